//! Sheets of five mechanisms drawn by an independent program, each with one mistake on purpose: the check names it,
//! in these words. `tests/mistakes/sheets.json` has them; `made` says what was done there, and somebody has read that `done` and `should_be` say it.

use serde::Deserialize;
use serde_json::Value;
use support::files;
use support::program::with_scene;

#[derive(Deserialize)]
struct Sheet {
    /// The scene beside the sheets.
    scene: String,
    /// What was done, in words.
    made: String,
    /// The mistake's name in the catalogue.
    mistake: String,
    /// What is told of it, in English.
    done: String,
    /// What should be, in English.
    should_be: String,
    form: Value,
}

/// The mistakes of each explanation that fits best, or as well as that: their names, what was done and what should be.
fn told(sheet: &Sheet) -> Vec<Vec<[String; 3]>> {
    let scene = files::path(&format!("tests/mistakes/{}.json", sheet.scene));
    let scene = scene.to_str().expect("its name is text");
    let output = with_scene(&["check", scene, "-", "--json"], sheet.form.to_string().as_bytes());
    let result: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let alike = |other: &&Value| other["indistinguishable"] == true;
    let others = result["others"].as_array().into_iter().flatten().filter(alike);
    let mistakes = |explanation: &Value| {
        let all = explanation["mistakes"].as_array().expect("a list");
        let parts = all.iter().map(|m| [&m["mistake"], &m["done"], &m["should_be"]]);
        parts.map(|parts| parts.map(|text| text.as_str().unwrap_or("").to_owned())).collect()
    };
    core::iter::once(&result["diagnosis"]).chain(others).map(mistakes).collect()
}

#[test]
fn each_mistake_is_named_alone_and_at_its_place() {
    let text = files::read("tests/mistakes/sheets.json");
    let sheets: Vec<Sheet> = serde_json::from_str(&text).expect("good sheets");
    let mut wrong: Vec<String> = Vec::new();
    for sheet in &sheets {
        let told = told(sheet);
        let expected = [&sheet.mistake, &sheet.done, &sheet.should_be].map(String::clone);
        if !told.contains(&vec![expected]) {
            wrong.push(format!("{}, {}: {told:?}", sheet.scene, sheet.made));
        }
    }
    assert!(sheets.len() > 30, "only {} sheets", sheets.len());
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), sheets.len(), wrong.join("\n"));
}
