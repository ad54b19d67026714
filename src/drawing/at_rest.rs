//! Plans at rest. At the scales of a whole cycle the plan of one position may be small: while nothing moves each plan is as
//! large as its panel allows about its pole, which stays where it is, as does the mechanism. When a drive moves they become
//! smaller from picture to picture, until they have the scales of the cycle, and keep these.

use super::held_layout::HeldLayout;
use super::layout::{Needs, Placed};
use super::plan::on_paper::extent;
use super::view::Extent;
use crate::construction::Solution;
use crate::geometry::Point;

/// By how much a plan becomes smaller from one picture to the next: what is enlarged three times has the cycle's scale after an
/// eighth of a second.
const STEP: f64 = 1.15;
/// The least scale at rest over that of the cycle: what is smaller yet in its position says that hardly anything moves.
const LEAST: f64 = 0.1;

impl HeldLayout {
    /// This layout of a cycle with the plans of a position as large as their panels allow.
    #[must_use]
    pub fn at_rest(mut self, solution: &Solution) -> HeldLayout {
        self.scale_plans(|_, whole| fitting(whole, solution).map_or(whole.mu, |mu| mu.max(LEAST * whole.mu)));
        self
    }

    /// Goes a step of the way from the scales at rest to those of the cycle, as long as a step as a position needs.
    pub fn in_motion(&mut self, solution: &Solution) {
        self.scale_plans(|placed, whole| (STEP * placed.mu).max(fitting(whole, solution).unwrap_or(0.0)));
    }

    /// Gives the plans other scales, at most those of the cycle.
    fn scale_plans(&mut self, scale: impl Fn(&Placed, &Placed) -> f64) {
        let plans = self.layout.panels.iter_mut().zip(&self.cycle);
        for (placed, whole) in plans.filter(|(_, whole)| whole.needs.sheet.order().is_some()) {
            *placed = at_scale(whole, scale(placed, whole).min(whole.mu));
        }
    }
}

/// A panel of the cycle with its plan at another scale, about the pole.
fn at_scale(whole: &Placed, mu: f64) -> Placed {
    let share = mu / whole.mu;
    let Extent { low, high } = whole.needs.extent;
    let extent = Extent { low: low * share, high: high * share };
    Placed { needs: Needs { extent, ..whole.needs }, mu, ..*whole }
}

/// The finest scale at which the plan of a position has room about its pole; none where there is no plan, and where nothing moves.
fn fitting(whole: &Placed, solution: &Solution) -> Option<f64> {
    let plan = solution.shown_construction().plan_on(whole.needs.sheet)?;
    let Extent { low, high } = extent(plan, solution.scene.figure.construction);
    let (pole, area) = (whole.view(None).at(Point::origin()), whole.area);
    let sides = [
        (high.x, area.x1 - pole.x),
        (-low.x, pole.x - area.x0),
        (high.y, pole.y - area.y0),
        (-low.y, area.y1 - pole.y),
    ];
    let to_the_edge = |(size, room): (f64, f64)| size.max(0.0) / room.max(f64::MIN_POSITIVE) / whole.unit;
    let mu = sides.map(to_the_edge).into_iter().fold(0.0, f64::max);
    (mu > 0.0).then_some(mu)
}
