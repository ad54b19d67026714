//! `kinegon check` of a drawing made on the drawing board.

use super::files;
use super::message::{Failure, Source, passed};
use crate::board::{HandDrawing, Judge};
use crate::check::AnswerKey;
use crate::format;
use crate::message::Message;
use crate::problem::Problem;

/// Judges a drawing and prints what is found.
pub(super) fn judge(key: &AnswerKey<'_>, text: &Source, json: bool) -> Result<(), Failure> {
    let drawing = HandDrawing::read(&text.text).map_err(|error| text.fail(error))?;
    let judge = Judge::new(key);
    let judged = judge.judge(&drawing).map_err(|error| {
        let place = format!("{}: did.{}: ", text.name, error.entry);
        Failure::Misuse(Problem::new(Message::list([place.into(), error.message], "")))
    })?;
    let words = key.solution.wording();
    let result = judged.result(&judge, &drawing, &words);
    let printed = if json { format::json(&serde_json::json!({ "drawing": result })) } else { result.report(&words) };
    files::print_text(&printed)?;
    passed(usize::from(result.first_wrong.is_some()), 0)
}
