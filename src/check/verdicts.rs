//! The verdict on each value: by the band of honest hands, else by a coarse tolerance, by what its digits tell, and by a hand that is worse than
//! supposed.

use super::checked::{BANDS, Basis, Judged, Verdict};
use super::covariance::Hand;
use super::entry::Entry;
use super::measured::AnswerKey;
use super::model::Model;
use super::score::Scorer;
use super::written::half_unit;
use crate::quantity::{Band, QuantityRequest, Unread};
use crate::sheet::QuantityKind;

/// The verdicts at the key's tolerance.
pub(super) fn judged(entries: &[Entry], right: &Model, bands: &[Option<Band>]) -> Vec<Judged> {
    let judged = entries.iter().zip(bands).zip(&right.readings);
    let judged = judged.map(|((entry, band), reading)| {
        // Segments and lengths have no sign, whatever sign is written.
        let is_size = entry.is_magnitude || reading.is_ok_and(|r| r.is_size());
        let [value, expected] = [entry.value, entry.expected].map(|x| if is_size { x.abs() } else { x });
        let difference = entry.asked.turned(value - expected);
        let largest = largest(entries, entry.asked.kind());
        let (basis, allowed) = match (band, reading) {
            (Some(band), _) => (Basis::Drawn, BANDS * band.band),
            (None, Err(Unread::Given)) => (Basis::Given, 0.0),
            (None, _) => (Basis::Coarse, coarse(&entry.asked, expected, largest)),
        };
        let telling = Telling::new(&entry.asked, expected, largest);
        let rounding = telling.counted(entry, allowed);
        let tolerance = allowed + rounding;
        let has_no_sense = entry.is_magnitude && entry.value != 0.0;
        let off = difference.abs();
        // The factor 1.001 lets a last digit be rounded either way where the next is a five.
        let verdict = match () {
            () if off > (allowed + entry.rounding).max(1.001 * entry.rounding) + entry.doubt => Verdict::Off,
            () if off > tolerance.max(1.001 * rounding) => Verdict::TooCoarse,
            () if telling.is_too_coarse(entry.rounding, allowed) => Verdict::TooCoarse,
            () if off <= 1.001 * entry.rounding => Verdict::Right,
            () if telling.is_too_small(allowed, off) => Verdict::TooSmall,
            () => Verdict::WithinTolerance,
        };
        let verdict = match verdict {
            Verdict::Right | Verdict::WithinTolerance if has_no_sense => Verdict::SenseMissing,
            judged => judged,
        };
        Judged { entry: entry.clone(), verdict, difference, tolerance, basis }
    });
    judged.collect()
}

/// What is allowed of a value that no hand constructs, in parts of it; of an angle in degrees.
pub(super) const COARSE: f64 = 0.05;
pub(super) const COARSE_DEGREES: f64 = 2.0;

/// The same at least, in parts of the largest value of its kind: beside that a small one may be nothing.
const COARSE_LEAST: f64 = 0.01;

/// What is allowed of a value for which no construction by hand says how near a hand comes.
fn coarse(asked: &QuantityRequest, expected: f64, largest: f64) -> f64 {
    match asked.kind() {
        QuantityKind::Angle => COARSE_DEGREES,
        _ => (COARSE * expected.abs()).max(COARSE_LEAST * largest),
    }
}

/// What values of one kind must show to tell that somebody has found them.
#[derive(Clone, Copy, Debug)]
struct Telling {
    /// The exact value; 0 where it is nothing beside the largest of its kind.
    expected: f64,
    /// Largest half unit of a last digit that still tells something.
    fine: f64,
    is_angle: bool,
}

/// Largest half unit of a last digit with which a number still tells something, in parts of the exact value: one digit.
const ONE_DIGIT: f64 = 0.25;

/// The same of angles, and where the exact value is nothing, in parts of the largest value of its kind.
const OF_LARGEST: f64 = 0.02;

/// Significant digits whose rounding counts. One digit alone shows no drawing, and whoever guesses it is right too often.
const COUNTED: i32 = 2;

