//! Zhukovsky's lever: the velocity plan turned by 90° clockwise is a lever about its pole, on which each force acts at the image of its
//! point. Its moments about the pole, counter-clockwise positive, are the forces' powers; so equilibrium of the lever gives what a drive needs, without
//! any joint's force (N. E. Zhukovsky, 1909). A couple acts as two forces on two images of its link, which lie as its points do. With several drives
//! each has a lever of its own: it runs at rate 1, and the others stand. `told` says it.

mod told;

use super::number::{Equation, NumberId, NumberKind, Product, ProductKind};
use super::operation::{Along, MeasuredAs, OperationKind, OperationRole, PlaceId};
use super::plan::NOTHING;
use super::step::Action;
use super::writer::Writer;
use crate::forces::{Driven, Forces, lever_states};
use crate::geometry::{Ball, Number, Pair, Point, Vector, unit};
use crate::mechanism::{BodyId, PointId, Role};
use crate::motion::State;
use crate::sheet::Sheet;
use std::collections::BTreeMap;

/// White between levers, in parts of the widest one.
const APART: f64 = 0.25;

/// How many times as large as its error a load must be to be put on a lever.
const CERTAIN: f64 = 8.0;

/// The lever of one drive.
#[derive(Clone, Debug)]
pub struct Lever {
    /// The drive.
    pub drive: Driven,
    /// Its rate on the lever: its own, or 1 where there are several drives.
    pub rate: f64,
    /// The pole, in units of velocity as all places here.
    pub pole: Vector,
    /// The links' points with their images.
    pub links: Vec<(BodyId, Vec<(PointId, Vector)>)>,
    /// The forces at their images.
    pub forces: Vec<LeverForce>,
    /// What the drive needs: torque, or force along the guide.
    pub effort: f64,
    /// The name of that quantity.
    pub(super) name: String,
    /// By load that is put on it: its power, and the name of that, if the lever moves as the mechanism does.
    pub(crate) powers: Vec<LoadPower>,
    /// The same as a number of the construction.
    pub(super) number: NumberId,
}

/// The power of a load on a lever: the moments of its forces about the pole.
#[derive(Clone, Debug)]
pub(crate) struct LoadPower {
    /// The load, by its index.
    pub load: usize,
    /// Its power.
    pub number: NumberId,
    /// The last of its forces on the lever.
    pub last: Option<usize>,
    /// The name of the quantity; none where the lever moves at a rate of its own.
    pub name: Option<String>,
}

/// A force on a lever.
#[derive(Clone, Copy, Debug)]
pub struct LeverForce {
    /// The load, by its index.
    pub load: usize,
    /// Whether it is one of the two forces of its couple.
    pub is_of_couple: bool,
    /// Where it acts.
    pub at: Vector,
    /// Its direction.
    pub along: Vector,
    /// The foot of its arm.
    pub foot: Vector,
    /// Its size, not below zero.
    pub size: f64,
    /// Its arm, positive where it turns the lever counter-clockwise.
    pub arm: f64,
    /// Size and arm as numbers of the construction.
    pub(crate) numbers: [NumberId; 2],
    /// Where it acts, as a place of the construction.
    pub(crate) place: PlaceId,
}

/// What is done in a step of a lever; levers and forces by their indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeverStep {
    /// Turn the velocity plan.
    Turn(usize),
    /// Put a force at its image and measure its arm.
    Arm(usize, usize),
    /// Take moments about the pole.
    Effort(usize),
}

/// A force that is put on the lever.
struct Put {
    load: usize,
    is_of_couple: bool,
    size: NumberId,
    along: Vector,
    at: Pair<Ball>,
    exact: Option<Pair<Ball>>,
}

