//! In: a mechanism, its pose and its motion. Out: a [`Construction`]: the velocity and acceleration plans as the
//! [`Operation`]s of ruler, pencil and calculator that draw them, and as the [`Step`]s that a teacher takes at the
//! board. Each operation is carried out when it is written, with bounds of its rounding errors; so the construction is
//! a second, independent computation of every rate, compared with the loop equations. The same operations can be
//! repeated with a hand's errors or with mistakes ([`Values`]). Drawings, texts and checks read steps and values and
//! construct nothing again. A [`Solution`] holds all results of a scene.
//!
//! In reading order: `cut` (cut lines and special points), `operation`, `run`, `writer`, `body`, `leg`, `group`,
//! `construct`; `step` and `sentence` for captions and equations.

mod agreement;
mod body;
mod construct;
mod cut;
mod formula;
mod group;
mod images;
mod leg;
mod name;
mod operation;
mod passage;
mod run;
mod sentence;
mod solution;
mod step;
mod vectors;
mod writer;

pub use agreement::Agreement;
pub(crate) use construct::construction_writer;
pub use construct::{Construction, Extent, NumberedStep, construct};
pub use cut::{Course, CutLine, Special, SpecialId, Term, special_points};
pub use formula::{Formula, FormulaTerm, Known, NamedPart};
pub use name::{coincident_name, coriolis_name, display, image_name, normal_name, point_on, slide_name};
pub use operation::{
    Along, End, Equation, ErrorUnit, LineId, MeasuredAs, NumberId, NumberKind, Operation, OperationKind, Part, PlaceId,
    Product, ProductKind, Rate, Reference, StepId,
};
pub use passage::{Aim, Passage};
pub use run::{Change, Disturbance, Drawable, Tolerance, Values};
pub use sentence::{Teller, plain_text, rate_symbol, shown_text};
pub use solution::Solution;
pub use step::{
    Action, Added, Arrow, ArrowKind, LegEquation, NOTHING, Plan, PlanPoint, PointRole, Ray, RayOf, Relation,
    RelativePart, Step, VectorOf,
};
pub use vectors::PlanVector;
pub(crate) use writer::Writer;
