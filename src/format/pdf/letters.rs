//! Texts as glyphs of the bundled fonts, at the places where they were measured.

use std::ops::Range;
use std::sync::OnceLock;

use krilla::geom::{self, Path, PathBuilder};
use krilla::surface::Surface;
use krilla::tagging::{ContentTag, Identifier, SpanTag};
use krilla::text::{Font, GlyphId, KrillaGlyph};

use super::paths;
use crate::drawing::{ITALIC, PlacedRun, PlacedText, REGULAR, Run};

/// The bundled fonts, upright and italic, as krilla needs them.
pub(super) struct Fonts([Font; 2]);

impl Fonts {
    pub(super) fn new() -> Self {
        static FONTS: OnceLock<[Font; 2]> = OnceLock::new();
        let parse = |face: &'static [u8]| Font::new(face.into(), 0).expect("the bundled fonts are sound");
        Self(FONTS.get_or_init(|| [REGULAR, ITALIC].map(parse)).clone())
    }

    /// Writes a text in the current colour, as a span of the page, run by run. Spaces between runs are written too, so
    /// that words stay apart when they are copied.
    ///
    /// PDF readers guess words from gaps between letters, and gaps beside scripts mislead them. So formulas, and texts
    /// with a letter that the font lacks, get their reading as actual text. Readers take such a text for a line of its
    /// own, so prose with an exponent gets none.
    pub(super) fn write(&self, surface: &mut Surface<'_>, text: &PlacedText) -> Identifier {
        let runs = text.text.runs();
        let has = |what: fn(&Run) -> bool| runs.iter().any(what);
        let is_formula = has(|run| run.italic) && has(|run| !run.scripts.is_empty());
        let reads = (is_formula || text.runs().any(lacks_a_letter)).then(|| reading(runs));
        let span = SpanTag::empty().with_actual_text(reads.as_deref());
        let span = surface.start_tagged(ContentTag::Span(span));
        for (placed, run) in text.runs().zip(runs) {
            if run.spaced {
                self.write_run(surface, &space_before(placed));
            }
            if lacks_a_letter(placed) {
                // The box of the missing letter as lines, and a space as a letter for the actual text to replace.
                let mut path = PathBuilder::new();
                outline(&mut path, placed);
                paths::draw_path(surface, path.finish());
                let content = " ";
                self.write_run(surface, &PlacedRun { content, ..placed });
            } else {
                self.write_run(surface, &placed);
            }
        }
        surface.end_tagged();
        span
    }

    fn write_run(&self, surface: &mut Surface<'_>, run: &PlacedRun<'_>) {
        let mut set: Vec<(u16, Range<usize>, f64)> = Vec::new();
        let end = run.glyphs(|glyph, letters, x| set.push((glyph, letters, x)));
        let ends = set.iter().skip(1).map(|next| next.2).chain([end]);
        let glyph = |((glyph, letters, x), end): (&(u16, Range<usize>, f64), f64)| {
            let glyph = GlyphId::new(u32::from(*glyph));
            KrillaGlyph::new(glyph, (end - x) as f32, 0.0, 0.0, 0.0, letters.clone(), None)
        };
        let glyphs: Vec<KrillaGlyph> = set.iter().zip(ends).map(glyph).collect();
        let font = &self.0[usize::from(run.italic)];
        let [x, y, size] = [run.origin.x, run.origin.y, run.size].map(paths::length);
        let start = geom::Point::from_xy(x, y);
        surface.draw_glyphs(start, &glyphs, font.clone(), run.content, size, false);
    }
}

/// Whether the font lacks a letter of the run and would show an empty box.
fn lacks_a_letter(run: PlacedRun<'_>) -> bool {
    let mut lacks = false;
    run.glyphs(|glyph, _, _| lacks |= glyph == 0);
    lacks
}

/// The letters of runs with the spaces between them.
fn reading(runs: &[Run]) -> String {
    let mut reading = String::new();
    for run in runs {
        reading.push_str(if run.spaced { " " } else { "" });
        reading.push_str(&run.content);
    }
    reading
}

/// A space that ends where a run starts.
fn space_before(run: PlacedRun<'_>) -> PlacedRun<'_> {
    let mut space = PlacedRun { content: " ", italic: false, ..run };
    space.origin.x -= space.glyphs(|_, _, _| {}) * space.size;
    space
}

/// The outlines of all letters of a text; `None` where there is nothing to draw.
pub(super) fn outlines(text: &PlacedText) -> Option<Path> {
    let mut path = PathBuilder::new();
    text.runs().for_each(|run| outline(&mut path, run));
    path.finish()
}

fn outline(path: &mut PathBuilder, run: PlacedRun<'_>) {
    run.outline(|glyph, origin| paths::outline(path, glyph, origin, run.size));
}
