//! Our files as other programs see them: Chromium, LaTeX, Poppler, librsvg. A test that needs one of them is ignored
//! unless one asks for it: `cargo test --test judges -- --include-ignored`; `… pdf::` runs one of the modules.
//!
//! `component` tries `<kinegon-plan>`; `films` looks at films in Chromium; `pdf` and `tikz` read back what is written, with lopdf, Poppler and LaTeX; `rasters` compares what librsvg,
//! Chromium and Poppler make of our files with what resvg does; `workbench` uses the workbench in Chromium as people
//! do, by mouse, keys and fingers.

mod component;
mod films;
mod pdf;
mod rasters;
mod tikz;
mod workbench;
