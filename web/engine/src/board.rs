//! The drawing board: drawings in and out as text, all geometry and every judgement the library's.

use crate::checks::SheetPicture;
use crate::desk::Desk;
use crate::refused::Refused;
use kinegon::board::{
    Board, BoardError, BoardHint, DrawingResult, HandDrawing, Judge, JudgedDrawing, Pressed, STAGES, Screen, Snapped,
    own_drawing,
};
use kinegon::check::AnswerKey;
use kinegon::construction::Tolerance;
use kinegon::format::pdf_pages;
use kinegon::scene::SizeLimit;
use kinegon::{Order, Sheet};
use serde::{Deserialize, Serialize};

/// Which picture of a drawing is wanted.
#[derive(Clone, Copy, Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct BoardPictureAsk {
    /// Of which sheet.
    pub sheet: Sheet,
    /// How many entries are shown; none for all.
    pub until: Option<usize>,
    /// Height of the letters in mm; none for those of a sheet of paper.
    pub letters: Option<f64>,
    /// Whether what is wrong is marked.
    #[serde(default)]
    pub judged: bool,
}

/// What is found of a drawing.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct BoardJudged {
    /// The entries with their verdicts.
    pub entries: Vec<kinegon::board::EntryResult>,
    /// The index of the first wrong one; none where nothing is wrong.
    pub first_wrong: Option<usize>,
    /// Whether all that the scene asks for is there and nothing is wrong.
    pub is_complete: bool,
    /// What it asks for and is not there.
    pub missing: Vec<String>,
}

/// Height of letters on a sheet of paper, in mm.
const LETTERS: f64 = 3.4;

/// What is kept for the board: the screen of the last scene, and the last drawing judged.
#[derive(Default)]
pub struct Kept {
    scene: String,
    language: String,
    screen: Option<Screen>,
    /// The last drawing as it was read: a hand that moves over a sheet asks for it again and again.
    read: Option<(String, HandDrawing)>,
    judged: Option<(String, JudgedDrawing)>,
}

impl Kept {
    /// The screen of a scene.
    fn screen(&mut self, desk: &mut Desk, text: &str) -> Result<&Screen, Refused> {
        let spoken = desk.language().code();
        if self.screen.is_none() || self.scene != text || self.language != spoken {
            *self = Kept::default();
            let (kept, language) = desk.kept_with_language(text)?;
            kept.check(SizeLimit::BOARD)?;
            let solution = crate::desk::in_words(kept.solution(Order::Acceleration)?, language).into_owned();
            let key = AnswerKey::new(&solution, Some(Tolerance::default()));
            self.screen = Some(Screen::new(Judge::new(&key), solution.wording()));
            (self.scene, self.language) = (text.to_owned(), spoken.to_owned());
        }
        self.screen.as_ref().ok_or_else(|| Refused::whole(""))
    }

    /// What is found of a drawing, which may be kept from before.
    fn judged(
        &mut self,
        desk: &mut Desk,
        text: &str,
        drawing: &str,
    ) -> Result<(&Screen, &HandDrawing, &JudgedDrawing), Refused> {
        // What is kept may be of another scene.
        self.screen(desk, text)?;
        if self.judged.as_ref().is_none_or(|(before, _)| before != drawing) {
            let (screen, read) = self.drawing(desk, text, drawing)?;
            let judged = screen.judge.judge(read).map_err(refused)?;
            self.judged = Some((drawing.to_owned(), judged));
        }
        self.drawing(desk, text, drawing)?;
        let known = self.screen.as_ref().zip(self.read.as_ref()).zip(self.judged.as_ref());
        known.map(|((screen, (_, read)), (_, judged))| (screen, read, judged)).ok_or_else(|| Refused::whole(""))
    }

