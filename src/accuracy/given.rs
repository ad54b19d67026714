//! What the scene gives, with all digits that stand in its text: lengths, coordinates and angles as [`Ball`]s.

use crate::geometry::{Ball, Number, Pair, RADIANS_PER_SECOND, RADIANS_PER_TURN};
use crate::mechanism::{BodyId, GROUND, Guide, Mechanism, PointId, SliderId};
use crate::scene::{self, Along, At, Length, Scene, Shape, TimeUnit};

/// A place or a vector.
pub(super) type Vector = Pair<Ball>;

/// A scene and the mechanism in which its positions are found.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<'a> {
    pub scene: &'a Scene,
    pub mechanism: &'a Mechanism,
    /// How far drives may stand from their values.
    pub room: Room,
}

/// How far drives may stand from their values, to either side: nowhere else by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Room {
    /// Of links that are turned, in degrees.
    pub turned: f64,
    /// Of sliders that are pushed.
    pub pushed: f64,
}

impl Given<'_> {
    /// A number of the scene, as it is written; of a number that its text does not have, all that may be rounded to it.
    pub fn number(&self, x: f64) -> Ball {
        self.scene.as_written(x)
    }

    /// A number that the scene gives or that a drive has been given since, which then is what it is printed as.
    pub fn chosen(&self, x: f64) -> Ball {
        self.scene.as_written_or_printed(x)
    }

    /// A place or vector of the scene.
    pub fn vector(&self, v: impl Into<[f64; 2]>) -> Vector {
        let [x, y] = v.into().map(|x| self.number(x));
        Pair { x, y }
    }

    /// By point: the place that the scene gives it; the origin for other points.
    pub fn places(&self) -> Vec<Vector> {
        self.mechanism
            .given
            .iter()
            .map(|place| place.map_or_else(Vector::default, |place| self.vector(place)))
            .collect()
    }

    /// The angles, in degrees, that a drive may have.
    pub fn driven_angle(&self, degrees: f64) -> Ball {
        self.chosen(degrees).widened(self.room.turned)
    }

    /// The positions that a pushed slider may have.
    pub fn driven_slide(&self, position: f64) -> Ball {
        self.chosen(position).widened(self.room.pushed)
    }

    /// Cosine and sine of an angle of the scene, in degrees.
    pub fn direction(&self, degrees: f64) -> Vector {
        Pair::direction_of_degrees(self.number(degrees))
    }

    /// The given length between two points, which a checked scene has.
    fn length(&self, lengths: &[Length], a: &str, b: &str) -> Ball {
        let found = lengths.iter().find(|l| l.joins(a, b));
        self.number(found.map_or(0.0, |l| l.value))
    }

    /// The coordinates of a body's points in its own frame, in the order of its points.
    pub fn locals(&self, id: BodyId) -> Vec<Vector> {
        let body = self.mechanism.body(id);
        let link = Some(body).filter(|body| !body.is_nameless()).and_then(|body| self.scene.links.get(&body.name));
        match link.map(|link| (&link.shape, link.points.as_slice())) {
            Some((Shape::Lengths(lengths), [a, b])) => {
                vec![Vector::default(), Pair { x: self.length(lengths, a, b), y: Ball::default() }]
            }
            Some((Shape::Lengths(lengths), [a, b, c])) => {
                let [ab, ac, bc] = [(a, b), (a, c), (b, c)].map(|(p, q)| self.length(lengths, p, q));
                let side = body.local[2].y;
                vec![Vector::default(), Pair { x: ab, y: Ball::default() }, corner(ab, ac, bc, side)]
            }
            _ => body.local.iter().map(|&place| self.vector(place)).collect(),
        }
    }

    /// A slider's guide in the frame of its body: the place from which its position counts, and the unit direction.
    /// `local` gives the places of that body's points.
    pub fn line(&self, id: SliderId, local: impl Fn(PointId) -> Option<Vector>) -> [Vector; 2] {
        let slider = self.mechanism.slider(id);
        let (rough, along) = slider.line();
        let Some(given) = slider.given.and_then(|index| self.scene.sliders.get(index)) else {
            // The carriage of a given angle has guides along the axes.
            return [self.vector(rough), Pair::within(along, 0.0)];
        };
        let point = |name: &String| self.mechanism.point(name).and_then(&local);
        let through = match (&given.through, &given.along) {
            (Some(At::Place(p)), _) => Some(self.vector(*p)),
            (Some(At::Point(p)), _) | (None, Along::Points(p, _)) => point(p),
            (None, _) => self.mechanism.first_point(slider.on).and_then(&local),
        };
        let direction = match &given.along {
            Along::Points(a, b) => point(a).zip(point(b)).map(|(a, b)| (b - a).unit()),
            Along::Direction(d) => Some(self.vector(*d).unit()),
            Along::Degrees(angle) => Some(self.direction(*angle)),
        };
        let direction = direction.unwrap_or_else(|| Pair::within(along, f64::INFINITY));
        let mut through = through.unwrap_or_default();
        if given.beside != 0.0 {
            through = through.plus_scaled(direction.quarter_turn(), -self.number(given.beside));
        }
        [through, direction]
    }

    /// The direction of a guide as drawn, where `places` are the points.
    pub fn drawn_guide(&self, id: SliderId, places: &[Vector]) -> Vector {
        let slider = self.mechanism.slider(id);
        let between = |a: PointId, b: PointId| (places[b.0] - places[a.0]).unit();
        let given = slider.given.and_then(|index| self.scene.sliders.get(index));
        match (slider.guide, given.map(|given: &scene::Slider| &given.along)) {
            (Guide::DrawnBetween(a, b), _) => between(a, b),
            (_, Some(Along::Direction(d))) => self.vector(*d).unit(),
            (_, Some(Along::Degrees(angle))) => {
                let turn = self.direction(*angle);
                let on_ground = slider.on == GROUND;
                match self.mechanism.body(slider.on).points.as_slice() {
                    [a, b, ..] if !on_ground => between(*a, *b).turn(turn),
                    _ => turn,
                }
            }
            _ => Pair::within(slider.line().1, f64::INFINITY),
        }
    }

    /// The angular velocity that a scene gives for a driven body, which the mechanism has as `omega`. Turns per minute
    /// were rounded when they were read.
    pub fn omega(&self, id: BodyId, omega: f64) -> Ball {
        let drive = self.scene.links.get(&self.mechanism.body(id).name).and_then(|link| link.drive);
        // The mechanism may have been given another rate since.
        match drive.filter(|drive| drive.omega == omega).and_then(|drive| drive.rpm) {
            Some(rpm) => self.number(rpm) * radians_of_rpm(self.scene.units.time),
            None => self.chosen(omega),
        }
    }
}

