//! What is shown of a mechanism besides its own position: of the whole cycle of a drive paths and positions in a figure,
//! and positions one after another; the other ways to assemble it.

use super::drive::in_radians;
use super::locus::{PointPath, PointPaths, REACH, is_same};
use super::sampled::SAME;
use super::{Centrode, CycleError, Drive, Path};
use crate::construction::Solution;
use crate::geometry::{degrees_of, span};
use crate::mechanism::{Mechanism, Role};
use crate::position::{AssemblyError, Pose, first_poses};
use crate::words::Wording;

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
    /// The centrodes of the links that the figure asks for, in its order.
    pub centrodes: Vec<Centrode>,
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
        if figure.trace.is_empty() && figure.centrodes.is_empty() && figure.ghosts.is_none() {
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
        let grid = if figure.centrodes.is_empty() { Vec::new() } else { shown.grid() };
        let centrodes = figure.centrodes.iter().map(|link| Centrode::new(&path, link, &grid));
        let centrodes = centrodes.collect::<Result<_, _>>()?;
        Ok(Self { paths: shown.curves, centrodes, ghosts, times })
    }
}

/// The time that the drive needs for a step at its speed in the scene.
fn time(path: &Path, step: f64) -> Option<f64> {
    let input = &path.kernel.inputs[path.drive.input];
    (input.rate != 0.0).then(|| in_radians(input.kind, step) / input.rate.abs())
}

/// The range of the cycle of the path's drive, which is followed all along it; and whether the mechanism is at its end
/// where it was at its beginning.
pub(super) fn cycle(path: &mut Path) -> Result<([f64; 2], bool), CycleError> {
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
        !runs_off || pairs.all(|(a, b)| (a - b).norm() <= REACH * path.size)
    };
    let mut walker = path.walker();
    let others = values.filter(|value| (value - path.start()).abs() > SAME * path.unit());
    let poses = others.filter_map(|value| walker.position(value.min(high)).map(|position| position.pose()));
    poses.filter(is_near).collect()
}

/// Distance that an animation keeps from each end of the drive's range, in parts of the range: at a limit position
/// rates are infinite.
pub(super) const OFF_THE_END: f64 = 0.004;

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
            Err(CycleError::Drawn | CycleError::AtContact | CycleError::OffGuide(_) | CycleError::NoDrive) => {
                return Ok(still);
            }
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

/// Difference of angles in degrees, or of slides in sizes of the mechanism, that counts as none.
const STANDS: f64 = 1e-9;

/// The other ways to assemble a mechanism, with its drives where they stand.
#[derive(Clone, Debug, Default)]
pub struct OtherModes {
    /// The first of them, each with its number among all modes from 1, the mechanism's own among them.
    pub shown: Vec<(usize, Pose)>,
    /// Whether there are more.
    pub has_more: bool,
    /// The number of the own mode, if it is among the first.
    pub own: Option<usize>,
}

impl OtherModes {
    /// Most modes that are shown: more cannot be told apart on a sheet.
    pub const MOST: usize = 12;

    /// The other modes of a mechanism that may have been moved from its scene's own position. A drawn configuration has
    /// none.
    ///
    /// # Errors
    /// The mechanism cannot be assembled, or only with too much work.
    pub fn of(solution: &Solution) -> Result<Self, AssemblyError> {
        let standing = standing(&solution.mechanism, &solution.pose);
        let mechanism = standing.as_ref().unwrap_or(&solution.mechanism);
        let poses = first_poses(mechanism, &solution.scene.near, Self::MOST + 2)?;
        let own = poses.iter().position(|pose| pose.is_same_as(&solution.pose)).map(|index| index + 1);
        let others = (1..).zip(poses).filter(|(number, _)| Some(*number) != own);
        let mut shown: Vec<(usize, Pose)> = others.collect();
        let has_more = shown.len() > Self::MOST;
        shown.truncate(Self::MOST);
        Ok(Self { shown, has_more, own })
    }

    /// That not all of them are drawn, in the figure's language; none where all are.
    #[must_use]
    pub fn note(&self, words: &Wording) -> Option<String> {
        self.has_more.then(|| words.language.modes_left_out(&self.shown.len().to_string()))
    }

    /// By mode: the point that is farthest from those of all other modes and of the own position, where its number can
    /// stand.
    #[must_use]
    pub fn apart(&self, own: &Pose) -> Vec<usize> {
        let poses = || self.shown.iter().map(|(_, pose)| pose);
        let farthest = |(index, pose): (usize, &Pose)| {
            let others = || poses().enumerate().filter(move |(other, _)| *other != index).map(|(_, pose)| pose);
            let distance = |point: &usize| {
                let all = others().chain(std::iter::once(own)).flat_map(|other| &other.points);
                all.map(|place| (place - pose.points[*point]).norm_squared()).fold(f64::INFINITY, f64::min)
            };
            (0..pose.points.len()).max_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or_default()
        };
        poses().enumerate().map(farthest).collect()
    }
}

/// The mechanism with its drives as they stand in a pose; `None` where that is as the scene gives them.
fn standing(mechanism: &Mechanism, pose: &Pose) -> Option<Mechanism> {
    let size = span(pose.points.iter().copied());
    let mut moved = Mechanism { placing: None, ..mechanism.clone() };
    let mut is_moved = false;
    for (body, axis) in moved.bodies.iter_mut().zip(&pose.axes) {
        if let (Role::Driver { angle, .. }, Some(axis)) = (&mut body.role, axis) {
            let now = degrees_of(*axis);
            is_moved |= angle.is_some_and(|given| libm::remainder(given - now, 360.0).abs() > STANDS);
            *angle = Some(now);
        }
    }
    for (slider, slide) in moved.sliders.iter_mut().zip(&pose.slides) {
        if let (Some(drive), Some(now)) = (&mut slider.drive, slide) {
            is_moved |= drive.position.is_some_and(|given| (given - now).abs() > STANDS * size);
            drive.position = Some(*now);
        }
    }
    if let Some(placing) = &mechanism.placing {
        let now = pose.axes[placing.link.0].map(degrees_of);
        is_moved |= now.is_some_and(|now| libm::remainder(placing.angle - now, 360.0).abs() > 1e3 * STANDS);
    }
    is_moved.then_some(moved)
}
