//! Films: a [`Film`]'s pictures as pixels (`mod.rs`), of which a file holds what changes from one to the next (`change.rs`): as
//! GIF (`gif.rs`), in colours that are chosen for the whole film (`palette.rs`), or without loss as APNG (`apng.rs`).
//!
//! Pictures are drawn one after another, for names stay where they were in the one before; pixels are made of them on all
//! cores, of a few pictures at a time, and nothing of a picture is kept once it is written.

mod apng;
mod change;
mod gif;
mod palette;

use super::png::{CSS_DPI, PngError, coloured, pixels_of, tree_of};
use crate::cores::{cores, on_all_cores};
use crate::drawing::{Drawing, Film};

/// Most pixels of a picture of a film: those of a screen of the finest kind.
pub(crate) const MOST_AREA: f64 = 1e7;

/// A kind of file for a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FilmFormat {
    /// GIF, which all programs show: 255 colours.
    Gif,
    /// APNG, which browsers show: all colours.
    Apng,
}

/// Red, green and blue of a pixel.
type Pixel = [u8; 3];

/// A picture of a film, row by row.
struct Picture {
    width: usize,
    pixels: Vec<Pixel>,
}

impl Film {
    /// The film as a file that is shown over and over: at `dpi` dots per inch, on its background. `on_picture` hears of each
    /// picture that is written.
    ///
    /// The bytes are the same on every machine.
    ///
    /// # Errors
    /// The resolution is no positive number, the pictures would be too large, or the file cannot be made.
    pub fn file(&self, format: FilmFormat, dpi: f64, on_picture: impl FnMut(&Drawing)) -> Result<Vec<u8>, PngError> {
        if !(dpi > 0.0 && dpi.is_finite()) {
            return Err(PngError::Resolution { dpi });
        }
        let pictures = Pictures::of(self, dpi / CSS_DPI)?;
        match format {
            FilmFormat::Gif => gif::file(&pictures, on_picture),
            FilmFormat::Apng => apng::file(&pictures, dpi, on_picture),
        }
    }
}

/// The pictures of a film in pixels.
struct Pictures<'a> {
    film: &'a Film,
    /// Pixels across and down.
    size: [f64; 2],
}

impl<'a> Pictures<'a> {
    /// The pictures at so many pixels for each pixel of the SVG.
    fn of(film: &'a Film, scale: f64) -> Result<Self, PngError> {
        let first = film.drawings().next().unwrap_or_else(|| Drawing::new(1.0, 1.0));
        let [width, height] = pixels_of(&tree_of(&first)?, scale);
        if width * height > MOST_AREA {
            return Err(PngError::LargeFilm { width, height });
        }
        Ok(Pictures { film, size: [width, height] })
    }

    /// How many there are.
    fn count(&self) -> usize {
        self.film.running().poses.len()
    }

    /// Makes something of the pixels of every `step`th picture, on all cores, and passes it on in their order.
    fn each<T: Send>(
        &self,
        step: usize,
        make: impl Fn(Picture) -> T + Send + Sync,
        mut put: impl FnMut(&Drawing, T) -> Result<(), PngError>,
    ) -> Result<(), PngError> {
        let mut drawings = self.film.every(step);
        loop {
            let some: Vec<Drawing> = drawings.by_ref().take(2 * cores()).collect();
            if some.is_empty() {
                return Ok(());
            }
            let made = on_all_cores(&some, |drawing| self.picture(drawing).map(&make));
            for (drawing, made) in some.iter().zip(made) {
                put(drawing, made?)?;
            }
        }
    }

    fn picture(&self, drawing: &Drawing) -> Result<Picture, PngError> {
        let pixmap = coloured(&tree_of(drawing)?, self.size, drawing.style.background())?;
        let pixels = pixmap.data().as_chunks::<4>().0.iter().map(|[red, green, blue, _]| [*red, *green, *blue]);
        Ok(Picture { width: pixmap.width() as usize, pixels: pixels.collect() })
    }
}
