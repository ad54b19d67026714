use super::answer_key::AnswerKey;
use super::entry::{Entry, entries_by};
use super::error::CheckError;
use super::explanation::Diagnosis;
use super::hand::{Hand, SLIP};
use super::mistakes::Site;
use super::model::COMPUTING;
use super::points::is_mirrored;
use super::prepared::{Prepared, Ready};
use super::score::Scorer;
use super::search::{Search, hand};
use super::sheet::Measured;
use super::shown::ShownNames;
use super::verdict::{Judged, Verdict};
use crate::construction::Tolerance;
use crate::quantity::{QuantityKind, Unread};
use crate::sheet::Sheet;
use schemars::JsonSchema;
use serde::Serialize;

/// All values with their verdicts, and the mistakes that explain those that are off.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Checked {
    /// The values in the order of the construction.
    pub values: Vec<Judged>,
    /// The mistakes that explain them.
    pub diagnosis: Diagnosis,
    /// How accurate the drawing is, as the scatter of its values shows; `None` where too few are drawn.
    pub accuracy: Option<Accuracy>,
    /// Plans whose places on paper are the mirror image of the right ones; lengths alone do not show it.
    pub mirrored: Vec<Sheet>,
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

/// How accurate somebody draws and computes. Within the limits every error is equally likely.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "AccuracyResult")]
#[non_exhaustive]
pub struct Accuracy {
    /// Limit of the errors in lengths and places, in mm of paper.
    pub mm: f64,
    /// Limit of the errors in directions, in degrees.
    pub degrees: f64,
    /// Limit of the errors of computed numbers, in per cent; 0 where no slips are seen.
    pub percent: f64,
}

impl Accuracy {
    fn of(hand: &Hand, key: &AnswerKey<'_>) -> Accuracy {
        let size = hand.worst();
        let Tolerance { mm, degrees } = key.tolerance;
        Accuracy { mm: size * mm, degrees: size * degrees, percent: SLIP * hand.errors[COMPUTING] }
    }
}

/// The verdicts on the values that somebody has read from a drawing, and the mistakes that explain the values.
///
/// Where the scatter of all values shows that the hand is worse than the tolerance supposes, the tolerance follows it as
/// far as the key's latitude.
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
        let measured = &with_usual_points(measured, key);
        let entries = entries_by(measured, key, &self.names)?;
        let ready = self.ready(measured.mu, &entries)?;
        let mut values = judged(&entries, &ready);
        let has_off = |values: &[Judged]| values.iter().any(|v| v.verdict == Verdict::Off);
        let models = if has_off(&values) { ready.models(key, &entries) } else { core::slice::from_ref(&ready.right) };
        let scorer = Scorer::new(models, &entries, key.tolerance, &ready.groups);
        let none = scorer.compare(&[], None).filter(|_| !scorer.data.is_empty());
        let mut accuracy = none.as_ref().map(|fit| Accuracy::of(&fit.hand, key));
        let diagnosis = match none {
            Some(none) if has_off(&values) && !is_all_alike(&entries) => {
                let site = Site { model: &models[0], key, entries: &entries, other_modes: models.len() - 1 };
                let mut search = Search::new(site.candidates(), &scorer);
                let off: Vec<bool> = scorer.data.iter().map(|d| values[d.entry].verdict == Verdict::Off).collect();
                let tried = search.run(none, &off, key.depth);
                if let Some(hand) = hand(&tried) {
                    accuracy = Some(Accuracy::of(&hand, key));
                    widen(&mut values, &scorer, &hand, key);
                }
                if has_off(&values) { search.diagnosis(&tried, &values) } else { Diagnosis::none(&values) }
            }
            _ => Diagnosis::none(&values),
        };
        let plans = key.solution.construction.plans();
        let mirrored = plans.filter(|plan| {
            let mut places = measured.points.iter().filter(|p| p.kind == plan.sheet);
            places.any(|points| is_mirrored(points, plan))
        });
        let accuracy = accuracy.filter(|_| scorer.data.len() >= ENOUGH);
        Ok(Checked { values, diagnosis, accuracy, mirrored: mirrored.map(|plan| plan.sheet).collect() })
    }
}

