/// What a student's values are compared with: the solved scene, and the accuracy expected of a hand.
#[derive(Clone, Copy, Debug)]
pub struct AnswerKey<'a> {
    /// The right solution of the scene, with accelerations.
    pub solution: &'a Solution,
    /// The scales of the scene's figure.
    pub scales: Scales,
    /// Limits of the errors of an honest hand.
    pub tolerance: Tolerance,
    /// How many times as large an honest hand's errors may be where the scatter of all values shows that they are. 1: the
    /// tolerance rules.
    pub latitude: f64,
    /// Largest number of mistakes that are looked for together.
    pub depth: usize,
}
use crate::construction::{Solution, Tolerance};
use crate::quantity::Scales;
