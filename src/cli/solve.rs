//! How a scene is solved for a command, and what is printed of one: its numbers, the steps of its construction, its groups, its
//! assembly modes; and the schemas of all files.

use super::files;
use super::message::{Failure, Source, note, warn};
use super::options::{Hand, Look};
use crate::accuracy::bounds;
use crate::board::{Given, own_drawing};
use crate::construction::Solution;
use crate::cycle::told_turning_back;
use crate::drawing::Style;
use crate::format::ResultFile;
use crate::mechanism::{Mechanism, mechanism};
use crate::position::{Pose, counted_poses, with_nearest_sides};
use crate::quantity::{QuantityRequest, pencil, readable_names, step_pencil};
use crate::scene::{Figure, Scene, SizeLimit};
use crate::sheet::{Order, Sheet};
use crate::words::Wording;
use crate::{Error, format, posed};
use clap::{Args, ValueEnum};
use indexmap::IndexSet;
use std::path::PathBuf;

/// Condition from which on it is asked whether something is proved of a position that is drawn.
const NEARLY_SINGULAR: f64 = 1e6;

/// Which assembly mode is wanted.
#[derive(Debug, Args)]
pub(super) struct Mode {
    /// Assembly mode by its number in `kinegon modes`, in place of the one that `near` picks.
    #[arg(long = "mode", value_name = "MODE", value_parser = mode_number)]
    pub number: Option<usize>,
}

fn mode_number(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(0) => Err("assembly modes are numbered from 1".to_owned()),
        Ok(number) => Ok(number),
        Err(_) => Err("not the number of an assembly mode".to_owned()),
    }
}

/// Solves a scene to the given order of motion, after `override_figure` has put the options of the command line into
/// its figure; in the assembly mode of that number, else in the one that `near` picks.
pub(super) fn solve(
    source: &Source,
    most: SizeLimit,
    mode: Option<usize>,
    override_figure: impl Fn(&mut Figure),
    order: impl Fn(&Scene) -> Order,
) -> Result<Solution, Failure> {
    let (mut scene, mechanism, pose) = read(source, most, mode)?;
    let had_forces = scene.figure.shown_panels().contains(&Sheet::Forces);
    override_figure(&mut scene.figure);
    // Whoever asks for other panels does without the corners.
    let draws_forces = !had_forces || scene.figure.shown_panels().contains(&Sheet::Forces);
    scene.check_frame().map_err(|error| Failure::of_option("--frame", error))?;
    let order = order(&scene);
    let solution = source.checked(Solution::new(scene, mechanism, pose, order))?;
    if draws_forces {
        source.checked(solution.check_corners())?;
    }
    Ok(solution)
}

/// Reads a scene and finds its position.
pub(super) fn read(source: &Source, most: SizeLimit, mode: Option<usize>) -> Result<(Scene, Mechanism, Pose), Failure> {
    let scene = source.checked(Scene::read(&source.text))?;
    let (mechanism, pose) = source.checked(posed(&scene, most, mode))?;
    Ok((scene, mechanism, pose))
}

/// Shows what is to be known of a result on stderr.
fn show(result: &ResultFile) {
    result.warnings.iter().for_each(|text| warn(text));
    result.notes.iter().for_each(|text| note(text));
}

/// Shows the warnings of a solution on stderr, and what turns back there.
pub(super) fn show_warnings(solution: &Solution) {
    solution.warnings().for_each(|text| warn(&text));
    // Whether it is a limit or a change point is told as by `solve`.
    if solution.motion.conditions.iter().any(|condition| *condition > NEARLY_SINGULAR) {
        let Solution { scene, mechanism, pose, motion, .. } = solution;
        bounds(scene, mechanism, pose, motion).warnings().iter().for_each(|warning| warn(&warning.to_string()));
    }
    told_turning_back(solution, &solution.wording()).iter().for_each(|text| note(text));
}

const AFTER_HELP: &str = "\
Examples:
  kinegon solve scene.json > result.json   every number, with its error bound
  kinegon solve scene.json --digits        a table of certain digits
  kinegon solve scene.json --pencil        with what a hand drawing gives";

