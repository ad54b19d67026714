//! Links of a scene: points, shape, drive, given motion.

use indexmap::IndexMap;

/// A rigid link.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Names of its points, in file order (with [`Shape::Local`] and no list of points: in the order of the shape).
    /// Its axis runs from the first to the second, except with [`Shape::Local`].
    pub points: Vec<String>,
    /// What fixes the points to each other; always [`Shape::Bare`] in the drawn form.
    pub shape: Shape,
    /// The drive that turns it, if any.
    pub drive: Option<Drive>,
    /// Angle of its axis from +x, in degrees, in place of the angle of another link's drive. One that the file gives on a link with
    /// a drive of its own stands in the drive.
    pub angle_deg: Option<f64>,
    /// Its motion, if it is a known moving body (drawn form only).
    pub motion: Option<LinkMotion>,
}

/// What fixes the points of a link to each other.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Nothing is needed: no point, one point, or a drawn configuration.
    Bare,
    /// Distances: one for two points, three for three points. They can be joined: the triangle closes or is straight.
    Lengths(Vec<Length>),
    /// Coordinates in the link's own frame, whose x axis is the link's axis; one entry for each point.
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

/// A drive that turns a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// Angle of the link's axis from +x, in degrees; always `None` in the drawn form.
    pub angle_deg: Option<f64>,
    /// Angular velocity, in radians per unit of time, counter-clockwise positive.
    pub omega: f64,
    /// Angular acceleration, in radians per unit of time squared; zero unless given.
    pub alpha: f64,
}

/// The given motion of a link, in the fixed frame.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkMotion {
    /// The point of the body that has the velocity and the acceleration below.
    pub at: At,
    /// Velocity there, in length per time.
    pub velocity: [f64; 2],
    /// Acceleration there, in length per time squared; zero unless given.
    pub acceleration: [f64; 2],
    /// Angular velocity, in radians per unit of time; zero unless given.
    pub omega: f64,
    /// Angular acceleration, in radians per unit of time squared; zero unless given.
    pub alpha: f64,
}

/// A place: that of a named point, or coordinates.
#[derive(Debug, Clone, PartialEq)]
pub enum At {
    /// Where this point is.
    Point(String),
    /// Coordinates, in the fixed frame unless the field that holds it says otherwise.
    Place([f64; 2]),
}

impl From<&str> for At {
    fn from(point: &str) -> Self {
        At::Point(point.to_owned())
    }
}

impl From<[f64; 2]> for At {
    fn from(place: [f64; 2]) -> Self {
        At::Place(place)
    }
}
