use super::solvable;
use kinegon::editing::{Edit, Key, apply};
use serde_json::{Value, json};

fn set(text: &str, path: &[&str], value: Value) -> String {
    let set = path.iter().map(|&part| Key::from(part)).collect();
    apply(text, &[Edit::Set { set, value }]).unwrap_or_else(|error| panic!("{path:?}: {error}"))
}

/// The paths and values of all leaves.
fn leaves(value: &Value, path: &mut Vec<String>, found: &mut Vec<(Vec<String>, Value)>) {
    let parts: Vec<(String, &Value)> = match value {
        Value::Object(entries) => entries.iter().map(|(key, value)| (key.clone(), value)).collect(),
        Value::Array(elements) => elements.iter().enumerate().map(|(i, value)| (i.to_string(), value)).collect(),
        _ => return found.push((path.clone(), value.clone())),
    };
    for (key, value) in parts {
        path.push(key);
        leaves(value, path, found);
        path.pop();
    }
}

#[test]
fn a_value_set_and_set_back_gives_the_same_text() {
    let mut seen = 0;
    for (name, text) in solvable() {
        let json: Value = serde_json::from_str(&text).expect("JSON");
        let mut found = Vec::new();
        leaves(&json, &mut Vec::new(), &mut found);
        for (path, value) in found {
            let path: Vec<&str> = path.iter().map(String::as_str).collect();
            let other = if value == json!(17.5) { json!(18.5) } else { json!(17.5) };
            let changed = set(&text, &path, other.clone());
            assert_ne!(changed, text, "{name} {path:?}");
            let now: Value = serde_json::from_str(&changed).expect("JSON");
            assert_eq!(path.iter().fold(&now, |value, key| at(value, key)), &other, "{name} {path:?}");
            let back = set(&changed, &path, value.clone());
            // serde_json reads some numbers of 17 digits, and writes needless zeros, otherwise than they stand.
            let written = value.to_string();
            if text
                .match_indices(&written)
                .any(|(at, _)| !text[at + written.len()..].starts_with(|c: char| c.is_ascii_digit() || c == '.'))
            {
                assert_eq!(back, text, "{name} {path:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 1000, "{seen}");
}

fn at<'v>(value: &'v Value, key: &str) -> &'v Value {
    match value {
        Value::Array(elements) => &elements[key.parse::<usize>().expect("an index")],
        other => &other[key],
    }
}

#[test]
fn an_entry_added_and_removed_gives_the_same_text() {
    for (name, text) in solvable() {
        let json: Value = serde_json::from_str(&text).expect("JSON");
        let places: Vec<Vec<&str>> =
            vec![vec!["note"], vec!["figure", "language"], vec!["units", "note"], vec!["title"]];
        let links = json["links"].as_object().expect("links").iter();
        let links = links.filter(|(_, link)| link.is_object()).map(|(link, _)| vec!["links", link, "drive"]);
        for place in places.into_iter().chain(links).filter(|place| place.iter().fold(&json, |v, k| &v[*k]).is_null()) {
            let with = set(&text, &place, json!("es"));
            let removes_whole = place.len() == 2 && json[place[0]].is_null();
            let back = set(&with, if removes_whole { &place[..1] } else { &place }, Value::Null);
            assert_eq!(back, text, "{name} {place:?}\n{with}");
            let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
            let kept = lines(&text).into_iter().filter(|line| lines(&with).contains(line)).count();
            assert!(kept + 2 >= lines(&text).len(), "{name} {place:?}\n{with}");
        }
    }
}

#[test]
fn new_keys_stand_where_people_write_them() {
    let text = r#"{
  "kinegon": 1,
  "units": { "length": "mm", "time": "s" },
  "links": {
    "1": { "points": ["A", "B"],
           "drive": { "angle": 60, "omega": 10 } }
  },
  "figure": { "mu_l": 2 }
}
"#;
    let with = set(text, &["links", "1", "lengths", "AB"], json!(60));
    let with = set(&with, &["near", "C"], json!([1, 2.5]));
    let with = set(&with, &["ground"], json!({ "A": [0, 0] }));
    let with = set(&with, &["links", "2"], json!({ "points": ["B", "C"] }));
    let with = set(&with, &["sliders"], json!([]));
    let with = set(&with, &["sliders", "0"], json!({ "pin": "C", "on": "ground" }));
    let with = set(&with, &["links", "1", "drive", "alpha"], json!(3));
    let with = set(&with, &["links", "1", "drive", "omega"], Value::Null);
    let expected = r#"{
  "kinegon": 1,
  "units": { "length": "mm", "time": "s" },
  "ground": { "A": [0, 0] },
  "links": {
    "1": { "points": ["A", "B"], "lengths": { "AB": 60 },
           "drive": { "angle": 60, "alpha": 3 } },
    "2": { "points": ["B", "C"] }
  },
  "sliders": [
    { "pin": "C", "on": "ground" }
  ],
  "near": { "C": [1, 2.5] },
  "figure": { "mu_l": 2 }
}
"#;
    assert_eq!(with, expected);
    // The last one.
    assert_eq!(
        set(&with, &["links", "2"], Value::Null),
        set(&with, &["links"], json!({ "1": serde_json::from_str::<Value>(&with).expect("JSON")["links"]["1"] }))
    );
}

