//! The picture in a JPEG or PNG file: upright, in grey, with limits on what it takes.

use crate::photo::Picture;
use exif::{In, Tag};
use png::{BitDepth, ColorType, Transformations};
use std::fmt::Display;
use std::io::Cursor;
use zune_jpeg::JpegDecoder;
use zune_jpeg::errors::DecodeErrors;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// Most pixels of a picture, in millions: several times those of usual telephones.
const MOST_MEGAPIXELS: f64 = 64.0;
/// Most bytes of its pixels: three for each of so many, as a JPEG has them.
const MOST_BYTES: u64 = 192_000_000;
/// Most memory that decoding a PNG may take, in bytes: its pixels, and as many again.
const MEMORY: usize = 2 * MOST_BYTES as usize;

/// Why a file is no picture, and what to try.
pub type Refused = (String, &'static str);

pub(super) fn broken(why: impl Display) -> Refused {
    (format!("cannot be read as a picture: {why}"), "save the photograph again as JPEG")
}

fn no_picture() -> Refused {
    ("is no JPEG or PNG picture".to_owned(), "save the photograph as JPEG")
}

/// The picture in the bytes of a file.
///
/// # Errors
/// It is none that is read, too large, or broken.
pub fn decoded(bytes: &[u8]) -> Result<Picture, Refused> {
    let stored = match bytes {
        [0xff, 0xd8, 0xff, ..] => jpeg(bytes)?,
        [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', ..] => png(bytes)?,
        _ => return Err(no_picture()),
    };
    stored.upright().ok_or_else(no_picture)
}

/// A picture as the file has it.
struct Stored {
    size: [usize; 2],
    /// How it is turned, as Exif numbers it: 1 is upright.
    turn: u32,
    grey: Vec<u8>,
}

fn jpeg(bytes: &[u8]) -> Result<Stored, Refused> {
    let options = DecoderOptions::default().set_strict_mode(false).set_max_width(usize::MAX).set_max_height(usize::MAX);
    let refused = |error| match error {
        DecodeErrors::Unsupported(_) => no_picture(),
        error => broken(error),
    };
    let mut head = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    head.decode_headers().map_err(refused)?;
    let (width, height) = head.dimensions().ok_or_else(no_picture)?;
    // All that is not grey comes out in red, green and blue.
    let is_grey = head.input_colorspace() == Some(ColorSpace::Luma);
    let (space, samples) = if is_grey { (ColorSpace::Luma, 1) } else { (ColorSpace::RGB, 3) };
    refuse_large([width as u64, height as u64], samples, 1)?;
    let turn = turn(head.exif().map(Vec::as_slice));
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options.jpeg_set_out_colorspace(space));
    let pixels = decoder.decode().map_err(broken)?;
    let grey = if is_grey { pixels } else { pixels.as_chunks().0.iter().map(luma).collect() };
    Ok(Stored { size: [width, height], turn, grey })
}

fn png(bytes: &[u8]) -> Result<Stored, Refused> {
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: MEMORY });
    // Palettes become colours, and fewer bits eight.
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(broken)?;
    let (width, height) = reader.info().size();
    let (colours, depth) = reader.output_color_type();
    let bytes = if depth == BitDepth::Sixteen { 2 } else { 1 };
    refuse_large([width.into(), height.into()], colours.samples() as u64, bytes)?;
    let turn = turn(reader.info().exif_metadata.as_deref());
    let mut pixels = vec![0; reader.output_buffer_size().ok_or_else(no_picture)?];
    reader.next_frame(&mut pixels).map_err(broken)?;
    Ok(Stored { size: [width as usize, height as usize], turn, grey: grey(pixels, colours, depth) })
}

