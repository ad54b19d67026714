use super::files::{self, Source};
use super::message::{Failure, warn};
use crate::mechanism::{Mechanism, mechanism};
use crate::motion::{Motion, Order, motion};
use crate::plan::{Construction, construction_in};
use crate::position::{AssemblyError, Pose, pose, poses};
use crate::scene::{Figure, Near, Scene};
use crate::words::Wording;
use clap::Args;
use std::path::Path;

/// Which assembly mode is wanted.
#[derive(Debug, Args)]
pub(super) struct Mode {
    /// Assembly mode by its number in `kinegon modes`, in place of the one that `near` picks.
    #[arg(long = "mode", value_name = "MODE", value_parser = mode_number)]
    pub number: Option<usize>,
}

fn mode_number(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(0) => Err("assembly modes are numbered from 1".to_owned()),
        Ok(number) => Ok(number),
        Err(_) => Err("not the number of an assembly mode".to_owned()),
    }
}

/// A scene after all stages before drawing.
pub(super) struct Work {
    pub scene: Scene,
    pub mechanism: Mechanism,
    pub pose: Pose,
    pub motion: Motion,
    pub construction: Construction,
}

/// Takes a scene through its stages, as far as `order` says, with what was `asked` of its figure on the command line; in the assembly mode of that number, else the one that `near` picks.
pub(super) fn work(
    source: &Source,
    mode: Option<usize>,
    asked: impl Fn(&mut Figure),
    order: impl Fn(&Scene) -> Order,
) -> Result<Work, Failure> {
    let stages = || -> Result<Work, crate::Error> {
        let (mut scene, mechanism, pose) = posed(source, mode)?;
        asked(&mut scene.figure);
        let motion = motion(&mechanism, &pose, order(&scene))?;
        let wording = Wording::of(&scene.figure);
        let construction = construction_in(&mechanism, &pose, &motion, &wording);
        Ok(Work { scene, mechanism, pose, motion, construction })
    };
    stages().map_err(|error| Failure::Scene(source.clone(), Box::new(error)))
}

/// Reads a scene and finds its position; says what the reader should know of them.
pub(super) fn start(path: &Path, mode: Option<usize>) -> Result<(Source, (Scene, Mechanism, Pose)), Failure> {
    let source = files::read(path)?;
    let posed = posed(&source, mode);
    let posed = posed.map_err(|error| Failure::Scene(source.clone(), Box::new(error)))?;
    let warnings = posed.1.warnings.iter().chain(&posed.2.warnings);
    warnings.for_each(|text| warn(text));
    Ok((source, posed))
}

fn posed(source: &Source, mode: Option<usize>) -> Result<(Scene, Mechanism, Pose), crate::Error> {
    let scene = Scene::read(&source.text)?;
    let mechanism = mechanism(&scene)?;
    let pose = match mode {
        Some(mode) => numbered(&mechanism, &scene.near, mode)?,
        None => pose(&mechanism, &scene.near)?,
    };
    Ok((scene, mechanism, pose))
}

/// The assembly mode of that number, counted from 1.
fn numbered(mechanism: &Mechanism, near: &Near, mode: usize) -> Result<Pose, crate::Error> {
    let mut poses = poses(mechanism, near)?;
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
        let found = [&self.mechanism.warnings, &self.pose.warnings, &self.motion.warnings, &self.construction.warnings];
        for warning in found.into_iter().flatten() {
            warn(warning);
        }
    }
}
