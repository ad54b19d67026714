//! The labels of a panel, their free places, and the cost of each place.

use kurbo::{Point, Rect};
use smallvec::SmallVec;
use std::cell::{Cell, OnceCell};

use super::super::grid::{BOX_GAP, Grid, Obstacles};
use super::super::shape::{crosses_line, distance_to_box};
use super::blocked::Blocked;
use super::places::{Clipped, FAR, LINE_GAP, Label, LabelRequest, NEAR, SIDES, Spot, inside};

// Costs, in mm of distance from the anchor.
/// Of a place that a line strikes through: more than that of any clear place on a sheet.
pub(super) const STRUCK: f64 = 1000.0;
/// Per millimetre of line near the ink.
const CROSSING: f64 = 1.6;
/// Of a leader for each line that it crosses, and for each joint or arrowhead.
const ACROSS: [f64; 2] = [0.7, 6.0];
/// Per millimetre by which another anchor is not clearly farther than the label's own.
const AMBIGUITY: f64 = 2.5;
/// Difference from which another anchor is clearly farther, in mm.
const CLEARLY: f64 = 0.6;

/// Most lines, and most other anchors, that count for a label: among more it cannot be read anyway.
const MOST_AROUND: usize = 400;

/// How many things each stage of a search may look at: far more than a figure of a textbook needs, and less than a tenth
/// of a second.
const ENOUGH: usize = 200_000;

/// How much is tried to find places for all labels.
#[derive(Clone, Copy)]
pub(super) struct Effort {
    /// Longest chain of labels that make room for one another.
    pub(super) pushes: usize,
    /// Most tries of one label, which bounds the time for overfull panels.
    pub(super) tries: usize,
}

impl Effort {
    const WHOLE: Effort = Effort { pushes: 3, tries: 60 };
    /// For a label that may be left out.
    pub(super) const LITTLE: Effort = Effort { pushes: 2, tries: 20 };
    /// For a picture that is soon replaced by the next one.
    pub(super) const MOVING: Effort = Effort { pushes: 2, tries: 40 };
}

/// What the other labels at their present places do to a place.
#[derive(Default)]
pub(super) struct Around {
    /// Those in the way, at most one more than was asked for; without one the place can be taken.
    pub(super) blockers: SmallVec<[usize; 3]>,
    /// The cost of the others' being near.
    pub(super) closeness: f64,
}

/// All labels with their present places.
pub(super) struct Search<'a> {
    pub(super) labels: Vec<Label>,
    pub(super) effort: Effort,
    lines: Vec<Clipped>,
    pub(super) obstacles: &'a Obstacles,
    /// Where the labels' present places and their leaders are.
    chosen: Grid,
    anchors: Grid,
    /// Where the obstacles leave no place, once it is asked for.
    blocked: OnceCell<Blocked>,
    /// How many things this stage has looked at: a measure of time that is the same everywhere.
    work: Cell<usize>,
    /// Whether a stage was stopped because it looked at too many.
    pub(super) is_cut_short: Cell<bool>,
}

impl<'a> Search<'a> {
    pub(super) fn new(requests: &[LabelRequest], obstacles: &'a Obstacles) -> Self {
        let lines = obstacles.lines.iter().copied().map(Clipped::new).collect();
        let labels: Vec<Label> = requests.iter().map(Label::new).collect();
        let bounds = obstacles.bounds;
        let mut anchors = Grid::new(bounds);
        for (index, label) in labels.iter().enumerate() {
            anchors.add(index, Rect::from_points(label.anchor, label.anchor));
        }
        let chosen = Grid::new(bounds);
        let (work, is_cut_short, blocked) = (Cell::new(0), Cell::new(false), OnceCell::new());
        let effort = Effort::WHOLE;
        Self { labels, effort, lines, obstacles, chosen, anchors, blocked, work, is_cut_short }
    }

    /// Finds the places of a label near its anchor, if they are not known yet.
    pub(super) fn begin_label(&mut self, index: usize) {
        let label = &mut self.labels[index];
        if std::mem::replace(&mut label.has_near, true) {
            return;
        }
        label.reach = label.reach_at(NEAR[NEAR.len() - 1]);
        self.find_surroundings(index);
        self.add_places(index, &NEAR);
    }

    /// Begins a stage of the search.
    pub(super) fn begin(&self) {
        self.work.set(0);
    }

    /// Counts things that are looked at.
    pub(super) fn count(&self, things: usize) {
        self.work.set(self.work.get() + things);
    }

    /// Whether this stage has looked at so much that it must end.
    pub(super) fn is_enough(&self) -> bool {
        let is_enough = self.work.get() > ENOUGH;
        self.is_cut_short.set(self.is_cut_short.get() | is_enough);
        is_enough
    }

