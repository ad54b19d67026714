//! Values of the scheme: the links' rates with arcs in their sense, given lengths beside the links.
//!
//! Both rates of a link stand at one place of it: above is the arc of its angular velocity, below that of its angular
//! acceleration, which has a second line. No arc is without its name.

use super::on_paper::{LinkShape, SchemeOnPaper};
use crate::drawing::canvas::Canvas;
use crate::drawing::context::{Value, ValueOf};
use crate::drawing::labels::LabelRequest;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::text::RichText;
use crate::drawing::values::{is_at_drive, label};
use crate::mechanism::BodyId;
use crate::quantity::QuantityKind;
use crate::scene::{Head, QuantityName};
use crate::sheet::{Order, Sheet};
use kurbo::{Point, Rect, Vec2};
use std::f64::consts::FRAC_PI_2;

/// Radius of the arcs, in mm.
const RADIUS: f64 = 5.0;
/// Angle of an arc.
const SWEEP: f64 = 2.5;
/// Distance of the second line of an angular acceleration, over the length of an arrowhead.
const SECOND: f64 = 0.45;
/// White between arcs and joints or other arcs, in mm.
const APART: f64 = 1.0;
/// Distance of a value from its place on the link where there is no arc, in mm.
const ALONE: f64 = 2.0;

