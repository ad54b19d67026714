//! The check of a form, and what the forms of a class have in common, worked out once: the names of the scene's quantities,
//! and for each set of quantities that forms have the constructions and the bands with which their values are compared.

use super::checked::{Accuracy, BANDS, Checked, Diagnosis, Judged, Verdict};
use super::covariance::{Groups, Hand, SLIP};
use super::entry::{Entry, entries_by};
use super::measured::{AnswerKey, CheckError, Measured, PointsOf};
use super::mistakes::Site;
use super::model::{COMPUTING, Model};
use super::names::Names;
use super::score::Scorer;
use super::search::{Search, hand, other_modes};
use crate::construction::Tolerance;
use crate::geometry::with_turns;
use crate::quantity::{Band, Unread};
use crate::sheet::{PerSheet, QuantityKind, Scales};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// An answer key for many forms, which may be checked on many cores at once: the first form takes longest.
#[derive(Debug)]
pub struct Prepared<'a> {
    key: AnswerKey<'a>,
    names: Names<'a>,
    ready: Mutex<BTreeMap<Asking, Arc<Ready>>>,
}

/// The quantities of a form in their order, and the bits of its scales.
type Asking = (Vec<String>, PerSheet<Option<u64>>);

/// Most sets of quantities that are kept: forms are alike, or blanks are left in each at other places.
const KEPT: usize = 50;

/// What forms with the same quantities at the same scales are compared with.
#[derive(Debug)]
struct Ready {
    /// The right construction, followed by the readings of the quantities.
    right: Model,
    /// By quantity: the band of honest drawings, where there is one.
    bands: Vec<Option<Band>>,
    /// The right construction, and those of the other assembly modes.
    models: OnceLock<Vec<Model>>,
    /// The covariances of a right drawing that the errors of hands cause.
    groups: OnceLock<Groups>,
}

impl<'a> Prepared<'a> {
    /// Makes an answer key ready for many forms.
    #[must_use]
    pub fn new(key: &AnswerKey<'a>) -> Prepared<'a> {
        Prepared { key: *key, names: Names::new(key.solution), ready: Mutex::default() }
    }

    /// The answer key.
    #[must_use]
    pub fn key(&self) -> &AnswerKey<'a> {
        &self.key
    }

    /// What a form's values are compared with.
    fn ready(&self, mu: Scales, entries: &[Entry]) -> Result<Arc<Ready>, CheckError> {
        let names = entries.iter().map(|entry| entry.asked.name().to_owned());
        let asking = (names.collect(), mu.map(|mu| mu.map(f64::to_bits)));
        // A check that has panicked leaves the map as it was before or after.
        let kept = || self.ready.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(ready) = kept().get(&asking) {
            return Ok(Arc::clone(ready));
        }
        let right = Model::new(&self.key, self.key.solution, mu, entries)?;
        let bands = right.bands(&self.key.tolerance);
        let ready = Arc::new(Ready { right, bands, models: OnceLock::new(), groups: OnceLock::new() });
        let mut kept = kept();
        if kept.len() < KEPT {
            kept.insert(asking, Arc::clone(&ready));
        }
        Ok(ready)
    }

