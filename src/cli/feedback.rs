//! What students get back: a page each, and the drawing over the right one.

use super::figures::{FigureOptions, Figures, Made, Sheets, stem};
use super::files::read_unnamed;
use super::message::{Failure, refuse, warn};
use super::options::{GivenScales, Paper, scale_option};
use super::output::FileSet;
use super::style::GivenStyle;
use crate::check::{self, AnswerKey, Checked, Feedback, Measured};
use crate::drawing::{FigureSheets, overlay};
use crate::format::FEEDBACK_MARK;
use crate::sheet::Sheet;
use clap::{Args, ValueEnum};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Whether pages for the students are written.
#[derive(Debug, Args)]
pub(super) struct FeedbackOptions {
    /// Also write a page for each form, for the student: the verdict on every value, what probably happened, the marks,
    /// and the student's drawing over the right one. Into this folder, each with the name of its form.
    #[arg(long, value_name = "DIR", conflicts_with = "template")]
    feedback: Option<PathBuf>,
    /// Formats of these pages.
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', value_enum, default_values_t = [PageFormat::default()])]
    feedback_format: Vec<PageFormat>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
enum PageFormat {
    #[cfg(feature = "pdf")]
    #[default]
    Pdf,
    #[cfg_attr(not(feature = "pdf"), default)]
    Html,
}

impl FeedbackOptions {
    /// The pages of forms with these names, as the report shows them; `None` if no pages are wanted.
    ///
    /// Refuses to write over files that are no such pages; nothing is written yet.
    pub(super) fn pages<'f>(&self, forms: impl IntoIterator<Item = &'f str>) -> Result<Option<Pages>, Failure> {
        let Some(folder) = &self.feedback else {
            return match self.feedback_format == [PageFormat::default()] {
                true => Ok(None),
                false => refuse(
                    "--feedback-format is of pages for the students, which are not asked for",
                    "add `--feedback DIR`",
                ),
            };
        };
        if folder == Path::new("-") || folder.is_file() {
            return refuse(
                format!("{} is no folder, but every student gets a page", folder.display()),
                "name a folder after --feedback",
            );
        }
        let forms: Vec<&str> = forms.into_iter().collect();
        let formats: BTreeSet<PageFormat> = self.feedback_format.iter().copied().collect();
        let pages = Pages { folder: folder.clone(), formats, names: page_names(&forms) };
        for index in 0..forms.len() {
            for format in &pages.formats {
                refuse_foreign(&pages.path(index, *format))?;
            }
        }
        Ok(Some(pages))
    }
}

/// Where the pages of forms go.
pub(super) struct Pages {
    folder: PathBuf,
    formats: BTreeSet<PageFormat>,
    /// By form: the name of its page, without an ending.
    names: Vec<String>,
}

impl Pages {
    fn path(&self, form: usize, format: PageFormat) -> PathBuf {
        let ending = if format == PageFormat::Html { "html" } else { "pdf" };
        self.folder.join(format!("{}.{ending}", self.names[form]))
    }

    /// The files of a form's page.
    pub(super) fn of(&self, form: usize, feedback: &Feedback) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
        let file = |format: &PageFormat| -> Result<(PathBuf, Vec<u8>), Failure> {
            let bytes = match format {
                #[cfg(feature = "pdf")]
                PageFormat::Pdf => {
                    crate::format::pdf_pages(&feedback.sheets(), Some(FEEDBACK_MARK)).map_err(Failure::unclear)?
                }
                PageFormat::Html => feedback.html().into_bytes(),
            };
            Ok((self.path(form, *format), bytes))
        };
        self.formats.iter().map(file).collect()
    }
}

/// Refuses to write over a file that is no page for a student.
fn refuse_foreign(page: &Path) -> Result<(), Failure> {
    if fs::metadata(page).is_err() || is_page(page) {
        return Ok(());
    }
    refuse(
        format!("{} is there already, is no page for a student and is not overwritten", page.display()),
        "choose another folder after --feedback",
    )
}

/// Most bytes of a page for a student.
const LARGEST: u64 = 64 << 20;

/// Whether a file is a page for a student.
pub(super) fn is_page(path: &Path) -> bool {
    let mark = FEEDBACK_MARK.as_bytes();
    read_unnamed(path, None, LARGEST).is_ok_and(|bytes| bytes.windows(mark.len()).any(|part| part == mark))
}

/// Most bytes of a page's name: file systems take 255 with all endings.
pub const LONGEST: usize = 180;

/// Names for the pages of forms, all different on every file system: those of the forms without their endings, with
/// them where two would be the same.
pub fn page_names(forms: &[&str]) -> Vec<String> {
    let stem = |form: &&str| form.rsplit_once('.').map_or(*form, |(stem, _)| stem).to_owned();
    let ending = |form: &&str| form.rsplit_once('.').map_or("", |(_, ending)| ending).to_lowercase();
    let mut count: BTreeMap<String, usize> = BTreeMap::new();
    for form in forms {
        *count.entry(safe(&stem(form)).to_lowercase()).or_default() += 1;
    }
    let mut taken = BTreeSet::new();
    let name = |form: &&str| {
        let mut name = safe(&stem(form));
        if count[&name.to_lowercase()] > 1 {
            name = format!("{name}-{}", ending(form));
        }
        let numbered = (2..).map(|number| format!("{name}-{number}"));
        let free = [name.clone()].into_iter().chain(numbered).find(|name| taken.insert(name.to_lowercase()));
        free.unwrap_or(name)
    };
    forms.iter().map(name).collect()
}

