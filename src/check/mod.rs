//! In: a scene with its plans, and a [`Measured`] sheet of the values that a student has read from an own drawing. Out: a [`Checked`] list of
//! verdicts, each against the band of honest hand drawings of that very quantity, and the mistakes that explain the values best:
//! the construction is replayed with one mistake put in, then with more, and every replay is held against all values, right and wrong ones.
//!
//! In reading order: `sheet`, `file`, `table` and `unit` read the values, `template` writes an empty form; `entry` finds what each value stands
//! for, `precision` how finely it is written, `points` what places on paper say; `verdict` judges each by itself. `model` predicts all values together with their common
//! errors, `score`, `datum`, `covariance` and `fit` say how well values fit a prediction, `mistakes/` is the catalogue, `together` what a drawing program is off, `search` looks for what explains
//! the values, `diagnosis` what that comes to, `report` and `result` tell it, `redrawn/` draws it again as it was
//! probably drawn; `student` draws with mistakes on purpose;
//! `marks` says what values earn, `class` what is told of many drawings. Nothing is read or printed here, and no plan is computed again.

mod answer_key;
mod checked;
mod class;
mod covariance;
mod datum;
mod diagnosis;
mod entry;
mod explanation;
mod file;
mod fit;
mod marks;
mod mistakes;
mod model;
mod points;
mod precision;
mod redrawn;
mod report;
mod result;
mod score;
mod search;
mod sheet;
mod student;
mod table;
mod template;
mod together;
mod unit;
mod verdict;

pub use answer_key::AnswerKey;
pub use checked::{BANDS, Checked, check};
pub use class::{ClassFound, ClassMistake, ClassResult, ClassRow, ClassSummary, Common, class_schema};
pub use entry::{Entry, entries};
pub use explanation::{Diagnosis, Explanation, Finding};
pub use marks::{Awarded, MarkScheme, Marks};
pub use mistakes::{Candidate, Mistake};
pub use precision::Precision;
pub use redrawn::redrawn;
pub use report::report;
pub(crate) use report::significant;
pub use result::{CheckResult, check_result, check_schema};

pub use sheet::{CheckError, Given, Measured, PointsOf, Positive};
pub use student::Student;
pub use template::{form_names, template_csv, template_json};
pub use verdict::{Judged, Verdict};
