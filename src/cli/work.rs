use super::files::Source;
use super::message::{Failure, warn};
use crate::mechanism::{Mechanism, mechanism};
use crate::motion::{Motion, Order, motion};
use crate::plan::{Construction, construction};
use crate::position::{Pose, pose};
use crate::scene::Scene;

/// A scene after all stages before drawing.
pub(super) struct Work {
    pub scene: Scene,
    pub mechanism: Mechanism,
    pub pose: Pose,
    pub motion: Motion,
    pub construction: Construction,
}

/// Takes a scene through its stages, as far as `order` says.
pub(super) fn work(source: &Source, order: impl Fn(&Scene) -> Order) -> Result<Work, Failure> {
    let stages = || -> Result<Work, crate::Error> {
        let scene = Scene::read(&source.text)?;
        let mechanism = mechanism(&scene)?;
        let pose = pose(&mechanism, &scene.near)?;
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
