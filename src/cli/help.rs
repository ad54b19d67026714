//! What the command line says of itself: help, with the commands grouped by who asks for them, what shells complete, manual pages.

use super::message::{Failure, refuse};
use super::output::FileSet;
use super::{Command as Given, files};
use clap::builder::{PossibleValue, StyledStr};
use clap::{Args, ColorChoice, Command, CommandFactory, ValueEnum};
use clap_complete::Shell;
use clap_mangen::roff::{Roff, roman};
use colorchoice_clap::Color;
use std::ffi::OsString;
use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};

/// Commands by who asks for them.
pub const GROUPS: [(&str, &[&str]); 5] = [
    ("To begin", &["app", "new", "draw"]),
    ("For students", &["steps", "check"]),
    ("For teachers", &["exercise"]),
    ("For engineers", &["solve", "sweep", "curves", "study", "structure", "modes"]),
    ("For editors, shells and programs", &["schema", "completions", "man", "help"]),
];

const EXAMPLES: &str = "\
Examples:
  kinegon app                                    the workbench in the browser
  kinegon new four-bar -o four-bar.json          a scene to start from
  kinegon draw four-bar.json -o four-bar.pdf     its plans, true to scale
  kinegon steps four-bar.json                    how they are constructed
  kinegon check four-bar.json values.json        a hand drawing, checked
  kinegon exercise four-bar --seed 7 -o class/   an exercise with its key
  kinegon solve four-bar.json > result.json      every number

`kinegon draw --help` tells the options of `draw`, with further examples.";

/// The description of the whole command line.
pub fn command() -> Command {
    let color = "Colours in messages and help; `auto` has them on a terminal where NO_COLOR is not set";
    let mut command = Given::command().after_help(EXAMPLES).mut_arg("color", |arg| arg.help(color));
    // Gives `help` its own line.
    command.build();
    let template = template(&command);
    command.help_template(template)
}

/// The top-level help: the groups of commands in place of one list.
fn template(command: &Command) -> StyledStr {
    let (header, name) = (command.get_styles().get_header(), command.get_styles().get_literal());
    let mut text = "{about-with-newline}\n{usage-heading} {usage}\n".to_owned();
    for (title, names) in GROUPS {
        // Writing to a text does not fail.
        let _ = write!(text, "\n{header}{title}:{header:#}\n");
        for known in names.iter().filter_map(|name| command.find_subcommand(name)) {
            let about = known.get_about().map(ToString::to_string).unwrap_or_default();
            let _ = writeln!(text, "  {name}{:13}{name:#}{about}", known.get_name());
        }
    }
    let _ = write!(text, "\n{header}Options:{header:#}\n{{options}}{{after-help}}");
    text.into()
}

/// The colours that a command line asks for. Help is shown, and mistakes are told, before it is understood.
pub(super) fn asked_color(arguments: &[OsString]) -> Color {
    let mut words = arguments.iter().map(|argument| argument.to_string_lossy()).take_while(|word| word != "--");
    let mut color = Color::default();
    while let Some(word) = words.next() {
        let value = match word.strip_prefix("--color") {
            Some("") => words.next().map(|value| value.into_owned()),
            Some(rest) => rest.strip_prefix('=').map(str::to_owned),
            None => None,
        };
        let choice = value.and_then(|value| ColorChoice::from_str(&value, false).ok());
        color.color = choice.unwrap_or(color.color);
    }
    color
}

const COMPLETIONS_HELP: &str = "\
Examples:
  kinegon completions bash > ~/.local/share/bash-completion/completions/kinegon
  kinegon completions zsh > ~/.zfunc/_kinegon      with ~/.zfunc in fpath
  kinegon completions fish > ~/.config/fish/completions/kinegon.fish
  kinegon completions powershell >> $PROFILE
  kinegon completions elvish >> ~/.config/elvish/rc.elv";

#[derive(Debug, Args)]
#[command(after_help = COMPLETIONS_HELP)]
pub(super) struct Completions {
    /// For which shell.
    #[arg(value_enum)]
    shell: Shell,
}

impl Completions {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let (mut command, mut script) = (command(), Vec::new());
        clap_complete::generate(self.shell, &mut command, "kinegon", &mut script);
        let script = String::from_utf8_lossy(&script);
        let script = match self.shell {
            Shell::Zsh => with_files(&script, ":(", ")' \\", ":{compadd -- ", "; _files}' \\"),
            Shell::Fish => with_files(&script, " -r -f -a \"", "", " -r -F -a \"", "") + &fish_arguments(&command),
            _ => script.into_owned(),
        };
        files::print(script.as_bytes())
    }
}

/// What is not an option but takes names that are known, as kinds: clap_complete leaves it out for fish.
fn fish_arguments(command: &Command) -> String {
    let mut lines = String::new();
    for task in command.get_subcommands() {
        for argument in task.get_positionals().filter(|argument| !argument.get_possible_values().is_empty()) {
            let values = argument.get_possible_values();
            let names: Vec<&str> = values.iter().map(PossibleValue::get_name).collect();
            let no_files =
                if takes_path(&argument.get_help().map(ToString::to_string).unwrap_or_default()) { "" } else { " -f" };
            // Writing to a text does not fail.
            let _ = writeln!(
                lines,
                "complete -c kinegon -n \"__fish_kinegon_using_subcommand {}\"{no_files} -a \"{}\"",
                task.get_name(),
                names.join(" ")
            );
        }
    }
    lines
}

/// Whether what is said of an argument is that it takes the path of a file beside names that are known.
fn takes_path(help: &str) -> bool {
    help.contains("the path of a ")
}

/// A script in which such arguments are completed by files, too: clap_complete has either. Both texts around the names
/// are replaced.
fn with_files(script: &str, before: &str, behind: &str, new_before: &str, new_behind: &str) -> String {
    let line = |line: &str| match line.strip_suffix(behind) {
        Some(rest) if takes_path(line) && rest.contains(before) => {
            format!("{}{new_behind}\n", rest.replace(before, new_before))
        }
        _ => format!("{line}\n"),
    };
    script.lines().map(line).collect()
}

const MAN_HELP: &str = "\
Examples:
  kinegon man | man -l -                       reads the page
  kinegon man draw | man -l -                  that of a command
  kinegon man -o ~/.local/share/man/man1/      writes all, for `man kinegon`";

#[derive(Debug, Args)]
#[command(after_help = MAN_HELP)]
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
        let whole = command();
        let failed = |error: io::Error| Failure::outside(format!("the manual page cannot be made: {error}"));
        match (&self.output, &self.command) {
            (Some(folder), _) => write_all(&whole, folder),
            (None, None) => files::print(&page(&whole).map_err(failed)?),
            (None, Some(name)) => match commands(&whole).find(|command| command.get_name() == name) {
                Some(command) => files::print(&page(command).map_err(failed)?),
                None => refuse(format!("there is no command `{name}`"), "`kinegon --help` lists the commands"),
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
        let page = page(command).map_err(|error| Failure::unwritable(&path, &error))?;
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
