//! The forms in a folder, and the exercises in another to which they belong.

use super::feedback::is_page;
use super::files;
use super::message::{Failure, Source, refuse};
use super::pieces::caught;
use crate::check::Measured;
use crate::scene::nearest;
use crate::text::{Untrusted, shown};
use std::collections::BTreeSet;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// What was handed in in a folder, ordered by path: forms, which are all files in `.json` or `.csv`, and what cannot be read as one, so that a
/// row says so; without `others`. Refuses a folder without forms.
///
/// With `below` those of the folders in it, too. Links to folders are not followed; a folder in it that cannot be listed is
/// itself among the forms, so that a row says so.
pub(super) fn forms(folder: &Path, below: bool, others: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let others: BTreeSet<PathBuf> = others.iter().filter_map(|file| file.canonicalize().ok()).collect();
    let (mut forms, mut unread, mut folders) = (Vec::new(), Vec::new(), vec![folder.to_owned()]);
    while let Some(inside) = folders.pop() {
        let entries = match files::entries(&inside) {
            Err(_) if inside != folder => {
                forms.push(inside);
                continue;
            }
            entries => entries?,
        };
        for path in entries.into_iter().filter(|path| !is_hidden(path)) {
            if below && fs::symlink_metadata(&path).is_ok_and(|found| found.is_dir()) {
                folders.push(path);
            } else if path.canonicalize().is_ok_and(|path| others.contains(&path)) {
                continue;
            } else if is_form(&path) {
                forms.push(path);
            } else if is_handed_in(&path) {
                unread.push(path);
            }
        }
    }
    match forms.is_empty() {
        false => {
            forms.append(&mut unread);
            forms.sort();
            Ok(forms)
        }
        true => refuse(
            format!("{} has no forms to check, and no photographs", folder.display()),
            "files that end in `.json` or `.csv` are forms, those in `.jpg` or `.png` photographs of sheets; `kinegon check SCENE --template` writes an empty form",
        ),
    }
}

/// Whether a file's name has one of these endings, in letters of either case.
pub(super) fn has_ending(path: &Path, endings: &[&str]) -> bool {
    path.extension().is_some_and(|own| endings.iter().any(|ending| own.eq_ignore_ascii_case(ending)))
}

fn is_hidden(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'))
}

/// Whether a file's name is that of a form.
fn is_form(path: &Path) -> bool {
    has_ending(path, &["json", "csv"])
}

/// Whether a file that is no form was handed in all the same. Folders are not, hidden files, what systems, editors and teachers put beside
/// forms, and what this program writes there: pictures over photographs and drawings, reports, pages for the students.
pub(super) fn is_handed_in(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let is_beside = ["readme", "~$"].iter().any(|start| name.starts_with(start))
        || ["thumbs.db", "desktop.ini"].contains(&name.as_str());
    let is_picture =
        has_ending(path, &["png", "pdf", "svg", "tex"]) && (stem.ends_with("-check") || stem.contains("-check-values"));
    let is_own = || {
        (has_ending(path, &["jsonl", "ndjson"]) && path.is_file() && is_report(path))
            || (has_ending(path, &["html", "pdf"]) && is_page(path))
    };
    !(path.is_dir() || is_hidden(path) || is_beside || is_picture || is_own())
}

/// Whether a file is a report on a class.
pub(super) fn is_report(path: &Path) -> bool {
    let mut start = Vec::new();
    let read = fs::File::open(path).and_then(|f| f.take(64).read_to_end(&mut start));
    let start = String::from_utf8_lossy(&start);
    let starts = ["file,name,passed,", "file,exercise,name,passed,", "{\n  \"kinegon_class\"", "{\"file\":"];
    read.is_ok() && starts.iter().any(|known| start.starts_with(known))
}

/// The values of a form: JSON if it begins with a bracket and the file's name does not end in `.csv`, else CSV.
pub(super) fn read(path: &Path, text: &Source) -> Result<Measured, Failure> {
    if !has_ending(path, &["csv"]) && Measured::is_json(&text.text) {
        text.checked(Measured::read_json(&text.text))
    } else {
        Measured::read_csv(&text.text).map_err(|error| text.misuse(&error))
    }
}

/// The values of a form in a folder, or why it is not understood.
pub(super) fn measured(path: &Path) -> Result<Measured, String> {
    let text = text_in_folder(path)?;
    let read = caught(|| read(path, &text))?;
    read.map_err(|failure| failure.line(&path.display().to_string()))
}

/// The text of a form or drawing in a folder, or why it is not read.
pub(super) fn text_in_folder(path: &Path) -> Result<Source, String> {
    // Whoever handed it in may link to any file, also to that of somebody else.
    if files::leads_outside(path, path.parent().unwrap_or(Path::new(""))) {
        return Err("it is a link to a file outside of its folder, which is not read".to_owned());
    }
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
    if !is_form(path) {
        return Err(
            "it is no form: forms end in `.json` or `.csv`, and photographs are read from a folder without forms"
                .to_owned(),
        );
    }
    let text = caught(|| files::read_form(path))?;
    text.map_err(|failure| failure.line(&path.display().to_string()))
}

