use super::columns::{Column, Columns};
use super::{Path, Walker};
use crate::quantity::{Asked, Kind, Quantity};

/// How near a change point, in parts of a turn, rates are not read but taken from beside it: second rates lose three digits for
/// each that the distance loses.
const GAP: f64 = 1e-3;

/// Golden section: the part of a bracket that a step leaves.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// How near a limit, in parts of a turn, a quantity is not read but follows from its values a little before: a curve that does not grow
/// without bound there goes like a polynomial of the distance's square root.
const NEAR_LIMIT: f64 = 5e-7;

/// Distances from an end of the path, in parts of a turn, by which growth shows there.
const APPROACH: [f64; 3] = [1e-3, 3e-5, 1e-6];

/// Changes below this part of a value may be rounding.
const UNSEEN: f64 = 1e-9;

/// Steps of golden section: they leave 2e-10 of the bracket.
const STEPS: usize = 46;

/// One quantity of a path as a function of the drive's value; of a vector its size.
pub(super) struct Reading<'a> {
    columns: Columns<'a>,
    walker: Walker<'a>,
    path: &'a Path<'a>,
    turns: bool,
    /// What the quantity does at the path's ends, below and above.
    pub ends: [End; 2],
}

/// What a quantity does at an end of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End {
    /// Nothing of note.
    Plain,
    /// It comes to a value at this limit position.
    Limit(f64),
    /// It grows beyond all bounds; whether upwards.
    Grows(bool),
}

impl<'a> Reading<'a> {
    /// The reading of a quantity.
    pub fn new(path: &'a Path<'a>, asked: Asked) -> Self {
        let mut reading = Reading {
            turns: asked.kind() == Kind::Angle,
            columns: Columns::of(path, vec![Column { asked }]),
            walker: path.walker(),
            path,
            ends: [End::Plain; 2],
        };
        reading.ends = [false, true].map(|above| reading.end(above));
        reading
    }

    fn end(&mut self, above: bool) -> End {
        match (self.growth(above), self.path.limit(above)) {
            (Some(up), _) => End::Grows(up),
            (None, Some(at)) => End::Limit(at),
            (None, None) => End::Plain,
        }
    }

    /// Whether the quantity grows without bound towards an end of the path, and if so whether upwards; an angle never does.
    ///
    /// At a distance d from a limit a rate goes like A + B/√d or steeper, so it changes more and more; what is bounded changes less and less.
    fn growth(&mut self, above: bool) -> Option<bool> {
        let end = self.path.end(above).filter(|_| !self.turns)?;
        let away = if above { -1.0 } else { 1.0 } * self.path.unit();
        let [far, nearer, nearest] = APPROACH.map(|d| self.read(end.at + away * d));
        let (far, nearer, nearest) = (far?, nearer?, nearest?);
        let [early, late] = [nearer - far, nearest - nearer];
        let seen = late.abs() > UNSEEN * far.abs();
        (seen && late.abs() > 2.0 * early.abs()).then_some(late > 0.0)
    }

    /// Its value, for an angle the one closest to `near`; none where it has no value.
    pub fn at(&mut self, drive: f64, near: Option<f64>) -> Option<f64> {
        let unit = self.path.unit();
        let gap = GAP * unit;
        let limit = self.ends.into_iter().find_map(|end| match end {
            End::Limit(at) if (at - drive).abs() < NEAR_LIMIT * unit => Some(at),
            _ => None,
        });
        let found = if let Some(limit) = limit {
            self.before_limit(drive, limit)
        } else if self.path.changes.iter().any(|c| (c.at - drive).abs() < gap) {
            self.bridged(drive, 2.0 * gap)
        } else {
            self.read(drive)
        };
        found.map(|value| self.closest(value, near))
    }

    /// The value from those beside it, to the fourth power of the step; at the end of the path from one side, to the third.
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

    /// The value near a limit: of the polynomial through four values further back, in the square root of the distance.
    fn before_limit(&mut self, drive: f64, limit: f64) -> Option<f64> {
        let unit = NEAR_LIMIT * self.path.unit();
        let back = if limit > self.path.start() { -unit } else { unit };
        let root = ((limit - drive).abs() / unit).sqrt();
        let first = self.read(limit + back)?;
        let nodes = [1.0, 2.0, 3.0, 4.0];
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
        let (_, found) = self.columns.values(self.walker.position(drive)).next()?;
        let value = match found? {
            Quantity::Number(x) => x,
            Quantity::Vector(v) => v.norm(),
        };
        value.is_finite().then_some(value)
    }

    /// An angle turned by whole turns until it is closest to another; other quantities as they are.
    fn closest(&self, value: f64, near: Option<f64>) -> f64 {
        match near {
            Some(near) if self.turns => value + 360.0 * ((near - value) / 360.0).round(),
            _ => value,
        }
    }

    /// Where between two values of the drive it is greatest (`sign` 1) or least (−1), and how much, if it has one such place there.
    pub fn peak(&mut self, [low, high]: [f64; 2], sign: f64, near: f64) -> Option<[f64; 2]> {
        let mut rated = |x: f64| {
            let value = self.at(x, Some(near));
            value.map_or(f64::NEG_INFINITY, |y| sign * y)
        };
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
