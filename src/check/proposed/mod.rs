//! Points of plans and of figures of instant centres proposed from the pencil lines of a photograph, and what each of them tells.
//!
//! The construction is carried out once more along the pencil lines, from the poles on: where lines are that an operation may have drawn, its result is where they are, and later
//! operations go on from there. Where the right plan has its points is not asked: what an operation asks for is one way to read the lines among others, and what it cannot
//! begin at is not looked for. So errors of the hand do not add up, and a mistake shows as lines that only it leads to.

mod ink;
mod reading;

use super::checked::BANDS;
use super::measured::{AnswerKey, CheckError, Measured, PointsOf};
use super::model::Model;
use super::photographs::{PencilledPlan, PointVerdict, hundredths};
use super::placed::ROUNDING;
use crate::geometry::{Vector, cross};
use crate::quantity::{QuantityRequest, pencil};
use crate::sheet::Sheet;
use reading::{Reader, Reading};

/// Where a point seems to be, by the pencil lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Its place from the sheet's origin, in mm, y up.
    pub at: [f64; 2],
    /// Radius that holds it with 95 %, in mm.
    pub band: f64,
    /// What its place tells.
    pub verdict: PointVerdict,
}

/// A point of a sheet: where it should be, and where it seems to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    /// Of which sheet.
    pub sheet: Sheet,
    /// Its name, as in `b`, `n_b3` or `P(1,3)`.
    pub name: String,
    /// Its right place from the sheet's origin, in mm, y up.
    pub right: [f64; 2],
    /// How far from there an honest hand may have it, in mm.
    pub tolerance: f64,
    /// Where it seems to be; `None` where that is left to the student.
    pub found: Option<Found>,
}

/// The form that proposals make: by sheet the places that were found, with the radii that hold them, to 0.01 mm.
#[must_use]
pub fn proposed_form(proposals: &[Proposal], plans: &[PencilledPlan<'_>], key: &AnswerKey<'_>) -> Measured {
    let mut measured = Measured { mu: key.scales, upright: true, ..Measured::default() };
    for plan in plans {
        measured.mu[plan.of()] = Some(plan.mu);
        let mut points = PointsOf::new(plan.of());
        points.put(plan.points.origin(), [0.0; 2], Some(hundredths(plan.sheet.band(plan.origin))));
        for point in proposals.iter().filter(|point| point.sheet == plan.of()) {
            if let Some(found) = point.found {
                points.put(point.name.as_str(), found.at.map(hundredths), Some(hundredths(found.band)));
            }
        }
        measured.points.push(points);
    }
    measured
}

/// What of a place no line tells: where the student set the point of the pencil, as a radius in mm. An end of a vector shows more of it than
/// a crossing, which may be marked by 0.3 mm along x and y.
const SET: f64 = 0.27;
const SET_AT_CROSSING: f64 = 0.38;
/// By how much the logarithm of the odds of two readings differs for each that speaks more for one of them.
const ODDS: f64 = 1.5;
/// Least share of the odds with which a place is proposed.
const SURE: f64 = 0.95;
/// Distance of two places that are not the same point, in mm.
const APART: f64 = 0.5;

/// The points of some plans, in the order of the construction, as the pencil lines of a student's sheets show them. They
/// are proposals: lines may mislead.
///
/// # Errors
/// The scene's figure lacks a sheet.
pub fn proposed(key: &AnswerKey<'_>, plans: &[PencilledPlan<'_>]) -> Result<Vec<Proposal>, CheckError> {
    let mut points = right_points(key, plans);
    let mut mu = key.scales;
    for plan in plans {
        mu[plan.of()] = Some(plan.mu);
    }
    let model = Model::new(key, key.solution, mu, &[])?;
    let readings = Reader::new(&model, plans).readings();
    for point in &mut points {
        point.found = agreed(&readings, &model, plans, point);
    }
    leave_coincident(&mut points);
    Ok(points)
}

