//! APNG: PNG with more pictures.

use super::change::Change;
use super::{Picture, Pictures, Pixel, PngError};
use crate::drawing::Drawing;
use crate::format::png::resolution;
use ::png::{BitDepth, BlendOp, ColorType, Compression, DisposeOp, Encoder, Filter};

/// A pixel that stays as it is.
const KEPT: [u8; 4] = [0; 4];

/// The film, shown over and over.
pub(super) fn file(
    pictures: &Pictures<'_>,
    dpi: f64,
    mut on_picture: impl FnMut(&Drawing),
) -> Result<Vec<u8>, PngError> {
    let mut file = Vec::new();
    let [width, height] = pictures.size.map(|side| side as u32);
    let mut encoder = Encoder::new(&mut file, width, height);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    // Most of a picture is what stays; filters only help photographs.
    encoder.set_filter(Filter::NoFilter);
    encoder.set_pixel_dims(Some(resolution(dpi)));
    encoder.set_animated(pictures.count() as u32, 0)?;
    encoder.set_frame_delay(1, pictures.film.per_second())?;
    encoder.set_dispose_op(DisposeOp::None)?;
    encoder.set_blend_op(BlendOp::Over)?;
    let mut writer = encoder.write_header()?;
    let mut before: Option<Vec<Pixel>> = None;
    pictures.each(
        1,
        |picture| picture,
        |drawing, Picture { width, pixels }| {
            let change = Change::of(before.as_deref(), &pixels, width);
            let opaque = |[red, green, blue]: Pixel| [red, green, blue, 255];
            let written = change.written(before.as_deref(), &pixels, width, KEPT, opaque);
            let [left, top, width, height] =
                [change.left, change.top, change.width, change.height].map(|side| side as u32);
            writer.reset_frame_position()?;
            writer.set_frame_dimension(width, height)?;
            writer.set_frame_position(left, top)?;
            writer.write_image_data(written.as_flattened())?;
            before = Some(pixels);
            on_picture(drawing);
            Ok(())
        },
    )?;
    writer.finish()?;
    Ok(file)
}
