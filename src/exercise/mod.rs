//! In: a scene and a seed. Out: [`Exercise`]s, variants of the scene with other round numbers that a student can draw
//! by hand, each with its sheet, its empty form and its key; the same for the same seed on every machine.
//! A variant gets random numbers and is accepted only where a hand drawing comes out well; `judge` has all the
//! conditions.
//!
//! In reading order: `vary` finds the numbers of a scene file and replaces them, `teeth` those of wheels, `judge` accepts or refuses a variant,
//! `asked` chooses the values that it asks for, `even` makes loads alike that are too unequal to be drawn, `find` looks for accepted ones, `sheets` writes what stands on the sheets of a student and of a teacher, also for a scene
//! as it stands, `key` the values for the teacher. Nothing is read or written here.
//!
//! # An exercise is a scene that passes an examination
//!
//! `vary` puts other round numbers into the scene's file, `judge` asks of what comes out all that a hand needs:
//! crossings, room, lengths on paper, bands. The accepted file says its own position and scales, and is judged again
//! as it stands, so that nothing depends on how it was found.

mod asked;
mod centers;
mod even;
mod find;
mod forces;
mod given;
mod judge;
mod key;
#[doc(hidden)] // for tests
pub mod says;
mod sheets;
mod teeth;
mod vary;

#[cfg(feature = "courses")]
pub use asked::MEASURABLE;
pub use find::{ExerciseError, Exercises};
pub use judge::{Exercise, Refusal};
pub use key::{KeyResult, KeyScales, KeyValue, key_schema};
pub use vary::{Number, each_number};
