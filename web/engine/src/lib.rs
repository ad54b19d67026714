//! Kinegon for the browser: text in, text out.
//!
//! In: the text of a scene and what is wanted of it, as JSON. Out: JSON, or a file's bytes. All mathematics and all drawing are the
//! library's; the page that calls this is in `web/page`, and the names here are those of its `engine/types.ts`.

mod answers;
mod building;
mod checks;
mod desk;
mod exercises;
mod files;
mod forms;
mod gesture;
mod kinds;
mod opened;
mod photo;
mod photo_answers;
mod picture;
mod refused;
#[cfg(not(target_arch = "wasm32"))]
mod schema;

#[cfg(not(target_arch = "wasm32"))]
pub use schema::schema;

use desk::Desk;
use exercises::Series;
use gesture::{Gesture, nothing_held};
use kinegon::drawing::{ITALIC, REGULAR};
use kinegon::editing::{self, Edit};
use kinegon::exercise::{self, Exercise};
use kinegon::format::pdf_pages;
use kinegon::scene::SceneError;
use kinegon::words::Language;
use kinegon::{Sheet, check};
use photo::Photograph;
use refused::Refused;
use serde::Serialize;
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::wasm_bindgen;

/// The engine: it keeps the last scene solved.
#[wasm_bindgen]
#[derive(Default)]
pub struct Engine {
    desk: Desk,
    gesture: Option<Gesture>,
    series: Option<Series>,
    photo: Option<Photograph>,
}

#[wasm_bindgen]
impl Engine {
    /// An engine without a scene.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Engine {
        Engine::default()
    }

    /// The starting scenes.
    #[must_use]
    pub fn kinds(&self) -> String {
        json(&kinds::kinds())
    }

    /// Chooses the language in which steps, boxes and verdicts are told, as `es`; pictures and files keep that of the figure.
    /// Any other word lets all be told in the figure's.
    pub fn speak(&mut self, language: &str) {
        self.desk.speak(language);
    }

    /// What is known of a scene.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn open(&mut self, text: &str) -> Result<String, String> {
        answer(self.desk.language(), self.desk.open(text))
    }

    /// The picture of a scene.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn picture(&mut self, text: &str, view: &str) -> Result<String, String> {
        answer(self.desk.language(), asked(view).and_then(|view| self.desk.picture(text, &view)))
    }

    /// How a scene runs; null where no drive has a speed.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn running(&mut self, text: &str) -> Result<String, String> {
        answer(self.desk.language(), self.desk.kept(text).and_then(desk::Kept::running))
    }

    /// Takes hold of something: the picture, whose layout stays until it is let go.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn grab(&mut self, text: &str, view: &str, what: &str) -> Result<String, String> {
        self.gesture = None;
        let held = asked(view).and_then(|view| self.desk.grab(text, &view, &asked(what)?));
        answer(
            self.desk.language(),
            held.map(|(gesture, picture)| {
                self.gesture = Some(gesture);
                picture
            }),
        )
    }

    /// Pulls what is held: the picture of the new position.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn drag(&mut self, to: &str) -> Result<String, String> {
        let (gesture, language) = (self.gesture.as_mut().ok_or_else(nothing_held), self.desk.spoken());
        answer(self.desk.language(), gesture.and_then(|gesture| gesture.pull(asked(to)?, language)))
    }

    /// Lets go: the scene's text after the gesture.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    #[wasm_bindgen(js_name = drop)]
    pub fn let_go(&mut self) -> Result<String, String> {
        let gesture = self.gesture.take().ok_or_else(nothing_held);
        plain(self.desk.language(), gesture.and_then(|gesture| gesture.let_go(&mut self.desk)))
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
        answer(self.desk.language(), opened::places(text))
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

    /// All values of the scene's position with their certain digits.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn values(&mut self, text: &str) -> Result<String, String> {
        answer(self.desk.language(), self.desk.values(text))
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

    /// A face of the letters that drawings are set with, as OpenType.
    #[must_use]
    pub fn font(&self, is_italic: bool) -> Vec<u8> {
        if is_italic { ITALIC.to_vec() } else { REGULAR.to_vec() }
    }
}

