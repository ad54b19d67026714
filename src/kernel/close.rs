use super::action::{Action, Closing, Placing, Unknown};
use super::columns::{correct_columns, turn_columns};
use super::compile::InputKind;
use super::solve::{determinant, solve};
use super::{Block, Kernel, Single};
use crate::geometry::{Lanes, MANY, NEAR, Number, OneByOne, Pair, Row, UNIT_ROUNDOFF, direction_near, quarters_of};
use std::ops::Range;

/// Newton steps at most for one group, from a good start.
const STEPS: usize = 12;

/// The largest part of a group's size, or of a radian, by which a first step may correct a start that counts as good.
const GOOD: f64 = 0.5;

/// Corrections, in radians, that change a direction's length by so little that [`unit`] mends it.
const SMALL: f64 = 1e-3;

/// How a block's positions were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// The largest first correction, in radians or parts of the group's size: how far off the start was.
    pub first: f64,
    /// Whether every loop closed to what rounding allows.
    pub closed: bool,
    /// What the first correction has left for a second one, in units of rounding.
    pub doubt: f64,
}

impl Kernel {
    /// Sets a drive: angles in degrees, or positions along the guide.
    #[inline(always)]
    pub fn set_input<L: Lanes, R: Row>(&self, lanes: L, block: &mut Block<R>, input: usize, values: &R) {
        match self.inputs[input].kind {
            InputKind::Turning { class } => {
                let turns = &mut block.turns[class];
                let quarters = quarters_of(values[0]);
                let mut farthest = lanes.splat(0.0);
                for k in portions::<L, R>() {
                    let degrees = lanes.load(values, k);
                    let away = degrees - lanes.splat(90.0 * quarters);
                    farthest = farthest.larger(away).larger(-away);
                    lanes.store_pair(turns, k, direction_near(degrees, quarters));
                }
                if lanes.largest(farthest) > NEAR {
                    for k in 0..R::LEN {
                        let direction = direction_near(values[k], quarters_of(values[k]));
                        OneByOne.store_pair(turns, k, direction);
                    }
                }
            }
            InputKind::Sliding { slider } => block.slides[slider] = *values,
        }
    }

    /// Closes every group by Newton's method from the angles and slides in `block`, and places all points.
    ///
    /// The matrix is that of the velocities, so a position is as exact as the condition of its velocities allows. It must start near:
    /// where a first step is larger than half a radian, or steps do not get smaller, the loops count as not closed.
    /// A first step of at most `sure`, in radians or parts of a group's size, is known to leave only rounding.
    #[inline(always)]
    pub fn assemble<L: Lanes, R: Row>(&self, lanes: L, block: &mut Block<R>, sure: f64) -> Correction {
        let mut worst = Correction { first: 0.0, closed: true, doubt: 0.0 };
        for action in &self.actions {
            match action {
                Action::Place(placing) => place(lanes, block, placing),
                Action::Close(closing) => {
                    let found = close(lanes, block, closing, sure);
                    worst.first = worst.first.max(found.first);
                    worst.doubt = worst.doubt.max(found.doubt);
                    worst.closed &= found.closed;
                    if !worst.closed {
                        return worst;
                    }
                }
            }
        }
        worst
    }

    /// One Newton step for a group from anywhere; the largest gap of its loops before it, and that of its ties in radians.
    ///
    /// Not numbers or not finite where the step cannot be made.
    pub fn step(&self, block: &mut Single, group: usize) -> [f64; 2] {
        let Some(closing) = self.closing(group) else {
            return [f64::NAN; 2];
        };
        turn_columns(OneByOne, block, closing);
        let largest = |sides: &mut dyn Iterator<Item = &[f64; 1]>| sides.map(|[x]| x.abs()).fold(0.0, larger);
        let gaps = [
            largest(&mut block.sides[..closing.chains.len()].iter().flatten()),
            largest(&mut block.tie_sides[..closing.ties.len()].iter()),
        ];
        solve::<_, _, true>(OneByOne, block, closing);
        let steps = &block.solution[..closing.unknowns.len()];
        if !steps.iter().flatten().all(|x| x.is_finite()) {
            return [f64::INFINITY; 2];
        }
        correct(OneByOne, block, closing, Size::Large);
        gaps
    }

