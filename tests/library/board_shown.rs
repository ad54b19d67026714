//! What a board shows of a drawing: all that its own construction needs can be chosen, numbers have their units, sheets have room for helping points,
//! free hands are told how near they must be, and what is told of a wrong entry is true in its sense and its sign.

use kinegon::Sheet;
use kinegon::board::{Board, Given, HandDrawing, Judge, Pressed, Screen, ThingKind, own_drawing};
use kinegon::check::AnswerKey;
use kinegon::construction::Tolerance;
use serde_json::{Value, json};
use support::files::{read, templates};
use support::stages::solved;

fn screen(scene: &str) -> Screen {
    let solution = solved(scene).expect("a good scene");
    Screen::new(Judge::new(&AnswerKey::new(&solution, Some(Tolerance::default()))), solution.wording())
}

fn drawing(snap: &str, did: &Value) -> HandDrawing {
    let text = json!({ "kinegon_drawing": 1, "snap": snap, "did": did }).to_string();
    HandDrawing::read(&text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn shown(screen: &Screen, snap: &str, did: &Value) -> Board {
    screen.board(String::new(), &drawing(snap, did))
}

/// What is told of the first wrong entry: what was done, what should be.
fn told(screen: &Screen, did: &Value) -> [String; 2] {
    let drawing = drawing("all", did);
    let judged = screen.judge.judge(&drawing).expect("it is carried out");
    let result = judged.result(&screen.judge, &drawing, &screen.words());
    let wrong = &result.entries[result.first_wrong.expect("something is wrong")];
    [wrong.done.clone(), wrong.should.clone()].map(Option::unwrap_or_default)
}

/// The names that give a direction, of an entry.
fn directions(entry: &Value) -> Vec<&str> {
    let along = entry["along"].as_object().into_iter().flatten();
    along
        .flat_map(|(how, value)| match how.as_str() {
            "turned" => value.as_array().into_iter().flatten().filter_map(Value::as_str).collect(),
            "parallel" | "normal" => value.as_str().into_iter().collect(),
            _ => Vec::new(),
        })
        .collect()
}

#[test]
fn all_of_the_own_construction_can_be_chosen_from_what_the_board_offers() {
    let scenes = ["figure-1", "figure-2"].map(|name| (name.to_owned(), read(&format!("examples/{name}.json"))));
    let mut tried = 0;
    for (name, text) in templates().into_iter().chain(scenes) {
        let Ok(solution) = solved(&text) else { continue };
        // The line of two centres in the frame is no link: a hand joins it first.
        if text.contains("\"gears\"") {
            continue;
        }
        let screen = screen(&text);
        let own: Value = serde_json::from_str(&own_drawing(&Given::new(&solution), &solution.scales())).expect("JSON");
        let all = own["did"].as_array().expect("entries");
        for (index, entry) in all.iter().enumerate() {
            let board = shown(&screen, "all", &json!(all[..index]));
            let has = |kinds: &[ThingKind], sheet: Option<&str>, wanted: &str| {
                board.things.iter().any(|thing| {
                    kinds.contains(&thing.kind)
                        && thing.name == wanted
                        && sheet.is_none_or(|s| thing.sheet.as_str() == s)
                })
            };
            for wanted in directions(entry) {
                // Two points the other way round are the same direction with the other sign, which a hand turns.
                let turned = wanted.split_once(',').map_or(String::new(), |(from, to)| format!("{to},{from}"));
                let kinds = [ThingKind::Link, ThingKind::Guide, ThingKind::Line];
                let is_there = has(&kinds, None, wanted) || has(&kinds, None, &turned);
                assert!(is_there, "{name}, entry {}: no direction {wanted}: {entry}", index + 1);
            }
            let points = ["from", "to", "through"].into_iter().filter_map(|key| entry[key].as_str());
            let listed = ["points", "ends"].into_iter().filter(|key| *key == "ends" || entry["join"].is_string());
            let listed = listed.flat_map(|key| entry[key].as_array().into_iter().flatten().filter_map(Value::as_str));
            for wanted in points.chain(listed) {
                let is_there = has(&[ThingKind::Point], entry["on"].as_str(), wanted);
                assert!(is_there, "{name}, entry {}: no point {wanted}: {entry}", index + 1);
            }
            tried += 1;
        }
    }
    assert!(tried > 400, "{tried} entries");
}

#[test]
fn numbers_have_units_and_lengths_that_are_taken_from_the_scheme_are_there() {
    let lever = screen(&read("templates/slotted-lever.json"));
    let did = json!([
        { "lay_off": "b", "on": "velocity", "from": "p", "size": "omega(1) * L(A,B)", "along": { "normal": "1" } },
        { "measure": "pb", "on": "velocity", "from": "p", "to": "b" },
        { "compute": "half", "as": "pb / 2" },
    ]);
    let board = shown(&lever, "all", &did);
    let unit = |name: &str| {
        let found = board.numbers.iter().find(|number| number.name == name);
        found.unwrap_or_else(|| panic!("no {name}")).unit.as_str()
    };
    assert_eq!([unit("pb"), unit("half"), unit("omega(1)"), unit("L(D,B)")], ["mm/s", "", "rad/s", "mm"]);
    let lengths = board.numbers.iter().filter(|number| number.name.starts_with("L("));
    let of_nothing: Vec<&str> =
        lengths.filter(|number| number.value == "0").map(|number| number.name.as_str()).collect();
    assert!(of_nothing.is_empty(), "{of_nothing:?}");
    let turning = |name: &str| board.names.iter().any(|known| known.name == name && known.is_turning);
    assert_eq!(["omega(3)", "alpha(3)", "v_r(2/3)", "v(B)"].map(turning), [true, true, false, false]);
    assert!(board.did[1].words.ends_with("600 mm/s"), "{}", board.did[1].words);
}

#[test]
fn sheets_have_room_for_helping_points() {
    // The normal part of B alone is farther to the side than any point of the plan: the tangential part brings b back.
    let crank = screen(
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
             "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 55 }, "drive": { "angle": 130, "omega": 6, "alpha": 40 } },
                        "2": { "points": ["B", "C", "Q"], "lengths": { "BC": 170, "BQ": 60, "CQ": 135 } }, "3": { "points": ["C"] } },
             "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 25], "along": 10 }],
             "near": { "C": [130, 45], "Q": [10, 95] }, "figure": { "panels": ["scheme", "velocity", "acceleration"] } }"#,
    );
    let did = json!([{ "lay_off": "h1", "on": "acceleration", "from": "π", "size": "-omega(1)^2 * L(A,B)", "along": { "parallel": "1" } }]);
    let board = shown(&crank, "all", &did);
    let sheet = board.sheets.iter().find(|sheet| sheet.sheet.as_str() == "acceleration").expect("a plan");
    let point = board.things.iter().find(|thing| thing.name == "h1").expect("it is drawn");
    let room = 10.0;
    for (at, size) in point.at.into_iter().zip([sheet.width, sheet.height]) {
        assert!(at > room && at < size - room, "{at} mm of {size} mm");
    }
}

