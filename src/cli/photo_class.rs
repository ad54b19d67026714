//! `kinegon check` for photographs: of one student, or a folder with those of a class.

use super::check::Check;
use super::files;
use super::forms::{ExerciseFiles, ExerciseFolder, file_name, forms, is_handed_in};
use super::message::{Failure, Source, note, passed, refuse, warn};
use super::output::FileSet;
use super::photo::{Photo, PhotoResult, expected, is_photograph, note_next, student};
use super::solve::show_warnings;
use crate::check::PointVerdict;
use crate::construction::Solution;
use crate::cores::on_all_cores;
use crate::text::{Untrusted, cell, quoted};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// A scene that photographs may be of, solved.
type Subject = (ExerciseFiles, Solution);

impl Check {
    /// Checks photographs, if photographs are given; false if not.
    pub(super) fn photographs(&self) -> Result<bool, Failure> {
        let Some(first) = self.measured.as_deref() else {
            return Ok(false);
        };
        if first.is_dir() {
            let (photos, unread) = photos_below(first)?;
            return if photos.is_empty() { Ok(false) } else { self.photo_class(first, photos, &unread).map(|()| true) };
        }
        if is_photograph(first) {
            let all: Vec<PathBuf> = std::iter::once(first.to_owned()).chain(self.further.iter().cloned()).collect();
            return self.one_student(&all).map(|()| true);
        }
        if let Some(further) = self.further.first() {
            return refuse(
                format!("{} is one form too many: one is checked at a time, or a folder", further.display()),
                "put the forms into a folder; only photographs of one student's sheets come several at a time",
            );
        }
        if self.accept { refuse("--accept is of photographs; here is a form", "leave it out") } else { Ok(false) }
    }

    /// The scenes that photographs may be of.
    fn subjects(&self) -> Result<Vec<Subject>, Failure> {
        let all = match self.scene.is_dir() {
            true => ExerciseFolder::read(&self.scene)?.all,
            false => vec![ExerciseFiles::of_scene(&self.scene)],
        };
        let solved = on_all_cores(&all, |exercise| self.solved(&exercise.scene));
        all.into_iter().zip(solved).map(|(exercise, solved)| Ok((exercise, solved?))).collect()
    }

    /// Checks the photographs of one student's sheets.
    fn one_student(&self, paths: &[PathBuf]) -> Result<(), Failure> {
        let subjects = self.subjects()?;
        let name = student(&paths[0]);
        let mut results = self.results(paths, &name, &subjects)?;
        let Some(((exercise, solution), result)) = results.pop().filter(|_| results.is_empty()) else {
            return refuse(
                "the photographs show sheets of several exercises",
                "give those of one exercise, or put all of them into a folder",
            );
        };
        show_warnings(solution);
        let mut files = FileSet::default();
        let mut form = None;
        if let Some(folder) = &self.output {
            if folder == Path::new("-") || folder.is_file() {
                return refuse(
                    format!("{} is no folder, but pictures and a form are written", folder.display()),
                    "name a folder after -o",
                );
            }
            form = Some(result.write(&mut files, folder, &name, &self.key(solution))?);
        }
        files::print_text(&result.table(solution))?;
        files.finish()?;
        for (message, hint) in &result.warnings {
            let language = &solution.wording().language;
            warn(&format!("{}; {}", language.says(message), language.says(hint)));
        }
        if self.accept {
            let source = Source::new(paths[0].display().to_string(), String::new());
            return self.form(exercise, solution, &source, &result.measured);
        }
        note_next(form.as_deref(), &exercise.scene);
        passed(result.points.len() - result.count(Some(PointVerdict::Right)), 0)
    }

