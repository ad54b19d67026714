//! In: a scene with its plans, and a [`Measured`] sheet: the values that a student has read from a drawing. Out: a
//! [`Checked`] list of verdicts, each against the band of honest hand drawings of that quantity, and the mistakes that
//! explain the values best: the construction is replayed with one mistake, then with more, and every replay is compared
//! with all values, right and wrong ones.
//!
//! In reading order: `sheet` has the values of a form, `form` reads and writes them as JSON, `table` as a table; `rows` has
//! the boxes of a scene's form, `shown` the names of the sheets, `names` finds what a written name means, `boxes` lists what
//! a page asks for. `entry` makes of each value a quantity with its number (`precision`: how finely it is written; `unit`:
//! the unit beside it; `points`: distances between given places); `error` says what is not understood. `answer_key` is what
//! values are compared with, `prepared` keeps what many forms of one scene have in common; `checked` gives each value its
//! `verdict`.
//!
//! `model` predicts all values together with their common errors, `together` the errors that a drawing program makes;
//! `datum`, `covariance`, `hand`, `walk`, `score` and `fit` compute how well values fit a prediction; `mistakes/` is the
//! catalogue, `settle` fits the amounts of unknown mistakes, `search` tries all of them, `diagnosis` weighs the
//! explanations and chooses the `explanation` that is told.
//!
//! `report` says it in parts and as text, `result` as JSON, `redrawn/` draws the student's sheets as they probably were,
//! `marks` gives the marks that values earn, `class` sums up many drawings, `feedback` makes of one what its student gets
//! back; `student` draws with mistakes on purpose; `photographs` has the plans of photographed sheets, `proposed/` finds
//! their points among the pencil lines. Nothing is read or printed here, and no plan is computed again.

mod answer_key;
mod boxes;
mod checked;
mod class;
mod covariance;
mod datum;
mod diagnosis;
mod entry;
mod error;
mod explanation;
mod feedback;
mod fit;
mod form;
mod hand;
mod marks;
mod mistakes;
mod model;
mod names;
#[cfg(feature = "photo")]
mod photographs;
mod points;
#[doc(hidden)] // for tests
pub mod precision;
mod prepared;
#[cfg(feature = "photo")]
mod proposed;
#[doc(hidden)] // for tests
pub mod redrawn;
mod report;
mod result;
mod rows;
mod score;
mod search;
mod settle;
mod sheet;
mod shown;
mod student;
mod table;
#[doc(hidden)] // for tests
pub mod together;
mod unit;
mod verdict;
mod walk;

pub use answer_key::{AnswerKey, DEPTH, LATITUDE};
pub use boxes::{FormBox, form_boxes, further_boxes, plan_points};
pub use checked::{Accuracy, BANDS, Checked, check};
pub use class::{ClassColumns, ClassFound, ClassMistake, ClassResult, ClassRow, ClassSummary, Common, class_schema};
pub use entry::{Entry, entries, faults};
pub use explanation::{Diagnosis, Explanation, Finding};
pub use feedback::Feedback;
pub use form::{EmptyForm, FilledForm};
pub use marks::{Awarded, MarkScheme, Marks};
pub use mistakes::{Blank, Candidate, Mistake, Told};
#[cfg(feature = "photo")]
pub use photographs::{Aimed, PencilledPlan, PlacedPoint, PointVerdict, hundredths};
pub use precision::Precision;
pub use prepared::Prepared;
#[cfg(feature = "photo")]
pub use proposed::{Found, Proposal, Proposals, proposed};
pub use redrawn::redrawn;
pub use report::{Cause, ReportParts, ReportRow, report, report_parts};
pub use result::{CheckResult, check_result, check_schema};

pub use error::CheckError;
pub use rows::{form_name, form_names};
pub use sheet::{Given, Measured, PointsOf, Positive};
pub use student::Student;
pub use verdict::{Judged, Verdict};
