//! A student's drawing over the right figure: what stands elsewhere on the own sheets, in a pen of its own, the steps at which something went
//! wrong in the accent colour, everything else pale.

mod layer;
mod notes;
mod own;

pub(super) use layer::OwnLayer;
pub(super) use notes::{Notes, WordsPlace};
pub use own::{Overlay, OwnKind, OwnLine, OwnPoint, OwnValue, WrongStep};
