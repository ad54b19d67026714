//! What is too large for a command is refused at once, with what there is too much of and how much there may be.

use support::files;
use support::program::{kinegon, scratch, stderr, with_scene};
use support::survey::Size;

/// A scene as drawn of a crank with a dyad, and further links without a point of their own: stubs on given points.
fn scene(links: usize) -> Vec<u8> {
    let stubs: String = (3..links).map(|k| format!(r#", "s{k}": ["B"]"#)).collect();
    let scene = format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }},
            "points": {{ "B": [0, 0], "C": [90, 80], "D": [150, 10] }},
            "known": {{ "B": {{ "velocity": [-120, 160] }}, "D": {{ "velocity": [60, 90] }} }},
            "links": {{ "1": ["B", "C"], "2": ["D", "C"], "3": ["D"]{stubs} }} }}"#
    );
    scene.into_bytes()
}

#[test]
fn each_command_states_its_limits() {
    for (arguments, what, most) in [
        (&["draw", "-", "-o", "-"][..], "a figure", 3_000),
        (&["draw", "-", "--layered", "-o", "-"], "a figure with steps", 150),
        (&["draw", "-", "--format", "html", "-o", "-"], "a figure with steps", 150),
        (&["steps", "-"], "a construction by hand", 1_000),
        (&["solve", "-", "--pencil"], "a construction by hand", 1_000),
        (&["solve", "-"], "a scene", 10_000),
    ] {
        let output = with_scene(arguments, &scene(most + 1));
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        let told = format!("{what} has at most {most} links, and here are {}", most + 1);
        assert!(message.contains(&told), "{arguments:?}: {message}");
        assert!(message.contains("divide the mechanism"), "{message}");
        assert!(output.stdout.is_empty());
    }
}

/// A four-bar with so many couples and a spring.
fn loaded(couples: usize) -> Vec<u8> {
    let couples: Vec<String> = (0..couples).map(|k| format!(r#"{{ "on": "3", "couple": {k} }}"#)).collect();
    let scene = String::from_utf8(many_points(0))
        .expect("it is text")
        .replace(r#""time": "s""#, r#""time": "s", "force": "N""#);
    let loads = format!(
        r#", "springs": [{{ "between": [["3", "C"], ["ground", [300, 0]]], "rate": 1, "length": 20 }}], "forces": [{}] }}"#,
        couples.join(", ")
    );
    (scene.trim_end().trim_end_matches('}').to_owned() + &loads).into_bytes()
}

#[test]
fn each_command_states_its_limit_of_loads() {
    for (arguments, what, most) in [
        (&["draw", "-", "-o", "-"][..], "a figure", 1_000),
        (&["draw", "-", "--layered", "-o", "-"], "a figure with steps", 100),
        (&["draw", "-", "--format", "html", "-o", "-"], "a figure with steps", 100),
        (&["steps", "-"], "a construction by hand", 300),
        (&["solve", "-", "--pencil"], "a construction by hand", 300),
        (&["solve", "-"], "a scene", 10_000),
    ] {
        let output = with_scene(arguments, &loaded(most));
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        let told = format!("{what} has at most {most} forces, couples and springs, and here are {}", most + 1);
        assert!(message.contains(&told), "{arguments:?}: {message}");
        assert!(message.contains("their resultant") && message.contains("forces"), "{message}");
        assert!(output.stdout.is_empty());
    }
    let output = with_scene(&["steps", "-"], &loaded(20));
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
}

/// A drawing is judged operation by operation, each by all before.
#[test]
fn a_drawing_to_be_checked_has_a_limit() {
    let folder = scratch("large-drawing");
    let drawing = folder.join("drawing.json");
    std::fs::write(&drawing, r#"{ "kinegon_drawing": 1, "did": [] }"#).expect("the test's folder can be written");
    let output = with_scene(&["check", "-", drawing.to_str().expect("a path of letters")], &scene(76));
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        message.contains("drawing.json: a drawing to be checked has at most 75 links, and here are 76"),
        "{message}"
    );
}

#[test]
fn nesting_is_limited() {
    let output = with_scene(&["solve", "-"], "[".repeat(100_000).as_bytes());
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
}

#[test]
fn a_form_has_a_limit() {
    let folder = scratch("large-form");
    let form = folder.join("form.csv");
    let lines: String = (0..90_000).map(|k| format!("x,{}\n", k % 10)).collect();
    std::fs::write(&form, lines).expect("the test's folder can be written");
    let arguments = [files::path("examples/figure-2.json"), form];
    let output = kinegon().arg("check").args(arguments).output().expect("the program runs");
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("at most 5000 values, and here are 90000"), "{message}");
}

/// A four-bar with so many further points on its coupler.
fn many_points(count: usize) -> Vec<u8> {
    let points: String = (0..count).map(|k| format!(r#", "P{k}": [{}, {}]"#, k, 5 + 37 * k % 140)).collect();
    let scene = format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [160, 0] }},
            "links": {{
                "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 60 }}, "drive": {{ "angle": 60, "omega": 10 }} }},
                "2": {{ "shape": {{ "B": [0, 0], "C": [140, 0]{points} }} }},
                "3": {{ "points": ["D", "C"], "lengths": {{ "CD": 110 }} }} }},
            "near": {{ "C": [155, 110] }} }}"#
    );
    scene.into_bytes()
}

