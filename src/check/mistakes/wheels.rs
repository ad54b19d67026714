//! Wheels that mesh, for the mistakes of `teeth`. All but one put another equation in place of a mesh's: z₁ ω₁ + z₂ ω₂ = (z₁ + z₂) ω_carrier with a wrong sign,
//! wrong teeth, or a rate left out. What the wheels of a group then turn with follows from the rates that are known.

use super::site::{Candidate, Site, instead, times};
use super::told::{Blank, Told};
use crate::construction::{Disturbance, Equation, NumberId, OperationKind, Product, ProductKind, image_name};
use crate::geometry::quarter_turn;
use crate::mechanism::{AngularRate, BodyId, GROUND, Group, JointId, LoopEquations};
use crate::sheet::Order;
use nalgebra::DMatrix;

/// Rates that differ by less than this part are one.
pub(super) const ALIKE: f64 = 1e-9;

/// An equation of rates: Σ weight · rate = 0.
pub(super) type Row = Vec<(BodyId, f64)>;

/// A mesh, its numbers of teeth signed.
#[derive(Clone, Copy)]
pub(super) struct Mesh {
    pub(super) joint: JointId,
    pub(super) wheels: [BodyId; 2],
    pub(super) carrier: BodyId,
    pub(super) teeth: [f64; 2],
}

impl Mesh {
    /// Its equation with these numbers of teeth.
    pub(super) fn row(&self, [first, second]: [f64; 2]) -> Row {
        vec![(self.wheels[0], first), (self.wheels[1], second), (self.carrier, -(first + second))]
    }

    pub(super) fn is_internal(&self) -> bool {
        self.teeth.iter().any(|teeth| *teeth < 0.0)
    }

    /// The index of a wheel.
    pub(super) fn side(&self, wheel: BodyId) -> Option<usize> {
        self.wheels.iter().position(|own| *own == wheel)
    }
}

/// A group of wheels and arms, with its meshes in the order of their equations.
pub(super) struct Train<'s> {
    pub(super) site: &'s Site<'s>,
    pub(super) equations: LoopEquations,
    pub(super) meshes: Vec<Mesh>,
}

/// The wheels of the mechanism in their groups.
pub(super) struct Wheels<'s> {
    pub(super) site: &'s Site<'s>,
    pub(super) meshes: Vec<Mesh>,
    pub(super) trains: Vec<Train<'s>>,
}

impl<'s> Wheels<'s> {
    pub(super) fn of(site: &'s Site<'_>) -> Wheels<'s> {
        let mechanism = &site.key.solution.mechanism;
        let mesh = |id: JointId| {
            let joint = mechanism.joint(id);
            let carrier = joint.related_bodies().nth(2)?;
            Some(Mesh { joint: id, wheels: joint.bodies, carrier, teeth: joint.pitch?.all_teeth.map(f64::from) })
        };
        let meshes: Vec<Mesh> = (0..mechanism.joints.len()).filter_map(|index| mesh(JointId(index))).collect();
        let train = |group: &Group| {
            let own: Vec<Mesh> = group.joints.iter().filter_map(|&joint| mesh(joint)).collect();
            let equations = LoopEquations::new(mechanism, group);
            let is_train = group.loops.is_empty() && !own.is_empty() && own.len() == equations.unknowns;
            is_train.then_some(Train { site, equations, meshes: own })
        };
        Wheels { site, trains: mechanism.groups.iter().filter_map(train).collect(), meshes }
    }

    /// The candidates that put these rows in place of the equations of meshes.
    pub(super) fn instead(&self, told: &Told, wrong: &[(JointId, Row)]) -> Vec<Candidate> {
        let mut all: [Vec<Disturbance>; 3] = Default::default();
        for train in &self.trains {
            let rows: Vec<Row> = train
                .meshes
                .iter()
                .map(|mesh| {
                    let wrong = wrong.iter().find(|(joint, _)| *joint == mesh.joint);
                    wrong.map_or_else(|| mesh.row(mesh.teeth), |(_, row)| row.clone())
                })
                .collect();
            if train.meshes.iter().any(|mesh| wrong.iter().any(|(joint, _)| *joint == mesh.joint))
                && let Some(rates) = train.rates(&rows)
            {
                train.edits(&rates, &mut all);
            }
        }
        found(self.site, told, all)
    }

    pub(super) fn name(&self, body: BodyId) -> Blank {
        let solution = self.site.key.solution;
        match body {
            GROUND => solution.wording().ground().into(),
            link => solution.mechanism.body(link).name.as_str().into(),
        }
    }

    /// The names of the wheels of a mesh.
    pub(super) fn names(&self, mesh: &Mesh) -> [Blank; 2] {
        mesh.wheels.map(|wheel| self.name(wheel))
    }

    /// For each mesh, what `rows` puts in place of its equation.
    pub(super) fn each<const N: usize>(
        &self,
        told: impl Fn(&Mesh) -> Told,
        rows: impl Fn(&Mesh) -> [Option<Row>; N],
    ) -> Vec<Candidate> {
        let each = self.meshes.iter().flat_map(|mesh| {
            let rows = rows(mesh).into_iter().flatten();
            rows.flat_map(|row| self.instead(&told(mesh), &[(mesh.joint, row)])).collect::<Vec<_>>()
        });
        each.collect()
    }
}

