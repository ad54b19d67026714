//! Scenes, changed as trees: the whole way to figure and result ends in an error that can be shown, or in finite numbers.

#![no_main]

#[path = "../support.rs"]
mod support;

use libfuzzer_sys::{Corpus, fuzz_crossover, fuzz_mutator, fuzz_target, fuzzer_mutate};
use support::{mutations, whole_way};

fuzz_target!(|data: &[u8]| -> Corpus {
    let Ok(text) = std::str::from_utf8(data) else {
        return Corpus::Reject;
    };
    match whole_way::whole_way(text) {
        // What the reader refuses leads nowhere new; `read_scene` looks after it.
        Err(kinegon::Error::Scene(_)) => Corpus::Reject,
        _ => Corpus::Keep,
    }
});

// A few bytes are changed as bytes: digits become other digits.
fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed % 16 {
        0 => fuzzer_mutate(data, size, max_size),
        _ => mutations::mutate(data, size, max_size, seed),
    }
});

fuzz_crossover!(|one: &[u8], other: &[u8], out: &mut [u8], seed: u32| {
    mutations::cross(one, other, out, seed)
});
