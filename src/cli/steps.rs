use super::files;
use super::message::{Failure, print};
use super::paper::{GivenScales, Paper};
use super::pencil::Hand;
use super::wording::Words;
use super::work::{Mode, show_warnings, solve};
use crate::quantity::step_pencil;
use crate::scene::{Figure, SizeLimit};
use crate::sheet::Sheet;
use clap::Args;
use std::path::PathBuf;

/// Text of `--help` behind the options.
const AFTER_HELP: &str = "\
Examples:
  kinegon steps scene.json                      the construction, numbered
  kinegon steps scene.json --language es        the same in Spanish
  kinegon steps scene.json --page a3            with lengths for a larger sheet";

/// Print the construction of a scene.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
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
        print(&text)
    }
}
