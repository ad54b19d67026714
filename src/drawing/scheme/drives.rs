//! Arrows beside driven links and sliders, the senses of their drives.

use super::on_paper::SchemeOnPaper;
use crate::drawing::canvas::Canvas;
use crate::drawing::context::Purpose;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::values::drive_value;
use crate::drawing::view::on_sheet;
use crate::mechanism::{BodyId, GROUND, PointId, Role, SliderId};
use crate::sheet::Order;
use kurbo::{Point, Vec2};

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
                    let shown = |name: &str| self.context.shown(name, None);
                    let notation = &self.context.words.notation;
                    let label = self.mechanism.push_symbol(Order::Velocity, slider, notation, &shown);
                    self.slide_arrow(canvas, slider, drive.speed, ["speed", &label]);
                }
                None if self.context.purpose == Purpose::Exercise => {
                    self.slide_arrow(canvas, slider, 1.0, ["sense", "+"]);
                }
                _ => {}
            }
        }
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
}
