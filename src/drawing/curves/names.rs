use super::lines::distance;
use crate::drawing::clip::clipped_segment;
use kurbo::{Point, Rect, Size, Vec2};

/// White between a curve and its name, in mm.
pub(super) const CLEARANCE: f64 = 0.9;

/// Distance between the places that are tried, in mm.
const STEP: f64 = 3.0;

/// Room around a name, in mm, that is as good as any more.
const ROOM: f64 = 7.0;

/// What a name's place could be in conflict with, on the sheet.
pub(super) struct Surroundings<'a> {
    pub frame: Rect,
    /// The lines of all curves, the named one's too.
    pub curves: &'a [Vec<Vec<Point>>],
    /// Straight lines, which are better left free too.
    pub lines: &'a [(Point, Point)],
}

/// Where the name of a curve stands best: the point of the curve that it is beside, the direction in which, and its box.
///
/// Of places all along the curve, above and below it, the one with most room to other curves and what is `taken` wins, the rightmost of equals.
pub(super) fn name_place(
    own: usize,
    size: Size,
    around: &Surroundings<'_>,
    taken: &[Rect],
) -> Option<(Point, Vec2, Rect)> {
    let mut best: Option<(f64, (Point, Vec2, Rect))> = None;
    for anchor in around.curves[own].iter().flat_map(|part| along(part)) {
        for up in [-1.0, 1.0] {
            let toward = Vec2::new(0.0, up);
            let centre = anchor + toward * (CLEARANCE + 0.5 * size.height);
            let area = Rect::from_center_size(centre, size);
            if around.frame.inset(-1.5).union(area) != around.frame.inset(-1.5) {
                continue;
            }
            let least = best.as_ref().map_or(f64::NEG_INFINITY, |best| best.0);
            let room = room(own, area, around, taken, least);
            if room >= least {
                best = Some((room, (anchor, toward, area)));
            }
        }
    }
    best.map(|(_, place)| place)
}

/// Places along a line at equal steps.
fn along(line: &[Point]) -> Vec<Point> {
    let mut places = Vec::new();
    let mut left = 0.5 * STEP;
    for ends in line.windows(2) {
        let run = ends[1] - ends[0];
        let length = run.hypot2().sqrt();
        while left < length {
            places.push(ends[0] + run * (left / length));
            left += STEP;
        }
        left -= length;
    }
    places
}

/// How much room a box has, in mm, negative where it lies on something; or anything less than `least` if it has less.
fn room(own: usize, area: Rect, around: &Surroundings<'_>, taken: &[Rect], least: f64) -> f64 {
    let mut room = ROOM;
    for other in taken {
        room = room.min(apart(area, *other).clamp(-1.0, ROOM));
    }
    for (a, b) in around.lines {
        room = room.min(gap_to_line(area, *a, *b) + 1.0);
    }
    for (index, curve) in around.curves.iter().enumerate() {
        for ends in curve.iter().flat_map(|part| part.windows(2)) {
            if room < least {
                return room;
            }
            // Its own curve may be as near as the name asks for, not nearer.
            let near = if index == own { 0.8 * CLEARANCE } else { room };
            if apart(area, Rect::from_points(ends[0], ends[1])) >= near {
                continue;
            }
            let gap = gap_to_line(area, ends[0], ends[1]);
            let left = if index == own {
                ROOM + 12.0 * (gap - near).min(0.0)
            } else if gap > 0.0 {
                gap
            } else {
                -ROOM
            };
            room = room.min(left);
        }
    }
    room
}

/// How far two boxes are from each other across or down, whichever is more; negative where they overlap.
fn apart(a: Rect, b: Rect) -> f64 {
    let across = (a.x0 - b.x1).max(b.x0 - a.x1);
    let down = (a.y0 - b.y1).max(b.y0 - a.y1);
    across.max(down)
}

/// The distance between a box and a straight line; 0 where they touch.
fn gap_to_line(area: Rect, a: Point, b: Point) -> f64 {
    let beside = |p: Point| {
        let x = (area.x0 - p.x).max(p.x - area.x1).max(0.0);
        let y = (area.y0 - p.y).max(p.y - area.y1).max(0.0);
        (x * x + y * y).sqrt()
    };
    let ends = beside(a).min(beside(b));
    if ends == 0.0 || clipped_segment(area, a, b).is_some() {
        return 0.0;
    }
    let corners = [(area.x0, area.y0), (area.x1, area.y0), (area.x0, area.y1), (area.x1, area.y1)];
    let corners = corners.map(|c| distance(c.into(), a, b));
    corners.into_iter().fold(ends, f64::min)
}
