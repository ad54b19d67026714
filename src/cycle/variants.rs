use super::drive::{in_radians, moving, ratios, stands};
use super::kept::{Kept, Rates, kept_branch, run_on};
use super::position::start;
use super::{CycleError, Drive, Position};
use crate::construction::Rate;
use crate::geometry::{MANY, Many, Registers, Row, TOGETHER};
use crate::kernel::{Block, Input, InputKind, Kernel, Single};
use crate::mechanism::Mechanism;
use crate::position::Pose;
use fearless_simd::{Level, dispatch};
use std::ops::Range;

/// Mechanisms of one kind side by side: the same links, joints and drives in the same order, each with lengths and
/// drives of its own.
///
/// For searches over lengths: positions and rates of all of them are computed together, [`MANY`] in the widest
/// registers that the processor has.
#[derive(Clone, Debug)]
pub struct Variants<'a> {
    mechanisms: &'a [Mechanism],
    /// That of one of this kind.
    kernel: Kernel,
    blocks: Vec<Block<Many>>,
    /// Where the mechanisms of the block that is being moved were.
    left: Stand,
    /// By mechanism: its drives.
    inputs: Vec<Input>,
    /// By mechanism: the values of its drives.
    drives: Vec<f64>,
    /// By mechanism: the values of its drives in the pose that it had first.
    starts: Vec<f64>,
    /// By mechanism: whether it closed at the values its drives were set to last.
    closed: Vec<bool>,
    registers: Level,
}

impl<'a> Variants<'a> {
    /// The mechanisms in these poses, with the rates that their drives have.
    ///
    /// # Errors
    /// One is a drawn configuration, or not of the kind of the first; or there is none.
    ///
    /// # Panics
    /// There are not as many poses as mechanisms.
    pub fn new(mechanisms: &'a [Mechanism], poses: &[Pose]) -> Result<Self, CycleError> {
        assert_eq!(mechanisms.len(), poses.len(), "each mechanism needs its pose");
        let kernels: Vec<Kernel> = mechanisms.iter().map(moving).collect::<Result<_, _>>()?;
        let [first, ..] = &kernels[..] else { return Err(CycleError::NotOfOneKind(0)) };
        if let Some(number) = kernels.iter().position(|kernel| !kernel.is_like(first)) {
            return Err(CycleError::NotOfOneKind(number));
        }
        let (mut variants, _) = Variants::unplaced(first.clone(), mechanisms);
        for (index, (kernel, pose)) in kernels.iter().zip(poses).enumerate() {
            let started = start(kernel, &mechanisms[index], pose);
            variants.put((&started.turns, &started.slides), 0, index);
            variants.start_drives(index, pose);
        }
        variants.compute();
        Ok(variants)
    }

    /// The mechanisms with their lengths and rates, at no position yet, and whether all are of the kind of the kernel.
    pub(super) fn unplaced(kernel: Kernel, mechanisms: &'a [Mechanism]) -> (Self, bool) {
        let count = mechanisms.len();
        let inputs: Vec<Input> = mechanisms.iter().flat_map(|mechanism| kernel.inputs_of(mechanism)).collect();
        let drives = kernel.inputs.len();
        let mut is_like = true;
        let block = |first: usize| {
            let mut block: Block<Many> = Block::new(&kernel);
            for lane in 0..MANY {
                // Lanes beyond the last mechanism repeat it.
                let mechanism = (first + lane).min(count - 1);
                is_like &= block.set_lengths(lane, &kernel, &mechanisms[mechanism]);
                for input in &inputs[mechanism * drives..][..drives] {
                    let (rates, seconds) = match input.kind {
                        InputKind::Turning { class } => (&mut block.omegas[class], &mut block.alphas[class]),
                        InputKind::Sliding { slider } => (&mut block.speeds[slider], &mut block.accelerations[slider]),
                    };
                    (rates[lane], seconds[lane]) = (input.rate, input.second);
                }
            }
            block
        };
        let variants = Variants {
            mechanisms,
            blocks: (0..count).step_by(MANY).map(block).collect(),
            drives: vec![0.0; inputs.len()],
            starts: vec![0.0; inputs.len()],
            inputs,
            closed: vec![false; count],
            left: Stand::default(),
            kernel,
            registers: Level::new(),
        };
        (variants, is_like)
    }