#[test]
fn what_a_change_does_not_mean_stays() {
    let text = "\u{feff}{\r\n\t\"kinegon\" : 1.0,\r\n\t\"links\": {\"1\":  {\"points\":[\"A\",\"B\"] , \"note\": \"x\"}}\r\n}\r\n";
    let with = set(text, &["links", "1"], json!({ "points": ["A", "C", "D"], "drive": { "omega": 1 } }));
    assert_eq!(
        with,
        text.replace(r#""A","B"]"#, r#""A","C","D"]"#)
            .replace(", \"note\"", ", \"drive\": {\"omega\": 1}, \"note\"")
            .replace("] , \"drive\"", "], \"drive\"")
            .replace("}, \"note\"", "} , \"note\"")
    );
    assert!(with.contains("\"kinegon\" : 1.0,\r\n"));
    let with = set(text, &["title"], json!("t"));
    assert!(with.contains("1.0,\r\n\t\"title\": \"t\",\r\n\t\"links\""), "{with}");
}

#[test]
fn texts_that_are_no_scenes_are_edited_or_refused() {
    let edit = |text: &str, path: &[&str]| {
        let set = path.iter().map(|&part| Key::from(part)).collect();
        apply(text, &[Edit::Set { set, value: json!([1, { "a": 2 }]) }])
    };
    assert_eq!(edit("{}", &["a", "b"]).expect("an object"), r#"{ "a": { "b": [1, { "a": 2 }] } }"#);
    assert_eq!(edit("{\"a\":{}}", &["a", "b"]).expect("an object"), r#"{"a":{"b":[1,{"a":2}]}}"#);
    for (text, path, message) in [
        ("", ["a", "b"], "the scene is empty"),
        ("[]", ["a", "b"], "a scene is an object"),
        ("{ \"a\": 1 }", ["a", "b"], "there is no place for `b` here"),
        ("{ \"a\": [1] }", ["a", "2"], "this list has 1 entries, and no `2`"),
        ("{ \"a\": ", ["a", "2"], ""),
    ] {
        let error = edit(text, &path).expect_err(text);
        assert!(error.message.to_string().starts_with(message), "{text}: {error}");
    }
}

#[test]
fn edits_are_read_as_the_page_writes_them() {
    let edits: Vec<Edit> = serde_json::from_value(json!([
        { "set": ["links", 1, "lengths", "AB"], "value": 3 },
        { "set": ["near"] },
        { "remove": ["figure"] },
        { "rename": "point", "from": "A", "to": "E" },
        { "rename": "link", "from": "1", "to": "4" },
        { "add_link": { "points": [{ "name": "P", "at": [1, 2] }] } },
        { "add_point": { "link": "4", "name": "Q", "at": [1.5, 2] } },
        { "add_slider": { "link": "2", "at": "P", "on": "ground", "along": 30 } },
        { "add_slider": { "link": "2", "at": "P", "on": "ground", "along": "AB" } },
        { "drop_link": "2" },
        { "drop_point": "P" }
    ]))
    .expect("all of them");
    let names: Vec<String> =
        edits.iter().map(|edit| format!("{edit:?}").split(' ').next().expect("a name").to_owned()).collect();
    let expected = [
        "Set",
        "Set",
        "Remove",
        "Rename",
        "Rename",
        "AddLink",
        "AddPoint",
        "AddSlider",
        "AddSlider",
        "DropLink",
        "DropPoint",
    ];
    assert_eq!(names, expected);
    let text = r#"{ "links": { "1": { "lengths": { "AB": 2 } } }, "near": {} }"#;
    assert_eq!(apply(text, &edits[..2]).expect("JSON"), r#"{ "links": { "1": { "lengths": { "AB": 3 } } } }"#);
}
