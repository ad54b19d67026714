//! Poles of the motion: instant centres, inflection poles, poles of accelerations; in numbers without bounds.

use super::error::QuantityError;
use super::name::{Pole, PoleOf, QuantityRequest};
use super::says;
use super::value::{Quantity, State};
use crate::centers::{LinkPair, Moved, Permanent, to_the_right};
use crate::construction::Solution;
use crate::geometry::{Pair, Place, Point, UNIT_ROUNDOFF, Vector, cross, quarter_turn, span};
use crate::mechanism::{BodyId, GROUND, PointId};

/// A centre farther away than this, in parts of the mechanism's size, is taken to be at infinity: of its place three digits would be right at most.
const FAR: f64 = 1e12;

/// Relative motion below this part of the motions themselves is rounding.
const REST: f64 = 64.0 * UNIT_ROUNDOFF;

/// A link whose ω² is below this part of its α does not turn: it is about to turn back.
const TURNING_BACK: f64 = 1e-20;

impl QuantityRequest {
    /// Where a pole lies.
    pub(crate) fn place_of(&self, pole: &Pole, state: &impl State) -> Result<Point, QuantityError> {
        match self.found(pole, state)? {
            Place::At(place) => Ok(place),
            Place::AtInfinity(_) => Err(self.none(says::centre_at_infinity())),
        }
    }

    /// The direction in which a pole lies at infinity.
    pub(super) fn direction_of(&self, pole: &Pole, state: &impl State) -> Result<Vector, QuantityError> {
        match self.found(pole, state)? {
            Place::At(_) => Err(self.none(says::centre_at_place())),
            Place::AtInfinity(direction) => Ok(direction),
        }
    }

    fn found(&self, pole: &Pole, state: &impl State) -> Result<Place, QuantityError> {
        if let PoleOf::Center(pair, permanent) = pole.of {
            return center(pole, pair, permanent, state).ok_or_else(|| self.none(says::rest_on_another()));
        }
        let (moved, is_turning) = self.moved_link(pole, state)?;
        let found = match pole.of {
            PoleOf::Acceleration(_) => moved.acceleration_pole(),
            _ if is_turning => moved.inflection_pole(),
            _ => return Err(self.none(says::link_turns_not())),
        };
        place(found).ok_or_else(|| self.none(says::link_turns_not()))
    }

    /// The diameter of the inflection circle of the link of that pole.
    pub(super) fn diameter(&self, pole: &Pole, state: &impl State) -> Result<f64, QuantityError> {
        let (moved, is_turning) = self.moved_link(pole, state)?;
        let diameter = moved.inflection_diameter();
        if is_turning && diameter.is_finite() { Ok(diameter) } else { Err(self.none(says::link_turns_not())) }
    }

    /// The radius of curvature of the path of a body's point.
    pub(super) fn path_radius(&self, body: BodyId, at: Point, state: &impl State) -> Result<f64, QuantityError> {
        let [velocity, acceleration] = state.motion_at(body, at);
        let is_curved = cross(velocity, acceleration).abs() > REST * velocity.norm() * acceleration.norm();
        let radius = moved(state, body, at).path_radius();
        if is_curved && radius.is_finite() { Ok(radius) } else { Err(self.none(says::path_is_straight())) }
    }

    /// The motion of the link of a pole about a point of it, and whether it turns.
    fn moved_link(&self, pole: &Pole, state: &impl State) -> Result<(Moved<f64>, bool), QuantityError> {
        if !state.has_accelerations() {
            return Err(self.none(says::no_accelerations()));
        }
        let moved = moved(state, pole.of.link(), state.place(pole.near));
        let speed = Vector::new(moved.velocity.x, moved.velocity.y).norm();
        let is_turning = moved.omega * moved.omega > TURNING_BACK * moved.alpha.abs()
            && speed <= FAR * size(pole, state) * moved.omega.abs();
        Ok((moved, is_turning))
    }
}

