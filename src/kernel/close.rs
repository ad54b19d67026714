use super::compile::{Action, Closing, InputKind, Placing, Source, Unknown};
use super::{Block, Kernel, Single};
use crate::geometry::{LinearSystem, Number, Pair, Reduced, UNIT_ROUNDOFF, Vector};
use crate::mechanism::Reduction;
use nalgebra::DMatrix;

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

/// A group's equations, factored.
#[derive(Clone, Debug)]
pub(super) enum System<T, const M: usize> {
    One([Reduced<1, T>; M]),
    Two([Reduced<2, T>; M]),
    /// One system for each lane.
    Any(Vec<Option<LinearSystem>>),
}

impl<T: Number, const M: usize> System<T, M> {
    /// Room for the system of a group that reduces so.
    pub fn new(reduction: Option<Reduction>) -> Self {
        let x = Pair::splat(Vector::x());
        match reduction {
            Some(Reduction::OneLoop) => System::One([Reduced::new([[x; 3]]); M]),
            Some(Reduction::TwoLoops { .. }) => System::Two([Reduced::new([[x; 3]; 2]); M]),
            None => System::Any(Vec::new()),
        }
    }
}

impl Kernel {
    /// Sets a drive: angles in degrees, or positions along the guide.
    #[inline(always)]
    pub fn set_input<T: Number, const M: usize>(
        &self,
        block: &mut Block<T, M>,
        input: usize,
        values: &[T; M],
    ) {
        match self.inputs[input].kind {
            InputKind::Turning { class } => {
                for (turn, value) in block.turns[class].iter_mut().zip(values) {
                    *turn = value.direction_of_degrees();
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
    pub fn assemble<T: Number, const M: usize>(
        &self,
        block: &mut Block<T, M>,
        sure: f64,
    ) -> Correction {
        let mut worst = Correction {
            first: 0.0,
            closed: true,
            doubt: 0.0,
        };
        for action in &self.actions {
            match action {
                Action::Place(placing) => place(block, placing),
                Action::Close(closing) => {
                    let found = close(block, closing, sure);
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

    /// One Newton step for a group from anywhere; the largest gap of its loops before it.
    ///
    /// Not a number or not finite where the step cannot be made.
    pub fn step(&self, block: &mut Single, group: usize) -> f64 {
        let Some(closing) = self.closing(group) else {
            return f64::NAN;
        };
        arms(block, closing);
        factor(block, closing);
        gaps(block, closing);
        let sides = block.sides[..closing.ends.len()].iter().flatten();
        let gap = sides
            .flat_map(|side| [side.x.abs(), side.y.abs()])
            .fold(0.0, larger);
        solve(block, closing);
        let steps = &block.solution[..closing.unknowns.len()];
        if !steps.iter().flatten().all(|x| x.is_finite()) {
            return f64::INFINITY;
        }
        correct(block, closing, f64::INFINITY);
        gap
    }

    /// Places the points of a group's links from its angles and slides.
    pub fn place(&self, block: &mut Single, group: usize) {
        let mut actions = self.actions.iter();
        let _ = actions.find(|a| matches!(a, Action::Close(closing) if closing.group == group));
        for action in actions {
            match action {
                Action::Place(placing) => place(block, placing),
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

    /// By group, in the first lane: the determinant of its equations, whose sign changes where two branches meet, and the square
    /// of Hadamard's ratio, 1 down to 0 in a singular position.
    #[must_use]
    pub fn determinants(&self, block: &Block<f64, 1>) -> Vec<[f64; 2]> {
        let systems = block.systems.iter().map(|system| match system {
            System::One([s]) => [s.determinant, s.squared_sharpness()],
            System::Two([s]) => [s.determinant, s.squared_sharpness()],
            System::Any(systems) => {
                let determinant = |s: &LinearSystem| [s.determinant(), s.condition().powi(-2)];
                systems
                    .first()
                    .and_then(Option::as_ref)
                    .map_or([0.0; 2], determinant)
            }
        });
        systems.collect()
    }
}

#[inline(always)]
fn place<T: Number, const M: usize>(block: &mut Block<T, M>, placing: &Placing) {
    let turn = &block.turns[placing.class];
    let reach = &mut block.reaches[placing.reach];
    for k in 0..M {
        reach[k] = turn[k].turn(placing.local);
    }
    if let Some((slider, direction)) = placing.slide {
        let slides = &block.slides[slider];
        for k in 0..M {
            reach[k] = reach[k] + turn[k].turn(direction) * slides[k];
        }
    }
    for k in 0..M {
        block.points[placing.to][k] = block.points[placing.from][k] + reach[k];
    }
}

/// The larger of two magnitudes; not a number if one is not.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b <= a { a } else { b }
}

/// Newton's method for one group.
#[inline(always)]
fn close<T: Number, const M: usize>(
    block: &mut Block<T, M>,
    closing: &Closing,
    sure: f64,
) -> Correction {
    let mut before = f64::INFINITY;
    let mut start: Option<[f64; 2]> = None;
    for _ in 0..STEPS {
        arms(block, closing);
        factor(block, closing);
        gaps(block, closing);
        solve(block, closing);
        let largest = largest_correction(block, closing);
        if start.is_none() && largest <= sure {
            correct(block, closing, largest);
            arms(block, closing);
            return Correction {
                first: largest,
                closed: true,
                doubt: 0.0,
            };
        }
        // Newton's method squares an error and divides it by the sharpness; what that leaves must be rounding.
        let doubt =
            largest * largest / (dullest(&block.systems[closing.group]).sqrt() * UNIT_ROUNDOFF);
        let [first, first_doubt] = start.unwrap_or([largest, doubt]);
        let found = |closed| Correction {
            first,
            closed,
            doubt: first_doubt,
        };
        let far = start.is_none() && largest > GOOD;
        let stuck = largest > 0.5 * before;
        if doubt.is_nan() || far || (stuck && doubt > 1e3) {
            return found(false);
        }
        correct(block, closing, largest);
        if doubt <= 0.25 || stuck {
            arms(block, closing);
            return found(true);
        }
        start = Some([first, first_doubt]);
        before = largest;
    }
    Correction {
        first: f64::INFINITY,
        closed: false,
        doubt: f64::INFINITY,
    }
}

/// The largest correction in the block's solution, in radians or parts of the largest member.
#[inline(always)]
fn largest_correction<T: Number, const M: usize>(block: &Block<T, M>, closing: &Closing) -> f64 {
    let (mut turns, mut slides): (f64, f64) = (0.0, 0.0);
    for (unknown, steps) in closing.unknowns.iter().zip(&block.solution) {
        let largest = match unknown {
            Unknown::Spin(_) => &mut turns,
            Unknown::Slide(_) => &mut slides,
        };
        for step in steps {
            let step = step.largest();
            // A NaN must not be lost in a maximum.
            *largest = if step <= *largest { *largest } else { step };
        }
    }
    if slides == 0.0 {
        return turns;
    }
    let mut size = closing.reach;
    for member in &closing.members {
        for arm in &block.arms[member.arm] {
            size = size.max(arm.x.largest()).max(arm.y.largest());
        }
    }
    let slides = slides / size;
    if slides <= turns { turns } else { slides }
}

/// The smallest squared sharpness of a group's equations.
#[inline(always)]
fn dullest<T: Number, const M: usize>(system: &System<T, M>) -> f64 {
    let least = |sharpness: f64, least: f64| if sharpness < least { sharpness } else { least };
    match system {
        System::One(systems) => systems
            .iter()
            .fold(1.0, |l, s| least(s.squared_sharpness().smallest(), l)),
        System::Two(systems) => systems
            .iter()
            .fold(1.0, |l, s| least(s.squared_sharpness().smallest(), l)),
        System::Any(systems) => systems.iter().fold(1.0, |l, s| {
            let condition = s.as_ref().map_or(f64::INFINITY, LinearSystem::condition);
            least(condition.powi(-2), l)
        }),
    }
}

/// Turns the members of all loops, and the guides in them.
#[inline(always)]
fn arms<T: Number, const M: usize>(block: &mut Block<T, M>, closing: &Closing) {
    for member in &closing.members {
        let (turn, arm) = (&block.turns[member.class], &mut block.arms[member.arm]);
        for k in 0..M {
            arm[k] = turn[k].turn(member.local);
        }
    }
    for rail in &closing.rails {
        let (turn, slides) = (&block.turns[rail.class], &block.slides[rail.slider]);
        let (guide, arm) = (&mut block.rails[rail.rail], &mut block.arms[rail.arm]);
        for k in 0..M {
            guide[k] = turn[k].turn(rail.direction);
            arm[k] = arm[k] + guide[k] * slides[k];
        }
    }
}

/// What is missing for the loops to close: from their starts, along their members, to their ends.
#[inline(always)]
fn gaps<T: Number, const M: usize>(block: &mut Block<T, M>, closing: &Closing) {
    differences(&mut block.sides, &block.points, closing);
    for member in &closing.members {
        let (gap, arm) = (&mut block.sides[member.chain], &block.arms[member.arm]);
        for k in 0..M {
            gap[k] = gap[k] - arm[k];
        }
    }
}

/// The values at the loops' ends less those at their starts; zero for a loop that closes on itself.
#[inline(always)]
pub(super) fn differences<T: Number, const M: usize>(
    sides: &mut [[Pair<T>; M]],
    values: &[[Pair<T>; M]],
    closing: &Closing,
) {
    for (side, ends) in sides.iter_mut().zip(&closing.ends) {
        for k in 0..M {
            side[k] = match *ends {
                Some([start, end]) => values[end][k] - values[start][k],
                None => Pair::splat(Vector::zeros()),
            };
        }
    }
}

/// The column of an unknown in a loop.
#[inline(always)]
fn column<T: Number, const M: usize>(
    arms: &[[Pair<T>; M]],
    rails: &[[Pair<T>; M]],
    source: Source,
    k: usize,
) -> Pair<T> {
    match source {
        Source::None => Pair::splat(Vector::zeros()),
        Source::Rail(rail) => rails[rail][k],
        Source::Arm(arm) => arms[arm][k].quarter_turn(),
    }
}

/// Factors a group's equations.
#[inline(always)]
pub(super) fn factor<T: Number, const M: usize>(block: &mut Block<T, M>, closing: &Closing) {
    let (arms, rails) = (&block.arms, &block.rails);
    let column = |source, k| column(arms, rails, source, k);
    match (
        &mut block.systems[closing.group],
        closing.columns.as_slice(),
    ) {
        (System::One(systems), [chain]) => {
            let &[s, t] = chain.first_chunk().expect("a dyad has two unknowns");
            for k in 0..M {
                systems[k] = Reduced::new([[s, s, t].map(|source| column(source, k))]);
            }
        }
        (System::Two(systems), [first, second]) => {
            let columns = [first, second].map(|c| c.first_chunk().expect("four unknowns"));
            let [[s, t, h, _], [u, v, _, g]] = columns.map(|c: &[Source; 4]| *c);
            for k in 0..M {
                let first = [column(h, k), column(s, k), column(t, k)];
                let second = [column(g, k), column(u, k), column(v, k)];
                systems[k] = Reduced::new([first, second]);
            }
        }
        _ => block.systems[closing.group] = System::Any(any_systems(block, closing)),
    }
}

/// The systems of a group that does not reduce, lane by lane.
#[inline(never)]
fn any_systems<T: Number, const M: usize>(
    block: &Block<T, M>,
    closing: &Closing,
) -> Vec<Option<LinearSystem>> {
    let (loops, unknowns) = (closing.ends.len(), closing.unknowns.len());
    let system = |lane: usize| {
        let matrix = DMatrix::from_fn(2 * loops, unknowns, |row, unknown| {
            let source = closing.columns[row / 2][unknown];
            let column = column(&block.arms, &block.rails, source, lane / T::LANES);
            column.lane(lane % T::LANES)[row % 2]
        });
        LinearSystem::new((matrix.nrows() == matrix.ncols()).then_some(matrix)?)
    };
    (0..M * T::LANES).map(system).collect()
}

/// The solution for the block's right sides.
#[inline(always)]
pub(super) fn solve<T: Number, const M: usize>(block: &mut Block<T, M>, closing: &Closing) {
    match &block.systems[closing.group] {
        System::One(systems) => {
            for k in 0..M {
                let [x, y, ..] = systems[k].solve([block.sides[0][k]]);
                (block.solution[0][k], block.solution[1][k]) = (x, y);
            }
        }
        System::Two(systems) => {
            for k in 0..M {
                let solved = systems[k].solve([block.sides[0][k], block.sides[1][k]]);
                for (unknown, value) in block.solution.iter_mut().zip(solved) {
                    unknown[k] = value;
                }
            }
        }
        System::Any(systems) => {
            let sides = &block.sides[..closing.ends.len()];
            let solved: Vec<_> = systems
                .iter()
                .enumerate()
                .map(|(lane, system)| {
                    let sides = sides.iter().flat_map(|side| {
                        let side = side[lane / T::LANES].lane(lane % T::LANES);
                        [side.x, side.y]
                    });
                    let sides: Vec<f64> = sides.collect();
                    system.as_ref().map(|system| system.solve(&sides))
                })
                .collect();
            for (unknown, values) in block
                .solution
                .iter_mut()
                .enumerate()
                .take(closing.unknowns.len())
            {
                for k in 0..M {
                    values[k] = T::from_lanes(|i| {
                        let solved = solved[k * T::LANES + i].as_ref();
                        solved.map_or(f64::NAN, |s| s[unknown])
                    });
                }
            }
        }
    }
}

/// Adds the corrections of the unknowns, of which `largest` is the largest in radians.
#[inline(always)]
fn correct<T: Number, const M: usize>(block: &mut Block<T, M>, closing: &Closing, largest: f64) {
    for (unknown, correction) in closing.unknowns.iter().zip(&block.solution) {
        match *unknown {
            Unknown::Slide(slider) => {
                let slides = &mut block.slides[slider];
                for k in 0..M {
                    slides[k] = slides[k] + correction[k];
                }
            }
            Unknown::Spin(class) => {
                let turns = &mut block.turns[class];
                for k in 0..M {
                    // The turn whose tangent is the correction: to third order the correction itself, and never more than 90°.
                    let turned = turns[k] + turns[k].quarter_turn() * correction[k];
                    turns[k] = if largest < SMALL {
                        unit(turned)
                    } else {
                        turned * (T::splat(1.0) / turned.dot(turned).sqrt())
                    };
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
    let one = T::splat(1.0);
    let excess = v.dot(v) - one;
    v * (one - excess * (T::splat(0.5) - excess * 0.375))
}
