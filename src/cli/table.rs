#[cfg(feature = "arrow")]
use super::files;
use super::message::Failure;
use super::pieces::{Output, Pieces};
use crate::cycle::{Numbers, Sweep};
use crate::format;
use clap::ValueEnum;
use std::path::Path;

/// Rows in a piece.
const ROWS: usize = 2048;

/// Numbers in a table from which a progress bar is shown.
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
    /// The formats by the endings of files.
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
        TableFormat::ENDINGS.iter().find(|(known, _)| *known == ending).map(|(_, format)| *format)
    }

    /// Rows as text; empty for the binary formats.
    fn text(self, sweep: &Sweep, numbers: &Numbers) -> String {
        match self {
            TableFormat::Csv => format::csv_rows(sweep, numbers),
            TableFormat::Jsonl => format::json_lines(sweep, numbers),
            #[cfg(feature = "arrow")]
            TableFormat::Arrow | TableFormat::Parquet => String::new(),
        }
    }
}

/// Writes a table to a file, or to stdout for `-`, piece by piece; a file is complete or not written at all.
pub(super) fn write(sweep: &Sweep, format: TableFormat, place: &Path) -> Result<(), Failure> {
    let mut out = Output::new(place)?;
    #[cfg(feature = "arrow")]
    if matches!(format, TableFormat::Arrow | TableFormat::Parquet) {
        let unwritable = |error: format::ColumnsError| match error {
            format::ColumnsError::Io(error) => files::unwritable(place, &error),
            other => Failure::Outside(format!("{} cannot be written: {other}", place.display())),
        };
        let columns = match format {
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
    if format == TableFormat::Csv && !out.put(&format::csv_header(sweep))? {
        return Ok(());
    }
    let text = |rows| format.text(sweep, &sweep.rows(rows));
    pieces(sweep).each(text, |piece: String| out.put(&piece))?;
    out.finish()
}

/// The rows of a table in pieces, with a progress bar if there are many.
fn pieces(sweep: &Sweep) -> Pieces {
    let count = sweep.steps().count();
    Pieces { count, size: ROWS, per_core: 4, unit: (count * sweep.header().len() >= LONG).then_some("rows") }
}
