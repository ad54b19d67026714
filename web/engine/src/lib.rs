//! Kinegon for the browser: text in, text out.
//!
//! In: the text of a scene and what is wanted of it, as JSON. Out: JSON, or a file's bytes. All mathematics and all drawing are the
//! library's; the page that calls this is in `web/page`, and the names here are those of its `engine/types.ts`.

mod answers;
mod checks;
mod desk;
mod exercises;
mod forms;
mod kinds;
mod refused;

use desk::Desk;
use exercises::Series;
use kinegon::exercise::Exercise;
use refused::Refused;
use serde::Serialize;
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::wasm_bindgen;

/// The engine: it keeps the last scene solved.
#[wasm_bindgen]
#[derive(Default)]
pub struct Engine {
    desk: Desk,
    series: Option<Series>,
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

    /// What is known of a scene.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn open(&mut self, text: &str) -> Result<String, String> {
        answer(self.desk.open(text))
    }

    /// The picture of a scene.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn picture(&mut self, text: &str, view: &str) -> Result<String, String> {
        answer(asked(view).and_then(|view| self.desk.picture(text, &view)))
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
        answer(self.desk.form(text, filled))
    }

    /// A form, JSON or a table, as JSON with the scene's own names.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn read_form(&mut self, text: &str, form: &str) -> Result<String, String> {
        self.desk.read_form(text, form).map_err(|refused| json(&refused))
    }

    /// A form as a table.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn write_form(&mut self, text: &str, form: &str) -> Result<String, String> {
        self.desk.write_form(text, form).map_err(|refused| json(&refused))
    }

    /// The verdict on a form.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn check(&mut self, text: &str, form: &str, options: &str) -> Result<String, String> {
        answer(asked(options).and_then(|options| self.desk.check(text, form, &options)))
    }

    /// The exercise of a number, counted from 1, of the scene's variants.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn exercise(&mut self, text: &str, name: &str, seed: f64, number: f64, options: &str) -> Result<String, String> {
        let name = format!("{name}-{seed}-{number}");
        answer(self.found(text, [seed, number], options).map(|found| exercises::Exercise::of(found, name)))
    }

    /// A sheet of an exercise as PDF: `sheet` or `key`.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn exercise_file(
        &mut self,
        text: &str,
        seed: f64,
        number: f64,
        options: &str,
        what: &str,
    ) -> Result<Vec<u8>, String> {
        let found = self.found(text, [seed, number], options).map_err(|refused| json(&refused))?;
        let sheet = if what == "key" { found.key_sheet() } else { found.sheet.clone() };
        sheet.pdf().map_err(|error| json(&Refused::whole(error.to_string())))
    }
}

impl Engine {
    /// An exercise; those before it are kept, as the next one is looked for from the last.
    fn found(&mut self, text: &str, [seed, number]: [f64; 2], options: &str) -> Result<&Exercise, Refused> {
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

/// A request from its JSON.
fn asked<T: DeserializeOwned>(json: &str) -> Result<T, Refused> {
    serde_json::from_str(json).map_err(|error| Refused::whole(error.to_string()))
}

/// An answer or a refusal as JSON.
fn answer<T: Serialize>(answer: Result<T, Refused>) -> Result<String, String> {
    answer.map(|answer| json(&answer)).map_err(|refused| json(&refused))
}

fn json<T: Serialize>(value: &T) -> String {
    serde_json::to_string(value).unwrap_or_default()
}
