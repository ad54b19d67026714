//! Where labels go: beside what they name, on nothing else.
//!
//! Every label has the same kinds of places around its anchor: its ink box touching a circle about
//! the anchor, in 24 directions and at a few distances. A place is *free* if it is inside the panel
//! and off every obstacle box; a free place has a *cost* in millimetres for standing away, on the
//! wrong side, on lines, or nearer to another label's anchor than to its own. Labels with the
//! fewest free places choose first, then labels move, alone or in pairs, as long as the sum of the
//! costs falls. Christensen, Marks and Shieber, "An Empirical Study of Algorithms for Point-Feature
//! Label Placement" (ACM Trans. Graphics 14(3), 1995), compare such searches; this one uses no
//! chance and visits everything in order, so the same labels always get the same places.

use kurbo::{Point, Rect, Vec2};

use super::text::{PlacedText, RichText};

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

/// Distances beyond the clearance, in mm, at which a label still clearly belongs to its anchor.
const NEAR: [f64; 4] = [0.0, 0.6, 1.3, 2.2];
/// Distances that need a leader; tried only where nothing near is free.
const FAR: [f64; 6] = [3.5, 5.0, 7.0, 9.5, 12.5, 16.0];
/// Least white between the ink of two labels, in mm.
const LABEL_GAP: f64 = 0.4;
/// Least white between a label's ink and an obstacle box, in mm.
const OBSTACLE_GAP: f64 = 0.1;
/// White around a label's ink that a line should not enter, in mm.
const LINE_GAP: f64 = 0.3;
/// White between a leader and the ink it leads to, in mm.
const LEADER_GAP: f64 = 0.4;

// Costs, in mm of distance from the anchor.
/// Of a millimetre of line inside the box.
const CROSSING: f64 = 1.6;
/// Of standing at a right angle to the preferred direction; opposite costs twice that.
const DEVIATION: f64 = 1.2;
/// The same for labels without a preference: a slight liking for the upper right, where readers
/// look first.
const HABIT: f64 = 0.25;
/// Where such labels like to stand.
const HABITUAL: Vec2 = Vec2::new(0.6, -0.8);
/// Of each millimetre by which another anchor is not clearly farther than the label's own.
const AMBIGUITY: f64 = 2.5;
/// By how much another anchor is clearly farther, in mm.
const CLEARLY: f64 = 0.6;
/// Of having a leader at all.
const LEADER: f64 = 3.0;
/// Least gain in mm that makes a label move, so that rounding cannot make two labels swap for ever.
const LEAST_GAIN: f64 = 1e-6;

/// How often all labels may try to move; three or four rounds settle every figure tried.
const ROUNDS: usize = 8;
/// How many labels may be pushed on, one by the other, to make room for one.
const PUSHES: usize = 3;
/// How many such tries one label may make: a bound on time for panels that are simply too full.
const TRIES: usize = 4_000;
/// Step in mm of the last search, over the whole panel.
const LAST_STEP: f64 = 1.5;

/// A direction in which a box stands beside a point.
struct Side {
    /// Which point of the box faces the point, in half sizes from the box's centre, turned round.
    align: Vec2,
    /// The unit vector along which the box is moved off.
    shift: Vec2,
    /// The unit vector in which a reader sees the box, as if it were a square: a box as wide as a
    /// word is "to the upper right" long before its centre is.
    toward: Vec2,
}

/// Beside a side of the box, at its middle or a quarter of its length from a corner.
const fn beside(align: (f64, f64), shift: (f64, f64)) -> Side {
    // A quarter off the middle is seen at atan(1/2).
    const MAIN: f64 = 0.894_427_190_999_915_9;
    let straight = align.0 == shift.0 && align.1 == shift.1;
    let scale = if straight { 1.0 } else { MAIN };
    let toward = Vec2::new(align.0 * scale, align.1 * scale);
    Side {
        align: Vec2::new(align.0, align.1),
        shift: Vec2::new(shift.0, shift.1),
        toward,
    }
}

/// Off a corner of the box.
const fn corner(align: (f64, f64), shift: (f64, f64)) -> Side {
    let shift = Vec2::new(shift.0, shift.1);
    Side {
        align: Vec2::new(align.0, align.1),
        shift,
        toward: shift,
    }
}

const HALF_ROOT_2: f64 = std::f64::consts::FRAC_1_SQRT_2;
const HALF_ROOT_3: f64 = 0.866_025_403_784_438_6;

