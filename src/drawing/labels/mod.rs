//! Placement of labels beside the points that they name, off all other things.
//!
//! All labels have the same kinds of places around their anchors: the ink box touches a circle about the anchor, in 24
//! directions and at a few distances. A place is *free* if it is inside the panel and off every obstacle box; a free
//! place has a *cost* in millimetres for its distance, its direction, lines that it crosses, and other labels' anchors
//! that are nearer than its own. Labels with the fewest free places choose first; then labels move, alone or in pairs,
//! as long as the sum of the costs decreases. Christensen, Marks and Shieber, "An Empirical Study of Algorithms for
//! Point-Feature Label Placement" (ACM Trans. Graphics 14(3), 1995), compare such searches; this one is deterministic:
//! the same labels always get the same places.

use kurbo::{Point, Vec2};

mod boxes;
mod moves;
mod places;
mod search;

use super::obstacles::{Obstacles, Taken};
use super::text::{Anchor, PlacedText};
use places::Spot;
pub use places::{LabelRequest, PlacedLabel};
use search::Search;

/// The places of the labels, in the order of the requests.
///
/// No label touches another, an obstacle box or the edge of the panel, unless it is `crowded`: then the panel has no
/// free place, and it is where it covers least. The search for so many labels that no panel could show them ends early;
/// labels without a place are then `left_out`. The same input gives the same places on every platform.
pub fn place(requests: &[LabelRequest], obstacles: &Obstacles) -> Vec<PlacedLabel> {
    place_among(requests, &Taken::of(obstacles), None)
}

/// The same among obstacles that are already found quickly. While a mechanism moves, `before` has for each label where
/// the middle of its ink was from its anchor: it stays there as long as nothing is much better, and the search is short.
pub(super) fn place_among(
    requests: &[LabelRequest],
    taken: &Taken,
    before: Option<&[Option<Vec2>]>,
) -> Vec<PlacedLabel> {
    let mut search = Search::new(requests, taken, before);
    search.choose_first(requests);
    search.make_room();
    search.improve();
    search.free_struck();
    search.search_panel();
    let is_cut_short = search.is_cut_short.get();
    let found: Vec<Option<Spot>> =
        search.labels.iter().map(|label| label.chosen.map(|chosen| label.places[chosen])).collect();
    let placed = requests.iter().zip(found).enumerate().map(|(index, (request, found))| {
        let crowded = found.is_none() && !request.text.is_empty();
        let left_out = crowded && is_cut_short;
        let place = found.unwrap_or_else(|| match left_out {
            true => search.labels[index].first_place(),
            false => search.least_covering(index),
        });
        let ink = request.text.ink_box(request.size);
        let origin = Point::ORIGIN + (place.ink.origin() - ink.origin());
        let text = PlacedText::new(request.text.clone(), request.size, origin).anchored(Anchor::Middle);
        let struck = if left_out { 0.0 } else { search.struck(place.ink) };
        PlacedLabel { text, leader: place.leader, struck, crowded, left_out }
    });
    placed.collect()
}

/// The best place near its anchor for one more label; `None` where nothing is free there. Other labels do not move for
/// it.
pub(super) fn place_near(request: &LabelRequest, taken: &Taken) -> Option<PlacedLabel> {
    let mut search = Search::new(std::slice::from_ref(request), taken, None);
    let count = search.labels[0].places.len();
    let cheapest = (0..count).map(|place| (search.cost(0, place), place)).min_by(|a, b| a.0.total_cmp(&b.0));
    let place = search.labels[0].places[cheapest?.1];
    let origin = Point::ORIGIN + (place.ink.origin() - request.text.ink_box(request.size).origin());
    let text = PlacedText::new(request.text.clone(), request.size, origin).anchored(Anchor::Middle);
    Some(PlacedLabel { text, leader: place.leader, struck: search.struck(place.ink), crowded: false, left_out: false })
}

#[cfg(test)]
mod tests {
    use super::boxes::{gap, touch};
    use super::*;
    use crate::drawing::text::RichText;
    use kurbo::Rect;

