use super::board;
use super::class::{Class, Form, ReportFormat, Subject};
use super::feedback::{Correction, FeedbackOptions, Pages};
use super::files;
use super::forms::{ExerciseFiles, ExerciseFolder, file_name, forms, measured, read, text_in_folder};
use super::message::{Failure, Source, passed, refuse, warn};
use super::options::{Hand, Words};
use super::output::FileSet;
use super::pieces::caught;
use super::solve::{Mode, show_warnings, solve};
use crate::board::HandDrawing;
use crate::check::{self, AnswerKey, ClassColumns, Feedback, MarkScheme, Marks, Measured, Prepared};
use crate::construction::Solution;
use crate::cores::on_all_cores;
use crate::exercise::ExerciseError;
use crate::format;
use crate::scene::{Figure, SizeLimit};
use crate::sheet::Order;
use crate::words::Wording;
use clap::Args;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

const AFTER_HELP: &str = "\
Without --pencil-mm and --pencil-degrees the tolerance follows the hand that the scatter of all values shows, up to ±1 mm and ±1°.

Exit code: 0 all that the scene asks for is there and right (by its `form`, else by all its steps), 1 something is off, missing or tells \
nothing, 2 something is not understood; of a folder: 0 all files are passed, 1 some are not, \
2 some are not understood (their rows say why; the table is written all the same).

Examples:
  kinegon check scene.json values.json                 one drawing
  kinegon check scene.json --template > form.json      the empty form
  kinegon check scene.json class/ -o report.csv        a row for each form
  kinegon check scene.json class/ --marks marks.json   with marks
  kinegon check exercises/ class/ -o report.csv        each form by its exercise
  kinegon check scene.json class/ --feedback pages/    a page for each student
  kinegon check scene.json Ana-2.jpg Ana-3.jpg -o out/ photographs of the sheets
  kinegon check exercises/ photos/ -o forms/           a form for each student";

#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Check {
    /// Scene file, `-` for stdin. Or a folder of exercises, as `kinegon exercise` writes them: then each form is checked
    /// against its own, which it names as `exercise`, or which its file's name or its folder's name contains.
    pub(super) scene: PathBuf,
    /// File with the values: JSON, or a table as CSV; `-` for stdin. Or a folder with such files, those of a class:
    /// then a table is printed, a row for each.
    /// Or a photograph of a sheet with markers, JPEG or PNG, or a folder of them.
    #[arg(required_unless_present = "template")]
    pub(super) measured: Option<PathBuf>,
    /// Photographs of the same student's other sheets.
    #[arg(value_name = "PHOTOGRAPH")]
    pub(super) further: Vec<PathBuf>,
    /// Take the places of points that pencil lines in a photograph show as they are, and check them.
    #[arg(long)]
    pub(super) accept: bool,
    /// Print an empty form in place of a check: every quantity of the steps, in order.
    #[arg(long, value_name = "FORMAT", num_args = 0..=1, default_missing_value = "json", conflicts_with = "measured",
        value_parser = ["json", "csv"])]
    template: Option<String>,
    /// With boxes for the arms that the force polygons need, too.
    #[arg(long, requires = "template")]
    arms: bool,
    /// Print verdicts and diagnosis as JSON.
    #[arg(long)]
    json: bool,
    /// File for the table of a folder: .csv, .json or .jsonl; `-` for stdout. Of photographs the folder for the straightened sheets with the right
    /// plans over them, and for the forms with the places of the points.
    #[arg(short, long, value_name = "FILE|DIR", conflicts_with = "template")]
    pub(super) output: Option<PathBuf>,
    /// Marking scheme: how many marks the quantities are worth (JSON, `kinegon schema marks`).
    #[arg(long, value_name = "FILE", conflicts_with = "template")]
    pub(super) marks: Option<PathBuf>,
    /// How many mistakes at once are looked for.
    #[arg(long, default_value_t = check::DEPTH as u8, value_parser = clap::value_parser!(u8).range(1..=6))]
    depth: u8,
    #[command(flatten)]
    mode: Mode,
    #[command(flatten)]
    words: Words,
    #[command(flatten)]
    hand: Hand,
    #[command(flatten)]
    feedback: FeedbackOptions,
    #[command(flatten)]
    correction: Correction,
}

/// The names of the arms that a form may ask for; refuses a scene that has none.
pub(super) fn arms(solution: &Solution) -> Result<Vec<String>, Failure> {
    let arms = check::arm_names(solution);
    match arms.is_empty() {
        true => refuse(
            "no arms are measured: the figure has no force polygons",
            "give loads and add the panel `\"forces\"` to `figure`, or leave `--arms` out",
        ),
        false => Ok(arms),
    }
}

