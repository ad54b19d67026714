//! The engine of the workbench: its files have the bytes that the program writes, and no request makes it panic.

use kinegon_web::Engine;
use serde_json::{Value, json};
use support::files::read;
use support::program::{scratch, stderr, with_scene};
use support::survey::{KINDS, Size};

/// The starting scenes, by name.
fn starting_scenes() -> Vec<(String, String)> {
    let kinds: Value = serde_json::from_str(&Engine::new().kinds()).expect("JSON");
    let kind = |kind: &Value| {
        let [name, text] = ["name", "text"].map(|key| kind[key].as_str().expect("a text").to_owned());
        (name, text)
    };
    kinds.as_array().expect("a list").iter().map(kind).collect()
}

/// What the program prints for a scene on stdin.
fn printed(arguments: &[&str], text: &str) -> Vec<u8> {
    let output = with_scene(arguments, text.as_bytes());
    assert!(output.status.code().is_some_and(|code| code < 2), "{arguments:?}: {}", stderr(&output));
    output.stdout
}

fn file(engine: &mut Engine, text: &str, format: &str, of: Value) -> Vec<u8> {
    let request = json!({ "format": format, "of": of }).to_string();
    engine.file(text, &request).unwrap_or_else(|refused| panic!("{request}: {refused}"))
}

fn parsed(answer: Result<String, String>) -> Value {
    let answer = answer.unwrap_or_else(|refused| panic!("{refused}"));
    serde_json::from_str(&answer).expect("JSON")
}

/// Whether a refusal has a message that says something.
fn is_refusal(refused: &str) -> bool {
    let refused: Value = serde_json::from_str(refused).expect("JSON");
    refused["message"].as_str().is_some_and(|message| message.len() > 5)
}

#[test]
fn files_have_the_bytes_of_the_program() {
    let mut engine = Engine::new();
    let all = starting_scenes();
    assert_eq!(all.len(), 31);
    for (name, text) in all.iter().step_by(KINDS.now()) {
        for (format, of, arguments) in [
            ("svg", json!("figure"), vec!["draw", "-", "-o", "-", "--format", "svg"]),
            ("tikz", json!("figure"), vec!["draw", "-", "-o", "-", "--format", "tikz"]),
            ("svg", json!({ "step": 3 }), vec!["draw", "-", "-o", "-", "--upto", "3", "--format", "svg"]),
            ("svg", json!("worksheet"), vec!["draw", "-", "-o", "-", "--worksheet", "--format", "svg"]),
            ("json", json!("figure"), vec!["solve", "-"]),
            ("steps", json!("figure"), vec!["steps", "-"]),
        ] {
            let expected = printed(&arguments, text);
            assert!(file(&mut engine, text, format, of) == expected, "{name}: {arguments:?}");
        }
    }
}

#[test]
fn sheets_to_print_and_outlines_have_the_bytes_of_the_program() {
    let mut engine = Engine::new();
    for name in ["examples/figure-2.json", "templates/hydraulic-boom.json"] {
        let text = read(name);
        let expected = printed(&["draw", "-", "-o", "-", "--format", "pdf"], &text);
        assert!(file(&mut engine, &text, "pdf", json!("figure")) == expected, "{name}: PDF");
        let expected = printed(&["draw", "-", "-o", "-", "--format", "svg", "--outlines"], &text);
        assert!(file(&mut engine, &text, "outlines", json!("figure")) == expected, "{name}: outlines");
    }
}

