//! Inflection circles: the inflection pole of a link by its pole tangent and one pin whose path has a known centre of curvature.
//!
//! Let P be the instant centre of the link against the frame, A a pin, A₀ the centre of curvature of its path. On the ray from P the point J with
//! A J · A A₀ = A P², on the same side of A as A₀, passes an inflection of its path (L. Euler 1765, F. Savary 1845; A. S. Hall, *Kinematics and Linkage Design*, 1961,
//! ch. 5); where A₀ lies at infinity it is A itself. J and P lie on the inflection circle, and so, by Thales, the normal to the ray in J meets the normal to the pole
//! tangent in P in the other end of the diameter from P: the inflection pole W.

use super::{CenterOrigin, CurvatureStep, PoleTangent, Spot};
use crate::centers::Moved;
use crate::construction::constructed::Agreement;
use crate::construction::number::{End, Equation, NumberKind, Product, ProductKind};
use crate::construction::operation::{Along, LineId, MeasuredAs, OperationRole, PlaceId};
use crate::construction::step::Action;
use crate::construction::writer::Writer;
use crate::geometry::{Ball, Pair, Place, UNIT_ROUNDOFF, Vector};
use crate::mechanism::BodyId;
use crate::motion::Motion;
use crate::scene::Head;
use crate::sheet::{Order, Sheet};

/// The inflection pole of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Inflection {
    /// The link's pole tangent: index among [`Centers::tangents`](super::Centers::tangents).
    pub tangent: usize,
    /// Which of its two rays is taken.
    pub by: usize,
    /// The point of that ray that passes an inflection.
    pub point: Place,
    /// The inflection pole.
    pub pole: Place,
    /// The diameter of the inflection circle.
    pub diameter: f64,
    /// Names of the distance that is measured for the point; none where it is the pin.
    pub measured: Vec<String>,
    /// Names of the pole's coordinates and of the diameter.
    pub found: Vec<String>,
    /// How the pole agrees with that of the computed motion, in parts of the diameter or of the mechanism's size, whichever is larger; none without accelerations.
    pub agreement: Option<Agreement>,
}

impl Writer<'_> {
    /// Draws the inflection pole of a link; nothing where it cannot be found.
    pub(super) fn inflection(&mut self, link: BodyId) {
        let _ = self.inflection_of(link);
    }

    fn inflection_of(&mut self, link: BodyId) -> Option<()> {
        let tangent = self.pole_tangent(link)?;
        let own = self.drawn_centers().tangents.get(tangent)?.clone();
        let Spot::At(pole) = self.spot(own.pole) else { return None };
        // The ray that is farther from the tangent: its normal meets that of the tangent more steeply.
        let sines = own.lines.map(|line| self.along(line).perp(&own.direction).abs());
        let by = usize::from(sines[1] > sines[0]);
        let index = self.drawn_centers().inflections.len();
        let step = self.begin(Sheet::Centers);
        let (point, measured) = self.inflection_point(&own, by, pole)?;
        self.finish(step, Action::Curvature { index, step: CurvatureStep::InflectionPoint });
        let step = self.begin(Sheet::Centers);
        let normal = |line: LineId| Along::line(line).turned(1);
        let through_point = self.draw(Sheet::Centers, OperationRole::Line, point, normal(own.lines[by]));
        let through_pole = self.draw(Sheet::Centers, OperationRole::Line, pole, normal(own.line));
        let Some(Spot::At(found)) = self.meet([Some(through_point), Some(through_pole)]) else { return None };
        let name = |head: Head| format!("{}({})", head.word(), self.mechanism.body(link).name);
        let [pole_name, diameter_name] = [Head::InflectionPole, Head::InflectionDiameter].map(name);
        let ends = [pole, found];
        let diameter = self.measure(Sheet::Centers, NumberKind::Reading(diameter_name.clone()), ends, MeasuredAs::Size);
        self.name_place(Sheet::Centers, &pole_name, found);
        let drawn = Inflection {
            tangent,
            by,
            point: self.place_of(Spot::At(point)),
            pole: self.place_of(Spot::At(found)),
            diameter: self.number(diameter),
            measured,
            found: vec![format!("{pole_name}.x"), format!("{pole_name}.y"), diameter_name],
            agreement: self.agreement_of_inflection(link, ends),
        };
        self.drawn_centers().inflections.push(drawn);
        self.finish(step, Action::Curvature { index, step: CurvatureStep::InflectionPole });
        Some(())
    }

    /// The point of a ray that passes an inflection, and the name of the distance that is measured for it.
    fn inflection_point(&mut self, own: &PoleTangent, by: usize, pole: PlaceId) -> Option<(PlaceId, Vec<String>)> {
        let ray = own.rays[by];
        let Spot::At(pin) = self.spot(ray.pin) else { return None };
        let Spot::At(center) = self.spot(ray.center) else { return Some((pin, Vec::new())) };
        let CenterOrigin::Pin(joint) = self.drawn_centers().get(ray.pin).origin else { return None };
        let kind = NumberKind::Length([End::Center(own.pole), End::Joint(joint)]);
        let arm = self.measure(Sheet::Centers, kind, [pole, pin], MeasuredAs::Size);
        let crank = self.measure(Sheet::Centers, NumberKind::Size, [pin, center], MeasuredAs::Size);
        let equation = Equation {
            left: vec![(0, Product::new(ProductKind::Plain, 1.0, &[crank]))],
            right: vec![Product::new(ProductKind::Plain, 1.0, &[arm, arm])],
        };
        let [number] = self.solve(Sheet::Centers, vec![NumberKind::Size], vec![equation])?.try_into().ok()?;
        let towards = self.join_places(Sheet::Centers, OperationRole::Line, [pin, center]);
        let point = self.lay_off(Sheet::Centers, pin, vec![Product::plain(number)], Along::line(towards));
        Some((point, vec![self.construction.number_name(self.mechanism, arm)]))
    }

    /// The direction of a line.
    fn along(&self, line: LineId) -> Vector {
        self.construction.record.exact.lines[line.0].1.rounded()
    }

    /// How an inflection pole agrees with that of the computed motion.
    fn agreement_of_inflection(&self, link: BodyId, [pole, found]: [PlaceId; 2]) -> Option<Agreement> {
        if self.motion.order != Order::Acceleration {
            return None;
        }
        let from = Pair::within(self.construction.origin.coords, 0.0);
        let [pole, drawn] = [pole, found].map(|place| self.exact_place(place) + from);
        let moved = moved(self.motion, link).inflection_pole();
        let scale = self.size.max((drawn - pole).rounded().norm());
        let allowed = (drawn.errors() + moved.errors()).norm() / scale;
        let difference = (drawn - moved).rounded().norm() / scale;
        (difference.is_finite() && allowed.is_finite())
            .then_some(Agreement { difference, allowed: 4.0 * UNIT_ROUNDOFF + allowed })
    }
}

/// The motion of a link with the bounds of its errors.
fn moved(motion: &Motion, link: BodyId) -> Moved<Ball> {
    let (body, error) = (motion.body(link), motion.error(link));
    let vector =
        |value: Vector, error: Vector| Pair { x: Ball::within(value.x, error.x), y: Ball::within(value.y, error.y) };
    Moved {
        at: Pair::within(body.at.coords, 0.0),
        velocity: vector(body.velocity, error.velocity),
        acceleration: vector(body.acceleration, error.acceleration),
        omega: Ball::within(body.omega, error.omega),
        alpha: Ball::within(body.alpha, error.alpha),
    }
}