    /// Places the points of a group's links from its angles and slides.
    pub fn place(&self, block: &mut Single, group: usize) {
        let mut actions = self.actions.iter();
        let _ = actions.find(|a| matches!(a, Action::Close(closing) if closing.group == group));
        for action in actions {
            match action {
                Action::Place(placing) => place(OneByOne, block, placing),
                Action::Close(_) => break,
            }
        }
    }

    fn closing(&self, group: usize) -> Option<&Closing> {
        let mut actions = self.actions.iter();
        actions.find_map(|action| match action {
            Action::Close(closing) if closing.group == group => Some(closing),
            _ => None,
        })
    }

    /// By group: the determinant of its equations, whose sign changes where two branches meet, and the square of Hadamard's
    /// ratio, 1 down to 0 in a singular position.
    #[must_use]
    pub fn determinants(&self, block: &Single) -> Vec<[f64; 2]> {
        let groups = 0..block.systems.len();
        let closings = groups.filter_map(|group| self.closing(group));
        closings.map(|c| determinant(block, c, 0)).collect()
    }
}

/// The portions of a row.
#[inline(always)]
#[must_use]
pub fn portions<L: Lanes, R: Row>() -> Range<usize> {
    0..R::LEN / L::COUNT
}

#[inline(always)]
fn place<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, placing: &Placing) {
    let turn = &block.turns[placing.class];
    let (local, reach) = (&block.lengths.reaches[placing.reach], &mut block.reaches[placing.reach]);
    for k in portions::<L, R>() {
        let turned = lanes.pair(turn, k).turn(lanes.pair(local, k));
        lanes.store_pair(reach, k, turned);
    }
    if let Some((slider, _)) = placing.slide {
        let (way, slides) = (&block.lengths.ways[placing.reach], &block.slides[slider]);
        for k in portions::<L, R>() {
            let way = lanes.pair(turn, k).turn(lanes.pair(way, k));
            let slid = lanes.pair(reach, k).plus_scaled(way, lanes.load(slides, k));
            lanes.store_pair(reach, k, slid);
        }
    }
    let ends = block.points.get_disjoint_mut([placing.from, placing.to]);
    let [from, to] = ends.expect("a point is placed from another one");
    for k in portions::<L, R>() {
        lanes.store_pair(to, k, lanes.pair(from, k) + lanes.pair(reach, k));
    }
}

/// The larger of two magnitudes; not a number if one is not.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b <= a || a.is_nan() { a } else { b }
}

/// Newton's method for one group.
#[inline(always)]
fn close<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing, sure: f64) -> Correction {
    turn_columns(lanes, block, closing);
    solve::<_, _, true>(lanes, block, closing);
    let first = longest_correction(lanes, block, closing);
    if first <= sure {
        correct(lanes, block, closing, Size::Tiny);
        correct_columns(lanes, block, closing);
        return Correction { first, closed: true, doubt: 0.0 };
    }
    close_by_steps(lanes, block, closing)
}

/// As many steps as it takes, the first of which has been computed.
#[inline(always)]
fn close_by_steps<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) -> Correction {
    let mut before = f64::INFINITY;
    let mut start: Option<[f64; 2]> = None;
    for _ in 0..STEPS {
        let largest = largest_correction(block, closing);
        // Newton's method squares an error and divides it by the sharpness; what that leaves must be rounding.
        let doubt = largest * largest / (dullest(block, closing).sqrt() * UNIT_ROUNDOFF);
        let [first, first_doubt] = start.unwrap_or([largest, doubt]);
        let found = |closed| Correction { first, closed, doubt: first_doubt };
        let far = start.is_none() && largest > GOOD;
        let stuck = largest > 0.5 * before;
        if doubt.is_nan() || far || (stuck && doubt > 1e3) {
            return found(false);
        }
        let size = if largest < SMALL { Size::Small } else { Size::Large };
        correct(lanes, block, closing, size);
        turn_columns(lanes, block, closing);
        if doubt <= 0.25 || stuck {
            return found(true);
        }
        start = Some([first, first_doubt]);
        before = largest;
        solve::<_, _, true>(lanes, block, closing);
    }
    Correction { first: f64::INFINITY, closed: false, doubt: f64::INFINITY }
}

