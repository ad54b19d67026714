//! What a student's photographed sheets show, plans or the figure of instant centres: what is tapped on them, and how points stand there.

use super::measured::PlacedPoint;
use super::on_paper::PaperPoints;
use crate::construction::Solution;
use crate::geometry::Point;
use crate::photo::{PhotoSheet, Stroke, crossing};
use crate::sheet::Sheet;
use serde::Serialize;

/// Radius that holds a place that a hand has written or set by keys with 95 %, in mm.
const AIMED: f64 = 0.5;

/// A plan or figure of instant centres on a photographed sheet, with the pencil lines there.
#[derive(Clone, Copy)]
pub struct PencilledPlan<'a> {
    /// Its points.
    pub points: PaperPoints<'a>,
    /// Its scale, in units of the scene per millimetre.
    pub mu: f64,
    /// The place of its origin on the sheet, in mm, y down: of a plan's pole, of the mechanism's first point.
    pub origin: [f64; 2],
    /// The pencil lines of the sheet, in mm, y down.
    pub strokes: &'a [Stroke],
    /// The sheet in its photograph.
    pub sheet: &'a PhotoSheet,
}

/// A place on a sheet that somebody points at.
#[derive(Clone, Copy, Debug)]
pub struct Aimed {
    /// On the sheet, in mm, y down.
    pub at: [f64; 2],
    /// Radius that holds it with 95 %, in mm.
    pub band: f64,
    /// Whether pencil lines cross there.
    pub is_crossing: bool,
}

/// What the place of a point in a photograph tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "PlaceVerdict"))]
#[serde(rename_all = "lowercase")]
pub enum PointVerdict {
    /// It is where an honest hand would have it.
    Right,
    /// It is elsewhere.
    Off,
    /// The picture cannot tell: the place could be right or off.
    #[serde(rename = "open")]
    CannotTell,
}

impl PointVerdict {
    /// The verdict on a point that is `distance` from its right place and known within `band`, where an honest hand may be off by `tolerance`; all
    /// in mm.
    #[must_use]
    pub fn of(distance: f64, band: f64, tolerance: f64) -> PointVerdict {
        match (distance + band <= tolerance, distance - band > tolerance) {
            (true, _) => PointVerdict::Right,
            (_, true) => PointVerdict::Off,
            _ => PointVerdict::CannotTell,
        }
    }
}

impl<'a> PencilledPlan<'a> {
    /// What a photographed sheet of a scene says is on it and its points are read of.
    pub fn on(
        solution: &'a Solution,
        sheet: &'a PhotoSheet,
        strokes: &'a [Stroke],
    ) -> impl Iterator<Item = PencilledPlan<'a>> {
        sheet.code.panels.iter().filter_map(move |placed| {
            let points = PaperPoints::of(solution, placed.panel)?;
            let origin = placed.at(points.origin_on_panel().into());
            Some(PencilledPlan { points, mu: placed.mu, origin, strokes, sheet })
        })
    }

    /// Which sheet of the construction it is.
    #[must_use]
    pub fn of(&self) -> Sheet {
        self.points.sheet
    }

    /// A place on the sheet from the origin, in mm, y up.
    #[must_use]
    pub fn from_origin(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x - self.origin[0], self.origin[1] - y]
    }

    /// The place on the sheet of one given from the origin, in mm, y up.
    #[must_use]
    pub fn on_sheet(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x + self.origin[0], self.origin[1] - y]
    }

    /// The place that somebody means who points at one on the sheet: where pencil lines cross within `reach` mm, else that place itself, which
    /// the hand meets within `aim` mm with 95 %.
    #[must_use]
    pub fn aimed(&self, at: [f64; 2], reach: f64, aim: f64) -> Aimed {
        let found = crossing(self.strokes, Point::from(at), reach);
        let (at, own) = found.map_or((at, aim), |found| (found.at.into(), found.band));
        Aimed { at, band: libm::hypot(own, self.sheet.band(at)), is_crossing: found.is_some() }
    }

    /// Radius that holds a student's point with 95 %, in mm.
    #[must_use]
    pub fn band(&self, point: &PlacedPoint) -> f64 {
        point.band.unwrap_or_else(|| libm::hypot(AIMED, self.sheet.band(self.on_sheet(point.at))))
    }

    /// How far a student's point is from its right place, in mm, and what that tells. The plan hangs on the student's pole, on the printed one without; so a
    /// figure of centres on the mechanism's first point.
    #[must_use]
    pub fn judged(
        &self,
        point: &PlacedPoint,
        pole: Option<&PlacedPoint>,
        (right, tolerance): ([f64; 2], f64),
    ) -> (f64, PointVerdict) {
        let origin = pole.map_or([0.0; 2], |pole| pole.at);
        let off = libm::hypot(point.at[0] - origin[0] - right[0], point.at[1] - origin[1] - right[1]);
        let unsure = libm::hypot(self.band(point), pole.map_or(0.0, |pole| self.band(pole)));
        (off, PointVerdict::of(off, unsure, tolerance))
    }
}

/// A length in mm to 0.01.
#[must_use]
pub fn hundredths(mm: f64) -> f64 {
    libm::round(100.0 * mm) / 100.0 + 0.0
}
