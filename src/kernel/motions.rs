use super::action::Action;
use super::close::{Size, assemble, assemble_many, correct, place};
use super::rates::{point_rates, rates, rates_many};
use super::shapes::step_with_rates;
use super::{Block, Correction, Kernel, Single};
use crate::geometry::{Lanes, Many, OneByOne, Row};
use fearless_simd::Level;

/// Positions and rates that [`Kernel::begin_motions`] has computed.
#[derive(Clone, Copy, Debug)]
pub struct Begun<'a> {
    found: Correction,
    rest: &'a [Action],
}

impl Begun<'_> {
    /// Whether nothing is left to be computed.
    #[must_use]
    pub fn is_all(&self) -> bool {
        self.rest.is_empty()
    }
}

impl Kernel {
    /// [`Self::assemble`], and [`Self::rates`] if all loops have closed: to the same bits, but quicker where the first
    /// corrections are sure.
    #[inline(never)]
    pub fn motions(&self, block: &mut Single, sure: f64) -> Correction {
        let begun = self.begin_motions(OneByOne, block, sure);
        if begun.is_all() {
            return begun.found;
        }
        let found = begun.found.and(assemble(begun.rest, block, sure));
        if found.closed {
            rates(begun.rest, block);
        }
        found
    }

    /// Computes positions and rates of one action after another, up to the first group that has no shape or whose step
    /// is not sure; for the rest nothing has been changed. [`Self::finish_motions`] does that.
    #[inline(always)]
    pub fn begin_motions<L: Lanes, R: Row>(&self, lanes: L, block: &mut Block<R>, sure: f64) -> Begun<'_> {
        let mut begun = Begun { found: Correction::NONE, rest: &self.actions };
        if !L::HAS_PLUS_PRODUCT || sure == 0.0 {
            return begun;
        }
        while let [action, rest @ ..] = begun.rest {
            match action {
                Action::Place(placing) => {
                    place(lanes, block, placing);
                    point_rates(lanes, block, placing);
                }
                Action::Close(closing) => match step_with_rates(lanes, block, closing) {
                    Some(longest) if longest <= sure => {
                        correct(lanes, block, closing, Size::Tiny);
                        begun.found = begun.found.and(Correction { first: longest, last: longest, ..Correction::NONE });
                    }
                    _ => break,
                },
            }
            begun.rest = rest;
        }
        begun
    }

    /// Computes what is left of the motions of many positions, in the widest registers of the processor.
    #[inline]
    pub fn finish_motions(&self, registers: Level, block: &mut Block<Many>, sure: f64, begun: Begun) -> Correction {
        if begun.is_all() {
            return begun.found;
        }
        let found = begun.found.and(assemble_many(begun.rest, registers, block, sure));
        if found.closed {
            rates_many(begun.rest, registers, block);
        }
        found
    }
}
