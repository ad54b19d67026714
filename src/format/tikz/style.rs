//! Colours and styles of pens.

use std::fmt::Write;

use super::super::number::number;
use crate::drawing::{Cap, Colour, Drawing, Emphasis, Look, Mark, Pen, Shape};

/// What a pen draws in a figure.
#[derive(Clone, Copy, Default)]
pub(super) struct Used {
    lines: bool,
    texts: bool,
}

impl Used {
    /// Counts a shape in.
    pub(super) fn count(&mut self, shape: &Shape) {
        match shape {
            Shape::Text(_) => self.texts = true,
            _ => self.lines = true,
        }
    }
}

/// Gives a look its colours and its style by name, unless the document has.
pub(super) fn write_style(file: &mut String, name: &str, look: &Look, used: Used) {
    let mut style: Vec<String> = Vec::new();
    // An area without outline has the colour inside as its only one.
    let drawn = look.stroke.or(look.fill).filter(|_| used.lines);
    let main = drawn.unwrap_or(look.ink);
    write_colour(file, name, main);
    if used.texts {
        // Where a pen writes in another colour than it draws in, that colour has a name of its own.
        let own = used.lines && look.ink != main;
        let ink = if own { format!("{name}-ink") } else { name.to_owned() };
        if own {
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
                let turns = ["on", "off"].into_iter().cycle();
                let dashes = look.dash.iter().zip(turns);
                let dashes: Vec<String> =
                    dashes.map(|(length, turn)| format!("{turn} {}mm", number(*length))).collect();
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

/// What a mark's look is called in names of styles and colours: after its pen, with a number where the drawing's style gives links or curves
/// looks of their own, and with its emphasis.
pub(super) fn name(drawing: &Drawing, mark: &Mark) -> String {
    let mut name = pen_name(mark.pen).to_owned();
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

fn pen_name(pen: Pen) -> &'static str {
    match pen {
        Pen::Frame => "frame",
        Pen::Ground => "ground",
        Pen::Hatch => "hatch",
        Pen::Link => "link",
        Pen::LinkFill => "link-fill",
        Pen::Slider => "slider",
        Pen::Guide => "guide",
        Pen::Joint => "joint",
        Pen::Trace => "trace",
        Pen::Construction => "construction",
        Pen::Ray => "ray",
        Pen::Vector => "vector",
        Pen::Velocity => "velocity",
        Pen::Acceleration => "acceleration",
        Pen::Normal => "normal",
        Pen::Tangential => "tangential",
        Pen::Coriolis => "coriolis",
        Pen::Pole => "pole",
        Pen::Image => "image",
        Pen::ImageFill => "image-fill",
        Pen::ImagePoint => "image-point",
        Pen::Special => "special",
        Pen::Turning => "turning",
        Pen::Leader => "leader",
        Pen::Label => "label",
        Pen::Caption => "caption",
        Pen::Heading => "heading",
        Pen::Grid => "grid",
        Pen::Zero => "zero",
        Pen::Curve => "curve",
        Pen::Dead => "dead",
        Pen::Limit => "limit",
        Pen::Change => "change",
        Pen::Stand => "stand",
        Pen::Student => "student",
        Pen::StudentPoint => "student-point",
        Pen::Hint => "hint",
    }
}
