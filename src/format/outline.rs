use super::number::push_digits;
use crate::drawing::{Outline, OutlinePart, Point};

/// The unit of outlines, in mm: they are written in whole numbers. The error of rounding is a tenth of a pixel at 600
/// dots per inch.
pub(super) const FINEST: f64 = 0.01;
/// The transform of an SVG group in which outlines are written.
pub(super) const IN_FINEST: &str = "scale(.01)";

/// Writes outlines as path data in whole hundredths of a mm, each point relative to the one before.
pub(super) struct Tracer<'a> {
    data: &'a mut String,
    at: [i64; 2],
    /// The first point of the outline being written.
    start: [i64; 2],
    /// The command to which further numbers belong.
    command: char,
}

impl<'a> Tracer<'a> {
    pub(super) fn new(data: &'a mut String) -> Self {
        Self { data, at: [0; 2], start: [0; 2], command: ' ' }
    }

    /// Writes a glyph; its outline is in em, `origin` and `size` are in mm.
    pub(super) fn trace(&mut self, glyph: &Outline, origin: Point, size: f64) {
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