/// Where nearly all that speaks for any reading has a point: `None` where too much speaks for other places, or for none.
fn agreed(readings: &[Reading], model: &Model, plans: &[PencilledPlan<'_>], point: &Proposal) -> Option<Found> {
    let place = model.construction.place(point.sheet, model.construction.plan_name(point.sheet, &point.name))?;
    let plan = plans.iter().find(|plan| plan.of() == point.sheet)?;
    let best = readings.first()?.worth;
    let spot = readings.iter().find_map(|reading| reading.sure_spot(place))?;
    let (mut here, mut all) = (0.0, 0.0);
    for reading in readings {
        let odds = libm::exp(ODDS * (reading.worth - best));
        all += odds;
        if reading.place(place).is_some_and(|other| (other - spot.at).norm() <= APART) {
            here += odds;
        }
    }
    if here < SURE * all {
        return None;
    }
    let at = [spot.at.x, spot.at.y];
    let set = if point.sheet.order().is_some() { SET } else { SET_AT_CROSSING };
    let band = libm::hypot(libm::hypot(spot.band, set), plan.sheet.band(plan.on_sheet(at)));
    let distance = libm::hypot(at[0] - point.right[0], at[1] - point.right[1]);
    Some(Found { at, band, verdict: PointVerdict::of(distance, band, point.tolerance) })
}

/// Leaves points to the student that seem to be at one place but should not be.
fn leave_coincident(points: &mut [Proposal]) {
    let apart = |a: [f64; 2], b: [f64; 2]| libm::hypot(a[0] - b[0], a[1] - b[1]);
    let places: Vec<Option<[f64; 2]>> = points.iter().map(|point| point.found.map(|found| found.at)).collect();
    for i in 0..points.len() {
        let is_taken = (0..points.len()).any(|j| {
            let both = places[i].zip(places[j]).is_some_and(|(a, b)| apart(a, b) < 1.0);
            i != j && points[i].sheet == points[j].sheet && both && apart(points[i].right, points[j].right) > 2.0
        });
        if is_taken {
            points[i].found = None;
        }
    }
}

/// Factors, less one, that common scales have: less is a hand's own, more is no sheet that was printed to fit.
const SCALES: [f64; 2] = [0.012, 0.12];
/// Least distance from a pole at which a point shows a scale, in mm.
const FAR: f64 = 20.0;

/// By which factor all points that were found are farther from their poles than they should be, as on a sheet that was not printed at 100 %, whose
/// squares are as much smaller as all else that is printed; `None` where they do not agree in one.
#[must_use]
pub fn common_scale(points: &[Proposal]) -> Option<f64> {
    let far = points.iter().filter_map(|point| {
        let (found, right) = (point.found?, Vector::from(point.right));
        (right.norm() > FAR).then(|| (Vector::from(found.at), right))
    });
    let pairs: Vec<(Vector, Vector)> = far.collect();
    let sum = |of: fn(&(Vector, Vector)) -> f64| pairs.iter().map(of).sum::<f64>();
    let scale = sum(|(found, right)| found.dot(right)) / sum(|(_, right)| right.norm_squared());
    // Each by itself: a quarter of the difference is a hand's.
    let agrees = |(found, right): &(Vector, Vector)| {
        let (own, across) = (found.dot(right) / right.norm_squared(), cross(*right, *found) / right.norm_squared());
        (own - scale).abs() < 0.25 * (scale - 1.0).abs() + 0.3 / right.norm()
            && across.abs() < 0.01 + 0.3 / right.norm()
    };
    let is_told = pairs.len() > 2 && (SCALES[0]..SCALES[1]).contains(&(scale - 1.0).abs());
    (is_told && pairs.iter().all(agrees)).then_some(scale)
}

/// The points of the sheets with their right places and the tolerances of these, without those at rest.
fn right_points(key: &AnswerKey<'_>, plans: &[PencilledPlan<'_>]) -> Vec<Proposal> {
    let mut points = Vec::new();
    for PencilledPlan { points: own, mu, .. } in plans {
        let asked = own.found().flat_map(|(name, _)| own.quantities(name));
        let asked = asked.filter_map(|name| QuantityRequest::new(&name, &key.solution.mechanism).ok());
        let mut scales = key.scales;
        scales[own.sheet] = Some(*mu);
        let pencil = pencil(key.solution, &scales, key.tolerance, asked.collect());
        for (name, place) in own.found() {
            let bands = own.quantities(name).into_iter().map(|quantity| Some(pencil.band(&quantity)?.band));
            let Some(bands) = bands.collect::<Option<Vec<f64>>>() else { continue };
            let right = [place.x / mu, place.y / mu];
            let band = bands.into_iter().fold(0.0, libm::hypot);
            let tolerance = (BANDS * band + ROUNDING * mu) / mu;
            points.push(Proposal { sheet: own.sheet, name: name.to_owned(), right, tolerance, found: None });
        }
    }
    points
}