/// A path in a folder as a report shows it; bytes that are not UTF-8 are replaced.
pub(super) fn file_name(path: &Path, folder: &Path) -> Untrusted {
    let inside = path.strip_prefix(folder).unwrap_or(path);
    let parts: Vec<_> = inside.components().map(|part| part.as_os_str().to_string_lossy()).collect();
    parts.join("/").into()
}

/// The exercises of a folder, in the order of their names.
pub struct ExerciseFolder {
    pub folder: PathBuf,
    pub all: Vec<ExerciseFiles>,
}

/// Where the files of an exercise are.
pub struct ExerciseFiles {
    /// Its name: that of its folder, or of its scene's file without the ending.
    pub name: String,
    pub scene: PathBuf,
    /// Its own folder, if it has one.
    pub folder: Option<PathBuf>,
}

impl ExerciseFiles {
    /// A scene that is the only one.
    pub(super) fn of_scene(scene: &Path) -> ExerciseFiles {
        ExerciseFiles { name: String::new(), scene: scene.to_owned(), folder: None }
    }

    /// Its own marking scheme, if it has one.
    pub(super) fn marks(&self) -> Option<PathBuf> {
        self.folder.as_ref().map(|folder| folder.join("marks.json")).filter(|marks| is_there(marks))
    }

    /// Its files that nobody has handed in: the scene, and beside `scene.json` the key, the marks and the sheets.
    pub(super) fn others(&self) -> Vec<PathBuf> {
        let mut all = vec![self.scene.clone()];
        if let Some(folder) = self.scene.parent().filter(|_| self.scene.ends_with("scene.json")) {
            all.extend(["key.json", "key-drawing.json", "marks.json"].map(|name| folder.join(name)));
            let is_sheet = |path: &PathBuf| {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                has_ending(path, &["svg", "pdf"]) && ["sheet", "key"].iter().any(|start| name.starts_with(start))
            };
            let folder = if folder == Path::new("") { Path::new(".") } else { folder };
            all.extend(files::entries(folder).unwrap_or_default().into_iter().filter(is_sheet));
        }
        all
    }
}

/// Most exercises that a message names.
const NAMED: usize = 6;

impl ExerciseFolder {
    /// The exercises of a folder: each folder in it with a `scene.json`, and each scene file. A folder that has
    /// `scene.json` itself is one exercise.
    pub(super) fn read(folder: &Path) -> Result<ExerciseFolder, Failure> {
        let scene = folder.join("scene.json");
        let mut all = Vec::new();
        if is_there(&scene) {
            let place = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
            all.push(ExerciseFiles { name: name(place.file_name()), scene, folder: Some(folder.to_owned()) });
        } else {
            all.extend(files::entries(folder)?.iter().filter_map(|path| exercise(path)));
        }
        for exercise in &all {
            let read = [Some(exercise.scene.clone()), exercise.marks()].into_iter().flatten();
            for file in read {
                if files::leads_outside(&file, folder) {
                    return refuse(
                        format!("{} is a link to a file outside of its folder, which is not read", file.display()),
                        "put a copy of the file there",
                    );
                }
                if let Err(why) = files::regular(&file) {
                    return refuse(format!("{} {why}", file.display()), "put a file there, or take it away");
                }
            }
        }
        all.sort_by(|a, b| a.name.cmp(&b.name));
        if let Some(same) = all.windows(2).find(|pair| pair[0].name == pair[1].name) {
            let [first, second] = [&same[0], &same[1]].map(|exercise| exercise.scene.display());
            return refuse(
                format!("{first} and {second} have one name"),
                "forms are matched with exercises by their names: rename one of them",
            );
        }
        if all.is_empty() {
            return refuse(
                format!("{} has no exercises", folder.display()),
                "an exercise is a folder with scene.json, as `kinegon exercise KIND --count 30 -o DIR` writes it, \
                     or a scene file",
            );
        }
        Ok(ExerciseFolder { folder: folder.to_owned(), all })
    }

    /// The index of the exercise that a form belongs to: the one that it names, else the one whose name is in the name
    /// of its file, else in that of the nearest folder; `path` is the form's in the folder of forms. A single exercise
    /// has all forms that name none.
    pub fn of_form(&self, named: Option<&Untrusted>, path: &Path) -> Result<usize, String> {
        if let Some(name) = named {
            return self.named(name);
        }
        match (self.of_path(path)?, self.all.as_slice()) {
            (Some(index), _) => Ok(index),
            (None, [_]) => Ok(0),
            (None, _) => Err(format!(
                "it does not say to which exercise it belongs (write the exercise's name into the form as `exercise`, \
                 or into the file's name; {})",
                self.names()
            )),
        }
    }