/// The longest correction of a position, its unknowns taken as a vector in radians and parts of the group's reach: not less than
/// its largest one; not a number if one of them is not.
#[inline(always)]
fn longest_correction<L: Lanes, R: Row>(lanes: L, block: &Block<R>, closing: &Closing) -> f64 {
    let zero = lanes.splat(0.0);
    let mut squares = [zero; MANY];
    for (unknown, steps) in closing.unknowns.iter().zip(&block.solution) {
        let scale = lanes.splat(match unknown {
            Unknown::Spin(_) => 1.0,
            Unknown::Slide(_) => 1.0 / closing.reach,
        });
        for k in portions::<L, R>() {
            let step = lanes.load(steps, k) * scale;
            squares[k] = squares[k].plus_product(step, step);
        }
    }
    let (mut sum, mut longest) = (zero, zero);
    for k in portions::<L, R>() {
        sum = sum + squares[k];
        longest = longest.larger(squares[k]);
    }
    if lanes.sum(sum).is_nan() {
        return f64::NAN;
    }
    lanes.largest(longest).sqrt()
}

/// The largest correction in the block's solution, in radians or parts of the largest member.
fn largest_correction<R: Row>(block: &Block<R>, closing: &Closing) -> f64 {
    let (mut turns, mut slides): (f64, f64) = (0.0, 0.0);
    for (unknown, steps) in closing.unknowns.iter().zip(&block.solution) {
        let largest = match unknown {
            Unknown::Spin(_) => &mut turns,
            Unknown::Slide(_) => &mut slides,
        };
        let steps = steps.as_ref().iter().map(|step| step.abs());
        *largest = steps.fold(*largest, larger);
    }
    if slides == 0.0 {
        return turns;
    }
    let members = closing.chains.iter().flat_map(|c| &c.members);
    let members = members.map(|m| &block.columns[m.column]);
    let components = members.flatten().flat_map(|row| row.as_ref());
    let size = components.fold(closing.reach, |size, x| size.max(x.abs()));
    larger(turns, slides / size)
}

/// The smallest squared sharpness of a group's equations.
fn dullest<R: Row>(block: &Block<R>, closing: &Closing) -> f64 {
    let sharpness = (0..R::LEN).map(|position| determinant(block, closing, position)[1]);
    sharpness.fold(1.0, |least, s| if s < least { s } else { least })
}

/// How large corrections are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    /// Their squares are less than rounding.
    Tiny,
    /// Less than [`SMALL`].
    Small,
    Large,
}

/// Adds the corrections of the unknowns.
#[inline(always)]
fn correct<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing, size: Size) {
    for (unknown, steps) in closing.unknowns.iter().zip(&block.solution) {
        match *unknown {
            Unknown::Slide(slider) => {
                let slides = &mut block.slides[slider];
                for k in portions::<L, R>() {
                    lanes.store(slides, k, lanes.load(slides, k) + lanes.load(steps, k));
                }
            }
            Unknown::Spin(class) => {
                let turns = &mut block.turns[class];
                for k in portions::<L, R>() {
                    // The turn whose tangent is the correction: to third order the correction itself, and never more than 90°.
                    let turn = lanes.pair(turns, k);
                    let turned = turn.plus_turned(turn, lanes.load(steps, k));
                    let turned = match size {
                        Size::Tiny => turned,
                        Size::Small => unit(turned),
                        Size::Large => turned * (lanes.splat(1.0) / turned.dot(turned).sqrt()),
                    };
                    lanes.store_pair(turns, k, turned);
                }
            }
        }
    }
}

/// A vector of nearly length 1 brought to that length: rounding must not change lengths in the long run.
///
/// Three terms of 1/√(1 + excess): with an excess up to 1e-6 what they leave is beyond rounding.
#[inline(always)]
pub fn unit<T: Number>(v: Pair<T>) -> Pair<T> {
    let (one, half, rest) = (v.x.same(1.0), v.x.same(0.5), v.x.same(0.375));
    let excess = v.dot(v) - one;
    v * one.minus_product(excess, half.minus_product(excess, rest))
}
