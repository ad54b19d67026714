//! What is asked of each mechanism of a study, and what becomes of it.

use super::samples::{fluctuation, mean};
use crate::cycle::{Drive, Steps};
use crate::quantity::{QuantityKind, QuantityRequest};
use serde::Deserialize;

/// The motion that every mechanism makes, and what is wanted of it.
#[derive(Clone, Debug)]
pub(super) struct Task {
    pub range: DriveRange,
    pub wanted: Vec<Wanted>,
    /// Whether values have bounds of their errors.
    pub errors: bool,
    /// Whether extremes are those of the steps alone, for mechanisms that are followed side by side.
    pub at_steps: bool,
}

/// The motion of every mechanism.
#[derive(Clone, Debug)]
pub(super) struct DriveRange {
    /// The drive that moves: the same of every mechanism, as only their numbers differ.
    pub drive: Drive,
    pub from: f64,
    pub to: f64,
    pub steps: Steps,
    /// Whether it is one whole turn of a crank.
    pub is_turn: bool,
    /// Whether other drives stand still.
    pub alone: bool,
}

impl DriveRange {
    /// From one sample to the next: in radians, or in the scene's unit of length.
    fn step(&self) -> f64 {
        let steps = (self.steps.count() - 1).max(1) as f64;
        let step = (self.to - self.from).abs() / steps;
        if self.drive.is_angle { step.to_radians() } else { step }
    }

    /// Its lowest and highest value.
    pub fn ends(&self) -> [f64; 2] {
        [self.from.min(self.to), self.from.max(self.to)]
    }
}

/// A quantity with the figures that are wanted of it.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    pub name: String,
    pub asked: QuantityRequest,
    pub figures: Vec<Figure>,
}

impl Wanted {
    /// Whether its values are angles.
    pub fn turns(&self) -> bool {
        self.asked.kind() == QuantityKind::Angle
    }

    /// Whether something is wanted of its samples together.
    pub fn has_sum(&self) -> bool {
        self.figures.iter().any(|figure| matches!(figure, Figure::Mean | Figure::Fluctuation))
    }

    /// Whether its greatest (`sign` 1) or least value is looked for.
    pub fn has_extreme(&self, sign: f64) -> bool {
        let one = if sign > 0.0 { Figure::Max } else { Figure::Min };
        self.figures.iter().any(|f| *f == one || matches!(f, Figure::MaxAbs | Figure::Range))
    }
}

/// What is said of a quantity over the cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "figure"))]
#[serde(rename_all = "snake_case")]
pub enum Figure {
    /// The greatest value, and the drive's value there.
    Max,
    /// The least value, and the drive's value there.
    Min,
    /// The greatest magnitude, and the drive's value there.
    MaxAbs,
    /// The greatest value less the least.
    Range,
    /// The mean over the drive's values.
    Mean,
    /// How far the integral over the drive of what the quantity differs from its mean goes up and down: of a drive's torque the work
    /// that a flywheel takes in and gives back. Radians for a drive that turns.
    Fluctuation,
    /// The value at the scene's own position.
    AtScene,
}

impl Figure {
    /// Its name in a study, and behind the quantity's name in a table.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Figure::Max => "max",
            Figure::Min => "min",
            Figure::MaxAbs => "max_abs",
            Figure::Range => "range",
            Figure::Mean => "mean",
            Figure::Fluctuation => "fluctuation",
            Figure::AtScene => "at_scene",
        }
    }

    /// Whether it is a value at one position, whose error has a bound.
    #[must_use]
    pub fn has_error(self) -> bool {
        self.has_place() || self == Figure::AtScene
    }

    /// Whether it happens somewhere.
    #[must_use]
    pub fn has_place(self) -> bool {
        matches!(self, Figure::Max | Figure::Min | Figure::MaxAbs)
    }
}

