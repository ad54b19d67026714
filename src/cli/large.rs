//! What of `draw` takes long or much memory is refused before it is begun, unless `--yes` asks for it.

use super::draw::Draw;
#[cfg(feature = "png")]
use super::figures::INCH;
use super::message::{Failure, refuse};
use crate::drawing::{Drawing, Steps};
#[cfg(feature = "png")]
use crate::scene::Figure;

/// Most sheets of steps, and most marks on all of them, that are written without asking: each takes milliseconds, and marks
/// grow with the square of the steps.
const MOST_SHEETS: usize = 400;
/// Most points of a figure that is drawn without being asked about; and of one that is painted, too.
const MOST_POINTS: usize = 6_500;
const MOST_PAINTED_POINTS: usize = 4_000;
const MOST_MARKS: usize = 400_000;
/// As many where they are painted in pixels, which takes several times as long.
const MOST_PAINTED: usize = 80_000;
/// Most million pixels of a picture that is written without asking, and about how many bytes each takes.
#[cfg(feature = "png")]
const MOST_MEGAPIXELS: f64 = 25.0;
#[cfg(feature = "png")]
const BYTES: f64 = 7.0;

impl Draw {
    /// Refuses to write very many sheets, before the first is drawn.
    pub(super) fn refuse_many(&self, all: &Drawing, shown: &[usize], steps: Option<Steps>) -> Result<(), Failure> {
        let marks: usize = shown.iter().map(|step| all.marks_after_step(*step)).sum();
        let has_png = self.figures.has_png();
        if shown.len() <= MOST_SHEETS && marks <= if has_png { MOST_PAINTED } else { MOST_MARKS } {
            return Ok(());
        }
        let coarse = if steps == Some(Steps::Coarse) { "" } else { "--steps coarse joins them to fewer sheets; " };
        let png = if has_png { ", as PNG, too" } else { "" };
        refuse(
            format!("the steps make {} sheets with {marks} marks in all{png}", shown.len()),
            format!("{coarse}--upto N draws one of them, --layered all in one file; with --yes they are written"),
        )
    }

    /// Refuses a figure with very many points, before it is drawn.
    pub(super) fn refuse_crowded(&self, points: usize) -> Result<(), Failure> {
        let has_png = self.figures.has_png();
        if self.yes || points <= if has_png { MOST_PAINTED_POINTS } else { MOST_POINTS } {
            return Ok(());
        }
        let without = if has_png { "SVG or PDF take less; " } else { "" };
        let as_png = if has_png { ", also as PNG," } else { "" };
        refuse(
            format!("a figure with {points} points{as_png} takes more than 2 s and 200 MB of memory"),
            format!("draw fewer points, few of which have room for their names; {without}with --yes it is drawn"),
        )
    }

    /// Refuses a picture of very many pixels, before it is drawn.
    #[cfg(feature = "png")]
    pub(super) fn refuse_large(&self, figure: &Figure) -> Result<(), Failure> {
        let [width, height] = figure.page.size_mm();
        let dots = self.figures.options.dpi_of(width) / INCH;
        let megapixels = width * height * dots * dots / 1e6;
        if self.yes || !self.figures.has_png() || megapixels <= MOST_MEGAPIXELS {
            return Ok(());
        }
        refuse(
            format!("a picture of {megapixels:.0} million pixels takes {:.0} MB of memory", BYTES * megapixels),
            "take fewer dots per inch (--dpi, --width), or SVG or PDF, which have no pixels; with --yes it is written",
        )
    }
}
