//! Texts of strangers: every change gives JSON or an error that can be shown.

use super::position;
use kinegon::editing::{
    Along, Edit, Key, Named, NewLink, NewPoint, NewSlider, Pins, PlacedPoint, Reshape, apply, with_mode, with_position,
};
use kinegon::scene::SceneError;
use serde_json::{Value, json};
use support::files::{list, path, read, refused, templates};

/// Makes all kinds of changes of a text.
fn change(text: &str) {
    let can_be_shown = |error: SceneError| {
        let span = error.place.as_ref().map(|place| place.span.clone());
        assert!(span.is_none_or(|span| text.get(span).is_some()), "the span of {error} is not in the text");
        let message = error.message.to_string();
        assert!(!message.is_empty() && !message.contains('\n'), "{message:?}");
    };
    for edit in edits() {
        match apply(text, std::slice::from_ref(&edit)) {
            Ok(new) => {
                let body = new.strip_prefix('\u{feff}').unwrap_or(&new);
                assert!(serde_json::from_str::<serde::de::IgnoredAny>(body).is_ok(), "{edit:?}\n{text}\n{new}");
            }
            Err(error) => can_be_shown(error),
        }
    }
    for point in ["A", "B", "C", "D"] {
        match Reshape::new(
            text,
            point,
            &Pins { points: vec!["E".to_owned()], lengths: vec!["2.BC".to_owned(), "1.angle".to_owned()] },
        ) {
            Ok(pull) => _ = pull.to([30.0, 20.0]).map_err(can_be_shown),
            Err(error) => can_be_shown(error),
        }
    }
    _ = with_mode(text, 2).map_err(can_be_shown);
    if let Ok((_, _, pose)) = position(text) {
        _ = with_position(text, &pose).map_err(can_be_shown);
    }
}

fn edits() -> Vec<Edit> {
    let set = |path: &[&str], value: Value| Edit::Set { set: path.iter().map(|&key| Key::from(key)).collect(), value };
    let placed = |name: &str, at| PlacedPoint { name: name.to_owned(), at };
    let link = |points: Vec<PlacedPoint>| Edit::AddLink { add_link: NewLink { points } };
    let point =
        |link: &str, at| Edit::AddPoint { add_point: NewPoint { link: link.to_owned(), name: "Q".to_owned(), at } };
    let slider = |link: &str, on: &str, along| Edit::AddSlider {
        add_slider: NewSlider { link: link.to_owned(), at: "B".to_owned(), on: on.to_owned(), along },
    };
    let rename = |rename, from: &str, to: &str| Edit::Rename { rename, from: from.to_owned(), to: to.to_owned() };
    vec![
        set(&["links", "2", "lengths", "BC"], json!(3)),
        set(&["links"], json!({ "1": ["A"], "x": { "y": [1, { "z": null }] } })),
        set(&["sliders", "0", "on"], json!("x")),
        set(&[], json!({ "kinegon": 1 })),
        set(&[], json!(1)),
        Edit::Remove { remove: vec!["links".into(), Key::Index(1)] },
        Edit::Remove { remove: vec![] },
        rename(Named::Point, "B", "Q"),
        rename(Named::Point, "A", "B"),
        rename(Named::Link, "1", "9"),
        rename(Named::Link, "3", "\u{1}"),
        link(vec![placed("B", [1.0, 2.0]), placed("Q", [30.0, 4.0])]),
        link(vec![placed("Q", [1e300, 2.0]), placed("R", [f64::NAN, 4.0]), placed("S", [0.0, 0.0])]),
        link(vec![placed("Q", [1.0, 2.0]), placed("R", [3.0, 4.0]), placed("T", [5.0, 0.0]), placed("U", [5.0, 9.0])]),
        point("1", [1.0, 2.0]),
        point("2", [1.0, 2.0]),
        point("3", [f64::INFINITY, 2.0]),
        point("ground", [1e-300, 2.0]),
        slider("2", "ground", Along::Degrees(30.0)),
        slider("", "3", Along::Degrees(f64::NAN)),
        slider("1", "3", Along::Points("DC".to_owned())),
        Edit::DropLink { drop_link: "2".to_owned() },
        Edit::DropLink { drop_link: "3".to_owned() },
        Edit::DropPoint { drop_point: "B".to_owned() },
        Edit::DropPoint { drop_point: "D".to_owned() },
    ]
}

/// The text with each of its values in turn replaced by others.
fn each_value_replaced(whole: &Value, path: &mut Vec<String>, seen: &mut usize, take: &mut dyn FnMut(&Value)) {
    let here = path.iter().fold(whole, |value, key| match value {
        Value::Array(elements) => &elements[key.parse::<usize>().expect("an index")],
        other => &other[key],
    });
    if !path.is_empty() {
        let others = [
            json!(null),
            json!([]),
            json!({}),
            json!("B"),
            json!(-1e300),
            json!(["A", "B"]),
            json!({ "A": [1, 2], "B": 0 }),
        ];
        let mut changed = whole.clone();
        let pointer =
            path.iter().map(|key| format!("/{}", key.replace('~', "~0").replace('/', "~1"))).collect::<String>();
        *changed.pointer_mut(&pointer).expect("it is there") = others[*seen % others.len()].clone();
        *seen += 1;
        take(&changed);
    }
    let keys: Vec<String> = match here {
        Value::Object(entries) => entries.keys().cloned().collect(),
        Value::Array(elements) => (0..elements.len()).map(|index| index.to_string()).collect(),
        _ => return,
    };
    for key in keys {
        path.push(key);
        each_value_replaced(whole, path, seen, take);
        path.pop();
    }
}

#[test]
fn broken_scenes_are_changed_or_refused() {
    refused("tests/bad_scenes.txt").iter().for_each(|case| change(&case.text));
    for file in list("tests/fuzzed").into_iter().filter(|file| file.ends_with(".json")) {
        let bytes = std::fs::read(path(&format!("tests/fuzzed/{file}"))).expect("it can be read");
        // Those that take long to solve are tried elsewhere.
        if !["modes_without_end.json", "doubled_link.json"].contains(&file.as_str()) {
            change(&String::from_utf8_lossy(&bytes));
        }
    }
}

#[test]
fn scenes_with_a_wrong_value_are_changed_or_refused() {
    let mut seen = 0;
    let kinds = ["four-bar", "slotted-lever", "dyad-rpr", "hydraulic-boom"];
    for (_, text) in templates().into_iter().filter(|(name, _)| kinds.contains(&name.as_str())) {
        let whole: Value = serde_json::from_str(&text).expect("JSON");
        each_value_replaced(&whole, &mut Vec::new(), &mut seen, &mut |changed| change(&changed.to_string()));
    }
    assert!(seen > 200, "{seen}");
}

#[test]
fn half_a_text_is_refused() {
    let text = read("templates/slotted-lever.json");
    for end in (0..text.len()).filter(|end| text.is_char_boundary(*end)).step_by(7) {
        change(&text[..end]);
    }
}
