use super::{Path, Position};
use crate::geometry::{Lanes, MANY, Many, OneByOne, Registers, Row};
use crate::kernel::{Block, Kernel, Single};
use pulp::{Arch, Simd, WithSimd};

/// How near a change point there is nothing to read, in parts of a turn: rounding leaves about u / distance³ of second rates.
const BLANK: f64 = 1e-4;

/// Computes positions and rates anywhere on a path in memory of its own: one position at a time, or [`MANY`].
#[derive(Clone, Debug)]
pub struct Walker<'a, R: Row = [f64; 1]> {
    path: &'a Path<'a>,
    kernel: &'a Kernel,
    block: Block<R>,
    segment: usize,
    registers: Arch,
}

impl<'a, R: Row> Walker<'a, R> {
    pub(super) fn new(path: &'a Path<'a>, kernel: &'a Kernel) -> Self {
        Self { path, kernel, block: Block::new(kernel), segment: 0, registers: Arch::new() }
    }

    /// Finds the segment that holds a value.
    #[inline(always)]
    fn seek(&mut self, value: f64) -> bool {
        let segments = &self.path.segments;
        if segments.get(self.segment).is_some_and(|s| s.holds(value)) {
            return true;
        }
        let found = self.path.segment(value);
        self.segment = found.unwrap_or(self.segment);
        found.is_some()
    }

    /// Assembles the mechanism at values that all lie on the segment found.
    #[inline(always)]
    fn assemble<L: Lanes>(&mut self, lanes: L, values: &R) -> bool {
        let segment = &self.path.segments[self.segment];
        if !segment.holds_all(lanes, values) || self.is_blank(values) {
            return false;
        }
        self.path.set_inputs(lanes, &mut self.block, values);
        segment.predict(lanes, values, &mut self.block);
        let found = self.kernel.assemble(lanes, &mut self.block, segment.sure);
        found.closed
    }

    /// Whether a value is next to a change point.
    #[inline(always)]
    fn is_blank(&self, values: &R) -> bool {
        let blank = BLANK * self.path.unit();
        let near = |at: f64| values.as_ref().iter().any(|v| (v - at).abs() < blank);
        self.path.changes.iter().any(|change| near(change.at))
    }

    #[inline(always)]
    fn scene_rates<L: Lanes>(&mut self, lanes: L) {
        for (index, input) in self.kernel.inputs.iter().enumerate() {
            let block = &mut self.block;
            self.kernel.set_rates(block, index, input.rate, input.second);
        }
        self.kernel.rates(lanes, &mut self.block);
    }
}

/// One position at a time.
impl Walker<'_> {
    /// The position at a value of the drive; `None` where that has not been reached, is singular, or next to a change point.
    #[inline]
    pub fn positions(&mut self, value: &[f64; 1]) -> Option<&mut Single> {
        let found = self.seek(value[0]) && self.assemble(OneByOne, value);
        found.then_some(&mut self.block)
    }

    /// The position and the rates for the drives running as the scene says; `None` as for [`Self::positions`].
    #[inline]
    pub fn motions(&mut self, value: &[f64; 1]) -> Option<&Single> {
        self.positions(value)?;
        Some(self.rates())
    }

    /// The rates at the position computed last, for the drives running as the scene says.
    #[inline]
    pub fn rates(&mut self) -> &Single {
        self.scene_rates(OneByOne);
        &self.block
    }

    /// The position at a value of the drive, with its rates; `None` where it has not been reached or is singular.
    pub fn position(&mut self, value: f64) -> Option<Position<'_>> {
        let path = self.path;
        let block = self.motions(&[value])?;
        Some(path.position(block, 0))
    }

    /// The motion for the drive running by one unit of its value a unit of time.
    pub(super) fn unit_motion(&mut self, value: f64) -> Option<&Single> {
        self.positions(&[value])?;
        self.path.unit_rates(&mut self.block);
        Some(&self.block)
    }
}

/// [`MANY`] positions at a time, in the widest registers that the processor has.
///
/// Last digits may differ from those of one position at a time: where the processor multiplies and adds with one rounding, this does.
impl Walker<'_, Many> {
    /// Positions at the first of some values of the drive: as many as lie on one segment of the path, at most [`MANY`].
    ///
    /// The block's other positions repeat the last. None where one of these positions has not been reached, is singular, or
    /// next to a change point: then ask one by one.
    #[inline]
    pub fn positions(&mut self, values: &[f64]) -> (usize, Option<&Block<Many>>) {
        self.compute(values, Task::Positions)
    }

    /// The same with the rates for the drives running as the scene says.
    #[inline]
    pub fn motions(&mut self, values: &[f64]) -> (usize, Option<&Block<Many>>) {
        self.compute(values, Task::Motions)
    }

    /// The rates at the positions computed last, for the drives running as the scene says.
    #[inline]
    pub fn rates(&mut self) -> &Block<Many> {
        self.dispatch(&Many::splat(0.0), Task::Rates);
        &self.block
    }

    #[inline]
    fn compute(&mut self, values: &[f64], task: Task) -> (usize, Option<&Block<Many>>) {
        let Some(first) = values.first() else {
            return (0, None);
        };
        if !self.seek(*first) {
            return (1, None);
        }
        // In order, as they mostly are, they all lie on a segment if the last does; that they do is made sure of in the registers.
        let segment = &self.path.segments[self.segment];
        let full = values.first_chunk::<MANY>();
        if let Some(full) = full.filter(|v| segment.holds(v[MANY - 1]))
            && self.dispatch(&Many(*full), task)
        {
            return (MANY, Some(&self.block));
        }
        let mut row = Many([*first; MANY]);
        let mut count = 0;
        for (place, value) in row.0.iter_mut().zip(values) {
            if !segment.holds(*value) {
                break;
            }
            *place = *value;
            count += 1;
        }
        let last = row.0[count - 1];
        row.0[count..].fill(last);
        let found = self.dispatch(&row, task);
        (count, found.then_some(&self.block))
    }

    #[inline]
    fn dispatch(&mut self, values: &Many, task: Task) -> bool {
        self.registers.dispatch(Together { walker: self, values, task })
    }
}

/// What is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Task {
    Positions,
    Rates,
    Motions,
}

/// A calculation for the registers that the processor turns out to have.
struct Together<'w, 'a> {
    walker: &'w mut Walker<'a, Many>,
    values: &'w Many,
    task: Task,
}

impl WithSimd for Together<'_, '_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let lanes = Registers(simd);
        let found = self.task == Task::Rates || self.walker.assemble(lanes, self.values);
        if found && self.task != Task::Positions {
            self.walker.scene_rates(lanes);
        }
        found
    }
}
