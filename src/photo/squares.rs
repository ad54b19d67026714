//! Dark figures with four corners: what may be a marker.

use super::picture::Picture;
use crate::geometry::{Point, cross, hull};
use indexmap::IndexMap;
use petgraph::unionfind::UnionFind;

/// Share of the mean brightness around it below which a pixel is dark.
const DARK: [u64; 2] = [74, 88];
/// Radii of the area round a pixel whose mean counts, as parts of the picture's longer side.
const AROUND: [usize; 2] = [28, 60];
/// Least side of a figure, in pixels.
const LEAST: f64 = 9.0;
/// What pixels add to the outline of a square that stands on edge, for each of its length, in pixels.
const ROUND: f64 = 0.4;
/// Most corners of an outline that are looked at.
const CORNERS: usize = 40;

/// The dark figures of a picture that have nearly four corners, each clockwise as it is seen. `pass` 0 is for usual light, 1 for faint print and blur.
pub(super) fn squares(picture: &Picture, pass: usize) -> Vec<[Point; 4]> {
    let (width, height) = (picture.width(), picture.height());
    let radius = (width.max(height) / AROUND[pass]).max(4);
    let sums = sums(picture);
    let mut runs: Vec<Run> = Vec::new();
    let mut touching: Vec<[usize; 2]> = Vec::new();
    let mut before = 0..0;
    for y in 0..height {
        let (y0, y1) = (y.saturating_sub(radius), (y + radius + 1).min(height));
        let (above, below) = (&sums[y0 * (width + 1)..], &sums[y1 * (width + 1)..]);
        let row = picture.row(y);
        let begin = runs.len();
        let mut open: Option<usize> = None;
        for (x, &pixel) in row.iter().enumerate() {
            let (x0, x1) = (x.saturating_sub(radius), (x + radius + 1).min(width));
            let sum = u64::from(below[x1].wrapping_sub(below[x0]).wrapping_sub(above[x1].wrapping_sub(above[x0])));
            let area = ((x1 - x0) * (y1 - y0)) as u64;
            let is_dark = u64::from(pixel) * area * 100 < sum * DARK[pass];
            match (is_dark, open) {
                (true, None) => open = Some(x),
                (false, Some(from)) => {
                    runs.push(Run { y, from, to: x });
                    open = None;
                }
                _ => {}
            }
        }
        runs.extend(open.map(|from| Run { y, from, to: width }));
        // Runs that touch one of the row above belong to its part, be it by a corner: frames that stand on edge are thin.
        let mut first = before.start;
        for run in begin..runs.len() {
            while first < before.end && runs[first].to < runs[run].from {
                first += 1;
            }
            let touched = (first..before.end).take_while(|&other| runs[other].from <= runs[run].to);
            touching.extend(touched.map(|other| [run, other]));
        }
        before = begin..runs.len();
    }
    let most = width.max(height) / 4;
    parts(&runs, &touching).iter().filter_map(|part| part.corners(most)).collect()
}

/// Sums of all pixels above and to the left, with a first row and column of zeros. They wrap: only differences count.
fn sums(picture: &Picture) -> Vec<u32> {
    let width = picture.width() + 1;
    let mut sums = vec![0_u32; width * (picture.height() + 1)];
    for y in 0..picture.height() {
        let (above, below) = sums[y * width..][..2 * width].split_at_mut(width);
        let mut sum = 0_u32;
        for (x, &pixel) in picture.row(y).iter().enumerate() {
            sum = sum.wrapping_add(u32::from(pixel));
            below[x + 1] = above[x + 1].wrapping_add(sum);
        }
    }
    sums
}

/// Dark pixels side by side in one row.
struct Run {
    y: usize,
    from: usize,
    to: usize,
}

/// Dark pixels that hang together: the ends of their runs, by row, and their number.
#[derive(Default)]
struct Part {
    /// By row from `top`: the leftmost pixel and the one after the rightmost.
    ends: Vec<[u32; 2]>,
    top: usize,
    count: usize,
}

