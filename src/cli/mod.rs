//! In: a command line. Out: files, text on stdout, messages on stderr, an exit code. Only this folder reads and writes
//! files. A command writes all of its files or none (`output/`).
//!
//! Exit codes: 0 done; 1 not assembled, singular, not passed, or not written; 2 a scene or a command that is not
//! understood; 128 and a signal's number where that has stopped it, as 130 for Ctrl-C.

mod begin;
mod board;
mod centers;
mod check;
mod class;
mod cycle;
mod draw;
mod exercise;
#[doc(hidden)] // for tests
pub mod feedback;
mod figures;
mod files;
mod film;
#[doc(hidden)] // for tests
pub mod forms;
#[doc(hidden)] // for tests
pub mod help;
mod large;
#[doc(hidden)] // for tests
pub mod message;
mod options;
#[doc(hidden)] // for tests
pub mod output;
mod parts;
#[doc(hidden)] // for tests
pub mod photo;
mod photo_class;
#[doc(hidden)] // for tests
pub mod picture;
#[doc(hidden)] // for tests
pub mod pieces;
mod solve;
mod study;
mod style;
mod table;
mod tables;

pub use message::shown;

use crate::text;
use clap::error::{ContextKind, ContextValue};
use clap::{FromArgMatches, Parser, Subcommand};
use colorchoice_clap::Color;
use message::Failure;
use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::Path;
use std::process::ExitCode;

/// Velocity and acceleration plans of planar mechanisms, true to scale.
#[derive(Debug, Parser)]
#[command(name = "kinegon", version, about, arg_required_else_help = true)]
struct Command {
    #[command(subcommand)]
    task: Task,
    #[command(flatten)]
    color: Color,
}

// A line each in `kinegon --help`, in the groups of `help`; it also heads the help of the command.
#[derive(Debug, Subcommand)]
enum Task {
    /// Open the workbench, the program as a page in the browser
    App(begin::App),
    /// Write a scene to start from, or list the kinds of mechanisms
    New(begin::New),
    /// Draw scheme, velocity plan and acceleration plan
    Draw(draw::Draw),
    /// Print every position, velocity and acceleration as JSON
    Solve(solve::Solve),
    /// Print the construction step by step, with lengths on paper
    Steps(solve::Steps),
    /// Check values read from hand drawings; say what went wrong
    Check(check::Check),
    /// Write exercises to be drawn by hand: sheets, forms, keys
    Exercise(exercise::ExerciseCommand),
    /// Print the Assur groups in solving order
    #[command(after_help = solve::STRUCTURE_HELP)]
    Structure(solve::Listed),
    /// Print every way to assemble a scene, numbered
    #[command(after_help = solve::MODES_HELP)]
    Modes(solve::Listed),
    /// Write a table of the motion: CSV, JSON lines
    Sweep(cycle::SweepCommand),
    /// Draw quantities over the motion, with extremes and limits
    Curves(cycle::CurvesCommand),
    /// Compute many mechanisms that differ in some numbers
    Study(study::StudyCommand),
    /// Print the JSON Schema of scenes and other files
    Schema(solve::Schema),
    /// Print what a shell needs to complete the command line
    Completions(help::Completions),
    /// Print the manual page, or write all pages
    Man(help::Man),
}

/// Runs the command line of this process.
#[must_use]
pub fn run() -> ExitCode {
    ExitCode::from(run_with(std::env::args_os()))
}

/// Runs a command line, the program's name first, in this process: its exit code.
#[must_use]
pub fn run_with(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    help::asked_color(&arguments).write_global();
    let parsed = help::command().try_get_matches_from(&arguments);
    let command = match parsed.and_then(|matches| Command::from_arg_matches(&matches)) {
        Ok(command) => command,
        Err(error) => return refused(with_equals(error, &arguments)),
    };
    command.color.write_global();
    output::survive_size_limits();
    let done = match &command.task {
        Task::App(app) => app.run(),
        Task::New(new) => new.run(),
        Task::Draw(draw) => draw.run(),
        Task::Solve(solve) => solve.run(),
        Task::Steps(steps) => steps.run(),
        Task::Check(check) => check.run(),
        Task::Exercise(exercise) => exercise.run(),
        Task::Structure(listed) => listed.structure(),
        Task::Modes(listed) => listed.modes(),
        Task::Sweep(sweep) => sweep.run(),
        Task::Curves(curves) => curves.run(),
        Task::Study(study) => study.run(),
        Task::Schema(schema) => schema.run(),
        Task::Completions(completions) => completions.run(),
        Task::Man(man) => man.run(),
    };
    match done {
        Ok(()) => 0,
        Err(failure) => {
            output::wait_if_stopped();
            message::show(&failure);
            failure.exit_code()
        }
    }
}

/// Why a command line is not understood; where a word behind an option may be its value, which stands behind `=`, with what to type.
fn with_equals(mut error: clap::Error, arguments: &[OsString]) -> clap::Error {
    if error.kind() != clap::error::ErrorKind::UnknownArgument {
        return error;
    }
    let command = help::command();
    let task = arguments.get(1).and_then(|name| command.find_subcommand(name));
    let options: Vec<String> = task
        .into_iter()
        .flat_map(|task| task.get_arguments())
        .filter_map(|option| {
            let long = option.get_long().filter(|_| option.is_require_equals_set())?;
            Some(format!("--{long}"))
        })
        .collect();
    let tips = arguments.windows(2).filter_map(|pair| {
        let (option, value) = (pair[0].to_str()?, text::shown(pair[1].to_str()?));
        let is_value = options.iter().any(|own| own == option) && !value.starts_with('-');
        is_value.then(|| format!("if {value} is the value of {option}, write {option}={value}").into())
    });
    let tips: Vec<clap::builder::StyledStr> = tips.collect();
    if !tips.is_empty() {
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(tips));
    }
    error
}

/// Shows help, or why a command line is not understood, without what a terminal would obey in its arguments.
fn refused(mut error: clap::Error) -> u8 {
    let given: Vec<_> = error.context().map(|(kind, value)| (kind, value.clone())).collect();
    for (kind, value) in given {
        if let ContextValue::String(value) = value {
            error.insert(kind, ContextValue::String(text::shown(&value)));
        }
    }
    // What parsers of values say of them is no part of the context.
    let plain = error.render().to_string();
    let safe = text::short_lines(&plain);
    if error.use_stderr() && safe != plain {
        anstream::eprint!("{safe}");
    } else if let Err(unwritten) = error.print()
        && !error.use_stderr()
        && unwritten.kind() != ErrorKind::BrokenPipe
    {
        message::show(&Failure::unwritable(Path::new("stdout"), &unwritten));
        return 1;
    }
    u8::try_from(error.exit_code()).unwrap_or(2)
}
