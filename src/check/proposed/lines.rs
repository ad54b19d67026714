//! Which pencil line an operation has drawn, and where it ends.

use crate::geometry::{Point, Vector, cross};
use crate::photo::Stroke;

/// How far a line may be beside a place of which an operation says that it goes through: always, and for each mm from the place that it is drawn through.
const ASIDE: f64 = 0.6;
const ASIDE_PER_MM: f64 = 0.012;
/// Most of it, in mm.
const FARTHEST: f64 = 1.8;
/// Most difference of directions, in radians, and what is added to it for short lines, in mm.
const TURNED: f64 = 0.05;
const UNEVEN: f64 = 0.25;
/// How far a line may end before the place that it leads to, in mm.
const SHORT: f64 = 2.5;
/// How far from where it should be a vector's end is looked for, along its line, in mm.
const END: f64 = 1.7;
/// Distance within which signs of an end are one, in mm.
const SAME: f64 = 0.4;
/// Least length of what makes a line by itself, in mm; arrowheads and letters are shorter.
const LONG: f64 = 4.0;

/// A place that pencil lines show: from the pole, in mm, y up, with the radius that holds it with 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub at: Point,
    pub band: f64,
}

/// The line that was drawn along `along` through a place `far` mm from where it was begun, and how much it differs: 0 not at all, 1 as much as may be.
pub(super) fn drawn(strokes: &[Stroke], at: Point, along: Vector, far: f64) -> Option<(&Stroke, f64)> {
    let aside = (ASIDE + ASIDE_PER_MM * far).min(FARTHEST);
    let rated = strokes.iter().filter_map(|stroke| {
        let turned = cross(stroke.along(), along).abs() / (TURNED + UNEVEN / stroke.length());
        let off = stroke.aside(at).abs() / aside;
        let is_one = turned <= 1.0 && off <= 1.0 && stroke.beyond(at) <= SHORT && stroke.length() > 2.0;
        // Of lines that fit the longer is the likelier one.
        is_one.then(|| (stroke, libm::hypot(turned, off) * 0.7, off + turned - 0.03 * stroke.length().min(30.0)))
    });
    let best = rated.min_by(|a, b| a.2.total_cmp(&b.2))?;
    Some((best.0, best.1))
}

/// Where two lines cross.
pub(super) fn crossing(a: &Stroke, b: &Stroke) -> Option<Spot> {
    let at = a.crossing(b)?;
    let sine = cross(a.along(), b.along()).abs();
    Some(Spot { at, band: 2.45 * libm::hypot(libm::hypot(a.deviation, b.deviation) / sine, LEAST) })
}

/// Least standard deviation of a place, in mm: pencil lines are no thinner.
const LEAST: f64 = 0.05;

/// Where a vector along a line ends, near where it should: what speaks for it are lines that cross there, arrowheads and the line's own end. `None` where there
/// is nothing, or two places come into question.
pub(super) fn end(strokes: &[Stroke], line: &Stroke, expected: Point) -> Option<Spot> {
    let along = line.along();
    let position = |at: Point| along.dot(&(at - expected));
    // Positions along the line, with their weights and deviations.
    let mut signs: Vec<(f64, f64, f64)> = Vec::new();
    for other in strokes {
        let sine = cross(along, other.along()).abs();
        let Some(at) = line.crossing(other).filter(|_| sine > 0.25) else { continue };
        let place = position(at);
        if place.abs() > END || other.beyond(at) > 0.8 || line.beyond(at) > 1.5 {
            continue;
        }
        let weight = if other.length() > LONG { 2.0 } else { 0.7 };
        signs.push((place, weight, other.deviation / sine));
    }
    for own in line.ends {
        let place = position(own);
        if place.abs() <= END {
            signs.push((place, 0.8, 0.15));
        }
    }
    let support =
        |place: f64| signs.iter().filter(|sign| (sign.0 - place).abs() <= SAME).map(|sign| sign.1).sum::<f64>();
    let best = signs.iter().max_by(|a, b| support(a.0).total_cmp(&support(b.0)))?;
    let most = support(best.0);
    let is_disputed = signs.iter().any(|sign| (sign.0 - best.0).abs() > 1.5 * SAME && support(sign.0) > 0.6 * most);
    if most < 1.4 || is_disputed {
        return None;
    }
    let own: Vec<&(f64, f64, f64)> = signs.iter().filter(|sign| (sign.0 - best.0).abs() <= SAME).collect();
    let total: f64 = own.iter().map(|sign| sign.1 / (LEAST + sign.2).powi(2)).sum();
    let place = own.iter().map(|sign| sign.0 * sign.1 / (LEAST + sign.2).powi(2)).sum::<f64>() / total;
    let scatter = own.iter().map(|sign| (sign.0 - place).abs()).fold(0.0, f64::max);
    let foot = line.ends[0] + along * along.dot(&(expected - line.ends[0]));
    let deviation = libm::hypot(libm::hypot(line.deviation, 0.06), 0.5 * scatter);
    Some(Spot { at: foot + along * place, band: 2.45 * deviation })
}
