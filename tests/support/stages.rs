//! A scene taken through all stages.

use kinegon::check::Drawn;
use kinegon::drafting::Tolerance;
use kinegon::drawing::{Drawing, figure, scales};
use kinegon::format::{self, ResultFile, Solved};
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::motion::{Motion, Order, motion};
use kinegon::plan::{Construction, construction_in};
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;
use kinegon::words::Wording;

/// All that is known of a scene.
pub struct Stages {
    pub scene: Scene,
    pub mechanism: Mechanism,
    pub pose: Pose,
    pub motion: Motion,
    pub construction: Construction,
}

impl Stages {
    pub fn of(text: &str) -> Result<Stages, kinegon::Error> {
        let scene = Scene::read(text)?;
        let mechanism = mechanism(&scene)?;
        let pose = pose(&mechanism, &scene.near)?;
        let motion = motion(&mechanism, &pose, Order::Acceleration)?;
        let words = Wording::of(&scene.figure);
        let construction = construction_in(&mechanism, &pose, &motion, &words);
        Ok(Stages { scene, mechanism, pose, motion, construction })
    }

    pub fn result(&self) -> ResultFile {
        format::result(Solved {
            units: self.scene.units,
            mechanism: &self.mechanism,
            pose: &self.pose,
            motion: &self.motion,
            construction: &self.construction,
        })
    }

    /// What a student's values are held against; so many mistakes at once are looked for.
    pub fn drawn(&self, depth: usize) -> Drawn<'_> {
        let (scene, mechanism, pose) = (&self.scene, &self.mechanism, &self.pose);
        Drawn {
            units: scene.units,
            near: &scene.near,
            mechanism,
            pose,
            motion: &self.motion,
            construction: &self.construction,
            scales: scales(scene, mechanism, pose, &self.construction),
            tolerance: Tolerance::default(),
            depth,
        }
    }

    pub fn drawing(&self) -> Drawing {
        figure(&self.scene, &self.mechanism, &self.pose, &self.construction)
    }
}
