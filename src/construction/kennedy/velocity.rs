//! Angular velocities and velocities by distances of centres.
//!
//! At P_1k links 1 and k have one velocity: ω_k · P_k0 P_1k = ω_1 · P_10 P_1k, with distances that count along one line, so that a centre P_1k between
//! the two others reverses the sense. A slider that pushes link 1 along a guide of the frame gives P_1k the velocity of the slider, and so ω_k · P_k0 P_1k; one
//! between links c and r gives it to P_c0 as a point of r, and so ω_r · P_r0 P_c0. A point C of link k then moves with ω_k · P_k0 C, normal to its ray. Velocities are drawn on the
//! mechanism so that the end of the driven crank has one as long as the crank.

use super::{CenterId, Spot};
use crate::centers::LinkPair;
use crate::construction::number::{End, Equation, NumberId, NumberKind, Product, ProductKind, Rate};
use crate::construction::operation::{Along, MeasuredAs, OperationRole, PlaceId};
use crate::construction::step::Action;
use crate::construction::writer::Writer;
use crate::geometry::{Place, Vector, quarter_turn};
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId, Role, SliderId};
use crate::sheet::{Order, Sheet};

/// A driven slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push {
    /// The slider.
    pub slider: SliderId,
    /// The link along which it pushes the driven one, or the frame.
    pub on: BodyId,
    /// −1 where its velocity counts against the driven link: the guide moves, over a block of the frame.
    pub sign: f64,
}

impl Push {
    /// How a slider pushes which link; `None` of one that is not driven, or at rest.
    fn of(id: SliderId, mechanism: &Mechanism) -> Option<(BodyId, Push)> {
        let slider = mechanism.slider(id);
        slider.drive.filter(|drive| drive.speed != 0.0)?;
        Some(match slider.link {
            GROUND => (slider.on, Push { slider: id, on: GROUND, sign: -1.0 }),
            link => (link, Push { slider: id, on: slider.on, sign: 1.0 }),
        })
    }
}

/// The velocity of a point by centres.
#[derive(Clone, Debug, PartialEq)]
pub struct CenterVelocity {
    /// The point …
    pub point: PointId,
    /// … of this link.
    pub link: BodyId,
    /// The driven link: what turns, or is pushed along a guide.
    pub driver: BodyId,
    /// How it is pushed; none of one that turns.
    pub push: Option<Push>,
    /// Its end on the sheet; none before it is drawn.
    pub end: Option<PlaceId>,
    /// From the point to that end, in the scene's unit of length.
    pub arrow: Vector,
    /// The velocity, in the scene's units.
    pub velocity: Vector,
    /// The angular velocity of the link.
    pub omega: f64,
    /// Names of the quantities that are found with it: the distance that is measured, size and direction.
    pub names: Vec<String>,
}

impl CenterVelocity {
    /// The centres from which it follows.
    pub(super) fn needs(&self) -> impl Iterator<Item = LinkPair> + use<> {
        let pushed = self.push.map(|push| (push.on, GROUND));
        let pairs = [(self.driver, GROUND), (self.link, GROUND), (self.driver, self.link)];
        pairs.into_iter().chain(pushed).filter_map(|(a, b)| LinkPair::new(a, b))
    }
}

