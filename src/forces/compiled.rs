//! Equilibrium in many positions: what hangs on joints alone is found once, and each position then costs a few sums for each link and,
//! by group, as many equations as its velocities have.
//!
//! Each group is cut open in as many pins as it has loops, so that every link hangs on one other by one joint. Virtual power of all loads at rate
//! 1 of each unknown ω and ṡ, Q, is a sum over what hangs on a joint; with f, the forces in the cut pins, Aᵀ f = −Q, where A is the
//! matrix of the velocities of these loops (Shai and Pennock 2006). What the other joints carry follows link by link, the outermost first.

use super::acting::{Acting, LoadList, Wrench};
use super::carried::{Carried, Forces};
use super::equilibrium::driven;
use super::opened::{Along, By, Hung, Opened};
use super::{Counted, Posed, equilibrium};
use crate::geometry::{Pair, SEVERAL, Several};
use crate::mechanism::{AngularConstraint, BodyId, GROUND, Mechanism, PointId};
use smallvec::{SmallVec, smallvec};

/// Numbers without bounds, of one position or of several.
pub(crate) trait Quick: Counted {
    /// Whether none is infinite or NaN.
    fn is_finite(self) -> bool;

    /// The forces f of several cuts with Aᵀ f = −Q; `None` where A is singular.
    fn cut_forces(cuts: usize, matrix: &[Pair<Self>], right: &[Self]) -> Option<SmallVec<[Pair<Self>; 2]>>;
}

impl Quick for f64 {
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }

    fn cut_forces(cuts: usize, matrix: &[Pair<f64>], right: &[f64]) -> Option<SmallVec<[Pair<f64>; 2]>> {
        solved(cuts, matrix, right)
    }
}

impl Quick for Several {
    fn is_finite(self) -> bool {
        self.0.iter().all(|x| x.is_finite())
    }

    fn cut_forces(cuts: usize, matrix: &[Pair<Several>], right: &[Several]) -> Option<SmallVec<[Pair<Several>; 2]>> {
        let mut found: SmallVec<[Pair<Several>; 2]> = smallvec![Pair::default(); cuts];
        for lane in 0..SEVERAL {
            let own: SmallVec<[Pair<f64>; 8]> =
                matrix.iter().map(|pair| Pair { x: pair.x.0[lane], y: pair.y.0[lane] }).collect();
            let right: SmallVec<[f64; 4]> = right.iter().map(|number| number.0[lane]).collect();
            for (force, own) in found.iter_mut().zip(solved(cuts, &own, &right)?) {
                (force.x.0[lane], force.y.0[lane]) = (own.x, own.y);
            }
        }
        Some(found)
    }
}

/// A mechanism with its loads, compiled for the forces of many positions.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The mechanism.
    pub mechanism: Mechanism,
    loads: Option<LoadList>,
    plan: Option<Plan>,
}

/// The order in which links are cut free.
#[derive(Clone, Debug)]
struct Plan {
    /// By body: the point about which its moments are taken.
    about: Vec<Option<PointId>>,
    groups: Vec<Opened>,
    driven: Vec<Hung>,
}

impl Compiled {
    /// A mechanism compiled.
    #[must_use]
    pub fn new(mechanism: &Mechanism) -> Compiled {
        let loads = LoadList::new(mechanism);
        // What joints with friction carry needs more than sums.
        let has_friction = loads.as_ref().is_some_and(|loads| !loads.friction.is_empty());
        let plan = if has_friction { None } else { Plan::new(mechanism) };
        Compiled { mechanism: mechanism.clone(), loads, plan }
    }

    /// The forces in a position; their [`Forces::drives`] are empty. `None` without loads and in a singular position.
    pub(crate) fn forces<N: Quick>(&self, posed: &impl Posed<N>) -> Option<Forces<N>> {
        let loads = self.loads.as_ref()?;
        match &self.plan {
            Some(plan) => plan.carried(&self.mechanism, posed, loads.acting(posed)?),
            None => equilibrium::carried(&self.mechanism, posed, loads),
        }
    }
}

