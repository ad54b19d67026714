use super::canvas::{Canvas, clipped_segment};
use super::sheet::{Pen, Shape};
use super::view::{Extent, View, on_sheet};
use crate::geometry::{self, Place, Vector, cross, span};
use crate::mechanism::{BodyId, GROUND, JointKind, Mechanism, PointId, Role, SliderId};
use crate::plan::{Construction, LegKind, Special, display};
use crate::position::Pose;
use crate::scene::{Figure, Scene};
use kurbo::{Point, Rect, Vec2};

/// Radius of a joint's circle in mm.
const JOINT: f64 = 1.15;
/// Half length and half width of a slider block in mm.
const BLOCK: Vec2 = Vec2::new(3.9, 2.2);
/// Height of a pivot's triangle, and half the length of the ground line under it, in mm.
const PIVOT: f64 = 4.4;
const PIVOT_HALF: f64 = 4.2;
/// How far the strokes under a ground line reach, in mm.
const HATCH: f64 = 1.7;
/// A special point that would make the scheme more than this many times larger is not drawn at its place.
const REACH: f64 = 2.5;

/// What the scheme shows.
pub(super) struct Scheme<'a> {
    pub figure: &'a Figure,
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub construction: &'a Construction,
}

impl<'a> Scheme<'a> {
    /// The scheme of a scene after its construction.
    pub(super) fn new(
        scene: &'a Scene,
        mechanism: &'a Mechanism,
        pose: &'a Pose,
        construction: &'a Construction,
    ) -> Self {
        Self {
            figure: &scene.figure,
            mechanism,
            pose,
            construction,
        }
    }

    /// What must find room: all points, and the special points that are not too far away.
    pub(super) fn extent(&self) -> Extent {
        let points = self.pose.points.iter().copied();
        let near = self.special().filter(|s| self.is_near(s));
        let special = near.filter_map(|s| s.place.finite());
        Extent::of(points.chain(special).chain(self.guide_ends()))
    }

    /// Places that keep room for guides on the ground.
    fn guide_ends(&self) -> impl Iterator<Item = geometry::Point> {
        const SHARE: f64 = 0.06;
        let reach = SHARE * span(self.pose.points.iter().copied());
        let sliders = (0..self.mechanism.sliders.len()).map(SliderId);
        sliders
            .filter(|&id| self.mechanism.slider(id).on == GROUND)
            .flat_map(move |id| {
                let at = self.pose.point(self.mechanism.slider(id).at);
                let arm = self.pose.guide(id) * reach;
                [at - arm, at + arm]
            })
    }

    fn special(&self) -> impl Iterator<Item = &Special> {
        let shown = self.figure.special_points;
        self.construction
            .special
            .iter()
            .flatten()
            .filter(move |s| shown && s.is_assur)
    }

    /// Whether a special point can be drawn at its place without making the rest small.
    fn is_near(&self, special: &Special) -> bool {
        let own = span(self.pose.points.iter().copied());
        special.place.finite().is_some_and(|place| {
            let points = self.pose.points.iter().copied();
            span(points.chain([place])) <= REACH * own
        })
    }

    /// Draws the mechanism.
    pub(super) fn draw(&self, canvas: &mut Canvas<'_>, view: &View) {
        self.link_areas(canvas, view);
        for special in self.special() {
            self.cuts(canvas, view, special);
        }
        for slider in (0..self.mechanism.sliders.len()).map(SliderId) {
            self.guide(canvas, view, slider);
        }
        self.link_lines(canvas, view);
        for (body, role) in self.mechanism.bodies.iter().map(|b| (b, &b.role)) {
            match role {
                Role::Stub => self.stub(canvas, view, body.points[0], &body.name),
                Role::Driver { pivot, omega, .. } => {
                    self.turning(canvas, view, *pivot, &body.points, &body.name, *omega);
                }
                _ => {}
            }
        }
        for &point in &self.mechanism.body(GROUND).points {
            self.pivot(canvas, view.at(self.pose.point(point)));
        }
        for slider in (0..self.mechanism.sliders.len()).map(SliderId) {
            self.block(canvas, view, slider);
        }
        self.joints(canvas, view);
        for special in self.special() {
            self.mark_special(canvas, view, special);
        }
        self.link_names(canvas, view);
    }

    fn at(&self, view: &View, point: PointId) -> Point {
        view.at(self.pose.point(point))
    }

