use super::drive::{in_radians, ratios, stands};
use super::position::start;
use super::{CycleError, Drive, Position};
use crate::construction::Rate;
use crate::geometry::{MANY, Many, Row};
use crate::kernel::{Block, InputKind, Kernel, Single};
use crate::mechanism::Mechanism;
use crate::position::Pose;
use fearless_simd::{Level, dispatch};

/// Mechanisms of one kind side by side: the same links, joints and drives in the same order, each with lengths and
/// drives of its own.
///
/// For searches over lengths: positions and rates of all of them are computed together, [`MANY`] in the widest
/// registers that the processor has.
#[derive(Clone, Debug)]
pub struct Variants<'a> {
    mechanisms: &'a [Mechanism],
    kernels: Vec<Kernel>,
    blocks: Vec<Block<Many>>,
    /// Where the mechanisms of the block that is being moved were.
    left: Stand,
    /// By mechanism and drive: the drive's value.
    drives: Vec<Vec<f64>>,
    /// By mechanism and drive: the drive's value in the pose that the mechanism had first.
    starts: Vec<Vec<f64>>,
    /// By mechanism: whether it closed at the values its drives were set to last.
    closed: Vec<bool>,
    registers: Level,
}

impl<'a> Variants<'a> {
    /// The mechanisms in these poses, with the rates that their drives have.
    ///
    /// # Errors
    /// One is a drawn configuration, or not of the kind of the first.
    ///
    /// # Panics
    /// There are not as many poses as mechanisms.
    pub fn new(mechanisms: &'a [Mechanism], poses: &[Pose]) -> Result<Self, CycleError> {
        assert_eq!(mechanisms.len(), poses.len(), "each mechanism needs its pose");
        let mut variants = Variants::unplaced(mechanisms, poses.iter())?;
        for (index, pose) in poses.iter().enumerate() {
            let started = start(&variants.kernels[index], &mechanisms[index], pose);
            variants.put((&started.turns, &started.slides), 0, index);
        }
        variants.compute();
        Ok(variants)
    }

    /// The mechanisms, all to be started in poses of the first one; `None` where they are drawn, or not of one kind.
    pub(super) fn all_in(mechanisms: &'a [Mechanism], pose: &Pose) -> Option<Self> {
        Variants::unplaced(mechanisms, std::iter::repeat_n(pose, mechanisms.len())).ok()
    }

    /// Puts all mechanisms into a pose of the first one, from which they have to be moved to their own.
    pub(super) fn start_all_in(&mut self, pose: &Pose) {
        let started = start(&self.kernels[0], &self.mechanisms[0], pose);
        for index in 0..self.count() {
            self.put((&started.turns, &started.slides), 0, index);
        }
    }

