//! Mistakes with the images of links: on the wrong side of another image, divided in the wrong ratio.

use super::site::{Candidate, Site, instead};
use super::told::{Blank, Told, tell};
use crate::construction::{
    Action, Along, Disturbance, LineId, NumberId, OperationKind, OperationRole, PlaceId, RayOf, Reference,
};
use crate::geometry::{Vector, unit};
use crate::sheet::Sheet;

pub(super) fn mirrored(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = mirrored_vectors(site);
    let shape = Shape { exchanged: false, mirrored: true };
    found.extend(triangles(site).iter().map(|triangle| triangle.drawn(site, shape)));
    found.extend(beyond(site));
    found
}

/// A division of the line of two images, measured from its other end; the triangle of a link's image drawn with its
/// two distances exchanged, on the right side or on the wrong one.
pub(super) fn wrong_ratio(site: &Site<'_>) -> Vec<Candidate> {
    let divided = site.operations().filter_map(|(index, operation)| match operation.kind {
        OperationKind::Divide { place, ends, like: [first, second, point] } => {
            let divided = |like, ends: [PlaceId; 2], tell: fn(Blank, Blank, Blank) -> Told| {
                let [from, to] = ends.map(|end| site.place(end));
                let told = tell(from, to, site.place(place));
                site.candidate(told, instead(index, OperationKind::Divide { place, ends, like }))
            };
            // The inverse ratio from either end: the point is taken for the other end.
            Some([
                divided([second, first, point], ends, tell::wrong_ratio),
                divided([first, point, second], ends, tell::inverse_ratio),
                divided([second, point, first], [ends[1], ends[0]], tell::inverse_ratio),
            ])
        }
        _ => None,
    });
    let mut found: Vec<Candidate> = divided.flatten().collect();
    for triangle in triangles(site) {
        for mirrored in [false, true] {
            found.push(triangle.drawn(site, Shape { exchanged: true, mirrored }));
        }
    }
    found
}

/// A ray for the image of a further point of a link: its operation, where it starts, its line, the link's arm.
struct ArmRay {
    index: usize,
    through: PlaceId,
    line: LineId,
    arm: LineId,
}

/// The image of a further point, crossed by two rays that make the triangle of the link's image.
struct Triangle {
    rays: [ArmRay; 2],
    place: PlaceId,
    /// The line of the two images.
    base: LineId,
    /// The line of their points on the link.
    side: LineId,
}

/// What is wrong with a triangle.
#[derive(Clone, Copy)]
struct Shape {
    /// Each ray has the angle of the other.
    exchanged: bool,
    /// The triangle is on the other side of its base.
    mirrored: bool,
}

/// The places that a line joins; `None` for other lines.
fn joined_by(site: &Site<'_>, line: LineId) -> Option<[PlaceId; 2]> {
    match site.drawing_of(line)?.1.kind {
        OperationKind::Join { from, towards, .. } => Some([from, towards]),
        _ => None,
    }
}

fn triangles(site: &Site<'_>) -> Vec<Triangle> {
    let joining = |ends: [PlaceId; 2]| {
        let mut lines = site.operations().filter_map(|(_, operation)| operation.kind.line());
        lines.find(|&line| joined_by(site, line) == Some(ends))
    };
    let crossed = site.operations().filter_map(|(_, operation)| {
        let (OperationRole::Image, &OperationKind::Cross { place, lines }) = (operation.role, &operation.kind) else {
            return None;
        };
        let [Some(first), Some(second)] = lines.map(|line| arm_ray(site, line)) else { return None };
        let base = joining([first.through, second.through])?;
        // The side of the link of which the base is the image joins the points at which the arms begin.
        let [a, b] = [&first, &second].map(|ray| joined_by(site, ray.arm));
        let side = joining([a?[0], b?[0]])?;
        Some(Triangle { rays: [first, second], place, base, side })
    });
    crossed.collect()
}

