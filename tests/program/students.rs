//! The judge of `tests/students` over some of its cases.

use support::files;
use support::tools::{find, run};

/// Python 3.11 or newer writes nothing beside its programs with this.
const QUIET: &str = "-B";

#[test]
#[ignore = "needs Python"]
fn another_hand_agrees_with_the_keys() {
    let python = find("python3");
    let hand = files::path("tests/students/hand.py");
    let said = run(
        &python,
        [QUIET.as_ref(), hand.as_os_str(), "--self-test".as_ref(), env!("CARGO_BIN_EXE_kinegon").as_ref()],
    );
    let said = String::from_utf8(said).expect("text");
    assert_eq!(said.lines().count(), 10, "{said}");
    assert!(!said.contains("DISAGREES"), "{said}");
}

#[test]
#[ignore = "needs Python"]
fn mistakes_with_instant_centres_are_named_and_honest_hands_are_not_accused() {
    let python = find("python3");
    let judge = files::path("tests/students/centers.py");
    let words = ["--scenes", "6", "--honest", "18", "--each", "6", "--limits"];
    let program = [QUIET.as_ref(), judge.as_os_str(), env!("CARGO_BIN_EXE_kinegon").as_ref()];
    let said = run(&python, program.into_iter().chain(words.map(AsRef::as_ref)));
    let said = String::from_utf8(said).expect("text");
    assert!(said.contains("honest accused 0.00 %"), "{said}");
}

#[test]
#[ignore = "needs Python"]
fn mistakes_with_wheels_are_named_and_honest_hands_are_not_accused() {
    let python = find("python3");
    let judge = files::path("tests/students/gears.py");
    let words = ["--scenes", "7", "--honest", "21", "--each", "7", "--limits"];
    let program = [QUIET.as_ref(), judge.as_os_str(), env!("CARGO_BIN_EXE_kinegon").as_ref()];
    let said = run(&python, program.into_iter().chain(words.map(AsRef::as_ref)));
    let said = String::from_utf8(said).expect("text");
    assert!(said.contains("honest accused 0.00 %"), "{said}");
}

#[test]
#[ignore = "needs Python"]
fn mistakes_with_teeth_cams_and_friction_are_named_and_honest_hands_are_not_accused() {
    let python = find("python3");
    for judge in ["teeth.py", "cams.py", "friction.py"] {
        let judge = files::path(&format!("tests/students/{judge}"));
        // Four ways to come to a friction.
        let words = ["--scenes", "5", "--honest", "20", "--each", "5", "--limits"];
        let program = [QUIET.as_ref(), judge.as_os_str(), env!("CARGO_BIN_EXE_kinegon").as_ref()];
        let said = run(&python, program.into_iter().chain(words.map(AsRef::as_ref)));
        let said = String::from_utf8(said).expect("text");
        assert!(said.contains("honest accused 0.00 %"), "{said}");
    }
}

/// Mistakes of which a right explanation once fitted badly: an angular velocity that was measured did not come into an acceleration, one radius was taken from paper, and
/// lines that cross under small angles were compared to first order.
#[test]
#[ignore = "needs Python"]
fn mistakes_whose_values_are_far_off_are_named() {
    let python = find("python3");
    for (judge, mistake, scenes, each, seed, least) in [
        ("gears.py", "accelerations-equal-at-P", "84", "168", "31", 90.0),
        ("cams.py", "face-along-wrong-line", "80", "160", "7", 80.0),
        ("teeth.py", "diameter-for-radius", "8", "24", "31", 95.0),
    ] {
        let judge = files::path(&format!("tests/students/{judge}"));
        let words = ["--mistake", mistake, "--scenes", scenes, "--honest", "1", "--each", each, "--seed", seed];
        let program = [QUIET.as_ref(), judge.as_os_str(), env!("CARGO_BIN_EXE_kinegon").as_ref()];
        let said = run(&python, program.into_iter().chain(words.map(AsRef::as_ref)));
        let said = String::from_utf8(said).expect("text");
        let named = said.split("all ").last().and_then(|all| all.split_once("named ")?.1.split_once(" %"));
        let named: f64 = named.and_then(|(share, _)| share.parse().ok()).unwrap_or_default();
        assert!(named >= least, "{said}");
    }
}

#[test]
#[ignore = "needs Python"]
fn mistakes_with_forces_are_named_and_honest_hands_are_not_accused() {
    let python = find("python3");
    let judge = files::path("tests/students/forces.py");
    let words = ["--scenes", "5", "--honest", "15", "--each", "5", "--limits"];
    let program = [QUIET.as_ref(), judge.as_os_str(), env!("CARGO_BIN_EXE_kinegon").as_ref()];
    let said = run(&python, program.into_iter().chain(words.map(AsRef::as_ref)));
    let said = String::from_utf8(said).expect("text");
    assert!(said.contains("honest accused 0.00 %"), "{said}");
}

#[test]
#[ignore = "needs Python"]
fn classical_mistakes_on_exact_sheets_are_named() {
    let python = find("python3");
    let judge = files::path("tests/students/judge.py");
    let words = [
        "--only",
        "normal part left out",
        "--hand",
        "exact",
        "--seeds",
        "1",
        "--limit-wrong",
        "0",
        "--least-named",
        "100",
    ];
    let program = [QUIET.as_ref(), judge.as_os_str(), env!("CARGO_BIN_EXE_kinegon").as_ref()];
    let said = run(&python, program.into_iter().chain(words.map(AsRef::as_ref)));
    let said = String::from_utf8(said).expect("text");
    assert!(said.contains("named 100"), "{said}");
}
