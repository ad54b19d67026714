//! In: a command line. Out: files, text on stdout, messages on stderr, an exit code. Only this folder reads and writes
//! files. A command writes all of its files or none (`output/`).
//!
//! Exit codes: 0 done; 1 not assembled, singular, not passed, or not written; 2 a scene or a command that is not
//! understood; 128 and a signal's number where that has stopped it, as 130 for Ctrl-C.

mod app;
mod caught;
mod check;
mod class;
mod correction;
mod curves;
mod decoding;
mod draw;
mod exercise;
mod exercises;
mod feedback;
mod figures;
mod files;
mod forms;
mod message;
mod new;
mod output;
mod paper;
mod pencil;
mod pieces;
mod solve;
mod steps;
mod structure;
mod sweep;
mod table;
mod wording;
mod work;

pub use message::shown;

use crate::text;
use clap::error::ContextValue;
use clap::{Parser, Subcommand};
use std::ffi::OsString;
use std::process::ExitCode;

/// Velocity and acceleration plans of planar mechanisms, true to scale.
#[derive(Debug, Parser)]
#[command(name = "kinegon", version, about, arg_required_else_help = true)]
struct Command {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Open the workbench, the program as a page in the browser; or write it to a file.
    App(app::App),
    /// Write a starting scene for a kind of mechanism, or list the kinds.
    New(new::New),
    /// Draw the figure of a scene: scheme, velocity plan, acceleration plan.
    Draw(draw::Draw),
    /// Print every position, velocity and acceleration of a scene as JSON.
    Solve(solve::Solve),
    /// Print the construction of the plans step by step, with lengths on paper.
    Steps(steps::Steps),
    /// Check values read from a hand drawing: verdicts, and what probably went wrong.
    Check(check::Check),
    /// Write exercises: random variants of a mechanism to be drawn by hand, with sheets, forms and keys.
    Exercise(exercise::ExerciseCommand),
    /// Print the Assur groups of a scene in solving order, with class, joints and degrees of freedom.
    Structure(structure::Structure),
    /// Print every way to assemble a scene, numbered, with coordinates.
    Modes(structure::Modes),
    /// Write a table of the motion while a drive moves: CSV or JSON lines.
    Sweep(sweep::SweepCommand),
    /// Draw quantities over the motion while a drive moves, with extremes and limits marked.
    Curves(curves::CurvesCommand),
    /// Print the JSON Schema of scene or result files, for editors.
    Schema(solve::Schema),
}

/// Runs the command line of this process.
#[must_use]
pub fn run() -> ExitCode {
    ExitCode::from(run_with(std::env::args_os()))
}

/// Runs a command line, the program's name first, in this process: its exit code.
#[must_use]
pub fn run_with(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let command = match Command::try_parse_from(arguments) {
        Ok(command) => command,
        Err(error) => return refused(error),
    };
    output::survive_size_limits();
    let done = match &command.task {
        Task::App(app) => app.run(),
        Task::New(new) => new.run(),
        Task::Draw(draw) => draw.run(),
        Task::Solve(solve) => solve.run(),
        Task::Steps(steps) => steps.run(),
        Task::Check(check) => check.run(),
        Task::Exercise(exercise) => exercise.run(),
        Task::Structure(structure) => structure.run(),
        Task::Modes(modes) => modes.run(),
        Task::Sweep(sweep) => sweep.run(),
        Task::Curves(curves) => curves.run(),
        Task::Schema(schema) => schema.run(),
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
    let safe = text::message(&plain);
    if error.use_stderr() && safe != plain {
        anstream::eprint!("{safe}");
    } else {
        // Where it cannot be printed nobody reads it.
        let _ = error.print();
    }
    u8::try_from(error.exit_code()).unwrap_or(2)
}
