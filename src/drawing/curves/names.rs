use crate::drawing::clip::{clipped_segment, distance};
use crate::drawing::shape::{corners, distance_to_box};
use kurbo::{Point, Rect, Size, Vec2};

/// White between a curve and its name, in mm.
pub(super) const CLEARANCE: f64 = 0.9;

/// Distance between the places that are tried, in mm.
const STEP: f64 = 3.0;

/// Distance to other things, in mm, above which a place is not better.
const ROOM: f64 = 7.0;

/// The obstacles for a name, on the sheet.
pub(super) struct Surroundings<'a> {
    pub frame: Rect,
    /// The lines of all curves, also of the named one.
    pub curves: &'a [Vec<Vec<Point>>],
    /// Straight lines, which names should keep off.
    pub lines: &'a [(Point, Point)],
}

/// The best place for the name of a curve: a point of the curve, the direction from it to the name, and the name's box;
/// none if no place is in the frame.
///
/// Places all along the curve, above and below it, are compared by their distance from other curves and from `taken`
/// boxes; of equals the rightmost one wins.
pub(super) fn name_place(
    named: usize,
    size: Size,
    around: &Surroundings<'_>,
    taken: &[Rect],
) -> Option<(Point, Vec2, Rect)> {
    let mut best: Option<(f64, (Point, Vec2, Rect))> = None;
    for anchor in around.curves[named].iter().flat_map(|part| along(part)) {
        for up in [-1.0, 1.0] {
            let toward = Vec2::new(0.0, up);
            let centre = anchor + toward * (CLEARANCE + 0.5 * size.height);
            let area = Rect::from_center_size(centre, size);
            if around.frame.inset(-1.5).union(area) != around.frame.inset(-1.5) {
                continue;
            }
            let least = best.as_ref().map_or(f64::NEG_INFINITY, |best| best.0);
            let room = room(named, area, around, taken, least);
            if room >= least {
                best = Some((room, (anchor, toward, area)));
            }
        }
    }
    best.map(|(_, place)| place)
}

/// Points of a line at equal steps.
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

/// The distance of a box from other things, in mm, negative where they overlap; or any value less than `least` if the
/// distance is less.
fn room(named: usize, area: Rect, around: &Surroundings<'_>, taken: &[Rect], least: f64) -> f64 {
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
            // The named curve may be as near as its clearance.
            let near = if index == named { 0.8 * CLEARANCE } else { room };
            if apart(area, Rect::from_points(ends[0], ends[1])) >= near {
                continue;
            }
            let gap = gap_to_line(area, ends[0], ends[1]);
            let left = if index == named {
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

/// The distance of two boxes in x or in y, the larger one; negative where they overlap.
fn apart(a: Rect, b: Rect) -> f64 {
    let across = (a.x0 - b.x1).max(b.x0 - a.x1);
    let down = (a.y0 - b.y1).max(b.y0 - a.y1);
    across.max(down)
}

/// The distance between a box and a straight line; 0 where they touch.
fn gap_to_line(area: Rect, a: Point, b: Point) -> f64 {
    let ends = distance_to_box(area, a).min(distance_to_box(area, b));
    if ends == 0.0 || clipped_segment(area, a, b).is_some() {
        return 0.0;
    }
    corners(area).map(|corner| distance(corner, a, b)).into_iter().fold(ends, f64::min)
}
