use super::figures::{GivenStyle, stem, style_names};
use super::files;
use super::message::{Failure, Source, note};
use super::options::{GivenScales, Markers, NamesAnd, Paper, Words};
use super::output::{FileSet, is_special};
use super::work::solve;
use crate::course::{Question, canvas, moodle, scorm};
use crate::drawing::Drawing;
use crate::exercise::{Exercise, ExerciseError, Exercises};
use crate::format::{self, Text};
use crate::scene::{Figure, Kind, SizeLimit};
use crate::sheet::Sheet;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

const AFTER_HELP: &str = "\
Writes DIR/KIND-SEED-1, DIR/KIND-SEED-2 …, each with scene.json, the student's sheets (sheet.svg, sheet-2.svg …, \
all in sheet.pdf), the empty form \
(form.json, form.csv) and for the teacher the drawn key (key.svg, key.pdf) and its values (key.json). Numbers are round; lines cross \
at 20° or more, special points are on the sheet, measured segments have 5 mm or more, and a careful hand finds every rate to 15 %. \
The same seed gives the same files.

Examples:
  kinegon exercise four-bar --seed 7 --count 30 -o class/  thirty of one kind
  kinegon exercise scene.json --seed 1 -o class/           of your own scene
  kinegon exercise four-bar --seed 7 --no-markers -o class/  one plain sheet

Into a course, as one file (docs/courses.md):
  kinegon exercise four-bar --seed 7 --lms moodle -o quiz.xml  a category of cloze questions
  kinegon exercise four-bar --seed 7 --lms canvas -o quiz.zip  quizzes in QTI 1.2
  kinegon exercise four-bar --seed 7 --lms scorm -o task.zip   the workbench, SCORM 1.2";

/// Write exercises to be drawn by hand, with sheets, forms and keys.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct ExerciseCommand {
    /// Kind of mechanism, as `kinegon new --list` shows them, or the path of a scene file.
    #[arg(value_name = "KIND|FILE", value_parser = NamesAnd(Kind::NAMES.to_vec()), hide_possible_values = true)]
    kind: String,
    /// Which exercises: a number that gives the same ones again.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    seed: u64,
    /// How many.
    #[arg(long, value_name = "M", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1000))]
    count: u16,
    /// Folder to write them to; a folder of an exercise that is there already is never written over. With `--lms` the file to write.
    #[arg(short, long, value_name = "DIR|FILE")]
    output: PathBuf,
    /// Write one file for a learning management system in place of folders.
    #[arg(long, value_name = "SYSTEM", value_enum)]
    lms: Option<Lms>,
    /// Drawing style: paper, print, lecture, board, or the path of a style file.
    #[arg(long, value_name = "NAME|FILE", value_parser = style_names(), hide_possible_values = true)]
    style: Option<String>,
    #[command(flatten)]
    words: Words,
    #[command(flatten)]
    paper: Paper,
    #[command(flatten)]
    scales: GivenScales,
    #[command(flatten)]
    markers: Markers,
}

impl ExerciseCommand {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let (name, source) = self.source()?;
        let style = GivenStyle::read(self.style.as_deref())?;
        let override_figure = |figure: &mut Figure| {
            self.words.put_into(figure);
            self.paper.put_into(figure);
            self.scales.put_into(figure);
            self.markers.put_into(figure);
            style.put_into(figure);
        };
        let solution = solve(&source, SizeLimit::HAND, None, override_figure, |_| Sheet::Acceleration)?;
        let (figure, construction) = (&solution.scene.figure, &solution.construction);
        let failed = |error: ExerciseError| failed(&source.name, &error);
        let page = self.paper.is_given().then_some(figure.page);
        let exercises = Exercises::new(&source.text, figure, page, construction, self.seed);
        let mut exercises = exercises.map_err(|error| {
            let hint = "`kinegon new --list` shows other kinds";
            Failure::misuse(format!("{}: {error}", source.name), hint)
        })?;
        if let Some(lms) = self.lms {
            return lms.write(&mut exercises, (&name, self.seed, self.count), &style, (&source.name, &self.output));
        }
        let folder = |number: u16| self.output.join(format!("{name}-{}-{number}", self.seed));
        for folder in (1..=self.count).map(folder) {
            if folder.exists() {
                let message = format!("{} is there already and is not overwritten", folder.display());
                let hint = "choose another folder or another seed, or remove it";
                return Err(Failure::misuse(message, hint));
            }
        }
        let mut files = FileSet::default();
        for number in 1..=self.count {
            let exercise = exercises.next().map_err(failed)?;
            files.add_all(&files_of(&exercise, &style, &folder(number))?)?;
        }
        files.finish()
    }

    /// The scene that is varied, and the name of its exercises.
    fn source(&self) -> Result<(String, Source), Failure> {
        if let Some(Kind { name, text }) = Kind::named(&self.kind) {
            return Ok((name.to_owned(), Source { name: name.to_owned(), text }));
        }
        let path = Path::new(&self.kind);
        if !path.is_file() {
            return Err(Failure::misuse(
                format!("`{}` is no kind of mechanism and no file", self.kind),
                format!(
                    "the nearest kind is `{}`; `kinegon new --list` shows all, or give the path of a scene file",
                    Kind::nearest(&self.kind)
                ),
            ));
        }
        Ok((stem(path), files::read(path)?))
    }
}

