//! Values of quantities in a position.

use super::error::{Part, QuantityError, unknown};
use super::forces::KeptForces;
use super::name::{AccelerationPart, QuantityRequest, Spot, What};
use super::says;
use crate::construction::{Construction, Rate, Solution, image_name, normal_name};
use crate::geometry::{Point, Vector, degrees_of, quarter_turn};
use crate::mechanism::{BodyId, PointId, SliderId};
use crate::message::Message;
use crate::motion::Motion;
use crate::position::Pose;
use crate::scene::{Component, Head, QuantityName, SceneError};
use crate::sheet::{Order, Scales, Sheet};
use crate::text::shown;
use core::f64::consts::TAU;

/// The value of a quantity, in the scene's units; angles in degrees, rates in rad per unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// A number.
    Number(f64),
    /// A vector in the fixed frame.
    Vector(Vector),
}

impl Quantity {
    /// It as one number: of a vector its size.
    #[must_use]
    pub fn as_number(self) -> f64 {
        match self {
            Quantity::Number(x) => x,
            Quantity::Vector(v) => v.norm(),
        }
    }
}

impl Solution {
    /// The value of the quantity of that name, as `omega(2)`, `a_n(D/G)` or `vplan(b,s3)`. A length on paper (`/mu`)
    /// has no value here, as it needs the scales of a figure: use [`QuantityRequest::value`].
    ///
    /// # Errors
    /// [`QuantityError`]: the name is of no known form, or the quantity has no value here. For many positions look the
    /// name up once: [`QuantityRequest`].
    pub fn quantity(&self, name: &str) -> Result<Quantity, QuantityError> {
        QuantityRequest::new(name, &self.mechanism)?.value(&self.snapshot(), Some(&self.construction), None)
    }

    /// Refuses a scene that wants what lies between corners that its force polygons do not have.
    ///
    /// # Errors
    /// As [`Solution::whole_result`]; the place is that in the scene.
    pub fn check_corners(&self) -> Result<(), SceneError> {
        let is_of_corners =
            |name: &str| QuantityName::parse(name).is_some_and(|name| name.head == Head::Between(Sheet::Forces));
        let wanted = self.scene.want.iter().flatten().enumerate().filter(|(_, name)| is_of_corners(name));
        for (index, name) in wanted {
            let found = QuantityRequest::new(name, &self.mechanism).and_then(|asked| match &asked.what {
                What::Corners(corners) => {
                    let state = &self.snapshot();
                    Reader { asked: &asked, state, construction: Some(&self.construction) }.corners(&corners.ends)?;
                    Ok(())
                }
                _ => Ok(()),
            });
            found.map_err(|error| self.scene.error_at(&["want", &index.to_string()], error.problem().message, None))?;
        }
        Ok(())
    }

    /// Position and motion together, from which quantities are evaluated.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot<'_> {
        Snapshot { pose: &self.pose, motion: &self.motion }
    }
}

impl QuantityRequest {
    /// Its value. `scales` are needed only for lengths on paper, `construction` only where
    /// [`Self::needs_construction`].
    ///
    /// # Errors
    /// [`QuantityError::NoValue`], and [`QuantityError::Unknown`] for a point that the plan does not have.
    pub fn value(
        &self,
        state: &impl State,
        construction: Option<&Construction>,
        scales: Option<&Scales>,
    ) -> Result<Quantity, QuantityError> {
        use Quantity::{Number, Vector};
        if self.needs_accelerations && !state.has_accelerations() {
            return Err(self.none(says::no_accelerations()));
        }
        let reader = Reader { asked: self, state, construction };
        let value = match &self.what {
            What::Rate(Rate::Angular(order, link)) => Number(state.angular_rates(*link)[*order]),
            What::Rate(Rate::Slide(order, id)) => Number(state.slide_rates(*id)[*order]),
            What::RelativeRate(order, links) => {
                let [own, other] = links.map(|link| state.angular_rates(link)[*order]);
                Number(own - other)
            }
            What::SpeedRatio(links) => {
                let [own, other] = links.map(|link| state.angular_rates(link)[Order::Velocity]);
                let ratio = own / other;
                if !ratio.is_finite() {
                    return Err(self.none(says::ratio_to_rest(self.argument(1))));
                }
                Number(ratio)
            }
            What::Rpm(link, time) => Number(state.angular_rates(*link)[Order::Velocity] * time.in_a_minute() / TAU),
            What::Angle(link) => {
                let axis = state.axis(*link);
                Number(degrees_of(axis.ok_or_else(|| self.none(says::no_axis()))?))
            }
            What::SlidePosition(id) => {
                let position = state.slide_position(*id);
                Number(position.ok_or_else(|| self.none(says::no_zero()))?)
            }
            What::Coriolis(id, on) => {
                let twice = 2.0 * state.angular_rates(*on)[0] * state.slide_rates(*id)[0];
                Vector(quarter_turn(state.guide(*id)) * twice)
            }
            What::Coordinate(axis, spot) => Number(reader.place(spot)?.1[*axis]),
            What::Length(a, b) => Number((reader.spot(b)? - reader.spot(a)?).norm()),
            What::Motion(order, a, b) => Vector(reader.difference(*order, a, b.as_ref())?),
            What::Part(part, a, b, link) => {
                let [normal, tangential] = reader.parts(a, b, *link)?;
                Vector(match part {
                    AccelerationPart::Normal => normal,
                    AccelerationPart::Tangential => tangential,
                })
            }
            What::Pole(pole) if self.written.component == Some(Component::Angle) => {
                Number(degrees_of(self.direction_of(pole, state)?))
            }
            What::Pole(pole) => Vector(self.place_of(pole, state)?.coords),
            What::InflectionDiameter(pole) => Number(self.diameter(pole, state)?),
            What::PathRadius(spot) => {
                let (body, place) = reader.place(spot)?;
                Number(self.path_radius(body, place, state)?)
            }
            What::Force(of, compiled) => reader.force(of, compiled)?,
            What::Segment(order, ends) if self.written.component.is_some() => Vector(reader.segment(*order, ends)?),
            What::Segment(order, ends) if !self.written.on_paper => Number(reader.segment(*order, ends)?.norm()),
            What::Corners(corners) => {
                let side = match &corners.way {
                    Some((way, compiled)) => reader.along(way, compiled)?,
                    None => reader.corners(&corners.ends)?,
                };
                match self.written.component {
                    Some(_) => Vector(side),
                    None if self.written.on_paper => Number(self.on_paper(side.norm(), Sheet::Forces, scales)?),
                    None => Number(side.norm()),
                }
            }
            What::Segment(order, ends) => {
                let length = reader.segment(*order, ends)?.norm();
                Number(self.on_paper(length, order.sheet(), scales)?)
            }
        };
        Ok(self.component(value))
    }

