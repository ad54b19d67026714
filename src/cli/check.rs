use super::class::{Class, ReportFormat};
use super::correction::Correction;
use super::files::{self, Source};
use super::message::Failure;
use super::pencil::Hand;
use super::wording::Words;
use super::work::{Mode, show_warnings, solve};
use crate::check::{self, AnswerKey, CheckError, EmptyForm, MarkScheme, Marks, Measured};
use crate::construction::Solution;
use crate::format;
use crate::motion::Order;
use crate::words::Wording;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// Text of `--help` behind the options.
const AFTER_HELP: &str = "\
Exit code: 0 no value is off, 1 some are, 2 something is not understood; of a folder: 0 all files are passed, 1 some are not, 2 some are
not understood (their rows say why; the table is written all the same).

Examples:
  kinegon check scene.json values.json                        one drawing
  kinegon check scene.json --template > form.json             the empty form
  kinegon check scene.json class/ -o report.csv               all *.json and *.csv in the folder, a row each
  kinegon check scene.json class/ --marks marks.json          with marks";

/// Check values read from a hand drawing, or those of a class.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Check {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
    /// File with the values: JSON, or a table as CSV; `-` for stdin. Or a folder with such files, those of a class:
    /// then a table is printed, a row for each.
    #[arg(required_unless_present = "template")]
    measured: Option<PathBuf>,
    /// Print an empty form in place of a check: every quantity of the steps, in order.
    #[arg(long, value_name = "FORMAT", num_args = 0..=1, default_missing_value = "json", conflicts_with = "measured")]
    template: Option<TemplateFormat>,
    /// Print verdicts and diagnosis as JSON.
    #[arg(long)]
    json: bool,
    /// File for the table of a folder: .csv, .json or .jsonl; `-` for stdout.
    #[arg(short, long, value_name = "FILE", conflicts_with = "template")]
    output: Option<PathBuf>,
    /// Marking scheme: how many marks the quantities are worth (JSON, `kinegon schema marks`).
    #[arg(long, value_name = "FILE", conflicts_with = "template")]
    marks: Option<PathBuf>,
    /// How many mistakes at once are looked for.
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u8).range(1..=6))]
    depth: u8,
    #[command(flatten)]
    mode: Mode,
    #[command(flatten)]
    words: Words,
    #[command(flatten)]
    hand: Hand,
    #[command(flatten)]
    correction: Correction,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum TemplateFormat {
    Json,
    Csv,
}

impl Check {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let solution = solve(&source, self.mode.number, |figure| self.words.put_into(figure), |_| Order::Acceleration)?;
        let Some(path) = &self.measured else {
            return self.print_template(&solution);
        };
        self.correction.refuse_drawing_options(path.is_dir())?;
        let key = self.key(&solution);
        let wording = Wording::of(&solution.scene.figure);
        let scheme = self.scheme(&key)?;
        if path.is_dir() {
            return self.class(path, &solution, &key, scheme.as_ref());
        }
        if self.output.is_some() {
            return Err(Failure::Misuse(
                "-o takes the table of a folder; here is one form".into(),
                Some("leave out -o: the report is printed".into()),
            ));
        }
        let text = files::read_text("form", path)?;
        let measured = read(path, &text)?;
        let checked = check::check(&measured, &key).map_err(|error| misuse(&text, &error))?;
        let marks = scheme.map(|scheme| scheme.award(&checked));
        let printed = if self.json {
            let mut result = check::check_result(&checked, &key, &wording, measured.name.clone());
            result.marks = marks;
            format::json(&result)
        } else {
            let marks = marks.map_or_else(String::new, |marks| marks.line(&wording) + "\n");
            check::report(&checked, &key, &wording) + &marks
        };
        show_warnings(&solution);
        self.correction.write(&solution, [&self.scene, path], &measured, &key, &checked)?;
        files::print(printed.as_bytes())?;
        if checked.is_passed() { Ok(()) } else { Err(Failure::NotPassed) }
    }

    /// Checks the forms of a folder and writes their table.
    fn class(
        &self,
        folder: &Path,
        solution: &Solution,
        key: &AnswerKey<'_>,
        scheme: Option<&MarkScheme>,
    ) -> Result<(), Failure> {
        let output = self.output.as_deref().unwrap_or(Path::new("-"));
        for (what, input) in [("scene", Some(&self.scene)), ("marking scheme", self.marks.as_ref())] {
            input.map_or(Ok(()), |input| files::refuse_overwriting(what, input, output))?;
        }
        let format = ReportFormat::of(output, self.json)?;
        show_warnings(solution);
        let class = Class {
            folder,
            others: [Some(&self.scene), self.marks.as_deref()],
            key,
            words: &Wording::of(&solution.scene.figure),
            scheme,
            format,
            output,
        };
        class.run()
    }

    /// The marks that the quantities are worth; `None` without a marking scheme.
    fn scheme(&self, key: &AnswerKey<'_>) -> Result<Option<MarkScheme>, Failure> {
        let Some(path) = &self.marks else {
            return Ok(None);
        };
        let text = files::read_text("marking scheme", path)?;
        let marks = Marks::read(&text.text).map_err(|error| text.fail(error))?;
        let scheme = marks.of(key).map_err(|error| misuse(&text, &error))?;
        Ok(Some(scheme))
    }

    fn print_template(&self, solution: &Solution) -> Result<(), Failure> {
        let form = EmptyForm { solution, scales: solution.scales(), exercise: None };
        let text = match self.template.unwrap_or(TemplateFormat::Json) {
            TemplateFormat::Json => form.json(),
            TemplateFormat::Csv => form.csv(),
        };
        files::print(text.as_bytes())
    }

    fn key<'a>(&self, solution: &'a Solution) -> AnswerKey<'a> {
        AnswerKey {
            solution,
            scales: solution.scales(),
            tolerance: self.hand.tolerance(),
            depth: usize::from(self.depth),
        }
    }
}

/// The values of a form: JSON if it begins with a bracket and the file's name does not end in `.csv`, else CSV.
pub(super) fn read(path: &Path, text: &Source) -> Result<Measured, Failure> {
    let is_table = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    if !is_table && text.text.trim_start_matches(['\u{feff}', ' ', '\n', '\r', '\t']).starts_with(['{', '[']) {
        Measured::read_json(&text.text).map_err(|error| text.fail(error))
    } else {
        Measured::read_csv(&text.text).map_err(|error| misuse(text, &error))
    }
}

fn misuse(source: &Source, error: &CheckError) -> Failure {
    Failure::Misuse(format!("{}: {error}", source.name), error.hint.clone())
}
