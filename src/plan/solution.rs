use super::quantity::{Asked, Quantity, QuantityError};
use super::state::Snapshot;
use super::write::{Construction, construction_in};
use crate::Error;
use crate::mechanism::{Mechanism, mechanism};
use crate::motion::{Motion, MotionError, Order, motion};
use crate::position::{Pose, pose};
use crate::scene::Scene;
use crate::words::Wording;

/// A solved scene: the mechanism in one position with its motion and its plans. Figures, results, steps and checks start from here.
#[derive(Clone, Debug)]
pub struct Solution {
    /// What was asked for.
    pub scene: Scene,
    /// Its bodies, joints and groups.
    pub mechanism: Mechanism,
    /// Where everything is.
    pub pose: Pose,
    /// How everything moves.
    pub motion: Motion,
    /// The plans of that motion.
    pub construction: Construction,
}

/// Solves a scene: position, velocities, accelerations and both plans.
///
/// ```
/// let scene = kinegon::Scene::read(include_str!("../../examples/figure-2.json"))?;
/// let solution = kinegon::solve(&scene)?;
/// let link = solution.mechanism.link("4").expect("the scene has a link 4");
/// assert!((solution.motion.body(link).omega - -0.474663754894).abs() < 1e-12);
/// # Ok::<(), kinegon::Error>(())
/// ```
///
/// # Errors
/// It is no mechanism, cannot be assembled, or is in a singular position.
pub fn solve(scene: &Scene) -> Result<Solution, Error> {
    let mechanism = mechanism(scene)?;
    let pose = pose(&mechanism, &scene.near)?;
    Ok(Solution::new(scene.clone(), mechanism, pose, Order::Acceleration)?)
}

impl Solution {
    /// Motion and plans of a mechanism in a position that has been found.
    ///
    /// # Errors
    /// [`MotionError`] in a singular position.
    pub fn new(scene: Scene, mechanism: Mechanism, pose: Pose, order: Order) -> Result<Self, MotionError> {
        let motion = motion(&mechanism, &pose, order)?;
        let construction = construction_in(&mechanism, &pose, &motion, &Wording::of(&scene.figure));
        Ok(Self { scene, mechanism, pose, motion, construction })
    }

    /// The same mechanism in another position.
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

    /// Position and motion together, as quantities are read from them.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot<'_> {
        Snapshot { pose: &self.pose, motion: &self.motion }
    }

    /// The value of the quantity of that name, as in `omega(2)`, `a_n(D/G)` or `vplan(b,s3)`; lengths on paper (`/mu`) have no value here,
    /// for they need a figure's scales: [`Asked::value`].
    ///
    /// # Errors
    /// Says what the name should be, or why there is no value.
    pub fn quantity(&self, name: &str) -> Result<Quantity, QuantityError> {
        Asked::new(name, &self.mechanism)?.value(&self.snapshot(), Some(&self.construction), None)
    }

    /// What the reader should know of these numbers, in the order in which they were found.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        [&self.mechanism.warnings, &self.pose.warnings, &self.motion.warnings, &self.construction.warnings]
            .into_iter()
            .flatten()
            .map(String::as_str)
    }
}