impl Plan {
    /// `None` for a mechanism with joints that are neither pins nor guides which keep an angle, or with a group that is singular by
    /// structure.
    fn new(mechanism: &Mechanism) -> Option<Plan> {
        let is_plain = |joint: &crate::mechanism::Joint| match &joint.angular {
            Some(angular) => AngularConstraint::as_fixed_angle(angular).is_some() && joint.slider.is_some(),
            None => joint.pin.is_some() && joint.slider.is_none(),
        };
        if !mechanism.joints.iter().all(is_plain) {
            return None;
        }
        let mut about: Vec<Option<PointId>> = mechanism.body_ids().map(|body| mechanism.first_point(body)).collect();
        let groups: Option<Vec<Opened>> =
            mechanism.groups.iter().rev().map(|group| Opened::new(mechanism, group)).collect();
        let groups = groups?;
        let driven: Option<Vec<Hung>> =
            driven(mechanism).into_iter().map(|body| Hung::driven(mechanism, body)).collect();
        let driven = driven?;
        for hung in groups.iter().flat_map(|group| &group.hung).chain(&driven) {
            about[hung.body.0] = Some(hung.at);
        }
        Some(Plan { about, groups, driven })
    }

    fn carried<N: Quick>(
        &self,
        mechanism: &Mechanism,
        posed: &impl Posed<N>,
        acting: Vec<Acting<N>>,
    ) -> Option<Forces<N>> {
        let places: SmallVec<[Pair<N>; 16]> =
            (0..mechanism.points.len()).map(|point| posed.place(PointId(point))).collect();
        let bodies = mechanism.bodies.len();
        let mut here = Here {
            plan: self,
            posed,
            places,
            loads: smallvec![Wrench::default(); bodies],
            joints: vec![Carried::default(); mechanism.joints.len()],
            torques: vec![N::default(); bodies],
        };
        for load in &acting {
            here.receive(load.body, load.at, load.force, load.couple);
        }
        for group in &self.groups {
            here.solve(group)?;
        }
        for hung in &self.driven {
            here.hand_on(hung);
        }
        let frame = here.frame(mechanism);
        Some(Forces { acting, joints: here.joints, torques: here.torques, frame, drives: Vec::new() })
    }
}

/// Equilibrium in a position.
struct Here<'a, P, N> {
    plan: &'a Plan,
    posed: &'a P,
    places: SmallVec<[Pair<N>; 16]>,
    /// By body: what it has received, with the moment about its own point.
    loads: SmallVec<[Wrench<N>; 12]>,
    joints: Vec<Carried<N>>,
    torques: Vec<N>,
}

