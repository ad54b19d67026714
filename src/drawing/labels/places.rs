//! Labels without a place, the spots where each could stand with their costs by distance and direction, and placed labels.

use kurbo::{Point, Rect, Vec2};

use super::super::shape::crosses_line;
use super::super::text::{ABOVE, BESIDE, LABEL, PlacedText, RichText};

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
    /// Whether it may stand apart from the anchor, with a leader, where no place near it is free.
    pub may_stand_apart: bool,
    /// A shorter text, where the whole has no place.
    pub short: Option<RichText>,
}

impl LabelRequest {
    /// A label of the usual size.
    pub(in crate::drawing) fn new(
        text: RichText,
        anchor: Point,
        clearance: f64,
        prefer: Option<Vec2>,
        priority: u8,
    ) -> LabelRequest {
        LabelRequest { text, size: LABEL, anchor, clearance, prefer, priority, may_stand_apart: true, short: None }
    }
}

/// A label at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedLabel {
    /// The text on the sheet.
    pub text: PlacedText,
    /// A thin line from near the anchor to near the text, where the text had to stand apart.
    pub leader: Option<(Point, Point)>,
}

/// Distances beyond the clearance, in mm, at which a label still clearly belongs to its anchor.
pub(super) const NEAR: [f64; 4] = [0.0, 0.6, 1.3, 2.2];
/// Distances that need a leader; tried only where nothing near is free.
pub(super) const FAR: [f64; 6] = [3.5, 5.0, 7.0, 9.5, 12.5, 16.0];
/// White beside a label's ink from which the next one is clearly another, in mm: an em.
pub(super) const CLEAR: f64 = LABEL;
/// White around a label's ink that a line should not enter, in mm.
pub(super) const LINE_GAP: f64 = 0.6;
/// White between a leader and the ink it leads to, in mm.
pub(super) const LEADER_GAP: f64 = 0.4;

// Costs, in mm of distance from the anchor; the search adds those of things near a place.
/// Of a direction normal to the preferred one; the opposite direction costs twice that.
const DEVIATION: f64 = 1.2;
/// Cost of a direction for labels without a preference: a slight one for the upper right, where readers look first.
const HABIT: f64 = 0.25;
/// Of a place elsewhere than the one where the label was before, per mm between them and at most: so small advantages do
/// not move it, and it moves rather a little than far.
const ELSEWHERE: [f64; 2] = [0.4, 2.5];
/// The preferred direction of such labels.
const HABITUAL: Vec2 = Vec2::new(0.6, -0.8);
const LEADER: f64 = 3.0;
/// Of a label beside another with the least white; of one with clear white nothing.
const CLOSE: f64 = 2.0;

/// A direction from an anchor to a box.
pub(super) struct Side {
    /// Offset of the box's centre from the point that faces the anchor, in half sizes of the box.
    align: Vec2,
    /// Unit vector along which the box is displaced.
    shift: Vec2,
    /// Unit vector of the direction as a reader sees it, as if the box were a square: a wide box is "to the upper
    /// right" long before its centre is.
    pub(super) toward: Vec2,
}

/// Beside a side of the box: at its middle, or a quarter of its length from a corner.
pub(super) const fn beside(align: (f64, f64), shift: (f64, f64)) -> Side {
    // A quarter off the middle counts as the direction atan(1/2).
    const MAIN: f64 = 0.894_427_190_999_915_9;
    let straight = align.0 == shift.0 && align.1 == shift.1;
    let scale = if straight { 1.0 } else { MAIN };
    let toward = Vec2::new(align.0 * scale, align.1 * scale);
    Side { align: Vec2::new(align.0, align.1), shift: Vec2::new(shift.0, shift.1), toward }
}

/// Off a corner of the box.
pub(super) const fn corner(align: (f64, f64), shift: (f64, f64)) -> Side {
    let shift = Vec2::new(shift.0, shift.1);
    Side { align: Vec2::new(align.0, align.1), shift, toward: shift }
}

pub(super) const HALF_ROOT_2: f64 = std::f64::consts::FRAC_1_SQRT_2;
pub(super) const HALF_ROOT_3: f64 = 0.866_025_403_784_438_6;

/// Three places along each side of the box and three about each corner. Beside a side the box is displaced along the
/// normal, so that all have the same distance from the point.
pub(super) static SIDES: [Side; 24] = [
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

/// A possible place of a label.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    pub(super) ink: Rect,
    /// Its cost by distance and direction alone.
    pub(super) own: f64,
    /// A lower bound of its cost, in the end the whole. Most places are ruled out before.
    pub(super) least: f64,
    /// Whether `least` is the whole cost.
    pub(super) known: bool,
    pub(super) leader: Option<(Point, Point)>,
    /// The labels that were in its way when it was last looked at: mostly they still are.
    pub(super) blockers: [u32; 3],
}

