//! Shapes as elements of SVG, with their attributes and path data; and texts: as letters, as outlines, or as outlines that stand once
//! in the file.

use super::super::number::{number, push_digits, push_number};
use crate::drawing::{Look, Outline, OutlinePart, PlacedRun, PlacedText, Point, Shape};
use crate::text::xml;
use std::collections::BTreeMap;

/// Writes a shape that is not a text, in the group of its pen.
pub(super) fn write_shape(written: &mut String, look: &Look, shape: &Shape, id: Option<&str>) {
    // An open line is never filled, even with a pen that fills areas.
    let open = if look.fill.is_some() { " fill=\"none\"" } else { "" };
    match shape {
        Shape::Line(from, to) => write_path(written, id, "", |data| chain(data, &[*from, *to], false)),
        Shape::Polyline(points) => write_path(written, id, open, |data| chain(data, points, false)),
        Shape::Polygon(points) => write_path(written, id, "", |data| chain(data, points, true)),
        Shape::Area(chains) => {
            write_path(written, id, "", |data| chains.iter().for_each(|points| chain(data, points, true)));
        }
        Shape::Circle { center, radius } => {
            written.push_str("<circle");
            write_id(written, id);
            for (name, value) in [("cx", center.x), ("cy", center.y), ("r", radius.abs())] {
                length(written, name, value);
            }
            written.push_str("/>");
        }
        Shape::Arc { center, radius, start, sweep } => {
            write_path(written, id, open, |data| arc(data, *center, *radius, *start, *sweep));
        }
        Shape::Arrow { .. } | Shape::ArcArrow { .. } => {
            // Shaft and head in one group with the mark's name.
            written.push_str("<g");
            write_id(written, id);
            written.push('>');
            if let Some(shaft) = shape.shaft() {
                write_shape(written, look, &shaft, None);
            }
            if let Some(head) = shape.head() {
                // Without a stroke, which would move the tip beyond the vector's end.
                let ink = look.stroke.unwrap_or(look.ink);
                let ink = format!(" fill=\"{ink}\" stroke=\"none\"");
                write_path(written, None, &ink, |data| chain(data, &head, true));
            }
            written.push_str("</g>");
        }
        // `write_texts` writes texts, in groups of their own.
        Shape::Text(_) => {}
    }
}

pub(super) fn attribute(written: &mut String, name: &str, value: &str) {
    for part in [" ", name, "=\"", value, "\""] {
        written.push_str(part);
    }
}

/// Writes a length in mm as an attribute.
pub(super) fn length(written: &mut String, name: &str, value: f64) {
    for part in [" ", name, "=\""] {
        written.push_str(part);
    }
    push_number(written, value);
    written.push('"');
}

fn write_id(written: &mut String, id: Option<&str>) {
    if let Some(id) = id {
        attribute(written, "id", &xml(id));
    }
}

fn write_path(written: &mut String, id: Option<&str>, attributes: &str, data: impl FnOnce(&mut String)) {
    written.push_str("<path");
    write_id(written, id);
    written.push_str(attributes);
    written.push_str(" d=\"");
    data(written);
    written.push_str("\"/>");
}

/// Path data of straight lines through points.
fn chain(data: &mut String, points: &[Point], closed: bool) {
    for (index, &point) in points.iter().enumerate() {
        data.push(if index == 0 { 'M' } else { 'L' });
        push_point(data, point);
    }
    if closed && !points.is_empty() {
        data.push('Z');
    }
}

/// Path data of part of a circle.
fn arc(data: &mut String, center: Point, radius: f64, start: f64, sweep: f64) {
    // One arc command cannot draw a full turn, and is badly conditioned near a full and near a half turn; thirds are
    // safe.
    let sweep = sweep.clamp(-std::f64::consts::TAU, std::f64::consts::TAU);
    let parts = (sweep.abs() / 2.1).ceil().max(1.0);
    let at = |angle: f64| Point::new(center.x + radius * libm::cos(angle), center.y + radius * libm::sin(angle));
    data.push('M');
    push_point(data, at(start));
    let (size, turning) = (number(radius.abs()), if sweep > 0.0 { "1" } else { "0" });
    for part in 1..=parts as u32 {
        for piece in ["A", &size, " ", &size, " 0 0 ", turning, " "] {
            data.push_str(piece);
        }
        push_point(data, at(start + sweep * f64::from(part) / parts));
    }
}

fn push_point(data: &mut String, point: Point) {
    push_number(data, point.x);
    data.push(' ');
    push_number(data, point.y);
}

/// The unit of outlines, in mm: they are written in whole numbers. The error of rounding is a tenth of a pixel at 600
/// dots per inch.
pub(super) const FINEST: f64 = 0.01;
/// The transform of an SVG group in which outlines are written.
pub(super) const IN_FINEST: &str = "scale(.01)";

/// Writes outlines as path data in whole hundredths of a mm, each point relative to the one before.
struct Tracer<'a> {
    data: &'a mut String,
    at: [i64; 2],
    /// The first point of the outline being written.
    start: [i64; 2],
    /// The command to which further numbers belong.
    command: char,
}

