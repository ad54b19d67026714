//! Scenes on which somebody is at work, changed as trees: what is known of them is drawn, on parts of screens of all sizes.

#![no_main]

#[path = "../support.rs"]
mod support;

use kinegon::drawing::{DraftView, Pane, draft};
use kinegon::editing::Draft;
use libfuzzer_sys::{Corpus, fuzz_mutator, fuzz_target, fuzzer_mutate};
use support::{mutations, whole_way};

fuzz_target!(|data: &[u8]| -> Corpus {
    let Some(draft_of) = std::str::from_utf8(data).ok().and_then(|text| Draft::of(text).ok()) else {
        return Corpus::Reject;
    };
    for (width, centre, scale) in [(800.0, [20.0, 15.0], 4.0), (90.0, [-1e9, 1e-9], 1e-6), (3000.0, [0.0, 0.0], 1e6)] {
        let pane = Pane { width, height: 500.0, letters: 14.0, words: false };
        whole_way::drawing_is_finite(&draft(&draft_of, &DraftView { pane, centre, scale }));
    }
    Corpus::Keep
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed % 16 {
        0 => fuzzer_mutate(data, size, max_size),
        _ => mutations::mutate(data, size, max_size, seed),
    }
});
