//! The scheme in a view.

use super::link_shape::{LinkLines, LinkShape, ON_LINE, Posed};
use crate::drawing::context::SheetContext;
use crate::drawing::dims::Dims;
use crate::drawing::view::{View, on_sheet};
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId};
use crate::position::Pose;
use kurbo::{Point, Vec2};
use std::cell::OnceCell;

/// The mechanism as it stands on a sheet.
pub(super) struct SchemeOnPaper<'a> {
    pub context: &'a SheetContext<'a>,
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub view: &'a View,
    /// The lines of the links, once they are asked for.
    link_lines: OnceCell<LinkLines>,
}

impl<'a> SchemeOnPaper<'a> {
    pub(super) fn new(context: &'a SheetContext<'a>, view: &'a View) -> Self {
        let (mechanism, pose) = (context.mechanism(), context.pose());
        Self { context, mechanism, pose, view, link_lines: OnceCell::new() }
    }

    pub(super) fn dims(&self) -> Dims {
        self.context.surface.dims
    }

    /// The place of a point on the sheet.
    pub(super) fn at(&self, point: PointId) -> Point {
        self.view.at(self.pose.point(point))
    }
    pub(super) fn posed<'p>(&self, pose: &'p Pose) -> Posed<'p>
    where
        'a: 'p,
    {
        Posed { mechanism: self.mechanism, pose }
    }
    pub(super) fn shape(&self, link: BodyId) -> LinkShape {
        self.posed(self.pose).shape(self.view, link)
    }

    /// Whether a point is a pin.
    pub(super) fn is_pin(&self, point: PointId) -> bool {
        self.context.facts.pins[point.0]
    }

    /// Number of a link, by which a style picks its colour.
    pub(super) fn number(&self, link: BodyId) -> Option<usize> {
        self.context.number(link)
    }

    /// Unit vector from the centre of the mechanism; none within 5 mm of it.
    pub(super) fn outward(&self, from: Point) -> Option<Vec2> {
        let away = from - self.view.at(self.context.facts.middle);
        (away.hypot() > 5.0).then(|| away.normalize())
    }

    /// The unit vectors of links and guides at a point.
    pub(super) fn directions(&self, point: PointId) -> Vec<Vec2> {
        let from = self.at(point);
        let lines = self.link_lines.get_or_init(|| LinkLines::new(&self.posed(self.pose), self.view));
        let ends = lines.at(from).into_iter().flat_map(|ends| ends.map(|end| end - from));
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
