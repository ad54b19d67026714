//! What a reader could misread: texts of a panel that run together, and texts that a line goes through. Texts are measured
//! by the convex hulls of their letters' outlines, lines with their widths.

use super::faults::{covers, meet};
use kinegon::drawing::{Drawing, Mark, OutlinePart, Pen, PlacedText, Point, Rect, Shape, Vec2};
use std::f64::consts::PI;

/// Least white between two texts side by side, in em: with less they read as one.
const BESIDE: f64 = 0.5;
/// Least white between two texts one above the other, in em.
const STACKED: f64 = 0.15;
/// Difference of baselines, in em, below which two texts stand on one line to the eye: less than the height of small
/// letters.
const ONE_LINE: f64 = 0.4;
/// Straight parts of a circle.
const ROUND: usize = 32;

/// What can be misread on a sheet, in words.
#[derive(Clone, Debug, Default)]
pub struct Misread {
    /// Two texts on one line, too near to each other.
    pub beside: Vec<String>,
    /// Two texts one above the other, too near to each other.
    pub stacked: Vec<String>,
    /// A text with a line through it.
    pub struck: Vec<String>,
}

/// A text with its letters' hull.
struct Text<'a> {
    text: &'a PlacedText,
    pen: Pen,
    ink: Rect,
    hull: Vec<Point>,
}

/// What can be misread in the panels of a sheet. Captions are set in rows of their own: among themselves they are not held
/// against each other.
pub fn misread(drawing: &Drawing) -> Misread {
    let mut found = Misread::default();
    for (_, frame) in &drawing.panels {
        let marks = || drawing.marks.iter().filter(|mark| frame.overlaps(mark.shape.bounds()));
        let texts: Vec<Text<'_>> = marks().filter_map(text).collect();
        for (index, one) in texts.iter().enumerate() {
            for other in texts[..index].iter().filter(|other| one.pen != Pen::Caption || other.pen != Pen::Caption) {
                compare(one, other, &mut found);
            }
        }
        for mark in marks() {
            let strokes = strokes(drawing, mark);
            let strikes =
                |text: &&Text<'_>| strokes.iter().any(|stroke| covers(stroke, text.ink) && meet(&text.hull, stroke));
            for text in texts.iter().filter(strikes) {
                let what = mark.id.as_deref().unwrap_or("");
                found.struck.push(format!("{} by {:?} {what}", text.text.text.content(), mark.pen));
            }
        }
    }
    found
}

fn text(mark: &Mark) -> Option<Text<'_>> {
    let Shape::Text(text) = &mark.shape else { return None };
    let hull = hull(letters(text));
    (hull.len() > 2).then(|| Text { text, pen: mark.pen, ink: text.ink_box(), hull })
}

fn compare(one: &Text<'_>, other: &Text<'_>, found: &mut Misread) {
    let em = one.text.size.min(other.text.size);
    let aside = (one.ink.x0 - other.ink.x1).max(other.ink.x0 - one.ink.x1);
    let on_one_line = (one.text.origin.y - other.text.origin.y).abs() < ONE_LINE * em;
    if aside >= BESIDE * em {
        return;
    }
    let apart = distance(&one.hull, &other.hull) / em;
    let words = || format!("{} | {}: {apart:.2} em", one.text.text.content(), other.text.text.content());
    if on_one_line && apart < BESIDE {
        found.beside.push(words());
    } else if apart < STACKED {
        found.stacked.push(words());
    }
}

/// Points of the letters' outlines.
fn letters(text: &PlacedText) -> Vec<Point> {
    let mut points = Vec::new();
    for run in text.runs() {
        run.outline(|glyph, pen| {
            let mut last = Point::ORIGIN;
            for part in glyph.elements() {
                // Of a line all points between its ends are on it.
                let [a, b, c, d] = match *part {
                    OutlinePart::MoveTo(to) | OutlinePart::LineTo(to) => [to; 4],
                    OutlinePart::QuadTo(by, to) => [last, last.lerp(by, 2.0 / 3.0), to.lerp(by, 2.0 / 3.0), to],
                    OutlinePart::CurveTo(by, and, to) => [last, by, and, to],
                    OutlinePart::ClosePath => continue,
                };
                for share in [0.25, 0.5, 0.75, 1.0] {
                    let [ab, bc, cd] = [a.lerp(b, share), b.lerp(c, share), c.lerp(d, share)];
                    let on_curve = ab.lerp(bc, share).lerp(bc.lerp(cd, share), share);
                    points.push(pen + on_curve.to_vec2() * run.size);
                }
                last = d;
            }
        });
    }
    points
}

