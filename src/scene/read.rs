//! The whole way: text, JSON, file, scene.

use serde::de::DeserializeOwned;
use serde_json::Value as Json;
use serde_path_to_error::Segment;

use super::check_figure::figure;
use super::check_links::{check_motions, links};
use super::check_points::{check_given_once, check_points, ground, known, near};
use super::check_sliders::sliders;
use super::error::SceneError;
use super::file::SceneFile;
use super::kind::FileKind;
use super::names::Names;
use super::place::{Source, Spot};
use super::units::Units;
use super::words::{describe, plain, shortened};
use super::{Form, Scene, text};

/// The scene that the text describes.
pub(super) fn read(text: &str) -> Result<Scene, SceneError> {
    let source = Source(text);
    let file: SceneFile = read_as(text, &FileKind::SCENE)?;

    let form = if file.points.is_some() { Form::Drawn } else { Form::Lengths };
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
        units: Units { length: file.units.length, time: file.units.time },
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

/// The file of that kind that the text holds, as its types, or the first thing that is wrong with it.
pub(crate) fn read_as<T: DeserializeOwned>(text: &str, kind: &FileKind) -> Result<T, SceneError> {
    let source = Source(text);
    let json = text::parse(source, kind)?;
    check_version(source, &json, kind)?;
    typed(source, &json)
}

/// The version comes first: a file of another version may have other keys.
fn check_version(source: Source<'_>, json: &Json, kind: &FileKind) -> Result<(), SceneError> {
    let FileKind { what, key, version } = *kind;
    let Some(object) = json.as_object() else {
        let start = kind.start();
        let message = format!("expected a {what} as {start}, found {}", describe(json));
        return Err(source.error(&[], message));
    };
    match object.get(key) {
        None => {
            // An unknown key that is nearly this one is the better message.
            let near = object.keys().find(|other| super::words::nearest(other, [key]).is_some());
            let hint = match near {
                Some(other) => format!("did you mean `{key}` by `{}`?", shortened(other)),
                None => format!(r#"add "{key}": {version}, the version of the {what} format"#),
            };
            let message = format!("`{key}` is missing, so this may be something other than a {what}");
            Err(source.error(&[], message).hint(hint))
        }
        Some(Json::Number(said)) if said.as_f64() == Some(version as f64) => Ok(()),
        Some(Json::Number(said)) => {
            let message = format!("this program reads version {version}, the {what} says {said}");
            Err(source.error(&[key], message))
        }
        Some(other) => {
            let message =
                format!("expected the number {version}, the version of the format, found {}", describe(other));
            Err(source.error(&[key], message).hint(format!(r#"write "{key}": {version}"#)))
        }
    }
}

/// The JSON as the types of the file.
fn typed<T: DeserializeOwned>(source: Source<'_>, json: &Json) -> Result<T, SceneError> {
    let mut track = serde_path_to_error::Track::new();
    let result = T::deserialize(serde_path_to_error::Deserializer::new(json, &mut track));
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