    /// The mechanisms with their lengths and rates, at no position yet; the values of drives that no scene gives are those of the poses.
    fn unplaced<'p>(mechanisms: &'a [Mechanism], poses: impl Iterator<Item = &'p Pose>) -> Result<Self, CycleError> {
        let kernels: Vec<Kernel> =
            mechanisms.iter().map(Kernel::new).collect::<Option<_>>().ok_or(CycleError::Drawn)?;
        let kind = kernels.first().map(Kernel::kind);
        if let Some(number) = kernels.iter().position(|k| Some(k.kind()) != kind) {
            return Err(CycleError::NotOfOneKind(number));
        }
        let count = kernels.len();
        let block = |first: usize| {
            let mut block: Block<Many> = Block::new(&kernels[first]);
            for lane in 0..MANY {
                // Lanes beyond the last mechanism repeat it.
                let kernel = &kernels[(first + lane).min(count - 1)];
                block.set_lengths(lane, kernel);
                for input in &kernel.inputs {
                    let (rates, seconds) = match input.kind {
                        InputKind::Turning { class } => (&mut block.omegas[class], &mut block.alphas[class]),
                        InputKind::Sliding { slider } => (&mut block.speeds[slider], &mut block.accelerations[slider]),
                    };
                    (rates[lane], seconds[lane]) = (input.rate, input.second);
                }
            }
            block
        };
        let drives = |(kernel, pose): (&Kernel, &Pose)| kernel.inputs.iter().map(|i| stands(i, pose)).collect();
        let drives: Vec<Vec<f64>> = kernels.iter().zip(poses).map(drives).collect();
        Ok(Variants {
            mechanisms,
            starts: drives.clone(),
            blocks: (0..count).step_by(MANY).map(block).collect(),
            drives,
            closed: vec![false; count],
            left: Stand::default(),
            kernels,
            registers: Level::new(),
        })
    }

    /// Number of mechanisms.
    #[must_use]
    pub fn count(&self) -> usize {
        self.mechanisms.len()
    }

    /// The values of a mechanism's drives, to be set: angles in degrees, or positions along guides, in the order of
    /// [`Mechanism::drive_names`].
    pub fn drives_mut(&mut self, mechanism: usize) -> &mut [f64] {
        &mut self.drives[mechanism]
    }

    /// The value of a drive in the pose that a mechanism had first.
    #[must_use]
    pub fn start(&self, mechanism: usize, drive: &Drive) -> f64 {
        self.starts[mechanism][drive.input]
    }

    /// Sets one drive of a mechanism to a value; its other drives run along from the first pose in proportion to their speeds.
    pub fn set_along(&mut self, mechanism: usize, drive: &Drive, value: f64) {
        if let [only] = &mut self.drives[mechanism][..] {
            *only = value;
            return;
        }
        let from = self.starts[mechanism][drive.input];
        let ratios = ratios(&self.kernels[mechanism], drive.input);
        for (index, ratio) in ratios.into_iter().enumerate() {
            // The moved drive's own value keeps all of its bits.
            let own = self.starts[mechanism][index] + (value - from) * ratio;
            self.drives[mechanism][index] = if index == drive.input { value } else { own };
        }
    }

    /// Whether all drives run at constant speeds, and the moved one does move: then a change of its value takes a time.
    #[must_use]
    pub fn runs_evenly(&self, mechanism: usize, drive: &Drive) -> bool {
        let inputs = &self.kernels[mechanism].inputs;
        inputs[drive.input].rate != 0.0 && inputs.iter().all(|input| input.second == 0.0)
    }

    /// The time in which a drive's value changes by so much.
    #[must_use]
    pub fn time(&self, mechanism: usize, drive: &Drive, change: f64) -> f64 {
        let input = &self.kernels[mechanism].inputs[drive.input];
        in_radians(input.kind, change) / input.rate
    }

    /// Where all mechanisms are now, with their rates.
    #[must_use]
    pub fn kept(&self) -> Kept {
        Kept(self.blocks.iter().map(|block| Rates::of(&self.kernels[0], block)).collect())
    }

    /// Puts a mechanism where it was; its drives must then be set to values near those it had.
    pub fn put_back(&mut self, mechanism: usize, kept: &Kept) {
        let stand = kept.0[mechanism / MANY].rows(&self.blocks[mechanism / MANY]);
        self.put((stand.turns, stand.slides), mechanism % MANY, mechanism);
    }

    /// Puts a mechanism where another position has its lane.
    fn put<R: Row>(&mut self, (turns, slides): (&[[R; 2]], &[R]), here: usize, mechanism: usize) {
        let (block, lane) = (&mut self.blocks[mechanism / MANY], mechanism % MANY);
        // Lanes beyond the last mechanism repeat it.
        let last = if mechanism + 1 == self.mechanisms.len() { MANY } else { lane + 1 };
        (lane..last).for_each(|to| copy((turns, slides), here, block, to));
    }

    /// Whether a mechanism closed at the values its drives were set to last.
    #[must_use]
    pub fn is_closed(&self, mechanism: usize) -> bool {
        self.closed[mechanism]
    }

    /// A rate of all mechanisms where they are now, [`MANY`] by [`MANY`]; of what did not close it says nothing.
    pub fn rates(&self, rate: Rate) -> impl Iterator<Item = &[f64]> {
        let kernel = &self.kernels[0];
        let rows = self.blocks.iter().map(move |block| match rate {
            Rate::Angular(order, body) => &[&block.omegas, &block.alphas][order][kernel.seat(body).class].0,
            Rate::Slide(order, slider) => &[&block.speeds, &block.accelerations][order][slider.0].0,
        });
        rows.enumerate().map(|(block, row)| &row[..MANY.min(self.count() - block * MANY)])
    }

    /// By mechanism: whether it has stayed on one branch since `before`, `times[mechanism]` ago: the determinants of all groups kept
    /// their signs, and every angle and slide changed by what the rates at both ends let expect, to a ten-thousandth of a radian or of
    /// the slide. Rates that change faster than the two positions show are found so, too.
    ///
    /// # Panics
    /// There are not as many times as mechanisms.
    #[must_use]
    pub fn kept_branch(&self, before: &Kept, times: &[f64]) -> Vec<bool> {
        assert_eq!(times.len(), self.count(), "each mechanism needs its time");
        let mut all = Vec::with_capacity(times.len());
        for ((was, block), times) in before.0.iter().zip(&self.blocks).zip(times.chunks(MANY)) {
            let mut time = Many::splat(0.0);
            time.0[..times.len()].copy_from_slice(times);
            let kernel = &self.kernels[0];
            let kept_branch = dispatch!(self.registers, _simd => kept_branch(kernel, was, block, &time));
            all.extend_from_slice(&kept_branch[..times.len()]);
        }
        all
    }

    /// Moves all mechanisms to the values of their drives by Newton's method, which starts at their last positions:
    /// these must be near.
    pub fn compute(&mut self) {
        for first in (0..self.count()).step_by(MANY) {
            let block = first..self.count().min(first + MANY);
            self.left.turns.clone_from(&self.blocks[first / MANY].turns);
            self.left.slides.clone_from(&self.blocks[first / MANY].slides);
            self.closed[block.clone()].fill(true);
            if self.compute_block(first) {
                continue;
            }
            // Some mechanism does not close: find out which, leave those where they were and move the others.
            self.left.give(&mut self.blocks[first / MANY]);
            for index in block.clone() {
                self.closed[index] = self.reaches(index);
            }
            if !self.compute_block(first) {
                self.left.give(&mut self.blocks[first / MANY]);
                self.closed[block].fill(false);
            }
        }
    }

    /// Whether a mechanism closes at the values of its drives, starting from where it is.
    fn reaches(&self, index: usize) -> bool {
        let kernel = &self.kernels[index];
        let mut single = Single::new(kernel);
        let block = &self.blocks[index / MANY];
        copy((&block.turns, &block.slides), index % MANY, &mut single, 0);
        for (input, value) in self.drives[index].iter().enumerate() {
            kernel.set_input(&mut single, input, &[*value]);
        }
        kernel.assemble(&mut single, SURE).closed
    }

    /// Moves those mechanisms of a block that are marked as closed to the values of their drives; whether all loops
    /// closed.
    fn compute_block(&mut self, first: usize) -> bool {
        let (count, kernel) = (self.count(), &self.kernels[first]);
        let block = &mut self.blocks[first / MANY];
        for input in 0..kernel.inputs.len() {
            let mut values = Many::splat(0.0);
            for lane in 0..MANY {
                values[lane] = self.drives[(first + lane).min(count - 1)][input];
            }
            kernel.set_input(block, input, &values);
        }
        for lane in 0..MANY {
            if !self.closed[(first + lane).min(count - 1)] {
                copy((&self.left.turns, &self.left.slides), lane, block, lane);
            }
        }
        let is_closed = kernel.assemble_many(self.registers, block, SURE).closed;
        if is_closed {
            kernel.rates_many(self.registers, block);
        }
        is_closed
    }

    /// The position of a mechanism, with its rates; `None` if it did not close at the values of its drives.
    #[must_use]
    pub fn position(&self, mechanism: usize) -> Option<Position<'_, Many>> {
        self.closed[mechanism].then(|| Position {
            mechanism: &self.mechanisms[mechanism],
            kernel: &self.kernels[mechanism],
            block: &self.blocks[mechanism / MANY],
            lane: mechanism % MANY,
        })
    }
}

