//! The parts of a scene put together in Rust: links, guides, drives.

use super::forms::Direction;
use super::link::{At, LinkMotion};
use super::write::{Object, Written, texts};

/// A link for [`Builder::link`](super::Builder::link).
#[derive(Debug, Clone)]
pub struct NewLink {
    /// Its points or its shape.
    points: Object,
    lengths: Object,
    more: Object,
}

impl NewLink {
    /// A link of these points. Its axis runs from the first to the second.
    #[must_use]
    pub fn points<'a>(names: impl IntoIterator<Item = &'a str>) -> NewLink {
        NewLink::of(Object::of("points", texts(names)))
    }

    /// A link of points with coordinates in its own frame, whose x axis is the link's axis.
    #[must_use]
    pub fn shape<'a>(places: impl IntoIterator<Item = (&'a str, [f64; 2])>) -> NewLink {
        let mut shape = Object::default();
        for (point, place) in places {
            shape.add(point, place);
        }
        NewLink::of(Object::of("shape", shape))
    }

    /// Adds the distance of two of its points, as `"AB"`, or `"A1-B1"` where names are longer: one for two points, three for three.
    #[must_use]
    pub fn length(mut self, points: &str, length: f64) -> NewLink {
        self.lengths.add(points, length);
        self
    }

    /// Adds a drive that turns it about its ground pivot.
    #[must_use]
    pub fn drive(mut self, turn: Turn) -> NewLink {
        self.more.add("drive", turn.0);
        self
    }

    /// Gives the angle of its axis from +x, in degrees, in place of the drive's.
    #[must_use]
    pub fn angle(mut self, degrees: f64) -> NewLink {
        self.more.add("angle", degrees);
        self
    }

    /// Gives its whole motion, in a drawn configuration.
    #[must_use]
    pub fn motion(mut self, motion: LinkMotion) -> NewLink {
        let mut object = Object::of("at", motion.at);
        object.add("velocity", motion.velocity);
        object.add("acceleration", motion.acceleration);
        object.add("omega", motion.omega);
        object.add("alpha", motion.alpha);
        self.more.add("motion", object);
        self
    }

    fn of(points: Object) -> NewLink {
        NewLink { points, lengths: Object::default(), more: Object::default() }
    }

    /// The link as the file says it.
    pub(super) fn written(mut self) -> Object {
        self.points.add_entries("lengths", &self.lengths);
        self.points.and(self.more)
    }
}

/// A drive that turns a link, for [`NewLink::drive`]; counter-clockwise positive.
#[derive(Debug, Clone)]
pub struct Turn(Object);

impl Turn {
    /// At this angular velocity, in radians per unit of time.
    #[must_use]
    pub fn omega(omega: f64) -> Turn {
        Turn(Object::of("omega", omega))
    }

    /// At this speed of rotation, in turns per minute.
    #[must_use]
    pub fn rpm(rpm: f64) -> Turn {
        Turn(Object::of("rpm", rpm))
    }

    /// With the link's axis at this angle from +x, in degrees; needed except in a drawn configuration.
    #[must_use]
    pub fn angle(mut self, degrees: f64) -> Turn {
        self.0.add("angle", degrees);
        self
    }

    /// With this angular acceleration, in radians per unit of time squared; zero unless given.
    #[must_use]
    pub fn alpha(mut self, alpha: f64) -> Turn {
        self.0.add("alpha", alpha);
        self
    }
}

/// A straight guide, and how it is used, for [`Builder::slider`](super::Builder::slider) and [`Builder::pin`](super::Builder::pin).
#[derive(Debug, Clone)]
pub struct Guide(Object);

impl Guide {
    /// A guide that this link carries, or `"ground"`.
    #[must_use]
    pub fn on(carrier: &str) -> Guide {
        Guide(Object::of("on", carrier))
    }

    /// Passing through a point of its carrier, as `"B"`; or through a place `[x, y]`, on the ground or in the carrier's shape.
    /// Unless given: through the first point of [`Guide::along`], else of the carrier.
    #[must_use]
    pub fn through(mut self, place: impl Into<At>) -> Guide {
        self.0.add("through", place.into());
        self
    }

    /// Running from one point of its carrier to another, as `"BE"`; or at an angle in degrees, from +x on the ground and from
    /// the carrier's axis otherwise; or along `[dx, dy]`. Unless given: 0.
    #[must_use]
    pub fn along(mut self, direction: impl Into<Direction>) -> Guide {
        self.0.add("along", direction.into());
        self
    }

    /// With the slider's axis turned from the guide by this angle, in degrees; zero unless given.
    #[must_use]
    pub fn turned(mut self, degrees: f64) -> Guide {
        self.0.add("turned", degrees);
        self
    }

    /// With a drive that pushes what slides.
    #[must_use]
    pub fn drive(mut self, push: Push) -> Guide {
        self.0.add("drive", push.0);
        self
    }

    /// What the file says of it beside who slides.
    pub(super) fn written(self) -> Object {
        self.0
    }
}

/// A drive that pushes a slider along its guide, for [`Guide::drive`].
#[derive(Debug, Clone)]
pub struct Push(Object);

impl Push {
    /// At this speed along the guide, in length per time.
    #[must_use]
    pub fn speed(speed: f64) -> Push {
        Push(Object::of("speed", speed))
    }

    /// At this distance along the guide from the place that it passes through; needed except in a drawn configuration.
    #[must_use]
    pub fn position(mut self, position: f64) -> Push {
        self.0.add("position", position);
        self
    }

    /// With this acceleration along the guide, in length per time squared; zero unless given.
    #[must_use]
    pub fn acceleration(mut self, acceleration: f64) -> Push {
        self.0.add("acceleration", acceleration);
        self
    }
}

impl From<At> for Written {
    fn from(at: At) -> Self {
        match at {
            At::Point(name) => name.as_str().into(),
            At::Place(place) => place.into(),
        }
    }
}

impl From<Direction> for Written {
    fn from(direction: Direction) -> Self {
        match direction {
            Direction::Points(points) => points.as_str().into(),
            Direction::Degrees(degrees) => degrees.into(),
            Direction::Vector(vector) => vector.into(),
        }
    }
}
