use super::action::Action;
use super::close::{Size, assemble, assemble_many, correct, place};
use super::rates::{point_rates, rates, rates_many};
use super::shapes::step_with_rates;
use super::{Block, Correction, Kernel, Single};
use crate::geometry::{Lanes, Many, OneByOne, Row};
use fearless_simd::Level;

/// Positions and rates that [`Kernel::begin_motions`] has computed.
#[derive(Clone, Copy, Debug)]
pub struct Begun {
    found: Correction,
    /// How many of the kernel's actions have been carried out.
    actions: usize,
}

impl Kernel {
    /// [`Self::assemble`], and [`Self::rates`] if all loops have closed: to the same bits, but quicker where the first
    /// corrections are sure.
    #[inline(never)]
    pub fn motions(&self, block: &mut Single, sure: f64) -> Correction {
        let Begun { found, actions } = self.begin_motions(OneByOne, block, sure);
        let rest = &self.actions[actions..];
        if rest.is_empty() {
            return found;
        }
        let found = found.and(assemble(rest, block, sure));
        if found.closed {
            rates(rest, block);
        }
        found
    }

    /// Computes positions and rates, action by action, up to the first group that has no shape or whose step is not
    /// sure: for the rest nothing has been changed.
    #[inline(always)]
    pub fn begin_motions<L: Lanes, R: Row>(&self, lanes: L, block: &mut Block<R>, sure: f64) -> Begun {
        let mut begun = Begun { found: Correction::NONE, actions: 0 };
        if !L::HAS_PLUS_PRODUCT || sure == 0.0 {
            return begun;
        }
        for action in &self.actions {
            match action {
                Action::Place(placing) => {
                    place(lanes, block, placing);
                    point_rates(lanes, block, placing);
                }
                Action::Close(closing) => {
                    let Some(longest) = step_with_rates(lanes, block, closing).filter(|longest| *longest <= sure)
                    else {
                        return begun;
                    };
                    correct(lanes, block, closing, Size::Tiny);
                    begun.found = begun.found.and(Correction { first: longest, last: longest, ..Correction::NONE });
                }
            }
            begun.actions += 1;
        }
        begun
    }

    /// Computes what is left of positions and rates, as [`Self::motions`] does: many in the widest registers of the
    /// processor.
    #[inline]
    pub fn finish_motions(&self, registers: Level, block: &mut Block<Many>, sure: f64, begun: Begun) -> Correction {
        let rest = &self.actions[begun.actions..];
        if rest.is_empty() {
            return begun.found;
        }
        let found = begun.found.and(assemble_many(rest, registers, block, sure));
        if found.closed {
            rates_many(rest, registers, block);
        }
        found
    }
}
