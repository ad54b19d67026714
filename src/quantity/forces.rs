//! Forces in joints and drives as quantities, in a position with its rates.

use super::name::{ForceOf, QuantityError, QuantityRequest};
use super::says;
use super::value::{Quantity, State};
use crate::forces::{Forces, Posed, in_equilibrium};
use crate::geometry::{Pair, Point, Solvable, Vector};
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId};
use std::cell::OnceCell;

/// A force as read from all forces: a number or a vector.
pub(crate) enum ForceRead<N> {
    /// Across or along a guide, or a moment.
    Number(N),
    /// At a pin.
    Vector(Pair<N>),
}

/// The forces in a position, once they are found.
#[derive(Clone, Debug, Default)]
pub struct KeptForces(OnceCell<Option<Box<Forces<f64>>>>);

impl ForceOf {
    /// It among all forces; `guide` gives the directions of guides. `None` where the body has no joint with the pin.
    pub(crate) fn read<N: Solvable>(
        self,
        mechanism: &Mechanism,
        forces: &Forces<N>,
        guide: impl Fn(SliderId) -> Pair<N>,
    ) -> Option<ForceRead<N>> {
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
        let find = || in_equilibrium(mechanism, &Here { mechanism, state }).map(Box::new);
        let read = |forces: &Forces<f64>| of.read(mechanism, forces, |slider| state.guide(slider).into());
        let found = match state.kept_forces() {
            Some(KeptForces(kept)) => kept.get_or_init(find).as_deref().and_then(read),
            None => find().as_deref().and_then(read),
        };
        match found.ok_or_else(|| self.none(says::no_forces()))? {
            ForceRead::Number(number) => Ok(Quantity::Number(number)),
            ForceRead::Vector(Pair { x, y }) => Ok(Quantity::Vector(Vector::new(x, y))),
        }
    }
}

/// A position with its rates, whose numbers count as exact.
struct Here<'a, S> {
    mechanism: &'a Mechanism,
    state: &'a S,
}

impl<S: State> Posed<f64> for Here<'_, S> {
    fn place(&self, point: PointId) -> Pair<f64> {
        self.state.place(point).coords.into()
    }

    fn guide(&self, slider: SliderId) -> Pair<f64> {
        self.state.guide(slider).into()
    }

    fn given(&self, number: f64) -> f64 {
        number
    }

    fn axis(&self, body: BodyId) -> Option<Pair<f64>> {
        Some(self.state.axis(body)?.normalize().into())
    }

    fn slide_position(&self, slider: SliderId) -> Option<f64> {
        self.state.slide_position(slider)
    }

    fn local(&self, body: BodyId, point: PointId) -> Pair<f64> {
        self.mechanism.local(body, point).coords.into()
    }

    fn acceleration(&self, body: BodyId, place: Pair<f64>) -> Pair<f64> {
        let [_, acceleration] = self.state.motion_at(body, Point::new(place.x, place.y));
        acceleration.into()
    }

    fn alpha(&self, body: BodyId) -> f64 {
        let [_, alpha] = self.state.angular_rates(body);
        alpha
    }
}