/// Sheets of steps are as many as the points, with as many marks on each: nothing is drawn before that is wanted.
#[test]
fn very_many_sheets_are_asked_about() {
    let folder = scratch("many-sheets");
    let arguments = ["draw", "-", "--steps", "--format", "svg", "-o"];
    let run = |count: usize, further: &[&str]| {
        let place = folder.join(format!("{count}/"));
        let mut all: Vec<&str> = arguments.to_vec();
        all.push(place.to_str().expect("a path of letters"));
        all.extend(further);
        (with_scene(&all, &many_points(count)), place)
    };
    let (output, place) = run(300, &[]);
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    assert!(stderr(&output).contains("sheets with"), "{}", stderr(&output));
    assert!(stderr(&output).contains("--steps coarse"), "{}", stderr(&output));
    assert!(!place.exists());
    let (output, place) = run(300, &["--upto", "7"]);
    assert_eq!(output.status.code(), Some(2), "--steps and --upto are two things");
    assert!(!place.exists());
    // A few are drawn as ever, and told once of names without room.
    let (output, place) = run(8, &[]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(std::fs::read_dir(place).expect("a folder").count() > 40);
    assert!(stderr(&output).matches("no room").count() <= 3, "{}", stderr(&output));
}

/// What is painted in pixels takes many times as long: fewer sheets are written so, and pictures of very many pixels are asked
/// about.
#[test]
fn very_many_points_are_asked_about() {
    let all = [(7_000, "svg", true), (4_500, "png", true), (4_500, "svg", false)];
    for (count, kind, is_asked) in all.into_iter().take(if Size::is_usual("a figure of 4500 points") { 3 } else { 2 }) {
        let file = scratch("many-points").join(format!("{count}.{kind}"));
        let output = with_scene(&["draw", "-", "-o", file.to_str().expect("a name")], &many_points(count));
        let told = stderr(&output);
        assert_eq!(told.contains("with --yes it is drawn"), is_asked, "{count} {kind}: {told}");
        assert_eq!((output.status.success(), file.exists()), (!is_asked, !is_asked), "{told}");
    }
}

#[test]
fn very_many_pixels_are_asked_about() {
    let folder = scratch("many-pixels");
    let run = |arguments: &[&str]| {
        let place = folder.join("out/");
        let all = [&["draw", "-", "-o", place.to_str().expect("a path of letters")], arguments].concat();
        let output = with_scene(&all, &many_points(100));
        (output.status.code(), stderr(&output), place.exists())
    };
    let (code, told, is_there) = run(&["--steps", "--format", "png"]);
    assert!(code == Some(2) && told.contains("marks in all, as PNG, too") && !is_there, "{told}");
    let (code, told, is_there) = run(&["--format", "png", "--width", "8000"]);
    assert!(code == Some(2) && told.contains("million pixels") && told.contains("--yes") && !is_there, "{told}");
    let (code, told, _) = run(&["--format", "png", "--width", "800"]);
    assert_eq!(code, Some(0), "{told}");
}

/// Who has five thousand names wrong sees the first of them.
#[test]
fn very_many_errors_are_not_all_told() {
    let folder = scratch("many-errors");
    let form = folder.join("form.csv");
    let lines: String = (0..4_000).map(|k| format!("unknown{k},1\n")).collect();
    std::fs::write(&form, lines).expect("the test's folder can be written");
    let arguments = [files::path("examples/figure-2.json"), form];
    let output = kinegon().arg("check").args(arguments).output().expect("the program runs");
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.len() < 10_000, "{} bytes", message.len());
    assert!(message.contains("unknown0") && message.contains("more"), "{message}");
}

#[cfg(target_os = "linux")]
#[test]
fn help_that_cannot_be_written_is_no_success() {
    let full = std::fs::File::options().write(true).open("/dev/full").expect("Linux has it");
    for arguments in [&["--help"][..], &["draw", "--help"], &["--version"]] {
        let full = full.try_clone().expect("it is open");
        let output = kinegon().args(arguments).stdout(full).output().expect("the program runs");
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(stderr(&output).contains("cannot be written"), "{}", stderr(&output));
    }
}
