//! Another position of the mechanism, or another assembly mode, as a change of its text: of the values of its drives, and of `near`, of
//! which as little is said as chooses that assembly.

use serde_json::{Map, Value as Json};

use super::document::Document;
use super::measure::Decimals;
use super::present::{Solved, of_scene, refused};
use super::says;
use crate::geometry::{degrees_of, span, with_turns};
use crate::mechanism::{BodyId, Mechanism, Role};
use crate::position::{Pose, numbered_pose};
use crate::scene::{GivenBy, QuantityName, Scene, SceneError};

/// Numbers of further decimals of a drive that are tried, where rounding moves points too far or beyond a limit.
const FURTHER: [i32; 5] = [0, 1, 2, 4, 8];

/// Whole turns of a drive that are tried where wheels mesh: a pose does not say how often they have gone round, but where they stand depends on it.
const TURNS: [f64; 25] = [
    0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0, 5.0, -5.0, 6.0, -6.0, 7.0, -7.0, 8.0, -8.0, 9.0, -9.0, 10.0,
    -10.0, 11.0, -11.0, 12.0, -12.0,
];

/// Of these, for each of two drives.
const FEW: usize = 13;

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
        return Err(document.error(&["points"], says::drawn(), Some(says::give_lengths())));
    }
    let values = Stand::all(&document.json(), &before.mechanism, now);
    let mut failure = None;
    let turns = further_turns(before.mechanism.has_wheels(), &values);
    for (further, turns) in FURTHER.into_iter().flat_map(|further| turns.iter().map(move |turns| (further, turns))) {
        let mut trial = document.clone();
        let value =
            |(stand, turns): (&Stand, f64)| stand.decimals.finer(further).json(stand.value + stand.turn * turns);
        let of_each = values.iter().zip(turns.iter().copied());
        let changed = of_each.filter(|(stand, turns)| stand.is_new || *turns != 0.0);
        let rounded = changed.map(|changed| (changed.0.path.clone(), value(changed)));
        trial.set_all(&rounded.collect::<Vec<_>>())?;
        match settle(&mut trial, now) {
            Ok(solved) if distance(now, &solved.pose) <= MOVED => return Ok(trial.text()),
            Ok(_) => {}
            Err(error) => failure = Some(error),
        }
    }
    Err(failure.unwrap_or_else(|| document.error(&[], says::no_position(), Some(says::other_position()))))
}

/// By drive, the whole turns that are tried, the fewest first; of two drives that turn each has its own, as in a differential, of more
/// only the first two.
fn further_turns(has_wheels: bool, values: &[Stand]) -> Vec<Vec<f64>> {
    let none = vec![0.0; values.len()];
    let turning: Vec<usize> = (0..values.len()).filter(|&drive| values[drive].turn != 0.0).take(2).collect();
    let with = |turns: &[f64]| {
        let mut all = none.clone();
        turning.iter().zip(turns).for_each(|(&drive, &turns)| all[drive] = turns);
        all
    };
    match turning.len() {
        _ if !has_wheels => vec![none],
        0 => vec![none],
        1 => TURNS.iter().map(|&turns| with(&[turns])).collect(),
        _ => {
            let few = &TURNS[..FEW];
            let pairs = few.iter().flat_map(|&first| few.iter().map(move |&second| [first, second]));
            let mut pairs: Vec<[f64; 2]> = pairs.collect();
            pairs.sort_by(|a, b| (a[0].abs() + a[1].abs()).total_cmp(&(b[0].abs() + b[1].abs())));
            pairs.iter().map(|pair| with(pair)).collect()
        }
    }
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
        false => Err(document.error(&["near"], says::near_cannot_choose(number), None)),
    }
}

/// Where the text says how a drive stands, and what it is to say.
struct Stand {
    path: Vec<String>,
    value: f64,
    /// What may be added to it any number of times: a whole turn of an angle.
    turn: f64,
    /// Whether it stands otherwise now, but for whole turns.
    is_new: bool,
    decimals: Decimals,
}

impl Stand {
    /// What the text says of all drives, but for those that stand so already.
    fn all(scene: &Json, mechanism: &Mechanism, now: &Pose) -> Vec<Stand> {
        let is_driven = |id: &BodyId| matches!(mechanism.body(*id).role, Role::Driver { .. });
        let placing = mechanism.placing.iter().map(|placing| placing.link);
        let turned = mechanism.links().map(|(id, _)| id).filter(is_driven).chain(placing);
        let has_wheels = mechanism.has_wheels();
        let turned = turned.filter_map(|id| {
            Stand::turned(scene, &mechanism.body(id).name, degrees_of((*now.axes.get(id.0)?)?), has_wheels)
        });
        let pushed = mechanism.sliders.iter().enumerate().filter(|(_, slider)| slider.drive.is_some());
        let pushed =
            pushed.filter_map(|(id, slider)| Stand::pushed(scene, slider.given?, (*now.slides.get(id)?)?, now));
        turned.chain(pushed).collect()
    }

    /// A link at that angle, in degrees; where whole turns count, even if it stands so but for these.
    fn turned(scene: &Json, link: &str, degrees: f64, turns_count: bool) -> Option<Stand> {
        let path = turning(scene, link)?;
        let old = number_at(scene, &path)?;
        // People who write no negative angles get none.
        let value = match (turns_count, old >= 0.0) {
            (true, _) => with_turns(degrees, old),
            (false, true) => degrees.rem_euclid(360.0),
            (false, false) => degrees,
        };
        let is_new = (with_turns(degrees, old) - old).abs() > STANDS;
        (is_new || turns_count).then_some(Stand { path, value, turn: 360.0, is_new, decimals: ANGLE })
    }

    /// The slider of that index in the scene at that position.
    fn pushed(scene: &Json, index: usize, value: f64, now: &Pose) -> Option<Stand> {
        let path = position_of(scene, index)?;
        let size = span(now.points.iter().copied());
        let is_new = (value - number_at(scene, &path)?).abs() > STANDS * size;
        // About four digits.
        let decimals = Decimals::of_size(value.abs().clamp(0.1 * size, size));
        is_new.then_some(Stand { path, value, turn: 0.0, is_new, decimals })
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
