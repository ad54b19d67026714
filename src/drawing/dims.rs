//! The sheet and the sizes of letters and signs, in units of the layout.
//!
//! A sheet is laid out in units in which its letters have one size, [`CAPTION`]: in mm of paper for the style `paper`,
//! on a smaller sheet for a style with larger letters. [`Drawing::enlarged`] brings it to its size on paper. So all
//! that has no size of its own is in proportion to the letters; "mm" of the layout are these units.

use super::grid::STRIKE;
use super::held_layout::Pane;
use super::markers::{CODE_WHITE, EDGE, SIDE, WHITE, code_place};
use super::shape::Shape;
use super::sheet::Drawing;
use super::style::Style;
use super::text::CAPTION;
use crate::scene::{Figure, Page};
use kurbo::{Affine, Point};

/// White around the sheet's content, in mm.
pub(super) const MARGIN: f64 = 8.0;
/// Height of the title above the panels, in mm.
pub(super) const TITLE: f64 = 9.0;
/// White around the panels on a part of a screen, in units of the layout.
const PANE_EDGE: f64 = 1.0;
/// Room for half of the width of lines beside markers, in mm of paper.
const BORDER: f64 = 0.3;
/// White between the scales and the small code, in units of the layout.
const BESIDE: f64 = 1.5;

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
    /// White around a label's ink that no line enters.
    pub strike: f64,
    /// What is kept free of contents.
    pub free: Free,
}

/// What is kept free of contents along the edges of a sheet, in units of the layout.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Free {
    /// Along the left, right and lower edge.
    pub edge: f64,
    /// Along the upper edge, with the title.
    pub top: f64,
    /// Side of a square in the lower right corner of the rest, for the small code.
    pub corner: f64,
    /// Width of a marker with its white at the middle of the upper edge, between title and fields.
    pub middle: f64,
}

impl Free {
    const PLAIN: Free = Free { edge: MARGIN, top: MARGIN + TITLE, corner: 0.0, middle: 0.0 };
    pub(super) fn has_markers(self) -> bool {
        self.middle > 0.0
    }
}

impl Dims {
    /// Those of a scene's figure: of its own sizes or else of its style.
    pub(super) fn of(figure: &Figure) -> Dims {
        Dims::on_page(figure.page, figure)
    }

    /// Those of a figure on another page than its own.
    pub(super) fn on_page(page: Page, figure: &Figure) -> Dims {
        let page = page.size_mm();
        let sizes = figure.sizes.unwrap_or_else(|| Style::named(figure.style).sizes());
        let unit = sizes.letters.on(page) / CAPTION;
        let [head, dot, joint] = [sizes.arrowheads, sizes.points, sizes.joints].map(|size| size.on(page) / unit);
        let page = page.map(|side| side / unit);
        let strike = (0.5 * sizes.lines / unit + 0.05).clamp(STRIKE[0], STRIKE[1]);
        Dims { unit, page, head, dot: 0.5 * dot, joint: 0.5 * joint, strike, free: Free::PLAIN }
    }

    /// Those of a figure on a part of a screen, which has no title: a sheet of the pane's proportions on which the letters
    /// of the figure's style are as large as they are to be there; so lines and signs are in proportion to them, too.
    pub(super) fn on_pane(pane: Pane, figure: &Figure) -> Dims {
        let page = [pane.width, pane.height].map(|side| side * CAPTION / pane.letters);
        let free = Free { edge: PANE_EDGE, top: PANE_EDGE, corner: 0.0, middle: 0.0 };
        Dims { page, free, ..Dims::of(figure) }
    }

    /// Whether the title stands above the panels.
    pub(super) fn has_title(&self) -> bool {
        self.free.top > self.free.edge
    }

    /// These sizes with room for markers and the code along the edges.
    pub(super) fn with_markers(self) -> Dims {
        let page = self.page.map(|side| side * self.unit);
        let edge = EDGE + SIDE + WHITE + BORDER;
        let corner = page[0] - code_place(page).x0 + CODE_WHITE - edge;
        let [edge, corner, middle] = [edge, corner, SIDE + 2.0 * WHITE].map(|mm| mm / self.unit);
        let free = Free { edge: edge.max(MARGIN), top: (MARGIN + TITLE).max(edge), corner, middle };
        Dims { free, ..self }
    }

    /// Width of the area below the scales.
    pub(super) fn width_below(&self) -> f64 {
        self.page[0] - 2.0 * self.free.edge - self.beside_code()
    }

    /// Width of the small code with its white, right of the area below the scales.
    pub(super) fn beside_code(&self) -> f64 {
        if self.free.has_markers() { self.free.corner + BESIDE } else { 0.0 }
    }

    /// Ends of the line of the title, across the sheet.
    pub(super) fn title_line(&self) -> [f64; 2] {
        let end = match self.free.has_markers() {
            true => 0.5 * (self.page[0] - self.free.middle),
            false => self.page[0] - self.free.edge,
        };
        [self.free.edge, end]
    }
}

impl Drawing {
    /// The sheet with all lengths multiplied by a factor; widths of lines are those of the style.
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
        for name in self.unlabelled.iter_mut().flat_map(|panel| &mut panel.names) {
            name.place = Affine::scale(factor) * name.place;
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
            Shape::Area(chains) => chains.iter_mut().flatten().for_each(at),
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
