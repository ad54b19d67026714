//! What acts on the links besides their joints: weights, inertia, given forces and couples, springs.

use super::{Counted, Posed};
use crate::geometry::{Ball, Pair, Solvable, degrees_of};
use crate::mechanism::{BodyId, GROUND, Mechanism};
use crate::scene::{Amount, Analysis, Gauge, GivenBy, LinkPlace, Load, Loads, Mass, Spring, SpringEnd};
use std::marker::PhantomData;

/// Where a load comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Source {
    /// The weight of the body.
    Weight,
    /// Its inertia: −m a of its centre of mass, and −J α.
    Inertia,
    /// The force or couple of this index among those of the scene.
    Given(usize),
    /// The spring of this index.
    Spring(usize),
}

impl Source {
    /// The name in results of a load from there on a body: that which the scene gives it, `weight(2)`, `inertia(2)`; of a spring with the link
    /// on which it pulls.
    pub(crate) fn name(self, mechanism: &Mechanism, body: BodyId) -> String {
        let link = &mechanism.body(body).name;
        let loads = mechanism.loads.as_ref().map(|loads| &loads.0);
        match self {
            Source::Weight => format!("weight({link})"),
            Source::Inertia => format!("inertia({link})"),
            Source::Given(index) => loads.map_or_else(String::new, |loads| loads.loads[index].name.clone()),
            Source::Spring(index) => {
                loads.map_or_else(String::new, |loads| format!("{}({link})", loads.springs[index].name))
            }
        }
    }
}

/// A load on a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Acting<N = Ball> {
    pub source: Source,
    pub body: BodyId,
    /// The place where the force acts.
    pub at: Pair<N>,
    pub force: Pair<N>,
    /// A couple beside it, counter-clockwise positive.
    pub couple: N,
}

/// A force and its moment about a body's reference place.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Wrench<N = Ball> {
    pub force: Pair<N>,
    pub moment: N,
}

impl<N: Solvable> Wrench<N> {
    pub(super) fn add(&mut self, other: Wrench<N>) {
        self.force = self.force + other.force;
        self.moment = self.moment + other.moment;
    }

    pub(super) fn times(self, factor: N) -> Wrench<N> {
        Wrench { force: self.force * factor, moment: self.moment * factor }
    }
}

/// All loads on bodies whose equilibrium counts; `factor` is the force that one unit of mass needs for one unit of acceleration; the frame among them for what springs do to it. `None` where a load changes over an
/// angle or a position that there is not.
pub(super) fn acting<N: Counted>(
    loads: &Loads,
    factor: Ball,
    mechanism: &Mechanism,
    posed: &impl Posed<N>,
) -> Option<Vec<Acting<N>>> {
    let here = Here { mechanism, posed, numbers: PhantomData };
    let factor = N::of_ball(factor);
    let gravity = Pair { x: posed.given(loads.gravity[0]), y: posed.given(loads.gravity[1]) };
    let mut all = Vec::new();
    for (link, mass) in &loads.masses {
        if let Some(body) = mechanism.link(link) {
            here.masses(body, mass, factor, gravity, loads.analysis, &mut all);
        }
    }
    for (index, load) in loads.loads.iter().enumerate() {
        all.push(here.given(index, load)?);
    }
    all.extend(loads.springs.iter().enumerate().flat_map(|(index, spring)| here.spring(index, spring)));
    Some(all)
}

/// The centre of mass of a body; `None` of one without a mass.
pub(crate) fn center<N: Counted>(mechanism: &Mechanism, posed: &impl Posed<N>, body: BodyId) -> Option<Pair<N>> {
    let loads = &mechanism.loads.as_ref()?.0;
    let mass = loads.masses.get(&mechanism.body(body).name)?;
    Some(Here { mechanism, posed, numbers: PhantomData }.place(body, &mass.center))
}

struct Here<'a, P, N> {
    mechanism: &'a Mechanism,
    posed: &'a P,
    numbers: PhantomData<N>,
}

