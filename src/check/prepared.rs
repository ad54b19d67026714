//! The check of a form, and what the forms of a class have in common, worked out once: the names of the scene's quantities,
//! and for each set of quantities that forms have the constructions and the bands with which their values are compared.

use super::checked::{Accuracy, Checked, Diagnosis, Judged, Verdict};
use super::common::CommonError;
use super::covariance::{Groups, SLIP};
use super::entry::{Entry, entries_by, is_empty};
use super::measured::{AnswerKey, CheckError, Measured, PointsOf};
use super::mistakes::{Candidate, Site};
use super::model::{COMPUTING, Model};
use super::names::Names;
use super::on_paper::PaperPoints;
use super::placed::turned;
use super::score::Scorer;
use super::search::{Search, hand, other_modes};
use super::sensible::sensible;
use super::verdicts::{ENOUGH, judged, widened};
use crate::construction::Tolerance;
use crate::quantity::Band;
use crate::sheet::{PerSheet, Scales};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// An answer key for many forms, which may be checked on many cores at once: the first form takes longest.
#[derive(Debug)]
pub struct Prepared<'a> {
    key: AnswerKey<'a>,
    names: Names<'a>,
    ready: Mutex<BTreeMap<Asking, Arc<Ready>>>,
    /// The exact values of the form's rows.
    exact: OnceLock<BTreeMap<String, f64>>,
}

/// The quantities of a form in their order, and the bits of its scales.
type Asking = (Vec<String>, PerSheet<Option<u64>>);