/// A mechanism that is being put together.
#[wasm_bindgen]
impl Engine {
    /// What is known of a scene, complete or not, with its picture.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn board(&self, text: &str, view: &str) -> Result<String, String> {
        answer(self.desk.language(), asked(view).and_then(|view| building::board(text, &view)))
    }

    /// The scene's text after some changes, with all points where they were, also where it is not complete.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn edit_in_place(&self, text: &str, edits: &str) -> Result<String, String> {
        plain(self.desk.language(), asked::<Vec<Edit>>(edits).and_then(|edits| building::edited(text, &edits)))
    }

    /// The scene's text with points at other places.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn move_points(&self, text: &str, moves: &str) -> Result<String, String> {
        plain(self.desk.language(), asked(moves).and_then(|moves| building::moved(text, &moves)))
    }
}

/// The student's way.
#[wasm_bindgen]
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

    /// The verdict on a form.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn check(&mut self, text: &str, form: &str, options: &str) -> Result<String, String> {
        answer(self.desk.language(), asked(options).and_then(|options| self.desk.check(text, form, &options)))
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
#[wasm_bindgen]
impl Engine {
    /// The sheet in a photograph, by its grey pixels row by row; it is kept until the next one. `name` is that of the exercise,
    /// where there is one.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn photo(&mut self, text: &str, name: &str, width: f64, height: f64, grey: Vec<u8>) -> Result<String, String> {
        self.photo = None;
        let read = photo::read(&mut self.desk, text, name, [width, height].map(|side| side as usize), grey);
        let (read, kept) = read.map_err(told(self.desk.language()))?;
        self.photo = kept;
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
        let photo = self.photo.as_mut().ok_or_else(|| Refused::whole(check::says::no_photograph()))?;
        Ok((photo, &mut self.desk))
    }

    /// An exercise; those before it are kept, as the next one is looked for from the last.
    fn found(&mut self, text: &str, [seed, number]: [f64; 2], options: &str) -> Result<&Exercise, Refused> {
        if seed < 0.0 || seed.fract() != 0.0 || seed > 9e15 {
            return Err(Refused::whole(exercise::says::whole_seed()));
        }
        let (seed, options) = (seed as u64, asked(options)?);
        if !self.series.as_ref().is_some_and(|series| series.is_of(text, seed, &options)) {
            self.series = None;
        }
        let series = match self.series.take() {
            Some(series) => series,
            None => Series::new(text, seed, &options)?,
        };
        self.series.insert(series).exercise(number as usize)
    }
}

/// Why a change of this text is refused.
fn refused(text: &str) -> impl Fn(SceneError) -> Refused {
    |error| Refused::of(text, error)
}

/// Tells the page why the engine stops, where it has a fault.
#[cfg(target_arch = "wasm32")]
#[wasm_bindgen(start)]
pub fn tell_faults() {
    std::panic::set_hook(Box::new(|fault| wasm_bindgen::throw_str(&fault.to_string())));
}

/// A request from its JSON.
fn asked<T: DeserializeOwned>(json: &str) -> Result<T, Refused> {
    serde_json::from_str(json).map_err(|error| Refused::whole(error.to_string()))
}

/// An answer or a refusal as JSON.
fn answer<T: Serialize>(language: &Language, answer: Result<T, Refused>) -> Result<String, String> {
    answer.map(|answer| json(&answer)).map_err(told(language))
}

/// A text or the bytes of a file, or a refusal as JSON.
fn plain<T>(language: &Language, answer: Result<T, Refused>) -> Result<T, String> {
    answer.map_err(told(language))
}

/// A refusal as JSON, in the words of a language.
fn told(language: &Language) -> impl Fn(Refused) -> String {
    move |refused| json(&refused.told(language))
}

fn json<T: Serialize>(value: &T) -> String {
    serde_json::to_string(value).unwrap_or_default()
}
