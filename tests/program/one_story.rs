//! Where a scene stands at a limit, a change point or a dead centre, every command says so in the same words, and so does a motion
//! that comes there from elsewhere.

use support::program::{scratch, stderr, with_scene};

/// A four-bar with these lengths and pivots as far apart, its crank at an angle, and C near a place.
fn four_bar([a, b, c, f]: [&str; 4], angle: &str, near: [f64; 2]) -> String {
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [{f}, 0] }},
    "links": {{
      "1": {{ "points": ["A", "B"], "lengths": {{ "AB": {a} }}, "drive": {{ "angle": {angle}, "omega": 1 }} }},
      "2": {{ "points": ["B", "C"], "lengths": {{ "BC": {b} }} }},
      "3": {{ "points": ["D", "C"], "lengths": {{ "CD": {c} }} }} }},
    "near": {{ "C": {near:?} }} }}"#
    )
}

/// A slider-crank with a crank of 50, this rod, and the guide as far above the crank's pivot.
fn slider_crank(rod: &str, height: &str, angle: &str, near: [f64; 2]) -> String {
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0] }},
    "links": {{
      "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 50 }}, "drive": {{ "angle": {angle}, "omega": 1 }} }},
      "2": {{ "points": ["B", "C"], "lengths": {{ "BC": {rod} }} }}, "3": {{ "points": ["C"] }} }},
    "sliders": [{{ "link": "3", "at": "C", "on": "ground", "through": [0, {height}], "along": 0 }}],
    "near": {{ "C": {near:?} }} }}"#
    )
}

/// What a command says of a scene.
fn said(name: &str, scene: &str, command: &[&str]) -> String {
    let drawn = scratch(&format!("one-story-{name}")).join("drawn.svg");
    let drawn = drawn.to_string_lossy();
    let further: &[&str] = if command[0] == "draw" { &["-o", &drawn] } else { &[] };
    let output = with_scene(&[command, &["-"], further].concat(), scene.as_bytes());
    stderr(&output)
}

const SWEEP: [&str; 3] = ["sweep", "--want", "omega(2)"];

/// All commands that solve a scene.
const COMMANDS: [&[&str]; 4] = [&["solve"], &["steps"], &["draw"], &SWEEP];

#[test]
fn a_limit_is_told_by_every_command() {
    let bars = ["60", "50", "40", "100"];
    for (name, scene, links) in [
        // Crank and frame are the short sides of a right triangle whose long one the dyad just reaches.
        (
            "right",
            four_bar(["30", "20", "30", "40"], "90", [16.0, 18.0]),
            "limit position at angle(1) = 90°: links 2, 3",
        ),
        (
            "at",
            four_bar(bars, "62.7203872640219", [78.0, 28.0]),
            "limit position at angle(1) = 62.720387264°: links 2, 3",
        ),
        (
            "next",
            four_bar(bars, "62.7203872640218", [78.0, 28.0]),
            "limit position at angle(1) = 62.720387264°: links 2, 3",
        ),
        (
            "slider",
            // The rod stands upright on the guide.
            slider_crank("25", "0", "30", [43.3, 0.0]),
            "limit position at angle(1) = 30°: links 2, 3",
        ),
    ] {
        for command in COMMANDS {
            let said = said(name, &scene, command);
            let words = format!("{links} can go no further, their rates grow without bound");
            assert!(said.contains(&words), "{name}: {command:?}: {said}");
        }
    }
}

/// However near a scene stands to a limit, its motion goes from that one to the other.
#[test]
fn a_motion_from_next_to_a_limit_is_the_whole() {
    let bars = ["60", "50", "40", "100"];
    for angle in ["62.72038726392", "62.720387263", "62.7203", "62", "0", "-62.72038726392"] {
        let near = if angle.starts_with('-') { [78.0, -28.0] } else { [78.0, 28.0] };
        let said = said("near", &four_bar(bars, angle, near), &SWEEP);
        for sign in ["", "-"] {
            let words = format!("limit position at angle(1) = {sign}62.720387264°: links 2, 3 can go no further");
            assert!(said.contains(&words), "{angle}: {said}");
        }
        assert!(!said.contains("singular"), "{angle}: {said}");
    }
}