impl SchemeOnPaper<'_> {
    /// Draws the arcs of rates and requests the labels of all values.
    pub(super) fn values(&self, canvas: &mut Canvas<'_>) {
        let mut places: Vec<(BodyId, Point, bool)> = Vec::new();
        for value in self.context.values_of(Sheet::Scheme) {
            match value.of {
                ValueOf::Rate(link) if !is_at_drive(self.context, value, link) => {
                    let known = places.iter().find(|(own, ..)| *own == link).copied();
                    let place = known.or_else(|| {
                        let (center, has_room) = self.place_of_arcs(canvas, link, &places)?;
                        places.push((link, center, has_room));
                        Some((link, center, has_room))
                    });
                    if let Some((_, center, has_room)) = place {
                        self.rate(canvas, value, link, center, has_room);
                    }
                }
                ValueOf::Length(ends) => {
                    // Beside the line, away from the middle of the mechanism.
                    let [a, b] = ends.map(|point| self.at(point));
                    let anchor = a.lerp(b, 0.66);
                    label(self.context, canvas, value, anchor, Some(self.outer_side([a, b], anchor)));
                }
                _ => {}
            }
        }
        canvas.step = 0;
    }

    /// Draws the arc of a rate and requests its label.
    fn rate(&self, canvas: &mut Canvas<'_>, value: &Value, link: BodyId, center: Point, has_room: bool) {
        let order = match value.kind {
            QuantityKind::AngularAcceleration => Order::Acceleration,
            _ => Order::Velocity,
        };
        let mut names = Vec::new();
        if has_room && value.number != 0.0 {
            canvas.step = value.since;
            for (index, shape) in self.arc(center, order, value.number).into_iter().enumerate() {
                let what = ["omega", "alpha"][order];
                let second = if index > 0 { "-second" } else { "" };
                let name = format!("{what}-{}{second}", self.mechanism.body(link).name);
                canvas.draw_named(&name, Pen::Turning, shape).number = self.context.number(link);
                names.push(name);
            }
        }
        let away = if names.is_empty() { ALONE } else { self.reach(order) };
        let wanted = label(self.context, canvas, value, center + side(order) * away, Some(side(order)));
        wanted.short = (!names.is_empty()).then(|| RichText::math(&value.symbol));
        wanted.with = names;
    }

    /// Draws the senses of the angular rates that a step yields, where they have room, unless they are there with their
    /// values.
    pub(super) fn solved_rates(&self, canvas: &mut Canvas<'_>, step: u16, unknowns: &[(String, f64)]) {
        let mut places = Vec::new();
        for (name, value) in unknowns.iter().filter(|(_, value)| *value != 0.0 && self.context.values.is_empty()) {
            let parsed = QuantityName::parse(name);
            let order = match parsed.as_ref().map(|name| name.head) {
                Some(Head::Omega) => Order::Velocity,
                Some(Head::Alpha) => Order::Acceleration,
                _ => continue,
            };
            let argument = parsed.as_ref().and_then(|name| name.arguments.first());
            let Some(link) = argument.and_then(|name| self.mechanism.link(name)) else { continue };
            let Some((center, true)) = self.place_of_arcs(canvas, link, &places) else { continue };
            places.push((link, center, true));
            let number = self.context.number(link);
            for shape in self.arc(center, order, *value) {
                canvas.draw_in_step(step, Pen::Turning, shape).number = number;
            }
            let link = self.mechanism.body(link).name.as_str();
            let symbol = RichText::math(&format!("{}_{{{}}}", order.rate(), canvas.shown(link, link)));
            let anchor = center + side(order) * self.reach(order);
            canvas.step = step;
            let wanted =
                canvas.ask(&format!("solved-{name}"), LabelRequest::new(symbol, anchor, 0.9, Some(side(order)), 0));
            (wanted.number, wanted.optional, wanted.last, wanted.passing) = (number, true, true, true);
            canvas.step = 0;
        }
    }

    /// The place of a link around which its arcs stand, and whether they have room there, between the joints and off
    /// other arcs; none for a link without points.
    fn place_of_arcs(
        &self,
        canvas: &Canvas<'_>,
        link: BodyId,
        taken: &[(BodyId, Point, bool)],
    ) -> Option<(Point, bool)> {
        let longest = |bars: &[[Point; 2]]| {
            let length = |[a, b]: &[Point; 2]| (*b - *a).hypot();
            bars.iter().copied().max_by(|one, other| length(one).total_cmp(&length(other)))
        };
        let tried: Vec<Point> = match self.shape(link) {
            // Off the link's name, which is in the middle, or around it.
            LinkShape::Bars(bars) => {
                let [a, b] = longest(&bars)?;
                let is_long = (b - a).hypot() > 8.0 * RADIUS;
                let shares = if is_long { [0.35, 0.65, 0.25, 0.75, 0.5] } else { [0.5, 0.35, 0.65, 0.25, 0.75] };
                shares.map(|share| a.lerp(b, share)).to_vec()
            }
            LinkShape::Plate(corners) => {
                let sum = corners.iter().fold(Vec2::ZERO, |sum, corner| sum + corner.to_vec2());
                let middle = (sum / corners.len() as f64).to_point();
                let inside = std::iter::once(middle).chain(corners.iter().map(|corner| middle.lerp(*corner, 0.4)));
                // Or on a side of a narrow one.
                let sides = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| a.midpoint(*b));
                inside.chain(sides).collect()
            }
            LinkShape::Nothing => vec![self.at(*self.mechanism.body(link).points.first()?)],
        };
        let reach = self.reach(Order::Acceleration);
        let joints: Vec<Point> = self.pose.points.iter().map(|&place| self.view.at(place)).collect();
        let has_room = |center: &&Point| {
            let area = Rect::from_center_size(**center, (2.0 * reach, 2.0 * reach));
            let mut others = taken.iter().filter(|(_, _, has_arcs)| *has_arcs);
            canvas.room().union(area) == canvas.room()
                && joints.iter().all(|joint| (*joint - **center).hypot() > reach + self.dims().joint + APART)
                && others.all(|(_, other, _)| (*other - **center).hypot() > 2.0 * reach + APART)
        };
        let found = tried.iter().find(has_room);
        Some((*found.or(tried.first())?, found.is_some()))
    }

    /// Distance of the outer line of an arc from its place, in mm.
    fn reach(&self, order: Order) -> f64 {
        match order {
            Order::Velocity => RADIUS,
            Order::Acceleration => RADIUS + SECOND * self.dims().head,
        }
    }

    /// The arc in the sense of a rate, with a second line for an angular acceleration.
    fn arc(&self, center: Point, order: Order, rate: f64) -> Vec<Shape> {
        let head = self.dims().head;
        // Counter-clockwise is negative in the angles of the sheet.
        let sweep = -rate.signum() * SWEEP;
        let start = FRAC_PI_2 * side(order).y - 0.5 * sweep;
        let arrow = Shape::ArcArrow { center, radius: RADIUS, start, sweep, head };
        // It ends where the head begins.
        let second =
            Shape::Arc { center, radius: self.reach(order), start, sweep: sweep - (head / RADIUS).copysign(sweep) };
        match order {
            Order::Velocity => vec![arrow],
            Order::Acceleration => vec![arrow, second],
        }
    }
}

/// The side of its place on which the arc of a rate stands.
fn side(order: Order) -> Vec2 {
    match order {
        Order::Velocity => Vec2::new(0.0, -1.0),
        Order::Acceleration => Vec2::new(0.0, 1.0),
    }
}
