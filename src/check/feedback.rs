//! What a student gets back: the verdict on every value, what probably happened, the marks, and where values are off the
//! student's drawing over the right one.

use super::checked::Checked;
use super::marks::Awarded;
use super::measured::{AnswerKey, CheckError, Measured};
use super::redrawn::redrawn;
use crate::construction::Solution;
use crate::drawing::{Drawing, Overlay, overlay, overlay_words};
use crate::format::feedback_html;
use crate::scene::{Figure, PageSize, Scene};
use crate::sheet::Scales;
use crate::text::Untrusted;
use crate::words::Wording;

/// What a student gets back.
#[derive(Clone, Debug)]
pub struct Feedback {
    /// The exercise; `None` where only words are told.
    solution: Option<Solution>,
    figure: Figure,
    title: Untrusted,
    overlay: Overlay,
}

impl Feedback {
    /// That for checked values. Where all are right there is no drawing.
    ///
    /// The figure shows the student's drawing as large as the sheet allows, not at the student's scales.
    ///
    /// # Errors
    /// A scale is missing; values that have been checked have theirs.
    pub fn new(
        measured: &Measured,
        key: &AnswerKey<'_>,
        checked: &Checked,
        marks: Option<&Awarded>,
    ) -> Result<Feedback, CheckError> {
        let words = &key.solution.wording();
        let mut overlay = redrawn(measured, key, checked)?;
        if let Some(marks) = marks {
            overlay.words.insert(1.min(overlay.words.len()), format!("{}.", marks.line(words)));
        }
        let scene = &key.solution.scene;
        let figure = printed(&scene.figure);
        let solution = (!checked.is_nothing_off()).then(|| {
            let mut solution = key.solution.clone();
            solution.scene.figure = figure.clone();
            solution
        });
        Ok(Feedback { solution, figure, title: titled(Some(scene), words), overlay })
    }

    /// That for a form that was not understood: the message says why. `scene` is its exercise, where that is known.
    #[must_use]
    pub fn refused(scene: Option<&Scene>, name: &Untrusted, message: &str, words: &Wording) -> Feedback {
        let said = [words.language.class_not_understood().to_owned(), message.to_owned()];
        let overlay = Overlay { name: Some(name.clone()), words: said.into(), ..Overlay::default() };
        let figure = scene.map(|scene| printed(&scene.figure)).unwrap_or_default();
        Feedback { solution: None, figure, title: titled(scene, words), overlay }
    }

    /// Sheets to print: the figure with the words, and the table of values on the same sheet or on further ones.
    #[must_use]
    pub fn sheets(&self) -> Vec<Drawing> {
        match &self.solution {
            Some(solution) => overlay(solution, &self.overlay),
            None => overlay_words(&self.figure, &self.title, &self.overlay),
        }
    }

    /// A page for a browser with what is on the sheets.
    #[must_use]
    pub fn html(&self) -> String {
        // Words and table are text of the page.
        let drawn = Overlay { words: Vec::new(), values: Vec::new(), ..self.overlay.clone() };
        let figures = self.solution.as_ref().map_or_else(Vec::new, |solution| overlay(solution, &drawn));
        feedback_html(&self.title, Wording::of(&self.figure).language.code(), &figures, &self.overlay)
    }
}

/// The figure of an exercise as a student prints it: on A4 at most, at scales that fit there.
fn printed(figure: &Figure) -> Figure {
    let mut figure = figure.clone();
    figure.mu = Scales::default();
    if figure.page.size == PageSize::A3 {
        figure.page.size = PageSize::A4;
    }
    figure
}

/// The title of an exercise.
fn titled(scene: Option<&Scene>, words: &Wording) -> Untrusted {
    let own = scene.and_then(|scene| scene.title.clone());
    let usual = || scene.map_or_else(|| words.language.title().to_owned(), |scene| words.title_of(&scene.figure));
    own.unwrap_or_else(|| usual().as_str().into())
}
