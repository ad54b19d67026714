//! The parts of a scene that is built in Rust: links, guides, drives.

use super::error::Wrong;
use super::given::{LinkDriveFile, LinkMotion, SliderDrive};
use super::joint::SliderFile;
use super::link::LinkFields;
use super::value::{At, Direction, Entries, ShapePoint};

/// A part of the file, and the first key in it that was set twice.
#[derive(Debug, Clone)]
pub(super) struct Part<T> {
    pub file: T,
    pub wrong: Option<Wrong>,
}

impl<T> Part<T> {
    fn new(file: T) -> Part<T> {
        Part { file, wrong: None }
    }

    /// Sets a key; an error if it has another value than its default already.
    fn set<V: Default + PartialEq>(mut self, key: &str, slot: fn(&mut T) -> &mut V, value: V) -> Part<T> {
        if std::mem::replace(slot(&mut self.file), value) != V::default() {
            let doubled = Wrong::key(&[key], format!("key `{key}` stands twice")).hint("keep one of them");
            self.wrong.get_or_insert(doubled);
        }
        self
    }

    /// Sets a key to a part with errors of its own.
    fn put<V: PartialEq>(mut self, key: &str, slot: fn(&mut T) -> &mut Option<V>, part: Part<V>) -> Part<T> {
        self.wrong = self.wrong.or(part.wrong.map(|wrong| wrong.inside(&[key])));
        self.set(key, slot, Some(part.file))
    }
}

/// A link for [`Builder::link`](super::Builder::link).
#[derive(Debug, Clone)]
#[must_use]
pub struct NewLink(pub(super) Part<LinkFields>);

impl NewLink {
    /// A link with these points. Its axis runs from the first to the second.
    pub fn points<'a>(names: impl IntoIterator<Item = &'a str>) -> NewLink {
        let points = Some(names.into_iter().map(str::to_owned).collect());
        NewLink(Part::new(LinkFields { points, ..LinkFields::default() }))
    }

    /// A link by the coordinates of its points in its own frame, whose x axis is the link's axis.
    pub fn shape<'a>(places: impl IntoIterator<Item = (&'a str, [f64; 2])>) -> NewLink {
        let places = places.into_iter().map(|(point, place)| (point.to_owned(), ShapePoint(place)));
        let shape = Some(Entries(places.collect()));
        NewLink(Part::new(LinkFields { shape, ..LinkFields::default() }))
    }

    /// Adds the distance of two of its points, as `"AB"`, or `"A1-B1"` for longer names: one for two points, three for
    /// three.
    pub fn length(mut self, points: &str, length: f64) -> NewLink {
        self.0.file.lengths.get_or_insert_default().add(points, length);
        self
    }

    /// Adds a drive that turns it about its ground pivot.
    pub fn drive(self, turn: Turn) -> NewLink {
        NewLink(self.0.put("drive", |link| &mut link.drive, turn.0))
    }

    /// Gives the angle of its axis from +x, in degrees, in place of that of another link's drive.
    pub fn angle(self, degrees: f64) -> NewLink {
        NewLink(self.0.set("angle", |link| &mut link.angle, Some(degrees)))
    }

    /// Gives its motion, in a drawn configuration.
    pub fn motion(self, motion: LinkMotion) -> NewLink {
        NewLink(self.0.set("motion", |link| &mut link.motion, Some(motion)))
    }
}

/// A drive that turns a link, for [`NewLink::drive`]; counter-clockwise positive.
#[derive(Debug, Clone)]
#[must_use]
pub struct Turn(Part<LinkDriveFile>);

impl Turn {
    /// With this angular velocity, in radians per unit of time.
    pub fn omega(omega: f64) -> Turn {
        Turn(Part::new(LinkDriveFile { omega: Some(omega), ..LinkDriveFile::default() }))
    }

    /// With this speed of rotation, in turns per minute.
    pub fn rpm(rpm: f64) -> Turn {
        Turn(Part::new(LinkDriveFile { rpm: Some(rpm), ..LinkDriveFile::default() }))
    }

    /// With the link's axis at this angle from +x, in degrees; required except in a drawn configuration.
    pub fn angle(self, degrees: f64) -> Turn {
        Turn(self.0.set("angle", |drive| &mut drive.angle, Some(degrees)))
    }

    /// With this angular acceleration, in radians per unit of time squared; zero by default.
    pub fn alpha(self, alpha: f64) -> Turn {
        Turn(self.0.set("alpha", |drive| &mut drive.alpha, Some(alpha)))
    }
}

/// A straight guide and the use of it, for [`Builder::slider`](super::Builder::slider) and
/// [`Builder::pin`](super::Builder::pin).
#[derive(Debug, Clone)]
#[must_use]
pub struct Guide(pub(super) Part<SliderFile>);

impl Guide {
    /// A guide of the link of this name, or of `"ground"`.
    pub fn on(carrier: &str) -> Guide {
        Guide(Part::new(SliderFile { on: carrier.to_owned(), ..SliderFile::default() }))
    }

    /// Through a point of its carrier, as `"B"`, or a place `[x, y]`, on the ground in the fixed frame, else in the
    /// carrier's shape. By default through the first point of [`Guide::along`], else of the carrier.
    pub fn through(self, place: impl Into<At>) -> Guide {
        Guide(self.0.set("through", |slider| &mut slider.through, Some(place.into())))
    }

    /// In the direction from one point of its carrier to another, as `"BE"`; or at an angle in degrees, from +x on the
    /// ground, else from the carrier's axis; or along `[dx, dy]`. By default at 0°.
    pub fn along(self, direction: impl Into<Direction>) -> Guide {
        Guide(self.0.set("along", |slider| &mut slider.along, Some(direction.into())))
    }

    /// With this angle from the guide to the sliding link's axis, in degrees; zero by default.
    pub fn turned(self, degrees: f64) -> Guide {
        Guide(self.0.set("turned", |slider| &mut slider.turned, Some(degrees)))
    }

    /// With a drive that pushes the sliding link or the pin.
    pub fn drive(self, push: Push) -> Guide {
        Guide(self.0.put("drive", |slider| &mut slider.drive, push.0))
    }
}

/// A drive that pushes a slider along its guide, for [`Guide::drive`].
#[derive(Debug, Clone)]
#[must_use]
pub struct Push(Part<SliderDrive>);

impl Push {
    /// With this velocity along the guide, in length per time.
    pub fn speed(speed: f64) -> Push {
        Push(Part::new(SliderDrive { position: None, speed, acceleration: 0.0 }))
    }

    /// At this distance along the guide from the place of [`Guide::through`]; required except in a drawn configuration.
    pub fn position(self, position: f64) -> Push {
        Push(self.0.set("position", |drive| &mut drive.position, Some(position)))
    }

    /// With this acceleration along the guide, in length per time squared; zero by default.
    pub fn acceleration(self, acceleration: f64) -> Push {
        Push(self.0.set("acceleration", |drive| &mut drive.acceleration, acceleration))
    }
}
