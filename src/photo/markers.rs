//! Which dark squares are markers, and which of them stand together on one sheet.

use super::picture::Picture;
use super::squares::squares;
use crate::drawing::markers::{CELLS, CODES, INNER, pages, places};
use crate::geometry::Point;
use crate::scene::Page;
use nalgebra::{Matrix3, SMatrix};

/// Longer side of the picture in which markers are looked for, in pixels; their edges are found in the whole one.
const WORKING: usize = 1700;
/// Least number of markers of a sheet.
pub(super) const LEAST: usize = 4;
/// Cells in which a code may differ from that of its marker: codes differ in six.
const WRONG_CELLS: u32 = 2;
/// Least difference of brightness between paper and print.
const CONTRAST: f64 = 18.0;
/// How far a corner may be from where the others let expect it, in sides of its marker.
const APART: f64 = 0.9;

/// The corners of a marker on its page, in mm, clockwise from the upper left one.
pub(super) fn corners(page: Page, number: usize) -> [Point; 4] {
    let place = places(page.size_mm())[number];
    [(place.x0, place.y0), (place.x1, place.y0), (place.x1, place.y1), (place.x0, place.y1)]
        .map(|(x, y)| Point::new(x, y))
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Marker {
    /// Its number: its place on the sheet.
    pub number: usize,
    /// Its corners, from its own upper left one, clockwise.
    pub corners: [Point; 4],
}

/// The markers of one sheet in a picture, and its page.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    pub page: Page,
    pub markers: Vec<Marker>,
    /// The places of corners on the sheet, in mm, and in the picture: roughly.
    pub plane: Homography,
}

impl Seen {
    /// Whether a marker is one of these, or where one of these is.
    pub(super) fn has(&self, marker: &Marker) -> bool {
        self.markers.iter().any(|own| (own.corners[0] - marker.corners[0]).norm() < 2.0 * own.side())
    }
}

impl Marker {
    /// The pairs of corners on a page and in the picture.
    fn pairs(&self, page: Page) -> impl Iterator<Item = (Point, Point)> {
        corners(page, self.number).into_iter().zip(self.corners)
    }

    fn side(&self) -> f64 {
        (self.corners[0] - self.corners[2]).norm().max((self.corners[1] - self.corners[3]).norm())
            / std::f64::consts::SQRT_2
    }
}

/// The markers in a picture. They are looked for in a smaller one; a sheet far away has small markers, so where some are missing in one of twice that size,
/// too.
pub(super) fn markers(picture: &Picture) -> Vec<Marker> {
    let factor = picture.width().max(picture.height()).div_ceil(WORKING);
    let mut found = markers_in(&picture.smaller(factor), factor);
    if factor > 1 && most_together(&found) < CODES.len() {
        add(&mut found, markers_in(&picture.smaller(factor / 2), factor / 2));
    }
    found
}

/// The markers in a picture, in places of the whole picture, which is `factor` times as large.
fn markers_in(small: &Picture, factor: usize) -> Vec<Marker> {
    let mut found: Vec<Marker> = Vec::new();
    for pass in 0..2 {
        add(&mut found, squares(small, pass).iter().filter_map(|square| read(small, square)).collect());
        if most_together(&found) == CODES.len() {
            break;
        }
    }
    for marker in &mut found {
        marker.corners = marker.corners.map(|corner| corner * factor as f64);
    }
    found
}

/// Adds further markers; those that are known already stay as they are.
fn add(found: &mut Vec<Marker>, further: Vec<Marker>) {
    for marker in further {
        let is_known = |other: &Marker| {
            other.number == marker.number && (other.corners[0] - marker.corners[0]).norm() < 0.5 * marker.side()
        };
        if !found.iter().any(is_known) {
            found.push(marker);
        }
    }
}

