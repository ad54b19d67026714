//! What the workbench asks for besides the picture: editing, building, curves, files, forms, exercises, photographs.

use crate::desk::Desk;
use crate::exercises::Series;
use crate::photo::Photograph;
use crate::refused::Refused;
use crate::{Engine, answer, asked, board, building, exercises, json, kinds, modes, photo, plain, told};
use kinegon::editing::{self, Edit};
use kinegon::exercise::{self, Exercise};
use kinegon::format::pdf_pages;
use kinegon::scene::SceneError;
use kinegon::{Sheet, check};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen::prelude::wasm_bindgen;

/// What is kept for it.
#[derive(Default)]
pub struct Own {
    series: Option<Series>,
    photo: Option<Photograph>,
    board: board::Kept,
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen)]
impl Engine {
    /// The starting scenes.
    #[must_use]
    pub fn kinds(&self) -> String {
        json(&kinds::kinds())
    }

    /// The scene's text after some changes.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn edit(&self, text: &str, edits: &str) -> Result<String, String> {
        plain(
            self.desk.language(),
            asked::<Vec<Edit>>(edits).and_then(|edits| editing::apply(text, &edits).map_err(refused(text))),
        )
    }

    /// Where the points are: as solved; of a scene that cannot be solved, those that its text says.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn places(&self, text: &str) -> Result<String, String> {
        answer(self.desk.language(), modes::places(text))
    }

    /// Every way to assemble the scene.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn modes(&mut self, text: &str) -> Result<String, String> {
        answer(self.desk.language(), self.desk.modes(text))
    }

    /// The scene's text with another assembly mode chosen.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn choose_mode(&self, text: &str, number: f64) -> Result<String, String> {
        plain(self.desk.language(), editing::with_mode(text, number.max(0.0) as usize).map_err(refused(text)))
    }

    /// What is drawn over the cycle, for the scene's page or for a part of the screen.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn curves(&mut self, text: &str, of: &str, pane: &str) -> Result<String, String> {
        answer(self.desk.language(), asked(of).and_then(|of| self.desk.curves(text, &of, asked(pane)?)))
    }

    /// A file as the program writes it.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn file(&mut self, text: &str, request: &str) -> Result<Vec<u8>, String> {
        plain(self.desk.language(), asked(request).and_then(|request| self.desk.file(text, &request)))
    }

    /// How many sheets of paper a drawing takes.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn pages(&mut self, text: &str, of: &str) -> Result<String, String> {
        answer(self.desk.language(), asked(of).and_then(|of| self.desk.pages(text, &of)))
    }
}

/// A mechanism that is being put together.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen)]
impl Engine {
    /// What is known of a scene, complete or not, with its picture.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn drafted(&self, text: &str, view: &str) -> Result<String, String> {
        answer(self.desk.language(), asked(view).and_then(|view| building::drafted(text, &view)))
    }

    /// The scene's text after some changes, with all points where they were, also where it is not complete.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn edit_in_place(&self, text: &str, edits: &str) -> Result<String, String> {
        plain(self.desk.language(), asked::<Vec<Edit>>(edits).and_then(|edits| building::edited(text, &edits)))
    }

    /// The lines of a load's table, each a place and a factor, as a spreadsheet writes them; of several columns that with the load's name.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn load_table(&self, table: &str, load: &str) -> Result<String, String> {
        answer(self.desk.language(), building::load_table(table, load))
    }

    /// The scene's text with points at other places.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn move_points(&self, text: &str, moves: &str) -> Result<String, String> {
        plain(self.desk.language(), asked(moves).and_then(|moves| building::moved(text, &moves)))
    }
}

/// The drawing board.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen)]
impl Engine {
    /// A drawing on its board; of no text an empty one.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board(&mut self, text: &str, drawing: &str) -> Result<String, String> {
        let board = self.own.board.board(&mut self.desk, text, drawing);
        answer(self.desk.language(), board)
    }

    /// What a press on a sheet may mean, the nearest first.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board_snap(&mut self, text: &str, drawing: &str, pressed: &str) -> Result<String, String> {
        let found = asked(pressed).and_then(|pressed| self.own.board.snap(&mut self.desk, [text, drawing], &pressed));
        answer(self.desk.language(), found)
    }

    /// A sheet of a drawing as a picture.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board_picture(&mut self, text: &str, drawing: &str, of: &str) -> Result<String, String> {
        let picture = asked(of).and_then(|of| self.own.board.picture(&mut self.desk, [text, drawing], &of));
        answer(self.desk.language(), picture)
    }

    /// The verdicts on a drawing's entries.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board_judge(&mut self, text: &str, drawing: &str) -> Result<String, String> {
        let judged = self.own.board.judge(&mut self.desk, text, drawing);
        answer(self.desk.language(), judged)
    }

    /// A hint of a stage, from 1: about the first wrong entry, or about what comes next.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board_hint(&mut self, text: &str, drawing: &str, stage: f64) -> Result<String, String> {
        let hint = self.own.board.hint(&mut self.desk, [text, drawing], stage);
        answer(self.desk.language(), hint)
    }

    /// The form of measured values that a drawing gives.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board_form(&mut self, text: &str, drawing: &str) -> Result<String, String> {
        let form = self.own.board.form(&mut self.desk, text, drawing);
        plain(self.desk.language(), form)
    }

    /// Kinegon's own construction as a drawing.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board_own(&mut self, text: &str) -> Result<String, String> {
        let own = self.own.board.own(&mut self.desk, text);
        plain(self.desk.language(), own)
    }

    /// The plans of a drawing on sheets of paper, with markers, as one PDF; `name` is that of the exercise.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board_sheets(&mut self, text: &str, drawing: &str, name: &str) -> Result<Vec<u8>, String> {
        let sheets = self.own.board.sheets(&mut self.desk, [text, drawing, name]);
        plain(self.desk.language(), sheets)
    }
}