    /// What is to be said of a form that belongs to the exercise of that index, as it names it, where its file or its folder is named after another one.
    pub(super) fn contradiction(&self, index: usize, path: &Path) -> Option<String> {
        let other = self.of_path(path).ok()?.filter(|other| *other != index)?;
        let [own, other] = [index, other].map(|index| shown(&self.all[index].name));
        Some(format!(
            "its file or folder is named after the exercise `{other}`, but the form names `{own}` and is checked against that \
             (rename the file, or change `exercise` in the form)"
        ))
    }

    /// The index of the exercise whose name is in the name of a form's file, else in that of the nearest folder.
    fn of_path(&self, path: &Path) -> Result<Option<usize>, String> {
        let folders = path.components().rev().skip(1).map(|part| part.as_os_str());
        for part in path.file_stem().into_iter().chain(folders) {
            let text = part.to_string_lossy();
            match self.in_text(&text).as_slice() {
                [] => {}
                [one] => return Ok(Some(*one)),
                several => {
                    let names: Vec<String> = several.iter().map(|&i| shown(&self.all[i].name)).collect();
                    return Err(format!(
                        "`{}` has the names of several exercises: {} (write the right one into the form, as \
                         `exercise`)",
                        shown(&text),
                        names.join(", ")
                    ));
                }
            }
        }
        Ok(None)
    }

    /// The exercise that a form names.
    fn named(&self, named: &Untrusted) -> Result<usize, String> {
        let name = named.for_comparing();
        let exactly = self.all.iter().position(|e| e.name == name);
        let nearly = || self.all.iter().position(|e| e.name.to_lowercase() == name.trim().to_lowercase());
        exactly.or_else(nearly).ok_or_else(|| {
            let near = nearest(name, self.all.iter().map(|e| e.name.as_str()));
            let near = near.map_or_else(String::new, |near| format!("did you mean `{}`? ", shown(near)));
            format!(
                "its exercise `{}` is not in {} ({near}{})",
                named.for_message(),
                self.folder.display(),
                self.names()
            )
        })
    }

    /// The exercises whose names are whole words of a text; none that is a part of another one's name there.
    fn in_text(&self, text: &str) -> Vec<usize> {
        let text = text.to_lowercase();
        let names = self.all.iter().map(|e| e.name.to_lowercase()).enumerate();
        let found: Vec<(usize, String)> = names.filter(|(_, name)| has_word(&text, name)).collect();
        let is_part = |name: &str| found.iter().any(|(_, longer)| longer != name && has_word(longer, name));
        found.iter().filter(|(_, name)| !is_part(name)).map(|(index, _)| *index).collect()
    }

    /// The names of the exercises for a message.
    fn names(&self) -> String {
        let some: Vec<String> = self.all.iter().take(NAMED).map(|e| shown(&e.name)).collect();
        match self.all.len() - some.len() {
            0 => format!("there are {}", some.join(", ")),
            more => format!("there are {} and {more} more", some.join(", ")),
        }
    }
}

/// Whether a name stands in a folder, whatever it leads to.
fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// The exercise at a path, if one is there.
fn exercise(path: &Path) -> Option<ExerciseFiles> {
    if is_hidden(path) {
        return None;
    }
    let inside = path.join("scene.json");
    if is_there(&inside) {
        return Some(ExerciseFiles { name: name(path.file_name()), scene: inside, folder: Some(path.to_owned()) });
    }
    (has_ending(path, &["json"]) && !path.is_dir() && is_scene(path)).then(|| ExerciseFiles {
        name: name(path.file_stem()),
        scene: path.to_owned(),
        folder: None,
    })
}

/// Whether a file is a scene, or one that cannot be read: marking schemes, forms, keys and reports are none.
fn is_scene(path: &Path) -> bool {
    if files::regular(path).is_err() {
        return true;
    }
    let Ok(source) = files::read(path) else {
        return true;
    };
    let value: Result<serde_json::Value, _> = serde_json::from_str(source.text.trim_start_matches('\u{feff}'));
    value.map_or(true, |value| value.get("kinegon").is_some())
}

fn name(name: Option<&std::ffi::OsStr>) -> String {
    name.unwrap_or_default().to_string_lossy().into_owned()
}

/// Whether a word stands in a text, with no letter or digit beside it.
fn has_word(text: &str, word: &str) -> bool {
    !word.is_empty()
        && text.match_indices(word).any(|(at, _)| {
            let before = text[..at].chars().next_back();
            let after = text[at + word.len()..].chars().next();
            ![before, after].into_iter().flatten().any(char::is_alphanumeric)
        })
}
