//! In: the name of a quantity and a solved scene. Out: its value ([`QuantityRequest::value`]), its unit and symbol, how a hand
//! reads it from its drawing ([`read_by_hand`]) and the scatter of honest drawings ([`Pencil`]). Each property of a
//! quantity has a file. Not here: which mistake explains a wrong value (`check/`), and how a number is written
//! (`words/`).
//!
//! # A hand drawing is the construction with errors
//!
//! An operation's elementary errors (up to 0.3 mm, 0.3°, all equally likely) go through the later ones; their
//! difference quotients in quadrature make the band: 2.1 standard deviations (`band`). Pairs of drawings with all
//! errors at once show where first order is not enough: the band then says that it is rough. Any operation may be
//! replaced by a mistaken one.

mod band;
mod error;
mod force_name;
mod forces;
mod name;
mod names;
mod poles;
mod reading;
#[doc(hidden)] // for tests
pub mod says;
mod turning;
mod unit;
mod value;
mod ways;

pub use crate::scene::{Component, Head, QuantityName};
pub use crate::sheet::QuantityKind;
pub use band::{Band, Pencil, pencil, step_pencil};
pub use error::QuantityError;
pub use force_name::{ArmPoint, ForceOf, LinePart, LoadOf, Towards, force_names};
pub(crate) use forces::ForceRead;
pub use forces::KeptForces;
pub use name::{AccelerationPart, Pole, PoleOf, QuantityRequest, Spot, What};
pub use names::{measured_names, readable_names, step_names};
pub use reading::{Reading, Sense, Unread, read_by_hand};
pub use turning::turning_names;
pub use value::{Quantity, Snapshot, State};
pub use ways::Corners;
