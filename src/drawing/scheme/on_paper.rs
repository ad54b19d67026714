//! The scheme in a view: places of points, shapes of links, and the lines on which a point lies.

use crate::drawing::context::SheetContext;
use crate::drawing::dims::Dims;
use crate::drawing::grid::Grid;
use crate::drawing::shape::{Shape, around};
use crate::drawing::view::{View, on_sheet, towards};
use crate::geometry::{self, cross, hull, span};
use crate::mechanism::{BodyId, Mechanism, PointId};
use crate::position::Pose;
use kurbo::{Line, ParamCurveNearest, Point, Rect, Vec2};
use std::cell::OnceCell;

/// A point closer than this to a line, in mm, counts as on the line.
pub(super) const ON_LINE: f64 = 0.3;

/// The mechanism as it stands on a sheet.
pub(super) struct SchemeOnPaper<'a> {
    pub context: &'a SheetContext<'a>,
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub view: &'a View,
    /// The straight lines of all links, in the order of the links, and where they are; once they are asked for.
    link_lines: OnceCell<(Vec<[Point; 2]>, Grid)>,
}

/// The shape of a link.
pub(super) enum LinkShape {
    /// None besides its block or its guide.
    Nothing,
    /// Straight bars: one between two points, or a slot and the arms that hold it.
    Bars(Vec<[Point; 2]>),
    /// An area with these corners.
    Plate(Vec<Point>),
}

impl LinkShape {
    /// The straight lines of its bars or around its area.
    pub(super) fn lines(&self) -> Vec<[Point; 2]> {
        let lines = self.outlines().into_iter().flat_map(|outline| outline.lines());
        lines.map(|(a, b)| [a, b]).collect()
    }

    /// What is drawn of it as lines.
    pub(super) fn outlines(&self) -> Vec<Shape> {
        match self {
            LinkShape::Nothing => Vec::new(),
            LinkShape::Bars(bars) => bars.iter().map(|[a, b]| Shape::Line(*a, *b)).collect(),
            LinkShape::Plate(corners) => vec![Shape::Polygon(corners.clone())],
        }
    }
}

impl<'a> SchemeOnPaper<'a> {
    pub(super) fn new(context: &'a SheetContext<'a>, view: &'a View) -> Self {
        let (mechanism, pose) = (context.mechanism(), &context.solution.pose);
        Self { context, mechanism, pose, view, link_lines: OnceCell::new() }
    }

    /// The mechanism in another position.
    pub(super) fn in_pose(&self, pose: &'a Pose) -> Self {
        Self { pose, ..Self::new(self.context, self.view) }
    }

    pub(super) fn dims(&self) -> Dims {
        self.context.surface.dims
    }

    /// The place of a point on the sheet.
    pub(super) fn at(&self, point: PointId) -> Point {
        self.view.at(self.pose.point(point))
    }

    /// Whether a point is a pin.
    pub(super) fn is_pin(&self, point: PointId) -> bool {
        self.context.facts.pins[point.0]
    }

    /// Unit vector from the centre of the mechanism; none within 5 mm of it.
    pub(super) fn outward(&self, from: Point) -> Option<Vec2> {
        let away = from - self.view.at(self.context.facts.middle);
        (away.hypot() > 5.0).then(|| away.normalize())
    }

    /// The direction normal to a line, away from the centre of the mechanism at a place of the line.
    pub(super) fn outer_side(&self, [a, b]: [Point; 2], place: Point) -> Vec2 {
        let along = towards(a, b, Vec2::new(1.0, 0.0));
        let beside = Vec2::new(-along.y, along.x);
        let is_inner = self.outward(place).is_some_and(|outward| outward.dot(beside) < 0.0);
        if is_inner { -beside } else { beside }
    }

