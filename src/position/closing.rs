use super::frames::{Frames, across, local, local_guide, pinned};
use crate::geometry::{Numbers, Point, Turn, UNIT_ROUNDOFF, Vector, span};
use crate::mechanism::{BodyId, Group, JointKind, Loop, LoopEquations, Mechanism, SliderId};
use smallvec::smallvec;

/// Newton steps at most; from a polynomial's root two or three are needed, at a double root ten.
const STEPS: usize = 16;

/// A group being put together: how its links are turned and where its sliders stand.
#[derive(Clone, Debug)]
pub(super) struct Assembled {
    /// Frames of all bodies, the group's included.
    pub frames: Frames,
    /// By slider.
    pub slides: Vec<f64>,
    /// What is left of the loops' gaps, relative to the mechanism's size.
    pub gap: f64,
}

/// Closes the loops of `group` from the approximate `start`, by Newton's method on the loop equations themselves.
///
/// The matrix is that of the velocity equations, the right side the gaps; so a pose is as exact as the
/// condition of its velocities allows.
pub(super) fn closed(
    mechanism: &Mechanism,
    group: &Group,
    equations: &LoopEquations,
    start: Assembled,
) -> Assembled {
    let mut state = start;
    let mut best: Option<Assembled> = None;
    for _ in 0..STEPS {
        let gaps = walk(mechanism, group, &mut state);
        let (points, guides) = places(mechanism, &state.frames);
        let size = span(points.iter().copied());
        let gap = gaps.iter().fold(0.0, |m: f64, g| m.max(g.abs())) / size;
        if !gap.is_finite() {
            break;
        }
        state.gap = gap;
        let better = best.as_ref().is_none_or(|b| gap < b.gap);
        if better {
            best = Some(state.clone());
        }
        // At the level of rounding one more step changes nothing; a gap that grows there has reached it.
        if gap <= UNIT_ROUNDOFF || (!better && gap < 1e-12) {
            break;
        }
        let Some(system) = equations.factored(&points, &guides) else {
            break;
        };
        let correction = system.solve(&gaps);
        for &link in &group.links {
            if let (Some(unknown), Some(frame)) =
                (equations.spin_unknown(link), state.frames.of(link).copied())
            {
                let (sine, cosine) = libm::sincos(correction[unknown]);
                let turn = frame.rotation * Turn::from_cos_sin_unchecked(cosine, sine);
                let size = libm::hypot(turn.re, turn.im);
                let turn = Turn::from_cos_sin_unchecked(turn.re / size, turn.im / size);
                state.frames.set(
                    link,
                    pinned(turn, Point::origin(), frame.translation.vector.into()),
                );
            }
        }
        for slider in (0..mechanism.sliders.len()).map(SliderId) {
            if let Some(unknown) = equations.slide_unknown(slider) {
                state.slides[slider.0] += correction[unknown];
            }
        }
    }
    best.unwrap_or(Assembled {
        gap: f64::INFINITY,
        ..state
    })
}

/// Places the links along the loops and returns the gaps, from-end minus from-start.
fn walk(mechanism: &Mechanism, group: &Group, state: &mut Assembled) -> Numbers {
    let mut gaps: Numbers = smallvec![0.0; 2 * group.loops.len()];
    // The first loop has the last word on the links that loops share.
    for (chain, gap) in group.loops.iter().zip(gaps.chunks_exact_mut(2)).rev() {
        let g = walk_loop(mechanism, chain, state).unwrap_or_else(|| Vector::repeat(f64::NAN));
        gap.copy_from_slice(&[g.x, g.y]);
    }
    gaps
}

/// Walks a loop from both ends to its last pin; the gap there.
fn walk_loop(mechanism: &Mechanism, chain: &Loop, state: &mut Assembled) -> Option<Vector> {
    let last_pin = chain
        .joints
        .iter()
        .rposition(|&j| !mechanism.is_prismatic(j))?;
    for i in 0..last_pin {
        step(
            mechanism,
            state,
            chain,
            i,
            chain.bodies[i],
            chain.bodies[i + 1],
        )?;
    }
    for i in (last_pin + 1..chain.joints.len()).rev() {
        step(
            mechanism,
            state,
            chain,
            i,
            chain.bodies[i + 1],
            chain.bodies[i],
        )?;
    }
    let pin = mechanism.joint_point(chain.joints[last_pin]);
    let place = |body| state.frames.place(mechanism, body, pin);
    Some(place(chain.bodies[last_pin + 1])? - place(chain.bodies[last_pin])?)
}

/// Places body `to` from body `from`, across the loop's joint of that index.
fn step(
    mechanism: &Mechanism,
    state: &mut Assembled,
    chain: &Loop,
    joint: usize,
    from: BodyId,
    to: BodyId,
) -> Option<()> {
    let base = *state.frames.of(from)?;
    let frame = match mechanism.joint(chain.joints[joint]).kind {
        JointKind::Revolute(point) => {
            let place = base * local(mechanism, from, point);
            let turn = state.frames.of(to)?.rotation;
            pinned(turn, local(mechanism, to, point), place)
        }
        JointKind::Prismatic(id) => {
            base * across(mechanism, mechanism.slider(id), from, state.slides[id.0])
        }
    };
    state.frames.set(to, frame);
    Some(())
}

/// Places of all points and directions of all guides; what has no frame yet stands at the origin.
pub(super) fn places(mechanism: &Mechanism, frames: &Frames) -> (Vec<Point>, Vec<Vector>) {
    let mut points: Vec<Point> = mechanism
        .given
        .iter()
        .map(|p| p.unwrap_or_else(Point::origin))
        .collect();
    // Known bodies last: they have the last word on shared points.
    let bodies = (0..mechanism.bodies.len()).map(BodyId);
    let (known, members): (Vec<BodyId>, Vec<BodyId>) =
        bodies.partition(|&b| mechanism.body(b).role.is_known());
    for id in members.into_iter().rev().chain(known.into_iter().rev()) {
        let body = mechanism.body(id);
        for &point in &body.points {
            if let Some(place) = frames.place(mechanism, id, point) {
                points[point.0] = place;
            }
        }
    }
    let guides = mechanism.sliders.iter().map(|slider| {
        let (_, direction) = local_guide(slider);
        frames
            .of(slider.on)
            .map_or(direction, |frame| frame.rotation * direction)
    });
    (points, guides.collect())
}
