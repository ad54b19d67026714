//! Arrows beside driven links and sliders, the senses of their drives; values: rates with arrows in their sense around
//! the links' centres, given lengths beside the links.

use super::on_paper::SchemeOnPaper;
use crate::drawing::canvas::Canvas;
use crate::drawing::context::{Purpose, Value, ValueOf};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::values::{drive_value, is_at_drive, label};
use crate::drawing::view::on_sheet;
use crate::mechanism::{BodyId, GROUND, PointId, Role, SliderId};
use crate::quantity::QuantityKind;
use crate::scene::{Argument, QuantityName};
use crate::sheet::Sheet;
use kurbo::{Point, Vec2};
use std::f64::consts::PI;

/// Radius of the arrow of a solved rate, in mm.
const RATE_RADIUS: f64 = 5.0;
/// Radius of the arrow of an angular acceleration, around that of the angular velocity, in mm.
const ALPHA_RADIUS: f64 = 6.6;

impl SchemeOnPaper<'_> {
    pub(super) fn rotation_arrows(&self, canvas: &mut Canvas<'_>) {
        for (link, body) in self.mechanism.links() {
            if let Role::Driver { pivot, omega, .. } = body.role
                && omega != 0.0
            {
                self.rotation_arrow(canvas, link, pivot, omega);
            }
        }
    }

    pub(super) fn slide_arrows(&self, canvas: &mut Canvas<'_>) {
        for slider in self.mechanism.slider_ids() {
            match self.mechanism.slider(slider).drive {
                Some(drive) if drive.speed != 0.0 => {
                    let name = self.mechanism.push_name(slider);
                    let label = format!("v_{{{}}}", canvas.shown(&name, &name));
                    self.slide_arrow(canvas, slider, drive.speed, ["speed", &label]);
                }
                None if self.context.purpose == Purpose::Exercise => {
                    self.slide_arrow(canvas, slider, 1.0, ["sense", "+"]);
                }
                _ => {}
            }
        }
    }

    /// Draws the senses of the angular rates that a step yields, unless they are there with their values: a curved arrow
    /// around the centre of each link.
    pub(super) fn rate_arrows(&self, canvas: &mut Canvas<'_>, step: u16, unknowns: &[(String, f64)]) {
        for (name, value) in unknowns.iter().filter(|(_, value)| *value != 0.0 && self.context.values.is_empty()) {
            let name = QuantityName::parse(name).filter(|name| name.head.argument() == Argument::Link);
            let Some(link) = name.and_then(|name| self.mechanism.link(name.arguments.first()?)) else {
                continue;
            };
            if let Some(shape) = self.rate_arrow(link, RATE_RADIUS, *value) {
                canvas.draw_in_step(step, Pen::Turning, shape).number = self.context.number(link);
            }
        }
    }

    /// A curved arrow in the sense of a rate around the centre of a link; none for a link without points.
    pub(super) fn rate_arrow(&self, link: BodyId, radius: f64, rate: f64) -> Option<Shape> {
        const SWEEP: f64 = 4.2;
        let places: Vec<Point> = self.mechanism.body(link).points.iter().map(|&point| self.at(point)).collect();
        let center = match places.as_slice() {
            [] => return None,
            // Off the link's name.
            [a, b] if (*b - *a).hypot() > 8.0 * radius => a.lerp(*b, 0.35),
            _ => (places.iter().fold(Vec2::ZERO, |sum, place| sum + place.to_vec2()) / places.len() as f64).to_point(),
        };
        let sense = -rate.signum();
        Some(Shape::ArcArrow {
            center,
            radius,
            start: -0.5 * PI - 0.5 * sense * SWEEP,
            sweep: sense * SWEEP,
            head: self.dims().head,
        })
    }

    /// The arm of a driven link from its pivot: to another point, else to a block on it, else along its axis.
    fn arm_of(&self, link: BodyId, pivot: PointId) -> Vec2 {
        const LONG: f64 = 10.0;
        let center = self.at(pivot);
        let points = self.mechanism.body(link).points.iter().copied();
        let blocks = self.mechanism.sliders.iter().filter(|slider| slider.on == link).map(|slider| slider.at);
        let mut arms = points.chain(blocks).map(|point| self.at(point) - center);
        let far = arms.find(|arm| arm.hypot() >= 1.0);
        let axis = || self.pose.axes[link.0].map_or(Vec2::new(1.0, 0.0), on_sheet).normalize() * LONG;
        far.unwrap_or_else(axis)
    }

    /// Draws the sense of rotation of a driven link.
    fn rotation_arrow(&self, canvas: &mut Canvas<'_>, link: BodyId, pivot: PointId, omega: f64) {
        const RADIUS: f64 = 7.5;
        const SWEEP: f64 = 1.5;
        let name = self.mechanism.body(link).name.as_str();
        let (center, arm) = (self.at(pivot), self.arm_of(link, pivot));
        // Counter-clockwise is negative in the angles of the sheet.
        let sense = -omega.signum();
        let start = |lead: f64| libm::atan2(arm.y, arm.x) + sense * lead;
        let (sweep, head) = (sense * SWEEP, canvas.dims.head);
        let arc = |&(radius, lead): &(f64, f64)| Shape::ArcArrow { center, radius, start: start(lead), sweep, head };
        // Within the panel and, if possible, off the pivot's hatching: ahead of the link, behind it, or smaller.
        let (bounds, foot) = (canvas.obstacles.bounds, self.pivot_box(pivot));
        let behind = -0.35 - SWEEP;
        let tries = [(RADIUS, 0.35), (RADIUS, behind), (0.8 * RADIUS, 0.35), (0.8 * RADIUS, behind)];
        let fits = |tried: &&(f64, f64)| arc(tried).drawn_box().union(bounds) == bounds;
        let clear = |tried: &&(f64, f64)| arc(tried).drawn_box().intersect(foot).area() <= 0.0;
        let best = tries.iter().filter(fits).find(clear);
        let best @ &(radius, lead) = best.or(tries.iter().find(fits)).unwrap_or(&tries[2]);
        canvas.draw_named(&format!("omega-{name}"), Pen::Turning, arc(best)).number = self.context.number(link);
        let middle = start(lead) + 0.6 * sweep;
        let direction = Vec2::new(libm::cos(middle), libm::sin(middle));
        let label = format!("ω_{{{}}}", canvas.shown(name, name));
        let anchor = center + direction * radius;
        let name = format!("omega({name})");
        let label = canvas.label(&name, &label, anchor, 0.8, Some(direction), 2);
        label.number = self.context.number(link);
        if let Some(value) = drive_value(self.context, link) {
            label.short = Some(std::mem::replace(&mut label.request.text, value.text()));
        }
    }

    /// Draws an arrow beside a block along its guide, in the sense of `speed` relative to the guide's body; with what its
    /// ids begin with, and its label's markup.
    fn slide_arrow(&self, canvas: &mut Canvas<'_>, id: SliderId, speed: f64, [what, label]: [&str; 2]) {
        const LENGTH: f64 = 10.0;
        const BESIDE: f64 = 2.0;
        let slider = self.mechanism.slider(id);
        let along = on_sheet(self.pose.guide(id));
        let (block, half) = (self.at(slider.at), self.half(id));
        let free = match slider.on {
            GROUND => -self.ground_side(id),
            _ => Vec2::new(along.y, -along.x),
        };
        let outward = self.outward(block).unwrap_or(free);
        let sides = match (slider.on == GROUND, free.dot(outward) > 0.0) {
            (true, _) => [free, free],
            (false, true) => [free, -free],
            (false, false) => [-free, free],
        };
        let arm = along * (0.5 * LENGTH * speed.signum());
        // Beside the block or a little further on: inside the panel, where fewest obstacles are crossed.
        let bounds = canvas.obstacles.bounds;
        let places = sides.into_iter().flat_map(|side| [0.0, -LENGTH, LENGTH].map(|shift| (side, shift)));
        let arrows = places.map(|(side, shift)| {
            let middle = block + along * shift + side * (half.y + BESIDE);
            (side, middle - arm, middle + arm)
        });
        let cost = |&(_, from, to): &(Vec2, Point, Point)| {
            let drawn = canvas.arrow(from, to).drawn_box();
            (drawn.union(bounds) != bounds, canvas.obstacles.crossings_with(from, to))
        };
        let best = arrows.min_by_key(cost);
        let (side, from, to) = best.expect("there are six places to choose from");
        let (name, number) = (self.mechanism.push_name(id), self.context.number(slider.link));
        canvas.draw_named(&format!("{what}-{name}"), Pen::Turning, canvas.arrow(from, to)).number = number;
        canvas.label(&format!("{what}({name})"), label, from.midpoint(to), 0.8, Some(side), 2).number = number;
    }

    /// Draws the arrows of rates and requests the labels of all values.
    pub(super) fn values(&self, canvas: &mut Canvas<'_>) {
        let mut taken: Vec<Point> = Vec::new();
        for value in self.context.values_of(Sheet::Scheme) {
            if let ValueOf::Rate(link) = value.of {
                self.arrow_of_rate(canvas, value, link, &mut taken);
            }
        }
        for value in self.context.values_of(Sheet::Scheme) {
            match value.of {
                ValueOf::Rate(link) => self.label_rate(canvas, value, link),
                ValueOf::Length(ends) => {
                    // Beside the line, away from the middle of the mechanism.
                    let [a, b] = ends.map(|point| self.at(point));
                    let anchor = a.lerp(b, 0.66);
                    label(self.context, canvas, value, anchor, Some(self.outer_side([a, b], anchor)));
                }
                ValueOf::Vector(_) => {}
            }
        }
        canvas.step = 0;
    }

    /// The arrow of a rate of a link; that of a drive's angular velocity is at its pivot. Without room between the joints
    /// and the arrows around the centres `taken` there is none.
    fn arrow_of_rate(&self, canvas: &mut Canvas<'_>, value: &Value, link: BodyId, taken: &mut Vec<Point>) {
        if value.number == 0.0 || is_at_drive(self.context, value, link) {
            return;
        }
        let (radius, name) = match value.kind {
            QuantityKind::AngularAcceleration => (ALPHA_RADIUS, "alpha"),
            _ => (RATE_RADIUS, "omega"),
        };
        if let Some(shape @ Shape::ArcArrow { center, .. }) = self.rate_arrow(link, radius, value.number) {
            let mut joints = self.pose.points.iter().map(|&place| self.view.at(place));
            let is_near = |other: &Point| (*other - center).hypot() < 2.0 * ALPHA_RADIUS + 1.0;
            let is_apart = joints.all(|joint| (joint - center).hypot() > radius + self.dims().joint + 1.0);
            if !is_apart || taken.iter().any(|other| *other != center && is_near(other)) {
                return;
            }
            taken.push(center);
            canvas.step = value.since;
            let name = format!("{name}-{}", self.mechanism.body(link).name);
            canvas.draw_named(&name, Pen::Turning, shape).number = self.context.number(link);
        }
    }

    fn label_rate(&self, canvas: &mut Canvas<'_>, value: &Value, link: BodyId) {
        let Some(Shape::ArcArrow { center, radius, .. }) = self.rate_arrow(link, ALPHA_RADIUS, 1.0) else {
            return;
        };
        if is_at_drive(self.context, value, link) {
            return;
        }
        let side = if value.kind == QuantityKind::AngularAcceleration { 1.0 } else { -1.0 };
        let anchor = center + Vec2::new(0.0, side * radius);
        label(self.context, canvas, value, anchor, Some(Vec2::new(0.0, side)));
    }
}
