//! Panels of a sheet, each with layers.

use super::canvas::Canvas;
use super::dims::Dims;
use super::held::Held;
use super::layout::{HEADING, Needs, Placed, sheet_of};
use super::lines::Line;
use super::markers::PlacedPanel;
use super::shape::{Shape, corners};
use super::sheet::{Drawing, Mark, Pen};
use super::text::CAPTION;
use super::view::{Extent, View};
use crate::geometry;
use crate::quantity::QuantityKind;
use crate::text::Untrusted;
use indexmap::IndexMap;
use kurbo::{Rect, Vec2};

/// Size of panels' headings, in mm of one em.
const SIZE: f64 = 1.05 * CAPTION;
/// Least distance of a pole from the edge, in mm: room for its name.
const AROUND: f64 = 5.0;
const BEFORE: f64 = 2.5;
pub(super) struct Panel<'a> {
    /// Its name, in the figure's language.
    pub name: String,
    /// Prefix of its marks' ids.
    pub prefix: String,
    /// The room that it needs.
    pub needs: Needs,
    /// What it says where its content is larger.
    pub cut: String,
    /// What it says where it has no room for all names.
    pub unlabelled: String,
    /// The extent of what is held in sight where the panel is for other positions, too.
    pub content: Option<Extent>,
    /// Its layers, the lowest first.
    pub layers: Layers<'a>,
}

/// Layers of a panel, the lowest first.
pub(super) type Layers<'a> = Vec<Box<dyn Layer + 'a>>;

/// A layer of a panel, drawn over those before it.
pub(super) trait Layer {
    /// Reserves room before the layers below are drawn: they and all labels keep off it.
    fn reserve(&self, _canvas: &mut Canvas<'_>, _view: &View) {}
    fn draw(&self, canvas: &mut Canvas<'_>, view: &View);

    /// Changes the marks of all layers after labels have been placed.
    fn retouch(&self, _marks: &mut Vec<Mark>) {}
}

impl<F: Fn(&mut Canvas<'_>, &View)> Layer for F {
    fn draw(&self, canvas: &mut Canvas<'_>, view: &View) {
        self(canvas, view);
    }
}

impl<'a> Panel<'a> {
    /// A panel whose content always fits and has room for its names.
    pub(super) fn plain(name: &str, prefix: &str, needs: Needs, layers: Layers<'a>) -> Panel<'a> {
        let (name, prefix) = (name.to_owned(), prefix.to_owned());
        Panel { name, prefix, needs, cut: String::new(), unlabelled: String::new(), content: None, layers }
    }

    /// Draws the panel in its place; `renamed` replaces names of points and links. What was `held` in the picture before
    /// stays where it was, if it can.
    pub(super) fn draw(
        &self,
        drawing: &mut Drawing,
        placed: &Placed,
        renamed: &IndexMap<String, Untrusted>,
        dims: &Dims,
        held: Option<&mut Held>,
    ) {
        drawing.panels.push((self.name.clone(), placed.frame));
        let view = placed.view(&self.needs.extent, self.content);
        let before = drawing.marks.len();
        let mut canvas = Canvas::new(drawing, &self.prefix, placed.frame, renamed, *dims);
        canvas.held = held;
        for layer in &self.layers {
            layer.reserve(&mut canvas, &view);
        }
        for layer in &self.layers {
            layer.draw(&mut canvas, &view);
        }
        let unlabelled = canvas.finish(&self.cut, &self.unlabelled);
        if !unlabelled.is_empty() {
            drawing.unlabelled.push((self.name.clone(), unlabelled));
        }
        let mut marks = drawing.marks.split_off(before);
        for layer in &self.layers {
            layer.retouch(&mut marks);
        }
        drawing.marks.append(&mut marks);
    }

    /// The panel on a sheet, for programs that read a photograph of it.
    pub(super) fn on_paper(&self, placed: &Placed) -> PlacedPanel {
        let origin = placed.view(&self.needs.extent, self.content).at(geometry::Point::origin());
        let panel = sheet_of(placed.kind);
        PlacedPanel { panel, mu: placed.mu, origin: [origin.x, origin.y].map(|place| place * placed.unit) }
    }
}

impl Placed {
    /// The view of a panel of some extent, moved so that a content that fits stays in sight, and always the pole of a plan.
    pub(super) fn view(&self, extent: &Extent, content: Option<Extent>) -> View {
        let mut view = View::new(self.mu * self.unit, extent, self.area);
        if let Some(content) = content.filter(|content| self.holds(content)) {
            view = view.holding(content.low, self.area).holding(content.high, self.area);
        }
        if matches!(self.kind, QuantityKind::Velocity | QuantityKind::Acceleration) {
            view = view.holding(geometry::Point::origin(), self.room_of_pole());
        }
        view
    }

    /// Where the pole of a plan is always in sight, with its name.
    pub(super) fn room_of_pole(&self) -> Rect {
        let mut room = self.frame.inset(-AROUND);
        room.y0 += HEADING;
        room
    }
}

/// A panel's border and heading: its lowest layer.
pub(super) struct Frame {
    pub heading: Line,
    /// What stands in a panel that is too narrow for the heading.
    pub short: Option<Line>,
    pub pen: Pen,
    /// Start of the heading, from the panel's upper left corner, in mm.
    pub at: Vec2,
}

impl Frame {
    /// A frame with the heading inside.
    pub(super) fn new(heading: Line, pen: Pen) -> Frame {
        Frame { heading, short: None, pen, at: Vec2::new(BEFORE, 6.0) }
    }

    /// Smallest width of a panel with this heading, in mm.
    pub(super) fn width(&self) -> f64 {
        self.heading.width(SIZE) + 2.0 * BEFORE
    }
}

impl Layer for Frame {
    fn draw(&self, canvas: &mut Canvas<'_>, _: &View) {
        let frame = canvas.frame();
        canvas.drawing.draw(Pen::Frame, Shape::Polygon(corners(frame)));
        // A short one is no smaller than captions.
        let (heading, size) = match &self.short {
            // White on the right may be narrower: letters of panels differ in width.
            Some(short) if self.width() - BEFORE > frame.width() => (short, CAPTION),
            _ => (&self.heading, SIZE),
        };
        let ink = heading.starting(canvas.drawing, self.pen, frame.origin() + self.at, size);
        canvas.keep_off(ink);
        canvas.exclude_drawn();
    }
}

/// The heading of the panel with this index, as in `(a) Scheme`.
pub(super) fn numbered(index: usize, name: &str) -> String {
    format!("({}) {name}", char::from(b'a' + index as u8))
}
