//! What a check must not say: mistakes of sheets that pass, of forms that tell nothing, or that a written value refutes; and what it must
//! know of the hand.

use kinegon::Solution;
use kinegon::check::{AnswerKey, Blank, Checked, CommonError, Given, Measured, Mistake, Student, Verdict, check};
use support::files;
use support::random::Random;
use support::stages::{answer_key, solved};
use support::survey::ALIKE;

fn scene(name: &str) -> Solution {
    solved(&files::read(&format!("templates/{name}.json"))).expect("a starting scene is sound")
}

/// A drawing without mistakes by a hand of so many millimetres and degrees.
fn drawn(key: &AnswerKey<'_>, hand: f64, seed: u64) -> Measured {
    let mut random = Random(seed);
    let student = Student::new(key).expect("it can be drawn");
    student.draw(&[], [hand; 2], &mut || random.within(1.0), &[])
}

fn told(checked: &Checked) -> Vec<Mistake> {
    checked.diagnosis.best.findings.iter().map(|finding| finding.candidate.mistake()).collect()
}

#[test]
fn the_scatter_of_the_values_shows_the_hand() {
    let solution = scene("watt-1");
    let key = answer_key(&solution, 5);
    for hand in [0.15, 0.3, 0.6, 1.0] {
        // Single sheets have few values: the middle of nine.
        let mut found: Vec<f64> = (0..9)
            .map(|seed| {
                let checked = check(&drawn(&key, hand, 100 + seed), &key).expect("values that are understood");
                checked.accuracy.expect("enough values").mm
            })
            .collect();
        found.sort_by(f64::total_cmp);
        assert!((0.6..1.7).contains(&(found[4] / hand)), "{hand}: {found:?}");
    }
}

#[test]
fn a_blunt_pencil_is_no_mistake_unless_the_teacher_says_so() {
    let solution = scene("four-bar");
    let (mut failed, mut strictly_failed) = (0, 0);
    for seed in 0..12 {
        let key = answer_key(&solution, 5);
        let measured = drawn(&key, 0.9, seed);
        let checked = check(&measured, &key).expect("values that are understood");
        assert_eq!(told(&checked), [], "{seed}");
        failed += usize::from(!checked.is_passed());
        let strict = AnswerKey { leniency: 1.0, ..key };
        strictly_failed += usize::from(!check(&measured, &strict).expect("the same values").is_passed());
    }
    assert!(failed <= 1 && strictly_failed >= 3, "{failed} and {strictly_failed} of 12");
}

/// A form with all lengths in millimetres changed.
fn with_lengths(mut measured: Measured, change: impl Fn(f64) -> f64) -> Measured {
    for given in measured.values.iter_mut().filter(|given| given.name.ends_with("/mu")) {
        let mm: f64 = given.text.parse().expect("a number");
        given.text = format!("{:.1}", change(mm));
    }
    measured
}

#[test]
fn a_sheet_printed_too_large_and_a_ruler_read_from_two_are_told() {
    let (mut tried, mut seen) = (0, 0);
    for name in ["four-bar", "watt-1", "slotted-lever"] {
        let solution = scene(name);
        let key = answer_key(&solution, 2);
        for seed in 0..4 {
            tried += 4;
            let common = |measured: &Measured| {
                let checked = check(measured, &key).expect("values that are understood");
                let off = checked.values.iter().filter(|value| value.verdict == Verdict::Off);
                (checked.common, off.map(|value| format!("{value:?}")).collect::<Vec<String>>())
            };
            for factor in [1.031, 0.97] {
                let (told, off) = common(&with_lengths(drawn(&key, 0.3, seed), |mm| factor * mm));
                let Some(told) = told else { continue };
                let CommonError::Scale(scale) = told else { panic!("{name}, {seed}, {factor}: {told:?}") };
                seen += 1;
                assert!((1.0 + scale - factor).abs() < 0.01, "{name}, {seed}: {scale}");
                assert!(off.is_empty(), "{name}, {seed}: {off:#?}");
            }
            for amount in [2.0, -2.5] {
                let (told, off) = common(&with_lengths(drawn(&key, 0.2, seed), |mm| mm + amount));
                let Some(told) = told else { continue };
                let CommonError::Zero(mm) = told else { panic!("{name}, {seed}, {amount}: {told:?}") };
                seen += 1;
                assert!((mm - amount).abs() < 0.5, "{name}, {seed}: {mm}");
                assert!(off.is_empty(), "{name}, {seed}: {off:#?}");
            }
        }
    }
    // Short lengths hide it in some sheets.
    assert!(4 * seen >= 3 * tried, "{seen} of {tried}");
}

