//! Shapes as paths of PDF, which has lines and cubic curves only, and texts as glyphs of the bundled fonts, at the places where they
//! were measured. Lengths are in mm.

use std::ops::Range;
use std::sync::OnceLock;

use krilla::geom::{self, Path, PathBuilder};
use krilla::surface::Surface;
use krilla::tagging::{ContentTag, Identifier, SpanTag};
use krilla::text::{Font, GlyphId, KrillaGlyph};
use kurbo::Affine;

use crate::drawing::{ITALIC, Outline, OutlinePart, PlacedRun, PlacedText, Point, REGULAR, Run, Shape};

/// A length in mm, rounded to a micrometre, so that the file is short and the same on every platform.
fn length(mm: f64) -> f32 {
    ((mm * 1000.0).round() / 1000.0) as f32
}

/// A shape as a path; `None` for a text, for an arrow, and where there is nothing to draw.
pub(super) fn path(shape: &Shape) -> Option<Path> {
    match *shape {
        Shape::Line(from, to) => chain(&[from, to], false),
        Shape::Polyline(ref points) => chain(points, false),
        Shape::Polygon(ref points) => chain(points, true),
        Shape::Area(ref chains) => {
            let mut path = PathBuilder::new();
            chains.iter().for_each(|points| push_chain(&mut path, points, true));
            path.finish()
        }
        Shape::Circle { center, radius } => {
            let mut path = PathBuilder::new();
            arc(&mut path, center, radius, 0.0, std::f64::consts::TAU);
            path.close();
            path.finish()
        }
        Shape::Arc { center, radius, start, sweep } => {
            let mut path = PathBuilder::new();
            arc(&mut path, center, radius, start, sweep);
            path.finish()
        }
        Shape::Arrow { .. } | Shape::ArcArrow { .. } | Shape::Text(_) => None,
    }
}

/// Draws a path, if there is one.
pub(super) fn draw_path(surface: &mut Surface<'_>, path: Option<Path>) {
    // Without fill and stroke krilla would fill with black.
    let is_visible = surface.get_fill().is_some() || surface.get_stroke().is_some();
    if is_visible && let Some(path) = path {
        surface.draw_path(&path);
    }
}

/// Straight lines through points; `None` without points.
pub(super) fn chain(points: &[Point], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    push_chain(&mut path, points, closed);
    path.finish()
}

fn push_chain(path: &mut PathBuilder, points: &[Point], closed: bool) {
    let Some((&first, rest)) = points.split_first() else { return };
    path.move_to(length(first.x), length(first.y));
    for &point in rest {
        path.line_to(length(point.x), length(point.y));
    }
    if closed {
        path.close();
    }
}

/// Draws part of a circle in cubic curves of at most a quarter turn each: they leave the circle by less than 0.03 % of
/// its radius.
fn arc(path: &mut PathBuilder, center: Point, radius: f64, start: f64, sweep: f64) {
    let sweep = sweep.clamp(-std::f64::consts::TAU, std::f64::consts::TAU);
    let parts = (sweep.abs() / std::f64::consts::FRAC_PI_2).ceil().max(1.0);
    let step = sweep / parts;
    // With this distance of the control points the curve's middle lies on the circle.
    let handle = 4.0 / 3.0 * libm::tan(0.25 * step) * radius;
    let on = |angle: f64, aside: f64| {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        [length(center.x + radius * cos - aside * sin), length(center.y + radius * sin + aside * cos)]
    };
    let [x, y] = on(start, 0.0);
    path.move_to(x, y);
    for part in 0..parts as u32 {
        let (from, to) = (start + step * f64::from(part), start + step * f64::from(part + 1));
        let ([x1, y1], [x2, y2], [x, y]) = (on(from, handle), on(to, -handle), on(to, 0.0));
        path.cubic_to(x1, y1, x2, y2, x, y);
    }
}