impl<P: Posed<N>, N: Quick> Here<'_, P, N> {
    fn receive(&mut self, body: BodyId, at: Pair<N>, force: Pair<N>, couple: N) {
        let about = self.plan.about[body.0].map_or_else(Pair::default, |point| self.places[point.0]);
        self.loads[body.0].add(Wrench { force, moment: couple + (at - about).cross(force) });
    }

    /// What a joint passes on, and the couple among it: a pin none.
    fn passed(&self, hung: &Hung, wrench: Wrench<N>) -> N {
        if matches!(hung.by, By::Guide(..)) { wrench.moment } else { N::default() }
    }

    /// Finds what the joints of a group carry.
    fn solve(&mut self, group: &Opened) -> Option<()> {
        let rows = 2 * group.cuts.len();
        let mut right: SmallVec<[N; 4]> = smallvec![N::default(); rows];
        let mut wrenches: SmallVec<[Wrench<N>; 6]> = group.hung.iter().map(|hung| self.loads[hung.body.0]).collect();
        for (index, hung) in group.hung.iter().enumerate() {
            let wrench = wrenches[index];
            match hung.by {
                By::Pin(row) => right[row] = wrench.moment,
                By::Guide(slider, Some(row)) => right[row] = wrench.force.dot(self.posed.guide(slider)),
                By::Guide(_, None) | By::Drive => {}
            }
            if let Some(within) = hung.within {
                let arm = self.places[hung.at.0] - self.places[group.hung[within].at.0];
                let moment = self.passed(hung, wrench) + arm.cross(wrench.force);
                wrenches[within].add(Wrench { force: wrench.force, moment });
            }
        }
        let forces = self.cut_forces(group, &right)?;
        for (cut, &force) in group.cuts.iter().zip(&forces) {
            self.joints[cut.joint.0].force = force;
            let [first, second] = cut.bodies;
            let at = self.places[cut.at.0];
            self.receive(first, at, -force, N::default());
            self.receive(second, at, force, N::default());
        }
        group.hung.iter().for_each(|hung| self.hand_on(hung));
        Some(())
    }

    /// The forces in the cuts; `right` is the virtual power of all that is known.
    fn cut_forces(&self, group: &Opened, right: &[N]) -> Option<SmallVec<[Pair<N>; 2]>> {
        let cuts = group.cuts.len();
        let mut matrix: SmallVec<[Pair<N>; 8]> = smallvec![Pair::default(); 2 * cuts * cuts];
        for term in &group.terms {
            let vector = match term.vector {
                Along::Arm(from, to) => (self.places[to.0] - self.places[from.0]).quarter_turn(),
                Along::Guide(slider) => self.posed.guide(slider),
            };
            let own = &mut matrix[term.row * cuts + term.cut];
            *own = own.plus_scaled(vector, N::from(if term.sign < 0.0 { -1 } else { 1 }));
        }
        let forces = match *matrix {
            [first, second] => {
                let whole = N::from(1) / first.cross(second);
                smallvec![(second * right[0] - first * right[1]).quarter_turn() * whole]
            }
            _ => N::cut_forces(cuts, &matrix, right)?,
        };
        forces.iter().all(|force| force.x.is_finite() && force.y.is_finite()).then_some(forces)
    }

    /// Notes what a body's joint carries when all else on the body is known, and hands it on.
    fn hand_on(&mut self, hung: &Hung) {
        let wrench = self.loads[hung.body.0];
        let mut couple = self.passed(hung, wrench);
        let (force, own) = if hung.is_second { (-wrench.force, -couple) } else { (wrench.force, couple) };
        self.joints[hung.joint.0] = Carried { force, couple: own, ..Carried::default() };
        if matches!(hung.by, By::Drive) {
            self.torques[hung.body.0] = -wrench.moment;
            // The frame receives the torque's reaction.
            let frame = &mut self.loads[GROUND.0];
            frame.moment = frame.moment + wrench.moment;
            couple = N::default();
        }
        self.receive(hung.on, self.places[hung.at.0], wrench.force, couple);
    }

    /// What the frame has received, about its first point.
    fn frame(&self, mechanism: &Mechanism) -> Wrench<N> {
        debug_assert_eq!(self.plan.about[GROUND.0], mechanism.first_point(GROUND));
        self.loads[GROUND.0]
    }
}

/// The forces f with Aᵀ f = −Q, by elimination with the largest pivot, each row in parts of its largest coefficient; `None` where one is zero.
fn solved(cuts: usize, matrix: &[Pair<f64>], right: &[f64]) -> Option<SmallVec<[Pair<f64>; 2]>> {
    let size = 2 * cuts;
    let mut rows: SmallVec<[SmallVec<[f64; 5]>; 4]> = SmallVec::new();
    for (row, &right) in matrix.chunks(cuts).zip(right) {
        let largest = row.iter().fold(0.0_f64, |most, v| most.max(v.x.abs()).max(v.y.abs()));
        let numbers = row.iter().flat_map(|v| [v.x, v.y]).chain([-right]);
        rows.push(numbers.map(|x| x / largest).collect());
    }
    for step in 0..size {
        let pivot = (step..size).max_by(|&a, &b| rows[a][step].abs().total_cmp(&rows[b][step].abs()))?;
        rows.swap(step, pivot);
        let (done, rest) = rows.split_at_mut(step + 1);
        let own = &done[step];
        if own[step] == 0.0 {
            return None;
        }
        for row in rest {
            let factor = row[step] / own[step];
            if factor != 0.0 {
                for (x, y) in row[step..].iter_mut().zip(&own[step..]) {
                    *x -= factor * y;
                }
            }
        }
    }
    let mut found: SmallVec<[f64; 4]> = smallvec![0.0; size];
    for step in (0..size).rev() {
        let row = &rows[step];
        let sum = (step + 1..size).fold(row[size], |left, other| left - row[other] * found[other]);
        found[step] = sum / row[step];
    }
    Some(found.chunks(2).map(|force| Pair { x: force[0], y: force[1] }).collect())
}
