use super::closing::Assembled;
use super::frames::{local, pinned};
use crate::geometry::{Point, Turn, cross};
use crate::mechanism::{BodyId, Group, LoopEquations, Mechanism, SliderId};

/// A slotted lever with one point, on the line of its slot, with the one-point blocks that slide in it.
///
/// Turned by 180° about their points together, they have the same places: only the axes and the signs of the slides
/// change.
#[derive(Debug)]
pub(super) struct Lever {
    /// The lever and its blocks.
    pub links: Vec<BodyId>,
    /// The sliders on the lever, in scene order.
    sliders: Vec<SliderId>,
}

impl Lever {
    /// The levers of a group.
    pub(super) fn all(mechanism: &Mechanism, group: &Group, equations: &LoopEquations) -> Vec<Lever> {
        let mut levers: Vec<Lever> = Vec::new();
        let unknowns = 0..equations.unknowns;
        for unknown in unknowns {
            let turns = |link: &&BodyId| equations.angular_unknown(**link) == Some(unknown);
            let links: Vec<BodyId> = group.bodies.iter().filter(turns).copied().collect();
            let sliders: Vec<SliderId> =
                mechanism.slider_ids().filter(|&id| links.contains(&mechanism.slider(id).on)).collect();
            let lever = Lever { links, sliders };
            if lever.is_symmetric(mechanism) {
                levers.push(lever);
            }
        }
        levers
    }

    fn is_symmetric(&self, mechanism: &Mechanism) -> bool {
        let one_point = |&link: &BodyId| mechanism.body(link).points.len() == 1;
        // A given position of a slider distinguishes the two orientations.
        let driven = |&id: &SliderId| mechanism.slider(id).drive.is_some();
        let is_through_point = |&id: &SliderId| {
            let slider = mechanism.slider(id);
            let point = only_point(mechanism, slider.on);
            let (through, direction) = slider.line();
            // Exact comparison: these are the scene's own coordinates.
            cross(through - point, direction) == 0.0
        };
        !self.sliders.is_empty()
            && !self.sliders.iter().any(driven)
            && self.links.iter().all(one_point)
            && self.sliders.iter().all(is_through_point)
    }

    /// An assembly with the lever turned by 180°.
    pub(super) fn reversed(&self, mechanism: &Mechanism, assembled: &Assembled) -> Assembled {
        let mut reversed = assembled.clone();
        for &link in &self.links {
            let point = only_point(mechanism, link);
            if let Some(&frame) = assembled.frames.of(link) {
                let turn = Turn::from_cos_sin_unchecked(-frame.rotation.re, -frame.rotation.im);
                reversed.frames.set(link, pinned(turn, point, frame * point));
            }
        }
        for &id in &self.sliders {
            // Slides count from `through`, which need not be the lever's point.
            let slider = mechanism.slider(id);
            let point = only_point(mechanism, slider.on);
            let (through, direction) = slider.line();
            let offset = (through - point).dot(&direction);
            reversed.slides[id.0] = -assembled.slides[id.0] - 2.0 * offset;
        }
        reversed
    }

    /// The assembly with the lever in the orientation in which its first slider has the larger position.
    pub(super) fn positive(&self, mechanism: &Mechanism, assembled: Assembled) -> Assembled {
        let reversed = self.reversed(mechanism, &assembled);
        let first = self.sliders[0].0;
        if reversed.slides[first] > assembled.slides[first] { reversed } else { assembled }
    }
}

/// The point of a one-point link, in its frame.
fn only_point(mechanism: &Mechanism, link: BodyId) -> Point {
    local(mechanism, link, mechanism.body(link).points[0])
}
