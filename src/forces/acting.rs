//! What acts on the links besides their joints: weights, inertia, given forces and couples, springs.

use super::{Counted, Posed};
use crate::geometry::{Ball, Pair, Point, Solvable, Vector, quarter_turn, unit};
use crate::mechanism::{BodyId, GROUND, JointId, Mechanism, PointId, SliderId};
use crate::position::Pose;
use crate::scene::{
    Amount, Analysis, Friction, Gauge, GivenBy, Grip, LinkPlace, Load, Mass, Over, RubbingJoint, Spring, SpringEnd,
};
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
    /// The friction in this joint.
    Friction(JointId),
}

impl Source {
    /// The name in results of a load from there on a body: that which the scene gives it, `weight(2)`, `inertia(2)`; of a spring with the link
    /// on which it pulls; of friction with the link and what rubs on it, `friction(3/2)` in a guide and `friction(B,2)` at a pin.
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
            Source::Friction(joint) => {
                let own = mechanism.joint(joint);
                match (own.pin, own.slider) {
                    (Some(pin), _) => format!("friction({},{link})", mechanism.point_name(pin)),
                    (None, Some(slider)) if own.bodies[1] == body => {
                        format!("friction({})", mechanism.slider_name(slider))
                    }
                    _ => format!("friction({link}/{})", mechanism.body(own.bodies[1]).name),
                }
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

/// The loads of a scene by the bodies and points of its mechanism, looked up once.
#[derive(Clone, Debug)]
pub(crate) struct LoadList {
    /// The force that one unit of mass needs for one unit of acceleration.
    factor: Ball,
    gravity: [f64; 2],
    has_inertia: bool,
    masses: Vec<PlacedMass>,
    given: Vec<PlacedLoad>,
    springs: Vec<PlacedSpring>,
    /// The joints with friction.
    pub(super) friction: Vec<(JointId, Rub)>,
}

/// The friction of a joint.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rub {
    /// At a pin with a journal of this radius.
    Pin { radius: f64, grip: Grip },
    /// In the guide of this slider.
    Guide(SliderId, Grip),
}

impl Grip {
    /// tan φ of the angle of friction, the coefficient.
    pub(crate) fn tangent(self) -> f64 {
        match self {
            Grip::Coefficient(tangent) => tangent,
            Grip::Angle(angle) => angle.tangent_and_sine()[0],
        }
    }

    /// sin φ of the angle of friction.
    pub(crate) fn sine(self) -> f64 {
        match self {
            Grip::Coefficient(tangent) => tangent / (1.0 + tangent * tangent).sqrt(),
            Grip::Angle(angle) => angle.tangent_and_sine()[1],
        }
    }

