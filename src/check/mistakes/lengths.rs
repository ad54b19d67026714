//! Mistakes with lengths and segments, the wrong one measured or taken; with a crank, whose length and angle the scene
//! gives; and the whole mechanism drawn in another assembly mode.

use super::site::{Candidate, Laid, Site, instead, times};
use super::told::{Blank, Told, tell};
use crate::check::entry::Entry;
use crate::check::model::in_order;
use crate::construction::{
    Along, Disturbance, MeasuredAs, NumberId, NumberKind, OperationKind, OperationRole, PlaceId, Product, ProductKind,
    Reference,
};
use crate::geometry::{turn_of_degrees, with_turns};
use crate::mechanism::{BodyId, Role};
use crate::position::{Pose, first_poses, pose};
use crate::sheet::Sheet;

/// The operations that measure a length between points of a name: index, sheet, number, ends.
fn measures<'a>(site: &'a Site<'a>) -> impl Iterator<Item = (usize, Sheet, NumberId, [PlaceId; 2])> {
    let is_meant = |number| !matches!(site.number_kind(number), NumberKind::Force | NumberKind::Arm);
    site.operations().filter_map(move |(index, operation)| match operation.kind {
        OperationKind::Measure { number, from, to, how: MeasuredAs::Along(_) | MeasuredAs::Size }
            if is_meant(number) =>
        {
            Some((index, operation.sheet, number, [from, to]))
        }
        _ => None,
    })
}

/// A number measured between other places or along an axis, with its right sign: people take the sign from the sheets, not
/// from the measurement.
fn measured(
    site: &Site<'_>,
    told: Told,
    operation: usize,
    (number, [from, to], how): (NumberId, [PlaceId; 2], MeasuredAs),
) -> Candidate {
    let mut candidate = site.candidate(told, instead(operation, OperationKind::Measure { number, from, to, how }));
    if site.model.replay(&candidate.edits).number(number) * site.exact(number) < 0.0 {
        candidate.edits.push(times(operation, number, -1.0));
    }
    candidate
}

pub(super) fn component(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, _, number, ends) in measures(site) {
        for (how, axis) in [(MeasuredAs::X, Blank::Horizontal), (MeasuredAs::Y, Blank::Vertical)] {
            let [from, to] = ends.map(|end| site.place(end));
            let told = tell::component(site.quantity(number), axis, from, to);
            found.push(measured(site, told, index, (number, ends, how)));
        }
    }
    found
}

/// A segment of a plan measured from or to another point.
pub(super) fn wrong_segment(site: &Site<'_>) -> Vec<Candidate> {
    let told = |number, from, to| tell::wrong_segment(site.quantity(number), from, to);
    ends_elsewhere(site, told, |sheet| sheet.order().is_some())
}

/// A distance on the figure of instant centres measured from or to another place.
pub(super) fn wrong_distance(site: &Site<'_>) -> Vec<Candidate> {
    let told = |number, from, to| tell::distance_from_wrong_center(site.quantity(number), from, to);
    ends_elsewhere(site, told, |sheet| sheet == Sheet::Centers)
}

/// Measures from or to another place of a sheet that is meant, told by the number and the places.
fn ends_elsewhere(
    site: &Site<'_>,
    told: impl Fn(NumberId, Blank, Blank) -> Told,
    is_meant: fn(Sheet) -> bool,
) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, sheet, number, [from, to]) in measures(site).filter(|measure| is_meant(measure.1)) {
        for other in site.model.places_before(sheet, index) {
            if [from, to].contains(&other) {
                continue;
            }
            for ends in [[other, to], [from, other]] {
                let [from, to] = ends.map(|end| site.place(end));
                found.push(measured(site, told(number, from, to), index, (number, ends, MeasuredAs::Size)));
            }
        }
    }
    found
}

/// A length of the scheme, or one of a link that the construction does without.
#[derive(Clone, Copy)]
pub(super) struct Length<'s> {
    /// Its number, where the construction uses it.
    pub number: Option<NumberId>,
    /// Its size.
    pub exact: f64,
    /// The names of its ends.
    pub names: [&'s str; 2],
}

/// Most lengths among which any is taken for any other; of more only neighbours are.
const FEW: usize = 12;

