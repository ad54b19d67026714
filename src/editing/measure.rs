//! Numbers with few digits, and the lengths and shapes of links that are measured from places.

use serde_json::{Map, Number, Value as Json};

use super::document::Document;
use super::says;
use crate::geometry::{Point, cross, unit};
use crate::scene::{SceneError, joined};

/// A number of decimals: −1 for tens.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Decimals(pub i32);

impl Decimals {
    /// Of angles in degrees that follow from places.
    pub const ANGLE: Decimals = Decimals(2);

    /// Of places on a mechanism of that size, in its unit of length: steps of a thousandth of the size, or finer by less
    /// than ten times.
    pub fn of_size(size: f64) -> Decimals {
        let is_sound = size > 0.0 && size.is_finite();
        Decimals(if is_sound { -libm::floor(libm::log10(size) - 3.0) as i32 } else { 1 })
    }

    /// So many decimals more.
    pub fn finer(self, by: i32) -> Decimals {
        Decimals(self.0 + by)
    }

    /// The distance of two neighbouring numbers.
    pub fn step(self) -> f64 {
        libm::exp10(f64::from(-self.0))
    }

    /// The nearest number with so many decimals, as reading its digits gives it.
    pub fn round(self, x: f64) -> f64 {
        let steps = libm::round(x / self.step());
        // Beyond that a number has no more digits than it has.
        if !steps.is_finite() || steps.abs() > 1e15 {
            return x;
        }
        format!("{steps}e{}", -self.0).parse().unwrap_or(x) + 0.0
    }

    /// The rounded number as JSON.
    pub fn json(self, x: f64) -> Json {
        json(self.round(x))
    }

    /// A rounded place.
    pub fn place(self, place: Point) -> Point {
        Point::new(self.round(place.x), self.round(place.y))
    }

    /// A rounded place as JSON.
    pub fn place_json(self, place: Point) -> Json {
        Json::Array(vec![self.json(place.x), self.json(place.y)])
    }
}

/// A number as JSON, a whole one without decimals.
pub fn json(x: f64) -> Json {
    match x == libm::trunc(x) && x.abs() < 1e15 {
        true => Json::from(x as i64),
        false => Number::from_f64(x).map_or(Json::Null, Json::Number),
    }
}

/// Height of a triangle, in parts of its longest side, below which rounded lengths would hardly say where its points are.
const FLAT: f64 = 0.05;

/// A point of a link and its place.
pub(super) type Placed<'a> = (&'a str, Point);

/// The lengths of a link of up to three points, or its shape where lengths do not fix it well: the key, and what stands
/// there; `None` for a link of one point.
///
/// # Errors
/// Two points are in one place.
pub(super) fn measured(
    document: &Document<'_>,
    link: &str,
    points: &[Placed<'_>],
    decimals: Decimals,
) -> Result<Option<(&'static str, Json)>, SceneError> {
    for (index, (second, place)) in points.iter().enumerate() {
        let is_there = |(_, other): &&Placed<'_>| (place - other).norm() < decimals.step();
        if let Some((first, _)) = points[..index].iter().find(is_there) {
            let message = says::in_one_place(link, *first, *second);
            return Err(document.error(&["links", link], message, Some(says::one_name_or_move())));
        }
    }
    Ok(match points {
        [] | [_] => None,
        [a, b] => Some(("lengths", lengths(&[(a, b)], decimals))),
        // A decimal more: where three lengths meet in a low triangle, they are that much less sure of its point.
        [a, b, c] if !is_flat([a.1, b.1, c.1]) => {
            Some(("lengths", lengths(&[(a, b), (b, c), (a, c)], decimals.finer(1))))
        }
        _ => Some(("shape", shape(points, decimals))),
    })
}

fn lengths(pairs: &[(&Placed<'_>, &Placed<'_>)], decimals: Decimals) -> Json {
    let length = |(a, b): &(&Placed<'_>, &Placed<'_>)| (joined(a.0, b.0), decimals.json((b.1 - a.1).norm()));
    Json::Object(pairs.iter().map(length).collect())
}

/// Coordinates in the frame whose origin is the first point and whose x axis goes to the second.
pub(super) fn shape(points: &[Placed<'_>], decimals: Decimals) -> Json {
    let (origin, second) = (points[0].1, points[1].1);
    let axis = unit(second - origin).unwrap_or_else(crate::geometry::Vector::x);
    let local = |(name, place): &Placed<'_>| {
        let arm = place - origin;
        let place = decimals.place(Point::new(axis.dot(&arm), cross(axis, arm)));
        ((*name).to_owned(), shape_place(place))
    };
    Json::Object(points.iter().map(local).collect::<Map<_, _>>())
}

/// A place of a shape: one number on the axis, else two.
pub(super) fn shape_place(place: Point) -> Json {
    if place.y == 0.0 { json(place.x) } else { Json::Array(vec![json(place.x), json(place.y)]) }
}

/// Whether three points lie nearly on a line.
fn is_flat([a, b, c]: [Point; 3]) -> bool {
    let longest = [b - a, c - b, a - c].map(|side| side.norm()).into_iter().fold(0.0, f64::max);
    cross(b - a, c - a).abs() < FLAT * longest * longest
}
