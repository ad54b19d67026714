//! Shapes as paths of TikZ.

use super::super::number::push_number;
use crate::drawing::{Outline, OutlinePart, Point, Shape, Vec2};

/// Writes a shape as a path; nothing for a text or an arrow.
pub(super) fn write_path(file: &mut String, shape: &Shape) {
    match *shape {
        Shape::Line(from, to) => write_chain(file, &[from, to]),
        Shape::Polyline(ref points) => write_chain(file, points),
        Shape::Polygon(ref points) => {
            write_chain(file, points);
            file.push_str("--cycle");
        }
        Shape::Area(ref chains) => {
            for points in chains {
                write_chain(file, points);
                file.push_str("--cycle");
            }
        }
        Shape::Circle { center, radius } => {
            write_point(file, center);
            file.push_str("circle[radius=");
            push_number(file, radius.abs());
            file.push(']');
        }
        Shape::Arc { center, radius, start, sweep } => {
            let sweep = sweep.clamp(-std::f64::consts::TAU, std::f64::consts::TAU);
            let (sin, cos) = (libm::sin(start), libm::cos(start));
            write_point(file, center + Vec2::new(cos, sin) * radius);
            for (name, value) in [
                ("arc[start angle=", start.to_degrees()),
                (",end angle=", (start + sweep).to_degrees()),
                (",radius=", radius),
            ] {
                file.push_str(name);
                push_number(file, value);
            }
            file.push(']');
        }
        Shape::Arrow { .. } | Shape::ArcArrow { .. } | Shape::Text(_) => {}
    }
}

fn write_chain(file: &mut String, points: &[Point]) {
    for (index, &point) in points.iter().enumerate() {
        file.push_str(if index == 0 { "" } else { "--" });
        write_point(file, point);
    }
}

fn write_point(file: &mut String, point: Point) {
    file.push('(');
    push_number(file, point.x);
    file.push(',');
    push_number(file, point.y);
    file.push(')');
}

/// Writes the outline of a glyph, one closed curve per line; it is in em, `origin` and `size` are in mm.
pub(super) fn write_outline(file: &mut String, glyph: &Outline, origin: Point, size: f64) {
    let at = |point: Point| origin + point.to_vec2() * size;
    let mut pen = Point::ORIGIN;
    for element in glyph {
        let [first, second, to] = match element {
            OutlinePart::MoveTo(to) | OutlinePart::LineTo(to) => {
                file.push_str(if matches!(element, OutlinePart::MoveTo(_)) { "\n  " } else { "--" });
                write_point(file, at(to));
                pen = to;
                continue;
            }
            // The control points of the same curve as a cubic one.
            OutlinePart::QuadTo(by, to) => [pen.lerp(by, 2.0 / 3.0), to.lerp(by, 2.0 / 3.0), to],
            OutlinePart::CurveTo(first, second, to) => [first, second, to],
            OutlinePart::ClosePath => {
                file.push_str("--cycle");
                continue;
            }
        };
        file.push_str("..controls");
        write_point(file, at(first));
        file.push_str("and");
        write_point(file, at(second));
        file.push_str("..");
        write_point(file, at(to));
        pen = to;
    }
}