    /// The unit vectors of links and guides at a point.
    pub(super) fn directions(&self, point: PointId) -> Vec<Vec2> {
        let from = self.at(point);
        let (lines, grid) = self.link_lines.get_or_init(|| self.all_lines());
        let near = grid.near(Rect::from_center_size(from, (1.0, 1.0))).into_iter().map(|index| lines[index]);
        let ends = near.filter(|ends| is_on(*ends, from)).flat_map(|ends| ends.map(|end| end - from));
        let mut directions: Vec<Vec2> = ends.filter(|end| end.hypot() > ON_LINE).map(Vec2::normalize).collect();
        for id in self.mechanism.slider_ids() {
            if self.mechanism.slider(id).at == point {
                let along = on_sheet(self.pose.guide(id));
                directions.extend([along, -along]);
            }
        }
        directions
    }

    fn all_lines(&self) -> (Vec<[Point; 2]>, Grid) {
        let lines: Vec<[Point; 2]> = self.mechanism.links().flat_map(|(id, _)| self.shape(id).lines()).collect();
        let mut grid = Grid::new(around(lines.as_flattened()));
        for (index, [from, to]) in lines.iter().enumerate() {
            grid.add_line(index, (*from, *to));
        }
        (lines, grid)
    }

    pub(super) fn shape(&self, link: BodyId) -> LinkShape {
        let points = &self.mechanism.body(link).points;
        let outline = outline(points.iter().map(|&p| self.pose.point(p)).collect());
        if outline.len() > 2
            && let Some(bars) = self.yoke(link)
        {
            return LinkShape::Bars(bars);
        }
        let corners: Vec<Point> = outline.iter().map(|&p| self.view.at(p)).collect();
        match corners.as_slice() {
            [] | [_] => LinkShape::Nothing,
            &[a, b] => LinkShape::Bars(vec![[a, b]]),
            _ => LinkShape::Plate(corners),
        }
    }

    /// The bars of a yoke, a link with a slot between two points that are only the slot's ends: the slot, and from each
    /// other point an arm normal to it.
    fn yoke(&self, link: BodyId) -> Option<Vec<[Point; 2]>> {
        let ids = self.mechanism.slider_ids();
        let mut slots = ids.filter(|&id| self.mechanism.slider(id).on == link);
        let slot = slots.next().filter(|_| slots.next().is_none())?;
        let at = self.at(self.mechanism.slider(slot).at);
        let along = on_sheet(self.pose.guide(slot));
        let points = &self.mechanism.body(link).points;
        let (ends, others): (Vec<PointId>, Vec<PointId>) =
            points.iter().partition(|&&point| (self.at(point) - at).cross(along).abs() <= ON_LINE);
        let is_held = |&point: &PointId| self.is_pin(point) || self.context.facts.slides[point.0];
        let &[a, b] = ends.as_slice() else {
            return None;
        };
        if ends.iter().any(is_held) {
            return None;
        }
        let [a, b] = [a, b].map(|end| self.at(end));
        if (b - a).hypot() <= ON_LINE {
            return None;
        }
        let arms = others.into_iter().map(|point| {
            let from = self.at(point);
            let share = (from - a).dot(b - a) / (b - a).hypot2();
            [from, a.lerp(b, share.clamp(0.0, 1.0))]
        });
        Some(std::iter::once([a, b]).chain(arms).collect())
    }
}

/// Whether a point is on a line to the reader's eye.
pub(super) fn is_on([a, b]: [Point; 2], point: Point) -> bool {
    let nearest = Line::new(a, b).nearest(point, 0.1 * ON_LINE);
    nearest.distance_sq <= ON_LINE * ON_LINE
}

/// Corners of a link, or of its image, in order around it; two for a straight one.
pub(in crate::drawing) fn outline(places: Vec<geometry::Point>) -> Vec<geometry::Point> {
    if places.len() < 3 {
        return places;
    }
    let size = span(places.iter().copied());
    // A corner flatter than a thousandth of the link counts as straight.
    hull(places, |[a, b, c]| cross(b - a, c - b) > 1e-3 * size * (c - a).norm())
}