/// The student's way.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen)]
impl Engine {
    /// The form of a scene, with boxes for all values of a filled form, which may be empty.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn form(&mut self, text: &str, filled: &str) -> Result<String, String> {
        answer(self.desk.language(), self.desk.form(text, filled))
    }

    /// A form, JSON or a table, as JSON with the scene's own names.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn read_form(&mut self, text: &str, form: &str) -> Result<String, String> {
        plain(self.desk.language(), self.desk.read_form(text, form))
    }

    /// A form as a table.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn write_form(&mut self, text: &str, form: &str) -> Result<String, String> {
        plain(self.desk.language(), self.desk.write_form(text, form))
    }

    /// The exercise of a number, counted from 1, of the scene's variants.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn exercise(
        &mut self,
        text: &str,
        name: &str,
        seed: f64,
        number: f64,
        options: &str,
    ) -> Result<String, String> {
        let name = format!("{name}-{seed}-{number}");
        let (language, spoken) = (self.desk.language(), self.desk.spoken());
        let found = self.found(text, [seed, number], options);
        answer(language, found.map(|found| exercises::Exercise::of(found, name, spoken)))
    }

    /// The student's sheets of an exercise as one PDF, `sheet`, or its key, `key`; the name is that of
    /// [`exercise`](Engine::exercise).
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn exercise_file(
        &mut self,
        text: &str,
        name: &str,
        seed: f64,
        number: f64,
        options: &str,
        what: &str,
    ) -> Result<Vec<u8>, String> {
        let language = self.desk.language();
        let found = self.found(text, [seed, number], options).map_err(told(language))?;
        let sheets =
            if what == "key" { vec![found.key_sheet()] } else { found.sheets(&format!("{name}-{seed}-{number}")) };
        pdf_pages(&sheets, None).map_err(|error| told(language)(Refused::whole(error.to_string())))
    }
}

/// A photograph of the student's drawing.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen)]
impl Engine {
    /// The sheet in a photograph, by its grey pixels row by row; it is kept until the next one. `name` is that of the exercise,
    /// where there is one.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn photo(&mut self, text: &str, name: &str, width: f64, height: f64, grey: Vec<u8>) -> Result<String, String> {
        self.own.photo = None;
        let read = photo::read(&mut self.desk, text, name, [width, height].map(|side| side as usize), grey);
        let (read, kept) = read.map_err(told(self.desk.language()))?;
        self.own.photo = kept;
        Ok(json(&read))
    }

    /// The points that the pencil lines of the photograph show; they are looked for once.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn photo_proposed(&mut self) -> Result<String, String> {
        answer(self.desk.language(), self.photograph().and_then(|(photo, desk)| photo.proposed(desk)))
    }

    /// The place in a plan, `velocity` or `acceleration`, that is tapped in the picture: where pencil lines cross at most
    /// `reach` mm from there, else there, which the hand meets within `aim` mm with 95 %.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn photo_tap(&mut self, plan: &str, x: f64, y: f64, reach: f64, aim: f64) -> Result<String, String> {
        let plan = Sheet::from_word(plan);
        let tapped = |(photo, desk): (&mut Photograph, &mut Desk)| match plan {
            Some(plan) => photo.tapped(desk, plan, [x, y], [reach, aim]),
            None => Ok(None),
        };
        answer(self.desk.language(), self.photograph().and_then(tapped))
    }

    /// How points of the student's plans stand in the photograph.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn photo_points(&mut self, placed: &str) -> Result<String, String> {
        answer(
            self.desk.language(),
            self.photograph().and_then(|(photo, desk)| photo.judged(desk, &asked::<Vec<_>>(placed)?)),
        )
    }
}

impl Engine {
    fn photograph(&mut self) -> Result<(&mut Photograph, &mut Desk), Refused> {
        let photo = self.own.photo.as_mut().ok_or_else(|| Refused::whole(check::says::no_photograph()))?;
        Ok((photo, &mut self.desk))
    }

    /// An exercise; those before it are kept, as the next one is looked for from the last.
    fn found(&mut self, text: &str, [seed, number]: [f64; 2], options: &str) -> Result<&Exercise, Refused> {
        if seed < 0.0 || seed.fract() != 0.0 || seed > 9e15 {
            return Err(Refused::whole(exercise::says::whole_seed()));
        }
        let (seed, options) = (seed as u64, asked(options)?);
        if !self.own.series.as_ref().is_some_and(|series| series.is_of(text, seed, &options)) {
            self.own.series = None;
        }
        let series = match self.own.series.take() {
            Some(series) => series,
            None => Series::new(text, seed, &options)?,
        };
        self.own.series.insert(series).exercise(number as usize)
    }
}

/// Why a change of this text is refused.
fn refused(text: &str) -> impl Fn(SceneError) -> Refused {
    |error| Refused::of(text, error)
}
