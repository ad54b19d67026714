//! In: a mechanism, its pose and its motion. Out: a [`Construction`]: the velocity and acceleration plans as lists of [`Step`]s.
//! It is the second route to every rate: cut lines, special points, rays, crossings and the source paper's four equations,
//! solved apart from the loop equations and compared with them. Drawings, texts and checks read the steps and cross nothing again.

mod cut;
mod driven;
mod equation;
mod equations;
mod images;
mod name;
mod quantity;
mod solution;
mod state;
mod step;
mod symbol;
mod words;
mod write;

pub use cut::{CutLine, LegKind, Special, special_points};
pub use driven::SlideMeasure;
pub use equation::{Equation, Known, NamedPart, Term};
pub use equations::{Agreement, Construct, LegMeasure};
pub use name::{coincident_name, coriolis_name, display, image_name, normal_name, point_on, slide_name};
pub use quantity::{
    Asked, Component, Normality, Quantity, QuantityError, Scales, Spot, What, is_acceleration, measured_names,
    quantity, step_names,
};
pub use solution::{Solution, solve};
pub use state::{Snapshot, State};
pub use step::{Action, Arrow, Part, Plan, PlanKind, PlanPoint, PointRole, Ray, Relation, Step};
pub use symbol::Kind;
pub use words::{plain_text, rate_symbol, shown_text};
pub use write::{Construction, construction, construction_in};
