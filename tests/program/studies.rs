//! `kinegon study`: its rows against the closed form of the four-bar and against what makes a crank turn, its parts, its messages.

use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;
use support::program::{self, scratch, stderr};

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/studies/four-bar.json");
const ON_DASK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/studies/on_dask.py");

/// Crank, and distance of the pivots.
const CRANK: f64 = 60.0;
const GROUND: f64 = 160.0;
const OMEGA: f64 = 10.0;

fn kinegon(folder: &Path, arguments: &[&str]) -> Output {
    program::kinegon().current_dir(folder).args(arguments).output().expect("the program runs")
}

/// The study of a four-bar with these further keys.
fn study(keys: &str) -> String {
    format!(
        r#"{{ "kinegon_study": 1,
  "scene": {{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [{GROUND}, 0] }},
    "links": {{
      "1": {{ "points": ["A", "B"], "lengths": {{ "AB": {CRANK} }}, "drive": {{ "angle": 60, "omega": {OMEGA} }} }},
      "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 140 }} }},
      "3": {{ "points": ["D", "C"], "lengths": {{ "CD": 110 }} }} }},
    "near": {{ "C": [155, 110] }} }},
  {keys} }}"#
    )
}

/// The scene of that study, in a file of its own.
#[cfg(unix)]
fn example() -> String {
    let study: serde_json::Value = serde_json::from_str(&study(r#""vary": {}"#)).expect("JSON");
    study["scene"].to_string()
}

/// The rows of a CSV file by the names of its columns.
struct Table(csv::StringRecord, Vec<csv::StringRecord>);

impl Table {
    fn of(bytes: &[u8]) -> Table {
        let mut reader = csv::Reader::from_reader(bytes);
        let head = reader.headers().expect("a head").clone();
        Table(head, reader.records().map(|row| row.expect("a row")).collect())
    }

    fn cell(&self, row: usize, name: &str) -> &str {
        let column = self.0.iter().position(|other| other == name).unwrap_or_else(|| panic!("no column {name}"));
        &self.1[row][column]
    }

    fn number(&self, row: usize, name: &str) -> f64 {
        self.cell(row, name).parse().unwrap_or_else(|_| panic!("no number in row {row}, column {name}"))
    }
}

fn table(folder: &Path, keys: &str) -> Table {
    std::fs::write(folder.join("study.json"), study(keys)).expect("written");
    let output = kinegon(folder, &["study", "study.json"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    Table::of(&output.stdout)
}

/// ω and α of the rocker, and its angle, with C above the diagonal BD: from the triangle BCD, and the loop's derivatives.
fn rocker(coupler: f64, rocker: f64, degrees: f64) -> [f64; 3] {
    let (s, c) = libm::sincos(degrees.to_radians());
    let b = [CRANK * c, CRANK * s];
    let d = [GROUND - b[0], -b[1]];
    let diagonal = libm::hypot(d[0], d[1]);
    let along = (diagonal * diagonal + coupler * coupler - rocker * rocker) / (2.0 * diagonal);
    let across = (coupler * coupler - along * along).sqrt();
    let u = [d[0] / diagonal, d[1] / diagonal];
    let bc = [along * u[0] - across * u[1], along * u[1] + across * u[0]];
    let dc = [b[0] + bc[0] - GROUND, b[1] + bc[1]];
    // v_C·BC = v_B·BC; with v_C = ω3 J DC.
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let v_b = [-OMEGA * b[1], OMEGA * b[0]];
    let omega = dot(v_b, bc) / cross(dc, bc);
    let v_c = [-omega * dc[1], omega * dc[0]];
    let relative = [v_c[0] - v_b[0], v_c[1] - v_b[1]];
    // (a_C − a_B)·BC + |v_C − v_B|² = 0, a_C = α J DC − ω² DC.
    let alpha = (dot([-OMEGA * OMEGA * b[0], -OMEGA * OMEGA * b[1]], bc) + omega * omega * dot(dc, bc)
        - dot(relative, relative))
        / cross(dc, bc);
    [omega, alpha, libm::atan2(dc[1], dc[0]).to_degrees()]
}

/// Extremes of the closed form: least and greatest of ω, α and angle, by samples a hundredth of a degree apart.
fn extremes(coupler: f64, length: f64) -> [[f64; 2]; 3] {
    let mut found = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for k in 0..36_000 {
        for (found, y) in found.iter_mut().zip(rocker(coupler, length, f64::from(k) / 100.0)) {
            *found = [found[0].min(y), found[1].max(y)];
        }
    }
    found
}

/// The crank turns where both triangles exist in which it lies along the ground.
fn turns(coupler: f64, rocker: f64) -> bool {
    let is_triangle = |side: f64| (coupler - rocker).abs() < side && side < coupler + rocker;
    is_triangle(GROUND - CRANK) && is_triangle(GROUND + CRANK)
}

#[test]
fn extremes_are_those_of_the_closed_form() {
    let folder = scratch("study-extremes");
    let found = table(
        &folder,
        r#""vary": { "2.BC": { "from": 125, "to": 170 }, "3.CD": { "plus_minus": 14 } }, "count": 60, "seed": 5,
        "cycle": { "from": 0, "to": 360, "step": 5 },
        "want": { "omega(3)": ["max", "min", "at_scene", "mean"], "alpha(3)": ["max", "min", "max_abs", "range"], "angle(3)": ["range"] }"#,
    );
    let mut worst = 0.0_f64;
    let mut whole = 0;
    for row in 0..60 {
        let [coupler, length] = ["2.BC", "3.CD"].map(|name| found.number(row, name));
        assert_eq!(found.cell(row, "status") == "whole", turns(coupler, length), "{coupler} {length}");
        let here = rocker(coupler, length, 60.0);
        assert!((found.number(row, "omega(3).at_scene") - here[0]).abs() < 1e-11);
        if !turns(coupler, length) {
            continue;
        }
        whole += 1;
        let expected = extremes(coupler, length);
        for (which, name) in ["omega(3)", "alpha(3)"].iter().enumerate() {
            let height = expected[which][1] - expected[which][0];
            for (side, figure) in ["min", "max"].iter().enumerate() {
                let name = format!("{name}.{figure}");
                let off = (found.number(row, &name) - expected[which][side]).abs() / height;
                worst = worst.max(off);
                assert!(off < 1e-6, "{name} of {coupler} {length}: {off:e}");
                let at = rocker(coupler, length, found.number(row, &format!("{name}_at")))[which];
                assert!((at - found.number(row, &name)).abs() < 1e-9 * height, "{name}_at");
            }
        }
        let [low, high] = expected[1];
        assert!((found.number(row, "alpha(3).range") - (high - low)).abs() < 2e-6 * (high - low));
        assert!((found.number(row, "alpha(3).max_abs") - high.abs().max(low.abs())).abs() < 1e-6 * (high - low));
        assert!((found.number(row, "angle(3).range") - (expected[2][1] - expected[2][0])).abs() < 1e-5);
        // The rocker comes back: its angular velocity has the mean 0.
        assert!(found.number(row, "omega(3).mean").abs() < 1e-6);
    }
    assert!(whole > 30, "{whole}");
    println!("worst of {whole}: {worst:e} of the height");
}

/// Extremes at the steps are those of the closed form at the steps, and are told apart from the curve's own.
#[test]
fn extremes_at_the_steps_alone() {
    let folder = scratch("study-steps");
    let found = table(
        &folder,
        r#""vary": { "2.BC": { "from": 135, "to": 145 } }, "count": 40, "at_steps": true,
        "cycle": { "from": 0, "to": 360, "step": 5 }, "want": { "alpha(3)": ["max", "min"] }"#,
    );
    let mut missed = 0.0_f64;
    for row in 0..40 {
        let coupler = found.number(row, "2.BC");
        let samples: Vec<f64> = (0..=72).map(|k| rocker(coupler, 110.0, 5.0 * f64::from(k))[1]).collect();
        let greatest = samples.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = samples.iter().copied().fold(f64::INFINITY, f64::min);
        for (name, expected) in [("alpha(3).max", greatest), ("alpha(3).min", least)] {
            assert!((found.number(row, name) - expected).abs() < 1e-9 * (greatest - least), "{name} of {coupler}");
            let at = found.number(row, &format!("{name}_at"));
            assert_eq!(at % 5.0, 0.0);
            assert!((rocker(coupler, 110.0, at)[1] - expected).abs() < 1e-9 * (greatest - least));
        }
        missed = missed.max((extremes(coupler, 110.0)[1][1] - greatest) / (greatest - least));
    }
    assert!(missed > 1e-4, "the steps miss the peaks by {missed:e} of the height at most");
}

/// Which cranks turn is known; a limit lies where coupler and rocker are in line.
/// With errors each value at one position has the bound of its error there, against the closed form.
#[test]
fn values_have_bounds_where_they_are_asked_for() {
    let folder = scratch("study-errors");
    let keys = r#""vary": { "2.BC": { "from": 130, "to": 150, "count": 5 }, "3.CD": { "from": 100, "to": 130, "count": 3 } }, "bounds": true,
        "cycle": { "from": 0, "to": 360, "step": 5 },
        "want": { "omega(3)": ["max", "min", "max_abs", "range", "mean", "at_scene"], "v(C)": ["min"], "angle(3)": ["max"], "angle(1)": ["at_scene"] }"#;
    let table = table(&folder, keys);
    let mut checked = 0;
    for row in 0..table.1.len() {
        let of = |degrees: f64| rocker(table.number(row, "2.BC"), table.number(row, "3.CD"), degrees);
        for (name, at, index) in [
            ("omega(3).max", "omega(3).max_at", 0),
            ("omega(3).min", "omega(3).min_at", 0),
            ("omega(3).at_scene", "", 0),
            ("angle(3).max", "angle(3).max_at", 2),
        ] {
            if table.cell(row, name).is_empty() {
                continue;
            }
            let truth = of(if at.is_empty() { 60.0 } else { table.number(row, at) })[index];
            let (value, bound) = (table.number(row, name), table.number(row, &format!("{name}_error")));
            // The closed form is rounded, too.
            assert!(bound > 0.0 && bound < 1e-10, "row {row}: {name} ± {bound}");
            assert!(
                (value - truth).abs() <= bound + 2e-12 * value.abs(),
                "row {row}: {name} = {value} ± {bound}, {truth}"
            );
            checked += 1;
        }
        assert_eq!(table.number(row, "angle(1).at_scene_error"), 0.0);
        assert!(table.number(row, "v(C).min_error") < 1e-9);
    }
    assert!(checked >= 30, "{checked}");
    for without in ["omega(3).range_error", "omega(3).mean_error"] {
        assert!(!table.0.iter().any(|name| name == without), "{without}");
    }
}

#[test]
fn cranks_turn_by_the_rule_of_grashof() {
    let folder = scratch("study-grashof");
    let found = table(
        &folder,
        r#""vary": { "2.BC": { "from": 41, "to": 241, "count": 9 }, "3.CD": { "from": 33, "to": 233, "count": 9 } },
        "cycle": { "from": 0, "to": 360, "step": 5 }, "want": { "omega(3)": ["max"] }"#,
    );
    assert_eq!(found.1.len(), 81);
    let mut limits = 0;
    for row in 0..81 {
        let [coupler, length] = ["2.BC", "3.CD"].map(|name| found.number(row, name));
        assert_eq!(found.number(row, "index"), row as f64);
        let status = found.cell(row, "status");
        // At 60° the diagonal BD is 140.
        let is_there = (coupler - length).abs() < 140.0 && 140.0 < coupler + length;
        let expected = if !is_there {
            "not assembled"
        } else if turns(coupler, length) {
            "whole"
        } else {
            "part"
        };
        assert_eq!(status, expected, "{coupler} {length}");
        if status == "part" {
            let ends = ["reach_from", "reach_to"].map(|name| found.number(row, name));
            for end in ends.into_iter().filter(|end| *end != 0.0 && *end != 360.0) {
                let b = [CRANK * libm::cos(end.to_radians()), CRANK * libm::sin(end.to_radians())];
                let diagonal = libm::hypot(GROUND - b[0], b[1]);
                let off = (diagonal - coupler - length).abs().min((diagonal - (coupler - length).abs()).abs());
                assert!(off < 1e-6, "{coupler} {length}: {end}");
                limits += 1;
            }
        }
    }
    assert!(limits > 20, "{limits}");
}

const LONG: &str = r#""vary": { "2.BC": { "plus_minus": 5 }, "3.CD": { "sigma": 1 } }, "count": 20000, "seed": 3,
    "cycle": { "from": 56, "to": 64, "step": 4 }, "want": { "omega(3)": ["max"] }"#;

/// Rows hang on the study and their index alone: shards are lines of the whole, and parts made by several runs give its bytes.
#[test]
fn shards_joined_are_the_whole() {
    let folder = scratch("study-shards");
    std::fs::write(folder.join("study.json"), study(LONG)).expect("written");
    let run = |arguments: &[&str]| {
        let output = kinegon(&folder, &[&["study", "study.json"], arguments].concat());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        output.stdout
    };
    run(&["-o", "whole.csv"]);
    assert!(!folder.join("whole.csv.parts").exists());
    let whole = std::fs::read_to_string(folder.join("whole.csv")).expect("written");
    assert_eq!(whole.lines().count(), 20_001);
    let shard = String::from_utf8(run(&["--rows", "4090..4217"])).expect("UTF-8");
    let lines: Vec<&str> = whole.lines().collect();
    assert_eq!(shard.lines().skip(1).collect::<Vec<_>>(), lines[4091..4218]);
    for rows in ["9000..20000", "0..9000"] {
        run(&["-o", "parts.csv", "--parts", "--rows", rows]);
    }
    assert!(!folder.join("parts.csv").exists());
    run(&["-o", "parts.csv"]);
    assert!(std::fs::read(folder.join("parts.csv")).expect("written") == whole.as_bytes(), "other bytes");
    assert_eq!(run(&["--count"]), b"20000\n");
}

/// A run that is killed goes on when it is started again; another study under its name is refused.
#[test]
fn a_killed_run_goes_on() {
    let folder = scratch("study-killed");
    std::fs::write(folder.join("study.json"), study(LONG)).expect("written");
    let start = |output: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_kinegon"));
        command.current_dir(&folder).args(["study", "study.json", "-o", output]).stderr(Stdio::piped());
        command.env("RAYON_NUM_THREADS", "1").spawn().expect("it starts")
    };
    start("whole.csv").wait().expect("it ends");
    let mut child = start("killed.csv");
    let parts = folder.join("killed.csv.parts");
    let count =
        || std::fs::read_dir(&parts).map_or(0, |all| all.flatten().filter(|e| e.file_name().len() == 21).count());
    while count() < 2 && child.try_wait().expect("it can be asked").is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().expect("it can be killed");
    child.wait().expect("it ends");
    assert!(!folder.join("killed.csv").exists() && (2..5).contains(&count()), "{} parts", count());

    std::fs::write(folder.join("other.json"), study(&LONG.replace("20000", "19999"))).expect("written");
    let other = kinegon(&folder, &["study", "other.json", "-o", "killed.csv"]);
    assert_eq!(other.status.code(), Some(2));
    assert!(stderr(&other).contains("has rows of another study"), "{}", stderr(&other));

    let again = start("killed.csv").wait_with_output().expect("it ends");
    assert!(stderr(&again).contains("of 5 parts are there already"), "{}", stderr(&again));
    let [killed, whole] = ["killed.csv", "whole.csv"].map(|name| std::fs::read(folder.join(name)).expect("written"));
    assert!(killed == whole, "other bytes");
    assert!(!parts.exists());
}

/// A part in which a bit has turned is no row of the table; and what one run joins no other is at work on.
#[test]
fn parts_that_have_changed_are_told_and_runs_apart() {
    let folder = scratch("study-changed");
    std::fs::write(folder.join("study.json"), study(LONG)).expect("written");
    let run = |more: &[&str]| kinegon(&folder, &[&["study", "study.json", "-o", "all.csv"][..], more].concat());
    assert!(run(&["--parts", "--rows", "0..4096"]).status.success());
    let parts = folder.join("all.csv.parts");
    let named = |entry: &std::fs::DirEntry| entry.file_name().len() == 21;
    let part = std::fs::read_dir(&parts).expect("there are parts").flatten().find(named).expect("one is there").path();
    let mut bytes = std::fs::read(&part).expect("it can be read");
    bytes[1000] ^= 0x10;
    std::fs::write(&part, &bytes).expect("it can be written");
    let output = run(&[]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let message = stderr(&output);
    assert!(message.contains("is not as it was written") && message.contains("remove that file"), "{message}");
    assert!(!folder.join("all.csv").exists());

    let lock = std::fs::File::options().append(true).open(parts.join("lock")).expect("it is there");
    lock.lock().expect("this file system can lock");
    let output = run(&[]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert!(stderr(&output).contains("another run is at work on"), "{}", stderr(&output));
    lock.unlock().expect("it was locked");

    std::fs::remove_file(&part).expect("it can be removed");
    assert!(run(&[]).status.success());
    let again = kinegon(&folder, &["study", "study.json", "-o", "whole.csv"]);
    assert!(again.status.success());
    let [all, whole] = ["all.csv", "whole.csv"].map(|name| std::fs::read(folder.join(name)).expect("written"));
    assert!(all == whole, "other bytes");
}

/// What a study names is a file, and so are its parts: nothing waits for a pipe or for stdin.
#[test]
#[cfg(unix)]
fn only_files_are_read_for_a_study() {
    let folder = scratch("study-special");
    let keys = r#""vary": { "2.BC": { "plus_minus": 5 } }, "count": 5000, "cycle": { "from": 0, "to": 10, "step": 5 },
        "want": { "omega(3)": ["max"] }"#;
    std::fs::write(folder.join("scene.json"), example()).expect("written");
    let pipe = |path: &str| assert!(Command::new("mkfifo").arg(folder.join(path)).status().expect("it runs").success());
    let run = |scene: &str| {
        let study = format!(r#"{{ "kinegon_study": 1, "scene": "{scene}", {keys} }}"#);
        std::fs::write(folder.join("study.json"), study).expect("written");
        let mut command = program::kinegon();
        let output = program::in_a_minute(
            command.current_dir(&folder).args(["study", "study.json", "-o", "all.csv"]),
            example().as_bytes(),
        );
        let output = output.unwrap_or_else(|| panic!("{scene}: it waits"));
        (output.status.code(), stderr(&output))
    };
    let (code, message) = run("-");
    assert!(code == Some(2) && message.contains("-, which the study names as its scene, cannot be read"), "{message}");
    pipe("pipe");
    let (code, message) = run("pipe");
    assert!(code == Some(2) && message.contains("pipe, which the study names as its scene, is a pipe"), "{message}");
    std::fs::create_dir(folder.join("all.csv.parts")).expect("made");
    pipe("all.csv.parts/lock");
    pipe("all.csv.parts/0000000000-0000004096");
    let (code, message) = run("scene.json");
    assert_eq!(code, Some(0), "{message}");
    std::fs::create_dir(folder.join("all.csv.parts")).expect("made");
    pipe("all.csv.parts/study");
    let (code, message) = run("scene.json");
    assert!(code == Some(1) && message.contains("study is a pipe or a device"), "{message}");
}

/// A study of a stranger may name any file as its scene; nothing of it is shown.
#[test]
fn a_file_elsewhere_is_not_shown() {
    let folder = scratch("study-elsewhere");
    std::fs::create_dir_all(folder.join("study")).expect("made");
    std::fs::write(folder.join("secret.txt"), "root:x:0:0:a secret\n").expect("written");
    let keys = r#""vary": { "2.BC": { "plus_minus": 5 } }, "count": 10, "cycle": { "from": 0, "to": 360, "step": 5 },
        "want": { "omega(3)": ["max"] }"#;
    let run = |scene: &str| {
        let study = format!(r#"{{ "kinegon_study": 1, "scene": "{scene}", {keys} }}"#);
        std::fs::write(folder.join("study/study.json"), study).expect("written");
        kinegon(&folder, &["study", "study/study.json"])
    };
    let output = run("../secret.txt");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("secret.txt, which the study names as its scene"), "{}", stderr(&output));
    assert!(!stderr(&output).contains("root"), "{}", stderr(&output));
    // A scene in another folder is one all the same; of one in its own a message has the line.
    let scene = std::fs::read(support::files::path("templates/four-bar.json")).expect("it is there");
    std::fs::write(folder.join("four-bar.json"), scene).expect("written");
    let output = run("../four-bar.json");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    std::fs::write(folder.join("study/own.json"), "{ \"kinegon\": 1, \"wrong\": 2 }").expect("written");
    assert!(stderr(&run("own.json")).contains("wrong"));
}

/// Two Dask workers, of which one is killed in the middle, make the bytes of one run.
#[test]
#[ignore = "needs Python with dask.distributed (KINEGON_PYTHON names another Python)"]
fn dask_makes_the_same_bytes() {
    let python = std::env::var("KINEGON_PYTHON").unwrap_or_else(|_| "python3".into());
    let folder = scratch("study-dask");
    std::fs::write(folder.join("study.json"), study(LONG)).expect("written");
    assert!(kinegon(&folder, &["study", "study.json", "-o", "whole.csv"]).status.success());
    let script = r#"
import importlib.util, os, signal, sys, threading, time
from dask.distributed import Client, LocalCluster
spec = importlib.util.spec_from_file_location("on_dask", sys.argv[1])
on_dask = importlib.util.module_from_spec(spec)
sys.modules["on_dask"] = on_dask
spec.loader.exec_module(on_dask)
def kill(client):
    while len(os.listdir("dask.csv.parts") if os.path.isdir("dask.csv.parts") else []) < 2:
        time.sleep(0.01)
    pids = client.run(os.getpid)
    os.kill(next(iter(pids.values())), signal.SIGKILL)
    print("killed one of", len(pids))
if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(sys.argv[1]))
    os.environ["RAYON_NUM_THREADS"] = "1"
    os.environ["PYTHONPATH"] = os.path.dirname(sys.argv[1])
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        killer = threading.Thread(target=kill, args=(client,))
        killer.start()
        on_dask.run("study.json", "dask.csv", client)
        killer.join()
"#;
    std::fs::write(folder.join("run.py"), script).expect("written");
    let mut command = Command::new(&python);
    command.current_dir(&folder).args(["run.py", ON_DASK]).env("KINEGON", env!("CARGO_BIN_EXE_kinegon"));
    let output = command.output().expect("it runs");
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(String::from_utf8_lossy(&output.stdout).contains("killed one of 2"), "{}", stderr(&output));
    let [dask, whole] = ["dask.csv", "whole.csv"].map(|name| std::fs::read(folder.join(name)).expect("written"));
    assert!(dask == whole, "other bytes");
}

#[test]
fn the_example_runs() {
    let output = kinegon(Path::new("."), &["study", EXAMPLE]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(Table::of(&output.stdout).1.len(), 1000);
    assert!(stderr(&output).contains("mechanisms: 1000 whole"), "{}", stderr(&output));
}

/// One message, with its place, and nothing written.
#[test]
fn bad_studies_are_refused() {
    let folder = scratch("study-bad");
    let vary = r#""vary": { "2.BC": { "plus_minus": 5 } }, "count": 10,"#;
    let cycle = r#""cycle": { "from": 0, "to": 360, "step": 5 },"#;
    let want = r#""want": { "omega(3)": ["max"] }"#;
    let bad = [
        (format!(r#"{vary} {cycle} "want": {{ "omega(7)": ["max"] }}"#), "omega(7)"),
        (format!(r#"{vary} {cycle} "want": {{ "omega(3)": ["most"] }}"#), "unknown word \"most\""),
        (format!(r#"{vary} {cycle} "want": {{ "omega(3)": [] }}"#), "no figure of this quantity"),
        (format!(r#"{vary} {cycle} "want": {{}}"#), "nothing is wanted"),
        (
            format!(r#""vary": {{ "2.BD": {{ "plus_minus": 5 }} }}, "count": 10, {cycle} {want}"#),
            "did you mean `2.BC`?",
        ),
        (format!(r#""vary": {{ "2.BC": {{ "plus_minus": 5 }} }}, {cycle} {want}"#), "nothing says how often"),
        (
            format!(r#""vary": {{ "2.BC": {{ "plus_minus": -5 }} }}, "count": 10, {cycle} {want}"#),
            "a tolerance is a positive number",
        ),
        (format!(r#""vary": {{ "2.BC": {{ "from": 3, "to": 4, "count": 1 }} }}, {cycle} {want}"#), "at least 2 values"),
        (format!(r#""vary": {{ "2.BC": {{ "from": 3 }} }}, {cycle} {want}"#), "neither a grid nor a tolerance"),
        (
            format!(r#""vary": {{ "2.BC": {{ "from": 3, "to": 4, "count": 3 }} }}, "count": 9, {cycle} {want}"#),
            "nothing varies at random",
        ),
        (
            format!(r#""vary": {{ "1.angle": {{ "plus_minus": 5 }} }}, "count": 10, {cycle} {want}"#),
            "the drive that moves",
        ),
        (format!(r#"{vary} "cycle": {{ "from": 0, "to": 360, "step": 7 }}, {want}"#), "no whole number of steps"),
        (
            format!(r#"{vary} "cycle": {{ "from": 0, "to": 360, "step": 5, "drive": "2" }}, {want}"#),
            "there is no drive `2`",
        ),
        (format!(r#"{vary} {cycle} {want}, "rows": 3"#), "unknown key `rows`"),
        (format!(r#""vary": {{}}, {cycle} {want}"#), "nothing varies"),
        (format!(r#"{vary} {cycle} {want}, "bounds": true, "at_steps": true"#), "bounds are those of extremes"),
    ];
    for (keys, expected) in bad {
        std::fs::write(folder.join("study.json"), study(&keys)).expect("written");
        let output = kinegon(&folder, &["study", "study.json", "-o", "out.csv"]);
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{keys}: {message}");
        assert!(message.contains(expected), "{expected}: {message}");
        assert!(message.contains("study.json:8"), "no place: {message}");
        assert_eq!(message.matches("error").count(), 1, "{message}");
    }
    // In the scene within, too.
    std::fs::write(folder.join("study.json"), study(&format!("{vary} {cycle} {want}")).replace("140", "-140"))
        .expect("written");
    let output = kinegon(&folder, &["study", "study.json"]);
    assert!(
        stderr(&output).contains("study.json:5:") && stderr(&output).contains("a length is positive"),
        "{}",
        stderr(&output)
    );
    std::fs::write(folder.join("study.json"), study(&format!("{vary} {cycle} {want}"))).expect("written");
    let forms: [(&[&str], &str); 3] = [
        (&["-o", "out.jsonl"], "ending in `.jsonl`"),
        (&["-o", "out.xls"], "known endings: csv"),
        (&["-o", "out.csv", "--format", "jsonl"], "not written as JSON lines"),
    ];
    for (options, expected) in forms {
        let output = kinegon(&folder, &[&["study", "study.json"], options].concat());
        assert!(output.status.code() == Some(2) && stderr(&output).contains(expected), "{}", stderr(&output));
    }
    assert_eq!(std::fs::read_dir(&folder).expect("listed").count(), 1, "something was written");
}