    /// Numbers between 0 and 1 from a seed (Steele, Lea and Flood, "Fast Splittable Pseudorandom
    /// Number Generators", 2014).
    fn random(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = *seed;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn crowd(seed: u64, labels: usize, lines: usize, size: (f64, f64)) -> (Vec<LabelRequest>, Obstacles) {
        let mut seed = seed;
        let bounds = Rect::new(10.0, 10.0, 10.0 + size.0, 10.0 + size.1);
        let at = |seed: &mut u64| {
            let (x, y) = (random(seed), random(seed));
            Point::new(bounds.x0 + 2.0 + (size.0 - 4.0) * x, bounds.y0 + 2.0 + (size.1 - 4.0) * y)
        };
        let names = ["A", "S_3", "n_{s3b}", "v_{CB} ⊥ CB", "a^n_{DG}", "ω_2", "b'"];
        let anchors: Vec<Point> = (0..labels).map(|_| at(&mut seed)).collect();
        let request = |(index, &anchor): (usize, &Point)| LabelRequest {
            text: RichText::math(names[index % names.len()]),
            size: 3.5,
            anchor,
            clearance: 1.6,
            prefer: (index % 3 == 0).then_some(Vec2::new(1.0, -0.2)),
            priority: 0,
        };
        let requests = anchors.iter().enumerate().map(request).collect();
        let boxes = anchors.iter().map(|&anchor| Rect::from_center_size(anchor, (2.2, 2.2))).collect();
        let lines = (0..lines).map(|_| (at(&mut seed), at(&mut seed))).collect();
        (requests, Obstacles { boxes, lines, bounds })
    }

    fn check(placed: &[PlacedLabel], obstacles: &Obstacles) {
        for (index, label) in placed.iter().enumerate() {
            let ink = label.text.ink_box();
            assert!(!label.crowded, "label {index} found no place");
            assert_eq!(ink.union(obstacles.bounds), obstacles.bounds, "label {index} leaves the panel");
            assert!(!obstacles.boxes.iter().any(|&other| touch(ink, other, 0.0)), "label {index} touches an obstacle");
            for (other_index, other) in placed[..index].iter().enumerate() {
                assert!(!touch(ink, other.text.ink_box(), 0.0), "labels {other_index} and {index} touch");
            }
        }
    }

    #[test]
    fn labels_keep_apart_in_crowds() {
        for seed in 0..60 {
            let (requests, obstacles) = crowd(seed, 40, 100, (140.0, 100.0));
            check(&place(&requests, &obstacles), &obstacles);
            let (requests, obstacles) = crowd(1000 + seed, 24, 20, (60.0, 50.0));
            check(&place(&requests, &obstacles), &obstacles);
        }
    }

    #[test]
    fn the_same_labels_get_the_same_places() {
        let (requests, obstacles) = crowd(7, 40, 100, (140.0, 100.0));
        assert_eq!(place(&requests, &obstacles), place(&requests, &obstacles));
    }

    #[test]
    fn a_lone_label_stands_where_it_likes() {
        let obstacles = Obstacles { boxes: vec![], lines: vec![], bounds: Rect::new(0.0, 0.0, 100.0, 100.0) };
        for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (1.0, 1.0), (-1.0, -1.0)] {
            let wish = Vec2::new(x, y);
            let anchor = Point::new(50.0, 50.0);
            let request = LabelRequest {
                text: RichText::math("S_3"),
                size: 4.0,
                anchor,
                clearance: 1.5,
                prefer: Some(wish),
                priority: 0,
            };
            let placed = place(&[request], &obstacles);
            let away = placed[0].text.ink_box().center() - anchor;
            assert!(away.dot(wish) > 0.7 * away.hypot2().sqrt() * wish.hypot2().sqrt(), "{away:?} for {wish:?}");
            assert!((gap(placed[0].text.ink_box(), anchor) - 1.5).abs() < 1e-9);
            assert_eq!(placed[0].leader, None);
        }
    }

    #[test]
    fn a_label_without_room_beside_its_point_gets_a_leader() {
        let anchor = Point::new(50.0, 50.0);
        let boxes = vec![Rect::from_center_size(anchor, (14.0, 14.0))];
        let obstacles = Obstacles { boxes, lines: vec![], bounds: Rect::new(0.0, 0.0, 100.0, 100.0) };
        let request =
            LabelRequest { text: RichText::math("S_3"), size: 4.0, anchor, clearance: 1.5, prefer: None, priority: 0 };
        let placed = place(&[request], &obstacles);
        check(&placed, &obstacles);
        assert!(placed[0].leader.is_some());
    }

    #[test]
    fn a_panel_without_room_says_so() {
        let obstacles = Obstacles { boxes: vec![], lines: vec![], bounds: Rect::new(0.0, 0.0, 4.0, 4.0) };
        let request = |x| LabelRequest {
            text: RichText::math("v_{CB} ⊥ CB"),
            size: 4.0,
            anchor: Point::new(x, 2.0),
            clearance: 1.0,
            prefer: None,
            priority: 0,
        };
        let placed = place(&[request(1.0), request(f64::NAN)], &obstacles);
        assert!(placed.iter().all(|label| label.crowded));
        assert!(place(&[], &obstacles).is_empty());
    }
}
