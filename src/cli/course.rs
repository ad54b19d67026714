//! `kinegon exercise --lms`: exercises as one file for a learning management system.

use super::exercise::failed;
use super::figures::GivenStyle;
use super::files;
use super::message::Failure;
use super::output::{FileSet, is_special};
use crate::course::{CourseError, Question, canvas, moodle, scorm};
use crate::exercise::Exercises;
use clap::ValueEnum;
use std::path::Path;

/// A kind of learning management system, by the file that it imports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Lms {
    /// Moodle XML: a question bank.
    Moodle,
    /// QTI 1.2, for Canvas.
    Canvas,
    /// SCORM 1.2, for any: the workbench, which reports a score.
    Scorm,
}

impl Lms {
    /// The ending of its file.
    fn ending(self) -> &'static str {
        match self {
            Lms::Moodle => "xml",
            Lms::Canvas | Lms::Scorm => "zip",
        }
    }

    /// Writes so many exercises with that name and seed into one file, or to stdout. `source` names the scene in messages.
    pub(super) fn write(
        self,
        exercises: &mut Exercises,
        (name, seed, count): (&str, u64, u16),
        style: &GivenStyle,
        (source, path): (&str, &Path),
    ) -> Result<(), Failure> {
        self.refuse_other_files(path)?;
        files::refuse_overwriting("scene", Path::new(source), path)?;
        let mut questions = Vec::new();
        for number in 1..=count {
            let mut exercise = exercises.next().map_err(|error| failed(source, &error))?;
            style.put_on([&mut exercise.sheet]);
            let question =
                Question::new(&exercise, &format!("{}-{seed}-{number}", plain(name)), &|key| style.put_on([key]));
            questions.push(question.map_err(|error| Failure::Misuse(format!("{source}: {error}"), None))?);
        }
        let written = match self {
            Lms::Moodle => moodle(name, &questions),
            Lms::Canvas => canvas(&questions),
            Lms::Scorm => scorm(name, &questions),
        };
        let bytes = written.map_err(|error: CourseError| Failure::Outside(error.to_string().into()))?;
        if path == Path::new("-") {
            return files::print(&bytes);
        }
        let mut set = FileSet::default();
        set.add(path, &bytes)?;
        set.finish()
    }

    /// Refuses a folder, and a name whose ending says something else.
    fn refuse_other_files(self, path: &Path) -> Result<(), Failure> {
        if path == Path::new("-") || is_special(path) {
            return Ok(());
        }
        let ending = self.ending();
        let name = self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned());
        let hint = |more: &str| Some(format!("`--lms {name}` writes one file; {more} `.{ending}`"));
        if files::is_folder(path) {
            return Err(Failure::Misuse(
                format!("{} is a folder", path.display()),
                hint("give its name, too, which ends in"),
            ));
        }
        let is_file = path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending));
        let message = format!("{} is no name for the file of a course", path.display());
        let hint = hint("let its name end in");
        if is_file { Ok(()) } else { Err(Failure::Misuse(message, hint)) }
    }
}

/// A name as names of files in addresses have it: letters, digits and hyphens of ASCII.
fn plain(name: &str) -> String {
    let letters = name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' });
    letters.take(60).collect()
}
