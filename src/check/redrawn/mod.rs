//! The student's drawing as an overlay on the right figure: points and lines that are elsewhere than they should be,
//! with sentences.

#[doc(hidden)] // for tests
pub mod sheets;

use super::checked::{Checked, Verdict};
use super::measured::{AnswerKey, CheckError, Measured};
use super::mistakes::{Candidate, Mistake};
use super::model::Model;
use super::report::{ReportParts, report_parts};
use super::search::other_modes;
use crate::construction::{Action, Rate};
use crate::drawing::{Overlay, OwnValue, WrongStep};
use crate::quantity::{QuantityRequest, What};
use crate::sheet::Sheet;
use crate::words::{Language, Medium, NumberStyle, Wording};
use sheets::Sheets;

/// Rotation of given points above which a sentence says that they were turned, in degrees.
const TURNED: f64 = 1.0;

/// Most values following from one mistake that are named below the figure; more are marked in the table.
const NAMED: usize = 3;

/// The report's columns that the table beside the figure has.
const COLUMNS: [usize; 6] = [0, 1, 2, 4, 5, 7];

/// The student's drawing over the right one, with sentences about it.
///
/// Given points of a plan are placed with pole on pole and rotated so that most of them fit what was probably drawn.
/// Everything else comes from the replay with the mistakes that were found, as far as it differs visibly from the right
/// drawing. Unexplained values are drawn at their own length. A slip of writing alone changes no drawing.
///
/// # Errors
/// A scale is missing; values that have been checked have theirs.
pub fn redrawn(measured: &Measured, key: &AnswerKey<'_>, checked: &Checked) -> Result<Overlay, CheckError> {
    let words = &key.solution.wording();
    let entries: Vec<_> = checked.values.iter().map(|v| v.entry.clone()).collect();
    let right = Model::new(key, key.solution, measured.mu, &entries)?;
    let findings = &checked.diagnosis.best.findings;
    let mode = findings.iter().map(|f| f.candidate.mode).max().unwrap_or(0);
    // Mode 0 is the scene's own; the others are counted from 1.
    let other = mode.checked_sub(1).and_then(|other| other_modes(key, measured.mu, &entries).into_iter().nth(other));
    let own = other.as_ref().unwrap_or(&right);
    let found: Vec<&Candidate> = findings.iter().map(|f| &f.candidate).collect();

    let mut sheets = Sheets::new(key, &right, own, &found);
    let turns = sheets.lay_points(measured);
    sheets.draw_operations();
    if mode > 0 {
        sheets.draw_links();
    }
    let unknown = findings.iter().filter(|f| f.candidate.mistake() == Mistake::Unknown && f.candidate.edits.is_empty());
    for index in checked.diagnosis.unexplained.iter().copied().chain(unknown.flat_map(|f| f.written.iter().copied())) {
        sheets.draw_value(index, &checked.values[index]);
    }
    let (points, lines) = sheets.finish();

    let parts = report_parts(checked, key);
    Ok(Overlay {
        name: measured.name.clone().filter(|name| !name.is_blank()),
        points,
        lines,
        steps: wrong_steps(key, &found, words.language),
        words: said(&parts, checked, &turns, words),
        head: cells(&parts.columns),
        values: (0..checked.values.len()).map(|index| own_value(&parts, checked, index)).collect(),
    })
}

/// The sentences below the figure: the verdict, the numbered mistakes, the unexplained values, and the rotation of
/// given points.
fn said(parts: &ReportParts, checked: &Checked, turns: &[(Sheet, f64)], words: &Wording) -> Vec<String> {
    let sure = parts.sure.as_ref().map_or_else(String::new, |sure| format!(" ({sure})"));
    let mut said = vec![format!("{}. {}{sure}", parts.counts, parts.heading)];
    for ((finding, told), number) in checked.diagnosis.best.findings.iter().zip(&parts.causes).zip(1..) {
        let follows = match finding.follows.len() {
            0 => None,
            few if few <= NAMED => told.follows.clone(),
            many => Some(words.language.check_follows_marked(&many.to_string(), &format!("({number})"))),
        };
        // Beside a figure there is no room to repeat what a slipped number should be.
        let [done, should] = finding.candidate.told.sentences(words);
        let should = (!done.contains(&should)).then_some(told.should.clone());
        // Of several there is no room for all that each teaches.
        let is_one = checked.diagnosis.best.findings.len() == 1;
        let worked = told.worked.iter().chain(&told.redo).filter(|_| is_one).cloned();
        let sentences: Vec<String> =
            [told.done.clone()].into_iter().chain(should).chain(follows).chain(worked).collect();
        said.push(format!("{number}. {}", sentences.join(" ")));
    }
    said.extend(parts.senses.iter().chain(&parts.further).cloned());
    for &(sheet, degrees) in turns {
        if degrees.abs() > TURNED {
            let degrees = words.write(degrees, NumberStyle::decimals(0).on(Medium::Figure));
            said.push(words.language.check_turned(words.language.named_sheet(sheet), &degrees));
        }
    }
    said.into_iter().map(|sentence| sentence.replace(" -", " −")).collect()
}

/// The cells of a report's row that the table beside the figure has.
fn cells(row: &[String; 8]) -> [String; COLUMNS.len()] {
    COLUMNS.map(|column| row[column].clone())
}

/// A checked value as a row of that table, with the numbers of the mistakes that it follows from.
fn own_value(parts: &ReportParts, checked: &Checked, index: usize) -> OwnValue {
    let mut cells = cells(&parts.rows[index].cells);
    for (number, finding) in (1..).zip(&checked.diagnosis.best.findings) {
        if finding.follows.contains(&index) {
            cells[5].push_str(&format!(" ({number})"));
        }
    }
    OwnValue { cells, is_off: checked.values[index].verdict == Verdict::Off }
}

/// The steps at which mistakes were made, each once.
fn wrong_steps(key: &AnswerKey<'_>, found: &[&Candidate], language: &Language) -> Vec<WrongStep> {
    let mut wrong: Vec<WrongStep> = Vec::new();
    for candidate in found {
        if wrong.iter().any(|w| w.step == candidate.step) {
            continue;
        }
        let Some(step) = key.solution.construction.numbered_steps().find(|s| s.number == candidate.step) else {
            continue;
        };
        // A step may solve for the rates of several links; the mistake is in that of one, whose sense is shown on the
        // scheme.
        let solves = matches!(step.action, Action::Solve { .. });
        let rate = candidate.told.quantity().and_then(|name| QuantityRequest::new(name, &key.solution.mechanism).ok());
        let link = match rate.as_ref().map(|asked| &asked.what) {
            Some(What::Rate(Rate::Angular(_, link))) => key.solution.mechanism.body(*link).name.as_str(),
            _ => "",
        };
        wrong.push(WrongStep {
            step: step.number,
            panel: if solves { Sheet::Scheme } else { step.sheet },
            label: language.check_step(&step.number.to_string()),
            link: solves.then(|| link.to_owned()),
        });
    }
    wrong
}
