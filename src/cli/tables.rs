//! Tables of loads in files beside a scene, as an indicator diagram over a crank's angle: read here, and written into the scene's text.

use super::files::{MOST, decoded, read_unnamed};
use super::message::{Failure, Source, refuse};
use crate::Problem;
use crate::editing::{PutTable, TableFile, tables_in_files, with_tables};
use crate::message::Message;
use crate::scene::{MAX_BYTES, SceneError};
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

/// A text of a scene before tables were written into it, for messages: they show the lines of the file.
#[derive(Clone, Debug)]
pub struct Given {
    text: String,
    tables: Vec<FromFile>,
}

/// A table that was written into a scene's text.
#[derive(Clone, Debug)]
struct FromFile {
    /// The name of its file.
    file: String,
    /// The number in the file of each of its lines.
    lines: Vec<usize>,
    put: PutTable,
}

/// A scene's text with the tables that it leaves to files, whose paths are from its folder. Each file is read once.
pub(super) fn put_tables(source: Source, scene: &Path) -> Result<Source, Failure> {
    let folder = scene.parent().filter(|_| scene != Path::new("-")).unwrap_or(Path::new(""));
    let given = tables_in_files(&source.text);
    if given.is_empty() {
        return Ok(source);
    }
    let mut files: BTreeMap<&str, (String, TableFile)> = BTreeMap::new();
    let (mut tables, mut from, mut numbers) = (Vec::new(), Vec::new(), 0);
    for load in &given {
        if !files.contains_key(load.path.as_str()) {
            files.insert(&load.path, read_table(&folder.join(&load.path), folder)?);
        }
        let (name, file) = &files[load.path.as_str()];
        let table = file.table(load.name.as_deref(), load.unit.as_deref());
        let (lines, table): (Vec<usize>, Vec<[f64; 2]>) =
            table.map_err(|problem| in_file(name, problem))?.into_iter().unzip();
        // A number takes two bytes at least, so that a text of more numbers is too large whatever they are.
        numbers += 2 * table.len();
        if numbers > MAX_BYTES / 2 {
            return too_large(&source, &files);
        }
        tables.push((load.load, table));
        from.push((name.clone(), lines));
    }
    let (text, put) = source.checked(with_tables(&source.text, &tables))?;
    if text.len() > MAX_BYTES && source.text.len() <= MAX_BYTES {
        return too_large(&source, &files);
    }
    let tables = from.into_iter().zip(put).map(|((file, lines), put)| FromFile { file, lines, put }).collect();
    Ok(Source { name: source.name, text, given: Some(Box::new(Given { text: source.text, tables })) })
}

/// Refuses tables with which the scene is larger than any may be.
fn too_large<T>(source: &Source, files: &BTreeMap<&str, (String, TableFile)>) -> Result<T, Failure> {
    let names: Vec<&str> = files.values().map(|(name, _)| name.as_str()).collect();
    let most = MAX_BYTES >> 20;
    let message =
        format!("{} with the tables of all its loads is larger than {most} MB: {}", source.name, names.join(", "));
    refuse(message, "give the loads fewer lines: leave out those that a straight line gives as well")
}

/// The name of a file with tables, and what is in it.
fn read_table(path: &Path, folder: &Path) -> Result<(String, TableFile), Failure> {
    let name = path.display().to_string();
    // Somebody else's scene may name any file: nothing outside of its folder is read.
    let bytes = read_unnamed(path, Some(folder), MOST).map_err(|why| {
        Failure::misuse(format!("{name}, which the scene names as a table, {why}"), "put the table beside the scene")
    })?;
    let Some(text) = decoded(bytes) else {
        return refuse(format!("{name}, which the scene names as a table, is no text"), "save it as CSV UTF-8");
    };
    match TableFile::read(&text) {
        Ok(table) => Ok((name, table)),
        Err(problem) => Err(in_file(&name, problem)),
    }
}

/// What is wrong in a file.
fn in_file(name: &str, Problem { message, hint }: Problem) -> Failure {
    Failure::Misuse(Problem { message: Message::list([name.into(), message], ": "), hint })
}

impl Given {
    /// The text as it stands in the file.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// An error in the text with the tables as it is told: at its place in the file of the scene, or in that of a table.
    pub(super) fn told(&self, error: &SceneError, text: &str) -> Told {
        let Some(place) = &error.place else { return Told::InScene(error.clone()) };
        let span = place.span.clone();
        let within = |table: &&FromFile| table.put.lines.start < span.start && span.end < table.put.lines.end;
        if let Some(FromFile { file, lines, put }) = self.tables.iter().find(within) {
            // Each line is a list in the list, and numbers have no brackets.
            let index = text.get(put.lines.start + 1..=span.start).map_or(0, |before| before.matches('[').count());
            let line = lines.get(index.saturating_sub(1)).copied().unwrap_or_default();
            let place =
                Message::list([file.as_str().into(), format!("line {line}").into(), error.message.clone()], ": ");
            return Told::InTable(Problem { message: place, hint: error.hint.clone() });
        }
        Told::InScene(error.clone().placed(&self.text, self.place(span)))
    }

    /// The bytes in the file of some in the text with the tables.
    fn place(&self, span: Range<usize>) -> Range<usize> {
        let moved = |at: usize, is_end: bool| {
            let before = self.tables.iter().filter(|table| table.put.lines.start < at);
            before.fold(at, |moved, FromFile { put, .. }| match at < put.lines.end {
                true => {
                    if is_end {
                        put.name.end
                    } else {
                        put.name.start
                    }
                }
                false => moved + put.name.len() - put.lines.len(),
            })
        };
        moved(span.start, false)..moved(span.end, true)
    }
}

/// What an error in a text with tables is told as.
pub(super) enum Told {
    /// An error in the scene's own text.
    InScene(SceneError),
    /// Something wrong in the file of a table.
    InTable(Problem),
}
