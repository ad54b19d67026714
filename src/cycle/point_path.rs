use super::circuit::other_branches;
use super::curve::{Shown, grid};
use super::tip::{MARKS, Tip};
use super::{CycleError, Event, Happening, Path};
use crate::geometry::{Point, Vector};
use crate::mechanism::{BodyId, GROUND, PointId};
use crate::quantity::State;

/// Largest distance of a path from the middle of the straight line between two samples, in sizes of the mechanism: on a
/// sheet that shows the whole mechanism a hundredth of a millimetre at most.
const TOLERANCE: f64 = 1e-5;
/// Smallest distance of two samples, in parts of the range of the drive.
const CLOSEST: f64 = 1e-7;
/// Distance of two samples at the smallest distance that counts as a gap, in sizes of the mechanism.
const GAP: f64 = 1e-3;
/// Distance from the scene's own position up to which a point is followed that runs off to infinity, in sizes of the
/// mechanism.
pub(super) const REACH: f64 = 3.0;
/// Step either way from a tick at which the direction of the path is found, in turns of the drive.
const ASIDE: f64 = 1e-4;

/// The path of a point of a link over a range of a drive, in the scene's frame and unit of length.
#[derive(Clone, Debug)]
pub struct PointPath {
    /// The point.
    pub point: PointId,
    /// Its name.
    pub name: String,
    /// The first link with that point.
    pub link: BodyId,
    /// Values of the drive and places, in pieces without a gap, so dense that straight lines between them look like the
    /// path. They run evenly in the drive's value, so that a cusp is sharp and a double point is met twice.
    pub pieces: Vec<Vec<(f64, Point)>>,
    /// The rest of the curve, which the drive cannot reach on the branch of the scene's own position: the mechanism,
    /// moved by another link, goes through limit positions over to the branches that end there too. In such pieces;
    /// none unless it was asked for.
    pub beyond: Vec<Vec<(f64, Point)>>,
    /// Places at equal steps of the drive.
    pub ticks: Vec<Tick>,
    /// The place in the scene's own position, if that is in the range.
    pub own: Option<Point>,
}

/// A place on a path at a marked value of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    /// The drive's value; an angle of a whole turn counted from 0° to 360°.
    pub value: f64,
    /// The place.
    pub place: Point,
    /// Unit vector along the path there, at a cusp along its tangent; none where the point rests.
    pub along: Option<Vector>,
}

/// The paths of points over a range of a motion.
#[derive(Clone, Debug)]
pub struct PointPaths<'a> {
    /// The motion.
    pub path: &'a Path<'a>,
    /// Lowest and highest value of the drive that are shown: the part of the range that the motion has reached.
    pub range: [f64; 2],
    /// The paths, in the order in which they were asked for, with ticks at round values of the drive: in a whole turn
    /// every 30°.
    pub paths: Vec<PointPath>,
    /// The events in the range, in the order of the drive's value.
    pub events: Vec<Event>,
}

impl<'a> PointPaths<'a> {
    /// The paths of points by their names, over the part of `range` that `path` has reached.
    ///
    /// # Errors
    /// A name is no point of a moving link, or nothing of the range has been reached.
    pub fn new(path: &'a Path<'a>, range: [f64; 2], points: &[String]) -> Result<Self, CycleError> {
        let shown = Shown::new(path, range)?;
        let step = if shown.is_turn(path) { MARKS } else { shown.round_step() };
        let values = shown.round_values(path, step);
        let mut paths: Vec<PointPath> = Vec::new();
        for name in points {
            if !paths.iter().any(|other| other.name == *name) {
                paths.push(PointPath::new(path, &shown, name, &values)?);
            }
        }
        Ok(PointPaths { path, range: shown.range, paths, events: shown.events })
    }

    /// Adds the rest of the curves beyond limits of the drive; only the whole range of a branch goes on there.
    ///
    /// # Errors
    /// A branch on the other side of a limit cannot be followed.
    pub fn beyond_limits(mut self) -> Result<Self, CycleError> {
        let others = other_branches(self.path);
        for one in &mut self.paths {
            one.go_beyond(&others)?;
        }
        Ok(self)
    }
}

impl PointPath {
    /// The path of the point of that name, with ticks at these values of the drive.
    pub(super) fn new(path: &Path, shown: &Shown, name: &str, ticks: &[f64]) -> Result<Self, CycleError> {
        let (point, link) = moving_point(path, name)?;
        let mut place = Place::new(path, name, point)?;
        let called = |at: f64| if shown.is_turn(path) { at.rem_euclid(360.0) } else { at };
        let tick = |place: &mut Place, &at: &f64| {
            Some(Tick { value: called(at), along: place.along(at), place: place.at(at)? })
        };
        Ok(PointPath {
            point,
            name: name.to_owned(),
            link,
            pieces: place.pieces(&grid(path, shown.range)),
            beyond: Vec::new(),
            ticks: ticks.iter().filter_map(|at| tick(&mut place, at)).collect(),
            own: shown.own(path).and_then(|at| place.at(at)),
        })
    }
}

