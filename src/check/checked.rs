//! What a check finds: the verdict on every value, and the mistakes that explain those that are off.

use super::common::CommonError;
use super::entry::Entry;
use super::lesson::Lesson;
use super::mistakes::{Candidate, Mistake};
use super::placed::TurnedPlan;
use super::sensible::StatedScale;
use crate::sheet::Sheet;
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
    /// Plans whose places on paper lie turned to the scheme, with all of the sheet.
    pub turned: Vec<TurnedPlan>,
    /// The rows of the scene's form that have no value here, whatever the student's form asks for.
    pub missing: Vec<String>,
    /// The exercise of the class whose values these are, where they are those of another one: then no mistakes are told.
    pub values_of: Option<String>,
    /// Scales of the form that are not those asked for, or at which no sheet can be drawn.
    pub scales: Vec<StatedScale>,
    /// An error that all measured lengths have in common; it is taken out of the values.
    pub common: Option<CommonError>,
    /// How many stages of hints the student opened, as the form says.
    pub hints: u64,
}

/// Fewest values that show whose they are, and the shares of them that are right there, and here at most.
const OF_ANOTHER: (usize, f64, f64) = (5, 0.8, 0.5);

impl Checked {
    /// Whether so many of the values are right as of another exercise that they are its values, and not this one's.
    pub(super) fn are_rather(&self, other: &[Verdict]) -> bool {
        let share = |verdicts: &mut dyn Iterator<Item = Verdict>| {
            let right = verdicts.filter(|v| matches!(v, Verdict::Right | Verdict::WithinTolerance)).count();
            right as f64 / self.values.len() as f64
        };
        let (fewest, there, here) = OF_ANOTHER;
        self.values.len() >= fewest
            && share(&mut other.iter().copied()) >= there
            && share(&mut self.values.iter().map(|value| value.verdict)) <= here
    }

    /// Says that the values are those of another exercise of the class: its mistakes would explain nothing.
    pub fn put_down_to(&mut self, exercise: &str) {
        self.diagnosis = Diagnosis::none(&self.values);
        self.values_of = Some(exercise.to_owned());
    }

    /// What all verdicts come to.
    #[must_use]
    pub fn outcome(&self) -> Outcome {
        let values = self.values.iter().map(|value| Outcome::of(value.verdict)).max();
        let plans = if self.mirrored.is_empty() { Outcome::Passed } else { Outcome::Off };
        let asked = if self.missing.is_empty() { Outcome::Passed } else { Outcome::Incomplete };
        // Where there is no value, nothing has been judged.
        values.unwrap_or(Outcome::Incomplete).max(plans).max(asked)
    }

    /// Whether all that is asked for is there, and every value is right or within its tolerance.
    #[must_use]
    pub fn is_passed(&self) -> bool {
        self.outcome() == Outcome::Passed
    }

    /// Whether no value is off, and no plan mirrored.
    #[must_use]
    pub fn is_nothing_off(&self) -> bool {
        self.outcome() != Outcome::Off
    }

    /// How many values have this verdict.
    pub(super) fn count(&self, verdict: Verdict) -> usize {
        self.values.iter().filter(|value| value.verdict == verdict).count()
    }

    /// The names of the quantities of some values.
    pub(super) fn names(&self, values: &[usize]) -> Vec<String> {
        values.iter().map(|&value| self.values[value].entry.asked.name().to_owned()).collect()
    }
}

/// What a check comes to, from good to bad: of several the largest counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// All that is asked for is there, and all that is there is judged and good.
    Passed,
    /// Nothing is off, but something is missing, or does not tell enough to be judged.
    Incomplete,
    /// Something is off.
    Off,
}

impl Outcome {
    /// What a single verdict comes to: only a value that is judged can pass.
    const fn of(verdict: Verdict) -> Outcome {
        match verdict {
            Verdict::Right | Verdict::WithinTolerance => Outcome::Passed,
            Verdict::SenseMissing | Verdict::TooCoarse | Verdict::TooSmall => Outcome::Incomplete,
            Verdict::Off => Outcome::Off,
        }
    }
}

/// Tolerance of a value, in bands. Of 100 honest drawings at least 95 keep a single value within its band; so that a
/// whole drawing of dozens of values passes as surely, each may be off by two bands, 4.2 standard deviations.
pub const BANDS: f64 = 2.0;

