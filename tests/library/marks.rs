//! Marks: every mistake is charged once, and what follows from it is paid for; the numbers of marks are counted by hand from that rule.

use kinegon::check::{
    AnswerKey, Awarded, DEPTH, LENIENCY, Marks, Measured, Mistake, Prepared, Student, Verdict, asked_names, check,
};
use kinegon::construction::Tolerance;
use kinegon::{Scene, Solution, solve};
use serde_json::json;
use support::survey::ALIKE;

fn key(solution: &Solution) -> AnswerKey<'_> {
    let tolerance = Tolerance::default();
    AnswerKey { solution, scales: solution.scales(), tolerance, leniency: LENIENCY, depth: 1 }
}

fn solution(text: &str) -> Solution {
    solve(&Scene::read(text).expect("a scene")).expect("it can be solved")
}

const FOUR_BAR: &str = include_str!("../../templates/four-bar.json");

/// All drawings of the four-bar with one mistake that is told: whatever it is, it costs something; one in which no written value is wrong
/// by itself, as a line, mostly costs one value.
#[test]
fn every_mistake_that_is_told_costs_something() {
    let solution = solution(FOUR_BAR);
    let (key, mut told, mut lines, mut alone) = (key(&solution), 0, 0, 0);
    let (student, prepared) = (Student::new(&key).expect("a student"), Prepared::new(&key));
    let scheme = Marks::read(r#"{ "kinegon_marks": 1 }"#).expect("a scheme").of(&key).expect("of this scene");
    for way in Mistake::all().flat_map(|mistake| student.ways(mistake)).step_by(ALIKE.now()) {
        let checked = prepared.check(&student.draw(&[&way], [0.0; 2], &mut || 0.0, &[])).expect("a form");
        let is_off =
            |step: usize| checked.values.iter().any(|value| value.verdict == Verdict::Off && value.entry.step == step);
        let [finding] = checked.diagnosis.best.findings.as_slice() else { continue };
        if !checked.diagnosis.unexplained.is_empty() || !checked.values.iter().any(|v| v.verdict == Verdict::Off) {
            continue;
        }
        let marks = scheme.award(&checked);
        told += 1;
        let lost = marks.of - marks.earned;
        assert!(lost > 0.99, "{:?} at step {} costs {lost}", way.mistake(), way.step);
        if finding.written.is_empty() && finding.candidate.mistake() == way.mistake() && !is_off(way.step) {
            lines += 1;
            // What is no larger than its tolerance does not show from what it follows.
            alone += usize::from(lost < 1.01);
        }
    }
    assert!(told * ALIKE.now() > 30 && lines * ALIKE.now() > 8, "{told} told, {lines} of them of lines");
    assert!(10 * alone >= 7 * lines, "{alone} of {lines} cost one value");
}

/// What a scene says of its form: which boxes there are, and what they are worth.
#[test]
fn a_form_asks_for_what_its_scene_says() {
    let mut scene: serde_json::Value = serde_json::from_str(FOUR_BAR).expect("JSON");
    scene["form"] = json!({ "omega(3)": 2.5, "vplan(c,b)": 1, "omega(9)": 4 });
    let solution = solution(&scene.to_string());
    // In the order of the steps, whichever way a segment is written; what no step gives has no box.
    assert_eq!(asked_names(&solution), ["vplan(b,c)", "omega(3)"]);
    let key = key(&solution);
    let of = |scheme: &str| {
        let scheme = Marks::read(scheme).expect("a scheme").of(&key).expect("of this scene");
        let student = Student::new(&key).expect("a student");
        let right = student.draw(&[], [0.0; 2], &mut || 0.0, &[]);
        scheme.award(&Prepared::new(&key).check(&right).expect("a form"))
    };
    let marks = of(r#"{ "kinegon_marks": 1 }"#);
    assert_eq!([marks.earned, marks.of], [3.5, 3.5]);
    let marks = of(r#"{ "kinegon_marks": 1, "each": 1 }"#);
    assert_eq!([marks.earned, marks.of], [2.0, 2.0]);
}

/// A mistake without a name has numbers to choose, so that some values of any form seem to follow from it: they are not paid for where as
/// many others stay open. In this form the crank's two segments are right and all else is invented.
#[test]
fn from_a_mistake_without_a_name_that_leaves_much_open_nothing_follows() {
    let file: serde_json::Value = serde_json::from_str(include_str!("../files/rest-invented.json")).expect("JSON");
    let solution = solution(&file["scene"].to_string());
    let key = AnswerKey { depth: DEPTH, ..key(&solution) };
    let checked = check(&Measured::read_json(&file["form"].to_string()).expect("a form"), &key).expect("understood");
    let [finding] = checked.diagnosis.best.findings.as_slice() else { panic!("{:?}", checked.diagnosis) };
    let [follows, open] = [finding.follows.len(), checked.diagnosis.unexplained.len()];
    assert!(finding.candidate.mistake() == Mistake::Unknown && follows > 2 && open > 2, "{follows} {open}");
    let scheme = Marks::read(r#"{ "kinegon_marks": 1 }"#).expect("a scheme").of(&key).expect("of this scene");
    let Awarded { earned, of, follow_through, .. } = scheme.award(&checked);
    assert_eq!([earned, of, follow_through], [2.0, 15.0, 0.0]);
}