    /// Sets the drives of a mechanism to the values that it has in its first pose; those that no scene gives are those of the pose.
    pub(super) fn start_drives(&mut self, mechanism: usize, pose: &Pose) {
        let own = self.of(mechanism);
        for index in own {
            self.starts[index] = stands(&self.inputs[index], pose);
            self.drives[index] = self.starts[index];
        }
    }

    /// The places of a mechanism's drives.
    fn of(&self, mechanism: usize) -> Range<usize> {
        let count = self.kernel.inputs.len();
        mechanism * count..(mechanism + 1) * count
    }

    /// Number of mechanisms.
    #[must_use]
    pub fn count(&self) -> usize {
        self.mechanisms.len()
    }

    /// The values of a mechanism's drives, to be set: angles in degrees, or positions along guides, in the order of
    /// [`Mechanism::drive_names`].
    pub fn drives_mut(&mut self, mechanism: usize) -> &mut [f64] {
        let own = self.of(mechanism);
        &mut self.drives[own]
    }

    /// The value of a drive in the pose that a mechanism had first.
    #[must_use]
    pub fn start(&self, mechanism: usize, drive: &Drive) -> f64 {
        self.starts[self.of(mechanism)][drive.input]
    }

    /// Sets one drive of a mechanism to a value; its other drives run along from the first pose in proportion to their speeds.
    pub fn set_along(&mut self, mechanism: usize, drive: &Drive, value: f64) {
        let own = self.of(mechanism);
        let moved = own.start + drive.input;
        if own.len() > 1 {
            let by = value - self.starts[moved];
            let ratios = ratios(&self.inputs[own.clone()], drive.input);
            for (index, ratio) in own.zip(ratios) {
                self.drives[index] = self.starts[index] + by * ratio;
            }
        }
        // The moved drive's own value keeps all of its bits.
        self.drives[moved] = value;
    }

    /// Whether all drives run at constant speeds, and the moved one does move: then a change of its value takes a time.
    #[must_use]
    pub fn runs_evenly(&self, mechanism: usize, drive: &Drive) -> bool {
        let inputs = &self.inputs[self.of(mechanism)];
        inputs[drive.input].rate != 0.0 && inputs.iter().all(|input| input.second == 0.0)
    }

    /// By mechanism: the time in which a drive's value changes by so much; no time of those that do not move.
    #[must_use]
    pub fn times(&self, drive: &Drive, change: f64, moves: &[bool]) -> Vec<f64> {
        let inputs = self.inputs.iter().skip(drive.input).step_by(self.kernel.inputs.len());
        let time =
            |(input, moves): (&Input, &bool)| if *moves { in_radians(input.kind, change) / input.rate } else { 0.0 };
        inputs.zip(moves).map(time).collect()
    }

    /// Where all mechanisms are now, with their rates.
    #[must_use]
    pub fn kept(&self) -> Kept {
        Kept(self.blocks.iter().map(|block| Rates::of(&self.kernel, block)).collect())
    }

    /// Puts a mechanism where it was; its drives must then be set to values near those it had.
    pub fn put_back(&mut self, mechanism: usize, kept: &Kept) {
        let stand = kept.0[mechanism / MANY].rows(&self.blocks[mechanism / MANY]);
        self.put((stand.turns, stand.slides), mechanism % MANY, mechanism);
    }

    /// Puts a mechanism where another position has its lane.
    pub(super) fn put<R: Row>(&mut self, (turns, slides): (&[[R; 2]], &[R]), here: usize, mechanism: usize) {
        let (block, lane) = (&mut self.blocks[mechanism / MANY], mechanism % MANY);
        // Lanes beyond the last mechanism repeat it.
        let last = if mechanism + 1 == self.mechanisms.len() { MANY } else { lane + 1 };
        (lane..last).for_each(|to| copy((turns, slides), here, block, to));
    }

