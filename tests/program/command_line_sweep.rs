//! `kinegon sweep` from outside: tables on stdout or in files, whole or not at all.

use kinegon::cycle::{Drive, Path as Branch, Steps, Sweep};
use kinegon::{Scene, Solution, format, solve};
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use support::program::{kinegon, scratch, stderr};

const FIGURE_2: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/figure-2.json");

/// Longer than any of these commands takes; much less than they would take if they did not stop.
const SOON: Duration = Duration::from_secs(60);

fn sweep(arguments: &[&str]) -> Output {
    let output = kinegon().args(["sweep", FIGURE_2]).args(arguments).output();
    output.expect("the program runs")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("it can be listed");
    let mut names: Vec<String> =
        entries.map(|e| e.expect("listed").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_table_has_a_row_for_each_step() {
    let output =
        sweep(&["--from", "69.8", "--to", "70", "--step", "0.1", "--want", "omega(4), L(B,S3)", "--want", "v(D)"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let text = stdout(&output);
    let lines: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(text.lines().next(), Some("angle(1),omega(4),\"L(B,S3)\",v(D).x,v(D).y"));
    let firsts: Vec<&str> = lines.iter().map(|line| line[0]).collect();
    assert_eq!(firsts, ["69.8", "69.9", "70.0"]);
    let number = |k: usize| lines[2][k].parse::<f64>().expect("a number");
    assert!((number(1) - -0.474_663_754_894).abs() < 1e-12 && (number(2) - 370.964_757_433_2).abs() < 1e-9);
    assert!(output.stderr.is_empty(), "{}", stderr(&output));
}

/// The file holds the same bytes as stdout, in the form that its ending says; rows computed on all cores are those of one.
#[test]
fn files_hold_the_same_bytes() {
    let folder = scratch("sweep-files");
    let scene = Scene::read(&std::fs::read_to_string(FIGURE_2).expect("read")).expect("a scene");
    let Solution { mechanism, pose, .. } = solve(&scene).expect("it can be solved");
    let drive = Drive::new(&mechanism, None).expect("a drive");
    let mut branch = Branch::new(&mechanism, &pose, drive).expect("a regular position");
    branch.cover(Some(-130.0), Some(130.0)).expect("it can be followed");
    let steps = Steps::new(-130.0, 130.0, 0.02).expect("steps");
    let table = Sweep::new(&branch, steps, None).expect("all quantities");
    let rows: Vec<usize> = (0..table.steps.count()).step_by(2048).collect();
    let rows = |text: &dyn Fn(&[Option<f64>]) -> String| -> String {
        let piece = |first: &usize| table.rows(*first..(first + 2048).min(table.steps.count()));
        rows.iter().map(|first| text(&piece(first))).collect()
    };
    let columns = format::columns_of(&table);
    let csv = format::csv_header(&columns) + &rows(&|numbers| format::csv_rows(&columns, numbers));
    let json = rows(&|numbers| format::json_lines(&table, numbers));
    let range = ["--from", "-130", "--to", "130", "--step", "0.02"];
    for (name, expected) in [("a.csv", &csv), ("a.jsonl", &json), ("new/b.ndjson", &json), ("-", &csv)] {
        let file = folder.join(name);
        let path = if name == "-" { "-" } else { file.to_str().expect("UTF-8") };
        let output = sweep(&[&range[..], &["-o", path]].concat());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let got = if name == "-" { stdout(&output) } else { std::fs::read_to_string(&file).expect("written") };
        assert!(got == *expected, "{name} differs");
    }
    let file = folder.join("c.txt");
    let path = file.to_str().expect("UTF-8");
    let output = sweep(&[&range[..], &["-o", path, "--format", "jsonl"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(std::fs::read_to_string(file).expect("written") == json);
    assert_eq!(names(&folder), ["a.csv", "a.jsonl", "c.txt", "new"]);
}

/// Commands that must be refused: exit code, words that the message must have, arguments.
const REFUSED: [(i32, &[&str], &[&str]); 23] = [
    (2, &["`omga(4)` is no quantity", "omega(2)"], &["--want", "omga(4)"]),
    (2, &["no link `44`", "did you mean `4`?"], &["--want", "omega(44)"]),
    (2, &["no plan point `s9`"], &["--want", "vplan(b,s9)"]),
    (2, &["vplan(b,s3)/mu", "no scale"], &["--want", "vplan(b,s3)/mu"]),
    (2, &["no drive `4`", "the drives are: 1"], &["--drive", "4"]),
    (2, &["the step cannot be 0"], &["--step", "0"]),
    (2, &["the step cannot be 0"], &["--from", "0", "--to", "10", "--step", "0"]),
    (2, &["the step cannot be NaN"], &["--step", "nan"]),
    (2, &["leads away", "a positive step"], &["--from", "0", "--to", "10", "--step", "-1"]),
    (2, &["leads away"], &["--step", "-1"]),
    (2, &["more than 1e12 steps", "a larger step"], &["--from", "0", "--to", "10", "--step", "1e-12"]),
    (2, &["finite"], &["--from", "nan", "--to", "10"]),
    (2, &["finite"], &["--from", "0", "--to", "inf"]),
    (2, &["a hundred turns", "36070°"], &["--from", "0", "--to", "1e6"]),
    (
        1,
        &["cannot be reached", "limit position at angle(1) = 137.5820821392°", "-137.58"],
        &["--from", "140", "--to", "200"],
    ),
    (2, &["--from", "abc"], &["--from", "abc"]),
    (2, &["no form of table", ".bmp", "csv, jsonl"], &["-o", "FOLDER/table.bmp"]),
    (1, &["directory"], &["-o", "FOLDER"]),
    (1, &["cannot be written"], &["-o", "FOLDER/scene.csv/table.csv"]),
    (2, &["is the scene itself"], &["-o", "FOLDER/scene.csv"]),
    (2, &["numbered from 1"], &["--mode", "0"]),
    (1, &["no assembly mode 9", "there are 2"], &["--mode", "9"]),
    (2, &["-1"], &["--mode", "-1"]),
];

#[test]
fn bad_commands_get_one_message_and_write_nothing() {
    let folder = scratch("sweep-refused");
    let scene = folder.join("scene.csv");
    std::fs::copy(FIGURE_2, &scene).expect("written");
    for (code, words, arguments) in REFUSED {
        let arguments = arguments.iter().map(|a| a.replace("FOLDER", folder.to_str().expect("UTF-8")));
        let mut command = kinegon();
        command.arg("sweep").arg(&scene).args(arguments);
        // A table that is not refused would be short.
        let output = command.output().expect("the program runs");
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(code), "{words:?}: {message}");
        assert!(output.stdout.is_empty(), "{words:?}");
        assert_eq!(message.matches("error:").count(), 1, "{message}");
        for word in words {
            assert!(message.contains(word), "no `{word}` in: {message}");
        }
        assert_eq!(names(&folder), ["scene.csv"], "{words:?}");
    }
    assert_eq!(std::fs::read(scene).expect("it is there"), std::fs::read(FIGURE_2).expect("it is there"));
}

#[test]
fn a_drawn_configuration_cannot_move() {
    let drawn = FIGURE_2.replace("figure-2", "figure-1");
    let output = kinegon().args(["sweep", &drawn]).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("has no lengths"), "{}", stderr(&output));
}

/// What can be reached is kept, and the rest is an error.
#[test]
fn a_range_beyond_a_limit_is_kept_in_part() {
    let folder = scratch("sweep-partly");
    let file = folder.join("table.csv");
    let path = file.to_str().expect("UTF-8");
    let output = sweep(&["--from", "150", "--to", "130", "--step", "5", "--want", "omega(4)", "-o", path]);
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("only a part of the range"), "{message}");
    assert!(message.contains("137.5820821392°"), "{message}");
    assert_eq!(message.matches("error").count(), 1, "{message}");
    let text = std::fs::read_to_string(&file).expect("written");
    let firsts: Vec<&str> = text.lines().filter_map(|line| line.split(',').next()).collect();
    assert_eq!(firsts, ["angle(1)", "135.0", "130.0"]);
    assert_eq!(names(&folder), ["table.csv"]);
}

/// A four-bar whose crank goes from 51.3° by 180° to 308.7°.
const AROUND: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [50, 0] },
    "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 40 }, "drive": { "angle": 100, "omega": 1 } },
               "2": { "points": ["B", "C"], "lengths": { "BC": 70 } }, "3": { "points": ["D", "C"], "lengths": { "DC": 30 } } },
    "near": { "C": [60, 30] } }"#;

/// What can be reached the other way round is said, and what to type for it works.
#[test]
fn the_other_way_round_is_offered() {
    let folder = scratch("sweep-around");
    let scene = folder.join("scene.json");
    std::fs::write(&scene, AROUND).expect("written");
    let run = |arguments: &[&str]| kinegon().arg("sweep").arg(&scene).args(arguments).output().expect("it runs");
    let output = run(&["--from", "-180", "--to", "180", "--want", "omega(3)"]);
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{message}");
    for words in ["from -180° to -51.31", "the other way round, as 180° to 308.68", "--from 52 --to 308"] {
        assert!(message.contains(words), "no `{words}` in: {message}");
    }
    let output = run(&["--from", "52", "--to", "308", "--want", "omega(3)"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(stdout(&output).lines().count(), 1 + 257);
}

/// Lengths next to those of a parallelogram: the limit is told whatever range is asked for, and no stop and no change point is made up.
#[test]
fn a_limit_next_to_a_change_point_is_told() {
    let folder = scratch("sweep-near");
    let scene = folder.join("scene.json");
    let text = AROUND.replace("\"D\": [50, 0]", "\"D\": [150, 0]").replace("\"AB\": 40", "\"AB\": 60");
    let text = text.replace("\"BC\": 70", "\"BC\": 150.000000001").replace("\"DC\": 30", "\"DC\": 60");
    let text = text.replace("\"angle\": 100", "\"angle\": 30").replace("[60, 30]", "[202, 30]");
    std::fs::write(&scene, text).expect("written");
    for [from, to] in [["0", "60"], ["-1", "60"], ["-10", "10"], ["-30", "30"], ["0", "360"]] {
        let output =
            kinegon().arg("sweep").arg(&scene).args(["--from", from, "--to", to, "--want", "omega(2)"]).output();
        let output = output.expect("it runs");
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains("limit position at angle(1) = 0.000256"), "{message}");
        assert!(!message.contains("change point"), "{message}");
    }
}

/// Also what is measured on a plan has a column of errors.
#[test]
fn errors_have_their_columns() {
    let output = sweep(&["--from", "69", "--to", "70", "--want", "omega(4), v(D), vplan(b,s3)", "--errors"]);
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(0), "{message}");
    let text = stdout(&output);
    assert_eq!(
        text.lines().next(),
        Some("angle(1),omega(4),omega(4)_error,v(D).x,v(D).y,v(D)_error,\"vplan(b,s3)\",\"vplan(b,s3)_error\"")
    );
    let last: Vec<f64> = text.lines().last().expect("a row").split(',').map(|n| n.parse().expect("a number")).collect();
    assert!((last[1] - -0.474_663_754_894).abs() < 1e-12 && last[2] > 0.0 && last[2] < 1e-12, "{last:?}");
    assert!(last[7] > 0.0 && last[7] < 1e-10 * last[6], "{last:?}");
}

#[test]
fn limits_and_extreme_positions_are_told() {
    let output = sweep(&["--want", "omega(4)"]);
    assert_eq!(output.status.code(), Some(0));
    let message = stderr(&output);
    for words in [
        "note: limit position at angle(1) = -137.5820821392°: links 2, 3, 4, 5 can go no further",
        "note: limit position at angle(1) = 137.5820821392°",
        // The slider turns where the paper's crank lies along the ground: BG is longest or shortest there.
        "note: extreme position at angle(1) = 0°: slider 3/2 stops at 345.341702 and slides back",
    ] {
        assert!(message.contains(words), "{message}");
    }
    // From limit to limit, at whole degrees.
    let text = stdout(&output);
    assert_eq!(text.lines().count(), 1 + 275);
    assert!(text.lines().nth(1).expect("a row").starts_with("-137.0,"), "{text}");
    // Of very many only the first are told.
    let four_bar = FIGURE_2.replace("examples/figure-2", "templates/four-bar");
    let output = kinegon()
        .args(["sweep", &four_bar, "--from", "0", "--to", "36000", "--step", "360"])
        .output()
        .expect("the program runs");
    let message = stderr(&output);
    assert_eq!(message.lines().filter(|line| line.contains("extreme position at")).count(), 30);
    assert!(message.contains("370 more"), "{message}");
}

/// A table that would take hours.
fn long() -> Command {
    let mut command = kinegon();
    command.args(["sweep", FIGURE_2, "--step", "1e-8", "--yes"]);
    command
}

fn ends_soon(child: &mut Child) -> std::process::ExitStatus {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().expect("it can be asked") {
            return status;
        }
        if start.elapsed() > SOON {
            let _ = child.kill();
            panic!("it goes on and on");
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// As in `kinegon sweep … | head`.
#[test]
fn a_reader_that_goes_away_ends_the_work() {
    let mut child = long().stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    let mut line = String::new();
    let mut reader = BufReader::new(child.stdout.take().expect("it is piped"));
    reader.read_line(&mut line).expect("a line");
    assert!(line.starts_with("angle(1),"), "{line}");
    drop(reader);
    let status = ends_soon(&mut child);
    assert_eq!(status.code(), Some(0));
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_no_file() {
    let folder = scratch("sweep-interrupted");
    let mut child = long().arg("-o").arg(folder.join("table.csv")).stderr(Stdio::piped()).spawn().expect("it starts");
    let start = Instant::now();
    // It has begun to write.
    while names(&folder).is_empty() {
        assert!(start.elapsed() < SOON, "it writes nothing");
        std::thread::sleep(Duration::from_millis(20));
    }
    assert_ne!(names(&folder), ["table.csv"]);
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("kill runs").success());
    let status = ends_soon(&mut child);
    let output = child.wait_with_output().expect("it has ended");
    assert_eq!(status.code(), Some(130));
    assert!(stderr(&output).contains("stopped"), "{}", stderr(&output));
    assert!(names(&folder).is_empty(), "{:?}", names(&folder));
}

/// A pipe that stands in the file system is written to, not replaced; so are devices.
#[cfg(unix)]
#[test]
fn a_named_pipe_stays_one() {
    use std::os::unix::fs::FileTypeExt;
    let folder = scratch("sweep-pipe");
    let pipe = folder.join("table.csv");
    let made = Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo runs").success());
    let mut reader = Command::new("cat");
    let reader = reader.arg(&pipe).stdout(Stdio::piped()).spawn();
    let reader = reader.expect("cat runs");
    let output = sweep(&["--step", "60", "-o", pipe.to_str().expect("UTF-8")]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let kind = std::fs::metadata(&pipe).expect("it is there").file_type();
    assert!(kind.is_fifo());
    let read = reader.wait_with_output().expect("it ends");
    assert_eq!(stdout(&read).lines().count(), 6);
}

#[test]
fn a_scene_from_stdin_can_be_swept() {
    let mut child = kinegon()
        .args(["sweep", "-", "--step", "90", "--format", "jsonl"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    let scene = std::fs::read(FIGURE_2).expect("read");
    child.stdin.take().expect("it is piped").write_all(&scene).expect("it is read");
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    for line in stdout(&output).lines() {
        let row: serde_json::Value = serde_json::from_str(line).expect("JSON");
        assert!(row["omega(4)"].is_number() && row["v(D)"].is_array(), "{row}");
    }
    assert_eq!(stdout(&output).lines().count(), 3);
}