impl Solution {
    /// The instant centre of a link and the frame, and the link's inflection pole: the ends of a diameter of its inflection circle. `None` of a link that has none,
    /// as it turns about a fixed point or does not turn, and without accelerations.
    #[must_use]
    pub fn inflection_circle(&self, link: &str) -> Option<(BodyId, [Point; 2])> {
        let pair = LinkPair::new(self.mechanism.link(link)?, GROUND)?;
        if Permanent::of(pair, &self.mechanism).is_some() {
            return None;
        }
        let ground = &self.mechanism.body(GROUND).name;
        let names = [format!("P({link},{ground})"), format!("W({link})")];
        let [pole, inflection] = names.map(|name| self.quantity(&name).ok());
        match (pole?, inflection?) {
            (Quantity::Vector(pole), Quantity::Vector(inflection)) => {
                Some((self.mechanism.link(link)?, [pole.into(), inflection.into()]))
            }
            _ => None,
        }
    }
}

impl PoleOf {
    /// The two links of an instant centre; `None` of another pole.
    #[must_use]
    pub fn pair(self) -> Option<LinkPair> {
        match self {
            PoleOf::Center(pair, _) => Some(pair),
            _ => None,
        }
    }

    /// The link whose motion it belongs to; of a pair the first one.
    #[must_use]
    pub fn link(self) -> BodyId {
        match self {
            PoleOf::Center(pair, _) => pair.links()[0],
            PoleOf::Inflection(link) | PoleOf::Acceleration(link) => link,
        }
    }
}

/// The motion of a body about a place.
fn moved(state: &impl State, body: BodyId, at: Point) -> Moved<f64> {
    let [velocity, acceleration] = state.motion_at(body, at).map(Into::into);
    let [omega, alpha] = state.angular_rates(body);
    Moved { at: at.coords.into(), velocity, acceleration, omega, alpha }
}

/// The size of the mechanism.
fn size(pole: &Pole, state: &impl State) -> f64 {
    span((0..pole.points).map(|point| state.place(PointId(point))))
}

fn place(found: Pair<f64>) -> Option<Place> {
    let is_finite = found.x.is_finite() && found.y.is_finite();
    is_finite.then(|| Place::At(Point::new(found.x, found.y)))
}

/// The instant centre of two links; `None` where they rest on one another.
fn center(pole: &Pole, pair: LinkPair, permanent: Option<Permanent>, state: &impl State) -> Option<Place> {
    let far = |along: Vector| to_the_right(along).map(Place::AtInfinity);
    match permanent {
        Some(Permanent::Pin(pin)) => return Some(Place::At(state.place(pin))),
        Some(Permanent::Mesh(_)) => {
            let at = |point: PointId| state.place(point).coords.into();
            return pole.rolling.and_then(|rolling| place(rolling.point(at, |guide| state.guide(guide).into(), |x| x)));
        }
        Some(Permanent::Guide(slider)) => return far(quarter_turn(state.guide(slider))),
        Some(Permanent::Alike) | None => {}
    }
    let [a, b] = pair.links().map(|link| moved(state, link, state.place(pole.near)));
    let relative = Moved { velocity: b.velocity - a.velocity, omega: b.omega - a.omega, ..b };
    let largest = |[x, y]: [f64; 2]| x.abs().max(y.abs());
    let velocity = Vector::new(relative.velocity.x, relative.velocity.y);
    let slides =
        velocity.amax() > REST * [a, b].iter().map(|m| largest([m.velocity.x, m.velocity.y])).fold(0.0, f64::max);
    let turns = permanent.is_none() && relative.omega.abs() > REST * largest([a.omega, b.omega]);
    match (slides, turns) {
        (true, true) if velocity.norm() <= FAR * size(pole, state) * relative.omega.abs() => place(relative.pole()),
        (false, true) => place(relative.pole()),
        (true, _) => far(quarter_turn(velocity)),
        (false, false) => None,
    }
}