    /// tan φ and sin φ of the angle of friction.
    pub(super) fn tangent_and_sine<N: Counted>(self, posed: &impl Posed<N>) -> [N; 2] {
        match self {
            Grip::Coefficient(coefficient) => {
                let tangent = posed.given(coefficient);
                [tangent, tangent / (N::from(1) + tangent * tangent).sqrt()]
            }
            Grip::Angle(angle) => posed.given(angle).tangent_and_sine(),
        }
    }
}

#[derive(Clone, Debug)]
struct PlacedMass {
    body: BodyId,
    amount: Amount,
    inertia: f64,
    center: Spot,
}

#[derive(Clone, Debug)]
struct PlacedLoad {
    body: BodyId,
    at: Spot,
    force: [f64; 2],
    couple: f64,
    turns: bool,
    over: Option<(Changing, Over)>,
}

#[derive(Clone, Debug)]
struct PlacedSpring {
    ends: [(BodyId, Spot); 2],
    rate: f64,
    length: f64,
}

/// A place of a body.
#[derive(Clone, Copy, Debug)]
enum Spot {
    Point(PointId),
    /// In the fixed frame.
    Fixed([f64; 2]),
    /// In the frame of the body that has this point.
    Local(PointId, [f64; 2]),
}

impl Spot {
    /// Where it is, rounded.
    fn at(self, mechanism: &Mechanism, pose: &Pose, body: BodyId) -> Point {
        match self {
            Spot::Point(point) => pose.point(point),
            Spot::Fixed(place) => place.into(),
            Spot::Local(point, place) => {
                let axis = pose.axes[body.0].and_then(unit).unwrap_or_default();
                let arm = Point::from(place) - mechanism.local(body, point);
                pose.point(point) + axis * arm.x + quarter_turn(axis) * arm.y
            }
        }
    }
}

/// What a load changes over.
#[derive(Clone, Copy, Debug)]
enum Changing {
    Angle(BodyId),
    Position(SliderId),
}

/// The centre of mass of a body; `None` of one without a mass.
pub(crate) fn center<N: Counted>(mechanism: &Mechanism, posed: &impl Posed<N>, body: BodyId) -> Option<Pair<N>> {
    let loads = &mechanism.loads.as_ref()?.0;
    let mass = loads.masses.get(&mechanism.body(body).name)?;
    let center = spot(mechanism, body, Some(&mass.center));
    Some(Here { posed, numbers: PhantomData }.place(body, center))
}

/// The joints of a mechanism with loads that have friction.
pub(crate) fn rubbed_joints(mechanism: &Mechanism) -> Vec<JointId> {
    let loads = mechanism.loads.iter().map(|loads| &loads.0);
    let all = loads.flat_map(|loads| &loads.friction).flat_map(|friction| rubbed(mechanism, friction));
    all.map(|(joint, _)| joint).collect()
}

/// The ends of the springs, each with its body.
pub(crate) fn spring_ends(mechanism: &Mechanism, pose: &Pose) -> Vec<[(BodyId, Point); 2]> {
    let springs = LoadList::new(mechanism).map_or_else(Vec::new, |list| list.springs);
    springs.into_iter().map(|spring| spring.ends.map(|(body, spot)| (body, spot.at(mechanism, pose, body)))).collect()
}

/// The places where loads act on links and springs end, and the corners around the circles of friction.
pub(crate) fn places_of_loads(mechanism: &Mechanism, pose: &Pose) -> Vec<Point> {
    let Some(list) = LoadList::new(mechanism) else { return Vec::new() };
    let masses = list.masses.iter().map(|mass| (mass.body, mass.center));
    let given = list.given.iter().map(|load| (load.body, load.at));
    let ends = list.springs.iter().flat_map(|spring| spring.ends);
    let acting = masses.chain(given).chain(ends).map(|(body, spot)| spot.at(mechanism, pose, body));
    let circles = friction_circles(mechanism).into_iter().flat_map(|(pin, radius)| {
        let arm = Vector::new(radius, radius);
        [pose.point(pin) - arm, pose.point(pin) + arm]
    });
    acting.chain(circles).collect()
}

/// The pins with friction, and the radii of their circles of friction, r sin φ.
pub(crate) fn friction_circles(mechanism: &Mechanism) -> Vec<(PointId, f64)> {
    let loads = mechanism.loads.iter().map(|loads| &loads.0);
    let circle = |friction: &Friction| match &friction.joint {
        RubbingJoint::Pin { point, radius, .. } => Some((mechanism.point(point)?, radius * friction.grip.sine())),
        RubbingJoint::Guide(_) => None,
    };
    loads.flat_map(|loads| &loads.friction).filter_map(circle).collect()
}

/// The joints that have this friction.
fn rubbed(mechanism: &Mechanism, friction: &Friction) -> Vec<(JointId, Rub)> {
    let grip = friction.grip;
    match &friction.joint {
        RubbingJoint::Pin { point, radius, .. } => {
            mechanism.joints_at_pin(point).map(|joint| (joint, Rub::Pin { radius: *radius, grip })).collect()
        }
        RubbingJoint::Guide(name) => {
            let slider = mechanism.slider_named(name);
            slider.map(|slider| (mechanism.slider_joint(slider), Rub::Guide(slider, grip))).into_iter().collect()
        }
    }
}

/// A place of a body as the scene gives it; its first point where it gives none.
fn spot(mechanism: &Mechanism, body: BodyId, at: Option<&LinkPlace>) -> Spot {
    let first = mechanism.first_point(body);
    let local = match at {
        Some(LinkPlace::Point(name)) => return mechanism.point(name).map_or(Spot::Fixed([0.0; 2]), Spot::Point),
        None => return first.map_or(Spot::Fixed([0.0; 2]), Spot::Point),
        Some(LinkPlace::Place(place)) => *place,
        Some(LinkPlace::Distance(distance)) => [*distance, 0.0],
    };
    match first {
        Some(point) if body != GROUND && mechanism.given_by != GivenBy::Drawing => Spot::Local(point, local),
        _ => Spot::Fixed(local),
    }
}

impl LoadList {
    /// `None` without loads, and where a load changes over an angle or a position that there is not.
    pub fn new(mechanism: &Mechanism) -> Option<LoadList> {
        let (loads, factor) = &**mechanism.loads.as_ref()?;
        let mass = |(link, mass): (&String, &Mass)| {
            let body = mechanism.link(link)?;
            let Mass { amount, inertia, ref center } = *mass;
            Some(PlacedMass { body, amount, inertia, center: spot(mechanism, body, Some(center)) })
        };
        let changing = |gauge: &Gauge| match gauge {
            Gauge::Angle(link) => mechanism.link(link).map(Changing::Angle),
            Gauge::Position(slider) => mechanism.slider_named(slider).map(Changing::Position),
        };
        let given = |load: &Load| {
            let body = mechanism.link(&load.on)?;
            let over = match &load.over {
                Some(over) => Some((changing(&over.of)?, over.clone())),
                None => None,
            };
            let Load { force, couple, turns, .. } = *load;
            Some(PlacedLoad { body, at: spot(mechanism, body, load.at.as_ref()), force, couple, turns, over })
        };
        let spring = |spring: &Spring| {
            let end = |end: &SpringEnd| {
                let body = mechanism.body_named(&end.on)?;
                Some((body, spot(mechanism, body, Some(&end.at))))
            };
            let [Some(first), Some(second)] = spring.ends.each_ref().map(end) else { return None };
            Some(PlacedSpring { ends: [first, second], rate: spring.rate, length: spring.length })
        };
        Some(LoadList {
            factor: *factor,
            gravity: loads.gravity,
            has_inertia: loads.analysis == Analysis::Dynamic,
            masses: loads.masses.iter().filter_map(mass).collect(),
            given: loads.loads.iter().map(given).collect::<Option<_>>()?,
            springs: loads.springs.iter().map(spring).collect::<Option<_>>()?,
            friction: loads.friction.iter().flat_map(|friction| rubbed(mechanism, friction)).collect(),
        })
    }

