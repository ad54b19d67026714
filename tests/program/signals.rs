//! Signals while files are being written: nothing is left, and what was there before stays.

use super::outputs::{assert_same, inputs, tree};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use support::program::{kinegon, stderr};

/// Longer than any of these commands takes to begin.
const SOON: Duration = Duration::from_secs(60);

/// Sends a signal.
fn send(child: &Child, signal: &str) {
    let kill = Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status();
    assert!(kill.expect("kill runs").success());
}

/// Waits until a command has a staging folder in a folder, and returns its path.
fn staging(folder: &Path) -> PathBuf {
    let start = Instant::now();
    loop {
        assert!(start.elapsed() < SOON, "it writes nothing");
        let entries = fs::read_dir(folder).expect("a folder");
        let found = entries.map(|entry| entry.expect("listed").path());
        let mut found =
            found.filter(|path| path.file_name().is_some_and(|n| n.to_string_lossy().starts_with(".kinegon-")));
        if let Some(found) = found.next() {
            return found;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// A table that would take hours, a thousand exercises, a class of thousands.
const LONG: [&str; 3] = [
    "sweep scene.json --step 1e-7 --yes -o out/table.csv",
    "exercise four-bar --seed 5 --count 1000 -o out/ex",
    "check scene.json class -o out/report.csv --feedback out/pages",
];

/// Whether these tests themselves were started with `nohup`, which programs inherit.
fn is_nohup() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).is_some_and(|mask| mask & 1 == 1)
}

#[test]
fn signals_leave_nothing() {
    let folder = inputs("outputs-signals");
    fs::create_dir(folder.join("class")).expect("made");
    for number in 0..3000 {
        fs::copy(folder.join("form.json"), folder.join(format!("class/{number}.json"))).expect("copied");
    }
    let before = tree(&folder);
    let mut names = Vec::new();
    for (command, (signal, code)) in LONG.into_iter().zip([("TERM", 143), ("HUP", 129), ("INT", 130)]) {
        let (signal, code) = if signal == "HUP" && is_nohup() { ("TERM", 143) } else { (signal, code) };
        let mut program = kinegon();
        program.args(command.split(' ')).current_dir(&folder).stderr(Stdio::piped()).stdout(Stdio::null());
        let child = program.spawn().expect("it starts");
        let stage = staging(&folder.join("out"));
        assert_eq!(fs::metadata(&stage).expect("there").permissions().mode() & 0o777, 0o700);
        names.push(stage);
        std::thread::sleep(Duration::from_millis(100));
        send(&child, signal);
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(output.status.code(), Some(code), "{command}: {}", stderr(&output));
        let message = stderr(&output);
        assert_eq!(message.trim(), "error: stopped before the files were complete; none was written", "{command}");
        assert_same(&folder, &before, command);
    }
    names.sort();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "names can be guessed: {names:?}");
}

/// What `nohup` has started goes on when the terminal is closed.
#[cfg(target_os = "linux")]
#[test]
fn nohup_is_heard() {
    let folder = inputs("outputs-nohup");
    let mut shell = Command::new("sh");
    shell.args(["-c", "trap '' HUP; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_kinegon")]);
    let mut child =
        shell.args(LONG[0].split(' ')).current_dir(&folder).stderr(Stdio::null()).spawn().expect("it starts");
    let stage = staging(&folder.join("out"));
    send(&child, "HUP");
    std::thread::sleep(Duration::from_millis(100));
    assert!(stage.is_dir() && child.try_wait().expect("asked").is_none());
    send(&child, "TERM");
    assert_eq!(child.wait().expect("it ends").code(), Some(143));
    assert!(!stage.exists());
}
