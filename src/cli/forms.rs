//! The forms in a folder.

use super::caught::caught;
use super::files;
use super::message::{Failure, Source};
use crate::check::Measured;
use crate::text::Untrusted;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The forms of a folder, ordered by name: all files in `.json` or `.csv` except hidden ones and `others`. What has
/// such a name and is no file is among them, so that a row says so.
pub(super) fn forms_in(folder: &Path, others: &[&Path]) -> Result<Vec<PathBuf>, Failure> {
    let others = complete(others);
    let mut forms: Vec<PathBuf> = files::entries(folder)?.into_iter().filter(|path| is_form(path, &others)).collect();
    forms.sort_by(|a, b| a.file_name().cmp(&b.file_name()));
    if forms.is_empty() { Err(none(folder)) } else { Ok(forms) }
}

/// The forms of a folder and of the folders in it, ordered by path: files as for [`forms_in`]. Links to folders are not
/// followed; a folder in it that cannot be listed is itself among them, so that a row says so.
pub(super) fn forms_below(folder: &Path, others: &[&Path]) -> Result<Vec<PathBuf>, Failure> {
    let others = complete(others);
    let (mut forms, mut folders) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(inside) = folders.pop() {
        let entries = match files::entries(&inside) {
            Err(_) if inside != folder => {
                forms.push(inside);
                continue;
            }
            entries => entries?,
        };
        for path in entries {
            let is_folder = fs::symlink_metadata(&path).is_ok_and(|found| found.is_dir());
            if is_folder && !is_hidden(&path) {
                folders.push(path);
            } else if !is_folder && is_form(&path, &others) {
                forms.push(path);
            }
        }
    }
    forms.sort();
    if forms.is_empty() { Err(none(folder)) } else { Ok(forms) }
}

/// The complete paths of the files that are there.
fn complete(files: &[&Path]) -> BTreeSet<PathBuf> {
    files.iter().filter_map(|file| file.canonicalize().ok()).collect()
}

fn is_form(path: &Path, others: &BTreeSet<PathBuf>) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    ["json", "csv"].contains(&ending.to_lowercase().as_str())
        && !is_hidden(path)
        && !path.canonicalize().is_ok_and(|path| others.contains(&path))
}

pub(super) fn is_hidden(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'))
}

fn none(folder: &Path) -> Failure {
    Failure::misuse(
        format!("{} has no forms to check, and no photographs", folder.display()),
        "files that end in `.json` or `.csv` are forms, those in `.jpg` or `.png` photographs of sheets; `kinegon check SCENE --template` writes an empty form",
    )
}

/// The values of a form: JSON if it begins with a bracket and the file's name does not end in `.csv`, else CSV.
pub(super) fn read(path: &Path, text: &Source) -> Result<Measured, Failure> {
    let is_table = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    if !is_table && Measured::is_json(&text.text) {
        Measured::read_json(&text.text).map_err(|error| text.fail(error))
    } else {
        Measured::read_csv(&text.text).map_err(|error| text.misuse(&error))
    }
}

/// The values of a form, or why it is not understood.
pub(super) fn measured(path: &Path) -> Result<Measured, String> {
    // A pipe or a device is not opened: reading it could block.
    if let Ok(found) = fs::metadata(path)
        && !found.is_file()
    {
        if let Some(error) = fs::read_dir(path).err().filter(|_| found.is_dir()) {
            return Err(format!("it is a folder that cannot be listed: {error}"));
        }
        let what = if found.is_dir() { "a folder" } else { "special" };
        return Err(format!("it is {what}, no file with values"));
    }
    let read = caught(|| files::read_form(path).and_then(|text| read(path, &text)))?;
    read.map_err(|failure| failure.line(&path.display().to_string()))
}

/// A path in a folder as a report shows it; bytes that are not UTF-8 are replaced.
pub(super) fn shown(path: &Path, folder: &Path) -> Untrusted {
    let inside = path.strip_prefix(folder).unwrap_or(path);
    let parts: Vec<_> = inside.components().map(|part| part.as_os_str().to_string_lossy()).collect();
    parts.join("/").into()
}
