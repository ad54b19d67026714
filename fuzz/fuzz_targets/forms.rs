//! Forms of measured values, as JSON or as tables, held against two mechanisms: report, row, page and sheets can be read back.

#![no_main]

#[path = "../support.rs"]
mod support;

use libfuzzer_sys::{Corpus, fuzz_mutator, fuzz_target, fuzzer_mutate};
use support::{mutations, read_back};

fuzz_target!(|data: &[u8]| -> Corpus {
    let Ok(text) = std::str::from_utf8(data) else {
        return Corpus::Reject;
    };
    read_back::form(text);
    Corpus::Keep
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed % 16 {
        0 => fuzzer_mutate(data, size, max_size),
        _ if data[..size].trim_ascii_start().starts_with(b"{") => mutations::mutate(data, size, max_size, seed),
        _ => mutations::mutate_lines(data, size, max_size, seed),
    }
});
