//! Mistakes with the radii of wheels and with the forces between their teeth.

use super::forces::{Drawn, all_of, first_blank, found};
use super::moments::{finds, sums};
use super::site::{Candidate, Site, times};
use super::told::{Blank, tell};
use crate::construction::{End, ForceOf, ForcePart, NumberId, NumberKind, OperationKind, OperationRole, PlaceId, Rate};
use crate::mechanism::{BodyId, JointId, PointId, Rolling};
use crate::sheet::Order;

/// The diameter in place of the radius: in the velocity of a rack, of a pitch point, in an angular velocity, or in moments.
pub(super) fn diameter(site: &Site<'_>) -> Vec<Candidate> {
    let mut all = of_racks(site);
    all.extend(of_vectors(site));
    all.extend(of_rates(site));
    all.extend(found(site, of_moments));
    all
}

fn name(site: &Site<'_>, body: BodyId) -> Blank {
    site.key.solution.mechanism.body(body).name.as_str().into()
}

/// The speed of a rack by the diameter of its wheel, or the angular velocity of a wheel that a rack turns.
fn of_racks(site: &Site<'_>) -> Vec<Candidate> {
    let mechanism = &site.key.solution.mechanism;
    let candidate = |id: JointId| {
        let Rolling::Rack(rack) = mechanism.joint(id).rolling()? else { return None };
        let wheel = mechanism.joint(id).bodies[rack.wheel];
        let group = mechanism.groups.iter().find(|group| group.joints.contains(&id))?;
        let slides = mechanism.joint(mechanism.slider_joint(rack.slider)).bodies;
        let is_found = [group.bodies.contains(&wheel), slides.iter().any(|body| group.bodies.contains(body))];
        let rate = |order: Order| match is_found {
            [true, false] => Some((Rate::Angular(order, wheel), 0.5)),
            [false, true] => Some((Rate::Slide(order, rack.slider), 2.0)),
            _ => None,
        };
        let edits: Vec<_> = Order::ALL
            .into_iter()
            .filter_map(|order| {
                let (rate, factor) = rate(order)?;
                let number = site.model.construction.rate(rate)??;
                Some((number, times(site.model.makers[number.0]?, number, factor)))
            })
            .collect();
        let (first, edit) = edits.first()?;
        let step = uses(site, *first).next().map_or(site.model.steps[edit.operation], |index| site.model.steps[index]);
        let told = tell::diameter_for_radius(site.quantity(*first), name(site, wheel));
        Some(Candidate { edits: edits.into_iter().map(|(_, edit)| edit).collect(), ..Candidate::at(told, step) })
    };
    (0..mechanism.joints.len()).map(JointId).filter_map(candidate).collect()
}

/// The operations that use a number.
fn uses<'s>(site: &'s Site<'_>, number: NumberId) -> impl Iterator<Item = usize> + 's {
    let reads = move |kind: &OperationKind| {
        let mut found = false;
        kind.each_number_read(|other| found |= other == number);
        found
    };
    site.operations().filter(move |(_, operation)| reads(&operation.kind)).map(|(index, _)| index)
}

/// The wheel of which a length is the pitch radius.
fn wheel_of(site: &Site<'_>, number: NumberId) -> Option<BodyId> {
    let &NumberKind::Length([End::Joint(center), End::Pitch(joint)]) = site.number_kind(number) else { return None };
    wheel_about(site, joint, center)
}

/// The wheel of a mesh that turns about a point.
fn wheel_about(site: &Site<'_>, joint: JointId, center: PointId) -> Option<BodyId> {
    let joint = site.key.solution.mechanism.joint(joint);
    match joint.rolling()? {
        Rolling::Wheels(pitch) => {
            let side = pitch.centers.iter().position(|own| *own == center)?;
            Some(joint.bodies[side])
        }
        Rolling::Rack(rack) => (rack.center == center).then_some(joint.bodies[rack.wheel]),
    }
}

