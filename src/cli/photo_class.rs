//! `kinegon check` for photographs: of one student, or a folder with those of a class.

use super::check::Check;
use super::exercises::ExerciseFolder;
use super::files;
use super::forms::forms_in;
use super::message::{Failure, Source, note, warn};
use super::output::FileSet;
use super::photo::{Photo, PhotoResult, expected, note_next, student};
use super::pictures::is_photograph;
use super::work::show_warnings;
use crate::check::PointVerdict;
use crate::construction::Solution;
use crate::cores::on_all_cores;
use crate::text::cell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A scene that photographs may be of.
struct Subject {
    path: PathBuf,
    solution: Solution,
    marks: Option<PathBuf>,
}

impl Check {
    /// Checks photographs, if photographs are given: `None` if not.
    pub(super) fn photographs(&self) -> Result<Option<Result<(), Failure>>, Failure> {
        let Some(first) = self.measured.as_deref() else { return Ok(None) };
        if first.is_dir() {
            let photos = photos_below(first)?;
            return Ok((!photos.is_empty()).then(|| self.photo_class(first, photos)));
        }
        if is_photograph(first) {
            let all: Vec<PathBuf> = std::iter::once(first.to_owned()).chain(self.further.iter().cloned()).collect();
            return Ok(Some(self.one_student(&all)));
        }
        if let Some(further) = self.further.first() {
            return Err(Failure::misuse(
                format!("{} is one form too many: one is checked at a time, or a folder", further.display()),
                "put the forms into a folder; only photographs of one student's sheets come several at a time",
            ));
        }
        match self.accept {
            true => Err(Failure::misuse("--accept is of photographs; here is a form", "leave it out")),
            false => Ok(None),
        }
    }

    /// The scenes that photographs may be of.
    fn subjects(&self) -> Result<Vec<Subject>, Failure> {
        if !self.scene.is_dir() {
            let solution = self.solved(&self.scene)?;
            return Ok(vec![Subject { path: self.scene.clone(), solution, marks: self.marks.clone() }]);
        }
        let exercises = ExerciseFolder::read(&self.scene)?;
        let subject = |exercise: &super::exercises::ExerciseFiles| {
            let marks = exercise.marks().or_else(|| self.marks.clone());
            Ok(Subject { solution: self.solved(&exercise.scene)?, path: exercise.scene.clone(), marks })
        };
        on_all_cores(&exercises.all, subject).into_iter().collect()
    }

    /// Checks the photographs of one student's sheets.
    fn one_student(&self, paths: &[PathBuf]) -> Result<(), Failure> {
        let subjects = self.subjects()?;
        let (subject, result) = self.result(paths, &subjects)?;
        let result = result.named(&student(&paths[0]));
        show_warnings(&subject.solution);
        let key = self.key(&subject.solution);
        let mut files = FileSet::default();
        let mut form = None;
        if let Some(folder) = &self.output {
            if folder == Path::new("-") || folder.is_file() {
                return Err(Failure::misuse(
                    format!("{} is no folder, but pictures and a form are written", folder.display()),
                    "name a folder after -o",
                ));
            }
            form = Some(result.write(&mut files, folder, &student(&paths[0]), &key)?);
        }
        files::print_text(&result.table(&subject.solution))?;
        files.finish()?;
        if self.accept {
            let source = Source { name: paths[0].display().to_string(), text: String::new() };
            return self.form(&subject.path, &subject.solution, subject.marks.as_deref(), (&source, &result.measured));
        }
        note_next(form.as_deref(), &subject.path);
        if result.count(PointVerdict::Off) == 0 { Ok(()) } else { Err(Failure::NotPassed) }
    }

