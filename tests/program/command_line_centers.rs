//! Instant centres asked for on the command line: options draw what keys of the scene do, and say what is not found.

use serde_json::{Value, json};
use std::process::Output;
use support::files;
use support::program::{kinegon, stderr, with_scene};

const FOUR_BAR: &str = "templates/four-bar.json";

fn run(arguments: &[&str]) -> Output {
    kinegon().args(arguments).current_dir(files::path(".")).output().expect("the program runs")
}

fn drawn(output: &Output) -> String {
    assert!(output.status.success(), "{}", stderr(output));
    String::from_utf8(output.stdout.clone()).expect("SVG is text")
}

fn svg(arguments: &[&str]) -> String {
    drawn(&run(&[&["draw"], arguments, &["-o", "-", "--format", "svg"]].concat()))
}

fn by_keys(scene: &str, figure: Value) -> String {
    let mut scene: Value = serde_json::from_str(&files::read(scene)).expect("JSON");
    scene["figure"] = figure;
    drawn(&with_scene(&["draw", "-o", "-", "--format", "svg", "-"], scene.to_string().as_bytes()))
}

#[test]
fn options_and_keys_of_the_scene_draw_the_same() {
    let panels = json!(["scheme", "centers"]);
    let by_option = svg(&[FOUR_BAR, "--centers=P(2,ground), P(1,3)", "--velocities", "C"]);
    let keys = json!({ "panels": panels, "centers": ["P(2,ground)", "P(1,3)"], "velocities": ["C"] });
    assert_eq!(by_option, by_keys(FOUR_BAR, keys));
    assert!(by_option.contains("id=\"centers-velocity-C\""));
    assert_eq!(svg(&[FOUR_BAR, "--centers"]), by_keys(FOUR_BAR, json!({ "panels": panels })));
    let all = svg(&["templates/watt-1.json", "--centers=all"]);
    assert_eq!(all, by_keys("templates/watt-1.json", json!({ "panels": panels, "centers": "all" })));
    let curves = svg(&[FOUR_BAR, "--centrodes", "2", "--inflection", "2"]);
    for id in ["scheme-fixed-centrode-2-1", "scheme-moving-centrode-2-1", "scheme-inflection-circle-2-1"] {
        assert!(curves.contains(&format!("id=\"{id}\"")), "{id}");
    }
    assert!(!svg(&[FOUR_BAR]).contains("centrode"));
}

/// Panels that a scene asks for stay, with its own centres.
#[test]
fn a_scene_with_the_figure_keeps_its_panels() {
    let mut scene: Value = serde_json::from_str(&files::read(FOUR_BAR)).expect("JSON");
    scene["figure"] = json!({ "panels": ["centers", "velocity"], "centers": ["P(1,3)"] });
    let text = scene.to_string();
    let plain = drawn(&with_scene(&["draw", "-o", "-", "--format", "svg", "-"], text.as_bytes()));
    let asked = drawn(&with_scene(&["draw", "-o", "-", "--format", "svg", "--centers", "-"], text.as_bytes()));
    assert_eq!(plain, asked);
}

#[test]
fn what_is_not_there_is_refused() {
    for (option, message) in [
        ("--centers=P(1,7)", "--centers: there is no link 7"),
        ("--centers=P(1,1)", "--centers: \"P(1,1)\" names no instant centre"),
        ("--centers=2", "--centers: \"2\" names no instant centre"),
        ("--centers=,", "--centers names nothing"),
        ("--centers=", "--centers names nothing"),
        ("--velocities=A", "--velocities: point A is on the ground and does not move"),
        ("--velocities=Q", "--velocities: there is no point Q"),
        ("--centrodes=9", "--centrodes: there is no link 9"),
        ("--centrodes=2,2", "--centrodes: "),
        ("--inflection=,", "--inflection names nothing"),
    ] {
        let output = run(&["draw", FOUR_BAR, option, "-o", "-"]);
        assert_eq!(output.status.code(), Some(2), "{option}");
        assert!(stderr(&output).contains(message), "{option}: {}", stderr(&output));
        assert!(output.stdout.is_empty(), "{option}");
    }
    let output = run(&["draw", "examples/figure-1.json", "--centrodes", "2", "-o", "-"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("a drawn configuration cannot be moved"), "{}", stderr(&output));
}

/// What is asked for and not found is said on stderr and on the figure.
#[test]
fn what_is_not_found_is_said() {
    let two_drives = run(&["draw", "templates/five-bar.json", "--velocities", "C", "-o", "-", "--format", "svg"]);
    let svg = drawn(&two_drives);
    for said in [stderr(&two_drives), svg] {
        assert!(said.contains("by centres: not found"), "{said}");
    }
    // Both cranks at rest: their centres with the frame are pins, that of their couplers is not.
    let mut scene: Value = serde_json::from_str(&files::read("templates/five-bar.json")).expect("JSON");
    for link in ["1", "4"] {
        scene["links"][link]["drive"]["omega"] = json!(0);
    }
    scene["figure"] = json!({ "panels": ["centers"], "centers": ["P(1,3)"] });
    let output = with_scene(&["draw", "-o", "-", "--format", "svg", "-"], scene.to_string().as_bytes());
    let svg = drawn(&output);
    assert!(stderr(&output).contains("P_13: the links rest on one another"), "{}", stderr(&output));
    assert!(svg.contains("rest on one another"), "{svg}");
}
