//! The pitch line of a rack, and the belt around two wheels.

use super::on_paper::SchemeOnPaper;
use crate::drawing::canvas::Canvas;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::geometry;
use crate::mechanism::{Belt, BodyId, GROUND, Joint, Rack};
use kurbo::{Point, Vec2};

/// How far a pitch line goes on beyond what touches it, in parts of the wheel's radius.
const BEYOND: f64 = 1.2;

/// Half the length of the stroke where a wheel touches, in mm.
const TOUCH: f64 = 1.6;

/// Length of a stroke of a fixed rack's hatching across its line, and the distance of two, in mm.
const HATCH: f64 = 1.6;
const APART: f64 = 1.8;

impl SchemeOnPaper<'_> {
    /// The pitch line on which a wheel rolls, as far as the rack and the wheel go along it, a stroke where they touch, and the hatching of a rack
    /// that is fixed.
    pub(super) fn rack(&self, canvas: &mut Canvas<'_>, joint: &Joint, rack: Rack) {
        let along = self.pose.guide(rack.slider);
        let center = self.pose.point(rack.center);
        let touch = center + geometry::quarter_turn(along) * (-rack.side * rack.radius);
        let reach = BEYOND * rack.radius;
        let body = joint.bodies[1 - rack.wheel];
        // A frame has points everywhere: its rack is there where the wheel is.
        let own = self.mechanism.body(body).points.iter().filter(|_| body != GROUND);
        let places = own.map(|&point| (self.pose.point(point) - touch).dot(&along));
        let (low, high) = places.fold((-reach, reach), |(low, high), at| (low.min(at), high.max(at)));
        let ends = [low, high].map(|at| self.view.at(touch + along * at));
        let pen = if body == GROUND { Pen::Guide } else { Pen::Link };
        canvas.draw(pen, Shape::Line(ends[0], ends[1])).number = self.context.number(body);
        self.stem(canvas, body, (touch, along));
        let (touch, center) = (self.view.at(touch), self.view.at(center));
        let outwards = touch - center;
        if outwards.hypot() <= f64::EPSILON {
            return;
        }
        let outwards = outwards / outwards.hypot();
        canvas.draw(Pen::Guide, Shape::Line(touch - outwards * TOUCH, touch + outwards * TOUCH));
        if body == GROUND {
            hatch_line(canvas, ends, outwards);
        }
    }

    /// What joins the line of a rack to its slider.
    fn stem(&self, canvas: &mut Canvas<'_>, body: BodyId, (touch, along): (geometry::Point, geometry::Vector)) {
        let slider = self.mechanism.sliders.iter().find(|slider| slider.link == body);
        let Some(at) = slider.map(|slider| self.pose.point(slider.at)).filter(|_| body != GROUND) else { return };
        let foot = touch + along * (at - touch).dot(&along);
        let [at, foot] = [at, foot].map(|place| self.view.at(place));
        if (at - foot).hypot() > self.dims().joint {
            canvas.draw(Pen::Link, Shape::Line(at, foot)).number = self.context.number(body);
        }
    }

    /// The straight parts of a belt: its circles' common tangents, the outer ones or the inner ones.
    pub(super) fn belt(&self, canvas: &mut Canvas<'_>, belt: Belt) {
        let places = belt.centers.map(|center| self.pose.point(center));
        let rim = |index: usize| self.view.at(places[index] + geometry::Vector::new(belt.radii[index], 0.0));
        let centers = places.map(|place| self.view.at(place));
        let radii = [0, 1].map(|index| (rim(index) - centers[index]).hypot());
        for [from, to] in tangents(centers, radii, belt.is_crossed) {
            canvas.draw(Pen::Guide, Shape::Line(from, to));
        }
    }
}

/// The common tangents of two circles, the outer or the inner ones, from the first to the second; none of circles that leave no room for one.
pub(in crate::drawing) fn tangents(centers: [Point; 2], radii: [f64; 2], is_inner: bool) -> Vec<[Point; 2]> {
    let way = centers[1] - centers[0];
    let away = way.hypot();
    let other = if is_inner { -radii[1] } else { radii[1] };
    // The sine of the angle between a tangent and the line of the centres.
    let sine = (radii[0] - other) / away;
    if sine.is_nan() || sine.abs() >= 1.0 {
        return Vec::new();
    }
    let along = way / away;
    let across = Vec2::new(-along.y, along.x);
    let tangent = |side: f64| {
        let normal = along * sine + across * (side * (1.0 - sine * sine).sqrt());
        [centers[0] + normal * radii[0], centers[1] + normal * other]
    };
    [1.0, -1.0].map(tangent).to_vec()
}

/// Strokes along a line on the side of `outwards`.
pub(in crate::drawing) fn hatch_line(canvas: &mut Canvas<'_>, [from, to]: [Point; 2], outwards: Vec2) {
    let way = to - from;
    let count = (way.hypot() / APART).floor().min(200.0);
    let step = way / count.max(1.0);
    let mut at = from;
    for _ in 0..count as usize {
        canvas.draw(Pen::Hatch, Shape::Line(at + step * 0.2, at + step * 0.7 + outwards * HATCH));
        at += step;
    }
}
