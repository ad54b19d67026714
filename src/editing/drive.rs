//! Another position of the mechanism, or another assembly mode, as a change of its text.

use serde_json::Value as Json;

use super::document::Document;
use super::measure::Decimals;
use super::near::{MOVED, distance, settle};
use super::present::{Solved, refused};
use crate::geometry::{degrees_of, span, with_turns};
use crate::mechanism::{BodyId, Mechanism, Role};
use crate::position::{Pose, numbered_pose};
use crate::scene::{GivenBy, SceneError};

/// Numbers of further decimals of a drive that are tried, where rounding moves points too far or beyond a limit.
const FURTHER: [i32; 5] = [0, 1, 2, 4, 8];

/// The text with its drives where they stand in `now`, a position of the mechanism of the text, and in that assembly.
///
/// Angles are rounded to 0.1°, positions of sliders to about four digits; to more where that would move a point visibly. Where
/// another link gives its angle in place of a drive, that angle is changed. `near` changes where it would choose another assembly.
///
/// # Errors
/// The text is no scene or is drawn, or it cannot be assembled there.
pub fn with_position(text: &str, now: &Pose) -> Result<String, SceneError> {
    let before = Solved::of(text)?;
    let document = Document::new(text)?;
    if before.scene.given_by == GivenBy::Drawing || now.points.len() != before.mechanism.points.len() {
        let message = "a drawn configuration cannot be moved";
        return Err(document.error(&["points"], message, Some("give the mechanism by lengths, with a drive")));
    }
    let values = Stand::all(&document.json(), &before.mechanism, now);
    let mut failure = None;
    for further in FURTHER {
        let mut trial = document.clone();
        let rounded = values.iter().map(|stand| (stand.path.clone(), stand.decimals.finer(further).json(stand.value)));
        trial.set_all(&rounded.collect::<Vec<_>>())?;
        match settle(&mut trial, now) {
            Ok(solved) if distance(now, &solved.pose) <= MOVED => return Ok(trial.text()),
            Ok(_) => {}
            Err(error) => failure = Some(error),
        }
    }
    let message = "the position cannot be written as values of the drives";
    Err(failure.unwrap_or_else(|| document.error(&[], message, Some("take another position"))))
}

/// The text with the assembly mode of that number, as `kinegon modes` counts them from 1, chosen by `near`.
///
/// # Errors
/// The text is no scene, is drawn, or has no such mode.
pub fn with_mode(text: &str, number: usize) -> Result<String, SceneError> {
    let before = Solved::of(text)?;
    let wanted = numbered_pose(&before.mechanism, &before.scene.near, number)
        .map_err(|error| refused(&before.scene, error.problem()))?;
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
struct Stand {
    path: Vec<String>,
    value: f64,
    decimals: Decimals,
}

impl Stand {
    /// What the text says of all drives, but for those that stand so already.
    fn all(scene: &Json, mechanism: &Mechanism, now: &Pose) -> Vec<Stand> {
        let is_driven = |id: &BodyId| matches!(mechanism.body(*id).role, Role::Driver { .. });
        let placing = mechanism.placing.iter().map(|placing| placing.link);
        let turned = mechanism.links().map(|(id, _)| id).filter(is_driven).chain(placing);
        let turned =
            turned.filter_map(|id| Stand::turned(scene, &mechanism.body(id).name, degrees_of((*now.axes.get(id.0)?)?)));
        let pushed = mechanism.sliders.iter().enumerate().filter(|(_, slider)| slider.drive.is_some());
        let pushed = pushed.filter_map(|(index, _)| Stand::pushed(scene, index, (*now.slides.get(index)?)?, now));
        turned.chain(pushed).collect()
    }

    /// A link at that angle, in degrees.
    fn turned(scene: &Json, link: &str, degrees: f64) -> Option<Stand> {
        let path = turning(scene, link)?;
        let old = number_at(scene, &path)?;
        // People who write no negative angles get none.
        let value = if old >= 0.0 { degrees.rem_euclid(360.0) } else { degrees };
        let is_new = (with_turns(degrees, old) - old).abs() > STANDS;
        is_new.then_some(Stand { path, value, decimals: ANGLE })
    }

    /// The slider of that index at that position.
    fn pushed(scene: &Json, index: usize, value: f64, now: &Pose) -> Option<Stand> {
        let path = position_of(scene, index)?;
        let size = span(now.points.iter().copied());
        let is_new = (value - number_at(scene, &path)?).abs() > STANDS * size;
        // About four digits.
        let decimals = Decimals::of_size(value.abs().clamp(0.1 * size, size));
        is_new.then_some(Stand { path, value, decimals })
    }
}

/// A number of the text; names have neither `/` nor `~`.
pub(super) fn number_at(scene: &Json, path: &[String]) -> Option<f64> {
    scene.pointer(&format!("/{}", path.join("/")))?.as_f64()
}

/// Change of a drive, in degrees or parts of the mechanism's size, that counts as none.
const STANDS: f64 = 1e-9;

/// Decimals of a drive's angle.
const ANGLE: Decimals = Decimals(1);

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

/// Where the text gives the position of a driven slider, by its index: in its entry or in the sliding link; `None` where
/// neither does.
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
