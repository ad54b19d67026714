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
pub(super) enum TableFormat {
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

impl TableFormat {
    /// The endings of files that tell their form.
    pub(super) const ENDINGS: &[(&str, TableFormat)] = &[
        ("csv", TableFormat::Csv),
        ("jsonl", TableFormat::Jsonl),
        ("ndjson", TableFormat::Jsonl),
        #[cfg(feature = "arrow")]
        ("arrow", TableFormat::Arrow),
        #[cfg(feature = "arrow")]
        ("parquet", TableFormat::Parquet),
    ];

    pub(super) fn of_ending(ending: &str) -> Option<TableFormat> {
        let found = TableFormat::ENDINGS.iter().find(|(known, _)| *known == ending);
        found.map(|(_, form)| *form)
    }

    /// Rows in this form, if it is one of text.
    fn text(self, sweep: &Sweep, numbers: &Numbers) -> String {
        match self {
            TableFormat::Csv => format::csv_rows(sweep, numbers),
            TableFormat::Jsonl => format::json_lines(sweep, numbers),
            #[cfg(feature = "arrow")]
            TableFormat::Arrow | TableFormat::Parquet => String::new(),
        }
    }
}

/// Writes a table to a file, or to stdout for `-`: piece by piece, and whole or not at all.
pub(super) fn write(sweep: &Sweep, form: TableFormat, place: &Path) -> Result<(), Failure> {
    let mut out = Out::new(place)?;
    #[cfg(feature = "arrow")]
    if matches!(form, TableFormat::Arrow | TableFormat::Parquet) {
        let unwritable = |error: format::ColumnsError| match error {
            format::ColumnsError::Io(error) => files::unwritable(place, &error),
            other => Failure::Outside(format!("{} cannot be written: {other}", place.display())),
        };
        let columns = match form {
            TableFormat::Parquet => format::Columns::parquet(sweep, out),
            _ => format::Columns::arrow(sweep, out),
        };
        let mut columns = columns.map_err(unwritable)?;
        pieces(sweep).each(
            |rows| sweep.rows(rows),
            |numbers: Numbers| columns.rows(&numbers).map(|()| true).map_err(unwritable),
        )?;
        return columns.finish().map_err(unwritable)?.finish();
    }
    if form == TableFormat::Csv && !out.put(&format::csv_header(sweep))? {
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