impl<N: Counted, P: Posed<N>> Here<'_, P, N> {
    /// The weight and the inertia of a link.
    fn masses(
        &self,
        body: BodyId,
        mass: &Mass,
        factor: N,
        gravity: Pair<N>,
        analysis: Analysis,
        all: &mut Vec<Acting<N>>,
    ) {
        let center = self.place(body, &mass.center);
        // In units of force per unit of acceleration.
        let amount = match mass.amount {
            Amount::Mass(amount) => factor * self.posed.given(amount),
            Amount::Weight(weight) => self.posed.given(weight) / gravity.dot(gravity).sqrt(),
        };
        let none = N::default();
        if gravity != Pair::default() {
            let force = gravity * amount;
            all.push(Acting { source: Source::Weight, body, at: center, force, couple: none });
        }
        if analysis == Analysis::Dynamic {
            let couple = -(factor * self.posed.given(mass.inertia) * self.posed.alpha(body));
            let force = self.posed.acceleration(body, center) * -amount;
            all.push(Acting { source: Source::Inertia, body, at: center, force, couple });
        }
    }

    fn given(&self, index: usize, load: &Load) -> Option<Acting<N>> {
        let body = self.mechanism.link(&load.on)?;
        let times =
            load.over.as_ref().map_or(Some(1.0.into()), |over| Some(N::of_ball(over.at(self.gauged(&over.of)?))))?;
        let [x, y] = load.force.map(|x| self.posed.given(x));
        let force = Pair { x, y } * times;
        let force = if load.turns { self.posed.axis(body).unwrap_or_default().turn(force) } else { force };
        let at = load.at.as_ref().map_or_else(|| about(self.mechanism, self.posed, body), |at| self.place(body, at));
        Some(Acting { source: Source::Given(index), body, at, force, couple: self.posed.given(load.couple) * times })
    }

    /// What a load changes over: an angle in degrees or a position, with its bound.
    fn gauged(&self, gauge: &Gauge) -> Option<Ball> {
        match gauge {
            Gauge::Angle(link) => {
                let axis = self.posed.axis(self.mechanism.link(link)?)?;
                let axis = Pair { x: axis.x.ball(), y: axis.y.ball() };
                let degrees = degrees_of(axis.rounded());
                Some(Ball::from(degrees).widened(axis.degrees_from(degrees)))
            }
            Gauge::Position(slider) => Some(self.posed.slide_position(self.mechanism.slider_named(slider)?)?.ball()),
        }
    }

    /// What a spring does to both its ends.
    fn spring(&self, index: usize, spring: &Spring) -> Vec<Acting<N>> {
        let end = |end: &SpringEnd| self.mechanism.body_named(&end.on).map(|body| (body, self.place(body, &end.at)));
        let [Some((first, from)), Some((second, to))] = spring.ends.each_ref().map(end) else {
            return Vec::new();
        };
        let arm = to - from;
        let length = arm.dot(arm).sqrt();
        let pull = self.posed.given(spring.rate) * (length - self.posed.given(spring.length));
        let force = if self.posed.given(spring.length) == N::default() {
            // Without a length of its own it has a force even where its ends meet.
            arm * self.posed.given(spring.rate)
        } else {
            arm * (pull / length)
        };
        let on = |body, at, force| Acting { source: Source::Spring(index), body, at, force, couple: N::default() };
        vec![on(first, from, force), on(second, to, -force)]
    }

    /// A place of a body in the fixed frame.
    fn place(&self, body: BodyId, at: &LinkPlace) -> Pair<N> {
        let local = match at {
            LinkPlace::Point(name) => {
                return self.mechanism.point(name).map_or_else(Pair::default, |point| self.posed.place(point));
            }
            LinkPlace::Place(place) => place.map(|x| self.posed.given(x)),
            LinkPlace::Distance(distance) => [self.posed.given(*distance), N::default()],
        };
        let local = Pair { x: local[0], y: local[1] };
        if body == GROUND || self.mechanism.given_by == GivenBy::Drawing {
            return local;
        }
        match self.mechanism.body(body).points.first() {
            Some(&point) => {
                let arm = local - self.posed.local(body, point);
                self.posed.place(point) + self.posed.axis(body).unwrap_or_default().turn(arm)
            }
            None => local,
        }
    }
}

/// The place about which the moments of a body are taken: its first point.
pub(super) fn about<N: Counted>(mechanism: &Mechanism, posed: &impl Posed<N>, body: BodyId) -> Pair<N> {
    mechanism.body(body).points.first().map_or_else(Pair::default, |&point| posed.place(point))
}
