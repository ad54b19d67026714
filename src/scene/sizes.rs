//! Sizes of letters and signs on a sheet. A style gives them; they are known before anything is placed.

/// Sizes of what is drawn on a sheet. All that has no size here (joints' feet, blocks, white between things) is in
/// proportion to the letters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// One em of labels and captions; no word of a figure is smaller, subscripts excepted.
    pub letters: Measure,
    /// Length of an arrowhead on a vector long enough for it.
    pub arrowheads: Measure,
    /// Diameter of the dot at the end of a vector; poles and special points of plans are in proportion.
    pub points: Measure,
    /// Diameter of the circle of a joint or a special point of the scheme.
    pub joints: Measure,
}

/// A length on a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// In mm of paper.
    Millimetres(f64),
    /// In hundredths of the sheet's shorter side: the same on every projector.
    Percent(f64),
}

impl Measure {
    /// Its length in mm on a sheet of that width and height.
    #[must_use]
    pub fn on(self, [width, height]: [f64; 2]) -> f64 {
        match self {
            Measure::Millimetres(mm) => mm,
            Measure::Percent(part) => 0.01 * part * width.min(height),
        }
    }
}

impl Default for Sizes {
    /// Those of the style `paper`.
    fn default() -> Self {
        Sizes {
            letters: Measure::Millimetres(4.7),
            arrowheads: Measure::Millimetres(2.6),
            points: Measure::Millimetres(0.9),
            joints: Measure::Millimetres(2.3),
        }
    }
}
