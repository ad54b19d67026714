//! Another position of the mechanism, or another assembly mode, as a change of its text.

use serde_json::Value as Json;

use super::document::Document;
use super::near::{distance, settle};
use super::number::{Decimals, json};
use super::present::{Solved, not_assembled};
use crate::geometry::{degrees_of, span};
use crate::mechanism::{Mechanism, Role, SliderId};
use crate::position::{Pose, numbered_pose};
use crate::scene::{GivenBy, SceneError};

/// Largest distance, in parts of the mechanism's size, by which rounding of a drive may move a point.
const MOVED: f64 = 0.02;

/// Numbers of further decimals of a drive that are tried, where rounding moves points too far or beyond a limit.
const FURTHER: [i32; 5] = [0, 1, 2, 4, 8];

/// The text with a drive at another value, in the assembly of `now`: that is the position at this value, of the mechanism of
/// the text. `drive` is one of [`Mechanism::drive_names`]; `value` its angle in degrees or its position.
///
/// The value is rounded to 0.1°, or to about four digits; to more where that would move a point visibly. Where another link gives its angle
/// in place of the drive, that angle is changed. `near` changes where it would choose another assembly.
///
/// # Errors
/// The text is no scene, has no such drive or is drawn, or it cannot be assembled there.
pub fn with_drive(text: &str, drive: &str, value: f64, now: &Pose) -> Result<String, SceneError> {
    let before = Solved::of(text)?;
    let document = Document::new(text)?;
    let place = Place::of(&document, &before.mechanism, drive, value, now).ok_or_else(|| {
        document.error(&["links"], format!("there is no drive {} that can be moved", crate::text::shown(drive)), None)
    })?;
    let mut failure = None;
    for further in FURTHER {
        let mut trial = document.clone();
        let path: Vec<&str> = place.path.iter().map(String::as_str).collect();
        trial.set(&path, &json(place.decimals.finer(further).round(place.value)))?;
        match settle(&mut trial, now) {
            Ok(solved) if distance(now, &solved.pose) <= MOVED => return Ok(trial.text()),
            Ok(_) => {}
            Err(error) => failure = Some(error),
        }
    }
    let message = "the position cannot be written as a value of the drive";
    Err(failure.unwrap_or_else(|| document.error(&[], message, Some("take another position"))))
}

/// The text with the assembly mode of that number, as `kinegon modes` counts them from 1, chosen by `near`.
///
/// # Errors
/// The text is no scene, is drawn, or has no such mode.
pub fn with_mode(text: &str, number: usize) -> Result<String, SceneError> {
    let before = Solved::of(text)?;
    let wanted = numbered_pose(&before.mechanism, &before.scene.near, number)
        .map_err(|error| not_assembled(&before.scene, &error))?;
    let mut document = Document::new(text)?;
    if before.scene.given_by == GivenBy::Drawing {
        return Ok(document.text());
    }
    let solved = settle(&mut document, &wanted)?;
    match distance(&wanted, &solved.pose) <= MOVED {
        true => Ok(document.text()),
        false => Err(document.error(&["near"], format!("rough places cannot choose mode {number}"), None)),
    }
}

/// Where the text says how a drive stands, and what it is to say.
struct Place {
    path: Vec<String>,
    value: f64,
    decimals: Decimals,
}

impl Place {
    fn of(document: &Document<'_>, mechanism: &Mechanism, drive: &str, value: f64, now: &Pose) -> Option<Place> {
        let scene = document.json();
        let index = mechanism.drive_names().iter().position(|name| name == drive)?;
        if mechanism.given_by == GivenBy::Drawing || now.points.len() != mechanism.points.len() {
            return None;
        }
        let turned = mechanism.bodies.iter().filter(|body| matches!(body.role, Role::Driver { .. })).nth(index);
        let path = match turned {
            Some(body) => turning(&scene, &body.name),
            None => pushing(&scene, mechanism, drive),
        };
        if let Some(path) = path {
            let is_angle = turned.is_some();
            let decimals = if is_angle { ANGLE } else { of_position(value, now) };
            let value = if is_angle { value % 360.0 } else { value };
            return Some(Place { path, value, decimals });
        }
        // Another link's angle stands in place of this drive.
        let placing = mechanism.placing.as_ref()?;
        let axis = (*now.axes.get(placing.link.0)?)?;
        let path = ["links", &mechanism.body(placing.link).name, "angle"].map(str::to_owned).to_vec();
        Some(Place { path, value: near_to(degrees_of(axis), placing.angle), decimals: ANGLE })
    }
}

/// Decimals of a drive's angle.
const ANGLE: Decimals = Decimals(1);

/// Decimals of a slider's position: about four digits.
fn of_position(value: f64, now: &Pose) -> Decimals {
    let size = span(now.points.iter().copied());
    Decimals::of_size(value.abs().clamp(0.1 * size, size))
}

/// The angle plus the number of whole turns that brings it nearest to another one, all in degrees.
pub(super) fn near_to(degrees: f64, other: f64) -> f64 {
    degrees + 360.0 * libm::round((other - degrees) / 360.0)
}

/// Where a link's drive or the link itself gives the angle; `None` where neither does.
pub(super) fn turning(scene: &Json, link: &str) -> Option<Vec<String>> {
    let entry = &scene["links"][link];
    let path: &[&str] = match (entry["drive"]["angle"].is_number(), entry["angle"].is_number()) {
        (true, _) => &["links", link, "drive", "angle"],
        (false, true) => &["links", link, "angle"],
        (false, false) => return None,
    };
    Some(path.iter().map(|&part| part.to_owned()).collect())
}

/// Where a slider's drive gives its position, in the entry of the slider or in the sliding link; `None` where neither
/// does.
fn pushing(scene: &Json, mechanism: &Mechanism, drive: &str) -> Option<Vec<String>> {
    let is_meant = |id: &SliderId| mechanism.slider(*id).drive.is_some() && mechanism.push_name(*id) == drive;
    let SliderId(index) = (0..mechanism.sliders.len()).map(SliderId).find(is_meant)?;
    position_of(scene, index)
}

/// Where the text gives the position of the slider of that index.
pub(super) fn position_of(scene: &Json, slider: usize) -> Option<Vec<String>> {
    let entry = &scene["sliders"][slider];
    let index = slider.to_string();
    if entry["drive"]["position"].is_number() {
        return Some(["sliders", &index, "drive", "position"].map(str::to_owned).to_vec());
    }
    let link = entry["link"].as_str()?;
    let is_given = scene["links"][link]["drive"]["position"].is_number();
    is_given.then(|| ["links", link, "drive", "position"].map(str::to_owned).to_vec())
}