/// Adds boxes for arms to the form of a scene.
fn ask_for_arms(solution: &mut Solution) -> Result<(), Failure> {
    let arms = arms(solution)?;
    let names = check::asked_names(solution).into_iter().chain(arms);
    let own = solution.scene.form.take().unwrap_or_default();
    solution.scene.form = Some(names.map(|name| (name.clone(), own.get(&name).copied().unwrap_or(1.0))).collect());
    Ok(())
}

impl Check {
    pub(super) fn run(&self) -> Result<(), Failure> {
        if self.photographs()? {
            return Ok(());
        }
        if self.scene.is_dir() {
            return self.exercises();
        }
        let mut solution = self.solved(&self.scene)?;
        let Some(path) = &self.measured else {
            if let Err(nothing) = ExerciseError::refuse_nothing(&solution) {
                return Err(Failure::unclear(nothing.to_string()));
            }
            if self.arms {
                ask_for_arms(&mut solution)?;
            }
            let form = Measured::empty(solution.scales(), None);
            let is_csv = self.template.as_deref() == Some("csv");
            return files::print(if is_csv { form.csv(&solution) } else { form.json(&solution) }.as_bytes());
        };
        self.correction.refuse_drawing_options(path.is_dir())?;
        if path.is_dir() {
            return self.class(path, &solution);
        }
        let text = self.read(path)?;
        if HandDrawing::is_one(&text.text) {
            return self.drawing(None, &solution, &text);
        }
        let measured = read(path, &text)?;
        self.form(&ExerciseFiles::of_scene(&self.scene), &solution, &text, &measured)
    }

    /// Checks the forms of a folder against the scene or the exercises.
    pub(super) fn forms_of(&self, folder: &Path) -> Result<(), Failure> {
        if self.scene.is_dir() {
            self.classes(&ExerciseFolder::read(&self.scene)?, folder)
        } else {
            self.class(folder, &self.solved(&self.scene)?)
        }
    }

    pub(super) fn solved(&self, scene: &Path) -> Result<Solution, Failure> {
        let source = files::read(scene)?;
        let override_figure = |figure: &mut Figure| self.words.put_into(figure);
        let solution = solve(&source, SizeLimit::HAND, self.mode.number, override_figure, |_| Order::Acceleration)?;
        source.checked(solution.check_form())?;
        Ok(solution)
    }

    /// Reads one form, or a drawing.
    fn read(&self, path: &Path) -> Result<Source, Failure> {
        if self.output.is_some() {
            let hint = "leave out -o: the report is printed";
            return refuse("-o takes the table of a folder; here is one form", hint);
        }
        files::read_form(path)
    }

    /// Judges one drawing; the marks of its exercise go before those of the command.
    fn drawing(&self, own: Option<&Path>, solution: &Solution, text: &Source) -> Result<(), Failure> {
        show_warnings(solution);
        let marks = own.or(self.marks.as_deref()).map(GivenMarks::read).transpose()?;
        board::judge(&self.subject(None, solution, marks.as_ref())?, text, self.json)
    }

    /// Checks one form and prints its report.
    pub(super) fn form(
        &self,
        exercise: &ExerciseFiles,
        solution: &Solution,
        text: &Source,
        measured: &Measured,
    ) -> Result<(), Failure> {
        let path = self.measured.as_deref().unwrap_or(Path::new("-"));
        let own = exercise.marks();
        let marks = own.as_deref().or(self.marks.as_deref()).map(GivenMarks::read).transpose()?;
        let with_centers = measured.with_centers(solution);
        let solution = with_centers.as_ref().unwrap_or(solution);
        let Subject { key: prepared, scheme, .. } = self.subject(None, solution, marks.as_ref())?;
        let key = prepared.key();
        let name = file_name(Path::new(path.file_name().unwrap_or_default()), path);
        let pages = self.feedback.pages([name.for_comparing()])?;
        let checked = prepared.check(measured).map_err(|error| text.misuse(&error))?;
        let marks = scheme.map(|scheme| scheme.award(&checked));
        let printed = if self.json {
            let mut result = check::check_result(&checked, key, measured.name.clone());
            result.marks = marks;
            format::json(&result)
        } else {
            let marks = marks.as_ref().map_or_else(String::new, |marks| marks.line(&solution.wording()) + "\n");
            check::report(&checked, key) + &marks
        };
        show_warnings(solution);
        let mut files = FileSet::default();
        self.correction.write(&mut files, [&exercise.scene, path], measured, key, &checked)?;
        if let Some(pages) = pages {
            let feedback = Feedback::new(measured, key, &checked, marks.as_ref());
            files.add_all(&pages.of(0, &feedback.map_err(|error| text.misuse(&error))?)?)?;
        }
        files::print_text(&printed)?;
        files.finish()?;
        passed(usize::from(!checked.is_passed()), 0)
    }