/// Draws the levers of all drives.
pub(super) fn levers(writer: &mut Writer<'_>, computed: &Forces) -> Vec<Lever> {
    let states = lever_states(writer.mechanism, writer.pose);
    let own_rate = match &states[..] {
        [(drive, _)] => drive.rate(writer.mechanism).filter(|rate| *rate != 0.0),
        _ => None,
    };
    let rate = own_rate.unwrap_or(1.0);
    let mut all: Vec<Lever> = Vec::new();
    let mut left = 0.0;
    for (drive, state) in states {
        let first = writer.construction.operations.len();
        let index = all.len();
        if let Some(mut lever) = writer.lever(index, computed, (drive, &state, rate)) {
            let [low, high] = lever.extent();
            if index > 0 {
                writer.shift_lever(first, Vector::new(left - low.x, 0.0), &mut lever);
            }
            let [_, high] = if index > 0 { lever.extent() } else { [low, high] };
            left = high.x + APART * (high - low).amax();
            all.push(lever);
        }
    }
    all
}

impl Lever {
    /// The corners of the box around its images.
    fn extent(&self) -> [Vector; 2] {
        let images = self.links.iter().flat_map(|(_, images)| images.iter().map(|(_, at)| *at));
        let places = images.chain(self.forces.iter().map(|force| force.at));
        places.fold([self.pole; 2], |[low, high], place| [low.inf(&place), high.sup(&place)])
    }

    fn moved(&mut self, by: Vector) {
        self.pole += by;
        self.links.iter_mut().flat_map(|(_, images)| images).for_each(|(_, at)| *at += by);
        for force in &mut self.forces {
            force.at += by;
            force.foot += by;
        }
    }
}

/// A velocity turned by 90° clockwise.
fn turned(velocity: Pair<Ball>) -> Pair<Ball> {
    -velocity.quarter_turn()
}