/// The marker in a dark square, if it is one.
fn read(picture: &Picture, square: &[Point; 4]) -> Option<Marker> {
    let unit = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y));
    let pairs: Vec<(Point, Point)> = unit.into_iter().zip(*square).collect();
    let plane = Homography::through(&pairs)?;
    let cells = CELLS as f64;
    // Brightness round the centre of a cell, which may lie outside.
    let cell = |x: i32, y: i32| {
        let near = [-0.2, 0.0, 0.2];
        let all = near.iter().flat_map(|dx| near.map(|dy| (dx, dy)));
        let sum: f64 = all
            .map(|(dx, dy)| {
                picture.at(plane.at(Point::new((f64::from(x) + 0.5 + dx) / cells, (f64::from(y) + 0.5 + dy) / cells)))
            })
            .sum();
        sum / 9.0
    };
    let last = CELLS as i32 - 1;
    let ring = |from: i32, to: i32| -> Vec<(i32, i32)> {
        let sides = (from..to).map(|i| [(i, from), (to, i), (to + from - i, to), (from, to + from - i)]);
        sides.flatten().collect()
    };
    let mut white: Vec<f64> = ring(-1, last + 1).into_iter().map(|(x, y)| cell(x, y)).collect();
    let mut black: Vec<f64> = ring(0, last).into_iter().map(|(x, y)| cell(x, y)).collect();
    white.sort_by(f64::total_cmp);
    black.sort_by(f64::total_cmp);
    let [light, dark] = [white[white.len() / 2], black[black.len() / 2]];
    let contrast = light - dark;
    let middle = 0.5 * (light + dark);
    let is_framed = black.iter().filter(|v| **v < middle).count() + 1 >= black.len()
        && white.iter().filter(|v| **v > middle).count() + 6 >= white.len();
    if contrast < CONTRAST || dark > 0.82 * light || !is_framed {
        return None;
    }
    let mut bits = [[false; INNER]; INNER];
    for (y, row) in bits.iter_mut().enumerate() {
        for (x, bit) in row.iter_mut().enumerate() {
            *bit = cell(x as i32 + 1, y as i32 + 1) < middle;
        }
    }
    let mut best: Option<(u32, usize, usize)> = None;
    for turn in 0..4 {
        let code = bits.iter().flatten().fold(0_u16, |code, bit| code << 1 | u16::from(*bit));
        for (number, own) in CODES.iter().enumerate() {
            let wrong = (code ^ own).count_ones();
            if best.is_none_or(|(least, ..)| wrong < least) {
                best = Some((wrong, number, turn));
            }
        }
        // A quarter turn to the left: what was the upper right corner is the upper left one.
        bits = std::array::from_fn(|y| std::array::from_fn(|x| bits[x][3 - y]));
    }
    let (wrong, number, turn) = best?;
    (wrong <= WRONG_CELLS).then(|| Marker { number, corners: std::array::from_fn(|i| square[(i + turn) % 4]) })
}

/// The largest set of markers that can stand on one sheet, for every page on which it can; at least [`LEAST`] markers.
pub(super) fn sheets(markers: &[Marker]) -> Vec<Seen> {
    let mut all: Vec<Seen> = pages().filter_map(|page| largest(markers, page)).collect();
    let most = all.iter().map(|seen| seen.markers.len()).max().unwrap_or(0);
    all.retain(|seen| seen.markers.len() == most);
    all
}

/// Most markers that are tried together.
const TRIED: usize = 24;

/// The largest set on a page: of those that two or three markers let expect.
fn largest(markers: &[Marker], page: Page) -> Option<Seen> {
    let mut best: Option<(f64, Seen)> = None;
    let few = &markers[..markers.len().min(TRIED)];
    let mut try_with = |seed: &[&Marker]| {
        let mut pairs: Vec<(Point, Point)> = seed.iter().flat_map(|marker| marker.pairs(page)).collect();
        let mut chosen: Vec<(f64, Marker)> = Vec::new();
        let mut plane = None;
        for _ in 0..4 {
            let Some(map) = Homography::through(&pairs) else { return };
            chosen = (0..CODES.len())
                .filter_map(|number| {
                    let own = markers.iter().filter(|marker| marker.number == number);
                    let rated = own.map(|marker| {
                        let error = marker.pairs(page).map(|(mm, px)| (map.at(mm) - px).norm()).fold(0.0, f64::max);
                        (error / marker.side(), *marker)
                    });
                    rated.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(error, _)| *error < APART)
                })
                .collect();
            plane = Some(map);
            pairs = chosen.iter().flat_map(|(_, marker)| marker.pairs(page)).collect();
        }
        let error = chosen.iter().map(|(error, _)| error).sum::<f64>() / chosen.len().max(1) as f64;
        let worth = chosen.len() as f64 - error;
        if let Some(plane) = plane
            && chosen.len() >= LEAST
            && best.as_ref().is_none_or(|(most, _)| worth > *most)
        {
            best = Some((worth, Seen { page, markers: chosen.into_iter().map(|(_, marker)| marker).collect(), plane }));
        }
    };
    for (i, a) in few.iter().enumerate() {
        for (j, b) in few.iter().enumerate().skip(i + 1).filter(|(_, b)| b.number != a.number) {
            try_with(&[a, b]);
            for c in few[j + 1..].iter().filter(|c| c.number != a.number && c.number != b.number) {
                if few.len() <= 12 {
                    try_with(&[a, b, c]);
                }
            }
        }
    }
    best.map(|(_, seen)| seen)
}