    /// The same with smooth joints.
    pub(super) fn without_friction(self) -> LoadList {
        LoadList { friction: Vec::new(), ..self }
    }

    /// All loads on bodies whose equilibrium counts; the frame among them for what springs do to it. `None` where a load changes over
    /// the angle of a body without an axis, or a position that counts from no point.
    pub fn acting<N: Counted>(&self, posed: &impl Posed<N>) -> Option<Vec<Acting<N>>> {
        let here = Here { posed, numbers: PhantomData };
        let gravity = self.gravity.map(|x| posed.given(x));
        let mut all = Vec::with_capacity(2 * self.masses.len() + self.given.len() + 2 * self.springs.len());
        for mass in &self.masses {
            self.masses(&here, mass, Pair { x: gravity[0], y: gravity[1] }, &mut all);
        }
        for (index, load) in self.given.iter().enumerate() {
            all.push(here.given(index, load)?);
        }
        all.extend(self.springs.iter().enumerate().flat_map(|(index, spring)| here.spring(index, spring)));
        Some(all)
    }

    /// The springs with a length of their own whose ends may meet here, so that their force has no direction.
    pub(super) fn collapsed_springs(&self, posed: &impl Posed<Ball>) -> Vec<usize> {
        let here = Here { posed, numbers: PhantomData };
        let collapsed = |spring: &PlacedSpring| {
            let [from, to] = spring.ends.map(|(body, at)| here.place(body, at));
            spring.length != 0.0 && [(to - from).x, (to - from).y].iter().all(|x| x.smallest() == 0.0)
        };
        let springs = self.springs.iter().enumerate();
        springs.filter(|(_, spring)| collapsed(spring)).map(|(index, _)| index).collect()
    }

