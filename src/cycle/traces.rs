//! What is shown of the whole cycle of a drive: paths and positions in a figure, positions one after another.

use super::circuit::is_same;
use super::drive::in_radians;
use super::locus::{PointPath, PointPaths, REACH};
use super::sampled::SAME;
use super::{CycleError, Drive, Path};
use crate::construction::Solution;
use crate::mechanism::{Mechanism, Role};
use crate::position::Pose;

/// Most turns of a drive that are followed until the mechanism is where it began.
const MOST_TURNS: usize = 12;

/// What the scheme of a figure shows of the whole cycle of a drive: the paths of points, and positions between.
///
/// The cycle lasts as many turns of the drive as the mechanism needs to be where it began; or it is the range that can
/// be reached on the branch of the scene's own position.
#[derive(Clone, Debug, Default)]
pub struct Traces {
    /// The paths that the figure asks for, in its order, with ticks at equal times from the scene's own position.
    pub paths: Vec<PointPath>,
    /// Equally spaced positions over the cycle, without the scene's own.
    pub ghosts: Vec<Pose>,
    /// The times of the ticks, if there are paths.
    pub times: Option<Times>,
}

/// Equal times, as steps of a drive at its speed in the scene.
#[derive(Clone, Debug)]
pub struct Times {
    /// The drive.
    pub drive: Drive,
    /// Whether limits stop the drive, so that the paths end there.
    pub is_stopped: bool,
    /// Distance of two ticks, in degrees or in the scene's unit of length.
    pub step: f64,
    /// The time for it, in the scene's unit; none for a drive at rest or with an acceleration.
    pub time: Option<f64>,
}

/// Whether no drive of the scene has an acceleration.
fn is_uniform(mechanism: &Mechanism) -> bool {
    let turns = mechanism.bodies.iter().all(|body| !matches!(body.role, Role::Driver { alpha, .. } if alpha != 0.0));
    turns && mechanism.sliders.iter().all(|slider| slider.drive.is_none_or(|drive| drive.acceleration == 0.0))
}

impl Traces {
    /// What the scene's figure asks for, with the first drive; nothing where that cannot be followed.
    #[must_use]
    pub fn of(solution: &Solution) -> Self {
        Self::new(solution, None).unwrap_or_default()
    }

    /// What the scene's figure asks for, with the drive of this name; without one with the first. Without paths and
    /// ghosts nothing is computed.
    ///
    /// # Errors
    /// There is no such drive, a point has no path, or the branch cannot be followed.
    pub fn new(solution: &Solution, drive: Option<&str>) -> Result<Self, CycleError> {
        let figure = &solution.scene.figure;
        if figure.trace.is_empty() && figure.ghosts.is_none() {
            return Ok(Self::default());
        }
        let drive = Drive::new(&solution.mechanism, drive)?;
        let mut path = Path::new(&solution.mechanism, &solution.pose, drive)?;
        let (range, is_closed) = cycle(&mut path)?;
        let mut shown = PointPaths::reached(&path, range)?;
        let step = shown.tick_step();
        let ticks = ticks(&shown, is_closed, step);
        for name in &figure.trace {
            shown.add(name, &ticks)?;
        }
        if figure.beyond_limits && !shown.curves.is_empty() {
            shown = shown.beyond_limits()?;
        }
        let times = (!shown.curves.is_empty()).then(|| Times {
            is_stopped: [false, true].into_iter().any(|above| path.end(above).is_some()),
            step,
            time: time(&path, step).filter(|_| is_uniform(&solution.mechanism)),
            drive: path.drive.clone(),
        });
        let ghosts = figure.ghosts.map_or_else(Vec::new, |count| ghosts(&shown, is_closed, &solution.pose, count));
        Ok(Self { paths: shown.curves, ghosts, times })
    }
}

/// The time that the drive needs for a step at its speed in the scene.
fn time(path: &Path, step: f64) -> Option<f64> {
    let input = &path.kernel.inputs[path.drive.input];
    (input.rate != 0.0).then(|| in_radians(input.kind, step) / input.rate.abs())
}

/// The range of the cycle of the path's drive, which is followed all along it; and whether the mechanism is at its end
/// where it was at its beginning.
fn cycle(path: &mut Path) -> Result<([f64; 2], bool), CycleError> {
    let range = path.whole_range()?;
    if !path.is_round() {
        return Ok((range, false));
    }
    let start = path.start();
    let closes = |turns: &usize| {
        let end = start + 360.0 * *turns as f64;
        path.follow_to(end);
        is_same(path, path, [start, end])
    };
    let turns = (1..=MOST_TURNS).find(closes);
    Ok(([start, start + 360.0 * turns.unwrap_or(1) as f64], turns.is_some()))
}

