//! The sheet of paper of a figure, and the sizes of what is drawn on it.

use super::error::shortened;
use super::value::choice;
use super::write::write_forms;
use serde::{Deserialize, Deserializer};

/// A sheet of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Page {
    /// Its size.
    pub size: PageSize,
    /// Whether its longer side lies horizontally.
    pub landscape: bool,
}

choice! {
    /// A standard size of paper.
    PageSize {
        /// 210 mm × 297 mm
        A4 = "a4",
        /// 297 mm × 420 mm
        A3 = "a3",
        /// 8.5 in × 11 in
        Letter = "letter",
        /// 180 mm × 320 mm, in the proportions of a projector
        Wide = "16x9",
    }
}

impl Default for Page {
    /// A4 landscape.
    fn default() -> Self {
        Page { size: PageSize::A4, landscape: true }
    }
}

impl Page {
    /// All names of pages in a scene file: of each size the one without a suffix, which is landscape, and those with one.
    pub const NAMES: [[&str; 3]; PageSize::ALL.len()] = [
        ["a4", "a4-landscape", "a4-portrait"],
        ["a3", "a3-landscape", "a3-portrait"],
        ["letter", "letter-landscape", "letter-portrait"],
        ["16x9", "16x9-landscape", "16x9-portrait"],
    ];

    /// The page of this name; `None` if there is none. Without a suffix it is landscape.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Page> {
        let mut all = PageSize::ALL.into_iter().zip(Page::NAMES);
        let (size, [.., portrait]) = all.find(|(_, names)| names.contains(&name))?;
        Some(Page { size, landscape: name != portrait })
    }

    /// Its name in a scene file: `"a4"`, `"a4-portrait"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        let [landscape, _, portrait] = Page::NAMES[self.size as usize];
        if self.landscape { landscape } else { portrait }
    }

    /// Width and height, in millimetres.
    pub fn size_mm(self) -> [f64; 2] {
        let [short, long] = match self.size {
            PageSize::A4 => [210.0, 297.0],
            PageSize::A3 => [297.0, 420.0],
            PageSize::Letter => [215.9, 279.4],
            PageSize::Wide => [180.0, 320.0],
        };
        if self.landscape { [long, short] } else { [short, long] }
    }
}

write_forms! { Page { page => page.name() } }

impl<'de> Deserialize<'de> for Page {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Page, D::Error> {
        let name = String::deserialize(deserializer)?;
        Page::from_name(&name)
            .ok_or_else(|| serde::de::Error::custom(format!("there is no page \"{}\"", shortened(&name))))
    }
}

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
    /// Width of the line of a link, in mm of paper: labels keep off lines by it.
    pub lines: f64,
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
            lines: 0.5,
        }
    }
}
