//! Tables of loads: those that a scene's text leaves to files beside it, and the lines of such a file.

use super::document::Document;
use super::says;
use crate::Problem;
use crate::message::Message;
use crate::scene::{Gauge, SceneError};
use crate::text::shown;
use csv::{ReaderBuilder, StringRecord, Trim};
use indexmap::IndexMap;
use serde_json::Value as Json;
use std::ops::Range;

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
    /// The unit of its places: `°`, or the scene's unit of length; `None` where the text does not say what the load changes over.
    pub unit: Option<String>,
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
        let over = &force["over"];
        let path = over["table"].as_str()?.to_owned();
        let unit = match over["of"].as_str().and_then(Gauge::parse) {
            Some(Gauge::Angle(_)) => Some("°"),
            Some(Gauge::Position(_)) => scene["units"]["length"].as_str(),
            None => None,
        };
        Some(TableInFile { load, name: force["name"].as_str().map(str::to_owned), path, unit: unit.map(str::to_owned) })
    };
    forces.enumerate().filter_map(table).collect()
}

/// Where the lines of a table stand in a text in place of the name of its file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PutTable {
    /// The bytes of the name, in the text that has it.
    pub name: Range<usize>,
    /// The bytes of the lines, in the text that has these.
    pub lines: Range<usize>,
}

/// A text with lines in place of the names of the files with the tables of the loads of these indices, each line a place and a factor; and where
/// they stand, in the order of the text.
///
/// # Errors
/// The text is no JSON.
pub fn with_tables(text: &str, tables: &[(usize, Vec<[f64; 2]>)]) -> Result<(String, Vec<PutTable>), SceneError> {
    let mut document = Document::new(text)?;
    let lines = |lines: &[[f64; 2]]| Json::Array(lines.iter().map(|line| Json::from(line.to_vec())).collect());
    let path = |load: usize| ["forces", &load.to_string(), "over", "table"].map(str::to_owned).to_vec();
    let values: Vec<(Vec<String>, Json)> = tables.iter().map(|(load, table)| (path(*load), lines(table))).collect();
    let put = document.put_all(&values);
    Ok((document.text(), put.into_iter().map(|[name, lines]| PutTable { name, lines }).collect()))
}

/// A file with tables of loads as a test stand or a spreadsheet writes it: places in the first column, the factors of a load in the second of two,
/// or of more in that with its name.
///
/// Cells are separated by semicolons or tabs, or else by commas; with semicolons and tabs numbers may have decimal commas. A first line
/// in which no cell is like a number names the columns. Every other line is of numbers.
#[derive(Clone, Debug)]
pub struct TableFile {
    mark: char,
    /// Lines with a cell that is not empty, each with its number.
    lines: Vec<(usize, StringRecord)>,
    /// The cells of the first line with their columns.
    first: IndexMap<String, usize>,
}

impl TableFile {
    /// The file of a text.
    ///
    /// # Errors
    /// There is no second column, or there are more than 10 000 lines.
    pub fn read(text: &str) -> Result<TableFile, Problem> {
        let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace('\r', "\n");
        let mut first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
        // Some spreadsheets say in a line of its own which mark they use.
        let told = first.trim().trim_matches('"').strip_prefix("sep=").and_then(|rest| rest.chars().next());
        if told.is_some() {
            first = text.lines().filter(|line| !line.trim().is_empty()).nth(1).unwrap_or_default();
        }
        let mark = [';', '\t'].into_iter().find(|&mark| first.contains(mark)).unwrap_or(',');
        let mut reader = ReaderBuilder::new();
        reader.has_headers(false).flexible(true).trim(Trim::All).delimiter(mark as u8);
        let mut lines = Vec::new();
        for record in reader.from_reader(text.as_bytes()).records() {
            let Ok(record) = record else { continue };
            let line = record.position().map_or(0, |at| at.line() as usize);
            if record.iter().all(str::is_empty) || (told.is_some() && lines.is_empty() && record[0].contains("sep=")) {
                continue;
            }
            // A quotation mark that is never closed would take all that follows into one cell.
            if let Some(column) = record.iter().position(|cell| cell.contains('\n')) {
                return Err(wrong(says::table_no_number(line, column + 1), says::table_line()));
            }
            lines.push((line, record));
            if lines.len() > MOST_LINES + 1 {
                return Err(wrong(says::table_long(MOST_LINES), says::table_shorten()));
            }
        }
        let mut first = IndexMap::new();
        for (column, cell) in lines.first().iter().flat_map(|(_, record)| record.iter().enumerate()) {
            first.entry(plain(cell).to_owned()).or_insert(column);
        }
        Ok(TableFile { mark, lines, first })
    }

