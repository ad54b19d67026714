use std::cmp::Ordering;

use super::closing::{Assembled, Closer, places};
use super::frames::Frames;
use super::levers::Lever;
use super::platform::Platform;
use super::rough::Rough;
use super::search::Search;
use crate::geometry::{Point, Vector, degrees_of, span};
use crate::mechanism::{Class, Group, LoopEquations, Mechanism};

/// A gap of a closed loop, relative to the mechanism's size, above which a candidate is no assembly mode: far more than the rounding
/// that Newton's method leaves, less than what is missing a billionth of a degree beyond a limit position.
const CLOSED: f64 = 1e-12;

/// Two assemblies whose points lie closer than this part of the mechanism's size are one, if their links with one point are turned by
/// less than [`SAME_TURN`] against each other.
const SAME: f64 = 1e-8;

/// In radians; where two modes come together, angles are as uncertain as the root of a rounding.
const SAME_TURN: f64 = 1e-6;

/// Condition number of its loop equations above which a mode is not firm: with gaps of [`CLOSED`], that of a group that can move is
/// larger, that of two modes that come together is not.
const MOVABLE: f64 = 1e10;

/// Why a group has no assembly mode.
pub(super) enum NoMode {
    /// There is none: by how much its links fail to meet, in words.
    Apart(String),
    /// None was found: how hard it was tried, in words.
    NotFound(String),
}

/// Every real assembly mode of `group`, of a higher class those that a search finds.
///
/// They are ordered by the angle of its first link that turns, counter-clockwise from +x; where none turns, by the positions of its
/// sliders. A slotted lever with one point has its slider on the positive side, in one mode; in two, turned by 180°, where `rough`
/// gives its angle.
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
        while !search.is_over(modes.found.len(), modes.firm) {
            let start = search.start();
            if modes.close(start, search.reach) {
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

/// The modes of a group, as they are found.
struct Modes<'a> {
    mechanism: &'a Mechanism,
    group: &'a Group,
    equations: LoopEquations,
    closer: Closer<'a>,
    levers: Vec<Lever>,
    found: Vec<Assembled>,
    /// Of each, where all points are.
    points: Vec<Vec<Point>>,
    /// Whether the rates of the group are definite in one of them.
    firm: bool,
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
            firm: false,
            smallest_gap: f64::INFINITY,
        }
    }

    /// Closes the loops from `start` and keeps what is a new mode; whether they close.
    ///
    /// Beside a slider that has run away any gap is small: it counts against a size of at most `reach`.
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
            // From afar the steps may have run out just before the end.
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
            self.firm = self.firm || self.is_firm(&points, &guides);
            self.found.push(assembled);
            self.points.push(points);
        }
        true
    }

    fn is_firm(&self, points: &[Point], guides: &[Vector]) -> bool {
        let system = self.equations.factored(points, guides);
        system.is_some_and(|system| system.condition() < MOVABLE)
    }

    /// All of them in order, with the levers both ways round whose angle `rough` gives.
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

/// Whether two assemblies have links with one point at the same angle.
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
