//! Tables of sweeps and studies: their forms, and how they are written.

use super::message::{Failure, refuse};
use super::output::{FileSet, Stream};
use super::pieces::Pieces;
use crate::cycle::{Numbers, Sweep};
use crate::format;
use crate::study::Column;
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

/// The forms by the endings of files.
const ENDINGS: &[(&str, TableFormat)] = &[
    ("csv", TableFormat::Csv),
    ("jsonl", TableFormat::Jsonl),
    ("ndjson", TableFormat::Jsonl),
    #[cfg(feature = "arrow")]
    ("arrow", TableFormat::Arrow),
    #[cfg(feature = "arrow")]
    ("parquet", TableFormat::Parquet),
];

impl TableFormat {
    /// The form that is `given`, else that of the ending of a file, else CSV. `table` names what has only the forms `taken`.
    pub(super) fn of(
        given: Option<TableFormat>,
        output: &Path,
        table: &str,
        taken: impl Fn(TableFormat) -> bool,
    ) -> Result<TableFormat, Failure> {
        let ending = output.extension().and_then(|e| e.to_str());
        let mut known = ENDINGS.iter().filter(|(_, format)| taken(*format));
        let of_ending = || known.clone().find(|(known, _)| *known == ending.unwrap_or("csv"));
        if let Some(format) = given.or_else(|| of_ending().map(|(_, format)| *format)) {
            return Ok(format);
        }
        let message = format!("no form of {table} for files ending in `.{}`", ending.unwrap_or_default());
        let known = known.by_ref().map(|(ending, _)| *ending).collect::<Vec<_>>().join(", ");
        let known = format!("known endings: {known}; or give --format");
        match ending {
            Some("arrow" | "parquet") if cfg!(not(feature = "arrow")) => refuse(
                message,
                format!("this needs Kinegon built with `--features arrow`, or its Python package and pyarrow; {known}"),
            ),
            _ => refuse(message, known),
        }
    }

    /// Rows as text; empty for the binary formats.
    fn text(self, sweep: &Sweep, columns: &[Column], numbers: &Numbers) -> String {
        match self {
            TableFormat::Csv => format::csv_rows(columns, numbers),
            TableFormat::Jsonl => format::json_lines(sweep, numbers),
            #[cfg(feature = "arrow")]
            TableFormat::Arrow | TableFormat::Parquet => String::new(),
        }
    }
}

/// A table that is written piece by piece; a file is complete or not written at all.
pub(super) enum TableWriter {
    Text(Stream),
    #[cfg(feature = "arrow")]
    Columns(std::path::PathBuf, format::Columns<Stream>),
}

impl TableWriter {
    /// A table in a file of a set, or on stdout for `-`, with its head; `None` if nobody reads stdout. Formats by columns say where it
    /// comes from.
    pub(super) fn begin(
        files: &mut FileSet,
        place: &Path,
        format: TableFormat,
        columns: &[Column],
        origin: &[(String, String)],
    ) -> Result<Option<TableWriter>, Failure> {
        #[cfg(not(feature = "arrow"))]
        let _ = origin;
        let mut out = files.begin(place)?;
        match format {
            TableFormat::Csv if !out.put(format::csv_header(columns).as_bytes())? => Ok(None),
            TableFormat::Csv | TableFormat::Jsonl => Ok(Some(TableWriter::Text(out))),
            #[cfg(feature = "arrow")]
            TableFormat::Arrow | TableFormat::Parquet => {
                let form = match format {
                    TableFormat::Parquet => format::ColumnFormat::Parquet,
                    _ => format::ColumnFormat::Arrow,
                };
                let table = format::Columns::with_origin(form, columns, origin, out);
                let table = table.map_err(|error| Failure::unwritable(place, &error))?;
                Ok(Some(TableWriter::Columns(place.to_owned(), table)))
            }
        }
    }

    /// Adds rows, of which `lines` are the text; false if nobody reads on.
    pub(super) fn put<T: Copy + Into<Option<f64>>>(
        &mut self,
        numbers: &[T],
        lines: impl FnOnce() -> String,
    ) -> Result<bool, Failure> {
        #[cfg(not(feature = "arrow"))]
        let _ = numbers;
        match self {
            TableWriter::Text(out) => out.put(lines().as_bytes()),
            #[cfg(feature = "arrow")]
            TableWriter::Columns(place, table) => match table.rows(numbers) {
                Ok(()) => Ok(true),
                Err(error) => Err(Failure::unwritable(place, &error)),
            },
        }
    }

    /// Hands the complete table over to the disk. It is in its place when its set is finished.
    pub(super) fn end(self) -> Result<(), Failure> {
        match self {
            TableWriter::Text(out) => out.end(),
            #[cfg(feature = "arrow")]
            TableWriter::Columns(place, table) => {
                table.finish().map_err(|error| Failure::unwritable(&place, &error))?.end()
            }
        }
    }
}

/// Writes the table of a sweep to a file, or to stdout for `-`.
pub(super) fn write(sweep: &Sweep, format: TableFormat, place: &Path) -> Result<(), Failure> {
    let mut files = FileSet::default();
    let columns = format::columns_of(sweep);
    let Some(mut table) = TableWriter::begin(&mut files, place, format, &columns, &[])? else {
        return Ok(());
    };
    let count = sweep.steps.count();
    let unit = (count * columns.len() >= LONG).then_some("rows");
    let piece = |rows| {
        let numbers = sweep.rows(rows);
        let text = format.text(sweep, &columns, &numbers);
        (numbers, text)
    };
    Pieces { count, size: ROWS, per_core: 4, unit }
        .each(piece, |(numbers, text): (Numbers, String)| table.put(&numbers, || text))?;
    table.end()?;
    files.finish()
}

/// Bytes from which a table is written only if that is asked for.
const HUGE: f64 = 1e9;

/// Refuses a table that would fill a disk: its bytes are those of some rows, from all over it, times their number.
pub(super) fn refuse_huge(sweep: &Sweep, format: TableFormat) -> Result<(), Failure> {
    const SPOTS: usize = 16;
    let count = sweep.steps.count();
    let columns = format::columns_of(sweep);
    // No number takes 1 kB with its name.
    if (count as f64) * (columns.len() as f64) < HUGE / 1e3 {
        return Ok(());
    }
    let row = |spot: usize| (count - 1) / (SPOTS - 1) * spot;
    let bytes: usize = match format {
        #[cfg(feature = "arrow")]
        TableFormat::Arrow | TableFormat::Parquet => SPOTS * columns.len() * size_of::<f64>(),
        _ => (0..SPOTS).map(|spot| format.text(sweep, &columns, &sweep.rows(row(spot)..row(spot) + 1)).len()).sum(),
    };
    let bytes = count as f64 * bytes as f64 / SPOTS as f64;
    if bytes <= HUGE {
        return Ok(());
    }
    refuse(
        format!("the table would have {} rows and about {} GB", grouped(count), grouped((bytes / 1e9).ceil() as usize)),
        "take a larger --step, a part of the range (--from, --to) or fewer quantities (--want); with --yes it is written",
    )
}

/// A whole number with its digits in groups of three.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let is_gap = |at: usize| at > 0 && (digits.len() - at).is_multiple_of(3);
    digits.char_indices().flat_map(|(at, digit)| is_gap(at).then_some(' ').into_iter().chain([digit])).collect()
}
