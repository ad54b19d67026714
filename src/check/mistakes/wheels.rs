//! Mistakes with wheels that mesh. All but one put another equation in place of a mesh's: z₁ ω₁ + z₂ ω₂ = (z₁ + z₂) ω_carrier with a wrong sign,
//! wrong teeth, or a rate left out. What the wheels of a group then turn with follows from the rates that are known.

use super::by_centers;
use super::site::{Candidate, Laid, Site, instead, times};
use super::told::{Blank, Told, tell};
use crate::construction::{Change, Disturbance, Equation, NumberId, OperationKind, Product, ProductKind, image_name};
use crate::geometry::quarter_turn;
use crate::mechanism::{AngularRate, BodyId, GROUND, Group, JointId, LoopEquations};
use crate::sheet::Order;
use nalgebra::DMatrix;

/// Rates that differ by less than this part are one.
const ALIKE: f64 = 1e-9;

/// An equation of rates: Σ weight · rate = 0.
type Row = Vec<(BodyId, f64)>;

/// A mesh, its numbers of teeth signed.
#[derive(Clone, Copy)]
struct Mesh {
    joint: JointId,
    wheels: [BodyId; 2],
    carrier: BodyId,
    teeth: [f64; 2],
}

impl Mesh {
    /// Its equation with these numbers of teeth.
    fn row(&self, [first, second]: [f64; 2]) -> Row {
        vec![(self.wheels[0], first), (self.wheels[1], second), (self.carrier, -(first + second))]
    }

    fn is_internal(&self) -> bool {
        self.teeth.iter().any(|teeth| *teeth < 0.0)
    }

    /// The index of a wheel.
    fn side(&self, wheel: BodyId) -> Option<usize> {
        self.wheels.iter().position(|own| *own == wheel)
    }
}

/// A group of wheels and arms, with its meshes in the order of their equations.
struct Train<'s> {
    site: &'s Site<'s>,
    equations: LoopEquations,
    meshes: Vec<Mesh>,
}

/// The wheels of the mechanism in their groups.
struct Wheels<'s> {
    site: &'s Site<'s>,
    meshes: Vec<Mesh>,
    trains: Vec<Train<'s>>,
}

