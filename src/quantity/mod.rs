//! In: the name of a quantity and a solved scene. Out: its value ([`Asked::value`]), its unit and symbol, how a hand reads it from its drawing
//! ([`read_by_hand`]) and how far an honest hand is off ([`Pencil`]).
//! Each property of a quantity is said once, in the file of that property. Not here: what an error of a measured value means (`check/`),
//! and how a number is written (`words/`).

mod band;
mod lists;
mod name;
mod reading;
mod state;
mod unit;
mod value;

pub use band::{Band, Pencil, pencil};
pub use lists::{measured_names, readable_names, step_names};
pub use name::{Asked, Component, Normality, QuantityError, Spot, What, is_acceleration};
pub use reading::{Reading, Sense, Unread, read_by_hand};
pub use state::{Snapshot, State};
pub use unit::Kind;
pub use value::{Quantity, Scales};
