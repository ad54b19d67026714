//! Guides: what carries them, where they pass and which way they go.

use crate::scene::error::Wrong;
use crate::scene::given::GivenBy;
use crate::scene::link::Link;
use crate::scene::name::{checked_pair, no_point};
use crate::scene::names::Names;
use crate::scene::points::Coordinates;
use crate::scene::shape::Shape;
use crate::scene::value::{At, Direction};

/// The carrier of a guide.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum On {
    /// The frame.
    Ground,
    /// The link of this name.
    Link(String),
}

/// The direction of a guide.
#[derive(Debug, Clone, PartialEq)]
pub enum Along {
    /// From the first to the second of two points of the guide's carrier.
    Points(String, String),
    /// An angle in degrees, from +x on the ground, else from the axis of the carrier; zero by default.
    Degrees(f64),
    /// A direction, not zero: on the ground and in a drawn configuration in the fixed frame, else in the carrier's own.
    Direction([f64; 2]),
}

/// The carrier of a guide, with the names of the scene.
pub(in crate::scene) struct Carrier<'a> {
    pub given_by: GivenBy,
    pub names: &'a Names<'a>,
    pub on: &'a On,
}

impl Carrier<'_> {
    /// "link 2" or "the ground".
    pub fn name(&self) -> String {
        match self.on {
            On::Ground => "the ground".into(),
            On::Link(link) => format!("link {link}"),
        }
    }

    /// The link, unless it is the ground.
    fn link(&self) -> Option<&Link> {
        match self.on {
            On::Ground => None,
            On::Link(link) => self.names.links.get(link),
        }
    }

    pub fn points(&self) -> &[String] {
        self.link().map_or(self.names.ground, |link| &link.points)
    }

    fn has(&self, point: &str) -> bool {
        match self.on {
            On::Ground => self.names.on_ground(point),
            On::Link(link) => self.names.on_link(link, point),
        }
    }

    /// An error if the sliding point is a point of the carrier.
    pub fn check_free(&self, key: &str, point: &str) -> Result<(), Wrong> {
        if self.has(point) {
            let message = format!("point {point} is a point of {}, so it cannot slide on it", self.name());
            return Err(Wrong::value(&[key], message).hint("use another name for the point that slides"));
        }
        Ok(())
    }

    pub fn through(&self, given: At) -> Result<At, Wrong> {
        match (&given, self.link()) {
            (At::Point(point), _) if !self.has(point) => {
                Err(Wrong::value(&["through"], no_point(&self.name(), point, self.points())))
            }
            (At::Place(_), Some(link)) if !matches!(link.shape, Shape::Local(_)) => {
                let name = self.name();
                let message = format!("coordinates need a frame, and {name} has no `shape`");
                let or = match self.given_by {
                    GivenBy::Lengths => "give the link a `shape`",
                    GivenBy::Drawing => "leave `through` out: the guide passes through the slider's point",
                };
                Err(Wrong::value(&["through"], message).hint(format!("name a point of {name}, or {or}")))
            }
            _ => Ok(given),
        }
    }

    pub fn along(&self, coordinates: &Coordinates, given: Option<Direction>) -> Result<Along, Wrong> {
        // Without the key the error is at the slider as a whole.
        let path: &[&str] = if given.is_some() { &["along"] } else { &[] };
        match given.unwrap_or(Direction::Degrees(0.0)) {
            Direction::Points(key) => self.along_points(coordinates, &key),
            Direction::Vector([0.0, 0.0]) => {
                Err(Wrong::value(path, "a direction of size zero points nowhere").hint("give [dx, dy] or degrees"))
            }
            Direction::Vector(direction) => Ok(Along::Direction(direction)),
            Direction::Degrees(_)
                if self.given_by == GivenBy::Drawing && self.link().is_some_and(|link| link.points.is_empty()) =>
            {
                let message = format!("{} has no points and so no axis to count degrees from", self.name());
                Err(Wrong::value(path, message).hint(r#"give the direction as drawn: "along": [dx, dy]"#))
            }
            Direction::Degrees(degrees) => Ok(Along::Degrees(degrees)),
        }
    }

    fn along_points(&self, coordinates: &Coordinates, key: &str) -> Result<Along, Wrong> {
        let points = checked_pair("along", key, &self.name(), self.points(), |point| self.has(point));
        let (from, to) = points.map_err(|Wrong { message, hint, .. }| {
            let number = key.trim().parse::<f64>().is_ok();
            let degrees = number.then(|| format!("write {} without quotes for degrees", key.trim()));
            Wrong::value(&["along"], message).maybe_hint(degrees.or(hint))
        })?;
        match (coordinates.get(&from), coordinates.get(&to)) {
            (Some(a), Some(b)) if a == b => {
                let message = format!("{from} and {to} are in one place, so they give no direction");
                Err(Wrong::value(&["along"], message))
            }
            _ => Ok(Along::Points(from, to)),
        }
    }
}
