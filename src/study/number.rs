//! The numbers of a scene that may vary.

use crate::quantity::QuantityKind;
use crate::scene::{Scene, Shape, TimeUnit, Units};
use std::f64::consts::{PI, TAU};

/// A number of a scene, by its place in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    /// A length: link, and its place in the link's list.
    Length(usize, usize),
    /// A coordinate in a link's shape: link, point, axis.
    Local(usize, usize, usize),
    /// A coordinate of a ground point: its place among the given coordinates, axis.
    Ground(usize, usize),
    /// A number of a link's drive.
    Turn(usize, Turn),
    /// A number of a slider's drive.
    Push(usize, Push),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turn {
    Angle,
    Omega,
    Rpm,
    Alpha,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Push {
    Position,
    Speed,
    Acceleration,
}

/// A number with its name, as `2.BC`, and its place in the scene, as `links.2.lengths.BC`.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub name: String,
    pub path: String,
    pub number: Number,
    pub value: f64,
}

const AXES: [&str; 2] = ["x", "y"];

/// All numbers of a scene that may vary.
pub(super) fn numbers(scene: &Scene) -> Vec<Named> {
    let mut all = Vec::new();
    let mut add = |name: String, path: String, number, value| all.push(Named { name, path, number, value });
    for (index, (point, place)) in scene.coordinates.iter().enumerate() {
        for (axis, letter) in AXES.iter().enumerate() {
            add(
                format!("{point}.{letter}"),
                format!("ground.{point}.{axis}"),
                Number::Ground(index, axis),
                place[axis],
            );
        }
    }
    for (index, (link, of)) in scene.links.iter().enumerate() {
        match &of.shape {
            Shape::Bare => {}
            Shape::Lengths(lengths) => {
                for (place, length) in lengths.iter().enumerate() {
                    let key = &length.key;
                    add(
                        format!("{link}.{key}"),
                        format!("links.{link}.lengths.{key}"),
                        Number::Length(index, place),
                        length.value,
                    );
                }
            }
            Shape::Local(points) => {
                for (place, (point, at)) in points.iter().enumerate() {
                    for (axis, letter) in AXES.iter().enumerate() {
                        let path = format!("links.{link}.shape.{point}.{axis}");
                        add(format!("{link}.{point}.{letter}"), path, Number::Local(index, place, axis), at[axis]);
                    }
                }
            }
        }
        if let Some(drive) = of.drive {
            let speed = drive.rpm.map_or(("omega", Turn::Omega, drive.omega), |rpm| ("rpm", Turn::Rpm, rpm));
            let angle = drive.angle_deg.map(|angle| ("angle", Turn::Angle, angle));
            for (key, turn, value) in angle.into_iter().chain([speed, ("alpha", Turn::Alpha, drive.alpha)]) {
                add(format!("{link}.{key}"), format!("links.{link}.drive.{key}"), Number::Turn(index, turn), value);
            }
        }
    }
    for (index, slider) in scene.sliders.iter().enumerate() {
        let (Some(drive), Some(link)) = (slider.drive, &slider.link) else {
            continue;
        };
        let position = drive.position.map(|position| ("position", Push::Position, position));
        let rates = [("speed", Push::Speed, drive.speed), ("acceleration", Push::Acceleration, drive.acceleration)];
        for (key, push, value) in position.into_iter().chain(rates) {
            add(format!("{link}.{key}"), format!("sliders.{index}.drive.{key}"), Number::Push(index, push), value);
        }
    }
    all
}

impl Number {
    /// Its unit.
    pub fn unit(self, units: Units) -> String {
        let kind = match self {
            Number::Turn(_, Turn::Rpm) => return "1/min".to_owned(),
            Number::Turn(_, Turn::Angle) => QuantityKind::Angle,
            Number::Turn(_, Turn::Omega) => QuantityKind::AngularVelocity,
            Number::Turn(_, Turn::Alpha) => QuantityKind::AngularAcceleration,
            Number::Push(_, Push::Speed) => QuantityKind::Velocity,
            Number::Push(_, Push::Acceleration) => QuantityKind::Acceleration,
            Number::Length(..) | Number::Local(..) | Number::Ground(..) | Number::Push(_, Push::Position) => {
                QuantityKind::Length
            }
        };
        kind.unit(units)
    }

    /// Puts a value in its place.
    pub fn set(self, scene: &mut Scene, value: f64) {
        match self {
            Number::Length(link, place) => {
                if let Shape::Lengths(lengths) = &mut scene.links[link].shape {
                    lengths[place].value = value;
                }
            }
            Number::Local(link, point, axis) => {
                if let Shape::Local(points) = &mut scene.links[link].shape {
                    points[point][axis] = value;
                }
            }
            Number::Ground(point, axis) => scene.coordinates[point][axis] = value,
            Number::Turn(link, turn) => {
                let per_rpm = if scene.units.time == TimeUnit::S { PI / 30.0 } else { TAU };
                if let Some(drive) = &mut scene.links[link].drive {
                    match turn {
                        Turn::Angle => drive.angle_deg = Some(value),
                        Turn::Omega => drive.omega = value,
                        Turn::Rpm => (drive.rpm, drive.omega) = (Some(value), value * per_rpm),
                        Turn::Alpha => drive.alpha = value,
                    }
                }
            }
            Number::Push(slider, push) => {
                if let Some(drive) = &mut scene.sliders[slider].drive {
                    match push {
                        Push::Position => drive.position = Some(value),
                        Push::Speed => drive.speed = value,
                        Push::Acceleration => drive.acceleration = value,
                    }
                }
            }
        }
    }
}

/// Whether links with these lengths exist: all are positive, and three of a link form a triangle.
pub(super) fn has_links(scene: &Scene) -> bool {
    scene.links.values().all(|link| {
        let Shape::Lengths(lengths) = &link.shape else {
            return true;
        };
        let sum: f64 = lengths.iter().map(|length| length.value).sum();
        let longest = lengths.iter().map(|length| length.value).fold(0.0, f64::max);
        lengths.iter().all(|length| length.value > 0.0) && (lengths.len() < 3 || 2.0 * longest - sum <= 1e-12 * longest)
    })
}
