use schemars::JsonSchema;
use serde::Deserialize;

/// What is said of a quantity over the cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "figure")]
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
            Figure::AtScene => "at_scene",
        }
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
    pub at_scene: Option<f64>,
}

impl Summary {
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
            Figure::AtScene => (self.at_scene, None),
        }
    }
}
