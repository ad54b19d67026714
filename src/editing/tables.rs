//! Tables of loads: those that a scene's text leaves to files beside it, and the lines of such a file.

use super::document::Document;
use super::says;
use crate::Problem;
use crate::message::Message;
use crate::scene::SceneError;
use crate::text::shown;
use serde_json::Value as Json;

/// More lines than any diagram has.
const MOST_LINES: usize = 10_000;

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

/// The lines of a load's table as a test stand or a spreadsheet writes it: the first column, and that of the load, which is the second of
/// two, of more that with its name.
///
/// Cells are separated by semicolons or tabs, or else by commas; with semicolons and tabs numbers may have decimal commas. A first line without
/// numbers names the columns.
///
/// # Errors
/// A cell is no number, there is no column of the load, or there are more than 10 000 lines.
pub fn lines_of_table(text: &str, load: Option<&str>) -> Result<Vec<[f64; 2]>, Problem> {
    let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace('\r', "\n");
    let mut filled = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()).peekable();
    let Some((_, first)) = filled.peek().copied() else { return Ok(Vec::new()) };
    let mark = [';', '\t'].into_iter().find(|&mark| first.contains(mark)).unwrap_or(',');
    let number = |cell: &str| {
        let cell = if mark == ',' { cell.to_owned() } else { cell.replace(',', ".") };
        cell.parse::<f64>().ok().filter(|x| x.is_finite())
    };
    let head = cells(first, mark);
    let is_head = number(head[0]).is_none();
    let column = column_of(load, &head, is_head)?;
    let mut lines = Vec::new();
    for (index, line) in filled.skip(usize::from(is_head)) {
        let cells = cells(line, mark);
        let at = |column: usize| {
            let found = cells.get(column).and_then(|cell| number(cell));
            found.ok_or_else(|| wrong(says::table_no_number(index + 1, column + 1), says::table_line()))
        };
        lines.push([at(0)?, at(column)?]);
        if lines.len() > MOST_LINES {
            return Err(wrong(says::table_long(MOST_LINES), says::table_shorten()));
        }
    }
    Ok(lines)
}

fn wrong(message: Message, hint: Message) -> Problem {
    Problem { message, hint: Some(hint) }
}

fn cells(line: &str, mark: char) -> Vec<&str> {
    line.split(mark).map(|cell| cell.trim().trim_matches('"').trim()).collect()
}

/// The column of a load.
fn column_of(load: Option<&str>, cells: &[&str], is_head: bool) -> Result<usize, Problem> {
    match cells.len() {
        0 | 1 => Err(wrong(says::table_one_column(), says::table_line())),
        2 => Ok(1),
        _ if !is_head => Err(wrong(says::table_unnamed(), says::table_head())),
        _ => {
            let found = load.and_then(|load| cells.iter().skip(1).position(|cell| *cell == load));
            let without = || match load {
                Some(load) => says::table_no_column(shown(load)),
                None => says::table_nameless(),
            };
            found.map(|index| index + 1).ok_or_else(|| wrong(without(), says::table_name()))
        }
    }
}
