use std::cmp::Ordering;

use super::closing::{Assembled, closed, places};
use super::frames::Frames;
use super::truss::Truss;
use crate::geometry::{Vector, degrees_of, span};
use crate::mechanism::{Group, LoopEquations, Mechanism};

/// A gap of a closed loop, relative to the mechanism's size, above which a candidate is no assembly mode.
const CLOSED: f64 = 1e-10;

/// Two assemblies whose points lie closer than this part of the mechanism's size are one.
const SAME: f64 = 1e-8;

/// Every real assembly mode of `group`, ordered by the angle of its first link that turns, counter-clockwise from +x; where none
/// turns, by the positions of its sliders.
///
/// # Errors
/// By how much its links fail to meet, in words.
pub(super) fn modes(
    mechanism: &Mechanism,
    group: &Group,
    known: &Frames,
    slides: &[f64],
) -> Result<Vec<Assembled>, String> {
    let Some(truss) = Truss::new(mechanism, group, known) else {
        return Ok(Vec::new());
    };
    let equations = LoopEquations::new(mechanism, group);
    let mut found: Vec<Assembled> = Vec::new();
    for start in truss.starts(known, slides) {
        let assembled = closed(mechanism, group, &equations, start);
        let new = |other: &Assembled| !same(mechanism, other, &assembled);
        if assembled.gap <= CLOSED && found.iter().all(new) {
            found.push(assembled);
        }
    }
    if found.is_empty() {
        return Err(truss.miss());
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

/// Whether two assemblies put every point in the same place.
fn same(mechanism: &Mechanism, a: &Assembled, b: &Assembled) -> bool {
    let ((a, _), (b, _)) = (places(mechanism, &a.frames), places(mechanism, &b.frames));
    let size = span(a.iter().copied());
    a.iter().zip(&b).all(|(p, q)| (p - q).norm() <= SAME * size)
}
