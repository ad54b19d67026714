//! Bands of hand drawings from outside: `kinegon steps`, `kinegon solve --pencil`.

use serde_json::Value;
use support::files;
use support::program::{stderr, with_scene};

const FIGURE_2: &str = include_str!("../../examples/figure-2.json");

fn text(arguments: &[&str], scene: &str) -> String {
    let output = with_scene(arguments, scene.as_bytes());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn pencil(arguments: &[&str], scene: &str) -> Value {
    let result: Value = serde_json::from_str(&text(arguments, scene)).expect("JSON");
    result["pencil"].clone()
}

fn band(pencil: &Value, name: &str) -> f64 {
    let band = &pencil["bands"][name]["band"];
    band.as_f64().unwrap_or_else(|| panic!("no {name} in {pencil}"))
}

/// 2.1 standard deviations where so many errors of a limit come together.
fn spread(limit: f64, errors: f64) -> f64 {
    2.1 * (errors / 3.0).sqrt() * limit
}

fn near(got: f64, want: f64) {
    // The difference quotient over the whole tolerance differs from the derivative by its square.
    assert!((got / want - 1.0).abs() < 1e-3, "{got}, not {want}");
}

/// What is laid off and read at once has closed forms.
#[test]
fn bands_of_single_acts() {
    let own = pencil(&["solve", "--pencil", "-"], FIGURE_2);
    assert_eq!(own["mm"], 0.3);
    assert_eq!([&own["mu_l"], &own["mu_v"], &own["mu_a"]], [5.0, 1.0, 2.0]);
    // The velocity of B: laid off and measured. Its direction: the crank's, drawn and read, 100 mm long on paper.
    near(band(&own, "v(B).size"), spread(0.3, 2.0));
    let crank = (0.3 / 20.0_f64).to_degrees();
    let across = (0.3_f64 / 100.0).to_degrees();
    assert!(across < crank);
    // A and B across the crank, 20 mm on paper; the direction read.
    near(band(&own, "angle(1)"), 2.1 * ((2.0 * crank * crank + 0.09) / 3.0).sqrt());
    near(band(&own, "v(B).angle"), 2.1 * ((2.0 * crank * crank + 2.0 * 0.09) / 3.0).sqrt());
    // At the scale of accelerations a millimetre is twice as much.
    near(band(&own, "a(B).size"), 2.0 * spread(0.3, 2.0));
    // Given rates have none.
    assert!(own["bands"].get("omega(1)").is_none() && own.get("without").is_none());

    let fine = ["solve", "--pencil-mm", "0.1", "--pencil-degrees", "0", "-"];
    let fine = pencil(&fine, FIGURE_2);
    near(band(&fine, "v(B).size"), spread(0.1, 2.0));
    assert_eq!(fine["degrees"], 0.0);
    let none = ["solve", "--pencil-mm", "0", "--pencil-degrees", "0", "-"];
    assert_eq!(band(&pencil(&none, FIGURE_2), "omega(4)"), 0.0);
}

/// The sheet that the figure has is the one on which the hand draws: twice as large, half the band where only lengths are wrong.
#[test]
fn bands_follow_the_scales_of_the_figure() {
    let arguments = ["solve", "--pencil-degrees", "0", "-"];
    let own = pencil(&arguments, FIGURE_2);
    let figure = r#""figure": { "mu_l": 2.5, "mu_v": 0.5, "mu_a": 1,"#;
    let scene = FIGURE_2.replace(r#""figure": {"#, figure);
    assert_ne!(scene, FIGURE_2);
    let large = pencil(&arguments, &scene);
    assert_eq!(large["mu_l"], 2.5);
    for name in ["L(B,S3)", "vplan(b,s3)", "omega(4)", "alpha(4)", "a(D).size"] {
        let ratio = band(&own, name) / band(&large, name);
        assert!((ratio - 2.0).abs() < 0.05, "{name}: {ratio}");
    }
}

#[test]
fn wanted_names_have_bands_and_those_without_say_why() {
    let want = r#""want": ["omega(4)", "vplan(b,s3)/mu", "a_n(D/G)", "v(D/B)", "a_c(3/2)", "x(D)"], "figure""#;
    let scene = FIGURE_2.replace("\"figure\"", want);
    let own = pencil(&["solve", "--pencil", "-"], &scene);
    assert_eq!(own["bands"]["vplan(b,s3)/mu"]["unit"], "mm");
    for name in ["a_n(D/G).size", "a_n(D/G).angle", "v(D/B).size", "a_c(3/2).size", "x(D)"] {
        assert!(band(&own, name) > 0.0);
    }
    // Only what the sheet shows can be read from it.
    let scheme =
        FIGURE_2.replace(r#""panels": ["scheme", "velocity", "acceleration"]"#, r#""panels": ["scheme", "velocity"]"#);
    assert_ne!(scheme, FIGURE_2);
    let own = pencil(&["solve", "--pencil", "-"], &scheme);
    assert!(band(&own, "omega(4)") > 0.0);
    let why = own["without"]["alpha(4)"].as_str().expect("a reason");
    assert_eq!(why, "the figure has no acceleration plan, so no scale");
}

#[test]
fn a_special_point_at_infinity_leaves_no_construction_to_draw() {
    let cases = files::read("tests/reference/hard.jsonl");
    let case = cases.lines().find(|line| line.contains("at_infinity"));
    let scene = files::scene_text(case.expect("a case at infinity"));
    let own = pencil(&["solve", "--pencil", "-"], scene);
    let why = own["without"]["omega(2)"].as_str().expect("a reason");
    assert!(why.contains("a special point at infinity"), "{why}");
    assert!(own["bands"].get("omega(2)").is_none());
    let steps = text(&["steps", "-"], scene);
    assert!(steps.contains("A value has no ± where it depends on a group without a construction"));
}

#[test]
fn steps_carry_their_bands() {
    let steps = text(&["steps", "-"], FIGURE_2);
    for words in [
        "hand drawings (±0.3 mm, ±0.3°)",
        "p b = 100.0000 mm/s (100.00 mm on paper), direction -20.00°; ± 0.51 mm/s (0.51 mm)",
        // A relative velocity of 4 mm on paper: it may be nothing.
        "mm), only roughly",
    ] {
        assert!(steps.contains(words), "no `{words}` in\n{steps}");
    }
    for name in ["L_BS3 = ", "b s3 = ", "omega(4) = ", "a_r(3/2) = ", "n_g3 s3 = "] {
        let line = steps.lines().find(|line| line.trim_start().starts_with(name));
        assert!(line.is_some_and(|line| line.contains("; ± ")), "{name}{line:?}");
    }
    let coarse = text(&["steps", "--pencil-mm", "1", "-"], FIGURE_2);
    assert!(coarse.contains("(±1 mm, ±0.3°)") && coarse.contains("; ± 1.7 mm/s (1.71 mm)"), "{coarse}");
}

/// However bad the hand, no number leaves that is none.
#[test]
fn errors_that_take_the_construction_apart_say_so() {
    let bad = ["solve", "--pencil-mm", "10", "--pencil-degrees", "10", "-"];
    for (name, scene) in files::templates() {
        let own = pencil(&bad, &scene);
        for (quantity, entry) in own["bands"].as_object().expect("an object") {
            assert!(entry["band"].is_f64(), "{name}: {quantity}: {entry}");
        }
    }
}

#[test]
fn misuse_is_told() {
    for (arguments, words) in [
        (vec!["solve", "--pencil-mm", "-1", "-"], "not a number from 0 to 10"),
        (vec!["steps", "--pencil-mm", "nan", "-"], "not a number from 0 to 10"),
        (vec!["steps", "--pencil-degrees", "90", "-"], "not a number from 0 to 10"),
        (vec!["solve", "--digits", "--pencil", "-"], "cannot be used with"),
        (vec!["solve", "--digits", "--pencil-mm", "1", "-"], "cannot be used with"),
    ] {
        let output = with_scene(&arguments, FIGURE_2.as_bytes());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty() && stderr(&output).contains(words), "{}", stderr(&output));
    }
}
