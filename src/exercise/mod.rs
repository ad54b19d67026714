//! In: a scene and a seed. Out: [`Exercise`]s, variants of the scene with other round numbers that a student can draw by hand, each with its sheet,
//! its empty form and its key; the same for the same seed on every machine.
//! A variant is drawn by lot and taken only where a hand drawing comes out well; all that is asked of it stands in `judge`.
//!
//! In reading order: `numbers` finds the numbers of a scene file, `vary` puts others in their place, `judge` says which variants are no
//! exercises, `find` looks for the others, `given` and `key` say what a student and a teacher are told. Nothing is read or written here.

mod find;
mod given;
mod judge;
mod key;
mod numbers;
mod vary;

pub use find::{ExerciseError, Exercises};
pub use judge::{Exercise, Refusal};
pub use key::{KeyResult, KeyScales, KeyValue, key_schema};
pub use numbers::{Number, each_number};
