//! Changes of a scene's text: what is not changed stays to the byte, what is changed is what was meant, and the mechanism stays in the
//! assembly that was seen.

mod added;
mod driven;
mod dropped;
mod hostile;
mod placed;
mod pulled;
mod renamed;
mod set;

use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::position::{Pose, pose, with_nearest_sides};
use kinegon::scene::Scene;
use support::files::{path, scenes};

/// Scenes of all kinds that can be solved, by name.
pub fn solvable() -> Vec<(String, String)> {
    let folders = ["templates", "examples", "tests/lecture"];
    let mut all: Vec<(String, String)> = folders.into_iter().flat_map(scenes).collect();
    let worked = std::fs::read_dir(path("tests/worked")).expect("a folder");
    for case in worked.map(|entry| entry.expect("an entry").path()).filter(|case| case.is_dir()) {
        if let Ok(text) = std::fs::read_to_string(case.join("scene.json")) {
            all.push((case.file_name().expect("a name").to_string_lossy().into_owned(), text));
        }
    }
    all.retain(|(_, text)| position(text).is_ok());
    all.sort();
    assert!(all.len() > 40, "{}", all.len());
    all
}

/// The mechanism of a text and its position.
pub fn position(text: &str) -> Result<(Scene, Mechanism, Pose), kinegon::Error> {
    let scene = Scene::read(text)?;
    let mechanism = with_nearest_sides(&scene, mechanism(&scene)?);
    let pose = pose(&mechanism, &scene.near)?;
    Ok((scene, mechanism, pose))
}

/// The diagonal of the box of all points.
pub fn size(pose: &Pose) -> f64 {
    kinegon::geometry::span(pose.points.iter().copied())
}
