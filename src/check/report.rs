//! The report in the figure's language: in parts, and as text from them. What its verdict rests on stands in `basis`.

mod basis;
mod lessons;

use super::checked::{Basis, Checked, Explanation, Finding, Judged, Verdict};
use super::measured::AnswerKey;
use super::mistakes::{Candidate, Mistake};
use super::names::Names;
use crate::construction::{NumberedStep, Teller, shown_text};
use crate::sheet::QuantityKind;
use crate::words::{Language, Medium, NumberStyle, Wording};
use serde::Serialize;

/// The report for the student: verdicts in the order of the construction, then the mistakes that were probably made.
#[must_use]
pub fn report(checked: &Checked, key: &AnswerKey<'_>) -> String {
    let text = ReportText::new(checked, key, Medium::Text);
    let parts = text.parts();
    let mut lines = vec![parts.counts];
    lines.extend(parts.missing);
    lines.extend(parts.rests_on);
    lines.extend(parts.accuracy);
    lines.push(String::new());
    let rows = [parts.columns].into_iter().chain(parts.rows.into_iter().map(|row| row.cells));
    lines.extend(aligned(&rows.collect::<Vec<_>>()));
    lines.push(String::new());
    lines.extend(parts.senses);
    lines.push(parts.heading);
    for (cause, number) in parts.causes.into_iter().zip(1..) {
        lines.push(format!("{number}. {}", cause.done));
        let caption = cause.caption.map(|caption| format!("({caption})"));
        let more = caption.into_iter().chain([cause.should]).chain(cause.worked).chain(cause.follows).chain(cause.redo);
        lines.extend(more.map(|line| format!("   {line}")));
    }
    lines.extend(parts.sure);
    lines.extend(parts.further);
    if !parts.others.is_empty() {
        lines.push(String::new());
        lines.push(parts.others_heading);
        lines.extend(parts.others.iter().map(|other| format!("  - {other}")));
    }
    lines.join("\n") + "\n"
}

/// The rows of a table with their columns aligned: the words of the first and the last to the left, numbers to the right.
pub(crate) fn aligned<const N: usize>(rows: &[[String; N]]) -> Vec<String> {
    let width = |column: usize| rows.iter().map(|r| r[column].chars().count()).max();
    let widths: [usize; N] = std::array::from_fn(|column| width(column).unwrap_or(0));
    let line = |row: &[String; N]| {
        let mut line = String::new();
        for (column, cell) in row.iter().enumerate() {
            let blanks = " ".repeat(widths[column] - cell.chars().count());
            match column == 0 || column == N - 1 {
                true => line.push_str(&format!("{cell}{blanks}  ")),
                false => line.push_str(&format!("{blanks}{cell}  ")),
            }
        }
        line.trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}

/// A report in parts, in the markup of [`Overlay::set`](crate::drawing::Overlay::set). What is right and what was
/// probably done stand apart, so that a page can say the one without the other.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct ReportParts {
    /// How many values are right, within the tolerance, off.
    pub counts: String,
    /// What is asked for and not there.
    pub missing: Option<String>,
    /// What else the verdict does not rest on: values that tell nothing, and scales that are not those asked for.
    pub rests_on: Vec<String>,
    /// How much is allowed, and how accurate the drawing is.
    pub accuracy: Vec<String>,
    /// Headings of the cells of a value.
    pub columns: [String; 8],
    /// The values in the order of the construction.
    pub rows: Vec<ReportRow>,
    /// About rates without a sense, if there are any.
    pub senses: Option<String>,
    /// The heading of the mistakes, or the sentence that there are none, or that none can be told.
    pub heading: String,
    /// The mistakes that were probably made.
    pub causes: Vec<Cause>,
    /// How many stages of a hint a student may open, of those of a cause and of all that it tells.
    pub hints: usize,
    /// How sure these are.
    pub sure: Option<String>,
    /// Which values nothing explains, and which plans are mirrored.
    pub further: Vec<String>,
    /// The heading of these.
    pub others_heading: String,
    /// What else explains the values, or what may have been done where only the place of a mistake is told.
    pub others: Vec<String>,
}

