//! Photographs: files of cameras and chats into grey pictures.

use super::caught::caught;
use super::message::Failure;
use crate::photo::Picture;
use image::{DynamicImage, GrayImage, ImageDecoder, ImageError, ImageReader, Limits};
use std::fs;
use std::io::{Cursor, Read};
use std::path::Path;

/// Most pixels of a picture, in millions: several times those of usual telephones.
const MOST_MEGAPIXELS: f64 = 64.0;
/// Largest file, in bytes.
const LARGEST: u64 = 64 << 20;
/// Most memory that decoding may take, in bytes: three for each pixel, and as many again.
const MEMORY: u64 = 400 << 20;

/// Whether a file's name is that of a photograph.
pub(super) fn is_photograph(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    ["jpg", "jpeg", "png", "heic", "heif", "webp", "tif", "tiff", "bmp", "gif"].contains(&ending.as_str())
}

/// The picture in a file, upright as the file says, in grey.
pub(super) fn read_picture(path: &Path) -> Result<Picture, Failure> {
    let name = path.display().to_string();
    let refuse = |message: String, hint: &str| Failure::misuse(format!("{name} {message}"), hint);
    let mut bytes = Vec::new();
    let opened = fs::File::open(path).and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes));
    opened.map_err(|error| refuse(format!("cannot be read: {error}"), "give the path of a photograph"))?;
    if bytes.len() as u64 > LARGEST {
        return Err(refuse(format!("is larger than {} MB", LARGEST >> 20), "send the photograph in a smaller size"));
    }
    if bytes.get(4..8) == Some(b"ftyp") {
        return Err(refuse(
            "is a HEIC or AVIF picture, which is not read".to_owned(),
            "save or send it as JPEG (on an iPhone: Settings, Camera, Formats, Most Compatible)",
        ));
    }
    // The decoders are not ours: whatever a broken file does to them is a message.
    let decoded = caught(|| decoded(&bytes)).unwrap_or_else(|panic| Err(Refused::Broken(panic)));
    decoded.map_err(|refused| match refused {
        Refused::Format => refuse("is no JPEG or PNG picture".to_owned(), "save the photograph as JPEG"),
        Refused::Large(width, height) => refuse(
            format!("has {width} x {height} pixels; pictures of up to {MOST_MEGAPIXELS} megapixels are read"),
            "take the photograph in the camera's usual size",
        ),
        Refused::Broken(why) => {
            refuse(format!("cannot be read as a picture: {why}"), "save the photograph again as JPEG")
        }
    })
}

/// Why a file is no picture.
enum Refused {
    Format,
    Large(u32, u32),
    Broken(String),
}

fn decoded(bytes: &[u8]) -> Result<Picture, Refused> {
    let broken = |error: ImageError| Refused::Broken(error.to_string());
    let mut reader = ImageReader::new(Cursor::new(bytes));
    reader = reader.with_guessed_format().map_err(|error| Refused::Broken(error.to_string()))?;
    if reader.format().is_none() {
        return Err(Refused::Format);
    }
    let mut limits = Limits::default();
    limits.max_alloc = Some(MEMORY);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(|error| match error {
        ImageError::Unsupported(_) => Refused::Format,
        error => broken(error),
    })?;
    let (width, height) = decoder.dimensions();
    if f64::from(width) * f64::from(height) > MOST_MEGAPIXELS * 1e6 {
        return Err(Refused::Large(width, height));
    }
    // What a wrong note of the camera says about the turn does not matter: markers have their own.
    let turn = decoder.orientation().ok();
    let mut picture = DynamicImage::ImageLuma8(grey(DynamicImage::from_decoder(decoder).map_err(broken)?));
    if let Some(turn) = turn {
        picture.apply_orientation(turn);
    }
    let grey = picture.into_luma8();
    let size = [grey.width() as usize, grey.height() as usize];
    Picture::new(size[0], size[1], grey.into_raw()).ok_or(Refused::Format)
}

/// A picture in grey. That of a JPEG is made here: `image` reckons for all colour spaces, which takes as long as decoding.
fn grey(picture: DynamicImage) -> GrayImage {
    // Luma of ITU-R BT.601, in 256ths.
    let luma =
        |pixel: &[u8]| ((77 * u32::from(pixel[0]) + 150 * u32::from(pixel[1]) + 29 * u32::from(pixel[2])) >> 8) as u8;
    match picture {
        DynamicImage::ImageRgb8(colour) => {
            let grey = colour.as_raw().chunks_exact(3).map(luma).collect();
            GrayImage::from_raw(colour.width(), colour.height(), grey).unwrap_or_default()
        }
        other => other.into_luma8(),
    }
}
