//! A quantity along a path as a function of the drive's value, and its samples.

use super::{CycleError, Path, Walker};
use crate::geometry::{Vector, with_turns};
use crate::quantity::{QuantityKind, QuantityRequest};

/// Distance from a change point, in parts of a turn, below which rates are interpolated from both sides: accelerations
/// lose three digits with each power of ten of the distance.
const GAP: f64 = 1e-3;

/// Golden section: the part of a bracket that one step keeps.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Distance from a limit, in parts of a turn, below which a quantity is extrapolated from its values a little before: a
/// bounded quantity is like a polynomial in the square root of the distance.
const NEAR_LIMIT: f64 = 5e-7;

/// How far beside the extreme a search for it may end, in parts of a turn.
pub(super) const SEARCHED: f64 = 1e-6;

/// Distances from an end of the path, in parts of a turn, at which a quantity is tested for growth without bound.
const APPROACH: [f64; 3] = [1e-3, 3e-5, 1e-6];

/// Relative change of a value below which it may be due to rounding.
const ROUNDING: f64 = 1e-9;

/// Steps of golden section: they shrink the bracket to 2e-10 of its width.
const STEPS: usize = 46;

/// One quantity of a path as a function of the drive's value; the size of a vector.
pub(super) struct Reading<'a> {
    asked: QuantityRequest,
    walker: Walker<'a>,
    path: &'a Path<'a>,
    /// Whether the quantity is an angle.
    turns: bool,
    /// The quantity's behaviour at the path's ends, below and above.
    pub ends: [End; 2],
}

/// How a quantity behaves at an end of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End {
    /// The end is no limit, and the quantity stays bounded.
    Plain,
    /// It stays bounded at the limit position at this value of the drive.
    Limit(f64),
    /// It grows without bound; `true` upwards.
    Grows(bool),
}

impl<'a> Reading<'a> {
    /// The reading of a quantity.
    pub fn new(path: &'a Path<'a>, asked: QuantityRequest) -> Self {
        let mut reading = Reading {
            turns: asked.kind() == QuantityKind::Angle,
            asked,
            walker: path.walker(),
            path,
            ends: [End::Plain; 2],
        };
        reading.ends = [false, true].map(|above| match (reading.growth(above), path.limit(above)) {
            (Some(up), _) => End::Grows(up),
            (None, Some(at)) => End::Limit(at),
            (None, None) => End::Plain,
        });
        reading
    }

    /// Whether the quantity grows without bound towards an end of the path, and if so whether upwards; an angle never
    /// does.
    ///
    /// At a distance d from a limit an unbounded rate is like A + B/√d or steeper, so its changes from one distance to
    /// the next grow; those of a bounded quantity shrink.
    fn growth(&mut self, above: bool) -> Option<bool> {
        if self.turns {
            return None;
        }
        let end = self.path.end(above)?;
        let away = if above { -1.0 } else { 1.0 } * self.path.unit();
        let [far, nearer, nearest] = APPROACH.map(|d| self.read(end.at + away * d));
        let (far, nearer, nearest) = (far?, nearer?, nearest?);
        let [early, late] = [nearer - far, nearest - nearer];
        let is_significant = late.abs() > ROUNDING * far.abs();
        (is_significant && late.abs() > 2.0 * early.abs()).then_some(late > 0.0)
    }

    /// The value at this value of the drive, of an angle the one closest to `near`; `None` where it has no value.
    pub fn at(&mut self, drive: f64, near: Option<f64>) -> Option<f64> {
        let found = if let Some(limit) = self.limit_near(drive) {
            self.before_limit(drive, limit, 1.0)
        } else if self.is_next_to_change(drive) {
            self.bridged(drive, 2.0 * GAP * self.path.unit())
        } else {
            self.read(drive)
        };
        found.map(|value| self.closest(value, near))
    }