/// How near an exact value most values are that may be of another exercise, in parts of it.
const NEAR: f64 = 0.15;

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
        Prepared { key: *key, names: Names::new(key.solution), ready: Mutex::default(), exact: OnceLock::new() }
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

    /// Whether values that were checked against another exercise are rather this one's.
    #[must_use]
    pub fn has_rather(&self, measured: &Measured, other: &Checked) -> bool {
        let exact = self.exact.get_or_init(|| {
            let value = |row: &str| Some((row.to_owned(), self.names.quantity(row).ok()?.expected));
            self.names.rows().filter_map(value).collect()
        });
        // Most exercises are ruled out at a glance.
        let is_near = |value: &&Judged| {
            let right = exact.get(&value.entry.row).map(|exact| exact.abs());
            right.is_some_and(|right| (value.entry.value.abs() - right).abs() <= NEAR * right)
        };
        2 * other.values.iter().filter(is_near).count() >= other.values.len()
            && self.verdicts(measured).is_ok_and(|verdicts| other.are_rather(&verdicts))
    }

    /// The verdicts on the values of a form for a careful hand, without a search for mistakes.
    ///
    /// # Errors
    /// A value is not understood.
    fn verdicts(&self, measured: &Measured) -> Result<Vec<Verdict>, CheckError> {
        let measured = &self.with_usual_points(measured);
        let entries = entries_by(measured, &self.key, &self.names)?;
        let (mu, _) = sensible(&self.key, measured.mu);
        let ready = self.ready(mu, &entries)?;
        Ok(judged(&entries, &ready.right, &ready.bands).into_iter().map(|value| value.verdict).collect())
    }

    /// The verdicts on the values of one of many forms, and the mistakes that explain them, as by [`check`].
    ///
    /// # Errors
    /// A value is not understood.
    pub fn check(&self, measured: &Measured) -> Result<Checked, CheckError> {
        let measured = &self.with_usual_points(measured);
        match entries_by(measured, &self.key, &self.names)? {
            entries if entries.is_empty() => Err(is_empty()),
            entries => self.checked(measured, entries),
        }
    }

    /// The same of the form that a drawing gives, which may have no values yet.
    ///
    /// # Errors
    /// The scene's figure lacks a sheet.
    pub fn check_drawn(&self, form: &Measured) -> Result<Checked, CheckError> {
        self.checked(form, entries_by(form, &self.key, &self.names)?)
    }

    fn checked(&self, measured: &Measured, mut entries: Vec<Entry>) -> Result<Checked, CheckError> {
        let key = &self.key;
        let (mu, scales) = sensible(key, measured.mu);
        let ready = self.ready(mu, &entries)?;
        let common = CommonError::of(&entries, &ready.right, &ready.bands);
        if let Some(common) = common {
            common.take_out(&mut entries, &ready.right);
        }
        let values = judged(&entries, &ready.right, &ready.bands);
        let is_searched = ready.right.construction.operations.len() <= SEARCHED;
        let Explained { values, diagnosis, accuracy } = match is_searched {
            true => self.explained(&ready, mu, &entries, values),
            false => {
                Explained { diagnosis: Diagnosis { looked_at: 0, ..Diagnosis::none(&values) }, accuracy: None, values }
            }
        };
        let mirrored = PaperPoints::all(key.solution).filter(|own| {
            let mut places = measured.points.iter().filter(|points| points.sheet == own.sheet);
            places.any(|points| points.is_mirrored(own))
        });
        let mirrored = mirrored.map(|own| own.sheet).collect();
        let (turned, missing) = (turned(measured, key.solution), self.missing(&entries));
        let hints = measured.hints;
        Ok(Checked { values, diagnosis, accuracy, mirrored, turned, missing, scales, common, values_of: None, hints })
    }

    /// Verdicts with what explains them: the tolerance of the hand that the values show, and the mistakes.
    fn explained(&self, ready: &Ready, mu: Scales, entries: &[Entry], mut values: Vec<Judged>) -> Explained {
        let key = &self.key;
        let has_off = |values: &[Judged]| values.iter().any(|v| v.verdict == Verdict::Off);
        let with_other_modes = || {
            let others = other_modes(key, mu, entries);
            [ready.right.clone()].into_iter().chain(others).collect()
        };
        let models = match has_off(&values) {
            true => ready.models.get_or_init(with_other_modes).as_slice(),
            false => core::slice::from_ref(&ready.right),
        };
        let Look { first, all } = Look::at(&values);
        let kept = OnceLock::new();
        let groups = if all == entries.len() { &ready.groups } else { &kept };
        let cut: Vec<Model>;
        let models = match all == entries.len() {
            true => models,
            false => {
                cut = models.iter().map(|model| model.first(all)).collect();
                &cut
            }
        };
        let scorer = Scorer::new(models, &entries[..all], key, groups);
        let none = scorer.compare(&[], None).filter(|_| !scorer.data.is_empty());
        let mut hand_found = none.as_ref().map(|fit| fit.hand);
        let mut diagnosis = Diagnosis::none(&values);
        if let Some(none) = none
            && has_off(&values)
            && !is_all_alike(entries)
            && !is_coarse(entries)
        {
            let pool = match first == all {
                true => candidates(models, key, &entries[..all], &values),
                false => {
                    self.causes(&models.iter().map(|model| model.first(first)).collect::<Vec<_>>(), &values[..first])
                }
            };
            let mut search = Search::new(pool, &scorer);
            let tried = search.run(none, &off(&scorer, &values), key.depth);
            let told = |values: &[Judged]| match has_off(values) {
                true => search.diagnosis(&tried, values),
                false => Diagnosis::none(values),
            };
            hand_found = hand(&tried).or(hand_found);
            let outside = tried.first().map_or(&[][..], |best| &best.fit.outside);
            let wider = hand(&tried).map(|hand| widened(&values, entries, &scorer, &hand, outside, key));
            diagnosis = told(wider.as_ref().unwrap_or(&values));
            match wider {
                // Values that nothing explains scatter as no hand does.
                Some(_) if diagnosis.unexplained.len() * MOST_OPEN > values.len() => {
                    (hand_found, diagnosis) = (None, told(&values));
                }
                Some(wider) => values = wider,
                None => {}
            }
        }
        diagnosis.looked_at = all;
        let Tolerance { mm, degrees } = key.tolerance;
        let accuracy = hand_found.filter(|_| scorer.data.len() >= ENOUGH).map(|hand| Accuracy {
            mm: hand.worst() * mm,
            degrees: hand.worst() * degrees,
            percent: SLIP * hand.errors[COMPUTING],
        });
        Explained { values, diagnosis, accuracy }
    }

    /// The mistakes in the likeliest explanations of the first values of a form, which the construction cut off behind them gives.
    fn causes(&self, models: &[Model], values: &[Judged]) -> Vec<Candidate> {
        let (key, groups) = (&self.key, OnceLock::new());
        let entries: Vec<Entry> = values.iter().map(|value| value.entry.clone()).collect();
        let scorer = Scorer::new(models, &entries, key, &groups);
        let Some(none) = scorer.compare(&[], None) else { return Vec::new() };
        let mut search = Search::new(candidates(models, key, &entries, values), &scorer);
        let tried = search.run(none, &off(&scorer, values), key.depth);
        let mut likely: Vec<usize> = tried.iter().take(LIKELY).flat_map(|tried| tried.set.iter().copied()).collect();
        likely.sort_unstable();
        likely.dedup();
        likely.into_iter().map(|index| search.pool[index].clone()).collect()
    }

    /// The rows of the scene's form that have no value, whatever the student's form has boxes for.
    fn missing(&self, entries: &[Entry]) -> Vec<String> {
        let given: BTreeSet<&str> = entries.iter().map(|entry| entry.row.as_str()).collect();
        self.names.all_asked().filter(|row| !given.contains(row)).map(str::to_owned).collect()
    }

    /// The values with the usual names of plan points, which may be written in any notation.
    fn with_usual_points(&self, measured: &Measured) -> Measured {
        let mut measured = measured.clone();
        for PointsOf { sheet, places } in &mut measured.points {
            *places = places.iter().map(|(name, at)| (self.names.usual_point(*sheet, name), *at)).collect();
        }
        measured
    }
}