    /// The verdicts on the values of one of many forms, and the mistakes that explain them, as by [`check`].
    ///
    /// # Errors
    /// A value is not understood.
    pub fn check(&self, measured: &Measured) -> Result<Checked, CheckError> {
        let key = &self.key;
        let measured = &self.with_usual_points(measured);
        let entries = entries_by(measured, key, &self.names)?;
        let ready = self.ready(measured.mu, &entries)?;
        let mut values = judged(&entries, &ready);
        let has_off = |values: &[Judged]| values.iter().any(|v| v.verdict == Verdict::Off);
        let with_other_modes = || {
            let others = other_modes(key, measured.mu, &entries);
            [ready.right.clone()].into_iter().chain(others).collect()
        };
        let models = match has_off(&values) {
            true => ready.models.get_or_init(with_other_modes).as_slice(),
            false => core::slice::from_ref(&ready.right),
        };
        let scorer = Scorer::new(models, &entries, key.tolerance, &ready.groups);
        let none = scorer.compare(&[], None).filter(|_| !scorer.data.is_empty());
        let mut hand_found = none.as_ref().map(|fit| fit.hand);
        let diagnosis = match none {
            Some(none) if has_off(&values) && !is_all_alike(&entries) => {
                let site = Site { model: &models[0], key, entries: &entries, other_modes: models.len() - 1 };
                let mut search = Search::new(site.candidates(), &scorer);
                let off: Vec<bool> = scorer.data.iter().map(|d| values[d.entry].verdict == Verdict::Off).collect();
                let tried = search.run(none, &off, key.depth);
                if let Some(hand) = hand(&tried) {
                    hand_found = Some(hand);
                    widen(&mut values, &scorer, &hand, key);
                }
                if has_off(&values) { search.diagnosis(&tried, &values) } else { Diagnosis::none(&values) }
            }
            _ => Diagnosis::none(&values),
        };
        let plans = key.solution.construction.plans();
        let mirrored = plans.filter(|plan| {
            let mut places = measured.points.iter().filter(|p| p.order == plan.order);
            places.any(|points| points.is_mirrored(plan))
        });
        let Tolerance { mm, degrees } = key.tolerance;
        let accuracy = hand_found.filter(|_| scorer.data.len() >= ENOUGH).map(|hand| Accuracy {
            mm: hand.worst() * mm,
            degrees: hand.worst() * degrees,
            percent: SLIP * hand.errors[COMPUTING],
        });
        Ok(Checked { values, diagnosis, accuracy, mirrored: mirrored.map(|plan| plan.sheet()).collect() })
    }

    /// The values with the usual names of plan points, which may be written in any notation.
    fn with_usual_points(&self, measured: &Measured) -> Measured {
        let mut measured = measured.clone();
        for PointsOf { order, places } in &mut measured.points {
            *places = places.iter().map(|(name, at)| (self.names.usual_point(order.sheet(), name), *at)).collect();
        }
        measured
    }
}

/// The verdicts on the values that somebody has read from a drawing, and the mistakes that explain the values.
///
/// Where the scatter of all values shows that the hand is worse than the tolerance supposes, the tolerance follows it as
/// far as the key's leniency.
///
/// # Errors
/// A value is not understood.
pub fn check(measured: &Measured, key: &AnswerKey<'_>) -> Result<Checked, CheckError> {
    Prepared::new(key).check(measured)
}

/// Whether one number is written everywhere: nothing was measured, so no mistake is looked for.
fn is_all_alike(entries: &[Entry]) -> bool {
    entries.len() > 2 && entries.iter().all(|entry| entry.text == entries[0].text && !entry.text.is_empty())
}

/// The verdicts at the key's tolerance.
fn judged(entries: &[Entry], ready: &Ready) -> Vec<Judged> {
    let judged = entries.iter().zip(&ready.bands).zip(&ready.right.readings);
    let judged = judged.map(|((entry, band), reading)| {
        // Segments and lengths have no sign, whatever sign is written.
        let is_size = entry.is_magnitude || reading.is_ok_and(|r| r.is_size());
        let [value, expected] = [entry.value, entry.expected].map(|x| if is_size { x.abs() } else { x });
        let mut difference = value - expected;
        if entry.asked.kind() == QuantityKind::Angle {
            difference = with_turns(difference, 0.0);
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
        Judged { entry: entry.clone(), verdict, difference, tolerance }
    });
    judged.collect()
}

/// Lets the tolerances follow a hand that is worse than they suppose, as far as the key allows.
fn widen(values: &mut [Judged], scorer: &Scorer<'_>, hand: &Hand, key: &AnswerKey<'_>) {
    let mut allowed = *hand;
    allowed.errors.iter_mut().for_each(|size| *size = size.min(key.leniency));
    // A few values do not show how good a hand is.
    if key.leniency <= 1.0 || !hand.is_by_hand() || scorer.data.len() < ENOUGH {
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