    /// What photographs tell, and of which scene they are.
    fn result<'s>(&self, paths: &[PathBuf], subjects: &'s [Subject]) -> Result<(&'s Subject, PhotoResult), Failure> {
        // Of one scene its sheets are known, so that a blurred code is read; those of many are told apart by their codes alone.
        let codes = || match subjects {
            [subject] => expected(&subject.solution, &subject.path),
            _ => Vec::new(),
        };
        let photos: Vec<Photo> = paths.iter().map(|path| Photo::read(path, codes)).collect::<Result<_, _>>()?;
        let is_of = |subject: &&Subject| subject.solution.scene.fingerprint() == photos[0].code().scene;
        let subject = match subjects {
            [subject] => subject,
            _ => subjects.iter().find(is_of).ok_or_else(|| {
                Failure::misuse(
                    format!(
                        "{} shows a sheet of `{}`, which is not in {}",
                        paths[0].display(),
                        photos[0].code().name,
                        self.scene.display()
                    ),
                    "name the folder with the exercise from which it was printed",
                )
            })?,
        };
        let key = self.key(&subject.solution);
        let result = PhotoResult::of(photos, &subject.solution, &key)?;
        Ok((subject, result))
    }

    /// Reads the photographs of a class and writes a form for each student, with pictures; with `--accept` the forms are checked.
    fn photo_class(&self, folder: &Path, photos: Vec<PathBuf>) -> Result<(), Failure> {
        let Some(output) = self.output.as_deref().filter(|output| *output != Path::new("-") && !output.is_file())
        else {
            return Err(Failure::misuse(
                format!("{} has photographs, of which pictures and forms are made", folder.display()),
                "name a folder for them: -o forms/",
            ));
        };
        if files::is_same(folder, output) {
            return Err(Failure::misuse(
                "the folder with the photographs is that for the forms",
                "choose another after -o",
            ));
        }
        let subjects = self.subjects()?;
        let mut students: BTreeMap<String, Vec<PathBuf>> = BTreeMap::new();
        for path in photos {
            let inside = path.parent().filter(|parent| *parent != folder).and_then(Path::file_name);
            let name = inside.map_or_else(|| student(&path), |inside| inside.to_string_lossy().into_owned());
            students.entry(name).or_default().push(path);
        }
        let students: Vec<(String, Vec<PathBuf>)> = students.into_iter().collect();
        let mut table = "student,photographs,right,off,cannot be told,not found,message\n".to_owned();
        let (mut files, mut broken, mut off) = (FileSet::default(), 0, 0);
        // A few at a time: each has pictures of many megabytes.
        for some in students.chunks(4) {
            let results = on_all_cores(some, |(_, paths)| self.result(paths, &subjects));
            for ((name, paths), result) in some.iter().zip(results) {
                let written = result.and_then(|(subject, result)| {
                    let result = result.named(name);
                    result.write(&mut files, output, name, &self.key(&subject.solution))?;
                    Ok(result)
                });
                let row = match written {
                    Ok(result) => {
                        let counts =
                            [PointVerdict::Right, PointVerdict::Off, PointVerdict::CannotTell].map(|v| result.count(v));
                        off += usize::from(counts[1] > 0);
                        format!("{},{},{},{},", counts[0], counts[1], counts[2], result.left())
                    }
                    Err(failure) => {
                        broken += 1;
                        format!(",,,,{}", quoted(&failure.line("")))
                    }
                };
                table += &format!("{},{},{row}\n", quoted(name), paths.len());
            }
        }
        files.finish()?;
        if self.accept {
            if broken > 0 {
                warn(&format!(
                    "{broken} of {} students' photographs are not read; without --accept a table says why",
                    students.len()
                ));
            }
            return if broken < students.len() { self.forms_of(output) } else { Err(Failure::NotUnderstood) };
        }
        files::print_text(&table)?;
        note(&format!(
            "look at the pictures in {0}, then `kinegon check {1} {0}` checks the forms there",
            output.display(),
            self.scene.display()
        ));
        match (broken, off) {
            (0, 0) => Ok(()),
            (0, _) => Err(Failure::NotPassed),
            _ => Err(Failure::NotUnderstood),
        }
    }
}

/// A text as a cell of a table.
fn quoted(text: &str) -> String {
    format!("\"{}\"", cell(text).replace('"', "\"\""))
}

/// The photographs in a folder and in the folders in it, one for each student; none where it has forms.
fn photos_below(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut photos = Vec::new();
    for path in files::entries(folder)? {
        if path.is_dir() {
            let inside = files::entries(&path)?.into_iter();
            photos.extend(inside.filter(|path| path.is_file() && is_photograph(path)));
        } else if is_photograph(&path) {
            photos.push(path);
        }
    }
    photos.sort();
    Ok(if forms_in(folder, &[]).is_ok() { Vec::new() } else { photos })
}
