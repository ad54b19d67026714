use super::action::Action;
use super::close::{Size, assemble, assemble_many, correct, place};
use super::rates::{point_rates, rates, rates_many};
use super::shapes::step_with_rates;
use super::{Block, Correction, Kernel, Single};
use crate::geometry::{Lanes, Many, OneByOne, Registers, Row, TOGETHER};
use fearless_simd::{Level, dispatch};

impl Kernel {
    /// [`Self::assemble`], and [`Self::rates`] if all loops have closed: to the same bits, but quicker where the first
    /// corrections are sure.
    #[inline(never)]
    pub fn motions(&self, block: &mut Single, sure: f64) -> Correction {
        let (mut found, rest) = at_once(OneByOne, &self.actions, block, sure);
        if !rest.is_empty() {
            found = found.and(assemble(rest, block, sure));
            if found.closed {
                rates(rest, block);
            }
        }
        found
    }

    /// As [`Self::motions`], for many positions in the widest registers of the processor.
    #[inline(never)]
    pub fn motions_many(&self, registers: Level, block: &mut Block<Many>, sure: f64) -> Correction {
        let (mut found, rest) =
            dispatch!(registers, simd => at_once(Registers::<_, TOGETHER>(simd), &self.actions, block, sure));
        if !rest.is_empty() {
            found = found.and(assemble_many(rest, registers, block, sure));
            if found.closed {
                rates_many(rest, registers, block);
            }
        }
        found
    }
}

/// Carries out actions, positions and rates of each at once, up to the first group that has no shape, or whose step is
/// not sure; returns that and the rest too, for which nothing has been changed.
#[inline(always)]
fn at_once<'a, L: Lanes, R: Row>(
    lanes: L,
    actions: &'a [Action],
    block: &mut Block<R>,
    sure: f64,
) -> (Correction, &'a [Action]) {
    let mut worst = Correction::NONE;
    if !L::HAS_PLUS_PRODUCT || sure == 0.0 {
        return (worst, actions);
    }
    for (index, action) in actions.iter().enumerate() {
        match action {
            Action::Place(placing) => {
                place(lanes, block, placing);
                point_rates(lanes, block, placing);
            }
            Action::Close(closing) => match step_with_rates(lanes, block, closing) {
                Some(longest) if longest <= sure => {
                    correct(lanes, block, closing, Size::Tiny);
                    worst = worst.and(Correction { first: longest, last: longest, ..Correction::NONE });
                }
                _ => return (worst, &actions[index..]),
            },
        }
    }
    (worst, &[])
}