impl<'a> Tracer<'a> {
    fn new(data: &'a mut String) -> Self {
        Self { data, at: [0; 2], start: [0; 2], command: ' ' }
    }

    /// Writes a glyph; its outline is in em, `origin` and `size` are in mm.
    fn trace(&mut self, glyph: &Outline, origin: Point, size: f64) {
        let whole = |point: Point| {
            let place = origin + point.to_vec2() * size;
            // Each point is rounded by itself, so that rounding does not add up.
            [place.x, place.y].map(|mm| (mm / FINEST).round() as i64)
        };
        for element in glyph {
            match element {
                OutlinePart::MoveTo(to) => {
                    self.start = whole(to);
                    self.go('m', [self.start]);
                }
                OutlinePart::LineTo(to) => self.go('l', [whole(to)]),
                OutlinePart::QuadTo(by, to) => self.go('q', [by, to].map(whole)),
                OutlinePart::CurveTo(first, second, to) => self.go('c', [first, second, to].map(whole)),
                OutlinePart::ClosePath => {
                    self.data.push('z');
                    (self.at, self.command) = (self.start, 'z');
                }
            }
        }
    }

    fn go<const N: usize>(&mut self, command: char, points: [[i64; 2]; N]) {
        let mut apart = self.command == command;
        if !apart {
            self.data.push(command);
            self.command = command;
        }
        for point in points {
            for (to, from) in point.into_iter().zip(self.at) {
                let step = to - from;
                if step < 0 {
                    self.data.push('-');
                } else if apart {
                    self.data.push(' ');
                }
                push_digits(self.data, step.unsigned_abs());
                apart = true;
            }
        }
        self.at = points[N - 1];
    }
}

/// Writes a text as letters: each run at its measured place, without white space between the elements, which would be
/// visible.
pub(super) fn write_text(written: &mut String, text: &PlacedText, id: Option<&str>) {
    let several = text.text.runs().len() > 1;
    written.push_str("<text");
    write_id(written, id);
    // A text of one run needs no inner element.
    if several {
        length(written, "font-size", text.size);
        written.push('>');
    }
    for run in text.runs() {
        if several {
            written.push_str("<tspan");
        }
        if !several || run.size != text.size {
            length(written, "font-size", run.size);
        }
        if run.italic {
            attribute(written, "font-style", "italic");
        }
        length(written, "x", run.origin.x);
        length(written, "y", run.origin.y);
        written.push('>');
        written.push_str(&xml(run.content));
        if several {
            written.push_str("</tspan>");
        }
    }
    written.push_str("</text>");
}

/// Writes a text as one path, in hundredths of a mm.
pub(super) fn write_outline(written: &mut String, text: &PlacedText, id: Option<&str>) {
    write_path(written, id, "", |data| {
        let mut tracer = Tracer::new(data);
        for run in text.runs() {
            run.outline(|glyph, origin| tracer.trace(glyph, origin, run.size));
        }
    });
}

/// A glyph's name in the file: its face, its number there, its size in hundredths of a mm.
fn name(run: &PlacedRun<'_>, number: u16) -> String {
    format!("{}{number}.{:.0}", if run.italic { 'i' } else { 'r' }, run.size / FINEST)
}

/// The outlines of all glyphs that texts have, by their names, to which [`write_glyphs`] refers; empty without texts.
pub(super) fn definitions<'a>(texts: impl Iterator<Item = &'a PlacedText>) -> String {
    let mut known: BTreeMap<String, String> = BTreeMap::new();
    for run in texts.flat_map(PlacedText::runs) {
        let mut names = Vec::new();
        run.glyphs(|number, _, _| names.push(name(&run, number)));
        let mut names = names.into_iter();
        run.outline(|glyph, _| {
            let traced = |data: &mut String| Tracer::new(data).trace(glyph, Point::ORIGIN, run.size);
            if let Some(name) = names.next() {
                let outline = known.entry(name).or_default();
                if outline.is_empty() {
                    traced(outline);
                }
            }
        });
    }
    known.retain(|_, outline| !outline.is_empty());
    let paths = known.iter().map(|(name, outline)| format!("<path id=\"{name}\" d=\"{outline}\"/>\n"));
    let paths: String = paths.collect();
    if paths.is_empty() { paths } else { format!("\n<defs>\n{paths}</defs>") }
}

/// Writes a text by the names of its glyphs, in hundredths of a mm.
pub(super) fn write_glyphs(written: &mut String, text: &PlacedText, id: Option<&str>) {
    let whole = |mm: f64| format!("{:.0}", mm / FINEST + 0.0);
    written.push_str("<g");
    write_id(written, id);
    written.push('>');
    for run in text.runs() {
        let place = format!("translate({} {})", whole(run.origin.x), whole(run.origin.y));
        written.push_str("<g");
        attribute(written, "transform", &place);
        written.push('>');
        run.glyphs(|number, letters, left| {
            if run.content[letters].chars().all(char::is_whitespace) {
                return;
            }
            written.push_str("<use");
            attribute(written, "href", &format!("#{}", name(&run, number)));
            if left != 0.0 {
                attribute(written, "x", &whole(left * run.size));
            }
            written.push_str("/>");
        });
        written.push_str("</g>");
    }
    written.push_str("</g>");
}