    /// Checks the forms of a folder, all of one scene, and writes their table.
    fn class(&self, folder: &Path, solution: &Solution) -> Result<(), Failure> {
        let marks = self.marks.as_deref().map(GivenMarks::read).transpose()?;
        let report = self.report()?;
        let mut others = ExerciseFiles::of_scene(&self.scene).others();
        others.extend(self.marks.iter().chain([&report.0]).cloned());
        let form = |path: PathBuf| Form { file: file_name(&path, folder), path, exercise: Ok(0), remark: None };
        let forms: Vec<Form> = forms(folder, false, &others)?.into_iter().map(form).collect();
        let with_centers = with_centers(solution, &forms);
        let solution = with_centers.as_ref().unwrap_or(solution);
        let subject = self.subject(None, solution, marks.as_ref())?;
        show_warnings(solution);
        let pages = self.feedback.pages(forms.iter().map(|form| form.file.for_comparing()))?;
        self.write_report(folder, report, &forms, &[Ok(subject)], pages)
    }

    /// Writes the table of a class.
    fn write_report(
        &self,
        folder: &Path,
        (output, format): (PathBuf, ReportFormat),
        forms: &[Form],
        exercises: &[Result<Subject<'_>, String>],
        pages: Option<Pages>,
    ) -> Result<(), Failure> {
        let solved = || exercises.iter().flatten();
        let columns =
            ClassColumns { exercise: self.scene.is_dir(), marks: solved().any(|subject| subject.scheme.is_some()) };
        // Without any exercise that can be solved the report is worded as the options say.
        let mut usual = Figure::default();
        self.words.put_into(&mut usual);
        let words = solved().next().map(|subject| subject.key.key().solution.wording());
        let words = &words.unwrap_or_else(|| Wording::of(&usual));
        Class { folder, forms, exercises, columns, format, output: &output, pages, words }.run()
    }

    /// The file of a table and its format; refuses to write over what was read.
    fn report(&self) -> Result<(PathBuf, ReportFormat), Failure> {
        // With `--accept` the folder of the output has the forms.
        let output = self.output.as_deref().filter(|_| !self.accept).unwrap_or(Path::new("-"));
        for (what, input) in [("scene", Some(&self.scene)), ("marking scheme", self.marks.as_ref())] {
            input.map_or(Ok(()), |input| files::refuse_overwriting(what, input, output))?;
        }
        Ok((output.to_owned(), ReportFormat::of(output, self.json)?))
    }

    /// Checks one form or a folder of forms, each against its own of the exercises in a folder.
    fn exercises(&self) -> Result<(), Failure> {
        let exercises = ExerciseFolder::read(&self.scene)?;
        let hint = format!("name one of its scenes, as {}", exercises.all[0].scene.display());
        if self.mode.number.is_some() {
            return refuse("--mode is of one scene, here is a folder of exercises", hint);
        }
        let Some(path) = &self.measured else {
            return refuse("--template writes the form of one scene, here is a folder of exercises", hint);
        };
        self.correction.refuse_drawing_options(path.is_dir())?;
        if path.is_dir() {
            return self.classes(&exercises, path);
        }
        let text = self.read(path)?;
        let drawn = board::exercise(&text.text);
        let measured = if drawn.is_some() { Measured::default() } else { read(path, &text)? };
        let named = drawn.as_ref().map_or(measured.exercise.as_ref(), Option::as_ref);
        let index = exercises.of_form(named, path);
        let index = index.map_err(|message| Failure::unclear(format!("{}: {message}", text.name)))?;
        if let Some(remark) = path.file_name().and_then(|file| exercises.contradiction(index, Path::new(file))) {
            warn(&format!("{}: {remark}", text.name));
        }
        let exercise = &exercises.all[index];
        let solution = self.solved(&exercise.scene)?;
        if drawn.is_some() {
            return self.drawing(exercise.marks().as_deref(), &solution, &text);
        }
        self.form(exercise, &solution, &text, &measured)
    }

    /// Checks the forms of a folder, each against its own exercise, and writes their joint table.
    fn classes(&self, exercises: &ExerciseFolder, folder: &Path) -> Result<(), Failure> {
        let report = self.report()?;
        let mut others: Vec<PathBuf> = exercises.all.iter().flat_map(ExerciseFiles::others).collect();
        others.extend(self.marks.clone());
        for other in &others {
            files::refuse_overwriting("exercise", other, &report.0)?;
        }
        others.push(report.0.clone());
        let form = |path: &PathBuf| {
            let inside = path.strip_prefix(folder).unwrap_or(path);
            // A form that is not understood says so in its row, whatever its exercise.
            let drawn = || text_in_folder(path).ok().and_then(|text| board::exercise(&text.text)).flatten();
            let named = measured(path).map_or_else(|_| drawn(), |measured| measured.exercise);
            let exercise = exercises.of_form(named.as_ref(), inside);
            let remark = exercise.as_ref().ok().and_then(|index| exercises.contradiction(*index, inside));
            Form { path: path.clone(), file: file_name(path, folder), exercise, remark }
        };
        let forms: Vec<Form> = on_all_cores(&forms(folder, true, &others)?, form);
        let pages = self.feedback.pages(forms.iter().map(|form| form.file.for_comparing()))?;
        let used: BTreeSet<usize> = forms.iter().filter_map(|form| form.exercise.clone().ok()).collect();
        let solved = self.all_solved(exercises, &used);
        let usual = self.marks.as_deref().map(GivenMarks::read).transpose()?;
        let mut subjects = Vec::new();
        for ((index, exercise), solution) in exercises.all.iter().enumerate().zip(&solved) {
            subjects.push(match solution {
                Ok(solution) => {
                    let is_used = used.contains(&index);
                    let own = exercise.marks().filter(|_| is_used).map(|own| GivenMarks::read(&own)).transpose()?;
                    let marks = own.as_ref().or(usual.as_ref()).filter(|_| is_used);
                    Ok(self.subject(Some(&exercise.name), solution, marks)?)
                }
                Err(message) => Err(message.clone()),
            });
        }
        self.write_report(folder, report, &forms, &subjects, pages)
    }

    /// The exercises, solved; of those that cannot be solved a message. Those that no form is `used` for are there because somebody may
    /// have handed in their values for another one.
    fn all_solved(&self, exercises: &ExerciseFolder, used: &BTreeSet<usize>) -> Vec<Result<Solution, String>> {
        let all: Vec<usize> = (0..exercises.all.len()).collect();
        let solved = on_all_cores(&all, |index| {
            let exercise = &exercises.all[*index];
            let place = exercise.scene.display().to_string();
            let solved = caught(|| self.solved(&exercise.scene));
            let solved = solved.and_then(|solved| solved.map_err(|failure| failure.line(&place)));
            solved.map_err(|why| format!("its exercise {} cannot be solved: {why}", exercise.name))
        });
        for index in used {
            let (exercise, solution) = (&exercises.all[*index], &solved[*index]);
            let warnings = solution.iter().flat_map(Solution::warnings);
            warnings.for_each(|warning| warn(&format!("{}: {warning}", exercise.name)));
        }
        solved
    }

    /// What forms are checked against; `name` is that of the exercise where there are several.
    fn subject<'a>(
        &self,
        name: Option<&'a str>,
        solution: &'a Solution,
        marks: Option<&GivenMarks>,
    ) -> Result<Subject<'a>, Failure> {
        let key = self.key(solution);
        let scheme = marks.map(|marks| marks.of(&key, name)).transpose()?;
        Ok(Subject { name, key: Prepared::new(&key), scheme })
    }

    pub(super) fn key<'a>(&self, solution: &'a Solution) -> AnswerKey<'a> {
        let hand = self.hand.is_given().then(|| self.hand.tolerance());
        AnswerKey { depth: usize::from(self.depth), ..AnswerKey::new(solution, hand) }
    }
}

