//! In: a mechanism, its pose, motion and [`Construction`](crate::plan::Construction), the scales of a sheet. Out: the construction as
//! [`Act`]s of drawing, measuring and computing that can be replayed on the values that a person with ruler and pencil has, with errors
//! and mistakes put in at any act; from that the [`Band`] that an honest hand drawing gives a quantity. Nothing is drawn here, and
//! without errors nothing comes out that the plans do not have.

mod act;
mod band;
mod body;
mod equations;
mod names;
mod read;
mod replay;
mod write;
mod writer;

pub use act::{Act, Deed, Equation, Error, How, LineId, NumberId, PlaceId, Product, Reference, Sheet};
pub use band::{Band, Pencil, Tolerance, pencil};
pub use names::readable_names;
pub use read::{Reading, Unread, drafting_with};
pub use replay::{Change, Disturbance, SheetScales, Values};
pub use writer::{Drafting, drafting};
