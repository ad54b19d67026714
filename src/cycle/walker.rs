use super::path::{BLANK, Path};
use super::position::Position;
use crate::geometry::{Lanes, MANY, Many, OneByOne, Registers, Row, TOGETHER};
use crate::kernel::{Begun, Block, Correction, Kernel, Single};
use fearless_simd::{Level, dispatch};

impl Path<'_> {
    /// A walker, one position at a time.
    #[must_use]
    pub fn walker(&self) -> Walker<'_> {
        Walker::new(self, &self.kernel)
    }

    /// A walker, [`MANY`](crate::geometry::MANY) positions at a time.
    #[must_use]
    pub fn many_walker(&self) -> Walker<'_, Many> {
        Walker::many(self, &self.kernel)
    }

    /// As [`Self::many_walker`], for angles, slides and their rates only: places and motions of points are left out,
    /// but for the joints between groups.
    #[must_use]
    pub fn many_walker_without_places(&self) -> Walker<'_, Many> {
        Walker::many(self, &self.bare)
    }
}

/// Computes positions and rates anywhere on a path, one position at a time or [`MANY`]; it owns the memory for them.
#[derive(Clone, Debug)]
pub struct Walker<'a, R: Row = [f64; 1]> {
    path: &'a Path<'a>,
    kernel: &'a Kernel,
    block: Block<R>,
    segment: usize,
    registers: Level,
}

impl<'a, R: Row> Walker<'a, R> {
    pub(super) fn new(path: &'a Path<'a>, kernel: &'a Kernel) -> Self {
        Self { path, kernel, block: Block::new(kernel), segment: 0, registers: Level::new() }
    }

    /// Finds the segment that holds a value of the drive; `false` if the path does not reach it.
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

    /// Predicts the mechanism's position at these values of the drive; `false` if they do not all lie on the segment
    /// found, or one is next to a change point.
    #[inline(always)]
    fn predict<L: Lanes>(&mut self, lanes: L, values: &R) -> bool {
        let segment = &self.path.segments[self.segment];
        if !segment.holds_all(lanes, values) || self.is_blank(values) {
            return false;
        }
        self.path.set_inputs(lanes, &mut self.block, values);
        segment.predict(lanes, values, &mut self.block);
        true
    }

    /// Closes predicted positions by `assemble`, which gets what correction is sure; `false` if a loop does not close.
    #[inline(always)]
    fn close(&mut self, assemble: impl FnOnce(&Kernel, &mut Block<R>, f64) -> Correction) -> bool {
        let segment = &self.path.segments[self.segment];
        let found = assemble(self.kernel, &mut self.block, segment.sure);
        if found.closed && segment.delicate {
            self.kernel.refine(&mut self.block);
        }
        found.closed
    }

    /// Whether one of the values is next to a change point.
    #[inline(always)]
    fn is_blank(&self, values: &R) -> bool {
        let blank = BLANK * self.path.unit();
        // Mostly there is none, and nothing is called then.
        for change in &self.path.changes {
            if values.as_ref().iter().any(|v| (v - change.at).abs() < blank) {
                return true;
            }
        }
        false
    }

    #[inline]
    fn set_scene_rates(&mut self) {
        for (index, input) in self.kernel.inputs.iter().enumerate() {
            self.kernel.set_rates(&mut self.block, index, input.rate, input.second);
        }
    }
}

