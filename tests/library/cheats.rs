//! Marks for nothing: forms filled in by somebody who has drawn nothing and knows only the names of the boxes. They must
//! earn what chance gives, and never pass.

use kinegon::Sheet;
use kinegon::Solution;
use kinegon::check::{
    AnswerKey, Basis, Checked, Given, MarkScheme, Marks, Measured, PlacedPoint, PointsOf, Positive, Prepared, Verdict,
    form_names, report,
};
use support::files;
use support::random::Random;
use support::stages::{answer_key, solved};
use support::survey::CHEATS;

/// How somebody fills in a form who knows nothing.
const WAYS: [&str; 9] = [
    "zeros with exponents",
    "one number everywhere",
    "numbers of any size",
    "one digit and an exponent",
    "numbers of any size at any scales",
    "zeros at any scales",
    "millimetres at any scales",
    "one value alone",
    "places of points that may be anywhere",
];

fn any_size(random: &mut Random) -> f64 {
    let size = libm::exp10(random.between(-2.0, 5.0));
    if random.below(2) == 0 { size } else { -size }
}

fn signed(number: &str, random: &mut Random) -> String {
    format!("{}{number}", ["", "-", "+"][random.below(3)])
}

fn form(way: usize, solution: &Solution, random: &mut Random) -> Measured {
    let names = form_names(&solution.construction);
    let same = format!("{:.3}", any_size(random));
    let value = |random: &mut Random| match way {
        0 | 5 => {
            let zero = format!("0e{}", random.below(9));
            signed(&zero, random)
        }
        1 => same.clone(),
        3 => {
            let number = format!("{}e{}", 1 + random.below(9), random.below(9) as i32 - 3);
            signed(&number, random)
        }
        6 => {
            let mm = format!("{:.1}", random.between(0.0, 120.0));
            signed(&mm, random)
        }
        _ => format!("{:.*}", random.below(4), any_size(random)),
    };
    let mut measured = Measured { mu: solution.scales(), ..Measured::default() };
    measured.positive = (random.below(2) == 0).then_some(Positive::CounterClockwise);
    if matches!(way, 4..=6 | 8) {
        for sheet in Sheet::ALL {
            measured.mu[sheet] = Some(libm::exp10(random.between(-3.0, 9.0)));
        }
    }
    measured.in_mm = way == 6;
    let asked = if way == 7 { vec![names[random.below(names.len())].clone()] } else { names };
    if way == 8 {
        for plan in solution.construction.plans() {
            let mut points = PointsOf::new(plan.order);
            for name in plan.points.keys().map(String::as_str).chain([plan.order.pole()]) {
                let at = [random.within(100.0), random.within(100.0)];
                points.places.insert(name.to_owned(), PlacedPoint { at, band: Some(random.between(0.0, 100.0)) });
            }
            measured.points.push(points);
        }
        return measured;
    }
    measured.values = asked
        .into_iter()
        .map(|name| Given { text: value(random), place: name.clone().into(), unit: None, name })
        .collect();
    measured
}