#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Solve {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
    #[command(flatten)]
    mode: Mode,
    /// Print a table of all rates, velocities, accelerations and wanted quantities in place of JSON, each with only those
    /// digits that are certain.
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
        let solution = solve(&source, most, self.mode.number, |_| (), |_| Order::Acceleration)?;
        source.checked(solution.check_form())?;
        let mut result = source.checked(solution.whole_result())?;
        if self.digits {
            show(&result);
            return files::print(solution.digits_of(&result).as_bytes());
        }
        if self.pencil || self.hand.is_given() {
            let asked = source.checked(readable_quantities(&solution))?;
            let pencil = pencil(&solution, &solution.scales(), self.hand.tolerance(), asked);
            result.pencil = Some(format::pencil_result(&pencil, solution.scene.units));
        }
        show(&result);
        files::print(format::json(&result).as_bytes())
    }
}

/// The quantities that may be read from a hand drawing: those of the result and those that the scene wants; of vectors
/// size and angle.
fn readable_quantities(solution: &Solution) -> Result<Vec<QuantityRequest>, Error> {
    let mut names: IndexSet<String> = readable_names(solution).into_iter().collect();
    for name in solution.scene.want.iter().flatten() {
        let asked = QuantityRequest::new(name, &solution.mechanism)?;
        if asked.is_place() {
            names.extend(["x", "y"].map(|part| format!("{name}.{part}")));
        } else if asked.is_vector() {
            names.extend(["size", "angle"].map(|part| format!("{name}.{part}")));
        } else {
            names.insert(name.clone());
        }
    }
    names.iter().map(|name| Ok(QuantityRequest::new(name, &solution.mechanism)?)).collect()
}

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
    /// Of drawings made on the drawing board, for `kinegon check`.
    Drawing,
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
            Kind::Drawing => crate::board::drawing_schema(),
        };
        files::print(format::json(&schema).as_bytes())
    }
}

const STEPS_HELP: &str = "\
Examples:
  kinegon steps scene.json                      the construction, numbered
  kinegon steps scene.json --language es        the same in Spanish
  kinegon steps scene.json --page a3            with lengths for a larger sheet
  kinegon steps scene.json --drawing            for the drawing board";

#[derive(Debug, Args)]
#[command(after_help = STEPS_HELP)]
pub(super) struct Steps {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
    /// Print the construction as a drawing, as the drawing board of the workbench reads it and `kinegon check` judges it.
    #[arg(long)]
    drawing: bool,
    #[command(flatten)]
    mode: Mode,
    #[command(flatten)]
    look: Look,
    #[command(flatten)]
    hand: Hand,
}

impl Steps {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let (mode, override_figure) = (self.mode.number, |figure: &mut Figure| self.look.put_into(figure));
        let solution = solve(&source, SizeLimit::HAND, mode, override_figure, |_| Order::Acceleration)?;
        if self.drawing {
            show_warnings(&solution);
            return files::print(own_drawing(&Given::new(&solution), &solution.scales()).as_bytes());
        }
        let pencil = source.checked(step_pencil(&solution, self.hand.tolerance()))?;
        let text = solution.steps(&pencil);
        show_warnings(&solution);
        files::print_text(&text)
    }
}

pub(super) const STRUCTURE_HELP: &str = "\
Examples:
  kinegon structure scene.json
  kinegon new fourth-class | kinegon structure -";

pub(super) const MODES_HELP: &str = "\
Examples:
  kinegon modes scene.json                          lists them
  kinegon draw scene.json --mode 2 -o mode-2.svg    draws the second";

/// A scene, of which something is listed.
#[derive(Debug, Args)]
pub(super) struct Listed {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
}

impl Listed {
    /// Prints its groups in solving order.
    pub(super) fn structure(&self) -> Result<(), Failure> {
        let (source, scene) = files::read_scene(&self.scene)?;
        let mechanism = source.checked(mechanism(&scene))?;
        files::print_text(&format::structure(&mechanism, &Wording::of(&scene.figure)))
    }

    /// Prints its assembly modes.
    pub(super) fn modes(&self) -> Result<(), Failure> {
        let (source, scene) = files::read_scene(&self.scene)?;
        let mechanism = with_nearest_sides(&scene, source.checked(mechanism(&scene))?);
        let listed = source.checked(counted_poses(&mechanism, &scene.near))?;
        mechanism.warnings.iter().for_each(|warning| warn(&warning.to_string()));
        files::print_text(&format::listed_modes(&scene, &mechanism, &listed))
    }
}
