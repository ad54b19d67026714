//! Centres of curvature of the paths of points, by Bobillier's construction.
//!
//! Let P be the instant centre of a link against the frame, A and B two pins of it whose paths have known centres of curvature A₀ and B₀: pins on cranks,
//! or on blocks in the frame, whose centre lies at infinity. The lines AB and A₀B₀ meet in Q, and PQ is the collineation axis of the rays PA and PB. Bobillier's
//! theorem: the pole tangent makes with the one ray the angle that the other ray makes with the axis, in the other sense. Once the tangent is known, the theorem
//! gives the axis of the rays PA and PC of any third point C, and with it the centre C₀ of the curvature of C's path: nothing but lines is drawn, and no rate enters
//! (E. Bobillier, *Cours de géométrie*, 1870; A. S. Hall, *Kinematics and Linkage Design*, 1961, ch. 5; O. Bottema, B. Roth, *Theoretical Kinematics*, 1979, ch. VIII).
//!
//! Of a path about a fixed point, and of a link that does not turn, there is nothing to find; where C₀ is at infinity the path has an inflection.

use super::draw::PARALLEL;
use super::{CenterId, CenterOrigin, Spot};
use crate::centers::LinkPair;
use crate::construction::constructed::Agreement;
use crate::construction::number::NumberKind;
use crate::construction::operation::{Along, LineId, MeasuredAs, OperationRole, PlaceId};
use crate::construction::step::Action;
use crate::construction::writer::Writer;
use crate::geometry::{Ball, Pair, Place, UNIT_ROUNDOFF, Vector, unit};
use crate::mechanism::{BodyId, GROUND, PointId};
use crate::motion::Motion;
use crate::sheet::{Order, Sheet};

/// The pole tangent of a link against the frame, and what it is drawn by.
#[derive(Clone, Debug, PartialEq)]
pub struct PoleTangent {
    /// The link.
    pub link: BodyId,
    /// Its centre with the frame.
    pub pole: CenterId,
    /// Two of its pins with the centres of curvature of their paths.
    pub rays: [KnownRay; 2],
    /// Where the line of the pins meets that of their centres.
    pub crossing: Place,
    /// The direction of the tangent, of length 1.
    pub direction: Vector,
    /// The rays, from the pole.
    pub(super) lines: [LineId; 2],
    /// The tangent.
    pub(super) line: LineId,
}

/// A pin of a link, and the centre of curvature of its path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnownRay {
    /// The pin, a centre of the link and of another link …
    pub pin: CenterId,
    /// … and that one's centre with the frame, which may be at infinity.
    pub center: CenterId,
}

/// The centre of curvature of the path of a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Curvature {
    /// The point.
    pub point: PointId,
    /// Its link's pole tangent: index among [`Centers::tangents`](super::Centers::tangents).
    pub tangent: usize,
    /// Which of the two rays is taken with that of the point.
    pub by: usize,
    /// Where the line of the point and that ray's pin meets the collineation axis.
    pub crossing: Place,
    /// The centre of curvature.
    pub center: Place,
    /// The radius of curvature; none at an inflection.
    pub radius: Option<f64>,
    /// How the centre agrees with that of the computed motion, in parts of the radius or of the mechanism's size, whichever is larger; none without accelerations,
    /// and at an inflection.
    pub agreement: Option<Agreement>,
}

/// A step of the construction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurvatureStep {
    /// The collineation axis of the two known rays.
    Axis,
    /// The pole tangent.
    Tangent,
    /// The axis of a known ray and the point's.
    OwnAxis,
    /// The centre of curvature.
    Center,
    /// The point of a ray that passes an inflection.
    InflectionPoint,
    /// The inflection pole.
    InflectionPole,
}