/// Draws the outline of a glyph; it is in em, `origin` and `size` are in mm.
fn outline_glyph(path: &mut PathBuilder, glyph: &Outline, origin: Point, size: f64) {
    let place = Affine::translate(origin.to_vec2()) * Affine::scale(size);
    for element in glyph {
        match place * element {
            OutlinePart::MoveTo(to) => path.move_to(length(to.x), length(to.y)),
            OutlinePart::LineTo(to) => path.line_to(length(to.x), length(to.y)),
            OutlinePart::QuadTo(by, to) => path.quad_to(length(by.x), length(by.y), length(to.x), length(to.y)),
            OutlinePart::CurveTo(first, second, to) => {
                let [first, second, to] = [first, second, to].map(|point| [length(point.x), length(point.y)]);
                path.cubic_to(first[0], first[1], second[0], second[1], to[0], to[1]);
            }
            OutlinePart::ClosePath => path.close(),
        }
    }
}

/// The bundled fonts, upright and italic, as krilla needs them.
fn fonts() -> &'static [Font; 2] {
    static FONTS: OnceLock<[Font; 2]> = OnceLock::new();
    let parse = |face: &'static [u8]| Font::new(face.into(), 0).expect("the bundled fonts are sound");
    FONTS.get_or_init(|| [REGULAR, ITALIC].map(parse))
}

/// Writes a text in the current colour, as a span of the page, run by run. Spaces between runs are written too, so
/// that words stay apart when they are copied.
///
/// PDF readers guess words from gaps between letters, and gaps beside scripts mislead them. So formulas, and texts
/// with a letter that the font lacks, get their reading as actual text. Readers take such a text for a line of its
/// own, so prose with an exponent gets none.
pub(super) fn write_text(surface: &mut Surface<'_>, text: &PlacedText) -> Identifier {
    let runs = text.text.runs();
    let has = |what: fn(&Run) -> bool| runs.iter().any(what);
    let is_formula = has(|run| run.italic) && has(|run| !run.scripts.is_empty());
    let reads = (is_formula || text.runs().any(lacks_a_letter)).then(|| reading(runs));
    let span = SpanTag::empty().with_actual_text(reads.as_deref());
    let span = surface.start_tagged(ContentTag::Span(span));
    for (placed, run) in text.runs().zip(runs) {
        if run.spaced {
            write_run(surface, &space_before(placed));
        }
        if lacks_a_letter(placed) {
            // The box of the missing letter as lines, and a space as a letter for the actual text to replace.
            let mut path = PathBuilder::new();
            outline(&mut path, placed);
            draw_path(surface, path.finish());
            let content = " ";
            write_run(surface, &PlacedRun { content, ..placed });
        } else {
            write_run(surface, &placed);
        }
    }
    surface.end_tagged();
    span
}

fn write_run(surface: &mut Surface<'_>, run: &PlacedRun<'_>) {
    let mut set: Vec<(u16, Range<usize>, f64)> = Vec::new();
    let end = run.glyphs(|glyph, letters, x| set.push((glyph, letters, x)));
    let ends = set.iter().skip(1).map(|next| next.2).chain([end]);
    let glyph = |((glyph, letters, x), end): (&(u16, Range<usize>, f64), f64)| {
        let glyph = GlyphId::new(u32::from(*glyph));
        KrillaGlyph::new(glyph, (end - x) as f32, 0.0, 0.0, 0.0, letters.clone(), None)
    };
    let glyphs: Vec<KrillaGlyph> = set.iter().zip(ends).map(glyph).collect();
    let font = &fonts()[usize::from(run.italic)];
    let [x, y, size] = [run.origin.x, run.origin.y, run.size].map(length);
    let start = geom::Point::from_xy(x, y);
    surface.draw_glyphs(start, &glyphs, font.clone(), run.content, size, false);
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
    run.outline(|glyph, origin| outline_glyph(path, glyph, origin, run.size));
}
