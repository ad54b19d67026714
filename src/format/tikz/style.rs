//! Colours and styles of pens.

use std::fmt::Write;

use super::super::number::number;
use crate::drawing::{Cap, Colour, Drawing, Emphasis, Look, Mark, Shape};

/// Whether a pen draws lines and texts in a figure.
#[derive(Clone, Copy, Default)]
pub(super) struct Used {
    lines: bool,
    texts: bool,
}

impl Used {
    /// Notes that the pen draws a shape.
    pub(super) fn count(&mut self, shape: &Shape) {
        match shape {
            Shape::Text(_) => self.texts = true,
            _ => self.lines = true,
        }
    }
}

/// Writes the definitions of a look's colours and style, which take effect unless the document has its own.
pub(super) fn write_style(file: &mut String, name: &str, look: &Look, used: Used) {
    let mut style: Vec<String> = Vec::new();
    // The main colour is that of lines; of an area without outline that of its inside.
    let main = if used.lines { look.stroke.or(look.fill).unwrap_or(look.ink) } else { look.ink };
    write_colour(file, name, main);
    if used.texts {
        // The colour of texts has a name of its own where it is not that of lines.
        let is_other = used.lines && look.ink != main;
        let ink = if is_other { format!("{name}-ink") } else { name.to_owned() };
        if is_other {
            write_colour(file, &ink, look.ink);
        }
        style.push(format!("text=kinegon-{ink}"));
    }
    if used.lines {
        if look.stroke.is_some() {
            style.push(format!("draw=kinegon-{name},line width={}mm,line join=round", number(look.width)));
            if look.cap == Cap::Round {
                style.push("line cap=round".into());
            }
            if !look.dash.is_empty() {
                let dashes = look.dash.iter().zip(["on", "off"].into_iter().cycle());
                let dashes: Vec<String> =
                    dashes.map(|(length, state)| format!("{state} {}mm", number(*length))).collect();
                style.push(format!("dash pattern={}", dashes.join(" ")));
            }
        }
        match (look.stroke, look.fill) {
            (Some(_), Some(fill)) => {
                write_colour(file, &format!("{name}-inside"), fill);
                style.push(format!("fill=kinegon-{name}-inside"));
            }
            (None, Some(_)) => style.push(format!("fill=kinegon-{name}")),
            (_, None) => {}
        }
    }
    let _ = writeln!(file, "\\kinegonstyle{{{name}}}{{{}}}%", style.join(","));
}

pub(super) fn write_colour(file: &mut String, name: &str, Colour { red, green, blue }: Colour) {
    let _ = writeln!(file, "\\providecolor{{kinegon-{name}}}{{HTML}}{{{red:02X}{green:02X}{blue:02X}}}%");
}

/// The name of a mark's look in styles and colours: its pen, a number where the drawing's style gives links or curves
/// looks of their own, and its emphasis.
pub(super) fn name(drawing: &Drawing, mark: &Mark) -> String {
    let mut name = mark.pen.name().replace('_', "-");
    let look = |number| drawing.style.look(mark.pen, number);
    if let Some(number) = mark.number.filter(|&n| look(Some(n)) != look(None)) {
        let _ = write!(name, "-{}", number + 1);
    }
    name.push_str(match mark.emphasis {
        Emphasis::Plain => "",
        Emphasis::New => "-new",
        Emphasis::Earlier => "-earlier",
    });
    name
}