/// What is known of a quantity over the cycle of one mechanism; `None` where it has no value or grows without bound.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Summary {
    /// The drive's value and the greatest value there.
    pub max: Option<[f64; 2]>,
    /// The drive's value and the least value there.
    pub min: Option<[f64; 2]>,
    pub mean: Option<f64>,
    pub fluctuation: Option<f64>,
    pub at_scene: Option<f64>,
    /// Bounds of the errors of the values of `max`, `min` and `at_scene`, where they are asked for.
    pub errors: [Option<f64>; 3],
}

impl Summary {
    /// Says what the samples of the whole range tell together.
    pub fn sum(&mut self, wanted: &Wanted, samples: &[f64], range: &DriveRange) {
        if wanted.figures.contains(&Figure::Mean) {
            self.mean = mean(samples);
        }
        if wanted.figures.contains(&Figure::Fluctuation) {
            self.fluctuation = fluctuation(samples, range.step(), range.is_turn && !wanted.turns());
        }
    }

    /// The bound of the error of a figure's value at its place.
    pub fn error(&self, figure: Figure) -> Option<f64> {
        let [max, min, at_scene] = self.errors;
        match figure {
            Figure::Max => max,
            Figure::Min => min,
            Figure::MaxAbs => {
                let (greatest, least) = self.max.zip(self.min)?;
                if greatest[1].abs() >= least[1].abs() { max } else { min }
            }
            Figure::AtScene => at_scene,
            Figure::Range | Figure::Mean | Figure::Fluctuation => None,
        }
    }

    /// A figure, and the drive's value where it happens if it happens somewhere.
    pub fn figure(&self, figure: Figure) -> (Option<f64>, Option<f64>) {
        let placed = |found: Option<[f64; 2]>| (found.map(|f| f[1]), found.map(|f| f[0]));
        match figure {
            Figure::Max => placed(self.max),
            Figure::Min => placed(self.min),
            Figure::MaxAbs => placed(self.max.zip(self.min).map(|(max, min)| {
                let [at, value] = if max[1].abs() >= min[1].abs() { max } else { min };
                [at, value.abs()]
            })),
            Figure::Range => (self.max.zip(self.min).map(|(max, min)| max[1] - min[1]), None),
            Figure::Mean => (self.mean, None),
            Figure::Fluctuation => (self.fluctuation, None),
            Figure::AtScene => (self.at_scene, None),
        }
    }
}

/// How far a mechanism goes, and what is known of each quantity that is wanted.
#[derive(Clone, Debug)]
pub(super) struct Outcome {
    pub status: Status,
    pub reach: Option<[f64; 2]>,
    pub summaries: Vec<Summary>,
}

impl Outcome {
    /// Of a mechanism that does not move.
    pub fn without_motion(status: Status, task: &Task) -> Outcome {
        Outcome { status, reach: None, summaries: vec![Summary::default(); task.wanted.len()] }
    }
}

/// What became of one mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It goes through the whole cycle.
    Whole,
    /// It goes through a part of the cycle, from `reach_from` to `reach_to`; figures are of that part.
    Part,
    /// It cannot come from the scene's position to any part of the cycle.
    Outside,
    /// Its position in the scene is singular, so which way it goes on is not decided.
    Singular,
    /// It cannot be assembled at the scene's position.
    NotAssembled,
    /// It is no mechanism: a length is not positive, three lengths form no triangle, or the like.
    NoMechanism,
}

impl Status {
    /// All of them in their order, by which a row has a number for each.
    pub const ALL: [Status; 6] =
        [Status::Whole, Status::Part, Status::Outside, Status::Singular, Status::NotAssembled, Status::NoMechanism];

    /// The word that stands in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        ["whole", "part", "outside", "singular", "not assembled", "no mechanism"][self as usize]
    }
}

/// A column of a study's table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// What its numbers are.
    pub content: Content,
    /// The unit of its numbers, as `rad/s²`; angles are in degrees (°), numbers of rows and words have none.
    pub unit: String,
}

/// What the numbers of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Whole numbers.
    Index,
    /// Numbers; NaN where there is none.
    Number,
    /// Places in [`Status::ALL`].
    Status,
}
