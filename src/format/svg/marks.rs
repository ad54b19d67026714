//! Marks in drawing order, in groups of those that look alike.

use super::super::number::number;
use super::letters::{FINEST, IN_FINEST, definitions, write_glyphs, write_outline, write_text};
use super::shapes::{attribute, length, write_shape};
use crate::drawing::{Cap, Colour, Drawing, Look, Mark, PlacedText, Shape};

/// How texts are written in an SVG file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Text {
    /// As letters: small, searchable and editable; shown in the bundled font where it is installed, else in a similar
    /// one.
    #[default]
    Letters,
    /// As the outlines of the bundled font's letters: exactly the same in every program, whatever fonts it has.
    Outlines,
    /// As outlines, each glyph once in the file: half as large where many letters are the same, but not a path for each text.
    Glyphs,
}

/// A mark, and whether it is a text that needs its halo.
pub(super) type Drawn<'a> = (&'a Mark, bool);

/// All marks whose numbers are finite.
pub(super) fn drawn(drawing: &Drawing) -> Vec<Drawn<'_>> {
    drawing.marks.iter().zip(drawing.halos()).filter(|(mark, _)| mark.shape.is_drawable()).collect()
}

/// All marks, written straight into one string: building an element for each would take many times as long.
pub(super) fn body(drawing: &Drawing, text: Text) -> String {
    let drawn = drawn(drawing);
    let each = if text == Text::Letters { 160 } else { 600 };
    let mut written = String::with_capacity(each * drawn.len());
    write_marks(&mut written, drawing, text, &drawn);
    written.truncate(written.trim_end().len());
    if text == Text::Glyphs {
        written += &definitions(drawn.iter().filter_map(|(mark, _)| placed(mark)));
    }
    written
}

/// Writes marks in drawing order, with a group for consecutive marks that look alike.
pub(super) fn write_marks(written: &mut String, drawing: &Drawing, text: Text, marks: &[Drawn<'_>]) {
    let alike = |(a, _): &Drawn<'_>, (b, _): &Drawn<'_>| {
        let of = |mark: &Mark| (mark.pen, mark.emphasis, is_text(mark));
        of(a) == of(b) && (a.number == b.number || drawing.look(a) == drawing.look(b))
    };
    for marks in marks.chunk_by(alike) {
        let first = marks[0].0;
        let look = drawing.look(first);
        if is_text(first) {
            write_texts(written, text, &look, drawing.style.background(), marks);
        } else {
            open_line_group(written, &look);
            for (mark, _) in marks {
                written.push('\n');
                write_shape(written, &look, &mark.shape, mark.id.as_deref());
            }
            written.push_str("\n</g>\n");
        }
    }
}

fn is_text(mark: &Mark) -> bool {
    placed(mark).is_some()
}

fn placed(mark: &Mark) -> Option<&PlacedText> {
    if let Shape::Text(text) = &mark.shape { Some(text) } else { None }
}

/// Opens a group of marks that are not texts.
fn open_line_group(written: &mut String, look: &Look) {
    written.push_str("<g");
    if let Some(stroke) = look.stroke {
        attribute(written, "stroke", &stroke.to_string());
        length(written, "stroke-width", look.width);
        if !look.dash.is_empty() {
            let lengths: Vec<String> = look.dash.iter().copied().map(number).collect();
            attribute(written, "stroke-dasharray", &lengths.join(" "));
        }
        if look.cap == Cap::Round {
            attribute(written, "stroke-linecap", "round");
        }
        attribute(written, "stroke-linejoin", "round");
    }
    if let Some(fill) = look.fill {
        attribute(written, "fill", &fill.to_string());
    }
    written.push('>');
}

/// Writes texts of one pen; those with a halo (marked true) twice, first outlined in the background's colour, because
/// not every program knows the attribute `paint-order` that puts a stroke behind its letters. All halos come before all
/// letters, so that none covers a neighbour.
fn write_texts(written: &mut String, text: Text, look: &Look, background: Colour, marks: &[Drawn<'_>]) {
    if marks.iter().any(|mark| mark.1) {
        written.push_str("<g");
        attribute(written, "fill", &background.to_string());
        attribute(written, "stroke", &background.to_string());
        match text {
            Text::Letters => length(written, "stroke-width", look.halo),
            Text::Outlines | Text::Glyphs => {
                length(written, "stroke-width", look.halo / FINEST);
                attribute(written, "transform", IN_FINEST);
            }
        }
        attribute(written, "stroke-linejoin", "round");
        attribute(written, "aria-hidden", "true");
        written.push('>');
        for (mark, _) in marks.iter().filter(|mark| mark.1) {
            write_label(written, text, mark, None);
        }
        written.push_str("\n</g>\n");
    }
    written.push_str("<g");
    attribute(written, "fill", &look.ink.to_string());
    if text != Text::Letters {
        attribute(written, "transform", IN_FINEST);
    }
    written.push('>');
    for (mark, _) in marks {
        write_label(written, text, mark, mark.id.as_deref());
    }
    written.push_str("\n</g>\n");
}

/// Writes a text on a line of its own.
fn write_label(written: &mut String, text: Text, mark: &Mark, id: Option<&str>) {
    if let Some(placed) = placed(mark) {
        written.push('\n');
        match text {
            Text::Letters => write_text(written, placed, id),
            Text::Outlines => write_outline(written, placed, id),
            Text::Glyphs => write_glyphs(written, placed, id),
        }
    }
}
