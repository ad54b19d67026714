//! The points of a sheet whose places on paper a form or a photograph gives: from where they are measured, and where they should be.

use crate::construction::{CenterOrigin, Construction, FigureOf, Plan, Solution};
use crate::drawing::{RichText, SheetLabels};
use crate::geometry::{Point, Vector};
use crate::quantity::{Component, QuantityRequest, What};
use crate::sheet::Sheet;

/// The points of a sheet that have places on paper.
///
/// All are measured from one that the sheet has from the start, its origin: the pole of a plan, and in the figure of instant centres the
/// mechanism's first point.
#[derive(Clone, Copy)]
pub struct PaperPoints<'a> {
    solution: &'a Solution,
    /// The sheet.
    pub sheet: Sheet,
    plan: Option<&'a Plan>,
}

impl<'a> PaperPoints<'a> {
    /// The points of a sheet; `None` of one that is not there, and of one whose places are not read.
    #[must_use]
    pub fn of(solution: &'a Solution, sheet: Sheet) -> Option<PaperPoints<'a>> {
        let plan = solution.construction.plan_on(sheet);
        let is_there = plan.is_some() || (sheet == Sheet::Centers && solution.construction.centers.is_some());
        (sheet.has_places() && is_there).then_some(PaperPoints { solution, sheet, plan })
    }

    /// The points of all sheets that are there.
    pub fn all(solution: &'a Solution) -> impl Iterator<Item = PaperPoints<'a>> {
        Sheet::ALL.into_iter().filter_map(|sheet| PaperPoints::of(solution, sheet))
    }

    /// The name of the origin.
    #[must_use]
    pub fn origin(&self) -> &'a str {
        match self.sheet.order() {
            Some(order) => order.pole(),
            None => self.solution.mechanism.points.first().map_or("", String::as_str),
        }
    }

    /// Where the origin is, in the coordinates of the sheet's panel.
    #[must_use]
    pub fn origin_on_panel(&self) -> Point {
        if self.plan.is_some() { Point::origin() } else { self.solution.construction.origin }
    }

    /// Where a point should be, from the origin, in units of the sheet.
    #[must_use]
    pub fn right(&self, name: &str) -> Option<Vector> {
        match self.plan {
            Some(plan) if name == plan.order.pole() => Some(Vector::zeros()),
            Some(plan) => plan.points.get(name).map(|point| point.vector),
            None => self.found().find(|(own, _)| *own == name).map(|(_, at)| at).or_else(|| self.joint(name)),
        }
    }

    /// Where a joint is that the figure of instant centres has from the start.
    pub(super) fn joint(&self, name: &str) -> Option<Vector> {
        let Solution { mechanism, pose, construction, .. } = self.solution;
        let index = mechanism.points.iter().position(|point| point == name).filter(|_| self.plan.is_none())?;
        Some(pose.points[index] - construction.origin)
    }

    /// The points that a hand finds by drawing, in the order of the construction, with their right places from the origin; without those
    /// that are at the origin because they are at rest.
    pub fn found(&self) -> Box<dyn Iterator<Item = (&'a str, Vector)> + 'a> {
        let construction: &'a Construction = &self.solution.construction;
        match self.plan {
            Some(plan) => {
                let places = plan.points.iter().map(|(name, point)| (name.as_str(), point.vector));
                Box::new(places.filter(|(_, vector)| *vector != Vector::zeros()))
            }
            None => {
                let all = construction.centers.iter().flat_map(|centers| &centers.all);
                let drawn = all.filter(|center| {
                    center.figure == FigureOf::Mechanism && matches!(center.origin, CenterOrigin::Lines { .. })
                });
                Box::new(
                    drawn.filter_map(|center| {
                        Some((center.name.as_str(), center.place.finite()? - construction.origin))
                    }),
                )
            }
        }
    }

    /// The quantities that the place of a point gives.
    #[must_use]
    pub fn quantities(&self, name: &str) -> Vec<String> {
        match self.plan {
            Some(plan) => vec![plan.sheet().segment_name(plan.order.pole(), name)],
            None => ["x", "y"].map(|axis| format!("{name}.{axis}")).to_vec(),
        }
    }

    /// A point as the sheets write it.
    #[must_use]
    pub fn label(&self, labels: &SheetLabels<'_>, name: &str) -> RichText {
        labels.place(self.sheet, name)
    }

    /// The points of the sheet that a quantity names whose value their places give.
    pub(super) fn named_by(&self, asked: &QuantityRequest) -> Vec<String> {
        match &asked.what {
            What::Segment(order, ends) if order.sheet() == self.sheet => ends.iter().map(ToString::to_string).collect(),
            // Of one at infinity the direction is asked for.
            What::Pole(pole)
                if self.sheet == Sheet::Centers
                    && matches!(asked.written.component, Some(Component::X | Component::Y)) =>
            {
                vec![pole.name.clone()]
            }
            _ => Vec::new(),
        }
    }
}
