//! Inputs that once broke something, found by the fuzzer and made small: each goes the whole way.
//! A new one is a new file in `tests/fuzzed`.

use crate::support::files::{list, path};
use crate::support::whole_way;

#[test]
fn what_once_broke_something_goes_the_whole_way() {
    let names = list("tests/fuzzed");
    let broken = names.iter().filter(|name| {
        let bytes = std::fs::read(path(&format!("tests/fuzzed/{name}"))).expect("it can be read");
        let text = String::from_utf8_lossy(&bytes);
        let outcome = std::panic::catch_unwind(|| {
            whole_way::reading(&text);
            _ = whole_way::whole_way(&text);
        });
        outcome.is_err()
    });
    let broken: Vec<_> = broken.collect();
    assert!(broken.is_empty() && !names.is_empty(), "{broken:?}");
}
