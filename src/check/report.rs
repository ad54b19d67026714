//! The report as text, in the figure's language.

use super::answer_key::AnswerKey;
use super::checked::Checked;
use super::explanation::{Explanation, Finding};
use super::mistakes::{Candidate, Mistake};
use super::shown::ShownNames;
use super::verdict::{Judged, Verdict};
use crate::construction::Teller;
use crate::construction::shown_text;
use crate::words::{Language, Medium, NumberStyle, Wording};

/// The report for the student: verdicts in the order of the construction, then the mistakes that were probably made.
#[must_use]
pub fn report(checked: &Checked, key: &AnswerKey<'_>, words: &Wording) -> String {
    let report = ReportText::new(checked, key, words, Medium::Text);
    let mut lines = vec![report.counts()];
    lines.extend(report.accuracy());
    lines.push(String::new());
    lines.extend(report.table());
    lines.push(String::new());
    lines.extend(report.senses());
    lines.extend(report.diagnosis());
    lines.join("\n") + "\n"
}

/// The sentences about one mistake.
pub(super) struct Told {
    /// At which step, and what was done.
    pub done: String,
    /// The step's caption.
    pub caption: Option<String>,
    /// What it should be.
    pub should: String,
    /// Which values follow from it.
    pub follows: Option<String>,
}

/// Writes the sentences about checked values.
pub(super) struct ReportText<'a> {
    pub checked: &'a Checked,
    key: &'a AnswerKey<'a>,
    words: &'a Wording,
    pub own: &'static Language,
    medium: Medium,
    shown: ShownNames<'a>,
}

impl<'a> ReportText<'a> {
    pub(super) fn new(
        checked: &'a Checked,
        key: &'a AnswerKey<'a>,
        words: &'a Wording,
        medium: Medium,
    ) -> ReportText<'a> {
        ReportText { checked, key, words, own: words.language, medium, shown: ShownNames::of(key.solution) }
    }
}

