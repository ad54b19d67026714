//! The search: who takes which place.

use kurbo::{Rect, Vec2};

use super::boxes::{Clipped, gap, inside, touch};
use super::places::{FAR, LABEL_GAP, LINE_GAP, Label, NEAR, OBSTACLE_GAP, Place, SIDES};
use super::{LabelRequest, Obstacles};

// Costs, in mm of distance from the anchor.
/// Of a millimetre of line inside the box.
const CROSSING: f64 = 1.6;
/// Of each millimetre by which another anchor is not clearly farther than the label's own.
const AMBIGUITY: f64 = 2.5;
/// By how much another anchor is clearly farther, in mm.
const CLEARLY: f64 = 0.6;
/// Least gain in mm that makes a label move, so that rounding cannot make two labels swap for ever.
const LEAST_GAIN: f64 = 1e-6;

/// How often all labels may try to move; three or four rounds settle every figure tried.
const ROUNDS: usize = 8;
/// How many labels may be pushed on, one by the other, to make room for one.
const PUSHES: usize = 3;
/// How many such tries one label may make: a bound on time for panels that are simply too full.
const TRIES: usize = 1_000;
/// Step in mm of the last search, over the whole panel.
const LAST_STEP: f64 = 1.5;

/// All labels and where they stand so far.
pub(super) struct Search<'a> {
    pub(super) labels: Vec<Label>,
    lines: Vec<Clipped>,
    obstacles: &'a Obstacles,
}

impl<'a> Search<'a> {
    pub(super) fn new(requests: &[LabelRequest], obstacles: &'a Obstacles) -> Self {
        let lines = obstacles.lines.iter().copied().map(Clipped::new).collect();
        let labels: Vec<Label> = requests.iter().map(Label::new).collect();
        let mut search = Self {
            labels,
            lines,
            obstacles,
        };
        for index in 0..search.labels.len() {
            search.survey(index);
            search.add_places(index, &NEAR);
        }
        search
    }

    /// Finds what the places of a label could touch.
    fn survey(&mut self, index: usize) {
        let (reach, anchor) = (self.labels[index].reach, self.labels[index].anchor);
        let near = self
            .lines
            .iter()
            .filter(|line| line.share_inside(reach) > 0.0);
        let lines = near.copied().collect();
        let others = self.labels.iter().map(|other| other.anchor);
        // Labels of one point do not compete for it.
        let anchors = others
            .filter(|&other| inside(reach, other) && (other - anchor).hypot2() > 1e-6)
            .collect();
        let touching = |other: &Label| touch(other.reach, reach, LABEL_GAP);
        let neighbours = (0..self.labels.len())
            .filter(|&other| other != index && touching(&self.labels[other]))
            .collect();
        let label = &mut self.labels[index];
        (label.lines, label.anchors, label.neighbours) = (lines, anchors, neighbours);
    }

    /// Adds the free places of a label at some distances.
    fn add_places(&mut self, index: usize, distances: &[f64]) {
        let label = &self.labels[index];
        let bounds = self.obstacles.bounds;
        let reach = label.reach;
        let boxes: Vec<Rect> = self
            .obstacles
            .boxes
            .iter()
            .copied()
            .filter(|&other| touch(other, reach, OBSTACLE_GAP))
            .collect();
        let free = |ink: Rect| {
            ink.x0 >= bounds.x0
                && ink.x1 <= bounds.x1
                && ink.y0 >= bounds.y0
                && ink.y1 <= bounds.y1
                && !boxes.iter().any(|&other| touch(other, ink, OBSTACLE_GAP))
        };
        let dislikes = label.dislikes();
        let mut places = Vec::with_capacity(distances.len() * SIDES.len());
        for &distance in distances {
            for (side, dislike) in SIDES.iter().zip(dislikes) {
                let ink = label.ink_beside(side, label.clearance + distance);
                if free(ink) {
                    places.push(label.place_at(ink, distance, dislike));
                }
            }
        }
        self.labels[index].places.append(&mut places);
    }

    /// Gives a label places farther off, with leaders.
    fn add_far_places(&mut self, index: usize) {
        let label = &mut self.labels[index];
        if label.has_far {
            return;
        }
        label.has_far = true;
        label.reach = label.reach_at(FAR[FAR.len() - 1]);
        self.survey(index);
        for other in self.labels[index].neighbours.clone() {
            let neighbours = &mut self.labels[other].neighbours;
            if let Err(position) = neighbours.binary_search(&index) {
                neighbours.insert(position, index);
            }
        }
        // The near places keep their costs: what the wider survey adds is beyond them.
        self.add_places(index, &FAR);
    }

