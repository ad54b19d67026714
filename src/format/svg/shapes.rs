//! Shapes as elements of SVG, with their attributes and path data.

use super::super::number::{number, push_number};
use crate::drawing::{Look, Point, Shape};
use crate::text::xml;

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

pub(super) fn write_id(written: &mut String, id: Option<&str>) {
    if let Some(id) = id {
        attribute(written, "id", &xml(id));
    }
}

pub(super) fn write_path(written: &mut String, id: Option<&str>, attributes: &str, data: impl FnOnce(&mut String)) {
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
