use super::files::{self, Growing};
use super::message::Failure;
use crate::cores::on_all_cores;
use crate::cycle::{Numbers, Sweep};
use crate::format;
use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

/// Rows that are computed in one piece.
const ROWS: usize = 2048;

/// Numbers from which a table counts as long, so that a terminal sees how far it has come.
const LONG: usize = 3_000_000;

/// The form of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Form {
    /// A line of names, then a line for each position.
    Csv,
    /// A JSON object a line for each position.
    Jsonl,
    /// Apache Arrow's file format, a column for each number.
    #[cfg(feature = "arrow")]
    Arrow,
    /// Apache Parquet, a column for each number.
    #[cfg(feature = "arrow")]
    Parquet,
}

impl Form {
    /// The endings of files that tell their form.
    pub(super) const ENDINGS: &[(&str, Form)] = &[
        ("csv", Form::Csv),
        ("jsonl", Form::Jsonl),
        ("ndjson", Form::Jsonl),
        #[cfg(feature = "arrow")]
        ("arrow", Form::Arrow),
        #[cfg(feature = "arrow")]
        ("parquet", Form::Parquet),
    ];

    pub(super) fn of_ending(ending: &str) -> Option<Form> {
        let found = Form::ENDINGS.iter().find(|(known, _)| *known == ending);
        found.map(|(_, form)| *form)
    }

    /// Rows in this form, if it is one of text.
    fn text(self, sweep: &Sweep, numbers: &Numbers) -> String {
        match self {
            Form::Csv => format::csv_rows(sweep, numbers),
            Form::Jsonl => format::json_lines(sweep, numbers),
            #[cfg(feature = "arrow")]
            Form::Arrow | Form::Parquet => String::new(),
        }
    }
}

/// Writes a table to a file, or to stdout for `-`: piece by piece, and whole or not at all.
pub(super) fn write(sweep: &Sweep, form: Form, place: &Path) -> Result<(), Failure> {
    let mut out = Out::new(place)?;
    #[cfg(feature = "arrow")]
    if matches!(form, Form::Arrow | Form::Parquet) {
        let unwritable = |error: format::ColumnsError| match error {
            format::ColumnsError::Io(error) => files::unwritable(place, &error),
            other => Failure::Outside(format!("{} cannot be written: {other}", place.display())),
        };
        let columns = match form {
            Form::Parquet => format::Columns::parquet(sweep, out),
            _ => format::Columns::arrow(sweep, out),
        };
        let mut columns = columns.map_err(unwritable)?;
        each_piece(
            sweep,
            |rows| sweep.rows(rows),
            |numbers: Numbers| columns.rows(&numbers).map(|()| true).map_err(unwritable),
        )?;
        return columns.finish().map_err(unwritable)?.finish();
    }
    if form == Form::Csv && !out.put(&format::csv_header(sweep))? {
        return Ok(());
    }
    let text = |rows| form.text(sweep, &sweep.rows(rows));
    each_piece(sweep, text, |piece: String| out.put(&piece))?;
    out.finish()
}

/// Where a table goes.
enum Out<'a> {
    Stdout,
    File(Growing, &'a Path),
}

impl<'a> Out<'a> {
    fn new(place: &'a Path) -> Result<Self, Failure> {
        if place == Path::new("-") {
            return Ok(Out::Stdout);
        }
        Ok(Out::File(Growing::new(place)?, place))
    }

    /// Writes text; whether anybody wants more.
    fn put(&mut self, text: &str) -> Result<bool, Failure> {
        match self {
            Out::Stdout => files::is_printed(text.as_bytes()),
            Out::File(file, place) => match file.write_all(text.as_bytes()) {
                Err(error) => Err(files::unwritable(place, &error)),
                Ok(()) => Ok(true),
            },
        }
    }

    fn finish(self) -> Result<(), Failure> {
        match self {
            Out::Stdout => Ok(()),
            Out::File(file, _) => file.finish(),
        }
    }
}

#[cfg(feature = "arrow")]
impl Write for Out<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match self {
            Out::Stdout => std::io::stdout().write(bytes),
            Out::File(file, _) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        match self {
            Out::Stdout => std::io::stdout().flush(),
            Out::File(file, _) => file.flush(),
        }
    }
}

/// Computes a table's pieces, some at a time on all cores, and hands them on in order while somebody wants more; Ctrl-C ends it.
fn each_piece<P: Send>(
    sweep: &Sweep,
    piece: impl Fn(std::ops::Range<usize>) -> P + Send + Sync,
    mut put: impl FnMut(P) -> Result<bool, Failure>,
) -> Result<(), Failure> {
    static STOPPED: AtomicBool = AtomicBool::new(false);
    // Where a handler cannot be set, Ctrl-C ends the program as it would have without one.
    let _ = ctrlc::set_handler(|| STOPPED.store(true, Ordering::Relaxed));
    let count = sweep.steps().count();
    let rows = |first: &usize| piece(*first..(first + ROWS).min(count));
    let progress = progress(sweep);
    for start in (0..count).step_by(ROWS * window()) {
        let firsts = (start..count).step_by(ROWS).take(window());
        let firsts: Vec<usize> = firsts.collect();
        for done in on_all_cores(&firsts, rows) {
            if STOPPED.load(Ordering::Relaxed) {
                return Err(Failure::Interrupted);
            }
            if !put(done)? {
                return Ok(());
            }
            progress.inc(ROWS as u64);
        }
    }
    progress.finish_and_clear();
    Ok(())
}

/// How many pieces are in memory at a time: some for each core.
fn window() -> usize {
    #[cfg(feature = "parallel")]
    return 4 * rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    1
}

/// A bar on a terminal's stderr for a long table.
fn progress(sweep: &Sweep) -> ProgressBar {
    let rows = sweep.steps().count();
    if rows * sweep.header().len() < LONG || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{wide_bar} {percent}% of {len} rows, {eta} left");
    ProgressBar::new(rows as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
