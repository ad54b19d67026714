//! Couples in guides, from the moments of single links.

use super::Found;
use super::statics::{Couple, Set, Statics};
use crate::construction::number::NumberKind;
use crate::mechanism::{BodyId, JointId};
use crate::sheet::Sheet;

impl Statics<'_, '_> {
    /// Finds the couples in the guides of a group whose forces are found: a link with one of them left tells it. `None` where no link does.
    pub fn guide_couples(&mut self, links: &[Vec<BodyId>], joints: &[JointId]) -> Option<()> {
        loop {
            let is_open = |joint: &&JointId| {
                let slider = self.mechanism().joint(**joint).slider;
                slider.is_some_and(|slider| !self.couples.contains_key(&slider))
            };
            let open: Vec<JointId> = joints.iter().filter(is_open).copied().collect();
            if open.is_empty() {
                return Some(());
            }
            let touches = |joint: JointId, link: &[BodyId]| {
                self.mechanism().joint(joint).bodies.into_iter().find(|body| link.contains(body))
            };
            let of_link = |link: &Vec<BodyId>| {
                let own: Vec<JointId> = open.iter().copied().filter(|joint| touches(*joint, link).is_some()).collect();
                if let [joint] = own[..] { Some((link.clone(), joint)) } else { None }
            };
            let (link, joint) = links.iter().find_map(of_link)?;
            let own = self.set(&link);
            let others = joints.iter().copied().filter(|other| *other != joint);
            let set = others.fold(own, |set, other| match touches(other, &link) {
                Some(body) => set.with(self.on(other, body), self.couple_on(other, body)),
                None => set,
            });
            self.guide_couple(&link, set, joint, touches(joint, &link)?)?;
        }
    }

    /// The couple that a guide gives one of its bodies, if it is known.
    pub fn couple_on(&self, joint: JointId, body: BodyId) -> Option<Couple> {
        let slider = self.mechanism().joint(joint).slider?;
        let couple = *self.couples.get(&slider)?;
        Some(if self.mechanism().slider(slider).link == body { couple } else { couple.reversed() })
    }

    /// Finds the couple in a guide from the moments of a link of which all else is known.
    pub fn guide_couple(&mut self, links: &[BodyId], set: Set, joint: JointId, body: BodyId) -> Option<()> {
        let slider = self.mechanism().joint(joint).slider?;
        let at = self.mechanism().slider(slider).at;
        let is_sliding = self.mechanism().slider(slider).link == body;
        let size = self.couple_by_moments(links, &set, at, Found::Couple(slider));
        let Some(size) = size else {
            // Nothing has a moment.
            let zero = self.writer.compute(Sheet::Forces, NumberKind::Moment, Vec::new());
            self.couples.insert(slider, Couple { size: zero, sign: 1.0 });
            return Some(());
        };
        self.couples.insert(slider, Couple { size, sign: if is_sliding { 1.0 } else { -1.0 } });
        Some(())
    }
}