/// Size of a value that is nothing, in parts of the largest one of its kind.
const NOTHING: f64 = 1e-9;

impl Telling {
    fn new(asked: &QuantityRequest, expected: f64, largest: f64) -> Telling {
        let is_angle = asked.kind() == QuantityKind::Angle;
        let expected = if expected.abs() <= NOTHING * largest { 0.0 } else { expected };
        let fine = if is_angle || expected == 0.0 { OF_LARGEST * largest } else { ONE_DIGIT * expected.abs() };
        Telling { expected, fine, is_angle }
    }

    /// How far a value may be off for its digits, where honest hands are off by `drawn`: half a unit of its last one, but no more than two digits
    /// of the exact value need, or than such a hand is off by.
    fn counted(&self, entry: &Entry, drawn: f64) -> f64 {
        let is_fine = self.is_angle || self.expected == 0.0;
        let needed = if is_fine { self.fine } else { half_unit(self.expected, COUNTED) };
        if entry.text.is_empty() { entry.rounding } else { entry.rounding.min(needed.max(drawn)) }
    }

    /// Whether the digits hold so much that they tell nothing, where honest hands are off by `drawn`.
    fn is_too_coarse(&self, rounding: f64, drawn: f64) -> bool {
        rounding > self.fine.max(drawn)
    }

    /// Whether an honest hand, off by up to `tolerance`, could as well find nothing there, and a value that is `off` is not so near that
    /// it tells something all the same.
    fn is_too_small(&self, tolerance: f64, off: f64) -> bool {
        !self.is_angle && self.expected != 0.0 && tolerance >= self.expected.abs() && off > self.fine
    }
}

/// The largest exact value of a kind in a form; of angles half a turn.
fn largest(entries: &[Entry], kind: QuantityKind) -> f64 {
    let same = entries.iter().filter(|entry| entry.asked.kind() == kind);
    if kind == QuantityKind::Angle { 180.0 } else { same.map(|entry| entry.expected.abs()).fold(0.0, f64::max) }
}

/// The verdicts where the tolerances follow a hand that is worse than they suppose, as far as the key allows. `outside`: by datum whether even that hand
/// does not come to it beside the others, as where values contradict those from which they were computed.
pub(super) fn widened(
    values: &[Judged],
    entries: &[Entry],
    scorer: &Scorer<'_>,
    hand: &Hand,
    outside: &[bool],
    key: &AnswerKey<'_>,
) -> Vec<Judged> {
    let mut values = values.to_vec();
    let mut allowed = *hand;
    allowed.errors.iter_mut().for_each(|size| *size = size.min(key.leniency));
    // A few values do not show how good a hand is.
    if key.leniency <= 1.0 || !hand.is_by_hand() || scorer.data.len() < ENOUGH {
        return values;
    }
    let largest: Vec<f64> = values.iter().map(|value| largest(entries, value.entry.asked.kind())).collect();
    for (place, datum) in scorer.data.iter().enumerate() {
        let value = &mut values[datum.entry];
        let Entry { asked, expected, .. } = &value.entry;
        let telling = Telling::new(asked, *expected, largest[datum.entry]);
        let drawn = BANDS * BAND * scorer.spread(place, &allowed);
        let tolerance = drawn + telling.counted(&value.entry, drawn);
        let is_outside = outside.get(place).is_some_and(|outside| *outside);
        if !is_outside && value.basis == Basis::Drawn && value.tolerance < tolerance {
            value.tolerance = tolerance;
            if value.verdict == Verdict::Off && value.difference.abs() <= tolerance {
                let is_too_small = telling.is_too_small(tolerance, value.difference.abs());
                value.verdict = if is_too_small { Verdict::TooSmall } else { Verdict::WithinTolerance };
            }
        }
    }
    values
}

/// Least number of drawn values whose scatter shows how accurate a hand is.
pub(super) const ENOUGH: usize = 8;

/// Half a band, in standard deviations: 95 of 100 values are within.
const BAND: f64 = 1.96;
