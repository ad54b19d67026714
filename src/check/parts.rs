//! The report in parts, for a page that shows them one by one.

use super::answer_key::AnswerKey;
use super::checked::Checked;
use super::report::ReportText;
use super::rows::FormNames;
use super::shown::ShownNames;
use crate::words::{Medium, Wording};
use schemars::JsonSchema;
use serde::Serialize;

/// A report in parts, in the markup of [`Overlay::set`](crate::drawing::Overlay::set). What is right and what was
/// probably done stand apart, so that a page can say the one without the other.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ReportParts {
    /// How many values are right, within the tolerance, off.
    pub counts: String,
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
    /// How sure these are.
    pub sure: Option<String>,
    /// Which values nothing explains, and which plans are mirrored.
    pub further: Vec<String>,
    /// What else explains the values.
    pub others: Vec<String>,
}

/// A value of a report.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ReportRow {
    /// The name of the form's box.
    pub name: String,
    /// Name, own value, exact value, difference, the same on paper and in per cent, what is allowed, verdict.
    pub cells: [String; 8],
}

/// A mistake that was probably made.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Cause {
    /// At which step, and what was done.
    pub done: String,
    /// The step's caption.
    pub caption: Option<String>,
    /// What it should be.
    pub should: String,
    /// Which values follow from it.
    pub follows: Option<String>,
}

impl ReportParts {
    /// The parts with all texts but the names of boxes set by a function, as in HTML.
    #[must_use]
    pub fn set(self, set: impl Fn(String) -> String) -> ReportParts {
        let all = |texts: Vec<String>| texts.into_iter().map(&set).collect();
        let cause = |Cause { done, caption, should, follows }| Cause {
            done: set(done),
            caption: caption.map(&set),
            should: set(should),
            follows: follows.map(&set),
        };
        let row = |ReportRow { name, cells }: ReportRow| ReportRow { name, cells: cells.map(&set) };
        ReportParts {
            counts: set(self.counts),
            accuracy: all(self.accuracy),
            columns: self.columns.map(&set),
            rows: self.rows.into_iter().map(row).collect(),
            senses: self.senses.map(&set),
            heading: set(self.heading),
            causes: self.causes.into_iter().map(cause).collect(),
            sure: self.sure.map(&set),
            further: all(self.further),
            others: all(self.others),
        }
    }
}

/// The parts of the report on checked values, in the wording's language.
#[must_use]
pub fn report_parts(checked: &Checked, key: &AnswerKey<'_>, words: &Wording) -> ReportParts {
    let text = ReportText::new(checked, key, words, Medium::Figure);
    let (shown, form) = (ShownNames::of(key.solution), FormNames::new(&key.solution.construction));
    let rows = checked.values.iter().map(|value| {
        let name = shown.in_form(&value.entry.row, &form);
        ReportRow { name, cells: text.row(value) }
    });
    let best = &checked.diagnosis.best;
    let causes = best.findings.iter().map(|finding| {
        let told = text.told(finding);
        Cause { done: told.done, caption: told.caption, should: told.should, follows: told.follows }
    });
    let is_off = !text.has_nothing_to_explain();
    ReportParts {
        counts: text.counts(),
        accuracy: text.accuracy(),
        columns: words.language.check_columns().map(str::to_owned),
        rows: rows.collect(),
        senses: text.senses(),
        heading: text.heading(),
        causes: causes.collect(),
        sure: (!best.findings.is_empty()).then(|| text.sure(best)),
        further: if is_off { text.unexplained().into_iter().chain(text.mirrored()).collect() } else { Vec::new() },
        others: if is_off {
            checked.diagnosis.others.iter().map(|other| text.other(other)).collect()
        } else {
            Vec::new()
        },
    }
}