    /// Puts mechanisms where they are to be expected `times[mechanism]` after `was`, so that few corrections are left to [`Self::compute`]; those
    /// without a time stay. The rates there say it, and those at `before`, if that is as long before.
    ///
    /// # Panics
    /// There are not as many times as mechanisms.
    pub fn run_on(&mut self, before: Option<&Kept>, was: &Kept, times: &[f64]) {
        assert_eq!(times.len(), self.count(), "each mechanism needs its time");
        let kernel = &self.kernel;
        for (index, (block, was)) in self.blocks.iter_mut().zip(&was.0).enumerate() {
            let before = before.map(|before| &before.0[index]);
            let time = row(&times[index * MANY..]);
            dispatch!(self.registers, simd => run_on(Registers::<_, TOGETHER>(simd), kernel, before, was, block, &time));
        }
    }

    /// Whether a mechanism closed at the values its drives were set to last.
    #[must_use]
    pub fn is_closed(&self, mechanism: usize) -> bool {
        self.closed[mechanism]
    }

    /// A rate of all mechanisms where they are now, [`MANY`] by [`MANY`]; of what did not close it says nothing, and beyond the last it is
    /// repeated.
    pub fn rates(&self, rate: Rate) -> impl Iterator<Item = &Many> {
        let kernel = &self.kernel;
        self.blocks.iter().map(move |block| match rate {
            Rate::Angular(order, body) => &[&block.omegas, &block.alphas][order][kernel.seat(body).class],
            Rate::Slide(order, slider) => &[&block.speeds, &block.accelerations][order][slider.0],
        })
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
        let kernel = &self.kernel;
        for ((was, block), times) in before.0.iter().zip(&self.blocks).zip(times.chunks(MANY)) {
            let time = row(times);
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
        let kernel = &self.kernel;
        let mut single = Single::new(kernel);
        single.set_lengths(0, kernel, &self.mechanisms[index]);
        let block = &self.blocks[index / MANY];
        copy((&block.turns, &block.slides), index % MANY, &mut single, 0);
        for (input, value) in self.drives[self.of(index)].iter().enumerate() {
            kernel.set_input(&mut single, input, &[*value]);
        }
        kernel.assemble(&mut single, SURE).closed
    }

    /// Moves those mechanisms of a block that are marked as closed to the values of their drives; whether all loops
    /// closed.
    fn compute_block(&mut self, first: usize) -> bool {
        let (count, kernel, registers) = (self.count(), &self.kernel, self.registers);
        let drives = kernel.inputs.len();
        let block = &mut self.blocks[first / MANY];
        let of_lane = |lane: usize| (first + lane).min(count - 1);
        let begun = dispatch!(registers, simd => {
            let lanes = Registers::<_, TOGETHER>(simd);
            for input in 0..drives {
                let mut values = Many::splat(0.0);
                (0..MANY).for_each(|lane| values[lane] = self.drives[of_lane(lane) * drives + input]);
                kernel.set_input_in(lanes, block, input, &values);
            }
            for lane in (0..MANY).filter(|lane| !self.closed[of_lane(*lane)]) {
                copy((&self.left.turns, &self.left.slides), lane, block, lane);
            }
            kernel.begin_motions(lanes, block, SURE, STEPS)
        });
        kernel.finish_motions(registers, block, SURE, begun).closed
    }

    /// The position of a mechanism, with its rates; `None` if it did not close at the values of its drives.
    #[must_use]
    pub fn position(&self, mechanism: usize) -> Option<Position<'_, Many>> {
        let (block, lane) = (&self.blocks[mechanism / MANY], mechanism % MANY);
        self.closed[mechanism].then(|| Position::new(&self.mechanisms[mechanism], &self.kernel, block, lane))
    }
}

/// Newton steps from where a mechanism is expected, or from another one's assembly; if there must be more, each is made by itself.
const STEPS: usize = 6;

/// Correction, in radians or parts of a group's size, whose square is a hundredth of rounding; both grow alike towards singular positions.
const SURE: f64 = 1e-9;

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

/// A row of these numbers, as many as there are for it; beyond the last that is repeated, as mechanisms are.
fn row(numbers: &[f64]) -> Many {
    let mut row = Many::splat(numbers.last().copied().unwrap_or_default());
    let count = numbers.len().min(MANY);
    row.0[..count].copy_from_slice(&numbers[..count]);
    row
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
