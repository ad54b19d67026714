//! Texts: as letters, as outlines, or as outlines that stand once in the file.

use super::super::number::push_digits;
use super::shapes::{attribute, length, write_id, write_path};
use crate::drawing::{Outline, OutlinePart, PlacedRun, PlacedText, Point};
use crate::text::xml;
use std::collections::BTreeMap;

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