/// How many markers with different numbers there are.
pub(super) fn most_together(markers: &[Marker]) -> usize {
    (0..CODES.len()).filter(|number| markers.iter().any(|marker| marker.number == *number)).count()
}

/// Whether markers that are too few to be a sheet let expect most of the others outside of the picture.
pub(super) fn ends_early(found: &[Marker], picture: &Picture) -> bool {
    let is_single = |marker: &&Marker| found.iter().filter(|other| other.number == marker.number).count() == 1;
    let own: Vec<&Marker> = found.iter().filter(is_single).collect();
    let ends = |page: Page| {
        let pairs: Vec<(Point, Point)> = own.iter().flat_map(|marker| marker.pairs(page)).collect();
        let Some(plane) = Homography::through(&pairs) else { return false };
        let fits = pairs.iter().all(|(mm, px)| (plane.at(*mm) - px).norm() < APART * own[0].side());
        let missing = (0..CODES.len()).filter(|number| own.iter().all(|marker| marker.number != *number));
        let is_outside = |number: &usize| corners(page, *number).iter().any(|corner| !picture.holds(plane.at(*corner)));
        let (outside, inside): (Vec<usize>, Vec<usize>) = missing.partition(is_outside);
        fits && outside.len() > inside.len()
    };
    own.len() > 1 && pages().any(ends)
}

/// Places of one plane to places of another, with straight lines kept straight: a homography.
#[derive(Clone, Copy, Debug)]
pub(super) struct Homography(pub Matrix3<f64>);

impl Homography {
    /// The homography that takes the first of each pair nearest to the second, by the direct linear transformation with both sides scaled (Hartley 1997);
    /// `None` for fewer than four pairs or where they leave it open.
    pub(super) fn through(pairs: &[(Point, Point)]) -> Option<Homography> {
        if pairs.len() < 4 {
            return None;
        }
        let (from, to) = (scaling(pairs.iter().map(|pair| pair.0))?, scaling(pairs.iter().map(|pair| pair.1))?);
        let mut normal = [[0.0; 9]; 9];
        for (a, b) in pairs {
            let (a, b) = (Homography(from).at(*a), Homography(to).at(*b));
            for row in [
                [a.x, a.y, 1.0, 0.0, 0.0, 0.0, -b.x * a.x, -b.x * a.y, -b.x],
                [0.0, 0.0, 0.0, a.x, a.y, 1.0, -b.y * a.x, -b.y * a.y, -b.y],
            ] {
                for (sums, own) in normal.iter_mut().zip(&row) {
                    for (sum, other) in sums.iter_mut().zip(&row) {
                        *sum += own * other;
                    }
                }
            }
        }
        let eigen = SMatrix::<f64, 9, 9>::from(normal).symmetric_eigen();
        let mut order: Vec<usize> = (0..9).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        // A second solution beside the first: the places are in line.
        if eigen.eigenvalues[order[1]] < 1e-9 * eigen.eigenvalues[order[8]] {
            return None;
        }
        let h = eigen.eigenvectors.column(order[0]);
        let scaled = Matrix3::from_fn(|i, j| h[3 * i + j]);
        Some(Homography(to.try_inverse()? * scaled * from)).filter(|h| h.0.iter().all(|x| x.is_finite()))
    }

    pub(super) fn at(&self, point: Point) -> Point {
        let (map, x, y) = (&self.0, point.x, point.y);
        let far = map.m31 * x + map.m32 * y + map.m33;
        Point::new((map.m11 * x + map.m12 * y + map.m13) / far, (map.m21 * x + map.m22 * y + map.m23) / far)
    }
}

/// Brings places to a mean of zero and a mean distance of √2.
fn scaling(points: impl Iterator<Item = Point> + Clone) -> Option<Matrix3<f64>> {
    let count = points.clone().count() as f64;
    let mean = points.clone().map(|p| p.coords).sum::<nalgebra::Vector2<f64>>() / count;
    let spread = points.map(|p| (p.coords - mean).norm()).sum::<f64>() / count;
    let scale = std::f64::consts::SQRT_2 / spread;
    let matrix = Matrix3::new(scale, 0.0, -scale * mean.x, 0.0, scale, -scale * mean.y, 0.0, 0.0, 1.0);
    scale.is_finite().then_some(matrix)
}
