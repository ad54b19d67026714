use super::action::{Action, Closing, InputKind, Placing, Unknown};
use super::columns::{correct_columns, turn_columns};
use super::solve::{determinant, solve};
use super::{Block, Kernel, Single};
use crate::geometry::{
    Lanes, Many, NEAR, Number, OneByOne, Pair, Registers, Row, TOGETHER, UNIT_ROUNDOFF, direction_near, portions,
    quarters_of,
};
use fearless_simd::{Level, dispatch};

/// Most Newton steps for one group from a near start.
const STEPS: usize = 12;

/// Largest first correction, in radians or parts of the group's size, from a start that counts as near.
pub(super) const NEAR_START: f64 = 0.5;

/// Largest correction, in radians, after which [`unit`] restores a direction's length 1.
const SMALL: f64 = 1e-3;

/// Outcome of the assembly of a block's positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// The largest first correction, in radians or parts of the group's size: the error of the start.
    pub first: f64,
    /// The largest last one: what was left before the last step.
    pub last: f64,
    /// Whether every loop closed to rounding.
    pub closed: bool,
    /// The error estimated to remain after the first correction, in units of rounding; only where nothing is `sure`,
    /// else zero.
    pub doubt: f64,
}

impl Correction {
    /// Nothing to correct.
    pub(super) const NONE: Correction = Correction { first: 0.0, last: 0.0, closed: true, doubt: 0.0 };

    /// That of two groups.
    #[inline(always)]
    pub(super) fn and(self, other: Correction) -> Correction {
        Correction {
            first: self.first.max(other.first),
            last: self.last.max(other.last),
            closed: self.closed && other.closed,
            doubt: self.doubt.max(other.doubt),
        }
    }
}

impl Kernel {
    /// Sets a drive to angles in degrees, or to positions along the guide, number by number.
    pub fn set_input<R: Row>(&self, block: &mut Block<R>, input: usize, values: &R) {
        self.set_input_in(OneByOne, block, input, values);
    }

