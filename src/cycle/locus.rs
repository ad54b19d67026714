//! Loci: the paths of points, and of the tips of vectors from one pole; and the other branches of the motion, on which a
//! point's path goes on.

use super::reading::{CurveReader, Sampler, Tip};
use super::sampled::MARKS;
use super::segment::Node;
use super::{Curve, Curves, CycleError, Path, Position, Sampled};
use crate::geometry::{Point, Vector};
use crate::kernel::Unknown;
use crate::mechanism::{BodyId, PointId};
use crate::quantity::{QuantityRequest, State};

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
        let rests = along.norm() <= 1e-12 * self.path.size;
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
        let reach = REACH * self.path.size;
        self.centre.is_none_or(|centre| (place - centre).norm() <= reach).then_some(place)
    }

    fn is_joined(&self, a: Point, b: Point) -> bool {
        (a - b).norm() <= GAP * self.path.size
    }

    fn is_straight(&self, a: Point, middle: Point, b: Point) -> bool {
        (middle - nalgebra::center(&a, &b)).norm() <= TOLERANCE * self.path.size
    }
}

/// Hodographs: the curves of the tips of vectors over a range of a path, all vectors laid off from one pole.
pub type Hodographs<'a> = Sampled<'a, Hodograph>;

/// The curve of one vector's tip.
#[derive(Clone, Debug)]
pub struct Hodograph {
    /// The vector.
    pub asked: QuantityRequest,
    /// Values of the drive and tips, measured from the pole, in pieces without a gap, so dense that straight lines
    /// between them look like the curve. The curve of a whole turn is closed.
    pub pieces: Vec<Vec<(f64, Vector)>>,
    /// Lowest and highest coordinates to be shown, the pole included: the whole curve, or, where it grows without
    /// bound, as far as the rest of it stays readable.
    pub window: [Vector; 2],
    /// Tips at round values of the drive: for an angle every 30°, counted from 0° to 360° where the range is a whole
    /// turn.
    pub marks: Vec<(f64, Vector)>,
    /// The tip at the scene's own position, if that is in the range.
    pub own: Option<Vector>,
}

impl<'a> Hodographs<'a> {
    /// The hodographs of vectors by their names, as `v(D)` or `a(D/G)`, over the part of `range` that `path` has
    /// reached.
    ///
    /// # Errors
    /// A name is no vector of this mechanism, or the vector has no value in the range; or nothing of the range has been
    /// reached.
    pub fn new(path: &'a Path<'a>, range: [f64; 2], names: &[String]) -> Result<Self, CycleError> {
        let mut all = Sampled { path, range, curves: Vec::new(), events: Vec::new() };
        for (index, name) in names.iter().enumerate() {
            if names[..index].contains(name) {
                continue;
            }
            let asked = QuantityRequest::new(name, &path.mechanism)?;
            if !asked.is_vector() {
                return Err(CycleError::NoVector(name.clone()));
            }
            let parts = [".x", ".y"].map(|part| format!("{name}{part}"));
            let components = Curves::new(path, range, Some(&parts))?;
            let curve = |part: &String| {
                let has = |curve: &&Curve| curve.asked.iter().any(|asked| asked.name() == part);
                let found = components.curves.iter().find(has);
                found.expect("both parts have a curve")
            };
            let tip = Tip::new(path, parts.each_ref().map(String::as_str))?;
            all.curves.push(hodograph(asked, &components, parts.each_ref().map(curve), tip));
            (all.range, all.events) = (components.range, components.events);
        }
        Ok(all)
    }
}

/// The hodograph of the vector with the components `x` and `y`, two of `curves`.
fn hodograph(asked: QuantityRequest, curves: &Curves, [x, y]: [&Curve; 2], mut tip: Tip) -> Hodograph {
    let mut tip = |at: f64| tip.at(at);
    // Tips at the samples of both components, where the pieces of both overlap.
    let mut pieces = Vec::new();
    for a in &x.pieces {
        for b in &y.pieces {
            let ends = |piece: &[[f64; 2]]| [piece[0][0], piece[piece.len() - 1][0]];
            let [[a0, a1], [b0, b1]] = [ends(a), ends(b)];
            let common = a0.max(b0)..=a1.min(b1);
            let samples = a.iter().chain(b).map(|sample| sample[0]);
            let mut values: Vec<f64> = samples.filter(|at| common.contains(at)).collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            let piece: Vec<(f64, Vector)> = values.into_iter().filter_map(|at| Some((at, tip(at)?))).collect();
            if piece.len() > 1 {
                pieces.push(piece);
            }
        }
    }
    let step = if curves.path.drive.is_angle { MARKS } else { curves.round_step() };
    let marks = curves.round_values(step).into_iter();
    Hodograph {
        asked,
        pieces,
        window: [
            Vector::new(x.window[0].min(0.0), y.window[0].min(0.0)),
            Vector::new(x.window[1].max(0.0), y.window[1].max(0.0)),
        ],
        marks: marks.filter_map(|at| Some((curves.called(at), tip(at)?))).collect(),
        own: curves.own().and_then(tip),
    }
}

