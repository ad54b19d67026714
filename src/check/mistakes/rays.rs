//! Mistakes with lines: rays, cut lines, special points.

use super::beside::measured_there;
use super::site::{Candidate, Site, instead, times};
use super::told::{Blank, Told, tell};
use crate::construction::{Action, LineId, MeasuredAs, NumberId, Operation, OperationKind, OperationRole};
use crate::geometry::{Vector, cross, unit};
use crate::sheet::Sheet;

/// The plan points that a ray goes through and leads to; `None` if the operation draws no ray.
fn ends<'s>(site: &'s Site<'_>, operation: &Operation) -> Option<[&'s str; 2]> {
    match site.key.solution.construction.step(operation.step?)? {
        Action::Ray(ray) if operation.role == OperationRole::Ray => Some([&ray.through, &ray.to]),
        _ => None,
    }
}

/// A line drawn at 90° to its right direction.
fn turn(site: &Site<'_>, told: Told, index: usize) -> Option<Candidate> {
    let OperationKind::Draw { line, through, along } = site.operation(index).kind else {
        return None;
    };
    Some(site.candidate(told, instead(index, OperationKind::Draw { line, through, along: along.turned(1) })))
}

/// Rays turned by 90°, one of them or both that cross at an image. Along the link a segment shows no sense of its rate,
/// so either is taken.
pub(super) fn turned(site: &Site<'_>) -> Vec<Candidate> {
    let rays: Vec<TurnedRay> = site.operations().filter_map(|(index, _)| TurnedRay::at(site, index)).collect();
    let mut found: Vec<Candidate> = rays.iter().flat_map(TurnedRay::in_either_sense).collect();
    for (_, operation) in site.operations() {
        let OperationKind::Cross { lines, .. } = operation.kind else { continue };
        let ray = |line: LineId| rays.iter().find(|ray| ray.line == line);
        let [Some(first), Some(second)] = lines.map(ray) else { continue };
        for a in first.in_either_sense() {
            for b in second.in_either_sense() {
                let mut both = a.clone();
                both.edits.extend(b.edits);
                both.told = tell::turned_rays(first.from.clone(), first.to.clone(), second.from.clone());
                found.push(both);
            }
        }
    }
    found
}

/// A ray drawn at 90° to its right direction.
struct TurnedRay {
    line: LineId,
    from: Blank,
    to: Blank,
    candidate: Candidate,
    /// The operation that solves for the rate that its segment gives, and that rate.
    rate: Option<(usize, NumberId)>,
}

impl TurnedRay {
    fn at(site: &Site<'_>, index: usize) -> Option<TurnedRay> {
        let operation = site.operation(index);
        let [from, to] = ends(site, operation)?.map(Blank::from);
        let line = operation.kind.line()?;
        let candidate = turn(site, tell::turned_ray(from.clone(), to.clone()), index)?;
        Some(TurnedRay { line, from, to, candidate, rate: rate_along(site, line) })
    }

    fn in_either_sense(&self) -> Vec<Candidate> {
        let mut both = vec![self.candidate.clone()];
        if let Some((operation, rate)) = self.rate {
            let mut other = self.candidate.clone();
            other.edits.push(times(operation, rate, -1.0));
            both.push(other);
        }
        both
    }
}

/// The rate that the segment along a ray gives by itself: the operation that solves for it, and its number.
fn rate_along(site: &Site<'_>, line: LineId) -> Option<(usize, NumberId)> {
    let (_, segment, _) = site.measuring_along(line)?;
    site.operations().find_map(|(index, operation)| {
        let OperationKind::Solve { unknowns, equations } = &operation.kind else { return None };
        let mut alone = equations.iter().filter(|e| e.right.iter().any(|p| p.of.as_slice() == [segment]));
        match alone.next()?.left.as_slice() {
            [(unknown, _)] => Some((index, unknowns[*unknown])),
            _ => None,
        }
    })
}

pub(super) fn turned_cut_line(site: &Site<'_>) -> Vec<Candidate> {
    let turned = |(index, operation): (usize, &Operation)| match (operation.role, &operation.kind) {
        (OperationRole::CutLine(special), OperationKind::Draw { through, .. }) => {
            let special = site.model.construction.special(special).name.as_str();
            turn(site, tell::turned_cut_line(site.place(*through), special.into()), index)
        }
        _ => None,
    };
    site.operations().filter_map(turned).collect()
}

