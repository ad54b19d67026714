//! Straight pencil lines on paper, and where they cross.

use super::edges::Line;
use super::picture::Paper;
use crate::geometry::{Point, Vector, cross};

/// Standard deviation of the smoothing with which lines are looked for, in mm: near that of a pencil line.
const SMOOTH: f64 = 0.22;
/// Least curvature of darkness across a line, per mm².
const RIDGE: f32 = 0.55;
/// Least curvature from which a line is begun.
const BEGIN: f32 = 0.9;
/// Most difference of direction inside a line, in radians.
const ALIGNED: f64 = 0.24;
/// Standard deviation across from which places are no single line, in mm.
const WIDE: f64 = 0.32;
/// Least length of a line, in mm.
const SHORT: f64 = 1.6;
/// Most gap between two parts of one line, in mm: where others cross it.
const GAP: f64 = 5.0;
/// Most distance of two parts of one line from their common line, in mm.
const ASIDE: f64 = 0.22;

/// Steps along a line in which its ink is followed to where it ends, in mm; how far at most; and how dark it is still, as a part of the line's.
const STEP: f64 = 0.1;
const FARTHEST: f64 = 4.0;
const STILL_DARK: f64 = 0.45;

/// A straight line drawn by pencil; places in mm on the sheet.
#[derive(Clone, Copy, Debug)]
pub struct Stroke {
    /// Its ends.
    pub ends: [Point; 2],
    /// Standard deviation of its places across, in mm.
    pub deviation: f64,
    /// Mean darkness along it.
    pub dark: f64,
}

impl Stroke {
    /// Its direction, of length one.
    #[must_use]
    pub fn along(&self) -> Vector {
        let [from, to] = self.ends;
        let (x, y) = (to.x - from.x, to.y - from.y);
        let length = (x * x + y * y).sqrt();
        Vector::new(x / length, y / length)
    }

    /// Its length, in mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        (self.ends[1] - self.ends[0]).norm()
    }

    /// Distance of a place from its line, to its left positive as the sheet is seen.
    #[must_use]
    pub fn aside(&self, at: Point) -> f64 {
        cross(self.along(), at - self.ends[0])
    }

    /// How far a place is beyond its ends; 0 between them.
    #[must_use]
    pub fn beyond(&self, at: Point) -> f64 {
        let along = self.along().dot(&(at - self.ends[0]));
        (-along).max(along - self.length()).max(0.0)
    }

    /// Where its line crosses another's.
    #[must_use]
    pub fn crossing(&self, other: &Stroke) -> Option<Point> {
        let sine = cross(self.along(), other.along());
        (sine.abs() > 1e-6)
            .then(|| self.ends[0] + self.along() * (cross(other.ends[0] - self.ends[0], other.along()) / sine))
    }
}

/// The straight pencil lines on paper.
pub(super) fn strokes(paper: &Paper) -> Vec<Stroke> {
    let ridges = ridges(paper);
    let mut parts = grown(paper, &ridges);
    joined(&mut parts);
    parts.into_iter().filter_map(|part| part.stroke(paper)).filter(|stroke| stroke.length() >= SHORT).collect()
}

/// By place: how strongly darkness is curved across a line through it, and the line's direction in [0, π).
struct Ridges {
    strength: Vec<f32>,
    direction: Vec<f32>,
}

