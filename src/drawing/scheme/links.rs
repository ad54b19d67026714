//! Links as lines and areas, and pieces of the neighbouring mechanism.

use super::super::canvas::Canvas;
use super::super::shape::Shape;
use super::super::sheet::Pen;
use super::super::view::{View, on_sheet};
use super::Scheme;
use super::looked_up::LinkLines;
use crate::geometry::{self, cross, span};
use crate::mechanism::{BodyId, Mark, Mechanism, PointId, SliderId};
use crate::position::Pose;
use kurbo::{Line, ParamCurveNearest, Point, Rect, Vec2};

/// A point closer than this to a line, in mm, counts as on the line.
pub(super) const ON_LINE: f64 = 0.3;

/// A mechanism in one position.
pub(super) struct Posed<'a> {
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
}

/// Shape of a link.
pub(super) enum LinkShape {
    /// None besides its block or its guide.
    Nothing,
    /// Straight bars: one between two points, or a slot and the arms that hold it.
    Bars(Vec<[Point; 2]>),
    /// An area with these corners.
    Plate(Vec<Point>),
}

impl LinkShape {
    /// Its straight lines.
    pub(super) fn lines(&self) -> Vec<[Point; 2]> {
        match self {
            LinkShape::Nothing => Vec::new(),
            LinkShape::Bars(bars) => bars.clone(),
            LinkShape::Plate(corners) => {
                let next = corners.iter().cycle().skip(1);
                corners.iter().zip(next).map(|(&a, &b)| [a, b]).collect()
            }
        }
    }
}

impl Posed<'_> {
    /// The shape of a link.
    pub(super) fn shape(&self, view: &View, link: BodyId) -> LinkShape {
        let points = &self.mechanism.body(link).points;
        let outline = outline(points.iter().map(|&p| self.pose.point(p)).collect());
        if let [_, _, _, ..] = outline.as_slice()
            && let Some(bars) = self.yoke(view, link)
        {
            return LinkShape::Bars(bars);
        }
        let corners: Vec<Point> = outline.iter().map(|&p| view.at(p)).collect();
        match corners.as_slice() {
            [] | [_] => LinkShape::Nothing,
            &[a, b] => LinkShape::Bars(vec![[a, b]]),
            _ => LinkShape::Plate(corners),
        }
    }

    /// The bars of a yoke, a link with a slot between two points that are only the slot's ends: the slot, and from each
    /// other point an arm normal to it.
    fn yoke(&self, view: &View, link: BodyId) -> Option<Vec<[Point; 2]>> {
        let ids = (0..self.mechanism.sliders.len()).map(SliderId);
        let mut slots = ids.filter(|&id| self.mechanism.slider(id).on == link);
        let slot = slots.next().filter(|_| slots.next().is_none())?;
        let at = self.at(view, self.mechanism.slider(slot).at);
        let along = on_sheet(self.pose.guide(slot));
        let points = &self.mechanism.body(link).points;
        let (ends, others): (Vec<PointId>, Vec<PointId>) =
            points.iter().partition(|&&point| (self.at(view, point) - at).cross(along).abs() <= ON_LINE);
        let slides = |point| self.mechanism.sliders.iter().any(|s| s.at == point);
        let held = |&point: &PointId| self.is_pin(point) || slides(point);
        let &[a, b] = ends.as_slice() else {
            return None;
        };
        if ends.iter().any(held) {
            return None;
        }
        let [a, b] = [a, b].map(|end| self.at(view, end));
        if (b - a).hypot() <= ON_LINE {
            return None;
        }
        let mut bars = vec![[a, b]];
        for point in others {
            let from = self.at(view, point);
            let share = (from - a).dot(b - a) / (b - a).hypot2();
            bars.push([from, a.lerp(b, share.clamp(0.0, 1.0))]);
        }
        Some(bars)
    }

    /// Whether a point is a pin.
    pub(super) fn is_pin(&self, point: PointId) -> bool {
        let marks = self.mechanism.joints.iter().flat_map(|joint| &joint.marks);
        marks.into_iter().any(|mark| matches!(mark, Mark::Circle { center, .. } if *center == point))
    }

    fn at(&self, view: &View, point: PointId) -> Point {
        view.at(self.pose.point(point))
    }
}

