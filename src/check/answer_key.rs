use crate::construction::{Solution, Tolerance};
use crate::sheet::Scales;

/// How many times as large as usual an honest hand's errors may be where nobody has said how accurate it should be: up to
/// 1 mm and 1° with the usual tolerance.
pub const LATITUDE: f64 = 10.0 / 3.0;

/// How many mistakes at once are usually looked for.
pub const DEPTH: usize = 5;

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

impl<'a> AnswerKey<'a> {
    /// The key of a scene at the scales of its figure. Without limits of the hand's errors those of a sharp pencil hold,
    /// and the scatter of all values shows how much larger they may be.
    #[must_use]
    pub fn new(solution: &'a Solution, hand: Option<Tolerance>) -> AnswerKey<'a> {
        AnswerKey {
            solution,
            scales: solution.scales(),
            tolerance: hand.unwrap_or_default(),
            latitude: if hand.is_some() { 1.0 } else { LATITUDE },
            depth: DEPTH,
        }
    }
}