/// Whether one number is written everywhere: nothing was measured, so no mistake is looked for.
fn is_all_alike(entries: &[Entry]) -> bool {
    entries.len() > 2 && entries.iter().all(|entry| entry.text == entries[0].text && !entry.text.is_empty())
}

/// The verdicts at the key's tolerance.
fn judged(entries: &[Entry], ready: &Ready) -> Vec<Judged> {
    let judged = entries.iter().zip(&ready.bands).zip(&ready.right.readings);
    let judged = judged.map(|((entry, band), reading)| {
        let mut difference =
            if entry.is_magnitude { entry.value.abs() - entry.expected.abs() } else { entry.value - entry.expected };
        if entry.asked.kind() == QuantityKind::Angle {
            difference -= 360.0 * libm::round(difference / 360.0);
        }
        // Segments and lengths have no sign, whatever sign is written.
        if reading.is_ok_and(|r| r.is_size()) {
            difference = entry.value.abs() - entry.expected.abs();
        }
        let tolerance = band.map(|band| BANDS * band.band + entry.rounding);
        let is_given = *reading == Err(Unread::Given);
        let has_no_sense = entry.is_magnitude && entry.value != 0.0;
        let off = difference.abs();
        // The factor 1.001 lets a last digit be rounded either way where the next is a five.
        let verdict = match tolerance {
            _ if off <= 1.001 * entry.rounding => Verdict::Right,
            Some(tolerance) if off <= tolerance => Verdict::WithinTolerance,
            None if !is_given => Verdict::Unjudged,
            _ => Verdict::Off,
        };
        let verdict = match verdict {
            Verdict::Right | Verdict::WithinTolerance if has_no_sense => Verdict::SenseMissing,
            judged => judged,
        };
        Judged {
            entry: entry.clone(),
            verdict,
            difference,
            tolerance,
            is_rough: band.is_some_and(|band| band.is_rough),
        }
    });
    judged.collect()
}

/// Lets the tolerances follow a hand that is worse than they suppose, as far as the key allows.
fn widen(values: &mut [Judged], scorer: &Scorer<'_>, hand: &Hand, key: &AnswerKey<'_>) {
    let mut allowed = *hand;
    allowed.errors.iter_mut().for_each(|size| *size = size.min(key.latitude));
    // A few values do not show how good a hand is.
    if key.latitude <= 1.0 || !hand.is_by_hand() || scorer.data.len() < ENOUGH {
        return;
    }
    for (place, datum) in scorer.data.iter().enumerate() {
        let value = &mut values[datum.entry];
        let tolerance = BANDS * BAND * scorer.spread(place, &allowed) + value.entry.rounding;
        if value.tolerance.is_some_and(|usual| usual < tolerance) {
            value.tolerance = Some(tolerance);
            if value.verdict == Verdict::Off && value.difference.abs() <= tolerance {
                value.verdict = Verdict::WithinTolerance;
            }
        }
    }
}

/// Least number of drawn values whose scatter shows how accurate a hand is.
const ENOUGH: usize = 8;

/// Half a band, in standard deviations: 95 of 100 values are within.
const BAND: f64 = 1.96;

/// The same with the usual names of plan points, which may be written in any notation.
fn with_usual_points(measured: &Measured, key: &AnswerKey<'_>) -> Measured {
    let shown = ShownNames::of(key.solution);
    let mut measured = measured.clone();
    for points in &mut measured.points {
        let sheet = points.kind;
        points.places = points.places.iter().map(|(name, at)| (shown.usual_point(sheet, name), *at)).collect();
        points.bands = points.bands.iter().map(|(name, band)| (shown.usual_point(sheet, name), *band)).collect();
    }
    measured
}
