//! Forms that name instant centres of a scene whose figure shows none: these are constructed, too, as if it showed them.

use super::measured::Measured;
use super::names::Names;
use crate::centers::LinkPair;
use crate::construction::Solution;
use crate::scene::{CentersShown, Head};
use crate::sheet::Sheet;
use std::collections::BTreeSet;

impl Measured {
    /// The solution with the construction of the instant centres that this form names. `None` where the scene's figure has such a
    /// construction already, where the form names no centre, and in a singular position.
    #[must_use]
    pub fn with_centers(&self, solution: &Solution) -> Option<Solution> {
        let named = self.centers_named(solution);
        if solution.construction.centers.is_some() || named.is_empty() {
            return None;
        }
        let mut figure = solution.scene.figure.clone();
        figure.focus = None;
        figure.panels = solution.scene.figure.shown_panels();
        figure.panels.push(Sheet::Centers);
        figure.centers = CentersShown::Named(named.into_iter().collect());
        let Solution { scene, mechanism, pose, motion, .. } = solution;
        let mut scene = scene.clone();
        scene.figure = figure;
        Solution::new(scene, mechanism.clone(), pose.clone(), motion.order).ok()
    }

    /// The instant centres in the names of a form's values.
    fn centers_named(&self, solution: &Solution) -> BTreeSet<String> {
        let has_center = |name: &&String| name.contains(Head::Center.word());
        let mut named =
            self.values.iter().map(|given| given.plain_name().0).filter(|name| has_center(&name)).peekable();
        if named.peek().is_none() {
            return BTreeSet::new();
        }
        let names = Names::new(solution);
        let asked = named.filter_map(|name| names.quantity(&name).ok());
        let pairs: Vec<LinkPair> = asked
            .flat_map(|meant| meant.asked.centers().filter_map(|pole| pole.of.pair()).collect::<Vec<LinkPair>>())
            .collect();
        pairs.into_iter().map(|pair| pair.name(&solution.mechanism)).collect()
    }
}