/// Angle, in radians, or part of a slide to which positions and rates must agree.
const AGREED: f64 = 1e-4;

/// Correction, in radians or parts of a group's size, whose square is a hundredth of rounding; both grow alike towards singular positions.
const SURE: f64 = 1e-9;

/// The sine of up to a radian, to a millionth.
#[inline(always)]
fn short_sine(x: f64) -> f64 {
    let square = x * x;
    x * (1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0))))
}

/// Where mechanisms side by side were, with their rates.
#[derive(Clone, Debug)]
pub struct Kept(Vec<Rates>);

/// Where the mechanisms of a block were.
#[derive(Clone, Debug, Default)]
struct Stand {
    turns: Vec<[Many; 2]>,
    slides: Vec<Many>,
}

impl Stand {
    /// Puts all of them back.
    fn give(&self, block: &mut Block<Many>) {
        block.turns.clone_from(&self.turns);
        block.slides.clone_from(&self.slides);
    }
}

/// All rows of a block in one piece of memory: many are kept.
#[derive(Clone, Debug)]
struct Rates(Vec<Many>);

/// The rows of [`Rates`].
struct Rows<'a> {
    turns: &'a [[Many; 2]],
    slides: &'a [Many],
    omegas: &'a [Many],
    alphas: &'a [Many],
    speeds: &'a [Many],
    accelerations: &'a [Many],
    /// By group.
    inverse_determinants: &'a [Many],
}

