//! Sheets of five mechanisms drawn by an independent program, each with one mistake on purpose: the check names it.
//! `tests/mistakes/sheets.json` has them, `made` says in words what was done there, `told` what the sentence must hold.

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
    /// What its sentence must hold: the place.
    told: String,
    form: Value,
}

/// The mistakes of each explanation that fits best, or as well as that: their names and sentences.
fn told(sheet: &Sheet) -> Vec<Vec<(String, String)>> {
    let scene = files::path(&format!("tests/mistakes/{}.json", sheet.scene));
    let scene = scene.to_str().expect("its name is text");
    let output = with_scene(&["check", scene, "-", "--json"], sheet.form.to_string().as_bytes());
    let result: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let alike = |other: &&Value| other["indistinguishable"] == true;
    let others = result["others"].as_array().into_iter().flatten().filter(alike);
    let mistakes = |explanation: &Value| {
        let all = explanation["mistakes"].as_array().expect("a list");
        all.iter()
            .map(|m| [&m["mistake"], &m["done"]].map(|text| text.as_str().unwrap_or("").to_owned()).into())
            .collect()
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
        let is_it = |(name, done): &(String, String)| *name == sheet.mistake && done.contains(&sheet.told);
        if !told.iter().any(|mistakes| mistakes.len() == 1 && mistakes.iter().all(is_it)) {
            wrong.push(format!("{}, {}: {told:?}", sheet.scene, sheet.made));
        }
    }
    assert!(sheets.len() > 30, "only {} sheets", sheets.len());
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), sheets.len(), wrong.join("\n"));
}