impl<'s> Wheels<'s> {
    fn of(site: &'s Site<'_>) -> Wheels<'s> {
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
    fn instead(&self, told: &Told, wrong: &[(JointId, Row)]) -> Vec<Candidate> {
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

    fn name(&self, body: BodyId) -> Blank {
        let solution = self.site.key.solution;
        match body {
            GROUND => solution.wording().ground().into(),
            link => solution.mechanism.body(link).name.as_str().into(),
        }
    }

    /// The names of the wheels of a mesh.
    fn names(&self, mesh: &Mesh) -> [Blank; 2] {
        mesh.wheels.map(|wheel| self.name(wheel))
    }

    /// For each mesh, what `rows` puts in place of its equation.
    fn each<const N: usize>(
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
fn found(site: &Site<'_>, told: &Told, [computed, measured, centers]: [Vec<Disturbance>; 3]) -> Vec<Candidate> {
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
    fn rates(&self, rows: &[Row]) -> Option<Vec<Row>> {
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

    fn number(&self, order: Order, body: BodyId) -> Option<NumberId> {
        self.site.model.construction.angular_rates[body.0]?[order]
    }

    /// The sum of known rates as products.
    fn sum(&self, order: Order, row: &Row, of: &[NumberId]) -> Vec<Product> {
        let product = |&(body, factor): &(BodyId, f64)| {
            let number = self.number(order, body)?;
            let numbers: Vec<NumberId> = std::iter::once(number).chain(of.iter().copied()).collect();
            (factor != 0.0).then(|| Product::new(ProductKind::Plain, factor, &numbers))
        };
        row.iter().filter_map(product).collect()
    }

    fn value(&self, sum: &[Product]) -> f64 {
        sum.iter().map(|p| p.factor * p.of.iter().map(|number| self.site.exact(*number)).product::<f64>()).sum()
    }

    /// The edits that give the unknowns these rates: computed, and as factors of what is measured; and those that lay off centres from carriers.
    fn edits(&self, rates: &[Row], [computed, measured, centers]: &mut [Vec<Disturbance>; 3]) {
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
    fn solved(&self, order: Order, maker: usize, rates: &[Row]) -> Option<Disturbance> {
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
    fn center_by_arm(&self, arm: BodyId, row: &Row) -> Vec<Disturbance> {
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

/// Wheels that touch outside taken to turn alike, or a ring and the wheel in it to turn opposite ways.
pub(super) fn sense(site: &Site<'_>) -> Vec<Candidate> {
    let wheels = Wheels::of(site);
    let told = |mesh: &Mesh| {
        let [first, second] = wheels.names(mesh);
        match mesh.is_internal() {
            true => tell::mesh_sense_internal(first, second),
            false => tell::mesh_sense(first, second),
        }
    };
    wheels.each(told, |mesh| [Some(mesh.row([mesh.teeth[0], -mesh.teeth[1]]))])
}

/// Numbers of teeth in each other's place; likewise distances of instant centres.
pub(super) fn inverted(site: &Site<'_>) -> Vec<Candidate> {
    let wheels = Wheels::of(site);
    let told = |mesh: &Mesh| {
        let [first, second] = wheels.names(mesh);
        tell::teeth_inverted(first, second)
    };
    let mut all = by_centers::ratio_inverted(site);
    all.extend(wheels.each(told, |mesh| [Some(mesh.row([mesh.teeth[1], mesh.teeth[0]]))]));
    all
}

/// The carrier taken to be at rest.
pub(super) fn arm_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    let wheels = Wheels::of(site);
    let told = |mesh: &Mesh| {
        let [first, second] = wheels.names(mesh);
        tell::arm_forgotten(first, second, wheels.name(mesh.carrier))
    };
    let rows = |mesh: &Mesh| {
        let row = mesh.row(mesh.teeth).into_iter().take(2).collect();
        [(mesh.carrier != GROUND).then_some(row)]
    };
    wheels.each(told, rows)
}

/// A rate relative to the carrier in place of that to the frame.
pub(super) fn relative(site: &Site<'_>) -> Vec<Candidate> {
    let wheels = Wheels::of(site);
    let mut all = Vec::new();
    for train in &wheels.trains {
        let rows: Vec<Row> = train.meshes.iter().map(|mesh| mesh.row(mesh.teeth)).collect();
        let Some(rates) = train.rates(&rows) else { continue };
        for mesh in train.meshes.iter().filter(|mesh| mesh.carrier != GROUND) {
            for wheel in mesh.wheels {
                let Some(unknown) = train.equations.angular_unknown(wheel) else { continue };
                let Some(number) = train.number(Order::Velocity, wheel) else { continue };
                let carrier: Row = match train.equations.angular_rate_of(mesh.carrier) {
                    AngularRate::Unknown(arm) => rates[arm].clone(),
                    AngularRate::Known(arm) => vec![(arm, 1.0)],
                };
                let mut wrong = rates.clone();
                wrong[unknown].extend(carrier.into_iter().map(|(body, factor)| (body, -factor)));
                let mut edits = Default::default();
                train.edits(&wrong, &mut edits);
                let told = tell::relative_for_absolute(site.symbol(number), wheels.name(mesh.carrier));
                all.extend(found(site, &told, edits));
            }
        }
    }
    all
}

/// The teeth of a wheel between two others in the ratio of these.
pub(super) fn idler_counted(site: &Site<'_>) -> Vec<Candidate> {
    let wheels = Wheels::of(site);
    let mut all = Vec::new();
    for last in &wheels.meshes {
        for end in 0..2 {
            let (wheel, idler) = (last.wheels[end], last.wheels[1 - end]);
            let before = wheels.meshes.iter().filter(|mesh| mesh.joint != last.joint && mesh.carrier == last.carrier);
            for before in before {
                let Some(side) = before.side(idler) else { continue };
                let first = before.wheels[1 - side];
                // From a wheel that rests it looks as if the carrier were forgotten.
                let is_idler =
                    before.teeth[side] == last.teeth[1 - end] && first != wheel && ![first, wheel].contains(&GROUND);
                if !is_idler {
                    continue;
                }
                let ratios = [before.teeth[1 - side] / before.teeth[side], last.teeth[1 - end] / last.teeth[end]];
                let told = tell::idler_counted(wheels.name(idler), wheels.name(first), wheels.name(wheel));
                for ratio in ratios.into_iter().flat_map(|ratio| [ratio, -ratio]) {
                    let row = vec![(wheel, 1.0), (first, -ratio), (last.carrier, ratio - 1.0)];
                    all.extend(wheels.instead(&told, &[(last.joint, row)]));
                }
            }
        }
    }
    all
}

/// The other rim of a wheel with two: in one mesh, or in both.
pub(super) fn rim_swapped(site: &Site<'_>) -> Vec<Candidate> {
    let wheels = Wheels::of(site);
    let mut all = Vec::new();
    for mesh in &wheels.meshes {
        for side in 0..2 {
            let wheel = mesh.wheels[side];
            for other in wheels.meshes.iter().filter(|other| other.joint != mesh.joint) {
                let Some(own) = other.side(wheel).filter(|own| other.teeth[*own].abs() != mesh.teeth[side].abs())
                else {
                    continue;
                };
                let taken = |mesh: &Mesh, side: usize, teeth: f64| {
                    let mut wrong = mesh.teeth;
                    wrong[side] = teeth.abs().copysign(wrong[side]);
                    (mesh.joint, mesh.row(wrong))
                };
                let one = taken(mesh, side, other.teeth[own]);
                let both = [one.clone(), taken(other, own, mesh.teeth[side])];
                let told = tell::rim_swapped(wheels.name(wheel), wheels.name(mesh.wheels[1 - side]));
                all.extend(wheels.instead(&told, &[one]));
                if mesh.joint < other.joint {
                    all.extend(wheels.instead(&tell::rims_swapped(wheels.name(wheel)), &both));
                }
            }
        }
    }
    all
}

/// The pitch point of a ring taken on the near side of the wheel in it.
pub(super) fn wrong_side(site: &Site<'_>) -> Vec<Candidate> {
    let wheels = Wheels::of(site);
    let inner = |mesh: &Mesh| mesh.teeth.iter().position(|teeth| *teeth > 0.0).unwrap_or(0);
    let told = |mesh: &Mesh| {
        let side = inner(mesh);
        tell::pitch_on_wrong_side(wheels.name(mesh.wheels[side]), wheels.name(mesh.wheels[1 - side]))
    };
    let rows = |mesh: &Mesh| {
        let side = inner(mesh);
        let (wheel, ring) = (mesh.teeth[side], mesh.teeth[1 - side].abs());
        let row = |of_ring: f64| {
            vec![(mesh.wheels[1 - side], of_ring), (mesh.wheels[side], wheel), (mesh.carrier, wheel - ring)]
        };
        // The velocity of the ring there, or that of its rim.
        [ring - 2.0 * wheel, ring].map(|of_ring| mesh.is_internal().then(|| row(of_ring)))
    };
    let mut all = wheels.each(told, rows);
    // The velocity of the ring there, laid off in the plan.
    for (mesh, vector) in to_pitch_points(&wheels, false) {
        let near = rows(&mesh)[0].clone();
        for mut candidate in near.into_iter().flat_map(|row| wheels.instead(&told(&mesh), &[(mesh.joint, row)])) {
            let side = inner(&mesh);
            let factor = 1.0 - 2.0 * mesh.teeth[side] / mesh.teeth[1 - side].abs();
            candidate.edits.push(times(vector.maker, vector.size, factor));
            candidate.edits.sort_by_key(|edit| edit.operation);
            candidate.step = site.model.steps[vector.operation];
            all.push(candidate);
        }
    }
    for (mesh, vector) in to_rings(&wheels) {
        let reversed = site.candidate(told(&mesh), vector.turned(vector.along.turned(2)));
        let side = inner(&mesh);
        let ring = mesh.wheels[1 - side];
        let factor = mesh.teeth[1 - side].abs() / (mesh.teeth[1 - side].abs() - 2.0 * mesh.teeth[side]);
        let rate = site.model.construction.angular_rates[ring.0].and_then(|rates| rates[Order::Velocity]);
        let maker = rate.and_then(|rate| Some((site.model.makers[rate.0]?, rate)));
        if let Some((maker, rate)) = maker.filter(|_| factor.is_finite()) {
            // The ring's angular velocity by the distance of the near side.
            let mut near = reversed.clone();
            near.edits.push(times(maker, rate, factor));
            all.push(near);
        }
        all.push(reversed);
    }
    all
}

/// The velocities of pitch points of rings that are laid off as those of the wheels in them: on the near side they have the opposite sense.
fn to_rings<'s>(wheels: &Wheels<'s>) -> Vec<(Mesh, Laid<'s>)> {
    to_pitch_points(wheels, true)
}

/// The vectors to the pitch points of rings, laid off as points of the wheel in the ring or of the ring.
fn to_pitch_points<'s>(wheels: &Wheels<'s>, of_inner: bool) -> Vec<(Mesh, Laid<'s>)> {
    let site = wheels.site;
    let construction = &site.model.construction;
    let mesh = |vector: &Laid<'_>| {
        let image = vector.ends[1];
        let mesh = wheels.meshes.iter().find(|mesh| image_name(construction.pitch_name(mesh.joint)) == image)?;
        let side = mesh.teeth.iter().position(|teeth| (*teeth > 0.0) == of_inner)?;
        let rate = construction.angular_rates[mesh.wheels[side].0]?[Order::Velocity]?;
        let is_of_it = vector.sum.iter().any(|product| product.of.contains(&rate));
        (mesh.is_internal() && is_of_it).then_some(*mesh)
    };
    site.vectors().into_iter().filter_map(|vector| Some((mesh(&vector)?, vector))).collect()
}

/// The operations that lay these off.
pub(super) fn laid_off_to_rings(site: &Site<'_>) -> Vec<usize> {
    to_rings(&Wheels::of(site)).iter().map(|(_, vector)| vector.operation).collect()
}

/// The accelerations of two wheels taken as equal where they touch: the centre of one follows from that.
pub(super) fn accelerations_equal(site: &Site<'_>) -> Vec<Candidate> {
    let wheels = Wheels::of(site);
    let mechanism = &site.key.solution.mechanism;
    let construction = &site.model.construction;
    let rate = |body: BodyId| construction.angular_rates[body.0].and_then(|rates| rates[Order::Velocity]);
    let mut all = Vec::new();
    for mesh in wheels.meshes.iter().filter(|mesh| mesh.carrier != GROUND) {
        let Some(pitch) = mechanism.joint(mesh.joint).pitch else { continue };
        let (Some(length), Some(arm)) = (construction.length_of(pitch.centers), rate(mesh.carrier)) else { continue };
        for term in site.terms(ProductKind::Normal) {
            if term.product().of.as_slice() != [arm, arm, length] {
                continue;
            }
            // The centre that is laid off is the one that the frame does not have.
            let Some(fixed) = (0..2).find(|side| mechanism.body(GROUND).has(pitch.centers[*side])) else { continue };
            let share = mesh.teeth[fixed] / (mesh.teeth[0] + mesh.teeth[1]);
            let part = |side: usize, share: f64| {
                let rate = rate(mesh.wheels[side])?;
                Some(Product::new(ProductKind::Normal, term.product().factor * share, &[rate, rate, length]))
            };
            let mut sum = term.vector.sum.to_vec();
            sum.remove(term.at);
            sum.extend([part(fixed, share), part(1 - fixed, 1.0 - share)].into_iter().flatten());
            let [first, second] = wheels.names(mesh);
            let kind = OperationKind::Compute { number: term.vector.size, sum };
            all.push(site.candidate(tell::accelerations_equal(first, second), instead(term.vector.maker, kind)));
        }
    }
    all
}

/// All rates that meshes alone tell.
pub(super) fn rates(site: &Site<'_>) -> Vec<NumberId> {
    let trains = Wheels::of(site).trains;
    let of = |train: &Train<'_>| {
        let links = (0..train.equations.unknowns).filter_map(|unknown| train.equations.link_of(unknown));
        let numbers = links.flat_map(|link| Order::ALL.map(|order| train.number(order, link)));
        numbers.flatten().collect::<Vec<_>>()
    };
    trains.iter().flat_map(of).collect()
}

/// The rates that a mistake in the sense of a mesh, or in the side of a pitch point, reverses: of these it is told.
pub(super) fn reversed(site: &Site<'_>) -> Vec<NumberId> {
    let mut found: Vec<NumberId> = Vec::new();
    for candidate in [sense(site), wrong_side(site)].iter().flatten() {
        for edit in &candidate.edits {
            if let Change::Times(number, factor) = edit.change
                && (factor + 1.0).abs() < ALIKE
            {
                found.push(number);
            }
        }
    }
    found
}
