//! Strategies of somebody who hands in an exercise and knows nothing, or next to nothing: none passes, in a form or in a drawing. Whoever has drawn
//! and computed carefully passes everywhere.

use kinegon::Solution;
use kinegon::board::{Given as BoardGiven, HandDrawing, Judge, own_drawing};
use kinegon::check::{
    AnswerKey, Checked, Given, MarkScheme, Marks, Measured, PointsOf, Positive, Prepared, asked_names, entries,
};
use kinegon::exercise::Exercises;
use serde_json::{Value, json};
use support::files;
use support::random::Random;
use support::stages::{answer_key, solved};
use support::students::hand::SKILLS;
use support::students::task::Task;
use support::survey::{HANDED_IN, KINDS as EVERY_KIND};

const KINDS: [&str; 7] =
    ["four-bar", "slider-crank", "slotted-lever", "whitworth", "watt-1", "stephenson-3", "toggle-press"];

/// What somebody hands in.
enum Handed {
    Form(Measured),
    Drawing(Value),
}

/// An exercise with its right values, by the names of its form.
struct Subject {
    text: String,
    solution: Solution,
    right: Vec<(String, f64)>,
    /// The same by the names of its key.
    key: Vec<(String, f64)>,
}

impl Subject {
    fn form(&self, values: impl IntoIterator<Item = (String, String)>) -> Measured {
        let given = |(name, text): (String, String)| Given { text, unit: None, place: name.clone().into(), name };
        Measured {
            mu: self.solution.scales(),
            positive: Some(Positive::CounterClockwise),
            values: values.into_iter().map(given).collect(),
            ..Measured::default()
        }
    }

    fn key(&self) -> AnswerKey<'_> {
        answer_key(&self.solution, 3)
    }

    /// A drawing of these operations.
    fn drawing(&self, did: &[Value]) -> Handed {
        let mut drawing: Value = serde_json::from_str(&self.own_text()).expect("JSON");
        drawing["did"] = json!(did);
        Handed::Drawing(drawing)
    }

    fn own_text(&self) -> String {
        own_drawing(&BoardGiven::new(&self.solution), &self.solution.scales())
    }

    /// Kinegon's own construction.
    fn own(&self) -> Vec<Value> {
        let own: Value = serde_json::from_str(&self.own_text()).expect("JSON");
        own["did"].as_array().expect("a list").clone()
    }
}

/// Four digits, with a sign.
fn four(value: f64) -> String {
    let decimals = 3 - libm::floor(libm::log10(value.abs().max(1e-9))) as i32;
    format!("{value:+.*}", decimals.clamp(0, 9) as usize)
}

fn is_rate(name: &str) -> bool {
    ["omega(", "alpha(", "v_r(", "a_r("].iter().any(|head| name.starts_with(head))
}

fn subjects(kind: &str) -> Vec<Subject> {
    let base = solved(&files::read(&format!("templates/{kind}.json"))).expect("a good scene");
    let mut exercises = Exercises::new(&base, None, 5).expect("it can vary");
    let of = |found: kinegon::exercise::Exercise| {
        let solution = solved(&found.text).expect("a good scene");
        let key = found.key().values.iter().map(|(name, value)| (name.clone(), value.value)).collect();
        let zeros = asked_names(&solution).into_iter().map(|name| (name, "0".to_owned()));
        let mut subject = Subject { text: found.text, solution, right: Vec::new(), key };
        let form = subject.form(zeros);
        let expected = entries(&form, &subject.key()).expect("zeros are understood");
        subject.right = expected.into_iter().map(|entry| (entry.row, entry.expected)).collect();
        subject
    };
    (0..HANDED_IN.now()).map(|_| of(exercises.next().expect("one can be found"))).collect()
}

