//! Tables as text: CSV (RFC 4180), or a line of JSON for each row.

use crate::cycle::Sweep;
use crate::study::{Column, Content, Status};

/// The columns of a table over a drive, as a study has them; of a vector's numbers each is a column. Units are left out.
#[must_use]
pub fn columns_of(sweep: &Sweep) -> Vec<Column> {
    let column = |name| Column { name, content: Content::Number, unit: String::new() };
    sweep.header().into_iter().map(column).collect()
}

/// The names of a table's columns as the first line of a CSV file; a name with a comma is in quotes.
#[must_use]
pub fn csv_header(columns: &[Column]) -> String {
    let quoted = |name: &str| if name.contains(',') { format!("\"{name}\"") } else { name.to_owned() };
    columns.iter().map(|column| quoted(&column.name)).collect::<Vec<_>>().join(",") + "\n"
}

/// Rows of a table as lines of CSV: indices whole, states as words, each number as the shortest text that reads back to
/// it, an empty cell where there is none.
#[must_use]
pub fn csv_rows<T: Copy + Into<Option<f64>>>(columns: &[Column], numbers: &[T]) -> String {
    let mut buffer = zmij::Buffer::new();
    let mut text = String::with_capacity(numbers.len() * 20);
    for row in numbers.chunks_exact(columns.len()) {
        for (index, (column, &number)) in columns.iter().zip(row).enumerate() {
            if index > 0 {
                text.push(',');
            }
            match (column.content, number.into()) {
                (Content::Index, Some(number)) => text.push_str(&format!("{number}")),
                (Content::Status, Some(number)) => text.push_str(status(number)),
                (Content::Number, Some(number)) if number.is_finite() => text.push_str(buffer.format(number)),
                _ => {}
            }
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
    let mut keys = vec![(sweep.path.drive.quantity.clone(), false)];
    for column in &sweep.columns {
        keys.push((column.name().to_owned(), column.is_vector()));
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
