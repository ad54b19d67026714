//! Special points and the cut lines that cross there.

use super::super::canvas::Canvas;
use super::super::clip::clipped_segment;
use super::super::shape::Shape;
use super::super::sheet::Pen;
use super::super::view::{View, on_sheet, towards};
use super::Scheme;
use crate::construction::Special;
use crate::geometry::{Place, Point as Point2, span};
use crate::scene::ConstructionShown;
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Vec2};

/// Largest size of the scheme with a special point over that without it; more distant points are not drawn at their
/// places: they would make the mechanism small.
const REACH: f64 = 1.4;
/// The same on sheets where the student finds the point, and in figures as in the source paper.
const REACH_OF_PENCIL: f64 = 2.5;

/// Room for the arrow towards a distant one, in parts of the mechanism's size.
const ARROW: f64 = 0.12;

/// Number style of the distances of these.
const DISTANCE: NumberStyle = NumberStyle::significant(4).in_full(-3, 6).on(Medium::Figure);

impl Scheme<'_> {
    pub(in crate::drawing) fn special(&self) -> impl Iterator<Item = &Special> {
        let shown = self.figure.special_points;
        self.construction.special.iter().flatten().filter(move |s| shown && s.is_assur)
    }

    /// Whether a special point is near enough to be drawn at its place.
    pub(in super::super) fn is_near(&self, special: &Special) -> bool {
        let size = span(self.pose.points.iter().copied());
        let reach = if self.has_far_points() { REACH_OF_PENCIL } else { REACH };
        special.place.finite().is_some_and(|place| {
            let points = self.pose.points.iter().copied();
            span(points.chain([place])) <= reach * size
        })
    }

    /// Whether special points far from the mechanism are at their places.
    fn has_far_points(&self) -> bool {
        self.is_for_pencil || self.figure.construction == ConstructionShown::Paper
    }

    /// A place that the extent of the scheme reaches for a special point: its own or, of a distant one, the end of its
    /// arrow.
    pub(super) fn reached(&self, special: &Special) -> Option<Point2> {
        let place = special.place.finite()?;
        if self.is_near(special) {
            return Some(place);
        }
        let start = special.cuts.iter().find_map(|cut| cut.start()).filter(|_| !self.has_far_points())?;
        let start = self.pose.point(start);
        let size = span(self.pose.points.iter().copied());
        Some(start + (place - start).normalize() * (ARROW * size))
    }

    /// The cut lines of a special point, from their joints to it.
    pub(super) fn cuts(&self, canvas: &mut Canvas<'_>, view: &View, special: &Special) {
        if !self.figure.construction.has_lines() {
            return;
        }
        let bounds = canvas.room();
        for cut in &special.cuts {
            let (Some(start), Some(direction)) = (cut.start(), cut.line.direction()) else {
                continue;
            };
            let from = self.at(view, start);
            // For a distant special point the cut line runs towards it to the panel's edge.
            let to = match special.place {
                Place::At(place) => view.at(place),
                Place::AtInfinity(_) => from + on_sheet(direction) * (bounds.width() + bounds.height()),
            };
            let name = format!("cut-{}-{}", special.name, self.mechanism.point_name(start));
            // A special point may coincide with the joint.
            let way = towards(from, to, on_sheet(direction));
            let end = if self.is_near(special) { to + way * 3.0 } else { to };
            if let Some((a, b)) = clipped_segment(bounds, from, end) {
                canvas.draw_named(&name, Pen::Construction, Shape::Line(a, b));
            }
            if let Some(slider) = cut.guide() {
                let along = on_sheet(self.pose.guide(slider));
                self.right_angle(canvas, from, along, way);
            }
        }
    }

    /// Draws the sign of a right angle at `corner`.
    fn right_angle(&self, canvas: &mut Canvas<'_>, corner: Point, a: Vec2, b: Vec2) {
        const SIDE: f64 = 2.4;
        let chain = vec![corner + a * SIDE, corner + (a + b) * SIDE, corner + b * SIDE];
        canvas.draw(Pen::Frame, Shape::Polyline(chain));
    }

    /// Draws a special point at its place, or a distant one as an arrow with its distance.
    pub(super) fn mark_special(&self, canvas: &mut Canvas<'_>, view: &View, special: &Special) {
        let label = self.names.markup(&special.name);
        if self.is_near(special) {
            let Some(place) = special.place.finite() else {
                return;
            };
            let center = view.at(place);
            let name = format!("point-{}", special.name);
            let shape = Shape::Circle { center, radius: self.dims.joint };
            canvas.draw_named(&name, Pen::Special, shape);
            canvas.label(&special.name, &label, center, self.dims.joint + 0.7, None, 3);
            return;
        }
        // The arrow is on the first cut line with a direction.
        let bounds = canvas.room().inset(-2.0);
        let start = special.cuts.iter().find_map(|c| Some((c.start()?, c.line.direction()?)));
        let Some((start, direction)) = start else {
            return;
        };
        let from = self.at(view, start);
        let towards = match special.place {
            Place::At(place) => view.at(place) - from,
            Place::AtInfinity(_) => on_sheet(direction),
        };
        let far = from + towards.normalize() * (bounds.width() + bounds.height());
        let Some((_, edge)) = clipped_segment(bounds, from, far) else {
            return;
        };
        let tail = edge - towards.normalize() * 9.0;
        let distance = match special.place {
            Place::At(place) => {
                let distance = (place - self.pose.point(start)).norm();
                let name = self.mechanism.point_name(start);
                let distance = self.words.write(distance, DISTANCE);
                self.words.language.far_away(&label, &distance, name)
            }
            Place::AtInfinity(_) => self.words.language.at_infinity(&label),
        };
        let name = format!("point-{}", special.name);
        canvas.draw_named(&name, Pen::Special, canvas.arrow(tail, edge));
        canvas.words(&special.name, &distance, tail);
    }
}