/// The strategies, by name, with what is handed in.
fn strategies(all: &[Subject], at: usize, random: &mut Random) -> Vec<(&'static str, Handed)> {
    let own = &all[at];
    let right = || own.right.iter().map(|(name, value)| (name.clone(), four(*value)));
    let count = own.right.len();
    let some = |first: usize, most: usize| right().cycle().skip(first).take(most).collect::<Vec<_>>();
    let form = |values: Vec<(String, String)>| Handed::Form(own.form(values));
    let named = |mut measured: Measured, name: &str| {
        measured.exercise = Some(name.into());
        Handed::Form(measured)
    };
    let every = |text: &mut dyn FnMut() -> String| -> Vec<(String, String)> {
        own.right.iter().map(|(name, _)| (name.clone(), text())).collect()
    };
    let anywhere = |radius: Option<f64>, random: &mut Random| {
        let mut measured = own.form([]);
        measured.upright = true;
        for plan in own.solution.construction.plans() {
            let mut points = PointsOf::new(plan.order);
            for name in plan.points.keys().map(String::as_str).chain([plan.order.pole()]) {
                points.put(name, [random.within(100.0), random.within(100.0)], radius);
            }
            measured.points.push(points);
        }
        Handed::Form(measured)
    };
    let median = |name: &String| {
        let of = |subject: &Subject| subject.right.iter().find(|(own, _)| own == name).map(|(_, value)| *value);
        // The median of the other students: with the middle one of three it would be the student's own value.
        let others = all.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, subject)| subject);
        let mut values: Vec<f64> = others.filter_map(of).collect();
        if values.is_empty() {
            values.extend(of(own));
        }
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let next = &all[(at + 1) % all.len()];
    let neighbours = || next.right.iter().map(|(name, value)| (name.clone(), four(*value))).collect::<Vec<_>>();
    let did = own.own();
    let vector = did.iter().position(|entry| entry.get("lay_off").is_some()).expect("a vector");
    let mut undone = did.clone();
    undone.push(json!({ "undo": did.len() }));
    let typed: Vec<Value> = own
        .right
        .iter()
        .filter(|(name, _)| is_rate(name))
        .map(|(name, value)| json!({ "compute": name, "value": value }))
        .collect();
    let by_formula: Vec<Value> = own
        .right
        .iter()
        .filter(|(name, _)| is_rate(name))
        .map(|(name, value)| json!({ "compute": name, "as": format!("{value}") }))
        .collect();
    let segments: Vec<Value> = own
        .right
        .iter()
        .filter(|(name, _)| !is_rate(name))
        .map(|(name, value)| json!({ "compute": name, "value": value.abs() }))
        .collect();
    let ends: Vec<&str> =
        own.solution.scene.links.values().next().expect("a link").points.iter().map(String::as_str).take(2).collect();
    let length = format!("L({},{})", ends[0], ends[1]);
    let (one, random_at) = (four(any_size(random)), random.below(count));
    vec![
        ("lines taken out", named(own.form(some(random_at, count - 1)), "an-exercise")),
        ("exercise and lines left out", form(some(random_at, count / 2))),
        ("one value only", form(some(random_at, 1))),
        ("one given length", form(vec![(length, "60".to_owned())])),
        ("one vector", own.drawing(&did[..=vector])),
        ("empty drawing", own.drawing(&[])),
        ("all undone", own.drawing(&undone)),
        ("typed rates alone", own.drawing(&typed)),
        ("typed rates as formulas", own.drawing(&by_formula)),
        ("typed segments alone", own.drawing(&segments)),
        ("zeros", form(every(&mut || "0".to_owned()))),
        ("one number everywhere", form(every(&mut || one.clone()))),
        ("random", form(every(&mut || four(any_size(random))))),
        ("points anywhere, radii of 10 mm", anywhere(Some(10.0), random)),
        ("points anywhere, radii of 1 mm", anywhere(Some(1.0), random)),
        ("median of the class", form(own.right.iter().map(|(name, _)| (name.clone(), four(median(name)))).collect())),
        ("a neighbour's numbers", form(neighbours())),
        (IN_CLASS, form(neighbours())),
    ]
}

const IN_CLASS: &str = "a neighbour's numbers, in a class";

fn any_size(random: &mut Random) -> f64 {
    let size = libm::exp10(random.between(-2.0, 5.0));
    if random.below(2) == 0 { size } else { -size }
}