/// The solution with the instant centres that any of these forms names; none where the figure has them, or no form names one.
fn with_centers(solution: &Solution, forms: &[Form]) -> Option<Solution> {
    let understood = || forms.iter().filter_map(|form| measured(&form.path).ok());
    let values = || understood().flat_map(|measured| measured.values).collect();
    solution
        .construction
        .centers
        .is_none()
        .then(|| Measured { values: values(), ..Measured::default() })?
        .with_centers(solution)
}

/// A marking scheme as it was read.
struct GivenMarks {
    text: Source,
    marks: Marks,
}

impl GivenMarks {
    fn read(path: &Path) -> Result<GivenMarks, Failure> {
        let text = files::read_text("marking scheme", path)?;
        let marks = text.checked(Marks::read(&text.text))?;
        Ok(GivenMarks { text, marks })
    }

    /// The marks that the quantities of an exercise are worth; `exercise` is its name where there are several.
    fn of(&self, key: &AnswerKey<'_>, exercise: Option<&str>) -> Result<MarkScheme, Failure> {
        self.marks.of(key).map_err(|error| match exercise {
            Some(exercise) => {
                let message = format!("{}: it does not fit exercise {exercise}: {error}", self.text.name);
                let hint = error.hint.unwrap_or_else(|| "an exercise may have marks.json in its folder".into());
                Failure::misuse(message, hint)
            }
            None => self.text.misuse(&error),
        })
    }
}
