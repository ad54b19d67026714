//! `kinegon check` of drawings made on the drawing board: one, or those of a class.

use super::class::Subject;
use super::files;
use super::forms::text_in_folder;
use super::message::{Failure, Source, passed};
use crate::board::{BoardError, HandDrawing, Judge, JudgedDrawing, Verdict};
use crate::check::{AnswerKey, ClassMistake, Measured, Mistake};
use crate::format;
use crate::message::Message;
use crate::problem::Problem;
use crate::scene::SizeLimit;
use crate::text::Untrusted;
use serde_json::json;
use std::path::Path;

/// Judges a drawing, with marks for what it gives where there is a scheme, and prints what is found.
pub(super) fn judge(subject: &Subject<'_>, text: &Source, as_json: bool) -> Result<(), Failure> {
    let key = subject.key.key();
    SizeLimit::BOARD.check(&key.solution.scene).map_err(|error| Failure::of_option(&text.name, error))?;
    let judge = Judge::new(key);
    let drawing = judge.read(&text.text).map_err(|error| text.fail(error))?;
    let judged = judge.judge(&drawing).map_err(|error| {
        let place = format!("{}: did.{}: ", text.name, error.entry);
        Failure::Misuse(Problem::new(Message::list([place.into(), error.message], "")))
    })?;
    let words = key.solution.wording();
    let result = judged.result(&judge, &drawing, &words);
    let marks = match &subject.scheme {
        Some(scheme) => {
            let form = judge.form(&drawing, &judged);
            let checked = subject.key.check_drawn(&form).map_err(|error| text.misuse(&error))?;
            Some(scheme.award(&checked))
        }
        None => None,
    };
    let printed = if as_json {
        let mut printed = json!({ "drawing": result });
        if let Some(marks) = marks {
            printed["marks"] = json!(marks);
        }
        format::json(&printed)
    } else {
        result.report(&words) + &marks.map_or_else(String::new, |marks| marks.line(&words) + "\n")
    };
    files::print_text(&printed)?;
    passed(usize::from(!result.passed), 0)
}

/// The exercise that a drawing names; `None` for a text that is no drawing.
pub(super) fn exercise(text: &str) -> Option<Option<Untrusted>> {
    HandDrawing::is_one(text).then(|| HandDrawing::read(text).ok().and_then(|drawing| drawing.exercise))
}

/// A drawing of a class.
pub(super) struct Drawn {
    /// The values that it gives.
    pub form: Measured,
    /// What is wrong: the step of the construction, the mistake, what is to be said of it.
    pub wrong: Vec<(ClassMistake, String)>,
    /// What is asked for and not there.
    pub missing: Vec<String>,
}

/// The drawing in a file, judged; `None` for a file that is none.
pub(super) fn drawn(path: &Path, key: &AnswerKey<'_>) -> Result<Option<Drawn>, String> {
    // What is no file, or no text, is refused where forms are read.
    let Some(text) = text_in_folder(path).ok().filter(|text| HandDrawing::is_one(&text.text)) else { return Ok(None) };
    let words = key.solution.wording();
    SizeLimit::BOARD.check(&key.solution.scene).map_err(|error| words.language.says(&error.message))?;
    let judge = Judge::new(key);
    let drawing = judge.read(&text.text).map_err(|error| text.fail(error).line(""))?;
    let judged = judge.judge(&drawing);
    let judged =
        judged.map_err(|BoardError { entry, message }| format!("did.{entry}: {}", words.language.says(&message)))?;
    let wrong = wrong(&judge, &drawing, &judged);
    let form = judge.form(&drawing, &judged);
    Ok(Some(Drawn { missing: judge.missing(&form), form, wrong }))
}

fn wrong(judge: &Judge, drawing: &HandDrawing, judged: &JudgedDrawing) -> Vec<(ClassMistake, String)> {
    let words = judge.given().solution.wording();
    let steps = judge.steps(drawing);
    let all = judged.verdicts.iter().zip(steps).filter_map(|(verdict, step)| {
        let Verdict::Wrong(wrong) = verdict else { return None };
        let mistake = wrong.mistake.as_ref();
        let id = mistake.map_or(Mistake::Unknown, |told| told.mistake).id();
        let done = match mistake {
            Some(told) => told.sentences(&words)[0].clone(),
            None => words.language.says(&wrong.what),
        };
        Some((ClassMistake::new(step, id), done))
    });
    all.collect()
}
