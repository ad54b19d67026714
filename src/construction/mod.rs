//! In: a mechanism, its pose and its motion. Out: a [`Construction`]: the velocity and acceleration plans as the
//! [`Operation`]s of ruler, pencil and calculator that draw them, and as the [`Step`]s that a teacher takes at the
//! board. Each operation is carried out when it is written, with bounds of its rounding errors; so the construction is
//! a second, independent computation of every rate, compared with the loop equations. The same operations can be
//! repeated with a hand's errors or with mistakes ([`Values`]). Drawings, texts and checks read steps and values and
//! construct nothing again. A [`Solution`] holds all results of a scene.
//!
//! In reading order: `cut` (cut lines and special points); `operation` and `number` (what a hand and a calculator do),
//! carried out by `run`; `writer`, which writes them down in `record` and in the [`Construction`]; what is drawn: `body`,
//! `leg`, `group`, `rates`, `joint_images`, `images`; `construct`, which goes through all groups. `step`, `plan`, `sentence`,
//! `equations` and `passage` are for captions.
//!
//! To add something that a hand does: an [`OperationKind`] with its errors, and how it is carried out in `run`. To add
//! a construction: a method of `Writer` that begins a step, writes operations and finishes the step with what it has
//! done; steps, bands, forms, checks and drawings read what it puts down.

mod body;
mod construct;
mod construction;
mod cut;
mod equations;
mod formula;
mod group;
mod images;
mod joint_images;
mod leg;
mod markup;
mod name;
mod number;
mod operation;
mod passage;
mod plan;
mod rates;
mod record;
mod run;
mod sentence;
mod solution;
mod step;
mod vectors;
mod writer;

pub use construct::construct;
pub use construction::{Agreement, Construction, Extent, NumberedStep};
pub use cut::{Course, CutLine, Special, SpecialId, Term};
pub use formula::{Formula, FormulaTerm, Known, NamedPart};
pub use markup::{display, shown_text};
pub(crate) use markup::{plain_text, rate_symbol};
pub(crate) use name::point_on;
pub use name::{coincident_name, image_name, normal_name};
pub use number::{End, Equation, NumberId, NumberKind, Product, ProductKind, Rate};
pub use operation::{
    Along, ErrorUnit, LineId, MeasuredAs, Operation, OperationKind, OperationRole, PlaceId, Reference, StepId,
};
pub use passage::{Aim, Passage};
pub use plan::{NOTHING, Plan, PlanPoint, PointRole};
pub use run::{Change, Disturbance, Tolerance, Values};
pub use sentence::Teller;
pub use solution::Solution;
pub use step::{Action, Added, Arrow, ArrowKind, LegEquation, Ray, RayOf, Relation, RelativePart, Step, VectorOf};
pub use vectors::PlanVector;
pub(crate) use writer::Writer;
