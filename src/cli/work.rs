use super::files;
use super::message::{Failure, Source, warn};
use crate::construction::Solution;
use crate::mechanism::Mechanism;
use crate::posed;
use crate::position::Pose;
use crate::scene::{Figure, Scene, SizeLimit};
use crate::sheet::Sheet;
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

/// Solves a scene to the given order of motion, after `override_figure` has put the options of the command line into
/// its figure; in the assembly mode of that number, else in the one that `near` picks.
pub(super) fn solve(
    source: &Source,
    most: SizeLimit,
    mode: Option<usize>,
    override_figure: impl Fn(&mut Figure),
    order: impl Fn(&Scene) -> Sheet,
) -> Result<Solution, Failure> {
    let stages = || -> Result<Solution, crate::Error> {
        let (mut scene, mechanism, pose) = read(source, most, mode)?;
        override_figure(&mut scene.figure);
        let order = order(&scene);
        Ok(Solution::new(scene, mechanism, pose, order)?)
    };
    stages().map_err(|error| source.fail(error))
}

/// Reads a scene and finds its position; shows their warnings.
pub(super) fn start(path: &Path, mode: Option<usize>) -> Result<(Source, (Scene, Mechanism, Pose)), Failure> {
    let source = files::read(path)?;
    let posed = read(&source, SizeLimit::NUMBERS, mode).map_err(|error| source.fail(error))?;
    posed.1.warnings.iter().chain(&posed.2.warnings).for_each(|text| warn(text));
    Ok((source, posed))
}

fn read(source: &Source, most: SizeLimit, mode: Option<usize>) -> Result<(Scene, Mechanism, Pose), crate::Error> {
    let scene = Scene::read(&source.text)?;
    let (mechanism, pose) = posed(&scene, most, mode)?;
    Ok((scene, mechanism, pose))
}

/// Shows the warnings of a solution on stderr.
pub(super) fn show_warnings(solution: &Solution) {
    solution.warnings().for_each(|text| warn(&text));
}
