use super::files::{self, Source};
use super::message::{Failure, warn};
use crate::construction::Solution;
use crate::mechanism::{Mechanism, mechanism};
use crate::motion::Order;
use crate::position::{Pose, numbered_pose, pose, with_nearest_sides};
use crate::scene::{Figure, Scene};
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

/// How large a scene may be for what is done with it: links, points, and what has these limits.
pub(super) type Most = (usize, usize, &'static str);
/// For numbers: no more than a scene may have.
pub(super) const NUMBERS: Most = (usize::MAX, usize::MAX, "a scene");
/// For a figure, which takes three seconds then.
pub(super) const FIGURE: Most = (3_000, 10_000, "a figure");
/// For steps and pages, whose sheets grow as the square of the links.
pub(super) const STEPS: Most = (150, 1_000, "a figure with steps");
/// For what is drawn by hand: errors of all lines go through to all later ones.
pub(super) const HAND: Most = (1_000, 2_000, "a construction by hand");

/// Solves a scene to the given order of motion, after `override_figure` has put the options of the command line into
/// its figure; in the assembly mode of that number, else in the one that `near` picks.
pub(super) fn solve(
    source: &Source,
    most: Most,
    mode: Option<usize>,
    override_figure: impl Fn(&mut Figure),
    order: impl Fn(&Scene) -> Order,
) -> Result<Solution, Failure> {
    let stages = || -> Result<Solution, crate::Error> {
        let (mut scene, mechanism, pose) = posed(source, most, mode)?;
        override_figure(&mut scene.figure);
        let order = order(&scene);
        Ok(Solution::new(scene, mechanism, pose, order)?)
    };
    stages().map_err(|error| source.fail(error))
}

/// Reads a scene and finds its position; shows their warnings.
pub(super) fn start(path: &Path, mode: Option<usize>) -> Result<(Source, (Scene, Mechanism, Pose)), Failure> {
    let source = files::read(path)?;
    let posed = posed(&source, NUMBERS, mode).map_err(|error| source.fail(error))?;
    posed.1.warnings.iter().chain(&posed.2.warnings).for_each(|text| warn(text));
    Ok((source, posed))
}

fn posed(
    source: &Source,
    (links, points, what): Most,
    mode: Option<usize>,
) -> Result<(Scene, Mechanism, Pose), crate::Error> {
    let scene = Scene::read(&source.text)?;
    scene.check_size(links, points, what)?;
    let mechanism = with_nearest_sides(&scene, mechanism(&scene)?);
    let pose = match mode {
        Some(mode) => numbered_pose(&mechanism, &scene.near, mode)?,
        None => pose(&mechanism, &scene.near)?,
    };
    Ok((scene, mechanism, pose))
}

/// Shows the warnings of a solution on stderr.
pub(super) fn show_warnings(solution: &Solution) {
    solution.warnings().for_each(|text| warn(&text));
}
