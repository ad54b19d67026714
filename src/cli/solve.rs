//! What is printed of one scene: its numbers, the steps of its construction, its groups, its assembly modes; and the schemas of all files.

use super::files;
use super::message::{Failure, warn};
use super::options::{GivenScales, Hand, Paper, Words};
use super::work::{Mode, show_warnings, solve};
use crate::construction::Solution;
use crate::drawing::Style;
use crate::format;
use crate::mechanism::mechanism;
use crate::order_of_result;
use crate::position::{counted_poses, with_nearest_sides};
use crate::quantity::{QuantityRequest, readable_names, step_pencil};
use crate::scene::{Figure, Scene, SizeLimit};
use crate::sheet::Sheet;
use crate::words::Wording;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

const AFTER_HELP: &str = "\
Examples:
  kinegon solve scene.json > result.json   every number, with its error bound
  kinegon solve scene.json --digits        a table of certain digits
  kinegon solve scene.json --pencil        with what a hand drawing gives";

/// Print the result of a scene.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Solve {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
    #[command(flatten)]
    mode: Mode,
    /// Print a table of all rates, velocities and accelerations in place of JSON, each with only those digits that are
    /// certain.
    #[arg(long, conflicts_with_all = ["pencil", "mm", "degrees"])]
    digits: bool,
    /// Add what honest hand drawings at the figure's scales give: the band of every quantity.
    #[arg(long)]
    pencil: bool,
    #[command(flatten)]
    hand: Hand,
}

impl Solve {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let most = if self.pencil || self.hand.is_given() { SizeLimit::HAND } else { SizeLimit::NUMBERS };
        let solution = solve(&source, most, self.mode.number, |_| (), order_of_result)?;
        if self.digits {
            return print_digits(&solution);
        }
        let mut result = solution.whole_result().map_err(|error| source.fail(error))?;
        if self.pencil || self.hand.is_given() {
            let asked = readable_quantities(&solution).map_err(|error| source.fail(error))?;
            let pencil = self.hand.pencil(&solution, asked);
            result.pencil = Some(format::pencil_result(&pencil, solution.scene.units));
        }
        show_warnings(&solution);
        files::print(format::json(&result).as_bytes())
    }
}

/// Prints the table of certain digits; warns of wanted quantities that have no bound of their error.
fn print_digits(solution: &Solution) -> Result<(), Failure> {
    let text = solution.digits();
    show_warnings(solution);
    for name in solution.scene.want.iter().flatten() {
        // The table gives a vector by its components.
        let is_named = |line: &str| line.starts_with(&format!("{name} ")) || line.starts_with(&format!("{name}."));
        if !text.lines().any(is_named) {
            warn(&format!(
                "`{name}` has no stated bound of its error and is left out of the table; without --digits its value is printed"
            ));
        }
    }
    files::print(text.as_bytes())
}

/// The quantities that may be read from a hand drawing: those of the result and those that the scene wants; of vectors
/// size and angle.
fn readable_quantities(solution: &Solution) -> Result<Vec<QuantityRequest>, crate::Error> {
    let mut names = readable_names(solution);
    for name in solution.scene.want.iter().flatten() {
        let asked = QuantityRequest::new(name, &solution.mechanism)?;
        if asked.is_vector() {
            names.extend(["size", "angle"].map(|part| format!("{name}.{part}")));
        } else {
            names.push(name.clone());
        }
    }
    let mut asked: Vec<QuantityRequest> = Vec::new();
    for name in names {
        if !asked.iter().any(|other| other.name() == name) {
            asked.push(QuantityRequest::new(&name, &solution.mechanism)?);
        }
    }
    Ok(asked)
}

/// Print a JSON Schema.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  kinegon schema > scene.schema.json          for an editor, by \"$schema\"
  kinegon schema result > result.schema.json  for a program that reads results")]
pub(super) struct Schema {
    /// Of which kind of file.
    #[arg(value_enum, default_value_t = Kind::Scene)]
    kind: Kind,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Kind {
    Scene,
    Result,
    Style,
    Check,
    /// Of marking schemes, for `kinegon check --marks`.
    Marks,
    /// Of reports on a class.
    Class,
    /// Of keys of exercises.
    Key,
    /// Of studies, for `kinegon study`.
    Study,
}

impl Schema {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let schema = match self.kind {
            Kind::Scene => Scene::schema(),
            Kind::Result => format::result_schema(),
            Kind::Style => Style::schema(),
            Kind::Check => crate::check::check_schema(),
            Kind::Marks => crate::check::Marks::schema(),
            Kind::Class => crate::check::class_schema(),
            Kind::Key => crate::exercise::key_schema(),
            Kind::Study => crate::study::StudyFile::schema(),
        };
        files::print(format::json(&schema).as_bytes())
    }
}

const STEPS_HELP: &str = "\
Examples:
  kinegon steps scene.json                      the construction, numbered
  kinegon steps scene.json --language es        the same in Spanish
  kinegon steps scene.json --page a3            with lengths for a larger sheet";

/// Print the construction of a scene.
#[derive(Debug, Args)]
#[command(after_help = STEPS_HELP)]
pub(super) struct Steps {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
    #[command(flatten)]
    mode: Mode,
    #[command(flatten)]
    words: Words,
    #[command(flatten)]
    paper: Paper,
    #[command(flatten)]
    scales: GivenScales,
    #[command(flatten)]
    hand: Hand,
}

impl Steps {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let override_figure = |figure: &mut Figure| {
            self.words.put_into(figure);
            self.paper.put_into(figure);
            self.scales.put_into(figure);
        };
        let solution = solve(&source, SizeLimit::HAND, self.mode.number, override_figure, |_| Sheet::Acceleration)?;
        let pencil = step_pencil(&solution, self.hand.tolerance()).map_err(|error| source.fail(error))?;
        let text = solution.steps(&pencil);
        show_warnings(&solution);
        files::print_text(&text)
    }
}

/// Print the structure of a scene.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  kinegon structure scene.json
  kinegon new fourth-class | kinegon structure -")]
pub(super) struct Structure {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
}

impl Structure {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let text = || -> Result<String, crate::Error> {
            let scene = Scene::read(&source.text)?;
            Ok(format::structure(&mechanism(&scene)?, &Wording::of(&scene.figure)))
        };
        let text = text().map_err(|error| source.fail(error))?;
        files::print_text(&text)
    }
}

/// Print the assembly modes of a scene.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  kinegon modes scene.json                          lists them
  kinegon draw scene.json --mode 2 -o mode-2.svg    draws the second")]
pub(super) struct Modes {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
}

impl Modes {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let stages = || -> Result<_, crate::Error> {
            let scene = Scene::read(&source.text)?;
            let mechanism = with_nearest_sides(&scene, mechanism(&scene)?);
            let listed = counted_poses(&mechanism, &scene.near)?;
            Ok((format::listed_modes(&scene, &mechanism, &listed), mechanism.warnings))
        };
        let (text, warnings) = stages().map_err(|error| source.fail(error))?;
        warnings.iter().for_each(|w| warn(w));
        files::print_text(&text)
    }
}
