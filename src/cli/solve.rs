use super::files;
use super::message::{Failure, warn};
use super::pencil::Hand;
use super::work::{Mode, Work, work};
use crate::accuracy::bounds;
use crate::drafting::readable_names;
use crate::drawing::{Style, scales};
use crate::format::{self, QuantityResult, ResultFile, Solved};
use crate::motion::Order;
use crate::plan::{Asked, Quantity, is_acceleration, measured_names, quantity};
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
        let work = work(&source, self.mode.number, |_| (), needed)?;
        if self.digits {
            return print_digits(&work);
        }
        let mut result = format::result(Solved {
            units: work.scene.units,
            mechanism: &work.mechanism,
            pose: &work.pose,
            motion: &work.motion,
            construction: &work.construction,
        });
        let wrong = |error| Failure::Scene(source, Box::new(error));
        add_quantities(&work, &mut result).map_err(wrong.clone())?;
        if self.pencil || self.hand.is_given() {
            let asked = drawn_quantities(&work).map_err(wrong)?;
            let pencil = self.hand.pencil(&work, asked);
            result.pencil = Some(format::pencil_result(&pencil, work.scene.units));
        }
        work.warn();
        files::print(format::json(&result).as_bytes())
    }
}

/// The table of certain digits; says which of the wanted quantities have no stated bound.
fn print_digits(work: &Work) -> Result<(), Failure> {
    let (mechanism, pose, motion) = (&work.mechanism, &work.pose, &work.motion);
    let units = work.scene.units;
    let bounds = bounds(mechanism, pose, motion);
    let construction = &work.construction;
    let text = format::digits(units, mechanism, pose, motion, construction, &bounds);
    work.warn();
    for name in work.scene.want.iter().flatten() {
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
fn add_quantities(work: &Work, result: &mut ResultFile) -> Result<(), crate::Error> {
    let names = match &work.scene.want {
        Some(want) => want.clone(),
        None => measured_names(&work.construction),
    };
    let on_paper = names.iter().any(|n| n.ends_with("/mu"));
    let scales = on_paper.then(|| scales(&work.scene, &work.mechanism, &work.pose, &work.construction));
    for (index, name) in names.iter().enumerate() {
        let value = quantity(name, &work.mechanism, &work.pose, &work.motion, &work.construction, scales.as_ref());
        let value = value.map_err(|error| {
            let path = ["want", &index.to_string()];
            work.scene.error_at(&path, error.to_string(), None)
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
fn drawn_quantities(work: &Work) -> Result<Vec<Asked>, crate::Error> {
    let mut names = readable_names(&work.mechanism, &work.motion, &work.construction);
    for name in work.scene.want.iter().flatten() {
        let asked = Asked::new(name, &work.mechanism)?;
        if asked.is_vector() {
            names.extend(["size", "angle"].map(|part| format!("{name}.{part}")));
        } else {
            names.push(name.clone());
        }
    }
    let mut asked: Vec<Asked> = Vec::new();
    for name in names {
        if !asked.iter().any(|other| other.name() == name) {
            asked.push(Asked::new(&name, &work.mechanism)?);
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
