//! Mistakes with arms and moments, on the scheme and on levers.

use super::forces::{Drawn, found};
use super::site::{Candidate, Site, instead, times};
use super::told::{Blank, tell};
use crate::construction::{
    Disturbance, LineId, MeasuredAs, MomentPoint, NumberId, NumberKind, OperationKind, OperationRole, PlaceId,
    Reference,
};
use crate::geometry::{Vector, cross, quarter_turn};
use crate::sheet::Sheet;

/// Two places nearer than this are one to a hand, in mm.
const ONE: f64 = 3.0;

/// Shortest arm of an unknown by which somebody divides, in mm.
const SHORTEST: f64 = 4.0;

/// An arm that is measured: from the point about which moments are taken to the foot of the normal on a line of action.
#[derive(Clone, Copy)]
pub(super) struct Arm {
    /// The operation that measures it, and its number.
    pub measured: usize,
    pub number: NumberId,
    pub about: PlaceId,
    foot: PlaceId,
    /// The normal.
    normal: LineId,
    /// Where the force acts.
    pub at: PlaceId,
    sheet: Sheet,
}

fn arms(site: &Site<'_>) -> Vec<Arm> {
    let all = site.operations().filter_map(|(measured, operation)| {
        let OperationKind::Measure { number, from: about, to: foot, how: MeasuredAs::Along(normal) } = operation.kind
        else {
            return None;
        };
        if *site.number_kind(number) != NumberKind::Arm {
            return None;
        }
        let OperationKind::Cross { lines, .. } = site.operation(site.model.place_makers[foot.0]?).kind else {
            return None;
        };
        let line = lines.into_iter().find(|line| *line != normal)?;
        let at = match site.drawing_of(line)?.1.kind {
            OperationKind::Draw { through, .. } => through,
            OperationKind::Join { from, .. } => from,
            _ => return None,
        };
        Some(Arm { measured, number, about, foot, normal, at, sheet: operation.sheet })
    });
    all.collect()
}

/// A sum of moments: the operation that computes it, what it finds, and its arms, the last one of the unknown where that is a force.
pub(super) struct Sum {
    pub operation: usize,
    pub finds: NumberId,
    pub arms: Vec<Arm>,
    /// The arm by which is divided.
    divisor: Option<NumberId>,
}

pub(super) fn sums(site: &Site<'_>) -> Vec<Sum> {
    let all = arms(site);
    let sums = site.operations().filter_map(|(operation, done)| {
        let (finds, divisor) = match &done.kind {
            OperationKind::Solve { unknowns, equations } => {
                let (&[number], [equation]) = (unknowns.as_slice(), equations.as_slice()) else { return None };
                (number, equation.left.first()?.1.of.first().copied())
            }
            OperationKind::Compute { number, .. } => (*number, None),
            _ => return None,
        };
        if !matches!(site.number_kind(finds), NumberKind::Force | NumberKind::Moment) {
            return None;
        }
        let mut read = Vec::new();
        done.kind.each_number_read(|number| read.push(number));
        let arms: Vec<Arm> = all.iter().filter(|arm| read.contains(&arm.number)).copied().collect();
        let divisor = divisor.filter(|number| arms.iter().any(|arm| arm.number == *number));
        (!arms.is_empty()).then_some(Sum { operation, finds, arms, divisor })
    });
    sums.collect()
}

impl Sum {
    fn loaded(&self) -> impl Iterator<Item = &Arm> {
        self.arms.iter().filter(|arm| Some(arm.number) != self.divisor)
    }
}

/// What is told of a sum: the symbol of what it finds.
pub(super) fn finds(drawn: &Drawn<'_>, number: NumberId) -> Blank {
    let site = drawn.site;
    let name = site.number_name(number);
    if !name.is_empty() {
        return site.quantity(number);
    }
    let part = drawn.plan.numbers.parts.iter().find(|part| part.size == number);
    part.map_or_else(|| Blank::Words(String::new()), |part| drawn.symbol(part.of))
}

/// An arm measured to the point where its force acts.
pub(super) fn to_point(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let mut all = Vec::new();
        for sum in sums(site) {
            let mut edits_of_all = Vec::new();
            for arm in sum.loaded() {
                let edits = arm_to_point(site, arm);
                if edits.is_empty() {
                    continue;
                }
                edits_of_all.extend(edits.iter().cloned());
                let told = tell::arm_to_point(finds(drawn, sum.finds));
                all.extend(drawn.together(told, edits, Some(site.model.steps[sum.operation])));
            }
            let told = tell::arm_to_point(finds(drawn, sum.finds));
            if edits_of_all.len() > 2 {
                all.extend(drawn.together(told, edits_of_all, Some(site.model.steps[sum.operation])));
            }
        }
        all
    })
}

fn arm_to_point(site: &Site<'_>, arm: &Arm) -> Vec<Disturbance> {
    let right = site.exact(arm.number);
    let wrong = (site.model.exact.place(arm.at) - site.model.exact.place(arm.about)).norm();
    if (wrong - right.abs()).abs() < 1e-3 * wrong {
        return Vec::new();
    }
    let &Arm { measured, number, about, at, .. } = arm;
    let kind = OperationKind::Measure { number, from: about, to: at, how: MeasuredAs::Size };
    let sign = if right < 0.0 { -1.0 } else { 1.0 };
    vec![instead(measured, kind), times(measured, number, sign)]
}