/// Whether it passes, and the share of the marks that it earns.
fn judged(handed: &Handed, prepared: &Prepared<'_>, others: &[Prepared<'_>], scheme: &MarkScheme) -> (bool, f64) {
    let share = |checked: &Checked| {
        let marks = scheme.award(checked);
        marks.earned / marks.of.max(1e-9)
    };
    match handed {
        Handed::Form(measured) => {
            let mut checked = prepared.check(measured).expect("a form that is understood");
            if others.iter().any(|other| other.has_rather(measured, &checked)) {
                checked.put_down_to("another");
            }
            (checked.is_passed(), share(&checked))
        }
        Handed::Drawing(drawing) => {
            let drawing = HandDrawing::read(&drawing.to_string()).expect("a drawing");
            let judge = Judge::new(prepared.key());
            let found = judge.judge(&drawing).expect("it is carried out");
            let result = found.result(&judge, &drawing, &prepared.key().solution.wording());
            let checked = prepared.check_drawn(&judge.form(&drawing, &found)).expect("understood");
            (result.passed, share(&checked))
        }
    }
}

#[test]
fn no_strategy_passes_and_whoever_draws_carefully_does() {
    let mut random = Random(17);
    let mut table: Vec<(&str, usize, usize, f64, f64)> = Vec::new();
    let mut failed: Vec<String> = Vec::new();
    let mut count = 0;
    for kind in KINDS.into_iter().step_by(EVERY_KIND.now()) {
        let all = subjects(kind);
        let keys: Vec<AnswerKey<'_>> = all.iter().map(Subject::key).collect();
        for (at, own) in all.iter().enumerate() {
            count += 1;
            let key = keys[at];
            let prepared = Prepared::new(&key);
            let others: Vec<Prepared<'_>> =
                keys.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, key)| Prepared::new(key)).collect();
            let marks = Marks::read(r#"{ "kinegon_marks": 1 }"#).expect("a scheme").of(&key).expect("of this scene");
            for (name, handed) in strategies(&all, at, &mut random) {
                let others = if name == IN_CLASS { &others[..] } else { &[] };
                let (passed, share) = judged(&handed, &prepared, others, &marks);
                if passed {
                    failed.push(format!("{kind} {at}: {name} passes"));
                }
                match table.iter_mut().find(|row| row.0 == name) {
                    Some(row) => {
                        (row.1, row.2) = (row.1 + 1, row.2 + usize::from(passed));
                        (row.3, row.4) = (row.3 + share, row.4.max(share));
                    }
                    None => table.push((name, 1, usize::from(passed), share, share)),
                }
            }
            let careful = |values: &[(String, f64)]| {
                Handed::Form(own.form(values.iter().map(|(name, value)| (name.clone(), four(*value)))))
            };
            let task = Task::new(kind, &own.text).expect("a scene");
            let hand = task.hand_in(None, SKILLS[0], 100 + at as u64);
            for (name, handed) in [
                ("four digits", careful(&own.right)),
                ("four digits by the names of the key", careful(&own.key)),
                ("the own construction", own.drawing(&own.own())),
                ("a careful hand", Handed::Form(hand)),
            ] {
                let (passed, share) = judged(&handed, &prepared, &[], &marks);
                if !passed || share < 1.0 {
                    failed.push(format!("{kind} {at}: {name} does not pass, {:.0} % of the marks", 100.0 * share));
                }
            }
        }
    }
    println!("| strategy | exercises | passed | mean | best |\n|---|---|---|---|---|");
    for (name, tried, passed, sum, best) in &table {
        println!("| {name} | {tried} | {passed} | {:.1} % | {:.0} % |", 100.0 * sum / *tried as f64, 100.0 * best);
    }
    println!("{count} exercises");
    assert!(failed.is_empty(), "{}", failed.join("\n"));
    let mean = |name: &str| table.iter().find(|row| row.0 == name).map(|row| row.3 / row.1 as f64).expect("tried");
    for nothing in ["one given length", "empty drawing", "all undone", "typed rates alone", "typed rates as formulas"] {
        assert_eq!(mean(nothing), 0.0, "{nothing}");
    }
    for little in ["zeros", "one number everywhere", "random", "points anywhere, radii of 10 mm"] {
        assert!(mean(little) < 0.06, "{little}: {}", mean(little));
    }
}
