//! Bounds of the errors of quantities: each is read from the enclosure as its value is from the pose.

use super::bounds::{Bounds, of_printing};
use super::enclosure::Enclosure;
use super::given::{Vector, radians_of_rpm};
use crate::construction::{Rate, image_name, normal_name};
use crate::geometry::{Ball, Number};
use crate::mechanism::BodyId;
use crate::quantity::{AccelerationPart, Component, ForceRead, Quantity, QuantityRequest, Spot, What};
use crate::sheet::{Order, Scales};

/// The true value of a quantity, with its bound.
pub(super) enum TrueValue {
    Number(Ball),
    Vector(Vector),
}

impl Bounds<'_> {
    /// Bound of the error of a quantity, as [`QuantityRequest::value`] has it: of a vector in each component, of angles in
    /// degrees, of lengths on paper in millimetres by the `scales`.
    ///
    /// Infinite where none can be given: beside what holds for all numbers, of the direction of a vector that may be zero, and
    /// of special points and what is measured on a plan [without a construction](Self::with_plans).
    #[must_use]
    pub fn of(&self, asked: &QuantityRequest, scales: Option<&Scales>) -> f64 {
        match &asked.what {
            What::Rate(Rate::Angular(order, link)) => return self.angular_rates(*link)[*order],
            What::Rate(Rate::Slide(order, slider)) => return self.slide(*slider)[*order],
            What::Angle(link) => return self.angle(*link).unwrap_or(f64::INFINITY),
            What::SlidePosition(slider) => return self.slide_position(*slider).unwrap_or(f64::INFINITY),
            What::Coordinate(_, Spot::Point(_, point, _)) => return self.place(*point),
            _ => {}
        }
        let of = |e: &Enclosure| self.true_value(e, asked);
        let Ok(value) = asked.value(&self.snapshot(), self.construction, scales) else { return f64::INFINITY };
        match (value, asked.written.component) {
            // The direction of a centre at infinity: `center` has it.
            (_, Some(Component::Angle)) if asked.is_place() => f64::INFINITY,
            (Quantity::Number(value), Some(Component::Angle)) => self.from(of, |truth| match truth {
                TrueValue::Vector(truth) => truth.degrees_from(value) + of_printing(value),
                TrueValue::Number(_) => f64::INFINITY,
            }),
            (Quantity::Number(value), component) => {
                let mu = match &asked.what {
                    What::Segment(..) | What::Corners(_) if asked.written.on_paper => {
                        scales.and_then(|all| all[asked.sheet()])
                    }
                    _ => None,
                };
                self.from(of, |truth| {
                    let number = match (truth, component) {
                        (TrueValue::Number(number), _) => number,
                        (TrueValue::Vector(v), Some(Component::X)) => v.x,
                        (TrueValue::Vector(v), Some(Component::Y)) => v.y,
                        (TrueValue::Vector(v), _) => v.dot(v).sqrt(),
                    };
                    self.of_number(mu.map_or(number, |mu| number / Ball::decimal(mu)), value)
                })
            }
            (Quantity::Vector(value), _) => self.from(of, |truth| match truth {
                TrueValue::Vector(truth) => self.of_vector(truth, value),
                TrueValue::Number(_) => f64::INFINITY,
            }),
        }
    }

    /// The true value, of a vector's component the whole vector; `None` where it cannot be had.
    pub(super) fn true_value(&self, e: &Enclosure, asked: &QuantityRequest) -> Option<TrueValue> {
        Some(match &asked.what {
            What::RelativeRate(order, links) => {
                let [own, other] = links.map(|link| e.angular_rates(link)[*order]);
                TrueValue::Number(own - other)
            }
            What::SpeedRatio(links) => {
                let [own, other] = links.map(|link| e.angular_rates(link)[Order::Velocity]);
                TrueValue::Number(own / other)
            }
            What::Rpm(link, time) => TrueValue::Number(e.angular_rates(*link)[Order::Velocity] / radians_of_rpm(*time)),
            What::Coriolis(slider, on) => TrueValue::Vector(e.coriolis(*slider, *on)),
            What::Coordinate(axis, spot) => {
                let (_, place) = self.true_place(e, spot)?;
                TrueValue::Number([place.x, place.y][*axis])
            }
            What::Length(a, b) => {
                let place = |spot: &Spot| match spot {
                    Spot::Pole(pole) => e.pole(pole, |x| self.scene.as_written(x)),
                    _ => self.true_place(e, spot).map(|(_, place)| place),
                };
                let arm = place(b)? - place(a)?;
                TrueValue::Number(arm.dot(arm).sqrt())
            }
            What::Motion(order, a, b) => {
                let motion = |spot: &Spot| {
                    let (body, place) = self.true_place(e, spot)?;
                    Some(e.motion_at(body, place)[*order])
                };
                TrueValue::Vector(match b {
                    Some(b) => motion(a)? - motion(b)?,
                    None => motion(a)?,
                })
            }
            What::Part(part, a, b, link) => TrueValue::Vector(self.true_part(e, *part, [a, b], *link)?),
            What::Segment(order, [from, to]) => TrueValue::Vector(self.true_segment(*order, [from, to])?),
            What::Corners(corners) => {
                let plan = self.construction.and_then(|drawn| drawn.forces.as_deref());
                let way = corners.way(plan, self.mechanism)?;
                TrueValue::Vector(way.read(self.mechanism, self.forces()?, &self.loaded(e))?)
            }
            What::Pole(pole) => TrueValue::Vector(e.pole(pole, |x| self.scene.as_written(x))?),
            What::InflectionDiameter(pole) => TrueValue::Number(e.diameter(pole)),
            What::PathRadius(spot) => {
                let (body, place) = self.true_place(e, spot)?;
                TrueValue::Number(e.path_radius(body, place))
            }
            What::Force(of, compiled) => {
                let about = of.about().and_then(|spot| self.true_place(e, spot)).map(|(_, place)| place);
                match of.read(&compiled.mechanism, self.forces()?, &self.loaded(e), about)? {
                    ForceRead::Number(number) => TrueValue::Number(number),
                    ForceRead::Vector(vector) => TrueValue::Vector(vector),
                }
            }
            What::Rate(_) | What::Angle(_) | What::SlidePosition(_) => return None,
        })
    }

    /// The body to which a named place belongs, and the true place.
    fn true_place(&self, e: &Enclosure, spot: &Spot) -> Option<(BodyId, Vector)> {
        match spot {
            Spot::Point(body, point, _) => Some((*body, e.place(*point))),
            Spot::Special(name) => {
                let special = self.construction?.special_point(name)?;
                Some((special.link, e.special(special)?))
            }
            Spot::Pole(_) => None,
        }
    }

    fn true_segment(&self, order: Order, ends: [&str; 2]) -> Option<Vector> {
        self.construction?.enclosed_segment(self.plans()?, order, ends)
    }

    /// Normal or tangential part of the acceleration of `a` relative to `b`: of a special point as its plan has it.
    fn true_part(
        &self,
        e: &Enclosure,
        part: AccelerationPart,
        [a, b]: [&Spot; 2],
        link: Option<BodyId>,
    ) -> Option<Vector> {
        if let Spot::Special(special) = a
            && let Some([start, end]) = self.construction?.known_parts.get(&normal_name(b.name(), special))
        {
            let image = image_name(special);
            let ends = match part {
                AccelerationPart::Normal => [start.as_str(), end],
                AccelerationPart::Tangential => [end.as_str(), &image],
            };
            return self.true_segment(Order::Acceleration, ends);
        }
        let arm = self.true_place(e, a)?.1 - self.true_place(e, b)?.1;
        let [omega, alpha] = e.angular_rates(link?);
        Some(match part {
            AccelerationPart::Normal => arm * -(omega * omega),
            AccelerationPart::Tangential => arm.quarter_turn() * alpha,
        })
    }
}
