use super::files;
use super::message::{Failure, print};
use super::paper::{GivenScales, Paper};
use super::pencil::Hand;
use super::wording::Words;
use super::work::{HAND, Mode, show_warnings, solve};
use crate::motion::Order;
use crate::quantity::{Asked, step_names};
use crate::scene::Figure;
use clap::Args;
use std::path::PathBuf;

/// Print the construction of a scene.
#[derive(Debug, Args)]
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
        let solution = solve(&source, HAND, self.mode.number, override_figure, |_| Order::Acceleration)?;
        let names = step_names(&solution.construction);
        let asked: Result<Vec<Asked>, _> = names.iter().map(|name| Asked::new(name, &solution.mechanism)).collect();
        let asked = asked.map_err(|error| source.fail(error))?;
        let pencil = self.hand.pencil(&solution, asked);
        let text = solution.steps(&pencil);
        show_warnings(&solution);
        print(&text)
    }
}
