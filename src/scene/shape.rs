//! Shapes of links: lengths, which are positive and of which three form a triangle; or coordinates.

use std::collections::{HashMap, HashSet};

use indexmap::IndexMap;

use super::error::Wrong;
use super::name::{checked_pair, joined, no_point};
use super::value::ShapePoint;
use super::words::number;

/// Relative tolerance of three lengths that add up, in parts of the longest: within it the link is straight. It covers
/// the rounding of decimal lengths, with room for a few operations.
pub(crate) const STRAIGHT: f64 = 1e-12;

/// The distances between the points of a link.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Not needed: no point, one point, or a drawn configuration.
    Bare,
    /// Distances: one for two points, three for three points. The triangle closes or is straight.
    Lengths(Vec<Length>),
    /// Coordinates of every point in the link's own frame, whose x axis is the link's axis.
    Local(IndexMap<String, [f64; 2]>),
}

/// The distance between two points of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Length {
    /// Name of the first point.
    pub from: String,
    /// Name of the second point.
    pub to: String,
    /// The distance, positive, in units of length.
    pub value: f64,
    /// The key as written in the file: `AB` or `A-B`.
    pub key: String,
}

impl Length {
    /// Whether it is the distance of these two points.
    pub(crate) fn joins(&self, a: &str, b: &str) -> bool {
        (self.from == a && self.to == b) || (self.from == b && self.to == a)
    }
}

/// The lengths of a link: none for up to one point, one for two, three for three.
pub(super) fn lengths(link: &str, points: &[String], given: IndexMap<String, f64>) -> Result<Shape, Wrong> {
    if points.len() > 3 {
        let message = format!("link {link} has {} points, which lengths do not fix", points.len());
        let hint = format!(
            "give coordinates in the link's own frame: \"shape\": {{ \"{}\": [x, y], \"{}\": [x, y], … }}",
            points[0], points[1]
        );
        return Err(Wrong::value(&[], message).hint(hint));
    }
    let mut lengths: Vec<Length> = Vec::with_capacity(given.len());
    for (key, value) in given {
        let length = length(link, points, &lengths, key.clone(), value);
        lengths.push(length.map_err(|wrong| wrong.inside(&["lengths", &key]))?);
    }
    if let Some((from, to)) = missing(points, &lengths) {
        let key = joined(from, to);
        let message = match points.len() {
            2 => format!("link {link} has the points {from} and {to}, but not their distance"),
            _ => format!("link {link} has three points, which need three lengths; that of {from} and {to} is missing"),
        };
        let hint = match lengths.is_empty() {
            true => format!("add \"lengths\": {{ \"{key}\": … }}, or give a `shape`"),
            false => format!("add \"{key}\": … to its lengths"),
        };
        return Err(Wrong::value(&[], message).hint(hint));
    }
    if let [a, b, c] = &lengths[..] {
        check_triangle(link, [a, b, c])?;
    }
    Ok(if lengths.is_empty() { Shape::Bare } else { Shape::Lengths(lengths) })
}

/// One length of a link; `before` are those before it.
fn length(link: &str, points: &[String], before: &[Length], key: String, value: f64) -> Result<Length, Wrong> {
    let is_point = |point: &str| points.iter().any(|other| other == point);
    let (from, to) = checked_pair("lengths key", &key, &format!("link {link}"), points, is_point)?;
    if let Some(first) = before.iter().find(|other| other.joins(&from, &to)) {
        let message = format!("the length {key} of link {link} is given already, as {}", first.key);
        return Err(Wrong::key(&[], message).hint("keep one of them"));
    }
    if value == 0.0 {
        let message = format!("length {key} is 0: {from} and {to} would be one point");
        return Err(Wrong::value(&[], message).hint("use one name for both, or give a positive length"));
    }
    if value < 0.0 {
        return Err(Wrong::value(&[], format!("length {key} is {}; a length is positive", number(value))));
    }
    Ok(Length { from, to, value, key })
}

/// The first two points of a link whose distance is needed and not given.
fn missing<'a>(points: &'a [String], lengths: &[Length]) -> Option<(&'a str, &'a str)> {
    let pairs = match points {
        [a, b] => vec![(a, b)],
        [a, b, c] => vec![(a, b), (b, c), (a, c)],
        _ => Vec::new(),
    };
    let mut missing = pairs.into_iter().filter(|(a, b)| !lengths.iter().any(|length| length.joins(a, b)));
    missing.next().map(|(a, b)| (a.as_str(), b.as_str()))
}

fn check_triangle(link: &str, sides: [&Length; 3]) -> Result<(), Wrong> {
    let [a, b, c] = sides.map(|side| side.value);
    let (long, one, other) = match (a >= b && a >= c, b >= c) {
        (true, _) => (a, b, c),
        (false, true) => (b, a, c),
        (false, false) => (c, a, b),
    };
    // A difference, as the sum of two lengths could overflow.
    if long - one - other <= STRAIGHT * long {
        return Ok(());
    }
    let shown = sides.map(|side| format!("{} {}", side.key, number(side.value))).join(", ");
    let [long, one, other] = [long, one, other].map(number);
    let message = format!("link {link}: lengths {shown} cannot form a triangle: {one} + {other} < {long}");
    Err(Wrong::value(&["lengths"], message))
}

/// The shape of a link: coordinates of each of its points, no two the same.
pub(super) fn local(link: &str, points: &[String], given: IndexMap<String, ShapePoint>) -> Result<Shape, Wrong> {
    if given.is_empty() {
        return Err(Wrong::value(&["shape"], format!("the shape of link {link} has no points")));
    }
    let listed: HashSet<&String> = points.iter().collect();
    if let Some(point) = given.keys().find(|point| !listed.contains(point)) {
        let message = no_point(&format!("link {link}"), point, points);
        return Err(Wrong::key(&["shape", point], message).hint("add it to `points`, or leave `points` out"));
    }
    let places: IndexMap<String, [f64; 2]> = given.into_iter().map(|(point, place)| (point, place.0)).collect();
    if let Some(point) = points.iter().find(|point| !places.contains_key(*point)) {
        let message = format!("the shape of link {link} does not say where {point} is");
        return Err(Wrong::value(&["shape"], message).hint(format!("add \"{point}\": [x, y]")));
    }
    check_apart(link, places.iter().map(|(point, place)| (point.as_str(), *place)))
        .map_err(|(second, wrong)| wrong.inside(&["shape", second]))?;
    Ok(Shape::Local(places))
}

/// An error at the first of a link's points that coincides with an earlier one.
pub(super) fn check_apart<'a>(
    link: &str,
    points: impl Iterator<Item = (&'a str, [f64; 2])>,
) -> Result<(), (&'a str, Wrong)> {
    let mut seen: HashMap<[u64; 2], &str> = HashMap::new();
    for (second, place) in points {
        // Adding zero turns a negative zero into a positive one, which has other bits.
        let key = place.map(|coordinate| (coordinate + 0.0).to_bits());
        if let Some(first) = seen.insert(key, second) {
            let message = format!("link {link} has {first} and {second} in one place: a zero-length link");
            return Err((second, Wrong::value(&[], message).hint("use one name for both, or move one")));
        }
    }
    Ok(())
}
