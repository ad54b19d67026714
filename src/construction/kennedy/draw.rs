//! Draws Kennedy's lines on the sheet of centres, centre by centre.

use super::chain::{Homogeneous, LeftOut, Places, Way, ways};
use super::order::{Crossed, Two, two};
use super::{Center, CenterId, CenterLine, CenterOrigin, Centers, FigureOf, Spot};
use crate::centers::LinkPair;
use crate::construction::constructed::Agreement;
use crate::construction::operation::{Along, LineId, OperationRole, PlaceId};
use crate::construction::step::Action;
use crate::construction::writer::Writer;
use crate::geometry::{Ball, Pair, Place, Point, UNIT_ROUNDOFF, Vector, quarter_turn};
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId, Role};
use crate::motion::Motion;
use crate::sheet::Sheet;

/// The link over which a line runs, and the two centres that it runs through.
type OverLink = (Option<BodyId>, [CenterId; 2]);

impl Writer<'_> {
    /// Draws the centres that are wanted, and those that lead to them; the velocities of these points by centres, the centres of curvature of the paths of others, and inflection poles of links.
    pub(crate) fn centers(
        &mut self,
        wanted: &[LinkPair],
        points: &[PointId],
        curved: &[PointId],
        inflected: &[BodyId],
    ) {
        let links: Vec<BodyId> = links(self.mechanism);
        self.construction.centers =
            Some(Box::new(Centers { wanted: wanted.to_vec(), links: links.clone(), ..Centers::default() }));
        self.permanent_centers(&links);
        let number = |link: BodyId| links.iter().position(|&other| other == link);
        let two_of = |pair: LinkPair| {
            let [a, b] = pair.links().map(number);
            Some(two(a?, b?))
        };
        let mut places = Places::new(links.len());
        let mut permanent: Vec<Two> = Vec::new();
        let joints: Vec<(LinkPair, Place)> =
            self.drawn_centers().all.iter().map(|center| (center.pair, center.place)).collect();
        for (pair, place) in joints {
            if let Some(pair) = two_of(pair) {
                places.put(pair, self.homogeneous(place));
                permanent.push(pair);
            }
        }
        let velocities = self.velocity_plans(points);
        let of_curved: Vec<LinkPair> = { self.mechanism.links() }
            .filter(|(id, link)| inflected.contains(id) || curved.iter().any(|point| link.has(*point)))
            .filter_map(|(id, _)| LinkPair::new(id, GROUND))
            .collect();
        let needed =
            wanted.iter().copied().chain(velocities.iter().flat_map(|velocity| velocity.needs())).chain(of_curved);
        let numbers: Vec<Two> = needed.filter_map(two_of).collect();
        let is_too_large = links.len() > MOST_LINKS;
        self.drawn_centers().is_too_large = is_too_large;
        let leaves_out = has_one_freedom(self.mechanism);
        let ways = if is_too_large { Vec::new() } else { ways(&permanent, &mut places, &numbers, leaves_out) };
        for way in ways {
            match way {
                Way::Crossed(crossed) => self.crossed_center(&links, crossed, FigureOf::Mechanism),
                Way::LeftOut(left_out) => self.center_without_link(&links, &left_out),
            };
        }
        self.compare_centers(wanted);
        for velocity in velocities {
            self.velocity_by_centers(velocity);
        }
        curved.iter().for_each(|point| self.curvature(*point));
        inflected.iter().for_each(|link| self.inflection(*link));
        let centers = self.drawn_centers();
        let is_known = |point: &PointId| centers.curvatures.iter().any(|found| found.point == *point);
        centers.without_curvature = curved.iter().copied().filter(|point| !is_known(point)).collect();
        let is_found = |point: &PointId| centers.velocities.iter().any(|found| found.point == *point);
        centers.without_velocity = points.iter().copied().filter(|point| !is_found(point)).collect();
    }

    pub(super) fn drawn_centers(&mut self) -> &mut Centers {
        self.construction.centers.get_or_insert_default()
    }

    /// A place in the frame of the chain.
    fn homogeneous(&self, place: Place) -> Homogeneous {
        match place {
            Place::At(place) => {
                let from = (place - self.construction.origin) / self.size;
                Homogeneous::at(from.x, from.y)
            }
            Place::AtInfinity(along) => Homogeneous::towards(along.x, along.y),
        }
    }

    fn add_center(&mut self, center: Center) -> CenterId {
        if let Spot::At(place) = center.spot {
            self.name_place(Sheet::Centers, &center.name, place);
        }
        let all = &mut self.drawn_centers().all;
        all.push(center);
        CenterId(all.len() - 1)
    }

    /// Plots the pins and draws the guides: a pin of n links is n (n − 1) / 2 centres.
    fn permanent_centers(&mut self, links: &[BodyId]) {
        let step = self.begin(Sheet::Centers);
        for (point, holders) in self.mechanism.point_ids().zip(self.mechanism.holders()) {
            let holders: Vec<BodyId> = holders.into_iter().filter(|holder| links.contains(holder)).collect();
            for (index, &a) in holders.iter().enumerate() {
                for &b in &holders[index + 1..] {
                    let place = self.plot_on(Sheet::Centers, point);
                    let at = Place::At(self.pose.point(point));
                    self.add_permanent([a, b], CenterOrigin::Pin(point), Spot::At(place), at);
                }
            }
        }
        for id in self.mechanism.joint_ids() {
            let joint = self.mechanism.joint(id);
            if let Some(rolling) = joint.rolling().filter(|_| joint.bodies.iter().all(|body| links.contains(body))) {
                let exact = |point: PointId| Pair::between(self.construction.origin, self.pose.point(point));
                let exact =
                    rolling.point(exact, |guide| Pair::within(self.pose.guide(guide), 0.0), |x| Ball::within(x, 0.0));
                let role = OperationRole::Center(CenterId(self.drawn_centers().all.len()));
                let place = self.plot_exact(Sheet::Centers, role, exact);
                let at = Place::At(self.construction.origin + exact.rounded());
                self.add_permanent(joint.bodies, CenterOrigin::Mesh(id), Spot::At(place), at);
            }
        }
        for id in self.mechanism.slider_ids() {
            let slider = self.mechanism.slider(id);
            if links.contains(&slider.link) && links.contains(&slider.on) {
                let normal = Along::line(self.guide_on(Sheet::Centers, id)).turned(1);
                let at = Place::AtInfinity(quarter_turn(self.pose.guide(id)));
                self.add_permanent([slider.link, slider.on], CenterOrigin::Guide(id), Spot::Towards(normal), at);
            }
        }
        self.finish(step, Action::PermanentCenters);
    }

    fn add_permanent(&mut self, [a, b]: [BodyId; 2], origin: CenterOrigin, spot: Spot, place: Place) {
        if let Some(pair) = LinkPair::new(a, b).filter(|pair| self.drawn_centers().of(*pair).is_none()) {
            let figure = FigureOf::Mechanism;
            let name = figure.center_name(pair, self.mechanism);
            self.add_center(Center { name, pair, origin, figure, spot, place });
        }
    }

    /// The centre of a figure with these links: the mechanism's, or that where two of them are one, if a link is left out.
    fn center_of(&mut self, [a, b]: [BodyId; 2], figure: FigureOf) -> Option<CenterId> {
        let pair = LinkPair::new(a, b)?;
        let centers = self.drawn_centers();
        let of = |pair: LinkPair, figure: FigureOf| {
            centers.all.iter().position(|center| center.pair == pair && center.figure == figure).map(CenterId)
        };
        match figure {
            FigureOf::Mechanism => of(pair, figure),
            FigureOf::Glued { without, together, .. } => {
                // Either name of the glued link.
                let other = |link: BodyId| together.other(link).unwrap_or(link);
                let names = [Some(pair), LinkPair::new(other(a), b), LinkPair::new(a, other(b))];
                let joint = |pair: LinkPair| of(pair, FigureOf::Mechanism).filter(|id| centers.get(*id).is_permanent());
                let [first, second] = together.links();
                let shared =
                    of(pair, FigureOf::Mechanism).filter(|id| centers.is_without(*id, &[without, first, second]));
                let own = |pair: LinkPair| of(pair, figure).or_else(|| joint(pair));
                names.into_iter().flatten().find_map(own).or(shared)
            }
        }
    }

    /// The centre at the crossing of two lines, each over one link.
    fn crossed_center(&mut self, links: &[BodyId], crossed: Crossed, figure: FigureOf) -> Option<CenterId> {
        let [a, b] = crossed.center.map(|number| links[number]);
        let lines = crossed.over.map(|over| {
            let over = links[over];
            let through = [self.center_of([a, over], figure), self.center_of([b, over], figure)];
            Some((Some(over), [through[0]?, through[1]?]))
        });
        let [first, second] = lines;
        let (pair, lines) = (LinkPair::new(a, b)?, [first?, second?]);
        match self.figure_of(pair, &lines, figure) {
            // It has been found before.
            FigureOf::Mechanism if self.drawn_centers().of(pair).is_some() => self.drawn_centers().of(pair),
            own => self.center_at(pair, own, lines),
        }
    }

    /// The figure whose centre is found by these lines in some figure: the mechanism itself, where they have nothing of what was glued.
    fn figure_of(&mut self, pair: LinkPair, lines: &[OverLink; 2], figure: FigureOf) -> FigureOf {
        let FigureOf::Glued { without, together, .. } = figure else { return figure };
        let [first, second] = together.links();
        let changed = [without, first, second];
        let centers = self.drawn_centers();
        let is_own = |(over, through): &OverLink| {
            over.is_some_and(|over| !changed.contains(&over))
                && through.iter().all(|id| centers.is_without(*id, &changed))
        };
        let is_of_mechanism = lines.iter().all(is_own) && pair.links().iter().all(|link| !changed.contains(link));
        if is_of_mechanism { FigureOf::Mechanism } else { figure }
    }

    /// The centre of two links that one other link joins, found without that link.
    fn center_without_link(&mut self, links: &[BodyId], left_out: &LeftOut) -> Option<CenterId> {
        let without = links[left_out.link];
        let [a, b] = left_out.center.map(|number| links[number]);
        let mut glued = [None; 2];
        for (index, way) in left_out.glued.iter().enumerate() {
            let [kept, gone] = way.together.map(|number| links[number]);
            let figure = FigureOf::Glued { without, together: LinkPair::new(kept, gone)?, is_second: index > 0 };
            let step = self.begin(Sheet::Centers);
            self.finish(step, Action::LeaveOut { center: LinkPair::new(a, b)?, figure });
            for crossed in &way.crossings {
                glued[index] = self.crossed_center(links, *crossed, figure);
            }
            if way.crossings.is_empty() {
                glued[index] = self.center_of([a, b], figure);
            }
        }
        let own =
            [self.center_of([a, without], FigureOf::Mechanism)?, self.center_of([b, without], FigureOf::Mechanism)?];
        let lines = [(None, [glued[0]?, glued[1]?]), (Some(without), own)];
        self.center_at(LinkPair::new(a, b)?, FigureOf::Mechanism, lines)
    }

    /// Draws both lines of a centre and crosses them, each in a step.
    fn center_at(&mut self, pair: LinkPair, figure: FigureOf, lines: [OverLink; 2]) -> Option<CenterId> {
        let id = CenterId(self.drawn_centers().all.len());
        let mut drawn = Vec::new();
        for (side, (over, through)) in lines.into_iter().enumerate() {
            let step = self.begin(Sheet::Centers);
            let line = self.center_line(OperationRole::CenterLine(id, side), through);
            let line = CenterLine { over, through, line };
            if line.line.is_some() {
                self.finish(step, Action::CenterLine { center: id, pair, figure, line: line.clone() });
            }
            drawn.push(line);
        }
        let lines: [CenterLine; 2] = drawn.try_into().ok()?;
        let step = self.begin(Sheet::Centers);
        let (spot, place, sine) = self.crossing_of_lines(id, &lines)?;
        let name = figure.center_name(pair, self.mechanism);
        let origin = CenterOrigin::Lines { lines, sine };
        let added = self.add_center(Center { name, pair, origin, figure, spot, place });
        self.finish(step, Action::Center(added));
        Some(added)
    }

    /// The line through two centres; none for the line at infinity.
    fn center_line(&mut self, role: OperationRole, through: [CenterId; 2]) -> Option<LineId> {
        let [first, second] = through.map(|id| self.drawn_centers().get(id).spot);
        match (first, second) {
            (Spot::At(from), Spot::At(towards)) => Some(self.join_places(Sheet::Centers, role, [from, towards])),
            (Spot::At(through), Spot::Towards(along)) | (Spot::Towards(along), Spot::At(through)) => {
                let drawn = self.drawn(through, along);
                Some(drawn.unwrap_or_else(|| self.draw(Sheet::Centers, role, through, along)))
            }
            (Spot::Towards(_), Spot::Towards(_)) => None,
        }
    }

    /// Where two lines cross: parallel ones at infinity.
    fn crossing_of_lines(&mut self, id: CenterId, lines: &[CenterLine; 2]) -> Option<(Spot, Place, f64)> {
        let at_infinity = |writer: &Self, line: LineId, sine: f64| {
            let along: Vector = writer.construction.record.exact.lines[line.0].1.rounded();
            (Spot::Towards(Along::line(line)), Place::AtInfinity(along), sine)
        };
        match lines.each_ref().map(|line| line.line) {
            [Some(first), Some(second)] => {
                let [d, e] = [first, second].map(|line| self.construction.record.exact.lines[line.0].1);
                let sine = d.cross(e);
                if sine.high.abs() <= sine.error().max(PARALLEL) {
                    return Some(at_infinity(self, first, 0.0));
                }
                match self.cross(true, Sheet::Centers, OperationRole::Center(id), [first, second]) {
                    Some(place) => {
                        let at = self.exact_place(place).rounded();
                        Some((Spot::At(place), Place::At(self.construction.origin + at), sine.high.abs()))
                    }
                    None => Some(at_infinity(self, first, 0.0)),
                }
            }
            [Some(line), None] | [None, Some(line)] => Some(at_infinity(self, line, 1.0)),
            [None, None] => None,
        }
    }

    pub(super) fn exact_place(&self, place: PlaceId) -> Pair<Ball> {
        self.construction.record.exact.places[place.0]
    }

    /// Compares the centres with those of the motion, and takes those that no lines lead to from there.
    fn compare_centers(&mut self, wanted: &[LinkPair]) {
        let (mut agreement, motion): (Option<Agreement>, &Motion) = (None, self.motion);
        let reach = self.size / PARALLEL;
        let from = Pair::within(self.construction.origin.coords, 0.0);
        let centers = self.drawn_centers().clone();
        for center in centers.all.iter().filter(|center| center.figure == FigureOf::Mechanism) {
            let (Spot::At(place), false) = (center.spot, center.is_permanent()) else { continue };
            let drawn = self.exact_place(place) + from;
            let Some(moved) = moving_center(motion, center.pair, drawn.rounded(), reach) else { continue };
            let apart: Vector = (drawn - moved).rounded();
            let scale = self.size.max((drawn - from).rounded().norm());
            let allowed = drawn.errors() + moved.errors();
            let so_far = agreement.get_or_insert(Agreement { difference: 0.0, allowed: 0.0 });
            so_far.difference = so_far.difference.max(apart.norm() / scale);
            so_far.allowed = so_far.allowed.max(4.0 * UNIT_ROUNDOFF + allowed.norm() / scale);
        }
        let mut by_rates = Vec::new();
        for &pair in wanted.iter().filter(|pair| centers.of(**pair).is_none()) {
            by_rates.push((pair, place_of_moving(motion, pair, self.construction.origin, reach)));
        }
        if !by_rates.is_empty() {
            let step = self.begin(Sheet::Centers);
            self.finish(step, Action::CentersByRates(by_rates.iter().map(|(pair, _)| *pair).collect()));
        }
        let centers = self.drawn_centers();
        (centers.agreement, centers.by_rates) = (agreement, by_rates);
    }
}