    /// The whole cost of a place if it is less than `limit`.
    fn cost_below(&mut self, index: usize, place: usize, limit: f64) -> Option<f64> {
        let label = &mut self.labels[index];
        let Place {
            ink,
            mut least,
            known,
            leader,
        } = label.places[place];
        if known || least >= limit {
            return (least < limit).then_some(least);
        }
        // Parts are added up until they pass the limit; the sum so far is then a better lower bound
        // for the next time.
        let mut whole = true;
        let own = gap(ink, label.anchor);
        for &other in &label.anchors {
            least += AMBIGUITY * (own + CLEARLY - gap(ink, other)).max(0.0);
        }
        let area = ink.inflate(LINE_GAP, LINE_GAP);
        for line in &label.lines {
            least += CROSSING * line.share_inside(area) * line.length;
            if least >= limit {
                whole = false;
                break;
            }
        }
        if whole && let Some(leader) = leader {
            let leader = Clipped::new(leader);
            for &other in &self.obstacles.boxes {
                least += CROSSING * leader.share_inside(other) * leader.length;
            }
        }
        let place = &mut label.places[place];
        if whole {
            place.least = least;
            place.known = true;
        } else {
            place.least = place.least.max(least);
        }
        (least < limit).then_some(least)
    }

    /// The whole cost of a place.
    fn cost(&mut self, index: usize, place: usize) -> f64 {
        self.cost_below(index, place, f64::INFINITY)
            .unwrap_or(f64::INFINITY)
    }

    /// The labels in the way of a place, up to `most` of them; none in the list means that the
    /// place can be taken.
    fn blockers(&self, index: usize, place: usize, most: usize) -> ([usize; 2], usize) {
        let (mut found, mut count) = ([usize::MAX; 2], 0);
        let wanted = &self.labels[index].places[place];
        for &other in &self.labels[index].neighbours {
            let label = &self.labels[other];
            if let Some(chosen) = label.chosen
                && wanted.conflicts(&label.places[chosen])
            {
                if count < found.len() {
                    found[count] = other;
                }
                count += 1;
                if count > most {
                    break;
                }
            }
        }
        (found, count)
    }

    /// The cheapest place of a label that no other label is in the way of, if it costs less than
    /// `limit`.
    fn cheapest(&mut self, index: usize, limit: f64) -> Option<(usize, f64)> {
        let mut best = None;
        let mut limit = limit;
        for place in 0..self.labels[index].places.len() {
            if self.labels[index].places[place].least >= limit
                || self.blockers(index, place, 0).1 > 0
            {
                continue;
            }
            if let Some(cost) = self.cost_below(index, place, limit) {
                limit = cost;
                best = Some((place, cost));
            }
        }
        best
    }

    /// Every label takes its cheapest place, those with the least choice first.
    pub(super) fn choose_first(&mut self, requests: &[LabelRequest]) {
        let mut order: Vec<usize> = (0..requests.len()).collect();
        order.sort_by_key(|&index| {
            (
                u8::MAX - requests[index].priority,
                self.labels[index].places.len(),
                index,
            )
        });
        for index in order {
            self.labels[index].chosen = self.cheapest(index, f64::INFINITY).map(|(place, _)| place);
        }
    }

    /// Labels without a place push others aside, else go far off.
    pub(super) fn make_room(&mut self) {
        for index in 0..self.labels.len() {
            if self.labels[index].chosen.is_some() || self.labels[index].is_blank() {
                continue;
            }
            let mut tries = TRIES;
            if self.push(index, PUSHES, &mut Vec::new(), &mut tries) {
                continue;
            }
            self.add_far_places(index);
            self.labels[index].chosen = self.cheapest(index, f64::INFINITY).map(|(place, _)| place);
            if self.labels[index].chosen.is_none() {
                let mut tries = TRIES;
                self.push(index, PUSHES, &mut Vec::new(), &mut tries);
            }
        }
    }

    /// Finds a place for a label by moving at most two others, which may move others in turn;
    /// changes nothing if it fails.
    fn push(
        &mut self,
        index: usize,
        depth: usize,
        fixed: &mut Vec<usize>,
        tries: &mut usize,
    ) -> bool {
        if let Some((place, _)) = self.cheapest(index, f64::INFINITY) {
            self.labels[index].chosen = Some(place);
            return true;
        }
        if depth == 0 {
            return false;
        }
        fixed.push(index);
        let mut order: Vec<(f64, usize)> = (0..self.labels[index].places.len())
            .map(|place| (self.cost(index, place), place))
            .collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (_, place) in order {
            let (others, count) = self.blockers(index, place, 2);
            let others = &others[..count.min(2)];
            if count > 2 || *tries == 0 || others.iter().any(|other| fixed.contains(other)) {
                continue;
            }
            *tries -= 1;
            let before: Vec<Option<usize>> = self.labels.iter().map(|label| label.chosen).collect();
            self.labels[index].chosen = Some(place);
            for &other in others {
                self.labels[other].chosen = None;
            }
            if others
                .iter()
                .all(|&other| self.push(other, depth - 1, fixed, tries))
            {
                fixed.pop();
                return true;
            }
            for (label, chosen) in self.labels.iter_mut().zip(before) {
                label.chosen = chosen;
            }
        }
        fixed.pop();
        false
    }

