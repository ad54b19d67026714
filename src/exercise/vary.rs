//! The numbers of a scene file, and the scene with other round ones in their place.

use super::teeth::Wheels;
use crate::editing::measure::json as json_number;
use crate::geometry::{Point, Random, span};
use crate::scene::{Along, GivenBy, Scene};
use serde_json::{Value, json};

/// The meaning of a number in a scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// A coordinate of a place, or a length.
    Length,
    /// A component or the size of a given velocity or acceleration.
    Motion,
    /// The angle of a given velocity or acceleration, in degrees.
    Direction,
    /// A given angular velocity or acceleration of a link.
    Turning,
    /// The angle of a drive, in degrees.
    DriveAngle,
    /// The position of a driven slider along its guide.
    DrivePosition,
    /// Angular velocity, speed or acceleration of a drive.
    DriveRate,
    /// A mass, a moment of inertia, a component or the size of a given force, a couple.
    Load,
}

/// Replaces the numbers of places, lengths, given motions, drives and loads in a scene file, in this order, each by what
/// `change` returns.
///
/// Rough places (`near`), directions of guides and the figure stay as they are.
pub fn each_number(scene: &mut Value, change: &mut dyn FnMut(Number, f64) -> f64) {
    for (key, number) in [("ground", Number::Length), ("points", Number::Length), ("known", Number::Motion)] {
        within(scene.get_mut(key), number, change);
    }
    let links = scene.get_mut("links").and_then(Value::as_object_mut);
    for link in links.into_iter().flat_map(|links| links.values_mut()) {
        for (key, number) in [("lengths", Number::Length), ("shape", Number::Length), ("motion", Number::Motion)] {
            within(link.get_mut(key), number, change);
        }
        for (key, number) in [("center", Number::Length), ("mass", Number::Load), ("inertia", Number::Load)] {
            within(link.get_mut(key), number, change);
        }
        drive(link.get_mut("drive"), change);
        if let Some(angle) = link.get_mut("angle") {
            within(Some(angle), Number::DriveAngle, change);
        }
    }
    let sliders = scene.get_mut("sliders").and_then(Value::as_array_mut);
    for slider in sliders.into_iter().flatten() {
        drive(slider.get_mut("drive"), change);
    }
    let contacts = scene.get_mut("contacts").and_then(Value::as_array_mut);
    for contact in contacts.into_iter().flatten() {
        within(contact.get_mut("radii"), Number::Length, change);
    }
    let forces = scene.get_mut("forces").and_then(Value::as_array_mut);
    for load in forces.into_iter().flatten() {
        for (key, number) in [("at", Number::Length), ("force", Number::Load), ("couple", Number::Load)] {
            within(load.get_mut(key), number, change);
        }
    }
}

fn drive(drive: Option<&mut Value>, change: &mut dyn FnMut(Number, f64) -> f64) {
    let entries = drive.and_then(Value::as_object_mut);
    for (key, value) in entries.into_iter().flatten() {
        let number = match key.as_str() {
            "angle" => Number::DriveAngle,
            "position" => Number::DrivePosition,
            _ => Number::DriveRate,
        };
        within(Some(value), number, change);
    }
}

/// Changes all numbers of a part of the file.
fn within(part: Option<&mut Value>, number: Number, change: &mut dyn FnMut(Number, f64) -> f64) {
    match part {
        Some(value @ Value::Number(_)) => {
            let x = value.as_f64().unwrap_or(0.0);
            *value = json_number(change(number, x));
        }
        Some(Value::Array(elements)) => {
            for element in elements {
                within(Some(element), number, change);
            }
        }
        Some(Value::Object(entries)) => {
            for (key, value) in entries {
                let number = match (key.as_str(), number) {
                    ("angle", Number::Motion | Number::Load) => Number::Direction,
                    ("omega" | "alpha", Number::Motion) => Number::Turning,
                    ("at", Number::Motion) => Number::Length,
                    (_, number) => number,
                };
                within(Some(value), number, change);
            }
        }
        _ => {}
    }
}

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

/// The scene with other numbers: lengths, places, given motions and loads up to a quarter larger or smaller, drives turned by
/// up to 60° and with half to twice their rates. Zeros stay, but for drives' angles; senses stay; blocks stay on
/// their guides.
pub(super) fn varied(scene: &Value, on_guides: &[OnGuide], random: &mut Random) -> Value {
    let wheels = Wheels::of(scene);
    let mut scene = scene.clone();
    let step = length_step(&scene);
    each_number(&mut scene, &mut |number, x| {
        let part = x * (1.0 + PART * random.within());
        match number {
            _ if x == 0.0 && number != Number::DriveAngle => 0.0,
            Number::Length | Number::DrivePosition => step.multiple(part, 1.0),
            // To two digits.
            Number::Motion | Number::Load => Step { count: 1, exponent: decimal(part).1 - 1 }.multiple(part, 1.0),
            Number::Turning => rate(part),
            Number::DriveRate => rate(x * libm::exp2(random.within())),
            Number::Direction => angle(x + DIRECTION * random.within()),
            Number::DriveAngle => angle(x + DRIVE * random.within()),
        }
    });
    on_guides.iter().for_each(|block| block.put(&mut scene));
    wheels.vary(&mut scene, random);
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
        scene["points"][&self.at] = json!([foot.x, foot.y].map(json_number));
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
    /// The nearest multiple, of at least so many steps: 1 for what must not become 0.
    pub fn multiple(self, x: f64, least: f64) -> f64 {
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
