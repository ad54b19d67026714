//! Mistakes put into drawings of random scenes, as `examples/mistakes.rs` does: the check names them first, and leaves clean drawings alone.

use crate::examples::mistakes::{clean, row};
use kinegon::check::Mistake;
use support::survey::{ALIKE, CLEAN, PLANTED_MISTAKES};

/// Drawings of each mistake.
fn drawings() -> usize {
    PLANTED_MISTAKES.now()
}

#[test]
fn exact_drawings_show_their_mistake() {
    let (mut planted, mut named) = (0, 0);
    for mistake in Mistake::all().step_by(ALIKE.now()) {
        let row = row(mistake, drawings(), [0.0; 2], 11);
        planted += row.planted;
        named += row.named;
    }
    assert!(planted >= 5, "only {planted} drawings");
    // As docs/mistakes.md says for many more drawings.
    assert!(named * 100 >= planted * 90, "{named} of {planted}");
}

#[test]
fn pencil_drawings_mostly_show_their_mistake() {
    let (mut planted, mut named) = (0, 0);
    // A pencil hides whether numbers are cut off.
    let seen = Mistake::all().filter(|m| *m != Mistake::Truncated);
    for mistake in seen.skip(1).step_by(ALIKE.now()) {
        let row = row(mistake, drawings(), [0.3; 2], 12);
        planted += row.planted;
        named += row.named;
    }
    assert!(named * 100 >= planted * 80, "{named} of {planted}");
}

#[test]
fn clean_drawings_pass_and_are_told_of_no_mistake() {
    let count = CLEAN.now();
    let [off, named] = clean(count, [0.3; 2], 13);
    assert!(100 * off <= count, "{off} of {count} not passed");
    assert!(100 * named <= count, "{named} of {count} told of a mistake");
}
