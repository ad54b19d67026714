//! Panels: boxes of a sheet, each with a stack of layers.

use super::canvas::Canvas;
use super::layout::{Needs, Placed};
use super::line::Line;
use super::shape::{Shape, corners};
use super::sheet::{Drawing, Mark, Pen};
use super::text::CAPTION;
use super::view::View;
use indexmap::IndexMap;
use kurbo::Vec2;

/// Size of panels' headings.
const SIZE: f64 = 1.05 * CAPTION;
/// White before them.
const BEFORE: f64 = 2.5;

/// A box of a sheet.
pub(super) struct Panel<'a> {
    /// What it is called.
    pub name: String,
    /// Its marks' ids begin with this.
    pub prefix: &'static str,
    /// How much room it wants.
    pub needs: Needs,
    /// What is drawn in it, the lowest layer first.
    pub layers: Layers<'a>,
}

/// What is drawn in a panel, the lowest layer first.
pub(super) type Layers<'a> = Vec<Box<dyn Layer + 'a>>;

/// Something that is drawn in a panel, over the layers before it.
pub(super) trait Layer {
    /// Keeps the layers below, and all names, off what it is going to draw.
    fn announce(&self, _canvas: &mut Canvas<'_>, _view: &View) {}

    /// Draws it.
    fn draw(&self, canvas: &mut Canvas<'_>, view: &View);

    /// Changes the marks of the whole panel, when all names have their places.
    fn retouch(&self, _marks: &mut Vec<Mark>) {}
}

impl<F: Fn(&mut Canvas<'_>, &View)> Layer for F {
    fn draw(&self, canvas: &mut Canvas<'_>, view: &View) {
        self(canvas, view);
    }
}

impl Panel<'_> {
    /// Draws the panel in its place; names are shown as `renamed` says.
    pub(super) fn draw(&self, drawing: &mut Drawing, placed: &Placed, renamed: &IndexMap<String, String>) {
        drawing.panels.push((self.name.clone(), placed.frame));
        let view = View::new(placed.mu, &self.needs.extent, placed.area);
        let before = drawing.marks.len();
        let mut canvas = Canvas::new(drawing, self.prefix, placed.frame, renamed);
        for layer in &self.layers {
            layer.announce(&mut canvas, &view);
        }
        for layer in &self.layers {
            layer.draw(&mut canvas, &view);
        }
        canvas.finish();
        let mut own = drawing.marks.split_off(before);
        for layer in &self.layers {
            layer.retouch(&mut own);
        }
        drawing.marks.append(&mut own);
    }
}

/// A panel's border and its heading: its lowest layer.
pub(super) struct Frame {
    pub heading: Line,
    pub pen: Pen,
    /// Where the heading begins, from the panel's upper left corner.
    pub at: Vec2,
}

impl Frame {
    /// A frame with the heading inside.
    pub(super) fn new(heading: Line, pen: Pen) -> Frame {
        Frame { heading, pen, at: Vec2::new(BEFORE, 6.0) }
    }

    /// How wide a panel must be for the heading.
    pub(super) fn width(&self) -> f64 {
        self.heading.width(SIZE) + 2.0 * BEFORE
    }
}

impl Layer for Frame {
    fn draw(&self, canvas: &mut Canvas<'_>, _: &View) {
        let frame = canvas.frame();
        canvas.drawing.draw(Pen::Frame, Shape::Polygon(corners(frame)));
        let ink = self.heading.starting(canvas.drawing, self.pen, frame.origin() + self.at, SIZE);
        canvas.keep_off(ink);
        canvas.settle();
    }
}

/// The heading of the panel of this number, as in `(a) Scheme`.
pub(super) fn numbered(index: usize, name: &str) -> String {
    format!("({}) {name}", char::from(b'a' + index as u8))
}
