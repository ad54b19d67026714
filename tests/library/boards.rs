//! Drawings made on the board, judged operation by operation: Kinegon's own construction of every scene is right, so are equivalent ways, the first wrong
//! operation is the one that was put in, every prefix replays, and no file ends in a panic.

use kinegon::board::{Entry, Formula, Given, HandDrawing, Judge, JudgedDrawing, MOST_ENTRIES, Verdict, own_drawing};
use kinegon::check::AnswerKey;
use kinegon::construction::Tolerance;
use serde_json::{Value, json};
use support::files::{read, templates};
use support::random::Random;
use support::stages::solved;

const FOUR_BAR: &str = "templates/four-bar.json";
const SLIDER_CRANK: &str = "templates/slider-crank.json";

fn judge(scene: &str) -> Judge {
    let solution = solved(scene).expect("a good scene");
    Judge::new(&AnswerKey::new(&solution, Some(Tolerance::default())))
}

fn drawing(did: &Value) -> HandDrawing {
    let text = json!({ "kinegon_drawing": 1, "did": did }).to_string();
    HandDrawing::read(&text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn judged(judge: &Judge, did: &Value) -> JudgedDrawing {
    judge.judge(&drawing(did)).unwrap_or_else(|error| panic!("{did}: {error}"))
}

/// The velocity plan of the four-bar linkage as a textbook has it.
fn velocity_plan() -> Vec<Value> {
    vec![
        json!({ "compute": "v(B)", "as": "omega(1) * L(A,B)" }),
        json!({ "lay_off": "b", "on": "velocity", "from": "p", "size": "v(B)", "along": { "normal": "A,B" } }),
        json!({ "line": "r1", "on": "velocity", "through": "b", "along": { "normal": "2" } }),
        json!({ "line": "r2", "on": "velocity", "through": "p", "along": { "normal": "3" } }),
        json!({ "cross": "c", "of": ["r1", "r2"] }),
        json!({ "measure": "bc", "on": "velocity", "from": "b", "to": "c" }),
        json!({ "compute": "omega(2)", "as": "bc / L(B,C)", "sense": "cw" }),
    ]
}

/// The drawing with one entry in place of another.
fn with(index: usize, entry: Value) -> Value {
    let mut did = velocity_plan();
    did[index] = entry;
    Value::Array(did)
}

#[test]
fn own_constructions_are_right_and_every_prefix_replays() {
    let scenes =
        ["figure-1", "figure-2", "wiper"].map(|name| (name.to_owned(), read(&format!("examples/{name}.json"))));
    for (name, text) in templates().into_iter().chain(scenes) {
        let Ok(solution) = solved(&text) else { continue };
        let judge = judge(&text);
        let own = own_drawing(&Given::new(&solution), &solution.scales());
        let whole = HandDrawing::read(&own).unwrap_or_else(|error| panic!("{name}: {error}"));
        let found = judge.judge(&whole).unwrap_or_else(|error| panic!("{name}: {error}"));
        let wrong = found.first_wrong().map(|index| &whole.did[index]);
        assert!(wrong.is_none(), "{name}: {wrong:?}: {:?}", found.verdicts);
        assert_eq!(judge.missing(&judge.form(&whole, &found)), [""; 0], "{name}");
        assert_eq!(own, own_drawing(&Given::new(&solution), &solution.scales()), "{name}: not the same bytes");
        // Every prefix is a drawing, too; its verdicts do not depend on what comes later but for what is unused yet.
        for count in (0..whole.did.len()).step_by(7) {
            let mut prefix = whole.clone();
            prefix.did.truncate(count);
            let found = judge.judge(&prefix).unwrap_or_else(|error| panic!("{name}, {count} entries: {error}"));
            assert!(found.first_wrong().is_none(), "{name}: {count} entries: {:?}", found.verdicts);
        }
    }
}

#[test]
fn ways_that_lead_to_the_same_are_right() {
    let judge = judge(&read(FOUR_BAR));
    let crank = [
        // v²/l, ω² l, ω v: with the sense of the normal part in the direction or in the sign.
        json!({ "lay_off": "b", "on": "acceleration", "from": "π", "size": "v(B)^2 / L(A,B)", "along": { "parallel": "B,A" } }),
        json!({ "lay_off": "b", "on": "acceleration", "from": "pi", "size": "-omega(1)^2 * L(A,B)", "along": { "parallel": "1" } }),
        json!({ "lay_off": "b", "on": "acceleration", "from": "a", "size": "omega(1) * vplan(p,b)", "along": { "parallel": "B,A" } }),
    ];
    for entry in crank {
        let mut did = velocity_plan();
        did.push(entry.clone());
        let found = judged(&judge, &Value::Array(did));
        assert_eq!(found.verdicts[7], Verdict::Right, "{entry}");
    }
    // Poles in any order, rays in any order, additional lines, a detour that is taken back.
    let mut did = velocity_plan();
    did.swap(2, 3);
    did.insert(2, json!({ "line": "x", "on": "velocity", "through": "b", "along": { "angle": 17 } }));
    did.insert(3, json!({ "undo": 1 }));
    did.insert(4, json!({ "line": "x", "on": "velocity", "through": "p", "along": { "angle": 17 } }));
    let found = judged(&judge, &Value::Array(did));
    assert_eq!(found.first_wrong(), None, "{:?}", found.verdicts);
    assert_eq!([&found.verdicts[2], &found.verdicts[4]], [&Verdict::Undone, &Verdict::Unused]);
}

/// A line that is not crossed yet is right where it leads to a point that is still to be found, and else leads nowhere.
#[test]
fn a_line_that_is_not_used_yet_is_right_where_it_leads_on() {
    for name in ["templates/four-bar.json", "templates/whitworth.json", "examples/figure-2.json"] {
        let text = read(name);
        let solution = solved(&text).expect("a sound scene");
        let judge = judge(&text);
        let whole = HandDrawing::read(&own_drawing(&Given::new(&solution), &solution.scales())).expect("a drawing");
        let lines = whole.did.iter().enumerate().filter(|(_, entry)| matches!(entry, Entry::Line(_)));
        for (index, entry) in lines {
            let mut prefix = whole.clone();
            prefix.did.truncate(index + 1);
            let found = judge.judge(&prefix).unwrap_or_else(|error| panic!("{name}, {index}: {error}"));
            assert_eq!(found.verdicts[index], Verdict::Right, "{name}: {entry:?}");
        }
    }
    let judge = judge(&read(FOUR_BAR));
    let lines = [
        // v_CB is at right angles to BC, v_C to CD.
        (json!({ "line": "r1", "on": "velocity", "through": "b", "along": { "normal": "2" } }), Verdict::Right),
        (json!({ "line": "r1", "on": "velocity", "through": "b", "along": { "parallel": "2" } }), Verdict::Unused),
        (json!({ "line": "r2", "on": "velocity", "through": "p", "along": { "parallel": "3" } }), Verdict::Unused),
        (json!({ "line": "r2", "on": "velocity", "through": "b", "along": { "normal": "3" } }), Verdict::Unused),
        // It leads back to p, which is there.
        (json!({ "line": "r1", "on": "velocity", "through": "b", "along": { "normal": "1" } }), Verdict::Unused),
    ];
    for (line, verdict) in lines {
        let mut did = velocity_plan();
        did.truncate(2);
        did.push(line.clone());
        assert_eq!(judged(&judge, &Value::Array(did)).verdicts[2], verdict, "{line}");
    }
}

#[test]
fn the_first_wrong_operation_is_named() {
    let judge = judge(&read(FOUR_BAR));
    let planted = [
        (with(0, json!({ "compute": "v(B)", "as": "omega(1)^2 * L(A,B)" })), 0, Some("omega-not-squared")),
        (
            with(2, json!({ "line": "r1", "on": "velocity", "through": "b", "along": { "parallel": "2" } })),
            2,
            Some("turned-ray"),
        ),
        (
            with(3, json!({ "line": "r2", "on": "velocity", "through": "b", "along": { "normal": "3" } })),
            3,
            Some("ray-from-wrong-point"),
        ),
        (with(5, json!({ "measure": "bc", "on": "velocity", "from": "p", "to": "c" })), 5, Some("wrong-segment")),
        (with(6, json!({ "compute": "omega(2)", "as": "bc / L(C,D)", "sense": "cw" })), 6, Some("wrong-length")),
        (with(6, json!({ "compute": "omega(2)", "as": "bc / L(B,C)", "sense": "ccw" })), 6, Some("wrong-sense")),
    ];
    for (did, index, mistake) in planted {
        let found = judged(&judge, &did);
        assert_eq!(found.first_wrong(), Some(index), "{did}: {:?}", found.verdicts);
        let Verdict::Wrong(wrong) = &found.verdicts[index] else { unreachable!("it is the first wrong one") };
        let told = wrong.mistake.as_ref().map(|told| told.mistake.id());
        // What is not squared where it should not be has no name of its own.
        if mistake != Some("omega-not-squared") {
            assert_eq!(told, mistake, "{did}");
        }
        // What comes later is right by itself.
        assert_eq!(found.verdicts.iter().filter(|verdict| matches!(verdict, Verdict::Wrong(_))).count(), 1, "{did}");
    }
}

/// ω₃ : ω₁ = AP : DP, where P, the crossing of coupler and frame, is the instant centre of crank and rocker (Aronhold 1872, Kennedy 1886).
/// The ratio turned over is wrong where it stands, and not the right crossing before it.
#[test]
fn a_ratio_turned_over_is_wrong_where_it_stands() {
    let by_centre = |ratio: &str| {
        json!([
            { "join": "l1", "on": "scheme", "points": ["A", "D"] },
            { "join": "l2", "on": "scheme", "points": ["B", "C"] },
            { "cross": "P", "of": ["l1", "l2"] },
            { "measure": "ap", "on": "scheme", "from": "A", "to": "P" },
            { "measure": "dp", "on": "scheme", "from": "D", "to": "P" },
            { "compute": "omega(3)", "as": format!("omega(1) * {ratio}"), "sense": "ccw" },
        ])
    };
    let judge = judge(&read(FOUR_BAR));
    assert_eq!(judged(&judge, &by_centre("ap / dp")).first_wrong(), None);
    assert_eq!(judged(&judge, &by_centre("dp / ap")).first_wrong(), Some(5));
}

#[test]
fn a_free_hand_may_err_as_hands_do() {
    let judge = judge(&read(FOUR_BAR));
    // Right: b at 120 mm along 150°, the ray through it normal to BC at 114.48°. A hand is 0.2 mm and 0.2° off, then 3 mm, then 3°.
    let [x, y] = [120.0 * libm::cos(150.0_f64.to_radians()), 60.0];
    for (aside, turn, is_right) in [(0.2, 0.2, true), (3.0, 0.0, false), (0.0, 3.0, false)] {
        for stated in [true, false] {
            let mut entry = json!({ "line": "r1", "on": "velocity", "drawn": [x + aside, y, 114.48 + turn] });
            if stated {
                entry["through"] = json!("b");
                entry["along"] = json!({ "normal": "2" });
            }
            let found = judged(&judge, &with(2, entry.clone()));
            assert_eq!(found.first_wrong() != Some(2), is_right, "{entry}: {:?}", found.verdicts);
        }
    }
}

/// Numbers that a free hand has measured, worked out and typed, of drawings by another hand (tests/drawings): they are off by more than their digits
/// leave open, and follow from what was drawn.
#[test]
fn typed_numbers_that_follow_from_the_drawing_are_right() {
    for name in ["whitworth", "figure-1"] {
        let at = |part: &str| read(&format!("tests/drawings/honest/{name}.{part}.json"));
        let drawing = HandDrawing::read(&at("drawing")).expect("a drawing");
        let found = judge(&at("scene")).judge(&drawing).expect("it is carried out");
        assert_eq!(found.first_wrong(), None, "{name}: {:?}", found.verdicts);
    }
}

/// The plans of the four-bar linkage up to the end of the normal part of C relative to B, which has a name of the hand's own.
fn up_to_own_normal_part(size: &Value, from: &str) -> Value {
    let mut did = velocity_plan();
    did.extend([
        json!({ "lay_off": "b", "on": "acceleration", "from": "π", "size": "omega(1)^2*L(A,B)", "along": { "parallel": "B,A" } }),
        json!({ "lay_off": "h1", "on": "acceleration", "from": from, "size": size, "along": { "parallel": "C,B" } }),
        json!({ "line": "r3", "on": "acceleration", "through": "h1", "along": { "normal": "2" } }),
        json!({ "compute": "omega(3)", "as": "vplan(p,c)/L(C,D)", "sense": "ccw" }),
        json!({ "lay_off": "n_dC", "on": "acceleration", "from": "π", "size": "omega(3)^2*L(C,D)", "along": { "parallel": "C,D" } }),
        json!({ "line": "r4", "on": "acceleration", "through": "n_dC", "along": { "normal": "3" } }),
        json!({ "cross": "c", "of": ["r3", "r4"] }),
    ]);
    Value::Array(did)
}

#[test]
fn what_is_wrong_with_points_and_numbers_of_ones_own_is_named() {
    use kinegon::check::Mistake;
    let judge = judge(&read(FOUR_BAR));
    let given = judge.given();
    let number = |name: &str| given.number(name).expect("a number");
    let [omega, length] = ["omega(2)", "L(B,C)"].map(number);
    let own = 8;
    let cases = [
        (json!("2*omega(2)^2*L(B,C)"), "b", Mistake::Diameter),
        (json!("abs(omega(2))*L(B,C)"), "b", Mistake::OmegaNotSquared),
        (json!("vplan(p,c)^2/L(B,C)"), "b", Mistake::NormalFromAbsolute),
        // Worked out by the hand, to three digits.
        (json!(three_digits(omega.abs() * length)), "b", Mistake::OmegaNotSquared),
    ];
    let right = judged(&judge, &up_to_own_normal_part(&json!("omega(2)^2*L(B,C)"), "b"));
    assert_eq!(right.first_wrong(), None, "{:?}", right.verdicts);
    let typed = judged(&judge, &up_to_own_normal_part(&json!(three_digits(omega * omega * length)), "b"));
    assert_eq!(typed.first_wrong(), None, "{:?}", typed.verdicts);
    for (size, from, meant) in cases {
        let found = judged(&judge, &up_to_own_normal_part(&size, from));
        assert_eq!(found.first_wrong(), Some(own), "{size}: {:?}", found.verdicts);
        let Verdict::Wrong(wrong) = &found.verdicts[own] else { unreachable!() };
        assert_eq!(wrong.mistake.as_ref().map(|told| told.mistake), Some(meant), "{size}");
    }
}

fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().expect("a number")
}

#[test]
fn what_cannot_be_carried_out_is_refused_with_its_entry() {
    let judge = judge(&read(SLIDER_CRANK));
    let refused = [
        (json!({ "measure": "m", "on": "velocity", "from": "p", "to": "c" }), "there is no point c yet"),
        (json!({ "cross": "c", "of": ["r1", "r2"] }), "there is no line r1"),
        (json!({ "compute": "x", "as": "omega(2) * 2" }), "omega(2) is not known yet"),
        (
            json!({ "lay_off": "p", "on": "velocity", "from": "p", "size": 1, "along": { "angle": 0 } }),
            "`p` cannot be the name: it is taken, or no name",
        ),
        (
            json!({ "solve": ["x"], "equations": ["x * x = 4"] }),
            "`x * x = 4` is not linear in the numbers that are sought",
        ),
        (json!({ "compute": "x", "as": "1 / 0" }), "`1 / 0` has no value"),
    ];
    for (entry, message) in refused {
        let error = judge.judge(&drawing(&json!([{ "undo": 1 }, entry.clone()]))).expect_err("it is refused");
        assert_eq!((error.entry, error.message.to_string()), (1, message.to_owned()), "{entry}");
    }
    // A scale is a length of nature for a millimetre.
    for mu in ["0", "-5"] {
        let text = format!(r#"{{ "kinegon_drawing": 1, "mu_v": {mu}, "did": [] }}"#);
        let error = HandDrawing::read(&text).expect_err(&text);
        assert!(error.to_string().contains("mu_v is no scale"), "{error}");
    }
}

#[test]
fn formulas_mean_what_they_say() {
    let judge = judge(&read(FOUR_BAR));
    let values = [
        ("2 + 3 * 4", 14.0),
        ("-2^2", -4.0),
        ("(2 + 3)^2 / 5", 5.0),
        ("sqrt(16) - abs(-3)", 1.0),
        ("2e3 : 4", 500.0),
        ("2 * sin(30)", 1.0),
    ];
    for (text, value) in values {
        let did = json!([{ "compute": "x", "as": text }]);
        let (table, refused) = judge.drawn(&drawing(&did));
        assert_eq!(refused, None);
        let found = table.known("x").expect("it has a value");
        assert!((found - value).abs() < 1e-12, "{text}: {found}");
    }
    for text in ["", "2 +", "L(A", "3 3", "(2", "omega(", "*"] {
        assert!(Formula::read(text).is_err(), "{text}");
    }
}

#[test]
fn no_file_ends_in_a_panic() {
    let text = read("examples/figure-2.json");
    let solution = solved(&text).expect("a good scene");
    let judge = judge(&text);
    let own = own_drawing(&Given::new(&solution), &solution.scales());
    let whole: Value = serde_json::from_str(&own).expect("JSON");
    let words: Vec<Value> = texts(&whole["did"]);
    let (mut random, mut read_and_judged) = (Random(1), 0);
    for _ in 0..400 {
        let mut changed = whole.clone();
        let did = changed["did"].as_array_mut().expect("a list");
        for _ in 0..=random.below(3) {
            let (at, other) = (random.below(did.len()), random.below(did.len()));
            match random.below(4) {
                0 => drop(did.remove(at)),
                1 => did.swap(at, other),
                2 => did.insert(at, json!({ "undo": random.below(4) })),
                _ => {
                    let entry = did[at].as_object_mut().expect("an entry");
                    let key = entry.keys().nth(random.below(entry.len())).expect("a key").clone();
                    entry[&key] = words[random.below(words.len())].clone();
                }
            }
        }
        // The text itself, broken off or with letters exchanged.
        let text = changed.to_string();
        for text in
            [text.clone(), text.chars().take(random.below(text.len())).collect::<String>(), text.replacen('[', "{", 3)]
        {
            if let Ok(drawing) = HandDrawing::read(&text) {
                read_and_judged += usize::from(judge.judge(&drawing).is_ok());
            }
        }
    }
    assert!(read_and_judged > 40, "only {read_and_judged} could be judged");
}

/// All texts and lists of texts of a drawing.
fn texts(value: &Value) -> Vec<Value> {
    match value {
        Value::String(_) => vec![value.clone()],
        Value::Array(all) => std::iter::once(value.clone()).chain(all.iter().flat_map(texts)).collect(),
        Value::Object(all) => std::iter::once(value.clone()).chain(all.values().flat_map(texts)).collect(),
        _ => Vec::new(),
    }
}

#[test]
fn the_longest_drawing_is_judged() {
    let judge = judge(&read(FOUR_BAR));
    let mut did = velocity_plan();
    while did.len() < MOST_ENTRIES {
        did.push(json!({ "line": format!("x{}", did.len()), "on": "velocity", "through": "b", "along": { "angle": did.len() } }));
    }
    assert_eq!(judged(&judge, &Value::Array(did.clone())).first_wrong(), None);
    did.push(json!({ "undo": 1 }));
    let text = json!({ "kinegon_drawing": 1, "did": did }).to_string();
    let error = HandDrawing::read(&text).expect_err("it is too long");
    assert!(error.to_string().contains("at most 2000 entries"), "{error}");
}

/// The starting scene of a kind with the figure of instant centres alone.
fn with_centers(kind: &str) -> String {
    let mut scene: Value = serde_json::from_str(&read(&format!("templates/{kind}.json"))).expect("a scene");
    scene["figure"] = json!({ "panels": ["scheme", "centers"], "centers": "all", "velocities": ["C"], "mu_c": 1 });
    scene.to_string()
}

/// The centres of the four-bar linkage, ω₃ and v_C by them: in another order than Kinegon's, with names as hands write them.
fn centers_of_four_bar() -> Vec<Value> {
    vec![
        json!({ "join": "r1", "points": ["P(1,2)", "P(2,3)"] }),
        json!({ "join": "r2", "on": "centers", "points": ["A", "P(3,0)"] }),
        json!({ "cross": "P(3,1)", "of": ["r2", "r1"] }),
        json!({ "join": "r3", "on": "centers", "points": ["D", "C"] }),
        json!({ "join": "r4", "points": ["P(1,ground)", "P(2,1)"] }),
        json!({ "cross": "P(2,0)", "of": ["r3", "r4"] }),
        json!({ "measure": "L(P(1,ground),P(1,3))", "from": "A", "to": "P(1,3)", "on": "centers" }),
        json!({ "compute": "omega(3)", "as": "omega(1) * L(P(1,0),P(1,3)) / L(P(3,0),P(3,1))" }),
        json!({ "compute": "v(C)", "as": "omega(3) * L(P(3,ground),C)" }),
    ]
}

#[test]
fn own_constructions_of_centres_are_right_and_complete() {
    for kind in ["four-bar", "slider-crank", "slotted-lever"] {
        let text = with_centers(kind);
        let solution = solved(&text).expect("a good scene");
        let judge = judge(&text);
        let own = HandDrawing::read(&own_drawing(&Given::new(&solution), &solution.scales())).expect("a drawing");
        let found = judge.judge(&own).unwrap_or_else(|error| panic!("{kind}: {error}"));
        let wrong = found.first_wrong().map(|index| &own.did[index]);
        assert!(wrong.is_none(), "{kind}: {wrong:?}: {:?}", found.verdicts);
        assert_eq!(judge.missing(&judge.form(&own, &found)), [""; 0], "{kind}");
    }
}

#[test]
fn centres_by_a_route_of_ones_own_are_right_and_the_first_wrong_operation_is_named() {
    let text = with_centers("four-bar");
    let judge = judge(&text);
    let did = centers_of_four_bar();
    let right = judged(&judge, &Value::Array(did.clone()));
    assert!(right.first_wrong().is_none(), "{:?}", right.verdicts);
    assert_eq!(judge.missing(&judge.form(&drawing(&Value::Array(did.clone())), &right)), [""; 0]);
    for (index, entry, mistake) in [
        (0, json!({ "join": "r1", "points": ["P(1,2)", "P(3,ground)"] }), "lines-without-common-link"),
        (4, json!({ "join": "r4", "points": ["P(1,ground)", "P(2,3)"] }), "lines-without-common-link"),
        (5, json!({ "cross": "P(2,0)", "of": ["r3", "r2"] }), "lines-without-common-link"),
        (
            6,
            json!({ "measure": "L(P(1,ground),P(1,3))", "from": "B", "to": "P(1,3)", "on": "centers" }),
            "distance-from-wrong-centre",
        ),
        (7, json!({ "compute": "omega(3)", "as": "omega(1) * L(P(3,0),P(1,3)) / L(P(1,0),P(1,3))" }), "ratio-inverted"),
        (
            7,
            json!({ "compute": "omega(3)", "as": "-omega(1) * L(P(1,0),P(1,3)) / L(P(3,0),P(1,3))" }),
            "sense-by-centre",
        ),
        (8, json!({ "compute": "v(C)", "as": "omega(3) * L(P(1,3),C)" }), "distance-from-wrong-centre"),
    ] {
        let mut wrong = did.clone();
        wrong[index] = entry.clone();
        // As far as the centre or the numbers that it leads to.
        wrong.truncate(3 * (index / 3) + 3);
        let found = judged(&judge, &Value::Array(wrong));
        let Some(Verdict::Wrong(told)) = found.verdicts.get(index) else { panic!("{entry}: {:?}", found.verdicts) };
        assert_eq!(found.first_wrong(), Some(index), "{entry}: {:?}", found.verdicts);
        assert_eq!(told.mistake.as_ref().map(|told| told.mistake.id()), Some(mistake), "{entry}");
    }
}

#[test]
fn lines_along_a_guide_and_to_a_block_are_named() {
    let judge = judge(&with_centers("slider-crank"));
    let line = |along: Value| {
        json!([
            { "join": "r1", "on": "centers", "points": ["A", "B"] },
            { "line": "r2", "on": "centers", "through": "C", "along": along },
            { "cross": "P(2,0)", "of": ["r1", "r2"] },
        ])
    };
    let guide = "3/ground";
    assert!(judged(&judge, &line(json!({ "normal": guide }))).first_wrong().is_none());
    let to_block = json!([
        { "join": "r1", "on": "centers", "points": ["P(1,2)", "P(2,3)"] },
        { "join": "r2", "on": "centers", "points": ["A", "C"] },
        { "cross": "P(1,3)", "of": ["r1", "r2"] },
    ]);
    for (did, mistake) in [(line(json!({ "parallel": guide })), "centre-along-guide"), (to_block, "centre-at-slider")] {
        let found = judged(&judge, &did);
        let Some(Verdict::Wrong(told)) = found.verdicts.get(1) else { panic!("{did}: {:?}", found.verdicts) };
        assert_eq!(told.mistake.as_ref().map(|told| told.mistake.id()), Some(mistake), "{did}");
    }
}

#[test]
fn a_permanent_centre_is_there_and_one_at_infinity_is_no_crossing() {
    let judge = judge(&with_centers("slider-crank"));
    let refused = |did: Value| judge.judge(&drawing(&did)).expect_err("it cannot be carried out").message.to_string();
    let two = |name: &str| {
        json!([
            { "join": "r1", "on": "centers", "points": ["A", "B"] },
            { "line": "r2", "on": "centers", "through": "C", "along": { "normal": "3/ground" } },
            { "cross": name, "of": ["r1", "r2"] },
        ])
    };
    assert!(refused(two("P(0,1)")).contains("P(0,1)"));
    let parallel = json!([
        { "line": "r1", "on": "centers", "through": "A", "along": { "normal": "3/ground" } },
        { "line": "r2", "on": "centers", "through": "C", "along": { "normal": "3/ground" } },
        { "cross": "P(1,3)", "of": ["r1", "r2"] },
    ]);
    assert!(refused(parallel).contains("r1"));
}
