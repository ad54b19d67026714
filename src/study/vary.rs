//! The numbers of a scene that may vary, and the values that they take, in order or by chance.

use super::file::Range;
use crate::geometry::Random;
use crate::quantity::QuantityKind;
use crate::scene::{Equivalent, Scene, Shape, TimeUnit, Units};
use std::f64::consts::{PI, TAU};

/// A number of a scene, by its place in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    /// A coordinate of a ground point: its place among the given coordinates, axis.
    Ground(usize, usize),
    /// A length: link, and its place in the link's list.
    Length(usize, usize),
    /// A coordinate in a link's shape: link, point, axis.
    Local(usize, usize, usize),
    /// The angle of a link's drive, its angular velocity or its angular acceleration.
    Turn(usize, QuantityKind),
    /// The turns per minute of a link's drive.
    Rpm(usize),
    /// The position of a slider's drive, its velocity or its acceleration.
    Push(usize, QuantityKind),
}

/// A number with its name, as `2.BC`, and its place in the scene, as `links.2.lengths.BC`.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub name: String,
    pub path: String,
    pub number: Number,
}

const AXES: [&str; 2] = ["x", "y"];

/// All numbers of a scene that may vary.
pub(super) fn numbers(scene: &Scene) -> Vec<Named> {
    let mut all = Vec::new();
    let mut add = |name: String, path: String, number| all.push(Named { name, path, number });
    for (index, point) in scene.coordinates.keys().enumerate() {
        for (axis, letter) in AXES.iter().enumerate() {
            add(format!("{point}.{letter}"), format!("ground.{point}.{axis}"), Number::Ground(index, axis));
        }
    }
    let is_equivalent = |link: &str| {
        let mut contacts = scene.contacts.iter();
        contacts.any(|contact| matches!(&contact.equivalent, Equivalent::Link { name, .. } if name == link))
    };
    let written = scene.links.iter().enumerate().filter(|(_, (link, _))| !is_equivalent(link));
    for (index, (link, of)) in written {
        match &of.shape {
            Shape::Bare => {}
            Shape::Lengths(lengths) => {
                for (place, key) in lengths.iter().map(|length| &length.key).enumerate() {
                    let path = format!("links.{link}.lengths.{key}");
                    add(format!("{link}.{key}"), path, Number::Length(index, place));
                }
            }
            Shape::Local(points) => {
                for (place, point) in points.keys().enumerate() {
                    for (axis, letter) in AXES.iter().enumerate() {
                        let path = format!("links.{link}.shape.{point}.{axis}");
                        add(format!("{link}.{point}.{letter}"), path, Number::Local(index, place, axis));
                    }
                }
            }
        }
        if let Some(drive) = of.drive {
            let turn = |kind| Number::Turn(index, kind);
            let angle = drive.angle_deg.map(|_| ("angle", turn(QuantityKind::Angle)));
            let speed = match drive.rpm {
                Some(_) => ("rpm", Number::Rpm(index)),
                None => ("omega", turn(QuantityKind::AngularVelocity)),
            };
            for (key, number) in angle.into_iter().chain([speed, ("alpha", turn(QuantityKind::AngularAcceleration))]) {
                add(format!("{link}.{key}"), format!("links.{link}.drive.{key}"), number);
            }
        }
    }
    for (index, slider) in scene.sliders.iter().enumerate() {
        let (Some(drive), Some(link)) = (slider.drive, &slider.link) else {
            continue;
        };
        let position = drive.position.map(|_| ("position", QuantityKind::Position));
        let rates = [("speed", QuantityKind::Velocity), ("acceleration", QuantityKind::Acceleration)];
        for (key, kind) in position.into_iter().chain(rates) {
            add(format!("{link}.{key}"), format!("sliders.{index}.drive.{key}"), Number::Push(index, kind));
        }
    }
    all
}

impl Number {
    /// Its unit.
    pub fn unit(self, units: Units) -> String {
        match self {
            Number::Ground(..) | Number::Length(..) | Number::Local(..) => QuantityKind::Length.unit(units),
            Number::Turn(_, kind) | Number::Push(_, kind) => kind.unit(units),
            Number::Rpm(_) => "1/min".to_owned(),
        }
    }

