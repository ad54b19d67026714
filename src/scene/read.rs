//! The whole way: text, JSON, file, scene.

use serde::Deserialize;
use serde_json::Value as Json;
use serde_path_to_error::Segment;

use super::check_figure::figure;
use super::check_links::{check_motions, links};
use super::check_points::{check_given_once, check_points, ground, known, near};
use super::check_sliders::sliders;
use super::error::SceneError;
use super::file::SceneFile;
use super::names::Names;
use super::place::{Source, Spot};
use super::units::Units;
use super::words::{describe, plain, shortened};
use super::{Form, Scene, text};

/// The version of the scene format that this program reads.
const VERSION: u64 = 1;

/// The scene that the text describes.
pub(super) fn read(text: &str) -> Result<Scene, SceneError> {
    let source = Source(text);
    let json = text::parse(source)?;
    check_version(source, &json)?;
    let file = typed(source, &json)?;

    let form = if file.points.is_some() {
        Form::Drawn
    } else {
        Form::Lengths
    };
    let (links, pushes) = links(source, form, file.units.time, file.links)?;
    let (ground, coordinates) = ground(source, form, file.ground, file.points)?;
    let names = Names::new(source, &ground, &links);
    check_points(source, form, &names, &ground, &links, &coordinates)?;
    let sliders = sliders(source, form, &names, &coordinates, file.sliders, pushes)?;
    let known = known(source, form, &names, file.known)?;
    check_given_once(source, &names, &known, &sliders)?;
    let near = near(source, form, &names, file.near)?;
    check_motions(&names, &links)?;
    let figure = figure(source, file.figure)?;
    Ok(Scene {
        title: file.title,
        units: Units {
            length: file.units.length,
            time: file.units.time,
        },
        form,
        ground,
        coordinates,
        known,
        links,
        sliders,
        near,
        figure,
        want: file.want,
        text: text.to_owned(),
    })
}

/// The version comes first: a scene of another version may have other keys.
fn check_version(source: Source<'_>, json: &Json) -> Result<(), SceneError> {
    let Some(object) = json.as_object() else {
        let message = format!(
            r#"expected a scene as {{ "kinegon": 1, … }}, found {}"#,
            describe(json)
        );
        return Err(source.error(&[], message));
    };
    match object.get("kinegon") {
        None => {
            // An unknown key that is nearly this one is the better message.
            let near = object
                .keys()
                .find(|key| super::words::nearest(key, ["kinegon"]).is_some());
            let hint = match near {
                Some(key) => format!("did you mean `kinegon` by `{}`?", shortened(key)),
                None => r#"add "kinegon": 1, the version of the scene format"#.into(),
            };
            let message = "`kinegon` is missing, so this may be something other than a scene";
            Err(source.error(&[], message).hint(hint))
        }
        Some(Json::Number(version)) if version.as_f64() == Some(VERSION as f64) => Ok(()),
        Some(Json::Number(version)) => {
            let message = format!("this program reads version {VERSION}, the scene says {version}");
            Err(source.error(&["kinegon"], message))
        }
        Some(other) => {
            let message = format!(
                "expected the number {VERSION}, the version of the format, found {}",
                describe(other)
            );
            Err(source
                .error(&["kinegon"], message)
                .hint(r#"write "kinegon": 1"#))
        }
    }
}

/// The JSON as the types of the file.
fn typed(source: Source<'_>, json: &Json) -> Result<SceneFile, SceneError> {
    let mut track = serde_path_to_error::Track::new();
    let result = SceneFile::deserialize(serde_path_to_error::Deserializer::new(json, &mut track));
    result.map_err(|error| {
        let parts = track.path().iter().filter_map(part).collect::<Vec<_>>();
        let mut path: Vec<&str> = parts.iter().map(String::as_str).collect();
        let plain = plain(&error.to_string(), &path, at(json, &path));
        let spot = match &plain.key {
            Some(key) => {
                if path.last() != Some(&key.as_str()) {
                    path.push(key);
                }
                Spot::Key
            }
            None => Spot::Value,
        };
        source.error_with(&path, spot, plain.message.clone(), plain.hint.clone())
    })
}

/// A step of a path, in the form of this stage.
fn part(segment: &Segment) -> Option<String> {
    match segment {
        Segment::Seq { index } => Some(index.to_string()),
        Segment::Map { key } => Some(key.clone()),
        Segment::Enum { .. } | Segment::Unknown => None,
    }
}

/// The value at a path.
fn at<'a>(json: &'a Json, path: &[&str]) -> Option<&'a Json> {
    path.iter().try_fold(json, |value, part| match value {
        Json::Object(object) => object.get(*part),
        Json::Array(array) => array.get(part.parse::<usize>().ok()?),
        _ => None,
    })
}
