//! Our files as other programs see them: Chromium, LaTeX, Poppler, librsvg. A test whose judge is not installed is skipped, with a word on stderr.
//! `cargo test --test judges pdf::` runs one of the modules.

mod pdf;
mod rasters;
mod tikz;
mod workbench;