    /// Corners of a link in order around it; two for a straight one.
    fn outline(&self, points: &[PointId]) -> Vec<geometry::Point> {
        let mut places: Vec<geometry::Point> = points.iter().map(|&p| self.pose.point(p)).collect();
        if places.len() < 3 {
            return places;
        }
        // The convex hull, by Andrew's monotone chain.
        places.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        let size = span(places.iter().copied());
        let mut hull: Vec<geometry::Point> = Vec::new();
        for pass in 0..2 {
            let base = hull.len();
            for &p in &places {
                while hull.len() >= base + 2 {
                    let (a, b) = (hull[hull.len() - 2], hull[hull.len() - 1]);
                    // Flatter than a thousandth of the link is drawn as straight.
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

    fn link_areas(&self, canvas: &mut Canvas<'_>, view: &View) {
        for (index, (_, body)) in self.mechanism.links().enumerate() {
            let outline = self.outline(&body.points);
            if outline.len() > 2 {
                let corners = outline.iter().map(|&p| view.at(p)).collect();
                canvas.draw(Pen::LinkFill(index as u8), Shape::Polygon(corners));
            }
        }
    }

    fn link_lines(&self, canvas: &mut Canvas<'_>, view: &View) {
        for (_, body) in self.mechanism.links() {
            let corners: Vec<Point> = self
                .outline(&body.points)
                .iter()
                .map(|&p| view.at(p))
                .collect();
            let name = format!("link-{}", body.name);
            match corners.as_slice() {
                [] | [_] => {}
                [a, b] => canvas.draw_named(&name, Pen::Link, Shape::Line(*a, *b)),
                _ => canvas.draw_named(&name, Pen::Link, Shape::Polygon(corners)),
            }
        }
    }

    /// The cut lines of a special point, from their joints to it.
    fn cuts(&self, canvas: &mut Canvas<'_>, view: &View, special: &Special) {
        if !self.figure.construction {
            return;
        }
        let bounds = canvas.room();
        for cut in &special.cuts {
            let (Some(start), Some(direction)) = (cut.start(), cut.line.direction()) else {
                continue;
            };
            let from = self.at(view, start);
            // A far special point: the cut line runs to the panel's edge, towards it.
            let to = match special.place {
                Place::At(place) => view.at(place),
                Place::AtInfinity(_) => {
                    from + on_sheet(direction) * (bounds.width() + bounds.height())
                }
            };
            let name = format!("cut-{}-{}", special.name, self.mechanism.point_name(start));
            let over = (to - from).normalize() * 3.0;
            let end = if self.is_near(special) { to + over } else { to };
            if let Some((a, b)) = clipped_segment(bounds, from, end) {
                canvas.draw_named(&name, Pen::Construction, Shape::Line(a, b));
            }
            if let LegKind::PinThenSlider { inner: slider, .. }
            | LegKind::SliderThenPin { outer: slider, .. } = cut.kind
            {
                let along = on_sheet(self.pose.guide(slider));
                self.right_angle(canvas, from, along, (to - from).normalize());
            }
        }
    }

    /// The mark of a right angle at `corner`.
    fn right_angle(&self, canvas: &mut Canvas<'_>, corner: Point, a: Vec2, b: Vec2) {
        const SIDE: f64 = 2.4;
        let chain = vec![
            corner + a * SIDE,
            corner + (a + b) * SIDE,
            corner + b * SIDE,
        ];
        canvas.draw(Pen::Frame, Shape::Polyline(chain));
    }

    /// A special point at its place; one far away by an arrow with its distance.
    fn mark_special(&self, canvas: &mut Canvas<'_>, view: &View, special: &Special) {
        let label = display(&special.name);
        if self.is_near(special) {
            let Some(place) = special.place.finite() else {
                return;
            };
            let center = view.at(place);
            let name = format!("point-{}", special.name);
            let shape = Shape::Circle {
                center,
                radius: JOINT,
            };
            canvas.draw_named(&name, Pen::Special, shape);
            canvas.label(&special.name, &label, center, JOINT + 0.7, None, 3);
            return;
        }
        // The arrow lies on the first cut line that reaches the panel's edge.
        let bounds = canvas.room().inset(-2.0);
        let start = special
            .cuts
            .iter()
            .find_map(|c| Some((c.start()?, c.line.direction()?)));
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
                format!("{label}: {} from {name}", significant(distance))
            }
            Place::AtInfinity(_) => format!("{label} at infinity"),
        };
        let name = format!("point-{}", special.name);
        canvas.draw_named(
            &name,
            Pen::Special,
            Shape::Arrow {
                from: tail,
                to: edge,
            },
        );
        canvas.words(&special.name, &distance, tail);
    }

    /// A guide that is no line between its body's points: a line about the block, joined to those
    /// points; so is one that runs on beyond them. It stays on the panel: an arm whose foot would lie far off goes to the guide's end.
    fn guide(&self, canvas: &mut Canvas<'_>, view: &View, id: SliderId) {
        const HALF: f64 = 3.0 * BLOCK.x;
        let slider = self.mechanism.slider(id);
        let (at, along) = (self.at(view, slider.at), on_sheet(self.pose.guide(id)));
        let across = Vec2::new(-along.y, along.x);
        // Room for the ground line and its hatching beside the block.
        let bounds = canvas.bounds().inset(-(BLOCK.y + HATCH));
        let Some((a, b)) = clipped_segment(bounds, at - along * HALF, at + along * HALF) else {
            return;
        };
        if slider.on == GROUND {
            let (a, b) = (a + across * BLOCK.y, b + across * BLOCK.y);
            canvas.draw(Pen::Ground, Shape::Line(a, b));
            hatch(canvas, a, b, across);
            for (from, to) in strokes(a, b, across) {
                canvas.keep_off(Rect::from_points(from, to));
            }
            return;
        }
        let (mut low, mut high) = ((a - at).dot(along), (b - at).dot(along));
        let points = &self.mechanism.body(slider.on).points;
        let offsets = points.iter().map(|&point| self.at(view, point) - at);
        let (on_line, off_line): (Vec<Vec2>, Vec<Vec2>) =
            offsets.partition(|offset| offset.dot(across).abs() <= 0.3);
        let places: Vec<f64> = on_line.iter().map(|offset| offset.dot(along)).collect();
        // Between points of its body the block is on the drawn link already.
        if places.len() >= 2 && places.iter().any(|&x| x < 0.0) && places.iter().any(|&x| x > 0.0) {
            return;
        }
        for place in places {
            (low, high) = (low.min(place), high.max(place));
        }
        for offset in off_line {
            let foot = at + along * offset.dot(along).clamp(low, high);
            canvas.draw(Pen::Link, Shape::Line(at + offset, foot));
        }
        let (a, b) = (at + along * low, at + along * high);
        canvas.draw(Pen::Guide, Shape::Line(a, b));
    }

    fn block(&self, canvas: &mut Canvas<'_>, view: &View, id: SliderId) {
        let slider = self.mechanism.slider(id);
        let (at, along) = (self.at(view, slider.at), on_sheet(self.pose.guide(id)));
        let across = Vec2::new(-along.y, along.x);
        let corner = |x: f64, y: f64| at + along * (x * BLOCK.x) + across * (y * BLOCK.y);
        let corners = vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ];
        let name = format!("slider-{}", self.mechanism.body(slider.link).name);
        canvas.draw_named(&name, Pen::Slider, Shape::Polygon(corners));
    }

    /// Circles at pins, dots at other points, and their names.
    fn joints(&self, canvas: &mut Canvas<'_>, view: &View) {
        let mut named: Vec<Point> = Vec::new();
        for point in (0..self.mechanism.points.len()).map(PointId) {
            let center = self.at(view, point);
            let is_pin = |j: &crate::mechanism::Joint| j.kind == JointKind::Revolute(point);
            let pin = self.mechanism.joints.iter().any(is_pin);
            let slides = self.mechanism.sliders.iter().any(|s| s.at == point);
            let name = self.mechanism.point_name(point);
            let id = format!("point-{name}");
            if pin {
                let radius = JOINT;
                canvas.draw_named(&id, Pen::Joint, Shape::Circle { center, radius });
            } else {
                let radius = 0.5;
                canvas.draw_named(&id, Pen::ImagePoint, Shape::Circle { center, radius });
            }
            let clearance = if slides { BLOCK.y + 0.8 } else { JOINT + 0.6 };
            // Two points in one place are told apart by their labels alone.
            let twin = named.iter().any(|p| (*p - center).hypot() < 0.3);
            let priority = if twin { 1 } else { 2 };
            named.push(center);
            canvas.label(
                name,
                &display(name),
                center,
                clearance,
                self.outward(view, center),
                priority,
            );
        }
    }

    /// The direction away from the middle of the mechanism.
    fn outward(&self, view: &View, from: Point) -> Option<Vec2> {
        let extent = Extent::of(self.pose.points.iter().copied());
        let away = from - view.at(nalgebra::center(&extent.low, &extent.high));
        (away.hypot() > 5.0).then(|| away.normalize())
    }

    /// A pivot on the ground.
    fn pivot(&self, canvas: &mut Canvas<'_>, apex: Point) {
        const HALF: f64 = 2.3;
        let base = apex.y + PIVOT;
        let triangle = vec![
            apex,
            Point::new(apex.x - HALF, base),
            Point::new(apex.x + HALF, base),
        ];
        canvas.draw(Pen::Slider, Shape::Polygon(triangle));
        let (a, b) = (
            Point::new(apex.x - PIVOT_HALF, base),
            Point::new(apex.x + PIVOT_HALF, base),
        );
        canvas.draw(Pen::Ground, Shape::Line(a, b));
        hatch(canvas, a, b, Vec2::new(0.0, 1.0));
        canvas.keep_off(pivot_box(apex));
    }

    /// A link of the neighbouring mechanism: a piece of it, broken off.
    fn stub(&self, canvas: &mut Canvas<'_>, view: &View, point: PointId, name: &str) {
        const LENGTH: f64 = 11.0;
        let from = self.at(view, point);
        const HALF_WAVE: f64 = 2.6;
        let outward = self.outward(view, from).unwrap_or(Vec2::new(-1.0, 0.0));
        // Outwards, or as little beside it as keeps the piece on the panel.
        let turned = |degrees: f64| {
            let turn = geometry::direction_of_degrees(degrees);
            Vec2::new(
                turn.x * outward.x - turn.y * outward.y,
                turn.y * outward.x + turn.x * outward.y,
            )
        };
        let turns = [0.0, 30.0, -30.0, 60.0, -60.0, 90.0, -90.0, 120.0, -120.0];
        let bounds = canvas.bounds();
        let fits = |away: &Vec2| {
            let tip = from + *away * (LENGTH + 1.2);
            let across = Vec2::new(-away.y, away.x) * HALF_WAVE;
            bounds.contains(tip - across) && bounds.contains(tip + across)
        };
        let mut tries = turns.into_iter().map(turned);
        let away = tries.find(fits).unwrap_or(outward);
        let across = Vec2::new(-away.y, away.x);
        let end = from + away * LENGTH;
        canvas.draw_named(&format!("link-{name}"), Pen::Link, Shape::Line(from, end));
        let wave = vec![
            end + across * HALF_WAVE,
            end + across * 0.7,
            end + across * 0.3 + away * 1.2,
            end - across * 0.3 - away * 1.2,
            end - across * 0.7,
            end - across * HALF_WAVE,
        ];
        canvas.draw(Pen::Guide, Shape::Polyline(wave));
        canvas.label(
            name,
            name,
            from + away * (0.6 * LENGTH),
            1.2,
            Some(across),
            1,
        );
    }

    /// The sense in which a driven link turns.
    fn turning(
        &self,
        canvas: &mut Canvas<'_>,
        view: &View,
        pivot: PointId,
        points: &[PointId],
        name: &str,
        omega: f64,
    ) {
        const RADIUS: f64 = 7.5;
        const SWEEP: f64 = 1.5;
        let Some(&tip) = points.iter().find(|&&p| p != pivot) else {
            return;
        };
        let center = self.at(view, pivot);
        let arm = self.at(view, tip) - center;
        if omega == 0.0 || arm.hypot() < 1.0 {
            return;
        }
        // Counter-clockwise is against the sheet's own sense of angles.
        let sense = -omega.signum();
        let arc = |radius: f64, lead: f64| Shape::ArcArrow {
            center,
            radius,
            start: libm::atan2(arm.y, arm.x) + sense * lead,
            sweep: sense * SWEEP,
        };
        // Off the panel's edge and, where that can be, off the pivot's hatching: ahead of the link,
        // behind it, or smaller.
        let (bounds, foot) = (canvas.bounds(), pivot_box(center));
        let behind = -0.35 - SWEEP;
        let tries = [
            (RADIUS, 0.35),
            (RADIUS, behind),
            (0.8 * RADIUS, 0.35),
            (0.8 * RADIUS, behind),
        ];
        let fits =
            |&&(radius, lead): &&(f64, f64)| arc(radius, lead).drawn_box().union(bounds) == bounds;
        let clear = |&&(radius, lead): &&(f64, f64)| {
            let both = arc(radius, lead).drawn_box().intersect(foot);
            both.area() <= 0.0
        };
        let best = tries.iter().filter(fits).find(clear);
        let &(radius, lead) = best.or(tries.iter().find(fits)).unwrap_or(&tries[2]);
        let start = libm::atan2(arm.y, arm.x) + sense * lead;
        let sweep = sense * SWEEP;
        let shape = arc(radius, lead);
        canvas.draw_named(&format!("omega-{name}"), Pen::Turning, shape);
        let middle = start + 0.6 * sweep;
        let direction = Vec2::new(libm::cos(middle), libm::sin(middle));
        let label = format!("ω_{{{}}}", canvas.shown(name, name));
        let anchor = center + direction * radius;
        canvas.label(
            &format!("omega({name})"),
            &label,
            anchor,
            0.8,
            Some(direction),
            2,
        );
    }

    /// The links' names: inside areas, beside lines where there is most room.
    fn link_names(&self, canvas: &mut Canvas<'_>, view: &View) {
        let joints: Vec<Point> = self.pose.points.iter().map(|&p| view.at(p)).collect();
        for (id, body) in self.mechanism.links() {
            if body.role == Role::Stub {
                continue;
            }
            let corners: Vec<Point> = self
                .outline(&body.points)
                .iter()
                .map(|&p| view.at(p))
                .collect();
            let (anchor, clearance, prefer) = match corners.as_slice() {
                [a, b] => {
                    let free = |share: f64| {
                        let p = a.lerp(*b, share);
                        let nearest = joints.iter().map(|j| (*j - p).hypot());
                        nearest.fold(f64::INFINITY, f64::min)
                    };
                    let shares = [0.5, 0.4, 0.6, 0.3, 0.7, 0.22, 0.78];
                    // The middle, unless a joint is close there.
                    let good = shares.into_iter().find(|&s| free(s) > 8.0);
                    let best = |x: &f64, y: &f64| free(*x).total_cmp(&free(*y));
                    let share = good.or_else(|| shares.into_iter().max_by(best));
                    (a.lerp(*b, share.unwrap_or(0.5)), 1.0, None)
                }
                [] | [_] => match self.own_place(view, id) {
                    Some((place, clearance)) => (place, clearance, None),
                    None => continue,
                },
                corners => {
                    let sum = corners.iter().fold(Vec2::ZERO, |s, p| s + p.to_vec2());
                    ((sum / corners.len() as f64).to_point(), 0.0, None)
                }
            };
            canvas.label(&body.name, &body.name, anchor, clearance, prefer, 1);
        }
        if let Some(&first) = self.mechanism.body(GROUND).points.first() {
            let name = self.mechanism.body(GROUND).name.as_str();
            let shown = canvas.shown(name, "");
            if !shown.is_empty() {
                let anchor = self.at(view, first) + Vec2::new(0.0, 6.0);
                canvas.label(name, &shown, anchor, 1.5, Some(Vec2::new(0.0, 1.0)), 1);
            }
        }
    }

    /// Where a link with fewer than two points is: its block or its guide.
    fn own_place(&self, view: &View, link: BodyId) -> Option<(Point, f64)> {
        let own = |s: &crate::mechanism::Slider| s.link == link || s.on == link;
        let index = self.mechanism.sliders.iter().position(own)?;
        let slider = &self.mechanism.sliders[index];
        let at = self.at(view, slider.at);
        if slider.link == link {
            return Some((at, 1.2 * BLOCK.x));
        }
        let along: Vector = self.pose.guide(SliderId(index));
        Some((at + on_sheet(along) * (2.4 * BLOCK.x), 1.0))
    }
}

/// The ground line under a pivot and its hatching.
fn pivot_box(apex: Point) -> Rect {
    let base = apex.y + PIVOT;
    Rect::new(apex.x - PIVOT_HALF, base, apex.x + PIVOT_HALF, base + HATCH)
}

/// Hatches a ground line on the side of `away`.
fn hatch(canvas: &mut Canvas<'_>, a: Point, b: Point, away: Vec2) {
    for (from, to) in strokes(a, b, away) {
        canvas.drawing.draw(Pen::Hatch, Shape::Line(from, to));
    }
}

/// Short strokes along a ground line, on the side of `away`.
fn strokes(a: Point, b: Point, away: Vec2) -> impl Iterator<Item = (Point, Point)> {
    const SPACING: f64 = 1.4;
    let run = b - a;
    let count = (run.hypot() / SPACING).round().max(1.0);
    let along = run / run.hypot();
    (0..count as usize).map(move |k| {
        let from = a + run * ((k as f64 + 0.75) / count);
        (from, from + away * HATCH - along * HATCH)
    })
}

/// A number with four significant digits, for captions.
pub(super) fn significant(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let exponent = libm::floor(libm::log10(x.abs())) as i32;
    if !(-3..6).contains(&exponent) {
        let mantissa = x / libm::pow(10.0, f64::from(exponent));
        return format!("{mantissa:.3}·10^{{{exponent}}}");
    }
    format!("{x:.*}", (3 - exponent).max(0) as usize)
}