impl Writer<'_> {
    /// What there is to find for these points: each as one of a link with a fixed centre, if it has such a link; nothing without a single
    /// drive that moves.
    pub(super) fn velocity_plans(&mut self, points: &[PointId]) -> Vec<CenterVelocity> {
        let mechanism = self.mechanism;
        if mechanism.drive_names().len() != 1 {
            return Vec::new();
        }
        let turns = |body: &BodyId| matches!(mechanism.body(*body).role, Role::Driver { omega, .. } if omega != 0.0);
        let turned = mechanism.body_ids().find(turns).map(|driver| (driver, None));
        let pushed = || mechanism.slider_ids().find_map(|id| Push::of(id, mechanism));
        let driven = turned.or_else(|| pushed().map(|(driver, push)| (driver, Some(push))));
        let Some((driver, push)) = driven else { return Vec::new() };
        let plan = |point: &PointId| {
            let holders = || mechanism.links().map(|(id, _)| id).filter(|id| mechanism.body(*id).has(*point));
            let is_pivoted = |link: &BodyId| {
                mechanism.body(*link).points.iter().any(|pin| mechanism.body(GROUND).has(*pin) && pin != point)
            };
            let link = holders().find(is_pivoted).or_else(|| holders().next())?;
            let (arrow, velocity) = (Vector::zeros(), Vector::zeros());
            Some(CenterVelocity {
                point: *point,
                link,
                driver,
                push,
                end: None,
                arrow,
                velocity,
                omega: 0.0,
                names: Vec::new(),
            })
        };
        points.iter().filter_map(plan).collect()
    }

    /// Draws the velocity of a point by the centres that are there; nothing where one of them is missing.
    pub(super) fn velocity_by_centers(&mut self, velocity: CenterVelocity) {
        let _ = self.drawn_velocity(velocity);
    }

    fn drawn_velocity(&mut self, mut found: CenterVelocity) -> Option<()> {
        let pole = self.center_of_links(found.link, GROUND)?;
        // The number that turns the ray, and the line that is turned.
        let (size, along) = match (self.spot(pole), found.push) {
            (Spot::At(from), _) => {
                let rate = self.rate_of(&found)?;
                found.omega = self.number(rate);
                let to = self.plot_on(Sheet::Centers, found.point);
                let line = self.join_places(Sheet::Centers, OperationRole::Line, [from, to]);
                let kind = NumberKind::Length([End::Center(pole), End::Joint(found.point)]);
                let arm = self.measure(Sheet::Centers, kind, [from, to], MeasuredAs::Along(line));
                found.names.push(self.construction.number_name(self.mechanism, arm));
                (Product::new(ProductKind::Turning, 1.0, &[rate, arm]), Along::line(line).turned(1))
            }
            // What is pushed along a guide of the frame.
            (Spot::Towards(_), Some(push)) if push.on == GROUND && found.link == found.driver => {
                let guide = self.guide_on(Sheet::Centers, push.slider);
                let speed = self.construction.rate(Rate::Slide(Order::Velocity, push.slider))??;
                (Product::new(ProductKind::Sliding, push.sign, &[speed]), Along::line(guide))
            }
            // The link does not turn: it moves as the driven link does in their common centre.
            (Spot::Towards(_), push) => {
                let given = match push {
                    Some(push) if push.on == GROUND => return None,
                    Some(push) => self.rate_by_slide(found.driver, LinkPair::new(push.on, GROUND)?, push)?,
                    None => self.construction.rate(Rate::Angular(Order::Velocity, found.driver))??,
                };
                let fixed = self.center_of_links(found.driver, GROUND)?;
                let common = self.center_of_links(found.driver, found.link)?;
                let (Spot::At(from), Spot::At(to)) = (self.spot(fixed), self.spot(common)) else { return None };
                let line = self.join_places(Sheet::Centers, OperationRole::Line, [from, to]);
                let kind = NumberKind::Length([End::Center(fixed), End::Center(common)]);
                let arm = self.measure(Sheet::Centers, kind, [from, to], MeasuredAs::Along(line));
                found.names.push(self.construction.number_name(self.mechanism, arm));
                (Product::new(ProductKind::Turning, 1.0, &[given, arm]), Along::line(line).turned(1))
            }
        };
        let step = self.begin(Sheet::Centers);
        let per_rate = self.length_per_velocity(&found)?;
        let at = self.plot_on(Sheet::Centers, found.point);
        let speed = self.compute(Sheet::Centers, NumberKind::SpeedByCenters(found.point), vec![size]);
        let on_paper = Product::new(ProductKind::Plain, per_rate, &[speed]);
        let end = self.lay_off(Sheet::Centers, at, vec![on_paper], along);
        let point = self.mechanism.point_name(found.point);
        found.names.extend(["size", "angle"].map(|part| format!("v({point}).{part}")));
        found.end = Some(end);
        found.arrow = (self.exact_place(end) - self.exact_place(at)).rounded();
        found.velocity = found.arrow / per_rate;
        let index = self.drawn_centers().velocities.len();
        self.drawn_centers().velocities.push(found);
        self.finish(step, Action::VelocityByCenters(index));
        Some(())
    }

    /// How long a velocity is drawn: so that the end of a driven crank has one as long as the crank; what is pushed, one of a part of the mechanism.
    fn length_per_velocity(&self, found: &CenterVelocity) -> Option<f64> {
        /// That part.
        const PUSHED: f64 = 0.125;
        let rate = match found.push {
            Some(push) => Rate::Slide(Order::Velocity, push.slider),
            None => Rate::Angular(Order::Velocity, found.driver),
        };
        let given = self.number(self.construction.rate(rate)??).abs();
        Some(if found.push.is_some() { PUSHED * self.size / given } else { 1.0 / given })
    }

    /// The angular velocity of the link of a velocity.
    fn rate_of(&mut self, found: &CenterVelocity) -> Option<NumberId> {
        let CenterVelocity { link, driver, .. } = *found;
        let given = match found.push {
            Some(push) if push.on == GROUND => {
                return self.rate_by_slide(link, LinkPair::new(driver, link)?, push);
            }
            Some(push) => self.rate_by_slide(driver, LinkPair::new(push.on, GROUND)?, push)?,
            None => self.construction.rate(Rate::Angular(Order::Velocity, driver))??,
        };
        // What slides along a link turns with it.
        if link == driver || found.push.is_some_and(|push| push.on == link) {
            return Some(given);
        }
        self.known_rate(link).or_else(|| {
            let step = self.begin(Sheet::Centers);
            let rate = self.rate_by_centers(link, driver, given)?;
            let value = self.number(rate);
            let names = self.names_of_rate(link, driver, rate);
            self.finish(step, Action::RateByCenters { link, driver, value, names });
            Some(rate)
        })
    }

    /// The angular velocity of a link, if it has been found by centres.
    fn known_rate(&self, link: BodyId) -> Option<NumberId> {
        let kind = NumberKind::RateByCenters(link);
        self.construction.numbers.iter().position(|known| *known == kind).map(NumberId)
    }

    /// The angular velocity of a link by a driven slider: in this centre it has the velocity along the guide.
    fn rate_by_slide(&mut self, link: BodyId, at: LinkPair, push: Push) -> Option<NumberId> {
        if let Some(known) = self.known_rate(link) {
            return Some(known);
        }
        let speed = self.construction.rate(Rate::Slide(Order::Velocity, push.slider))??;
        let [fixed, moving] = [self.center_of_links(link, GROUND)?, self.drawn_centers().of(at)?];
        let (Spot::At(from), Spot::At(to)) = (self.spot(fixed), self.spot(moving)) else { return None };
        let arm = (self.exact_place(to) - self.exact_place(from)).rounded();
        if arm.norm() <= self.near {
            return None;
        }
        let step = self.begin(Sheet::Centers);
        let line = self.join_places(Sheet::Centers, OperationRole::Line, [from, to]);
        let kind = NumberKind::Length([End::Center(fixed), End::Center(moving)]);
        let length = self.measure(Sheet::Centers, kind, [from, to], MeasuredAs::Along(line));
        let sense = if quarter_turn(arm).dot(&self.pose.guide(push.slider)) < 0.0 { -push.sign } else { push.sign };
        let equation = Equation {
            left: vec![(0, Product::new(ProductKind::Plain, 1.0, &[length]))],
            right: vec![Product::new(ProductKind::Sliding, sense, &[speed])],
        };
        let found = self.solve(Sheet::Centers, vec![NumberKind::RateByCenters(link)], vec![equation])?;
        let rate = found.first().copied()?;
        let value = self.number(rate);
        let names = [length, rate].map(|number| self.construction.number_name(self.mechanism, number)).to_vec();
        self.finish(step, Action::RateBySlide { link, at, slider: push.slider, value, names });
        Some(rate)
    }

    /// The angular velocity of a link, from that of the driven one.
    fn rate_by_centers(&mut self, link: BodyId, driver: BodyId, given: NumberId) -> Option<NumberId> {
        let [fixed, other] = [self.center_of_links(driver, GROUND)?, self.center_of_links(link, GROUND)?];
        let common = self.center_of_links(driver, link)?;
        let Spot::At(meeting) = self.spot(common) else {
            // Parallel motion: both turn alike.
            return Some(self.compute(Sheet::Centers, NumberKind::RateByCenters(link), vec![Product::plain(given)]));
        };
        let (Spot::At(from), Spot::At(to)) = (self.spot(fixed), self.spot(other)) else { return None };
        // A common centre on the driven link's own pivot tells no direction: then the other pivot does.
        let is_apart = |a: PlaceId, b: PlaceId, writer: &Self| {
            (writer.exact_place(a) - writer.exact_place(b)).rounded().norm() > writer.near
        };
        let line = match is_apart(from, to, self) {
            true => self.join_places(Sheet::Centers, OperationRole::Line, [from, to]),
            false => return None,
        };
        if !is_apart(to, meeting, self) {
            return None;
        }
        let length = |writer: &mut Self, ends: [CenterId; 2], places: [PlaceId; 2]| {
            let kind = NumberKind::Length(ends.map(End::Center));
            writer.measure(Sheet::Centers, kind, places, MeasuredAs::Along(line))
        };
        let driven = length(self, [fixed, common], [from, meeting]);
        let own = length(self, [other, common], [to, meeting]);
        let equation = Equation {
            left: vec![(0, Product::new(ProductKind::Plain, 1.0, &[own]))],
            right: vec![Product::new(ProductKind::Turning, 1.0, &[given, driven])],
        };
        let found = self.solve(Sheet::Centers, vec![NumberKind::RateByCenters(link)], vec![equation])?;
        found.first().copied()
    }

    /// The names of the distances from which an angular velocity is found, and its own.
    fn names_of_rate(&self, link: BodyId, driver: BodyId, rate: NumberId) -> Vec<String> {
        let centers = self.construction.centers.as_deref();
        let name = |a: BodyId, b: BodyId| {
            let centers = centers?;
            Some(centers.get(centers.of(LinkPair::new(a, b)?)?).name.as_str())
        };
        let own = self.construction.number_name(self.mechanism, rate);
        let common = centers.zip(LinkPair::new(driver, link)).and_then(|(all, pair)| Some(all.get(all.of(pair)?)));
        // Of links that turn alike nothing is measured.
        if common.is_none_or(|common| common.place.finite().is_none()) {
            return vec![own];
        }
        let lengths = [driver, link].map(|body| {
            let [from, to] = [name(body, GROUND)?, name(driver, link)?];
            Some(Sheet::Centers.segment_name(from, to))
        });
        lengths.into_iter().flatten().chain([own]).collect()
    }

    pub(super) fn center_of_links(&mut self, a: BodyId, b: BodyId) -> Option<CenterId> {
        let pair = LinkPair::new(a, b)?;
        self.drawn_centers().of(pair)
    }

    pub(super) fn spot(&mut self, id: CenterId) -> Spot {
        let center = self.drawn_centers().get(id);
        debug_assert!(matches!(center.place, Place::At(_)) == matches!(center.spot, Spot::At(_)));
        center.spot
    }

    pub(super) fn number(&self, number: NumberId) -> f64 {
        self.construction.record.exact.numbers[number.0].high
    }
}
