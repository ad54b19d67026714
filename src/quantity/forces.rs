//! Forces in joints and drives as quantities, in a position with its rates.

use super::error::QuantityError;
use super::force_name::{ArmPoint, ForceOf, LinePart, LoadOf, Towards};
use super::name::{QuantityRequest, Spot, What};
use super::says;
use super::value::{Quantity, Reader, State};
use super::ways::ForceWay;
use crate::forces::{Acting, Compiled, Counted, Forces, Posed, Source, center};
use crate::geometry::{Pair, Point, Several, Vector};
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
    /// It among all forces of a position; `about` is the place about which it is a moment. `None` where the body has no joint with the
    /// pin, and without that place.
    pub(crate) fn read<N: Counted>(
        &self,
        mechanism: &Mechanism,
        forces: &Forces<N>,
        posed: &impl Posed<N>,
        about: Option<Pair<N>>,
    ) -> Option<ForceRead<N>> {
        use ForceRead::{Number, Vector};
        let load = |of: &LoadOf| forces.load(of.source, of.body);
        // At a pin of several links friction acts from each of the others on the link in which the pin is fixed.
        let alike = |of: LoadOf| forces.acting.iter().filter(move |load| of.is(mechanism, load.source, load.body));
        let inertia = |body: BodyId| forces.load(Source::Inertia, body);
        Some(match *self {
            ForceOf::Reaction(pin, body) => Vector(forces.at_pin(mechanism, pin, body)?),
            ForceOf::ReactionPart(part, pin, body, towards) => {
                let line = part.direction(pin, towards, posed);
                Number(forces.at_pin(mechanism, pin, body)?.dot(line) / line.dot(line).sqrt())
            }
            ForceOf::Normal(slider) => Number(forces.normal(mechanism, slider, posed.guide(slider))),
            ForceOf::Couple(slider) => Number(forces.couple(mechanism, slider)),
            ForceOf::Offset(slider) => {
                Number(forces.couple(mechanism, slider) / forces.normal(mechanism, slider, posed.guide(slider)))
            }
            ForceOf::Torque(link) => Number(forces.torque(link)),
            ForceOf::Push(slider) => Number(forces.push(mechanism, slider, posed.guide(slider))),
            ForceOf::InertiaForce(link) => Vector(inertia(link)?.force),
            ForceOf::InertiaCouple(link) => Number(inertia(link)?.couple),
            ForceOf::Friction(slider) => Number(forces.friction_along(mechanism, slider, posed.guide(slider))),
            ForceOf::FrictionCouple(pin, body) => Number(forces.friction_at_pin(mechanism, pin, body)),
            ForceOf::CenterAcceleration(link) => Vector(posed.acceleration(link, center(mechanism, posed, link)?)),
            ForceOf::LoadMoment(ref of, _) => {
                let about = about?;
                let moment = |load: &Acting<N>| (load.at - about).cross(load.force) + load.couple;
                Number(alike(*of).map(moment).reduce(|sum, moment| sum + moment)?)
            }
            ForceOf::Arm(ref of, ref point) => {
                let about = match point {
                    ArmPoint::Spot(_) => about?,
                    ArmPoint::Crossing(lines) => {
                        let [first, second] = lines.each_ref().map(|of| of.line(mechanism, forces, posed));
                        crossing(first?, second?)
                    }
                };
                let (at, along) = of.line(mechanism, forces, posed)?;
                let moment = (at - about).cross(along);
                Number(moment.larger(-moment) / along.dot(along).sqrt())
            }
            ForceOf::Load(ref of) => Vector(load(of)?.force),
            ForceOf::Power(ref of) => {
                let power = |load: &Acting<N>| {
                    let (velocity, omega) = posed.rates(load.body, load.at);
                    load.force.dot(velocity) + load.couple * omega
                };
                Number(alike(*of).map(power).reduce(|sum, power| sum + power)?)
            }
            ForceOf::Shaking => Vector(forces.frame.force),
            ForceOf::ShakingMoment(_) => Number(forces.frame_moment(mechanism, posed, about?)),
        })
    }
}

impl ForceOf {
    /// A place of its line of action and the line's direction, not of unit length; `None` of what is no force with a line. What a guide
    /// carries has its couple beside it, so its line runs through the slider's point.
    fn line<N: Counted>(
        &self,
        mechanism: &Mechanism,
        forces: &Forces<N>,
        posed: &impl Posed<N>,
    ) -> Option<(Pair<N>, Pair<N>)> {
        Some(match *self {
            ForceOf::Load(of) => {
                let load = forces.load(of.source, of.body)?;
                (load.at, load.force)
            }
            ForceOf::Reaction(pin, body) => (posed.place(pin), forces.at_pin(mechanism, pin, body)?),
            ForceOf::ReactionPart(part, pin, _, towards) => (posed.place(pin), part.direction(pin, towards, posed)),
            ForceOf::Normal(slider) => {
                let point = mechanism.joint_point(mechanism.slider_joint(slider));
                (posed.place(point), posed.guide(slider).quarter_turn())
            }
            _ => return None,
        })
    }
}

