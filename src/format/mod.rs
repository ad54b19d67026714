//! In: the outputs of other stages: results, steps, a [`Drawing`](crate::drawing::Drawing).
//! Out: the bytes of a file in a format that people or other programs read.
//! Nothing is decided or computed here; the same input gives the same bytes everywhere.

mod centers;
#[cfg(feature = "arrow")]
mod columns;
mod contacts;
#[doc(hidden)] // for tests
pub mod digits;
mod feedback;
#[cfg(feature = "png")]
mod film;
mod forces;
mod json;
#[doc(hidden)] // for tests
pub mod number;
#[cfg(feature = "pdf")]
mod pdf;
mod pencil;
#[cfg(feature = "png")]
mod png;
mod points;
mod result;
mod steps;
mod structure;
mod svg;
mod table;
mod tikz;
#[cfg(feature = "html")]
mod workbench;

pub use self::centers::CenterResult;
#[cfg(feature = "arrow")]
pub use self::columns::{ColumnFormat, Columns};
pub use self::contacts::ContactResult;
#[doc(inline)]
pub use self::digits::DigitRow;
pub use self::feedback::{FEEDBACK_MARK, feedback_html, html_text};
#[cfg(feature = "png")]
pub use self::film::FilmFormat;
#[cfg(all(feature = "cli", feature = "png"))]
pub(crate) use self::film::MOST_AREA as MOST_FILM_AREA;
pub use self::forces::{DriveResult, ForceResult, ForcesResult, FrameResult, GuideForceResult, InertiaResult};
pub use self::json::{json, json_line};
#[cfg(feature = "pdf")]
pub use self::pdf::{PdfError, pdf_pages};
pub use self::pencil::{BandResult, PencilResult, pencil_result};
#[cfg(feature = "png")]
pub use self::png::PngError;
pub use self::points::PointResult;
pub use self::result::{GroupResult, LinkResult, QuantityResult, ResultFile, ResultUnits, SliderResult, result_schema};
pub use self::steps::step_values;
pub use self::structure::{listed_modes, mode, structure};
pub use self::svg::{Text, layered_svg, panels_svg, svg_with};
pub use self::table::{columns_of, csv_header, csv_rows, json_lines};
#[cfg(feature = "html")]
pub use self::workbench::{OpenScene, workbench};

/// A grey picture as large as a sheet, over which it is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Backdrop {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Brightness row by row; 0 is black.
    pub grey: Vec<u8>,
}

impl Backdrop {
    /// Red, green, blue and 255 of each pixel.
    #[cfg(any(feature = "png", all(feature = "pdf", feature = "cli")))]
    fn colours(&self) -> Vec<u8> {
        self.grey.iter().flat_map(|grey| [*grey, *grey, *grey, 255]).collect()
    }
}
