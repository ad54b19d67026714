//! What a check says of values that follow: only of those that are recomputed from others and meet what is written.

use kinegon::Solution;
use kinegon::check::{AnswerKey, Checked, Given, Measured, Mistake, Student, Verdict, check, report_parts};
use kinegon::quantity::QuantityKind;
use support::files;
use support::random::Random;
use support::stages::{answer_key, solved};
use support::survey::ALIKE;

fn scene(name: &str) -> Solution {
    solved(&files::read(&format!("templates/{name}.json"))).expect("a starting scene is sound")
}

fn told(checked: &Checked) -> Vec<Mistake> {
    checked.diagnosis.best.findings.iter().map(|finding| finding.candidate.mistake()).collect()
}

fn given(name: &str, text: String) -> Given {
    Given { name: name.to_owned(), text, unit: None, place: name.to_owned().into() }
}

fn form(key: &AnswerKey<'_>, values: Vec<Given>) -> Measured {
    Measured { mu: key.scales, values, ..Measured::default() }
}

/// Two numbers that somebody has invented: some amount at some place of the drawing leads to any two.
#[test]
fn nothing_follows_from_invented_pairs() {
    let mut random = Random(57);
    let (mut tried, mut explained) = (0, Vec::new());
    let names = ["four-bar", "slider-crank", "slotted-lever", "watt-1", "third-class", "whitworth"];
    for name in names {
        let solution = scene(name);
        let key = answer_key(&solution, 5);
        let student = Student::new(&key).expect("it can be drawn");
        let exact = student.exact(None);
        let rates: Vec<usize> = (0..exact.len())
            .filter(|&place| exact[place].is_some_and(|value| value != 0.0) && !student.is_size(place))
            .collect();
        for _ in 0..50 / ALIKE.now() {
            let mut pair = [rates[random.below(rates.len())], rates[random.below(rates.len())]];
            pair.sort_unstable();
            if pair[0] == pair[1] {
                continue;
            }
            let value = |place: usize| exact[place].unwrap_or_default();
            let invented =
                pair.map(|place| value(place) * (1.0 + libm::copysign(random.between(0.2, 3.0), random.within(1.0))));
            let values = pair
                .iter()
                .zip(invented)
                .map(|(&place, number)| given(&student.names()[place], format!("{number:+.4}")));
            let checked = check(&form(&key, values.collect()), &key).expect("values that are understood");
            tried += 1;
            let off = |value: &kinegon::check::Judged| value.verdict == Verdict::Off;
            let first = checked.values.iter().position(off);
            let said = checked.diagnosis.best.findings.first();
            let is_first = said.is_none_or(|said| said.written.first().is_none_or(|told| Some(*told) <= first));
            assert!(is_first, "{name}, {pair:?}: what is off before is passed over");
            if checked.diagnosis.best.findings.iter().any(|finding| !finding.follows.is_empty()) {
                let said: Vec<String> =
                    checked.diagnosis.best.findings.iter().map(|f| format!("{:?}", f.candidate.told)).collect();
                explained.push(format!("{name}, {pair:?} {invented:?}: {said:?}"));
            }
        }
    }
    assert!(
        tried >= 200 / ALIKE.now() && explained.is_empty(),
        "{} of {tried}:\n{}",
        explained.len(),
        explained.join("\n")
    );
}

