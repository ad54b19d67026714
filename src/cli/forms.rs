//! The forms in a folder, and the exercises in another to which they belong.

use super::files;
use super::message::{Failure, Source, refuse};
use super::pieces::caught;
use crate::check::Measured;
use crate::scene::nearest;
use crate::text::{Untrusted, shown};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The forms of a folder, ordered by path: all files in `.json` or `.csv` except hidden ones and `others`. What has such a
/// name and is no file is among them, so that a row says so.
///
/// With `below` those of the folders in it, too. Links to folders are not followed; a folder in it that cannot be listed is
/// itself among the forms, so that a row says so.
pub(super) fn forms(folder: &Path, below: bool, others: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let others: BTreeSet<PathBuf> = others.iter().filter_map(|file| file.canonicalize().ok()).collect();
    let (mut forms, mut folders) = (Vec::new(), vec![folder.to_owned()]);
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
            } else if has_ending(&path, &["json", "csv"])
                && !path.canonicalize().is_ok_and(|path| others.contains(&path))
            {
                forms.push(path);
            }
        }
    }
    forms.sort();
    match forms.is_empty() {
        false => Ok(forms),
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

    /// Its files that are no forms.
    pub(super) fn others(&self) -> impl Iterator<Item = PathBuf> {
        let beside = self
            .folder
            .iter()
            .flat_map(|folder| ["key.json", "key-drawing.json", "marks.json"].map(|name| folder.join(name)));
        [self.scene.clone()].into_iter().chain(beside)
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
        let folders = path.components().rev().skip(1).map(|part| part.as_os_str());
        for part in path.file_stem().into_iter().chain(folders) {
            let text = part.to_string_lossy();
            match self.in_text(&text).as_slice() {
                [] => {}
                [one] => return Ok(*one),
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
        match self.all.as_slice() {
            [_] => Ok(0),
            _ => Err(format!(
                "it does not say to which exercise it belongs (write the exercise's name into the form as `exercise`, \
                 or into the file's name; {})",
                self.names()
            )),
        }
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
