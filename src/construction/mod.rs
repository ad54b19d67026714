//! In: a mechanism, its pose and its motion. Out: a [`Construction`]: the velocity and acceleration plans as the
//! [`Operation`]s of ruler, pencil and calculator that draw them, and as the [`NumberedStep`]s that a teacher takes at the
//! board. Each operation is carried out when it is written, with bounds of its rounding errors; so the construction is
//! a second, independent computation of every rate, compared with the loop equations. The same operations can be
//! repeated with a hand's errors or with mistakes ([`Values`]). Drawings, texts and checks read steps and values and
//! construct nothing again. A [`Solution`] holds all results of a scene.
//!
//! In reading order: `cut` (cut lines and special points); `operation` and `number` (what a hand and a calculator do),
//! carried out by `run`; `writer`, which writes them down in the [`Construction`]; what is drawn: `body`,
//! `leg`, `group`, `train` (wheels), `images`; `solution`, which goes through all groups; `kennedy`, instant centres on a sheet of their own; `polygon`, the force plan; `lever`, Zhukovsky's lever; `speeds`, Kutzbach's diagram of a train. `enclosed` carries all out on the true
//! position and motion; `step`, `markup`, `sentence`, `equations` and `passage` are for captions; `turned` shows the velocity plan turned.
//!
//! To add something that a hand does: an [`OperationKind`] with its errors, and how it is carried out in `run`. To add
//! a construction: a method of `Writer` that begins a step, writes operations and finishes the step with what it has
//! done; steps, bands, forms, checks and drawings read what it puts down.
//!
//! # The plan is the second route
//!
//! The special points are homogeneous crossings of cut lines; the rays are crossed, and the source paper's four
//! equations solved with nalgebra's full pivoting (for a third-class group the same with two special points of its
//! central link, for a dyad with its inner joint). This shares nothing with the loop equations but the pose. The
//! result states the difference of the two routes beside the difference that rounding and the sines of the crossings
//! allow. The paper's determinant is that of the loop equations over both sines: a special point at infinity breaks
//! the construction, not the mechanism. Then the rates come from the loop equations alone, and the result says so.
//!
//! # One list of operations, carried out four ways
//!
//! Each operation names its sheet, its step, its role, and the places, lines and numbers that it reads and makes, by
//! typed index. It is carried out in `Ball`s when it is written: these values are the plans, and their bounds tell
//! how well the two routes to the rates must agree. `Values<f64>` carries the same list out on the values that a
//! person has: lengths measured off the sheet, sizes computed from rates that were themselves solved for, in about a
//! microsecond; `enclosed` carries it out on what `accuracy/` knows of the true mechanism, so that every segment has a bound of
//! its whole error. Nothing else crosses lines: there is one interpreter (`run`), for both kinds of number.
//!
//! Operations and steps carry meanings, no words. `sentence` turns a step into its caption and its equation with the
//! sentences of `words/`.
//!
//! # A plan has all points
//!
//! When a group's rates are known, `images` adds the image of every further point of its links: from two images that
//! are there by division of their line or by two rays over the link's triangle, else by the motion relative to one,
//! each part of it a step. `Extent::Rates` leaves that out, as the source paper does. A group without a construction
//! takes its rates from the motion and continues alike, from the known links on. An image's bounds are those of the
//! rotation about a point of its link, so that they do not grow from crossing to crossing.

mod body;
mod constructed;
mod contact;
mod cut;
mod enclosed;
mod equations;
mod group;
mod images;
#[doc(hidden)] // for tests
pub mod kennedy;
mod leg;
mod lever;
mod markup;
mod name;
mod number;
mod operation;
mod passage;
mod polygon;
mod run;
mod sentence;
mod solution;
mod speeds;
mod step;
mod train;
mod turned;
mod writer;

pub use constructed::{Agreement, Construction, Extent};
pub use contact::contacts_told;
pub use cut::{Course, CutLine, Special, SpecialId, Term};
pub(crate) use enclosed::Truth;
pub use kennedy::{
    Center, CenterId, CenterLine, CenterOrigin, CenterVelocity, Centers, CurvatureStep, FigureOf, Inflection, Spot,
};
pub use lever::{Lever, LeverForce, LeverStep};
pub use markup::{Formula, FormulaTerm, Known, display, shown_text};
pub(crate) use markup::{plain_text, rate_symbol};
pub(crate) use name::point_on;
pub use name::{coincident_name, image_name, normal_name};
pub use number::{End, Equation, NumberId, NumberKind, Product, ProductKind, Rate};
pub use operation::{
    Along, ErrorUnit, LineId, MeasuredAs, Operation, OperationKind, OperationRole, PlaceId, Reference, Ruled, RuledEnd,
    StepId,
};
pub use passage::{Aim, Passage};
pub(crate) use polygon::{ComingRound, FoundForce, FoundNumbers, Rubbed, pressing_off};
pub use polygon::{
    Corner, ForceArm, ForceOf, ForcePart, ForcePlan, ForceStep, Found, LoadShown, Moment, MomentPoint, Polygon, Side,
    SideKind,
};
pub use run::{Change, Disturbance, Tolerance, Values};
pub use sentence::{PlanVector, Teller};
pub(crate) use solution::asked_construction;
pub(crate) use solution::force_polygons;
pub use solution::{Solution, construct};
pub use speeds::{BeltLine, PitchCircle, PitchLine, SpeedDiagram, SpeedLine, SpeedSpot, SpeedStep, SpotName};
pub use step::{
    Action, Arrow, LegEquation, NOTHING, NumberedStep, Plan, PlanPoint, PointRole, RateEquation, Ray, RayOf, Relation,
    VectorOf, VectorPart, WheelEquation,
};
pub(crate) use writer::Writer;