impl Scheme<'_> {
    /// The shape of a link.
    pub(super) fn shape(&self, view: &View, link: BodyId) -> LinkShape {
        self.posed(self.pose).shape(view, link)
    }

    pub(super) fn link_areas(&self, canvas: &mut Canvas<'_>, view: &View) {
        for (id, _) in self.mechanism.links() {
            if let LinkShape::Plate(corners) = self.shape(view, id) {
                let area = Shape::Polygon(corners);
                canvas.draw(Pen::LinkFill, area).number = self.number(id);
            }
        }
    }

    pub(super) fn link_lines(&self, canvas: &mut Canvas<'_>, view: &View) {
        for (id, body) in self.mechanism.links() {
            let lines = match self.shape(view, id) {
                LinkShape::Nothing => Vec::new(),
                LinkShape::Bars(bars) => bars.iter().map(|[a, b]| Shape::Line(*a, *b)).collect(),
                LinkShape::Plate(corners) => vec![Shape::Polygon(corners)],
            };
            let name = format!("link-{}", body.name);
            for (index, line) in lines.into_iter().enumerate() {
                let mark = match index {
                    0 => canvas.draw_named(&name, Pen::Link, line),
                    _ => canvas.draw(Pen::Link, line),
                };
                mark.number = self.number(id);
            }
        }
    }

    /// Draws a link of the neighbouring mechanism as a piece with a break line.
    pub(super) fn stub(&self, canvas: &mut Canvas<'_>, view: &View, link: BodyId) {
        let body = self.mechanism.body(link);
        let (point, name) = (body.points[0], body.name.as_str());
        const LENGTH: f64 = 11.0;
        let from = self.at(view, point);
        const HALF_WAVE: f64 = 2.6;
        /// Cosine of the smallest angle, 40°, between a piece and another line from its point.
        const CLEAR: f64 = 0.766;
        let outward = self.outward(view, from).unwrap_or(Vec2::new(-1.0, 0.0));
        // Outwards, or in the nearest direction that keeps the piece on the panel, off its heading, and clear of the
        // links and guides at its point.
        let turned = |degrees: f64| {
            let turn = geometry::direction_of_degrees(degrees);
            Vec2::new(turn.x * outward.x - turn.y * outward.y, turn.y * outward.x + turn.x * outward.y)
        };
        let turns = [0.0, 30.0, -30.0, 60.0, -60.0, 90.0, -90.0, 120.0, -120.0];
        let bounds = canvas.bounds();
        let fits = |away: &Vec2| {
            let tip = from + *away * (LENGTH + 1.2);
            let across = Vec2::new(-away.y, away.x) * HALF_WAVE;
            let outer = Rect::from_points(tip - across, tip + across).union_pt(from.lerp(tip, 0.5));
            bounds.contains(tip - across) && bounds.contains(tip + across) && !canvas.is_taken(outer)
        };
        let taken = self.directions(view, point);
        let clear = |away: &Vec2| taken.iter().all(|other| away.dot(*other) < CLEAR);
        let tries = turns.map(turned);
        let on_panel = || tries.iter().filter(|away| fits(away));
        let best = on_panel().find(|away| clear(away));
        let away = *best.or(on_panel().next()).unwrap_or(&outward);
        let across = Vec2::new(-away.y, away.x);
        let end = from + away * LENGTH;
        let piece = Shape::Line(from, end);
        let mark = canvas.draw_named(&format!("link-{name}"), Pen::Link, piece);
        mark.number = self.number(link);
        let wave = vec![
            end + across * HALF_WAVE,
            end + across * 0.7,
            end + across * 0.3 + away * 1.2,
            end - across * 0.3 - away * 1.2,
            end - across * 0.7,
            end - across * HALF_WAVE,
        ];
        canvas.draw(Pen::Guide, Shape::Polyline(wave));
        let anchor = from + away * (0.6 * LENGTH);
        let label = canvas.label(name, name, anchor, 1.2, Some(across), 1);
        label.number = self.number(link);
    }

    /// The unit vectors of links and guides at a point.
    pub(super) fn directions(&self, view: &View, point: PointId) -> Vec<Vec2> {
        let from = self.at(view, point);
        let mut kept = self.link_lines.borrow_mut();
        let lines = match kept.take().filter(|lines| lines.view == *view) {
            Some(lines) => lines,
            None => LinkLines::new(&self.posed(self.pose), view),
        };
        let here = kept.insert(lines).at(from).into_iter();
        let ends = here.flat_map(|ends| ends.map(|end| end - from));
        let mut directions: Vec<Vec2> = ends.filter(|end| end.hypot() > ON_LINE).map(Vec2::normalize).collect();
        for id in (0..self.mechanism.sliders.len()).map(SliderId) {
            if self.mechanism.slider(id).at == point {
                let along = on_sheet(self.pose.guide(id));
                directions.extend([along, -along]);
            }
        }
        directions
    }
}

/// Whether a point is on a line to the reader's eye.
pub(super) fn is_on([a, b]: [Point; 2], point: Point) -> bool {
    let nearest = Line::new(a, b).nearest(point, 0.1 * ON_LINE);
    nearest.distance_sq <= ON_LINE * ON_LINE
}

/// Corners of a link, or of its image, in order around it; two for a straight one.
pub(in crate::drawing) fn outline(mut places: Vec<geometry::Point>) -> Vec<geometry::Point> {
    if places.len() < 3 {
        return places;
    }
    // The convex hull by Andrew's monotone chain.
    places.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let size = span(places.iter().copied());
    let mut hull: Vec<geometry::Point> = Vec::new();
    for pass in 0..2 {
        let base = hull.len();
        for &p in &places {
            while hull.len() >= base + 2 {
                let (a, b) = (hull[hull.len() - 2], hull[hull.len() - 1]);
                // A corner flatter than a thousandth of the link counts as straight.
                if cross(b - a, p - b) > 1e-3 * size * (p - a).norm() {
                    break;
                }
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
        if pass == 0 {
            places.reverse();
        }
    }
    hull
}
