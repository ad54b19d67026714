//! Corners of markers to a part of a pixel: straight lines through their four edges, crossed.

use super::picture::Picture;
use crate::geometry::{Point, Vector, cross};

const PROFILES: usize = 17;
/// Part of an edge at either end without profiles: there it is round.
const END: f64 = 0.1;
/// Half the length of a profile, in mm: inside an edge is a cell of black, outside white.
const REACH: f64 = 1.2;
const SAMPLES: usize = 12;
/// Half the part of a profile about the edge that counts, in samples.
const WINDOW: f64 = 6.5;
/// Least standard deviation of a corner, in pixels: what profiles have in common.
const FLOOR: f64 = 0.02;

/// A corner in the picture with its standard deviation, in pixels, and how widely the edges at it are spread by blur, as a standard deviation in mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub at: Point,
    pub deviation: f64,
    pub blur: f64,
}

/// A straight line: a point on it, its direction of length one, the standard deviation of its places across, and its blur.
struct Edge {
    on: Point,
    along: Vector,
    deviation: f64,
    blur: f64,
}

/// The corners of a marker near where they are expected; `side` is its side in mm. `None` for corners beside an edge that is not seen.
pub(super) fn corners(picture: &Picture, expected: &[Point; 4], side: f64) -> [Option<Corner>; 4] {
    let edges: [Option<Edge>; 4] = std::array::from_fn(|i| edge(picture, expected, i, side));
    std::array::from_fn(|i| {
        let (before, after) = (edges[(i + 3) % 4].as_ref()?, edges[i].as_ref()?);
        let sine = cross(before.along, after.along);
        if sine.abs() < 0.2 {
            return None;
        }
        let at = before.on + before.along * (cross(after.on - before.on, after.along) / sine);
        let both = libm::hypot(before.deviation, after.deviation) / sine.abs();
        let deviation = libm::hypot(both, FLOOR);
        let is_near = (at - expected[i]).norm() < 0.25 * (expected[(i + 2) % 4] - expected[i]).norm();
        let blur = 0.5 * (before.blur + after.blur);
        (is_near && picture.holds(at)).then_some(Corner { at, deviation, blur })
    })
}

/// The edge from one corner to the next.
fn edge(picture: &Picture, expected: &[Point; 4], from: usize, side: f64) -> Option<Edge> {
    let (a, b) = (expected[from], expected[(from + 1) % 4]);
    let [inner_a, inner_b] = [expected[(from + 3) % 4], expected[(from + 2) % 4]];
    let mut points: Vec<Point> = Vec::with_capacity(PROFILES);
    let mut blur = 0.0;
    for i in 0..PROFILES {
        let t = END + (1.0 - 2.0 * END) * i as f64 / (PROFILES - 1) as f64;
        let on = a + (b - a) * t;
        // Inwards along the sides next to it, so that perspective is followed.
        let inwards = ((inner_a - a) * (1.0 - t) + (inner_b - b) * t) / side * REACH;
        if let Some((point, width)) = crossing(picture, on, inwards) {
            points.push(point);
            blur += width;
        }
    }
    if points.len() < PROFILES * 2 / 3 {
        return None;
    }
    blur /= points.len() as f64;
    // Least squares, then once more without those far off.
    for _ in 0..2 {
        let line = line(&points)?;
        let off = |point: &Point| cross(line.along, *point - line.on).abs();
        let limit = (3.0 * line.deviation * (points.len() as f64).sqrt()).max(0.05);
        points.retain(|point| off(point) <= limit);
    }
    let edge = (points.len() >= PROFILES / 2).then(|| line(&points)).flatten()?;
    Some(Edge { blur, ..edge })
}

/// Where a profile passes from black to white: the middle of its rise, which blur on both sides alike does not move. Only what is near it counts, so that cells
/// inside the marker do not. With the standard deviation of the rise about it, in mm.
fn crossing(picture: &Picture, on: Point, inwards: Vector) -> Option<(Point, f64)> {
    let count = 2 * SAMPLES + 1;
    let place = |i: f64| on + inwards * (1.0 - i / SAMPLES as f64);
    if !picture.holds(place(0.0)) || !picture.holds(place((count - 1) as f64)) {
        return None;
    }
    let values: Vec<f64> = (0..count).map(|i| picture.at(place(i as f64))).collect();
    let rises: Vec<f64> = values.windows(2).map(|pair| (pair[1] - pair[0]).max(0.0)).collect();
    let (low, high) = values.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(*v), high.max(*v)));
    if high - low < 12.0 {
        return None;
    }
    // A window about the steepest rise, moved until its middle is the mean of the rises in it.
    let steepest = (0..rises.len()).max_by(|a, b| rises[*a].total_cmp(&rises[*b]))?;
    let (mut middle, mut width) = (steepest as f64 + 0.5, 0.0);
    for _ in 0..6 {
        let (mut sum, mut moment, mut second) = (0.0, 0.0, 0.0);
        for (i, rise) in rises.iter().enumerate() {
            // Rise i lies from i to i + 1; the part of it inside the window counts.
            let (from, to) = ((i as f64).max(middle - WINDOW), (i as f64 + 1.0).min(middle + WINDOW));
            if to > from {
                sum += rise * (to - from);
                moment += rise * (to - from) * 0.5 * (from + to);
                second += rise * (to - from) * (0.5 * (from + to)).powi(2);
            }
        }
        if sum <= 0.0 {
            return None;
        }
        middle = moment / sum;
        width = (second / sum - middle * middle).max(0.0).sqrt();
    }
    (WINDOW * 0.5..rises.len() as f64 - WINDOW * 0.5)
        .contains(&middle)
        .then(|| (place(middle), width * REACH / SAMPLES as f64))
}

/// The edge along places on it.
fn line(points: &[Point]) -> Option<Edge> {
    let n = points.len() as f64;
    let Line { on, along, across, size } = Line::through(points.iter().map(|point| (*point, 1.0)));
    let spread = (across / (n - 2.0).max(1.0)).sqrt();
    // At the ends of a line its place is half as sure as in the middle.
    (size > 0.0).then_some(Edge { on, along, deviation: 2.0 * spread / n.sqrt(), blur: 0.0 })
}

/// A straight line with least squares across.
pub(super) struct Line {
    /// The mean of the places, and the direction of length one.
    pub on: Point,
    pub along: Vector,
    /// The weighted sum of the squares of distances from it.
    pub across: f64,
    /// That of the distances from the mean.
    size: f64,
}

impl Line {
    /// The line through places with their weights.
    pub(super) fn through(points: impl Iterator<Item = (Point, f64)> + Clone) -> Line {
        let total: f64 = points.clone().map(|(_, weight)| weight).sum();
        let on = Point::from(points.clone().map(|(point, weight)| point.coords * weight).sum::<Vector>() / total);
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for (point, weight) in points.clone() {
            let d = point - on;
            (xx, xy, yy) = (xx + weight * d.x * d.x, xy + weight * d.x * d.y, yy + weight * d.y * d.y);
        }
        let angle = 0.5 * libm::atan2(2.0 * xy, xx - yy);
        let along = Vector::new(libm::cos(angle), libm::sin(angle));
        let across = points.map(|(point, weight)| weight * cross(along, point - on).powi(2)).sum();
        Line { on, along, across, size: xx + yy }
    }
}
