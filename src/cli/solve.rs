use super::files;
use super::message::{Failure, warn};
use super::pencil::Hand;
use super::work::{HAND, Mode, NUMBERS, show_warnings, solve};
use crate::construction::Solution;
use crate::drawing::Style;
use crate::format::{self, QuantityResult, ResultFile};
use crate::motion::Order;
use crate::quantity::{Asked, Quantity, is_acceleration, measured_names, readable_names};
use crate::scene::Scene;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Print the result of a scene.
#[derive(Debug, Args)]
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
        let most = if self.pencil || self.hand.is_given() { HAND } else { NUMBERS };
        let solution = solve(&source, most, self.mode.number, |_| (), needed_order)?;
        if self.digits {
            return print_digits(&solution);
        }
        let mut result = solution.result();
        add_quantities(&solution, &mut result).map_err(|error| source.fail(error))?;
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

/// The order of the motion to be computed: accelerations unless `want` names only quantities without them.
fn needed_order(scene: &Scene) -> Order {
    match &scene.want {
        Some(want) if !want.iter().any(|name| is_acceleration(name)) => Order::Velocity,
        _ => Order::Acceleration,
    }
}

/// Adds the quantities that the scene wants to the result, or all that the construction measures if it wants none in
/// particular.
fn add_quantities(solution: &Solution, result: &mut ResultFile) -> Result<(), crate::Error> {
    let names = match &solution.scene.want {
        Some(want) => want.clone(),
        None => measured_names(&solution.construction),
    };
    let on_paper = names.iter().any(|n| n.ends_with("/mu"));
    let scales = on_paper.then(|| solution.scales());
    for (index, name) in names.iter().enumerate() {
        let value = Asked::new(name, &solution.mechanism)
            .and_then(|asked| asked.value(&solution.snapshot(), Some(&solution.construction), scales.as_ref()));
        let value = value.map_err(|error| {
            let path = ["want", &index.to_string()];
            solution.scene.error_at(&path, error.to_string(), None)
        })?;
        let value = match value {
            Quantity::Number(x) => QuantityResult::Number(x),
            Quantity::Vector(v) => QuantityResult::Vector([v.x, v.y]),
        };
        result.quantities.insert(name.clone(), value);
    }
    Ok(())
}

/// The quantities that may be read from a hand drawing: those of the result and those that the scene wants; of vectors
/// size and angle.
fn readable_quantities(solution: &Solution) -> Result<Vec<Asked>, crate::Error> {
    let mut names = readable_names(solution);
    for name in solution.scene.want.iter().flatten() {
        let asked = Asked::new(name, &solution.mechanism)?;
        if asked.is_vector() {
            names.extend(["size", "angle"].map(|part| format!("{name}.{part}")));
        } else {
            names.push(name.clone());
        }
    }
    let mut asked: Vec<Asked> = Vec::new();
    for name in names {
        if !asked.iter().any(|other| other.name() == name) {
            asked.push(Asked::new(&name, &solution.mechanism)?);
        }
    }
    Ok(asked)
}

/// Print a JSON Schema.
#[derive(Debug, Args)]
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
        };
        files::print(format::json(&schema).as_bytes())
    }
}