impl Rates {
    fn of(kernel: &Kernel, block: &Block<Many>) -> Rates {
        let groups = kernel.unknowns.len();
        let mut rows = Vec::with_capacity(4 * block.omegas.len() + 3 * block.slides.len() + groups);
        rows.extend_from_slice(block.turns.as_flattened());
        for part in [&block.slides, &block.omegas, &block.alphas, &block.speeds, &block.accelerations] {
            rows.extend_from_slice(part);
        }
        rows.extend((0..groups).map(|group| kernel.inverse_determinants(block, group)));
        Rates(rows)
    }

    /// The rows, of which a block has as many.
    fn rows(&self, block: &Block<Many>) -> Rows<'_> {
        let (classes, sliders) = (block.omegas.len(), block.slides.len());
        let (turns, rest) = self.0.split_at(2 * classes);
        let (slides, rest) = rest.split_at(sliders);
        let (omegas, rest) = rest.split_at(classes);
        let (alphas, rest) = rest.split_at(classes);
        let (speeds, rest) = rest.split_at(sliders);
        let (accelerations, inverse_determinants) = rest.split_at(sliders);
        Rows { turns: turns.as_chunks().0, slides, omegas, alphas, speeds, accelerations, inverse_determinants }
    }
}

/// As [`Variants::kept_branch`], for the mechanisms of a block.
///
/// What is wrong is counted, in numbers, so that the compiler uses registers of many.
#[inline(always)]
fn kept_branch(kernel: &Kernel, was: &Rates, block: &Block<Many>, time: &Many) -> [bool; MANY] {
    let was = was.rows(block);
    let mut wrong = Many::splat(0.0);
    let mut ask = |lane: usize, is_right: bool| wrong[lane] += if is_right { 0.0 } else { 1.0 };
    for (group, was) in was.inverse_determinants.iter().enumerate() {
        let is = kernel.inverse_determinants(block, group);
        for lane in 0..MANY {
            ask(
                lane,
                (is[lane].abs() < f64::INFINITY) & (was[lane].abs() < f64::INFINITY) & (is[lane] * was[lane] > 0.0),
            );
        }
    }
    let passed =
        |time: f64, was: [f64; 2], is: [f64; 2]| time * (0.5 * (was[0] + is[0]) + time / 12.0 * (was[1] - is[1]));
    for (class, (from, to)) in was.turns.iter().zip(&block.turns).enumerate() {
        let (omegas, alphas) = ([&was.omegas[class], &block.omegas[class]], [&was.alphas[class], &block.alphas[class]]);
        for lane in 0..MANY {
            let rates = |end: usize| [omegas[end][lane], alphas[end][lane]];
            let by = passed(time[lane], rates(0), rates(1));
            let ([c0, s0], [c1, s1]) = ([from[0][lane], from[1][lane]], [to[0][lane], to[1][lane]]);
            let (sine, cosine) = (c0 * s1 - s0 * c1, c0 * c1 + s0 * s1);
            ask(lane, (by.abs() <= 1.0) & (cosine > 0.0) & ((sine - short_sine(by)).abs() <= AGREED));
        }
    }
    for (slider, (from, to)) in was.slides.iter().zip(&block.slides).enumerate() {
        let speeds = [&was.speeds[slider], &block.speeds[slider]];
        let seconds = [&was.accelerations[slider], &block.accelerations[slider]];
        for lane in 0..MANY {
            let rates = |end: usize| [speeds[end][lane], seconds[end][lane]];
            let by = passed(time[lane], rates(0), rates(1));
            let size = to[lane].abs().max(from[lane].abs());
            let moved = to[lane] - from[lane];
            ask(lane, (moved - by).abs() <= AGREED * size.max(moved.abs()));
        }
    }
    wrong.0.map(|count| count == 0.0)
}

/// Copies all angles and slides of one position to another.
fn copy<A: Row, B: Row>((turns, slides): (&[[A; 2]], &[A]), here: usize, to: &mut Block<B>, there: usize) {
    for (to, from) in to.turns.iter_mut().zip(turns) {
        for axis in 0..2 {
            to[axis][there] = from[axis][here];
        }
    }
    for (to, from) in to.slides.iter_mut().zip(slides) {
        to[there] = from[here];
    }
}