/// Most branches that are followed one after another.
const MOST_BRANCHES: usize = 8;
/// Distance from a limit at which the other branch is sought, in turns: unknowns differ there by the root of it.
const BACK: f64 = 1e-4;
/// Distance of points that counts as none, in sizes of the mechanism.
const CLOSED: f64 = 1e-7;

/// The other branches of the motion that hang together with this one: in a limit position the drive can go no further,
/// but the mechanism, moved by another link, goes over to the branch that ends there too, and the drive goes back.
/// Without the branch itself, in the order in which they follow from its upper end, and then from its lower one.
pub(super) fn other_branches<'a>(own: &Path<'a>) -> Vec<Path<'a>> {
    let mut all = Vec::new();
    for above in [true, false] {
        let (mut chain, closed) = chain(own, above);
        all.append(&mut chain);
        if closed {
            break;
        }
    }
    all
}

/// The branches one after another from one end of a branch, and whether they lead back to it.
fn chain<'a>(own: &Path<'a>, mut above: bool) -> (Vec<Path<'a>>, bool) {
    let mut chain: Vec<Path<'a>> = Vec::new();
    while chain.len() < MOST_BRANCHES {
        let Some((next, value)) = across(chain.last().unwrap_or(own), above) else {
            return (chain, false);
        };
        if is_same(own, &next, [value; 2]) {
            return (chain, true);
        }
        chain.push(next);
        above = !above;
    }
    (chain, false)
}

/// The branch that ends in the same limit position as `path` above or below, followed to its other end, and a value of
/// the drive near the limit.
///
/// At a distance d of the limit the unknowns are x* − c √d on one branch and x* + c √d on the other.
fn across<'a>(path: &Path<'a>, above: bool) -> Option<(Path<'a>, f64)> {
    path.limit(above)?;
    let edge = if above { path.high() } else { path.low() };
    let inwards = if above { -path.unit() } else { path.unit() };
    let value = edge + BACK * inwards;
    let mut walker = path.walker();
    let limit = walker.positions(&[edge])?.clone();
    let mut block = walker.positions(&[value])?.clone();
    for unknown in path.kernel.unknowns.iter().flatten() {
        match *unknown {
            Unknown::Spin(class) => {
                let turned = limit.turn(class, 0) * block.turn(class, 0).inverse() * limit.turn(class, 0);
                block.turns[class] = [[turned.re], [turned.im]];
            }
            Unknown::Slide(slider) => block.slides[slider][0] = 2.0 * limit.slides[slider][0] - block.slides[slider][0],
        }
    }
    if !path.kernel.assemble(&mut block, 0.0).closed {
        return None;
    }
    path.unit_rates(&mut block);
    let mut next = path.restarted(Node::new(&path.kernel, value, block));
    if is_same(path, &next, [value; 2]) {
        return None;
    }
    next.follow_to(edge - BACK * inwards);
    next.follow_to(edge + path.far().copysign(inwards));
    Some((next, value))
}

/// Whether all points are in the same places on two branches at values of the drive.
pub(super) fn is_same(a: &Path, b: &Path, values: [f64; 2]) -> bool {
    let places = |position: Position<'_>| -> Vec<_> {
        (0..a.mechanism.points.len()).map(|point| position.place(PointId(point))).collect()
    };
    let at = |path: &Path, value: f64| {
        // A branch of one position only has no segment to walk on.
        let alone = path.nodes.first().filter(|node| path.segments.is_empty() && node.value == value);
        match alone {
            Some(node) => Some(places(path.position(&node.block, 0))),
            None => path.walker().position(value).map(places),
        }
    };
    let pairs = at(a, values[0]).zip(at(b, values[1])).map(|(a, b)| a.into_iter().zip(b));
    pairs.is_some_and(|mut pairs| pairs.all(|(p, q)| (p - q).norm() <= CLOSED * a.size))
}
