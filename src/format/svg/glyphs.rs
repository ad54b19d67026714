//! Texts as outlines that stand once in the file.

use super::super::outline::{FINEST, Tracer};
use super::{Drawn, attribute, write_id};
use crate::drawing::{PlacedRun, PlacedText, Point, Shape};
use std::collections::BTreeMap;

/// A glyph's name in the file: its face, its number there, its size in hundredths of a mm.
fn name(run: &PlacedRun<'_>, number: u16) -> String {
    format!("{}{number}.{:.0}", if run.italic { 'i' } else { 'r' }, run.size / FINEST)
}

/// The outlines of all glyphs that texts have, by their names, to which [`write`] refers; empty without texts.
pub(super) fn definitions(marks: &[Drawn<'_>]) -> String {
    let mut known: BTreeMap<String, String> = BTreeMap::new();
    let texts =
        marks.iter().filter_map(|(mark, _)| if let Shape::Text(text) = &mark.shape { Some(text) } else { None });
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
pub(super) fn write(written: &mut String, text: &PlacedText, id: Option<&str>) {
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