#[test]
fn a_hand_of_its_own_has_no_common_error() {
    for name in ["four-bar", "watt-1", "slotted-lever", "stephenson-3"] {
        let solution = scene(name);
        let key = answer_key(&solution, 0);
        let all = (0..60).step_by(ALIKE.now()).filter(|&seed| {
            let hand = [0.1, 0.3, 0.6, 1.0][seed % 4];
            let checked = check(&drawn(&key, hand, seed as u64), &key).expect("values that are understood");
            checked.common.is_some()
        });
        let count = all.count();
        assert!(count == 0, "{name}: {count} sheets");
    }
}

#[test]
fn a_form_with_one_number_everywhere_shows_no_mistake() {
    let solution = scene("four-bar");
    let key = answer_key(&solution, 5);
    let mut measured = drawn(&key, 0.0, 0);
    measured.values.iter_mut().for_each(|given| given.text = "1".to_owned());
    let checked = check(&measured, &key).expect("values that are understood");
    assert!(!checked.is_passed());
    assert_eq!(told(&checked), []);
}

#[test]
fn a_coriolis_part_that_is_written_was_not_forgotten() {
    let solution = scene("slotted-lever");
    let key = answer_key(&solution, 5);
    let student = Student::new(&key).expect("it can be drawn");
    let ways = student.ways(Mistake::CoriolisForgotten);
    let forgotten = student.draw(&[&ways[0]], [0.0; 2], &mut || 0.0, &[]);
    let checked = check(&forgotten, &key).expect("values that are understood");
    assert_eq!(told(&checked), [Mistake::CoriolisForgotten]);
    // The same sheet, but for the right Coriolis part on it.
    let right = drawn(&key, 0.0, 0);
    let is_part = |given: &Given| given.name.starts_with("aplan(b,");
    let place = right.values.iter().position(is_part).expect("it is asked for");
    let mut contradicting = forgotten;
    contradicting.values[place] = right.values[place].clone();
    let checked = check(&contradicting, &key).expect("values that are understood");
    assert!(!told(&checked).contains(&Mistake::CoriolisForgotten), "{:?}", told(&checked));
    assert!(checked.values.iter().any(|value| value.verdict == Verdict::Off));
}

#[test]
fn a_slip_at_any_vector_is_found_and_followed() {
    let solution = scene("four-bar");
    let key = answer_key(&solution, 5);
    let student = Student::new(&key).expect("it can be drawn");
    let mut found = 0;
    let ways = student.ways(Mistake::Diameter);
    let ways = ways.iter().filter(|way| way.step > 2);
    for way in ways {
        // Twice a normal part is the diameter; 1.37 times it is nothing that anybody knows.
        let double = student.draw(&[way], [0.0; 2], &mut || 0.0, &[]);
        assert!(check(&double, &key).is_ok_and(|checked| told(&checked) == [Mistake::Diameter]));
        found += 1;
    }
    assert!(found > 0);
    let right = drawn(&key, 0.0, 0);
    let place = right.values.iter().position(|given| given.name == "omega(2)").expect("it is asked for");
    let number: f64 = right.values[place].text.parse().expect("a number");
    let wrong = student.draw(&[], [0.0; 2], &mut || 0.0, &[(place, 1.37 * number)]);
    let mut measured = wrong;
    measured.values[place].text = format!("{:+.4}", 1.37 * number);
    let checked = check(&measured, &key).expect("values that are understood");
    assert_eq!(told(&checked), [Mistake::Unknown]);
    let finding = &checked.diagnosis.best.findings[0];
    assert_eq!(finding.candidate.told.blanks, [("quantity", Blank::Quantity("omega(2)".to_owned()))]);
    // The coupler's normal part, the point c and both angular accelerations follow.
    assert!(finding.follows.len() >= 5, "{:?}", finding.follows);
    assert!(checked.diagnosis.unexplained.is_empty());
}

#[test]
fn a_point_put_elsewhere_is_not_taken_for_a_bad_hand() {
    // An independent hand (`tests/students/second.py`) has put c of a Watt linkage 10 mm from where its rays cross and gone on from there: all
    // later values are off, as a blunt pencil's would be.
    let file: serde_json::Value = serde_json::from_str(&files::read("tests/files/point-elsewhere.json")).expect("JSON");
    let solution = solved(&file["scene"].to_string()).expect("a sound scene");
    let key = answer_key(&solution, 5);
    let measured = Measured::read_json(&file["form"].to_string()).expect("a form");
    let checked = check(&measured, &key).expect("values that are understood");
    assert!(!checked.is_passed());
    let [finding] = checked.diagnosis.best.findings.as_slice() else { panic!("{:?}", told(&checked)) };
    assert_eq!(finding.candidate.mistake(), Mistake::Unknown);
    // The rays to c are steps 3 and 4, and c is marked in step 5.
    assert!((3..=5).contains(&finding.candidate.step), "{}", finding.candidate.step);
}

