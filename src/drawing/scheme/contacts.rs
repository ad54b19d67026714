//! Profiles that touch: circles and flat faces, where they touch and the common normal there; and the pin in a guide that moves as a round profile on a
//! flat one does. The equivalent link is drawn with the links.

use super::on_paper::SchemeOnPaper;
use super::sliders::{BLOCK, block_corners, hatch};
use crate::construction::Solution;
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::clipped_segment;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::view::on_sheet;
use crate::geometry::{self, span, turn_of_degrees};
use crate::mechanism::{BodyId, Contact, GROUND, Mechanism, PointId, SliderId, Touch, Touching};
use crate::quantity::Snapshot;
use kurbo::{Point, Vec2};
use std::f64::consts::{PI, TAU};

/// How far to either side of the contact a profile is drawn of which only this place is known: in radians, and in parts of the mechanism's size. As
/// far again its circle of curvature goes on as a helping line.
const ARC: f64 = 0.6;
const LONG_ARC: f64 = 0.2;

/// How far a flat face goes on beyond what touches it, in parts of the radius, and in mm.
const BEYOND: f64 = 0.5;
const LEAST_FACE: f64 = 7.0;

/// Strokes of a fixed profile's hatching on either side of the contact, their length and the distance of two, in mm.
const STROKES: i32 = 6;
const HATCH: f64 = 1.6;
const APART: f64 = 1.4;

/// How far the normal goes on beyond the centres of curvature, in mm.
const NORMAL: f64 = 7.0;

/// The point of contact, in parts of an image's dot: it lies on lines.
const TOUCH: f64 = 1.7;

/// How far the guide of a pin that stands for a profile is drawn to either side of it, in mm.
const GUIDE: f64 = 11.0;

/// Chords of an area that stands for a disc.
const CHORDS: usize = 72;

/// A round profile, in the scene's unit of length.
struct Profile {
    body: BodyId,
    center: PointId,
    /// Negative of a hollow one.
    radius: f64,
    /// How far to either side of the contact it is drawn, in radians; `None` for all of a circle, as of a roller or a disc.
    half: Option<f64>,
}

/// The round profiles of a contact whose radii are known.
fn profiles(contact: &Contact, size: f64) -> Vec<Profile> {
    let half = |radius: f64, is_roller: bool| {
        let is_whole = is_roller || (contact.is_circular && radius > 0.0 && radius <= size);
        (!is_whole).then(|| ARC.min(LONG_ARC * size / radius.abs()))
    };
    let [first, second] = contact.bodies;
    match contact.touch {
        Touch::Arcs { centers, radii: Some(radii), .. } => {
            let roller = contact.has_roller;
            let one = |body, index: usize, is_roller: bool| {
                let radius = radii[index];
                Profile { body, center: centers[index], radius, half: half(radius, is_roller) }
            };
            vec![one(first, 0, false), one(second, 1, roller)]
        }
        Touch::Face { center, radius: Some(radius), .. } => {
            vec![Profile { body: first, center, radius, half: half(radius, false) }]
        }
        Touch::Arcs { .. } | Touch::Face { .. } => Vec::new(),
    }
}

/// What the extent of a scheme holds of contacts: circles, arcs, and where profiles touch.
pub(super) fn places(solution: &Solution) -> impl Iterator<Item = geometry::Point> {
    let (mechanism, pose) = (&solution.mechanism, &solution.pose);
    let size = span(pose.points.iter().copied());
    mechanism.contacts.iter().flat_map(move |contact| {
        let now = Snapshot { pose, motion: &solution.motion };
        let Some(touch) = contact.point(&now).map(|at| geometry::Point::new(at.x, at.y)) else { return Vec::new() };
        let ends = profiles(contact, size).into_iter().flat_map(|profile| {
            let center = pose.point(profile.center);
            match profile.half {
                None => [-1.0, 1.0].map(|sign| center + geometry::Vector::repeat(sign * profile.radius)),
                Some(half) => {
                    [-2.0, 2.0].map(|times| center + turn_of_degrees((times * half).to_degrees()) * (touch - center))
                }
            }
        });
        ends.chain([touch]).collect::<Vec<_>>()
    })
}

