//! Placement of labels beside the points that they name, off all other things.
//!
//! All labels have the same kinds of places around their anchors: the ink box touches a circle about the anchor, in 24
//! directions and at a few distances. A place is *free* if it is inside the panel and off every obstacle box, and *clear*
//! if it is off all lines, too; a free place has a *cost* in millimetres for its distance, its direction, lines near it,
//! and other labels' anchors that are nearer than its own. Labels with the fewest free places choose first; those
//! without a clear place push others away or stand apart, anywhere on the panel, with a thin leader to their anchor;
//! then labels move, alone or in pairs, as long as the sum of the costs decreases (`moves.rs`). While a mechanism moves, labels stay where they
//! were, and only those in the way of something move (`held.rs`). Christensen, Marks and Shieber, "An Empirical Study of Algorithms for
//! Point-Feature Label Placement" (ACM Trans. Graphics 14(3), 1995), compare such searches; this one is deterministic:
//! the same labels always get the same places.

use kurbo::{Point, Rect, Vec2};

mod blocked;
mod held;
mod moves;
mod places;
mod search;

use super::grid::Obstacles;
use super::text::{Anchor, PlacedText, RichText};
use places::Spot;
pub use places::{LabelRequest, PlacedLabel};
use search::Search;

/// The places of the labels, in the order of the requests; none for a label without a place, as on a panel that is full,
/// and for one without text.
///
/// Between two labels is so much white that they are not read as one, no line goes through one and no leader through a
/// text, and none touches an obstacle box or leaves the panel.
/// The search for so many labels that no panel could show them ends early. The same input gives the same places on every
/// platform.
///
/// While a mechanism moves, `before` has for each label where the middle of its ink was from its anchor: it stays there
/// as long as it is clear there, and only labels that are not look for another place.
pub fn place(
    requests: &[LabelRequest],
    obstacles: &Obstacles,
    before: Option<&[Option<Vec2>]>,
) -> Vec<Option<PlacedLabel>> {
    let mut search = Search::new(requests, obstacles);
    match before {
        Some(before) => search.hold(before),
        None => search.choose_all(),
    }
    search.shorten();
    let placed = requests.iter().enumerate().map(|(index, request)| {
        let label = &search.labels[index];
        let Spot { ink, leader, .. } = label.places[label.chosen?];
        let text = request.short.as_ref().filter(|_| label.is_short).unwrap_or(&request.text);
        Some(PlacedLabel { text: text_at(text, request.size, ink), leader })
    });
    placed.collect()
}

fn text_at(text: &RichText, size: f64, ink: Rect) -> PlacedText {
    let origin = Point::ORIGIN + (ink.origin() - text.ink_box(size).origin());
    PlacedText::new(text.clone(), size, origin).anchored(Anchor::Middle)
}