impl Triangle {
    fn drawn(&self, site: &Site<'_>, shape: Shape) -> Candidate {
        let edit = |own: usize| -> Disturbance {
            let (ray, other) = (&self.rays[own], &self.rays[1 - own]);
            // Exchanged, the angle at one end is that at the other, seen in a mirror.
            let arm = if shape.exchanged { other.arm } else { ray.arm };
            let angle = if shape.exchanged == shape.mirrored { [self.side, arm] } else { [arm, self.side] };
            let along = Along::angle(self.base, angle);
            instead(ray.index, OperationKind::Draw { line: ray.line, through: ray.through, along })
        };
        let [from, to] = [&self.rays[0], &self.rays[1]].map(|ray| site.place(ray.through));
        let point = site.place(self.place);
        let told = match shape {
            Shape { exchanged: false, .. } => tell::mirrored_image(from, point, to),
            Shape { mirrored: true, .. } => tell::distances_exchanged_and_mirrored(from, to, point),
            Shape { mirrored: false, .. } => tell::distances_exchanged(from, to, point),
        };
        let mut candidate = site.candidate(told, edit(0));
        candidate.edits.push(edit(1));
        candidate
    }
}

/// The ray of a line, if it leads to the image of a further point of a link.
fn arm_ray(site: &Site<'_>, line: LineId) -> Option<ArmRay> {
    let (index, operation) = site.drawing_of(line)?;
    match (site.key.solution.construction.step(operation.step?)?, &operation.kind) {
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

/// Least length of an arm beyond an end of a line, in parts of the line.
const LEAST_ARM: f64 = 0.02;

/// The image of a point that lies beyond an end of its line, as of a lever's far arm, marked on the wrong side of that
/// end.
fn beyond(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, operation) in site.operations() {
        let OperationKind::Divide { place, ends, like } = operation.kind else { continue };
        let [first, second, point] = like.map(|point| site.model.exact.place(point));
        let ratio = (point - first).dot(&(second - first)) / (second - first).norm_squared();
        let ([near, far], part) = if ratio < 0.5 { (ends, ratio) } else { ([ends[1], ends[0]], 1.0 - ratio) };
        if part < -LEAST_ARM {
            let [start, end] = [near, far].map(|end| site.model.exact.place(end));
            let told = tell::beyond_end(site.place(near), site.place(place), site.place(far));
            let edit = instead(index, OperationKind::Plot { place, at: start - (end - start) * part });
            found.push(site.candidate(told, edit));
        }
    }
    found
}

/// The image of a link with three points mirrored: one of its sides laid off on the wrong side of another.
fn mirrored_vectors(site: &Site<'_>) -> Vec<Candidate> {
    // Vectors of the plans that are normal to lines of the mechanism: operation, ends, size, direction of the line.
    let laid = site.operations().filter_map(|(index, operation)| match operation.kind {
        OperationKind::LayOff {
            place,
            from,
            size,
            along: Along { reference: Reference::Line(line), quarter_turns: 1 },
        } if operation.sheet != Sheet::Scheme && !site.place_name(place).is_empty() => {
            let [a, b] = joined_by(site, line)?.map(|end| site.model.exact.place(end));
            Some((index, [from, place], size, unit(b - a)?))
        }
        _ => None,
    });
    let laid: Vec<(usize, [PlaceId; 2], NumberId, Vector)> = laid.collect();
    let mut found = Vec::new();
    for &(index, [from, place], size, along) in &laid {
        let before = laid.iter().take_while(|(other, ..)| *other < index);
        for &(other, [from_other, place_other], _, axis) in before {
            let is_same_sheet = site.operation(other).sheet == site.operation(index).sheet;
            if site.place_name(from_other) != site.place_name(from) || !is_same_sheet {
                continue;
            }
            let mirrored = Along::given(axis * (2.0 * along.dot(&axis)) - along).turned(1);
            let told = tell::mirrored_image(site.place(from), site.place(place), site.place(place_other));
            let edit = instead(index, OperationKind::LayOff { place, from, size, along: mirrored });
            found.push(site.candidate(told, edit));
        }
    }
    found
}