impl SchemeOnPaper<'_> {
    /// The light areas of discs and rollers.
    pub(super) fn discs(&self, canvas: &mut Canvas<'_>) {
        for contact in &self.mechanism.contacts {
            let discs = self.profiles(contact).into_iter().filter(|profile| profile.half.is_none());
            for Profile { body, center, radius, .. } in discs.filter(|profile| profile.body != GROUND) {
                let (center, radius) = (self.at(center), self.length(radius));
                let corner = |k: usize| {
                    let angle = TAU * k as f64 / CHORDS as f64;
                    center + Vec2::new(libm::cos(angle), libm::sin(angle)) * radius
                };
                let area = Shape::Polygon((0..CHORDS).map(corner).collect());
                canvas.draw(Pen::LinkFill, area).number = self.context.number(body);
            }
        }
    }

    /// The profiles, where they touch, and the normal there.
    pub(super) fn contacts(&self, canvas: &mut Canvas<'_>) {
        let mut drawn: Vec<(Point, f64)> = Vec::new();
        for contact in &self.mechanism.contacts {
            let now = self.now();
            let touch = contact.point(&now).map(|at| self.view.at(geometry::Point::new(at.x, at.y)));
            for profile in self.profiles(contact) {
                let at = (self.at(profile.center), self.length(profile.radius));
                // A disc that touches twice.
                let is_drawn = profile.half.is_none()
                    && drawn.iter().any(|own| (own.0 - at.0).hypot() + (own.1 - at.1).abs() < 0.05);
                if let (Some(touch), false) = (touch, is_drawn) {
                    self.profile(canvas, &profile, touch);
                }
                drawn.push(at);
            }
            let across = contact.normal(&now);
            let across = on_sheet(geometry::Vector::new(across.x, across.y));
            if let Touch::Face { slider, .. } = contact.touch {
                if let Some(touch) = touch {
                    self.face(canvas, contact, touch, across);
                }
                self.pin_on_face(canvas, slider);
            }
            self.normal(canvas, contact, touch, across);
        }
    }

    fn now(&self) -> impl Touching<f64> {
        Snapshot { pose: self.pose, motion: &self.context.solution.motion }
    }

    fn profiles(&self, contact: &Contact) -> Vec<Profile> {
        profiles(contact, span(self.pose.points.iter().copied()))
    }

    /// A length of the scene on the sheet, without its sign.
    fn length(&self, length: f64) -> f64 {
        let origin = geometry::Point::origin();
        (self.view.at(geometry::Point::new(length, 0.0)) - self.view.at(origin)).hypot()
    }

    /// A circle, or the arc about the contact with the rest of its circle of curvature as a helping line.
    fn profile(&self, canvas: &mut Canvas<'_>, profile: &Profile, touch: Point) {
        let (center, radius) = (self.at(profile.center), self.length(profile.radius));
        if radius <= self.dims().dot {
            return;
        }
        let pen = if profile.body == GROUND { Pen::Ground } else { Pen::Link };
        let number = self.context.number(profile.body);
        if profile.body == GROUND {
            self.hatching(canvas, (center, radius), touch, profile.radius < 0.0);
        }
        let Some(half) = profile.half else {
            // Two half circles: unlike a full circle they leave the inside free for a label.
            for start in [0.0, PI] {
                canvas.draw(pen, Shape::Arc { center, radius, start, sweep: PI }).number = number;
            }
            return;
        };
        let middle = (touch - center).atan2();
        canvas.draw(pen, Shape::Arc { center, radius, start: middle - half, sweep: 2.0 * half }).number = number;
        for side in [half, -half] {
            let rest = Shape::Arc { center, radius, start: middle + side, sweep: side };
            canvas.draw(Pen::Construction, rest);
        }
    }

    /// The hatching of a fixed profile beside where the other touches it: inside of a round one, outside of a hollow one.
    fn hatching(&self, canvas: &mut Canvas<'_>, (center, radius): (Point, f64), touch: Point, is_hollow: bool) {
        let middle = (touch - center).atan2();
        let step = (APART / radius).min(ARC / f64::from(STROKES));
        let inwards = if is_hollow { HATCH } else { -HATCH };
        for stroke in -STROKES..=STROKES {
            let at = |part: f64, radius: f64| {
                let angle = middle + (f64::from(stroke) + part) * step;
                center + Vec2::new(libm::cos(angle), libm::sin(angle)) * radius
            };
            canvas.draw(Pen::Hatch, Shape::Line(at(0.0, radius), at(0.7, radius + inwards)));
        }
    }

    /// The flat face: as far as its link goes along it, and beside what touches it; and the arm to it where its link has no point on it.
    fn face(&self, canvas: &mut Canvas<'_>, contact: &Contact, touch: Point, across: Vec2) {
        const ON_FACE: f64 = 0.3;
        let Touch::Face { radius: Some(radius), .. } = contact.touch else { return };
        let body = contact.bodies[1];
        let along = Vec2::new(-across.y, across.x);
        let reach = (BEYOND * self.length(radius)).max(LEAST_FACE);
        // A frame has points everywhere: its face is there where it is touched.
        let points = self.mechanism.body(body).points.iter().filter(|_| body != GROUND);
        let offsets: Vec<Vec2> = points.map(|&point| self.at(point) - touch).collect();
        let on_face = offsets.iter().filter(|offset| offset.dot(across).abs() <= ON_FACE);
        let (low, high) = on_face
            .clone()
            .map(|offset| offset.dot(along))
            .fold((-reach, reach), |(low, high), at| (low.min(at), high.max(at)));
        let pen = if body == GROUND { Pen::Ground } else { Pen::Link };
        let number = self.context.number(body);
        let ends = [touch + along * low, touch + along * high];
        canvas.draw(pen, Shape::Line(ends[0], ends[1])).number = number;
        if body == GROUND {
            hatch(canvas, ends[0], ends[1], across);
        }
        if let (None, Some(nearest)) =
            (on_face.clone().next(), offsets.iter().min_by(|a, b| a.dot(across).abs().total_cmp(&b.dot(across).abs())))
        {
            let foot = along * nearest.dot(along).clamp(low, high);
            canvas.draw(Pen::Link, Shape::Line(touch + *nearest, touch + foot)).number = number;
        }
    }

    /// The pin that moves as a round profile on a flat one, in its block and on its guide.
    fn pin_on_face(&self, canvas: &mut Canvas<'_>, slider: SliderId) {
        let at = self.at(self.mechanism.slider(slider).at);
        let along = on_sheet(self.pose.guide(slider));
        let ends = (at - along * GUIDE, at + along * GUIDE);
        if let Some((a, b)) = clipped_segment(canvas.room(), ends.0, ends.1) {
            canvas.draw(Pen::Equivalent, Shape::Line(a, b));
        }
        canvas.draw(Pen::Equivalent, Shape::Polygon(block_corners(at, along, BLOCK)));
    }

    /// The common normal beyond the centres of curvature, and the point of contact.
    fn normal(&self, canvas: &mut Canvas<'_>, contact: &Contact, touch: Option<Point>, across: Vec2) {
        let first = self.at(contact.first_center());
        let ends = match contact.touch {
            Touch::Arcs { centers: [_, second], .. } => [first, self.at(second)],
            Touch::Face { .. } => [first, touch.unwrap_or(first)],
        };
        let along = |point: &Point| (*point - first).dot(across);
        let places = || ends.iter().chain(&touch).map(along);
        let (low, high) = (places().fold(0.0, f64::min), places().fold(0.0, f64::max));
        let (from, to) = (first + across * (low - NORMAL), first + across * (high + NORMAL));
        if let Some((a, b)) = clipped_segment(canvas.room(), from, to) {
            canvas.draw(Pen::Construction, Shape::Line(a, b));
        }
        if let Some(center) = touch {
            canvas.draw(Pen::ImagePoint, Shape::Circle { center, radius: TOUCH * self.dims().dot });
        }
    }
}

/// Whether a slider is drawn as a slot or a guide of its own.
pub(super) fn has_guide(mechanism: &Mechanism, slider: SliderId) -> bool {
    !mechanism.slider(slider).is_contact
}
