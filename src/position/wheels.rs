//! Groups without a loop: wheels, arms and racks whose angles and slides the meshes alone tell.

use super::closing::Assembled;
use super::frames::{Frames, pinned, placement_in_compound, principal_degrees};
use crate::geometry::{Point, Vector, turn_of_degrees};
use crate::mechanism::{AngularRate, BodyId, Group, LoopEquations, Mechanism};
use nalgebra::{DMatrix, DVector};

/// The assembly of a group without a loop; `None` of others.
///
/// Meshes are equations between angles, z₁ θ₁ + z₂ θ₂ − (z₁ + z₂) θ_carrier = z₂ · phase. Taken as directions, which know no whole turns, they
/// would have an assembly for each tooth by which a wheel may be shifted. Here they are taken as numbers, with the whole turns of drives
/// and of wheels before, and racks by the length that they have slid; so there is one, and a train that goes round comes back shifted by as many teeth as it has gone on.
pub(super) fn start(
    mechanism: &Mechanism,
    group: &Group,
    equations: &LoopEquations,
    known: &Frames,
    slides: &[f64],
) -> Option<Assembled> {
    if !group.loops.is_empty() {
        return None;
    }
    let mut matrix = DMatrix::zeros(equations.unknowns, equations.unknowns);
    let mut right = DVector::zeros(equations.unknowns);
    for (row, relation) in group.gears(mechanism).enumerate() {
        right[row] = relation.constant.rounded_degrees();
        for &(body, weight) in &relation.terms {
            let weight = f64::from(weight);
            match equations.angular_rate_of(body) {
                AngularRate::Unknown(unknown) => {
                    matrix[(row, unknown)] += weight;
                    let first = equations.link_of(unknown).unwrap_or(body);
                    let within = placement_in_compound(mechanism, first, body);
                    right[row] -= weight * principal_degrees(within.rotation * Vector::x());
                }
                AngularRate::Known(other) => right[row] -= weight * known.degrees(other)?,
            }
        }
        if let (Some(travel), Some(terms)) = (&relation.travel, &equations.angular[row].travel) {
            let degrees = (1.0 / travel.radius).to_degrees();
            right[row] -= travel.start * degrees;
            for slide in &terms.slides {
                match slide.unknown {
                    Some(unknown) => matrix[(row, unknown)] -= slide.sign * degrees,
                    None => right[row] += slide.sign * slides[slide.slider.0] * degrees,
                }
            }
        }
    }
    let found = matrix.lu().solve(&right)?;
    let mut slides = slides.to_vec();
    for &(slider, unknown) in &equations.slides {
        slides[slider.0] = found[unknown];
    }
    let mut frames = known.clone();
    for (unknown, &angle) in found.iter().enumerate() {
        let Some(link) = equations.link_of(unknown) else { continue };
        frames.set_compound(mechanism, link, pinned(turn_of_degrees(angle), Point::origin(), Point::origin()));
        frames.set_degrees(link, angle);
    }
    Some(Assembled { frames, slides, gap: f64::INFINITY })
}

/// The angles with their whole turns that an assembly has of these bodies.
pub(super) fn degrees(assembled: &Assembled, bodies: &[BodyId]) -> Vec<(BodyId, f64)> {
    let of = |body: &BodyId| Some((*body, assembled.frames.counted(*body)?));
    bodies.iter().filter_map(of).collect()
}