/// All mistakes that may have led to the first values of a form, of which these are the verdicts.
fn candidates(models: &[Model], key: &AnswerKey<'_>, entries: &[Entry], values: &[Judged]) -> Vec<Candidate> {
    let tolerances: Vec<f64> = values.iter().map(|value| value.tolerance).collect();
    let site = Site { model: &models[0], key, entries, tolerances: &tolerances, other_modes: models.len() - 1 };
    site.candidates()
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

/// Verdicts on values, and what explains them.
struct Explained {
    values: Vec<Judged>,
    diagnosis: Diagnosis,
    accuracy: Option<Accuracy>,
}

/// Most operations of a construction in which mistakes are looked for: some fifty links. Nobody draws more by hand, and places for mistakes
/// grow with their square.
pub(super) const SEARCHED: usize = 500;

/// At how many values of a large form the search for mistakes looks: its work grows with their number's third power.
#[derive(Clone, Copy)]
struct Look {
    /// The first values, in which causes are looked for: as far as some behind the first that is off.
    first: usize,
    /// The first values by which these causes are weighed.
    all: usize,
}

/// One in so many values may be off for no known reason where the scatter of all shows how good a hand is.
const MOST_OPEN: usize = 4;

/// Values behind the first that is off in which causes are looked for.
const BEHIND: usize = 60;

/// Most values by which causes are weighed.
const WEIGHED: usize = 150;

/// Explanations of the first values of a large form whose mistakes are weighed by more values.
const LIKELY: usize = 6;

impl Look {
    fn at(values: &[Judged]) -> Look {
        let off = values.iter().position(|value| value.verdict == Verdict::Off).unwrap_or(0);
        let all = values.len().min(WEIGHED);
        Look { first: all.min(off + BEHIND), all }
    }
}

/// By datum: whether its verdict is off.
fn off(scorer: &Scorer<'_>, values: &[Judged]) -> Vec<bool> {
    scorer.data.iter().map(|datum| values[datum.entry].verdict == Verdict::Off).collect()
}

/// Whether one number is written everywhere: nothing was measured, so no mistake is looked for.
fn is_all_alike(entries: &[Entry]) -> bool {
    entries.len() > 2 && entries.iter().all(|entry| entry.text == entries[0].text && !entry.text.is_empty())
}

/// Whether most values are written with so few digits that any mistake could explain them.
fn is_coarse(entries: &[Entry]) -> bool {
    2 * entries.iter().filter(|entry| entry.has_one_digit()).count() > entries.len()
}