    /// It in its place in a scene; `None` in a scene that has no such number.
    pub fn of(self, scene: &mut Scene) -> Option<&mut f64> {
        match self {
            Number::Ground(point, axis) => Some(&mut scene.coordinates[point][axis]),
            Number::Length(link, place) => match &mut scene.links[link].shape {
                Shape::Lengths(lengths) => Some(&mut lengths[place].value),
                _ => None,
            },
            Number::Local(link, point, axis) => match &mut scene.links[link].shape {
                Shape::Local(points) => Some(&mut points[point][axis]),
                _ => None,
            },
            Number::Rpm(link) => scene.links[link].drive.as_mut()?.rpm.as_mut(),
            Number::Turn(link, kind) => {
                let drive = scene.links[link].drive.as_mut()?;
                match kind {
                    QuantityKind::Angle => drive.angle_deg.as_mut(),
                    QuantityKind::AngularVelocity => Some(&mut drive.omega),
                    _ => Some(&mut drive.alpha),
                }
            }
            Number::Push(slider, kind) => {
                let drive = scene.sliders[slider].drive.as_mut()?;
                match kind {
                    QuantityKind::Position => drive.position.as_mut(),
                    QuantityKind::Velocity => Some(&mut drive.speed),
                    _ => Some(&mut drive.acceleration),
                }
            }
        }
    }

    /// Puts a value in its place.
    pub fn set(self, scene: &mut Scene, value: f64) {
        if let Some(number) = self.of(scene) {
            *number = value;
        }
        let per_rpm = if scene.units.time == TimeUnit::S { PI / 30.0 } else { TAU };
        if let Number::Rpm(link) = self
            && let Some(drive) = &mut scene.links[link].drive
        {
            drive.omega = value * per_rpm;
        }
    }
}

/// A number of the scene with the values that it takes.
#[derive(Clone, Debug)]
pub(super) struct Varied {
    /// Its name as the study has it.
    pub name: String,
    pub number: Number,
    pub values: Values,
}

/// The values that a number takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Values {
    /// So many at equal distances, both ends among them.
    Grid { from: f64, to: f64, count: u64 },
    /// All between two equally likely.
    Uniform { from: f64, to: f64 },
    /// Normally distributed.
    Normal { mean: f64, sigma: f64 },
}

impl Values {
    /// The values of a range about the scene's number `own`; else what is wrong with it.
    pub fn of(range: &Range, own: f64) -> Result<Values, &'static str> {
        let middle = range.nominal.unwrap_or(own);
        let values = match *range {
            Range { from: Some(from), to: Some(to), count, nominal: None, plus_minus: None, sigma: None } => {
                match count {
                    Some(0 | 1) => return Err("a grid has at least 2 values"),
                    Some(count) => Values::Grid { from, to, count },
                    None => Values::Uniform { from, to },
                }
            }
            Range { from: None, to: None, count: None, plus_minus: Some(by), sigma: None, .. } if by > 0.0 => {
                Values::Uniform { from: middle - by, to: middle + by }
            }
            Range { from: None, to: None, count: None, plus_minus: None, sigma: Some(sigma), .. } if sigma > 0.0 => {
                Values::Normal { mean: middle, sigma }
            }
            Range { plus_minus: Some(by), .. } | Range { sigma: Some(by), .. } if by <= 0.0 => {
                return Err("a tolerance is a positive number");
            }
            _ => return Err("this is neither a grid nor a tolerance"),
        };
        match values {
            Values::Grid { from, to, .. } | Values::Uniform { from, to } if from == to => {
                Err("the range begins and ends at the same value")
            }
            _ => Ok(values),
        }
    }

    /// How many points of a grid it is; 1 for random values.
    pub fn points(self) -> u64 {
        if let Values::Grid { count, .. } = self { count } else { 1 }
    }

    /// The value at a point of the grid, or drawn for a row.
    pub fn value(self, point: u64, [seed, row, column]: [u64; 3]) -> f64 {
        match self {
            Values::Grid { from, to, count } => {
                let last = (count - 1) as f64;
                (from * (last - point as f64) + to * point as f64) / last
            }
            Values::Uniform { from, to } => from + (to - from) * dice(seed, row, column).unit(),
            Values::Normal { mean, sigma } => mean + sigma * normal(&mut dice(seed, row, column)),
        }
    }
}

/// Random numbers of one column of one row: they depend on the seed, the row and the column alone, so that any part of a study has the
/// same rows.
pub(super) fn dice(seed: u64, row: u64, column: u64) -> Random {
    let mix = |state: u64, number: u64| Random(state ^ number).next();
    Random(mix(mix(mix(0, seed), row), column))
}

/// Normally distributed, with mean 0 and standard deviation 1: G. E. P. Box, M. E. Muller, "A note on the generation of random normal
/// deviates", Ann. Math. Stat. 29 (1958).
pub(super) fn normal(dice: &mut Random) -> f64 {
    // Of (0, 1], so that its logarithm is finite.
    let size = 1.0 - dice.unit();
    libm::sqrt(-2.0 * libm::log(size)) * libm::cos(TAU * dice.unit())
}