impl Writer<'_> {
    fn lever(&mut self, index: usize, computed: &Forces, (drive, state, rate): (Driven, &State, f64)) -> Option<Lever> {
        let step = self.begin(Sheet::Lever);
        let pole = self.pole(Sheet::Lever, &format!("p{}", index + 1), Vector::zeros());
        let mechanism = self.mechanism;
        let image =
            |body: BodyId, at: Pair<Ball>| turned(state.body(body).referred_to(at).velocity) * Ball::within(rate, 0.0);
        let mut links = Vec::new();
        for (body, own) in mechanism.links().filter(|(_, body)| body.role != Role::Unsolved) {
            let at =
                |point: &PointId| (*point, image(body, Pair::within(self.pose.point(*point).coords, 0.0)).rounded());
            links.push((body, own.points.iter().map(at).collect::<Vec<_>>()));
        }
        self.finish(step, Action::Lever(LeverStep::Turn(index)));
        let mut powers = Vec::new();
        let mut forces: Vec<LeverForce> = Vec::new();
        // By body with a couple: where its two forces act.
        let mut apart: BTreeMap<BodyId, Option<[Pair<Ball>; 2]>> = BTreeMap::new();
        let is_own_rate = drive.rate(mechanism) == Some(rate) && index == 0;
        for (load, acting) in computed.acting.iter().enumerate() {
            let mut put: Vec<Put> = Vec::new();
            let mut of_load: Vec<Product> = Vec::new();
            let force = acting.force.rounded();
            // What rounding leaves of none has no direction, and no power to speak of.
            if force.norm() > CERTAIN * acting.force.errors().norm()
                && let Some(along) = unit(force)
                && let Some(size) = self.take(true, Sheet::Lever, NumberKind::Force, force.norm())
            {
                self.construction.record.exact.numbers[size.0] = acting.force.dot(acting.force).sqrt();
                let at = image(acting.body, acting.at);
                put.push(Put { load, is_of_couple: false, size, along, at, exact: Some(acting.force) });
            }
            if acting.couple.high.abs() > CERTAIN * acting.couple.error() {
                let body = acting.body;
                match *apart.entry(body).or_insert_with(|| self.places_apart(computed, body)) {
                    Some(places) => {
                        let images = places.map(|place| image(acting.body, place));
                        put.extend(self.couple_on_lever(load, acting.couple, places, images));
                    }
                    // A link that is one point on the drawing.
                    None => of_load.extend(
                        self.power_of_couple(acting.couple, state.body(acting.body).omega * Ball::within(rate, 0.0)),
                    ),
                }
            }
            for put in put {
                let step = self.begin(Sheet::Lever);
                let (found, product) = self.arm_on_lever(pole, &put)?;
                of_load.extend(product);
                forces.push(found);
                self.finish(step, Action::Lever(LeverStep::Arm(index, forces.len() - 1)));
            }
            if !of_load.is_empty() {
                let number = self.compute(Sheet::Lever, NumberKind::Moment, of_load);
                let last = forces.iter().rposition(|force| force.load == load);
                let name = is_own_rate.then(|| format!("power({})", acting.source.name(mechanism, acting.body)));
                powers.push(LoadPower { load, number, last, name });
            }
        }
        let step = self.begin(Sheet::Lever);
        let rate_number = self.take(true, Sheet::Lever, NumberKind::Size, rate)?;
        let left = vec![(0, Product::plain(rate_number))];
        let right = powers.iter().map(|power| Product::plain(power.number).times(-1.0)).collect();
        let found = self.solve(Sheet::Lever, vec![NumberKind::Moment], vec![Equation { left, right }])?;
        let number = *found.first()?;
        self.finish(step, Action::Lever(LeverStep::Effort(index)));
        let effort = self.construction.record.exact.numbers[number.0].high;
        let name = match drive {
            Driven::Body(body) => format!("T({})", mechanism.body(body).name),
            Driven::Slider(slider) => format!("F({})", mechanism.slider_name(slider)),
        };
        Some(Lever { drive, rate, pole: Vector::zeros(), links, forces, effort, name, powers, number })
    }

    /// The two forces of a couple at the images of two points: each is the couple over their distance, normal to their line.
    fn couple_on_lever(
        &mut self,
        load: usize,
        couple: Ball,
        [from, to]: [Pair<Ball>; 2],
        [first_image, second_image]: [Pair<Ball>; 2],
    ) -> Vec<Put> {
        let arm = to - from;
        let Some(along) = unit(arm.rounded()) else { return Vec::new() };
        let normal = Vector::new(-along.y, along.x) * couple.high.signum();
        let size = couple / arm.dot(arm).sqrt();
        let sizes = [0, 1].map(|_| self.take(true, Sheet::Lever, NumberKind::Force, size.high.abs()));
        let [Some(first), Some(second)] = sizes else { return Vec::new() };
        let exact = arm.unit().quarter_turn() * size;
        [(first, first_image, -normal, -exact), (second, second_image, normal, exact)]
            .map(|(number, at, along, exact)| {
                self.construction.record.exact.numbers[number.0] = if size.high < 0.0 { -size } else { size };
                Put { load, is_of_couple: true, size: number, along, at, exact: Some(exact) }
            })
            .into()
    }

    /// Two places apart of a body or of one that turns with it: points, and where loads act, as in a centre of mass.
    fn places_apart(&self, computed: &Forces, body: BodyId) -> Option<[Pair<Ball>; 2]> {
        let mechanism = self.mechanism;
        let turns_alike = |other: &BodyId| {
            let fixed = mechanism.joints.iter().filter_map(|joint| joint.angular.as_ref()?.as_fixed_angle());
            fixed.into_iter().any(|(bodies, _)| bodies.contains(&body) && bodies.contains(other))
        };
        let farthest = |body: BodyId| {
            let points =
                mechanism.body(body).points.iter().map(|point| Pair::within(self.pose.point(*point).coords, 0.0));
            let loads = computed.acting.iter().filter(|load| load.body == body).map(|load| load.at);
            let mut places = points.chain(loads);
            let from: Pair<Ball> = places.next()?;
            let distance = |place: &Pair<Ball>| (*place - from).rounded().norm();
            let to = places.max_by(|a, b| distance(a).total_cmp(&distance(b)))?;
            (distance(&to) > self.near).then_some([from, to])
        };
        std::iter::once(body).chain(mechanism.body_ids().filter(turns_alike)).find_map(farthest)
    }

    /// The power of a couple, from the angular velocity of its link.
    fn power_of_couple(&mut self, couple: Ball, omega: Ball) -> Option<Product> {
        let numbers = [(NumberKind::Moment, couple), (NumberKind::Size, omega)].map(|(kind, value)| {
            let number = self.take(true, Sheet::Lever, kind, value.high)?;
            self.construction.record.exact.numbers[number.0] = value;
            Some(number)
        });
        let [Some(couple), Some(omega)] = numbers else { return None };
        Some(Product::new(ProductKind::Turning, 1.0, &[couple, omega]))
    }

    /// Puts a force at its image and measures its arm about the pole; nothing to add for one that acts in the pole.
    fn arm_on_lever(&mut self, pole: PlaceId, put: &Put) -> Option<(LeverForce, Option<Product>)> {
        let place = self.plot_exact(Sheet::Lever, OperationRole::Load(put.load), put.at);
        let line = self.draw(Sheet::Lever, OperationRole::ForceLine, place, Along::given(put.along));
        if let Some(exact) = put.exact {
            self.construction.record.exact.lines[line.0].1 = exact.unit();
        }
        let normal = self.draw(Sheet::Lever, OperationRole::ForceLine, pole, Along::line(line).turned(3));
        let foot = self.cross(true, Sheet::Lever, OperationRole::Foot, [line, normal])?;
        let arm = self.measure(Sheet::Lever, NumberKind::Arm, [pole, foot], MeasuredAs::Along(normal));
        let exact = &self.construction.record.exact;
        let (at, foot) = (exact.places[place.0].rounded(), exact.places[foot.0].rounded());
        let (size, length) = (exact.numbers[put.size.0].high, exact.numbers[arm.0].high);
        let found = LeverForce {
            load: put.load,
            is_of_couple: put.is_of_couple,
            at,
            along: put.along,
            foot,
            size,
            arm: length,
            numbers: [put.size, arm],
            place,
        };
        Some((found, Some(Product::new(ProductKind::Moment, 1.0, &[put.size, arm]))))
    }

    /// Moves a lever to where it has room: its operations are those from `first` on.
    fn shift_lever(&mut self, first: usize, by: Vector, lever: &mut Lever) {
        lever.moved(by);
        let construction = &mut self.construction;
        for operation in construction.operations[first..].iter_mut().filter(|own| own.sheet == Sheet::Lever) {
            if let OperationKind::Pole { at, .. } | OperationKind::Plot { at, .. } = &mut operation.kind {
                *at += by;
            }
            let exact = &mut construction.record.exact;
            if let Some(place) = operation.kind.place() {
                exact.places[place.0] = exact.places[place.0] + Pair::within(by, 0.0);
            }
            if let Some(line) = operation.kind.line() {
                exact.lines[line.0].0 = exact.lines[line.0].0 + Pair::within(by, 0.0);
            }
        }
    }
}

