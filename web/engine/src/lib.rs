//! Kinegon for the browser: text in, text out.
//!
//! In: the text of a scene and what is wanted of it, as JSON. Out: JSON, or a file's bytes. All mathematics and all drawing are the
//! library's; the page that calls this is in `web/page`, and the names here are those of its `engine/types.ts`. What the component
//! in `web/component` calls is in this file, what the workbench calls besides in `workbench.rs`.

mod answers;
#[cfg(feature = "workbench")]
mod board;
#[cfg(feature = "workbench")]
mod building;
mod checks;
mod desk;
#[cfg(feature = "workbench")]
mod exercises;
#[cfg(feature = "workbench")]
mod files;
#[cfg(feature = "workbench")]
mod forms;
mod gesture;
#[cfg(feature = "workbench")]
mod kinds;
#[cfg(feature = "workbench")]
mod modes;
mod opened;
#[cfg(feature = "workbench")]
mod photo;
#[cfg(feature = "workbench")]
mod photo_answers;
mod picture;
mod refused;
#[cfg(feature = "types")]
mod schema;
#[cfg(feature = "workbench")]
mod workbench;

#[cfg(feature = "types")]
pub use schema::schema;

use desk::Desk;
use gesture::{Gesture, nothing_held};
use kinegon::drawing::{ITALIC, REGULAR};
use kinegon::words::Language;
use refused::Refused;
use serde::Serialize;
use serde::de::DeserializeOwned;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen::prelude::wasm_bindgen;

/// The engine: it keeps the last scene solved.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen)]
#[derive(Default)]
pub struct Engine {
    desk: Desk,
    gesture: Option<Gesture>,
    #[cfg(feature = "workbench")]
    own: workbench::Own,
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen)]
impl Engine {
    /// An engine without a scene.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen(constructor))]
    #[must_use]
    pub fn new() -> Engine {
        Engine::default()
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
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen(js_name = drop))]
    pub fn let_go(&mut self) -> Result<String, String> {
        let gesture = self.gesture.take().ok_or_else(nothing_held);
        plain(self.desk.language(), gesture.and_then(|gesture| gesture.let_go(&mut self.desk)))
    }

    /// All values of the scene's position with their certain digits.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn values(&mut self, text: &str) -> Result<String, String> {
        answer(self.desk.language(), self.desk.values(text))
    }

    /// The verdict on a form.
    ///
    /// # Errors
    /// A [`Refused`] as JSON.
    pub fn check(&mut self, text: &str, form: &str, options: &str) -> Result<String, String> {
        answer(self.desk.language(), asked(options).and_then(|options| self.desk.check(text, form, &options)))
    }

    /// A face of the letters that drawings are set with, as OpenType.
    #[must_use]
    pub fn font(&self, is_italic: bool) -> Vec<u8> {
        if is_italic { ITALIC.to_vec() } else { REGULAR.to_vec() }
    }
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