impl ReportText<'_> {
    /// The sentence that counts the values that are right, within the tolerance, and off.
    pub(super) fn counts(&self) -> String {
        let count = |verdict| self.count(verdict).to_string();
        let [right, within, off] = [Verdict::Right, Verdict::WithinTolerance, Verdict::Off].map(count);
        match self.count(Verdict::SenseMissing) {
            0 => self.own.check_counts(&right, &within, &off),
            missing => self.own.check_counts_and_senses(&right, &within, &missing.to_string(), &off),
        }
    }

    fn count(&self, verdict: Verdict) -> usize {
        self.checked.values.iter().filter(|v| v.verdict == verdict).count()
    }

    /// The sentence about rates without a sense, if there are any.
    pub(super) fn senses(&self) -> Option<String> {
        (self.count(Verdict::SenseMissing) > 0).then(|| self.own.check_senses().to_owned())
    }

    fn table(&self) -> Vec<String> {
        let mut rows: Vec<[String; 8]> = vec![self.own.check_columns().map(str::to_owned)];
        rows.extend(self.checked.values.iter().map(|value| self.row(value)));
        let width = |column: usize| rows.iter().map(|r| r[column].chars().count()).max();
        let widths: Vec<usize> = (0..8).map(|c| width(c).unwrap_or(0)).collect();
        let line = |row: &[String; 8]| {
            let mut line = String::new();
            for (column, cell) in row.iter().enumerate() {
                let blanks = " ".repeat(widths[column] - cell.chars().count());
                match column {
                    0 | 7 => line.push_str(&format!("{cell}{blanks}  ")),
                    _ => line.push_str(&format!("{blanks}{cell}  ")),
                }
            }
            line.trim_end().to_owned()
        };
        rows.iter().map(line).collect()
    }

    fn number(&self, value: f64, digits: usize) -> String {
        self.words.write(value, significant(digits).on(self.medium))
    }

    /// A value as a row of the table.
    pub(super) fn row(&self, value: &Judged) -> [String; 8] {
        let entry = &value.entry;
        let unit = entry.asked.kind().unit(self.key.solution.scene.units);
        let expected = if entry.is_magnitude { entry.expected.abs() } else { entry.expected };
        let on_paper = entry.per_mm.and_then(|mu| {
            let mm = self.words.on_paper(value.difference, mu, signed(2).on(self.medium))?;
            Some(format!("{mm} mm"))
        });
        let percent = 100.0 * value.difference / entry.expected.abs();
        // Beside nearly nothing everything is many times as large.
        let percent = (percent.abs() < 1e6).then(|| {
            let digits = if percent.abs() < 10.0 { 2 } else { 0 };
            let percent = self.words.write(percent, signed(digits).on(self.medium));
            format!("{percent} %")
        });
        let tolerance = value.tolerance.map(|t| format!("±{}", self.number(t, 2)));
        let verdict = match value.verdict {
            Verdict::Right => self.own.check_right(),
            Verdict::WithinTolerance => self.own.check_within(),
            Verdict::SenseMissing => self.own.check_sense_missing(),
            Verdict::Off => self.own.check_off(),
            Verdict::Unjudged => self.own.check_unjudged(),
        };
        [
            self.shown.quantity(&entry.asked),
            self.number(entry.value, 7),
            format!("{} {unit}", self.number(expected, 7)),
            self.number(value.difference, 3),
            on_paper.unwrap_or_default(),
            percent.unwrap_or_default(),
            tolerance.unwrap_or_default(),
            verdict.to_owned(),
        ]
    }

    /// How much is allowed, and how accurate the drawing is.
    pub(super) fn accuracy(&self) -> Vec<String> {
        let number = |x: f64| self.words.write(x, NumberStyle::shortest());
        let asked = &self.key.tolerance;
        let [mm, degrees] = [asked.mm, asked.degrees].map(number);
        let mut lines = vec![self.own.check_tolerance(&mm, &degrees)];
        // A drawing program is more exact than a tenth of a millimetre.
        let Some(found) = self.checked.accuracy.filter(|found| found.mm >= SEEN) else {
            return lines;
        };
        let tenth = |x: f64| self.words.write(x.max(0.1), NumberStyle::decimals(1));
        let mut own = self.own.check_accuracy(&tenth(found.mm), &tenth(found.degrees));
        if found.percent > 0.0 {
            own = format!("{own} {}", self.own.check_slips(&number(found.percent)));
        }
        let size = found.mm / asked.mm;
        if size > 1.0 && self.key.latitude > 1.0 {
            own = format!("{own} {}", self.own.check_wider(&mm, &degrees));
        }
        let most = self.key.latitude.max(1.0);
        if size > 1.001 * most {
            let [mm, degrees] = [most * asked.mm, most * asked.degrees].map(tenth);
            own = format!("{own} {}", self.own.check_too_coarse(&mm, &degrees));
        }
        lines.push(own);
        lines
    }

    /// The heading of the mistakes that were found, or the sentence that there are none, or that none can be told.
    pub(super) fn heading(&self) -> String {
        let diagnosis = &self.checked.diagnosis;
        match (diagnosis.best.findings.len(), diagnosis.unexplained.first()) {
            (0, _) if self.has_nothing_to_explain() && self.count(Verdict::SenseMissing) > 0 => {
                self.own.check_nothing_off().to_owned()
            }
            (0, _) if self.has_nothing_to_explain() => self.own.check_nothing().to_owned(),
            (0, Some(&first)) => {
                let entry = &self.checked.values[first].entry;
                let (step, name) = (entry.step.to_string(), self.shown.quantity(&entry.asked));
                if self.is_alone() {
                    self.own.check_none_alone(&step, &name)
                } else {
                    self.own.check_none(&step, &name)
                }
            }
            (0 | 1, _) => self.own.check_probably().to_owned(),
            _ => self.own.check_no_single().to_owned(),
        }
    }

    /// Whether one value alone is off and nothing explains it: the heading says all of it.
    fn is_alone(&self) -> bool {
        let diagnosis = &self.checked.diagnosis;
        diagnosis.best.findings.is_empty() && diagnosis.unexplained.len() == 1 && self.count(Verdict::Off) == 1
    }

    pub(super) fn has_nothing_to_explain(&self) -> bool {
        let diagnosis = &self.checked.diagnosis;
        let none = diagnosis.best.findings.is_empty() && diagnosis.unexplained.is_empty();
        none && self.checked.is_passed()
    }

    fn diagnosis(&self) -> Vec<String> {
        let diagnosis = &self.checked.diagnosis;
        let mut lines = vec![self.heading()];
        if self.has_nothing_to_explain() {
            return lines;
        }
        for (finding, number) in diagnosis.best.findings.iter().zip(1..) {
            let told = self.told(finding);
            lines.push(format!("{number}. {}", told.done));
            let caption = told.caption.map(|caption| format!("({caption})"));
            let more = caption.into_iter().chain([told.should]).chain(told.follows);
            lines.extend(more.map(|line| format!("   {line}")));
        }
        if !diagnosis.best.findings.is_empty() {
            lines.push(self.sure(&diagnosis.best));
        }
        lines.extend(self.unexplained());
        lines.extend(self.mirrored());
        if !diagnosis.others.is_empty() {
            lines.push(String::new());
            lines.push(self.own.check_others().to_owned());
            lines.extend(diagnosis.others.iter().map(|other| format!("  - {}", self.other(other))));
        }
        lines
    }

    /// What else explains the values, as far as it differs from the best explanation.
    pub(super) fn other(&self, other: &Explanation) -> String {
        let best = &self.checked.diagnosis.best.findings;
        let new = other.findings.iter().filter(|f| !best.iter().any(|g| g.candidate.told == f.candidate.told));
        let told: Vec<String> = new
            .map(|f| {
                let [done, _] = f.candidate.told.sentences_with(self.words, &|name| self.shown.named(name));
                format!("{}: {done}", self.step(f))
            })
            .collect();
        let end = if other.is_alike { self.own.check_alike().to_owned() } else { self.sure(other) };
        format!("{} ({end})", told.join("; "))
    }

    /// The sentences about mirrored plans.
    pub(super) fn mirrored(&self) -> impl Iterator<Item = String> {
        let language = self.words.language;
        self.checked.mirrored.iter().map(|plan| self.own.check_mirrored(&language.sheet(*plan).to_lowercase()))
    }

    /// The sentence about the unexplained values, if there are any.
    pub(super) fn unexplained(&self) -> Option<String> {
        let values = &self.checked.diagnosis.unexplained;
        (!values.is_empty() && !self.is_alone()).then(|| self.own.check_unexplained(&self.names(values)))
    }

    pub(super) fn sure(&self, explanation: &Explanation) -> String {
        let percent = (100.0 * explanation.probability).clamp(1.0, 99.0);
        self.own.check_sure(&format!("{percent:.0}"))
    }

    fn step(&self, finding: &Finding) -> String {
        step(&finding.candidate, self.own)
    }

    /// The sentences about a mistake.
    pub(super) fn told(&self, finding: &Finding) -> Told {
        let Finding { candidate, follows, .. } = finding;
        let [done, should] = told_alone(candidate, &self.shown, self.words);
        let step = self.key.solution.construction.numbered_steps().find(|s| s.number == candidate.step);
        let follows = match follows.as_slice() {
            // This mistake is in every value.
            _ if candidate.mistake() == Mistake::Truncated => None,
            [] => Some(self.own.check_follows_none().to_owned()),
            some => Some(self.own.check_follows(&self.names(some))),
        };
        Told {
            done,
            caption: step.map(|step| {
                let caption = Teller::new(self.key.solution, self.words).caption(&step);
                shown_text(&caption, step.plan, self.words)
            }),
            should,
            follows,
        }
    }

    fn names(&self, values: &[usize]) -> String {
        let names: Vec<String> =
            values.iter().map(|&i| self.shown.quantity(&self.checked.values[i].entry.asked)).collect();
        names.join(", ")
    }
}

/// Accuracy of a drawing from which on it is said, in mm.
const SEEN: f64 = 0.05;

/// At which step what was done, and what should have been, as two sentences.
pub(super) fn told_alone(candidate: &Candidate, shown: &ShownNames<'_>, words: &Wording) -> [String; 2] {
    let [done, should] = candidate.told.sentences_with(words, &|name| shown.named(name));
    let own = words.language;
    [format!("{}: {done}.", step(candidate, own)), format!("{}: {should}.", own.check_instead())]
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