    /// So much of a sheet, in millimetres of its paper.
    fn on_paper(&self, length: f64, sheet: Sheet, scales: Option<&Scales>) -> Result<f64, QuantityError> {
        let mu = scales.and_then(|scales| scales[sheet]);
        let mm = length / mu.ok_or_else(|| self.none(says::no_plan_no_scale()))?;
        if mm.is_finite() { Ok(mm) } else { Err(self.none(says::scale_too_small())) }
    }

    /// That component of a vector that is asked for.
    pub(super) fn component(&self, value: Quantity) -> Quantity {
        use Quantity::{Number, Vector};
        match (value, self.written.component) {
            (Vector(v), Some(component)) => Number(match component {
                Component::X => v.x,
                Component::Y => v.y,
                Component::Size => v.norm(),
                Component::Angle => degrees_of(v),
            }),
            (value, _) => value,
        }
    }

    /// What stands in its parentheses at this index, as a message quotes it.
    fn argument(&self, index: usize) -> String {
        self.written.arguments.get(index).map_or_else(String::new, |name| shown(name))
    }

    pub(super) fn none(&self, why: Message) -> QuantityError {
        QuantityError::NoValue(self.name.clone(), why)
    }
}

/// Evaluates a quantity in a position.
pub(super) struct Reader<'a, S: State> {
    pub asked: &'a QuantityRequest,
    pub state: &'a S,
    construction: Option<&'a Construction>,
}

