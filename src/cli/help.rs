//! The command line's description, with the commands grouped by who asks for them.

use super::Command as Given;
use clap::builder::StyledStr;
use clap::{ColorChoice, Command, CommandFactory, ValueEnum};
use colorchoice_clap::Color;
use std::ffi::OsString;
use std::fmt::Write;

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
