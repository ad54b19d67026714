use resvg::tiny_skia::{BlendMode, Color, IntSize, Pixmap, PixmapPaint, Transform};
use resvg::usvg::{Options, Tree};

use super::Backdrop;
use super::svg::{Text, svg_with};
use crate::drawing::{Colour, Drawing};

/// Most pixels on a side; more is a mistyped resolution.
const MOST_PIXELS: f64 = 20_000.0;
/// Most pixels in all; each takes four bytes of memory.
const MOST_AREA: f64 = 2e8;
/// Millimetres in an inch.
const INCH: f64 = 25.4;
/// Pixels per inch in SVG and CSS.
pub(super) const CSS_DPI: f64 = 96.0;

/// Why a picture could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PngError {
    /// The picture would be too large.
    #[error(
        "the picture would have {width} x {height} pixels; a side may have {MOST_PIXELS} and the whole {MOST_AREA}: take fewer dots per inch"
    )]
    TooLarge {
        /// Pixels across.
        width: f64,
        /// Pixels down.
        height: f64,
    },
    /// The pictures of a film would be too large.
    #[error("the film would have {width} x {height} pixels; it may have ten million in all: take fewer dots per inch")]
    LargeFilm {
        /// Pixels across.
        width: f64,
        /// Pixels down.
        height: f64,
    },
    /// The dots per inch are not a positive number.
    #[error("{dpi} dots per inch: must be greater than 0, for instance 150 for a screen and 300 for paper")]
    Resolution {
        /// What was asked for.
        dpi: f64,
    },
    /// The SVG could not be read.
    #[error("the drawing cannot be read as SVG: {0}")]
    Svg(#[from] resvg::usvg::Error),
    /// The pixels could not be encoded.
    #[error("the pixels cannot be encoded: {0}")]
    Encoding(#[from] ::png::EncodingError),
    /// The pixels could not be encoded as GIF.
    #[error("the film cannot be encoded: {0}")]
    Film(#[from] ::gif::EncodingError),
}

impl Drawing {
    /// The bytes of a PNG file: the drawing on its background at `dpi` dots per inch, in 24-bit colour, with its
    /// resolution.
    ///
    /// The picture is rendered from the SVG file with texts as outlines, so it is the same on every machine.
    pub fn png(&self, dpi: f64) -> Result<Vec<u8>, PngError> {
        if !(dpi > 0.0 && dpi.is_finite()) {
            return Err(PngError::Resolution { dpi });
        }
        let tree = tree_of(self)?;
        encode(&coloured(&tree, pixels_of(&tree, dpi / CSS_DPI), self.style.background())?, dpi)
    }

    /// The bytes of a PNG file: the drawing over a picture, in that picture's pixels, as on a film: where the drawing
    /// is white they stay as they are.
    ///
    /// # Errors
    /// The picture has no pixels, or the file cannot be made.
    pub fn png_over(&self, backdrop: &Backdrop) -> Result<Vec<u8>, PngError> {
        let [width, height] = backdrop.size;
        let tree = tree_of(self)?;
        let film = rendered(&tree, backdrop.size.map(f64::from), Color::WHITE)?;
        let picture = IntSize::from_wh(width, height).and_then(|size| Pixmap::from_vec(backdrop.colours(), size));
        let mut picture = picture.ok_or(PngError::TooLarge { width: f64::from(width), height: f64::from(height) })?;
        let paint = PixmapPaint { blend_mode: BlendMode::Multiply, ..PixmapPaint::default() };
        picture.draw_pixmap(0, 0, film.as_ref(), &paint, Transform::identity(), None);
        let across = width as f32 / tree.size().width();
        encode(&picture, f64::from(across) * CSS_DPI)
    }
}

/// The SVG of a drawing with texts as outlines.
pub(super) fn tree_of(drawing: &Drawing) -> Result<Tree, PngError> {
    Ok(Tree::from_str(&svg_with(drawing, Text::Outlines), &Options::default())?)
}

/// The size of its picture at a scale.
pub(super) fn pixels_of(tree: &Tree, scale: f64) -> [f64; 2] {
    [tree.size().width(), tree.size().height()].map(|size| (f64::from(size) * scale).round().max(1.0))
}

/// A picture of so many pixels on a background.
pub(super) fn coloured(tree: &Tree, size: [f64; 2], background: Colour) -> Result<Pixmap, PngError> {
    let Colour { red, green, blue } = background;
    rendered(tree, size, Color::from_rgba8(red, green, blue, 255))
}

fn rendered(tree: &Tree, [width, height]: [f64; 2], background: Color) -> Result<Pixmap, PngError> {
    let too_large = PngError::TooLarge { width, height };
    if width > MOST_PIXELS || height > MOST_PIXELS || width * height > MOST_AREA {
        return Err(too_large);
    }
    // Both are at most 20 000, so they fit into u32.
    let mut pixmap = Pixmap::new(width as u32, height as u32).ok_or(too_large)?;
    pixmap.fill(background);
    let (across, down) = (width as f32 / tree.size().width(), height as f32 / tree.size().height());
    resvg::render(tree, Transform::from_scale(across, down), &mut pixmap.as_mut());
    Ok(pixmap)
}

/// The pixels as a PNG file.
fn encode(pixmap: &Pixmap, dpi: f64) -> Result<Vec<u8>, PngError> {
    let colours = without_alpha(pixmap.data());
    let mut file = Vec::with_capacity(colours.len() / 12);
    let mut encoder = ::png::Encoder::new(&mut file, pixmap.width(), pixmap.height());
    encoder.set_color(::png::ColorType::Rgb);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_compression(::png::Compression::Fast);
    encoder.set_filter(::png::Filter::Up);
    encoder.set_pixel_dims(Some(resolution(dpi)));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colours)?;
    writer.finish()?;
    Ok(file)
}

/// Dots per inch, as PNG has them.
pub(super) fn resolution(dpi: f64) -> ::png::PixelDimensions {
    let per_metre = (dpi * 1000.0 / INCH).round() as u32;
    ::png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: ::png::Unit::Meter }
}

/// Red, green and blue of pixels of four bytes. The background is opaque, so all alphas are 255 and can be left out.
fn without_alpha(pixels: &[u8]) -> Vec<u8> {
    let mut colours = vec![0; pixels.len() / 4 * 3];
    for (to, from) in colours.as_chunks_mut::<3>().0.iter_mut().zip(pixels.as_chunks::<4>().0) {
        to.copy_from_slice(&from[..3]);
    }
    colours
}