    /// Labels move, alone or with the one in the way, while that makes the sum of the costs
    /// smaller.
    pub(super) fn improve(&mut self) {
        for _ in 0..ROUNDS {
            let mut moved = false;
            for index in 0..self.labels.len() {
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
        // The greatest gain so far, and the moves that bring it.
        let mut gain = LEAST_GAIN;
        let mut best: Option<(usize, Option<(usize, usize)>)> = None;
        for place in 0..self.labels[index].places.len() {
            let Some(cost) = self.cost_below(index, place, cost_here - gain) else {
                continue;
            };
            let own_gain = cost_here - cost;
            if own_gain <= gain {
                continue;
            }
            match self.blockers(index, place, 1) {
                (_, 0) => {
                    gain = own_gain;
                    best = Some((place, None));
                }
                ([other, _], 1) => {
                    let Some(others_place) = self.labels[other].chosen else {
                        continue;
                    };
                    let others_cost = self.cost(other, others_place);
                    self.labels[index].chosen = Some(place);
                    if let Some((there, cost)) = self.cheapest(other, others_cost + own_gain - gain)
                    {
                        gain = own_gain + others_cost - cost;
                        best = Some((place, Some((other, there))));
                    }
                    self.labels[index].chosen = Some(here);
                }
                _ => {}
            }
        }
        let Some((place, pushed)) = best else {
            return false;
        };
        self.labels[index].chosen = Some(place);
        if let Some((other, there)) = pushed {
            self.labels[other].chosen = Some(there);
        }
        true
    }

    /// The last resort: the free place nearest to the anchor anywhere on the panel.
    pub(super) fn look_everywhere(&mut self) {
        for index in 0..self.labels.len() {
            let label = &self.labels[index];
            if label.chosen.is_some() || label.is_blank() {
                continue;
            }
            let (bounds, size) = (self.obstacles.bounds, label.ink.size());
            let steps = |room: f64| {
                if room >= 0.0 {
                    (room / LAST_STEP).min(1000.0) as usize + 1
                } else {
                    0
                }
            };
            let mut best: Option<(f64, Place)> = None;
            for row in 0..steps(bounds.height() - size.height) {
                for column in 0..steps(bounds.width() - size.width) {
                    let corner = bounds.origin() + Vec2::new(column as f64, row as f64) * LAST_STEP;
                    let ink = Rect::from_origin_size(corner, size);
                    let distance = gap(ink, label.anchor) - label.clearance;
                    if distance < 0.0 || best.is_some_and(|(least, _)| distance >= least) {
                        continue;
                    }
                    let place = label.place_at(ink, distance, 0.0);
                    let blocked = self
                        .obstacles
                        .boxes
                        .iter()
                        .any(|&other| touch(other, ink, OBSTACLE_GAP))
                        || self.labels.iter().any(|other| {
                            other
                                .chosen
                                .is_some_and(|chosen| place.conflicts(&other.places[chosen]))
                        });
                    if !blocked {
                        best = Some((distance, place));
                    }
                }
            }
            if let Some((_, place)) = best {
                let label = &mut self.labels[index];
                label.chosen = Some(label.places.len());
                label.places.push(place);
            }
        }
    }

    /// A place for a label that has none: inside the panel, covering as little as possible.
    pub(super) fn least_bad(&self, index: usize) -> Place {
        let label = &self.labels[index];
        let bounds = self.obstacles.bounds;
        let covered = |ink: Rect| {
            let taken = self
                .labels
                .iter()
                .filter_map(|other| other.chosen.map(|chosen| other.places[chosen].ink));
            let all = taken.chain(self.obstacles.boxes.iter().copied());
            all.map(|other| {
                let both = other.intersect(ink);
                both.width().max(0.0) * both.height().max(0.0)
            })
            .sum::<f64>()
        };
        let mut best: Option<(f64, Rect)> = None;
        for side in &SIDES {
            let ink = label.ink_beside(side, label.clearance);
            // Back into the panel; the left and upper edges win where it is too small.
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
        Place {
            ink,
            least: 0.0,
            known: false,
            leader: None,
        }
    }
}
