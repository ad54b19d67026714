//! The program `kinegon`: see `kinegon --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    kinegon::cli::run()
}
