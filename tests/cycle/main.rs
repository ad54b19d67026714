//! Branches followed over whole cycles, against the source paper, closed forms, positions assembled anew and differences of positions.

#[path = "../exact/mod.rs"]
mod exact;
mod four_bars;
mod paper;
mod random;

use kinegon::cycle::{Drive, Path};
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;

/// A thousandth of a billionth of a turn, in degrees.
const LOCATED: f64 = 360e-12;

/// The mechanism of a scene, and the position that its `near` picks.
fn posed(text: &str) -> (Mechanism, Pose) {
    let scene = Scene::read(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let mechanism = mechanism(&scene).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let pose = pose(&mechanism, &scene.near).unwrap_or_else(|error| panic!("{error}\n{text}"));
    (mechanism, pose)
}

/// The path through a pose for the first drive.
fn path<'a>(mechanism: &'a Mechanism, pose: &Pose) -> Path<'a> {
    let drive = Drive::new(mechanism, None).expect("it has a drive");
    Path::new(mechanism, pose, drive).expect("the position is regular")
}