/// Arms in millimetres of paper: of one sum, all of them or those of loads; and of all sums.
pub(super) fn in_paper_mm(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let sums = sums(site);
        let mut all = Vec::new();
        let scale = |sheet: Sheet| sheet.facts().scale_symbol;
        let edit = |arm: &Arm| times(arm.measured, arm.number, 1.0 / site.model.scales[arm.sheet]);
        let is_one = |sheet: Sheet| (site.model.scales[sheet] - 1.0).abs() < 1e-9;
        for sum in &sums {
            let Some(sheet) = sum.arms.first().map(|arm| arm.sheet).filter(|sheet| !is_one(*sheet)) else { continue };
            let told = || tell::arm_in_paper_mm(finds(drawn, sum.finds), scale(sheet).into());
            let step = Some(site.model.steps[sum.operation]);
            all.extend(drawn.together(told(), sum.arms.iter().map(edit).collect(), step));
            // The radii of a wheel are of one kind: who takes one from paper takes both so.
            let is_of_teeth = |arm: &Arm| {
                let maker = site.model.place_makers[arm.at.0];
                maker.is_some_and(|maker| matches!(site.operation(maker).role, OperationRole::Pitch(_)))
            };
            if sum.divisor.is_some() && !sum.loaded().all(is_of_teeth) {
                all.extend(drawn.together(told(), sum.loaded().map(edit).collect(), step));
            }
        }
        let on_scheme = |sum: &&Sum| sum.arms.iter().all(|arm| arm.sheet == Sheet::Scheme);
        let of_scheme: Vec<&Sum> = sums.iter().filter(on_scheme).collect();
        if of_scheme.len() > 1 && !is_one(Sheet::Scheme) {
            let told = tell::arms_in_paper_mm(scale(Sheet::Scheme).into());
            let edits = of_scheme.iter().flat_map(|sum| sum.arms.iter().map(edit)).collect();
            all.extend(drawn.together(told, edits, Some(site.model.steps[of_scheme[0].operation])));
        }
        all
    })
}

/// Moments taken about another point: another joint, or a crossing of other lines.
pub(super) fn about_wrong_point(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let mut all = Vec::new();
        for sum in sums(site).iter().filter(|sum| sum.arms.iter().all(|arm| arm.sheet == Sheet::Scheme)) {
            let about = sum.arms[0].about;
            let maker = site.model.place_makers[about.0];
            let is_crossing = maker.is_some_and(|maker| site.operation(maker).role == OperationRole::MomentPoint);
            let of_lines = if is_crossing { crossings(drawn, about) } else { Vec::new() };
            for (wrong, other, edit) in of_lines.into_iter().chain(joints(drawn, sum, about)) {
                let told = tell::moment_about_wrong_point(finds(drawn, sum.finds), wrong, right(drawn, sum, about));
                let edits = match edit {
                    Some(edit) => vec![edit],
                    None => moved(sum, other),
                };
                all.extend(drawn.together(told, edits, Some(site.model.steps[sum.operation])));
            }
        }
        all
    })
}

/// The right point by its name; of a crossing the forces whose lines cross there.
fn right(drawn: &Drawn<'_>, sum: &Sum, about: PlaceId) -> Blank {
    let name = drawn.site.place_name(about);
    if !name.is_empty() {
        return name.into();
    }
    let of_sum = drawn.plan.moments.iter().find(|moment| {
        (moment.value - drawn.site.exact(sum.finds)).abs() <= 1e-9 * moment.value.abs()
            && matches!(moment.about, MomentPoint::Crossing(_))
    });
    match of_sum.map(|moment| moment.about) {
        Some(MomentPoint::Crossing(lines)) => {
            let symbols = lines.map(|of| drawn.symbol(of).text().to_owned());
            Blank::Words(symbols.join(" × "))
        }
        _ => Blank::Words("S".to_owned()),
    }
}

/// The arms measured from another place.
fn moved(sum: &Sum, other: PlaceId) -> Vec<Disturbance> {
    let edits = sum.arms.iter().flat_map(|arm| {
        let &Arm { measured, number, foot, normal, .. } = arm;
        let how = MeasuredAs::Along(normal);
        [(measured, OperationKind::Measure { number, from: other, to: foot, how })]
    });
    edits.map(|(index, kind)| instead(index, kind)).collect()
}

type Wrong = (Blank, PlaceId, Option<Disturbance>);

