//! The shapes of links in a position: bars and plates, and the lines on which a point lies.

use crate::drawing::grid::Grid;
use crate::drawing::shape::around;
use crate::drawing::view::{View, on_sheet};
use crate::geometry::{self, cross, span};
use crate::mechanism::{BodyId, Mark, Mechanism, PointId, SliderId};
use crate::position::Pose;
use kurbo::{Line, ParamCurveNearest, Point, Rect};

/// A point closer than this to a line, in mm, counts as on the line.
pub(super) const ON_LINE: f64 = 0.3;
pub(super) struct Posed<'a> {
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
}
pub(super) enum LinkShape {
    /// None besides its block or its guide.
    Nothing,
    /// Straight bars: one between two points, or a slot and the arms that hold it.
    Bars(Vec<[Point; 2]>),
    /// An area with these corners.
    Plate(Vec<Point>),
}

impl LinkShape {
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
    fn is_pin(&self, point: PointId) -> bool {
        let marks = self.mechanism.joints.iter().flat_map(|joint| &joint.marks);
        marks.into_iter().any(|mark| matches!(mark, Mark::Circle { center, .. } if *center == point))
    }

    fn at(&self, view: &View, point: PointId) -> Point {
        view.at(self.pose.point(point))
    }
}

/// The straight lines of all links as a view shows them, in the order of the links.
pub(super) struct LinkLines {
    lines: Vec<[Point; 2]>,
    grid: Grid,
}

impl LinkLines {
    pub(super) fn new(posed: &Posed<'_>, view: &View) -> Self {
        let links = posed.mechanism.links();
        let lines: Vec<[Point; 2]> = links.flat_map(|(id, _)| posed.shape(view, id).lines()).collect();
        let ends: Vec<Point> = lines.as_flattened().to_vec();
        let mut grid = Grid::new(around(&ends));
        for (index, [from, to]) in lines.iter().enumerate() {
            grid.add_line(index, (*from, *to));
        }
        Self { lines, grid }
    }

    /// The lines on which a point is, to the reader's eye.
    pub(super) fn at(&self, point: Point) -> Vec<[Point; 2]> {
        let area = Rect::from_center_size(point, (1.0, 1.0));
        let near = self.grid.near(area).into_iter().map(|index| self.lines[index]);
        near.filter(|ends| is_on(*ends, point)).collect()
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
