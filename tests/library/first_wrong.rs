//! Where the first value is off that no mistake explains: told at its step, worked out with the student's own numbers, and by stages.

use kinegon::check::{AnswerKey, Checked, Measured, Mistake, Student, check, check_result, report, report_parts};
use support::files;
use support::stages::{answer_key, solved};

/// A form of the four-bar without errors, with one value changed by a factor.
fn with_slip<T>(name: &str, factor: f64, tell: impl FnOnce(&Checked, &AnswerKey<'_>) -> T) -> T {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a starting scene is sound");
    let key = answer_key(&solution, 5);
    let mut measured = exact(&key);
    let given = measured.values.iter_mut().find(|given| given.name == name).expect("a value of the form");
    let value: f64 = given.text.parse().expect("a number");
    given.text = format!("{:.4}", factor * value);
    tell(&check(&measured, &key).expect("values that are understood"), &key)
}

fn exact(key: &AnswerKey<'_>) -> Measured {
    // A hand like others', whose errors are none here.
    Student::new(key).expect("it can be drawn").draw(&[], [0.1; 2], &mut || 0.0, &[])
}

#[test]
fn a_value_that_alone_is_off_is_told_with_what_it_is_made_of() {
    with_slip("omega(3)", 1.43, |checked, key| {
        let [finding] = checked.diagnosis.best.findings.as_slice() else { panic!("{:?}", checked.diagnosis.best) };
        assert_eq!(finding.candidate.mistake(), Mistake::Unknown);
        let written = finding.written.first().map(|&value| checked.values[value].entry.asked.name());
        assert_eq!((written, finding.follows.len()), (Some("omega(3)"), 0));
        let text = report(checked, key);
        // ω = v / L from the student's own velocity, and the link that it is the rate of.
        assert!(text.contains("With your numbers: ω_3 = d c / L_DC"), "{text}");
        assert!(text.contains("Correct this number alone; the drawing stays."), "{text}");
    });
}

#[test]
fn what_may_have_been_done_there_is_a_part_of_it() {
    with_slip("omega(3)", 1.43, |checked, _| {
        let best = &checked.diagnosis.best;
        assert!(best.probability > 0.9, "{}", best.probability);
        for other in checked.diagnosis.others.iter().filter(|other| !other.is_alike) {
            assert!(other.is_within && other.probability < best.probability, "{other:?}");
        }
    });
}

#[test]
fn a_hint_says_the_plan_then_the_value_then_the_step() {
    with_slip("omega(3)", 1.43, |checked, key| {
        let parts = report_parts(checked, key);
        let [plan, value, step] = parts.causes[0].hints.as_slice() else { panic!("{:?}", parts.causes) };
        assert!(plan.contains("velocity plan"), "{plan}");
        assert!(value.contains("ω"), "{value}");
        assert!(step.starts_with("Step "), "{step}");
        // Four stages with what was done: all of them where the scene does not say.
        assert_eq!(parts.hints, 4);
    });
}

#[test]
fn hints_that_were_opened_are_counted() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a starting scene is sound");
    let key = answer_key(&solution, 5);
    let form = r#"{ "kinegon_measured": 1, "hints": 3, "values": { "omega(2)": 1 } }"#;
    let measured = Measured::read_json(form).expect("a form");
    let checked = check(&measured, &key).expect("values that are understood");
    assert_eq!(check_result(&checked, &key, None).hints, Some(3));
    let table = Measured::read_csv("quantity,value,unit\nhints,3,\nomega(2),1,\n").expect("a table");
    assert_eq!(table.hints, 3);
}
