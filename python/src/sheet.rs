//! Drawings as the bytes of files.

use crate::refused::Refused;
use kinegon::drawing::{Drawing, Film};
use kinegon::format::{FilmFormat, Text, layered_svg, pdf_pages, svg_with};
use pyo3::FromPyObject;

/// How sheets are written.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Form {
    /// svg, pdf, png, tikz; of a film gif, apng.
    pub format: String,
    /// Whether letters of an SVG are outlines.
    pub outlines: bool,
    /// Whether an SVG has a group for each step.
    pub layered: bool,
    /// Resolution of a PNG or a film.
    pub dpi: f64,
}

impl Form {
    /// The file of a drawing.
    pub fn bytes(&self, drawing: &Drawing) -> Result<Vec<u8>, Refused> {
        let failed = |error: String| Refused::new("KinegonError", error, None);
        let text = if self.outlines { Text::Outlines } else { Text::Letters };
        match self.format.as_str() {
            "svg" if self.layered => Ok(layered_svg(drawing, text).into_bytes()),
            "svg" => Ok(svg_with(drawing, text).into_bytes()),
            "tikz" => Ok(drawing.tikz().into_bytes()),
            "pdf" => drawing.pdf().map_err(|error| failed(error.to_string())),
            "png" => {
                self.checked_dpi()?;
                drawing.png(self.dpi).map_err(|error| failed(error.to_string()))
            }
            other => Err(failed(format!("there is no format `{other}` of a sheet"))),
        }
    }

    /// The files of the sheets of one set; as PDF one file with all of them.
    pub fn joined(&self, sheets: &[Drawing]) -> Result<Vec<Vec<u8>>, Refused> {
        if self.format != "pdf" {
            return self.files(sheets);
        }
        let file = pdf_pages(sheets, None).map_err(|error| Refused::new("KinegonError", error.to_string(), None));
        Ok(vec![file?])
    }

    /// The file of a film.
    pub fn film(&self, film: &Film) -> Result<Vec<u8>, Refused> {
        self.checked_dpi()?;
        let format = if self.format == "apng" { FilmFormat::Apng } else { FilmFormat::Gif };
        film.file(format, self.dpi, |_| ()).map_err(|error| Refused::new("KinegonError", error.to_string(), None))
    }

    fn checked_dpi(&self) -> Result<(), Refused> {
        let is_allowed = (10.0..=2400.0).contains(&self.dpi);
        let refused = || Refused::new("KinegonError", "dpi must be from 10 to 2400".to_owned(), None);
        if is_allowed { Ok(()) } else { Err(refused()) }
    }

    /// The files of several drawings.
    pub fn files(&self, drawings: &[Drawing]) -> Result<Vec<Vec<u8>>, Refused> {
        drawings.iter().map(|drawing| self.bytes(drawing)).collect()
    }
}