fn refuse_large([width, height]: [u64; 2], samples: u64, bytes: u64) -> Result<(), Refused> {
    if width as f64 * height as f64 > MOST_MEGAPIXELS * 1e6 {
        let message = format!("has {width} x {height} pixels; pictures of up to {MOST_MEGAPIXELS} megapixels are read");
        return Err((message, "take the photograph in the camera's usual size"));
    }
    let (all, bits) = (width * height * samples * bytes, 8 * bytes);
    if all > MOST_BYTES {
        let message =
            format!("has {width} x {height} pixels with {bits} bits for each colour, which are {} MB", all >> 20);
        return Err((message, "save it as JPEG, or in a smaller size"));
    }
    Ok(())
}

/// Luma of ITU-R BT.601, in 256ths.
fn luma([red, green, blue]: &[u8; 3]) -> u8 {
    ((77 * u32::from(*red) + 150 * u32::from(*green) + 29 * u32::from(*blue)) >> 8) as u8
}

/// Luma of ITU-R BT.709, of colours from 0 to 1.
fn fine_luma([red, green, blue]: [f32; 3]) -> u8 {
    ((red * 0.212_647_84 + green * 0.715_179_2 + blue * 0.072_173_04) * 255.0).round() as u8
}

/// The pixels of a PNG file in grey, whatever their alpha.
fn grey(pixels: Vec<u8>, colours: ColorType, depth: BitDepth) -> Vec<u8> {
    let samples = colours.samples();
    let fine = |pixel: &[u8], sample: usize| u16::from_be_bytes([pixel[2 * sample], pixel[2 * sample + 1]]);
    match (depth, colours) {
        (BitDepth::Sixteen, ColorType::Grayscale | ColorType::GrayscaleAlpha) => {
            pixels.chunks_exact(2 * samples).map(|pixel| ((u32::from(fine(pixel, 0)) + 128) / 257) as u8).collect()
        }
        (BitDepth::Sixteen, _) => {
            let part = |pixel, sample| f32::from(fine(pixel, sample)) * (1.0 / 65535.0);
            pixels.chunks_exact(2 * samples).map(|pixel| fine_luma([0, 1, 2].map(|i| part(pixel, i)))).collect()
        }
        (_, ColorType::Grayscale) => pixels,
        (_, ColorType::GrayscaleAlpha) => pixels.iter().copied().step_by(2).collect(),
        (_, ColorType::Rgba) => {
            let part = |sample| f32::from(sample) * (1.0 / 255.0);
            pixels
                .as_chunks::<4>()
                .0
                .iter()
                .map(|&[red, green, blue, _]| fine_luma([red, green, blue].map(part)))
                .collect()
        }
        (_, ColorType::Rgb | ColorType::Indexed) => pixels.as_chunks().0.iter().map(luma).collect(),
    }
}

/// How the camera was held. What a wrong note of it says does not matter: markers have their own turn.
fn turn(exif: Option<&[u8]>) -> u32 {
    let read = |bytes: &[u8]| {
        let read = exif::Reader::new().continue_on_error(true).read_raw(bytes.to_vec());
        let exif = read.or_else(|error| error.distill_partial_result(|_| {})).ok()?;
        exif.get_field(Tag::Orientation, In::PRIMARY)?.value.get_uint(0)
    };
    exif.and_then(read).unwrap_or(1)
}

impl Stored {
    fn upright(self) -> Option<Picture> {
        let [width, height] = self.size;
        let is_on_its_side = (5..=8).contains(&self.turn);
        let [across, down] = if is_on_its_side { [height, width] } else { [width, height] };
        // Where a pixel is stored.
        let from = |x: usize, y: usize| match self.turn {
            2 => [width - 1 - x, y],
            3 => [width - 1 - x, height - 1 - y],
            4 => [x, height - 1 - y],
            5 => [y, x],
            6 => [y, height - 1 - x],
            7 => [width - 1 - y, height - 1 - x],
            8 => [width - 1 - y, x],
            _ => [x, y],
        };
        let grey = match self.turn {
            2..=8 => {
                let places = (0..down).flat_map(|y| (0..across).map(move |x| from(x, y)));
                places.map(|[x, y]| self.grey[y * width + x]).collect()
            }
            _ => self.grey,
        };
        Picture::new(across, down, grey)
    }
}
