use super::check::arms;
use super::figures::{stem, style_names};
use super::files;
use super::message::{Failure, Source, note, refuse};
use super::options::{Look, Markers, NamesAnd};
use super::output::{FileSet, is_stream};
use super::solve::solve;
use super::style::GivenStyle;
use crate::board::{Given, own_drawing};
use crate::course::{Question, canvas, moodle, scorm};
use crate::exercise::{Exercise, Exercises};
use crate::format::{self, Text};
use crate::scene::{Figure, Kind, SizeLimit};
use crate::sheet::Order;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

const AFTER_HELP: &str = "\
Writes DIR/KIND-SEED-1, DIR/KIND-SEED-2 …, each with scene.json, the student's sheets (sheet.svg, sheet-2.svg …, \
all in sheet.pdf), the empty form \
(form.json, form.csv) and for the teacher the drawn key (key.svg, key.pdf), its values (key.json) and its construction for the drawing board \
(key-drawing.json). Numbers are round; lines cross \
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
    /// Marks that must be reached, in per cent: the course then says passed or failed. With `--lms scorm`.
    #[arg(long, value_name = "PERCENT", value_parser = clap::value_parser!(u8).range(0..=100))]
    pass: Option<u8>,
    /// Drawing style: paper, print, lecture, board, or the path of a style file.
    #[arg(long, value_name = "NAME|FILE", value_parser = style_names(), hide_possible_values = true)]
    style: Option<String>,
    /// Ask for the arms that the force polygons need, too.
    #[arg(long)]
    arms: bool,
    #[command(flatten)]
    look: Look,
    #[command(flatten)]
    markers: Markers,
}

impl ExerciseCommand {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let (name, source) = self.source()?;
        let style = GivenStyle::read(self.style.as_deref())?;
        let override_figure = |figure: &mut Figure| {
            self.look.put_into(figure);
            self.markers.put_into(figure);
            style.put_into(figure);
        };
        let solution = solve(&source, SizeLimit::HAND, None, override_figure, |_| Order::Acceleration)?;
        source.checked(solution.check_form())?;
        let page = self.look.paper.is_given().then_some(solution.scene.figure.page);
        let mut exercises = Exercises::new(&solution, page, self.seed).map_err(|error| {
            Failure::misuse(format!("{}: {error}", source.name), "`kinegon new --list` shows other kinds")
        })?;
        if self.arms {
            arms(&solution)?;
            exercises = exercises.with_arms();
        }
        if self.pass.is_some() && self.lms != Some(Lms::Scorm) {
            return refuse(
                "only a SCORM package says what must be reached".to_owned(),
                "add `--lms scorm`, or leave `--pass` out",
            );
        }
        if let Some(lms) = self.lms {
            return self.write_course(lms, &mut exercises, &name, &style, &source.name);
        }
        let folder = |number: u16| self.output.join(format!("{name}-{}-{number}", self.seed));
        if let Some(folder) = (1..=self.count).map(folder).find(|folder| folder.exists()) {
            let message = format!("{} is there already and is not overwritten", folder.display());
            return refuse(message, "choose another folder or another seed, or remove it");
        }
        let mut files = FileSet::default();
        for number in 1..=self.count {
            let exercise = exercises.next().map_err(|error| Failure::outside(format!("{}: {error}", source.name)))?;
            add_files(&mut files, &exercise, &style, &folder(number))?;
        }
        exercises.evened().iter().for_each(|changes| note(&changes.to_string()));
        files.finish()
    }

    /// Writes exercises into one file for a learning management system, or to stdout; `name` is theirs, `source` the scene's
    /// in messages.
    fn write_course(
        &self,
        lms: Lms,
        exercises: &mut Exercises,
        name: &str,
        style: &GivenStyle,
        source: &str,
    ) -> Result<(), Failure> {
        lms.refuse_other_files(&self.output)?;
        files::refuse_overwriting("scene", Path::new(source), &self.output)?;
        let mut questions = Vec::new();
        for number in 1..=self.count {
            let mut exercise = exercises.next().map_err(|error| Failure::outside(format!("{source}: {error}")))?;
            style.put_on([&mut exercise.sheet]);
            let of = format!("{}-{}", plain(name), self.seed);
            let width = self.count.to_string().len();
            let (name, listed) = (format!("{of}-{number}"), format!("{of}-{number:0width$}"));
            let question = Question::new(&exercise, &name, &listed, &|key| style.put_on([key]));
            questions.push(question.map_err(|error| Failure::unclear(format!("{source}: {error}")))?);
        }
        exercises.evened().iter().for_each(|changes| note(&changes.to_string()));
        let written = match lms {
            Lms::Moodle => moodle(name, &questions),
            Lms::Canvas => canvas(&questions),
            Lms::Scorm => scorm(name, &questions, self.pass),
        };
        files::write(&self.output, &written.map_err(Failure::outside)?)
    }

    /// The scene that is varied, and the name of its exercises.
    fn source(&self) -> Result<(String, Source), Failure> {
        if let Some(Kind { name, text }) = Kind::named(&self.kind) {
            return Ok((name.to_owned(), Source::new(name.to_owned(), text)));
        }
        let path = Path::new(&self.kind);
        if !path.is_file() {
            return refuse(
                format!("`{}` is no kind of mechanism and no file", self.kind),
                format!(
                    "the nearest kind is `{}`; `kinegon new --list` shows all, or give the path of a scene file",
                    Kind::nearest(&self.kind)
                ),
            );
        }
        Ok((stem(path), files::read(path)?))
    }
}