#[test]
fn a_change_point_is_told_by_every_command() {
    let scene = four_bar(["60", "150", "60", "150"], "0", [210.0, 0.0]);
    for command in COMMANDS {
        let said = said("change", &scene, command);
        let words = "change point at angle(1) = 0°: links 2, 3 could go on in another mode too";
        assert!(said.contains(words), "{command:?}: {said}");
    }
    let other = four_bar(["60", "150", "60", "150"], "40", [196.0, 38.6]);
    let said = said("from-elsewhere", &other, &SWEEP);
    assert!(said.contains("change point at angle(1) = 180°") && !said.contains("limit"), "{said}");
}

#[test]
fn a_dead_centre_is_told_by_every_command() {
    let commands: [&[&str]; 4] = [&["solve"], &["steps"], &["draw"], &["sweep", "--want", "omega(3)"]];
    for (name, scene, words) in [
        // A right triangle of crank and coupler in line, frame and rocker.
        (
            "rocker",
            four_bar(["15", "25", "50", "30"], "90", [0.0, 40.0]),
            "extreme position at angle(1) = 90°: link 3 stops at 126.869898° and turns back",
        ),
        // Crank and coupler in line, at an angle that is no f64.
        (
            "stretched",
            four_bar(["30", "50", "60", "100"], "36.86989764584402", [64.0, 48.0]),
            "extreme position at angle(1) = 36.8698976458°: link 3 stops at 126.869898° and turns back",
        ),
        (
            "slider",
            slider_crank("150", "0", "0", [200.0, 0.0]),
            "extreme position at angle(1) = 0°: slider 3/ground stops at 200 and slides back",
        ),
    ] {
        for command in commands {
            let rates = if name == "slider" { ["sweep", "--want", "omega(2)"] } else { SWEEP };
            let command = if command[0] == "sweep" { &rates[..] } else { command };
            let said = said(name, &scene, command);
            assert_eq!(said.matches(words).count(), 1, "{name}: {command:?}: {said}");
        }
        // Next to it nothing stops.
        let moved = scene.replace("\"angle\": 90", "\"angle\": 90.001").replace("\"angle\": 0,", "\"angle\": 0.001,");
        let moved = moved.replace("36.86989764584402", "36.8699");
        assert!(!said(name, &moved, &["solve"]).contains("extreme position"), "{name}");
    }
}

/// A four-bar that is nearly a parallelogram, with its longer side longer by a gap, can go no further next to where it would be flat;
/// with the other side longer it passes by. Which it is, and where, is the same from whichever side and however far the motion comes.
#[test]
fn a_near_parallelogram_has_one_story_in_every_range() {
    // In units of 1e-12 mm, so that sums are exact: crank and rocker 60, the long sides 150 and a gap more.
    for gap in [1_000_000_000_i64, 1_000_000, 1000, 10] {
        let longer = format!("150.{gap:012}");
        // (b − c)² − (f − a)² and (f + a)² − (b − c)² as sin² and cos² of half the limit's angle.
        let (gap, short, long) = (gap as f64 * 1e-12, 90.0, 210.0);
        let sine = gap * (2.0 * short + gap);
        let limit = 2.0 * libm::atan2(sine.sqrt(), ((long - short - gap) * (long + short + gap)).sqrt()).to_degrees();
        for [from, to] in [["0", "60"], ["-1", "60"], ["-10", "10"], ["-30", "30"], ["0", "360"]] {
            let range: &[&str] = &["sweep", "--from", from, "--to", to, "--want", "omega(2)"];
            let stops = said("stops", &four_bar(["60", &longer, "60", "150"], "100", [139.0, 59.0]), range);
            // On the other side the branches pass each other; within a 1e-10th of the lengths that cannot be followed, and is said.
            let is_singular = stops.contains("singular position") && (gap > 1e-10 || to != "360");
            assert!(!stops.contains("change point") && !is_singular, "{gap} {from} {to}: {stops}");
            let told = stops
                .split("limit position at angle(1) = ")
                .nth(1)
                .unwrap_or_else(|| panic!("{gap} {from} {to}: {stops}"));
            let told = told.split('°').next().expect("an angle");
            let (told, place): (f64, usize) =
                (told.parse().expect("a number"), told.split('.').nth(1).map_or(0, str::len));
            let unit = libm::pow(10.0, -(place as f64));
            assert!((told - limit).abs() <= unit, "{gap} {from} {to}: {told}, truly {limit}");
            let passes = said("passes", &four_bar(["60", "150", "60", &longer], "100", [139.0, 59.0]), range);
            let is_told = |what: &str| passes.contains(&format!("{what} at angle(1) = 0"));
            assert!(!["limit position", "change point"].into_iter().any(is_told), "{gap} {from} {to}: {passes}");
        }
    }
}
