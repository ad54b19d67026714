/// What a student's values are held against: the solved scene, and what may be expected of a hand.
#[derive(Clone, Copy, Debug)]
pub struct AnswerKey<'a> {
    /// The scene as it should be drawn, with accelerations.
    pub solution: &'a Solution,
    /// The scales of the scene's figure.
    pub scales: Scales,
    /// How good a hand may be expected to be.
    pub tolerance: Tolerance,
    /// How many mistakes at once are looked for.
    pub depth: usize,
}
use crate::construction::{Solution, Tolerance};
use crate::quantity::Scales;