/// The lengths of the scheme, then the links' other lengths.
pub(super) fn lengths<'s>(site: &'s Site<'_>) -> Vec<Length<'s>> {
    let solution = site.key.solution;
    let numbers = site.numbers_before(usize::MAX);
    let used = numbers.filter_map(|(number, kind)| match kind {
        NumberKind::Length(ends) => {
            let names = ends.map(|end| solution.construction.end_name(&solution.mechanism, end));
            Some(Length { number: Some(number), exact: site.exact(number).abs(), names })
        }
        _ => None,
    });
    let mut found: Vec<Length<'_>> = used.collect();
    for (_, link) in solution.mechanism.links() {
        for (at, &from) in link.points.iter().enumerate() {
            for &to in &link.points[at + 1..] {
                let names = [from, to].map(|point| solution.mechanism.point_name(point));
                let is_there = found.iter().any(|length| names.iter().all(|name| length.names.contains(name)));
                let exact = solution.pose.arm(from, to).norm();
                if !is_there && exact > 0.0 {
                    found.push(Length { number: None, exact, names });
                }
            }
        }
    }
    found
}

impl<'s> Length<'s> {
    /// The lengths that somebody takes for this one, with their ratios to it: those that share an end with it, and any
    /// where there are few.
    pub fn mistakable<'l>(&'l self, all: &'l [Length<'s>]) -> impl Iterator<Item = (&'l Length<'s>, f64)> {
        let is_near = |other: &Length<'_>| all.len() <= FEW || other.names.iter().any(|end| self.names.contains(end));
        let others = all.iter().filter(move |other| other.names != self.names && is_near(other));
        let ratios = others.map(|other| (other, other.exact / self.exact));
        ratios.filter(|(_, ratio)| ratio.is_finite() && *ratio > 0.0 && (ratio - 1.0).abs() > 1e-6)
    }

    /// The length taken `factor` times as large wherever it is used, from the first step that uses it on; `None` if it
    /// is measured, or never used.
    pub fn throughout(&self, site: &Site<'_>, told: Told, factor: f64) -> Option<Candidate> {
        let number = self.number.filter(|&number| site.is_given(number))?;
        let first = self.uses(site).next()?;
        let maker = site.model.makers[number.0]?;
        let step = site.model.steps[first];
        Some(Candidate { step, ..site.candidate(told, times(maker, number, factor)) })
    }

    /// The operations that use it.
    fn uses(&self, site: &Site<'_>) -> impl Iterator<Item = usize> {
        let uses = |kind: &OperationKind| {
            let mut found = false;
            kind.each_number_read(|number| found |= Some(number) == self.number);
            found
        };
        site.operations().filter(move |(_, operation)| uses(&operation.kind)).map(|(index, _)| index)
    }
}

/// A neighbouring length measured, or used in a vector's size, or used wherever the right one should be.
pub(super) fn wrong_length(site: &Site<'_>) -> Vec<Candidate> {
    let told = |number, from, to| tell::wrong_length(site.symbol(number), from, to);
    let mut found = ends_elsewhere(site, told, |sheet| sheet == Sheet::Scheme);
    let lengths = lengths(site);
    let used = || lengths.iter().filter_map(|length| Some((length, length.number?)));
    for term in site.all_terms() {
        let product = term.product();
        let Some((right, own)) = used().find(|(_, own)| product.of.last() == Some(own)) else {
            continue;
        };
        for (wrong, ratio) in right.mistakable(&lengths) {
            let [from, to] = wrong.names.map(Blank::from);
            found.push(term.candidate(site, told(own, from, to), Some(product.times(ratio))));
        }
    }
    for (right, own) in used().filter(|(length, _)| length.uses(site).count() > 1) {
        for (wrong, ratio) in right.mistakable(&lengths) {
            let [from, to] = wrong.names.map(Blank::from);
            let told = tell::wrong_length_throughout(site.symbol(own), from, to);
            found.extend(right.throughout(site, told, ratio));
        }
    }
    found
}

/// Whether a product is of a given rate with an arm of its link.
fn is_of_arm(site: &Site<'_>, product: &Product) -> bool {
    matches!(product.kind, ProductKind::Turning | ProductKind::Normal) && site.is_of_crank(product)
}

/// A crank's length taken `factor` times as long in all its products.
fn of_other_length(site: &Site<'_>, tell: fn(Blank) -> Told, factor: f64) -> Vec<Candidate> {
    let products = site.all_terms().map(|term| term.product()).filter(|product| is_of_arm(site, product));
    let arms: Vec<NumberId> = products.filter_map(|product| product.of.last().copied()).collect();
    let all = lengths(site).into_iter().filter_map(|length| {
        let number = length.number.filter(|number| arms.contains(number))?;
        length.throughout(site, tell(site.symbol(number)), factor)
    });
    all.collect()
}

/// The crank's diameter, or a slider-crank's stroke, in all products.
pub(super) fn diameter_throughout(site: &Site<'_>) -> Vec<Candidate> {
    of_other_length(site, tell::diameter_throughout, 2.0)
}

