use super::Bounds;
use crate::construction::Rate;
use crate::geometry::UNIT_ROUNDOFF;
use crate::mechanism::BodyId;
use crate::quantity::{AccelerationPart, Component, Quantity, QuantityRequest, Snapshot, Spot, What};
use core::f64::consts::SQRT_2;

/// Roundings in a number that is read from a pose and its motion.
const ROUNDINGS: f64 = 8.0 * UNIT_ROUNDOFF;

/// Whether [`Bounds::of`] bounds the error of a quantity: all but special points and what is measured on a plan.
#[must_use]
pub(crate) fn is_bounded(asked: &QuantityRequest) -> bool {
    let joint = |spot: &Spot| matches!(spot, Spot::Point(..));
    match asked.what() {
        What::Coordinate(_, spot) => joint(spot),
        What::Length(a, b) => joint(a) && joint(b),
        What::Motion(_, a, b) => joint(a) && b.as_ref().is_none_or(joint),
        What::Part(_, a, b, link) => link.is_some() && joint(a) && joint(b),
        What::Segment { .. } => false,
        _ => true,
    }
}

impl Bounds<'_> {
    /// Bound of the error of a quantity: of a vector in each component, of angles in degrees.
    ///
    /// `None` for special points and for what is measured on a plan, and for the direction of a vector that may be zero.
    #[must_use]
    pub fn of(&self, asked: &QuantityRequest) -> Option<f64> {
        let state = Snapshot { pose: self.pose, motion: self.motion };
        let whole = asked.without_component().value(&state, None, None).ok()?;
        let rounding = |whole: &Quantity| match whole {
            Quantity::Number(x) => x.abs() * ROUNDINGS,
            Quantity::Vector(v) => v.norm() * ROUNDINGS,
        };
        let bound = match asked.what() {
            What::Rate(rate) => {
                let bounds = match *rate {
                    Rate::Omega(link) | Rate::Alpha(link) => self.angular_rates(link),
                    Rate::SlideVelocity(slider) | Rate::SlideAcceleration(slider) => self.slide(slider),
                };
                bounds[rate.sheet().order()]
            }
            What::Angle(link) => self.angle(*link)?,
            What::SlidePosition(slider) => self.slide_position(*slider)?,
            What::Coriolis(slider, _) => self.coriolis(*slider),
            What::Coordinate(_, spot) => self.of_place(spot)?,
            What::Length(a, b) => SQRT_2 * (self.of_place(a)? + self.of_place(b)?) + rounding(&whole),
            What::Motion(sheet, a, b) => self.of_motion(sheet.order(), a, b.as_ref())?,
            What::Part(part, a, b, link) => self.of_part(*part, a, b, (*link)?)?,
            What::Segment { .. } => return None,
        };
        let (Quantity::Vector(whole), off) = (whole, SQRT_2 * bound) else {
            return Some(bound);
        };
        match asked.component() {
            Some(Component::Size) => Some(off + whole.norm() * ROUNDINGS),
            Some(Component::Angle) => {
                (off < whole.norm()).then(|| libm::asin(off / whole.norm()).to_degrees() + 180.0 * ROUNDINGS)
            }
            _ => Some(bound),
        }
    }

    /// Bound of the error of a place's coordinates.
    fn of_place(&self, spot: &Spot) -> Option<f64> {
        let Spot::Point(_, point, _) = spot else {
            return None;
        };
        Some(self.place(*point))
    }

    /// Bound of the error of a velocity (order 0) or acceleration (order 1), or of the difference of two.
    fn of_motion(&self, order: usize, a: &Spot, b: Option<&Spot>) -> Option<f64> {
        let of = |spot: &Spot| {
            let Spot::Point(body, point, _) = spot else {
                return None;
            };
            Some(self.motion_of(*body, *point)[order])
        };
        // The difference of two is rounded once more.
        let size = |spot: &Spot| match spot {
            Spot::Point(body, point, _) => {
                let (motion, at) = (self.motion.body(*body), self.pose.point(*point));
                [motion.velocity_at(at), motion.acceleration_at(at)][order].norm()
            }
            _ => 0.0,
        };
        match b {
            Some(b) => Some(of(a)? + of(b)? + ROUNDINGS * (size(a) + size(b))),
            None => of(a),
        }
    }

    /// Bound of the error of the normal or tangential part of a relative acceleration within a link.
    fn of_part(&self, part: AccelerationPart, a: &Spot, b: &Spot, link: BodyId) -> Option<f64> {
        let (Spot::Point(_, first, _), Spot::Point(_, second, _)) = (a, b) else {
            return None;
        };
        let arm = self.pose.arm(*second, *first).norm();
        let off = self.of_place(a)? + self.of_place(b)?;
        let ([omega, alpha], motion) = (self.angular_rates(link), self.motion.body(link));
        let (factor, error) = match part {
            AccelerationPart::Normal => (motion.omega * motion.omega, (2.0 * motion.omega.abs() + omega) * omega),
            AccelerationPart::Tangential => (motion.alpha.abs(), alpha),
        };
        Some(error * arm + (factor + error) * off + factor * arm * ROUNDINGS)
    }
}
