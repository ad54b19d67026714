//! What entries and verdicts say, in a language; and the result as JSON.

use super::direction::Direction;
use super::entry::{Compute, Cross, Entry, Join, LayOff, Like, Line, Mark, Measure, Solve, Undo};
use super::file::HandDrawing;
use super::judge::{Judge, JudgedDrawing, Verdict, Wrong};
use super::names::two_points;
use super::says;
use crate::message::Message;
use crate::words::{Medium, Wording};
use serde::Serialize;

/// Most of what is missing that a report names.
const NAMED: usize = 24;

/// A judged drawing as a result.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "judged_drawing"))]
pub struct DrawingResult {
    /// The entries of the drawing, each with its verdict.
    pub entries: Vec<EntryResult>,
    /// The index of the first wrong entry, from 0; left out where none is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_wrong: Option<usize>,
    /// Whether no entry is wrong, and all is there that the scene asks for, by its `form` or else by all its steps.
    pub passed: bool,
    /// What the scene asks for and the drawing does not have.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<String>,
}

/// An entry with its verdict.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "judged_entry"))]
pub struct EntryResult {
    /// Its index in the drawing, from 0.
    pub index: usize,
    /// What it does, in words.
    pub does: String,
    /// What is found of it.
    pub verdict: VerdictName,
    /// What is wrong.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub says: Option<String>,
    /// The mistake of the catalogue.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mistake: Option<&'static str>,
    /// What was probably done.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub done: Option<String>,
    /// What it should be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub should: Option<String>,
}

/// The word for a verdict in results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "drawing_verdict"))]
#[serde(rename_all = "lowercase")]
pub enum VerdictName {
    /// It is right.
    Right,
    /// It is wrong by itself.
    Wrong,
    /// It is right by itself, but hangs on something wrong.
    Follows,
    /// Nothing uses it, and its name means nothing.
    Unused,
    /// It was taken back, or takes back.
    Undone,
}

impl Verdict {
    /// The word for it in results.
    #[must_use]
    pub fn name(&self) -> VerdictName {
        match self {
            Verdict::Right => VerdictName::Right,
            Verdict::Wrong(_) => VerdictName::Wrong,
            Verdict::Follows => VerdictName::Follows,
            Verdict::Unused => VerdictName::Unused,
            Verdict::Undone => VerdictName::Undone,
        }
    }
}

impl VerdictName {
    fn told(self) -> Message {
        match self {
            VerdictName::Right => says::right(),
            VerdictName::Wrong => says::wrong(),
            VerdictName::Follows => says::follows(),
            VerdictName::Unused => says::unused(),
            VerdictName::Undone => says::undone(),
        }
    }
}

impl Entry {
    /// What it does, as a sentence in this kind of text.
    #[must_use]
    pub fn told(&self, judge: &Judge, medium: Medium) -> Message {
        let list = |all: &[String], between| Message::list(all.iter().map(Message::from), between);
        let point = |name: &str| judge.given().shown(name);
        match self {
            Entry::Join(Join { join, points, .. }) => says::join(join, point(&points[0]), point(&points[1])),
            Entry::Line(Line { line, through: Some(through), along: Some(along), .. }) => {
                says::line(line, point(through), along.told(judge, medium))
            }
            Entry::Line(Line { line, .. }) => says::line_by_eye(line),
            Entry::Cross(Cross { cross, of, .. }) => says::cross(point(cross), &of[0], &of[1]),
            Entry::LayOff(LayOff { lay_off, from, size, along, .. }) => {
                says::lay_off(lay_off, from, size.written(medium), along.told(judge, medium))
            }
            Entry::Like(Like { like, ends, points, .. }) => says::like(like, list(ends, ""), list(points, "")),
            Entry::Mark(Mark { mark, .. }) => says::mark(point(mark)),
            Entry::Measure(Measure { measure, from, to, .. }) => says::measure(measure, point(from), point(to)),
            Entry::Compute(Compute { compute, by, value, sense }) => {
                let told = match (by, value) {
                    (Some(formula), _) => says::compute(compute, formula.written(medium)),
                    (None, value) => says::typed(compute, written(value.unwrap_or(0.0), medium)),
                };
                let sense = sense.map(|sense| if sense.sign() > 0.0 { says::ccw() } else { says::cw() });
                Message::list(std::iter::once(told).chain(sense), ", ")
            }
            Entry::Solve(Solve { solve, .. }) => says::solve(list(solve, ", ")),
            Entry::Undo(Undo { undo }) => says::undo(*undo),
        }
    }
}