    /// The weight and the inertia of a link.
    fn masses<N: Counted, P: Posed<N>>(
        &self,
        here: &Here<'_, P, N>,
        mass: &PlacedMass,
        gravity: Pair<N>,
        all: &mut Vec<Acting<N>>,
    ) {
        let (posed, body) = (here.posed, mass.body);
        let center = here.place(body, mass.center);
        let factor = N::of_ball(self.factor);
        // In units of force per unit of acceleration.
        let amount = match mass.amount {
            Amount::Mass(amount) => factor * posed.given(amount),
            Amount::Weight(weight) => posed.given(weight) / gravity.dot(gravity).sqrt(),
        };
        if self.gravity != [0.0; 2] {
            let (force, couple) = (gravity * amount, N::default());
            all.push(Acting { source: Source::Weight, body, at: center, force, couple });
        }
        if self.has_inertia {
            let couple = -(factor * posed.given(mass.inertia) * posed.alpha(body));
            let force = posed.acceleration(body, center) * -amount;
            all.push(Acting { source: Source::Inertia, body, at: center, force, couple });
        }
    }
}

struct Here<'a, P, N> {
    posed: &'a P,
    numbers: PhantomData<N>,
}

impl<N: Counted, P: Posed<N>> Here<'_, P, N> {
    fn given(&self, index: usize, load: &PlacedLoad) -> Option<Acting<N>> {
        let body = load.body;
        let [x, y] = load.force.map(|x| self.posed.given(x));
        let mut force = Pair { x, y };
        let mut couple = self.posed.given(load.couple);
        if let Some((changing, over)) = &load.over {
            let times = self.times(*changing, over)?;
            (force, couple) = (force * times, couple * times);
        }
        if load.turns {
            force = self.posed.axis(body).unwrap_or_default().turn(force);
        }
        Some(Acting { source: Source::Given(index), body, at: self.place(body, load.at), force, couple })
    }

    /// How often a load acts here that changes over the motion.
    fn times(&self, changing: Changing, over: &Over) -> Option<N> {
        let at = match changing {
            Changing::Angle(link) => self.posed.axis(link).map(N::degrees)?,
            Changing::Position(slider) => self.posed.slide_position(slider)?,
        };
        Some(at.factor(over, |number| self.posed.given(number)))
    }

    /// What a spring does to both its ends.
    fn spring(&self, index: usize, spring: &PlacedSpring) -> [Acting<N>; 2] {
        let [(first, from), (second, to)] = spring.ends.map(|(body, at)| (body, self.place(body, at)));
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
        [on(first, from, force), on(second, to, -force)]
    }

    /// A place of a body in the fixed frame.
    fn place(&self, body: BodyId, at: Spot) -> Pair<N> {
        let given = |[x, y]: [f64; 2]| Pair { x: self.posed.given(x), y: self.posed.given(y) };
        match at {
            Spot::Point(point) => self.posed.place(point),
            Spot::Fixed(place) => given(place),
            Spot::Local(point, place) => {
                let arm = given(place) - self.posed.local(body, point);
                self.posed.place(point) + self.posed.axis(body).unwrap_or_default().turn(arm)
            }
        }
    }
}

/// The place about which the moments of a body are taken: its first point.
pub(super) fn about<N: Counted>(mechanism: &Mechanism, posed: &impl Posed<N>, body: BodyId) -> Pair<N> {
    mechanism.first_point(body).map_or_else(Pair::default, |point| posed.place(point))
}
