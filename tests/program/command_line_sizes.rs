//! What is too large for a command is refused at once, with what there is too much of and how much there may be.

use support::files;
use support::program::{kinegon, scratch, stderr, with_scene};

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
