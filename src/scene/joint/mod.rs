//! The joints that a scene lists, a file for each kind: its keys in the file, its checked form, the checks, and what its
//! words name, which is all that editing has to know of it. Pins are no kind: they follow from points that links share.

mod contact;
mod gear;
mod slider;

pub use contact::{Contact, Equivalent};
pub(super) use contact::{ContactFile, contacts, faces};
pub use gear::{Belt, Gear, RackOf};
pub(super) use gear::{GearFile, gears};
pub use slider::{Along, On, Slider};
pub(super) use slider::{SliderFile, sliders};

use super::error::nearest;
use super::says;
use crate::message::Message;
use serde_json::Value as Json;

/// The kinds of joints that a scene lists.
pub(crate) const JOINTS: [&JointKind; 3] = [&slider::SLIDERS, &gear::GEARS, &contact::CONTACTS];

/// A kind of joint as the text of a scene has it.
pub(crate) struct JointKind {
    /// The key of the list of such joints, at the top of a scene.
    pub list: &'static str,
    /// The keys of a joint in the order in which people write them, and what the words behind them name.
    pub keys: &'static [(&'static str, Option<Meaning>)],
}

impl JointKind {
    /// The kind whose joints stand in this list.
    pub fn of_list(list: &str) -> Option<&'static JointKind> {
        JOINTS.into_iter().find(|kind| kind.list == list)
    }

    /// The words of a joint's entry that name such a thing.
    pub fn words<'j>(&self, entry: &'j Json, meaning: Meaning) -> impl Iterator<Item = &'j str> {
        let values = self.keys.iter().filter(move |(_, own)| *own == Some(meaning)).map(|(key, _)| &entry[*key]);
        values
            .flat_map(|value| value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice))
            .filter_map(Json::as_str)
    }
}

/// What a word in the text of a scene names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    /// A point.
    Point,
    /// A point of a guide, which can be given in another way.
    PointOfGuide,
    /// A link.
    Link,
    /// A point, or a link as `angle(3)`.
    PointOrAngle,
    /// Two points of the link that the path names, as `AB`.
    PairOfLink,
    /// Two points of what carries the guide of the slider that the path names.
    PairOfGuide,
    /// A point or a part of the plans, or a point or a link.
    OfPlan,
    /// A quantity, as `omega(3)`.
    Quantity,
}

/// What a word names: a text at this path, or a key (`is_key`) of the object there; `None` where it is no name.
pub(crate) fn meaning(path: &[&str], is_key: bool) -> Option<Meaning> {
    Some(match (path, is_key) {
        (["ground" | "points" | "known"] | ["links", _, "shape"], true) => Meaning::Point,
        (["ground", _] | ["links", _, _] | ["links", _, "points", _], false) => Meaning::Point,
        (["links", _, "motion", "at"] | ["figure", "trace" | "velocities" | "curvature", _], false) => Meaning::Point,
        (["forces", _, "at"] | ["springs", _, "between", _, "1"] | ["friction", _, "pin"], false) => Meaning::Point,
        (["forces", _, "on"] | ["springs", _, "between", _, "0"] | ["friction", _, "fixed_in"], false) => Meaning::Link,
        (["figure", "centrodes" | "inflection", _], false) => Meaning::Link,
        (["links"], true) => Meaning::Link,
        (["near"], true) => Meaning::PointOrAngle,
        (["links", _, "lengths"], true) => Meaning::PairOfLink,
        (["figure", "labels"], true) | (["friction", _, "guide"], false) => Meaning::OfPlan,
        (["want", _] | ["figure", "centers", _] | ["forces", _, "over", "of"], false) | (["form"], true) => {
            Meaning::Quantity
        }
        ([list, _, key] | [list, _, key, _], false) => {
            return JointKind::of_list(list)?.keys.iter().find(|(own, _)| own == key)?.1;
        }
        _ => return None,
    })
}

/// The keys of a scene, its links, drives and joints in the order in which people write them; of other objects none.
pub(crate) fn key_order(path: &[&str]) -> Vec<&'static str> {
    match path {
        [] => {
            let before = ["$schema", "kinegon", "title", "units", "ground", "points", "known", "links"];
            let after = ["gravity", "forces", "springs", "friction", "analysis", "near", "figure", "want", "form"];
            before.into_iter().chain(JOINTS.map(|kind| kind.list)).chain(after).collect()
        }
        ["links", _] => {
            vec!["points", "lengths", "shape", "drive", "angle", "motion", "mass", "weight", "inertia", "center"]
        }
        ["forces", _] => vec!["name", "on", "at", "force", "couple", "turns", "over"],
        ["forces", _, "over"] => vec!["of", "table"],
        ["springs", _] => vec!["name", "between", "rate", "length"],
        ["friction", _] => vec!["pin", "guide", "coefficient", "angle", "radius", "fixed_in"],
        [.., "drive"] => vec!["angle", "omega", "rpm", "alpha", "position", "speed", "acceleration"],
        [list, _] => {
            JointKind::of_list(list).map_or(Vec::new(), |kind| kind.keys.iter().map(|(key, _)| *key).collect())
        }
        _ => Vec::new(),
    }
}

/// Keys of what moves otherwise than by pins and straight sliders.
const OTHER_JOINTS: [&str; 13] = [
    "pinion", "rack", "racks", "belt", "belts", "pulley", "pulleys", "chain", "chains", "cam", "cams", "follower",
    "geneva",
];

/// Keys of what moves a mechanism.
const FORCES: [&str; 13] = [
    "force", "forces", "load", "loads", "torque", "torques", "mass", "masses", "inertia", "spring", "springs",
    "damper", "dampers",
];

/// The hint for a key of something that scenes do not have.
pub(super) fn out_of_scope(word: &str) -> Option<Message> {
    let word = word.to_lowercase();
    let is_joint = || nearest(&word, JOINTS.map(|kind| kind.list)).is_some();
    match word.as_str() {
        other if OTHER_JOINTS.contains(&other) && !is_joint() => Some(says::joints_out_of_scope()),
        other if FORCES.contains(&other) => Some(says::forces_out_of_scope()),
        _ => None,
    }
}