/// Where there is no label.
pub(super) const NOBODY: u32 = u32::MAX;

/// A label in search of a place.
pub(super) struct Label {
    pub(super) anchor: Point,
    pub(super) clearance: f64,
    /// The ink box of the text set at the origin.
    pub(super) ink: Rect,
    pub(super) prefer: Option<Vec2>,
    pub(super) priority: u8,
    /// Its free places, as far as they have been looked for, and the index of the present one.
    pub(super) places: Vec<Spot>,
    pub(super) chosen: Option<usize>,
    /// What any of its places could touch: lines by their numbers, and anchors.
    pub(super) lines: Vec<u32>,
    pub(super) anchors: Vec<Point>,
    pub(super) reach: Rect,
    pub(super) may_stand_apart: bool,
    pub(super) has_near: bool,
    pub(super) has_far: bool,
    /// Whether no clear place was found for it, near or far.
    pub(super) is_stuck: bool,
    /// The ink box of a shorter text set at the origin, until it is taken.
    pub(super) short: Option<Rect>,
    pub(super) is_short: bool,
    /// Where the middle of its ink was from the anchor in the picture before, if there is one.
    pub(super) before: Option<Vec2>,
}

impl Label {
    pub(super) fn new(request: &LabelRequest) -> Self {
        Self {
            anchor: request.anchor,
            clearance: request.clearance.max(0.0),
            ink: request.text.ink_box(request.size),
            prefer: request.prefer.and_then(unit),
            priority: request.priority,
            places: Vec::new(),
            chosen: None,
            lines: Vec::new(),
            anchors: Vec::new(),
            reach: Rect::ZERO,
            may_stand_apart: request.may_stand_apart,
            has_near: false,
            has_far: false,
            is_stuck: false,
            short: request.short.as_ref().map(|short| short.ink_box(request.size)),
            is_short: false,
            before: None,
        }
    }

    pub(super) fn is_blank(&self) -> bool {
        self.ink.width() <= 0.0
    }

    /// The box around all places up to a distance from the clearance circle.
    pub(super) fn reach_at(&self, distance: f64) -> Rect {
        let most = self.clearance + distance;
        Rect::from_center_size(self.anchor, (2.0 * (most + self.ink.width()), 2.0 * (most + self.ink.height())))
    }

    /// The ink box beside the anchor at a distance.
    pub(super) fn ink_beside(&self, side: &Side, distance: f64) -> Rect {
        let (width, height) = (self.ink.width(), self.ink.height());
        let center =
            self.anchor + side.shift * distance + Vec2::new(side.align.x * 0.5 * width, side.align.y * 0.5 * height);
        Rect::from_center_size(center, (width, height))
    }

    /// By side: the cost of its direction.
    pub(super) fn dislikes(&self) -> [f64; SIDES.len()] {
        let (wanted, weight) = self.prefer.map_or((HABITUAL, HABIT), |prefer| (prefer, DEVIATION));
        std::array::from_fn(|side| weight * (1.0 - SIDES[side].toward.dot(wanted)))
    }

    /// The cost of ink elsewhere than before.
    pub(super) fn elsewhere(&self, ink: Rect) -> f64 {
        let [per_mm, most] = ELSEWHERE;
        self.before.map_or(0.0, |before| (per_mm * (ink.center() - self.anchor - before).hypot()).min(most))
    }

    /// The cost of the direction in which the middle of the ink lies from the anchor.
    pub(super) fn dislike_at(&self, offset: Vec2) -> f64 {
        let (wanted, weight) = self.prefer.map_or((HABITUAL, HABIT), |prefer| (prefer, DEVIATION));
        let half = 0.5 * self.ink.size() + kurbo::Size::new(self.clearance, self.clearance);
        let toward = unit(Vec2::new(offset.x / half.width, offset.y / half.height));
        toward.map_or(weight, |toward| weight * (1.0 - toward.dot(wanted)))
    }

    /// A place of the ink, `distance` beyond the clearance; `dislike` is the cost of its direction.
    #[inline]
    pub(super) fn place_at(&self, ink: Rect, distance: f64, dislike: f64) -> Spot {
        let leader = if distance < FAR[0] { None } else { self.leader_to(ink) };
        let apart = if leader.is_some() { LEADER } else { 0.0 };
        let own = distance + dislike + apart;
        Spot { ink, own, least: own, known: false, leader, blockers: [NOBODY; 3] }
    }

