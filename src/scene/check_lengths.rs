//! Lengths and shapes of links: each names points of its link, is positive, and the lengths of a triangle close.

use std::collections::{HashMap, HashSet};

use indexmap::IndexMap;

use super::error::SceneError;
use super::forms::ShapePoint;
use super::link::{Length, Shape};
use super::names::{no_point, pair};
use super::place::{Source, Spot};
use super::words::number;

/// How far, relative to the longest, three lengths may miss adding up and still be a straight link: the rounding of
/// decimal lengths, with room for a few operations.
const STRAIGHT: f64 = 1e-12;

/// The lengths of a link, as many as its points need.
pub(super) fn lengths(
    source: Source<'_>,
    name: &str,
    points: &[String],
    given: Option<IndexMap<String, f64>>,
) -> Result<Shape, SceneError> {
    let given = given.unwrap_or_default();
    if points.len() > 3 {
        let message = format!("link {name} has {} points, which lengths do not fix", points.len());
        let example = points.iter().take(2).map(|point| format!("\"{point}\": [x, y]")).collect::<Vec<_>>().join(", ");
        let hint = format!("give coordinates in the link's own frame: \"shape\": {{ {example}, … }}");
        return Err(source.error(&["links", name], message).hint(hint));
    }
    let mut lengths: Vec<Length> = Vec::with_capacity(given.len());
    for (key, value) in given {
        let path = ["links", name, "lengths", &key];
        let (from, to) = pair(&key, |point| points.iter().any(|other| other == point)).map_err(|wrong| {
            let (message, hint) = wrong.explain("lengths key", &key, &format!("link {name}"), points);
            source.error_with(&path, Spot::Key, message, hint)
        })?;
        let same = |other: &&Length| (other.from == from && other.to == to) || (other.from == to && other.to == from);
        if let Some(first) = lengths.iter().find(same) {
            let message = format!("the length {key} of link {name} is given already, as {}", first.key);
            return Err(source.key_error(&path, message).hint("keep one of them"));
        }
        if value == 0.0 {
            let message = format!("length {key} is 0: {from} and {to} would be one point");
            return Err(source.error(&path, message).hint("use one name for both, or give a positive length"));
        }
        if value < 0.0 {
            return Err(source.error(&path, format!("length {key} is {}; a length is positive", number(value))));
        }
        lengths.push(Length { from, to, value, key });
    }
    if let Some((from, to)) = missing(points, &lengths) {
        let key =
            if from.chars().count() + to.chars().count() == 2 { format!("{from}{to}") } else { format!("{from}-{to}") };
        let message = match points.len() {
            2 => format!("link {name} has the points {from} and {to}, but not their distance"),
            _ => format!("link {name} has three points, which need three lengths; that of {from} and {to} is missing"),
        };
        let hint = format!("add \"lengths\": {{ \"{key}\": … }}, or give a `shape`");
        let hint = if lengths.is_empty() { hint } else { format!("add \"{key}\": … to its lengths") };
        return Err(source.error(&["links", name], message).hint(hint));
    }
    if let [a, b, c] = &lengths[..] {
        check_triangle(source, name, [a, b, c])?;
    }
    Ok(if lengths.is_empty() { Shape::Bare } else { Shape::Lengths(lengths) })
}

/// The first two points of a link whose distance is needed and not given.
fn missing<'a>(points: &'a [String], lengths: &[Length]) -> Option<(&'a str, &'a str)> {
    let pairs = match points {
        [a, b] => vec![(a, b)],
        [a, b, c] => vec![(a, b), (b, c), (a, c)],
        _ => Vec::new(),
    };
    let given = |a: &str, b: &str| {
        lengths.iter().any(|length| (length.from == a && length.to == b) || (length.from == b && length.to == a))
    };
    pairs.into_iter().find(|(a, b)| !given(a, b)).map(|(a, b)| (a.as_str(), b.as_str()))
}

fn check_triangle(source: Source<'_>, name: &str, sides: [&Length; 3]) -> Result<(), SceneError> {
    let [a, b, c] = sides.map(|side| side.value);
    let (long, one, other) = match (a >= b && a >= c, b >= c) {
        (true, _) => (a, b, c),
        (false, true) => (b, a, c),
        (false, false) => (c, a, b),
    };
    // Differences first: a sum could overflow.
    if long - one - other <= STRAIGHT * long {
        return Ok(());
    }
    let shown = sides.map(|side| format!("{} {}", side.key, number(side.value))).join(", ");
    let message = format!(
        "link {name}: lengths {shown} cannot form a triangle: {} + {} < {}",
        number(one),
        number(other),
        number(long)
    );
    Err(source.error(&["links", name, "lengths"], message))
}

/// The shape of a link: one place for each of its points, no two the same.
pub(super) fn local(
    source: Source<'_>,
    name: &str,
    points: &[String],
    given: IndexMap<String, ShapePoint>,
) -> Result<Shape, SceneError> {
    fn path<'a>(name: &'a str, point: &'a str) -> [&'a str; 4] {
        ["links", name, "shape", point]
    }
    if given.is_empty() {
        return Err(source.error(&["links", name, "shape"], format!("the shape of link {name} has no points")));
    }
    let listed: HashSet<&String> = points.iter().collect();
    for point in given.keys() {
        if !listed.contains(point) {
            let message = no_point(&format!("link {name}"), point, points);
            return Err(source
                .key_error(&path(name, point), message)
                .hint("add it to `points`, or leave `points` out"));
        }
    }
    if let Some(point) = points.iter().find(|point| !given.contains_key(*point)) {
        let message = format!("the shape of link {name} does not say where {point} is");
        return Err(source.error(&["links", name, "shape"], message).hint(format!("add \"{point}\": [x, y]")));
    }
    let places: IndexMap<String, [f64; 2]> = given.into_iter().map(|(point, place)| (point, place.0)).collect();
    if let Some((first, second)) = coincident(places.iter().map(|(point, place)| (point.as_str(), *place))) {
        let message = format!("link {name} has {first} and {second} in one place: a zero-length link");
        return Err(source.error(&path(name, second), message).hint("use one name for both, or move one"));
    }
    Ok(Shape::Local(places))
}

/// The first two of the points that are in exactly the same place.
pub(super) fn coincident<'a>(points: impl Iterator<Item = (&'a str, [f64; 2])>) -> Option<(&'a str, &'a str)> {
    let mut seen: HashMap<[u64; 2], &str> = HashMap::new();
    for (name, place) in points {
        // Adding zero makes a negative zero a positive one.
        let key = place.map(|coordinate| (coordinate + 0.0).to_bits());
        if let Some(first) = seen.insert(key, name) {
            return Some((first, name));
        }
    }
    None
}
