//! The pages that students get back.

use super::message::Failure;
use crate::check::Feedback;
use crate::format::FEEDBACK_MARK;
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
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', value_enum, default_values_t = [PageFormat::usual()])]
    feedback_format: Vec<PageFormat>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
enum PageFormat {
    #[cfg(feature = "pdf")]
    Pdf,
    Html,
}

impl PageFormat {
    /// The format that is written if none is given.
    fn usual() -> PageFormat {
        #[cfg(feature = "pdf")]
        return PageFormat::Pdf;
        #[cfg(not(feature = "pdf"))]
        PageFormat::Html
    }

    fn ending(self) -> &'static str {
        match self {
            #[cfg(feature = "pdf")]
            PageFormat::Pdf => "pdf",
            PageFormat::Html => "html",
        }
    }
}

impl FeedbackOptions {
    /// The pages of forms with these names, as the report shows them; `None` if no pages are wanted.
    ///
    /// Refuses to write over files that are no such pages; nothing is written yet.
    pub(super) fn pages<'f>(&self, forms: impl IntoIterator<Item = &'f str>) -> Result<Option<Pages>, Failure> {
        let usual = self.feedback_format == [PageFormat::usual()];
        let Some(folder) = &self.feedback else {
            return match usual {
                true => Ok(None),
                false => Err(Failure::misuse(
                    "--feedback-format is of pages for the students, which are not asked for",
                    "add `--feedback DIR`",
                )),
            };
        };
        if folder == Path::new("-") || folder.is_file() {
            return Err(Failure::misuse(
                format!("{} is no folder, but every student gets a page", folder.display()),
                "name a folder after --feedback",
            ));
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
        self.folder.join(format!("{}.{}", self.names[form], format.ending()))
    }

    /// The files of a form's page.
    pub(super) fn of(&self, form: usize, feedback: &Feedback) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
        let file = |format: &PageFormat| -> Result<(PathBuf, Vec<u8>), Failure> {
            let bytes = match format {
                #[cfg(feature = "pdf")]
                PageFormat::Pdf => crate::format::pdf_pages(&feedback.sheets(), Some(FEEDBACK_MARK))
                    .map_err(|error| Failure::unclear(error.to_string()))?,
                PageFormat::Html => feedback.html().into_bytes(),
            };
            Ok((self.path(form, *format), bytes))
        };
        self.formats.iter().map(file).collect()
    }
}

/// Refuses to write over a file that is no page for a student.
fn refuse_foreign(page: &Path) -> Result<(), Failure> {
    let Ok(found) = fs::metadata(page) else {
        return Ok(());
    };
    let mark = FEEDBACK_MARK.as_bytes();
    let is_own = || fs::read(page).is_ok_and(|bytes| bytes.windows(mark.len()).any(|part| part == mark));
    if found.is_file() && is_own() {
        return Ok(());
    }
    Err(Failure::misuse(
        format!("{} is there already, is no page for a student and is not overwritten", page.display()),
        "choose another folder after --feedback",
    ))
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