/// Values of the drive at this step from the scene's own, both ways; in a closed cycle each position once.
fn ticks(shown: &PointPaths, is_closed: bool, step: f64) -> Vec<f64> {
    let ([low, high], start) = (shown.range, shown.path.start());
    let slack = SAME * (high - low);
    let first = ((low - start - slack) / step).ceil() as i64;
    let last = ((high - start + slack) / step).floor() as i64;
    let last = if is_closed { last - 1 } else { last };
    (first..=last).map(|k| (start + k as f64 * step).clamp(low, high)).collect()
}

/// So many equally spaced positions: in a closed cycle from the scene's own, which is left out, else from end to end.
/// Positions out of reach are left out.
fn ghosts(shown: &PointPaths, is_closed: bool, own: &Pose, count: usize) -> Vec<Pose> {
    let ([low, high], path) = (shown.range, shown.path);
    // The path stops just before its limits.
    let (low, high) = (low.max(path.low()), high.min(path.high()));
    let parts = if is_closed { count } else { count.saturating_sub(1).max(1) };
    let values = (0..count).map(|k| low + (high - low) * k as f64 / parts as f64);
    let runs_off = path.runs_off();
    let is_near = |pose: &Pose| {
        let mut pairs = pose.points.iter().zip(&own.points);
        !runs_off || pairs.all(|(a, b)| (a - b).norm() <= REACH * path.size())
    };
    let mut walker = path.walker();
    let others = values.filter(|value| (value - path.start()).abs() > SAME * path.unit());
    let poses = others.filter_map(|value| walker.position(value.min(high)).map(|position| position.pose()));
    poses.filter(is_near).collect()
}

/// Distance that an animation keeps from each end of the drive's range, in parts of the range: at a limit position
/// rates are infinite.
const OFF_THE_END: f64 = 0.004;

/// A mechanism solved at equal steps of a drive, for showing one position after another.
#[derive(Clone, Debug)]
pub struct Animation {
    /// The drive; `None` for a drawn configuration or a mechanism without a drive, which have one position.
    pub drive: Option<Drive>,
    /// The drive's values in degrees or lengths, rising; a single zero without a drive.
    pub values: Vec<f64>,
    /// The mechanism solved at each value.
    pub positions: Vec<Solution>,
    /// Index of the scene's own position.
    pub own: usize,
    /// Whether the first position follows the last: the drive turns all the way round.
    pub is_round: bool,
}

impl Animation {
    /// About `count` positions over the whole range that the drive of this name (without one, the first) can reach on
    /// the branch of the solution's own position, and that position itself. Positions without a definite motion are
    /// left out.
    ///
    /// # Errors
    /// There is no drive of that name, or the branch cannot be followed.
    pub fn new(own: &Solution, drive: Option<&str>, count: usize) -> Result<Self, CycleError> {
        let (mechanism, pose) = (&own.mechanism, &own.pose);
        let still = Self { drive: None, values: vec![0.0], positions: vec![own.clone()], own: 0, is_round: false };
        let drive = match Drive::new(mechanism, drive) {
            Ok(drive) => drive,
            Err(CycleError::Drawn | CycleError::NoDrive) => return Ok(still),
            Err(error) => return Err(error),
        };
        let mut path = Path::new(mechanism, pose, drive.clone())?;
        let start = path.start();
        let [low, high] = path.whole_range()?;
        let is_round = path.is_round();
        let mut values: Vec<f64> = if is_round {
            let step = path.unit() / count.max(1) as f64;
            (1..count).map(|k| start + step * k as f64).collect()
        } else {
            let (low, high) = (low.max(path.low()), high.min(path.high()));
            let off = OFF_THE_END * (high - low);
            let step = (high - low - 2.0 * off) / count.max(2).saturating_sub(1) as f64;
            (0..count).map(|k| low + off + step * k as f64).collect()
        };
        // The scene's own position replaces a value next to it, so that steps stay nearly equal.
        let next = values.iter().position(|v| *v >= start).unwrap_or(values.len());
        if values.get(next).is_some_and(|v| (v - start).abs() < 1e-9 * path.unit()) {
            values.remove(next);
        }
        values.insert(next, start);
        let mut animation = Self { drive: Some(drive), values: Vec::new(), positions: Vec::new(), is_round, ..still };
        let mut walker = path.walker();
        for value in values {
            let solution = if value == start {
                animation.own = animation.values.len();
                Some(own.clone())
            } else {
                walker.position(value).and_then(|position| own.moved(position.pose()).ok())
            };
            if let Some(solution) = solution {
                animation.values.push(value);
                animation.positions.push(solution);
            }
        }
        Ok(animation)
    }
}
