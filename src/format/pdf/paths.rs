//! Shapes as paths of PDF, which has lines and cubic curves only. Lengths are in mm.

use krilla::geom::{Path, PathBuilder};
use krilla::surface::Surface;
use kurbo::Affine;

use crate::drawing::{Outline, OutlinePart, Point, Shape};

/// A length in mm, rounded to a micrometre, so that the file is short and the same on every platform.
pub(super) fn length(mm: f64) -> f32 {
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
pub(super) fn outline(path: &mut PathBuilder, glyph: &Outline, origin: Point, size: f64) {
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
