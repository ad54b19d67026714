use super::circuit::other_branches;
use super::reading::Tip;
use super::samples::{CurveReader, Sampler};
use super::{CycleError, Path, Sampled};
use crate::geometry::{Point, Vector};
use crate::mechanism::{BodyId, PointId};
use crate::quantity::State;

/// Largest distance of a path from the middle of the straight line between two samples, in sizes of the mechanism: on a
/// sheet that shows the whole mechanism a hundredth of a millimetre at most.
const TOLERANCE: f64 = 1e-5;
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

/// The paths of points over a range of a motion, with ticks at round values of the drive: in a whole turn every 30°.
pub type PointPaths<'a> = Sampled<'a, PointPath>;

impl<'a> PointPaths<'a> {
    /// The paths of points by their names, over the part of `range` that `path` has reached.
    ///
    /// # Errors
    /// A name is no point of a moving link, or nothing of the range has been reached.
    pub fn new(path: &'a Path<'a>, range: [f64; 2], points: &[String]) -> Result<Self, CycleError> {
        let mut paths = PointPaths::reached(path, range)?;
        let ticks = paths.round_values(paths.tick_step());
        for name in points {
            if !paths.curves.iter().any(|other| other.name == *name) {
                paths.add(name, &ticks)?;
            }
        }
        Ok(paths)
    }

    /// Adds the path of the point of that name, with ticks at these values of the drive.
    pub(super) fn add(&mut self, name: &str, ticks: &[f64]) -> Result<(), CycleError> {
        let path = self.path;
        let point = path.mechanism.point(name);
        let moving = point.and_then(|point| Some((point, path.carrier(point)?)));
        let (point, link) = moving.ok_or_else(|| CycleError::NoPath(crate::text::shown(name)))?;
        let mut place = Place::new(path, name, point)?;
        let pieces = place.pieces(&self.grid());
        let mut tick =
            |at: f64| Some(Tick { value: self.called(at), along: place.along(at), place: place.at(at, None)? });
        let ticks = ticks.iter().filter_map(|at| tick(*at)).collect();
        let own = self.own().and_then(|at| place.at(at, None));
        self.curves.push(PointPath { point, name: name.to_owned(), link, pieces, beyond: Vec::new(), ticks, own });
        Ok(())
    }

    /// Adds the rest of the curves beyond limits of the drive; only the whole range of a branch goes on there.
    ///
    /// # Errors
    /// A branch on the other side of a limit cannot be followed.
    pub fn beyond_limits(mut self) -> Result<Self, CycleError> {
        let others = other_branches(self.path);
        for curve in &mut self.curves {
            for branch in &others {
                let shown = PointPaths::reached(branch, [branch.low(), branch.high()])?;
                let mut place = Place::new(branch, &curve.name, curve.point)?;
                curve.beyond.append(&mut place.pieces(&shown.grid()));
            }
        }
        Ok(self)
    }
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
        let own = path.walker().position(path.start()).map(|position| position.place(point));
        Ok(Place { tip, path, centre: own.filter(|_| path.runs_off()) })
    }

    /// The unit vector along the path; where the point stops, that in which it sets off.
    fn along(&mut self, value: f64) -> Option<Vector> {
        let aside = ASIDE * self.path.unit();
        let here = self.at(value, None)?;
        let [before, after] = [-aside, aside].map(|by| self.at(value + by, None));
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
        let mut sampler = Sampler::new(self, [first, last], usize::MAX);
        for &value in grid {
            let place = sampler.curve.at(value, None);
            sampler.go_on((value, place));
        }
        sampler.pieces()
    }
}

impl CurveReader for Place<'_> {
    type Value = Point;

    fn at(&mut self, value: f64, _: Option<Point>) -> Option<Point> {
        let place = Point::from(self.tip.at(value)?);
        let reach = REACH * self.path.size();
        self.centre.is_none_or(|centre| (place - centre).norm() <= reach).then_some(place)
    }

    fn is_joined(&self, a: Point, b: Point) -> bool {
        (a - b).norm() <= GAP * self.path.size()
    }

    fn is_straight(&self, a: Point, middle: Point, b: Point) -> bool {
        (middle - nalgebra::center(&a, &b)).norm() <= TOLERANCE * self.path.size()
    }
}
