//! Sheets asked for on the command line: size, way and scales in place of the scene's, work sheets, hodographs.

use support::files;
use support::program::{kinegon, scratch, stderr};

const FIGURE_2: &str = "examples/figure-2.json";

/// The SVG that a command prints.
fn svg(arguments: &[&str]) -> String {
    let scene = files::path(FIGURE_2);
    let mut all = vec![arguments[0], scene.to_str().expect("a plain path")];
    all.extend(&arguments[1..]);
    all.extend(["-o", "-"]);
    let output = kinegon().args(&all).output().expect("the program runs");
    assert!(output.status.success(), "{}", stderr(&output));
    String::from_utf8(output.stdout).expect("SVG is text")
}

#[test]
fn the_sheet_is_the_one_asked_for() {
    for (arguments, [width, height]) in [
        (vec![], ["297", "210"]),
        (vec!["--page", "a3"], ["420", "297"]),
        (vec!["--orientation", "portrait"], ["210", "297"]),
        (vec!["--page", "letter", "--orientation", "portrait"], ["215.9", "279.4"]),
    ] {
        for command in ["draw", "curves"] {
            let svg = svg(&[&[command], arguments.as_slice()].concat());
            let root = &svg[..svg.find('>').expect("the root ends")];
            assert!(root.contains(&format!(" width=\"{width}mm\"")), "{root}");
            assert!(root.contains(&format!(" height=\"{height}mm\"")), "{root}");
        }
    }
}

/// The distance of two marked circles on the sheet.
fn apart(svg: &str, ids: [&str; 2]) -> f64 {
    let place = |id: &str| {
        let start = svg.find(&format!("id=\"{id}\"")).expect("it is drawn");
        let element = svg[start..].split('>').next().expect("it ends");
        let number = |name: &str| -> f64 {
            let rest = element.split(&format!(" {name}=\"")).nth(1);
            let value = rest.and_then(|rest| rest.split('"').next());
            value.expect("a place").parse().expect("a number")
        };
        (number("cx"), number("cy"))
    };
    let ((a, b), (c, d)) = (place(ids[0]), place(ids[1]));
    libm::sqrt((a - c) * (a - c) + (b - d) * (b - d))
}

#[test]
fn scales_are_those_asked_for() {
    let svg = svg(&["draw", "--mu-l", "10", "--mu-v", "4", "--mu-a=8e0", "--worksheet"]);
    // AB is 100 mm long; the speed of s3 against b is 59.41 mm/s.
    let crank = apart(&svg, ["scheme-point-A", "scheme-point-B"]);
    assert!((crank - 10.0).abs() < 1e-3, "{crank}");
    let speed = apart(&svg, ["velocity-point-b", "velocity-point-s3"]);
    assert!((speed - 59.408 / 4.0).abs() < 2e-3, "{speed}");
    for words in ["= 10 mm/mm", "= 4 (mm/s)/mm", "= 8 (mm/s²)/mm", "id=\"ruler\""] {
        assert!(svg.contains(words), "no {words}");
    }
    let steps = kinegon()
        .args(["steps", files::path(FIGURE_2).to_str().expect("a plain path"), "--mu-v", "4"])
        .output()
        .expect("the program runs");
    let text = String::from_utf8(steps.stdout).expect("text");
    assert!(text.contains("b s3 = 59.40765 mm/s (14.85 mm on paper)"), "{text}");
}

/// A table without room beside the panels is on a second sheet of the same format; on stdout is the first alone, and a note says so.
#[test]
fn a_table_has_a_sheet_of_its_own() {
    let folder = scratch("work-sheets");
    let scene = files::path("templates/four-bar.json");
    let draw = |arguments: &[&str]| {
        let mut all = vec!["draw", scene.to_str().expect("a plain path"), "--worksheet"];
        all.extend(arguments);
        let output = kinegon().args(&all).current_dir(&folder).output().expect("the program runs");
        assert!(output.status.success(), "{}", stderr(&output));
        output
    };
    let text = |name: &str| std::fs::read_to_string(folder.join(name)).expect(name);
    draw(&["-o", "sheets/", "--format", "svg,tikz"]);
    for [first, second] in [["four-bar.svg", "four-bar-2.svg"], ["four-bar.tex", "four-bar-2.tex"]] {
        assert!(text(&format!("sheets/{first}")).contains("50 mm/s"), "{first}");
        assert!(!text(&format!("sheets/{second}")).contains("50 mm/s"), "{second}");
    }
    draw(&["-o", "own.name.svg"]);
    assert!(!text("own.name.svg").contains("measured-1-mm"));
    assert!(text("own.name-2.svg").contains("measured-1-mm"));
    let output = draw(&["-o", "-"]);
    assert!(String::from_utf8_lossy(&output.stdout).contains("id=\"ruler\""));
    assert!(stderr(&output).contains("a second sheet is not on stdout"), "{}", stderr(&output));
}

#[test]
fn wrong_paper_is_refused() {
    for (option, value, words) in [
        ("--mu-v", "0", "a scale, in units per millimetre of paper, is positive"),
        ("--mu-l", "-2", "-2; a scale, in units per millimetre of paper, is positive"),
        ("--mu-a", "NaN", "a scale, in units per millimetre of paper, is positive"),
        ("--mu-a", "1e101", "numbers are at most 1e100"),
        ("--mu-a", "inf", "numbers are at most 1e100"),
        ("--mu-l", "two", "not a number"),
        ("--page", "a5", "[possible values: a4, a4-landscape, a4-portrait, a3,"),
        ("--orientation", "upright", "[possible values: landscape, portrait]"),
    ] {
        let scene = files::path(FIGURE_2);
        let scene = scene.to_str().expect("a plain path");
        let arguments = ["draw", scene, option, value, "-o", "-"];
        let output = kinegon().args(arguments).output().expect("the program runs");
        assert_eq!(output.status.code(), Some(2), "{option} {value}");
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn hodographs_are_drawn_and_refused() {
    let svg = svg(&["curves", "--hodograph", "v(D), a(E)", "--page", "a3"]);
    for id in ["hodograph-a-own", "hodograph-b-way-0", "hodograph-a-tip-60"] {
        assert!(svg.contains(&format!("id=\"{id}\"")), "no {id}");
    }
    let scene = files::path(FIGURE_2);
    let scene = scene.to_str().expect("a plain path");
    for (arguments, words) in [
        (vec!["--hodograph", "omega(4)"], "`omega(4)` is no vector"),
        (vec!["--hodograph", "v(D)", "--want", "omega(4)"], "cannot be used with"),
    ] {
        let mut all = vec!["curves", scene, "-o", "-"];
        all.extend(arguments);
        let output = kinegon().args(&all).output().expect("the program runs");
        assert_eq!(output.status.code(), Some(2));
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
    }
}

#[test]
fn what_does_not_fit_is_told() {
    let scene = files::path(FIGURE_2);
    let scene = scene.to_str().expect("a plain path");
    let told = |arguments: &[&str]| {
        let mut all = vec!["draw", scene, "-o", "-"];
        all.extend(arguments);
        let output = kinegon().args(&all).output().expect("the program runs");
        assert!(output.status.success());
        stderr(&output)
    };
    // Figure 2 is about 715 mm high from S3 to S5: 358 mm of paper at 2 mm/mm.
    let words = told(&["--mu-l", "2"]);
    let sentence = "the scheme does not fit into its panel at mu_l = 2 and is cut off there; 5 fits";
    assert!(words.contains(sentence), "{words}");
    assert_eq!(told(&["--mu-l", "5"]), "");
    assert_eq!(told(&[]), "");
}
