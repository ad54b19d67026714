//! What is promised of files: the files of a command are there as a whole or not at all, and what was there before stays.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use support::program::{kinegon, scratch, stderr};

const FIGURE_2: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/figure-2.json");

/// The files below a folder with their bytes and modes; of a link where it leads.
pub fn tree(folder: &Path) -> BTreeMap<PathBuf, (Vec<u8>, u32)> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("it can be listed") {
        let path = entry.expect("listed").path();
        let mode = path.symlink_metadata().expect("there").permissions().mode();
        if path.is_symlink() {
            let to = fs::read_link(&path).expect("a link").into_os_string().into_encoded_bytes();
            found.insert(path, (to, mode));
        } else if path.is_dir() {
            found.extend(tree(&path));
            found.insert(path, (Vec::new(), mode));
        } else {
            found.insert(path.clone(), (fs::read(&path).expect("read"), mode));
        }
    }
    found
}

/// Holds a folder to what it was before a command.
pub fn assert_same(folder: &Path, before: &BTreeMap<PathBuf, (Vec<u8>, u32)>, command: &str) {
    let after = tree(folder);
    let is_new = |path: &&PathBuf| before.get(*path) != after.get(*path);
    let changed: Vec<&PathBuf> = before.keys().chain(after.keys()).filter(is_new).collect();
    assert!(changed.is_empty(), "{command} leaves {changed:?}");
}

fn empty(folder: &Path) {
    let _ = fs::remove_dir_all(folder);
    fs::create_dir(folder).expect("made");
}

