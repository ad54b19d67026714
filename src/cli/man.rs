use super::files;
use super::help;
use super::message::Failure;
use super::output::FileSet;
use clap::{Args, Command};
use clap_mangen::roff::{Roff, roman};
use std::io;
use std::path::{Path, PathBuf};

const AFTER_HELP: &str = "\
Examples:
  kinegon man | man -l -                       reads the page
  kinegon man draw | man -l -                  that of a command
  kinegon man -o ~/.local/share/man/man1/      writes all, for `man kinegon`";

/// Print a manual page, or write all pages into a folder.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Man {
    /// The command that it is about; without one the whole program.
    #[arg(conflicts_with = "output")]
    command: Option<String>,
    /// Folder for the pages of the program and of all of its commands.
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

impl Man {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let whole = help::command();
        let failed = |error: io::Error| Failure::outside(format!("the manual page cannot be made: {error}"));
        match (&self.output, &self.command) {
            (Some(folder), _) => write_all(&whole, folder),
            (None, None) => files::print(&page(&whole).map_err(failed)?),
            (None, Some(name)) => match commands(&whole).find(|command| command.get_name() == name) {
                Some(command) => files::print(&page(command).map_err(failed)?),
                None => {
                    Err(Failure::misuse(format!("there is no command `{name}`"), "`kinegon --help` lists the commands"))
                }
            },
        }
    }
}

/// The commands that have a page: all but `help`.
fn commands(whole: &Command) -> impl Iterator<Item = &Command> {
    whole.get_subcommands().filter(|command| command.get_name() != "help")
}

/// Writes the pages of the program and of its commands.
fn write_all(whole: &Command, folder: &Path) -> Result<(), Failure> {
    let mut files = FileSet::default();
    for command in std::iter::once(whole).chain(commands(whole)) {
        let name = clap_mangen::Man::new(command.clone()).get_filename();
        let path = folder.join(name);
        let page = page(command).map_err(|error| files::unwritable(&path, &error))?;
        files.add(&path, &page)?;
    }
    files.finish()
}

/// The page of a command, in roff.
fn page(command: &Command) -> io::Result<Vec<u8>> {
    let source = concat!("kinegon ", env!("CARGO_PKG_VERSION"));
    let page = clap_mangen::Man::new(command.clone()).manual("Kinegon").source(source);
    let mut bytes = Vec::new();
    page.render_title(&mut bytes)?;
    page.render_name_section(&mut bytes)?;
    page.render_synopsis_section(&mut bytes)?;
    page.render_description_section(&mut bytes)?;
    page.render_options_section(&mut bytes)?;
    if command.has_subcommands() {
        page.render_subcommands_section(&mut bytes)?;
    }
    let after = command.get_after_help().map(ToString::to_string).unwrap_or_default();
    let (remarks, examples) = after.split_once("Examples:\n").unwrap_or((&after, ""));
    section("REMARKS", remarks, &mut bytes)?;
    section("EXAMPLES", examples, &mut bytes)?;
    Ok(bytes)
}

/// A section of text whose lines stay as they are where they are indented.
fn section(title: &str, text: &str, bytes: &mut Vec<u8>) -> io::Result<()> {
    if text.trim().is_empty() {
        return Ok(());
    }
    let mut roff = Roff::new();
    roff.control("SH", [title]);
    for paragraph in text.trim_end().split("\n\n") {
        let is_kept = paragraph.starts_with("  ");
        roff.control(if is_kept { "nf" } else { "PP" }, []);
        for line in paragraph.lines() {
            roff.text([roman(line.trim_start())]);
        }
        if is_kept {
            roff.control("fi", []);
        }
    }
    roff.to_writer(bytes)
}