/// A file name that every system takes: folders, signs with a meaning and ends of blanks or dots are replaced.
fn safe(text: &str) -> String {
    let is_bad = |c: char| c.is_control() || matches!(c, '/' | '\\' | '<' | '>' | ':' | '"' | '|' | '?' | '*');
    let name: String = text.chars().map(|c| if is_bad(c) { '-' } else { c }).collect();
    let end = (0..=LONGEST.min(name.len())).rev().find(|&end| name.is_char_boundary(end));
    let name = name[..end.unwrap_or(0)].trim_matches([' ', '.']);
    let start = name.split('.').next().unwrap_or_default().to_lowercase();
    let device = start.strip_prefix("com").or_else(|| start.strip_prefix("lpt"));
    let is_device = ["con", "prn", "aux", "nul"].contains(&start.as_str())
        || device.is_some_and(|number| number.len() == 1 && number.starts_with(|c: char| c.is_ascii_digit()));
    match name {
        "" => "form".to_owned(),
        name if is_device => format!("{name}-form"),
        name => name.to_owned(),
    }
}

/// The student's drawing over the right figure, to be printed.
#[derive(Debug, Args)]
pub(super) struct Correction {
    /// Also draw it: the student's points and lines over the right figure at the student's scales, the first wrong
    /// steps marked, and a table of the values. Into a folder, or a file whose ending gives the format.
    #[arg(long, value_name = "FOLDER|FILE")]
    draw: Option<PathBuf>,
    #[command(flatten)]
    forms: FigureOptions,
    #[command(flatten)]
    paper: Paper,
    #[command(flatten)]
    scales: GivenScales,
}

impl Correction {
    /// Refuses options of a drawing where none is made: for a folder of forms, or without `--draw`.
    pub(super) fn refuse_drawing_options(&self, is_folder: bool) -> Result<(), Failure> {
        let is_drawing_meant = self.scales.is_given() || self.paper.is_given() || self.forms.style.is_some();
        match (&self.draw, is_folder) {
            (Some(_), true) => refuse("--draw draws one form, here is a folder", "name one of its files"),
            (None, _) if is_drawing_meant => {
                let options = Sheet::ALL.map(|sheet| format!("--{}", scale_option(sheet))).join(", ");
                let keys = Sheet::ALL.map(|sheet| sheet.facts().scale_key).join(", ");
                refuse(
                    format!("{options}, --page, --orientation and --style are of a drawing, which is not asked for"),
                    format!("add `--draw out/`; the scales of the student's own sheet stand in the form, as {keys}"),
                )
            }
            _ => Ok(()),
        }
    }

    /// Draws the checked values into a set of files if that was asked for. The files of the scene and of the values are not written over.
    pub(super) fn write(
        &self,
        files: &mut FileSet,
        [scene_file, values_file]: [&Path; 2],
        measured: &Measured,
        key: &AnswerKey<'_>,
        checked: &Checked,
    ) -> Result<(), Failure> {
        let Some(output) = &self.draw else {
            return Ok(());
        };
        if output == Path::new("-") {
            return refuse(
                "the report is on stdout, so the drawing cannot be there too",
                "name a folder or a file after --draw",
            );
        }
        let mut solution = key.solution.clone();
        let figure = &mut solution.scene.figure;
        // Scales: from the options, else from the form, else from the scene.
        figure.mu = measured.mu.or(figure.mu);
        let style = GivenStyle::read(self.forms.style.as_deref())?;
        style.put_into(figure);
        self.paper.put_into(figure);
        self.scales.put_into(figure);
        let redrawn = check::redrawn(measured, key, checked)?;
        FigureSheets::new(&solution).overflow_warnings().iter().for_each(|warning| warn(&warning.to_string()));
        let mut sheets = overlay(&solution, &redrawn);
        style.put_on(&mut sheets);
        let name = format!("{}-check", stem(values_file));
        let numbered = |(index, sheet)| match index {
            0 => (name.clone(), Made::Sheets(vec![sheet])),
            1 => (format!("{name}-values"), Made::Sheets(vec![sheet])),
            _ => (format!("{name}-values-{index}"), Made::Sheets(vec![sheet])),
        };
        let drawings = sheets.into_iter().enumerate().map(numbered).collect();
        let inputs = [("scene", scene_file), ("form", values_file)];
        let of_scene =
            |_, _| refuse("a check has no page to step through and no film", "the formats are svg, png, pdf and tikz");
        let figures = Figures { output: output.clone(), options: self.forms.clone() };
        figures.write(files, &inputs, drawings, Sheets::Apart, of_scene)
    }
}
