use super::files;
use super::message::{Failure, warn};
use super::pencil::Hand;
use super::work::{Mode, solve, warn_of};
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
    /// Print a table of all rates, velocities and accelerations in place of JSON, each with only those digits that are certain.
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
        let solution = solve(&source, self.mode.number, |_| (), needed)?;
        if self.digits {
            return print_digits(&solution);
        }
        let mut result = solution.result();
        let wrong = |error| Failure::Scene(source, Box::new(error));
        add_quantities(&solution, &mut result).map_err(wrong.clone())?;
        if self.pencil || self.hand.is_given() {
            let asked = drawn_quantities(&solution).map_err(wrong)?;
            let pencil = self.hand.pencil(&solution, asked);
            result.pencil = Some(format::pencil_result(&pencil, solution.scene.units));
        }
        warn_of(&solution);
        files::print(format::json(&result).as_bytes())
    }
}

/// The table of certain digits; says which of the wanted quantities have no stated bound.
fn print_digits(solution: &Solution) -> Result<(), Failure> {
    let text = solution.digits();
    warn_of(solution);
    for name in solution.scene.want.iter().flatten() {
        // A vector stands there by its components.
        let begins = |line: &str| line.starts_with(&format!("{name} ")) || line.starts_with(&format!("{name}."));
        if !text.lines().any(begins) {
            warn(&format!(
                "`{name}` has no stated bound of its error and is left out of the table; without --digits its value is printed"
            ));
        }
    }
    files::print(text.as_bytes())
}

/// Accelerations unless the scene's `want` names only quantities without them.
fn needed(scene: &Scene) -> Order {
    match &scene.want {
        Some(want) if !want.iter().any(|name| is_acceleration(name)) => Order::Velocity,
        _ => Order::Acceleration,
    }
}

/// The quantities that the scene wants; all that the construction measures where it does not say.
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

/// What may be read from a hand drawing of the scene: everything that the result gives, and what the scene wants; vectors by size and angle.
fn drawn_quantities(solution: &Solution) -> Result<Vec<Asked>, crate::Error> {
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
