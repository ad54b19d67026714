//! How far the extremes of curves can be from what is told of them.

use super::reading::{Reading, SEARCHED};
use super::{Curve, Curves, Extreme, Path, Walker};
use crate::accuracy::{Room, TrueNumber, bounds_within};
use crate::construction::{Extent, construct};
use crate::geometry::UNIT_ROUNDOFF;
use crate::kernel::InputKind;
use crate::motion::motion;
use crate::quantity::QuantityRequest;
use crate::scene::Scene;
use crate::sheet::Order;

/// Steps of the drive, in parts of a turn, with which the place of an extreme is found again from three values.
const STEPS: [f64; 2] = [3e-7, 3e-10];

/// Distances from an extreme, in parts of a turn, at which the quantity is held against it: the first that tells is taken.
const WIDTHS: [f64; 4] = [1e-14, 3e-13, 3e-11, 3e-9];

/// Positions at which a constant curve is held against its value.
const TRIED: usize = 5;

/// A greatest or least value, and how far the true one can be from it.
///
/// Proved is that the quantity has an extreme within these bounds: twice the digits tell that it is less, or greater, at both ends of
/// a range of the drive about it (the end of what is shown needs none), and enclose all that it can be in between. That it is nowhere greater, or less, is found from samples,
/// which follow the motion as closely as the path does, and not proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertainExtreme {
    /// The drive's value there, found again with twice the digits.
    pub at: f64,
    /// How far from it the extreme can be.
    pub within: f64,
    /// The quantity's value.
    pub value: f64,
    /// How far from it the extreme value can be.
    pub error: f64,
    /// Whether that is proved. Else, as at a limit position or next to a change point, `error` is what two ways to the value
    /// differ by, and of a constant the largest error that was found at some positions.
    pub is_proved: bool,
}

impl CertainExtreme {
    /// How many of so many significant digits of the value are certain, at least one.
    pub(crate) fn digits(&self, most: usize) -> usize {
        let certain = libm::floor(libm::log10(self.value.abs() / (2.0 * self.error))) + 1.0;
        // Zero and what is exact are written in full.
        if self.value == 0.0 || self.error == 0.0 { most } else { certain.clamp(1.0, most as f64) as usize }
    }
}

impl Curves<'_> {
    /// The first least and the first greatest value of one of these curves, with their bounds; none on a side where it grows
    /// without bound, and the value of a constant curve on both. `scene` is that of the path's mechanism.
    #[must_use]
    pub fn certain_extremes(&self, scene: &Scene, curve: &Curve) -> [Option<CertainExtreme>; 2] {
        let mut truth = Truth { path: self.path, scene, asked: &curve.asked[0], walker: self.path.walker() };
        if let Some(value) = curve.constant {
            return [Some(truth.constant(self.range, value)); 2];
        }
        [false, true].map(|greatest| {
            let extreme = curve.extremes.iter().find(|e| e.greatest == greatest)?;
            Some(truth.proved(self.range, extreme).unwrap_or_else(|| truth.estimated(extreme)))
        })
    }
}

/// A quantity along a path, with twice the digits.
struct Truth<'a> {
    path: &'a Path<'a>,
    scene: &'a Scene,
    asked: &'a QuantityRequest,
    walker: Walker<'a>,
}

