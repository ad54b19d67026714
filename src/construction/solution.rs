use super::construct::construct;
use super::constructed::{Construction, Extent};
use super::markup::{no_construction, plain_text};
use crate::mechanism::Mechanism;
use crate::motion::{Motion, MotionError, motion};
use crate::position::Pose;
use crate::scene::{ConstructionShown, Scene};
use crate::sheet::Sheet;
use crate::words::Wording;

/// A solved scene: the mechanism in one position with its motion and its plans. Input of figures, results, steps and
/// checks.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The scene as read.
    pub scene: Scene,
    /// Its bodies, joints and groups.
    pub mechanism: Mechanism,
    /// Places of all points and directions of all guides.
    pub pose: Pose,
    /// Velocities and accelerations.
    pub motion: Motion,
    /// The plans of that motion.
    pub construction: Construction,
}

impl Solution {
    /// Motion and plans of a mechanism at a pose.
    pub fn new(scene: Scene, mechanism: Mechanism, pose: Pose, order: Sheet) -> Result<Self, MotionError> {
        let motion = motion(&mechanism, &pose, order)?;
        let extent = match scene.figure.construction {
            ConstructionShown::Paper => Extent::Rates,
            ConstructionShown::Whole | ConstructionShown::Hidden => Extent::Points,
        };
        let construction = construct(&mechanism, &pose, &motion, extent);
        Ok(Self { scene, mechanism, pose, motion, construction })
    }

    /// The solution of the mechanism in another position.
    ///
    /// # Errors
    /// [`MotionError`] in a singular position.
    pub fn moved(&self, pose: Pose) -> Result<Self, MotionError> {
        Self::new(self.scene.clone(), self.mechanism.clone(), pose, self.motion.order)
    }

    /// Language and notation of the figure.
    #[must_use]
    pub fn wording(&self) -> Wording {
        Wording::of(&self.scene.figure)
    }

    /// The warnings of all stages, in English, in the order in which they were found.
    pub fn warnings(&self) -> impl Iterator<Item = String> {
        let found = [&self.mechanism.warnings, &self.pose.warnings, &self.motion.warnings];
        // Warnings are in English whatever the language of the figure.
        let without = self.construction.without().map(|far| plain_text(&no_construction(&Wording::default(), far)));
        found.into_iter().flatten().cloned().chain(without)
    }
}