/// A four-bar linkage, forms of a class, and exercises.
pub fn inputs(name: &str) -> PathBuf {
    let folder = scratch(name);
    let exercises = folder.join("exercises");
    let made = kinegon().args(["exercise", "four-bar", "--seed", "7", "-o"]).arg(&exercises).output();
    assert!(made.expect("it runs").status.success());
    fs::copy(exercises.join("four-bar-7-1/scene.json"), folder.join("scene.json")).expect("copied");
    for below in ["forms", "out"] {
        fs::create_dir(folder.join(below)).expect("made");
    }
    let form =
        |value: &str| format!(r#"{{"kinegon_measured": 1, "mu_l": 2, "mu_v": 2, "mu_a": 20, "values": {{{value}}}}}"#);
    for (name, text) in [("form.json", form(r#""omega(2)": -3"#)), ("forms/a.json", form(r#""omega(2)": 5"#))] {
        fs::write(folder.join(name), text).expect("written");
    }
    fs::write(folder.join("forms/b.json"), "no form").expect("written");
    folder
}

/// Every command that writes files, with the number of files; it is called in the folder of its inputs.
const WRITING: [(usize, &str); 17] = [
    (1, "new four-bar -o out/new.json"),
    (1, "new four-bar -o out/deep/er/"),
    (2, "draw scene.json -o out/"),
    (3, "draw scene.json --format svg,pdf,tikz -o out/deep/er/"),
    (1, "draw scene.json -o out/page.html"),
    (1, "app scene.json -o out/deep/"),
    (6, "draw scene.json --steps coarse --format svg -o out/"),
    (1, "draw scene.json --layered -o out/"),
    (1, "draw scene.json --worksheet -o out/sheet.pdf"),
    (2, "curves scene.json -o out/"),
    (1, "sweep scene.json -o out/table.csv"),
    (1, "sweep scene.json -o out/deep/table.jsonl"),
    (23, "exercise four-bar --seed 3 --count 2 -o out/ex"),
    (2, "check scene.json form.json --draw out/ --format svg --feedback out/pages"),
    (3, "check scene.json forms -o out/report.csv --feedback out/pages"),
    (5, "check scene.json forms -o out/report.json --feedback out/pages --feedback-format pdf,html"),
    (1, "check exercises forms -o out/report.jsonl"),
];

/// A command in a folder, where files of more than so many blocks cannot be written.
fn limited(folder: &Path, blocks: usize, command: &str) -> Output {
    let mut shell = Command::new("sh");
    shell.args(["-c", "ulimit -f $0; exec \"$@\"", &blocks.to_string(), env!("CARGO_BIN_EXE_kinegon")]);
    let done = shell.args(command.split(' ')).current_dir(folder).stdin(Stdio::null()).output();
    done.expect("a shell runs")
}

fn done(folder: &Path, command: &str) -> Output {
    kinegon().args(command.split(' ')).current_dir(folder).output().expect("the program runs")
}

/// As on a full disk: the first byte or a late one does not fit.
fn leaves_all_as_it_was(part: usize) {
    let folder = inputs(&format!("outputs-{part}"));
    let out = folder.join("out");
    for (count, command) in WRITING.iter().skip(part).step_by(3) {
        empty(&out);
        let refused = |blocks: usize| {
            let before = tree(&folder);
            let output = limited(&folder, blocks, command);
            let message = stderr(&output);
            assert_eq!(output.status.code(), Some(1), "{command}: {message}");
            assert_eq!(message.matches("error:").count(), 1, "{command}: {message}");
            assert!(message.contains("cannot be written: File too large"), "{command}: {message}");
            assert_same(&folder, &before, command);
        };
        refused(0);
        let output = done(&folder, command);
        let written = tree(&out);
        let files = || written.iter().filter(|(path, _)| path.is_file());
        assert_eq!(files().count(), *count, "{command}: {}", stderr(&output));
        let largest = files().map(|(_, (bytes, _))| bytes.len()).max().expect("files");
        // Most files fit, the largest does not. A block has 512 or 1024 bytes.
        empty(&out);
        refused((largest - 1) / 1024);
        if command.starts_with("new") || command.starts_with("exercise") {
            continue;
        }
        // Files that are there stay as they are, with their modes.
        assert!(done(&folder, command).status.code().is_some());
        for (path, _) in tree(&out).iter().filter(|(path, _)| path.is_file()) {
            fs::set_permissions(path, PermissionsExt::from_mode(0o640)).expect("it is ours");
        }
        refused((largest - 1) / 1024);
        // And when they are replaced.
        done(&folder, command);
        let replaced = tree(&out);
        assert_eq!(replaced.len(), written.len(), "{command}");
        assert!(files().all(|(path, _)| replaced[path].1 & 0o777 == 0o640), "{command}");
    }
}

#[test]
fn what_does_not_fit_leaves_all_as_it_was() {
    leaves_all_as_it_was(0);
}

#[test]
fn what_does_not_fit_leaves_all_as_it_was_too() {
    leaves_all_as_it_was(1);
}

#[test]
fn what_does_not_fit_leaves_all_as_it_was_as_well() {
    leaves_all_as_it_was(2);
}

#[test]
fn places_that_cannot_be_written_get_one_message() {
    let folder = inputs("outputs-refused");
    fs::write(folder.join("out/file"), "a file").expect("written");
    fs::write(folder.join("out/kept.csv"), "kept").expect("written");
    fs::set_permissions(folder.join("out/kept.csv"), PermissionsExt::from_mode(0o444)).expect("it is ours");
    fs::create_dir(folder.join("out/folder.svg")).expect("made");
    symlink("loop.csv", folder.join("out/loop.csv")).expect("made");
    for (command, words) in [
        ("draw scene.json -o out/file/x.svg", "out/file is no folder"),
        ("draw scene.json -o out/file/deep/er/x.svg", "out/file is no folder"),
        ("draw scene.json --steps coarse -o out/file/", "out/file is no folder"),
        ("curves scene.json -o out/file/x.svg", "out/file is no folder"),
        ("sweep scene.json -o out/file/x.csv", "out/file is no folder"),
        ("sweep scene.json -o out/kept.csv", "write-protected"),
        ("sweep scene.json -o out/folder.svg --format csv", "directory"),
        ("sweep scene.json -o out/loop.csv", "out/loop.csv cannot be written"),
        ("exercise four-bar --seed 3 -o out/file", "out/file is no folder"),
        ("exercise four-bar --seed 3 -o out/file/deep", "out/file is no folder"),
        ("new four-bar -o out/file/x.json", "out/file is no folder"),
        ("new four-bar -o out/kept.csv", "is there already"),
        ("check scene.json forms -o out/file/x.csv", "out/file is no folder"),
        ("check scene.json forms --feedback out/file", "is no folder"),
        ("check scene.json forms --feedback out/file/x -o out/report.csv", "out/file is no folder"),
        ("check scene.json form.json --draw out/file/deep/", "out/file is no folder"),
    ] {
        let before = tree(&folder);
        let output = done(&folder, command);
        let message = stderr(&output);
        assert!([1, 2].contains(&output.status.code().expect("an exit code")), "{command}: {message}");
        assert_eq!(message.matches("error:").count(), 1, "{command}: {message}");
        assert!(message.contains(words), "{command}: {message}");
        assert_same(&folder, &before, command);
    }
}

/// Not even root can make a file there.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_nothing_is_named() {
    for command in ["sweep FIGURE -o /sys/t.csv", "draw FIGURE -o /sys/new/", "new four-bar -o /sys/"] {
        let output = done(Path::new("/"), &command.replace("FIGURE", FIGURE_2));
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains("nothing can be put into the folder /sys: "), "{message}");
        assert!(!message.contains(".kinegon-"), "{message}");
    }
}

/// A link is kept, and what it shows is replaced; one to a file that is not there yet makes it.
#[test]
fn links_and_modes_are_kept() {
    let folder = inputs("outputs-links");
    let real = folder.join("out/real.csv");
    fs::write(&real, "before").expect("written");
    fs::set_permissions(&real, PermissionsExt::from_mode(0o600)).expect("it is ours");
    symlink("out/real.csv", folder.join("link.csv")).expect("made");
    symlink("link.csv", folder.join("far.csv")).expect("made");
    symlink("out/new.csv", folder.join("dangling.csv")).expect("made");
    for name in ["far.csv", "dangling.csv"] {
        let output = done(&folder, &format!("sweep scene.json --step 90 -o {name}"));
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert!(folder.join(name).is_symlink());
    }
    assert!(folder.join("link.csv").is_symlink());
    for name in ["real.csv", "new.csv"] {
        let text = fs::read_to_string(folder.join("out").join(name)).expect("written");
        assert!(text.starts_with("angle(1),"), "{text}");
    }
    assert_eq!(fs::metadata(&real).expect("there").permissions().mode() & 0o777, 0o600);
    assert_eq!(fs::read_dir(folder.join("out")).expect("a folder").count(), 2);
}

/// Nobody can put a link where the program begins to write: names with the process's number were known beforehand.
#[test]
fn a_planted_link_is_not_followed() {
    let folder = inputs("outputs-planted");
    let victim = folder.join("victim");
    fs::write(&victim, "before").expect("written");
    let plant = "for end in .part .tmp ''; do ln -s ../victim \"out/t.csv.$$$end\"; done; exec \"$0\" \"$@\"";
    let mut shell = Command::new("sh");
    shell.args(["-c", plant, env!("CARGO_BIN_EXE_kinegon"), "sweep", "scene.json", "--step", "90", "-o", "out/t.csv"]);
    let output = shell.current_dir(&folder).stdin(Stdio::null()).output().expect("a shell runs");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(&victim).expect("there"), "before");
    assert_eq!(fs::read_dir(folder.join("out")).expect("a folder").count(), 4);
}

