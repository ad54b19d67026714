//! The search for the labels' places.

use kurbo::{Rect, Vec2};

use super::super::shape::distance_to_box;
use super::places::Spot;
use super::search::{Effort, STRUCK, Search};

/// Least gain in mm that makes a label move, so that rounding cannot make two labels swap for ever.
const LEAST_GAIN: f64 = 1e-6;

/// Most rounds in which all labels may move; three or four are enough for every figure tried.
const ROUNDS: usize = 8;
/// Cost of a leader that crosses another one, in mm of distance.
const CROSSED: f64 = 30.0;
/// Grid of the search over the whole panel, in mm.
const STEP: f64 = 1.5;

/// Labels that may look in vain for a place apart once a stage has looked at enough things: on a panel that full those after
/// them find none either.
const IN_VAIN: usize = 200;

/// What is moved to make room.
#[derive(Default)]
struct Pushed {
    /// Labels that must not move now.
    fixed: Vec<usize>,
    /// Labels that were moved, with their places before, to take it back.
    moved: Vec<(usize, Option<usize>)>,
}

impl Search<'_> {
    /// Finds places for all labels anew.
    pub(super) fn choose_all(&mut self) {
        (0..self.labels.len()).for_each(|index| self.begin_label(index));
        self.choose_first();
        self.settle();
        self.improve();
        self.settle();
    }

    /// Assigns to every label its cheapest clear place; labels with fewest places first.
    fn choose_first(&mut self) {
        let mut order: Vec<usize> = (0..self.labels.len()).collect();
        order.sort_by_key(|&index| {
            let label = &self.labels[index];
            (u8::MAX - label.priority, label.places.len(), index)
        });
        for index in order {
            self.choose_cheapest(index);
        }
    }

    pub(super) fn choose_cheapest(&mut self, index: usize) -> bool {
        let place = self.cheapest(index, STRUCK).map(|(place, _)| place);
        self.choose(index, place);
        place.is_some()
    }

    /// Finds clear places for labels that have none: others move, or the label stands apart with a leader, as near as it
    /// can. A label for which nothing has been found before only takes a place that has become free.
    pub(super) fn settle(&mut self) {
        self.begin();
        let mut order: Vec<usize> = (0..self.labels.len()).collect();
        order.sort_by_key(|&index| (u8::MAX - self.labels[index].priority, index));
        let mut in_vain = 0;
        for index in order {
            if self.labels[index].is_blank() || self.labels[index].chosen.is_some() {
                continue;
            }
            let is_settled = match self.labels[index].is_stuck {
                true => self.choose_cheapest(index),
                false if in_vain >= IN_VAIN && self.is_enough() => false,
                false => self.push_others(index) || self.stand_apart(index),
            };
            in_vain += usize::from(!is_settled);
            self.labels[index].is_stuck = !is_settled;
        }
    }

    /// Sets labels without a place shorter, if they may be, and finds places for these.
    pub(super) fn shorten(&mut self) {
        let mut is_shorter = false;
        for index in 0..self.labels.len() {
            let label = &mut self.labels[index];
            if let Some(ink) = label.short.take_if(|_| label.chosen.is_none()) {
                (label.ink, label.is_short, label.is_stuck) = (ink, true, false);
                (label.has_near, label.has_far) = (false, false);
                label.places.clear();
                self.begin_label(index);
                is_shorter = true;
            }
        }
        if is_shorter {
            self.settle();
        }
    }

    /// Gives a label a clear place with a leader, if it may have one.
    pub(super) fn stand_apart(&mut self, index: usize) -> bool {
        if !self.labels[index].may_stand_apart {
            return false;
        }
        self.add_far_places(index);
        self.choose_cheapest(index) || self.push_others(index) || self.search_panel(index)
    }

    /// Finds a clear place for a label by moving others, while there is time for it.
    pub(super) fn push_others(&mut self, index: usize) -> bool {
        let Effort { pushes, mut tries } =
            if self.labels[index].may_stand_apart { self.effort } else { Effort::LITTLE };
        !self.is_enough() && self.push(index, pushes, &mut Pushed::default(), &mut tries)
    }

    /// Finds a clear place for a label by moving at most two others, which may move others in turn; changes nothing if
    /// that fails.
    fn push(&mut self, index: usize, depth: usize, pushed: &mut Pushed, tries: &mut usize) -> bool {
        self.begin_label(index);
        if let Some((place, _)) = self.cheapest(index, STRUCK) {
            pushed.moved.push((index, self.labels[index].chosen));
            self.choose(index, Some(place));
            return true;
        }
        if depth == 0 {
            return false;
        }
        pushed.fixed.push(index);
        let places = 0..self.labels[index].places.len();
        let costs = places.filter_map(|place| Some((self.cost_below(index, place, STRUCK)?, place)));
        let mut order: Vec<(f64, usize)> = costs.collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (_, place) in order {
            if *tries == 0 || self.is_enough() {
                break;
            }
            if self.is_still_blocked(index, place, 2) {
                continue;
            }
            let others = self.around(index, place, 2).blockers;
            if others.len() > 2 || others.iter().any(|other| pushed.fixed.contains(other)) {
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
    fn improve(&mut self) {
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
        let cost_here = self.cost(index, here) + self.around(index, here, 0).closeness;
        // The largest gain so far, and its moves.
        let mut gain = LEAST_GAIN;
        let mut best: Option<(usize, Option<(usize, usize)>)> = None;
        for place in 0..self.labels[index].places.len() {
            let Some(cost) = self.cost_below(index, place, cost_here - gain) else {
                continue;
            };
            if self.is_still_blocked(index, place, 1) {
                continue;
            }
            let around = self.around(index, place, 1);
            let gain_here = cost_here - cost - around.closeness;
            if gain_here <= gain {
                continue;
            }
            match *around.blockers {
                [] => {
                    gain = gain_here;
                    best = Some((place, None));
                }
                [other] => {
                    let Some(others_place) = self.labels[other].chosen else {
                        continue;
                    };
                    // What each of the two costs the other counts once.
                    let between = self.labels[index].places[here].closeness(&self.labels[other].places[others_place]);
                    let others_cost =
                        self.cost(other, others_place) + self.around(other, others_place, 0).closeness - between;
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

    /// Gives a label the clear place nearest to its anchor anywhere on the panel: a search in growing squares around the
    /// anchor.
    fn search_panel(&mut self, index: usize) -> bool {
        let label = &self.labels[index];
        let (bounds, size, anchor) = (self.obstacles.bounds, label.ink.size(), label.anchor);
        // The middles of ink within the panel, in steps from the anchor.
        let steps = |low: f64, high: f64| [(low / STEP).ceil(), (high / STEP).floor()].map(|step| step as i32);
        let columns = steps(bounds.x0 + 0.5 * size.width - anchor.x, bounds.x1 - 0.5 * size.width - anchor.x);
        let rows = steps(bounds.y0 + 0.5 * size.height - anchor.y, bounds.y1 - 0.5 * size.height - anchor.y);
        let most = [columns, rows].as_flattened().iter().map(|step| step.saturating_abs()).max().unwrap_or(0);
        let mut best: Option<(f64, Spot)> = None;
        for ring in 1..=most.min(1000) {
            let nearest = f64::from(ring) * STEP - 0.5 * size.width.max(size.height) - label.clearance;
            if best.is_some_and(|(least, _)| nearest >= least) || self.is_enough() {
                break;
            }
            for (column, row) in square(ring, columns, rows) {
                let center = anchor + Vec2::new(f64::from(column), f64::from(row)) * STEP;
                let ink = Rect::from_center_size(center, size);
                let limit = best.map_or(f64::INFINITY, |(least, _)| least);
                if self.is_ruled_out(ink) {
                    continue;
                }
                if let Some((worth, place)) = self.free_place(index, ink, limit) {
                    best = Some((worth, place));
                }
            }
        }
        let Some((worth, place)) = best else {
            return false;
        };
        let label = &mut self.labels[index];
        label.places.push(Spot { least: worth, known: true, ..place });
        let added = label.places.len() - 1;
        self.choose(index, Some(added));
        true
    }

    /// A place for this ink apart from the anchor, if it is clear and costs less than `limit`, with its cost.
    pub(super) fn free_place(&self, index: usize, ink: Rect, limit: f64) -> Option<(f64, Spot)> {
        let label = &self.labels[index];
        let distance = distance_to_box(ink, label.anchor) - label.clearance;
        if distance < 0.0 || distance >= limit {
            return None;
        }
        self.count(1);
        if self.is_on_obstacle(ink) || self.is_struck(ink) {
            return None;
        }
        let place = label.place_at(ink, distance, 0.0);
        let mut worth = place.least + self.ambiguity(index, ink);
        if worth >= limit {
            return None;
        }
        self.look_around(index, place.surroundings(), |_, spot| {
            let is_free = !place.conflicts(spot);
            worth += place.closeness(spot) + if place.crosses(spot) { CROSSED } else { 0.0 };
            worth = if is_free { worth } else { f64::INFINITY };
            worth >= limit
        });
        if worth >= limit {
            return None;
        }
        worth += place.leader.map_or(0.0, |leader| self.cost_of_leader(leader));
        (worth < limit.min(STRUCK)).then_some((worth, place))
    }
}

/// The steps to the places on the sides of a square, as far as they lie between two columns and two rows.
pub(super) fn square(ring: i32, columns: [i32; 2], rows: [i32; 2]) -> impl Iterator<Item = (i32, i32)> {
    let is_between = |[low, high]: [i32; 2], step: i32| low <= step && step <= high;
    let across = move |row: i32| {
        let within = columns[0].max(-ring)..=columns[1].min(ring);
        within.filter(move |_| is_between(rows, row)).map(move |column| (column, row))
    };
    let down = move |column: i32| {
        let within = rows[0].max(1 - ring)..=rows[1].min(ring - 1);
        within.filter(move |_| is_between(columns, column)).map(move |row| (column, row))
    };
    across(-ring).chain(across(ring)).chain(down(-ring)).chain(down(ring))
}
