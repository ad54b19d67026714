//! Forces in joints and drives as quantities, in a position with its rates.

use super::name::{ForceOf, QuantityError, QuantityRequest};
use super::says;
use super::value::{Quantity, State};
use crate::forces::{Forces, Posed, in_equilibrium};
use crate::geometry::{Ball, Pair, Point};
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId};
use crate::motion::Places;

/// A force as read from all forces: a number or a vector.
pub(crate) enum ForceRead {
    /// Across or along a guide, or a moment.
    Number(Ball),
    /// At a pin.
    Vector(Pair<Ball>),
}

impl ForceOf {
    /// It among all forces; `guide` gives the directions of guides. `None` where the body has no joint with the pin.
    pub(crate) fn read(
        self,
        mechanism: &Mechanism,
        forces: &Forces,
        guide: impl Fn(SliderId) -> Pair<Ball>,
    ) -> Option<ForceRead> {
        Some(match self {
            ForceOf::Reaction(pin, body) => ForceRead::Vector(forces.at_pin(mechanism, pin, body)?),
            ForceOf::Normal(slider) => ForceRead::Number(forces.normal(mechanism, slider, guide(slider))),
            ForceOf::Couple(slider) => ForceRead::Number(forces.couple(mechanism, slider)),
            ForceOf::Torque(link) => ForceRead::Number(forces.torque(link)),
            ForceOf::Push(slider) => ForceRead::Number(forces.push(mechanism, slider, guide(slider))),
        })
    }
}

impl QuantityRequest {
    /// The value of a force.
    pub(super) fn force(
        &self,
        of: ForceOf,
        mechanism: &Mechanism,
        state: &impl State,
    ) -> Result<Quantity, QuantityError> {
        let found = in_equilibrium(mechanism, &Here { mechanism, state })
            .and_then(|forces| of.read(mechanism, &forces, |slider| Pair::from(state.guide(slider))));
        match found.ok_or_else(|| self.none(says::no_forces()))? {
            ForceRead::Number(number) => Ok(Quantity::Number(number.high)),
            ForceRead::Vector(vector) => Ok(Quantity::Vector(vector.rounded())),
        }
    }
}

/// A position with its rates, whose numbers count as exact.
struct Here<'a, S> {
    mechanism: &'a Mechanism,
    state: &'a S,
}

impl<S: State> Places for Here<'_, S> {
    fn place(&self, point: PointId) -> Pair<Ball> {
        self.state.place(point).coords.into()
    }

    fn arm(&self, from: PointId, to: PointId) -> Pair<Ball> {
        Pair::between(self.state.place(from), self.state.place(to))
    }

    fn guide(&self, slider: SliderId) -> Pair<Ball> {
        self.state.guide(slider).into()
    }

    fn given(&self, number: f64) -> Ball {
        number.into()
    }

    fn omega(&self, _: BodyId, omega: f64) -> Ball {
        omega.into()
    }
}

impl<S: State> Posed for Here<'_, S> {
    fn axis(&self, body: BodyId) -> Option<Pair<Ball>> {
        Some(Pair::from(self.state.axis(body)?).unit())
    }

    fn slide_position(&self, slider: SliderId) -> Option<Ball> {
        self.state.slide_position(slider).map(Ball::from)
    }

    fn local(&self, body: BodyId, point: PointId) -> Pair<Ball> {
        self.mechanism.local(body, point).coords.into()
    }

    fn acceleration(&self, body: BodyId, place: Pair<Ball>) -> Pair<Ball> {
        let [_, acceleration] = self.state.motion_at(body, Point::from(place.rounded()));
        acceleration.into()
    }

    fn alpha(&self, body: BodyId) -> Ball {
        let [_, alpha] = self.state.angular_rates(body);
        alpha.into()
    }
}
