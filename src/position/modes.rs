use std::cmp::Ordering;

use super::closing::{Assembled, Closer, places};
use super::frames::Frames;
use super::levers::Lever;
use super::platform::Platform;
use super::rough::Rough;
use super::search::Search;
use crate::geometry::{Point, Vector, degrees_of, span};
use crate::mechanism::{Class, Group, LoopEquations, Mechanism};

/// Largest gap of a closed loop, relative to the mechanism's size: far more than the rounding that Newton's method
/// leaves, less than the gap a billionth of a degree beyond a limit position.
const CLOSED: f64 = 1e-12;

/// Two assemblies are the same mode if their points differ by less than this part of the mechanism's size and their
/// one-point links by less than [`SAME_TURN`].
const SAME: f64 = 1e-8;

/// In radians; at a double root angles are only as exact as the square root of a rounding.
const SAME_TURN: f64 = 1e-6;

/// Condition number above which the group counts as movable at fixed drives: with gaps of [`CLOSED`] a movable group
/// exceeds it, two modes that nearly coincide do not.
const MOVABLE: f64 = 1e10;

/// Reasons why a group has no assembly mode.
pub(super) enum NoMode {
    /// There is none: the distance by which its links fail to meet, in words.
    Apart(String),
    /// The search found none: number of starts and smallest gap, in words.
    NotFound(String),
}

/// Every real assembly mode of a group; of a group of higher class those that a search finds.
///
/// They are ordered by the angle of the group's first rotating link, counter-clockwise from +x; where none rotates, by
/// the positions of its sliders. A slotted lever with one point has its slider on the positive side; where `rough`
/// gives its angle, both orientations are modes.
pub(super) fn modes(
    mechanism: &Mechanism,
    index: usize,
    known: &Frames,
    slides: &[f64],
    rough: &Rough,
) -> Result<Vec<Assembled>, NoMode> {
    let group = &mechanism.groups[index];
    let mut modes = Modes::new(mechanism, index);
    if let Some(platform) = Platform::new(mechanism, group, known) {
        for start in platform.starts(known, slides) {
            modes.close(start, f64::INFINITY);
        }
        if modes.found.is_empty() {
            return Err(NoMode::Apart(platform.miss()));
        }
    } else {
        let mut search = Search::new(mechanism, group, known, slides, rough);
        while !search.is_over(modes.found.len(), modes.is_regular) {
            let start = search.start();
            if modes.close(start, search.size) {
                search.count_closed();
            }
        }
        if modes.found.is_empty() {
            let mut tried = format!("none of {} starts closes", search.starts);
            if modes.smallest_gap.is_finite() {
                let gap = modes.smallest_gap;
                tried += &format!(", the nearest leaves a gap of {gap:.1e} of the mechanism's size");
            }
            return Err(NoMode::NotFound(tried));
        }
    }
    Ok(modes.sorted(rough))
}

/// The modes of a group found so far.
struct Modes<'a> {
    mechanism: &'a Mechanism,
    group: &'a Group,
    equations: LoopEquations,
    closer: Closer<'a>,
    levers: Vec<Lever>,
    found: Vec<Assembled>,
    /// By mode: the places of all points.
    points: Vec<Vec<Point>>,
    /// Whether the loop equations are regular in at least one mode, so that the group cannot move at fixed drives.
    is_regular: bool,
    smallest_gap: f64,
}

impl<'a> Modes<'a> {
    fn new(mechanism: &'a Mechanism, index: usize) -> Modes<'a> {
        let group = &mechanism.groups[index];
        let equations = LoopEquations::new(mechanism, group);
        Modes {
            mechanism,
            group,
            levers: Lever::all(mechanism, group, &equations),
            equations,
            closer: Closer::new(mechanism, index),
            found: Vec::new(),
            points: Vec::new(),
            is_regular: false,
            smallest_gap: f64::INFINITY,
        }
    }

    /// Closes the loops from `start` and keeps the assembly if it is a new mode; whether they close.
    ///
    /// A slider that has moved far away enlarges the mechanism and makes any relative gap small: gaps are taken
    /// relative to a size of at most `reach`.
    fn close(&mut self, start: Assembled, reach: f64) -> bool {
        let (mechanism, group) = (self.mechanism, self.group);
        let mut assembled = self.closer.closed(start);
        let (points, _) = places(mechanism, &assembled.frames);
        let gap = assembled.gap * (span(points) / reach).max(1.0);
        self.smallest_gap = self.smallest_gap.min(gap);
        if gap.is_nan() || gap > CLOSED {
            return false;
        }
        if group.class == Class::Higher {
            // The steps from a distant start may have ended before full accuracy.
            assembled = self.closer.closed(assembled);
        }
        for lever in &self.levers {
            assembled = lever.positive(mechanism, assembled);
        }
        let (points, guides) = places(mechanism, &assembled.frames);
        let near = SAME * span(points.iter().copied());
        let mut found = self.found.iter().zip(&self.points);
        let is_known = found.any(|(other, places)| {
            let mut pairs = places.iter().zip(&points);
            pairs.all(|(p, q)| (p - q).norm() <= near) && same_turns(mechanism, group, other, &assembled)
        });
        if !is_known {
            self.is_regular = self.is_regular || self.is_regular_at(&points, &guides);
            self.found.push(assembled);
            self.points.push(points);
        }
        true
    }

    fn is_regular_at(&self, points: &[Point], guides: &[Vector]) -> bool {
        let system = self.equations.factored(points, guides);
        system.is_some_and(|system| system.condition() < MOVABLE)
    }

    /// All modes in order. A lever whose angle `rough` gives is listed in both orientations.
    fn sorted(self, rough: &Rough) -> Vec<Assembled> {
        let mut found = self.found;
        for lever in self.levers {
            if lever.links.iter().any(|&link| rough.angle(link).is_some()) {
                let reversed = found.iter().map(|a| lever.reversed(self.mechanism, a));
                found.extend(reversed.collect::<Vec<_>>());
            }
        }
        let mut links = self.group.links.iter();
        let turning = links.find(|&&link| self.equations.spin_unknown(link).is_some());
        let angle = |a: &Assembled| {
            let frame = turning.and_then(|&link| a.frames.of(link));
            frame.map_or(0.0, |f| degrees_of(f.rotation * Vector::x()).rem_euclid(360.0))
        };
        found.sort_by(|a, b| {
            let slides = a.slides.iter().zip(&b.slides);
            let slides = slides.map(|(a, b)| a.total_cmp(b));
            slides.fold(angle(a).total_cmp(&angle(b)), Ordering::then)
        });
        found
    }
}

/// Whether the one-point links of two assemblies have the same angles.
fn same_turns(mechanism: &Mechanism, group: &Group, a: &Assembled, b: &Assembled) -> bool {
    let mut one_point = group.bodies.iter().filter(|&&link| mechanism.body(link).points.len() == 1);
    one_point.all(|&link| {
        let rotation = |assembled: &Assembled| assembled.frames.of(link).map(|f| f.rotation);
        rotation(a).zip(rotation(b)).is_none_or(|(a, b)| {
            let (along, across) = (a.re - b.re, a.im - b.im);
            along * along + across * across <= SAME_TURN * SAME_TURN
        })
    })
}