    /// The leader, from the edge of the anchor's clearance to near the ink.
    pub(super) fn leader_to(&self, ink: Rect) -> Option<(Point, Point)> {
        let foot = Point::new(self.anchor.x.max(ink.x0).min(ink.x1), self.anchor.y.max(ink.y0).min(ink.y1));
        let direction = unit(foot - self.anchor)?;
        Some((self.anchor + direction * self.clearance, foot - direction * LEADER_GAP))
    }
}

impl Spot {
    /// The box around its ink and its leader.
    pub(super) fn area(&self) -> Rect {
        self.leader.map_or(self.ink, |(from, to)| self.ink.union_pt(from).union_pt(to))
    }

    /// The area in which another label matters.
    pub(super) fn surroundings(&self) -> Rect {
        self.area().union(self.ink.inflate(CLEAR, ABOVE)).inflate(LINE_GAP, LINE_GAP)
    }

    /// Whether two labels cannot have these places together: they would read as one, or the leader of one strikes through
    /// the other.
    pub(super) fn conflicts(&self, other: &Self) -> bool {
        let strikes = |leader: Option<(Point, Point)>, ink: Rect| {
            leader.is_some_and(|leader| Clipped::new(leader).share_inside(ink.inflate(LINE_GAP, LINE_GAP)) > 0.0)
        };
        let (a, b) = (self.ink, other.ink);
        let is_near = a.x0 < b.x1 + BESIDE && b.x0 < a.x1 + BESIDE && a.y0 < b.y1 + ABOVE && b.y0 < a.y1 + ABOVE;
        is_near || strikes(self.leader, b) || strikes(other.leader, a)
    }

    /// Whether two labels cannot have these places together, or their leaders cross.
    pub(super) fn excludes(&self, other: &Self) -> bool {
        self.conflicts(other) || self.crosses(other)
    }

    /// Whether the leaders of two labels cross.
    pub(super) fn crosses(&self, other: &Self) -> bool {
        matches!((self.leader, other.leader), (Some(one), Some(two)) if crosses_line(one, two))
    }

    /// The cost of another label beside this one.
    pub(super) fn closeness(&self, other: &Self) -> f64 {
        let (a, b) = (self.ink, other.ink);
        let white = (a.x0 - b.x1).max(b.x0 - a.x1);
        let is_beside = white < CLEAR && a.y0 < b.y1 + ABOVE && b.y0 < a.y1 + ABOVE;
        if is_beside { CLOSE * ((CLEAR - white) / (CLEAR - BESIDE)).min(1.0) } else { 0.0 }
    }
}

/// A line prepared for clipping: its start, the reciprocals of its components, its length.
#[derive(Clone, Copy)]
pub(super) struct Clipped {
    start: Point,
    reciprocal: Vec2,
    pub(super) length: f64,
}

impl Clipped {
    pub(super) fn new((start, end): (Point, Point)) -> Self {
        // A zero component has a huge reciprocal of either sign: the line is then inside a band with all of its length
        // or with none.
        let reciprocal = |run: f64| if run.abs() < 1e-12 { 1e12 } else { 1.0 / run };
        let run = end - start;
        Self { start, reciprocal: Vec2::new(reciprocal(run.x), reciprocal(run.y)), length: run.hypot2().sqrt() }
    }

    /// The share of the line inside a box, between 0 and 1 (Liang and Barsky, "A New Concept and
    /// Method for Line Clipping", 1984).
    pub(super) fn share_inside(&self, area: Rect) -> f64 {
        let (x0, x1) = ((area.x0 - self.start.x) * self.reciprocal.x, (area.x1 - self.start.x) * self.reciprocal.x);
        let (y0, y1) = ((area.y0 - self.start.y) * self.reciprocal.y, (area.y1 - self.start.y) * self.reciprocal.y);
        let enters = greater(greater(lesser(x0, x1), lesser(y0, y1)), 0.0);
        let leaves = lesser(lesser(greater(x0, x1), greater(y0, y1)), 1.0);
        greater(leaves - enters, 0.0)
    }
}

/// `f64::min` for numbers that are not NaN: a single instruction, for the innermost loop.
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// `f64::max` for numbers that are not NaN.
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

pub(super) fn unit(vector: Vec2) -> Option<Vec2> {
    let size = vector.hypot2().sqrt();
    (size > 0.0 && size.is_finite()).then(|| vector / size)
}

pub(super) fn inside(area: Rect, point: Point) -> bool {
    area.x0 <= point.x && point.x <= area.x1 && area.y0 <= point.y && point.y <= area.y1
}
