//! Drawings over a picture.

use crate::drawing::Drawing;

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

impl Drawing {
    /// The bytes of a PNG file: the drawing over a picture, in that picture's pixels.
    ///
    /// # Errors
    /// The picture has no pixels, or the file cannot be made.
    #[cfg(feature = "png")]
    pub fn png_over(&self, backdrop: &Backdrop) -> Result<Vec<u8>, super::PngError> {
        super::png::over(self, backdrop.size, backdrop.colours())
    }

    /// The bytes of a PDF file of one page: the drawing over a picture.
    ///
    /// # Errors
    /// The page cannot be that large, or the file cannot be made.
    #[cfg(all(feature = "pdf", feature = "cli"))]
    pub fn pdf_over(&self, backdrop: &Backdrop) -> Result<Vec<u8>, super::PdfError> {
        let [width, height] = backdrop.size;
        super::pdf::over(self, krilla::image::Image::from_rgba8(backdrop.colours(), width, height))
    }
}