/// A program that was ended at once, for want of memory or by `kill -9`, could not remove its folder: the next one does that.
#[test]
fn what_was_left_half_written_is_removed_by_the_next() {
    let folder = inputs("outputs-left");
    let left = |name: &str, has_lock: bool| {
        let own = folder.join(name);
        for part in ["new", "old"] {
            fs::create_dir_all(own.join(part)).expect("made");
        }
        fs::write(own.join("new/t.csv"), "half").expect("written");
        has_lock.then(|| fs::File::create(own.join("lock")).expect("made"))
    };
    drop(left(".kinegon-abcdefghijkl", true));
    let held = left(".kinegon-heldheldheld", true).expect("a lock");
    held.lock().expect("held");
    drop(left(".kinegon-withoutalock", false));
    drop(left(".kinegon-somebody-elses-notes", true));
    drop(left(".kinegon-hasreplaced0", true));
    fs::write(folder.join(".kinegon-hasreplaced0/old/0"), "before").expect("written");
    let output = done(&folder, "sweep scene.json --step 90 -o t.csv");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let entries = fs::read_dir(&folder).expect("the folder").flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    let mut kept: Vec<String> = names.filter(|name| name.starts_with(".kinegon-")).collect();
    kept.sort();
    let others = ["hasreplaced0", "heldheldheld", "somebody-elses-notes", "withoutalock"];
    assert_eq!(kept, others.map(|name| format!(".kinegon-{name}")));
}

/// Pipes and devices are written to, whichever name stdout has.
#[test]
fn stdout_and_devices_are_no_files() {
    let folder = inputs("outputs-devices");
    let whole = done(&folder, "sweep scene.json --step 90").stdout;
    let to = |place: &str, name: &str| {
        let file = fs::File::options().append(true).create(true).open(folder.join(name)).expect("opened");
        let mut command = kinegon();
        command.args(["sweep", "scene.json", "--step", "90", "-o", place]).current_dir(&folder);
        assert!(command.stdout(file).stderr(Stdio::null()).status().expect("it runs").success());
    };
    fs::write(folder.join("a"), "before\n").expect("written");
    to("/dev/stdout", "a");
    to("/dev/fd/1", "a");
    let twice = [b"before\n", whole.as_slice(), whole.as_slice()].concat();
    assert!(fs::read(folder.join("a")).expect("written") == twice);
    to("/dev/null", "b");
    assert!(Path::new("/dev/null").metadata().is_ok_and(|found| !found.is_file()));
    let svg = done(&folder, "draw scene.json -o /dev/stdout").stdout;
    assert!(svg == done(&folder, "draw scene.json -o -").stdout);
    if Path::new("/dev/full").exists() {
        let output = done(&folder, "sweep scene.json --step 90 -o /dev/full");
        assert_eq!(output.status.code(), Some(1));
        assert!(stderr(&output).contains("/dev/full cannot be written: No space left"), "{}", stderr(&output));
    }
}