/// Three places along each side of the box and three about each corner; beside a side the box is
/// moved off square to it, so its distance from the point is the same in all.
static SIDES: [Side; 24] = [
    beside((1.0, 0.0), (1.0, 0.0)),
    beside((1.0, -0.5), (1.0, 0.0)),
    beside((1.0, 0.5), (1.0, 0.0)),
    beside((-1.0, 0.0), (-1.0, 0.0)),
    beside((-1.0, -0.5), (-1.0, 0.0)),
    beside((-1.0, 0.5), (-1.0, 0.0)),
    beside((0.0, -1.0), (0.0, -1.0)),
    beside((0.5, -1.0), (0.0, -1.0)),
    beside((-0.5, -1.0), (0.0, -1.0)),
    beside((0.0, 1.0), (0.0, 1.0)),
    beside((0.5, 1.0), (0.0, 1.0)),
    beside((-0.5, 1.0), (0.0, 1.0)),
    corner((1.0, -1.0), (HALF_ROOT_3, -0.5)),
    corner((1.0, -1.0), (HALF_ROOT_2, -HALF_ROOT_2)),
    corner((1.0, -1.0), (0.5, -HALF_ROOT_3)),
    corner((1.0, 1.0), (HALF_ROOT_3, 0.5)),
    corner((1.0, 1.0), (HALF_ROOT_2, HALF_ROOT_2)),
    corner((1.0, 1.0), (0.5, HALF_ROOT_3)),
    corner((-1.0, -1.0), (-HALF_ROOT_3, -0.5)),
    corner((-1.0, -1.0), (-HALF_ROOT_2, -HALF_ROOT_2)),
    corner((-1.0, -1.0), (-0.5, -HALF_ROOT_3)),
    corner((-1.0, 1.0), (-HALF_ROOT_3, 0.5)),
    corner((-1.0, 1.0), (-HALF_ROOT_2, HALF_ROOT_2)),
    corner((-1.0, 1.0), (-0.5, HALF_ROOT_3)),
];

/// A line ready for clipping: its start, the reciprocals of its run, its length.
#[derive(Clone, Copy)]
struct Clipped {
    start: Point,
    reciprocal: Vec2,
    length: f64,
}

impl Clipped {
    fn new((start, end): (Point, Point)) -> Self {
        // A run of zero gets a huge reciprocal of either sign: the line is then inside a band for
        // all of its length or for none.
        let reciprocal = |run: f64| if run.abs() < 1e-12 { 1e12 } else { 1.0 / run };
        let run = end - start;
        Self {
            start,
            reciprocal: Vec2::new(reciprocal(run.x), reciprocal(run.y)),
            length: run.hypot2().sqrt(),
        }
    }

    /// The share of the line inside a box, between 0 and 1 (Liang and Barsky, "A New Concept and
    /// Method for Line Clipping", 1984).
    fn share_inside(&self, area: Rect) -> f64 {
        let (x0, x1) = (
            (area.x0 - self.start.x) * self.reciprocal.x,
            (area.x1 - self.start.x) * self.reciprocal.x,
        );
        let (y0, y1) = (
            (area.y0 - self.start.y) * self.reciprocal.y,
            (area.y1 - self.start.y) * self.reciprocal.y,
        );
        let enters = greater(greater(lesser(x0, x1), lesser(y0, y1)), 0.0);
        let leaves = lesser(lesser(greater(x0, x1), greater(y0, y1)), 1.0);
        greater(leaves - enters, 0.0)
    }
}

/// A place that a label could take.
#[derive(Clone, Copy)]
struct Place {
    ink: Rect,
    /// What the place costs at least: at first for distance and direction, in the end for all. Most
    /// places are ruled out before.
    least: f64,
    /// Whether `least` is the whole cost.
    known: bool,
    leader: Option<(Point, Point)>,
}

struct Label {
    anchor: Point,
    clearance: f64,
    /// The ink box of the text set at the origin.
    ink: Rect,
    prefer: Option<Vec2>,
    /// Its free places and the one it has.
    places: Vec<Place>,
    chosen: Option<usize>,
    /// Everything that any of its places could touch.
    lines: Vec<Clipped>,
    anchors: Vec<Point>,
    neighbours: Vec<usize>,
    reach: Rect,
    has_far: bool,
}

struct Search<'a> {
    labels: Vec<Label>,
    lines: Vec<Clipped>,
    obstacles: &'a Obstacles,
}