/// Twice the right number, used in all that comes later, is one mistake: whatever it equals, nothing else was done.
#[test]
fn twice_the_right_rate_is_gone_on_with() {
    let solution = solved(
        r#"{ "kinegon": 1, "units": { "length": "m", "time": "s" }, "ground": [],
        "points": { "C": [0, 0.2], "A": [0.1732051, 0.3], "B": [0.7647, 0.2] },
        "links": { "1": { "points": ["C"], "drive": { "speed": 1 } }, "2": ["C", "A"], "3": ["A", "B"], "4": ["B"] },
        "sliders": [ { "link": "1", "at": "C", "on": "ground", "along": 0 }, { "link": "4", "at": "B", "on": "ground", "along": 0 } ],
        "gears": [{ "mesh": ["2", "ground"], "teeth": [20, "rack"], "radius": 0.2, "on": "1" }] }"#,
    )
    .expect("a sound scene");
    let key = answer_key(&solution, 5);
    // v_A/C = ω₂ CA, ω₃ = ω₂ CA cos 30° / (AB cos θ), v_B = v_C + v_A/C's part along the guide and that of ω₃, for ω₂ = 5 f.
    for factor in [1.6, 2.0] {
        let (omega, radius) = (5.0 * factor, 0.2);
        let lift = omega * 0.173_205_1;
        let omega3 = lift / 0.591_494_9;
        let along = 1.0 + omega * 0.1 + omega3 * 0.1;
        let values = [
            given("omega(2)", format!("{:+.3}", -omega)),
            given("vplan(c,a)", format!("{:.3}", omega * radius)),
            given("omega(3)", format!("{omega3:+.3}")),
            given("v_r(4/ground)", format!("{along:+.3}")),
        ];
        let checked = check(&form(&key, values.to_vec()), &key).expect("values that are understood");
        assert_eq!(told(&checked), [Mistake::Unknown], "{factor}");
        assert_eq!(checked.diagnosis.best.findings[0].follows.len(), 3, "{factor}");
    }
}

/// All values of a kind times one factor, by a hand of 0.3 mm.
#[test]
fn a_factor_common_to_one_kind_is_told_as_that() {
    let turn = core::f64::consts::TAU;
    let factors = [360.0 / turn, turn / 360.0, turn, 60.0 / turn, 60.0, 1000.0, 0.001];
    let kinds = [QuantityKind::Velocity, QuantityKind::Acceleration];
    let (mut tried, mut missed) = (0, Vec::new());
    for name in ["four-bar", "slider-crank", "slotted-lever", "watt-1", "third-class", "whitworth"] {
        let solution = scene(name);
        let key = answer_key(&solution, 5);
        let student = Student::new(&key).expect("it can be drawn");
        for (index, (factor, kind)) in factors.iter().flat_map(|factor| kinds.map(|kind| (*factor, kind))).enumerate() {
            if index % ALIKE.now() != 0 {
                continue;
            }
            for seed in 0..6 / ALIKE.now().min(3) as u64 {
                let mut random = Random(1000 * index as u64 + seed);
                let mut measured = student.draw(&[], [0.3; 2], &mut || random.within(1.0), &[]);
                let checked = check(&measured, &key).expect("values that are understood");
                for value in checked.values.iter().filter(|value| value.entry.asked.kind() == kind) {
                    let is_it = |given: &&mut Given| given.name.trim_end_matches("/mu") == value.entry.asked.name();
                    if let Some(own) = measured.values.iter_mut().find(is_it) {
                        let unit = if own.name.ends_with("/mu") { value.entry.per_mm.unwrap_or(1.0) } else { 1.0 };
                        own.name = value.entry.asked.name().to_owned();
                        let number: f64 = own.text.parse().expect("a number");
                        // With as many digits as before.
                        let digits = own.text.chars().filter(char::is_ascii_digit).count();
                        let text = format!("{:.*e}", digits.saturating_sub(1).max(1), number * unit * factor);
                        own.text = if own.text.starts_with('+') { format!("+{text}") } else { text };
                    }
                }
                let checked = check(&measured, &key).expect("values that are understood");
                tried += 1;
                // A thousandth of millimetres is metres.
                let named = [[Mistake::CommonFactor], [Mistake::OtherUnit]];
                if !named.iter().any(|named| told(&checked) == *named) {
                    missed.push(format!("{name}, {kind:?} times {factor}: {:?}", told(&checked)));
                }
            }
        }
    }
    assert!(tried > 30 && 100 * missed.len() <= 3 * tried, "{} of {tried}:\n{}", missed.len(), missed.join("\n"));
}

