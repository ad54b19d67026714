//! Programs that read and draw what we write: judges that need not be installed, so tests that need one are ignored
//! unless one asks for them (`--include-ignored`), and then fail where it is missing.

use super::files;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Where a program is. Panics if it is not installed: a test without its judge has not passed.
pub fn find(program: &str) -> PathBuf {
    let folders = std::env::var_os("PATH").unwrap_or_default();
    let found = std::env::split_paths(&folders).map(|folder| folder.join(program)).find(|path| path.is_file());
    found.unwrap_or_else(|| panic!("{program} is not installed"))
}

/// What a program says on stdout.
pub fn run<A: AsRef<OsStr>>(program: &Path, arguments: impl IntoIterator<Item = A>) -> Vec<u8> {
    run_in(&files::left(), program, arguments)
}

/// What a program says on stdout when it is started in this folder.
pub fn run_in<A: AsRef<OsStr>>(folder: &Path, program: &Path, arguments: impl IntoIterator<Item = A>) -> Vec<u8> {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).stdin(Stdio::null());
    let output = command.output().expect("the program starts");
    assert!(
        output.status.success(),
        "{command:?}\n{}\n{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    output.stdout
}

/// A file of that name among the tests' products.
pub fn leave(name: &str, bytes: &[u8]) -> PathBuf {
    let path = files::left().join(name);
    std::fs::write(&path, bytes).expect("the test's folder can be written");
    path
}
