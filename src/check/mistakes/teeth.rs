//! Mistakes with wheels that mesh: other equations in place of those of their teeth, and accelerations taken as equal where they touch.

use super::by_centers;
use super::site::{Candidate, Laid, Site, instead, times};
use super::told::tell;
use super::wheels::{ALIKE, Mesh, Row, Train, Wheels, found};
use crate::construction::{Change, NumberId, OperationKind, Product, ProductKind, image_name};
use crate::mechanism::{AngularRate, BodyId, GROUND};
use crate::sheet::Order;

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
        let near = rows(&mesh).into_iter().flatten();
        for mut candidate in near.flat_map(|row| wheels.instead(&told(&mesh), &[(mesh.joint, row)])) {
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