impl Truth<'_> {
    /// All that the quantity can be while the drive is at most `half` from a value; `None` where nothing bounds it.
    fn at(&mut self, value: f64, half: f64) -> Option<TrueNumber> {
        let path = self.path;
        let mechanism = path.mechanism_at(value);
        let pose = self.walker.position(value)?.pose();
        let motion = motion(&mechanism, &pose, Order::Acceleration).ok()?;
        let built = self.asked.needs_construction().then(|| construct(&mechanism, &pose, &motion, Extent::Points));
        let bounds = bounds_within(self.scene, &mechanism, &pose, &motion, path.room(value, half));
        built.iter().fold(bounds, |bounds, built| bounds.with_plans(built)).true_number(self.asked)
    }

    /// An extreme with its bounds, if it is one for certain.
    fn proved(&mut self, range: [f64; 2], extreme: &Extreme) -> Option<CertainExtreme> {
        let sign = if extreme.greatest { 1.0 } else { -1.0 };
        let at = if range.contains(&extreme.at) { extreme.at } else { self.found_again(range, extreme.at, sign) };
        let middle = self.at(at, 0.0)?;
        for width in WIDTHS.map(|part| part * self.path.unit()) {
            let ends = [(at - width).max(range[0]), (at + width).min(range[1])];
            let is_further = |end: f64| {
                let more = middle.minus(self.at(end, 0.0)?);
                Some(sign * more.high > 0.0 && more.smallest() > 0.0)
            };
            // Beyond the end of the range nothing is shown.
            let shown = ends.into_iter().filter(|end| !range.contains(end));
            if !shown.map(is_further).all(|further| further == Some(true)) {
                continue;
            }
            let within = (at - ends[0]).max(ends[1] - at) * (1.0 + UNIT_ROUNDOFF) + 2.0 * UNIT_ROUNDOFF * at.abs();
            let error = self.at(at, within)?.error_from(extreme.value);
            let found = CertainExtreme { at, within, value: extreme.value, error, is_proved: true };
            return error.is_finite().then_some(found);
        }
        None
    }

    /// The best place next to one of an extreme: where the parabola through three values has its vertex, or the corner of a size that
    /// touches zero.
    fn found_again(&mut self, range: [f64; 2], from: f64, sign: f64) -> f64 {
        let mut at = from;
        for step in STEPS.map(|part| part * self.path.unit()) {
            let [Some(before), Some(here), Some(after)] = [at - step, at, at + step].map(|x| self.at(x, 0.0)) else {
                break;
            };
            let [down, up] = [before, after].map(|value| value.minus(here).high);
            let mut places = vec![at + step * (down - up) / (2.0 * (down + up))];
            if let (TrueNumber::Number(before), TrueNumber::Number(after)) = (before, after) {
                places.push(at + step * (before.high - after.high) / (before.high + after.high));
            }
            let mut best = here;
            for place in places.into_iter().filter(|place| (place - from).abs() <= SEARCHED * self.path.unit()) {
                let place = place.clamp(range[0], range[1]);
                if let Some(value) = self.at(place, 0.0).filter(|value| sign * value.minus(best).high > 0.0) {
                    (at, best) = (place, value);
                }
            }
        }
        at
    }

    /// An extreme with what two ways to its value differ by.
    fn estimated(&mut self, extreme: &Extreme) -> CertainExtreme {
        let Extreme { at, value, .. } = *extreme;
        let unit = self.path.unit();
        let enclosed = self.at(at, WIDTHS[WIDTHS.len() - 1] * unit).map(|truth| truth.error_from(value));
        let off = || Reading::new(self.path, self.asked.clone()).off(at, value);
        let error = enclosed.filter(|error| error.is_finite()).unwrap_or_else(off);
        CertainExtreme { at, within: SEARCHED * unit, value, error, is_proved: false }
    }

    /// The value of a constant quantity, with its largest error at some positions.
    fn constant(&mut self, [low, high]: [f64; 2], value: f64) -> CertainExtreme {
        let tried = (0..TRIED).map(|k| low + (high - low) * (k as f64 + 0.5) / TRIED as f64);
        let errors = tried.filter_map(|at| Some(self.at(at, 0.0)?.error_from(value)));
        let error = errors.reduce(f64::max).unwrap_or(f64::INFINITY);
        CertainExtreme { at: low, within: 0.0, value, error, is_proved: false }
    }
}

impl Path<'_> {
    /// How far the drives can be from where [`Self::mechanism_at`] has them while the moved one is at most `half` from a
    /// value. The value itself is given; those of others that run along are rounded.
    fn room(&self, value: f64, half: f64) -> Room {
        let mut room = Room::default();
        for (index, input) in self.kernel.inputs.iter().enumerate() {
            let [start, ratio] = self.inputs[index];
            let moved = index == self.drive.input;
            let rounded = |x: f64| 4.0 * UNIT_ROUNDOFF * x.abs();
            let off = if moved || ratio == 0.0 {
                0.0
            } else {
                rounded(ratio) * (value.abs() + self.origin.abs())
                    + rounded(start)
                    + rounded(self.value_of(index, value))
            };
            let own = half * ratio.abs() * (1.0 + 4.0 * UNIT_ROUNDOFF) + off;
            match input.kind {
                InputKind::Turning { .. } => room.turned = room.turned.max(own),
                InputKind::Sliding { .. } => room.pushed = room.pushed.max(own),
            }
        }
        room
    }
}
