//! Forces with their lines of action on the scheme, their arms and moments.

use super::{ForceArm, ForceOf, ForcePart, ForcePlan, ForceStep, Found, FoundForce, LoadShown, Moment, MomentPoint};
use crate::construction::number::{Equation, NumberId, NumberKind, Product, ProductKind};
use crate::construction::operation::{Along, LineId, MeasuredAs, OperationRole, PlaceId};
use crate::construction::writer::{Begun, Writer};
use crate::forces::Forces;
use crate::geometry::{Ball, Number, Pair, Point, Vector, unit};
use crate::mechanism::{BodyId, JointId, Mechanism, PointId, SliderId};
use crate::sheet::Sheet;
use indexmap::IndexMap;

/// How many times as large as its error a force must be to have a direction.
const CERTAIN: f64 = 8.0;
/// Forces below this part of the largest are left out in any case.
const LEAST: f64 = 1e-25;

/// A force on a body, with a place of its line of action on the scheme.
#[derive(Clone, Copy, Debug)]
pub(super) struct Force {
    pub of: ForceOf,
    pub on: BodyId,
    pub at: PlaceId,
    pub along: Along,
    /// Its size along that direction, times `sign`.
    pub size: NumberId,
    pub sign: f64,
    /// What is known of it, before `sign`: the direction of its line is that of a rounded one.
    pub exact: Option<Pair<Ball>>,
}

impl From<Force> for FoundForce {
    fn from(Force { of, size, along, .. }: Force) -> FoundForce {
        FoundForce { of, size, along }
    }
}

/// A couple on a body, counter-clockwise positive.
#[derive(Clone, Copy, Debug)]
pub(super) struct Couple {
    pub size: NumberId,
    pub sign: f64,
}

impl Couple {
    pub fn reversed(self) -> Couple {
        Couple { sign: -self.sign, ..self }
    }
}

/// The known forces and couples on links that are cut free together.
#[derive(Clone, Debug, Default)]
pub(super) struct Set {
    pub forces: Vec<Force>,
    pub couples: Vec<Couple>,
}

impl Set {
    pub fn is_empty(&self) -> bool {
        self.forces.is_empty() && self.couples.is_empty()
    }

    pub fn with(mut self, forces: impl IntoIterator<Item = Force>, couples: impl IntoIterator<Item = Couple>) -> Set {
        self.forces.extend(forces);
        self.couples.extend(couples);
        self
    }
}

/// A force plan in progress.
pub(super) struct Statics<'w, 'a> {
    pub writer: &'w mut Writer<'a>,
    pub computed: &'w Forces,
    pub plan: ForcePlan,
    /// By body: its loads, and what later groups hand on to it.
    pub loads: Vec<Set>,
    /// By joint that is found: what it does to one of its bodies; none where it carries no force.
    pub joints: IndexMap<JointId, Option<Force>>,
    /// What guides give their sliding links, about the slider's point.
    pub couples: IndexMap<SliderId, Couple>,
    /// By mesh: its pitch point on the scheme.
    pub pitch_places: IndexMap<JointId, PlaceId>,
    /// The largest force, by the equations.
    pub largest: f64,
    /// What of loads is left out as nothing.
    pub left_out: f64,
}

impl<'w, 'a> Statics<'w, 'a> {
    pub fn new(writer: &'w mut Writer<'a>, computed: &'w Forces) -> Self {
        let of_joints = computed.joints.iter().map(|carried| carried.force.rounded().norm());
        let of_loads = computed.acting.iter().map(|load| load.force.rounded().norm());
        let largest = of_joints.chain(of_loads).fold(0.0, f64::max);
        let loads = vec![Set::default(); writer.mechanism.bodies.len()];
        let (joints, couples, pitch_places) = (IndexMap::new(), IndexMap::new(), IndexMap::new());
        let plan = ForcePlan::default();
        let mut statics =
            Statics { writer, computed, plan, loads, joints, couples, pitch_places, largest, left_out: 0.0 };
        statics.take_loads();
        statics
    }

