//! Positions of a mechanism at equal times while a drive runs over and over.

use super::pull::PAST_CHANGE;
use super::traces::{OFF_THE_END, cycle};
use super::{CycleError, Drive, Path};
use crate::construction::Solution;
use crate::position::Pose;

/// The positions through which a drive takes a mechanism at equal times, until it is where it began: shown over and over
/// they have no jump.
///
/// They begin with the scene's own position and go on in the sense of the drive's speed; other drives run along in
/// proportion to theirs. A drive that turns all the way round is followed for as many turns as the mechanism needs; one
/// that does not, or after which the mechanism is never where it was, goes to and fro.
///
/// ```
/// use kinegon::cycle::Running;
///
/// let scene = kinegon::Scene::read(include_str!("../../templates/four-bar.json"))?;
/// let solution = kinegon::solve(&scene)?;
/// let running = Running::new(&solution, None, 90)?;
/// assert!(running.turns == Some(1) && running.poses.len() == 90);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Running {
    /// The drive.
    pub drive: Drive,
    /// The positions; after the last comes the first.
    pub poses: Vec<Pose>,
    /// The turns after which the mechanism is where it began; none where the drive goes to and fro.
    pub turns: Option<usize>,
    /// Whether the drive's value falls at its speed in the scene.
    pub is_backwards: bool,
}

impl Running {
    /// The positions of a solution's mechanism with the drive of this name, without one with the first: so many in a
    /// turn, or on the way to and fro. Positions without a definite motion are left out.
    ///
    /// # Errors
    /// There is no such drive, or the branch cannot be followed.
    pub fn new(own: &Solution, drive: Option<&str>, count: usize) -> Result<Self, CycleError> {
        let drive = Drive::new(&own.mechanism, drive)?;
        let mut path = Path::new(&own.mechanism, &own.pose, drive)?;
        let (range, is_closed) = cycle(&mut path)?;
        let count = count.max(1);
        let is_backwards = path.runs_backwards();
        let sense = if is_backwards { -1.0 } else { 1.0 };
        let turns = is_closed.then(|| ((range[1] - range[0]) / path.unit()).round() as usize);
        let values = match turns {
            Some(turns) => round(range, sense, count * turns),
            None => to_and_fro(kept_off(&path, range), path.start(), sense, count),
        };
        let mut walker = path.walker();
        let beside = PAST_CHANGE * path.unit();
        let mut pose = |value: f64| {
            let near = [value, value + beside, value - beside];
            near.into_iter().find_map(|value| walker.position(value).map(|position| position.pose()))
        };
        let others: Vec<Pose> = values.into_iter().skip(1).filter_map(&mut pose).collect();
        let poses = std::iter::once(own.pose.clone()).chain(others).collect();
        Ok(Self { drive: path.drive.clone(), poses, turns, is_backwards })
    }
}

/// Values of a drive that turns all the way round, from its own.
fn round([from, to]: [f64; 2], sense: f64, count: usize) -> Vec<f64> {
    let step = (to - from) / count as f64;
    // The path has been followed upwards; a whole cycle away stands the same mechanism.
    let first = if sense > 0.0 { from } else { to };
    (0..count).map(|k| first + sense * step * k as f64).collect()
}

/// Values of a drive that goes from its own to an end, to the other end and back.
fn to_and_fro([low, high]: [f64; 2], own: f64, sense: f64, count: usize) -> Vec<f64> {
    let there_and_back = 2.0 * (high - low);
    if there_and_back <= 0.0 {
        return vec![own];
    }
    let folded = |way: f64| {
        let way = way - there_and_back * (way / there_and_back).floor();
        low + way.min(there_and_back - way)
    };
    (0..count).map(|k| folded(own - low + sense * there_and_back * k as f64 / count as f64)).collect()
}

/// A range without what is next to the limits that stop a drive: rates are infinite there. The drive's own value stays in
/// it.
fn kept_off(path: &Path, [low, high]: [f64; 2]) -> [f64; 2] {
    let (low, high) = (low.max(path.low()), high.min(path.high()));
    let off = |above: bool| if path.end(above).is_some() { OFF_THE_END * (high - low) } else { 0.0 };
    [(low + off(false)).min(path.start()), (high - off(true)).max(path.start())]
}