#[test]
fn tables_and_curves_have_the_bytes_of_the_program() {
    let mut engine = Engine::new();
    for (name, text) in starting_scenes().into_iter().skip(1).step_by(KINDS.now()) {
        let opened = parsed(engine.open(&text));
        let curves = engine.curves(&text, &json!({ "curves": [] }).to_string(), "null");
        if opened["is_drawn"] == true || opened["drives"] == json!([]) {
            assert!(is_refusal(&curves.expect_err("nothing moves")), "{name}");
            continue;
        }
        let table = file(&mut engine, &text, "csv", json!("figure"));
        assert!(table == printed(&["sweep", "-"], &text), "{name}: table");
        let drawn = parsed(curves);
        let arguments = ["curves", "-", "-o", "-", "--format", "svg"];
        assert_eq!(drawn["svg"].as_str().map(str::as_bytes), Some(&*printed(&arguments, &text)), "{name}: curves");
        let quantities = opened["quantities"].as_array().expect("a list");
        let vector = &quantities.iter().find(|one| one["is_vector"] == true).expect("a vector")["name"];
        let [point, vector] = [&opened["traceable"][0], vector].map(|name| name.as_str().expect("a name").to_owned());
        for (of, option, wanted) in [("path", "--path", point), ("hodograph", "--hodograph", vector)] {
            let made = file(&mut engine, &text, "svg", json!({ of: [&wanted] }));
            let arguments = ["curves", "-", option, &wanted, "-o", "-", "--format", "svg"];
            assert!(made == printed(&arguments, &text), "{name}: {option} {wanted}");
        }
    }
}

#[test]
fn modes_and_values_are_those_of_the_program() {
    let mut engine = Engine::new();
    for (name, text) in starting_scenes() {
        let printed_modes = String::from_utf8(printed(&["modes", "-"], &text)).expect("UTF-8");
        let modes = parsed(engine.modes(&text));
        let modes = modes.as_array().expect("a list");
        assert_eq!(modes.iter().filter(|mode| mode["is_own"] == true).count(), 1, "{name}");
        for mode in modes {
            let line =
                format!("{:3}. {}\n", mode["number"], mode["shown"].as_str().expect("a text").replace('\n', "\n     "));
            assert!(printed_modes.contains(&line), "{name}: {line}");
        }
        let digits = String::from_utf8(printed(&["solve", "--digits", "-"], &text)).expect("UTF-8");
        let values = parsed(engine.values(&text));
        let values = values.as_array().expect("a list");
        assert_eq!(values.len(), digits.lines().count(), "{name}");
        for (value, line) in values.iter().zip(digits.lines()) {
            let words: Vec<&str> = line.split_whitespace().collect();
            assert_eq!([&value["name"], &value["value"]], [words[0], words[1]], "{name}");
        }
    }
}

#[test]
fn a_check_is_that_of_the_program() {
    let (text, form) = (read("examples/figure-2.json"), read("examples/paper-as-student.json"));
    let folder = scratch("engine-check");
    let (scene, values) = (folder.join("scene.json"), folder.join("values.json"));
    std::fs::write(&scene, &text).expect("it can be written");
    std::fs::write(&values, &form).expect("it can be written");
    let of = |json: &[&str]| {
        let arguments = [&["check", scene.to_str().expect("a path"), values.to_str().expect("a path")], json].concat();
        String::from_utf8(printed(&arguments, "")).expect("UTF-8")
    };
    let options = json!({ "marks": null, "pencil_mm": null, "pencil_degrees": null, "drawn": true }).to_string();
    let mut engine = Engine::new();
    let checked = parsed(engine.check(&text, &form, &options));
    assert_eq!(checked["report"], of(&[]));
    let result: Value = serde_json::from_str(&of(&["--json"])).expect("JSON");
    assert_eq!(checked["result"], result);
    let feedback = of(&["--feedback", folder.to_str().expect("a path"), "--feedback-format", "html"]);
    assert!(!feedback.is_empty());
    let page = std::fs::read_to_string(folder.join("values.html")).expect("a page");
    assert!(checked["feedback"] == *page, "the page for the student");
    let template = String::from_utf8(printed(&["check", "-", "--template"], &text)).expect("UTF-8");
    assert_eq!(parsed(engine.form(&text, ""))["json"], template);
}