impl<S: State> Reader<'_, S> {
    /// The coordinates of a named place or pole.
    fn spot(&self, spot: &Spot) -> Result<Point, QuantityError> {
        match spot {
            Spot::Pole(pole) => self.asked.place_of(pole, self.state),
            _ => Ok(self.place(spot)?.1),
        }
    }

    /// The body to which a named place belongs, and its coordinates.
    pub(super) fn place(&self, spot: &Spot) -> Result<(BodyId, Point), QuantityError> {
        match spot {
            Spot::Point(body, point, _) => Ok((*body, self.state.place(*point))),
            Spot::Special(name) => {
                let special = self.construction.and_then(|c| c.special_point(name));
                let special = special.ok_or_else(|| self.asked.none(says::no_construction()))?;
                let place = special.place.finite();
                let place = place.ok_or_else(|| self.asked.none(says::at_infinity()))?;
                Ok((special.link, place))
            }
            // Only lengths are measured to poles, which belong to no one body.
            Spot::Pole(_) => Err(self.asked.none(says::not_on_one_link())),
        }
    }

    /// The vector of place `a` in a plan, its velocity or its acceleration, minus that of `b`.
    fn difference(&self, order: Order, a: &Spot, b: Option<&Spot>) -> Result<Vector, QuantityError> {
        let of = |spot: &Spot| -> Result<Vector, QuantityError> {
            let (body, place) = self.place(spot)?;
            Ok(self.state.motion_at(body, place)[order])
        };
        Ok(of(a)? - b.map_or(Ok(Vector::zeros()), of)?)
    }

    /// Normal and tangential part of the acceleration of `a` relative to `b`.
    fn parts(&self, a: &Spot, b: &Spot, link: Option<BodyId>) -> Result<[Vector; 2], QuantityError> {
        let plan = self.construction.and_then(|c| c.plan(Order::Acceleration));
        if let (Spot::Special(special), Some(plan)) = (a, plan) {
            // The normal part starts at the image of `b`, or at the end of the parts of driven sliders laid off from
            // there; the Coriolis acceleration of the leg's slider, along the same line, counts with it.
            let ends = self.construction.and_then(|c| c.known_parts.get(&normal_name(b.name(), special)));
            let parts =
                ends.and_then(|[start, end]| plan.segment(start, end).zip(plan.segment(end, &image_name(special))));
            if let Some((normal, tangential)) = parts {
                return Ok([normal, tangential]);
            }
        }
        let arm = self.place(a)?.1 - self.place(b)?.1;
        let link = link.ok_or_else(|| self.asked.none(says::not_on_one_link()))?;
        let [omega, alpha] = self.state.angular_rates(link);
        Ok([arm * -(omega * omega), quarter_turn(arm) * alpha])
    }

    /// From one corner of a force polygon to another, in the scene's unit of force.
    fn corners(&self, ends: &[String; 2]) -> Result<Vector, QuantityError> {
        let none = |why: Message| self.asked.none(why);
        let construction = self.construction.ok_or_else(|| none(says::no_force_plan()))?;
        let drawn = construction.forces.as_deref().filter(|plan| !plan.polygons.is_empty());
        let plan = drawn.ok_or_else(|| none(says::no_force_plan()))?;
        let corner = |name: &String| {
            let known = || plan.named_corners().map(|(name, _)| name);
            plan.corner(name).ok_or_else(|| unknown(&self.asked.name, Part::PlanPoint, name, known()))
        };
        let [from, to] = [corner(&ends[0])?, corner(&ends[1])?];
        match from.polygon == to.polygon {
            _ if !plan.agrees() => Err(none(says::routes_differ())),
            true => Ok(to.at - from.at),
            false => Err(none(says::two_polygons())),
        }
    }

    /// The length of a plan segment, in the plan's units.
    fn segment(&self, order: Order, ends: &[String; 2]) -> Result<Vector, QuantityError> {
        let construction = self.construction.ok_or_else(|| self.asked.none(says::no_construction()))?;
        let plan = construction.plan(order).ok_or_else(|| self.asked.none(says::no_plan()))?;
        let [from, to] = ends.each_ref().map(|name| construction.plan_name(order, name));
        for name in [from, to] {
            if !plan.points.contains_key(name) {
                let known = plan.points.keys().map(String::as_str);
                return Err(unknown(&self.asked.name, Part::PlanPoint, name, known));
            }
        }
        Ok(plan.segment(from, to).unwrap_or_default())
    }
}

/// A position with its rates, as far as quantities are evaluated from it; in the fixed frame and in the scene's units.
pub trait State {
    /// Whether accelerations have been computed.
    fn has_accelerations(&self) -> bool;
    /// The place of a point.
    fn place(&self, point: PointId) -> Point;
    /// A vector along a link's axis; `None` for a link without one.
    fn axis(&self, link: BodyId) -> Option<Vector>;
    /// The unit direction of a slider's guide.
    fn guide(&self, slider: SliderId) -> Vector;
    /// A slider's position along its guide; `None` if there is no point to count from.
    fn slide_position(&self, slider: SliderId) -> Option<f64>;
    /// A slider's velocity and acceleration along its guide.
    fn slide_rates(&self, slider: SliderId) -> [f64; 2];
    /// A body's angular velocity and acceleration, in rad per unit of time.
    fn angular_rates(&self, body: BodyId) -> [f64; 2];
    /// Velocity and acceleration of the body's point at a place.
    fn motion_at(&self, body: BodyId, place: Point) -> [Vector; 2];
    /// Where the forces here are kept once they are found, so that all quantities that ask for them share them; `None` where each
    /// finds them anew.
    fn kept_forces(&self) -> Option<&KeptForces> {
        None
    }
}

/// A pose and its motion.
#[derive(Clone, Copy, Debug)]
pub struct Snapshot<'a> {
    /// The position.
    pub pose: &'a Pose,
    /// Its rates.
    pub motion: &'a Motion,
}

impl State for Snapshot<'_> {
    fn has_accelerations(&self) -> bool {
        self.motion.order == Order::Acceleration
    }

    fn place(&self, point: PointId) -> Point {
        self.pose.point(point)
    }

    fn axis(&self, link: BodyId) -> Option<Vector> {
        self.pose.axes[link.0]
    }

    fn guide(&self, slider: SliderId) -> Vector {
        self.pose.guide(slider)
    }

    fn slide_position(&self, slider: SliderId) -> Option<f64> {
        self.pose.slides[slider.0]
    }

    fn slide_rates(&self, slider: SliderId) -> [f64; 2] {
        let slide = self.motion.slide(slider);
        [slide.velocity, slide.acceleration]
    }

    fn angular_rates(&self, body: BodyId) -> [f64; 2] {
        let body = self.motion.body(body);
        [body.omega, body.alpha]
    }

    fn motion_at(&self, body: BodyId, place: Point) -> [Vector; 2] {
        let body = self.motion.body(body);
        [body.velocity_at(place), body.acceleration_at(place)]
    }
}
