//! Draws every starting scene of `kinegon new`, one of them in every style, and writes docs/gallery.md with the pictures in docs/gallery.
//! Run with `cargo run --release --example gallery`.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use kinegon::drawing::{Drawing, figure};
use kinegon::format::{structure, svg};
use kinegon::mechanism::mechanism;
use kinegon::motion::{Order, motion};
use kinegon::plan::construction_in;
use kinegon::position::pose;
use kinegon::scene::Scene;
use kinegon::words::Wording;
use serde_json::{Map, Value};

/// Kinds of `kinegon new` in its order, their scenes, and what each teaches.
const KINDS: [(&str, &str, &str); 19] = [
    (
        "four-bar",
        "templates/four-bar.json",
        "The first dyad: c lies where two rays cross, one normal to the coupler and one normal to the rocker.",
    ),
    (
        "slider-crank",
        "templates/slider-crank.json",
        "A slider's ray is parallel to its guide; the guide misses the crank's pivot by an offset.",
    ),
    (
        "slotted-lever",
        "templates/slotted-lever.json",
        "A block on a turning guide: the point of the lever under the block, sliding velocity, Coriolis acceleration.",
    ),
    (
        "whitworth",
        "templates/whitworth.json",
        "The lever turns fully because its pivot lies within the crank's circle; a second dyad drives the ram.",
    ),
    (
        "toggle-press",
        "templates/toggle-press.json",
        "Three links on one pin; the ram slows down, and its force grows, as the toggle straightens.",
    ),
    (
        "hydraulic-boom",
        "templates/hydraulic-boom.json",
        "Cylinder and rod are one link of changing length: sliding velocity, sliding and Coriolis acceleration are laid off before the ray.",
    ),
    (
        "watt-1",
        "templates/watt-1.json",
        "Two dyads, one after the other; the image of a ternary link is the link turned and scaled.",
    ),
    (
        "stephenson-3",
        "templates/stephenson-3.json",
        "A coupler point, found by its image, drives a second dyad.",
    ),
    (
        "five-bar",
        "templates/five-bar.json",
        "Two degrees of freedom, two drives: a dyad between two moving pins.",
    ),
    (
        "third-class",
        "templates/third-class.json",
        "No dyad to begin with: special points of the central link open the group.",
    ),
    (
        "fourth-class",
        "templates/fourth-class.json",
        "A closed contour of four links: special points of the two closure links open the group.",
    ),
    (
        "platform-3rrr",
        "templates/platform-3rrr.json",
        "Three drives move a third-class group by all its outer pins.",
    ),
    (
        "dyad-rrr",
        "templates/dyad-rrr.json",
        "Three pins: both rays are normal to links, and both outer pins may move.",
    ),
    (
        "dyad-rrp",
        "templates/dyad-rrp.json",
        "An outer slider: one ray is parallel to the guide.",
    ),
    (
        "dyad-rpr",
        "templates/dyad-rpr.json",
        "An inner slider: the ray of relative velocity is parallel to the lever, and Coriolis acceleration is normal to it.",
    ),
    (
        "dyad-prp",
        "templates/dyad-prp.json",
        "Two outer sliders: both rays are parallel to guides, of which one moves.",
    ),
    (
        "dyad-rpp",
        "templates/dyad-rpp.json",
        "A Scotch yoke: an inner and an outer slider, and no rotation at all.",
    ),
    (
        "paper-figure-1",
        "examples/figure-1.json",
        "The paper's fourth-class group with all joints revolute, as drawn, between two pins of known motion.",
    ),
    (
        "paper-figure-2",
        "examples/figure-2.json",
        "The paper's example: a fourth-class group with one slider, driven by a crank.",
    ),
];

/// Other looks of the last scene: picture, keys of its `figure`, and what they are for.
const LOOKS: [(&str, &str, &str); 4] = [
    (
        "style-print",
        r#"{ "style": "print" }"#,
        "For a black and white printer and the photocopier: widths, dashes and heads carry the meaning.",
    ),
    (
        "style-lecture",
        r#"{ "style": "lecture" }"#,
        "Each link has one colour: in the scheme, in its images, in its ω.",
    ),
    ("style-board", r#"{ "style": "board" }"#, "For a dark room."),
    (
        "spanish-german",
        r#"{ "language": "es", "notation": "german", "decimal": "comma" }"#,
        "In Spanish, with poles as German textbooks write them and decimal commas.",
    ),
];

/// A file of the gallery: where it goes, from the root of the repository, and what it says.
pub type File = (String, String);

/// The page and its pictures.
///
/// # Errors
/// Only if one of the scenes has been changed so that it cannot be drawn.
pub fn files() -> Result<Vec<File>, Box<dyn Error>> {
    let mut page = String::from(
        "# Gallery\n\n\
         Every kind of `kinegon new KIND`, with its Assur groups in solving order (`kinegon structure`) and its figure \
         (`kinegon draw`).\n\
         This page and its pictures are made by `cargo run --release --example gallery`.\n",
    );
    let mut pictures = Vec::new();
    for (kind, path, teaches) in KINDS {
        let text = fs::read_to_string(root().join(path))?;
        let (drawing, structure) = drawn(&text)?;
        let title = &drawing.title;
        let formula = structure.lines().next().unwrap_or_default();
        let _ = write!(
            page,
            "\n## {title}\n\n{teaches}\n\n`{kind}`: {formula}\n\n![{title}. {}](gallery/{kind}.svg)\n",
            drawing.description
        );
        pictures.push((format!("docs/gallery/{kind}.svg"), svg(&drawing)));
    }
    page.push_str("\n## Styles, notations, languages\n\nThe same figure with other keys in its scene's `figure`.\n");
    let (_, path, _) = KINDS[KINDS.len() - 1];
    for (name, keys, serves) in LOOKS {
        let text = fs::read_to_string(root().join(path))?;
        let mut scene: Value = serde_json::from_str(&text)?;
        let keys_of: Map<String, Value> = serde_json::from_str(keys)?;
        for (key, value) in keys_of {
            scene["figure"][key] = value;
        }
        let (drawing, _) = drawn(&scene.to_string())?;
        let _ = write!(
            page,
            "\n`{keys}`: {serves}\n\n![{}. {}](gallery/{name}.svg)\n",
            drawing.title, drawing.description
        );
        pictures.push((format!("docs/gallery/{name}.svg"), svg(&drawing)));
    }
    pictures.insert(0, ("docs/gallery.md".to_owned(), page));
    Ok(pictures)
}

/// The figure of a scene, and its groups in words.
fn drawn(text: &str) -> Result<(Drawing, String), Box<dyn Error>> {
    let scene = Scene::read(text)?;
    let mechanism = mechanism(&scene)?;
    let pose = pose(&mechanism, &scene.near)?;
    let motion = motion(&mechanism, &pose, Order::Acceleration)?;
    let words = Wording::of(&scene.figure);
    let construction = construction_in(&mechanism, &pose, &motion, &words);
    let drawing = figure(&scene, &mechanism, &pose, &construction);
    Ok((drawing, structure(&mechanism)))
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn main() -> Result<(), Box<dyn Error>> {
    for (path, text) in files()? {
        let path: &Path = &root().join(path);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(path, text)?;
    }
    Ok(())
}
