//! Any bytes: the reader gives a scene or an error whose message, with the text around its place, can be shown.

#![no_main]

#[path = "../support.rs"]
mod support;

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use support::{mutations, whole_way};

fuzz_target!(|data: &[u8]| {
    whole_way::reading(&String::from_utf8_lossy(data));
});

// Half of the inputs are trees changed as trees: other bytes seldom get past the parser.
fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed % 2 {
        0 => mutations::mutate(data, size, max_size, seed),
        _ => fuzzer_mutate(data, size, max_size),
    }
});
