//! Checks all forms of a folder and writes a table with a row for each.

use super::board;
use super::feedback::Pages;
use super::files;
use super::forms::{is_report, measured};
use super::message::{Failure, note, passed, refuse};
use super::output::{FileSet, is_stream};
use super::pieces::{Pieces, caught};
use crate::check::{Checked, ClassColumns, ClassRow, ClassSummary, Feedback, MarkScheme, Measured, Prepared};
use crate::format;
use crate::text::Untrusted;
use crate::words::Wording;
use std::path::{Path, PathBuf};

/// The forms of a class, the exercises to which they belong, and the report.
pub(super) struct Class<'a> {
    pub folder: &'a Path,
    pub forms: &'a [Form],
    /// The exercises, or why one cannot be solved.
    pub exercises: &'a [Result<Subject<'a>, String>],
    pub columns: ClassColumns,
    pub format: ReportFormat,
    /// File for the report, `-` for stdout.
    pub output: &'a Path,
    /// The pages for the students, if they are wanted.
    pub pages: Option<Pages>,
    /// Those of the summary.
    pub words: &'a Wording,
}

/// A form and the exercise to which it belongs.
pub(super) struct Form {
    pub path: PathBuf,
    /// Its name in the report.
    pub file: Untrusted,
    /// The index of its exercise, or why that is not known.
    pub exercise: Result<usize, String>,
    /// What is to be said of it beside its verdict.
    pub remark: Option<String>,
}

/// An exercise with its answers.
pub(super) struct Subject<'a> {
    /// Its name in a report on several.
    pub name: Option<&'a str>,
    pub key: Prepared<'a>,
    pub scheme: Option<MarkScheme>,
}

/// What a form comes to: its row, and the files of the student's page.
type Done = (ClassRow, Vec<(PathBuf, Vec<u8>)>);

/// The file format of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ReportFormat {
    Csv,
    Json,
    Jsonl,
}

impl ReportFormat {
    /// The format that the ending of the output file names; on stdout JSON if `as_json`, else CSV.
    pub(super) fn of(output: &Path, as_json: bool) -> Result<ReportFormat, Failure> {
        let ending = output.extension().unwrap_or_default().to_string_lossy();
        if ending.is_empty() && is_stream(output) {
            return Ok(if as_json { ReportFormat::Json } else { ReportFormat::Csv });
        }
        let format = match ending.as_ref() {
            "csv" => ReportFormat::Csv,
            "json" => ReportFormat::Json,
            "jsonl" | "ndjson" => ReportFormat::Jsonl,
            other => {
                return refuse(
                    format!("no form of report for files ending in `.{other}`"),
                    "known endings: csv, json, jsonl",
                );
            }
        };
        if as_json && format == ReportFormat::Csv {
            return refuse(
                "--json and a report that ends in `.csv` do not go together",
                "leave out --json, or name a file that ends in `.json`",
            );
        }
        Ok(format)
    }
}

