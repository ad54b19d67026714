//! Bounds of the errors of poles of the motion. What is certain of a centre is told by its bounds alone: whether it is at infinity, too.

use super::bounds::Bounds;
use super::enclosure::Enclosure;
use super::given::Vector;
use crate::centers::{Center, Moved, Permanent, TrueCenter};
use crate::geometry::{Ball, degrees_of};
use crate::mechanism::{BodyId, PointId};
use crate::quantity::{Component, Pole, PoleOf, Quantity, QuantityError, QuantityRequest, State, What, says};
use crate::sheet::Scales;

impl Bounds<'_> {
    /// The instant centre that is asked for, as far as it is certain; `None` where nothing is proved of the motion, and for other quantities.
    #[must_use]
    pub fn center(&self, asked: &QuantityRequest) -> Option<Center> {
        let What::Pole(pole) = &asked.what else { return None };
        let found = match self.enclosure()?.center(pole, |x| self.scene.as_written(x))? {
            TrueCenter::At(ball) => {
                // A pin is where the position has it. Any other place is rounded once: where links turn almost alike, numbers without bounds lose most digits.
                let place = match &pole.of {
                    PoleOf::Center(_, Some(Permanent::Pin(pin))) => self.snapshot().place(*pin),
                    _ => ball.rounded().into(),
                };
                Center::At { place, error: self.of_vector(ball, place.coords) }
            }
            TrueCenter::AtInfinity { along, beyond } => {
                let (direction, error) = TrueCenter::direction(along)?;
                Center::AtInfinity { direction, error, beyond }
            }
            TrueCenter::AtRest => Center::AtRest,
        };
        Some(found)
    }

    /// The value of a quantity and the bound of its error. Whether a centre is at infinity is decided by its bounds; all else is
    /// [`QuantityRequest::value`] and [`Self::of`].
    ///
    /// # Errors
    /// As [`QuantityRequest::value`].
    pub fn valued(&self, asked: &QuantityRequest, scales: Option<&Scales>) -> Result<(Quantity, f64), QuantityError> {
        let none = |why| Err(QuantityError::NoValue(asked.name().to_owned(), why));
        match (self.center(asked), asked.written.component) {
            (None, _) => {
                let value = asked.value(&self.snapshot(), self.construction, scales)?;
                Ok((value, self.of(asked, scales)))
            }
            (Some(Center::At { .. }), Some(Component::Angle)) => none(says::centre_at_place()),
            (Some(Center::At { place, error }), Some(Component::X)) => Ok((Quantity::Number(place.x), error)),
            (Some(Center::At { place, error }), Some(Component::Y)) => Ok((Quantity::Number(place.y), error)),
            (Some(Center::At { place, error }), _) => Ok((Quantity::Vector(place.coords), error)),
            (Some(Center::AtInfinity { direction, error, .. }), Some(Component::Angle)) => {
                Ok((Quantity::Number(degrees_of(direction)), error))
            }
            (Some(Center::AtInfinity { .. }), _) => none(says::centre_at_infinity()),
            (Some(Center::AtRest), _) => none(says::rest_on_another()),
        }
    }
}

impl Enclosure {
    /// The true centre of a pole that is one.
    fn center(&self, pole: &Pole, given: impl Fn(f64) -> Ball) -> Option<TrueCenter> {
        let PoleOf::Center(pair, permanent) = pole.of else { return None };
        match permanent {
            Some(Permanent::Pin(pin)) => {
                let place = self.place(pin);
                (place.x.is_known() && place.y.is_known()).then_some(TrueCenter::At(place))
            }
            Some(Permanent::Mesh(_)) => {
                let place = pole.rolling?.point(|center| self.place(center), |guide| self.guide(guide), given);
                (place.x.is_known() && place.y.is_known()).then_some(TrueCenter::At(place))
            }
            Some(Permanent::Guide(slider)) => {
                let along = self.guide(slider).quarter_turn();
                (along.x.is_known() && along.y.is_known())
                    .then_some(TrueCenter::AtInfinity { along, beyond: f64::INFINITY })
            }
            Some(Permanent::Alike) | None => {
                let near = self.place(pole.near);
                let [a, b] = pair.links().map(|link| self.state.body(link).referred_to(near));
                TrueCenter::of_motions(&a, &b, permanent.is_some())
            }
        }
    }

    /// The true place of a pole; `None` where it has none for certain.
    pub(super) fn pole(&self, pole: &Pole, given: impl Fn(f64) -> Ball) -> Option<Vector> {
        match pole.of {
            PoleOf::Center(..) => match self.center(pole, given)? {
                TrueCenter::At(place) => Some(place),
                _ => None,
            },
            PoleOf::Inflection(link) => Some(self.moved(link, pole.near).inflection_pole()),
            PoleOf::Acceleration(link) => Some(self.moved(link, pole.near).acceleration_pole()),
        }
    }

    /// The true diameter of the inflection circle of the link of that pole.
    pub(super) fn diameter(&self, pole: &Pole) -> Ball {
        self.moved(pole.of.link(), pole.near).inflection_diameter()
    }

    /// The true radius of curvature of the path of a body's point at a place.
    pub(super) fn path_radius(&self, body: BodyId, place: Vector) -> Ball {
        Moved::from(&self.state.body(body).referred_to(place)).path_radius()
    }

    fn moved(&self, link: BodyId, near: PointId) -> Moved<Ball> {
        Moved::from(&self.state.body(link).referred_to(self.place(near)))
    }
}
