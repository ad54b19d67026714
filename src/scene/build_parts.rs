//! The parts of a scene put together in Rust: links, guides, drives.

use super::drive::{LinkDriveFile, SliderDrive};
use super::link::LinkFields;
use super::motion::LinkMotion;
use super::slider::SliderFile;
use super::value::{At, Direction, Entries, ShapePoint};
use super::wrong::Wrong;

/// A part of the file, and what is wrong with it already: a key that was set twice.
#[derive(Debug, Clone)]
pub(super) struct Part<T> {
    pub file: T,
    pub wrong: Option<Wrong>,
}

impl<T> Part<T> {
    fn new(file: T) -> Part<T> {
        Part { file, wrong: None }
    }

    /// Sets a key that has its default value until then.
    fn set<V: Default + PartialEq>(mut self, key: &str, slot: fn(&mut T) -> &mut V, value: V) -> Part<T> {
        if std::mem::replace(slot(&mut self.file), value) != V::default() {
            let twice = Wrong::key(&[key], format!("key `{key}` stands twice")).hint("keep one of them");
            self.wrong.get_or_insert(twice);
        }
        self
    }

    /// Sets a key to a part of its own.
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
    /// A link of these points. Its axis runs from the first to the second.
    pub fn points<'a>(names: impl IntoIterator<Item = &'a str>) -> NewLink {
        let points = Some(names.into_iter().map(str::to_owned).collect());
        NewLink(Part::new(LinkFields { points, ..LinkFields::default() }))
    }

    /// A link of points with coordinates in its own frame, whose x axis is the link's axis.
    pub fn shape<'a>(places: impl IntoIterator<Item = (&'a str, [f64; 2])>) -> NewLink {
        let places = places.into_iter().map(|(point, place)| (point.to_owned(), ShapePoint(place)));
        let shape = Some(Entries(places.collect()));
        NewLink(Part::new(LinkFields { shape, ..LinkFields::default() }))
    }

    /// Adds the distance of two of its points, as `"AB"`, or `"A1-B1"` where names are longer: one for two points, three for three.
    pub fn length(mut self, points: &str, length: f64) -> NewLink {
        self.0.file.lengths.get_or_insert_default().add(points, length);
        self
    }

    /// Adds a drive that turns it about its ground pivot.
    pub fn drive(self, turn: Turn) -> NewLink {
        NewLink(self.0.put("drive", |link| &mut link.drive, turn.0))
    }

    /// Gives the angle of its axis from +x, in degrees, in place of the drive's.
    pub fn angle(self, degrees: f64) -> NewLink {
        NewLink(self.0.set("angle", |link| &mut link.angle, Some(degrees)))
    }

    /// Gives its whole motion, in a drawn configuration.
    pub fn motion(self, motion: LinkMotion) -> NewLink {
        NewLink(self.0.set("motion", |link| &mut link.motion, Some(motion)))
    }
}

/// A drive that turns a link, for [`NewLink::drive`]; counter-clockwise positive.
#[derive(Debug, Clone)]
#[must_use]
pub struct Turn(Part<LinkDriveFile>);

impl Turn {
    /// At this angular velocity, in radians per unit of time.
    pub fn omega(omega: f64) -> Turn {
        Turn(Part::new(LinkDriveFile { omega: Some(omega), ..LinkDriveFile::default() }))
    }

    /// At this speed of rotation, in turns per minute.
    pub fn rpm(rpm: f64) -> Turn {
        Turn(Part::new(LinkDriveFile { rpm: Some(rpm), ..LinkDriveFile::default() }))
    }

    /// With the link's axis at this angle from +x, in degrees; needed except in a drawn configuration.
    pub fn angle(self, degrees: f64) -> Turn {
        Turn(self.0.set("angle", |drive| &mut drive.angle, Some(degrees)))
    }

    /// With this angular acceleration, in radians per unit of time squared; zero unless given.
    pub fn alpha(self, alpha: f64) -> Turn {
        Turn(self.0.set("alpha", |drive| &mut drive.alpha, Some(alpha)))
    }
}

/// A straight guide, and how it is used, for [`Builder::slider`](super::Builder::slider) and [`Builder::pin`](super::Builder::pin).
#[derive(Debug, Clone)]
#[must_use]
pub struct Guide(pub(super) Part<SliderFile>);

impl Guide {
    /// A guide that this link carries, or `"ground"`.
    pub fn on(carrier: &str) -> Guide {
        Guide(Part::new(SliderFile { on: carrier.to_owned(), ..SliderFile::default() }))
    }

    /// Passing through a point of its carrier, as `"B"`; or through a place `[x, y]`, on the ground or in the carrier's shape.
    /// Unless given: through the first point of [`Guide::along`], else of the carrier.
    pub fn through(self, place: impl Into<At>) -> Guide {
        Guide(self.0.set("through", |slider| &mut slider.through, Some(place.into())))
    }

    /// Running from one point of its carrier to another, as `"BE"`; or at an angle in degrees, from +x on the ground and from
    /// the carrier's axis otherwise; or along `[dx, dy]`. Unless given: 0.
    pub fn along(self, direction: impl Into<Direction>) -> Guide {
        Guide(self.0.set("along", |slider| &mut slider.along, Some(direction.into())))
    }

    /// With the slider's axis turned from the guide by this angle, in degrees; zero unless given.
    pub fn turned(self, degrees: f64) -> Guide {
        Guide(self.0.set("turned", |slider| &mut slider.turned, Some(degrees)))
    }

    /// With a drive that pushes what slides.
    pub fn drive(self, push: Push) -> Guide {
        Guide(self.0.put("drive", |slider| &mut slider.drive, push.0))
    }
}

/// A drive that pushes a slider along its guide, for [`Guide::drive`].
#[derive(Debug, Clone)]
#[must_use]
pub struct Push(Part<SliderDrive>);

impl Push {
    /// At this speed along the guide, in length per time.
    pub fn speed(speed: f64) -> Push {
        Push(Part::new(SliderDrive { position: None, speed, acceleration: 0.0 }))
    }

    /// At this distance along the guide from the place that it passes through; needed except in a drawn configuration.
    pub fn position(self, position: f64) -> Push {
        Push(self.0.set("position", |drive| &mut drive.position, Some(position)))
    }

    /// With this acceleration along the guide, in length per time squared; zero unless given.
    pub fn acceleration(self, acceleration: f64) -> Push {
        Push(self.0.set("acceleration", |drive| &mut drive.acceleration, acceleration))
    }
}