impl Class<'_> {
    /// Checks all forms and writes the report. A form that is not understood does not stop the others.
    pub(super) fn run(&self) -> Result<(), Failure> {
        self.refuse_overwriting_form()?;
        let mut set = FileSet::default();
        let mut out = set.begin(self.output)?;
        let mut summary = ClassSummary::default();
        let mut is_wanted = match self.format {
            ReportFormat::Csv => out.put(ClassRow::csv_head(self.columns).as_bytes())?,
            ReportFormat::Json => out.put(b"{\n  \"kinegon_class\": 1,\n  \"rows\": [")?,
            ReportFormat::Jsonl => true,
        };
        let count = self.forms.len();
        let all = Pieces { count, size: 1, per_core: 32, unit: (count > 20).then_some("files") };
        all.each(
            |one| self.row(one.start),
            |(row, page): Done| {
                set.add_all(&page)?;
                let is_first = summary.files == 0;
                summary.add(&row);
                // With stdout closed the checks go on, for the exit code.
                is_wanted = is_wanted && out.put(self.written(&row, is_first).as_bytes())?;
                Ok(true)
            },
        )?;
        let summary = summary.finished();
        if self.format == ReportFormat::Json && is_wanted {
            let summary = format::json_line(&summary);
            out.put(format!("\n  ],\n  \"summary\": {summary}\n}}\n").as_bytes())?;
        }
        out.end()?;
        set.finish()?;
        summary.lines(self.words).iter().for_each(|line| note(line));
        passed(summary.off + summary.incomplete, summary.broken)
    }

    /// A row of the report as text.
    fn written(&self, row: &ClassRow, is_first: bool) -> String {
        let json = || format::json_line(row);
        match self.format {
            ReportFormat::Csv => row.csv(self.columns),
            ReportFormat::Json if is_first => format!("\n    {}", json()),
            ReportFormat::Json => format!(",\n    {}", json()),
            ReportFormat::Jsonl => format!("{}\n", json()),
        }
    }

    /// Refuses to write over a form; an earlier report may be overwritten.
    fn refuse_overwriting_form(&self) -> Result<(), Failure> {
        let inside = self.output.parent().map(|folder| match folder.as_os_str().is_empty() {
            true => Path::new("."),
            false => folder,
        });
        let is_inside = inside.is_some_and(|folder| files::is_same(folder, self.folder));
        if self.output == Path::new("-") || !is_inside || !self.output.is_file() || is_report(self.output) {
            return Ok(());
        }
        refuse(
            format!("{} is one of the files to check and is not overwritten", self.output.display()),
            "choose another output",
        )
    }

    /// The row and the page of a form. Whatever goes wrong with it is said there, and ends nothing else.
    fn row(&self, index: usize) -> Done {
        let done = caught(|| self.checked(index)).unwrap_or_else(Err);
        let (row, page) = done.unwrap_or_else(|message| self.broken(index, message));
        let exercise = self.subject(index).and_then(|subject| subject.name).map(Untrusted::from);
        (ClassRow { exercise, ..row }, page)
    }

    /// The exercise of a form, if it is known and can be solved.
    fn subject(&self, index: usize) -> Option<&Subject<'_>> {
        self.exercises.get(*self.forms[index].exercise.as_ref().ok()?)?.as_ref().ok()
    }

    /// The row and the page of a form that is checked, or why it is not.
    fn checked(&self, index: usize) -> Result<Done, String> {
        let form = &self.forms[index];
        let exercise = form.exercise.clone();
        let subject = exercise.clone().map(|exercise| self.exercises[exercise].as_ref().map_err(String::clone));
        let drawn = match &subject {
            Ok(Ok(subject)) => board::drawn(&form.path, &subject.key.key().clone())?,
            _ => None,
        };
        let (measured, drawn) = match drawn {
            Some(drawn) => (drawn.form, Some((drawn.wrong, drawn.missing))),
            None => (measured(&form.path)?, None),
        };
        let (exercise, subject) = (exercise?, subject??);
        let checked = if drawn.is_some() { subject.key.check_drawn(&measured) } else { subject.key.check(&measured) };
        let mut checked = checked.map_err(|error| Failure::from(error).line(""))?;
        let wrong = drawn.map(|(wrong, missing)| {
            checked.missing = missing;
            wrong
        });
        if let Some(other) = self.other_exercise(exercise, &measured, &checked) {
            checked.put_down_to(other);
        }
        let (name, file) = (measured.name.as_ref(), form.file.clone());
        let mut row = ClassRow::checked(file, name, &checked, subject.key.key(), subject.scheme.as_ref());
        if let Some(wrong) = wrong {
            row.judge_drawing(wrong);
        }
        row.message = form.remark.as_deref().map(Untrusted::from);
        let page = self.page(index, || {
            let marks = subject.scheme.as_ref().map(|scheme| scheme.award(&checked));
            let name = measured.name.clone().unwrap_or_else(|| form.file.stem());
            let named = Measured { name: Some(name), ..measured.clone() };
            Ok(Feedback::new(&named, subject.key.key(), &checked, marks.as_ref())?)
        });
        let page = page.map_err(|failure| format!("its page cannot be made: {}", failure.line("")))?;
        Ok((row, page))
    }

    /// The name of the exercise whose values a form has, where it is not its own.
    fn other_exercise(&self, own: usize, measured: &Measured, checked: &Checked) -> Option<&str> {
        if checked.is_nothing_off() {
            return None;
        }
        let others = self.exercises.iter().enumerate().filter(|(index, _)| *index != own);
        let mut others = others.filter_map(|(_, subject)| subject.as_ref().ok());
        others.find(|subject| subject.key.has_rather(measured, checked))?.name
    }

    /// The row and the page of a form that is not understood.
    fn broken(&self, index: usize, mut message: String) -> Done {
        let form = &self.forms[index];
        let refused = || {
            let name = measured(&form.path).ok().and_then(|measured| measured.name).unwrap_or_else(|| form.file.stem());
            let scene = self.subject(index).map(|subject| &subject.key.key().solution.scene);
            let words = scene.map_or(*self.words, |scene| Wording::of(&scene.figure));
            Ok(Feedback::refused(scene, &name, &message, &words))
        };
        let page = caught(|| self.page(index, refused)).and_then(|page| page.map_err(|failure| failure.line("")));
        let page = page.unwrap_or_else(|why| {
            message = format!("{message}; it has no page: {why}");
            Vec::new()
        });
        (ClassRow::broken(form.file.clone(), &message), page)
    }

    /// The files of the page of a form, if pages are wanted.
    fn page(
        &self,
        index: usize,
        feedback: impl FnOnce() -> Result<Feedback, Failure>,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
        self.pages.as_ref().map_or_else(|| Ok(Vec::new()), |pages| pages.of(index, &feedback()?))
    }
}