    /// The lines of the table of a load, each a place and a factor, with their numbers in the file; places may have this unit behind them.
    ///
    /// # Errors
    /// A cell is no number, a line has more cells than the first, or there is no column of the load.
    pub fn table(&self, load: Option<&str>, unit: Option<&str>) -> Result<Vec<(usize, [f64; 2])>, Problem> {
        let Some((_, first)) = self.lines.first() else { return Ok(Vec::new()) };
        // The name of a load may begin with a digit.
        let names_load = || !is_like_a_number(&first[0]) && load.is_some_and(|load| self.first.contains_key(load));
        let is_head = !first.iter().any(is_like_a_number) || names_load();
        let column = self.column_of(load, first.len(), is_head)?;
        let number = |cell: &str, unit: Option<&str>| number(plain(cell), self.mark, unit);
        let mut table = Vec::new();
        for (index, (line, record)) in self.lines.iter().enumerate().skip(usize::from(is_head)) {
            let hint = || if index == 0 { says::table_first() } else { says::table_line() };
            let cell = |column: usize, unit: Option<&str>| {
                let found = record.get(column).and_then(|cell| number(cell, unit));
                found.ok_or_else(|| wrong(says::table_no_number(*line, column + 1), hint()))
            };
            if record.iter().skip(first.len()).any(|cell| !cell.is_empty()) {
                return Err(wrong(says::table_more_cells(*line, record.len(), first.len()), says::table_marks()));
            }
            table.push((*line, [cell(0, unit)?, cell(column, None)?]));
        }
        match table.len() > MOST_LINES {
            true => Err(wrong(says::table_long(MOST_LINES), says::table_shorten())),
            false => Ok(table),
        }
    }

    /// The column of a load.
    fn column_of(&self, load: Option<&str>, columns: usize, is_head: bool) -> Result<usize, Problem> {
        match columns {
            0 | 1 => Err(wrong(says::table_one_column(), says::table_line())),
            2 => Ok(1),
            _ if !is_head => Err(wrong(says::table_unnamed(), says::table_head())),
            _ => {
                let found = load.and_then(|load| self.first.get(load).filter(|column| **column > 0));
                let without = || match load {
                    Some(load) => says::table_no_column(shown(load)),
                    None => says::table_nameless(),
                };
                found.copied().ok_or_else(|| wrong(without(), says::table_name()))
            }
        }
    }
}

/// The lines of a load's table in a file of this text: see [`TableFile`].
///
/// # Errors
/// Those of [`TableFile::read`] and [`TableFile::table`].
pub fn lines_of_table(text: &str, load: Option<&str>) -> Result<Vec<[f64; 2]>, Problem> {
    let lines = TableFile::read(text)?.table(load, None)?;
    Ok(lines.into_iter().map(|(_, line)| line).collect())
}

fn wrong(message: Message, hint: Message) -> Problem {
    Problem { message, hint: Some(hint) }
}

/// A cell without marks of quotation that stand behind a space.
fn plain(cell: &str) -> &str {
    cell.trim_matches('"').trim()
}

/// Whether a cell may have been meant as a number: it is one, or its first letter or digit is a digit, as in `10°`, `−10`, `(10)` or `1.234,5`.
fn is_like_a_number(cell: &str) -> bool {
    let cell = plain(cell);
    cell.parse::<f64>().is_ok() || cell.chars().find(|c| c.is_alphanumeric()).is_some_and(char::is_numeric)
}

/// The number in a cell, with a hyphen or a minus sign, and perhaps this unit behind it.
fn number(cell: &str, mark: char, unit: Option<&str>) -> Option<f64> {
    let words = unit.map(|unit| [unit, if unit == "°" { "deg" } else { unit }]);
    let bare = words.into_iter().flatten().find_map(|unit| cell.strip_suffix(unit)).map_or(cell, str::trim_end);
    let digits = bare.replace('−', "-");
    let digits = if mark == ',' { digits } else { digits.replace(',', ".") };
    digits.parse().ok().filter(|x: &f64| x.is_finite())
}