/// Files reach the disk before their names do, and the names before the program says that it is done.
#[cfg(target_os = "linux")]
#[test]
#[ignore = "needs strace"]
fn files_are_on_the_disk_before_they_are_renamed() {
    let folder = inputs("outputs-order");
    let mut strace = Command::new("strace");
    strace.args([
        "-f",
        "-o",
        "trace",
        "-e",
        "trace=openat,fcntl,write,fsync,rename,close",
        env!("CARGO_BIN_EXE_kinegon"),
    ]);
    let traced = strace.args(["draw", "scene.json", "-o", "out/"]).current_dir(&folder).output();
    let traced = traced.expect("strace is installed");
    assert!(traced.status.success(), "{}", stderr(&traced));
    let trace = fs::read_to_string(folder.join("trace")).expect("a trace");
    // What happens to the open file of each path, in order.
    let (mut open, mut events) = (BTreeMap::new(), Vec::new());
    for line in trace.lines().map(|line| line.split_once(' ').map_or(line, |(_, call)| call.trim())) {
        let quoted = line.split('"').nth(1).unwrap_or_default().to_owned();
        let number = |from: &str| line.split_once(from).and_then(|(_, rest)| rest.split([',', ')', ' ']).next());
        if line.starts_with("openat") {
            open.insert(line.rsplit("= ").next().unwrap_or_default().to_owned(), quoted);
        } else if let (true, Some(file)) =
            (line.contains("F_DUPFD"), number("fcntl(").and_then(|number| open.get(number)))
        {
            // A file may be written through a second handle of it.
            open.insert(line.rsplit("= ").next().unwrap_or_default().to_owned(), file.clone());
        } else if let Some(file) = number("write(").or(number("fsync(")).and_then(|number| open.get(number)) {
            events.push((line[..5].to_owned(), file.clone()));
        } else if line.starts_with("rename") {
            events.push(("renam".to_owned(), quoted));
        }
    }
    for name in ["scene.svg", "scene.png"] {
        let at =
            |what: &str, is: &dyn Fn(&str) -> bool| events.iter().rposition(|(event, path)| event == what && is(path));
        let staged = |path: &str| path.contains("/.kinegon-") && path.ends_with(name);
        let order = [
            at("write", &staged),
            at("fsync", &staged),
            at("renam", &staged),
            at("fsync", &|path| path.ends_with("out")),
        ];
        assert!(order.iter().all(Option::is_some) && order.is_sorted(), "{name}: {order:?} in {events:?}");
    }
    let renames = || events.iter().enumerate().filter(|(_, (event, _))| event == "renam").map(|(at, _)| at);
    let first = renames().next().expect("renames");
    assert!(
        events[first..].iter().all(|(event, _)| event != "write"),
        "all is written before the first rename: {events:?}"
    );
}

/// A table that would fill a disk is not begun.
#[test]
fn a_huge_table_must_be_asked_for() {
    let folder = scratch("outputs-huge");
    let sweep = |arguments: &[&str]| {
        kinegon().args(["sweep", FIGURE_2]).args(arguments).current_dir(&folder).output().expect("it runs")
    };
    for (place, format) in [("t.csv", "csv"), ("-", "jsonl")] {
        let output = sweep(&["--step", "1e-8", "-o", place, "--format", format]);
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{message}");
        for words in ["27 516 416 427 rows and about", "--step", "--want", "--yes"] {
            assert!(message.contains(words), "no `{words}` in {message}");
        }
        assert!(output.stdout.is_empty());
    }
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0);
    // The number of bytes is that of a table that is written: here of its 10 001 rows in the middle.
    let table = |to: &str, from: &str| sweep(&["--want", "omega(4)", "--step", "1e-8", "--from", from, "--to", to]);
    let said = stderr(&table("100", "0"));
    let gigabytes = said.split("about ").nth(1).and_then(|rest| rest.split(" GB").next()).expect("GB");
    let gigabytes: f64 = gigabytes.parse().expect("a number");
    let written = table("50.0001", "50").stdout.len() as f64 / 10_001.0 * 1e10 / 1e9;
    assert!((gigabytes / written - 1.0).abs() < 0.05, "{gigabytes} {written}");
}