/// Other joints about which somebody takes moments.
fn joints(drawn: &Drawn<'_>, sum: &Sum, about: PlaceId) -> Vec<Wrong> {
    let site = drawn.site;
    let mm = site.model.scales[Sheet::Scheme];
    let at = |place: PlaceId| site.model.exact.place(place);
    let divisor = sum.arms.iter().find(|arm| Some(arm.number) == sum.divisor);
    let others = site.operations().filter_map(|(_, operation)| match operation.kind {
        OperationKind::Plot { place, .. } if operation.sheet == Sheet::Scheme => Some(place),
        _ => None,
    });
    let is_far = |place: &PlaceId| (at(*place) - at(about)).norm() > ONE * mm;
    // The unknown needs an arm there.
    let has_arm = |place: &PlaceId| {
        divisor.is_none_or(|arm| {
            let along = site.model.exact.line(arm.normal).1;
            (at(arm.foot) - at(*place)).dot(&along).abs() > SHORTEST * mm
        })
    };
    others.filter(is_far).filter(has_arm).map(|place| (site.place(place), place, None)).collect()
}

/// Crossings of other lines of the scheme in place of a moment point.
fn crossings(drawn: &Drawn<'_>, about: PlaceId) -> Vec<Wrong> {
    let site = drawn.site;
    let Some(maker) = site.model.place_makers[about.0] else { return Vec::new() };
    let OperationKind::Cross { lines: own, .. } = site.operation(maker).kind else { return Vec::new() };
    let mm = site.model.scales[Sheet::Scheme];
    let before: Vec<LineId> = site
        .operations()
        .take(maker)
        .filter(|(_, operation)| operation.sheet == Sheet::Scheme)
        .filter_map(|(_, operation)| operation.kind.line())
        .filter(|line| line_name(drawn, *line).is_some())
        .collect();
    let right = site.model.exact.place(about);
    let mut all: Vec<Wrong> = Vec::new();
    let mut places = Vec::new();
    for (index, &first) in before.iter().enumerate() {
        for &second in &before[index + 1..] {
            if [first, second].iter().all(|line| own.contains(line)) {
                continue;
            }
            let [(p, u), (q, v)] = [first, second].map(|line| site.model.exact.line(line));
            let sine = cross(u, v);
            if sine.abs() < 0.1 {
                continue;
            }
            let at = p + u * (cross(q - p, v) / sine);
            let is_new = places.iter().all(|other: &Vector| (other - at).norm() > ONE * mm);
            if !is_new || (at - right).norm() < ONE * mm || !at.norm().is_finite() {
                continue;
            }
            places.push(at);
            let symbols = [first, second].map(|line| line_name(drawn, line).unwrap_or_default());
            let edit = instead(maker, OperationKind::Cross { place: about, lines: [first, second] });
            all.push((Blank::Words(symbols.join(" × ")), about, Some(edit)));
        }
    }
    all
}

/// A line through two joints by their names; none of other lines.
fn line_name(drawn: &Drawn<'_>, line: LineId) -> Option<String> {
    let site = drawn.site;
    match site.drawing_of(line)?.1.kind {
        OperationKind::Join { from, towards, .. } => Some([from, towards].map(|end| site.place_name(end)).concat()),
        OperationKind::Draw { along, .. } => match along.reference {
            Reference::Line(of) if along.quarter_turns.is_multiple_of(2) && of != line => line_name(drawn, of),
            _ => None,
        },
        _ => None,
    }
}

/// A lever that is not turned: its forces act at images of the plan as it is.
pub(super) fn not_turned(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let levers = site.model.construction.levers.iter();
        let unturned = levers.filter_map(|lever| {
            let pole = lever.forces.first().map(|_| lever.pole)?;
            let edits = lever.forces.iter().filter_map(|force| {
                let maker = site.model.place_makers[force.place.0]?;
                let OperationKind::Plot { place, at } = site.operation(maker).kind else { return None };
                let at = pole + quarter_turn(at - pole);
                Some(instead(maker, OperationKind::Plot { place, at }))
            });
            let step = site.model.makers[lever.number().0].map(|maker| site.model.steps[maker]);
            drawn.together(tell::lever_not_turned(site.quantity(lever.number())), edits.collect(), step)
        });
        unturned.collect()
    })
}

/// A couple added to the moments of a lever as it is, with the scale of the lever or without.
pub(super) fn couple_unscaled(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let mut all = Vec::new();
        for lever in &site.model.construction.levers {
            let couples: Vec<usize> = lever.forces.iter().filter(|force| force.is_of_couple).map(|f| f.load).collect();
            let mut loads = couples.clone();
            loads.dedup();
            for load in loads {
                let pair: Vec<_> = lever.forces.iter().filter(|f| f.is_of_couple && f.load == load).collect();
                let power: f64 = pair.iter().map(|force| force.size * force.arm).sum();
                let couple = drawn.plan.loads[load].couple;
                for scale in [1.0, site.model.scales[Sheet::Lever]] {
                    let factor = couple * scale / power;
                    let edits = pair.iter().filter_map(|force| drawn.times(force.numbers[0], factor));
                    let step = site.model.makers[lever.number().0].map(|maker| site.model.steps[maker]);
                    let told = tell::couple_on_lever_unscaled(drawn.link(drawn.plan.loads[load].body));
                    if factor.is_finite() && (factor - 1.0).abs() > 1e-3 {
                        all.extend(drawn.together(told, edits.collect(), step));
                    }
                }
            }
        }
        all
    })
}