/// A value of a report.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct ReportRow {
    /// The name of the form's box.
    pub name: String,
    /// Name, own value, exact value, difference, the same on paper and in per cent, what is allowed, verdict.
    pub cells: [String; 8],
}

/// A mistake that was probably made.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct Cause {
    /// At which step, and what was done.
    pub done: String,
    /// The step's caption.
    pub caption: Option<String>,
    /// What it should be.
    pub should: String,
    /// Which values follow from it.
    pub follows: Option<String>,
    /// The step worked out with the student's own numbers; by how much what was drawn is off.
    pub worked: Vec<String>,
    /// Which steps are to be done again.
    pub redo: Option<String>,
    /// The stages of a hint before all this is told: the plan, the first wrong value, the step.
    pub hints: Vec<String>,
    /// The number of its step; 0 for the whole drawing.
    pub step: usize,
}

impl ReportParts {
    /// The parts with all texts but the names of boxes set by a function, as in HTML.
    #[must_use]
    pub fn set(mut self, set: impl Fn(String) -> String) -> ReportParts {
        let cells = self.rows.iter_mut().flat_map(|row| &mut row.cells);
        let causes = self.causes.iter_mut().flat_map(
            |Cause { done, caption, should, follows, worked, redo, hints, step: _ }| {
                [done, should].into_iter().chain(caption).chain(follows).chain(worked).chain(redo).chain(hints)
            },
        );
        let texts =
            [&mut self.counts, &mut self.heading].into_iter().chain(&mut self.columns).chain(cells).chain(causes);
        let texts = texts
            .chain(&mut self.missing)
            .chain(&mut self.rests_on)
            .chain(&mut self.accuracy)
            .chain(&mut self.senses)
            .chain(&mut self.sure);
        for text in texts.chain(&mut self.further).chain(&mut self.others) {
            *text = set(core::mem::take(text));
        }
        self
    }
}

/// The parts of the report on checked values, for a page or a figure.
#[must_use]
pub fn report_parts(checked: &Checked, key: &AnswerKey<'_>) -> ReportParts {
    ReportText::new(checked, key, Medium::Figure).parts()
}

/// Writes the sentences about checked values.
struct ReportText<'a> {
    checked: &'a Checked,
    key: &'a AnswerKey<'a>,
    words: Wording,
    own: &'static Language,
    medium: Medium,
    names: Names<'a>,
}

