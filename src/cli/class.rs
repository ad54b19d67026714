//! Checks all forms of a folder and writes a table with a row for each.

use super::check::read;
use super::files;
use super::message::{Failure, note};
use super::pieces::{Output, Pieces};
use crate::check::{self, AnswerKey, ClassRow, ClassSummary, MarkScheme};
use crate::words::Wording;
use std::ffi::OsStr;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// A folder of forms, the key and the marking scheme for them, and the report.
pub(super) struct Class<'a> {
    pub folder: &'a Path,
    /// Files of the folder that are not forms: the scene and the marking scheme.
    pub others: [Option<&'a Path>; 2],
    pub key: &'a AnswerKey<'a>,
    pub words: &'a Wording,
    pub scheme: Option<&'a MarkScheme>,
    pub format: ReportFormat,
    /// File for the report, `-` for stdout.
    pub output: &'a Path,
}

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
        if output == Path::new("-") {
            return Ok(if as_json { ReportFormat::Json } else { ReportFormat::Csv });
        }
        let ending = output.extension().unwrap_or_default().to_string_lossy();
        let format = match ending.as_ref() {
            "csv" => ReportFormat::Csv,
            "json" => ReportFormat::Json,
            "jsonl" | "ndjson" => ReportFormat::Jsonl,
            other => {
                return Err(Failure::Misuse(
                    format!("no form of report for files ending in `.{other}`"),
                    Some("known endings: csv, json, jsonl".into()),
                ));
            }
        };
        if as_json && format == ReportFormat::Csv {
            return Err(Failure::Misuse(
                "--json and a report that ends in `.csv` do not go together".into(),
                Some("leave out --json, or name a file that ends in `.json`".into()),
            ));
        }
        Ok(format)
    }
}

impl Class<'_> {
    /// Checks all forms of the folder and writes the report. A form that is not understood does not stop the others.
    pub(super) fn run(&self) -> Result<(), Failure> {
        self.refuse_overwriting_form()?;
        let forms = self.forms()?;
        let mut out = Output::new(self.output)?;
        let (mut summary, mut is_wanted) = (ClassSummary::default(), true);
        is_wanted &= match self.format {
            ReportFormat::Csv => out.put(&ClassRow::csv_head(self.scheme.is_some()))?,
            ReportFormat::Json => out.put("{\n  \"kinegon_class\": 1,\n  \"rows\": [")?,
            ReportFormat::Jsonl => true,
        };
        let all = Pieces { count: forms.len(), size: 1, per_core: 32, unit: (forms.len() > 20).then_some("files") };
        all.each(
            |one| self.row(&forms[one.start]),
            |row| {
                let is_first = summary.files == 0;
                summary.add(&row);
                // With stdout closed the checks go on, for the exit code.
                is_wanted = is_wanted && out.put(&self.written(&row, is_first))?;
                Ok(true)
            },
        )?;
        let summary = summary.finished();
        if self.format == ReportFormat::Json && is_wanted {
            let summary = serde_json::to_string(&summary).expect("text keys");
            out.put(&format!("\n  ],\n  \"summary\": {summary}\n}}\n"))?;
        }
        out.finish()?;
        summary.lines(self.words).iter().for_each(|line| note(line));
        match (summary.broken, summary.off) {
            (0, 0) => Ok(()),
            (0, _) => Err(Failure::NotPassed),
            _ => Err(Failure::NotUnderstood),
        }
    }

    /// A row of the report as text.
    fn written(&self, row: &ClassRow, is_first: bool) -> String {
        let json = || serde_json::to_string(row).expect("a row has text keys");
        match self.format {
            ReportFormat::Csv => row.csv(self.scheme.is_some()),
            ReportFormat::Json if is_first => format!("\n    {}", json()),
            ReportFormat::Json => format!(",\n    {}", json()),
            ReportFormat::Jsonl => format!("{}\n", json()),
        }
    }

    /// The forms of the folder, ordered by name: all files in `.json` or `.csv` except hidden ones, the scene, the
    /// marking scheme and the report.
    fn forms(&self) -> Result<Vec<PathBuf>, Failure> {
        let failed = |error: std::io::Error| {
            let message = format!("{} cannot be listed: {error}", self.folder.display());
            Failure::Misuse(message, None)
        };
        let mut forms = Vec::new();
        for entry in fs::read_dir(self.folder).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            let ending = path.extension().unwrap_or_default().to_string_lossy();
            let is_form = ["json", "csv"].contains(&ending.to_lowercase().as_str());
            let is_hidden = name(&path).starts_with('.');
            let others = [Some(self.output), self.others[0], self.others[1]];
            let mut others = others.into_iter().flatten();
            if is_form && !is_hidden && !others.any(|other| files::is_same(other, &path)) {
                forms.push(path);
            }
        }
        forms.sort_by(|a, b| a.file_name().cmp(&b.file_name()));
        if forms.is_empty() {
            return Err(Failure::Misuse(
                format!("{} has no forms to check", self.folder.display()),
                Some("its files that end in `.json` or `.csv` are checked; `kinegon check SCENE --template` writes an empty form".into()),
            ));
        }
        Ok(forms)
    }

    /// Refuses to write over a form; an earlier report may be overwritten.
    fn refuse_overwriting_form(&self) -> Result<(), Failure> {
        let inside = self.output.parent().map(|folder| match folder.as_os_str().is_empty() {
            true => Path::new("."),
            false => folder,
        });
        let is_inside = inside.is_some_and(|folder| files::is_same(folder, self.folder));
        if self.output == Path::new("-") || !is_inside || !self.output.is_file() {
            return Ok(());
        }
        let mut start = Vec::new();
        let read = fs::File::open(self.output).and_then(|f| f.take(64).read_to_end(&mut start));
        let start = String::from_utf8_lossy(&start);
        let starts = ["file,name,passed,", "{\n  \"kinegon_class\"", "{\"file\":"];
        if read.is_ok() && starts.iter().any(|known| start.starts_with(known)) {
            return Ok(());
        }
        Err(Failure::Misuse(
            format!("{} is one of the files to check and is not overwritten", self.output.display()),
            Some("choose another output".into()),
        ))
    }

    /// The row of one file.
    fn row(&self, path: &Path) -> ClassRow {
        let file = name(path);
        let broken = |failure: Failure| {
            let place = path.display().to_string();
            ClassRow::broken(file.clone(), &failure.line(&place))
        };
        // A pipe or a device is not opened: reading it could block.
        if let Ok(found) = fs::metadata(path)
            && !found.is_file()
        {
            let what = if found.is_dir() { "a folder" } else { "special" };
            return ClassRow::broken(file, &format!("it is {what}, no file with values"));
        }
        let measured = match files::read_form(path).and_then(|text| read(path, &text)) {
            Ok(measured) => measured,
            Err(failure) => return broken(failure),
        };
        match check::check(&measured, self.key) {
            Ok(checked) => {
                let name = measured.name.as_deref();
                ClassRow::checked(file, name, &checked, self.words, self.scheme)
            }
            Err(error) => broken(Failure::Misuse(error.to_string(), error.hint)),
        }
    }
}

/// A file's name; bytes that are not UTF-8 are replaced.
fn name(path: &Path) -> String {
    path.file_name().unwrap_or(OsStr::new("")).to_string_lossy().into_owned()
}
