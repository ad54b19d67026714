//! Branches followed over whole cycles, against the source paper, closed forms, positions assembled anew and differences of positions.

mod branches;
mod changes;
mod drives;
mod ends;
mod four_bars;
mod many;
mod mover;
mod paper;
mod rates;
mod table;
mod variants;

use kinegon::cycle::{Drive, Path};
use kinegon::geometry::span;
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;
use support::files;

/// The unit roundoff of f64.
const U: f64 = f64::EPSILON / 2.0;

/// A turn in degrees.
const TURN: f64 = 360.0;

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

/// The same, followed once around, or from end to end.
fn followed<'a>(mechanism: &'a Mechanism, pose: &Pose) -> Path<'a> {
    let mut path = path(mechanism, pose);
    if path.drive.is_angle {
        path.cover(None, None).expect("it can be followed");
    } else {
        // Farther than any slider gets.
        let size = span(pose.points.iter().copied());
        path.follow_to(-10.0 * size);
        path.follow_to(10.0 * size);
    }
    path
}

/// Every starting scene that is given by lengths, and the paper's, with their names.
fn scenes() -> Vec<(String, String)> {
    let mut named = files::templates();
    let paper = files::read("examples/figure-2.json");
    named.push(("figure-2".to_owned(), paper));
    let movable = named.into_iter().filter(|(_, text)| text.contains("\"near\""));
    let more = MORE.map(|(name, text)| (name.to_owned(), text.to_owned()));
    let scenes: Vec<_> = movable.chain(more).collect();
    assert_eq!(scenes.len(), 19 + MORE.len());
    scenes
}

/// Kinds of drives and joints that no starting scene has.
const MORE: [(&str, &str); 4] = [
    (
        "a pushed piston turns a crank",
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
          "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 50 } }, "2": { "points": ["B", "C"], "lengths": { "BC": 150 } },
                     "3": { "points": ["C"] } },
          "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, -20], "along": 0,
                        "drive": { "position": 150, "speed": 30, "acceleration": 40 } }],
          "near": { "B": [10, 45] } }"#,
    ),
    (
        "a pin in the slot of a lever",
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [0, 0], "A": [0, 80] },
          "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 30 }, "drive": { "angle": 45, "omega": 4, "alpha": -7 } },
                     "3": { "points": ["O", "C"], "lengths": { "OC": 130 } } },
          "sliders": [{ "pin": "B", "on": "3", "along": "OC" }], "near": { "C": [30, 120] } }"#,
    ),
    (
        "a slotted lever with an offset slot moves a slider",
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [0, 0], "A": [10, 80] },
          "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 30 }, "drive": { "angle": 45, "omega": 4, "alpha": 2 } },
                     "2": { "points": ["B"] }, "3": { "shape": { "O": [0, 0], "P": [0, 12], "Q": [150, 12] } },
                     "4": { "points": ["Q"] }, "5": { "points": ["R"] } },
          "sliders": [{ "link": "2", "at": "B", "on": "3", "along": "PQ" },
                      { "link": "4", "at": "Q", "on": "5", "along": 90 },
                      { "link": "5", "at": "R", "on": "ground", "through": [0, 170], "along": 5 }],
          "near": { "Q": [30, 120] } }"#,
    ),
    (
        "an ellipse: a rod between two sliders, one of them pushed",
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [0, 0] },
          "links": { "1": { "points": ["P"] }, "2": { "points": ["P", "Q"], "lengths": { "PQ": 100 } }, "3": { "points": ["Q"] } },
          "sliders": [{ "link": "1", "at": "P", "on": "ground", "through": "O", "along": 0, "drive": { "position": 40, "speed": -12 } },
                      { "link": "3", "at": "Q", "on": "ground", "through": "O", "along": 70 }],
          "near": { "Q": [30, 90] } }"#,
    ),
];
