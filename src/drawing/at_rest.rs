//! Plans at rest. At the scales of a whole cycle the plan of one position may be small: while nothing moves each plan is as
//! large as its panel allows about its pole, which stays where it is, as does the mechanism. Polygons of forces and levers
//! stand in the middle of their panel. When a drive moves they become smaller from picture to picture, until they have the
//! scales and the places of the cycle, and keep these.

use super::held_layout::HeldLayout;
use super::layout::{Needs, Placed};
use super::panel::plan_extent;
use super::view::Extent;
use crate::construction::Solution;
use crate::geometry::{Point, Vector};

/// By how much a plan becomes smaller from one picture to the next: what is enlarged three times has the cycle's scale after an
/// eighth of a second.
const STEP: f64 = 1.15;
/// That of forces, which begin much smaller: see `LEAST_OF_FORCES`.
const STEP_OF_FORCES: f64 = 1.6;
/// The least scale at rest over that of the cycle: what is smaller yet in its position says that hardly anything moves.
const LEAST: f64 = 0.1;
/// That of forces: a press that carries only its weights has polygons that are worth seeing.
const LEAST_OF_FORCES: f64 = 1e-4;

impl HeldLayout {
    /// This layout of a cycle with the plans of a position as large as their panels allow.
    #[must_use]
    pub fn at_rest(mut self, solution: &Solution) -> HeldLayout {
        for (placed, whole) in self.layout.panels.iter_mut().zip(&self.cycle) {
            let Some(extent) = extent_of(whole, solution) else { continue };
            let fitting = fitting(whole, &extent);
            *placed = match whole.needs.sheet.order() {
                Some(_) => about_pole(whole, fitting.unwrap_or(whole.mu).max(LEAST * whole.mu)),
                None => {
                    let mu = fitting.unwrap_or(whole.mu).clamp(LEAST_OF_FORCES * whole.mu, whole.mu);
                    at_middle(whole, &extent, mu, middle(&extent) / mu)
                }
            };
        }
        self
    }

    /// Goes a step of the way from the scales at rest to those of the cycle, as long as a step as a position needs.
    pub fn in_motion(&mut self, solution: &Solution) {
        for (placed, whole) in self.layout.panels.iter_mut().zip(&self.cycle) {
            let Some(extent) = extent_of(whole, solution) else { continue };
            let step = if whole.needs.sheet.order().is_some() { STEP } else { STEP_OF_FORCES };
            let mu = (step * placed.mu).max(fitting(whole, &extent).unwrap_or(0.0));
            *placed = match whole.needs.sheet.order() {
                Some(_) => about_pole(whole, mu),
                None if mu >= whole.mu => *whole,
                None => {
                    // As far on the way to its place in the cycle as to its scale.
                    let share = libm::log(mu / placed.mu) / libm::log(whole.mu / placed.mu);
                    let [now, then] = [placed, whole].map(|placed| middle(&placed.needs.extent) / placed.mu);
                    at_middle(whole, &extent, mu, now + (then - now) * share)
                }
            };
        }
    }
}

/// The extent of a panel's plan in a position; none where there is no plan, and of the scheme, which is as it is.
fn extent_of(whole: &Placed, solution: &Solution) -> Option<Extent> {
    plan_extent(whole.needs.sheet, solution.shown_construction(), solution.scene.figure.construction)
}

fn middle(Extent { low, high }: &Extent) -> Vector {
    nalgebra::center(low, high).coords
}

/// A panel of the cycle with its plan at another scale, at most that of the cycle, about the pole.
fn about_pole(whole: &Placed, mu: f64) -> Placed {
    let mu = mu.min(whole.mu);
    let share = mu / whole.mu;
    let Extent { low, high } = whole.needs.extent;
    let extent = Extent { low: low * share, high: high * share };
    Placed { needs: Needs { extent, ..whole.needs }, mu, ..*whole }
}

/// A panel of the cycle at another scale, with this place of the plan, in mm of paper, in its middle, or the next to it at
/// which all of the position's own `extent` is in sight.
fn at_middle(whole: &Placed, extent: &Extent, mu: f64, wanted: Vector) -> Placed {
    let share = mu / whole.mu;
    let half = whole.needs.extent.size() * (0.5 * share);
    let room = Vector::new(whole.area.width(), whole.area.height()) * (0.5 * mu * whole.unit);
    let [low, high] = [extent.high.coords - room, extent.low.coords + room];
    let middle = Vector::from_fn(|axis, _| (wanted[axis] * mu).min(high[axis]).max(low[axis]));
    let extent = Extent { low: Point::from(middle - half), high: Point::from(middle + half) };
    Placed { needs: Needs { extent, ..whole.needs }, mu, ..*whole }
}

/// The finest scale at which the plan of a position has room, about its pole if it has one; none where nothing moves.
fn fitting(whole: &Placed, Extent { low, high }: &Extent) -> Option<f64> {
    let area = whole.area;
    let sides = if whole.needs.sheet.order().is_some() {
        let pole = whole.view(None).at(Point::origin());
        [(high.x, area.x1 - pole.x), (-low.x, pole.x - area.x0), (high.y, pole.y - area.y0), (-low.y, area.y1 - pole.y)]
    } else {
        let [across, up] = [(high.x - low.x, area.width()), (high.y - low.y, area.height())];
        [across, across, up, up]
    };
    let to_the_edge = |(size, room): (f64, f64)| size.max(0.0) / room.max(f64::MIN_POSITIVE) / whole.unit;
    let mu = sides.map(to_the_edge).into_iter().fold(0.0, f64::max);
    (mu > 0.0).then_some(mu)
}
