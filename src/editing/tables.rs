//! Tables of loads that a scene's text leaves to files beside it.

use super::document::Document;
use crate::scene::SceneError;
use serde_json::Value as Json;

/// A load whose table over an angle or a position stands in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableInFile {
    /// Its index among the forces of the scene.
    pub load: usize,
    /// Its name, if the text gives it one.
    pub name: Option<String>,
    /// The path of the file, as the text has it.
    pub path: String,
}

/// The loads of a text whose tables stand in files; none of a text that is no JSON.
#[must_use]
pub fn tables_in_files(text: &str) -> Vec<TableInFile> {
    // Most scenes have none, and are not parsed for it.
    if !text.contains("\"table\"") {
        return Vec::new();
    }
    let Ok(document) = Document::new(text) else { return Vec::new() };
    let scene = document.json();
    let forces = scene["forces"].as_array().into_iter().flatten();
    let table = |(load, force): (usize, &Json)| {
        let path = force["over"]["table"].as_str()?.to_owned();
        Some(TableInFile { load, name: force["name"].as_str().map(str::to_owned), path })
    };
    forces.enumerate().filter_map(table).collect()
}

/// A text with these lines in place of the name of the file with the table of the load of this index: each a place and a factor.
///
/// # Errors
/// The text is no JSON.
pub fn with_table(text: &str, load: usize, lines: &[[f64; 2]]) -> Result<String, SceneError> {
    let mut document = Document::new(text)?;
    let lines = lines.iter().map(|line| Json::from(line.to_vec())).collect();
    document.set(&["forces", &load.to_string(), "over", "table"], &Json::Array(lines))?;
    Ok(document.text())
}