/// One position at a time.
impl Walker<'_> {
    /// The position at a value of the drive; `None` where that has not been reached, is singular or next to a change
    /// point.
    #[inline]
    pub fn positions(&mut self, value: &[f64; 1]) -> Option<&mut Single> {
        let found = self.seek(value[0]) && self.predict(OneByOne, value) && self.close(Kernel::assemble);
        found.then_some(&mut self.block)
    }

    /// The position and the rates for the drives running as the scene says; `None` as for [`Self::positions`].
    #[inline]
    pub fn motions(&mut self, value: &[f64; 1]) -> Option<&Single> {
        if !(self.seek(value[0]) && self.predict(OneByOne, value)) {
            return None;
        }
        self.set_scene_rates();
        let segment = &self.path.segments[self.segment];
        if segment.delicate {
            return self.close(Kernel::assemble).then(|| self.rates());
        }
        self.kernel.motions(&mut self.block, segment.sure).closed.then_some(&self.block)
    }

    /// The rates at the position computed last, for the drives running as the scene says.
    #[inline]
    pub fn rates(&mut self) -> &Single {
        self.set_scene_rates();
        self.kernel.rates(&mut self.block);
        &self.block
    }

    /// The position at a value of the drive, with its rates; `None` where it has not been reached or is singular.
    pub fn position(&mut self, value: f64) -> Option<Position<'_>> {
        let path = self.path;
        let block = self.motions(&[value])?;
        Some(path.position(block, 0))
    }

    /// The motion for a speed of the drive of one unit of its value per unit of time.
    pub(super) fn unit_motion(&mut self, value: f64) -> Option<&Single> {
        self.positions(&[value])?;
        self.path.unit_rates(&mut self.block);
        Some(&self.block)
    }
}

/// [`MANY`] positions at a time, in the widest registers that the processor has.
///
/// Last digits may differ from those of one position at a time: products are added with one rounding where the
/// processor can.
impl<'a> Walker<'a, Many> {
    /// With the drives' rates as the scene says, which stay.
    pub(super) fn many(path: &'a Path<'a>, kernel: &'a Kernel) -> Self {
        let mut walker = Self::new(path, kernel);
        walker.set_scene_rates();
        walker
    }

    /// Positions at the first of these values of the drive: as many as lie on one segment of the path, at most
    /// [`MANY`]; returns their number and block.
    ///
    /// The block's other lanes repeat the last position. `None` where one of these positions has not been reached, is
    /// singular or next to a change point: then ask one by one.
    #[inline]
    pub fn positions(&mut self, values: &[f64]) -> (usize, Option<&Block<Many>>) {
        self.compute(values, Self::find_positions)
    }

    /// As [`Self::positions`], with the rates for the drives running as the scene says.
    #[inline]
    pub fn motions(&mut self, values: &[f64]) -> (usize, Option<&Block<Many>>) {
        self.compute(values, Self::find_motions)
    }

    /// The rates at the positions computed last, for the drives running as the scene says.
    #[inline]
    pub fn rates(&mut self) -> &Block<Many> {
        self.kernel.rates_many(self.registers, &mut self.block);
        &self.block
    }

    #[inline]
    fn compute(&mut self, values: &[f64], find: fn(&mut Self, &Many) -> bool) -> (usize, Option<&Block<Many>>) {
        let Some(first) = values.first() else {
            return (0, None);
        };
        if !self.seek(*first) {
            return (1, None);
        }
        // Values mostly come in order: if the last lies on the segment, so do all. The registers check each of them.
        let segment = &self.path.segments[self.segment];
        let full = values.first_chunk::<MANY>();
        if let Some(full) = full.filter(|v| segment.holds(v[MANY - 1]))
            && find(self, &Many(*full))
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
        let found = find(self, &row);
        (count, found.then_some(&self.block))
    }

    #[inline]
    fn find_positions(&mut self, values: &Many) -> bool {
        let registers = self.registers;
        dispatch!(registers, simd => self.predict(Registers::<_, TOGETHER>(simd), values))
            && self.close(|kernel, block, sure| kernel.assemble_many(registers, block, sure))
    }

    #[inline]
    fn find_motions(&mut self, values: &Many) -> bool {
        let (registers, segment) = (self.registers, &self.path.segments[self.segment]);
        if segment.delicate {
            let found = self.find_positions(values);
            if found {
                self.rates();
            }
            return found;
        }
        let sure = segment.sure;
        let begun = dispatch!(registers, simd => self.begin_motions(Registers::<_, TOGETHER>(simd), values, sure));
        begun.is_some_and(|begun| self.kernel.finish_motions(registers, &mut self.block, sure, begun).closed)
    }

    /// Predicts positions and begins with the motions there: in one function, which is called once for many positions.
    #[inline(always)]
    fn begin_motions<L: Lanes>(&mut self, lanes: L, values: &Many, sure: f64) -> Option<Begun<'a>> {
        if self.predict(lanes, values) {
            Some(self.kernel.begin_motions(lanes, &mut self.block, sure, 1))
        } else {
            None
        }
    }
}