    /// The value interpolated from those at both sides, with an error of the fourth power of the step; at an end of the
    /// path extrapolated from one side, with an error of the third.
    fn bridged(&mut self, drive: f64, step: f64) -> Option<f64> {
        let mut side = |step: f64| -> Option<[f64; 3]> {
            let values = [1.0, 2.0, 3.0].map(|k| self.read(drive + k * step));
            let [first, second, third] = values;
            let [second, third] = [second?, third?].map(|y| self.closest(y, first));
            Some([first?, second, third])
        };
        match (side(-step), side(step)) {
            (Some(a), Some(b)) => {
                let [b0, b1] = [b[0], b[1]].map(|y| self.closest(y, Some(a[0])));
                Some((4.0 * (a[0] + b0) - (a[1] + b1)) / 6.0)
            }
            (a, b) => a.or(b).map(|y| 3.0 * (y[0] - y[1]) + y[2]),
        }
    }

    /// What a second way to the value differs by: next to a limit or a change point from values a little further away, elsewhere
    /// from a search that ended a little beside it.
    pub fn off(&mut self, drive: f64, value: f64) -> f64 {
        let unit = self.path.unit();
        let limit = self.limit_near(drive);
        let others = match limit {
            Some(limit) => vec![self.before_limit(drive, limit, 2.0)],
            None if self.is_next_to_change(drive) => vec![self.bridged(drive, 3.0 * GAP * unit)],
            None => [-SEARCHED, SEARCHED].map(|part| self.at(drive + part * unit, Some(value))).to_vec(),
        };
        let apart = others.into_iter().flatten().map(|other| (self.closest(other, Some(value)) - value).abs());
        apart.reduce(f64::max).unwrap_or(f64::INFINITY)
    }

    /// The limit position next to which this value of the drive is.
    fn limit_near(&self, drive: f64) -> Option<f64> {
        self.ends.into_iter().find_map(|end| match end {
            End::Limit(at) if (at - drive).abs() < NEAR_LIMIT * self.path.unit() => Some(at),
            _ => None,
        })
    }

    fn is_next_to_change(&self, drive: f64) -> bool {
        self.path.changes.iter().any(|c| (c.at - drive).abs() < GAP * self.path.unit())
    }

    /// The value near a limit: the cubic in the square root of the distance through four values further back, from so many steps on.
    fn before_limit(&mut self, drive: f64, limit: f64, first: f64) -> Option<f64> {
        let unit = NEAR_LIMIT * self.path.unit();
        let back = if limit > self.path.start() { -unit } else { unit };
        let root = ((limit - drive).abs() / unit).sqrt();
        let nodes = [0.0, 1.0, 2.0, 3.0].map(|further| first + further);
        let first = self.read(limit + first * first * back)?;
        let mut sum = 0.0;
        for node in nodes {
            let others = nodes.iter().filter(|k| **k != node);
            let weight: f64 = others.map(|k| (root - k) / (node - k)).product();
            let value = self.read(limit + node * node * back)?;
            sum += weight * self.closest(value, Some(first));
        }
        Some(sum)
    }

    fn read(&mut self, drive: f64) -> Option<f64> {
        let position = self.walker.position(drive)?;
        let built = if self.asked.needs_construction() { Some(position.construction()?) } else { None };
        let value = self.asked.value(&position, built.as_ref(), None).ok()?.as_number();
        value.is_finite().then_some(value)
    }

    /// An angle plus the whole turns that bring it closest to `near`; other quantities unchanged.
    fn closest(&self, value: f64, near: Option<f64>) -> f64 {
        match near {
            Some(near) if self.turns => with_turns(value, near),
            _ => value,
        }
    }

    /// The value of the drive between two others at which the quantity is greatest (`sign` 1) or least (−1), and that
    /// extreme; by golden section, which supposes a single extreme in between. Angles are taken closest to `near`.
    pub fn peak(&mut self, [low, high]: [f64; 2], sign: f64, near: f64) -> Option<[f64; 2]> {
        let mut rated = |x: f64| self.at(x, Some(near)).map_or(f64::NEG_INFINITY, |y| sign * y);
        let (mut low, mut high) = (low, high);
        let width = high - low;
        let mut inner = [high - GOLDEN * width, low + GOLDEN * width];
        let mut values = inner.map(&mut rated);
        for _ in 0..STEPS {
            if values[0] >= values[1] {
                high = inner[1];
                inner = [high - GOLDEN * (high - low), inner[0]];
                values = [rated(inner[0]), values[0]];
            } else {
                low = inner[0];
                inner = [inner[1], low + GOLDEN * (high - low)];
                values = [values[1], rated(inner[1])];
            }
        }
        let best = if values[0] >= values[1] { 0 } else { 1 };
        values[best].is_finite().then_some([inner[best], sign * values[best]])
    }
}