/// How accurate somebody draws and computes. Within the limits every error is equally likely.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "AccuracyResult"))]
#[non_exhaustive]
pub struct Accuracy {
    /// Limit of the errors in lengths and places, in mm of paper.
    pub mm: f64,
    /// Limit of the errors in directions, in degrees.
    pub degrees: f64,
    /// Limit of the errors of computed numbers, in per cent; 0 where no slips are seen.
    pub percent: f64,
}

/// The verdict on a written value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The exact value rounds to it.
    Right,
    /// It differs from the exact value by no more than is allowed.
    WithinTolerance,
    /// A rate whose size is right or within the tolerance, written without a sign where no sense counts as positive: it
    /// does not tell its sense.
    SenseMissing,
    /// It differs by more.
    Off,
    /// It is not wrong, but tells nothing: its digits, as `0e4`, or `2` for 1.3; or the radii of its places, which are too large.
    TooCoarse,
    /// It is not wrong, but so small beside what is allowed that an honest hand could as well find nothing there.
    #[serde(rename = "unjudged")]
    TooSmall,
}

/// A value with its verdict.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The value.
    pub entry: Entry,
    /// The verdict on it.
    pub verdict: Verdict,
    /// The value less the exact one, in the scene's units; of an angle the shorter way round.
    pub difference: f64,
    /// Largest difference that counts as within the tolerance.
    pub tolerance: f64,
    /// By what it is judged.
    pub basis: Basis,
}

/// By what a value is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// By what careful hands come to.
    Drawn,
    /// By a coarse tolerance: it has an exact value, but no construction by hand from which it could be read.
    Coarse,
    /// By its digits alone: the scene gives it.
    Given,
}

/// The best explanation of the values, and the others.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Diagnosis {
    /// The mistakes that explain the values and are probable; none where no value is off, or where no cause is probable.
    pub best: Explanation,
    /// Other explanations, less probable.
    pub others: Vec<Explanation>,
    /// Indices of the values that remain without an explanation.
    pub unexplained: Vec<usize>,
    /// How many values were looked at, the first ones: of large forms not all, of a construction that nobody draws by hand none.
    pub looked_at: usize,
}

/// Mistakes that together explain the values.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Explanation {
    /// The mistakes, in the order of the construction.
    pub findings: Vec<Finding>,
    /// The probability that they were made, or others that the values alone cannot tell from them, from 0 to 1. An honest
    /// share is left for mistakes that the catalogue does not have. Without mistakes: the probability that none was made
    /// that the catalogue has.
    pub probability: f64,
    /// Whether the given values alone cannot tell it from the best one.
    pub is_alike: bool,
    /// Whether it is one way in which what the best one tells only by its place may have happened: its probability is a part of that one's.
    pub is_within: bool,
}

/// A mistake that was probably made.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Finding {
    /// The mistake, and where it was made.
    pub candidate: Candidate,
    /// Indices of the values that differ from the right ones because of the mistake and are consistent with it.
    pub follows: Vec<usize>,
    /// Indices of the values that the mistake would change and that are not as it would make them.
    pub(super) contradicts: Vec<usize>,
    /// Indices of the values in which the mistake itself was made: written otherwise than meant, or read from the wrong
    /// operation.
    pub written: Vec<usize>,
    /// What it teaches; nothing yet where it is only weighed.
    pub(super) lesson: Lesson,
}

impl Diagnosis {
    /// No mistake is told; values that are off remain without an explanation.
    pub(super) fn none(values: &[Judged]) -> Diagnosis {
        Diagnosis {
            best: Explanation { findings: Vec::new(), probability: 1.0, is_alike: false, is_within: false },
            others: Vec::new(),
            unexplained: (0..values.len()).filter(|&i| values[i].verdict == Verdict::Off).collect(),
            looked_at: values.len(),
        }
    }
}

impl Finding {
    /// The values that the mistake changes, in the order of the construction.
    pub(super) fn changed(&self) -> Vec<usize> {
        let mut all: Vec<usize> =
            [&self.written, &self.follows, &self.contradicts].into_iter().flatten().copied().collect();
        all.sort_unstable();
        all
    }

    /// Whether it tells what was done, and not only where.
    pub(super) fn names_cause(&self) -> bool {
        self.candidate.mistake() != Mistake::Unknown
    }

    /// The first value that the mistake changes.
    pub(super) fn first(&self) -> Option<usize> {
        self.changed().first().copied()
    }
}
