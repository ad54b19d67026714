//! The scheme in a view: places of points, shapes of links, the lines on which a point lies; and what of it is in sight:
//! its extent, and which special points are near enough to stand at their places.

use super::contacts::{self, has_guide};
use crate::construction::{Solution, Special};
use crate::drawing::context::{Purpose, SheetContext};
use crate::drawing::dims::Dims;
use crate::drawing::grid::Grid;
use crate::drawing::shape::{Shape, around};
use crate::drawing::view::{Extent, View, on_sheet, towards};
use crate::forces::places_of_loads;
use crate::geometry::{self, cross, hull, span};
use crate::mechanism::{BodyId, GROUND, Mark, Mechanism, PointId};
use crate::position::Pose;
use crate::scene::ConstructionShown;
use kurbo::{Line, ParamCurveNearest, Point, Rect, Vec2};
use std::cell::OnceCell;

/// A point closer than this to a line, in mm, counts as on the line.
pub(super) const ON_LINE: f64 = 0.3;
/// Largest size of the scheme with a special point over that without it; more distant points are not drawn at their
/// places: they would make the mechanism small.
const REACH: f64 = 1.4;
/// Largest such size where they are to stand at their places: on sheets of exercises, and in figures as in the source paper.
const REACH_OF_PENCIL: f64 = 2.5;
/// Room for the arrow towards a more distant one, in parts of the mechanism's size.
const ARROW: f64 = 0.12;
/// Length of a guide on the ground to either side of its block, in parts of the mechanism's size.
const GUIDE: f64 = 0.06;

/// The mechanism as it stands on a sheet.
pub(super) struct SchemeOnPaper<'a> {
    pub context: &'a SheetContext<'a>,
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub view: &'a View,
    /// The room in the panel for the slots of links' areas; none where no slots are drawn.
    room: Option<Rect>,
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
        Self { context, mechanism, pose, view, room: None, link_lines: OnceCell::new() }
    }

    /// The mechanism with its slots, in a panel with this room.
    pub(super) fn within(self, room: Rect) -> Self {
        Self { room: Some(room), ..self }
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
            _ => {
                let slots = self.room.map(|room| self.corners_of_slots(link, room)).unwrap_or_default();
                LinkShape::Plate(if slots.is_empty() { corners } else { hull_on_sheet(&[corners, slots].concat()) })
            }
        }
    }

    /// The bars of a yoke, a link with a slot between two points that are only the slot's ends: the slot, and from each
    /// other point an arm normal to it.
    fn yoke(&self, link: BodyId) -> Option<Vec<[Point; 2]>> {
        let ids = self.mechanism.slider_ids();
        let mut slots = ids.filter(|&id| self.mechanism.slider(id).on == link && has_guide(self.mechanism, id));
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

/// The corners of the convex area around some points of the sheet.
fn hull_on_sheet(points: &[Point]) -> Vec<Point> {
    let places = points.iter().map(|point| geometry::Point::new(point.x, point.y));
    outline(places.collect()).into_iter().map(|place| Point::new(place.x, place.y)).collect()
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

/// The extent of all points, of paths, ghosts and other modes, and of the special points, or of the arrows to those too
/// far away.
pub(in crate::drawing) fn extent(context: &SheetContext<'_>) -> Extent {
    let special = context.special().filter_map(|special| reached(context, special));
    let circles = context.figure().inflection.iter().filter_map(|link| context.solution.inflection_circle(link));
    let poles = circles.flat_map(|(_, poles)| poles).filter(|pole| is_within_reach(context, *pole));
    let places = places(context.solution).chain(special).chain(poles);
    let traces = &context.traces;
    let pieces = traces.paths.iter().flat_map(|path| path.pieces.iter().chain(&path.beyond).flatten());
    let poses = traces.ghosts.iter().chain(context.modes.shown.iter().map(|(_, pose)| pose));
    let centrodes =
        traces.centrodes.iter().flat_map(|centrode| centrode.fixed.iter().chain(&centrode.moving).flatten());
    let others =
        pieces.chain(centrodes).map(|(_, place)| *place).chain(poses.flat_map(|pose| pose.points.iter().copied()));
    Extent::of(places.chain(others))
}

/// Whether a special point is near enough to be drawn at its place.
pub(in crate::drawing) fn is_near(context: &SheetContext<'_>, special: &Special) -> bool {
    special.place.finite().is_some_and(|place| is_within_reach(context, place))
}

fn is_within_reach(context: &SheetContext<'_>, place: geometry::Point) -> bool {
    let points = || context.solution.pose.points.iter().copied();
    let reach = if has_far_points(context) { REACH_OF_PENCIL } else { REACH };
    span(points().chain([place])) <= reach * span(points())
}

/// The circles of joints: centre, and radius in the scene's unit of length; zero for a pin.
pub(super) fn circles(mechanism: &Mechanism, pose: &Pose) -> impl Iterator<Item = (PointId, f64)> {
    let marks = mechanism.joints.iter().flat_map(|joint| joint.marks.iter().copied());
    marks.filter_map(|mark| match mark {
        Mark::Circle { center, towards, part } => Some((center, part * pose.arm(center, towards).norm())),
        Mark::Wheel { center, radius } => Some((center, radius)),
        Mark::Block(_) => None,
    })
}

/// Whether special points far from the mechanism stand at their places.
fn has_far_points(context: &SheetContext<'_>) -> bool {
    context.purpose != Purpose::Figure || context.figure().construction == ConstructionShown::Paper
}

/// A place that the extent of the scheme reaches for a special point: its own or, of a distant one, the end of its
/// arrow.
fn reached(context: &SheetContext<'_>, special: &Special) -> Option<geometry::Point> {
    let place = special.place.finite()?;
    if is_near(context, special) {
        return Some(place);
    }
    let start = special.cuts.iter().find_map(|cut| cut.start()).filter(|_| !has_far_points(context))?;
    let start = context.solution.pose.point(start);
    let size = span(context.solution.pose.points.iter().copied());
    Some(start + (place - start).normalize() * (ARROW * size))
}

/// The points of a position, the ends of guides on the ground, and the corners around circles, where loads act: what does not depend on the figure.
pub(in crate::drawing) fn places(solution: &Solution) -> impl Iterator<Item = geometry::Point> {
    let (mechanism, pose) = (&solution.mechanism, &solution.pose);
    let circles = circles(mechanism, pose).flat_map(|(center, radius)| {
        let (center, arm) = (pose.point(center), geometry::Vector::new(radius, radius));
        [center - arm, center + arm]
    });
    let points = pose.points.iter().copied().chain(guide_ends(mechanism, pose)).chain(circles);
    points.chain(contacts::places(solution)).chain(places_of_loads(mechanism, pose))
}

/// Points that extend the scheme for guides on the ground, and for those with ends.
fn guide_ends(mechanism: &Mechanism, pose: &Pose) -> impl Iterator<Item = geometry::Point> {
    let reach = GUIDE * span(pose.points.iter().copied());
    let sliders = mechanism.slider_ids();
    sliders
        .filter_map(move |id| {
            let slider = mechanism.slider(id);
            let (at, along) = (pose.point(slider.at), pose.guide(id));
            match slider.travel.zip(pose.slides[id.0]) {
                Some((travel, position)) => Some(travel.map(|end| at + along * (end - position))),
                None => (slider.on == GROUND).then(|| [at - along * reach, at + along * reach]),
            }
        })
        .flatten()
}
