//! Centrodes over the cycle of the drive, and inflection circles.

use super::on_paper::SchemeOnPaper;
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{clipped_segment, simplified, simplified_to};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use kurbo::{Point, Rect, Vec2};
use std::f64::consts::{PI, TAU};

/// Distance of a curve from the lines that labels keep off in its place, in mm.
const ROUGH: f64 = 0.3;
/// Parts of a circle, or of what of it is near the panel, that are straight.
const PARTS: usize = 360;
/// Distance of a label from the mark of its pole, in mm.
const BESIDE: f64 = 0.7;

impl SchemeOnPaper<'_> {
    /// Draws the centrodes: the fixed one full, the moving one dashed.
    pub(super) fn centrodes(&self, canvas: &mut Canvas<'_>) {
        let room = canvas.room();
        for centrode in &self.context.traces.centrodes {
            let number = self.context.number(centrode.link);
            let kinds = [("moving", Pen::Beyond, &centrode.moving), ("fixed", Pen::Trace, &centrode.fixed)];
            for (what, pen, pieces) in kinds {
                let chains = pieces.iter().flat_map(|piece| {
                    let chain: Vec<Point> = piece.iter().map(|(_, place)| self.view.at(*place)).collect();
                    within(room, &chain)
                });
                for (index, chain) in chains.enumerate() {
                    canvas.reserve(&Shape::Polyline(simplified_to(ROUGH, &chain)));
                    let name = format!("{what}-centrode-{}-{}", centrode.name, index + 1);
                    canvas.draw_below(&name, pen, Shape::Polyline(simplified(&chain))).number = number;
                }
            }
        }
    }

    /// Draws the inflection circles, over the diameters from the instant centre to the inflection pole, and both poles.
    pub(super) fn inflection_circles(&self, canvas: &mut Canvas<'_>) {
        let room = canvas.room();
        for name in &self.context.figure().inflection {
            let Some((link, poles)) = self.context.solution.inflection_circle(name) else { continue };
            let number = self.context.number(link);
            let [pole, inflection] = poles.map(|place| self.view.at(place));
            let (center, radius) = (pole.midpoint(inflection), 0.5 * pole.distance(inflection));
            for (part, chain) in around(room, center, radius).iter().enumerate() {
                canvas.reserve(&Shape::Polyline(simplified_to(ROUGH, chain)));
                let name = format!("inflection-circle-{name}-{}", part + 1);
                canvas.draw_below(&name, Pen::Construction, Shape::Polyline(simplified(chain))).number = number;
            }
            let [of_center, of_pole] = self.context.ends_of_inflection_circle(link);
            for (what, symbol, at) in [("pole", of_center, pole), ("inflection-pole", of_pole, inflection)] {
                if !room.inset(-1.0).contains(at) {
                    continue;
                }
                let shape = Shape::Circle { center: at, radius: self.dims().joint };
                canvas.draw_named(&format!("{what}-{name}"), Pen::Special, shape);
                canvas.label(&format!("{what}-{name}"), &symbol, at, self.dims().joint + BESIDE, None, 3);
            }
        }
    }
}

/// What of a chain of lines is in a room, in pieces.
fn within(room: Rect, chain: &[Point]) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    for ends in chain.windows(2) {
        let Some((from, to)) = clipped_segment(room, ends[0], ends[1]) else { continue };
        match pieces.last_mut().filter(|piece| piece.last() == Some(&from)) {
            Some(piece) => piece.push(to),
            None => pieces.push(vec![from, to]),
        }
    }
    pieces
}

/// What of a circle is in a room, as chains of lines. Of one much larger than the room only the part that is near it is looked at.
pub(in crate::drawing) fn around(room: Rect, center: Point, radius: f64) -> Vec<Vec<Point>> {
    let away = room.center() - center;
    let half = 0.5 * libm::hypot(room.width(), room.height());
    let (middle, spread) = match radius > 2.0 * half && away.hypot() > half {
        true => (libm::atan2(away.y, away.x), libm::asin((half / away.hypot()).min(1.0))),
        false => (0.0, PI),
    };
    let at = |part: usize| {
        let angle = middle + spread * (2.0 * part as f64 / PARTS as f64 - 1.0);
        let (sine, cosine) = libm::sincos(angle % TAU);
        center + Vec2::new(cosine, sine) * radius
    };
    let chain: Vec<Point> = (0..=PARTS).map(at).collect();
    within(room, &chain)
}