/// Adds the files of an exercise to a set. Its sheets are `sheet.svg`, `sheet-2.svg` …, and, with the feature `pdf`, `sheet.pdf`.
fn add_files(files: &mut FileSet, exercise: &Exercise, style: &GivenStyle, folder: &Path) -> Result<(), Failure> {
    let mut add = |name: &str, bytes: &[u8]| files.add(&folder.join(name), bytes);
    add("scene.json", exercise.text.as_bytes())?;
    let own_name = folder.file_name().unwrap_or_default().to_string_lossy();
    let sheets = exercise.sheets(&own_name);
    if sheets.len() > 1 && sheets[0].code.is_none() {
        note(&format!("{own_name}: no room for markers beside its scheme; its sheets for the plans have them"));
    }
    for (name, mut sheets) in [("sheet", sheets), ("key", vec![exercise.key_sheet()])] {
        style.put_on(&mut sheets);
        for (sheet, number) in sheets.iter().zip(1..) {
            let name = if number == 1 { format!("{name}.svg") } else { format!("{name}-{number}.svg") };
            add(&name, format::svg_with(sheet, Text::Letters).as_bytes())?;
        }
        #[cfg(feature = "pdf")]
        add(&format!("{name}.pdf"), &format::pdf_pages(&sheets, None).map_err(Failure::unclear)?)?;
    }
    let form = exercise.form(&own_name);
    add("form.json", form.json(&exercise.solution).as_bytes())?;
    add("form.csv", form.csv(&exercise.solution).as_bytes())?;
    add("key.json", format::json(&exercise.key()).as_bytes())?;
    let own = own_drawing(&Given::new(&exercise.solution), &exercise.solution.scales());
    add("key-drawing.json", own.as_bytes())
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
    /// Refuses a folder, and a name whose ending says something else.
    fn refuse_other_files(self, path: &Path) -> Result<(), Failure> {
        let ending = if self == Lms::Moodle { "xml" } else { "zip" };
        if is_stream(path) {
            return Ok(());
        }
        let name = self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned());
        let hint = |more: &str| format!("`--lms {name}` writes one file; {more} `.{ending}`");
        if files::is_folder(path) {
            return refuse(format!("{} is a folder", path.display()), hint("give its name, too, which ends in"));
        }
        if path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending)) {
            return Ok(());
        }
        refuse(format!("{} is no name for the file of a course", path.display()), hint("let its name end in"))
    }
}

/// A name as names of files in addresses have it: letters, digits and hyphens of ASCII.
fn plain(name: &str) -> String {
    let letters = name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' });
    letters.take(60).collect()
}
