use super::{Path, Position};
use crate::kernel::Block;

/// Computes positions and rates anywhere on a path, N at a time, in memory of its own.
#[derive(Clone, Debug)]
pub struct Walker<'a, const N: usize> {
    path: &'a Path<'a>,
    block: Block<N>,
    segment: usize,
}

impl<'a, const N: usize> Walker<'a, N> {
    pub(super) fn new(path: &'a Path<'a>) -> Self {
        Self {
            path,
            block: Block::new(&path.kernel),
            segment: 0,
        }
    }

    /// Positions at these values of the drive, which must lie on one segment; `None` where that is not so, or a position is singular.
    pub fn positions(&mut self, values: &[f64; N]) -> Option<&mut Block<N>> {
        let segments = &self.path.segments;
        let holds = |s: usize| {
            let range = segments.get(s).map(|s| s.from..=s.to);
            range.is_some_and(|range| values.iter().all(|v| range.contains(v)))
        };
        if !holds(self.segment) {
            self.segment = self.path.segment(values[0])?;
            if !holds(self.segment) {
                return None;
            }
        }
        self.path.set_inputs(&mut self.block, values);
        segments[self.segment].predict(values, &mut self.block);
        let found = self.path.kernel.assemble(&mut self.block);
        found.closed.then_some(&mut self.block)
    }

    /// Positions and the rates for the drives running as the scene says; `None` as for [`Self::positions`].
    pub fn motions(&mut self, values: &[f64; N]) -> Option<&Block<N>> {
        self.positions(values)?;
        Some(self.rates())
    }

    /// The rates at the positions computed last, for the drives running as the scene says.
    pub fn rates(&mut self) -> &Block<N> {
        self.path.scene_rates(&mut self.block);
        &self.block
    }

    /// The same for the drive running by one unit of its value a unit of time.
    pub(super) fn unit_motions(&mut self, values: &[f64; N]) -> Option<&Block<N>> {
        self.positions(values)?;
        self.path.unit_rates(&mut self.block);
        Some(&self.block)
    }
}

impl Walker<'_, 1> {
    /// The position at a value of the drive, with its rates; `None` where it has not been reached or is singular.
    pub fn position(&mut self, value: f64) -> Option<Position<'_, 1>> {
        let path = self.path;
        let block = self.motions(&[value])?;
        Some(path.position(block, 0))
    }
}