/// A sheet with one rate whose sense is wrong and whose size passes: that is what is told, whether the other values are there or not, and however
/// exactly they are drawn.
#[test]
fn what_passes_with_the_other_sign_has_the_wrong_sense() {
    let is_rate = |name: &str| ["omega(", "alpha(", "v_r(", "a_r("].iter().any(|head| name.starts_with(head));
    let (mut tried, mut missed) = (0, Vec::new());
    for name in ["four-bar", "slider-crank", "slotted-lever", "watt-1", "third-class"] {
        let solution = scene(name);
        let key = answer_key(&solution, 5);
        for all in [true, false] {
            let mut right = drawn(&key, 0.0, 0);
            right.values.retain(|given| all || is_rate(&given.name));
            let checked = check(&right, &key).expect("values that are understood");
            for value in checked.values.iter().filter(|value| is_rate(&value.entry.row)) {
                for share in [-0.95, -0.4, 0.4, 0.95] {
                    let (expected, tolerance) = (value.entry.expected, value.tolerance);
                    let written = -(expected + share * tolerance);
                    let mut wrong = right.clone();
                    let given = wrong.values.iter_mut().find(|given| given.name == value.entry.row);
                    given.expect("it is there").text = format!("{written:+.6}");
                    let checked = check(&wrong, &key).expect("values that are understood");
                    let is_off = |own: &&kinegon::check::Judged| own.verdict == Verdict::Off;
                    if checked.values.iter().filter(is_off).count() == 1 {
                        tried += 1;
                        if told(&checked) != [Mistake::WrongSense] {
                            missed.push(format!("{name} {} {share} {all}: {:?}", value.entry.row, told(&checked)));
                        }
                    }
                }
            }
        }
    }
    assert!(tried > 100 && 100 * missed.len() <= 3 * tried, "{} of {tried}:\n{}", missed.len(), missed.join("\n"));
}

/// A sheet that was drawn, or computed, with the crank at any other angle: one angle explains all of it. An angle taken in radians is told as that.
#[test]
fn one_wrong_angle_of_the_crank_explains_a_whole_sheet() {
    let (mut tried, mut missed) = (0, Vec::new());
    for name in ["four-bar", "slider-crank", "whitworth"] {
        let text = files::read(&format!("templates/{name}.json"));
        let right: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let own = scene(name);
        let key = answer_key(&own, 5);
        let link = own
            .scene
            .links
            .iter()
            .find(|(_, link)| link.drive.is_some())
            .map(|(name, _)| name.clone())
            .expect("a drive");
        let angle = right["links"][&link]["drive"]["angle"].as_f64().expect("an angle");
        let others = [23.0, 41.0, 67.0, 143.0, 165.0, 222.0].into_iter().map(|by| angle + by);
        for (wrong, is_in_radians) in others.map(|wrong| (wrong, false)).chain([(angle.to_degrees() % 360.0, true)]) {
            let mut scene = right.clone();
            scene["links"][&link]["drive"]["angle"] = wrong.into();
            scene["near"] = serde_json::json!({});
            let poses = [1, 2].into_iter().filter_map(|mode| {
                let read = kinegon::Scene::read(&scene.to_string()).ok()?;
                let (mechanism, pose) = kinegon::posed(&read, kinegon::scene::SizeLimit::NUMBERS, Some(mode)).ok()?;
                Solution::new(read, mechanism, pose, kinegon::Order::Acceleration).ok()
            });
            // The assembly that somebody draws who goes by the picture of the right one.
            let near = |other: &Solution| {
                let places = own.pose.points.iter().zip(&other.pose.points);
                places.map(|(a, b)| (a - b).norm_squared()).sum::<f64>()
            };
            let Some(drawn_so) = poses.min_by(|a, b| near(a).total_cmp(&near(b))) else { continue };
            for seed in 0..2 {
                let measured = drawn(&answer_key(&drawn_so, 5), 0.1, seed);
                let checked = check(&measured, &key).expect("values that are understood");
                tried += 1;
                let best = checked.diagnosis.best.findings.first();
                let said = best.map(|finding| format!("{:?}", finding.candidate.told)).unwrap_or_default();
                let is_so = said.to_lowercase().contains("radians") || !is_in_radians;
                if told(&checked) != [Mistake::CrankAngle] || !is_so {
                    missed.push(format!("{name} at {wrong}°: {:?}", told(&checked)));
                }
            }
        }
    }
    assert!(tried > 30 && 100 * missed.len() <= 5 * tried, "{} of {tried}:\n{}", missed.len(), missed.join("\n"));
}