#[test]
fn exercises_are_those_of_the_program() {
    let folder = scratch("engine-exercises");
    printed(&["exercise", "four-bar", "--seed", "7", "--count", "2", "-o", folder.to_str().expect("a path")], "");
    let (_, text) = starting_scenes().into_iter().find(|(name, _)| name == "four-bar").expect("it is there");
    let options = json!({ "page": null, "language": null, "notation": null, "decimal": null }).to_string();
    let mut engine = Engine::new();
    let exercise = parsed(engine.exercise(&text, "four-bar", 7.0, 2.0, &options));
    for (key, name) in [
        ("/text", "scene.json"),
        ("/sheets/0/svg", "sheet.svg"),
        ("/sheets/1/svg", "sheet-2.svg"),
        ("/sheets/2/svg", "sheet-3.svg"),
        ("/key/svg", "key.svg"),
        ("/form", "form.json"),
        ("/form_csv", "form.csv"),
        ("/key_values", "key.json"),
    ] {
        let expected = std::fs::read_to_string(folder.join("four-bar-7-2").join(name)).expect("it was written");
        assert!(exercise.pointer(key) == Some(&json!(expected)), "{name}");
    }
    assert_eq!(exercise["sheets"].as_array().map(Vec::len), Some(3));
    let sheet = engine.exercise_file(&text, "four-bar", 7.0, 2.0, &options, "sheet").expect("a sheet");
    assert!(sheet == std::fs::read(folder.join("four-bar-7-2/sheet.pdf")).expect("it was written"));
}

/// A gesture from the handle of a point by so many millimetres of paper, in small steps.
fn dragged(engine: &mut Engine, text: &str, what: &Value, by: [f64; 2]) -> (Value, String) {
    let view = json!({ "step": null, "coarse": false, "modes": false }).to_string();
    let picture = parsed(engine.grab(text, &view, &what.to_string()));
    let handles = picture["handles"].as_array().expect("a list");
    let handle = handles.iter().find(|handle| handle["name"] == what["point"]).expect("it can be held");
    let at = [0, 1].map(|axis| handle["at"][axis].as_f64().expect("a number"));
    let mut last = Value::Null;
    for part in [0.25, 0.5, 0.75, 1.0] {
        let to = [at[0] + part * by[0], at[1] + part * by[1]];
        last = parsed(engine.drag(&json!({ "to": to }).to_string()));
        assert_eq!([&last["width"], &last["height"]], [&picture["width"], &picture["height"]]);
    }
    (last, engine.let_go().expect("a text"))
}

#[test]
fn every_scene_can_be_moved_and_shaped() {
    let mut engine = Engine::new();
    for (name, text) in starting_scenes() {
        let opened = parsed(engine.open(&text));
        let Some(point) = opened["traceable"].as_array().and_then(|all| all.last()) else { continue };
        let is_driven = opened["drives"].as_array().is_some_and(|drives| !drives.is_empty());
        if is_driven {
            let (picture, moved) = dragged(&mut engine, &text, &json!({ "kind": "move", "point": point }), [6.0, -9.0]);
            let now = parsed(engine.open(&moved));
            let [shown, settled] = [&picture, &now].map(|of| of["drives"][0]["value"].as_f64().expect("a number"));
            let turns = ((shown - settled) / 360.0).round();
            let is_angle = opened["drives"][0]["is_angle"] == true;
            let off = if is_angle { shown - settled - 360.0 * turns } else { shown - settled };
            assert!(off.abs() < 0.1 + 1e-3 * shown.abs(), "{name}: {shown} became {settled}");
        }
        let pins = json!({ "points": [], "lengths": [] });
        let (_, shaped) =
            dragged(&mut engine, &text, &json!({ "kind": "shape", "point": point, "pins": pins }), [4.0, 3.0]);
        parsed(engine.open(&shaped));
    }
}

