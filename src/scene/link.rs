//! Links: their keys in the file and their checked form, with points, drive or motion, and shape: lengths, which are positive
//! and of which three form a triangle; or coordinates.

use std::collections::{HashMap, HashSet};

use indexmap::IndexMap;
use serde::Deserialize;

use super::error::{Wrong, number};
use super::given::{Drive, GivenBy, LinkDriveFile, LinkMotion, SliderDrive, first_given};
use super::loads::{LinkPlace, MassFields};
use super::name::{Bearer, check_list, check_name, checked_pair, joined, no_point};
use super::says;
use super::units::TimeUnit;
use super::value::{NamesOr, ShapePoint, several_forms};
use super::write::{write_forms, write_keys};

/// A rigid link. Its axis runs from its first to its second point.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "linkFields"))]
#[serde(deny_unknown_fields, expecting = "a link")]
pub(super) struct LinkFields {
    /// Names of its points.
    pub points: Option<Vec<String>>,
    /// Distances between its points, as { "AB": 100 } or { "A-B": 100 }: one for two points, three for three.
    pub lengths: Option<IndexMap<String, f64>>,
    /// Coordinates of its points in its own frame, whose x axis is the link's axis.
    pub shape: Option<IndexMap<String, ShapePoint>>,
    /// The drive that turns the link about its ground pivot.
    pub drive: Option<LinkDriveFile>,
    /// Angle of the link's axis from +x in degrees, in place of that of a drive: one link may give it where one drive does not.
    pub angle: Option<f64>,
    /// Known motion of the link, in a drawn configuration.
    pub motion: Option<LinkMotion>,
    /// Its mass, in the scene's unit of mass.
    pub mass: Option<f64>,
    /// Its weight, in the scene's unit of force, in place of its mass.
    pub weight: Option<f64>,
    /// Its moment of inertia about the centre of mass, in mass · length²; left out: zero.
    pub inertia: Option<f64>,
    /// Its centre of mass: a point, coordinates in the link's own frame (in a drawn configuration in the fixed frame), or a distance along its axis.
    pub center: Option<LinkPlace>,
}

write_keys!(LinkFields { points, shape, lengths, drive, angle, motion, mass, weight, inertia, center });

impl LinkFields {
    /// Its keys of a mass, which are then no longer there.
    fn take_masses(&mut self) -> MassFields {
        MassFields {
            mass: self.mass.take(),
            weight: self.weight.take(),
            inertia: self.inertia.take(),
            center: self.center.take(),
        }
    }
}

/// A link in the file: a list of points, or an object.
#[derive(Debug, Clone)]
pub(super) struct LinkFile(pub LinkFields);

write_forms! { LinkFile { LinkFile(fields) => fields } }

several_forms!(LinkFile, "link", NamesOr {
    expecting: r#"a link as { "points": ["A", "B"], … }, or a list of its points ["A", "B"]"#,
    names: |points| LinkFile(LinkFields { points: Some(points), ..LinkFields::default() }),
    other: LinkFile,
}, generator => {
    "anyOf": [
        generator.subschema_for::<LinkFields>(),
        { "type": "array", "items": { "type": "string" }, "description": "The link's points" },
    ]
});

/// A rigid link.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Names of its points, in file order; of a shape without a list of points in the order of the shape. Its axis runs
    /// from the first to the second, except with [`Shape::Local`].
    pub points: Vec<String>,
    /// The distances between its points; always [`Shape::Bare`] in a drawn configuration.
    pub shape: Shape,
    /// The drive that turns it, if any.
    pub drive: Option<Drive>,
    /// Angle of its axis from +x, in degrees, given in place of the angle of another link's drive. The angle of a link
    /// with a drive of its own is in the drive.
    pub angle_deg: Option<f64>,
    /// Its motion, if it is a body of given motion; only in a drawn configuration.
    pub motion: Option<LinkMotion>,
}

/// What is written in links and belongs elsewhere, by the name of the link.
#[derive(Debug, Default)]
pub(super) struct OfLinks {
    /// Drives along a guide, which belong to sliders.
    pub pushes: IndexMap<String, SliderDrive>,
    /// Masses, which belong to loads.
    pub masses: IndexMap<String, MassFields>,
}

/// The links, and what is written in them and belongs elsewhere.
pub(super) fn links(
    given_by: GivenBy,
    time: TimeUnit,
    file: IndexMap<String, LinkFile>,
) -> Result<(IndexMap<String, Link>, OfLinks), Wrong> {
    if file.is_empty() {
        return Err(Wrong::value(&["links"], says::no_links()));
    }
    let mut links = IndexMap::with_capacity(file.len());
    let mut others = OfLinks::default();
    for (name, LinkFile(mut fields)) in file {
        let masses = fields.take_masses();
        if !masses.is_empty() {
            others.masses.insert(name.clone(), masses);
        }
        let read = check_name(Bearer::Link, &name).and_then(|()| link(given_by, time, &name, fields));
        let (link, push) = read.map_err(|wrong| wrong.inside(&["links", &name]))?;
        if let Some(push) = push {
            others.pushes.insert(name.clone(), push);
        }
        links.insert(name, link);
    }
    Ok((links, others))
}