/// The places of the labels, in the order of the requests.
///
/// No label touches another, an obstacle box or the edge of the panel, unless it says `crowded`:
/// then the panel has no room for it, and it stands where it hides least. The same input gives the
/// same places on every platform.
pub fn place(requests: &[LabelRequest], obstacles: &Obstacles) -> Vec<PlacedLabel> {
    let mut search = Search::new(requests, obstacles);
    search.choose_first(requests);
    search.make_room();
    search.improve();
    search.look_everywhere();
    let found = search
        .labels
        .iter()
        .map(|label| label.chosen.map(|chosen| label.places[chosen]));
    let found: Vec<Option<Place>> = found.collect();
    let placed = requests
        .iter()
        .zip(found)
        .enumerate()
        .map(|(index, (request, found))| {
            let crowded = found.is_none();
            let place = found.unwrap_or_else(|| search.least_bad(index));
            let ink = request.text.ink_box(request.size);
            let origin = Point::ORIGIN + (place.ink.origin() - ink.origin());
            let text = PlacedText::new(request.text.clone(), request.size, origin);
            PlacedLabel {
                text,
                leader: place.leader,
                crowded: crowded && !request.text.is_empty(),
            }
        });
    placed.collect()
}

impl<'a> Search<'a> {
    fn new(requests: &[LabelRequest], obstacles: &'a Obstacles) -> Self {
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
        let mut places = Vec::with_capacity(distances.len() * SIDES.len());
        for &distance in distances {
            for side in &SIDES {
                let ink = label.ink_beside(side, label.clearance + distance);
                if free(ink) {
                    places.push(label.place_at(ink, distance, side.toward));
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
    fn choose_first(&mut self, requests: &[LabelRequest]) {
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
    fn make_room(&mut self) {
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
    fn improve(&mut self) {
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
    fn look_everywhere(&mut self) {
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
                    let place = label.place_at(ink, distance, Vec2::ZERO);
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
    fn least_bad(&self, index: usize) -> Place {
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

impl Label {
    fn new(request: &LabelRequest) -> Self {
        let mut label = Self {
            anchor: request.anchor,
            clearance: request.clearance.max(0.0),
            ink: request.text.ink_box(request.size),
            prefer: request.prefer.and_then(unit),
            places: Vec::new(),
            chosen: None,
            lines: Vec::new(),
            anchors: Vec::new(),
            neighbours: Vec::new(),
            reach: Rect::ZERO,
            has_far: false,
        };
        label.reach = label.reach_at(NEAR[NEAR.len() - 1]);
        label
    }

    fn is_blank(&self) -> bool {
        self.ink.width() <= 0.0
    }

    /// The box around all places up to a distance.
    fn reach_at(&self, distance: f64) -> Rect {
        let most = self.clearance + distance;
        Rect::from_center_size(
            self.anchor,
            (
                2.0 * (most + self.ink.width()),
                2.0 * (most + self.ink.height()),
            ),
        )
    }

    /// The ink box beside the anchor at a distance.
    fn ink_beside(&self, side: &Side, distance: f64) -> Rect {
        let (width, height) = (self.ink.width(), self.ink.height());
        let center = self.anchor
            + side.shift * distance
            + Vec2::new(side.align.x * 0.5 * width, side.align.y * 0.5 * height);
        Rect::from_center_size(center, (width, height))
    }

    /// A place for the ink, `distance` beyond the clearance and seen from the anchor in the
    /// direction `toward`.
    fn place_at(&self, ink: Rect, distance: f64, toward: Vec2) -> Place {
        let leader = if distance >= FAR[0] {
            self.leader_to(ink)
        } else {
            None
        };
        let (wanted, weight) = self
            .prefer
            .map_or((HABITUAL, HABIT), |prefer| (prefer, DEVIATION));
        let apart = if leader.is_some() { LEADER } else { 0.0 };
        Place {
            ink,
            least: distance + weight * (1.0 - toward.dot(wanted)) + apart,
            known: false,
            leader,
        }
    }

    /// The line from the edge of the anchor's clearance to just before the ink.
    fn leader_to(&self, ink: Rect) -> Option<(Point, Point)> {
        let foot = Point::new(
            self.anchor.x.clamp(ink.x0, ink.x1),
            self.anchor.y.clamp(ink.y0, ink.y1),
        );
        let direction = unit(foot - self.anchor)?;
        Some((
            self.anchor + direction * self.clearance,
            foot - direction * LEADER_GAP,
        ))
    }
}

impl Place {
    /// Whether two labels cannot have these places at once.
    fn conflicts(&self, other: &Self) -> bool {
        let strikes = |leader: Option<(Point, Point)>, ink: Rect| {
            leader.is_some_and(|leader| {
                Clipped::new(leader).share_inside(ink.inflate(LINE_GAP, LINE_GAP)) > 0.0
            })
        };
        touch(self.ink, other.ink, LABEL_GAP)
            || strikes(self.leader, other.ink)
            || strikes(other.leader, self.ink)
            || matches!((self.leader, other.leader), (Some(one), Some(two)) if cross(one, two))
    }
}

/// `f64::min` for numbers that are not NaN: one instruction, in the innermost loop.
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// `f64::max` for numbers that are not NaN.
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

fn unit(vector: Vec2) -> Option<Vec2> {
    let size = vector.hypot2().sqrt();
    (size > 0.0 && size.is_finite()).then(|| vector / size)
}

/// Whether two boxes overlap or come nearer than `gap`.
fn touch(a: Rect, b: Rect, gap: f64) -> bool {
    a.x0 < b.x1 + gap && b.x0 < a.x1 + gap && a.y0 < b.y1 + gap && b.y0 < a.y1 + gap
}

fn inside(area: Rect, point: Point) -> bool {
    area.x0 <= point.x && point.x <= area.x1 && area.y0 <= point.y && point.y <= area.y1
}

/// The distance from a box to a point outside it; 0 inside.
fn gap(area: Rect, point: Point) -> f64 {
    let x = (area.x0 - point.x).max(point.x - area.x1).max(0.0);
    let y = (area.y0 - point.y).max(point.y - area.y1).max(0.0);
    (x * x + y * y).sqrt()
}

/// Whether two lines cross; touching ends do not count.
fn cross((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let turn = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers between 0 and 1 from a seed (Steele, Lea and Flood, "Fast Splittable Pseudorandom
    /// Number Generators", 2014).
    fn random(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = *seed;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn crowd(
        seed: u64,
        labels: usize,
        lines: usize,
        size: (f64, f64),
    ) -> (Vec<LabelRequest>, Obstacles) {
        let mut seed = seed;
        let bounds = Rect::new(10.0, 10.0, 10.0 + size.0, 10.0 + size.1);
        let at = |seed: &mut u64| {
            let (x, y) = (random(seed), random(seed));
            Point::new(
                bounds.x0 + 2.0 + (size.0 - 4.0) * x,
                bounds.y0 + 2.0 + (size.1 - 4.0) * y,
            )
        };
        let names = [
            "A",
            "S_3",
            "n_{s3b}",
            "v_{CB} ⊥ CB",
            "a^n_{DG}",
            "ω_2",
            "b'",
        ];
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
        let boxes = anchors
            .iter()
            .map(|&anchor| Rect::from_center_size(anchor, (2.2, 2.2)))
            .collect();
        let lines = (0..lines).map(|_| (at(&mut seed), at(&mut seed))).collect();
        (
            requests,
            Obstacles {
                boxes,
                lines,
                bounds,
            },
        )
    }

    fn check(placed: &[PlacedLabel], obstacles: &Obstacles) {
        for (index, label) in placed.iter().enumerate() {
            let ink = label.text.ink_box();
            assert!(!label.crowded, "label {index} found no place");
            assert_eq!(
                ink.union(obstacles.bounds),
                obstacles.bounds,
                "label {index} leaves the panel"
            );
            assert!(
                !obstacles.boxes.iter().any(|&other| touch(ink, other, 0.0)),
                "label {index} touches an obstacle"
            );
            for (other_index, other) in placed[..index].iter().enumerate() {
                assert!(
                    !touch(ink, other.text.ink_box(), 0.0),
                    "labels {other_index} and {index} touch"
                );
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
        let obstacles = Obstacles {
            boxes: vec![],
            lines: vec![],
            bounds: Rect::new(0.0, 0.0, 100.0, 100.0),
        };
        for (x, y) in [
            (1.0, 0.0),
            (-1.0, 0.0),
            (0.0, 1.0),
            (0.0, -1.0),
            (1.0, 1.0),
            (-1.0, -1.0),
        ] {
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
            assert!(
                away.dot(wish) > 0.7 * away.hypot2().sqrt() * wish.hypot2().sqrt(),
                "{away:?} for {wish:?}"
            );
            assert!((gap(placed[0].text.ink_box(), anchor) - 1.5).abs() < 1e-9);
            assert_eq!(placed[0].leader, None);
        }
    }

    #[test]
    fn a_label_without_room_beside_its_point_gets_a_leader() {
        let anchor = Point::new(50.0, 50.0);
        let boxes = vec![Rect::from_center_size(anchor, (14.0, 14.0))];
        let obstacles = Obstacles {
            boxes,
            lines: vec![],
            bounds: Rect::new(0.0, 0.0, 100.0, 100.0),
        };
        let request = LabelRequest {
            text: RichText::math("S_3"),
            size: 4.0,
            anchor,
            clearance: 1.5,
            prefer: None,
            priority: 0,
        };
        let placed = place(&[request], &obstacles);
        check(&placed, &obstacles);
        assert!(placed[0].leader.is_some());
    }

    #[test]
    fn a_panel_without_room_says_so() {
        let obstacles = Obstacles {
            boxes: vec![],
            lines: vec![],
            bounds: Rect::new(0.0, 0.0, 4.0, 4.0),
        };
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
