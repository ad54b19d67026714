//! Tables as text: CSV (RFC 4180), or a line of JSON for each row.

use crate::cycle::Sweep;
use crate::study::{Column, Content, Status};

/// The names of a table's numbers as the first line of a CSV file; a name with a comma is in quotes.
#[must_use]
pub fn csv_header(sweep: &Sweep) -> String {
    header(sweep.header().iter().map(String::as_str))
}

/// The names of a study's columns as the first line of a CSV file; a name with a comma is in quotes.
#[must_use]
pub fn study_header(columns: &[Column]) -> String {
    header(columns.iter().map(|column| column.name.as_str()))
}

fn header<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let quoted = |name: &str| if name.contains(',') { format!("\"{name}\"") } else { name.to_owned() };
    names.map(quoted).collect::<Vec<_>>().join(",") + "\n"
}

/// Rows of a table as lines of CSV: each number as the shortest text that reads back to it, an empty cell where there
/// is none.
#[must_use]
pub fn csv_rows(sweep: &Sweep, numbers: &[Option<f64>]) -> String {
    let mut buffer = zmij::Buffer::new();
    lines(numbers, sweep.header().len(), |text, _, number| {
        if let Some(number) = number {
            text.push_str(buffer.format(*number));
        }
    })
}

/// Rows of a study as lines of CSV: indices whole, states as words, each number as the shortest text that reads back to
/// it, an empty cell where there is none.
#[must_use]
pub fn study_lines(columns: &[Column], numbers: &[f64]) -> String {
    let mut buffer = zmij::Buffer::new();
    lines(numbers, columns.len(), |text, index, number| match columns[index].content {
        Content::Index => text.push_str(&format!("{number}")),
        Content::Status => text.push_str(status(*number)),
        Content::Number if number.is_finite() => text.push_str(buffer.format(*number)),
        Content::Number => {}
    })
}

/// Rows of so many cells, each written by `write` with its index in the row.
fn lines<T>(cells: &[T], width: usize, mut write: impl FnMut(&mut String, usize, &T)) -> String {
    let mut text = String::with_capacity(cells.len() * 20);
    for row in cells.chunks_exact(width) {
        for (index, cell) in row.iter().enumerate() {
            if index > 0 {
                text.push(',');
            }
            write(&mut text, index, cell);
        }
        text.push('\n');
    }
    text
}

/// The word for a status's number.
pub(super) fn status(number: f64) -> &'static str {
    Status::ALL.get(number as usize).map_or("", |status| status.word())
}

/// Rows of a table as lines of JSON, one object per line: `null` where there is no number, a list of two for a vector.
#[must_use]
pub fn json_lines(sweep: &Sweep, numbers: &[Option<f64>]) -> String {
    let mut keys = vec![(sweep.drive().quantity(), false)];
    for column in sweep.columns() {
        keys.push((column.asked.name().to_owned(), column.asked.is_vector()));
        keys.extend(sweep.error_name(column).map(|name| (name, false)));
    }
    let mut text = String::with_capacity(numbers.len() * 30);
    let mut buffer = zmij::Buffer::new();
    for row in numbers.chunks_exact(sweep.header().len()) {
        let mut row = row.iter();
        let mut push = |text: &mut String| match row.next() {
            Some(Some(number)) => text.push_str(buffer.format(*number)),
            _ => text.push_str("null"),
        };
        for (index, (key, is_vector)) in keys.iter().enumerate() {
            text.push_str(if index == 0 { "{\"" } else { ",\"" });
            text.push_str(key);
            text.push_str("\":");
            if *is_vector {
                text.push('[');
                push(&mut text);
                text.push(',');
            }
            push(&mut text);
            if *is_vector {
                text.push(']');
            }
        }
        text.push_str("}\n");
    }
    text
}
