//! The crossing of pencil lines that a finger means.

use super::strokes::Stroke;
use crate::geometry::{Point, cross};

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