    /// Gives a label a place, or none.
    pub(super) fn choose(&mut self, index: usize, place: Option<usize>) {
        let label = &mut self.labels[index];
        if let Some(before) = std::mem::replace(&mut label.chosen, place) {
            self.chosen.remove(index, label.places[before].area());
        }
        if let Some(place) = place {
            self.chosen.add(index, label.places[place].area());
        }
    }

    /// Looks at the labels other than `index` with a present place near a box, at least at all that touch it, each once,
    /// until `is_enough` says so.
    pub(super) fn look_around(&self, index: usize, area: Rect, mut is_enough: impl FnMut(usize, &Spot) -> bool) {
        // Around a long leader it is quicker to look at all labels than at all cells.
        let is_wide = self.chosen.cell_count(area) > self.labels.len();
        let mut looked_at = 1;
        let mut seen: SmallVec<[usize; 8]> = SmallVec::new();
        let mut look = |other: usize| {
            looked_at += 1;
            if other == index || !is_wide && seen.contains(&other) {
                return false;
            }
            if !is_wide {
                seen.push(other);
            }
            let label = &self.labels[other];
            label.chosen.is_some_and(|chosen| is_enough(other, &label.places[chosen]))
        };
        if is_wide {
            (0..self.labels.len()).any(&mut look);
        } else {
            self.chosen.any(area, &mut look);
        }
        self.count(looked_at);
    }

    /// Finds the lines and anchors that the places of a label could touch.
    fn find_surroundings(&mut self, index: usize) {
        let (reach, anchor) = (self.labels[index].reach.inflate(LINE_GAP, LINE_GAP), self.labels[index].anchor);
        let is_inside = |line: usize| self.lines[line].share_inside(reach) > 0.0;
        let lines = self.obstacles.lines_near(reach, MOST_AROUND, is_inside);
        let lines = lines.into_iter().map(|line| line as u32).collect();
        let is_near =
            |other: usize| inside(reach, self.labels[other].anchor) && is_other(self.labels[other].anchor, anchor);
        let anchors = self.anchors.some_near(reach, MOST_AROUND, is_near);
        let anchors = anchors.into_iter().map(|other| self.labels[other].anchor).collect();
        let label = &mut self.labels[index];
        (label.lines, label.anchors) = (lines, anchors);
    }

    /// Adds the free places of a label at these distances.
    fn add_places(&mut self, index: usize, distances: &[f64]) {
        let label = &self.labels[index];
        let bounds = self.obstacles.bounds;
        let free = |ink: Rect| {
            ink.x0 >= bounds.x0
                && ink.x1 <= bounds.x1
                && ink.y0 >= bounds.y0
                && ink.y1 <= bounds.y1
                && !self.is_on_obstacle(ink)
        };
        // Around those far off are many lines, of which most are not near one of them.
        let is_clear = |ink: Rect, distance: f64| distance < FAR[0] || !self.is_struck(ink);
        let dislikes = label.dislikes();
        let mut places = Vec::with_capacity(distances.len() * SIDES.len());
        for &distance in distances {
            for (side, dislike) in SIDES.iter().zip(dislikes) {
                let ink = label.ink_beside(side, label.clearance + distance);
                if free(ink) && is_clear(ink, distance) {
                    places.push(label.place_at(ink, distance, dislike + label.elsewhere(ink)));
                }
            }
        }
        self.labels[index].places.append(&mut places);
    }

    /// Whether ink is too near to an obstacle box.
    pub(super) fn is_on_obstacle(&self, ink: Rect) -> bool {
        let near = ink.inflate(BOX_GAP, BOX_GAP);
        self.obstacles.any_box(near, |other| other.overlaps(near))
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
        // The costs of near places remain: the added lines and anchors are beyond them.
        self.add_places(index, &FAR);
    }

    /// Whether ink is on an obstacle for certain, which is told quickly.
    pub(super) fn is_ruled_out(&self, ink: Rect) -> bool {
        let blocked = self.blocked.get_or_init(|| Blocked::new(self.obstacles));
        blocked.is_certain(ink.inflate(BOX_GAP, BOX_GAP))
    }

    /// Whether a line strikes through ink.
    pub(super) fn is_struck(&self, ink: Rect) -> bool {
        let area = ink.inflate(self.obstacles.strike, self.obstacles.strike);
        self.obstacles.any_line(area, |line| self.lines[line].share_inside(area) * self.lines[line].length > 0.0)
    }

    /// The cost of what a leader crosses.
    pub(super) fn cost_of_leader(&self, leader: (Point, Point)) -> f64 {
        let (mut crossed, mut on_boxes, clipped) = (0, 0.0, Clipped::new(leader));
        self.obstacles.each_line_along(leader, |line| crossed += usize::from(crosses_line(line, leader)));
        self.obstacles.each_box_along(leader, |other, is_text| {
            on_boxes += match is_text {
                true if clipped.share_inside(other.inflate(LINE_GAP, LINE_GAP)) > 0.0 => STRUCK,
                false if clipped.share_inside(other) > 0.0 => ACROSS[1],
                _ => 0.0,
            }
        });
        ACROSS[0] * crossed as f64 + on_boxes
    }