#[test]
fn nothing_earns_no_marks() {
    let names = ["four-bar", "slider-crank", "slotted-lever", "watt-1"].map(|name| format!("templates/{name}.json"));
    let names = names.into_iter().chain(["examples/figure-2.json".to_owned()]);
    let mut random = Random(31);
    let (mut earned, mut of) = ([0.0; WAYS.len()], [0.0; WAYS.len()]);
    for name in names {
        let solution = solved(&files::read(&name)).expect("a sound scene");
        let key: AnswerKey<'_> = answer_key(&solution, 2);
        let scheme: MarkScheme =
            Marks::read(r#"{ "kinegon_marks": 1 }"#).expect("a scheme").of(&key).expect("of this scene");
        let prepared = Prepared::new(&key);
        for number in 0..CHEATS.now() {
            let way = number % WAYS.len();
            let measured = form(way, &solution, &mut random);
            let checked = prepared.check(&measured).expect("a form that is understood");
            assert!(!checked.is_passed(), "{name}, {}: {measured:?}", WAYS[way]);
            let marks = scheme.award(&checked);
            earned[way] += marks.earned;
            of[way] += marks.of;
            let most = 0.3 * marks.of + 1.0;
            let good =
                checked.values.iter().filter(|value| value.verdict != Verdict::Off).map(|v| v.entry.asked.name());
            let good: Vec<&str> = good.collect();
            assert!(marks.earned <= most, "{name}, {}: {marks:?} {good:?} {measured:?}", WAYS[way]);
        }
    }
    for (way, name) in WAYS.iter().enumerate() {
        let share = earned[way] / of[way];
        println!("{name}: {:.2} % of the marks", 100.0 * share);
        // A band of some 15 % of a size that may be any of seven powers of ten, and a sense: one or two of a hundred; of
        // rates between 0 and 120, of which some are, more.
        assert!(share <= 0.06, "{name}: {share}");
    }
}

/// A four-bar's form whose values are right, written by `write`.
fn written(solution: &Solution, write: impl Fn(f64) -> String) -> Measured {
    let key = answer_key(solution, 2);
    let names = form_names(&solution.construction).into_iter();
    let zero = |name: String| Given { text: "0".to_owned(), place: name.clone().into(), unit: None, name };
    let mut measured = Measured { mu: solution.scales(), values: names.map(zero).collect(), ..Measured::default() };
    let entries = kinegon::check::entries(&measured, &key).expect("zeros are understood");
    for given in &mut measured.values {
        let entry = entries.iter().find(|entry| entry.asked.name() == given.name).expect("it has one");
        given.text = write(entry.expected);
    }
    measured
}

#[test]
fn digits_without_information_cannot_tell() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a sound scene");
    let key = answer_key(&solution, 2);
    let check = |measured: &Measured| kinegon::check::check(measured, &key).expect("a form that is understood");
    // The exact value rounds to 0 · 10⁴, and so would any other.
    let checked = check(&written(&solution, |_| "0e9".to_owned()));
    assert!(checked.values.iter().all(|value| value.verdict == Verdict::TooCoarse));
    assert!(!checked.is_passed() && checked.is_nothing_off());
    // Four digits are right.
    let four = |value: f64| format!("{:+.*}", (3 - libm::log10(value.abs()).floor() as i32).max(0) as usize, value);
    assert!(check(&written(&solution, four)).is_passed());
    // One significant digit accuses nobody, and two that are right pass.
    let to = |digits: i32| {
        move |value: f64| {
            let unit = libm::exp10(f64::from(libm::log10(value.abs()).floor() as i32 + 1 - digits));
            format!("{:+}", (value / unit).round() * unit)
        }
    };
    assert!(check(&written(&solution, to(1))).is_nothing_off());
    assert!(check(&written(&solution, to(2))).is_nothing_off());
}

#[test]
fn a_scale_that_no_sheet_has_allows_no_more() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a sound scene");
    // Whatever the hand is taken for.
    let key = AnswerKey { leniency: 1.0, ..answer_key(&solution, 2) };
    let mut measured = written(&solution, |value| format!("{:+}", 1.3 * value));
    let allowed = |measured: &Measured| {
        let checked = kinegon::check::check(measured, &key).expect("a form that is understood");
        let all = checked.values.iter().map(|value| value.tolerance / value.entry.expected.abs());
        (checked.scales.clone(), all.fold(0.0, f64::max))
    };
    let (told, usual) = allowed(&measured);
    assert!(told.iter().all(|scale| scale.is_sensible()), "{told:?}");
    for sheet in Sheet::ALL {
        measured.mu[sheet] = Some(1e6);
    }
    let (told, most) = allowed(&measured);
    assert_eq!(told.len(), 3);
    assert!(told.iter().all(|scale| !scale.is_sensible()));
    // The plans of the figure are some 100 mm large, the least that is judged 40 mm.
    assert!(most < 5.0 * usual, "{most} {usual}");
}

#[test]
fn where_a_scale_is_asked_for_none_allows_more_than_twice() {
    let scene = files::read("templates/four-bar.json");
    let own = solved(&scene).expect("a sound scene").scales();
    let mut scene: serde_json::Value = serde_json::from_str(&scene).expect("JSON");
    for (sheet, mu) in own.given() {
        scene["figure"][sheet.facts().scale_key] = mu.into();
    }
    let solution = solved(&scene.to_string()).expect("a sound scene");
    let key = AnswerKey { leniency: 1.0, ..answer_key(&solution, 2) };
    let mut measured = written(&solution, |value| format!("{value:+.9}"));
    let mut allowed = |times: f64| -> Vec<f64> {
        for (sheet, mu) in own.given() {
            measured.mu[sheet] = Some(times * mu);
        }
        let checked = kinegon::check::check(&measured, &key).expect("a form that is understood");
        checked.values.iter().map(|value| value.tolerance).collect()
    };
    let [usual, twice, more] = [1.0, 2.0, 1e5].map(&mut allowed);
    for (index, usual) in usual.iter().enumerate() {
        // Errors of directions do not grow with the scale.
        assert!(twice[index] > *usual && twice[index] <= 2.001 * usual, "{} {usual}", twice[index]);
        assert!((more[index] / twice[index] - 1.0).abs() < 1e-9, "{} {}", more[index], twice[index]);
    }
}

