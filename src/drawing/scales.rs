//! The scales of a scene's sheets, chosen once for all of them: the figure, its steps, its work sheet and its page.

use super::figure::{COMPANION, Contents, Steps, composed, extents, extents_of_images};
use super::layout::Layout;
use super::scheme::Scheme;
use super::view::{Extent, next_scale};
use crate::construction::Solution;
use crate::cycle::Animation;
use crate::scene::ScalesFor;
use crate::sheet::{Scales, Sheet};

/// The sheets that have the same scales. A work sheet has them, too, but its table stands where there is room.
const SHEETS: [Option<Steps>; 3] = [Some(Steps::Fine), Some(Steps::Coarse), None];

/// Weight of the scheme's size beside those of the plans: of equals the one with the larger scheme, which must not
/// shrink for the sake of one plan.
const SCHEME: f64 = 1.1;

/// Positions in which the largest plans of a cycle are looked for.
const POSITIONS: usize = 72;

impl<'a> Scheme<'a> {
    /// The scheme of a solved scene, with the scales of all its sheets.
    pub(super) fn scaled(solution: &'a Solution) -> Self {
        Scheme::new(solution).with_scales()
    }

    /// The same with the scales of all its sheets.
    pub(super) fn with_scales(self) -> Self {
        Self { mu: self.common_scales(), ..self }
    }

    /// Scales at which the content fits on every sheet: of the sets between those that the
    /// sheets themselves would have, the one with the largest contents.
    fn common_scales(&self) -> Scales {
        let figure = self.figure;
        let panels = figure.shown_panels();
        if figure.scales == ScalesFor::Sheet || panels.iter().all(|&panel| figure.mu(panel).is_some()) {
            return self.mu;
        }
        let extents = self.extents_to_fit();
        let sheets = SHEETS.map(|steps| composed(self, &extents, Contents { steps, table: None }));
        let own: Vec<Layout> = sheets.iter().map(|sheet| sheet.layout()).collect();
        let fits = |scales: &Scales| {
            sheets.iter().all(|sheet| {
                let worth = sheet.layout_at(scales).worth;
                worth[0] > 0.0 && worth[1] as usize == extents.len()
            })
        };
        // By panel: the scales between the finest and the coarsest that a sheet would have.
        let choices = extents.iter().enumerate().map(|(index, &(panel, _))| {
            let own = own.iter().map(|layout| layout.panels[index].mu);
            (panel, scales_between(own))
        });
        let mut sets = combined(self.mu, &choices.collect::<Vec<_>>());
        let weight = |panel: Sheet| match panel {
            Sheet::Scheme if figure.focus.is_some() => COMPANION,
            Sheet::Scheme => SCHEME,
            _ => 1.0,
        };
        // The sum of the logarithms of the scales: the set with the largest contents comes first.
        let coarseness = |scales: &Scales| {
            let all = scales.given().map(|(panel, scale)| weight(panel) * libm::log(scale));
            all.sum::<f64>()
        };
        sets.sort_by(|a, b| coarseness(a).total_cmp(&coarseness(b)));
        let coarsest = sets.last().copied().unwrap_or(self.mu);
        sets.into_iter().find(fits).unwrap_or(coarsest)
    }

    /// What must fit at the scales: the content in the scene's own position or, for a cycle, in all positions of the
    /// first drive.
    pub(super) fn extents_to_fit(&self) -> Vec<(Sheet, Extent)> {
        let own = extents(self);
        if self.figure.scales != ScalesFor::Cycle {
            return own;
        }
        let Ok(animation) = Animation::new(self.solution, None, POSITIONS) else {
            return own;
        };
        let schemes: Vec<Scheme<'_>> = animation.positions.iter().map(Scheme::new).collect();
        own.into_iter()
            .map(|(panel, extent)| {
                let others = extents_of_images(&schemes, panel);
                // At the ends of a range rates go to infinity.
                let all = if animation.is_round { extent.with_all(others) } else { extent.with_most(others) };
                (panel, all)
            })
            .collect()
    }
}

/// The round scales from the finest to the coarsest of some.
fn scales_between(own: impl Iterator<Item = f64>) -> Vec<f64> {
    let (finest, coarsest) = own.fold((f64::INFINITY, 0.0_f64), |(low, high), mu| (low.min(mu), high.max(mu)));
    let next = |mu: &f64| Some(next_scale(1.01 * mu)).filter(|next| *next < coarsest);
    let mut all: Vec<f64> = std::iter::successors(Some(finest), next).collect();
    all.push(coarsest);
    all.dedup();
    all
}

/// All sets with a scale of each panel.
fn combined(given: Scales, choices: &[(Sheet, Vec<f64>)]) -> Vec<Scales> {
    choices.iter().fold(vec![given], |sets, (panel, scales)| {
        let with = |set: Scales| {
            scales.iter().map(move |&mu| {
                let mut set = set;
                set[*panel] = Some(mu);
                set
            })
        };
        sets.into_iter().flat_map(with).collect()
    })
}
