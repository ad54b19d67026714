//! What pencil lines show of a plan: lines through a place, crossings, and where vectors end.

use crate::geometry::{Point, Vector, cross};
use crate::photo::Stroke;

/// Shortest line that is one by itself, in mm.
const LINE: f64 = 2.5;
/// Shortest of those that arrowheads and letters do not have, in mm.
const LONG: f64 = 7.0;
/// How far a line may be beside a place that it goes through, in mm: always, and for each mm that it begins away from there.
const ASIDE: f64 = 0.55;
const ASIDE_PER_MM: f64 = 0.012;
/// How far away it may begin, in mm.
const AWAY: f64 = 12.0;
/// Least sine between lines whose crossing is a place, and one that is sure.
const SINE: f64 = 0.12;
const SURE_SINE: f64 = 0.26;
/// How far a line may end before a crossing, in mm and as a part of its length: in an arrowhead it is no line any more.
const SHORT: f64 = 1.6;
const AHEAD: f64 = 0.2;
/// So far, in mm, every line is.
const NEXT: f64 = 1.0;
/// How far from the crossing of two a third line passes that meets them, in mm.
const MEETING: f64 = 0.5;
/// Least standard deviation of a place, in mm: pencil lines are no thinner.
const LEAST: f64 = 0.08;
/// Radius that holds 95 % of places in the plane, in standard deviations.
const CIRCLE: f64 = 2.45;
/// Distance within which signs of an end are one, in mm.
const SAME: f64 = 0.6;
/// How much a line's own end speaks for a vector's.
const OWN: f64 = 0.55;
/// How much a leg of an arrowhead does, and how far before and behind a place it may point.
const LEG_STRENGTH: f64 = 0.4;
const POINTS: [f64; 2] = [1.6, 0.9];
/// Longest leg of an arrowhead, in mm, how far from the tip it may begin, and how far it may be turned from the vector, as sines.
const LEG: f64 = 6.0;
const TIP: f64 = 2.2;
const LEG_TURNED: [f64; 2] = [0.12, 0.75];
/// Faintest line that counts, as a part of the usual darkness: what was rubbed out is fainter.
const FAINT: f64 = 0.5;

/// The pencil lines of a plan; places from the pole, in mm, y up.
pub(super) struct Ink {
    strokes: Vec<Stroke>,
    /// By line: whether something must explain it: long, and not rubbed out.
    pub is_meant: Vec<bool>,
}

/// A place that pencil lines show: from the pole, in mm, y up, with the radius that holds it with 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub at: Point,
    pub band: f64,
}

/// Where a vector along a line may end.
pub(super) struct End {
    pub spot: Spot,
    /// How much speaks for it: 0 nothing, 1 as much as an own end with an arrowhead.
    pub strength: f64,
    /// Whether its place is sure enough to be proposed.
    pub is_sure: bool,
}

/// A sign of a vector's end: how far along the line, how sure, in mm, and how much speaks for it.
struct Sign {
    place: f64,
    deviation: f64,
    strength: f64,
}

impl Ink {
    pub(super) fn new(strokes: Vec<Stroke>) -> Ink {
        let is_long = |stroke: &&Stroke| stroke.length() > LONG;
        let mut dark: Vec<f64> = strokes.iter().filter(is_long).map(|stroke| stroke.dark).collect();
        dark.sort_by(f64::total_cmp);
        let usual = dark.get(dark.len() / 2).copied().unwrap_or(0.0);
        let is_meant = strokes.iter().map(|stroke| stroke.length() > LONG && stroke.dark > FAINT * usual).collect();
        Ink { strokes, is_meant }
    }

    pub(super) fn line(&self, index: usize) -> &Stroke {
        &self.strokes[index]
    }

    /// The lines through a place, with how far beside it they are: 0 not at all, 1 as far as may be.
    pub(super) fn through(&self, at: Point) -> impl Iterator<Item = (usize, f64)> {
        self.strokes.iter().enumerate().filter_map(move |(index, stroke)| {
            let away = stroke.beyond(at);
            let aside = stroke.aside(at).abs() / (ASIDE + ASIDE_PER_MM * away);
            let is_near = aside <= 1.0 && away <= AWAY.min(stroke.length()).max(NEXT);
            (is_near && stroke.length() > LINE).then_some((index, aside))
        })
    }

    /// Where two lines cross, if both reach that place, and whether they do so at an angle at which it is sure enough to be proposed.
    pub(super) fn crossing(&self, [a, b]: [usize; 2]) -> Option<(Spot, bool)> {
        let (a, b) = (&self.strokes[a], &self.strokes[b]);
        let at = a.crossing(b)?;
        let sine = cross(a.along(), b.along()).abs();
        let band = CIRCLE * libm::hypot(libm::hypot(a.deviation, b.deviation) / sine, LEAST);
        let is_one = sine > SINE && [a, b].iter().all(|line| reaches(line, at));
        is_one.then_some((Spot { at, band }, sine > SURE_SINE))
    }

