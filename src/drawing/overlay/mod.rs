//! A student's drawing over the right figure: where it differs, it has a pen of its own; wrong steps have the accent
//! colour; all else is paler.

mod layer;
#[doc(hidden)] // for tests
pub mod notes;
mod own;

pub(super) use layer::{OwnLayer, cross};
pub(super) use notes::{Notes, WordsPlace};
pub use own::{Overlay, OwnKind, OwnLine, OwnPoint, OwnValue, WrongStep};