/// The convex hull of points, in order around it (Andrew, "Another efficient algorithm for convex hulls in two dimensions",
/// 1979).
fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for point in points {
            while let [.., a, b] = chain.as_slice()
                && (*b - *a).cross(point - *b) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let lower = half(&mut points.iter().copied());
    [lower, half(&mut points.iter().rev().copied())].concat()
}

/// The distance of two convex areas; 0 where they meet.
fn distance(one: &[Point], other: &[Point]) -> f64 {
    if meet(one, other) {
        return 0.0;
    }
    let from = |corners: &[Point], sides: &[Point]| {
        let next = sides.iter().cycle().skip(1);
        let all = sides.iter().zip(next).flat_map(|(a, b)| corners.iter().map(move |corner| to_side(*corner, *a, *b)));
        all.fold(f64::INFINITY, f64::min)
    };
    from(one, other).min(from(other, one))
}

fn to_side(point: Point, a: Point, b: Point) -> f64 {
    let run = b - a;
    let share = if run.hypot2() > 0.0 { ((point - a).dot(run) / run.hypot2()).clamp(0.0, 1.0) } else { 0.0 };
    (point - a.lerp(b, share)).hypot()
}

/// Convex areas that together are the lines of a mark, with their width. Areas without outline and the broad pale lines under
/// the subject of a step have none.
fn strokes(drawing: &Drawing, mark: &Mark) -> Vec<Vec<Point>> {
    let look = drawing.look(mark);
    if look.stroke.is_none() || matches!(mark.pen, Pen::Hint | Pen::Ghost) {
        return Vec::new();
    }
    let straight = |a: Point, b: Point| {
        let along = if a == b { Vec2::new(1.0, 0.0) } else { (b - a).normalize() };
        let across = Vec2::new(-along.y, along.x) * (0.5 * look.width);
        vec![a - across, a + across, b + across, b - across]
    };
    let chain = |points: &[Point]| points.windows(2).map(|ends| straight(ends[0], ends[1])).collect::<Vec<_>>();
    let closed = |points: &[Point]| {
        let first = points.first().copied();
        chain(&points.iter().copied().chain(first).collect::<Vec<_>>())
    };
    let round = |center: Point, radius: f64, start: f64, sweep: f64| {
        let at = |k: usize| {
            let angle = start + sweep * k as f64 / ROUND as f64;
            center + Vec2::new(libm::cos(angle), libm::sin(angle)) * radius
        };
        (0..=ROUND).map(at).collect::<Vec<_>>()
    };
    let mut strokes = match &mark.shape {
        Shape::Line(a, b) => vec![straight(*a, *b)],
        Shape::Polyline(points) => chain(points),
        Shape::Polygon(points) => closed(points),
        Shape::Area(chains) => chains.iter().flat_map(|points| closed(points)).collect(),
        Shape::Circle { center, radius } => vec![round(*center, *radius + 0.5 * look.width, 0.0, 2.0 * PI)],
        Shape::Arc { center, radius, start, sweep } | Shape::ArcArrow { center, radius, start, sweep, .. } => {
            chain(&round(*center, *radius, *start, *sweep))
        }
        Shape::Arrow { from, to, .. } => vec![straight(*from, *to)],
        _ => Vec::new(),
    };
    // The notch of a head is hardly seen: tip and barbs are a triangle.
    strokes.extend(mark.shape.head().map(|[tip, left, _, right]| vec![tip, left, right]));
    strokes
}
