//! A drawing by hand: the paper's procedure with a pencil that misses every point a little.

use super::measure::{Pins, Rates};
use super::naive::{self, Pencil, Sheet};
use super::random::Random;

/// Errors of the pencil in mm: of a fine draughtsman, of a careful student, of a quick one.
pub const PENCILS: [f64; 3] = [0.1, 0.25, 0.5];

/// What a drawing with both plans takes, in nanoseconds: ten minutes.
pub const TIME: f64 = 600e9;

/// The scheme's joints fill so many mm; the largest velocity and the largest acceleration of a joint are so long in their plans.
const SHEET: f64 = 150.0;

/// Farther from the joints than this, in mm, nobody draws a special point.
const TABLE: f64 = 1000.0;

/// A pencil on three sheets.
struct Shaky<'a> {
    /// Length, velocity and acceleration that the pencil's error is worth.
    errors: [f64; 3],
    middle: [f64; 2],
    reach: f64,
    dice: &'a mut Random,
}

impl Pencil for Shaky<'_> {
    fn mark(&mut self, sheet: Sheet, [x, y]: [f64; 2]) -> [f64; 2] {
        let error = self.errors[sheet as usize];
        let (sin, cos) = libm::sincos(self.dice.angle());
        [x + error * cos, y + error * sin]
    }

    fn reaches(&self, [x, y]: [f64; 2]) -> bool {
        // False for what is no number too.
        libm::hypot(x - self.middle[0], y - self.middle[1]) <= self.reach
    }
}

/// What is read off a drawing in which every point is `pencil` mm beside its place, in a direction by lot; `None` where a special point
/// lies off the table. `truth` only sets the scales of the plans.
pub fn rates(pins: &Pins, truth: &Rates<f64>, pencil: f64, dice: &mut Random) -> Option<Rates<f64>> {
    let side = |axis: usize| {
        let places = pins.places.iter().map(|p| p[axis]);
        let (low, high) = places.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
        [low, high]
    };
    let sides = [side(0), side(1)];
    let size = sides.iter().fold(0.0_f64, |s, [low, high]| s.max(high - low));
    let largest = |outer: &[[f64; 2]], inner: &[[f64; 2]]| {
        let all = outer.iter().chain(inner);
        all.fold(0.0_f64, |s, [x, y]| s.max(libm::hypot(*x, *y)))
    };
    let velocity = largest(&pins.velocity, &truth.velocity);
    let acceleration = largest(&pins.acceleration, &truth.acceleration);
    let mut pencil = Shaky {
        errors: [size, velocity, acceleration].map(|full| pencil * full / SHEET),
        middle: sides.map(|[low, high]| 0.5 * (low + high)),
        reach: TABLE * size / SHEET,
        dice,
    };
    naive::rates(pins, &mut pencil)
}
