use super::files;
use super::message::Failure;
use super::output::FileSet;
use crate::scene::Kind;
use clap::Args;
use clap::builder::PossibleValuesParser;
use std::path::{Path, PathBuf};

const AFTER_HELP: &str = "\
Examples:
  kinegon new                             lists the kinds
  kinegon new four-bar -o four-bar.json   writes a four-bar linkage
  kinegon new slider-crank | kinegon draw - -o slider-crank.svg";

/// Write a starting scene.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct New {
    /// Kind of mechanism; without one the kinds are listed.
    #[arg(value_parser = PossibleValuesParser::new(Kind::NAMES), hide_possible_values = true)]
    kind: Option<String>,
    /// File to write, or a folder for KIND.json, or `-` for stdout; a file that is there already is never written over.
    #[arg(short, long, default_value = "-")]
    output: PathBuf,
    /// List the kinds.
    #[arg(long, conflicts_with_all = ["kind", "output"])]
    list: bool,
}

impl New {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let Some(kind) = &self.kind else {
            if self.output != Path::new("-") {
                return Err(Failure::misuse(
                    "which kind of mechanism is to be written?",
                    "name one of those that `kinegon new --list` shows",
                ));
            }
            return files::print_text(&list());
        };
        let Kind { name, text } = Kind::named(kind).expect("the command line takes no other name");
        if self.output == Path::new("-") {
            return files::print(text.as_bytes());
        }
        let is_folder = files::is_folder(&self.output);
        let path = if is_folder { self.output.join(format!("{name}.json")) } else { self.output.clone() };
        let mut files = FileSet::default();
        files.add_first(&path, text.as_bytes())?;
        files.finish()
    }
}

/// The kinds with the titles of their scenes, a line each.
fn list() -> String {
    let width = Kind::NAMES.iter().map(|name| name.len()).max().unwrap_or_default();
    Kind::all().map(|kind| format!("{:width$}  {}\n", kind.name, kind.title().for_terminal())).collect()
}
