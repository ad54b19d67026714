//! The program from outside.

use super::files;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// Where cargo has put the program for the tests.
pub fn path() -> PathBuf {
    files::built().join(format!("kinegon{}", std::env::consts::EXE_SUFFIX))
}

/// The program, without anything on its stdin.
pub fn kinegon() -> Command {
    let mut command = Command::new(path());
    command.env_remove("CLICOLOR_FORCE").stdin(Stdio::null());
    command
}

/// Runs `kinegon ARGUMENTS -` with a scene on stdin.
pub fn with_scene(arguments: &[&str], scene: &[u8]) -> Output {
    let mut child = kinegon()
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    // A program that refuses early need not read to the end.
    let _ = stdin.write_all(scene);
    drop(stdin);
    child.wait_with_output().expect("the program ends")
}

/// An empty folder of that name.
pub fn scratch(name: &str) -> PathBuf {
    let folder = files::left().join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("the test's folder can be written");
    folder
}

/// What it said on stderr.
pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