/// A rocker's normal part forgotten: |a_B| computed from the rocker's α and ω, as programs do, is no further mistake.
#[test]
fn a_value_computed_from_the_own_rates_makes_no_diagnosis_worse() {
    let solution = scene("four-bar");
    let key = answer_key(&solution, 5);
    let student = Student::new(&key).expect("it can be drawn");
    let place = |name: &str| student.names().iter().position(|own| own == name).expect("it is asked for");
    let length = |mechanism: &kinegon::mechanism::Mechanism, ends: [&str; 2]| {
        let [a, b] = ends.map(|name| solution.pose.point(mechanism.point(name).expect("a point")));
        (a - b).norm()
    };
    let (rocker, ends) = ("3", ["D", "C"]);
    let length = length(&solution.mechanism, ends);
    let ways = student.ways(Mistake::NormalForgotten);
    let way = ways.iter().find(|way| format!("{:?}", way.told).contains("n_dC")).expect("the rocker's normal part");
    let forgotten = student.draw(&[way], [0.0; 2], &mut || 0.0, &[]);
    let number = |name: &str| -> f64 { forgotten.values[place(name)].text.parse().expect("a number") };
    let (omega, alpha) = (number(&format!("omega({rocker})")), number(&format!("alpha({rocker})")));
    let right_names = ["omega(2)", "omega(3)", "alpha(2)", "alpha(3)"];
    let mut values: Vec<Given> =
        forgotten.values.iter().filter(|given| right_names.contains(&given.name.as_str())).cloned().collect();
    values.push(given("aplan(π,c)", format!("{:.4}", length * libm::hypot(alpha, omega * omega))));
    let checked = check(&form(&key, values.clone()), &key).expect("values that are understood");
    assert_eq!(told(&checked), [Mistake::NormalForgotten]);
    let computed =
        checked.values.iter().position(|value| value.entry.asked.name() == "aplan(π,c)").expect("it is there");
    assert!(
        checked.values[computed].verdict == Verdict::Off
            && checked.diagnosis.best.findings[0].follows.contains(&computed)
    );
    // One that is computed wrongly is told.
    values.last_mut().expect("it is there").text = format!("{:.4}", 1.3 * length * libm::hypot(alpha, omega * omega));
    let checked = check(&form(&key, values), &key).expect("values that are understood");
    assert!(told(&checked) != [Mistake::NormalForgotten] || checked.diagnosis.unexplained == [computed]);
}

/// What is worked out before a student has the student's numbers and those of the scene alone: no value of the key that nobody has written.
#[test]
fn only_numbers_that_are_there_are_worked_out() {
    let solution = scene("four-bar");
    let key = answer_key(&solution, 5);
    let worked = |values: Vec<Given>| {
        let checked = check(&form(&key, values), &key).expect("values that are understood");
        report_parts(&checked, &key).causes.into_iter().flat_map(|cause| cause.worked).collect::<Vec<String>>()
    };
    // α₃ = n_dC c / L_DC, and the segment is not written.
    assert_eq!(worked(vec![given("alpha(3)", "+118".to_owned())]), [""; 0]);
    let both = vec![given("aplan(n_dC,c)", "5647".to_owned()), given("alpha(3)", "+118".to_owned())];
    assert!(worked(both).iter().any(|told| told.contains("5647")));
}

/// The values of another exercise of the same kind: another angle and another speed of the crank. Whatever explains most of them, what the
/// numbers of the sheet give at once is another value.
#[test]
fn values_of_another_sheet_earn_nothing_by_following() {
    for name in ["four-bar", "slotted-lever", "slider-crank"] {
        let text = files::read(&format!("templates/{name}.json"));
        let solution = solved(&text).expect("a starting scene is sound");
        let key = answer_key(&solution, 5);
        let mut other: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let drive = &mut other["links"]["1"]["drive"];
        let [angle, omega] = ["angle", "omega"].map(|of| drive[of].as_f64().expect("a number"));
        (drive["angle"], drive["omega"]) = ((angle + 24.0).into(), (1.3 * omega).into());
        let other = solved(&other.to_string()).expect("it can be assembled");
        let other = answer_key(&other, 5);
        let copied = Student::new(&other).expect("it can be drawn").draw(&[], [0.0; 2], &mut || 0.0, &[]);
        let checked = check(&copied, &key).expect("values that are understood");
        let follows: usize = checked.diagnosis.best.findings.iter().map(|finding| finding.follows.len()).sum();
        assert_eq!(follows, 0, "{name}: {:?}", told(&checked));
    }
}
