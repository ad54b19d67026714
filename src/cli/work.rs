use super::files::Source;
use super::message::{Failure, warn};
use crate::mechanism::{Mechanism, mechanism};
use crate::motion::{Motion, Order, motion};
use crate::plan::{Construction, construction};
use crate::position::{AssemblyError, Pose, pose, poses};
use crate::scene::Scene;

/// A scene after all stages before drawing.
pub(super) struct Work {
    pub scene: Scene,
    pub mechanism: Mechanism,
    pub pose: Pose,
    pub motion: Motion,
    pub construction: Construction,
}

/// Takes a scene through its stages, as far as `order` says; in the assembly mode of that number, else the one that `near` picks.
pub(super) fn work(
    source: &Source,
    mode: Option<usize>,
    order: impl Fn(&Scene) -> Order,
) -> Result<Work, Failure> {
    let stages = || -> Result<Work, crate::Error> {
        let scene = Scene::read(&source.text)?;
        let mechanism = mechanism(&scene)?;
        let pose = match mode {
            Some(mode) => numbered(&mechanism, mode)?,
            None => pose(&mechanism, &scene.near)?,
        };
        let motion = motion(&mechanism, &pose, order(&scene))?;
        let construction = construction(&mechanism, &pose, &motion);
        Ok(Work {
            scene,
            mechanism,
            pose,
            motion,
            construction,
        })
    };
    stages().map_err(|error| Failure::Scene(source.clone(), Box::new(error)))
}

/// The assembly mode of that number, counted from 1.
fn numbered(mechanism: &Mechanism, mode: usize) -> Result<Pose, crate::Error> {
    let mut poses = poses(mechanism)?;
    let count = poses.len();
    if (1..=count).contains(&mode) {
        Ok(poses.swap_remove(mode - 1))
    } else {
        Err(AssemblyError::NoSuchMode { mode, count }.into())
    }
}

impl Work {
    /// Says on stderr what the reader should know of the result.
    pub(super) fn warn(&self) {
        let found = [
            &self.mechanism.warnings,
            &self.pose.warnings,
            &self.motion.warnings,
            &self.construction.warnings,
        ];
        for warning in found.into_iter().flatten() {
            warn(warning);
        }
    }
}