/// Curvatures of the smoothed darkness (Steger 1998).
fn ridges(paper: &Paper) -> Ridges {
    let [width, height] = paper.size;
    let sigma = SMOOTH / paper.step;
    let radius = (3.0 * sigma).ceil() as usize;
    let offsets = || (0..=2 * radius).map(|i| i as f64 - radius as f64);
    let bell = |x: f64| libm::exp(-0.5 * x * x / (sigma * sigma));
    let sum: f64 = offsets().map(bell).sum();
    let smooth: Vec<f32> = offsets().map(|x| (bell(x) / sum) as f32).collect();
    let slope: Vec<f32> = offsets().map(|x| (-x / (sigma * sigma) * bell(x) / sum) as f32).collect();
    let curve: Vec<f32> =
        offsets().map(|x| ((x * x / (sigma * sigma) - 1.0) / (sigma * sigma) * bell(x) / sum) as f32).collect();
    // Uniform darkness has no curvature; ignore it.
    let mean = curve.iter().sum::<f32>() / curve.len() as f32;
    let curve: Vec<f32> = curve.iter().map(|c| c - mean).collect();
    let mut strength = vec![0.0_f32; width * height];
    let mut direction = vec![0.0_f32; width * height];
    if width <= 2 * radius || height <= 2 * radius {
        return Ridges { strength, direction };
    }
    let dark = &paper.dark;
    let scale = (1.0 / (paper.step * paper.step)) as f32;
    let mut columns = [vec![0.0_f32; width], vec![0.0_f32; width], vec![0.0_f32; width]];
    for y in radius..height - radius {
        for (column, kernel) in columns.iter_mut().zip([&smooth, &slope, &curve]) {
            column.fill(0.0);
            for (i, weight) in kernel.iter().enumerate() {
                let row = &dark[(y + i - radius) * width..][..width];
                column.iter_mut().zip(row).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        let [smoothed, sloped, curved] = &columns;
        for x in radius..width - radius {
            let across = |column: &[f32], kernel: &[f32]| -> f32 {
                column[x - radius..=x + radius].iter().zip(kernel).map(|(a, b)| a * b).sum()
            };
            let yy = across(curved, &smooth) * scale;
            let xx = across(smoothed, &curve) * scale;
            // A dark line has a negative curvature across; what is no line is passed over quickly.
            if xx + yy > -RIDGE {
                continue;
            }
            let xy = across(sloped, &slope) * scale;
            let (half, mean) = (libm::hypotf(0.5 * (xx - yy), xy), 0.5 * (xx + yy));
            let (least, most) = (mean - half, mean + half);
            if -least > RIDGE && most > 0.6 * least {
                // The direction of the line is that of the least curved: square to the most curved.
                let angle = 0.5 * libm::atan2f(2.0 * xy, xx - yy);
                strength[y * width + x] = -least;
                direction[y * width + x] = angle;
            }
        }
    }
    Ridges { strength, direction }
}

/// Places that belong to one line, weighted by how strongly it shows there: their mean, the direction of the line, its ends
/// from the mean, and the standard deviation across.
#[derive(Clone, Debug)]
struct Segment {
    points: Vec<(Point, f64)>,
    mean: Point,
    along: Vector,
    from: f64,
    to: f64,
    across: f64,
}

/// Grows lines from the strongest places, through neighbours of their direction (Grompone von Gioi et al. 2010).
fn grown(paper: &Paper, ridges: &Ridges) -> Vec<Segment> {
    let [width, height] = paper.size;
    let mut order: Vec<usize> = (0..width * height).filter(|i| ridges.strength[*i] > BEGIN).collect();
    order.sort_by(|a, b| ridges.strength[*b].total_cmp(&ridges.strength[*a]).then(a.cmp(b)));
    let mut is_used = vec![false; width * height];
    let mut parts = Vec::new();
    let mut region: Vec<usize> = Vec::new();
    for seed in order {
        if is_used[seed] {
            continue;
        }
        region.clear();
        region.push(seed);
        is_used[seed] = true;
        let first = f64::from(ridges.direction[seed]);
        let mut sum = Vector::new(libm::cos(2.0 * first), libm::sin(2.0 * first));
        let mut next = 0;
        while next < region.len() {
            let (x, y) = (region[next] % width, region[next] / width);
            next += 1;
            let mean = 0.5 * libm::atan2(sum.y, sum.x);
            for (nx, ny) in [
                (x, y - 1),
                (x, y + 1),
                (x - 1, y),
                (x + 1, y),
                (x - 1, y - 1),
                (x + 1, y - 1),
                (x - 1, y + 1),
                (x + 1, y + 1),
            ] {
                let neighbour = ny * width + nx;
                if is_used[neighbour] || ridges.strength[neighbour] == 0.0 {
                    continue;
                }
                let own = f64::from(ridges.direction[neighbour]);
                let off = libm::remainder(own - mean, std::f64::consts::PI).abs();
                if off < ALIGNED {
                    is_used[neighbour] = true;
                    region.push(neighbour);
                    sum += Vector::new(libm::cos(2.0 * own), libm::sin(2.0 * own));
                }
            }
        }
        if (region.len() as f64) * paper.step < 0.8 {
            continue;
        }
        let at = |index: &usize| {
            let (x, y) = ((index % width) as f64 + 0.5, (index / width) as f64 + 0.5);
            let place = Point::new(paper.corner[0] + x * paper.step, paper.corner[1] + y * paper.step);
            (place, f64::from(ridges.strength[*index]))
        };
        let mut part = Segment::of(region.iter().map(at).collect());
        if part.across > WIDE {
            // Lines that run together at a small angle: one of them is that through the first place; the others are found from theirs.
            let own = one_line(&region, &at, first);
            region.iter().for_each(|index| is_used[*index] = false);
            is_used[seed] = true;
            own.iter().for_each(|index| is_used[*index] = true);
            part = Segment::of(own.iter().map(at).collect());
        }
        if part.across < WIDE && part.to - part.from > 0.8 && part.to - part.from > 3.0 * part.across {
            parts.push(part);
        }
    }
    parts
}

/// The places of a region that lie on one line through its first place, which has that direction there.
fn one_line(region: &[usize], at: &impl Fn(&usize) -> (Point, f64), direction: f64) -> Vec<usize> {
    let mut line = (at(&region[0]).0, Vector::new(libm::cos(direction), libm::sin(direction)));
    let mut own = vec![region[0]];
    // First near the first place, where its direction is sure, then farther and farther out.
    for reach in [2.0, 4.0, 8.0, 16.0, 40.0, 500.0] {
        let is_near = |index: &&usize| {
            let off = at(index).0 - line.0;
            cross(line.1, off).abs() < WIDE && off.norm() < reach
        };
        own = region.iter().filter(is_near).copied().collect();
        let part = Segment::of(own.iter().map(at).collect());
        if part.to - part.from > 1.0 {
            line.1 = part.along;
            line.0 = part.mean + part.along * part.along.dot(&(line.0 - part.mean));
        }
    }
    own
}

impl Segment {
    fn of(points: Vec<(Point, f64)>) -> Segment {
        let Line { on: mean, along, across, .. } = Line::through(points.iter().copied());
        let total: f64 = points.iter().map(|(_, weight)| weight).sum();
        let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
        for (point, _) in &points {
            let place = along.dot(&(point - mean));
            (from, to) = (from.min(place), to.max(place));
        }
        Segment { points, mean, along, from, to, across: (across / total).sqrt() }
    }

    fn ends(&self) -> [Point; 2] {
        [self.mean + self.along * self.from, self.mean + self.along * self.to]
    }

    /// Whether another segment lies on the same line, near enough to be a part of it.
    fn continues(&self, other: &Segment) -> bool {
        let (long, short) = if self.to - self.from >= other.to - other.from { (self, other) } else { (other, self) };
        let sine = cross(long.along, short.along).abs();
        let length = short.to - short.from;
        if sine > (0.5 * ASIDE / length.max(0.4)).clamp(0.05, 0.3) {
            return false;
        }
        let [a, b] = short.ends().map(|end| long.along.dot(&(end - long.mean)));
        let gap = (a.min(b) - long.to).max(long.from - a.max(b));
        let limit = GAP.min(0.4 * (long.to - long.from + length));
        let aside = cross(long.along, short.mean - long.mean).abs();
        // Far from a short line its direction is not sure.
        let reach = long.along.dot(&(short.mean - long.mean)).abs() - 0.5 * (long.to - long.from);
        let unsure = 0.02 * reach.max(0.0);
        gap < limit && gap > -0.6 * length && aside < ASIDE + unsure.min(0.15)
    }

    /// The line through the darkest places across it, and where it begins and ends.
    fn stroke(&self, paper: &Paper) -> Option<Stroke> {
        let normal = Vector::new(-self.along.y, self.along.x);
        let step = 0.2;
        let count = ((self.to - self.from) / step).ceil() as usize;
        let mut found: Vec<(f64, f64, f64)> = Vec::with_capacity(count);
        for i in 0..=count {
            let along = self.from + (self.to - self.from) * i as f64 / count.max(1) as f64;
            let on = self.mean + self.along * along;
            let profile: [f64; 13] = std::array::from_fn(|k| {
                let place = on + normal * (0.1 * (k as f64 - 6.0));
                paper.at(place.x, place.y)
            });
            let floor = 0.5 * (profile[0].min(profile[1]) + profile[11].min(profile[12]));
            let (mut weight, mut moment, mut most) = (0.0, 0.0, 0.0_f64);
            for (k, value) in profile.iter().enumerate().skip(1).take(11) {
                let dark = (value - floor - 0.02).max(0.0);
                weight += dark;
                moment += dark * 0.1 * (k as f64 - 6.0);
                most = most.max(dark);
            }
            if most > 0.05 {
                found.push((along, moment / weight, most));
            }
        }
        if found.len() < 4 {
            return None;
        }
        let mut fit = (0.0, 0.0, 0.0);
        for _ in 0..3 {
            let n = found.len() as f64;
            let mean = found.iter().map(|f| f.0).sum::<f64>() / n;
            let offset = found.iter().map(|f| f.1).sum::<f64>() / n;
            let (mut xx, mut xy) = (0.0, 0.0);
            for (x, y, _) in &found {
                xx += (x - mean).powi(2);
                xy += (x - mean) * (y - offset);
            }
            let slope = if xx > 0.0 { xy / xx } else { 0.0 };
            let line = |x: f64| offset + slope * (x - mean);
            let spread = (found.iter().map(|f| (f.1 - line(f.0)).powi(2)).sum::<f64>() / (n - 2.0).max(1.0)).sqrt();
            fit = (offset - slope * mean, slope, spread);
            let before = found.len();
            found.retain(|f| (f.1 - line(f.0)).abs() <= (2.0 * spread).max(0.06));
            if found.len() == before || found.len() < 4 {
                break;
            }
        }
        let (offset, slope, spread) = fit;
        let at = |x: f64| self.mean + self.along * x + normal * (offset + slope * x);
        let dark = found.iter().map(|f| f.2).sum::<f64>() / found.len().max(1) as f64;
        // Samples 0.2 mm apart share the grain of one pencil line.
        let deviation = 2.0 * spread / (found.len() as f64 / 3.0).max(1.0).sqrt();
        // In the tip of an arrowhead three lines are one blot: the ink goes on where no line is seen any more.
        let is_dark = |x: f64| {
            let places = [-0.15, 0.0, 0.15].map(|aside| at(x) + normal * aside);
            places.iter().any(|place| paper.at(place.x, place.y) > STILL_DARK * dark)
        };
        let beyond = |from: f64, step: f64| {
            let steps = (1..=(FARTHEST / STEP) as usize).take_while(|i| is_dark(from + step * *i as f64)).count();
            from + step * steps as f64
        };
        let ends = [at(beyond(self.from, -STEP)), at(beyond(self.to, STEP))];
        Some(Stroke { ends, deviation, dark })
    }
}

/// Joins parts of one line that others interrupt.
fn joined(parts: &mut Vec<Segment>) {
    parts.sort_by(|a, b| (b.to - b.from).total_cmp(&(a.to - a.from)));
    let mut i = 0;
    while i < parts.len() {
        let mut is_changed = false;
        let mut j = i + 1;
        while j < parts.len() {
            if parts[i].continues(&parts[j]) {
                let other = parts.remove(j);
                let points = std::mem::take(&mut parts[i].points);
                parts[i] = Segment::of(points.into_iter().chain(other.points).collect());
                is_changed = true;
            } else {
                j += 1;
            }
        }
        if !is_changed {
            i += 1;
        }
    }
}

/// Least sine between lines whose crossing is a place.
const SINE: f64 = 0.2;
/// Least length of a line, in mm: the legs of arrowheads and letters are shorter.
const LONG: f64 = 4.5;
/// How far a line may end before the crossing, in mm and as a part of its length: in an arrowhead it is no line any more.
const ENDS: f64 = 3.2;
const AHEAD: f64 = 0.25;
/// Least standard deviation of a crossing, in mm: pencil lines are not straight to less.
const LEAST: f64 = 0.04;
/// Crossings that are worse than the best one by less than this, in mm, may be the one that is meant.
const RIVAL: f64 = 0.5;

/// A crossing of pencil lines.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// Where it is on the sheet, in mm.
    pub at: Point,
    /// Radius that holds it with 95 %, in mm: of the lines alone; where others are as near, these are in it.
    pub band: f64,
    /// How many lines meet there.
    pub lines: usize,
}

/// The crossing of pencil lines nearest to a place, within `reach` mm; both lines reach it nearly. Of crossings about as near that of more and longer lines is taken.
#[must_use]
pub fn crossing(strokes: &[Stroke], near: Point, reach: f64) -> Option<Crossing> {
    let is_close = |s: &&Stroke| s.length() > LONG && s.aside(near).abs() < reach && s.beyond(near) < reach + ENDS;
    let close: Vec<&Stroke> = strokes.iter().filter(is_close).collect();
    let mut all: Vec<(f64, Crossing)> = Vec::new();
    for (i, a) in close.iter().enumerate() {
        for b in &close[i + 1..] {
            let Some(at) = a.crossing(b) else { continue };
            let sine = cross(a.along(), b.along()).abs();
            let distance = (at - near).norm();
            let [beyond_a, beyond_b] = [a, b].map(|line| line.beyond(at) / (AHEAD * line.length()).min(ENDS));
            let beyond = beyond_a.max(beyond_b);
            if sine < SINE || distance > reach || beyond > 1.0 {
                continue;
            }
            let lines = close.iter().filter(|s| s.aside(at).abs() < 0.4 && s.beyond(at) < 1.0).count();
            let band = 2.45 * libm::hypot(libm::hypot(a.deviation, b.deviation) / sine, LEAST);
            let length = a.length().min(b.length()).min(10.0);
            let worse = distance + beyond - 0.2 * (lines.min(4) as f64) - 0.05 * length;
            all.push((worse, Crossing { at, band, lines }));
        }
    }
    let (least, best) = all.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let rivals = all.iter().filter(|(worse, _)| *worse < least + RIVAL);
    let band = rivals.map(|(_, rival)| (rival.at - best.at).norm()).fold(best.band, f64::max);
    Some(Crossing { band, ..best })
}
