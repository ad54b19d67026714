//! Inputs that once broke something, found by the fuzzers and made small: each goes the whole way.
//! A new one is a new file in `tests/fuzzed`, in the folder of its kind; scenes stand there without one.

use support::files::{list, path};
use support::survey::ALIKE;
use support::{read_back, whole_way};

/// Runs one in `every` files of a folder through the whole program.
fn holds(folder: &str, every: usize, whole_way: impl Fn(&str) + std::panic::RefUnwindSafe) {
    let files: Vec<String> =
        list(folder).into_iter().filter(|name| path(&format!("{folder}/{name}")).is_file()).collect();
    let broken = files.iter().step_by(every).filter(|name| {
        let bytes = std::fs::read(path(&format!("{folder}/{name}"))).expect("it can be read");
        let text = String::from_utf8_lossy(&bytes);
        std::panic::catch_unwind(|| whole_way(&text)).is_err()
    });
    let broken: Vec<_> = broken.collect();
    assert!(broken.is_empty() && !files.is_empty(), "{broken:?}");
}

#[test]
fn what_once_broke_something_goes_the_whole_way() {
    holds("tests/fuzzed", ALIKE.now(), |text| {
        whole_way::reading(text);
        _ = whole_way::whole_way(text);
    });
}

#[test]
fn forms_can_be_checked_and_read_back() {
    holds("tests/fuzzed/forms", 1, read_back::form);
}

#[test]
fn texts_of_strangers_are_shown_and_not_obeyed() {
    holds("tests/fuzzed/texts", 1, read_back::texts);
}

#[test]
fn marks_and_styles_are_read_or_refused() {
    holds("fuzz/seeds/marks", 1, read_back::marks);
    holds("tests/fuzzed/styles", 1, read_back::style);
}