impl<'a> ReportText<'a> {
    fn new(checked: &'a Checked, key: &'a AnswerKey<'a>, medium: Medium) -> ReportText<'a> {
        let words = key.solution.wording();
        ReportText { checked, key, words, own: words.language, medium, names: Names::new(key.solution) }
    }

    fn parts(&self) -> ReportParts {
        let row = |value: &Judged| ReportRow { name: self.names.in_form(&value.entry.row), cells: self.row(value) };
        let diagnosis = &self.checked.diagnosis;
        let best = &diagnosis.best;
        let mirrored = self.checked.mirrored.iter();
        let mirrored = mirrored.map(|plan| self.own.check_mirrored(self.own.named_sheet(*plan)));
        let others: &[Explanation] = if self.has_nothing_to_explain() { &[] } else { &diagnosis.others };
        ReportParts {
            counts: self.counts(),
            missing: self.missing(),
            rests_on: self.rests_on(),
            accuracy: self.accuracy(),
            columns: self.own.check_columns().map(str::to_owned),
            rows: self.checked.values.iter().map(row).collect(),
            senses: (self.checked.count(Verdict::SenseMissing) > 0).then(|| self.own.check_senses().to_owned()),
            heading: self.heading(),
            hints: self.key.solution.scene.hints,
            causes: best.findings.iter().map(|finding| self.cause(finding)).collect(),
            sure: (!best.findings.is_empty()).then(|| self.sure(best)),
            further: self.unexplained().into_iter().chain(self.looked_at()).chain(mirrored).collect(),
            others_heading: match others.iter().any(|other| other.is_within) {
                true => self.own.check_perhaps().to_owned(),
                false => self.own.check_others().to_owned(),
            },
            others: others.iter().map(|other| self.other(other)).collect(),
        }
    }

    fn number(&self, value: f64, digits: usize) -> String {
        self.words.write(value, significant(digits).on(self.medium))
    }

    /// A value as a row of the table.
    fn row(&self, value: &Judged) -> [String; 8] {
        let entry = &value.entry;
        let unit = entry.asked.kind().unit(self.key.solution.scene.units);
        let expected = if entry.is_magnitude { entry.expected.abs() } else { entry.expected };
        let on_paper = entry.per_mm.and_then(|mu| {
            let mm = self.words.on_paper(value.difference, mu, signed(2).on(self.medium))?;
            Some(format!("{mm} mm"))
        });
        let percent = 100.0 * value.difference / entry.expected.abs();
        // Beside nearly nothing everything is many times as large, and a direction is no size.
        let is_angle = entry.asked.kind() == QuantityKind::Angle;
        let percent = (percent.abs() < 1e6 && !is_angle).then(|| {
            let digits = if percent.abs() < 10.0 { 2 } else { 0 };
            let percent = self.words.write(percent, signed(digits).on(self.medium));
            format!("{percent} %")
        });
        let tolerance = (value.basis != Basis::Given).then(|| format!("±{}", self.number(value.tolerance, 2)));
        let turned = || self.own.check_off_turned(&self.words.write(value.difference.abs(), NumberStyle::decimals(0)));
        let verdict = match value.verdict {
            Verdict::Off if is_angle && entry.asked.written.component.is_some() => &turned(),
            Verdict::Right => self.own.check_right(),
            Verdict::WithinTolerance => self.own.check_within(),
            Verdict::SenseMissing => self.own.check_sense_missing(),
            Verdict::Off => self.own.check_off(),
            Verdict::TooCoarse | Verdict::TooSmall => self.own.check_cannot_tell(),
        };
        [
            self.names.shown(&entry.asked),
            self.number(entry.value, 7),
            format!("{} {unit}", self.number(expected, 7)),
            self.number(value.difference, 3),
            on_paper.unwrap_or_default(),
            percent.unwrap_or_default(),
            tolerance.unwrap_or_default(),
            verdict.to_owned(),
        ]
    }

    /// The heading of the mistakes that were found, or the sentence that there are none, or that none can be told.
    fn heading(&self) -> String {
        let diagnosis = &self.checked.diagnosis;
        match (diagnosis.best.findings.len(), diagnosis.unexplained.first()) {
            (0, _) if self.has_nothing_to_explain() => self.nothing_off(),
            (0, Some(&first)) => {
                let entry = &self.checked.values[first].entry;
                self.own.check_none(&entry.step.to_string(), &self.names.shown(&entry.asked))
            }
            (0 | 1, _) => self.own.check_probably().to_owned(),
            // Then no one says that they explain all.
            _ if diagnosis.best.findings.iter().any(|f| f.candidate.mistake() == Mistake::Unknown) => {
                self.own.check_probably().to_owned()
            }
            _ => self.own.check_no_single().to_owned(),
        }
    }

    fn has_nothing_to_explain(&self) -> bool {
        let diagnosis = &self.checked.diagnosis;
        diagnosis.best.findings.is_empty() && diagnosis.unexplained.is_empty() && self.checked.is_nothing_off()
    }

    /// What else explains the values, as far as it differs from the best explanation.
    fn other(&self, other: &Explanation) -> String {
        let best = &self.checked.diagnosis.best.findings;
        let new = other.findings.iter().filter(|f| !best.iter().any(|g| g.candidate.told == f.candidate.told));
        let told: Vec<String> = new
            .map(|f| {
                let [done, _] = f.candidate.told.sentences_with(&self.words, &|name| self.names.named(name));
                format!("{}: {done}", step(&f.candidate, self.own))
            })
            .collect();
        let end = if other.is_alike { self.own.check_alike().to_owned() } else { self.sure(other) };
        format!("{} ({end})", told.join("; "))
    }

    /// The sentence about the unexplained values, if there are any.
    fn unexplained(&self) -> Option<String> {
        let values = &self.checked.diagnosis.unexplained;
        (!values.is_empty()).then(|| self.own.check_unexplained(&self.names(values)))
    }

    /// How many values the search for causes looked at, where not all.
    fn looked_at(&self) -> Option<String> {
        let looked_at = self.checked.diagnosis.looked_at;
        let is_part = looked_at < self.checked.values.len() && !self.checked.is_nothing_off();
        let told = match looked_at {
            0 => self.own.check_not_looked().to_owned(),
            _ => self.own.check_looked_at(&looked_at.to_string()),
        };
        is_part.then_some(told)
    }

    fn sure(&self, explanation: &Explanation) -> String {
        let percent = (100.0 * explanation.probability).clamp(1.0, 99.0);
        self.own.check_sure(&format!("{percent:.0}"))
    }

    /// The sentences about a mistake.
    fn cause(&self, finding: &Finding) -> Cause {
        let Finding { candidate, follows, .. } = finding;
        let [done, should] = told_alone(candidate, &self.names, &self.words);
        let step = self.key.solution.construction.numbered_steps().find(|s| s.number == candidate.step);
        let follows = match follows.as_slice() {
            // This mistake is in every value.
            _ if candidate.mistake() == Mistake::Truncated => None,
            // That is said already, or not known.
            [] if candidate.mistake() == Mistake::Unknown => None,
            [] => Some(self.own.check_follows_none().to_owned()),
            some => Some(self.own.check_follows(&self.names(some))),
        };
        Cause {
            done,
            caption: step.as_ref().map(|step| self.caption(step)),
            should,
            follows,
            worked: self.worked(&finding.lesson),
            redo: self.redo(&finding.lesson, candidate),
            hints: self.hints(finding, step.as_ref()),
            step: candidate.step,
        }
    }

    fn caption(&self, step: &NumberedStep<'_>) -> String {
        let caption = Teller::new(self.key.solution, &self.words).caption(step);
        shown_text(&caption, step.plan, &self.words)
    }

    fn names(&self, values: &[usize]) -> String {
        let names: Vec<String> =
            values.iter().map(|&i| self.names.shown(&self.checked.values[i].entry.asked)).collect();
        names.join(", ")
    }
}

/// At which step what was done, and what should have been, as two sentences.
pub(super) fn told_alone(candidate: &Candidate, names: &Names<'_>, words: &Wording) -> [String; 2] {
    let [done, should] = candidate.told.sentences_with(words, &|name| names.named(name));
    let own = words.language;
    let should = match candidate.mistake() {
        // Not how it should be, but where to look.
        Mistake::Unknown => format!("{should}."),
        _ => format!("{}: {should}.", own.check_instead()),
    };
    [format!("{}: {done}.", step(candidate, own)), should]
}

/// The words for the step at which a mistake was made.
fn step(candidate: &Candidate, own: &Language) -> String {
    match candidate.step {
        0 => own.check_whole().to_owned(),
        number => own.check_step(&number.to_string()),
    }
}

/// The style of values in a report.
pub(super) const fn significant(digits: usize) -> NumberStyle {
    NumberStyle::significant(digits).trimmed().in_full(-5, 12)
}

/// The style of differences in a report.
const fn signed(decimals: usize) -> NumberStyle {
    NumberStyle::decimals(decimals).with_plus()
}
