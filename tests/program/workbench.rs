//! The workbench as the program writes and opens it: `kinegon app`, and pages of `kinegon draw` with a scene inside.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::Output;
use support::outputs;
use support::program::{kinegon, scratch, stderr, with_scene};

const BUILT: &str = include_str!("../../templates/workbench.html");
const FIGURE_2: &str = "examples/figure-2.json";

fn run(arguments: &[&str]) -> Output {
    kinegon().args(arguments).output().expect("it runs")
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).expect("it was written")
}

/// The scene in a page of `kinegon draw`, and the step that it shows first.
fn opened(scene: &str, options: &[&str]) -> (String, serde_json::Value) {
    let output = run(&[&["draw", scene, "--format", "html", "-o", "-"], options].concat());
    assert!(output.status.success(), "{options:?}: {}", stderr(&output));
    let page = String::from_utf8(output.stdout).expect("UTF-8");
    let text = outputs::workbench(&page);
    let (_, data) = page.split_once("id=\"kinegon-scene\">").expect("a scene");
    let data = data.split("</script>").next().expect("its end");
    (text, serde_json::from_str::<serde_json::Value>(data).expect("JSON")["step"].clone())
}

#[test]
fn it_is_written_where_it_is_wanted() {
    let folder = scratch("app-written");
    let deep = format!("{}/course/", folder.display());
    for (output, file) in [(folder.join("a.html"), "a.html"), (PathBuf::from(deep), "course/kinegon.html")] {
        let done = kinegon().args(["app", "-o"]).arg(output).output().expect("it runs");
        assert_eq!(stderr(&done), "");
        assert_eq!(text(&folder.join(file)), BUILT);
    }
    let printed = run(&["app", "-o", "-"]);
    assert!(printed.stdout == BUILT.as_bytes());
    // With a scene, to the letter.
    let page = run(&["app", FIGURE_2, "-o", "-"]);
    let page = String::from_utf8(page.stdout).expect("UTF-8");
    assert_eq!(outputs::workbench(&page), text(Path::new(FIGURE_2)));
    assert!(page.contains("\",\"step\":null}"));
}

#[test]
fn what_is_no_scene_is_refused() {
    let folder = scratch("app-refused");
    let file = folder.join("kinegon.html");
    let named = file.to_str().expect("UTF-8");
    let output = with_scene(&["app", "-", "-o", named], b"{ \"kinegon\": 1 }");
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    assert!(stderr(&output).contains("units") && !file.exists());
    // What cannot be assembled is a scene all the same: the workbench is where to mend it.
    let apart = text(Path::new("templates/four-bar.json")).replace("140", "10");
    let output = with_scene(&["app", "-", "-o", named], apart.as_bytes());
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(outputs::workbench(&text(&file)), apart);
    let own = folder.join("scene.json");
    fs::write(&own, &apart).expect("written");
    let own = own.to_str().expect("UTF-8");
    let output = run(&["app", own, "-o", own]);
    assert!(stderr(&output).contains("is not overwritten"), "{}", stderr(&output));
    // A scene that is not named as the one to open must not become a page either.
    let output = run(&["app", "-o", own]);
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    assert!(stderr(&output).contains(".html") && text(Path::new(own)) == apart, "{}", stderr(&output));
}

/// `kinegon app` on a machine with these variables, and with a program that opens files if `opens`.
fn on_a_machine(folder: &Path, opens: bool, variables: &[(&str, &str)]) -> Output {
    let [home, bin] = ["home", "bin"].map(|name| folder.join(name));
    for made in [&home, &bin] {
        fs::create_dir_all(made).expect("made");
    }
    if opens {
        let opener = bin.join("xdg-open");
        fs::write(&opener, "#!/bin/sh\necho \"$1\" > \"$HOME/opened\"\n").expect("written");
        fs::set_permissions(&opener, fs::Permissions::from_mode(0o755)).expect("ours");
    }
    let mut command = kinegon();
    command.arg("app").env_clear().env("HOME", home).env("PATH", bin);
    command.envs(variables.iter().copied()).output().expect("it runs")
}

