//! What a hand needs to find instant centres well.

use super::judge::Refusal;
use crate::check::BANDS;
use crate::construction::{CenterId, CenterOrigin, Construction, Solution, Spot};
use crate::drawing::{KeyRow, shows_centers};
use crate::geometry::{Place, span};
use crate::quantity::{QuantityRequest, What};
use crate::sheet::{Scales, Sheet};

/// Smallest distance of two centres on paper, in mm: of closer ones the line is uncertain.
const APART: f64 = 6.0;
/// Smallest distance from which a velocity or a ratio is found, in mm of paper.
const SHORTEST: f64 = 15.0;
/// Largest band of a centre's coordinate, in mm of paper.
const BAND: f64 = 2.0;
/// Largest band of the direction of one at infinity, in degrees.
const DIRECTION: f64 = 2.0;
/// Largest band of an inflection pole's coordinate, in parts of the diameter.
const OF_DIAMETER: f64 = 0.15;
/// Largest diameter of an inflection circle, in sizes of the mechanism.
const LARGEST: f64 = 1.2;

/// Whether lines lead to all centres that are wanted, and to those of the motion.
pub(super) fn are_constructed(construction: &Construction) -> Result<(), Refusal> {
    let Some(centers) = &construction.centers else { return Ok(()) };
    if !centers.by_rates.is_empty() {
        return Err(Refusal::NoConstruction);
    }
    match centers.agreement {
        Some(agreement) if agreement.difference > agreement.allowed => Err(Refusal::Routes),
        _ => Ok(()),
    }
}

/// The sine of the angle at which the lines of a centre cross; none of one at infinity.
pub(super) fn sine(construction: &Construction, id: CenterId) -> Option<f64> {
    let center = construction.center(id)?;
    match (&center.origin, center.place) {
        (CenterOrigin::Lines { sine, .. }, Place::At(_)) => Some(*sine),
        _ => None,
    }
}

/// Whether all centres have room on the sheet, none close to another, and distances are long enough.
pub(super) fn are_clear(solution: &Solution, scales: &Scales) -> Result<(), Refusal> {
    let Some(centers) = &solution.construction.centers else { return Ok(()) };
    let mu = scales[Sheet::Centers].ok_or(Refusal::Sheet)?;
    if !shows_centers(solution) {
        return Err(Refusal::CenterFar);
    }
    let size = span(solution.pose.points.iter().copied());
    if centers.inflections.iter().any(|found| found.diameter > LARGEST * size) {
        return Err(Refusal::CenterFar);
    }
    let places = || {
        centers.all.iter().filter_map(|center| match (center.spot, center.place) {
            (Spot::At(id), Place::At(place)) => Some((id, place)),
            _ => None,
        })
    };
    for (id, place) in places() {
        if places().any(|(other, at)| other != id && (at - place).norm() < APART * mu) {
            return Err(Refusal::CentersClose);
        }
    }
    for name in solution.construction.steps_by_hand().flat_map(|step| step.names()) {
        let asked = QuantityRequest::new(&name, &solution.mechanism).map_err(|_| Refusal::NoConstruction)?;
        if matches!(asked.what, What::Length(..)) && asked.sheet() == Sheet::Centers {
            let value = asked.value(&solution.snapshot(), None, None).map_err(|_| Refusal::NoConstruction)?;
            if value.as_number() < SHORTEST * mu {
                return Err(Refusal::CenterDistance);
            }
        }
    }
    Ok(())
}

/// Whether a hand finds the places of all centres well.
pub(super) fn are_sure(rows: &[KeyRow<'_>], scales: &Scales) -> Result<(), Refusal> {
    let mut places = rows.iter().filter(|row| matches!(row.asked.what, What::Pole(_)));
    let most = scales[Sheet::Centers].map_or(0.0, |mu| BAND * mu);
    let diameters = rows.iter().filter(|row| matches!(row.asked.what, What::InflectionDiameter(_)));
    let diameter = diameters.map(|row| row.value).fold(f64::INFINITY, f64::min);
    let most_of = |row: &KeyRow<'_>| {
        BANDS
            * match &row.asked.what {
                What::Pole(pole) if pole.of.pair().is_none() => most.max(OF_DIAMETER * diameter),
                _ if row.asked.is_line() => DIRECTION,
                _ => most,
            }
    };
    match places.all(|row| row.allowed.is_some_and(|allowed| allowed <= most_of(row))) {
        true => Ok(()),
        false => Err(Refusal::CenterUnsure),
    }
}