    pub fn mechanism(&self) -> &'a Mechanism {
        self.writer.mechanism
    }

    /// Whether a force is what rounding leaves of none, so that it has no direction; it then counts among what is left out.
    pub fn is_nothing(&mut self, force: Pair<Ball>) -> bool {
        let (size, error) = (force.rounded().norm(), force.errors().norm());
        let is_nothing = size <= CERTAIN * error || size <= LEAST * self.largest;
        if is_nothing {
            self.left_out += size + error;
        }
        is_nothing
    }

    /// Takes the loads: size and direction of each, as they are given or follow from the motion.
    fn take_loads(&mut self) {
        for (index, load) in self.computed.acting.iter().enumerate() {
            let (force, couple) = (load.force.rounded(), load.couple.high);
            let at = Point::from(load.at.rounded());
            self.plan.loads.push(LoadShown { source: load.source, body: load.body, at, force, couple });
            self.plan.numbers.loads.push([None; 2]);
            if load.couple.high.abs() > CERTAIN * load.couple.error()
                && let Some(size) = self.writer.take(true, Sheet::Forces, NumberKind::Moment, couple)
            {
                self.writer.construction.record.exact.numbers[size.0] = load.couple;
                self.loads[load.body.0].couples.push(Couple { size, sign: 1.0 });
                self.plan.numbers.loads[index][1] = Some(size);
            } else {
                self.left_out += load.couple.largest() / self.writer.size;
            }
            if self.is_nothing(load.force) {
                continue;
            }
            let kind = NumberKind::Force;
            let Some(size) = self.writer.take(true, Sheet::Forces, kind, force.norm()) else { continue };
            self.writer.construction.record.exact.numbers[size.0] = load.force.dot(load.force).sqrt();
            let at = self.place_of_load(index, load.body, load.at);
            let along = Along::given(unit(force).unwrap_or_default());
            let of = ForceOf::Load(index);
            self.plan.numbers.loads[index][0] = Some(size);
            let force = Force { of, on: load.body, at, along, size, sign: 1.0, exact: Some(load.force) };
            self.loads[load.body.0].forces.push(force);
        }
    }

    /// The place of a load on the scheme: that of a joint, where it acts in one.
    fn place_of_load(&mut self, index: usize, body: BodyId, at: Pair<Ball>) -> PlaceId {
        let near =
            |point: &&PointId| (self.writer.pose.point(**point).coords - at.rounded()).norm() <= self.writer.near;
        match self.mechanism().body(body).points.iter().find(near) {
            Some(point) => self.writer.plot(*point),
            None => self.writer.plot_place(OperationRole::Load(index), at),
        }
    }

    /// All that is known to act on some bodies from outside.
    pub fn set(&self, bodies: &[BodyId]) -> Set {
        bodies.iter().fold(Set::default(), |set, body| {
            let own = &self.loads[body.0];
            set.with(own.forces.iter().copied(), own.couples.iter().copied())
        })
    }

    /// What a joint that is found does to one of its bodies.
    pub fn on(&self, joint: JointId, body: BodyId) -> Option<Force> {
        let force = self.joints.get(&joint).copied().flatten()?;
        Some(if force.on == body { force } else { self.reversed(force) })
    }

    /// What a joint does to its other body.
    pub fn reversed(&self, force: Force) -> Force {
        let ForceOf::Joint { joint, on, part } = force.of else { return force };
        let [first, second] = self.mechanism().joint(joint).bodies;
        let other = if on == first { second } else { first };
        let of = ForceOf::Joint { joint, on: other, part };
        Force { of, on: other, sign: -force.sign, ..force }
    }

    /// The place of a joint on the scheme.
    pub fn place(&mut self, joint: JointId) -> PlaceId {
        if let Some(place) = self.pitch_place(joint) {
            return place;
        }
        self.writer.plot(self.mechanism().joint_point(joint))
    }

    /// Where a place of the scheme is.
    pub fn point(&self, place: PlaceId) -> Point {
        self.writer.construction.origin + self.exact(place)
    }

    pub fn exact(&self, place: PlaceId) -> Vector {
        self.writer.construction.record.exact.places[place.0].rounded()
    }

    pub fn number(&self, number: NumberId) -> f64 {
        self.writer.construction.record.exact.numbers[number.0].high
    }

    /// Ends a step of this sheet; what it has done on the scheme belongs to it, too.
    pub fn finish(&mut self, begun: Begun, step: ForceStep) {
        let first = begun.first();
        let id = self.writer.finish(begun, step.into());
        for operation in &mut self.writer.construction.operations[first..] {
            if operation.step.is_none() && !operation.kind.is_shared() {
                operation.step = Some(id);
            }
        }
    }

    pub fn begin(&self) -> Begun {
        self.writer.begin(Sheet::Forces)
    }

    /// A line of action, drawn on the scheme unless it is there.
    pub fn line(&mut self, at: PlaceId, along: Along, exact: Option<Pair<Ball>>) -> LineId {
        if let Some(line) = self.writer.drawn(at, along) {
            return line;
        }
        let line = self.writer.draw(Sheet::Scheme, OperationRole::ForceLine, at, along);
        if let Some(exact) = exact {
            self.writer.construction.record.exact.lines[line.0].1 = exact.unit();
        }
        line
    }

    /// The arm of a force of this line of action about a place, positive where the force turns counter-clockwise; none where it acts in
    /// that very place.
    fn arm(&mut self, at: PlaceId, line: LineId, about: PlaceId) -> Option<(NumberId, PlaceId)> {
        if at == about {
            return None;
        }
        let normal = self.writer.draw(Sheet::Scheme, OperationRole::ForceLine, about, Along::line(line).turned(3));
        let foot = self.writer.cross(true, Sheet::Scheme, OperationRole::Foot, [line, normal])?;
        let how = MeasuredAs::Along(normal);
        Some((self.writer.measure(Sheet::Scheme, NumberKind::Arm, [about, foot], how), foot))
    }

    /// The moments of all that is known about a place, with the arms that are measured.
    fn moments(&mut self, set: &Set, about: PlaceId) -> (Vec<Product>, Vec<ForceArm>) {
        let (mut sum, mut arms) = (Vec::new(), Vec::new());
        for force in &set.forces {
            let line = self.line(force.at, force.along, force.exact);
            if let Some((arm, foot)) = self.arm(force.at, line, about) {
                sum.push(Product::new(ProductKind::Moment, force.sign, &[force.size, arm]));
                arms.push(self.shown_arm(force.of, [force.at, foot], arm));
            }
        }
        sum.extend(set.couples.iter().map(|couple| Product::new(ProductKind::Plain, couple.sign, &[couple.size])));
        (sum, arms)
    }

    fn shown_arm(&self, of: ForceOf, line: [PlaceId; 2], arm: NumberId) -> ForceArm {
        ForceArm { of, line: line.map(|place| self.point(place)), length: self.number(arm).abs(), number: arm }
    }

    /// Finds a force along a line from the moments of links about a place. `Some(None)` where nothing has a moment.
    pub fn force_by_moments(
        &mut self,
        step: Begun,
        links: &[BodyId],
        set: &Set,
        (about, place): (MomentPoint, PlaceId),
        (of, at, along): (ForceOf, PlaceId, Along),
    ) -> Option<Option<Force>> {
        let (sum, mut arms) = self.moments(set, place);
        if sum.is_empty() {
            return Some(None);
        }
        let line = self.line(at, along, None);
        let (arm, foot) = self.arm(at, line, place)?;
        arms.push(self.shown_arm(of, [at, foot], arm));
        let left = vec![(0, Product::plain(arm))];
        let right = sum.iter().map(|product| product.times(-1.0)).collect();
        let found = self.writer.solve(Sheet::Forces, vec![NumberKind::Force], vec![Equation { left, right }])?;
        let size = *found.first()?;
        let value = self.number(size);
        self.take_moment(
            step,
            Moment { links: links.to_vec(), about, at: self.point(place), arms, finds: Found::Force(of), value },
        );
        let ForceOf::Joint { on, .. } = of else { return None };
        let force = Force { of, on, at, along, size, sign: 1.0, exact: None };
        self.plan.numbers.parts.push(force.into());
        Some(Some(force))
    }

    /// Finds a couple from the moments of links about a joint; none where nothing has a moment.
    pub fn couple_by_moments(&mut self, links: &[BodyId], set: &Set, about: PointId, finds: Found) -> Option<NumberId> {
        let step = self.begin();
        let place = self.writer.plot(about);
        let (sum, arms) = self.moments(set, place);
        if sum.is_empty() {
            return None;
        }
        let sum = sum.iter().map(|product| product.times(-1.0)).collect();
        let size = self.writer.compute(Sheet::Forces, NumberKind::Moment, sum);
        let (links, about, at, value) =
            (links.to_vec(), MomentPoint::Joint(about), self.point(place), self.number(size));
        self.take_moment(step, Moment { links, about, at, arms, finds, value });
        Some(size)
    }

    fn take_moment(&mut self, step: Begun, moment: Moment) {
        let index = self.plan.moments.len();
        self.plan.moments.push(moment);
        self.finish(step, ForceStep::Moments(index));
    }

    /// A part of what a joint does to a body.
    pub fn part(joint: JointId, on: BodyId, part: ForcePart) -> ForceOf {
        ForceOf::Joint { joint, on, part }
    }
}