/// The parts that runs make, given row by row, of which some touch.
fn parts(runs: &[Run], touching: &[[usize; 2]]) -> Vec<Part> {
    let mut joined = UnionFind::new(runs.len());
    for &[one, other] in touching {
        joined.union(one, other);
    }
    let mut parts: IndexMap<usize, Part> = IndexMap::new();
    for (run, label) in runs.iter().zip(joined.into_labeling()) {
        let part = parts.entry(label).or_insert_with(|| Part { top: run.y, ..Part::default() });
        part.ends.resize(run.y + 1 - part.top, [u32::MAX, 0]);
        let ends = &mut part.ends[run.y - part.top];
        *ends = [ends[0].min(run.from as u32), ends[1].max(run.to as u32)];
        part.count += run.to - run.from;
    }
    parts.into_values().collect()
}

impl Part {
    /// The four corners, if there are four and the part is as large and as full as a marker.
    fn corners(&self, most: usize) -> Option<[Point; 4]> {
        let height = self.ends.len();
        let left = self.ends.iter().map(|ends| ends[0]).min()? as usize;
        let right = self.ends.iter().map(|ends| ends[1]).max()? as usize;
        let width = right.saturating_sub(left);
        let is_size = |side: usize| side as f64 >= LEAST && side <= most;
        if !is_size(width)
            || !is_size(height)
            || width > 4 * height
            || height > 4 * width
            || 4 * self.count < width * height
        {
            return None;
        }
        let hull = self.hull();
        let quad = widest(&hull)?;
        let filled = self.count as f64 / area(&quad);
        let sides: [f64; 4] = std::array::from_fn(|i| (quad[(i + 1) % 4] - quad[i]).norm());
        let (short, long) = sides.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), s| (a.min(*s), b.max(*s)));
        let is_square = short >= LEAST
            && long <= 3.5 * short
            && area(&quad) + ROUND * sides.iter().sum::<f64>() >= 0.84 * area(&hull)
            && (0.42..1.1).contains(&filled);
        is_square.then_some(quad)
    }

    /// The convex outline of its pixels, clockwise as it is seen.
    fn hull(&self) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::with_capacity(4 * self.ends.len());
        for (row, ends) in self.ends.iter().enumerate() {
            let y = (self.top + row) as f64;
            for x in ends {
                points.extend([Point::new(f64::from(*x), y), Point::new(f64::from(*x), y + 1.0)]);
            }
        }
        let mut hull = hull(points, |[a, b, c]| cross(b - a, c - b) > 0.0);
        // Corners that cut off least are left out.
        while hull.len() > CORNERS {
            let n = hull.len();
            let cut = |i: usize| cross(hull[i] - hull[(i + n - 1) % n], hull[(i + 1) % n] - hull[i]).abs();
            let least = (0..n).min_by(|a, b| cut(*a).total_cmp(&cut(*b))).unwrap_or(0);
            hull.remove(least);
        }
        hull
    }
}

fn area(outline: &[Point]) -> f64 {
    let n = outline.len();
    (0.5 * (0..n).map(|i| cross(outline[i].coords, outline[(i + 1) % n].coords)).sum::<f64>()).abs()
}

/// The largest figure with four corners of an outline.
fn widest(hull: &[Point]) -> Option<[Point; 4]> {
    let n = hull.len();
    if n < 4 {
        return None;
    }
    let mut best: Option<(f64, [usize; 4])> = None;
    for i in 0..n {
        for j in i + 2..n {
            // The corners farthest from the diagonal, on either side.
            let height = |k: usize| cross(hull[j] - hull[i], hull[k] - hull[i]).abs();
            let farthest =
                |range: &mut dyn Iterator<Item = usize>| range.max_by(|a, b| height(*a).total_cmp(&height(*b)));
            let (Some(a), Some(b)) = (farthest(&mut (i + 1..j)), farthest(&mut (j + 1..n).chain(0..i))) else {
                continue;
            };
            let size = height(a) + height(b);
            if best.is_none_or(|(most, _)| size > most) {
                best = Some((size, [i, a, j, b]));
            }
        }
    }
    best.map(|(_, corners)| corners.map(|corner| hull[corner]))
}