    /// The screen of a scene, and the drawing of a text; of none an empty one.
    fn drawing(&mut self, desk: &mut Desk, text: &str, drawing: &str) -> Result<(&Screen, &HandDrawing), Refused> {
        self.screen(desk, text)?;
        if self.read.as_ref().is_none_or(|(before, _)| before != drawing) {
            let empty = self.screen.as_ref().map_or_else(String::new, Screen::empty);
            let text = if drawing.trim().is_empty() { &empty } else { drawing };
            let read = HandDrawing::read(text).map_err(|error| Refused::of(text, error))?;
            self.read = Some((drawing.to_owned(), read));
        }
        let known = self.screen.as_ref().zip(self.read.as_ref().map(|(_, read)| read));
        known.ok_or_else(|| Refused::whole(""))
    }

    pub fn board(&mut self, desk: &mut Desk, text: &str, drawing: &str) -> Result<Board, Refused> {
        let (screen, read) = self.drawing(desk, text, drawing)?;
        let drawing = if drawing.trim().is_empty() { screen.empty() } else { drawing.to_owned() };
        Ok(screen.board(drawing, read))
    }

    pub fn snap(
        &mut self,
        desk: &mut Desk,
        [text, drawing]: [&str; 2],
        pressed: &Pressed,
    ) -> Result<Vec<Snapped>, Refused> {
        let (screen, read) = self.drawing(desk, text, drawing)?;
        Ok(screen.snapped(read, pressed))
    }

    pub fn picture(
        &mut self,
        desk: &mut Desk,
        [text, drawing]: [&str; 2],
        ask: &BoardPictureAsk,
    ) -> Result<SheetPicture, Refused> {
        // A drawing that cannot be judged is shown as it is.
        let judged =
            if ask.judged { self.judged(desk, text, drawing).ok().map(|(.., judged)| judged.clone()) } else { None };
        let (screen, read) = self.drawing(desk, text, drawing)?;
        let letters = ask.letters.unwrap_or(LETTERS).clamp(0.5, 50.0);
        let picture = screen.picture(read, ask.sheet, ask.until, letters, judged.as_ref());
        let picture = picture.ok_or_else(|| Refused::whole(kinegon::board::says::no_sheet()))?;
        Ok(SheetPicture { svg: picture.svg(), width: picture.width, height: picture.height })
    }

    pub fn judge(&mut self, desk: &mut Desk, text: &str, drawing: &str) -> Result<BoardJudged, Refused> {
        let (screen, read, judged) = self.judged(desk, text, drawing)?;
        let DrawingResult { entries, first_wrong, passed, missing } =
            judged.result(&screen.judge, read, &screen.words());
        Ok(BoardJudged { entries, first_wrong, is_complete: passed, missing })
    }

    pub fn hint(&mut self, desk: &mut Desk, [text, drawing]: [&str; 2], stage: f64) -> Result<BoardHint, Refused> {
        let stage = stage.clamp(1.0, f64::from(STAGES)) as u8;
        let judged = self.judged(desk, text, drawing).ok().map(|(.., judged)| judged.clone());
        let (screen, read) = self.drawing(desk, text, drawing)?;
        Ok(screen.hint(read, judged.as_ref(), stage))
    }

    pub fn form(&mut self, desk: &mut Desk, text: &str, drawing: &str) -> Result<String, Refused> {
        let (screen, read, judged) = self.judged(desk, text, drawing)?;
        Ok(screen.judge.form(read, judged).json(&screen.judge.given().solution))
    }

    pub fn own(&mut self, desk: &mut Desk, text: &str) -> Result<String, Refused> {
        let screen = self.screen(desk, text)?;
        let given = screen.judge.given();
        Ok(own_drawing(given, &given.solution.scales()))
    }

    pub fn sheets(&mut self, desk: &mut Desk, [text, drawing, name]: [&str; 3]) -> Result<Vec<u8>, Refused> {
        let (screen, read) = self.drawing(desk, text, drawing)?;
        let sheets = screen.sheets(read, None, name);
        pdf_pages(&sheets, None).map_err(|error| Refused::whole(error.to_string()))
    }
}

fn refused(BoardError { message, .. }: BoardError) -> Refused {
    Refused::whole(message)
}
