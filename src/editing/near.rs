//! `near` for a position that is wanted: as little of it as chooses that assembly.

use serde_json::{Map, Value as Json};

use super::document::Document;
use super::measure::Decimals;
use super::present::{Solved, of_scene};
use crate::geometry::{degrees_of, span};
use crate::mechanism::{BodyId, Mechanism};
use crate::position::Pose;
use crate::scene::{QuantityName, Scene, SceneError};

/// Largest distance of two positions that count as one, in parts of the mechanism's size and in radians.
const SAME: f64 = 1e-6;

/// Largest distance, in parts of the mechanism's size, by which rounding may move a point where `near` says all that it can.
pub(super) const MOVED: f64 = 0.02;

/// What `near` may say, from the least on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Said {
    /// What it says already.
    AsItIs,
    /// The points and links that it names already, where they are now.
    Present,
    /// All points whose places have to be found.
    AllPoints,
    /// These with more digits, and angles of levers of one point.
    Everything,
}

/// Makes `near` choose the assembly with points in these places, by index of the mechanism; gives the position.
///
/// # Errors
/// The text is no scene, or the scene cannot be assembled.
pub(super) fn settle(document: &mut Document<'_>, wanted: &Pose) -> Result<Solved, SceneError> {
    let mechanism = of_scene(&Scene::read(&document.text())?)?;
    if !mechanism.links().any(|(id, _)| mechanism.is_sought(id)) || wanted.points.len() != mechanism.points.len() {
        return Solved::of(&document.text());
    }
    let mut whole = document.clone();
    say(&mut whole, &mechanism, wanted, Said::Everything)?;
    let meant = Solved::of(&whole.text())?;
    for said in [Said::AsItIs, Said::Present, Said::AllPoints] {
        let mut trial = document.clone();
        say(&mut trial, &mechanism, wanted, said)?;
        if let Ok(solved) = Solved::of(&trial.text())
            && is_same(&solved, &meant)
            && solved.pose.warnings.len() <= meant.pose.warnings.len()
        {
            *document = trial;
            return Ok(solved);
        }
    }
    *document = whole;
    Ok(meant)
}

/// Whether all points and axes are in one place in both positions.
fn is_same(one: &Solved, other: &Solved) -> bool {
    let axes = one.pose.axes.iter().zip(&other.pose.axes).filter_map(|(a, b)| Some((a.as_ref()?, b.as_ref()?)));
    let turned = axes.map(|(a, b)| (a.normalize() - b.normalize()).norm());
    distance(&one.pose, &other.pose) <= SAME && turned.fold(0.0, f64::max) <= SAME
}

/// The largest distance of a point in two positions, in parts of the mechanism's size.
pub(super) fn distance(one: &Pose, other: &Pose) -> f64 {
    let pairs = one.points.iter().zip(&other.points);
    let off = pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
    let size = span(one.points.iter().copied());
    if size > 0.0 { off / size } else { off }
}

/// Writes `near`.
fn say(document: &mut Document<'_>, mechanism: &Mechanism, wanted: &Pose, said: Said) -> Result<(), SceneError> {
    if said == Said::AsItIs {
        return Ok(());
    }
    let decimals = Decimals::of_size(span(wanted.points.iter().copied()));
    let decimals = if said == Said::Everything { decimals.finer(4) } else { decimals };
    let near = &document.json()["near"];
    let keys = near.as_object().into_iter().flatten().map(|(key, _)| key.clone()).filter(|key| key != "note");
    let mut keys: Vec<String> = keys.collect();
    if said != Said::Present {
        let sought = mechanism.for_positions();
        keys.extend(sought.inner_points().into_iter().map(|point| sought.point_name(point).to_owned()));
    }
    if said == Said::Everything {
        let carries_guide = |link: BodyId| mechanism.sliders.iter().any(|slider| slider.on == link);
        let links = mechanism.links().filter(|(id, body)| body.points.len() == 1 && carries_guide(*id));
        keys.extend(links.map(|(_, body)| format!("angle({})", body.name)));
    }
    let values = keys.into_iter().filter_map(|key| {
        let value = place_or_angle(mechanism, wanted, &key, decimals)?;
        Some((key, value))
    });
    // A new `near` is added at once, as there may be many points.
    if near.is_null() {
        let values: Map<String, Json> = values.collect();
        return if values.is_empty() { Ok(()) } else { document.set(&["near"], &Json::Object(values)) };
    }
    let values = values.map(|(key, value)| (vec!["near".to_owned(), key], value));
    document.set_all(&values.collect::<Vec<_>>())
}

/// What `near` says under a key: a point's place, or a link's angle.
fn place_or_angle(mechanism: &Mechanism, wanted: &Pose, key: &str, decimals: Decimals) -> Option<Json> {
    match QuantityName::link_of_angle(key) {
        Some(link) => {
            let axis = (*wanted.axes.get(mechanism.link(link)?.0)?)?;
            Some(Decimals::ANGLE.json(degrees_of(axis)))
        }
        None => Some(decimals.place_json(*wanted.points.get(mechanism.point(key)?.0)?)),
    }
}