pub(super) fn half_the_radius(site: &Site<'_>) -> Vec<Candidate> {
    of_other_length(site, tell::half_the_radius, 0.5)
}

/// Angles by which a protractor is commonly misread, in degrees.
const MISREAD: [f64; 8] = [10.0, -10.0, 20.0, -20.0, 30.0, -30.0, 90.0, -90.0];

/// The vectors of a crank's point in both plans, all turned by one angle.
pub(super) fn crank_turned(site: &Site<'_>) -> Vec<Candidate> {
    let vectors = site.vectors().into_iter();
    let of_crank: Vec<Laid<'_>> =
        vectors.filter(|vector| vector.sum.iter().any(|product| is_of_arm(site, product))).collect();
    let mut found = Vec::new();
    for (place, first) in of_crank.iter().enumerate() {
        // From the first of one point's vectors on.
        let same = |vector: &&Laid<'_>| vector.ends[1] == first.ends[1];
        if of_crank[..place].iter().any(|vector| same(&vector)) {
            continue;
        }
        let all: Vec<&Laid<'_>> = of_crank.iter().filter(same).collect();
        if all.len() < 2 {
            continue;
        }
        for degrees in MISREAD {
            let edit = |vector: &&Laid<'_>| {
                let sense = site.exact(vector.size).signum();
                let direction = turn_of_degrees(degrees).transform_vector(&(vector.direction(site) * sense));
                vector.turned(Along::given(direction))
            };
            let [from, to] = first.blanks();
            let told = tell::turned_vectors(from, to, Blank::Number(degrees.abs().to_string()));
            let step = site.model.steps[first.operation];
            found.push(Candidate { edits: all.iter().map(edit).collect(), ..Candidate::at(told, step) });
        }
    }
    found
}

/// The whole drawing made in another assembly mode.
pub(super) fn other_mode(site: &Site<'_>) -> Vec<Candidate> {
    (1..=site.other_modes).map(|mode| Candidate { mode, ..Candidate::at(tell::other_mode(), 0) }).collect()
}

/// A crank drawn at another angle than the given one, in degrees from +x, as a protractor is commonly misread: from its
/// other end, clockwise, from the vertical, by some of its marks; or the crank drawn towards the other side.
fn misread(angle: f64) -> Vec<f64> {
    let slipped = [5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 180.0].into_iter().flat_map(|by| [angle + by, angle - by]);
    let all = [180.0 - angle, -angle, 90.0 - angle].into_iter().chain(slipped);
    // From −180° to 180°.
    let within = |degrees: f64| with_turns(degrees, 0.0);
    let apart = |a: f64, b: f64| within(a - b).abs() > 1.0;
    let mut found: Vec<f64> = Vec::new();
    for wrong in all.map(within) {
        if apart(wrong, angle) && found.iter().all(|&other| apart(wrong, other)) {
            found.push(wrong);
        }
    }
    found
}

/// The mechanism drawn with a crank at a wrong angle.
pub(super) fn crank_angle(site: &Site<'_>) -> Vec<Candidate> {
    let solution = site.key.solution;
    // Groups without a construction take long to assemble and are not drawn.
    if solution.construction.agreement.iter().any(Option::is_none) || solution.mechanism.placing.is_some() {
        return Vec::new();
    }
    let mut found = Vec::new();
    for crank in 0..solution.mechanism.bodies.len() {
        let Role::Driver { angle: Some(right), .. } = solution.mechanism.body(BodyId(crank)).role else { continue };
        let mut mechanism = solution.mechanism.clone();
        let mut turned = |wrong: f64| {
            if let Role::Driver { angle, .. } = &mut mechanism.bodies[crank].role {
                *angle = Some(wrong);
            }
            mechanism.clone()
        };
        let apart = |a: f64, b: f64| with_turns(a - b, 0.0).abs();
        let link = || solution.mechanism.body(BodyId(crank)).name.as_str().into();
        // A calculator that takes the degrees of the scene for radians.
        let in_radians = with_turns(right.to_degrees(), 0.0);
        let told = |wrong: f64| {
            let [was, is] = [wrong, right].map(|angle| Blank::Number(format!("{angle:.0}")));
            let is_in_radians =
                apart(wrong, in_radians) <= TRIED && misread(right).iter().all(|other| apart(wrong, *other) > TRIED);
            if is_in_radians {
                tell::crank_angle_in_radians(link(), was, is)
            } else {
                tell::crank_angle(link(), was, is)
            }
        };
        let near = &solution.scene.near;
        for wrong in misread(right).into_iter().chain([in_radians]).filter(|wrong| apart(*wrong, right) > TRIED) {
            let Ok(pose) = pose(&turned(wrong), near) else { continue };
            found.push(Candidate { edits: in_pose(site, &pose), ..Candidate::at(told(wrong), 0) });
        }
        let drawn_at = |wrong: f64| first_poses(&turned(wrong), near, POSES).unwrap_or_default();
        let fitted = fitted_angle(site, right, drawn_at);
        found.extend(fitted.map(|(wrong, edits)| Candidate { edits, ..Candidate::at(told(wrong), 0) }));
    }
    found
}