/// A point of the plane as a function of the drive's value: the tip of a vector, or a point of the mechanism.
pub(super) struct Tip<'a> {
    parts: [Reading<'a>; 2],
}

impl<'a> Tip<'a> {
    /// The point whose coordinates are the quantities of these names.
    pub fn new(path: &'a Path<'a>, [x, y]: [&str; 2]) -> Result<Self, CycleError> {
        let reading =
            |name| -> Result<_, CycleError> { Ok(Reading::new(path, QuantityRequest::new(name, &path.mechanism)?)) };
        Ok(Tip { parts: [reading(x)?, reading(y)?] })
    }

    /// The point at a value of the drive; `None` where it has no place.
    pub fn at(&mut self, value: f64) -> Option<Vector> {
        let [x, y] = &mut self.parts;
        Some(Vector::new(x.at(value, None)?, y.at(value, None)?))
    }
}

/// Largest distance of a curve from the straight line between two samples, in parts of the window's height.
const TOLERANCE: f64 = 5e-5;

/// Smallest distance of two samples, in parts of the range.
const CLOSEST: f64 = 1e-7;

/// Difference of two samples at the smallest distance that counts as a jump, in parts of the window's height.
const JUMP: f64 = 0.01;

/// Most further samples for each sample of the grid; smooth curves take fewer than ten.
const MOST: usize = 50;

/// A value of the drive, and that of a quantity (or the place of a point) there, if it has one.
pub(super) type Sample<V = f64> = (f64, Option<V>);

/// Least and greatest of some numbers; `[∞, −∞]` of none.
pub(super) fn hull(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    numbers.fold(none, |[low, high], y| [low.min(y), high.max(y)])
}

/// Samples at these values of the drive; angles run on without jumps of whole turns.
pub(super) fn samples(reading: &mut Reading, grid: &[f64]) -> Vec<Sample> {
    let mut last = None;
    let at = |x: &f64| {
        let value = reading.at(*x, last);
        last = value.or(last);
        (*x, value)
    };
    grid.iter().map(at).collect()
}

/// The curve in pieces without a gap or jump, sampled between the samples of `grid` so densely that straight lines look
/// like it.
///
/// Outside `window` the curve is sampled only as far as to show where it leaves.
pub(super) fn pieces(reading: &mut Reading, grid: &[Sample], window: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let (Some(first), Some(last)) = (grid.first(), grid.last()) else {
        return Vec::new();
    };
    let mut graph = Graph { reading, window };
    let mut sampler = Sampler::new(&mut graph, [first.0, last.0], MOST * grid.len());
    grid.iter().for_each(|sample| sampler.go_on(*sample));
    sampler.pieces().into_iter().map(|piece| piece.into_iter().map(<[f64; 2]>::from).collect()).collect()
}

/// The local extreme next to the sample of that index; `None` if a neighbour of the sample lies further out.
pub(super) fn peak(reading: &mut Reading, samples: &[Sample], index: usize, sign: f64) -> Option<[f64; 2]> {
    let (x, y) = samples[index];
    let y = y?;
    let last = samples.len() - 1;
    let (left, right) = (index.saturating_sub(1), (index + 1).min(last));
    let further = |i: usize, or_equal: bool| {
        let other = samples[i].1.map(|other| sign * (other - y));
        i != index && other.is_some_and(|d| d > 0.0 || or_equal && d == 0.0)
    };
    // Of equal neighbours the first counts.
    if further(left, true) || further(right, false) {
        return None;
    }
    let between = reading.peak([samples[left].0, samples[right].0], sign, y);
    Some(between.filter(|p| sign * (p[1] - y) > 0.0).unwrap_or([x, y]))
}