/// A ray drawn through the wrong plan point. Its segment is measured from there, or from the point where it should
/// start.
pub(super) fn from_wrong_point(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, operation) in site.operations() {
        let (&OperationKind::Draw { line, through, along }, Some([from, to])) =
            (&operation.kind, ends(site, operation))
        else {
            continue;
        };
        for wrong in site.model.places_before(operation.sheet, index) {
            if wrong == through {
                continue;
            }
            let told = tell::ray_from_wrong_point(to.into(), site.place(wrong), from.into());
            let candidate = site.candidate(told, instead(index, OperationKind::Draw { line, through: wrong, along }));
            let Some((measure, number, end)) = site.measuring_along(line) else {
                found.push(candidate);
                continue;
            };
            let drawn = site.model.replay(&candidate.edits);
            for start in [through, wrong] {
                // The sense is seen from the ray, also where the segment does not lie along it.
                let kind = OperationKind::Measure { number, from: start, to: end, how: MeasuredAs::Size };
                let (_, direction) = drawn.line(line);
                let sense = (drawn.place(end) - drawn.place(start)).dot(&direction).signum();
                let mut candidate = candidate.clone();
                candidate.edits.extend([instead(measure, kind), times(measure, number, sense)]);
                found.push(candidate);
            }
        }
    }
    found
}

pub(super) fn wrong_lines(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, operation) in site.operations() {
        let (OperationRole::SpecialPoint(special), &OperationKind::Cross { place, lines }) =
            (operation.role, &operation.kind)
        else {
            continue;
        };
        let name = site.model.construction.special(special).name.as_str();
        let before = site.operations().take(index).filter(|(_, other)| other.sheet == Sheet::Scheme);
        let drawn: Vec<LineId> = before.filter_map(|(_, other)| other.kind.line()).collect();
        for side in 0..2 {
            for &wrong in drawn.iter().filter(|line| !lines.contains(line)) {
                let mut taken = lines;
                taken[side] = wrong;
                let [wrong, right] = [wrong, lines[side]].map(|line| line_name(site, line));
                let edit = instead(index, OperationKind::Cross { place, lines: taken });
                found.extend(measured_there(
                    site.model,
                    site.candidate(tell::wrong_lines(name.into(), wrong, right), edit),
                    place,
                ));
            }
            // A side of a link that the construction does not draw.
            let kept = site.model.exact.line(lines[1 - side]);
            for (names, side_of_link) in sides(site) {
                let is_drawn =
                    lines.iter().chain(&drawn).any(|line| is_same(site.model.exact.line(*line), side_of_link));
                let Some(at) = crossing(kept, side_of_link).filter(|_| !is_drawn) else { continue };
                let wrong = Blank::LineThrough(names);
                let edit = instead(index, OperationKind::Plot { place, at });
                let told = tell::wrong_lines(name.into(), wrong, line_name(site, lines[side]));
                found.extend(measured_there(site.model, site.candidate(told, edit), place));
            }
        }
    }
    found
}

/// The lines through two pins of a link, by the pins' names: a point of each and its direction.
pub(super) fn sides(site: &Site<'_>) -> Vec<(String, (Vector, Vector))> {
    let solution = site.key.solution;
    let place = |point| solution.pose.point(point) - site.model.construction.origin;
    let mut found = Vec::new();
    for (_, link) in solution.mechanism.links() {
        for (at, &from) in link.points.iter().enumerate() {
            for &to in &link.points[at + 1..] {
                let names = [from, to].map(|point| solution.mechanism.point_name(point)).concat();
                found.extend(unit(place(to) - place(from)).map(|along| (names, (place(from), along))));
            }
        }
    }
    found
}

/// Whether two lines are one on paper.
fn is_same((a, u): (Vector, Vector), (b, v): (Vector, Vector)) -> bool {
    cross(u, v).abs() < 1e-6 && cross(u, b - a).abs() < 1e-6 * (b - a).norm().max(f64::MIN_POSITIVE)
}

/// Where two lines cross; `None` if they are parallel.
fn crossing((a, u): (Vector, Vector), (b, v): (Vector, Vector)) -> Option<Vector> {
    let sine = cross(u, v);
    (sine.abs() > 0.05).then(|| a + u * (cross(b - a, v) / sine))
}

/// A line of the scheme: its role, or two of its points.
fn line_name(site: &Site<'_>, line: LineId) -> Blank {
    match site.drawing_of(line).map(|(_, operation)| (operation.role, &operation.kind)) {
        Some((_, OperationKind::Join { from, towards, .. })) => {
            Blank::LineThrough(format!("{}{}", site.place_name(*from), site.place_name(*towards)))
        }
        Some((OperationRole::CutLine(special), _)) => {
            Blank::CutLine(site.model.construction.special(special).name.clone())
        }
        Some((OperationRole::Guide(slider), _)) => {
            let solution = site.key.solution;
            Blank::Guide(solution.mechanism.slider_in_words(slider, &solution.wording()))
        }
        _ => Blank::LineThrough(String::new()),
    }
}
