//! Labels while a mechanism moves: they stay beside their points where they were in the picture before.

use kurbo::{Rect, Vec2};
use std::ops::RangeInclusive;

use super::super::shape::distance_to_box;
use super::moves::square;
use super::places::Spot;
use super::search::{Effort, STRUCK, Search};

/// Least distance from its anchor, beyond the clearance, of a label that stays, in mm: its text may have grown.
const GROWN: f64 = -0.3;
/// Cost of other anchors near a label, in mm, from which it does not stay: it could be taken for another's.
const AMBIGUOUS: f64 = 1.5;
/// Steps in mm in which a label gives way.
const STEP: f64 = 1.0;
/// By so many steps it does so before it looks for a place on another side of its point, and by so many after that.
const LITTLE: RangeInclusive<i32> = 1..=2;
const MUCH: RangeInclusive<i32> = 3..=9;
/// Gain in mm for which a label that stands apart comes back to its point.
const BACK: f64 = 3.0;

impl Search<'_> {
    /// Leaves labels where the middle of their ink was from their anchors in the picture before, if they are clear there,
    /// and finds places for those that are not. A label that had no place takes one that is free, but moves none.
    pub(super) fn hold(&mut self, before: &[Option<Vec2>]) {
        self.effort = Effort::MOVING;
        self.begin();
        let mut order: Vec<usize> = (0..self.labels.len()).filter(|&index| !self.labels[index].is_blank()).collect();
        order.sort_by_key(|&index| (u8::MAX - self.labels[index].priority, index));
        for &index in &order {
            self.labels[index].before = before[index];
            self.keep(index);
        }
        for &index in &order {
            if self.labels[index].chosen.is_none() {
                self.labels[index].is_stuck = !self.make_way(index);
            }
        }
        order.into_iter().for_each(|index| self.come_back(index));
    }

    /// Finds a place for a label that cannot stay: rather a little away from where it was than far.
    fn make_way(&mut self, index: usize) -> bool {
        if self.labels[index].before.is_none() {
            self.begin_label(index);
            return self.choose_cheapest(index);
        }
        if self.give_way(index, LITTLE) {
            return true;
        }
        self.begin_label(index);
        if self.choose_cheapest(index) || self.give_way(index, MUCH) || self.push_others(index) {
            return true;
        }
        self.add_far_places(index);
        self.choose_cheapest(index)
    }

    /// Moves a label a little, over some squares around where it was.
    fn give_way(&mut self, index: usize, squares: RangeInclusive<i32>) -> bool {
        let label = &self.labels[index];
        let Some(offset) = label.before else { return false };
        let (size, bounds, from) = (label.ink.size(), self.obstacles.bounds, label.anchor + offset);
        for ring in squares {
            let mut best: Option<(f64, Spot)> = None;
            for (column, row) in square(ring, [-ring, ring], [-ring, ring]) {
                let ink = Rect::from_center_size(from + Vec2::new(f64::from(column), f64::from(row)) * STEP, size);
                let limit = best.map_or(STRUCK, |(least, _)| least);
                if ink.union(bounds) == bounds {
                    best = self.free_place(index, ink, limit).or(best);
                }
            }
            if let Some((least, place)) = best {
                let label = &mut self.labels[index];
                label.places.push(Spot { least, known: true, ..place });
                let added = label.places.len() - 1;
                self.choose(index, Some(added));
                return true;
            }
        }
        false
    }

    /// Leaves a label where it was, whole or else shorter, if it is clear there.
    fn keep(&mut self, index: usize) {
        let Some(offset) = self.labels[index].before else { return };
        let whole = self.labels[index].ink;
        if let (false, Some(short)) = (self.stays(index, offset), self.labels[index].short) {
            self.labels[index].ink = short;
            let is_short = self.stays(index, offset);
            let label = &mut self.labels[index];
            label.is_short = is_short;
            if is_short { label.short = None } else { label.ink = whole }
        }
    }

    fn stays(&mut self, index: usize, offset: Vec2) -> bool {
        let Some(place) = self.kept_place(index, offset) else { return false };
        self.labels[index].places = vec![place];
        let is_free = self.around(index, 0, 0).blockers.is_empty();
        if is_free {
            self.choose(index, Some(0))
        } else {
            self.labels[index].places.clear()
        }
        is_free
    }

    /// The place where a label was, if nothing but another label is in its way.
    fn kept_place(&self, index: usize, offset: Vec2) -> Option<Spot> {
        let label = &self.labels[index];
        let ink = Rect::from_center_size(label.anchor + offset, label.ink.size());
        let distance = distance_to_box(ink, label.anchor) - label.clearance;
        let bounds = self.obstacles.bounds;
        if distance < GROWN || ink.union(bounds) != bounds || self.is_on_obstacle(ink) || self.is_struck(ink) {
            return None;
        }
        let place = label.place_at(ink, distance.max(0.0), label.dislike_at(offset));
        let ambiguity = self.ambiguity(index, ink);
        let least = place.least + ambiguity + place.leader.map_or(0.0, |leader| self.cost_of_leader(leader));
        (ambiguity < AMBIGUOUS && least < STRUCK).then_some(Spot { least, known: true, ..place })
    }

    /// Moves a label that stands apart beside its point, where there is room again.
    fn come_back(&mut self, index: usize) {
        let label = &self.labels[index];
        let Some(here) = label.chosen.map(|place| label.places[place]).filter(|place| place.leader.is_some()) else {
            return;
        };
        self.begin_label(index);
        if let Some((place, _)) = self.cheapest(index, here.least - BACK) {
            self.choose(index, Some(place));
        }
    }
}
