//! The program from outside.

use super::files;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

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
    started(kinegon().args(arguments), scene).wait_with_output().expect("the program ends")
}

/// What a program comes to with a text on stdin; `None` if it has not ended within a minute.
pub fn in_a_minute(command: &mut Command, stdin: &[u8]) -> Option<Output> {
    let mut child = started(command, stdin);
    let begun = Instant::now();
    while child.try_wait().expect("it can be asked").is_none() {
        if begun.elapsed() > Duration::from_secs(60) {
            child.kill().expect("it can be ended");
            child.wait().expect("it has ended");
            return None;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    Some(child.wait_with_output().expect("it has ended"))
}

/// A program that runs, with a text on stdin.
fn started(command: &mut Command, text: &[u8]) -> Child {
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    // A program that refuses early need not read to the end.
    let _ = stdin.write_all(text);
    child
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
