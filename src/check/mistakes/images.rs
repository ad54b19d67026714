//! Mistakes with the images of links: on the wrong side of another image, divided in the wrong ratio.

use super::candidate::Candidate;
use super::mistake::Mistake;
use super::site::Site;
use crate::check::model::Edit;
use crate::construction::{Action, Along, LineId, NumberId, OperationKind, Part, PlaceId, RayOf, Reference, Sheet};
use crate::geometry::Vector;

pub(super) fn mirrored(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = mirrored_vectors(site);
    found.extend(mirrored_crossings(site));
    found
}

/// A division of the line of two images, measured from its other end.
pub(super) fn wrong_ratio(site: &Site<'_>) -> Vec<Candidate> {
    let divided = site.operations().filter_map(|(index, operation)| match operation.kind {
        OperationKind::Divide { place, ends, like: [first, second, point] } => {
            let edit = Edit::Instead(OperationKind::Divide { place, ends, like: [second, first, point] });
            let blanks = [ends[0], ends[1], place].map(|place| site.place_name(place));
            Some(site.candidate(Mistake::WrongRatio, index, edit, &blanks))
        }
        _ => None,
    });
    divided.collect()
}

/// A ray for the image of a further point of a link: its operation, where it starts, its line, the link's arm.
struct ArmRay {
    index: usize,
    through: PlaceId,
    line: LineId,
    arm: LineId,
}

/// The image of a further point, crossed on the wrong side of the line of the two images that give it.
fn mirrored_crossings(site: &Site<'_>) -> Vec<Candidate> {
    let joined = |ends: [PlaceId; 2]| {
        site.operations().find_map(|(_, operation)| match operation.kind {
            OperationKind::Join { line, from, towards } if [from, towards] == ends => Some(line),
            _ => None,
        })
    };
    let mut found = Vec::new();
    for (_, operation) in site.operations() {
        let (Part::Image, &OperationKind::Cross { place, lines }) = (operation.part, &operation.kind) else {
            continue;
        };
        let rays: Vec<ArmRay> = lines.iter().filter_map(|&line| arm_ray(site, line)).collect();
        let [first, second] = rays.as_slice() else { continue };
        let Some(base) = joined([first.through, second.through]) else { continue };
        // The side of the link of which the base is the image joins the points at which the arms begin.
        let start = |ray: &ArmRay| {
            site.operations().find_map(|(_, operation)| match operation.kind {
                OperationKind::Join { line, from, .. } if line == ray.arm => Some(from),
                _ => None,
            })
        };
        let Some(side) = start(first).zip(start(second)).and_then(|(a, b)| joined([a, b])) else { continue };
        let mirrored = |ray: &ArmRay| {
            let along = Along::angle(base, [ray.arm, side]);
            (ray.index, Edit::Instead(OperationKind::Draw { line: ray.line, through: ray.through, along }))
        };
        let blanks = [first.through, place, second.through].map(|place| site.place_name(place));
        let (index, edit) = mirrored(first);
        let mut candidate = site.candidate(Mistake::MirroredImage, index, edit, &blanks);
        candidate.edits.push(mirrored(second));
        found.push(candidate);
    }
    found
}

/// The ray of a line, if it leads to the image of a further point of a link.
fn arm_ray(site: &Site<'_>, line: LineId) -> Option<ArmRay> {
    let (index, operation) = site.operations().find(|(_, operation)| operation.kind.line() == Some(line))?;
    let step = site.key.solution.construction.step(operation.step?)?;
    match (&step.action, &operation.kind) {
        (Action::Ray(ray), &OperationKind::Draw { through, along, .. }) if matches!(ray.of, RayOf::Arm { .. }) => {
            let arm = match along.reference {
                Reference::Line(arm) | Reference::Angle { to: arm, .. } => arm,
                Reference::Given(_) => return None,
            };
            Some(ArmRay { index, through, line, arm })
        }
        _ => None,
    }
}

/// The image of a link with three points mirrored: one of its sides laid off on the wrong side of another.
fn mirrored_vectors(site: &Site<'_>) -> Vec<Candidate> {
    // Vectors of the plans that are normal to lines of the mechanism: operation, ends, size, direction of the line.
    let mut laid: Vec<(usize, [PlaceId; 2], NumberId, Vector)> = Vec::new();
    for (index, operation) in site.operations().filter(|(_, operation)| operation.sheet != Sheet::Scheme) {
        let OperationKind::LayOff {
            place,
            from,
            size,
            along: Along { reference: Reference::Line(line), quarter_turns: 1 },
        } = operation.kind
        else {
            continue;
        };
        let joined = site.operations().find_map(|(_, other)| match other.kind {
            OperationKind::Join { line: own, from, towards } if own == line => Some([from, towards]),
            _ => None,
        });
        let Some([a, b]) = joined.map(|ends| ends.map(|end| site.model.exact.place(end))) else { continue };
        if !site.place_name(place).is_empty()
            && let Some(along) = crate::geometry::unit(b - a)
        {
            laid.push((index, [from, place], size, along));
        }
    }
    let mut found = Vec::new();
    for &(index, [from, place], size, along) in &laid {
        let before = laid.iter().take_while(|(other, ..)| *other < index);
        for &(other, [from_other, place_other], _, axis) in before {
            let is_same_sheet = site.operation(other).sheet == site.operation(index).sheet;
            if site.place_name(from_other) != site.place_name(from) || !is_same_sheet {
                continue;
            }
            let mirrored = axis * (2.0 * along.dot(&axis)) - along;
            let edit =
                Edit::Instead(OperationKind::LayOff { place, from, size, along: Along::given(mirrored).turned(1) });
            let blanks = [from, place, place_other].map(|place| site.place_name(place));
            found.push(site.candidate(Mistake::MirroredImage, index, edit, &blanks));
        }
    }
    found
}