/// At a scale at which a sheet would be kilometres long there is no paper, and nothing is drawn.
#[test]
fn no_paper_is_kilometres_long() {
    let four_bar = screen(&read("templates/four-bar.json"));
    let sheets = |mu: f64| {
        let text = json!({ "kinegon_drawing": 1, "mu_l": mu, "did": [] }).to_string();
        let drawing = HandDrawing::read(&text).expect("a drawing");
        four_bar.picture(&drawing, Sheet::Scheme, None, 3.5, None)
    };
    assert!(sheets(2.5).is_some() && sheets(2.5e-6).is_none() && sheets(5e-324).is_none());
}

#[test]
fn a_free_hand_is_told_how_near_it_must_be_and_stays_where_it_drew() {
    let four_bar = screen(&read("templates/four-bar.json"));
    let did = json!([{ "lay_off": "b", "on": "velocity", "from": "p", "size": "omega(1) * L(A,B)", "along": { "normal": "1" } }]);
    assert_eq!(shown(&four_bar, "all", &did).hand, None);
    let said = shown(&four_bar, "none", &did).hand.expect("it is said");
    // Three times the 0.3 mm and 0.3° of a careful hand.
    assert!(said.contains("±0.9 mm") && said.contains("±0.9°"), "{said}");
    let board = shown(&four_bar, "none", &did);
    let b = board.things.iter().find(|thing| thing.name == "b").expect("it is drawn").at;
    let press = |snap: &str| {
        let has = json!({ "line": "", "along": { "normal": "2" } }).as_object().expect("keys").clone();
        let sheet = kinegon::Sheet::Velocity;
        let at = [b[0] + 0.5, b[1] + 0.5];
        four_bar.snapped(&drawing(snap, &did), &Pressed { has, sheet, at, reach: 3.0 }).remove(0).entry
    };
    assert_eq!((&press("points")["through"], press("points").get("drawn")), (&json!("b"), None));
    let free = press("none");
    assert_eq!(free["through"], "b");
    let [drawn_at, pole] = [&free["drawn"], &json!(board.sheets[1].pole)]
        .map(|place| [0, 1].map(|k| place[k].as_f64().unwrap_or_else(|| panic!("no place: {free:?}"))));
    assert!((drawn_at[0] - (b[0] + 0.5 - pole[0])).abs() < 0.01, "{drawn_at:?}");
    assert!((drawn_at[1] - (pole[1] - b[1] - 0.5)).abs() < 0.01, "{drawn_at:?}");
}

