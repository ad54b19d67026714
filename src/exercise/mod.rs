//! In: a scene and a seed. Out: [`Exercise`]s, variants of the scene with other round numbers that a student can draw
//! by hand, each with its sheet, its empty form and its key; the same for the same seed on every machine.
//! A variant gets random numbers and is accepted only where a hand drawing comes out well; `judge` has all the
//! conditions.
//!
//! In reading order: `numbers` finds the numbers of a scene file, `vary` replaces them, `judge` accepts or refuses a
//! variant, `find` looks for accepted ones, `given` and `key` write what a student and a teacher are told, `sheets` what
//! stands on their sheets, also for a scene as it stands. Nothing is read or written here.
//!
//! # An exercise is a scene that passes an examination
//!
//! `vary` puts other round numbers into the scene's file, `judge` asks of what comes out all that a hand needs:
//! crossings, room, lengths on paper, bands. The accepted file says its own position and scales, and is judged again
//! as it stands, so that nothing depends on how it was found.

mod find;
mod given;
mod judge;
mod key;
mod numbers;
mod sheets;
mod vary;

pub use find::{ExerciseError, Exercises};
pub use judge::{Exercise, Refusal};
pub use key::{KeyResult, KeyScales, KeyValue, key_schema};
pub use numbers::{Number, each_number};