/// The candidates with these edits: numbers found anew from the teeth, numbers multiplied as they are measured, and the centres of wheels laid off
/// from their carriers, where the plan has them from pitch points.
pub(super) fn found(
    site: &Site<'_>,
    told: &Told,
    [computed, measured, centers]: [Vec<Disturbance>; 3],
) -> Vec<Candidate> {
    let by_arm: Vec<Disturbance> = centers.iter().chain(&computed).cloned().collect();
    let ways = [computed, measured, if centers.is_empty() { Vec::new() } else { by_arm }];
    let ways = ways.into_iter().filter_map(|mut edits| {
        edits.sort_by_key(|edit| edit.operation);
        let step = site.model.steps[edits.first()?.operation];
        Some(Candidate { edits, ..Candidate::at(told.clone(), step) })
    });
    ways.collect()
}

impl Train<'_> {
    /// The rates of the unknowns as sums of known ones, each with its factor; `None` where these equations have no solution.
    pub(super) fn rates(&self, rows: &[Row]) -> Option<Vec<Row>> {
        let count = self.equations.unknowns;
        let mut known: Vec<BodyId> = Vec::new();
        for (body, _) in rows.iter().flatten() {
            if let AngularRate::Known(body) = self.equations.angular_rate_of(*body)
                && !known.contains(&body)
            {
                known.push(body);
            }
        }
        let (mut matrix, mut right) = (DMatrix::zeros(count, count), DMatrix::zeros(count, known.len()));
        for (index, row) in rows.iter().enumerate() {
            for &(body, weight) in row {
                match self.equations.angular_rate_of(body) {
                    AngularRate::Unknown(unknown) => matrix[(index, unknown)] += weight,
                    AngularRate::Known(body) => {
                        let column = known.iter().position(|own| *own == body)?;
                        right[(index, column)] -= weight;
                    }
                }
            }
        }
        let solved = matrix.lu().solve(&right)?;
        let is_finite = solved.iter().all(|factor: &f64| factor.is_finite() && factor.abs() < 1e6);
        let sum = |unknown: usize| known.iter().enumerate().map(|(k, body)| (*body, solved[(unknown, k)])).collect();
        is_finite.then(|| (0..count).map(sum).collect())
    }

    pub(super) fn number(&self, order: Order, body: BodyId) -> Option<NumberId> {
        self.site.model.construction.angular_rates[body.0]?[order]
    }

    /// The sum of known rates as products.
    pub(super) fn sum(&self, order: Order, row: &Row, of: &[NumberId]) -> Vec<Product> {
        let product = |&(body, factor): &(BodyId, f64)| {
            let number = self.number(order, body)?;
            let numbers: Vec<NumberId> = std::iter::once(number).chain(of.iter().copied()).collect();
            (factor != 0.0).then(|| Product::new(ProductKind::Plain, factor, &numbers))
        };
        row.iter().filter_map(product).collect()
    }

    pub(super) fn value(&self, sum: &[Product]) -> f64 {
        sum.iter().map(|p| p.factor * p.of.iter().map(|number| self.site.exact(*number)).product::<f64>()).sum()
    }

    /// The edits that give the unknowns these rates: computed, and as factors of what is measured; and those that lay off centres from carriers.
    pub(super) fn edits(&self, rates: &[Row], [computed, measured, centers]: &mut [Vec<Disturbance>; 3]) {
        for order in Order::ALL {
            let mut makers: Vec<usize> = Vec::new();
            for (unknown, row) in rates.iter().enumerate() {
                let Some(link) = self.equations.link_of(unknown) else { continue };
                let Some(number) = self.number(order, link) else { continue };
                let Some(maker) = self.site.model.makers[number.0] else { continue };
                let (right, wrong) = (self.site.exact(number), self.value(&self.sum(order, row, &[])));
                if (right - wrong).abs() <= ALIKE * right.abs().max(wrong.abs()) {
                    continue;
                }
                if right != 0.0 {
                    measured.push(times(maker, number, wrong / right));
                }
                if !makers.contains(&maker) {
                    makers.push(maker);
                    computed.extend(self.solved(order, maker, rates));
                }
                if order == Order::Velocity {
                    centers.extend(self.center_by_arm(link, row));
                }
            }
        }
    }

    /// The operation that finds rates, with these in place of what it finds.
    pub(super) fn solved(&self, order: Order, maker: usize, rates: &[Row]) -> Option<Disturbance> {
        let OperationKind::Solve { unknowns, .. } = &self.site.operation(maker).kind else { return None };
        let equation = |(index, number): (usize, &NumberId)| {
            let is_it = |unknown: &usize| {
                self.equations.link_of(*unknown).and_then(|link| self.number(order, link)) == Some(*number)
            };
            let unknown = (0..rates.len()).find(is_it)?;
            let left = vec![(index, Product::new(ProductKind::Plain, 1.0, &[]))];
            Some(Equation { left, right: self.sum(order, &rates[unknown], &[]) })
        };
        let equations = unknowns.iter().enumerate().map(equation).collect::<Option<Vec<_>>>()?;
        Some(instead(maker, OperationKind::Solve { unknowns: unknowns.clone(), equations }))
    }

    /// The centres of wheels that a plan has from their pitch points laid off from the pole by the rate of their arm, as by somebody who finds
    /// rates from teeth alone.
    pub(super) fn center_by_arm(&self, arm: BodyId, row: &Row) -> Vec<Disturbance> {
        let site = self.site;
        let mechanism = &site.key.solution.mechanism;
        let construction = &site.model.construction;
        let Some(pole) = construction.place(Order::Velocity, Order::Velocity.pole()) else { return Vec::new() };
        let mut found = Vec::new();
        for mesh in self.meshes.iter().filter(|mesh| mesh.carrier == arm) {
            let Some(pitch) = mechanism.joint(mesh.joint).pitch else { continue };
            let Some(length) = construction.length_of(pitch.centers) else { continue };
            let is_fixed = |center: usize| mechanism.body(GROUND).has(pitch.centers[center]);
            let center = match [is_fixed(0), is_fixed(1)] {
                [true, false] => 1,
                [false, true] => 0,
                _ => continue,
            };
            let image = image_name(mechanism.point_name(pitch.centers[center]));
            for vector in site.vectors().into_iter().filter(|vector| vector.ends[1] == image) {
                let is_by_arm = vector.sum.iter().any(|product| product.of.contains(&length));
                let is_from_pitch = construction.is_pitch_image(vector.ends[0]) || vector.from == pole;
                if is_by_arm
                    || !is_from_pitch
                    || found.iter().any(|edit: &Disturbance| edit.operation == vector.operation)
                {
                    continue;
                }
                let sense = site.key.solution.pose.arm(pitch.centers[1 - center], pitch.centers[center]);
                let along = site.model.exact.along(&vector.along);
                let sign = quarter_turn(sense).dot(&along).signum();
                let sum = self.sum(Order::Velocity, row, &[length]);
                let sum = sum.iter().map(|product| product.times(sign)).collect();
                found.push(instead(vector.maker, OperationKind::Compute { number: vector.size, sum }));
                let kind =
                    OperationKind::LayOff { place: vector.place, from: pole, size: vector.size, along: vector.along };
                found.push(instead(vector.operation, kind));
            }
        }
        found
    }
}