impl Lever {
    /// Something is seen of a force that is larger than this.
    #[must_use]
    pub fn least_shown(&self) -> f64 {
        NOTHING * self.forces.iter().map(|force| force.size).fold(0.0, f64::max)
    }

    /// The places on it, in units of velocity.
    pub(crate) fn places(&self) -> impl Iterator<Item = Point> + Clone {
        let images = self.links.iter().flat_map(|(_, images)| images.iter().map(|(_, at)| *at));
        images.chain(self.forces.iter().map(|force| force.at)).chain([self.pole]).map(Point::from)
    }

    /// The names of what a step of it finds.
    pub(super) fn names(&self, step: LeverStep) -> Vec<String> {
        match step {
            LeverStep::Turn(_) => Vec::new(),
            LeverStep::Effort(_) => vec![self.name.clone()],
            LeverStep::Arm(_, force) => {
                let found = self.powers.iter().filter(|power| power.last == Some(force));
                found.filter_map(|power| power.name.clone()).collect()
            }
        }
    }

    /// The name of what a number of it is.
    pub(super) fn number_name(&self, number: NumberId) -> Option<String> {
        let power = self.powers.iter().find(|power| power.number == number);
        if number == self.number { Some(self.name.clone()) } else { power?.name.clone() }
    }

    /// Its number, with the bound of its error.
    #[must_use]
    pub fn number(&self) -> NumberId {
        self.number
    }
}