    /// Whether a further line meets two at their crossing.
    pub(super) fn meet(&self, at: Point, two: [usize; 2]) -> bool {
        let along = two.map(|index| self.strokes[index].along());
        let mut further = self.strokes.iter().enumerate().filter(|(index, _)| !two.contains(index));
        further.any(|(_, line)| {
            let is_other = along.iter().all(|along| cross(*along, line.along()).abs() > SINE);
            is_other && line.length() > LONG && line.aside(at).abs() < MEETING && line.beyond(at) < NEXT
        })
    }

    /// Where a vector may end that was laid off from a place along a line, in that direction: where its own line ends, or another begins or passes. An arrowhead speaks for the
    /// place that it points to; its legs are too short to say where exactly that is.
    pub(super) fn ends(&self, index: usize, from: Point, along: Vector) -> Vec<End> {
        let line = &self.strokes[index];
        let position = |at: Point| along.dot(&(at - from));
        let own = line.ends.map(position).into_iter().fold(f64::NEG_INFINITY, f64::max);
        let (legs, mut signs) = self.signs(index, &position, along);
        signs.push(Sign { place: own, deviation: 0.15, strength: OWN });
        signs.retain(|sign| sign.place > 0.5 * LINE);
        signs.sort_by(|a, b| a.place.total_cmp(&b.place));
        let foot = line.ends[0] + line.along() * line.along().dot(&(from - line.ends[0]));
        let mut ends = Vec::new();
        let mut rest = &signs[..];
        while let Some(first) = rest.first() {
            let count = rest.iter().take_while(|sign| sign.place - first.place < SAME).count();
            let (group, after) = rest.split_at(count);
            rest = after;
            let total: f64 = group.iter().map(|sign| sign.deviation.powi(-2)).sum();
            let place = group.iter().map(|sign| sign.place * sign.deviation.powi(-2)).sum::<f64>() / total;
            let scatter = group.iter().map(|sign| (sign.place - place).abs()).fold(0.0, f64::max);
            let pointing = legs.iter().filter(|leg| (-POINTS[0]..POINTS[1]).contains(&(**leg - place))).count().min(2);
            let strength = group.iter().map(|sign| sign.strength).sum::<f64>() + LEG_STRENGTH * pointing as f64;
            let deviation = libm::hypot(libm::sqrt(1.0 / total), 0.5 * scatter);
            let band = CIRCLE * libm::hypot(libm::hypot(line.deviation, LEAST), deviation);
            let spot = Spot { at: foot + along * place, band };
            ends.push(End { spot, strength: strength.min(1.3), is_sure: count + pointing > 1 });
        }
        ends
    }

    /// What speaks for a vector's end along a line: where legs of arrowheads point to, and where other lines are, in order.
    fn signs(&self, index: usize, position: &impl Fn(Point) -> f64, along: Vector) -> (Vec<f64>, Vec<Sign>) {
        let line = &self.strokes[index];
        let (mut legs, mut signs) = (Vec::new(), Vec::new());
        for other in self.strokes.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, other)| other) {
            let sine = cross(along, other.along()).abs();
            let Some(at) = line.crossing(other).filter(|_| sine > LEG_TURNED[0]) else { continue };
            if line.beyond(at) > SHORT || other.beyond(at) > TIP {
                continue;
            }
            if is_leg(other, at, along) {
                legs.push(position(at));
            } else if other.length() > LONG && other.beyond(at) < NEXT && sine > 0.25 {
                // A line that begins there says more than one that passes.
                let begins = other.ends.iter().any(|end| (end - at).norm() < 1.5);
                let deviation = libm::hypot(LEAST, other.deviation / sine);
                signs.push(Sign { place: position(at), deviation, strength: if begins { 0.45 } else { 0.25 } });
            }
        }
        (legs, signs)
    }
}

/// Whether a line reaches a place on it, or nearly.
fn reaches(line: &Stroke, at: Point) -> bool {
    line.beyond(at) <= SHORT.min(AHEAD * line.length()).max(NEXT)
}

/// Whether a line is a leg of an arrowhead with its tip at a place, of a vector in that direction.
fn is_leg(line: &Stroke, tip: Point, along: Vector) -> bool {
    let ways = line.ends.map(|end| end - tip);
    let (near, far) = if ways[0].norm() < ways[1].norm() { (ways[0], ways[1]) } else { (ways[1], ways[0]) };
    let sine = cross(line.along(), along).abs();
    let is_turned = (LEG_TURNED[0]..LEG_TURNED[1]).contains(&sine);
    line.length() < LEG && near.norm() < TIP && far.dot(&along) < 0.0 && is_turned
}
