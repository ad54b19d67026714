//! Tables of loads in files beside a scene, as an indicator diagram over a crank's angle: read here, and written into the scene's text.

use super::files::{is_below, read_form};
use super::message::{Failure, Source, refuse};
use crate::editing::{TableInFile, tables_in_files, with_table};
use crate::text::shown;
use std::path::Path;

/// More lines than any diagram has.
const MOST_LINES: usize = 10_000;

/// A scene's text with the tables that it leaves to files, whose paths are from its folder.
pub(super) fn with_tables(mut source: Source, scene: &Path) -> Result<Source, Failure> {
    let folder = scene.parent().filter(|_| scene != Path::new("-")).unwrap_or(Path::new(""));
    for given in tables_in_files(&source.text) {
        let path = folder.join(&given.path);
        // Somebody else's scene may name any file: nothing outside of its folder is read.
        if path.exists() && !is_below(&path, folder) {
            let message = format!("{}, which the scene names as a table, is outside of its folder", path.display());
            return refuse(message, "put the table beside the scene");
        }
        let file = read_form(&path)?;
        let lines = lines_of(&file, &given)?;
        source.text = source.checked(with_table(&source.text, given.load, &lines))?;
    }
    Ok(source)
}

/// The lines of a table: the first column, and that of the load.
///
/// Cells are separated by semicolons or tabs, or else by commas; with semicolons and tabs numbers may have decimal commas. A first line without
/// numbers names the columns.
fn lines_of(file: &Source, given: &TableInFile) -> Result<Vec<[f64; 2]>, Failure> {
    let text = file.text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace('\r', "\n");
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or("");
    let mark = [';', '\t'].into_iter().find(|&mark| first.contains(mark)).unwrap_or(',');
    let cells = |line: &str| -> Vec<String> {
        line.split(mark).map(|cell| cell.trim().trim_matches('"').trim().to_owned()).collect()
    };
    let number = |cell: &str| {
        let cell = if mark == ',' { cell.to_owned() } else { cell.replace(',', ".") };
        cell.parse::<f64>().ok().filter(|x| x.is_finite())
    };
    let (mut column, mut lines) = (None, Vec::new());
    for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let cells = cells(line);
        let column = match column {
            Some(column) => column,
            None => {
                let is_head = number(&cells[0]).is_none();
                let found = column_of(file, given, &cells, is_head)?;
                column = Some(found);
                if is_head {
                    continue;
                }
                found
            }
        };
        let at = |column: usize| {
            let found = cells.get(column).and_then(|cell| number(cell));
            let message = || format!("{}: line {}, column {}: there is no number", file.name, index + 1, column + 1);
            found.map_or_else(|| refuse(message(), "write a place and a factor in every line, as `90,1500`"), Ok)
        };
        lines.push([at(0)?, at(column)?]);
        if lines.len() > MOST_LINES {
            return refuse(
                format!("{} has more than {MOST_LINES} lines", file.name),
                "leave out lines that a straight line gives as well",
            );
        }
    }
    Ok(lines)
}

/// The column of a load: the second one of two, of more that with its name.
fn column_of(file: &Source, given: &TableInFile, cells: &[String], is_head: bool) -> Result<usize, Failure> {
    let name = given.name.as_deref().unwrap_or_default();
    match cells.len() {
        0 | 1 => refuse(
            format!("{} has no second column", file.name),
            "write a place and a factor in every line, as `90,1500`",
        ),
        2 => Ok(1),
        _ if !is_head => refuse(
            format!("{} has more than two columns, and its first line does not name them", file.name),
            "name the columns in the first line, those of loads as the scene names these",
        ),
        _ => cells.iter().skip(1).position(|cell| !name.is_empty() && cell == name).map_or_else(
            || {
                let load = if name.is_empty() {
                    "this load, which has no name".to_owned()
                } else {
                    format!("`{}`", shown(name))
                };
                refuse(
                    format!("{} has no column for {load}", file.name),
                    "name a column in its first line as the scene names the load",
                )
            },
            |index| Ok(index + 1),
        ),
    }
}
