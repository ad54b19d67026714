use super::closing::Assembled;
use super::frames::{local, pinned};
use crate::geometry::{Turn, cross};
use crate::mechanism::{BodyId, Group, LoopEquations, Mechanism, SliderId};

/// A slotted lever with one point, on the line of its slot, and the blocks with one point that slide in it.
///
/// Turned by 180° about their points, all of them together, they are the same lever in the same place: no point moves, only the axes
/// and the signs of the slides change.
#[derive(Debug)]
pub(super) struct Lever {
    /// The lever and its blocks.
    pub links: Vec<BodyId>,
    /// In scene order.
    sliders: Vec<SliderId>,
}

impl Lever {
    /// The levers of a group.
    pub(super) fn all(mechanism: &Mechanism, group: &Group, equations: &LoopEquations) -> Vec<Lever> {
        let mut levers: Vec<Lever> = Vec::new();
        let spins = 0..equations.unknowns;
        for spin in spins {
            let turns = |link: &&BodyId| equations.spin_unknown(**link) == Some(spin);
            let links: Vec<BodyId> = group.bodies.iter().filter(turns).copied().collect();
            let sliders: Vec<SliderId> = (0..mechanism.sliders.len())
                .map(SliderId)
                .filter(|&id| links.contains(&mechanism.slider(id).on))
                .collect();
            let lever = Lever { links, sliders };
            if lever.is_its_own_reverse(mechanism) {
                levers.push(lever);
            }
        }
        levers
    }

    fn is_its_own_reverse(&self, mechanism: &Mechanism) -> bool {
        let one_point = |&link: &BodyId| mechanism.body(link).points.len() == 1;
        // Turned round, a driven slider would stand elsewhere.
        let driven = |&id: &SliderId| mechanism.slider(id).drive.is_some();
        let through_it = |&id: &SliderId| {
            let slider = mechanism.slider(id);
            let own = local(mechanism, slider.on, mechanism.body(slider.on).points[0]);
            let (through, direction) = slider.line();
            // Coordinates as the scene gives them: on the line or not, nothing is computed before.
            cross(through - own, direction) == 0.0
        };
        !self.sliders.is_empty()
            && !self.sliders.iter().any(driven)
            && self.links.iter().all(one_point)
            && self.sliders.iter().all(through_it)
    }

    /// The same assembly with the lever turned by 180°.
    pub(super) fn reversed(&self, mechanism: &Mechanism, assembled: &Assembled) -> Assembled {
        let mut reversed = assembled.clone();
        for &link in &self.links {
            let own = local(mechanism, link, mechanism.body(link).points[0]);
            if let Some(&frame) = assembled.frames.of(link) {
                let turn = Turn::from_cos_sin_unchecked(-frame.rotation.re, -frame.rotation.im);
                reversed.frames.set(link, pinned(turn, own, frame * own));
            }
        }
        for &id in &self.sliders {
            // The slide counts from `through`, which may be elsewhere on the line than the lever's point.
            let slider = mechanism.slider(id);
            let own = local(mechanism, slider.on, mechanism.body(slider.on).points[0]);
            let (through, direction) = slider.line();
            let offset = (through - own).dot(&direction);
            reversed.slides[id.0] = -assembled.slides[id.0] - 2.0 * offset;
        }
        reversed
    }

    /// The assembly with the lever so that its first slider is on the positive side of `through`, or as far towards it as it can be.
    pub(super) fn positive(&self, mechanism: &Mechanism, assembled: Assembled) -> Assembled {
        let reversed = self.reversed(mechanism, &assembled);
        let first = self.sliders[0].0;
        if reversed.slides[first] > assembled.slides[first] { reversed } else { assembled }
    }
}
