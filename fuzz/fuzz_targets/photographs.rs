//! Files that are to be photographs, changed as bytes: each is decoded and read, or refused.

#![no_main]

use kinegon::cli::photo::read_picture;
use kinegon::photo::read;
use libfuzzer_sys::{Corpus, fuzz_target};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

static FILE: LazyLock<PathBuf> = LazyLock::new(|| {
    let base = ["/dev/shm", "/tmp"].into_iter().find(|base| Path::new(base).is_dir()).unwrap_or(".");
    Path::new(base).join(format!("kinegon-photograph-{}", std::process::id()))
});

fuzz_target!(|data: &[u8]| -> Corpus {
    std::fs::write(&*FILE, data).expect("a temporary file can be written");
    let Ok(picture) = read_picture(&FILE) else { return Corpus::Keep };
    if let Ok(sheet) = read(&picture, Vec::new) {
        assert!(sheet.strokes(&picture).len() < 1_000_000);
    }
    Corpus::Keep
});
