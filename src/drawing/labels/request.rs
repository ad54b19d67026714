//! Requests for labels, and placed labels.

use super::super::text::{PlacedText, RichText};
use kurbo::{Point, Rect, Vec2};

/// A label without a place.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelRequest {
    /// Its text.
    pub text: RichText,
    /// Its size: mm of one em.
    pub size: f64,
    /// The point that it names.
    pub anchor: Point,
    /// Smallest distance of its ink from the anchor, in mm: the radius of a joint and a gap.
    pub clearance: f64,
    /// The preferred direction from the anchor, y down; none for any.
    pub prefer: Option<Vec2>,
    /// Labels of higher priority choose first.
    pub priority: u8,
}

/// Obstacles for labels.
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
    /// Length of the lines that cross the ink's box, in mm.
    pub struck: f64,
    /// Whether the panel holds no free place, so that this label touches something.
    pub crowded: bool,
    /// Whether there are so many labels that the search was ended before this one had a place: it is better left out.
    pub left_out: bool,
}
