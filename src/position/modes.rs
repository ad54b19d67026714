use std::cmp::Ordering;

use super::closing::{Assembled, closed, places};
use super::frames::Frames;
use super::levers::Lever;
use super::rough::Rough;
use super::truss::Truss;
use crate::geometry::{Vector, degrees_of, span};
use crate::mechanism::{BodyId, Group, LoopEquations, Mechanism};

/// A gap of a closed loop, relative to the mechanism's size, above which a candidate is no assembly mode.
const CLOSED: f64 = 1e-10;

/// Two assemblies whose points lie closer than this part of the mechanism's size are one, if their links with one point are turned by
/// less than [`SAME_TURN`] against each other.
const SAME: f64 = 1e-8;

/// In radians; where two modes come together, angles are as uncertain as the root of a rounding.
const SAME_TURN: f64 = 1e-6;

/// Every real assembly mode of `group`, ordered by the angle of its first link that turns, counter-clockwise from +x; where none
/// turns, by the positions of its sliders. A slotted lever with one point has its slider on the positive side, in one mode; in two,
/// turned by 180°, where `rough` gives its angle.
///
/// # Errors
/// By how much its links fail to meet, in words.
pub(super) fn modes(
    mechanism: &Mechanism,
    group: &Group,
    known: &Frames,
    slides: &[f64],
    rough: &Rough,
) -> Result<Vec<Assembled>, String> {
    let Some(truss) = Truss::new(mechanism, group, known) else {
        return Ok(Vec::new());
    };
    let equations = LoopEquations::new(mechanism, group);
    let levers = Lever::all(mechanism, group, &equations);
    let mut found: Vec<Assembled> = Vec::new();
    for start in truss.starts(known, slides) {
        let mut assembled = closed(mechanism, group, &equations, start);
        for lever in &levers {
            assembled = lever.positive(mechanism, assembled);
        }
        let new = |other: &Assembled| !same(mechanism, group, other, &assembled);
        if assembled.gap <= CLOSED && found.iter().all(new) {
            found.push(assembled);
        }
    }
    if found.is_empty() {
        return Err(truss.miss());
    }
    for lever in levers {
        if lever.links.iter().any(|&link| rough.gives_angle(link)) {
            let reversed = found.iter().map(|a| lever.reversed(mechanism, a));
            found.extend(reversed.collect::<Vec<_>>());
        }
    }
    let mut links = group.links.iter();
    let turning = links.find(|&&link| equations.spin_unknown(link).is_some());
    let angle = |a: &Assembled| {
        let frame = turning.and_then(|&link| a.frames.of(link));
        frame.map_or(0.0, |f| {
            degrees_of(f.rotation * Vector::x()).rem_euclid(360.0)
        })
    };
    found.sort_by(|a, b| {
        let slides = a.slides.iter().zip(&b.slides);
        let slides = slides.map(|(a, b)| a.total_cmp(b));
        slides.fold(angle(a).total_cmp(&angle(b)), Ordering::then)
    });
    Ok(found)
}

/// Whether two assemblies put every point in the same place, and links with one point at the same angle.
fn same(mechanism: &Mechanism, group: &Group, a: &Assembled, b: &Assembled) -> bool {
    let mut one_point = group
        .links
        .iter()
        .filter(|&&link| mechanism.body(link).points.len() == 1);
    let turned = |&link: &BodyId| {
        let rotation = |assembled: &Assembled| assembled.frames.of(link).map(|f| f.rotation);
        let rotations = rotation(a).zip(rotation(b));
        rotations.is_some_and(|(a, b)| {
            let (along, across) = (a.re - b.re, a.im - b.im);
            along * along + across * across > SAME_TURN * SAME_TURN
        })
    };
    if one_point.any(turned) {
        return false;
    }
    let ((a, _), (b, _)) = (places(mechanism, &a.frames), places(mechanism, &b.frames));
    let size = span(a.iter().copied());
    a.iter().zip(&b).all(|(p, q)| (p - q).norm() <= SAME * size)
}
