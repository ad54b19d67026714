//! A mechanism that is being put together, as far as its text tells it: with the strokes of the scheme, on a part of a screen.

use super::canvas::Canvas;
use super::clip::clipped_segment;
use super::dims::Dims;
use super::held_layout::Pane;
use super::scheme::on_paper::outline;
use super::scheme::sliders::{BLOCK, block_corners, ground_line, ground_piece, pivot, slot, slot_outline};
use super::scheme::springs::{SpringEnd, spring};
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::text::CAPTION;
use super::view::{Extent, View, on_sheet, towards};
use crate::construction::display;
use crate::editing::{Draft, DraftCircle, DraftGuide, DraftLink, DraftLoad, DraftSlider};
use crate::geometry;
use crate::scene::Figure;
use indexmap::IndexMap;
use kurbo::{Point, Rect, Vec2};
use std::f64::consts::{PI, TAU};

/// Length of a force's arrow; radius and angle of the arc of a couple, in mm and radians.
const FORCE: f64 = 12.0;
const COUPLE_RADIUS: f64 = 3.6;
const COUPLE_SWEEP: f64 = 3.6;

/// What of a [`Draft`] is drawn: the part of a screen, the place in its middle in the scene's units, and how many pixels one of them is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DraftView {
    /// The part of the screen.
    pub pane: Pane,
    /// The place of the mechanism in its middle.
    pub centre: [f64; 2],
    /// Pixels for a unit of length; positive.
    pub scale: f64,
}

/// Draws what is known of a mechanism: links between their known points, fixed points, guides and blocks, drives, names. Other than
/// [`figure`](crate::Solution::figure) this asks for no complete scene; a link of which one place is known is a stub or a block, one of
/// which none is known is not there.
///
/// ```
/// use kinegon::drawing::{DraftView, Pane, draft};
/// use kinegon::editing::Draft;
///
/// let text = r#"{ "ground": { "A": [0, 0] }, "links": { "1": ["A", "B"] }, "near": { "B": [40, 30] } }"#;
/// let pane = Pane { width: 800.0, height: 500.0, letters: 14.0, words: false };
/// let drawing = draft(&Draft::of(text)?, &DraftView { pane, centre: [20.0, 15.0], scale: 4.0 });
/// assert!(drawing.svg().contains("build-link-1"));
/// # Ok::<(), kinegon::scene::SceneError>(())
/// ```
#[must_use]
pub fn draft(draft: &Draft, view: &DraftView) -> Drawing {
    let dims = Dims::on_pane(view.pane, &Figure::default());
    let [width, height] = dims.page;
    let frame = Rect::new(0.0, 0.0, width, height);
    let centre = geometry::Point::from(view.centre);
    let mu = view.pane.letters / (CAPTION * view.scale);
    let mut drawing = Drawing::new(width, height);
    let names = IndexMap::new();
    let mut canvas = Canvas::new(&mut drawing, ["", "build"], frame, &names, dims);
    canvas.header = 0.0;
    let own = OnSheet { draft, view: View::new(mu, &Extent { low: centre, high: centre }, frame), frame };
    own.draw(&mut canvas);
    canvas.finish(None);
    drawing.panels.clear();
    drawing.enlarged(dims.unit)
}

/// A draft on its sheet.
struct OnSheet<'a> {
    draft: &'a Draft,
    view: View,
    frame: Rect,
}

