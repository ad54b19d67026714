//! Bobillier's construction: collineation axes, pole tangents, centres of curvature of paths.

use super::CentersOnPaper;
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{clipped_segment, simplified};
use crate::drawing::labels::LabelRequest;
use crate::drawing::scheme::centrodes::around;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::text::RichText;
use crate::drawing::view::on_sheet;
use crate::geometry::Place;
use crate::words::under;
use kurbo::Point;

/// How far a pole tangent is drawn on both sides of the pole, in mm.
const TANGENT: f64 = 22.0;
/// How far a line goes on beyond its end, in mm.
const BEYOND: f64 = 2.0;

impl CentersOnPaper<'_> {
    /// Draws what leads to centres of curvature, and these.
    pub(super) fn curvatures(&self, canvas: &mut Canvas<'_>) {
        let has_lines = self.context.figure().construction.has_lines();
        for (index, tangent) in self.centers.tangents.iter().enumerate() {
            let Some(pole) = self.centers.get(tangent.pole).place.finite() else { continue };
            let pole = self.view.at(pole);
            let name = &self.context.mechanism().body(tangent.link).name;
            let [axis, own] = self.steps.tangents[index];
            if has_lines {
                canvas.step = axis;
                let pins = tangent.rays.map(|ray| self.centers.get(ray.pin).place);
                let fixed = tangent.rays.map(|ray| self.centers.get(ray.center).place);
                self.over(canvas, &format!("pins-{name}"), pins, tangent.crossing);
                self.over(canvas, &format!("fixed-{name}"), fixed, tangent.crossing);
                self.over(canvas, &format!("axis-{name}"), [self.centers.get(tangent.pole).place; 2], tangent.crossing);
                self.dot(canvas, &format!("Q-{name}"), "Q", tangent.crossing);
            }
            canvas.step = own;
            let along = on_sheet(tangent.direction) * TANGENT;
            if let Some((a, b)) = clipped_segment(canvas.room(), pole - along, pole + along) {
                canvas.draw_named(&format!("tangent-{name}"), Pen::Special, Shape::Line(a, b));
                let symbol = format!("t_{{{}}}", self.context.link_in_index(tangent.link));
                let request = LabelRequest::new(RichText::math(&symbol), b, 1.0, None, 3);
                canvas.ask(&format!("tangent-{name}"), request);
            }
        }
        for (index, found) in self.centers.curvatures.iter().enumerate() {
            let Some(tangent) = self.centers.tangents.get(found.tangent) else { continue };
            let name = self.context.mechanism().point_name(found.point);
            let (ray, at) = (tangent.rays[found.by], self.context.solution.pose.point(found.point));
            let [pin, fixed, pole] = [ray.pin, ray.center, tangent.pole].map(|id| self.centers.get(id).place);
            let [own, last] = self.steps.curvatures[index];
            if has_lines {
                canvas.step = own;
                self.over(canvas, &format!("ray-{name}"), [pole, Place::At(at)], found.center);
                self.over(canvas, &format!("axis-of-{name}"), [pole; 2], found.crossing);
                self.over(canvas, &format!("line-of-{name}"), [pin, Place::At(at)], found.crossing);
                canvas.step = last;
                self.over(canvas, &format!("last-{name}"), [fixed, found.crossing], found.center);
            }
            canvas.step = last;
            let symbol = under(&self.context.told(name, None), "0");
            self.dot(canvas, &format!("curvature-{name}"), &symbol, found.center);
        }
    }

    /// Draws what leads to inflection poles, these, and the inflection circles.
    pub(super) fn inflections(&self, canvas: &mut Canvas<'_>) {
        let has_lines = self.context.figure().construction.has_lines();
        for (index, found) in self.centers.inflections.iter().enumerate() {
            let Some(tangent) = self.centers.tangents.get(found.tangent) else { continue };
            let name = &self.context.mechanism().body(tangent.link).name;
            let place = |id| self.centers.get(id).place;
            let (pole, pin) = (place(tangent.pole), place(tangent.rays[found.by].pin));
            let [own, last] = self.steps.inflections[index];
            canvas.step = own;
            if has_lines {
                self.over(canvas, &format!("inflection-ray-{name}"), [pole, pin], found.point);
            }
            if !found.measured.is_empty() {
                self.dot(canvas, &format!("inflection-point-{name}"), "J", found.point);
            }
            canvas.step = last;
            if has_lines {
                self.over(canvas, &format!("inflection-normal-{name}"), [found.point; 2], found.pole);
                self.over(canvas, &format!("pole-normal-{name}"), [pole; 2], found.pole);
            }
            if let (Some(from), Some(to)) = (pole.finite(), found.pole.finite()) {
                let [from, to] = [from, to].map(|at| self.view.at(at));
                let (center, radius) = (from.midpoint(to), 0.5 * from.distance(to));
                for (part, chain) in around(canvas.room(), center, radius).iter().enumerate() {
                    let name = format!("inflection-circle-of-{name}-{}", part + 1);
                    canvas.draw_named(&name, Pen::Construction, Shape::Polyline(simplified(chain)));
                }
            }
            let [_, symbol] = self.context.ends_of_inflection_circle(tangent.link);
            self.dot(canvas, &format!("inflection-pole-of-{name}"), &symbol, found.pole);
        }
    }

    /// A line over three places of it, as far as it is on the panel; towards one at infinity to the edge.
    fn over(&self, canvas: &mut Canvas<'_>, name: &str, [first, second]: [Place; 2], third: Place) {
        let finite: Vec<Point> =
            [first, second, third].iter().filter_map(|place| place.finite()).map(|place| self.view.at(place)).collect();
        let far = [first, second, third].into_iter().find_map(|place| match place {
            Place::AtInfinity(along) => Some(on_sheet(along).normalize()),
            Place::At(_) => None,
        });
        let Some(&from) = finite.first() else { return };
        let farthest = finite.iter().max_by(|a, b| (**a - from).hypot().total_cmp(&(**b - from).hypot()));
        let along = farthest.map(|end| *end - from).filter(|way| way.hypot() > 1e-6).map(|way| way.normalize());
        let Some(along) = along.or(far) else { return };
        let on_line = || finite.iter().map(|place| (*place - from).dot(along));
        let reach = canvas.frame.width() + canvas.frame.height();
        let far = if far.is_some() { reach } else { 0.0 };
        let low = on_line().fold(0.0, f64::min) - BEYOND - far;
        let high = on_line().fold(0.0, f64::max) + BEYOND + far;
        if let Some((a, b)) = clipped_segment(canvas.room(), from + along * low, from + along * high) {
            canvas.draw_named(name, Pen::Construction, Shape::Line(a, b));
        }
    }

    /// A place with its symbol, if it is on the panel.
    fn dot(&self, canvas: &mut Canvas<'_>, name: &str, symbol: &str, place: Place) {
        let Some(center) = self.shown(canvas, place) else { return };
        canvas.draw_named(name, Pen::Special, Shape::Circle { center, radius: canvas.dims.joint });
        let request = LabelRequest::new(RichText::math(symbol), center, canvas.dims.joint + 0.7, None, 3);
        canvas.ask(name, request);
    }
}
