//! The program `kinegon` from outside: what it prints and writes, its messages and exit codes.
//! `cargo test --test program styles::` runs one of the modules.

mod catalogue;
mod certain_digits;
mod command_line;
mod command_line_check;
mod command_line_class;
mod command_line_paper;
mod command_line_paths;
mod command_line_pencil;
mod command_line_sizes;
mod command_line_sweep;
mod command_line_values;
mod command_line_variants;
mod command_parts;
mod courses;
#[cfg(feature = "pdf")]
mod drawing_sheets;
mod engine;
mod exercises;
mod file_sets;
#[cfg(unix)] // it has a shell run what pages say
mod guide;
mod installed;
#[cfg(unix)] // limits, links and modes
mod outputs;
mod overlays;
mod photographs;
#[cfg(unix)]
mod signals;
mod step_sheets;
mod strangers;
mod students;
mod studies;
mod styles;
mod wording;
#[cfg(unix)] // it puts programs into folders
mod workbench;