#[test]
#[cfg(not(target_os = "macos"))] // which has a program of its own that opens files
fn it_is_opened_in_the_browser() {
    let folder = scratch("app-opened");
    let output = on_a_machine(&folder, true, &[("DISPLAY", ":0")]);
    assert!(output.status.success(), "{}", stderr(&output));
    let file = folder.join("home/.cache/kinegon/kinegon.html");
    assert_eq!(text(&file), BUILT);
    assert_eq!(text(&folder.join("home/opened")).trim(), file.to_str().expect("UTF-8"));
    assert!(stderr(&output).contains("the workbench is open in the browser"), "{}", stderr(&output));
}

#[test]
#[cfg(not(target_os = "macos"))]
fn a_machine_without_a_browser_is_told_where_it_is() {
    for (name, opens, variables) in [("screen", true, &[][..]), ("browser", false, &[("WAYLAND_DISPLAY", "0")])] {
        let folder = scratch(&format!("app-without-{name}"));
        let output = on_a_machine(&folder, opens, variables);
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{message}");
        let file = folder.join("home/.cache/kinegon/kinegon.html");
        assert_eq!(text(&file), BUILT);
        assert!(message.contains(file.to_str().expect("UTF-8")) && message.contains("open that file"), "{message}");
        assert_eq!(message.matches("error:").count(), 1, "{message}");
    }
}

#[test]
fn a_page_has_what_the_command_line_asks_for_in_its_scene() {
    let folder = scratch("app-options");
    for options in [
        &[][..],
        &["--style", "board", "--language", "es", "--decimal", "comma", "--notation", "german"],
        &["--mu-l", "5", "--mu-v", "0.25", "--mu-a", "0.5", "--scales", "cycle"],
        &["--values=m", "--page", "a3", "--orientation", "portrait", "--worksheet"],
        &["--trace", "D, F", "--ghosts", "6", "--beyond-limits", "--focus", "velocity"],
        &["--mode", "2"],
    ] {
        let (scene, step) = opened(FIGURE_2, options);
        assert_eq!(step, 1);
        let as_drawn = run(&[&["draw", FIGURE_2, "-o", "-"], options].concat());
        assert!(as_drawn.status.success(), "{options:?}: {}", stderr(&as_drawn));
        fs::write(folder.join("scene.json"), &scene).expect("written");
        let as_opened = with_scene(&["draw", "-", "-o", "-"], scene.as_bytes());
        assert!(as_drawn.stdout == as_opened.stdout, "{options:?}: another figure for\n{scene}");
        if options.is_empty() {
            assert_eq!(scene, text(Path::new(FIGURE_2)));
        }
    }
}

#[test]
fn a_page_shows_the_steps() {
    assert_eq!(opened(FIGURE_2, &["--upto", "7"]), (text(Path::new(FIGURE_2)), 7.into()));
    let at_three = text(Path::new("templates/four-bar.json")).replacen("\"panels\"", "\"step\": 3, \"panels\"", 1);
    let folder = scratch("app-steps");
    let file = folder.join("scene.json");
    fs::write(&file, &at_three).expect("written");
    assert_eq!(opened(file.to_str().expect("UTF-8"), &[]), (at_three, 3.into()));
}

#[test]
fn what_a_page_cannot_have_is_said() {
    let folder = scratch("page-refused");
    let style = "templates/styles/board.json";
    for (options, words) in [
        (&["--steps"][..], "leave out --steps"),
        (&["--style", style], "the styles that a scene can name"),
        (&["--upto", "99"], "no step 99"),
        (&["--layered"], "only SVG has layers"),
    ] {
        let mut command = kinegon();
        command.args(["draw", FIGURE_2, "--format", "html", "-o"]).arg(&folder);
        let output = command.args(options).output().expect("it runs");
        assert_eq!(output.status.code(), Some(2), "{options:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(words), "{options:?}: {}", stderr(&output));
    }
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 0, "a refused command wrote a file");
    // What asked for a film once is understood, and told to do nothing.
    let output = run(&["draw", FIGURE_2, "--format", "html", "-o", "-", "--positions", "72", "--drive", "1"]);
    assert!(output.status.success());
    assert!(stderr(&output).contains("--positions does nothing") && stderr(&output).contains("--drive does nothing"));
}
