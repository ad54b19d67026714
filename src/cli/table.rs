#[cfg(feature = "arrow")]
use super::files;
use super::message::Failure;
use super::pieces::{Out, Pieces};
use crate::cycle::{Numbers, Sweep};
use crate::format;
use clap::ValueEnum;
use std::path::Path;

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
        pieces(sweep).each(
            |rows| sweep.rows(rows),
            |numbers: Numbers| columns.rows(&numbers).map(|()| true).map_err(unwritable),
        )?;
        return columns.finish().map_err(unwritable)?.finish();
    }
    if form == Form::Csv && !out.put(&format::csv_header(sweep))? {
        return Ok(());
    }
    let text = |rows| form.text(sweep, &sweep.rows(rows));
    pieces(sweep).each(text, |piece: String| out.put(&piece))?;
    out.finish()
}

/// The rows of a table in pieces, with a bar where there are many.
fn pieces(sweep: &Sweep) -> Pieces {
    let count = sweep.steps().count();
    Pieces { count, size: ROWS, ahead: 4, unit: (count * sweep.header().len() >= LONG).then_some("rows") }
}
