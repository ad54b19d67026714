use super::action::{Action, Closing};
use super::close::{NEAR_START, Size, assemble, assemble_many, correct, place};
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
        let begun = self.begin_motions(OneByOne, block, sure, 1);
        if begun.is_all() {
            return begun.found;
        }
        let found = begun.found.and(assemble(begun.rest, block, sure));
        if found.closed {
            rates(begun.rest, block);
        }
        found
    }

    /// Computes positions and rates of one action after another, up to the first group that has no shape
    /// or comes to no sure one in so many steps; [`Self::finish_motions`] does the rest.
    #[inline(always)]
    pub fn begin_motions<L: Lanes, R: Row>(
        &self,
        lanes: L,
        block: &mut Block<R>,
        sure: f64,
        steps: usize,
    ) -> Begun<'_> {
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
                Action::Close(closing) => {
                    let found = close_with_rates(lanes, block, closing, sure, steps);
                    if !found.closed {
                        begun.found.first = begun.found.first.max(found.first);
                        break;
                    }
                    begun.found = begun.found.and(found);
                }
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

/// Closes a group with a shape in at most so many steps, as `close` does where each is at most half as large as the one before; otherwise it
/// has not closed. A single step that is not sure is not made.
#[inline(always)]
fn close_with_rates<L: Lanes, R: Row>(
    lanes: L,
    block: &mut Block<R>,
    closing: &Closing,
    sure: f64,
    steps: usize,
) -> Correction {
    let mut first = None;
    let mut most = NEAR_START;
    for left in (0..steps).rev() {
        let Some(longest) = step_with_rates(lanes, block, closing) else { break };
        let first = *first.get_or_insert(longest);
        if longest <= sure {
            correct(lanes, block, closing, Size::Tiny);
            return Correction { first, last: longest, ..Correction::NONE };
        }
        if left == 0 || longest > most || longest.is_nan() {
            break;
        }
        correct(lanes, block, closing, Size::of(longest));
        most = 0.5 * longest;
    }
    Correction { first: first.unwrap_or_default(), closed: false, ..Correction::NONE }
}