/// Most assemblies at each angle that is tried.
const POSES: usize = 4;
/// Degrees from one angle that is tried to the next, and to which the best one is found.
const TRIED: f64 = 1.0;
const FOUND: f64 = 0.05;
/// Fewest values that one fitted angle must explain: with fewer, too many angles would.
const EXPLAINED: usize = 3;
/// Values are explained within so many times their tolerance, which is another one in another position.
const NEAR: f64 = 2.5;

/// The angle of a crank that explains most values of a form in which most are off, with the drawing at it; none where there is none, or most are right.
fn fitted_angle(
    site: &Site<'_>,
    right: f64,
    mut drawn_at: impl FnMut(f64) -> Vec<Pose>,
) -> Option<(f64, Vec<Disturbance>)> {
    let (entries, tolerances) = (site.entries, site.tolerances);
    let is_off = |(entry, tolerance): &(&Entry, &f64)| (entry.value - entry.expected).abs() > **tolerance;
    let count = entries.iter().zip(tolerances).filter(is_off).count();
    if count < EXPLAINED || 2 * count < entries.len() || tolerances.len() < entries.len() {
        return None;
    }
    // Deviations in tolerances, those of values that grow in proportion.
    let deviations = |edits: &[Disturbance]| {
        let predicted = site.model.read(&site.model.replay(&in_order(edits.iter())));
        let deviation = move |index: usize| {
            let (entry, predicted) = (&entries[index], predicted[index]);
            let is_size = entry.is_magnitude || site.model.readings[index].is_ok_and(|reading| reading.is_size());
            let off = if is_size { entry.value.abs() - predicted.abs() } else { entry.value - predicted };
            let grown = (predicted.abs() / entry.expected.abs().max(f64::MIN_POSITIVE)).max(1.0);
            let deviation = off.abs() / (tolerances[index] * grown).max(entry.rounding).max(f64::MIN_POSITIVE);
            if deviation.is_finite() { deviation } else { f64::INFINITY }
        };
        (0..entries.len()).map(deviation)
    };
    let mut best = (f64::INFINITY, right, Vec::new());
    let mut look = |angle: f64, best: &mut (f64, f64, Vec<Disturbance>)| {
        for pose in drawn_at(angle) {
            let edits = in_pose(site, &pose);
            // What is far off counts as not explained.
            let misfit = deviations(&edits).map(|off| off.min(2.0 * NEAR).powi(2)).sum::<f64>();
            if misfit < best.0 {
                *best = (misfit, angle, edits);
            }
        }
    };
    (0..(360.0 / TRIED) as u32).for_each(|k| look(right + f64::from(k) * TRIED, &mut best));
    let mut step = 0.5 * TRIED;
    while step > FOUND {
        let middle = best.1;
        [middle - step, middle + step].into_iter().for_each(|angle| look(angle, &mut best));
        step *= 0.5;
    }
    let (_, angle, edits) = best;
    let angle = with_turns(angle, 0.0);
    let explained = deviations(&edits).filter(|off| *off <= NEAR).count();
    let is_meant =
        explained >= EXPLAINED && 3 * explained >= 2 * entries.len() && with_turns(angle - right, 0.0).abs() > TRIED;
    is_meant.then_some((angle, edits))
}

/// The joints plotted, and the guides drawn, in another pose.
pub(super) fn in_pose(site: &Site<'_>, pose: &Pose) -> Vec<Disturbance> {
    let origin = site.model.construction.origin;
    let plotted = site.operations().filter_map(|(index, operation)| {
        let kind = match (operation.role, &operation.kind) {
            (OperationRole::Joint(point), &OperationKind::Plot { place, .. }) => {
                OperationKind::Plot { place, at: pose.point(point) - origin }
            }
            (OperationRole::Guide(slider), &OperationKind::Draw { line, through, along }) => match along.reference {
                Reference::Given(_) => {
                    let given = Along::given(pose.guide(slider));
                    OperationKind::Draw { line, through, along: Along { quarter_turns: along.quarter_turns, ..given } }
                }
                _ => return None,
            },
            _ => return None,
        };
        Some(instead(index, kind))
    });
    plotted.collect()
}