/// A link, and the drive in it that belongs to its slider.
fn link(
    given_by: GivenBy,
    time: TimeUnit,
    name: &str,
    fields: LinkFields,
) -> Result<(Link, Option<SliderDrive>), Wrong> {
    check_given_by(given_by, name, &fields)?;
    let points = points(name, &fields)?;
    let shape = match (fields.shape, fields.lengths) {
        (Some(_), Some(_)) => {
            return Err(Wrong::key(&["lengths"], says::lengths_and_shape(name)).hint(says::keep_one()));
        }
        (Some(shape), None) => local(name, &points, shape)?,
        (None, given) if given_by == GivenBy::Lengths => lengths(name, &points, given.unwrap_or_default())?,
        (None, _) => Shape::Bare,
    };
    if fields.drive.is_some() && fields.motion.is_some() {
        return Err(Wrong::key(&["drive"], says::drive_and_motion(name)).hint(says::keep_one()));
    }
    let read = fields.drive.map(|drive| drive.read(time, name)).transpose();
    let (mut drive, push) = read.map_err(|wrong| wrong.inside(&["drive"]))?.unwrap_or_default();
    let mut angle_deg = fields.angle;
    if let Some(drive) = &mut drive {
        if angle_deg.is_some() && drive.angle_deg.is_some() {
            return Err(Wrong::value(&["angle"], says::two_angles(name)).hint(says::keep_one()));
        }
        drive.angle_deg = drive.angle_deg.or(angle_deg.take());
    }
    Ok((Link { points, shape, drive, angle_deg, motion: fields.motion }, push))
}

/// Refuses keys of lengths in a drawing, and keys of a drawing in a scene given by lengths.
fn check_given_by(given_by: GivenBy, name: &str, fields: &LinkFields) -> Result<(), Wrong> {
    if given_by == GivenBy::Lengths {
        if fields.motion.is_some() {
            let message = says::link_motion_is_drawn(name);
            return Err(Wrong::key(&["motion"], message).hint(says::points_or_drive_link()));
        }
        return Ok(());
    }
    let given =
        [("lengths", fields.lengths.is_some()), ("shape", fields.shape.is_some()), ("angle", fields.angle.is_some())];
    if let Some(key) = first_given(&given) {
        return Err(Wrong::key(&[key], says::link_is_drawn(name, key)).hint(says::remove_or_lengths(key)));
    }
    let check = |drive: &LinkDriveFile| drive.check_given_by(given_by, name);
    fields.drive.as_ref().map_or(Ok(()), check).map_err(|wrong| wrong.inside(&["drive"]))
}

/// The names of a link's points: those of `points`, else of `shape`.
fn points(name: &str, fields: &LinkFields) -> Result<Vec<String>, Wrong> {
    let shape = fields.shape.as_ref().map(IndexMap::keys);
    for point in shape.clone().into_iter().flatten() {
        check_name(Bearer::Point, point).map_err(|wrong| wrong.inside(&["shape", point]))?;
    }
    let Some(points) = &fields.points else {
        return match (shape, &fields.motion) {
            (Some(shape), _) => Ok(shape.cloned().collect()),
            (None, Some(_)) => Ok(Vec::new()),
            (None, None) => Err(Wrong::value(&[], says::no_points(name)).hint(says::add(r#""points": ["A", "B"]"#))),
        };
    };
    check_list(points, Some(name)).map_err(|wrong| wrong.inside(&["points"]))?;
    Ok(points.clone())
}

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
        let hint = says::give_shape(&points[0], &points[1]);
        return Err(Wrong::value(&[], says::too_many_points(link, points.len())).hint(hint));
    }
    let mut lengths: Vec<Length> = Vec::with_capacity(given.len());
    for (key, value) in given {
        let length = length(link, points, &lengths, key.clone(), value);
        lengths.push(length.map_err(|wrong| wrong.inside(&["lengths", &key]))?);
    }
    if let Some((from, to)) = missing(points, &lengths) {
        let key = joined(from, to);
        let message = match points.len() {
            2 => says::no_distance(link, from, to),
            _ => says::three_lengths(link, from, to),
        };
        let hint = match lengths.is_empty() {
            true => says::add_lengths(key),
            false => says::add_to_lengths(key),
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
    let (from, to) = checked_pair(says::lengths_key, &key, &says::link_named(link), points, is_point)?;
    if let Some(first) = before.iter().find(|other| other.joins(&from, &to)) {
        let message = says::length_twice(&key, link, &first.key);
        return Err(Wrong::key(&[], message).hint(says::keep_one()));
    }
    if value == 0.0 {
        return Err(Wrong::value(&[], says::length_zero(&key, &from, &to)).hint(says::one_name_or_length()));
    }
    if value < 0.0 {
        return Err(Wrong::value(&[], says::length_negative(&key, number(value))));
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
    Err(Wrong::value(&["lengths"], says::no_triangle(link, shown, one, other, long)))
}

/// The shape of a link: coordinates of each of its points, no two the same.
pub(super) fn local(link: &str, points: &[String], given: IndexMap<String, ShapePoint>) -> Result<Shape, Wrong> {
    if given.is_empty() {
        return Err(Wrong::value(&["shape"], says::shape_empty(link)));
    }
    let listed: HashSet<&String> = points.iter().collect();
    if let Some(point) = given.keys().find(|point| !listed.contains(point)) {
        let message = no_point(says::link_named(link), point, points);
        return Err(Wrong::key(&["shape", point], message).hint(says::add_or_without_points()));
    }
    let places: IndexMap<String, [f64; 2]> = given.into_iter().map(|(point, place)| (point, place.0)).collect();
    if let Some(point) = points.iter().find(|point| !places.contains_key(*point)) {
        return Err(Wrong::value(&["shape"], says::shape_lacks(link, point)).hint(says::add_place(point)));
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
            let message = says::zero_length(link, first, second);
            return Err((second, Wrong::value(&[], message).hint(says::one_name_or_move())));
        }
    }
    Ok(())
}
