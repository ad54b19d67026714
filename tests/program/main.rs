//! The program `kinegon` from outside: what it prints and writes, its messages and exit codes.
//! `cargo test --test program styles::` runs one of the modules.
//!
//! `installed` looks at help, completions in their shells, manual pages, colours and the list of the package.
//! `command_line` and its kin try hostile input; `command_line_check` checks forms, messages and the paper as a
//! student; `outputs` and `signals` run every command that writes against limits, links, bad places and signals;
//! `command_line_class` checks folders of forms, some broken, and marks counted by hand; `command_line_variants`
//! forms of several exercises, and students' pages; `certain_digits` holds every digit that `solve --digits` prints
//! to references; `one_story` asks every command about limits, change points and dead centres; `exercises` sees anew what is asked of exercises, for every kind; `courses` reads files for
//! learning management systems back by the importers' rules, and holds them to the keys; `step_sheets` looks for what
//! each step draws and says; `styles` measures contrast, and colours as dichromats see them; `strangers` gives
//! titles, labels, names and arguments that a terminal, a spreadsheet or a parser would obey, and reads everything
//! back; `load_tables` reads tables of loads from files beside scenes; `notices` asks whether everybody whose work is shipped is named; `films` films and what they refuse; `overlays` the same of students' drawings over the right figure; `wording` looks for words of another
//! language; `students` runs the judge in Python of `tests/students`.

mod boards;
mod catalogue;
mod certain_digits;
mod command_line;
mod command_line_centers;
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
#[cfg(feature = "png")]
mod films;
#[cfg(unix)] // it has a shell run what pages say
mod guide;
mod installed;
mod load_tables;
mod notices;
mod one_story;
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