/// The third corner of a triangle with base `ab` on the x axis and sides `ac`, `bc`, on the side of the sign of `side`.
///
/// A `side` of zero is a link that counts as straight: its third point lies on the base, or so near to it, on either
/// side, as the lengths allow. Lengths that fail to close by a rounding leave it as far from certain.
fn corner(ab: Ball, ac: Ball, bc: Ball, side: f64) -> Vector {
    let half = Ball::default().eighths(4);
    let x = half * (ab + (ac - bc) * (ac + bc) / ab);
    // Heron's formula. The factor that nearly vanishes comes from sums of neighbours, which lose nothing.
    let sixteen_squares = (ab + ac + bc) * ((ac - ab) + bc) * ((ab - ac) + bc) * ((ab - bc) + ac);
    if side == 0.0 {
        let height = half * Ball::default().widened(sixteen_squares.largest()).sqrt() / ab;
        return Pair { x, y: height };
    }
    let y = half * sixteen_squares.sqrt() / ab;
    Pair { x, y: if side < 0.0 { -y } else { y } }
}

/// A rigid placement with bounds of its errors: rotation, then translation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// Cosine and sine of its angle.
    pub turn: Vector,
    /// The place of its origin.
    pub origin: Vector,
}

impl Frame {
    /// No rotation and no translation.
    pub fn identity() -> Frame {
        Frame { turn: Pair { x: Ball::from(1), y: Ball::default() }, origin: Vector::default() }
    }

    /// The placement with rotation `turn` that brings the point `local` to `place`.
    pub fn pinned(turn: Vector, local: Vector, place: Vector) -> Frame {
        Frame { turn, origin: place - turn.turn(local) }
    }

    /// The place of a point.
    pub fn place(&self, local: Vector) -> Vector {
        self.origin + self.turn.turn(local)
    }

    /// `inner`, which is seen from this frame, as seen from outside.
    pub fn of(&self, inner: &Frame) -> Frame {
        Frame { turn: self.turn.turn(inner.turn), origin: self.place(inner.origin) }
    }

    /// The placement that undoes this one.
    pub fn inverse(&self) -> Frame {
        let turn = self.turn.reversed();
        Frame { turn, origin: -turn.turn(self.origin) }
    }
}

/// One revolution a minute in radians per unit of time.
pub(super) fn radians_of_rpm(time: TimeUnit) -> Ball {
    match time {
        TimeUnit::S => RADIANS_PER_SECOND,
        TimeUnit::Min => RADIANS_PER_TURN,
    }
}