    /// As [`Self::set_input`], in these lanes.
    #[inline(always)]
    pub fn set_input_in<L: Lanes, R: Row>(&self, lanes: L, block: &mut Block<R>, input: usize, values: &R) {
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
    /// The matrix is that of the velocity equations, so a position is as exact as the condition of its velocities
    /// allows. The start must be near: where a first correction exceeds half a radian or half the group's size, or
    /// corrections do not decrease, the loops count as not closed. After a correction of at most `sure`, in radians or
    /// parts of a group's size, no further step is made; with zero, what a step leaves is estimated each time.
    pub fn assemble(&self, block: &mut Single, sure: f64) -> Correction {
        assemble(&self.actions, block, sure)
    }

    /// As [`Self::assemble`], for many positions in the widest registers of the processor.
    pub fn assemble_many(&self, registers: Level, block: &mut Block<Many>, sure: f64) -> Correction {
        assemble_many(&self.actions, registers, block, sure)
    }

    /// One Newton step for a group from any start. Returns the largest gap of its loops before the step, a length, and
    /// that of its ties, in radians.
    ///
    /// NaN or infinite where the equations are singular.
    pub fn step(&self, block: &mut Single, group: usize) -> [f64; 2] {
        let Some(closing) = self.closing(group) else {
            return [f64::NAN; 2];
        };
        turn_columns(OneByOne, block, closing);
        let largest = |sides: &mut dyn Iterator<Item = &[f64; 1]>| sides.map(|[x]| x.abs()).fold(0.0, larger_or_nan);
        let gaps = [
            largest(&mut block.sides[..closing.chains.len()].iter().flatten()),
            largest(&mut block.tie_sides[..closing.ties.len()].iter()),
        ];
        solve(OneByOne, block, closing);
        let steps = &block.solution[..closing.unknowns.len()];
        if !steps.iter().flatten().all(|x| x.is_finite()) {
            return [f64::INFINITY; 2];
        }
        correct(OneByOne, block, closing, Size::Large);
        gaps
    }

    /// Places the points of a group's links by its angles and slides.
    pub fn place(&self, block: &mut Single, group: usize) {
        let after = self.closings.get(group).map_or(self.actions.len(), |closing| closing + 1);
        for action in &self.actions[after..] {
            match action {
                Action::Place(placing) => place(OneByOne, block, placing),
                Action::Close(_) => break,
            }
        }
    }

    fn closing(&self, group: usize) -> Option<&Closing> {
        match self.actions.get(*self.closings.get(group)?)? {
            Action::Close(closing) => Some(closing),
            Action::Place(_) => None,
        }
    }

    /// 1 over the determinant of a group's equations at one position, as they have been factored last.
    #[inline(always)]
    pub(crate) fn inverse_determinant<R: Row>(&self, block: &Block<R>, group: usize, position: usize) -> f64 {
        let system = &block.systems[group];
        match system.general.get(position) {
            Some(general) => general.as_ref().map_or(f64::INFINITY, |general| 1.0 / general.determinant()),
            None => system.inverse_determinant[position],
        }
    }

    /// The same at all positions of a block.
    #[inline(always)]
    pub(crate) fn inverse_determinants<R: Row>(&self, block: &Block<R>, group: usize) -> R {
        let system = &block.systems[group];
        let mut row = system.inverse_determinant;
        for (position, _) in system.general.iter().enumerate() {
            row[position] = self.inverse_determinant(block, group, position);
        }
        row
    }

    /// A group's determinant and the square of Hadamard's ratio, as in [`Self::determinants`].
    pub(crate) fn determinant(&self, block: &Single, group: usize) -> [f64; 2] {
        self.closing(group).map_or([0.0; 2], |closing| determinant(block, closing, 0))
    }

    /// By group: the determinant of its equations, which changes its sign where two branches meet, and the square of
    /// Hadamard's ratio, between 0 in a singular position and 1.
    #[must_use]
    pub fn determinants(&self, block: &Single) -> Vec<[f64; 2]> {
        let groups = 0..block.systems.len();
        let closings = groups.filter_map(|group| self.closing(group));
        closings.map(|c| determinant(block, c, 0)).collect()
    }
}

/// Carries out these actions for positions, as [`Kernel::assemble`] says.
///
/// A function of its own, as that for many: the compiler would repeat what is in it wherever it is called.
#[inline(never)]
pub(super) fn assemble(actions: &[Action], block: &mut Single, sure: f64) -> Correction {
    assemble_in(OneByOne, actions, block, sure)
}

#[inline(never)]
pub(super) fn assemble_many(actions: &[Action], registers: Level, block: &mut Block<Many>, sure: f64) -> Correction {
    dispatch!(registers, simd => assemble_in(Registers::<_, TOGETHER>(simd), actions, block, sure))
}

#[inline(always)]
fn assemble_in<L: Lanes, R: Row>(lanes: L, actions: &[Action], block: &mut Block<R>, sure: f64) -> Correction {
    let mut worst = Correction::NONE;
    for action in actions {
        match action {
            Action::Place(placing) => place(lanes, block, placing),
            Action::Close(closing) => {
                worst = worst.and(close(lanes, block, closing, sure));
                if !worst.closed {
                    return worst;
                }
            }
        }
    }
    worst
}

#[inline(always)]
pub(super) fn place<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, placing: &Placing) {
    let turn = &block.turns[placing.class];
    let (local, reach) = (&block.lengths.reaches[placing.reach], &mut block.reaches[placing.reach]);
    for k in portions::<L, R>() {
        let turned = lanes.pair(turn, k).turn(lanes.pair(local, k));
        lanes.store_pair(reach, k, turned);
    }
    if let Some(slider) = placing.slide {
        let (way, slides) = (&block.lengths.guides[placing.reach], &block.slides[slider]);
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

/// The larger of two magnitudes; NaN if one is NaN.
#[inline(always)]
fn larger_or_nan(a: f64, b: f64) -> f64 {
    if b <= a || a.is_nan() { a } else { b }
}

/// Closes one group by Newton's method, until only rounding remains.
#[inline(always)]
fn close<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing, sure: f64) -> Correction {
    let mut before = f64::INFINITY;
    let mut start: Option<[f64; 2]> = None;
    for _ in 0..STEPS {
        turn_columns(lanes, block, closing);
        let longest = solve(lanes, block, closing);
        if longest <= sure {
            correct(lanes, block, closing, Size::Tiny);
            correct_columns(lanes, block, closing);
            let [first, doubt] = start.unwrap_or([longest, 0.0]);
            return Correction { first, last: longest, closed: true, doubt };
        }
        if sure > 0.0 && longest <= 0.5 * before.min(2.0 * NEAR_START) {
            start.get_or_insert([longest, 0.0]);
            correct(lanes, block, closing, Size::of(longest));
            before = longest;
            continue;
        }
        let largest = largest_correction(block, closing);
        // A Newton step leaves the square of the error divided by Hadamard's ratio; compared with rounding.
        let doubt = largest * largest / (least_squared_ratio(block, closing).sqrt() * UNIT_ROUNDOFF);
        let is_far = start.is_none() && largest > NEAR_START;
        let is_stuck = largest > 0.5 * before;
        let [first, first_doubt] = *start.get_or_insert([largest, doubt]);
        let found = |closed| Correction { first, last: largest, closed, doubt: first_doubt };
        if doubt.is_nan() || is_far || (is_stuck && doubt > 1e3) {
            return found(false);
        }
        correct(lanes, block, closing, Size::of(largest));
        if doubt <= 0.25 || is_stuck {
            turn_columns(lanes, block, closing);
            return found(true);
        }
        before = largest;
    }
    Correction { first: f64::INFINITY, last: f64::INFINITY, closed: false, doubt: f64::INFINITY }
}

/// The largest component of a correction in the block, in radians or parts of the group's largest vector.
#[cold]
#[inline(never)]
fn largest_correction<R: Row>(block: &Block<R>, closing: &Closing) -> f64 {
    let largest = |largest: f64, row: &R| row.as_ref().iter().fold(largest, |l, x| larger_or_nan(l, x.abs()));
    let (mut turns, mut slides): (f64, f64) = (0.0, 0.0);
    for (unknown, steps) in closing.unknowns.iter().zip(&block.solution) {
        match unknown {
            Unknown::Spin(_) => turns = largest(turns, steps),
            Unknown::Slide(_) => slides = largest(slides, steps),
        }
    }
    if slides == 0.0 {
        return turns;
    }
    let mut size = closing.size;
    for member in closing.chains.iter().flat_map(|c| &c.members) {
        for row in &block.columns[member.column] {
            size = row.as_ref().iter().fold(size, |size, x| size.max(x.abs()));
        }
    }
    larger_or_nan(turns, slides / size)
}

/// The smallest square of Hadamard's ratio of a group's equations over all positions.
#[cold]
#[inline(never)]
fn least_squared_ratio<R: Row>(block: &Block<R>, closing: &Closing) -> f64 {
    let ratios = (0..R::LEN).map(|position| determinant(block, closing, position)[1]);
    ratios.fold(1.0, |least, s| if s < least { s } else { least })
}

/// Magnitude of corrections.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Size {
    /// Their squares are below rounding.
    Tiny,
    /// Less than [`SMALL`].
    Small,
    Large,
}

impl Size {
    #[inline(always)]
    pub fn of(largest: f64) -> Size {
        if largest < SMALL { Size::Small } else { Size::Large }
    }
}

/// Adds the corrections to the unknowns.
#[inline(always)]
pub(super) fn correct<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing, size: Size) {
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
                    // The rotation by the arctangent of the correction: equal to the correction to second order, and
                    // always less than 90°.
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

/// Restores length 1 of a vector that rounding has changed slightly; errors would add up over many positions.
///
/// Three terms of 1/√(1 + excess): for an excess up to 1e-6 the remainder is below rounding.
#[inline(always)]
pub fn unit<T: Number>(v: Pair<T>) -> Pair<T> {
    let (one, half, rest) = (v.x.one(), v.x.eighths(4), v.x.eighths(3));
    let excess = v.dot(v) - one;
    v * one.minus_product(excess, half.minus_product(excess, rest))
}
