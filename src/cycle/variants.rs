use super::start::{stands, start};
use super::{CycleError, Position};
use crate::geometry::{Lanes, MANY, Many, OneByOne, Registers, Row};
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
    /// By mechanism and drive: the drive's value.
    drives: Vec<Vec<f64>>,
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
        let kernels: Vec<Kernel> =
            mechanisms.iter().map(Kernel::new).collect::<Option<_>>().ok_or(CycleError::Drawn)?;
        if let Some(number) = kernels.iter().position(|k| !kernels[0].is_like(k)) {
            return Err(CycleError::NotOfOneKind { number });
        }
        let count = kernels.len();
        let block = |first: usize| {
            let mut block: Block<Many> = Block::new(&kernels[first]);
            for lane in 0..MANY {
                // Lanes beyond the last mechanism repeat it.
                let index = (first + lane).min(count - 1);
                let (kernel, mechanism) = (&kernels[index], &mechanisms[index]);
                block.set_lengths(lane, kernel);
                copy(&start(kernel, mechanism, &poses[index]), 0, &mut block, lane);
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
        let mut variants = Variants {
            mechanisms,
            blocks: (0..count).step_by(MANY).map(block).collect(),
            drives: kernels.iter().zip(poses).map(drives).collect(),
            closed: vec![false; count],
            kernels,
            registers: Level::new(),
        };
        variants.compute();
        Ok(variants)
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

    /// Moves all mechanisms to the values of their drives by Newton's method, which starts at their last positions:
    /// these must be near.
    pub fn compute(&mut self) {
        for first in (0..self.count()).step_by(MANY) {
            let before = self.blocks[first / MANY].clone();
            let block = first..self.count().min(first + MANY);
            self.closed[block.clone()].fill(true);
            if !self.compute_block(first) {
                // Some mechanism does not close: find out which, leave those where they were and move the others.
                for index in block {
                    self.closed[index] = self.reaches(index, &before, index - first);
                }
                self.blocks[first / MANY] = before;
                self.compute_block(first);
            }
        }
    }

    /// Whether a mechanism closes at the values of its drives, starting from its position in `block`.
    fn reaches(&self, index: usize, block: &Block<Many>, lane: usize) -> bool {
        let kernel = &self.kernels[index];
        let mut single = Single::new(kernel);
        copy(block, lane, &mut single, 0);
        for (input, value) in self.drives[index].iter().enumerate() {
            kernel.set_input(OneByOne, &mut single, input, &[*value]);
        }
        kernel.assemble(OneByOne, &mut single, 0.0).closed
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
            let before = block.clone();
            kernel.set_input(OneByOne, block, input, &values);
            for lane in 0..MANY {
                if !self.closed[(first + lane).min(count - 1)] {
                    copy(&before, lane, block, lane);
                }
            }
        }
        dispatch!(self.registers, simd => positions_and_rates(Registers(simd), kernel, block))
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

/// Copies all angles and slides of one position to another.
fn copy<A: Row, B: Row>(from: &Block<A>, here: usize, to: &mut Block<B>, there: usize) {
    for (to, from) in to.turns.iter_mut().zip(&from.turns) {
        for axis in 0..2 {
            to[axis][there] = from[axis][here];
        }
    }
    for (to, from) in to.slides.iter_mut().zip(&from.slides) {
        to[there] = from[here];
    }
}

/// Positions and rates of a block; whether its loops have closed.
#[inline(always)]
fn positions_and_rates<L: Lanes>(lanes: L, kernel: &Kernel, block: &mut Block<Many>) -> bool {
    let found = kernel.assemble(lanes, block, 0.0);
    if found.closed {
        kernel.rates(lanes, block);
    }
    found.closed
}
