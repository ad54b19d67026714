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
/// How far a line may end before the place that it leads to, in mm: in an arrowhead it is no line any more.
const SHORT: f64 = 3.2;
/// Farther than this part of its length a short line is not drawn out, as its direction is not sure.
const AHEAD: f64 = 0.2;
/// So far, in mm, every line is.
const NEXT: f64 = 1.0;
/// How far from where it should be a vector's end is looked for, along its line, in mm.
const END: f64 = 0.9;
/// Distance within which signs of an end are one, in mm.
const SAME: f64 = 0.4;
/// Least length of what makes a line by itself, in mm; arrowheads and letters are shorter.
const LONG: f64 = 6.0;

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
const LEAST: f64 = 0.08;

/// Where a vector along a line ends, near where it should: where long lines cross it, or else where both its own end and an arrowhead are. `None` where there is nothing,
/// or where several places come into question.
pub(super) fn end(strokes: &[Stroke], line: &Stroke, expected: Point) -> Option<Spot> {
    let along = line.along();
    let position = |at: Point| along.dot(&(at - expected));
    let (mut long, mut short): (Vec<Sign>, Vec<Sign>) = (Vec::new(), Vec::new());
    for other in strokes {
        let sine = cross(along, other.along()).abs();
        let Some(at) = line.crossing(other).filter(|_| sine > 0.25) else { continue };
        let place = position(at);
        if place.abs() > END || other.beyond(at) > 0.8 || line.beyond(at) > SHORT.min(AHEAD * line.length()).max(NEXT) {
            continue;
        }
        let signs = if other.length() > LONG { &mut long } else { &mut short };
        signs.push(Sign { place, deviation: libm::hypot(LEAST, other.deviation / sine) });
    }
    let own = line.ends.map(position).into_iter().filter(|place| place.abs() <= END);
    let own: Vec<Sign> = own.map(|place| Sign { place, deviation: 0.15 }).collect();
    let signs = match (long.is_empty(), own.is_empty() || short.is_empty()) {
        (false, _) => long,
        (true, false) => own.into_iter().chain(short).collect(),
        (true, true) => return None,
    };
    let total: f64 = signs.iter().map(|sign| sign.deviation.powi(-2)).sum();
    let place = signs.iter().map(|sign| sign.place * sign.deviation.powi(-2)).sum::<f64>() / total;
    let scatter = signs.iter().map(|sign| (sign.place - place).abs()).fold(0.0, f64::max);
    if scatter > SAME {
        return None;
    }
    let foot = line.ends[0] + along * along.dot(&(expected - line.ends[0]));
    let deviation =
        libm::hypot(libm::hypot(line.deviation, LEAST), libm::hypot(libm::sqrt(1.0 / total), 0.5 * scatter));
    Some(Spot { at: foot + along * place, band: 2.45 * deviation })
}

/// A sign of a vector's end: how far beyond where it should be, and how sure, in mm.
struct Sign {
    place: f64,
    deviation: f64,
}
