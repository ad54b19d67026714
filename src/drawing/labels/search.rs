//! The labels of a panel, their free places, and the cost of each place.

use kurbo::Rect;

use super::boxes::{Clipped, gap, inside, touch};
use super::places::{FAR, LABEL_GAP, LINE_GAP, Label, NEAR, OBSTACLE_GAP, Place, SIDES};
use super::request::{LabelRequest, Obstacles};

// Costs, in mm of distance from the anchor.
/// Per millimetre of line inside the box.
const CROSSING: f64 = 1.6;
/// Per millimetre by which another anchor is not clearly farther than the label's own.
const AMBIGUITY: f64 = 2.5;
/// Difference from which another anchor is clearly farther, in mm.
const CLEARLY: f64 = 0.6;

/// All labels with their present places.
pub(super) struct Search<'a> {
    pub(super) labels: Vec<Label>,
    lines: Vec<Clipped>,
    pub(super) obstacles: &'a Obstacles,
}

impl<'a> Search<'a> {
    pub(super) fn new(requests: &[LabelRequest], obstacles: &'a Obstacles) -> Self {
        let lines = obstacles.lines.iter().copied().map(Clipped::new).collect();
        let labels: Vec<Label> = requests.iter().map(Label::new).collect();
        let mut search = Self { labels, lines, obstacles };
        for index in 0..search.labels.len() {
            search.find_surroundings(index);
            search.add_places(index, &NEAR);
        }
        search
    }

    /// Finds the lines, anchors and labels that the places of a label could touch.
    fn find_surroundings(&mut self, index: usize) {
        let (reach, anchor) = (self.labels[index].reach, self.labels[index].anchor);
        let near = self.lines.iter().filter(|line| line.share_inside(reach) > 0.0);
        let lines = near.copied().collect();
        let others = self.labels.iter().map(|other| other.anchor);
        // Labels of the same point do not compete for it.
        let anchors = others.filter(|&other| inside(reach, other) && (other - anchor).hypot2() > 1e-6).collect();
        let touching = |other: &Label| touch(other.reach, reach, LABEL_GAP);
        let neighbours =
            (0..self.labels.len()).filter(|&other| other != index && touching(&self.labels[other])).collect();
        let label = &mut self.labels[index];
        (label.lines, label.anchors, label.neighbours) = (lines, anchors, neighbours);
    }

    /// Adds the free places of a label at these distances.
    fn add_places(&mut self, index: usize, distances: &[f64]) {
        let label = &self.labels[index];
        let bounds = self.obstacles.bounds;
        let reach = label.reach;
        let boxes: Vec<Rect> =
            self.obstacles.boxes.iter().copied().filter(|&other| touch(other, reach, OBSTACLE_GAP)).collect();
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

    /// Adds the distant places of a label, with leaders.
    pub(super) fn add_far_places(&mut self, index: usize) {
        let label = &mut self.labels[index];
        if label.has_far {
            return;
        }
        label.has_far = true;
        label.reach = label.reach_at(FAR[FAR.len() - 1]);
        self.find_surroundings(index);
        for other in self.labels[index].neighbours.clone() {
            let neighbours = &mut self.labels[other].neighbours;
            if let Err(position) = neighbours.binary_search(&index) {
                neighbours.insert(position, index);
            }
        }
        // The costs of near places remain: the added lines and anchors are beyond them.
        self.add_places(index, &FAR);
    }

    /// Length of the lines inside a box, in mm.
    pub(super) fn struck(&self, ink: Rect) -> f64 {
        self.lines.iter().map(|line| line.share_inside(ink) * line.length).sum()
    }

    /// The whole cost of a place if it is less than `limit`.
    pub(super) fn cost_below(&mut self, index: usize, place: usize, limit: f64) -> Option<f64> {
        let label = &mut self.labels[index];
        let Place { ink, mut least, known, leader } = label.places[place];
        if known || least >= limit {
            return (least < limit).then_some(least);
        }
        // Summation stops at the limit; the sum is then a better lower bound for the next time.
        let mut whole = true;
        let own_gap = gap(ink, label.anchor);
        for &other in &label.anchors {
            least += AMBIGUITY * (own_gap + CLEARLY - gap(ink, other)).max(0.0);
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
    pub(super) fn cost(&mut self, index: usize, place: usize) -> f64 {
        self.cost_below(index, place, f64::INFINITY).unwrap_or(f64::INFINITY)
    }

    /// The labels in the way of a place, two at most, and their number, at most one above `most`; zero means that the
    /// place can be taken.
    pub(super) fn blockers(&self, index: usize, place: usize, most: usize) -> ([usize; 2], usize) {
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

    /// The cheapest place of a label without another label in the way, if it costs less than `limit`.
    pub(super) fn cheapest(&mut self, index: usize, limit: f64) -> Option<(usize, f64)> {
        let mut best = None;
        let mut limit = limit;
        for place in 0..self.labels[index].places.len() {
            if self.labels[index].places[place].least >= limit || self.blockers(index, place, 0).1 > 0 {
                continue;
            }
            if let Some(cost) = self.cost_below(index, place, limit) {
                limit = cost;
                best = Some((place, cost));
            }
        }
        best
    }
}
