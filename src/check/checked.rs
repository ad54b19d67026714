use super::answer_key::AnswerKey;
use super::diagnosis::diagnose;
use super::entry::{Entry, entries_by};
use super::explanation::Diagnosis;
use super::model::NotRead;
use super::points::is_mirrored;
use super::prepared::Prepared;
use super::sheet::{CheckError, Measured};
use super::verdict::{Judged, Verdict};
use crate::construction::PlanKind;
use crate::quantity::{Band, Kind, Reading};

/// All values with their verdicts, and the mistakes that explain those that are off.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The values in the order of the construction.
    pub values: Vec<Judged>,
    /// The mistakes that explain them.
    pub diagnosis: Diagnosis,
    /// Plans whose places on paper are the mirror image of the right ones; lengths alone do not show it.
    pub mirrored: Vec<PlanKind>,
}

impl Checked {
    /// Whether no value is off, and no plan mirrored.
    #[must_use]
    pub fn is_passed(&self) -> bool {
        self.mirrored.is_empty() && self.values.iter().all(|v| v.verdict != Verdict::Off)
    }
}

/// Tolerance of a value, in bands. Of 100 honest drawings at least 95 keep a single value within its band; so that a
/// whole drawing of dozens of values passes as surely, each may be off by two bands, 4.2 standard deviations.
pub const BANDS: f64 = 2.0;

/// The verdicts on the values that somebody has read from a drawing, and the mistakes that explain the values.
///
/// # Errors
/// A value is not understood.
pub fn check(measured: &Measured, key: &AnswerKey<'_>) -> Result<Checked, CheckError> {
    Prepared::new(key).check(measured)
}

impl Prepared<'_> {
    /// The same as [`check`], for one of many forms.
    ///
    /// # Errors
    /// A value is not understood.
    pub fn check(&self, measured: &Measured) -> Result<Checked, CheckError> {
        let key = &self.key;
        let entries = entries_by(measured, key, &self.names)?;
        let ready = self.ready(measured.mu, &entries)?;
        let model = &ready.right;
        let judged = entries.into_iter().zip(&ready.bands).zip(&model.readings);
        let values: Vec<Judged> = judged.map(|((entry, band), reading)| judged_by(entry, *band, *reading)).collect();
        let diagnosis = diagnose(key, &ready, &values);
        let plans = key.solution.construction.plans();
        let mirrored = plans.filter(|plan| {
            let mut places = measured.points.iter().filter(|p| p.kind == plan.kind);
            places.any(|points| is_mirrored(points, plan))
        });
        Ok(Checked { values, diagnosis, mirrored: mirrored.map(|plan| plan.kind).collect() })
    }
}

/// A value with its verdict: how it is read, and the band of honest drawings.
fn judged_by(entry: Entry, band: Option<Band>, reading: Result<Reading, NotRead>) -> Judged {
    let mut difference =
        if entry.is_magnitude { entry.value.abs() - entry.expected.abs() } else { entry.value - entry.expected };
    if entry.asked.kind() == Kind::Angle {
        difference -= 360.0 * libm::round(difference / 360.0);
    }
    // Segments and lengths have no sign, whatever sign is written.
    if reading.is_ok_and(|r| r.is_size()) {
        difference = entry.value.abs() - entry.expected.abs();
    }
    let tolerance = band.map(|band| BANDS * band.band + entry.rounding);
    let is_given = reading.is_err_and(|why| why.is_given());
    let off = difference.abs();
    // The factor 1.001 lets a last digit be rounded either way where the next is a five.
    let verdict = if off <= 1.001 * entry.rounding {
        Verdict::Right
    } else {
        match tolerance {
            Some(tolerance) if off <= tolerance => Verdict::WithinTolerance,
            None if !is_given => Verdict::Unjudged,
            _ => Verdict::Off,
        }
    };
    Judged { entry, verdict, difference, tolerance, is_rough: band.is_some_and(|band| band.is_rough) }
}
