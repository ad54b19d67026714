//! In: a scene with its plans, and a [`Measured`] sheet: the values that a student has read from a drawing. Out: a
//! [`Checked`] list of verdicts, each against the band of honest hand drawings of that quantity, and the mistakes that
//! explain the values best: the construction is replayed with one mistake, then with more, and every replay is compared
//! with all values, right and wrong ones.
//!
//! In reading order: `measured` has the answer key, the values of a form and the error of what is not understood; `names`
//! has the names of a form's boxes, those on the sheets, and what a written name means, `named` the centres of forms whose figure shows none; `form` reads and writes forms as
//! JSON and lists their boxes for a page, `table` as a table. `entry` makes of each value a quantity with its number, with
//! what `written` knows of digits and `units` of units, `on_paper` which points of a sheet have places, and `placed` what these tell; `sensible` has the scales at which a sheet can be drawn,
//! `common` the error that all lengths of a sheet share. `checked` is what a check finds; `verdicts` judges the values, `prepared` carries it out and keeps what many
//! forms of one scene have in common.
//!
//! `model` predicts all values together with their common errors, those of a drawing program among them;
//! `covariance`, `score`, `fit` and `nearer` compute how well values fit a prediction, `own_rates` which follow from others anyhow; `mistakes/` is the catalogue, `settle`
//! fits the amounts of unknown mistakes, `search` tries all of them, `diagnosis` weighs the explanations and chooses the one
//! that is told, and `lesson` says what is to be learnt from it.
//!
//! `report` says it in parts and as text, `result` as JSON, `redrawn/` draws the student's sheets as they probably were,
//! `marks` gives the marks that values earn, `class` sums up many drawings, `feedback` makes of one what its student gets
//! back; `student` draws with mistakes on purpose; `photographs` has what is on photographed sheets, `proposed/` finds
//! their points among the pencil lines. Nothing is read or printed here, and no plan is computed again.
//!
//! # A check replays mistakes
//!
//! Every classical mistake is a small function that changes operations (`mistakes/`): a ray turned, a product left
//! out, another length measured. Slips of writing change the value that is compared, and what follows where the
//! student uses it later. Each replay predicts all values; honest errors, common to many values, give their
//! covariance (`covariance`). The values are gone through in the order of the construction, each against what the
//! earlier ones let expect; one that nothing explains pays for the range in which it could lie. How good the hand is
//! (from the pencil's tolerance to a drawing program), and whether it uses numbers later as it writes them, is
//! found from the values, too, for each sheet (`fit`): so an exact sheet shows slips of a last digit that a pencil
//! would hide, and a blunt pencil accuses nobody. Costs are −2 ln of likelihoods plus those of the mistakes, so that
//! a further mistake must explain more than it costs.
//!
//! # It is never surer than it is right
//!
//! Any operation may also be wrong by an amount that no mistake gives (`mistakes/unknown.rs`). The amount is fitted
//! so that the first wrong value is the written one (`settle`), and spreads over its whole range in the covariance:
//! so it pays by itself for fitting whatever comes. The search looks at all candidates by the factors of the parent's
//! covariance, at those only that concern a value still unexplained, and compares the likeliest completely.
//! `diagnosis` refuses what a written value refutes, sums the probabilities of what is told in the same words, leaves
//! a share for what no catalogue has, and tells a cause from 60 % on, else its place. What nothing explains is told at
//! the first value that is off, with what may have been done there as a part of it. Priors and that
//! share are set with students whom `tests/support/students` draws, who share nothing with the catalogue
//! (`examples/calibration.rs`). Nothing is looked for where all values pass.
//!
//! # A student's drawing lies over the right one
//!
//! `redrawn` replays the mistakes that were found and keeps what is visibly elsewhere, as names, places and
//! sentences; `drawing::overlay` draws these over the stepwise figure, whose marks know their steps: all pale but
//! those of the wrong steps. Neither knows the other's business. `Feedback` makes sheets or a page for the student of
//! it.
//!
//! # A class shares what its forms share
//!
//! `Prepared` keeps names, constructions of all assembly modes, bands and the covariance of a right drawing by the
//! quantities and scales of the forms; each form then stays on one core.

mod checked;
mod class;
mod common;
mod covariance;
mod diagnosis;
mod entry;
mod feedback;
mod fit;
mod form;
mod lesson;
mod marks;
mod measured;
mod mistakes;
#[doc(hidden)] // for tests
pub mod model;
mod named;
mod names;
mod nearer;
mod on_paper;
mod own_rates;
#[cfg(feature = "photo")]
mod photographs;
mod placed;
mod prepared;
#[cfg(feature = "photo")]
mod proposed;
#[doc(hidden)] // for tests
pub mod redrawn;
pub(crate) mod replayed;
mod report;
mod result;
#[doc(hidden)] // for tests
pub mod says;
mod score;
mod search;
mod sensible;
mod settle;
mod student;
mod table;
mod units;
mod verdicts;
#[doc(hidden)] // for tests
pub mod written;

pub use checked::{Accuracy, BANDS, Basis, Checked, Diagnosis, Explanation, Finding, Judged, Outcome, Verdict};
pub use class::{ClassColumns, ClassFound, ClassMistake, ClassResult, ClassRow, ClassSummary, Common, class_schema};
pub use common::CommonError;
pub use entry::{Entry, entries, faults};
pub use feedback::Feedback;
pub use form::{FormBox, form_boxes, further_boxes, sheet_points};
pub use marks::{Awarded, MarkScheme, Marks};
pub use measured::{AnswerKey, CheckError, DEPTH, Given, LENIENCY, Measured, PlacedPoint, PointsOf, Positive};
pub(crate) use mistakes::tell;
pub use mistakes::{Blank, Candidate, Mistake, Told};
pub(crate) use names::is_arm;
pub use names::{arm_names, asked_names, form_names};
pub use on_paper::PaperPoints;
#[cfg(feature = "photo")]
pub use photographs::{Aimed, PencilledPlan, PointVerdict, hundredths};
pub use placed::TurnedPlan;
pub use prepared::{Prepared, check};
#[cfg(feature = "photo")]
pub use proposed::{Found, Proposal, common_scale, proposed, proposed_form};
#[doc(inline)]
pub use redrawn::redrawn;
#[cfg(feature = "cli")]
pub(crate) use report::aligned;
pub use report::{Cause, ReportParts, ReportRow, report, report_parts};
pub use result::{CheckResult, check_result, check_schema};
pub use sensible::StatedScale;
pub use student::Student;
#[doc(inline)]
pub use written::Precision;