/// The velocity of a pitch point laid off by the diameter.
fn of_vectors(site: &Site<'_>) -> Vec<Candidate> {
    let wrong = site.all_terms().filter_map(|term| {
        let wheel = wheel_of(site, *term.product().of.last()?)?;
        let [_, end] = term.vector.ends;
        let told = tell::diameter_for_radius(end.into(), name(site, wheel));
        Some(term.candidate(site, told, Some(term.product().times(2.0))))
    });
    wrong.collect()
}

/// An angular velocity found by division by the diameter.
fn of_rates(site: &Site<'_>) -> Vec<Candidate> {
    let wrong = site.operations().filter_map(|(index, operation)| {
        let OperationKind::Solve { unknowns, equations } = &operation.kind else { return None };
        let (&[rate], [equation]) = (unknowns.as_slice(), equations.as_slice()) else { return None };
        let wheel = wheel_of(site, *equation.left.first()?.1.of.last()?)?;
        let told = tell::diameter_for_radius(site.symbol(rate), name(site, wheel));
        Some(site.candidate(told, times(index, rate, 0.5)))
    });
    wrong.collect()
}

/// Arms of forces between teeth as long as the diameter: in one sum of moments, or in all of a wheel.
fn of_moments(drawn: &Drawn<'_>) -> Vec<Candidate> {
    let site = drawn.site;
    let role = |place: PlaceId| site.model.place_makers[place.0].map(|maker| site.operation(maker).role);
    let mut all: Vec<Candidate> = Vec::new();
    let mut of_wheels: Vec<(BodyId, Candidate)> = Vec::new();
    for sum in sums(site) {
        for arm in &sum.arms {
            let (Some(OperationRole::Pitch(joint)), Some(OperationRole::Joint(center))) =
                (role(arm.at), role(arm.about))
            else {
                continue;
            };
            let Some(wheel) = wheel_about(site, joint, center) else { continue };
            let told = tell::diameter_for_radius(finds(drawn, sum.finds), name(site, wheel));
            let edits = vec![times(arm.measured, arm.number, 2.0)];
            let one = Candidate { edits, ..Candidate::at(told, site.model.steps[sum.operation]) };
            of_wheels.push((wheel, one.clone()));
            all.push(one);
        }
    }
    // Of all wheels.
    if of_wheels.len() > 1 {
        let words = |blank: &Blank| blank.text().to_owned();
        let mut wheels: Vec<String> = Vec::new();
        let mut finds: Vec<String> = Vec::new();
        for (wheel, one) in &of_wheels {
            let (wheel, found) = (words(&name(site, *wheel)), one.told.blanks.first().map(|(_, blank)| words(blank)));
            wheels.extend(Some(wheel).filter(|wheel| !wheels.contains(wheel)));
            finds.extend(found.filter(|found| !finds.contains(found)));
        }
        let told = tell::diameter_for_radius(Blank::Words(finds.join(", ")), Blank::Words(wheels.join(", ")));
        let step = of_wheels.iter().map(|(_, one)| one.step).min();
        let edits = of_wheels.into_iter().flat_map(|(_, one)| one.edits).collect();
        all.extend(drawn.together(told, edits, step));
    }
    all
}

/// What pushes teeth apart left out of the polygons: of one mesh, or of all.
pub(super) fn radial(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let mechanism = &drawn.solution().mechanism;
        let sides = drawn.plan.polygons.iter().flat_map(|polygon| &polygon.sides);
        let apart = sides.filter(|side| match side.of {
            ForceOf::Joint { joint, part: ForcePart::Normal, .. } => mechanism.joint(joint).rolls(),
            _ => false,
        });
        let mut all: Vec<Candidate> = apart
            .filter_map(|side| {
                let index = site.model.place_makers[side.ends[1].0]?;
                let OperationKind::LayOff { size, .. } = site.operation(index).kind else { return None };
                let told = tell::radial_force_left_out(drawn.symbol(side.of));
                Some(Candidate {
                    step: site.model.steps[index],
                    ..site.candidate(told, times(site.model.makers[size.0]?, size, 0.0))
                })
            })
            .collect();
        all.extend(all_of(&all, first_blank, tell::radial_force_left_out));
        all
    })
}