/// A part of what a joint does to a body as a vector; `None` of what is no such part.
pub(super) fn part_as_vector<N: Counted>(
    of: &ForceOf,
    on: BodyId,
    mechanism: &Mechanism,
    forces: &Forces<N>,
    posed: &impl Posed<N>,
) -> Option<Pair<N>> {
    let (force, receives) = match *of {
        ForceOf::ReactionPart(part, pin, body, towards) => {
            let along = part.direction(pin, towards, posed);
            (along * (forces.at_pin(mechanism, pin, body)?.dot(along) / along.dot(along)), body)
        }
        ForceOf::Normal(slider) => {
            let guide = posed.guide(slider);
            (guide.quarter_turn() * forces.normal(mechanism, slider, guide), mechanism.slider(slider).link)
        }
        _ => return None,
    };
    Some(if receives == on { force } else { -force })
}

impl LinePart {
    /// The direction of this part of what a pin does, not of unit length.
    fn direction<N: Counted>(self, pin: PointId, towards: Towards, posed: &impl Posed<N>) -> Pair<N> {
        let line = match towards {
            Towards::Point(other) => posed.place(other) - posed.place(pin),
            Towards::Guide(slider) => posed.guide(slider).quarter_turn(),
        };
        if self == LinePart::Along { line } else { line.quarter_turn() }
    }
}

/// Where two lines cross, each by a place and a direction: infinite or NaN where they are parallel.
fn crossing<N: Counted>((at, along): (Pair<N>, Pair<N>), (through, other): (Pair<N>, Pair<N>)) -> Pair<N> {
    at + along * ((through - at).cross(other) / along.cross(other))
}

impl<S: State> Reader<'_, S> {
    /// What is read from the forces of the position, which are found once.
    fn among_forces<T>(
        &self,
        compiled: &Compiled,
        read: impl FnOnce(&Forces<f64>, &Here<'_, S>) -> Option<T>,
    ) -> Option<T> {
        let here = Here { mechanism: &compiled.mechanism, state: self.state };
        let find = || compiled.forces(&here).map(Box::new);
        match self.state.kept_forces() {
            Some(KeptForces(kept)) => kept.get_or_init(find).as_deref().and_then(|forces| read(forces, &here)),
            None => find().as_deref().and_then(|forces| read(forces, &here)),
        }
    }

    /// What several forces add up to.
    pub(super) fn along(&self, way: &ForceWay, compiled: &Compiled) -> Result<Vector, QuantityError> {
        let found = self.among_forces(compiled, |forces, here| way.read(&compiled.mechanism, forces, here));
        let Pair { x, y } = found.ok_or_else(|| self.asked.none(says::no_forces()))?;
        Ok(Vector::new(x, y))
    }

    /// The value of a force.
    pub(super) fn force(&self, of: &ForceOf, compiled: &Compiled) -> Result<Quantity, QuantityError> {
        let about = of.about().map(|spot| self.place(spot)).transpose()?.map(|(_, place)| place.coords.into());
        let found = self.among_forces(compiled, |forces, here| of.read(&compiled.mechanism, forces, here, about));
        match found.ok_or_else(|| self.asked.none(says::no_forces()))? {
            ForceRead::Number(number) if number.is_finite() => Ok(Quantity::Number(number)),
            ForceRead::Number(_) if matches!(of, ForceOf::Arm(..)) => Err(self.asked.none(says::no_line_of_action())),
            ForceRead::Number(_) => Err(self.asked.none(says::no_normal_force())),
            ForceRead::Vector(Pair { x, y }) => Ok(Quantity::Vector(Vector::new(x, y))),
        }
    }
}

impl QuantityRequest {
    /// What loads and joints do in the mechanism, where this is a force that needs no more than places and rates of links: one that is
    /// found at several positions at once.
    pub(crate) fn force_of_links(&self) -> Option<&Compiled> {
        match &self.what {
            What::Force(of, compiled) if matches!(of.about(), None | Some(Spot::Point(..))) => Some(compiled),
            _ => None,
        }
    }

    /// This force among all forces of several positions.
    pub(crate) fn among(
        &self,
        mechanism: &Mechanism,
        forces: &Forces<Several>,
        posed: &impl Posed<Several>,
    ) -> Option<ForceRead<Several>> {
        let What::Force(of, _) = &self.what else { return None };
        let about = match of.about() {
            Some(Spot::Point(_, point, _)) => Some(posed.place(*point)),
            _ => None,
        };
        of.read(mechanism, forces, posed, about)
    }

    /// What was found for one of several positions; `None` where it is infinite.
    pub(crate) fn of_one(&self, found: &ForceRead<Several>, lane: usize) -> Option<Quantity> {
        match found {
            ForceRead::Number(number) => {
                let number = number.0[lane];
                number.is_finite().then_some(Quantity::Number(number))
            }
            ForceRead::Vector(Pair { x, y }) => {
                Some(self.component(Quantity::Vector(Vector::new(x.0[lane], y.0[lane]))))
            }
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

    fn rates(&self, body: BodyId, place: Pair<f64>) -> (Pair<f64>, f64) {
        let [velocity, _] = self.state.motion_at(body, Point::new(place.x, place.y));
        let [omega, _] = self.state.angular_rates(body);
        (velocity.into(), omega)
    }

    fn alpha(&self, body: BodyId) -> f64 {
        let [_, alpha] = self.state.angular_rates(body);
        alpha
    }
}
