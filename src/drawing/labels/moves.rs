//! The search for the labels' places.

use kurbo::{Rect, Vec2};

use super::super::shape::distance_to_box;
use super::places::{LINE_GAP, LabelRequest, SIDES, Spot};
use super::search::{Effort, Search};

/// Least gain in mm that makes a label move, so that rounding cannot make two labels swap for ever.
const LEAST_GAIN: f64 = 1e-6;

/// Most rounds in which all labels may move; three or four are enough for every figure tried.
const ROUNDS: usize = 8;
/// Cost of a place, as where a line strikes through the label, above which one with a leader may be better.
const STRUCK: f64 = 5.0;
/// By how much such a place may cost more.
const APART: f64 = 4.0;
/// Cost of a leader that crosses another label or its leader, in mm of distance.
const CROSSED: f64 = 30.0;
/// Grid of the last search over the whole panel, in mm.
const LAST_STEP: f64 = 1.5;

/// What is moved to make room.
#[derive(Default)]
struct Pushed {
    /// Labels that must not move now.
    fixed: Vec<usize>,
    /// Labels that were moved, with their places before, to take it back.
    moved: Vec<(usize, Option<usize>)>,
}

impl Search<'_> {
    /// Assigns to every label its cheapest place; labels with fewest places first.
    pub(super) fn choose_first(&mut self, requests: &[LabelRequest]) {
        let mut order: Vec<usize> = (0..requests.len()).collect();
        order.sort_by_key(|&index| {
            let label = &self.labels[index];
            (label.before.is_none(), u8::MAX - requests[index].priority, label.places.len(), index)
        });
        for index in order {
            self.choose_cheapest(index);
        }
    }

    fn choose_cheapest(&mut self, index: usize) {
        let place = self.cheapest(index, f64::INFINITY).map(|(place, _)| place);
        self.choose(index, place);
    }

    /// Makes room for labels without a place: others move, or the label gets a place far from its anchor.
    pub(super) fn make_room(&mut self) {
        self.begin();
        for index in 0..self.labels.len() {
            if self.labels[index].chosen.is_some() || self.labels[index].is_blank() {
                continue;
            }
            // Without time for pushing there are still places farther away.
            if self.push_others(index) {
                continue;
            }
            self.add_far_places(index);
            self.choose_cheapest(index);
            if self.labels[index].chosen.is_none() {
                self.push_others(index);
            }
        }
    }

    /// Finds a place for a label by moving others, while there is time for it.
    fn push_others(&mut self, index: usize) -> bool {
        let Effort { pushes, mut tries } = self.effort;
        !self.is_enough() && self.push(index, pushes, &mut Pushed::default(), &mut tries)
    }

    /// Gives labels that lines strike through a place with a leader, where that is better.
    pub(super) fn free_struck(&mut self) {
        self.begin();
        for index in 0..self.labels.len() {
            if self.is_enough() {
                return;
            }
            let Some(chosen) = self.labels[index].chosen else { continue };
            let cost = self.cost(index, chosen);
            if cost > STRUCK {
                self.add_far_places(index);
                let places = 0..self.labels[index].places.len();
                let is_clear = |place: &usize| {
                    !self.is_struck(self.labels[index].places[*place].ink) && self.blockers(index, *place, 0).1 == 0
                };
                let clear: Vec<usize> = places.filter(is_clear).collect();
                let costs = clear.into_iter().map(|place| (self.cost(index, place), place));
                let best = costs.min_by(|a, b| a.0.total_cmp(&b.0));
                if let Some((_, place)) = best.filter(|(least, _)| *least < cost + APART) {
                    self.choose(index, Some(place));
                }
            }
        }
    }

    /// Finds a place for a label by moving at most two others, which may move others in turn; changes nothing if that
    /// fails.
    fn push(&mut self, index: usize, depth: usize, pushed: &mut Pushed, tries: &mut usize) -> bool {
        if let Some((place, _)) = self.cheapest(index, f64::INFINITY) {
            pushed.moved.push((index, self.labels[index].chosen));
            self.choose(index, Some(place));
            return true;
        }
        if depth == 0 {
            return false;
        }
        pushed.fixed.push(index);
        let mut order: Vec<(f64, usize)> =
            (0..self.labels[index].places.len()).map(|place| (self.cost(index, place), place)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (_, place) in order {
            if self.is_enough() {
                break;
            }
            let (others, count) = self.blockers(index, place, 2);
            let others = &others[..count.min(2)];
            if count > 2 || *tries == 0 || others.iter().any(|other| pushed.fixed.contains(other)) {
                continue;
            }
            *tries -= 1;
            let before = pushed.moved.len();
            for (label, chosen) in
                std::iter::once((index, Some(place))).chain(others.iter().map(|&other| (other, None)))
            {
                pushed.moved.push((label, self.labels[label].chosen));
                self.choose(label, chosen);
            }
            if others.iter().all(|&other| self.push(other, depth - 1, pushed, tries)) {
                pushed.fixed.pop();
                return true;
            }
            while pushed.moved.len() > before {
                let Some((label, chosen)) = pushed.moved.pop() else { break };
                self.choose(label, chosen);
            }
        }
        pushed.fixed.pop();
        false
    }

    /// Moves labels, alone or with the one in the way, as long as the sum of the costs decreases.
    pub(super) fn improve(&mut self) {
        self.begin();
        for _ in 0..ROUNDS {
            let mut moved = false;
            for index in 0..self.labels.len() {
                if self.is_enough() {
                    return;
                }
                moved |= self.improve_one(index);
            }
            if !moved {
                return;
            }
        }
    }

    fn improve_one(&mut self, index: usize) -> bool {
        let Some(here) = self.labels[index].chosen else {
            return false;
        };
        let cost_here = self.cost(index, here);
        // The largest gain so far, and its moves.
        let mut gain = LEAST_GAIN;
        let mut best: Option<(usize, Option<(usize, usize)>)> = None;
        for place in 0..self.labels[index].places.len() {
            let Some(cost) = self.cost_below(index, place, cost_here - gain) else {
                continue;
            };
            let gain_here = cost_here - cost;
            if gain_here <= gain {
                continue;
            }
            match self.blockers(index, place, 1) {
                (_, 0) => {
                    gain = gain_here;
                    best = Some((place, None));
                }
                ([other, _], 1) => {
                    let Some(others_place) = self.labels[other].chosen else {
                        continue;
                    };
                    let others_cost = self.cost(other, others_place);
                    self.choose(index, Some(place));
                    if let Some((there, cost)) = self.cheapest(other, others_cost + gain_here - gain) {
                        gain = gain_here + others_cost - cost;
                        best = Some((place, Some((other, there))));
                    }
                    self.choose(index, Some(here));
                }
                _ => {}
            }
        }
        let Some((place, pushed)) = best else {
            return false;
        };
        self.choose(index, Some(place));
        if let Some((other, there)) = pushed {
            self.choose(other, Some(there));
        }
        true
    }

    /// Assigns to labels still without a place the free place nearest to the anchor anywhere on the panel. Its leader
    /// may cross others; that counts as additional distance.
    pub(super) fn search_panel(&mut self) {
        self.begin();
        for index in 0..self.labels.len() {
            if self.is_cut_short.get() || self.is_enough() {
                return;
            }
            let label = &self.labels[index];
            if label.chosen.is_some() || label.is_blank() {
                continue;
            }
            let (bounds, size) = (self.obstacles.bounds, label.ink.size());
            let steps = |room: f64| {
                if room >= 0.0 { (room / LAST_STEP).min(1000.0) as usize + 1 } else { 0 }
            };
            let mut best: Option<(f64, Spot)> = None;
            for row in 0..steps(bounds.height() - size.height) {
                if self.is_enough() {
                    break;
                }
                for column in 0..steps(bounds.width() - size.width) {
                    let corner = bounds.origin() + Vec2::new(column as f64, row as f64) * LAST_STEP;
                    let ink = Rect::from_origin_size(corner, size);
                    let distance = distance_to_box(ink, label.anchor) - label.clearance;
                    self.count(1);
                    if distance < 0.0 || best.is_some_and(|(least, _)| distance >= least) {
                        continue;
                    }
                    let place = label.place_at(ink, distance, 0.0);
                    if self.is_on_obstacle(ink) || self.is_overlapped(&place) {
                        continue;
                    }
                    let near = self.chosen_near(place.area().inflate(LINE_GAP, LINE_GAP));
                    let crossings: usize = near.map(|other| place.crossings(other)).sum();
                    let worth = distance + CROSSED * crossings as f64;
                    if best.is_none_or(|(least, _)| worth < least) {
                        best = Some((worth, place));
                    }
                }
            }
            if let Some((_, place)) = best {
                let label = &mut self.labels[index];
                let added = label.places.len();
                label.places.push(place);
                self.choose(index, Some(added));
            }
        }
    }

    /// A place inside the panel for a label without one, which covers as little as possible.
    pub(super) fn least_covering(&self, index: usize) -> Spot {
        let label = &self.labels[index];
        let bounds = self.obstacles.bounds;
        let covered = |ink: Rect| {
            let all = self.chosen_near(ink).map(|other| other.ink).chain(self.obstacles.boxes_near(ink));
            all.map(|other| {
                let both = other.intersect(ink);
                both.width().max(0.0) * both.height().max(0.0)
            })
            .sum::<f64>()
        };
        let mut best: Option<(f64, Rect)> = None;
        for side in &SIDES {
            let ink = label.ink_beside(side, label.clearance);
            // Moved into the panel; where it is too small, against its left and upper edges.
            let back = Vec2::new(
                (bounds.x1 - ink.x1).min(0.0).max(bounds.x0 - ink.x0),
                (bounds.y1 - ink.y1).min(0.0).max(bounds.y0 - ink.y0),
            );
            let ink = ink + back;
            let hidden = covered(ink);
            if best.is_none_or(|(least, _)| hidden < least) {
                best = Some((hidden, ink));
            }
        }
        let ink = best.map_or(label.ink + label.anchor.to_vec2(), |(_, ink)| ink);
        Spot { ink, least: 0.0, known: false, leader: None }
    }
}
