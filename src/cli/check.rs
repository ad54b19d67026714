use super::correction::Correction;
use super::files::{self, Source};
use super::message::Failure;
use super::pencil::Hand;
use super::wording::Words;
use super::work::{Mode, Work, work};
use crate::check::{self, CheckError, Drawn, Measured};
use crate::drawing::scales;
use crate::format;
use crate::motion::Order;
use crate::words::Wording;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// Check values read from a hand drawing.
#[derive(Debug, Args)]
pub(super) struct Check {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
    /// File with the values: JSON, or a table as CSV; `-` for stdin.
    #[arg(required_unless_present = "template")]
    measured: Option<PathBuf>,
    /// Print an empty form in place of a check: every quantity of the steps, in order.
    #[arg(long, value_name = "FORMAT", num_args = 0..=1, default_missing_value = "json", conflicts_with = "measured")]
    template: Option<Form>,
    /// Print verdicts and diagnosis as JSON.
    #[arg(long)]
    json: bool,
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
enum Form {
    Json,
    Csv,
}

impl Check {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let work = work(
            &source,
            self.mode.number,
            |figure| self.words.put_into(figure),
            |_| Order::Acceleration,
        )?;
        let Some(path) = &self.measured else {
            return self.print_template(&work);
        };
        let text = files::read_text("form", path)?;
        let measured = read(path, &text)?;
        let drawn = self.drawn(&work);
        let checked = check::check(&measured, &drawn);
        let checked = checked.map_err(|error| misuse(&text, &error))?;
        let wording = Wording::of(&work.scene.figure);
        let printed = if self.json {
            let result = check::check_result(&checked, &drawn, &wording, measured.name.clone());
            format::json(&result)
        } else {
            check::report(&checked, &drawn, &wording)
        };
        work.warn();
        let files = [self.scene.as_path(), path];
        let correction = &self.correction;
        correction.write(&work, files, &measured, &drawn, &checked)?;
        files::print(printed.as_bytes())?;
        if checked.is_passed() {
            Ok(())
        } else {
            Err(Failure::NotPassed)
        }
    }

    fn print_template(&self, work: &Work) -> Result<(), Failure> {
        let scales = scales(&work.scene, &work.mechanism, &work.pose, &work.construction);
        let text = match self.template.unwrap_or(Form::Json) {
            Form::Json => check::template_json(&work.construction, &scales),
            Form::Csv => check::template_csv(&work.construction, &scales),
        };
        files::print(text.as_bytes())
    }

    fn drawn<'a>(&self, work: &'a Work) -> Drawn<'a> {
        Drawn {
            units: work.scene.units,
            near: &work.scene.near,
            mechanism: &work.mechanism,
            pose: &work.pose,
            motion: &work.motion,
            construction: &work.construction,
            scales: scales(&work.scene, &work.mechanism, &work.pose, &work.construction),
            tolerance: self.hand.tolerance(),
            depth: usize::from(self.depth),
        }
    }
}

/// The values of a form: JSON where it begins with a brace, else a table.
fn read(path: &Path, text: &Source) -> Result<Measured, Failure> {
    let is_table = path
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    if !is_table
        && text
            .text
            .trim_start_matches(['\u{feff}', ' ', '\n', '\r', '\t'])
            .starts_with(['{', '['])
    {
        let measured = Measured::read_json(&text.text);
        measured.map_err(|error| Failure::Scene(text.clone(), Box::new(error.into())))
    } else {
        Measured::read_csv(&text.text).map_err(|error| misuse(text, &error))
    }
}

fn misuse(source: &Source, error: &CheckError) -> Failure {
    Failure::Misuse(format!("{}: {error}", source.name), error.hint.clone())
}