/// On a part of the screen the layout of a drive's whole motion stays when the hand lets go, and where undo leads back; that
/// of another shape is reached in steps.
#[test]
fn letting_go_of_a_drive_changes_nothing() {
    let mut engine = Engine::new();
    let pane = json!({ "width": 780, "height": 590, "letters": 14, "words": true });
    let view = json!({ "step": null, "coarse": false, "modes": false, "pane": pane }).to_string();
    let bars = |picture: &Value| -> Vec<String> {
        let svg = picture["svg"].as_str().expect("a picture");
        let bar = |line: &&str| line.contains("id=\"scale-");
        let bars = svg.lines().filter(bar).map(str::to_owned);
        // A shape that is pulled may leave its panel until the hand lets go.
        let panels = picture["panels"].to_string().replace("\"is_cut\":true", "\"is_cut\":false");
        bars.chain([panels]).collect()
    };
    for name in ["templates/watt-1.json", "templates/slotted-lever.json"] {
        let text = read(name);
        let first = parsed(engine.picture(&text, &view));
        assert!(bars(&first).len() > 3, "{name}: it has bars");
        let ratio = |side: &str| first[side].as_f64().expect("a side") / pane[side].as_f64().expect("a side");
        assert!((ratio("width") - ratio("height")).abs() < 1e-9, "{name}: other proportions than the pane's");
        parsed(engine.grab(&text, &view, &json!({ "kind": "drive", "drive": "1" }).to_string()));
        let mut drag = |value: f64| parsed(engine.drag(&json!({ "value": value }).to_string()));
        // At rest plans are larger; when a drive moves they come to the scales of the whole cycle, in their places.
        let held = (0..20).map(|k| drag(100.0 + 2.0 * f64::from(k))).last().expect("a picture");
        assert_eq!(held["panels"], first["panels"], "{name}");
        for value in [100.0, 170.0, 230.0] {
            assert_eq!(bars(&drag(value)), bars(&held), "{name}");
        }
        let moved = engine.let_go().expect("a text");
        assert_eq!(bars(&parsed(engine.picture(&moved, &view))), bars(&held), "{name}: it jumps");
        assert_eq!(parsed(engine.picture(&text, &view))["svg"], first["svg"], "{name}: undo leads elsewhere");
        // Another shape.
        let what = json!({ "kind": "shape", "point": "B", "pins": { "points": [], "lengths": [] } });
        let held = parsed(engine.grab(&text, &view, &what.to_string()));
        let handles = held["handles"].as_array().expect("a list");
        let at = &handles.iter().find(|handle| handle["name"] == "B").expect("it can be held")["at"];
        let to = [0, 1].map(|axis| at[axis].as_f64().expect("a number") + 6.0);
        let pulled = parsed(engine.drag(&json!({ "to": to }).to_string()));
        assert_eq!(bars(&pulled), bars(&first), "{name}: shaping");
        let shaped = engine.let_go().expect("a text");
        let eased = |engine: &mut Engine, share: f64| {
            let view = json!({ "step": null, "coarse": false, "modes": false, "pane": pane, "eased": share });
            bars(&parsed(engine.picture(&shaped, &view.to_string())))
        };
        assert_eq!(eased(&mut engine, 0.0), bars(&pulled), "{name}: it begins where the hand let go");
        let end = bars(&parsed(engine.picture(&shaped, &view)));
        assert_eq!(eased(&mut engine, 1.0), end, "{name}");
        assert!(eased(&mut engine, 0.5) != end && end != bars(&pulled), "{name}: another layout");
    }
}

