//! GIF.

use super::change::Change;
use super::palette::{Counts, Palette, counts};
use super::{Picture, Pictures, PngError};
use crate::drawing::Drawing;
use ::gif::{DisposalMethod, Encoder, Frame, Repeat};

/// The colours are those of every so many pictures.
const COLOURS_OF: usize = 8;

/// The film, shown over and over.
pub(super) fn file(pictures: &Pictures<'_>, mut on_picture: impl FnMut(&Drawing)) -> Result<Vec<u8>, PngError> {
    let mut all = Counts::new();
    let counted = |picture: Picture| counts(&picture.pixels);
    pictures.each(COLOURS_OF, counted, |_, own| {
        own.into_iter().for_each(|(colour, count)| *all.entry(colour).or_default() += count);
        Ok(())
    })?;
    let palette = Palette::new(&all);
    let kept = palette.colours.len() as u8;
    let mut colours = palette.colours.concat();
    colours.extend([0, 0, 0]);
    let [width, height] = pictures.size.map(|side| side as u16);
    let mut encoder = Encoder::new(Vec::new(), width, height, &colours)?;
    encoder.set_repeat(Repeat::Infinite)?;
    let mut before: Option<Vec<u8>> = None;
    let mut number = 0;
    pictures.each(
        1,
        |picture| palette.indices(&picture.pixels),
        |drawing, now| {
            let line = usize::from(width);
            let change = Change::of(before.as_deref(), &now, line);
            let [left, top, width, height] =
                [change.left, change.top, change.width, change.height].map(|side| side as u16);
            encoder.write_frame(&Frame {
                delay: hundredths(number + 1, pictures) - hundredths(number, pictures),
                dispose: DisposalMethod::Keep,
                transparent: before.as_ref().map(|_| kept),
                buffer: change.written(before.as_deref(), &now, line, kept, |index| index).into(),
                left,
                top,
                width,
                height,
                ..Frame::default()
            })?;
            before = Some(now);
            number += 1;
            on_picture(drawing);
            Ok(())
        },
    )?;
    Ok(encoder.into_inner()?)
}

/// When a picture comes, in hundredths of a second, in which GIF counts.
fn hundredths(number: u32, pictures: &Pictures<'_>) -> u16 {
    // At most 2000 pictures, each of a second at the most.
    let at = u64::from(number) * 100 / u64::from(pictures.film.per_second());
    at as u16
}
