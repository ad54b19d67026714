//! The file that a telephone writes: JPEG, with the word how it is to be turned.

use jpeg_encoder::{ColorType, Encoder, SamplingFactor};

/// How a picture is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Storage {
    /// 1 to 100.
    pub quality: u8,
    /// Colour has half the pixels along and down.
    pub is_subsampled: bool,
    /// The Exif orientation, 1 to 8: how the stored picture becomes the upright one. None: no Exif at all.
    pub orientation: Option<u8>,
}

/// The file of an upright picture (red, green and blue, row by row).
pub fn jpeg(pixels: &[u8], [width, height]: [usize; 2], storage: Storage) -> Vec<u8> {
    let orientation = storage.orientation.unwrap_or(1);
    let (stored, size) = stored(pixels, [width, height], orientation);
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, storage.quality);
    encoder.set_sampling_factor(if storage.is_subsampled { SamplingFactor::R_4_2_0 } else { SamplingFactor::R_4_4_4 });
    if storage.orientation.is_some() {
        encoder.add_exif_metadata(&exif(orientation)).expect("a few bytes fit");
    }
    let [width, height] = size.map(|n| u16::try_from(n).expect("no picture is that large"));
    encoder.encode(&stored, width, height, ColorType::Rgb).expect("memory can be written");
    bytes
}

/// A directory with one entry, the orientation.
fn exif(orientation: u8) -> Vec<u8> {
    let mut bytes = b"II*\0\x08\0\0\0\x01\0".to_vec();
    bytes.extend([0x12, 0x01, 0x03, 0, 1, 0, 0, 0, orientation, 0, 0, 0]);
    bytes.extend([0; 4]);
    bytes
}

/// The pixels as the sensor gives them: an orientation's turn leads from them to the upright picture.
fn stored(pixels: &[u8], [width, height]: [usize; 2], orientation: u8) -> (Vec<u8>, [usize; 2]) {
    if orientation == 1 {
        return (pixels.to_vec(), [width, height]);
    }
    let size = if orientation >= 5 { [height, width] } else { [width, height] };
    let (right, bottom) = (width - 1, height - 1);
    let mut stored = Vec::with_capacity(pixels.len());
    for y in 0..size[1] {
        for x in 0..size[0] {
            let [x, y] = match orientation {
                2 => [right - x, y],
                3 => [right - x, bottom - y],
                4 => [x, bottom - y],
                5 => [y, x],
                6 => [right - y, x],
                7 => [right - y, bottom - x],
                8 => [y, bottom - x],
                _ => [x, y],
            };
            let first = 3 * (y * width + x);
            stored.extend_from_slice(&pixels[first..first + 3]);
        }
    }
    (stored, size)
}
