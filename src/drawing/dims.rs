//! The sheet and the sizes of letters and signs, in units of the layout.
//!
//! A sheet is laid out in units in which its letters have one size, [`CAPTION`]: in mm of paper for the style `paper`,
//! on a smaller sheet for a style with larger letters. [`Drawing::enlarged`] brings it to its size on paper. So all
//! that has no size of its own is in proportion to the letters; "mm" of the layout are these units.

use super::shape::Shape;
use super::sheet::Drawing;
use super::style::Style;
use super::text::CAPTION;
use crate::scene::Figure;
use kurbo::{Affine, Point};

/// Sizes on a sheet, in units of the layout.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Dims {
    /// A unit of the layout, in mm of paper.
    pub unit: f64,
    /// Width and height of the sheet.
    pub page: [f64; 2],
    /// Length of an arrowhead.
    pub head: f64,
    /// Radius of the dot of an image in a plan.
    pub dot: f64,
    /// Radius of a joint's circle.
    pub joint: f64,
}

impl Dims {
    /// Those of a scene's figure: of its own sizes or else of its style.
    pub(super) fn of(figure: &Figure) -> Dims {
        let page = figure.page.size_mm();
        let sizes = figure.sizes.unwrap_or_else(|| Style::named(figure.style).sizes());
        let unit = sizes.letters.on(page) / CAPTION;
        let [head, dot, joint] = [sizes.arrowheads, sizes.points, sizes.joints].map(|size| size.on(page) / unit);
        Dims { unit, page: page.map(|side| side / unit), head, dot: 0.5 * dot, joint: 0.5 * joint }
    }
}

impl Drawing {
    /// The same sheet with all lengths multiplied by a factor; widths of lines are those of the style.
    pub(super) fn enlarged(mut self, factor: f64) -> Drawing {
        if factor == 1.0 {
            return self;
        }
        (self.width, self.height) = (self.width * factor, self.height * factor);
        for mark in &mut self.marks {
            mark.shape.enlarge(factor);
        }
        for (_, frame) in &mut self.panels {
            *frame = Affine::scale(factor).transform_rect_bbox(*frame);
        }
        self
    }
}

impl Shape {
    fn enlarge(&mut self, factor: f64) {
        let at = |point: &mut Point| *point = (point.to_vec2() * factor).to_point();
        match self {
            Shape::Line(a, b) => [a, b].into_iter().for_each(at),
            Shape::Polyline(points) | Shape::Polygon(points) => points.iter_mut().for_each(at),
            Shape::Circle { center, radius } | Shape::Arc { center, radius, .. } => {
                at(center);
                *radius *= factor;
            }
            Shape::ArcArrow { center, radius, head, .. } => {
                at(center);
                (*radius, *head) = (*radius * factor, *head * factor);
            }
            Shape::Arrow { from, to, head } => {
                [from, to].into_iter().for_each(at);
                *head *= factor;
            }
            Shape::Text(text) => {
                at(&mut text.origin);
                text.size *= factor;
            }
        }
    }
}
