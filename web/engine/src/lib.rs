//! Kinegon for the browser: text in, text out.
//!
//! In: the text of a scene and what is wanted of it, as JSON. Out: JSON, or a file's bytes. All mathematics and all drawing are the
//! library's; the page that calls this is in `web/page`, and the names here are those of its `engine/types.ts`.

mod answers;
mod desk;
mod kinds;
mod refused;

use desk::Desk;
use refused::Refused;
use serde::Serialize;
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::wasm_bindgen;

/// The engine: it keeps the last scene solved.
#[wasm_bindgen]
#[derive(Default)]
pub struct Engine {
    desk: Desk,
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
