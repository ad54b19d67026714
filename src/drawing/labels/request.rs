//! What labels ask for, and what they get.

use super::super::text::{PlacedText, RichText};
use kurbo::{Point, Rect, Vec2};

/// A label that wants a place.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelRequest {
    /// What it says.
    pub text: RichText,
    /// Its size: mm of one em.
    pub size: f64,
    /// The point that it names.
    pub anchor: Point,
    /// How far its ink must stay from the anchor, in mm: the radius of a joint and a gap.
    pub clearance: f64,
    /// The direction from the anchor that it likes best, y down; none for wherever there is most
    /// room.
    pub prefer: Option<Vec2>,
    /// Greater goes first where room is short.
    pub priority: u8,
}

/// What labels must or should keep off.
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacles {
    /// Joints, arrowheads, boxes: never touched.
    pub boxes: Vec<Rect>,
    /// Lines: crossing one costs by the length inside the label's box.
    pub lines: Vec<(Point, Point)>,
    /// The panel: no label leaves it.
    pub bounds: Rect,
}

/// A label at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedLabel {
    /// The text on the sheet.
    pub text: PlacedText,
    /// A thin line from near the anchor to near the text, where the text had to stand apart.
    pub leader: Option<(Point, Point)>,
    /// Whether the panel holds no free place, so that this label touches something.
    pub crowded: bool,
}