impl Writer<'_> {
    /// Draws the centre of curvature of the path of a point; nothing where it cannot be found.
    pub(super) fn curvature(&mut self, point: PointId) {
        let links = || self.mechanism.links().map(|(id, _)| id);
        let holders: Vec<BodyId> = links().filter(|link| self.mechanism.body(*link).has(point)).collect();
        let _ = holders.into_iter().find_map(|link| self.curvature_on(link, point));
    }

    fn curvature_on(&mut self, link: BodyId, point: PointId) -> Option<()> {
        let tangent = self.pole_tangent(link)?;
        let own = self.drawn_centers().tangents.get(tangent)?.clone();
        let Spot::At(pole) = self.spot(own.pole) else { return None };
        let at = self.plot_on(Sheet::Centers, point);
        if self.is_one(pole, at) {
            return None;
        }
        // The ray that is farther from the point's own.
        let along = self.way(pole, at)?;
        let pins = own.rays.map(|ray| self.spot(ray.pin));
        let sine = |spot: Spot| match spot {
            Spot::At(pin) if !self.is_one(pin, at) => self.way(pole, pin).map_or(0.0, |way| way.perp(&along).abs()),
            _ => 0.0,
        };
        let sines = pins.map(sine);
        let by = usize::from(sines[1] > sines[0]);
        let Spot::At(pin) = pins[by] else { return None };
        if sines[by] <= FLAT {
            return None;
        }
        let step = self.begin(Sheet::Centers);
        let ray = self.join_places(Sheet::Centers, OperationRole::Line, [pole, at]);
        let angle = Along::angle(ray, [own.line, own.lines[by]]);
        let axis = self.draw(Sheet::Centers, OperationRole::Line, pole, angle);
        let through = self.join_places(Sheet::Centers, OperationRole::Line, [pin, at]);
        let crossing = self.meet([Some(through), Some(axis)])?;
        let index = self.drawn_centers().curvatures.len();
        self.finish(step, Action::Curvature { index, step: CurvatureStep::OwnAxis });
        let step = self.begin(Sheet::Centers);
        let known = self.spot(own.rays[by].center);
        let last = self.line_of_spots([crossing, known]);
        let center = self.meet([Some(ray), last])?;
        let mut found = Curvature {
            point,
            tangent,
            by,
            crossing: self.place_of(crossing),
            center: self.place_of(center),
            radius: None,
            agreement: None,
        };
        if let Spot::At(center) = center {
            let name = format!("rho({})", self.mechanism.point_name(point));
            let radius = self.measure(Sheet::Centers, NumberKind::Reading(name), [at, center], MeasuredAs::Size);
            found.radius = Some(self.number(radius));
            found.agreement = self.agreement_of_center(link, [at, center]);
        }
        self.drawn_centers().curvatures.push(found);
        self.finish(step, Action::Curvature { index, step: CurvatureStep::Center });
        Some(())
    }

    /// The pole tangent of a link, drawn once; `None` of a link without two pins whose paths have known centres of curvature, and of one with a fixed centre.
    pub(super) fn pole_tangent(&mut self, link: BodyId) -> Option<usize> {
        let drawn = self.drawn_centers().tangents.iter().position(|tangent| tangent.link == link);
        if drawn.is_some() {
            return drawn;
        }
        let pole = self.center_of_links(link, GROUND)?;
        let is_fixed = self.drawn_centers().get(pole).is_permanent();
        let Spot::At(at) = self.spot(pole) else { return None };
        let rays = self.known_rays(link, at).filter(|_| !is_fixed)?;
        let pins = rays.map(|ray| self.spot(ray.pin));
        let [Spot::At(a), Spot::At(b)] = pins else { return None };
        let step = self.begin(Sheet::Centers);
        let of_pins = self.join_places(Sheet::Centers, OperationRole::Line, [a, b]);
        let centers = rays.map(|ray| self.spot(ray.center));
        let of_centers = self.line_of_spots(centers);
        let crossing = self.meet([Some(of_pins), of_centers])?;
        let axis = self.line_of_spots([Spot::At(at), crossing])?;
        let index = self.drawn_centers().tangents.len();
        self.finish(step, Action::Curvature { index, step: CurvatureStep::Axis });
        let step = self.begin(Sheet::Centers);
        let lines = [a, b].map(|pin| self.join_places(Sheet::Centers, OperationRole::Line, [at, pin]));
        let line = self.draw(Sheet::Centers, OperationRole::Line, at, Along::angle(lines[0], [axis, lines[1]]));
        let direction = self.construction.record.exact.lines[line.0].1.rounded();
        let crossing = self.place_of(crossing);
        let found = PoleTangent { link, pole, rays, crossing, direction, lines, line };
        self.drawn_centers().tangents.push(found);
        self.finish(step, Action::Curvature { index, step: CurvatureStep::Tangent });
        Some(index)
    }

    /// Those two pins of a link with known centres of curvature whose rays are most nearly at right angles.
    fn known_rays(&mut self, link: BodyId, pole: PlaceId) -> Option<[KnownRay; 2]> {
        let centers = self.drawn_centers().clone();
        let mut all: Vec<(KnownRay, Vector)> = Vec::new();
        for (index, center) in centers.all.iter().enumerate() {
            let (CenterOrigin::Pin(_), Some(other)) = (&center.origin, center.pair.other(link)) else { continue };
            let fixed = LinkPair::new(other, GROUND).and_then(|pair| centers.of(pair));
            let fixed = fixed.filter(|id| centers.get(*id).is_permanent());
            let (Some(fixed), Spot::At(pin)) = (fixed, center.spot) else { continue };
            if let Some(way) = self.way(pole, pin) {
                all.push((KnownRay { pin: CenterId(index), center: fixed }, way));
            }
        }
        let pairs = all.iter().enumerate().flat_map(|(index, a)| all[index + 1..].iter().map(move |b| (a, b)));
        let sine = |(a, b): &(&(KnownRay, Vector), &(KnownRay, Vector))| a.1.perp(&b.1).abs();
        let best = pairs.max_by(|a, b| sine(a).total_cmp(&sine(b)))?;
        (sine(&best) > FLAT).then_some([best.0.0, best.1.0])
    }

    /// The direction from one place to another; `None` where they are one.
    fn way(&self, from: PlaceId, to: PlaceId) -> Option<Vector> {
        if self.is_one(from, to) { None } else { unit((self.exact_place(to) - self.exact_place(from)).rounded()) }
    }

    fn is_one(&self, a: PlaceId, b: PlaceId) -> bool {
        (self.exact_place(a) - self.exact_place(b)).rounded().norm() <= self.near
    }

    /// The line through two spots; `None` for the line at infinity.
    fn line_of_spots(&mut self, spots: [Spot; 2]) -> Option<LineId> {
        match spots {
            [Spot::At(from), Spot::At(to)] => Some(self.join_places(Sheet::Centers, OperationRole::Line, [from, to])),
            [Spot::At(through), Spot::Towards(along)] | [Spot::Towards(along), Spot::At(through)] => {
                let drawn = self.drawn(through, along);
                Some(drawn.unwrap_or_else(|| self.draw(Sheet::Centers, OperationRole::Line, through, along)))
            }
            [Spot::Towards(_), Spot::Towards(_)] => None,
        }
    }

    /// Where two lines meet, parallel ones at infinity; none for the line at infinity twice.
    pub(super) fn meet(&mut self, lines: [Option<LineId>; 2]) -> Option<Spot> {
        let [first, second] = match lines {
            [Some(first), Some(second)] => [first, second],
            [Some(line), None] | [None, Some(line)] => return Some(Spot::Towards(Along::line(line))),
            [None, None] => return None,
        };
        let [d, e] = [first, second].map(|line| self.construction.record.exact.lines[line.0].1);
        let sine = d.cross(e);
        if sine.high.abs() <= sine.error().max(PARALLEL) {
            return Some(Spot::Towards(Along::line(first)));
        }
        let crossing = self.cross(true, Sheet::Centers, OperationRole::Line, [first, second]);
        Some(crossing.map_or(Spot::Towards(Along::line(first)), Spot::At))
    }

    pub(super) fn place_of(&self, spot: Spot) -> Place {
        match spot {
            Spot::At(place) => Place::At(self.construction.origin + self.exact_place(place).rounded()),
            Spot::Towards(along) => Place::AtInfinity(self.construction.record.exact.direction(&along, 0.0).rounded()),
        }
    }

    /// How a centre of curvature agrees with that of the computed motion.
    fn agreement_of_center(&self, link: BodyId, [at, center]: [PlaceId; 2]) -> Option<Agreement> {
        if self.motion.order != Order::Acceleration {
            return None;
        }
        let from = Pair::within(self.construction.origin.coords, 0.0);
        let [at, drawn] = [at, center].map(|place| self.exact_place(place) + from);
        let moved = center_of_curvature(self.motion, link, at);
        let scale = self.size.max((drawn - at).rounded().norm());
        let allowed = (drawn.errors() + moved.errors()).norm() / scale;
        let difference = (drawn - moved).rounded().norm() / scale;
        (difference.is_finite() && allowed.is_finite())
            .then_some(Agreement { difference, allowed: 4.0 * UNIT_ROUNDOFF + allowed })
    }
}

/// Sine of the angle of two rays below which they are one.
const FLAT: f64 = 1e-6;

/// The centre of curvature of the path of a link's point by its velocity and acceleration, with the bound of its error: C + J v · v²/(v × a).
fn center_of_curvature(motion: &Motion, link: BodyId, at: Pair<Ball>) -> Pair<Ball> {
    let (body, error) = (motion.body(link), motion.error(link));
    let vector =
        |value: Vector, error: Vector| Pair { x: Ball::within(value.x, error.x), y: Ball::within(value.y, error.y) };
    let omega = Ball::within(body.omega, error.omega);
    let alpha = Ball::within(body.alpha, error.alpha);
    let arm = at - Pair::within(body.at.coords, 0.0);
    let velocity = vector(body.velocity, error.velocity) + arm.quarter_turn() * omega;
    let acceleration =
        vector(body.acceleration, error.acceleration) + arm.quarter_turn() * alpha - arm * (omega * omega);
    at + velocity.quarter_turn() * (velocity.dot(velocity) / velocity.cross(acceleration))
}