/// Most links, with the frame, of which lines are sought: the time grows with more than the fourth power of their number.
pub const MOST_LINKS: usize = 42;

/// The links that have centres: all bodies but those whose rotation is not defined.
fn links(mechanism: &Mechanism) -> Vec<BodyId> {
    let has_rotation = |id: &BodyId| !matches!(mechanism.body(*id).role, Role::Carrier { .. } | Role::Unsolved);
    mechanism.body_ids().filter(has_rotation).collect()
}

/// Whether a single drive moves the mechanism: only then a centre hangs on places alone when a link is left out.
fn has_one_freedom(mechanism: &Mechanism) -> bool {
    let is_given = |role: &Role| matches!(role, Role::Carrier { .. } | Role::Moving { .. } | Role::Unsolved);
    mechanism.drive_names().len() == 1 && !mechanism.bodies.iter().any(|body| is_given(&body.role))
}

/// Sine of the angle of two lines below which roundings of the joints' places let nobody tell them from parallel ones.
pub(super) const PARALLEL: f64 = 1e-13;

/// The centre of two links by their motion, with the bound of its error: twists are taken about a point near it. None of one farther away than
/// `reach`, which counts as at infinity.
fn moving_center(motion: &Motion, pair: LinkPair, near: Vector, reach: f64) -> Option<Pair<Ball>> {
    let near = Pair::within(near, 0.0);
    let [first, second] = pair.links().map(|link| {
        let (body, error) = (motion.body(link), motion.error(link));
        let omega = Ball::within(body.omega, error.omega);
        let at = Pair::within(body.at.coords, 0.0);
        let velocity = Pair {
            x: Ball::within(body.velocity.x, error.velocity.x),
            y: Ball::within(body.velocity.y, error.velocity.y),
        };
        (omega, velocity + (near - at).quarter_turn() * omega)
    });
    let turning = second.0 - first.0;
    let center = near + (second.1 - first.1).quarter_turn() * (Ball::from(1) / turning);
    let is_near = |center: &Pair<Ball>| (center.rounded() - near.rounded()).norm() < reach;
    Some(center).filter(|center| center.x.is_known() && center.y.is_known() && is_near(center))
}

/// The same as a place; at infinity where nothing but the rounding of a rotation is left; `None` where the links are at rest on one another.
fn place_of_moving(motion: &Motion, pair: LinkPair, near: Point, reach: f64) -> Option<Place> {
    if let Some(center) = moving_center(motion, pair, near.coords, reach) {
        return Some(Place::At(Point::from(center.rounded())));
    }
    let [first, second] = pair.links().map(|link| motion.body(link).velocity_at(near));
    crate::geometry::unit(quarter_turn(second - first)).map(Place::AtInfinity)
}
