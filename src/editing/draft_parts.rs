//! What a text says of wheels, of profiles that touch and of loads, as far as their places are known.

use serde_json::Value as Json;

use super::draft::{DraftCircle, DraftLoad, Sketch};
use super::present::two_numbers;
use crate::geometry::{Point, Turn, Vector, direction_of_degrees};
use crate::scene::LoadNames;

/// The radius of the larger of two wheels with a belt whose size is not given, in parts of the distance of their centres, as in figures.
const LARGER_WHEEL: f64 = 0.3;

/// Largest radius that is drawn, in parts of the size of the mechanism: others are nearly straight.
const LARGEST_RADIUS: f64 = 3.0;

impl Sketch {
    /// Pitch circles of wheels, and circles of curvature of profiles that touch.
    pub(super) fn circles(&self) -> Vec<DraftCircle> {
        let entries = |list: &str| self.scene[list].as_array().map_or(&[][..], Vec::as_slice);
        let wheels = entries("gears").iter().flat_map(|gear| self.wheels(gear));
        let profiles = entries("contacts").iter().flat_map(|contact| self.profiles(contact));
        let largest = LARGEST_RADIUS * self.present.size([]);
        wheels.chain(profiles).filter(|circle| circle.radius > 0.0 && circle.radius <= largest).collect()
    }

    /// The point about which a wheel turns on its carrier.
    fn center(&self, gear: &Json, wheel: usize) -> Option<Point> {
        let carrier = self.names.of_carrier(gear["on"].as_str()?);
        let points = self.names.of_carrier(gear["mesh"][wheel].as_str()?);
        self.place(points.iter().find(|point| carrier.contains(point))?)
    }

    fn wheels(&self, gear: &Json) -> Vec<DraftCircle> {
        let teeth = [0, 1].map(|wheel| gear["teeth"][wheel].as_f64());
        let circle = |wheel: usize, radius: f64| Some(DraftCircle { at: self.center(gear, wheel)?, radius });
        let [Some(first), Some(second)] = teeth else {
            // On a rack.
            let wheel = usize::from(teeth[0].is_none());
            return gear["radius"].as_f64().and_then(|radius| circle(wheel, radius)).into_iter().collect();
        };
        let Some((one, other)) = self.center(gear, 0).zip(self.center(gear, 1)) else { return Vec::new() };
        let apart = (other - one).norm();
        let radii = if gear["belt"].is_string() {
            let unit =
                gear["radius"].as_f64().map_or(LARGER_WHEEL * apart / first.max(second), |radius| radius / first);
            [first * unit, second * unit]
        } else {
            [first, second].map(|teeth| (apart * teeth / (first + second)).abs())
        };
        let all = [0, 1].map(|wheel| circle(wheel, radii[wheel]));
        all.into_iter().flatten().filter(|circle| circle.radius.is_finite()).collect()
    }

    fn profiles(&self, contact: &Json) -> Vec<DraftCircle> {
        let circle = |which: usize| {
            let at = self.place(contact["centers"][which].as_str()?)?;
            Some(DraftCircle { at, radius: contact["radii"][which].as_f64()?.abs() })
        };
        [0, 1].into_iter().filter_map(circle).collect()
    }

    /// Forces and couples, in the order of the text.
    pub(super) fn loads(&self) -> Vec<DraftLoad> {
        let listed = |key: &str| self.scene[key].as_array().into_iter().flatten();
        let given = listed("forces").chain(listed("springs")).filter_map(|load| load["name"].as_str());
        let mut usual = LoadNames::new(given.map(str::to_owned));
        let loads = listed("forces").filter_map(|load| {
            let counted = (!load["force"].is_null()).then(|| usual.force());
            let name = load["name"].as_str().map(str::to_owned).or(counted);
            let name = name.unwrap_or_else(|| usual.couple(load["on"].as_str().unwrap_or_default()));
            self.load(load, name)
        });
        loads.collect()
    }

    fn load(&self, load: &Json, name: String) -> Option<DraftLoad> {
        let on = load["on"].as_str()?;
        let force = vector(&load["force"]).unwrap_or_default();
        let force = if load["turns"] == true { self.own(on)? * force } else { force };
        Some(DraftLoad {
            name,
            at: self.place_on(on, &load["at"])?,
            force,
            couple: load["couple"].as_f64().unwrap_or(0.0),
        })
    }

    /// The turn of a link's own axis.
    fn own(&self, link: &str) -> Option<Turn> {
        let axis = self.axis(link)?;
        Some(Turn::from_cos_sin_unchecked(axis.x, axis.y))
    }

    /// A place of a link, as loads have it; where none is given, its middle.
    fn place_on(&self, link: &str, at: &Json) -> Option<Point> {
        let points = self.names.of_carrier(link);
        let local = match at {
            Json::String(point) => return self.place(point),
            Json::Null => {
                let known: Vec<Point> = points.iter().filter_map(|point| self.place(point)).collect();
                let sum = known.iter().fold(Vector::zeros(), |sum, place| sum + place.coords);
                return (!known.is_empty()).then(|| Point::from(sum / known.len() as f64));
            }
            Json::Array(_) if self.names.drawn.is_some() => return two_numbers(at),
            Json::Array(_) => two_numbers(at)?,
            _ => Point::new(at.as_f64()?, 0.0),
        };
        if let Some(shape) = self.scene["links"][link]["shape"].as_object() {
            return Some(self.present.placement(link, shape)? * local);
        }
        Some(self.place(points.first()?)? + self.own(link)? * local.coords)
    }
}

/// Two components, or size and angle.
fn vector(value: &Json) -> Option<Vector> {
    if let Some(place) = two_numbers(value) {
        return Some(place.coords);
    }
    Some(direction_of_degrees(value["angle"].as_f64()?) * value["size"].as_f64()?)
}