    /// The cost of other anchors that are not clearly farther from ink than its own.
    pub(super) fn ambiguity(&self, index: usize, ink: Rect) -> f64 {
        let label = &self.labels[index];
        let gap = gap(ink, label.anchor);
        let mut cost = 0.0;
        self.anchors.any(ink.inflate(FAR[0] + CLEARLY, FAR[0] + CLEARLY), |other| {
            let other = self.labels[other].anchor;
            if is_other(other, label.anchor) {
                cost += ambiguity(ink, gap, other);
            }
            false
        });
        cost
    }

    /// The whole cost of a place if it is less than `limit`.
    pub(super) fn cost_below(&mut self, index: usize, place: usize, limit: f64) -> Option<f64> {
        let label = &mut self.labels[index];
        let Spot { ink, own, least, known, leader, .. } = label.places[place];
        if known || least >= limit {
            return (least < limit).then_some(least);
        }
        // Summation stops at the limit; the sum is then a better lower bound for the next time.
        let (mut whole, mut is_struck, strike) = (true, false, self.obstacles.strike);
        let gap = gap(ink, label.anchor);
        let mut least = own + label.anchors.iter().map(|other| ambiguity(ink, gap, *other)).sum::<f64>();
        let (area, narrow) = (ink.inflate(LINE_GAP, LINE_GAP), ink.inflate(strike, strike));
        self.work.set(self.work.get() + 1 + label.anchors.len() + label.lines.len());
        for &line in &label.lines {
            let line = &self.lines[line as usize];
            let inside = line.share_inside(area) * line.length;
            if inside > 0.0 {
                least += CROSSING * inside;
                if !is_struck && line.share_inside(narrow) * line.length > 0.0 {
                    is_struck = true;
                    least += STRUCK;
                }
                if least >= limit {
                    whole = false;
                    break;
                }
            }
        }
        if whole && let Some(leader) = leader {
            least += self.cost_of_leader(leader);
        }
        let place = &mut self.labels[index].places[place];
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

    /// What other labels do to a place; it is enough to know whether more than `most`, at most two, are in the way.
    pub(super) fn around(&mut self, index: usize, place: usize, most: usize) -> Around {
        let mut around = Around::default();
        let wanted = &self.labels[index].places[place];
        self.look_around(index, wanted.surroundings(), |other, spot| {
            if wanted.excludes(spot) {
                around.blockers.push(other);
            } else {
                around.closeness += wanted.closeness(spot);
            }
            around.blockers.len() > most
        });
        around.blockers.sort_unstable();
        let known = &mut self.labels[index].places[place].blockers;
        let found: SmallVec<[u32; 3]> = around.blockers.iter().map(|other| *other as u32).collect();
        let before = known.iter().copied().filter(|other| !found.contains(other));
        let all: SmallVec<[u32; 6]> = found.iter().copied().chain(before).collect();
        known.iter_mut().zip(all).for_each(|(known, other)| *known = other);
        around
    }

    /// Whether more than `most` of the labels that were in the way of a place when it was last looked at still are.
    pub(super) fn is_still_blocked(&self, index: usize, place: usize, most: usize) -> bool {
        let wanted = &self.labels[index].places[place];
        let others = wanted.blockers.iter().filter_map(|&other| self.labels.get(other as usize));
        let spots = others.filter_map(|other| Some(&other.places[other.chosen?]));
        spots.filter(|spot| wanted.excludes(spot)).nth(most).is_some()
    }

    /// The cheapest place of a label without another label in the way, if it costs less than `limit`, with its cost.
    pub(super) fn cheapest(&mut self, index: usize, limit: f64) -> Option<(usize, f64)> {
        let mut best = None;
        let mut limit = limit;
        for place in 0..self.labels[index].places.len() {
            if self.labels[index].places[place].least >= limit {
                continue;
            }
            // What a place costs is known after the first time.
            let Some(cost) = self.cost_below(index, place, limit) else { continue };
            if self.is_still_blocked(index, place, 0) {
                continue;
            }
            let around = self.around(index, place, 0);
            if around.blockers.is_empty() && cost + around.closeness < limit {
                limit = cost + around.closeness;
                best = Some((place, limit));
            }
        }
        best
    }
}

/// Whether a point is another one than an anchor: labels of the same point do not compete for it.
fn is_other(point: Point, anchor: Point) -> bool {
    (point - anchor).hypot2() > 1e-6
}

/// The distance of ink from its own anchor that others are compared with: from a label with a leader it is enough that they
/// are not near.
fn gap(ink: Rect, own: Point) -> f64 {
    distance_to_box(ink, own).min(FAR[0])
}

/// The cost of an anchor that is not clearly farther from ink than its own.
fn ambiguity(ink: Rect, gap: f64, other: Point) -> f64 {
    AMBIGUITY * (gap + CLEARLY - distance_to_box(ink, other)).max(0.0)
}
