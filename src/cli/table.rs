#[cfg(feature = "arrow")]
use super::files;
use super::message::Failure;
use super::output::FileSet;
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

    /// What to try where the ending of a file is not one of those `taken`.
    pub(super) fn hint(ending: Option<&str>, taken: impl Fn(TableFormat) -> bool) -> String {
        let taken = TableFormat::ENDINGS.iter().filter(|(_, format)| taken(*format));
        let known: Vec<&str> = taken.map(|(ending, _)| *ending).collect();
        let known = format!("known endings: {}; or give --format", known.join(", "));
        if cfg!(not(feature = "arrow")) && matches!(ending, Some("arrow" | "parquet")) {
            return format!(
                "this needs Kinegon built with `--features arrow`, or its Python package and pyarrow; {known}"
            );
        }
        known
    }

    /// Rows as text; empty for the binary formats.
    fn text(self, sweep: &Sweep, numbers: &Numbers) -> String {
        match self {
            TableFormat::Csv => format::csv_rows(&format::columns_of(sweep), numbers),
            TableFormat::Jsonl => format::json_lines(sweep, numbers),
            #[cfg(feature = "arrow")]
            TableFormat::Arrow | TableFormat::Parquet => String::new(),
        }
    }
}

/// Writes a table to a file, or to stdout for `-`, piece by piece; a file is complete or not written at all.
pub(super) fn write(sweep: &Sweep, format: TableFormat, place: &Path) -> Result<(), Failure> {
    let mut files = FileSet::default();
    let mut out = Output::new(&mut files, place)?;
    #[cfg(feature = "arrow")]
    if matches!(format, TableFormat::Arrow | TableFormat::Parquet) {
        let unwritable = |error: format::ColumnsError| match error {
            format::ColumnsError::Io(error) => files::unwritable(place, &error),
            other => Failure::outside(format!("{} cannot be written: {other}", place.display())),
        };
        let form =
            if format == TableFormat::Parquet { format::ColumnFormat::Parquet } else { format::ColumnFormat::Arrow };
        let mut columns = format::Columns::new(form, &format::columns_of(sweep), out).map_err(unwritable)?;
        pieces(sweep).each(
            |rows| sweep.rows(rows),
            |numbers: Numbers| columns.rows(&numbers).map(|()| true).map_err(unwritable),
        )?;
        columns.finish().map_err(unwritable)?.end()?;
        return files.finish();
    }
    if format == TableFormat::Csv && !out.put(&format::csv_header(&format::columns_of(sweep)))? {
        return Ok(());
    }
    let text = |rows| format.text(sweep, &sweep.rows(rows));
    pieces(sweep).each(text, |piece: String| out.put(&piece))?;
    out.end()?;
    files.finish()
}

/// The rows of a table in pieces, with a progress bar if there are many.
fn pieces(sweep: &Sweep) -> Pieces {
    let count = sweep.steps().count();
    Pieces { count, size: ROWS, per_core: 4, unit: (count * sweep.header().len() >= LONG).then_some("rows") }
}

/// Bytes from which a table is written only if that is asked for.
const HUGE: f64 = 1e9;

/// Refuses a table that would fill a disk: its bytes are those of some rows, from all over it, times their number.
pub(super) fn refuse_huge(sweep: &Sweep, format: TableFormat) -> Result<(), Failure> {
    const SPOTS: usize = 16;
    let count = sweep.steps().count();
    let columns = sweep.header().len();
    // No number takes 1 kB with its name.
    if (count as f64) * (columns as f64) < HUGE / 1e3 {
        return Ok(());
    }
    let row = |spot: usize| (count - 1) / (SPOTS - 1) * spot;
    let bytes: usize = match format {
        #[cfg(feature = "arrow")]
        TableFormat::Arrow | TableFormat::Parquet => SPOTS * columns * size_of::<f64>(),
        _ => (0..SPOTS).map(|spot| format.text(sweep, &sweep.rows(row(spot)..row(spot) + 1)).len()).sum(),
    };
    let bytes = count as f64 * bytes as f64 / SPOTS as f64;
    if bytes <= HUGE {
        return Ok(());
    }
    Err(Failure::misuse(
        format!("the table would have {} rows and about {} GB", grouped(count), grouped((bytes / 1e9).ceil() as usize)),
        "take a larger --step, a part of the range (--from, --to) or fewer quantities (--want); with --yes it is written",
    ))
}

/// A whole number with its digits in groups of three.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let is_gap = |at: usize| at > 0 && (digits.len() - at).is_multiple_of(3);
    digits.char_indices().flat_map(|(at, digit)| is_gap(at).then_some(' ').into_iter().chain([digit])).collect()
}
