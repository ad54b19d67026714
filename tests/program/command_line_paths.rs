//! Paths of points asked for on the command line: in every format, in the scheme and as charts, and what is refused.

use support::files;
use support::program::{kinegon, scratch, stderr, with_scene};

const LEG: &str = "tests/lecture/jansen.json";

fn run(arguments: &[&str]) -> std::process::Output {
    kinegon().args(arguments).current_dir(files::path(".")).output().expect("the program runs")
}

fn svg(arguments: &[&str]) -> String {
    let output = run(&[arguments, &["-o", "-", "--format", "svg"]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    String::from_utf8(output.stdout).expect("SVG is text")
}

#[test]
fn an_option_that_names_nothing_is_refused() {
    for arguments in [["draw", LEG, "--trace", ","], ["curves", LEG, "--path", ""], ["curves", LEG, "--hodograph", " "]]
    {
        let output = run(&[&arguments[..], &["-o", "-"]].concat());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&output).contains(&format!("{} names nothing", arguments[2])), "{}", stderr(&output));
    }
}

#[test]
fn options_and_keys_of_the_scene_draw_the_same() {
    let by_option = svg(&["draw", LEG, "--trace", "F, E", "--ghosts", "6"]);
    for id in ["scheme-path-F", "scheme-path-E", "scheme-tick-F-12", "scheme-ghost-5-link-7"] {
        assert!(by_option.contains(&format!("id=\"{id}\"")), "{id}");
    }
    assert!(by_option.contains("every 30° of drive 1, that is every 0.0873 s"));
    let mut scene: serde_json::Value = serde_json::from_str(&files::read(LEG)).expect("JSON");
    scene["figure"] = serde_json::json!({ "trace": ["F", "E"], "ghosts": 6 });
    let output = with_scene(&["draw", "-o", "-", "--format", "svg", "-"], scene.to_string().as_bytes());
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(String::from_utf8_lossy(&output.stdout), by_option);
    // The option takes the place of the scene's points.
    let output = with_scene(&["draw", "-o", "-", "--trace", "F", "-"], scene.to_string().as_bytes());
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(text.contains("scheme-path-F") && !text.contains("scheme-path-E"));
    assert!(!svg(&["draw", LEG]).contains("scheme-path"));
}

#[test]
fn every_format_has_the_path() {
    let folder = scratch("paths");
    let out = format!("{}/", folder.display());
    let output = run(&["draw", LEG, "--trace", "F", "--ghosts", "4", "--format", "svg,pdf,tikz,png,html", "-o", &out]);
    assert!(output.status.success(), "{}", stderr(&output));
    for ending in ["svg", "pdf", "tex", "png", "html"] {
        assert!(folder.join(format!("jansen.{ending}")).is_file(), "{ending}");
    }
    let tikz = std::fs::read_to_string(folder.join("jansen.tex")).expect("TikZ");
    assert!(tikz.contains("kinegon/trace") || tikz.contains("kinegonstyle{trace"), "no style of the path");
    let steps = run(&["draw", LEG, "--trace", "F", "--upto", "1", "-o", "-"]);
    assert!(String::from_utf8_lossy(&steps.stdout).contains("scheme-path-F"));
}

#[test]
fn a_chart_of_paths_says_what_it_shows() {
    let chart = svg(&["curves", LEG, "--path", "F, E"]);
    assert!(chart.contains("Path of F in mm; Path of E in mm."));
    let watt = "tests/lecture/watt.json";
    let chart = svg(&["curves", watt, "--path", "M", "--language", "es"]);
    assert!(chart.contains("Trayectoria de M en mm."));
    let whole = svg(&["curves", watt, "--path", "M", "--language", "es", "--beyond-limits"]);
    assert!(whole.contains("path-a-beyond-0") && !chart.contains("path-a-beyond"));
}

#[test]
fn paths_end_at_limits_unless_they_are_to_go_on() {
    let watt = ["draw", "tests/lecture/watt.json", "--trace", "M", "-o", "-"];
    let output = run(&watt);
    assert!(output.status.success() && stderr(&output).contains("--beyond-limits"), "{}", stderr(&output));
    assert!(!String::from_utf8_lossy(&output.stdout).contains("scheme-beyond-M"));
    let output = run(&[&watt[..], &["--beyond-limits"]].concat());
    assert!(stderr(&output).is_empty(), "{}", stderr(&output));
    assert!(String::from_utf8_lossy(&output.stdout).contains("scheme-beyond-M"));
}

#[test]
fn what_has_no_path_is_refused() {
    for (arguments, words) in [
        (vec!["draw", LEG, "--trace", "Q"], "--trace: there is no point Q"),
        (vec!["draw", LEG, "--trace", "F,Z"], "--trace: point Z is on the ground"),
        (vec!["draw", LEG, "--trace", "S7"], "--trace: S7 is a name of the construction"),
        (vec!["draw", LEG, "--ghosts", "1"], "--ghosts: the number of ghosts is from 2 to 72, not 1"),
        (vec!["draw", "examples/figure-1.json", "--trace", "B"], "--trace: a drawn configuration cannot be moved"),
        (vec!["draw", "examples/figure-1.json", "--ghosts", "6"], "--ghosts: a drawn configuration cannot be moved"),
        (vec!["curves", LEG, "--path", "O"], "--path: point O is on the ground"),
        (vec!["curves", LEG, "--path", "F", "--want", "omega(2)"], "cannot be used with"),
    ] {
        let output = run(&[arguments.as_slice(), &["-o", "-"]].concat());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
        assert!(stderr(&output).contains(words), "{arguments:?}: {}", stderr(&output));
    }
}
