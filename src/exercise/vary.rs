//! Replaces the numbers of a scene by other round ones.

use super::numbers::{Number, each_number, written};
use crate::geometry::{Point, Random, span};
use crate::scene::{Along, GivenBy, Scene};
use serde_json::{Value, json};

/// Largest relative change of lengths and given motions, up or down.
const PART: f64 = 0.25;
/// Largest change of drives' angles, up or down, in degrees.
const DRIVE: f64 = 60.0;
/// Largest change of directions of given vectors, up or down, in degrees.
const DIRECTION: f64 = 30.0;
/// Step of angles, in degrees.
const ANGLE: f64 = 5.0;
/// Approximate number of steps in the largest length; a step is 1 or 5 times a power of ten.
const STEPS: f64 = 25.0;
/// Round rates, to be multiplied by a power of ten.
const RATES: [f64; 11] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];

/// The scene with other numbers: lengths, places and given motions up to a quarter larger or smaller, drives turned by
/// up to 60° and with half to twice their rates. Zeros stay, but for drives' angles; senses stay; blocks stay on
/// their guides.
pub(super) fn varied(scene: &Value, on_guides: &[OnGuide], random: &mut Random) -> Value {
    let mut scene = scene.clone();
    let step = length_step(&scene);
    each_number(&mut scene, &mut |number, x| {
        let part = x * (1.0 + PART * random.within());
        match number {
            _ if x == 0.0 && number != Number::DriveAngle => 0.0,
            Number::Length | Number::DrivePosition => step.round(part),
            Number::Motion => Step::of_two_digits(part).round(part),
            Number::Turning => rate(part),
            Number::DriveRate => rate(x * libm::exp2(random.within())),
            Number::Direction => angle(x + DIRECTION * random.within()),
            Number::DriveAngle => angle(x + DRIVE * random.within()),
        }
    });
    on_guides.iter().for_each(|block| block.put(&mut scene));
    scene
}

/// A block of a drawn scene that stands on the line between two points of its guide.
#[derive(Clone, Debug)]
pub(super) struct OnGuide {
    at: String,
    line: [String; 2],
}

/// Largest distance of a block from its guide's line that counts as none, in parts of the scene's size: files have few
/// digits.
const ON_LINE: f64 = 1e-6;

impl OnGuide {
    /// The blocks of a drawn scene that stand on their guides' lines, in order; none for a scene from lengths, whose
    /// assembly puts them there.
    pub fn all(scene: &Scene) -> Vec<OnGuide> {
        let blocks = scene.sliders.iter().filter_map(|slider| {
            let Along::Points(a, b) = &slider.along else {
                return None;
            };
            let at = slider.at.as_ref().or(slider.pin.as_ref())?.clone();
            let place = |name: &String| scene.coordinates.get(name).copied().map(Point::from);
            let [block, from, to] = [place(&at)?, place(a)?, place(b)?];
            let along = (to - from).try_normalize(0.0)?;
            let off = along.perp(&(block - from)).abs();
            let size = span(scene.coordinates.values().copied().map(Point::from));
            let line = [a.clone(), b.clone()];
            let is_on = off <= ON_LINE * size && !line.contains(&at);
            is_on.then_some(OnGuide { at, line })
        });
        match scene.given_by {
            GivenBy::Drawing => blocks.collect(),
            GivenBy::Lengths => Vec::new(),
        }
    }

    /// Puts the block back on its line.
    pub fn put(&self, scene: &mut Value) {
        let place = |name: &String| -> Option<Point> {
            let place = &scene["points"][name];
            Some(Point::new(place[0].as_f64()?, place[1].as_f64()?))
        };
        let [from, to] = self.line.each_ref().map(place);
        let (Some(block), Some(from), Some(to)) = (place(&self.at), from, to) else {
            return;
        };
        let along = to - from;
        let foot = from + along * (along.dot(&(block - from)) / along.norm_squared());
        scene["points"][&self.at] = json!([foot.x, foot.y].map(written));
    }
}

/// The step of a scene's lengths: they become multiples of it.
pub(super) fn length_step(scene: &Value) -> Step {
    let mut largest = 0.0_f64;
    each_number(&mut scene.clone(), &mut |number, x| {
        if number == Number::Length {
            largest = largest.max(x.abs());
        }
        x
    });
    let (digit, exponent) = decimal(largest / STEPS);
    Step { count: if digit >= 5.0 { 5 } else { 1 }, exponent }
}

/// A round distance: 1 or 5 times a power of ten.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    count: i32,
    exponent: i32,
}

impl Step {
    /// The step of numbers with two digits.
    fn of_two_digits(x: f64) -> Step {
        Step { count: 1, exponent: decimal(x).1 - 1 }
    }

    /// The nearest multiple.
    pub fn nearest(self, x: f64) -> f64 {
        self.multiple(x, 0.0)
    }

    /// The nearest multiple other than 0.
    pub fn round(self, x: f64) -> f64 {
        self.multiple(x, 1.0)
    }

    fn multiple(self, x: f64, least: f64) -> f64 {
        let step = f64::from(self.count) * libm::exp10(f64::from(self.exponent));
        let times = libm::round(x.abs() / step).max(least) * f64::from(self.count);
        libm::copysign(with_exponent(times, self.exponent), x)
    }
}

/// The nearest of the round rates.
fn rate(x: f64) -> f64 {
    let (digit, exponent) = decimal(x);
    let nearest = RATES.into_iter().min_by(|a, b| {
        let off = |rate: &f64| (rate - digit).abs();
        off(a).total_cmp(&off(b))
    });
    libm::copysign(with_exponent(nearest.unwrap_or(1.0), exponent), x)
}

fn angle(x: f64) -> f64 {
    ANGLE * libm::round(x / ANGLE)
}

/// The magnitude of x as a number in [1, 10) and an exponent of ten; 1 and 0 for zero.
fn decimal(x: f64) -> (f64, i32) {
    if x == 0.0 {
        return (1.0, 0);
    }
    let exponent = libm::floor(libm::log10(x.abs())) as i32;
    (x.abs() / libm::exp10(f64::from(exponent)), exponent)
}

/// A number times a power of ten, rounded as the same decimal is when a file is read: 15 times 10⁻² is 0.15 to the last
/// bit.
fn with_exponent(number: f64, exponent: i32) -> f64 {
    let written = format!("{number}e{exponent}");
    written.parse().expect("digits and an exponent are a number")
}