#[test]
fn what_is_not_filled_in_is_missing() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a sound scene");
    let key = answer_key(&solution, 2);
    let four = |value: f64| format!("{:+.*}", (3 - libm::log10(value.abs()).floor() as i32).max(0) as usize, value);
    let mut measured = written(&solution, four);
    let left = measured.values.split_off(5);
    let checked = kinegon::check::check(&measured, &key).expect("a form that is understood");
    assert!(checked.is_nothing_off() && !checked.is_passed());
    assert_eq!(checked.missing.len(), left.len());
    measured.exercise = Some("four-bar-7-1".into());
    let checked = kinegon::check::check(&measured, &key).expect("understood");
    assert_eq!(checked.missing.len(), left.len());
    measured.values.extend(left);
    assert!(kinegon::check::check(&measured, &key).expect("understood").is_passed());
}

/// A group that no hand constructs: two ternary links joined by a pin, each on two legs. Its rates by the loop equations, solved with 40 digits.
#[test]
fn what_no_hand_constructs_is_judged_all_the_same() {
    let solution = solved(&files::read("tests/files/two-ternary-links.json")).expect("a sound scene");
    let key = answer_key(&solution, 2);
    let check = |values: &str| {
        let form = format!(r#"{{ "kinegon_measured": 1, "positive": "counter-clockwise", "values": {{ {values} }} }}"#);
        kinegon::check::check(&Measured::read_json(&form).expect("a form"), &key).expect("understood")
    };
    let verdicts = |checked: &Checked| checked.values.iter().map(|v| v.verdict).collect::<Vec<_>>();
    let wrong = check(r#""omega(2)": 99, "omega(3)": -40, "omega(5)": 70"#);
    assert_eq!(verdicts(&wrong), [Verdict::Off; 3]);
    assert!(!wrong.is_nothing_off());
    let careful = check(r#""omega(2)": -3.744, "omega(3)": -0.318, "omega(5)": -2.4"#);
    let expected = [Verdict::Right, Verdict::Right, Verdict::WithinTolerance];
    for (value, expected) in careful.values.iter().zip(expected) {
        let is_drawn = value.basis == Basis::Drawn;
        assert!(is_drawn || value.verdict == expected, "{value:?}");
        // A twentieth, or a hundredth of the largest rate.
        assert!(is_drawn || value.tolerance <= 0.05 * 3.75 + 0.051, "{value:?}");
    }
    // A scene's form may ask for them.
    let scene = files::read("tests/files/two-ternary-links.json").replacen(
        '{',
        r#"{ "form": { "omega(2)": 2, "omega(5)": 1 },"#,
        1,
    );
    let solution = solved(&scene).expect("a sound scene");
    assert_eq!(kinegon::check::asked_names(&solution), ["omega(2)", "omega(5)"]);
    let key = answer_key(&solution, 2);
    let passes = |values: &str| {
        let form = format!(r#"{{ "kinegon_measured": 1, "positive": "counter-clockwise", "values": {{ {values} }} }}"#);
        kinegon::check::check(&Measured::read_json(&form).expect("a form"), &key).expect("understood").is_passed()
    };
    assert!(passes(r#""omega(2)": -3.744, "omega(5)": -2.37"#));
    assert!(!passes(r#""omega(2)": -3.744"#) && !passes(r#""L(A,B)": 50"#));
    // A value that is not wrong, and tells nothing, passes no more than one that is off.
    let told: String = report(&wrong, &key);
    assert!(!told.contains("All correct"), "{told}");
}

/// Radii that a student writes behind places: they leave the place untold, and allow no more than a good photograph does.
#[test]
fn large_radii_allow_nothing() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a sound scene");
    let key = answer_key(&solution, 2);
    // b is 120 mm from the pole at 150°, where 5 mm/s are 1 mm; here it is so many mm farther.
    let verdict = |beside: f64, radius: f64| {
        let [x, y] = [libm::cos(150.0_f64.to_radians()), 0.5].map(|part| part * (120.0 + beside));
        let form = format!(
            r#"{{ "kinegon_measured": 1, "mu_v": 5, "upright": true, "points": {{ "velocity": {{ "p": [0, 0], "b": [{x}, {y}, {radius}] }} }} }}"#
        );
        let checked = kinegon::check::check(&Measured::read_json(&form).expect("a form"), &key).expect("understood");
        let length = checked.values.iter().find(|v| v.entry.asked.name() == "vplan(p,b)").expect("it is there");
        (length.verdict, checked.is_passed())
    };
    assert_eq!(verdict(0.5, 10.0).0, Verdict::Right);
    assert_eq!(verdict(6.0, 10.0).0, Verdict::TooCoarse);
    assert_eq!(verdict(12.5, 10.0).0, Verdict::Off);
    assert_eq!(verdict(1.7, 1.0).0, Verdict::WithinTolerance);
    assert_eq!(verdict(6.0, 1.0).0, Verdict::Off);
    assert!(!verdict(0.0, 0.1).1);
}

/// A neighbour's values, another exercise's: some lie near the right ones, most scatter as those of no hand, and nothing is allowed for that.
#[test]
fn values_that_nothing_explains_are_no_bad_hand() {
    let file: serde_json::Value =
        serde_json::from_str(&files::read("tests/files/neighbours-values.json")).expect("JSON");
    let solution = solved(&file["scene"].to_string()).expect("a sound scene");
    let key = answer_key(&solution, 5);
    let measured = Measured::read_json(&file["form"].to_string()).expect("a form");
    let checked = kinegon::check::check(&measured, &key).expect("a form that is understood");
    assert!(4 * checked.diagnosis.unexplained.len() > checked.values.len());
    assert!(checked.accuracy.is_none(), "{:?}", checked.accuracy);
    let strict = kinegon::check::check(&measured, &AnswerKey { leniency: 1.0, ..key }).expect("understood");
    let verdicts = |checked: &kinegon::check::Checked| checked.values.iter().map(|v| v.verdict).collect::<Vec<_>>();
    assert_eq!(verdicts(&checked), verdicts(&strict));
}

/// A scene's form that asks for what is not there lets nothing pass, whatever else it asks for.
#[test]
fn what_no_step_finds_lets_nothing_pass() {
    let scene = files::read("templates/four-bar.json");
    let exact = solved(&scene).expect("a sound scene").quantity("omega(3)").expect("it turns").as_number();
    for asked in [r#""omega(9)": 1"#, r#""omega(3)": 1, "vplan(x,y)": 3"#, r#""omega(3)": 1, "v(B)": 1"#] {
        let solution =
            solved(&scene.replacen('{', &format!(r#"{{ "form": {{ {asked} }},"#), 1)).expect("a sound scene");
        let key = answer_key(&solution, 1);
        let form = format!(
            r#"{{ "kinegon_measured": 1, "positive": "counter-clockwise", "values": {{ "L(A,D)": 160, "omega(3)": {exact} }} }}"#
        );
        let checked = kinegon::check::check(&Measured::read_json(&form).expect("a form"), &key).expect("understood");
        assert!(!checked.is_passed() && checked.is_nothing_off(), "{asked}: {:?}", checked.missing);
    }
}

/// Digits widen what is allowed as far as two would, or as far as a careful hand comes: one alone is right by chance only.
#[test]
fn one_digit_allows_no_more_than_two_would() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a sound scene");
    let key = answer_key(&solution, 2);
    let to = |digits: i32| {
        move |value: f64| {
            let exponent = libm::log10(value.abs()).floor() as i32;
            let unit = libm::exp10(f64::from(exponent + 1 - digits));
            format!("{:+}e{}", (value / unit).round(), exponent + 1 - digits)
        }
    };
    let check =
        |digits| kinegon::check::check(&written(&solution, to(digits)), &key).expect("a form that is understood");
    let [one, two, three] = [1, 2, 3].map(check);
    assert!(one.is_nothing_off() && !one.is_passed(), "{:?}", one.values);
    for (value, with_two) in one.values.iter().zip(&two.values) {
        // Twice what a careful hand is off by, or that and what two digits hold.
        let drawn = with_two.tolerance - with_two.entry.rounding;
        let most = with_two.tolerance.max(2.0 * drawn);
        assert!(value.tolerance <= 1.001 * most, "{value:?}");
    }
    assert!(two.is_passed() && three.is_passed(), "{:?}", two.values);
}

/// Places of points that contradict what is written are judged, too; those that agree with it change nothing.
#[test]
fn places_that_contradict_written_values_are_judged() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a sound scene");
    let key = answer_key(&solution, 2);
    let four = |value: f64| format!("{:+.*}", (3 - libm::log10(value.abs()).floor() as i32).max(0) as usize, value);
    let check = |x: f64, y: f64| {
        let mut measured = written(&solution, four);
        measured.mu[Sheet::Velocity] = Some(5.0);
        let mut points = PointsOf::new(Sheet::Velocity);
        points.put("p", [0.0, 0.0], None);
        points.put("b", [x, y], None);
        measured.points.push(points);
        kinegon::check::check(&measured, &key).expect("a form that is understood")
    };
    // b is 120 mm from the pole.
    let right = check(-103.9, 60.0);
    assert!(right.is_passed() && right.values.iter().all(|value| value.verdict == Verdict::Right));
    let wrong = check(1.0, 1.0);
    let length = wrong.values.iter().find(|value| value.entry.asked.name() == "vplan(p,b)").expect("it is there");
    assert_eq!(length.verdict, Verdict::Off);
    assert!(!wrong.is_passed() && !report(&wrong, &key).contains("All correct"));
}