#[test]
fn what_is_told_is_true_in_its_sense_and_its_sign() {
    // From b to k_b3 the Coriolis part runs backwards: it was drawn from b in its own direction.
    let lever = screen(&read("templates/slotted-lever.json"));
    let own: Value = {
        let solution = solved(&read("templates/slotted-lever.json")).expect("a good scene");
        serde_json::from_str(&own_drawing(&Given::new(&solution), &solution.scales())).expect("JSON")
    };
    let mut did = own["did"].as_array().expect("entries").clone();
    let at = did.iter().position(|entry| entry["lay_off"] == "k_b3").expect("a Coriolis part");
    did[at]["size"] = json!(format!("-({})", did[at]["size"].as_str().expect("a formula")));
    did.truncate(at + 1);
    let [done, should] = told(&lever, &json!(did));
    assert!(done.contains("from k_b3 to b"), "{done}");
    assert!(should.contains("turned by 90°"), "{should}");
    // A lever's whole length for that up to its pin; vplan(p,e), which would do with it, is not drawn.
    let velocities: Vec<Value> = json!([
        { "lay_off": "b", "on": "velocity", "from": "p", "size": "omega(1) * L(A,B)", "along": { "normal": "1" } },
        { "line": "r1", "on": "velocity", "through": "b", "along": { "parallel": "2/3" } },
        { "line": "r2", "on": "velocity", "through": "p", "along": { "normal": "3" } },
        { "cross": "b_3", "of": ["r1", "r2"] },
        { "compute": "omega(3)", "as": "vplan(p,b_3) / L(D,C)", "sense": "ccw" },
    ])
    .as_array()
    .expect("entries")
    .clone();
    let [done, _] = told(&lever, &json!(velocities));
    assert!(done.contains("L_DC") || done.contains("L_DB"), "{done}");
    // ω_2 of the four-bar linkage is −2.424 rad/s (docs/students.md): 4 and 2 stand in each other's place.
    let four_bar = screen(&read("templates/four-bar.json"));
    let [done, should] = told(&four_bar, &json!([{ "compute": "omega(2)", "value": -2.244 }]));
    assert!(done.contains("-2.244 for -2.424"), "{done}");
    assert_eq!(should, "-2.424");
}

#[test]
fn motions_of_the_ground_are_not_asked_for_and_minus_signs_are_signs() {
    let board = shown(&screen(&read("examples/figure-2.json")), "all", &json!([]));
    let names: Vec<&str> = board.names.iter().map(|name| name.name.as_str()).collect();
    for fixed in ["v(A)", "a(A)", "v(G)", "a(G)"] {
        assert!(!names.contains(&fixed), "{fixed}: {names:?}");
    }
    assert!(["v(B)", "v(D)", "v(D_2)"].iter().all(|moving| names.contains(moving)), "{names:?}");
    let omega = board.given.iter().find(|number| number.name == "omega(1)").expect("it is given");
    assert_eq!(omega.value, "−1");
    let words = |did: Value| shown(&screen(&read("templates/four-bar.json")), "all", &did).did[0].words.clone();
    let laid =
        json!([{ "lay_off": "b", "on": "velocity", "from": "p", "size": "-(2-L(A,B))", "along": { "angle": -30 } }]);
    assert!(words(laid).starts_with("b: −(2−L(A,B)) laid off from p, at −30°"));
    assert_eq!(words(json!([{ "compute": "x", "value": -8 }])), "x = −8, typed: −8");
}