/// A curve over the drive that can be read anywhere.
pub(super) trait CurveReader {
    /// What a point of the curve is besides the drive's value.
    type Value: Copy;

    /// The value at one of the drive, of an angle the one closest to `near`; `None` where it has none.
    fn at(&mut self, drive: f64, near: Option<Self::Value>) -> Option<Self::Value>;

    /// Whether two samples at the smallest distance hang together; else the curve jumps between them.
    fn is_joined(&self, a: Self::Value, b: Self::Value) -> bool;

    /// Whether the curve looks straight between two samples, with this one in the middle.
    fn is_straight(&self, a: Self::Value, middle: Self::Value, b: Self::Value) -> bool;
}

/// A quantity, as it looks in a window.
struct Graph<'r, 'a> {
    reading: &'r mut Reading<'a>,
    window: [f64; 2],
}

impl CurveReader for Graph<'_, '_> {
    type Value = f64;

    fn at(&mut self, drive: f64, near: Option<f64>) -> Option<f64> {
        self.reading.at(drive, near)
    }

    fn is_joined(&self, a: f64, b: f64) -> bool {
        let [low, high] = self.window;
        (a - b).abs() <= JUMP * (high - low)
    }

    fn is_straight(&self, a: f64, middle: f64, b: f64) -> bool {
        let [low, high] = self.window;
        let outside = [a, b, middle].iter().all(|v| *v > high) || [a, b, middle].iter().all(|v| *v < low);
        outside || (middle - 0.5 * (a + b)).abs() <= TOLERANCE * (high - low)
    }
}

/// Samples a curve as densely as it is curved, in pieces without a gap or jump.
pub(super) struct Sampler<'c, C: CurveReader> {
    pub curve: &'c mut C,
    /// Smallest distance of two samples.
    closest: f64,
    /// Number of samples that may still be taken between those of the grid.
    left: usize,
    last: Option<Sample<C::Value>>,
    pieces: Vec<Vec<(f64, C::Value)>>,
}

impl<'c, C: CurveReader> Sampler<'c, C> {
    /// For a range of the drive, with so many samples at most besides those of the grid.
    pub fn new(curve: &'c mut C, [first, last]: [f64; 2], most: usize) -> Self {
        Sampler { curve, closest: CLOSEST * (last - first), left: most, last: None, pieces: vec![Vec::new()] }
    }

    /// Adds the next sample of the grid, and as many before it as the curve needs.
    pub fn go_on(&mut self, next: Sample<C::Value>) {
        match self.last.replace(next) {
            Some(last) => self.between(last, next),
            None => self.push(next),
        }
    }

    /// The pieces of more than one sample.
    pub fn pieces(mut self) -> Vec<Vec<(f64, C::Value)>> {
        self.pieces.retain(|piece| piece.len() > 1);
        self.pieces
    }

    fn push(&mut self, (x, y): Sample<C::Value>) {
        if let (Some(y), Some(piece)) = (y, self.pieces.last_mut()) {
            piece.push((x, y));
        }
    }

    /// Adds the samples after `a` up to `b`, and `b` itself.
    fn between(&mut self, a: Sample<C::Value>, b: Sample<C::Value>) {
        let whole = a.1.zip(b.1);
        if b.0 - a.0 <= self.closest || self.left == 0 {
            if !whole.is_some_and(|(a, b)| self.curve.is_joined(a, b)) {
                self.pieces.push(Vec::new());
            }
            return self.push(b);
        }
        self.left -= 1;
        let x = 0.5 * (a.0 + b.0);
        let middle = (x, self.curve.at(x, a.1.or(b.1)));
        if middle.1.is_none() && whole.is_none() {
            self.pieces.push(Vec::new());
            return self.push(b);
        }
        if whole.zip(middle.1).is_some_and(|((a, b), y)| self.curve.is_straight(a, y, b)) {
            self.push(middle);
            self.push(b);
        } else {
            self.between(a, middle);
            self.between(middle, b);
        }
    }
}