#[test]
fn no_request_makes_it_panic() {
    let mut engine = Engine::new();
    let text = read("templates/four-bar.json");
    let good_text = text.as_str();
    let long = "x".repeat(4 << 20);
    let deep = "[".repeat(200_000);
    let list = format!("{{\"kinegon\":1,\"links\":{{{}}}}}", "\"1\":{},".repeat(300_000));
    let odd = ["", "{", "null", "[]", "7", "\"\u{0}\"", "\u{feff}", "{\"kinegon\":1}", &long, &deep, &list];
    let good = [
        json!({ "step": null, "coarse": false, "modes": false }),
        json!({ "format": "svg", "of": "figure" }),
        json!({ "kind": "move", "point": "C" }),
        json!({ "curves": [] }),
    ];
    let texts: Vec<&str> = odd.iter().copied().chain([text.as_str()]).collect();
    let requests = good.iter().map(Value::to_string).chain(odd.iter().map(|odd| (*odd).to_owned()));
    let requests: Vec<String> = requests.collect();
    let mut refused = 0;
    let mut told = |answer: Result<String, String>| {
        if let Err(why) = answer {
            assert!(is_refusal(&why), "{why}");
            refused += 1;
        }
    };
    let is_large = |text: &str| text.len() > 100_000;
    let is_all = Size::is_usual("large requests about texts that are refused without them");
    for text in &texts {
        // A large text is refused whatever is wanted of it.
        let is_good = *text == good_text;
        let is_tried = |request: &&String| match is_large(text) {
            true => request.len() < 5,
            false => is_all || is_good || !is_large(request),
        };
        for request in requests.iter().filter(is_tried) {
            let bytes = |answer: Result<Vec<u8>, String>| answer.map(|_| String::new());
            told(engine.open(text));
            told(engine.picture(text, request));
            told(engine.grab(text, request, request));
            told(engine.drag(request));
            told(engine.let_go());
            told(engine.edit(text, request));
            told(engine.modes(text));
            told(engine.curves(text, request, request));
            told(engine.values(text));
            told(bytes(engine.file(text, request)));
            told(engine.pages(text, request));
            told(engine.form(text, request));
            told(engine.check(text, request, request));
            told(engine.read_form(text, request));
        }
    }
    let numbers = [-1.0, 0.0, 0.5, f64::NAN, 1e9, 1e300, f64::INFINITY];
    for number in numbers.into_iter().step_by(KINDS.now()) {
        let view = json!({ "step": number, "coarse": true, "modes": true, "panels": ["none"] }).to_string();
        told(engine.picture(&text, &view));
        told(
            engine
                .file(&text, &json!({ "format": "svg", "of": { "step": number } }).to_string())
                .map(|_| String::new()),
        );
        told(
            engine
                .file(&text, &json!({ "format": "pdf", "of": { "worksheet": number } }).to_string())
                .map(|_| String::new()),
        );
        told(engine.choose_mode(&text, number));
        told(engine.exercise(&text, "x", number, number, "{}"));
        told(engine.grab(&text, &good[0].to_string(), &good[2].to_string()));
        told(engine.drag(&json!({ "to": [number, -number] }).to_string()));
        told(engine.drag(&json!({ "value": number }).to_string()));
        told(engine.let_go());
        let options =
            json!({ "marks": null, "pencil_mm": number, "pencil_degrees": number, "drawn": true }).to_string();
        told(engine.check(&text, &read("examples/paper-as-student.json"), &options));
    }
    assert!(refused > 100);
    for case in support::files::refused("tests/bad_scenes.txt") {
        assert!(is_refusal(&engine.open(&case.text).expect_err("a bad scene")));
    }
}

#[test]
fn a_refusal_has_its_place_in_utf_16() {
    let text = "{ \"kinegon\": 1, \"title\": \"𝄞𝄞 ω\", \"linkz\": {} }";
    let refused: Value = serde_json::from_str(&Engine::new().open(text).expect_err("no scene")).expect("JSON");
    let units: Vec<u16> = text.encode_utf16().collect();
    let [from, to] = ["from", "to"].map(|key| refused[key].as_u64().expect("a place") as usize);
    assert_eq!(String::from_utf16_lossy(&units[from..to]), "\"linkz\"", "{refused}");
}