/// At a joint two links meet: both are offered, each with its direction.
#[test]
fn a_press_at_a_joint_offers_all_directions_there() {
    let screen = screen(&read("templates/four-bar.json"));
    let empty = drawing("all", &json!([]));
    let board = shown(&screen, "all", &json!([]));
    let b = board.things.iter().find(|thing| thing.kind == ThingKind::Point && thing.name == "B").expect("a joint").at;
    let has = serde_json::from_value(json!({ "line": "", "along": { "normal": "" } })).expect("an object");
    let all = screen.snapped(&empty, &Pressed { has, sheet: kinegon::Sheet::Scheme, at: b, reach: 1.0 });
    let directions: Vec<f64> = all.iter().map(|snap| snap.direction.expect("a direction")).collect();
    // The crank stands at 60° in the template; the coupler does not.
    assert_eq!(directions.len(), 2, "{all:?}");
    assert!(directions.iter().any(|angle| (angle - 60.0).abs() < 1e-9), "{directions:?}");
    assert!((directions[0] - directions[1]).abs() > 1.0);
}

#[test]
fn the_figure_of_centres_takes_the_place_of_plans_that_nobody_asks_for() {
    let mut scene: Value = serde_json::from_str(&read("templates/slider-crank.json")).expect("a scene");
    scene["figure"] = json!({ "panels": ["scheme", "centers"], "centers": "all" });
    let screen = screen(&scene.to_string());
    let did = json!([
        { "join": "r1", "on": "centers", "points": ["A", "B"] },
        { "line": "r2", "on": "centers", "through": "C", "along": { "normal": "3/ground" } },
        { "cross": "P(2,0)", "of": ["r1", "r2"] },
    ]);
    let board = shown(&screen, "all", &did);
    assert_eq!(board.sheets.iter().map(|sheet| sheet.sheet).collect::<Vec<_>>(), [Sheet::Scheme, Sheet::Centers]);
    let missing = board.names.iter().filter(|name| name.sheet == Some(Sheet::Centers) && !name.is_made);
    assert_eq!(missing.map(|name| name.name.as_str()).collect::<Vec<_>>(), ["P(1,3)"]);
    assert_eq!(board.did[2].words, "P_20 where r1 and r2 cross");
    assert!(board.numbers.iter().any(|number| number.name == "L(P(1,ground),P(2,ground))"));
    // A guide is pressed on the figure of centres itself.
    let has = json!({ "line": "", "along": { "normal": "" } });
    let pressed =
        |sheet: Sheet, at: [f64; 2]| Pressed { has: has.as_object().expect("an entry").clone(), sheet, at, reach: 3.0 };
    let on_centers = board.things.iter().find(|thing| thing.sheet == Sheet::Centers && thing.name == "C").expect("C");
    let at = [on_centers.at[0] + 4.0, on_centers.at[1]];
    let snapped = screen.snapped(&drawing("all", &json!([])), &pressed(Sheet::Centers, at));
    assert!(snapped.iter().any(|snap| snap.entry["along"] == json!({ "normal": "3/ground" })), "{snapped:?}");
    // What is drawn by another route needs no further hint for the lines of Kinegon's own.
    let hint = screen.hint(&drawing("all", &did), None, 1);
    assert_eq!(hint.sheet, Some(Sheet::Centers));
    let picture = screen.picture(&drawing("all", &did), Sheet::Centers, None, 3.5, None).expect("a picture");
    assert!(picture.marks.iter().any(|mark| mark.id.as_deref().is_some_and(|id| id.contains("point-Pu282-groundu29"))));
}
