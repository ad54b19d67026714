//! One mechanism of a study by itself: in its position, with the values of its quantities there, and followed along its branch:
//! exactly, with its limits, and slowly.

use super::samples::unwrap;
use super::task::{Outcome, Status, Summary, Task, Wanted};
use crate::cycle::{CertainExtreme, Curves, CycleError, Extreme, Path, Steps, Sweep};
use crate::geometry::with_turns;
use crate::mechanism::{Mechanism, StructureError, mechanism};
use crate::position::{AssemblyError, Pose, counted_poses, pose, with_nearest_sides};
use crate::scene::{STRAIGHT, Scene, SceneError, Shape};

/// Most assemblies of a mechanism that are found for many side by side: of more it is quicker to look for the nearest one.
const MOST_ASSEMBLIES: usize = 16;

/// Why a study cannot be made of a scene.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The study asks for what the scene does not have; the place is in the study.
    #[error(transparent)]
    Study(#[from] SceneError),
    /// The scene is no mechanism that can be solved.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// The scene cannot be assembled.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// The scene cannot be moved.
    #[error(transparent)]
    Cycle(#[from] CycleError),
}

/// The mechanism of a varied scene, in its position; else what became of it.
pub(super) fn member(scene: &Scene) -> Result<(Mechanism, Pose), Status> {
    if !has_links(scene) {
        return Err(Status::NoMechanism);
    }
    posed(scene).map_err(|error| match error {
        StudyError::Assembly(_) => Status::NotAssembled,
        _ => Status::NoMechanism,
    })
}

/// Whether links with these lengths exist: all are positive, and three of a link form a triangle.
pub(super) fn has_links(scene: &Scene) -> bool {
    scene.links.values().all(|link| {
        let Shape::Lengths(lengths) = &link.shape else {
            return true;
        };
        let sum: f64 = lengths.iter().map(|length| length.value).sum();
        let longest = lengths.iter().map(|length| length.value).fold(0.0, f64::max);
        lengths.iter().all(|length| length.value > 0.0)
            && (lengths.len() < 3 || 2.0 * longest - sum <= STRAIGHT * longest)
    })
}

/// The mechanism of a scene in the assembly mode that `near` picks.
pub(super) fn posed(scene: &Scene) -> Result<(Mechanism, Pose), StudyError> {
    let mechanism = with_nearest_sides(scene, mechanism(scene)?);
    let pose = pose(&mechanism, &scene.near)?;
    Ok((mechanism, pose))
}

/// Every assembly of a mechanism; `None` where there are too many to look at all, or none.
pub(super) fn every_pose(mechanism: &Mechanism, scene: &Scene) -> Option<Vec<Pose>> {
    let listed = counted_poses(mechanism, &scene.near).ok()?;
    (listed.count.is_exact && listed.poses.len() <= MOST_ASSEMBLIES).then_some(listed.poses)
}

/// Follows one mechanism along its branch; values have bounds of their errors where its scene is given.
pub(super) fn follow_alone(task: &Task, scene: Option<&Scene>, mechanism: &Mechanism, pose: &Pose) -> Outcome {
    let none = |status| Outcome::without_motion(status, task);
    let range = &task.range;
    let Ok(mut path) = Path::new(mechanism, pose, range.drive.clone()) else {
        return none(Status::Singular);
    };
    match path.cover(Some(range.from), Some(range.to)) {
        Ok(_) => {}
        Err(CycleError::Singular { .. }) => return none(Status::Singular),
        Err(_) => return none(Status::Outside),
    }
    let [low, high] = range.ends();
    let whole = path.low() <= low && path.high() >= high;
    let mut outcome = none(if whole { Status::Whole } else { Status::Part });
    outcome.reach = Some(reach(&path, [low, high]));
    for (wanted, summary) in task.wanted.iter().zip(&mut outcome.summaries) {
        *summary = summarised(&path, task, wanted, scene);
    }
    outcome
}

/// The part of a range that a path has reached, with its limits.
fn reach(path: &Path, [low, high]: [f64; 2]) -> [f64; 2] {
    let end = |above: bool, reached: f64| path.end(above).map_or(reached, |end| end.at);
    let below = if path.low() > low { end(false, path.low()) } else { low };
    let above = if path.high() < high { end(true, path.high()) } else { high };
    [below.max(low), above.min(high)]
}

fn summarised(path: &Path, task: &Task, wanted: &Wanted, scene: Option<&Scene>) -> Summary {
    let names = [wanted.name.clone()];
    let mut summary = Summary { at_scene: sampled(path, None, wanted).first().copied(), ..Summary::default() };
    if let (Some(scene), Some(value)) = (scene, summary.at_scene) {
        summary.errors[2] = error_at(path, scene, wanted, [path.start(), value]);
    }
    let range = &task.range;
    if let Ok(curves) = Curves::new(path, [range.from, range.to], Some(&names))
        && let Some(curve) = curves.curves.first()
    {
        let found =
            |greatest: bool| curve.extremes.iter().find(|e| e.greatest == greatest).map(|e: &Extreme| [e.at, e.value]);
        let constant = curve.constant.map(|value| [curves.range[0], value]);
        (summary.max, summary.min) = (constant.or_else(|| found(true)), constant.or_else(|| found(false)));
        if let Some(scene) = scene {
            let certain = curves.certain_extremes(scene, curve);
            // A constant has one error at all positions.
            let error = |e: CertainExtreme| (e.is_proved || curve.constant.is_some()).then_some(e.error);
            let [min, max] = certain.map(|found| found.and_then(error).filter(|error| error.is_finite()));
            (summary.errors[0], summary.errors[1]) = (max, min);
        }
        // What grows without bound has no mean that samples could tell.
        if wanted.has_sum() && summary.max.is_some() && summary.min.is_some() {
            summary.sum(wanted, &sampled(path, Some(range.steps), wanted), range);
        }
    }
    summary
}

/// The bound of the error of a value that a quantity has at a value of the drive; `None` where it has none.
fn error_at(path: &Path, scene: &Scene, wanted: &Wanted, [at, value]: [f64; 2]) -> Option<f64> {
    // The size of a vector.
    let name = if wanted.asked.is_vector() { format!("{}.size", wanted.name) } else { wanted.name.clone() };
    let sweep = Sweep::new(path, Steps::new(at, at, 1.0).ok()?, Some(&[name])).ok()?.with_errors(scene);
    match *sweep.rows(0..sweep.steps.count()).as_slice() {
        [_, Some(own), Some(bound)] => {
            let off = if wanted.turns() { value - with_turns(own, value) } else { value - own };
            // The value is rounded where it is not the table's own.
            Some(bound + off.abs() * (1.0 + f64::EPSILON))
        }
        // The drive's own value is given.
        [_] => Some(0.0),
        _ => None,
    }
}

/// Values of a quantity at these steps, or at the scene's position; angles run on.
fn sampled(path: &Path, steps: Option<Steps>, wanted: &Wanted) -> Vec<f64> {
    let start = path.start();
    let Some(steps) = steps.or_else(|| Steps::new(start, start, 1.0).ok()) else {
        return Vec::new();
    };
    let Ok(sweep) = Sweep::new(path, steps, Some(std::slice::from_ref(&wanted.name))) else {
        return Vec::new();
    };
    let width = sweep.header().len();
    let numbers = sweep.rows(0..sweep.steps.count());
    let size = |row: &[Option<f64>]| match row {
        // The drive's own value is the first column, and not there twice.
        [drive] => drive.unwrap_or(f64::NAN),
        [_, number] => number.unwrap_or(f64::NAN),
        [_, x, y] => x.zip(*y).map_or(f64::NAN, |(x, y)| libm::hypot(x, y)),
        _ => f64::NAN,
    };
    let mut values: Vec<f64> = numbers.chunks_exact(width).map(size).collect();
    if wanted.turns() {
        unwrap(&mut values);
    }
    values
}
