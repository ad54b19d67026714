//! Command lines with their files: the program, run in this process in a folder of its own, ends with an exit code of its
//! own, and all that it prints and writes can be read back.

#![no_main]

#[path = "../support.rs"]
mod support;

use libfuzzer_sys::{Corpus, fuzz_mutator, fuzz_target, fuzzer_mutate};
use rustix::stdio::{dup2_stderr, dup2_stdout};
use std::ffi::OsString;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::os::fd::{AsFd, OwnedFd};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use support::case::{Case, Outcome, found};
use support::mutations;

/// The folder in which the program works, the files that stand in for its streams, and the true stderr.
struct Place {
    folder: PathBuf,
    stdout: File,
    stderr: File,
    own: OwnedFd,
}

static PLACE: OnceLock<Place> = OnceLock::new();

/// Makes the folder, moves into it, and has a panic's message go to the true stderr.
fn settle() -> Place {
    let base = ["/dev/shm", "/tmp"].into_iter().find(|base| Path::new(base).is_dir()).unwrap_or(".");
    let base = Path::new(base).join(format!("kinegon-fuzz-{}", std::process::id()));
    let folder = base.join("work");
    std::fs::create_dir_all(&folder).expect("a temporary folder can be made");
    std::env::set_current_dir(&folder).expect("it is there");
    let stream = |name: &str| {
        let mut options = File::options();
        options.read(true).write(true).create(true).truncate(true).open(base.join(name)).expect("a file can be made")
    };
    let own = std::io::stderr().as_fd().try_clone_to_owned().expect("stderr is open");
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        if let Some(place) = PLACE.get() {
            let _ = dup2_stderr(&place.own);
        }
        usual(info);
    }));
    Place { folder, stdout: stream("stdout"), stderr: stream("stderr"), own }
}

/// All that stands in a file, which is then empty.
fn taken(mut file: &File) -> Vec<u8> {
    let mut bytes = Vec::new();
    let _ = file.seek(SeekFrom::Start(0)).and_then(|_| file.read_to_end(&mut bytes));
    let _ = file.set_len(0).and_then(|()| file.seek(SeekFrom::Start(0)).map(drop));
    bytes
}

fuzz_target!(|data: &[u8]| -> Corpus {
    let Some(case) = std::str::from_utf8(data).ok().and_then(Case::read) else {
        return Corpus::Reject;
    };
    let place = PLACE.get_or_init(settle);
    for entry in std::fs::read_dir(&place.folder).into_iter().flatten().flatten() {
        let path = entry.path();
        let _ = if path.is_dir() { std::fs::remove_dir_all(path) } else { std::fs::remove_file(path) };
    }
    case.lay_out(&place.folder);
    let before = found(&place.folder);
    let arguments = std::iter::once("kinegon").chain(case.arguments.iter().map(String::as_str)).map(OsString::from);
    let streams = dup2_stdout(&place.stdout).and_then(|()| dup2_stderr(&place.stderr));
    let code = kinegon::cli::run_with(arguments);
    let _ = std::io::stdout().flush();
    let back = dup2_stderr(&place.own);
    assert!(streams.is_ok() && back.is_ok());
    let outcome = Outcome { code: Some(code.into()), stdout: taken(&place.stdout), stderr: taken(&place.stderr) };
    case.judge(&outcome, &place.folder, &before);
    Corpus::Keep
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed % 16 {
        0 => fuzzer_mutate(data, size, max_size),
        _ => mutations::mutate(data, size, max_size, seed),
    }
});