    /// What the photographs of the student of that name tell, for each exercise that they show.
    fn results<'s>(
        &self,
        paths: &[PathBuf],
        name: &str,
        subjects: &'s [Subject],
    ) -> Result<Vec<(&'s Subject, PhotoResult)>, Failure> {
        // Of one scene its sheets are known, so that a blurred code is read; those of many are told apart by their codes alone.
        let codes = || match subjects {
            [(exercise, solution)] => expected(solution, &exercise.scene),
            _ => Vec::new(),
        };
        let mut of_subjects: Vec<Vec<Photo>> = subjects.iter().map(|_| Vec::new()).collect();
        for path in paths {
            let photo = Photo::read(path, codes)?;
            let code = &photo.sheet.code;
            let own = subjects.iter().position(|(_, solution)| solution.scene.fingerprint() == code.scene);
            let Some(index) = own.or((subjects.len() == 1).then_some(0)) else {
                let [path, scene] = [path, &self.scene].map(|path| path.display());
                return refuse(
                    format!("{path} shows a sheet of `{}`, which is not in {scene}", code.name),
                    "name the folder with the exercise from which it was printed",
                );
            };
            of_subjects[index].push(photo);
        }
        let shown = subjects.iter().zip(of_subjects).filter(|(_, photos)| !photos.is_empty());
        let result = |(subject, photos): (&'s Subject, Vec<Photo>)| {
            let mut result = PhotoResult::of(photos, &self.key(&subject.1))?;
            result.measured.name = Some(Untrusted::from(name));
            // So that a folder with exercises knows the form again.
            let exercise = &subject.0.name;
            result.measured.exercise = (!exercise.is_empty()).then(|| Untrusted::from(exercise.as_str()));
            Ok((subject, result))
        };
        shown.map(result).collect()
    }

    /// Reads the photographs of a class and writes a form for each student, with pictures; with `--accept` the forms are checked.
    /// Files that are none are `unread`.
    fn photo_class(&self, folder: &Path, photos: Vec<PathBuf>, unread: &[PathBuf]) -> Result<(), Failure> {
        let Some(output) = self.output.as_deref().filter(|output| *output != Path::new("-") && !output.is_file())
        else {
            return refuse(
                format!("{} has photographs, of which pictures and forms are made", folder.display()),
                "name a folder for them: -o forms/",
            );
        };
        if files::is_same(folder, output) {
            return refuse("the folder with the photographs is that for the forms", "choose another after -o");
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
            let results = on_all_cores(some, |(name, paths)| {
                match paths.iter().find(|path| files::leads_outside(path, path.parent().unwrap_or(Path::new("")))) {
                    Some(outside) => refuse(
                        format!("{} is a link to a file outside of its folder, which is not read", outside.display()),
                        "put a copy of the photograph there",
                    ),
                    None => self.results(paths, name, &subjects),
                }
            });
            for ((name, paths), results) in some.iter().zip(results) {
                let written = results.and_then(|results| {
                    let is_only = results.len() == 1;
                    let write = |((exercise, solution), result): (&Subject, PhotoResult)| {
                        let form = if is_only { name.clone() } else { format!("{name}-{}", exercise.name) };
                        result.write(&mut files, output, &form, &self.key(solution))?;
                        Ok((form, result))
                    };
                    results.into_iter().map(write).collect::<Result<Vec<_>, Failure>>()
                });
                match written {
                    Ok(results) => {
                        for (form, result) in results {
                            off += usize::from(result.count(Some(PointVerdict::Right)) < result.points.len());
                            table += &result.row(&form);
                        }
                    }
                    Err(failure) => {
                        broken += 1;
                        let [name, said] = [name, &failure.line("")].map(|text| quoted(&cell(text)));
                        table += &format!("{name},{},,,,,{said}\n", paths.len());
                    }
                }
            }
        }
        for path in unread {
            let name = quoted(&file_name(path, folder).for_cell());
            table += &format!("{name},0,,,,,it is no photograph: these end in `.jpg` or `.png`\n");
        }
        files.finish()?;
        let is_any_read = broken < students.len();
        broken += unread.len();
        if self.accept {
            if broken > 0 {
                let all = students.len() + unread.len();
                warn(&format!(
                    "{broken} of {all} students' photographs are not read; without --accept a table says why"
                ));
            }
            let checked = if is_any_read { self.forms_of(output) } else { Ok(()) };
            return match checked {
                Ok(()) | Err(Failure::Reported(_)) if broken > 0 => passed(off, broken),
                checked => checked,
            };
        }
        files::print_text(&table)?;
        note(&format!(
            "look at the pictures in {0}, then `kinegon check {1} {0}` checks the forms there",
            output.display(),
            self.scene.display()
        ));
        passed(off, broken)
    }
}

/// The photographs in a folder and in the folders in it, one for each student, and the other files that were handed in there; none where it has forms.
fn photos_below(folder: &Path) -> Result<(Vec<PathBuf>, Vec<PathBuf>), Failure> {
    if forms(folder, false, &[]).is_ok() {
        return Ok(Default::default());
    }
    let mut all = Vec::new();
    for path in files::entries(folder)? {
        match fs::symlink_metadata(&path).is_ok_and(|found| found.is_dir()) {
            true => all.extend(files::entries(&path)?),
            false => all.push(path),
        }
    }
    all.retain(|path| is_handed_in(path));
    all.sort();
    Ok(all.into_iter().partition(|path| is_photograph(path)))
}