impl PointPath {
    /// Adds the parts of the curve on other branches.
    pub(super) fn go_beyond(&mut self, others: &[Path]) -> Result<(), CycleError> {
        for path in others {
            let shown = Shown::new(path, [path.low(), path.high()])?;
            let mut place = Place::new(path, &self.name, self.point)?;
            self.beyond.append(&mut place.pieces(&grid(path, shown.range)));
        }
        Ok(())
    }
}

/// The point of that name on a link that moves, and the first such link.
fn moving_point(path: &Path, name: &str) -> Result<(PointId, BodyId), CycleError> {
    let mechanism = &path.mechanism;
    let point = mechanism.point(name).filter(|point| !mechanism.body(GROUND).points.contains(point));
    let link = point.and_then(|point| mechanism.links().find(|(_, body)| body.points.contains(&point)));
    point.zip(link.map(|(id, _)| id)).ok_or_else(|| CycleError::NoPath(crate::text::shown(name)))
}

/// The place of a point as a function of the drive's value.
struct Place<'a> {
    tip: Tip<'a>,
    path: &'a Path<'a>,
    /// The scene's own place, if the point must stay within reach of it.
    centre: Option<Point>,
}

impl<'a> Place<'a> {
    fn new(path: &'a Path<'a>, name: &str, point: PointId) -> Result<Self, CycleError> {
        let tip = Tip::new(path, [&format!("x({name})"), &format!("y({name})")])?;
        let runs_off = |above: bool| path.end(above).is_some_and(|end| matches!(end.what, Happening::RunsOff { .. }));
        let mut walker = path.walker();
        let own = walker.position(path.start()).map(|position| position.place(point));
        Ok(Place { tip, path, centre: own.filter(|_| runs_off(false) || runs_off(true)) })
    }

    fn at(&mut self, value: f64) -> Option<Point> {
        let place = Point::from(self.tip.at(value)?);
        let reach = REACH * self.path.size();
        self.centre.is_none_or(|centre| (place - centre).norm() <= reach).then_some(place)
    }

    /// The unit vector along the path; where the point stops, that in which it sets off.
    fn along(&mut self, value: f64) -> Option<Vector> {
        let aside = ASIDE * self.path.unit();
        let here = self.at(value)?;
        let [before, after] = [-aside, aside].map(|by| self.at(value + by));
        let along = match (before, after) {
            (Some(before), Some(after)) => {
                let (first, second) = (after - before, (after - here) + (before - here));
                if first.norm() >= second.norm() { first } else { second }
            }
            (Some(before), None) => here - before,
            (None, Some(after)) => after - here,
            (None, None) => return None,
        };
        let rests = along.norm() <= 1e-12 * self.path.size();
        (!rests).then(|| along.normalize())
    }

    /// The path in pieces without a gap, sampled between the values of `grid` as densely as it is curved.
    fn pieces(&mut self, grid: &[f64]) -> Vec<Vec<(f64, Point)>> {
        let (Some(&first), Some(&last)) = (grid.first(), grid.last()) else {
            return Vec::new();
        };
        let mut pieces = vec![Vec::new()];
        let mut before = (first, self.at(first));
        push(&mut pieces, before);
        for &value in &grid[1..] {
            let next = (value, self.at(value));
            self.between(before, next, CLOSEST * (last - first), &mut pieces);
            before = next;
        }
        pieces.retain(|piece| piece.len() > 1);
        pieces
    }

    /// Adds the samples after `a` up to `b`, and `b` itself.
    fn between(&mut self, a: Sample, b: Sample, closest: f64, pieces: &mut Vec<Vec<(f64, Point)>>) {
        let size = self.path.size();
        let chord = a.1.zip(b.1);
        let middle = 0.5 * (a.0 + b.0);
        let place = self.at(middle);
        if b.0 - a.0 <= closest || chord.is_none() && place.is_none() {
            if !chord.is_some_and(|(a, b)| (a - b).norm() <= GAP * size) {
                pieces.push(Vec::new());
            }
            return push(pieces, b);
        }
        let straight =
            |((a, b), place): ((Point, Point), Point)| (place - nalgebra::center(&a, &b)).norm() <= TOLERANCE * size;
        if chord.zip(place).is_some_and(straight) {
            push(pieces, (middle, place));
            push(pieces, b);
        } else {
            self.between(a, (middle, place), closest, pieces);
            self.between((middle, place), b, closest, pieces);
        }
    }
}

/// A value of the drive, and the point's place there, if it has one.
type Sample = (f64, Option<Point>);

fn push(pieces: &mut [Vec<(f64, Point)>], (value, place): Sample) {
    if let (Some(place), Some(piece)) = (place, pieces.last_mut()) {
        piece.push((value, place));
    }
}