/// Why there is no further exercise.
fn failed(source: &str, error: &ExerciseError) -> Failure {
    Failure::outside(format!("{source}: {error}"))
}

/// The files of an exercise, by their paths.
fn files_of(exercise: &Exercise, style: &GivenStyle, folder: &Path) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut written = vec![("scene.json".to_owned(), exercise.text.clone().into_bytes())];
    let own_name = folder.file_name().unwrap_or_default().to_string_lossy();
    let sheets = exercise.sheets(&own_name);
    if sheets.len() > 1 && sheets[0].code.is_none() {
        note(&format!("{own_name}: no room for markers beside its scheme; its sheets for the plans have them"));
    }
    for (name, mut sheets) in [("sheet", sheets), ("key", vec![exercise.key_sheet()])] {
        style.put_on(&mut sheets);
        written.extend(pictures(name, &sheets)?);
    }
    let form = exercise.form(&own_name);
    for (name, text) in
        [("form.json", form.json()), ("form.csv", form.csv()), ("key.json", format::json(&exercise.key()))]
    {
        written.push((name.to_owned(), text.into_bytes()));
    }
    Ok(written.into_iter().map(|(name, bytes)| (folder.join(name), bytes)).collect())
}

/// Sheets as SVG, `name.svg`, `name-2.svg` …, and, with the feature `pdf`, as one PDF.
fn pictures(name: &str, sheets: &[Drawing]) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let svg = |(sheet, number): (&Drawing, usize)| {
        let name = if number == 1 { format!("{name}.svg") } else { format!("{name}-{number}.svg") };
        (name, format::svg_with(sheet, Text::Letters).into_bytes())
    };
    #[cfg_attr(not(feature = "pdf"), expect(unused_mut, reason = "the PDF comes last"))]
    let mut written: Vec<_> = sheets.iter().zip(1..).map(svg).collect();
    #[cfg(feature = "pdf")]
    {
        let pdf = format::pdf_pages(sheets, None).map_err(|error| Failure::unclear(error.to_string()))?;
        written.push((format!("{name}.pdf"), pdf));
    }
    Ok(written)
}

/// A kind of learning management system, by the file that it imports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Lms {
    /// Moodle XML: a question bank.
    Moodle,
    /// QTI 1.2, for Canvas.
    Canvas,
    /// SCORM 1.2, for any: the workbench, which reports a score.
    Scorm,
}

impl Lms {
    fn ending(self) -> &'static str {
        match self {
            Lms::Moodle => "xml",
            Lms::Canvas | Lms::Scorm => "zip",
        }
    }

    /// Writes so many exercises with that name and seed into one file, or to stdout. `source` names the scene in messages.
    fn write(
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
            questions.push(question.map_err(|error| Failure::unclear(format!("{source}: {error}")))?);
        }
        let written = match self {
            Lms::Moodle => moodle(name, &questions),
            Lms::Canvas => canvas(&questions),
            Lms::Scorm => scorm(name, &questions),
        };
        let bytes = written.map_err(Failure::outside)?;
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
        let hint = |more: &str| format!("`--lms {name}` writes one file; {more} `.{ending}`");
        if files::is_folder(path) {
            return Err(Failure::misuse(
                format!("{} is a folder", path.display()),
                hint("give its name, too, which ends in"),
            ));
        }
        let is_file = path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending));
        let message = format!("{} is no name for the file of a course", path.display());
        let hint = hint("let its name end in");
        if is_file { Ok(()) } else { Err(Failure::misuse(message, hint)) }
    }
}

/// A name as names of files in addresses have it: letters, digits and hyphens of ASCII.
fn plain(name: &str) -> String {
    let letters = name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' });
    letters.take(60).collect()
}