impl OnSheet<'_> {
    fn draw(&self, canvas: &mut Canvas<'_>) {
        for link in &self.draft.links {
            if let corners @ [_, _, _, ..] = self.corners(link).as_slice() {
                canvas.draw(Pen::LinkFill, Shape::Polygon(corners.to_vec()));
            }
        }
        for slider in &self.draft.sliders {
            self.guide(canvas, slider);
        }
        for circle in &self.draft.circles {
            self.circle(canvas, circle);
        }
        for (name, point) in &self.draft.points {
            if point.is_fixed {
                self.support(canvas, name, self.view.at(point.at));
            }
        }
        for (index, own) in self.draft.springs.iter().enumerate() {
            let ends = own.ends.each_ref().map(|(on, place)| {
                let at = self.view.at(*place);
                let points = self.draft.places_on(on).map(|point| self.view.at(point));
                (at, SpringEnd::at(at, points, on == "ground"))
            });
            spring(canvas, &format!("spring-{}", index + 1), ends);
        }
        for link in &self.draft.links {
            self.link(canvas, link);
        }
        for (index, slider) in self.draft.sliders.iter().enumerate() {
            self.block(canvas, index, slider);
        }
        for link in &self.draft.links {
            self.turning(canvas, link);
        }
        self.joints(canvas);
        for (index, load) in self.draft.loads.iter().enumerate() {
            self.load(canvas, index, load);
        }
        for link in &self.draft.links {
            self.name(canvas, link);
        }
    }

    fn place(&self, point: &str) -> Option<Point> {
        self.draft.points.get(point).map(|point| self.view.at(point.at))
    }

    /// The corners of a link's area, the ends of a straight one, the one known place of others.
    fn corners(&self, link: &DraftLink) -> Vec<Point> {
        let places = outline(self.draft.places_on(&link.name).collect());
        places.into_iter().map(|place| self.view.at(place)).collect()
    }

    fn link(&self, canvas: &mut Canvas<'_>, link: &DraftLink) {
        let name = format!("link-{}", link.name);
        match self.corners(link).as_slice() {
            [] => {}
            &[at] => {
                let slides = self.draft.sliders.iter().any(|slider| slider.link.as_ref() == Some(&link.name));
                // The link is known to be there, but not where it goes.
                if !slides {
                    let corners = block_corners(at, Vec2::new(1.0, 0.0), BLOCK * 0.8);
                    canvas.draw_named(&name, Pen::Link, Shape::Polygon(corners));
                }
            }
            &[a, b] => {
                canvas.draw_named(&name, Pen::Link, Shape::Line(a, b));
            }
            corners => {
                canvas.draw_named(&name, Pen::Link, Shape::Polygon(corners.to_vec()));
            }
        }
    }

    /// The block's place on the sheet and the direction of its guide; where the two do not go together yet, the block stays at its point.
    fn on_guide(&self, slider: &DraftSlider) -> Option<(Point, Vec2, DraftGuide)> {
        let guide = slider.guide?;
        Some((self.place(&slider.at)?, on_sheet(guide.along), guide))
    }

    fn guide(&self, canvas: &mut Canvas<'_>, slider: &DraftSlider) {
        let Some((block, along, guide)) = self.on_guide(slider) else { return };
        let through = self.view.at(guide.through);
        let foot = through + along * (block - through).dot(along);
        let bounds = self.frame.inflate(BLOCK.x, BLOCK.x);
        let reach = clipped_segment(bounds, foot - along * (3.0 * BLOCK.x), foot + along * (3.0 * BLOCK.x));
        let Some((a, b)) = reach else { return };
        if (foot - block).hypot() > 1.0 {
            // What is not on its guide yet is tied to it.
            canvas.draw(Pen::Construction, Shape::Line(block, foot));
        }
        if slider.on == "ground" {
            let across = Vec2::new(-along.y, along.x);
            let arms = self.draft.links.iter().filter(|link| slider.link.as_ref() != Some(&link.name));
            let arms = arms.filter(|link| link.points.contains(&slider.at)).flat_map(|link| self.corners(link));
            let lean: f64 = arms.map(|end| towards(block, end, Vec2::ZERO).dot(across)).sum();
            return ground_line(canvas, [a, b], if lean > 0.15 { -across } else { across }, BLOCK.y);
        }
        let points = self.draft.places_on(&slider.on).map(|place| self.view.at(place));
        let Some(slot) = slot(foot, along, [a, b], points) else { return };
        for [from, to] in slot.arms {
            canvas.draw(Pen::Link, Shape::Line(from, to));
        }
        canvas.draw(Pen::Guide, Shape::Polyline(slot_outline(slot.ends)));
    }

    fn block(&self, canvas: &mut Canvas<'_>, index: usize, slider: &DraftSlider) {
        let Some((at, along, _)) = self.on_guide(slider) else { return };
        let is_behind = self.draft.sliders[index + 1..].iter().any(|other| other.at == slider.at);
        let half = match &slider.link {
            None => Vec2::new(2.2 * BLOCK.x, canvas.dims.joint + 0.2),
            Some(_) => BLOCK * if is_behind { 1.5 } else { 1.0 },
        };
        let name = format!("slider-{index}");
        canvas.draw_named(&name, Pen::Slider, Shape::Polygon(block_corners(at, along, half)));
        if let Some(speed) = slider.drive {
            let side = Vec2::new(along.y, -along.x) * (half.y + 2.0);
            let arm = along * (5.0 * speed.signum());
            canvas.draw_named(&format!("drive-{index}"), Pen::Turning, canvas.arrow(at + side - arm, at + side + arm));
        }
    }

    /// The foot of a fixed point: below it, but above where links hang down and none stands up.
    fn support(&self, canvas: &mut Canvas<'_>, name: &str, at: Point) {
        let links = self.draft.links.iter().filter(|link| link.points.iter().any(|point| point == name));
        let mut ends = links.flat_map(|link| self.corners(link)).filter(|end| (*end - at).hypot() > 0.0).peekable();
        if ends.peek().is_none() {
            return ground_piece(canvas, at);
        }
        let falls: Vec<f64> = ends.map(|end| towards(at, end, Vec2::ZERO).y).collect();
        let steep = libm::cos(50.0_f64.to_radians());
        let hangs = falls.iter().any(|&y| y > steep) && !falls.iter().any(|&y| y < -steep);
        pivot(canvas, at, Vec2::new(0.0, if hangs { -1.0 } else { 1.0 }));
    }

    /// The sense of a drive that turns a link, about its fixed point.
    fn turning(&self, canvas: &mut Canvas<'_>, link: &DraftLink) {
        let Some(speed) = link.turning else { return };
        let mut known = link
            .points
            .iter()
            .filter_map(|name| self.draft.points.get(name).map(|point| (point, self.view.at(point.at))));
        let ends: Vec<(bool, Point)> = known.by_ref().map(|(point, at)| (point.is_fixed, at)).collect();
        let Some(&(_, center)) = ends.iter().find(|(is_fixed, _)| *is_fixed).or(ends.first()) else { return };
        let arm = ends.iter().map(|(_, at)| *at - center).find(|arm| arm.hypot() > 0.0).unwrap_or(Vec2::new(1.0, 0.0));
        // Counter-clockwise is negative in the angles of the sheet.
        let sense = if speed < 0.0 { 1.0 } else { -1.0 };
        let (start, sweep) = (libm::atan2(arm.y, arm.x) + sense * 0.35, sense * 1.5);
        let shape = Shape::ArcArrow { center, radius: 7.5, start, sweep, head: canvas.dims.head };
        canvas.draw_named(&format!("omega-{}", link.name), Pen::Turning, shape);
    }

    /// A pitch circle or a round profile, as two half circles: unlike a full one they leave the inside free for labels.
    fn circle(&self, canvas: &mut Canvas<'_>, circle: &DraftCircle) {
        let center = self.view.at(circle.at);
        let radius = circle.radius / self.view.mu();
        for start in [0.0, PI] {
            canvas.draw(Pen::Guide, Shape::Arc { center, radius, start, sweep: PI });
        }
    }

    /// A force as an arrow from where it acts, a couple as an arc with a head: loads have no scale.
    fn load(&self, canvas: &mut Canvas<'_>, index: usize, load: &DraftLoad) {
        let at = self.view.at(load.at);
        let name = format!("load-{}", index + 1);
        if load.couple != 0.0 {
            let sense = -load.couple.signum();
            let start = PI + 0.5 * (TAU - COUPLE_SWEEP) * sense;
            let (radius, head) = (COUPLE_RADIUS, canvas.dims.head);
            let arc = Shape::ArcArrow { center: at, radius, start, sweep: sense * COUPLE_SWEEP, head };
            canvas.draw_named(&name, Pen::Acceleration, arc);
        }
        let along = (load.force.norm() > 0.0).then(|| on_sheet(load.force).normalize());
        if let Some(along) = along {
            let arrow = canvas.arrow(at, at + along * FORCE);
            canvas.draw_named(&name, Pen::Acceleration, arrow);
        }
        let (end, prefer) = match along {
            Some(along) => (at + along * FORCE, along),
            None => (at + Vec2::new(0.6, -0.8) * COUPLE_RADIUS, Vec2::new(0.6, -0.8)),
        };
        canvas.label(&format!("load {}", index + 1), &load.name, end, 1.0, Some(prefer), 2);
    }

    fn joints(&self, canvas: &mut Canvas<'_>) {
        let (joint, dot) = (canvas.dims.joint, canvas.dims.dot);
        for (name, point) in &self.draft.points {
            let center = self.view.at(point.at);
            let of_links = self.draft.links.iter().filter(|link| link.points.contains(name)).count();
            let slides = self.draft.sliders.iter().any(|slider| slider.at == *name);
            let in_slots =
                self.draft.sliders.iter().filter(|slider| slider.at == *name && slider.link.is_none()).count();
            // A pin joins two bodies, or rides in a slot.
            let (pen, radius) = match of_links + usize::from(point.is_fixed) + in_slots {
                0 | 1 => (Pen::ImagePoint, dot * (0.5 / 0.45)),
                _ => (Pen::Joint, joint),
            };
            canvas.draw_named(&format!("point-{name}"), pen, Shape::Circle { center, radius });
            let clearance = if slides { BLOCK.y + 0.8 } else { joint + 0.9 };
            canvas.label(name, &display(name), center, clearance, None, 2);
        }
    }

    /// A link's name: in its area, beside its middle, beside its block.
    fn name(&self, canvas: &mut Canvas<'_>, link: &DraftLink) {
        let (anchor, clearance, prefer) = match self.corners(link).as_slice() {
            [] => return,
            &[at] => (at, BLOCK.y + 1.3, None),
            &[a, b] => {
                let along = towards(a, b, Vec2::new(1.0, 0.0));
                let above = if along.x > 0.0 { Vec2::new(along.y, -along.x) } else { Vec2::new(-along.y, along.x) };
                (a.midpoint(b), 1.6, Some(above))
            }
            corners => {
                let sum = corners.iter().fold(Vec2::ZERO, |sum, corner| sum + corner.to_vec2());
                ((sum / corners.len() as f64).to_point(), 0.0, None)
            }
        };
        canvas.label(&format!("link {}", link.name), &link.name, anchor, clearance, prefer, 1);
    }
}
