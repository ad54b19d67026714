//! Scales at which a sheet can be drawn and read. Tolerances grow with a form's own scales, so one that no sheet can have
//! must not make them large.

use super::measured::AnswerKey;
use crate::geometry::span;
use crate::sheet::{Scales, Sheet};

/// Least size of a scheme or plan that is drawn to be measured, in mm of paper.
const SMALLEST: f64 = 40.0;

/// Largest size of one, in mm: a wall board.
const LARGEST: f64 = 1000.0;

/// How much coarser than at the scale that the scene's figure states a sheet may be drawn.
const COARSER: f64 = 2.0;

/// Difference of two scales from which on they are not the same, in parts of one.
const SAME: f64 = 1e-3;

/// A scale that a form states and that is not the one asked for, or at which the sheet cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct StatedScale {
    /// Of which sheet.
    pub sheet: Sheet,
    /// The scale in the form, in units of the scene per millimetre.
    pub stated: f64,
    /// The scale that the scene's figure states, where it states one.
    pub asked: Option<f64>,
    /// The scale by which the values are judged.
    pub used: f64,
}

impl StatedScale {
    /// Whether a sheet can be drawn at this scale.
    #[must_use]
    pub fn is_sensible(&self) -> bool {
        is_same(self.stated, self.used)
    }
}

fn is_same(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() <= SAME
}

/// The scales by which a form's values are judged, and what is to be said of those that it states. Where the scene's figure
/// states a scale, one that is at most twice as coarse holds; else one at which the sheet is at least 40 mm large, or as large
/// as in the figure. No sheet is larger than 1 m, or than in the figure. Otherwise the nearest such scale does.
pub(super) fn sensible(key: &AnswerKey<'_>, mu: Scales) -> (Scales, Vec<StatedScale>) {
    let (mut scales, mut told) = (mu, Vec::new());
    for (sheet, stated) in mu.given() {
        let own = key.scales[sheet];
        let size = size(key, sheet);
        let asked = key.solution.scene.figure.mu[sheet];
        let coarsest = asked.map_or_else(|| own.unwrap_or(0.0).max(size / SMALLEST), |asked| COARSER * asked);
        let finest = own.unwrap_or(f64::INFINITY).min(size / LARGEST);
        // Where all points are at rest any scale will do.
        let used = if size > 0.0 { stated.min(coarsest).max(finest) } else { stated };
        scales[sheet] = Some(used);
        let scale = StatedScale { sheet, stated, asked, used };
        if !scale.is_sensible() || asked.is_some_and(|asked| !is_same(stated, asked)) {
            told.push(scale);
        }
    }
    (scales, told)
}

/// The size of what a sheet shows, in units of the scene.
fn size(key: &AnswerKey<'_>, sheet: Sheet) -> f64 {
    let construction = &key.solution.construction;
    match construction.plan_on(sheet) {
        Some(plan) => span(plan.points.values().map(|point| point.vector.into())),
        None if sheet == Sheet::Scheme || sheet == Sheet::Centers && construction.centers.is_some() => {
            span(key.solution.pose.points.iter().copied())
        }
        None if sheet == Sheet::Forces => construction.forces.as_ref().map_or(0.0, |plan| span(plan.corners())),
        None if sheet == Sheet::Lever => span(construction.levers.iter().flat_map(|lever| lever.places())),
        None => 0.0,
    }
}
