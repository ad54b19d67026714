use super::{Path, Position};
use crate::geometry::{Eight, Number};
use crate::kernel::Block;
use multiversion::multiversion;

/// How near a change position there is nothing to read, in parts of a turn: rounding leaves about u / distance³ of second rates.
const BLANK: f64 = 1e-4;

/// Vectors in a block of many positions: enough that being general costs little, few enough to stay in the nearest cache.
pub const MANY: usize = 4;

/// Computes positions and rates anywhere on a path in memory of its own, one at a time or M times the lanes of T.
#[derive(Clone, Debug)]
pub struct Walker<'a, T: Number = f64, const M: usize = 1> {
    path: &'a Path<'a>,
    block: Block<T, M>,
    segment: usize,
}

impl<'a, T: Number, const M: usize> Walker<'a, T, M> {
    pub(super) fn new(path: &'a Path<'a>) -> Self {
        Self {
            path,
            block: Block::new(&path.kernel),
            segment: 0,
        }
    }

    /// Positions at these values of the drive, which must lie on one segment; `None` where that is not so, or a position is
    /// singular or next to a change position.
    #[inline]
    pub fn positions(&mut self, values: &[T; M]) -> Option<&mut Block<T, M>> {
        self.assemble(values).then_some(&mut self.block)
    }

    #[inline(always)]
    fn assemble(&mut self, values: &[T; M]) -> bool {
        let segments = &self.path.segments;
        if !segments.get(self.segment).is_some_and(|s| s.holds(values)) {
            let found = self.path.segment(values[0].lane(0));
            self.segment = found.unwrap_or(self.segment);
            if !segments.get(self.segment).is_some_and(|s| s.holds(values)) {
                return false;
            }
        }
        let blank = BLANK * self.path.unit();
        let near = |at: f64, v: &T| (0..T::LANES).any(|i| (v.lane(i) - at).abs() < blank);
        let mut changes = self.path.changes.iter();
        if changes.any(|change| values.iter().any(|v| near(change.at, v))) {
            return false;
        }
        self.path.set_inputs(&mut self.block, values);
        let segment = &segments[self.segment];
        segment.predict(values, &mut self.block);
        let kernel = &self.path.kernel;
        kernel.assemble(&mut self.block, segment.sure).closed
    }

    /// Positions and the rates for the drives running as the scene says; `None` as for [`Self::positions`].
    #[inline]
    pub fn motions(&mut self, values: &[T; M]) -> Option<&Block<T, M>> {
        self.move_to(values).then_some(&self.block)
    }

    #[inline(always)]
    fn move_to(&mut self, values: &[T; M]) -> bool {
        let found = self.assemble(values);
        if found {
            self.path.scene_rates(&mut self.block);
        }
        found
    }

    /// The rates at the positions computed last, for the drives running as the scene says.
    #[inline]
    pub fn rates(&mut self) -> &Block<T, M> {
        self.path.scene_rates(&mut self.block);
        &self.block
    }
}

/// Vectors of eight numbers in blocks: the widest registers that the processor has do the work.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn motions_of_many(walker: &mut Walker<Eight, MANY>, values: &[Eight; MANY]) -> bool {
    walker.move_to(values)
}

impl Walker<'_, Eight, MANY> {
    /// The same as [`Self::motions`], with the widest registers that the processor has.
    pub fn many_motions(&mut self, values: &[Eight; MANY]) -> Option<&Block<Eight, MANY>> {
        motions_of_many(self, values).then_some(&self.block)
    }
}

impl Walker<'_> {
    /// The position at a value of the drive, with its rates; `None` where it has not been reached or is singular.
    pub fn position(&mut self, value: f64) -> Option<Position<'_>> {
        let path = self.path;
        let block = self.motions(&[value])?;
        Some(path.position(block, 0))
    }

    /// The motion for the drive running by one unit of its value a unit of time.
    pub(super) fn unit_motion(&mut self, value: f64) -> Option<&Block<f64, 1>> {
        self.positions(&[value])?;
        self.path.unit_rates(&mut self.block);
        Some(&self.block)
    }
}
