use super::files;
use super::help;
use super::message::Failure;
use clap::builder::PossibleValue;
use clap::{Args, Command};
use clap_complete::Shell;
use std::fmt::Write;

const AFTER_HELP: &str = "\
Examples:
  kinegon completions bash > ~/.local/share/bash-completion/completions/kinegon
  kinegon completions zsh > ~/.zfunc/_kinegon      with ~/.zfunc in fpath
  kinegon completions fish > ~/.config/fish/completions/kinegon.fish
  kinegon completions powershell >> $PROFILE
  kinegon completions elvish >> ~/.config/elvish/rc.elv";

/// Print what a shell needs to complete commands, options, kinds, styles, formats and languages.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Completions {
    /// For which shell.
    #[arg(value_enum)]
    shell: Shell,
}

impl Completions {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let (mut command, mut script) = (help::command(), Vec::new());
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
