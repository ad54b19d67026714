//! What the words in a scene's text mean, by their place in it, and in which order people write keys: all that those who
//! change a text have to know of the keys. A new kind of joint says it here.

/// What a word in the text of a scene names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning<'p> {
    /// A point.
    Point,
    /// A link.
    Link,
    /// A point, or a link as `angle(3)`.
    PointOrAngle,
    /// Two points of this link, as `AB`.
    PairOfLink(&'p str),
    /// Two points of what carries the guide of the slider of this index.
    PairOfGuide(&'p str),
    /// A point or a part of the plans, or a point or a link.
    OfPlan,
    /// A quantity, as `omega(3)`.
    Quantity,
}

/// Lists at the top of a scene whose entries are joints: an entry goes with a link that it names.
pub(crate) const JOINTS: [&str; 1] = ["sliders"];

/// What a word names: a text at this path, or a key (`is_key`) of the object there; `None` where it is no name.
pub(crate) fn meaning<'p>(path: &[&'p str], is_key: bool) -> Option<Meaning<'p>> {
    Some(match (path, is_key) {
        (["ground" | "points" | "known"] | ["links", _, "shape"], true) => Meaning::Point,
        (["ground", _] | ["links", _, _] | ["links", _, "points", _], false) => Meaning::Point,
        (["links", _, "motion", "at"] | ["sliders", _, "at" | "pin" | "through"], false) => Meaning::Point,
        (["figure", "trace", _], false) => Meaning::Point,
        (["links"], true) | (["sliders", _, "link" | "on"], false) => Meaning::Link,
        (["near"], true) => Meaning::PointOrAngle,
        (["links", link, "lengths"], true) => Meaning::PairOfLink(link),
        (["sliders", index, "along"], false) => Meaning::PairOfGuide(index),
        (["figure", "labels"], true) => Meaning::OfPlan,
        (["want", _], false) => Meaning::Quantity,
        _ => return None,
    })
}

/// The keys of a scene, its links, drives and joints in the order in which people write them; of other objects none.
pub(crate) fn key_order(path: &[&str]) -> &'static [&'static str] {
    match path {
        [] => &[
            "$schema", "kinegon", "title", "units", "ground", "points", "known", "links", "sliders", "near", "figure",
            "want",
        ],
        ["links", _] => &["points", "lengths", "shape", "drive", "angle", "motion"],
        [.., "drive"] => &["angle", "omega", "rpm", "alpha", "position", "speed", "acceleration"],
        ["sliders", _] => &["link", "at", "pin", "on", "through", "along", "turned", "drive"],
        _ => &[],
    }
}