/// A number as somebody typed it.
fn written(number: f64, medium: Medium) -> String {
    match medium {
        Medium::Text => number.to_string(),
        Medium::Figure => number.to_string().replace('-', "−"),
    }
}

impl Direction {
    fn told(&self, judge: &Judge, medium: Medium) -> Message {
        let to = |name: &str| {
            let mechanism = judge.given().mechanism();
            if mechanism.link(name).is_some() {
                says::link(name)
            } else if mechanism.slider_ids().any(|id| mechanism.slider_name(id) == name) {
                says::guide(name)
            } else if let Some(points) = two_points(name) {
                points.map(|point| judge.given().shown(point)).concat().into()
            } else {
                says::drawn_line(name)
            }
        };
        match self {
            Direction::Parallel { parallel } => says::parallel(to(parallel)),
            Direction::Normal { normal } => says::normal(to(normal)),
            Direction::Turned { turned, base } => says::turned(to(base), to(&turned[0]), to(&turned[1])),
            Direction::Angle { angle } => says::angle(written(*angle, medium)),
        }
    }
}

impl JudgedDrawing {
    /// The result, in the language of a figure.
    #[must_use]
    pub fn result(&self, judge: &Judge, drawing: &HandDrawing, words: &Wording) -> DrawingResult {
        let language = words.language;
        let entries = self.verdicts.iter().zip(&drawing.did).enumerate().map(|(index, (verdict, entry))| {
            let mut told = EntryResult {
                index,
                does: language.says(&entry.told(judge, Medium::Text)),
                verdict: verdict.name(),
                says: None,
                mistake: None,
                done: None,
                should: None,
            };
            if let Verdict::Wrong(Wrong { what, mistake }) = verdict {
                told.says = Some(language.says(what));
                if let Some(mistake) = mistake {
                    let [done, should] = mistake.sentences(words);
                    told.mistake = Some(mistake.mistake.id());
                    (told.done, told.should) = (Some(done), Some(should));
                }
            }
            told
        });
        let (first_wrong, missing) = (self.first_wrong(), judge.missing(&judge.form(drawing, self)));
        let passed = first_wrong.is_none() && missing.is_empty();
        DrawingResult { entries: entries.collect(), first_wrong, passed, missing }
    }
}

impl DrawingResult {
    /// The report: a line for each entry, what is wrong below it, and the first wrong one at the end.
    #[must_use]
    pub fn report(&self, words: &Wording) -> String {
        let language = words.language;
        let mut lines = Vec::new();
        let width = self.entries.len().to_string().len();
        for entry in &self.entries {
            let verdict = language.says(&entry.verdict.told());
            lines.push(format!("{:>width$}  {}: {verdict}", entry.index + 1, entry.does));
            let indent = " ".repeat(width + 4);
            for told in [&entry.says, &entry.done].into_iter().flatten() {
                lines.push(format!("{indent}{told}"));
            }
            lines.extend(entry.should.iter().map(|should| format!("{indent}{}", language.says(&says::should(should)))));
        }
        let is_empty = self.entries.iter().all(|entry| matches!(entry.verdict, VerdictName::Undone));
        let right = match () {
            () if is_empty => says::nothing_drawn,
            () if self.passed => says::all_right,
            () => says::right_so_far,
        };
        let first = self.first_wrong.map_or_else(right, |index| says::first_wrong(index + 1));
        lines.push(language.says(&first));
        let named = &self.missing[..self.missing.len().min(NAMED)];
        let more = self.missing.len() - named.len();
        let named = || Message::list(named.iter().map(Message::from), ", ");
        match more {
            0 if self.missing.is_empty() => {}
            0 => lines.push(language.says(&says::asked_missing(named()))),
            more => lines.push(language.says(&says::asked_missing_many(named(), more))),
        }
        lines.join("\n") + "\n"
    }
}
