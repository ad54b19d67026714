use crate::study::{Column, Content, Status};
#[cfg(feature = "arrow")]
use arrow_array::{ArrayRef, Float64Array, StringArray, UInt64Array};
#[cfg(feature = "arrow")]
use arrow_schema::{DataType, Field, Schema};
#[cfg(feature = "arrow")]
use std::sync::Arc;

/// The names of a study's columns as the first line of a CSV file (RFC 4180); a name with a comma is in quotes.
#[must_use]
pub fn study_header(columns: &[Column]) -> String {
    let quoted = |name: &String| if name.contains(',') { format!("\"{name}\"") } else { name.clone() };
    columns.iter().map(|column| quoted(&column.name)).collect::<Vec<_>>().join(",") + "\n"
}

/// Rows of a study as lines of CSV: each number as the shortest text that reads back to it, an empty cell where there is none.
#[must_use]
pub fn study_lines(columns: &[Column], numbers: &[f64]) -> String {
    let mut text = String::with_capacity(numbers.len() * 18);
    let mut buffer = zmij::Buffer::new();
    for row in numbers.chunks_exact(columns.len()) {
        for (index, (column, number)) in columns.iter().zip(row).enumerate() {
            if index > 0 {
                text.push(',');
            }
            match column.content {
                Content::Index => text.push_str(&format!("{number}")),
                Content::Status => text.push_str(word(*number)),
                Content::Number if number.is_finite() => text.push_str(buffer.format(*number)),
                Content::Number => {}
            }
        }
        text.push('\n');
    }
    text
}

/// The word for a status's number.
fn word(number: f64) -> &'static str {
    Status::ALL.get(number as usize).map_or("", |status| status.word())
}

/// The columns of a study as Arrow has them.
#[cfg(feature = "arrow")]
pub(super) fn study_schema(columns: &[Column]) -> Schema {
    let field = |column: &Column| {
        let (kind, may_lack) = match column.content {
            Content::Index => (DataType::UInt64, false),
            Content::Status => (DataType::Utf8, false),
            Content::Number => (DataType::Float64, true),
        };
        Field::new(&column.name, kind, may_lack)
    };
    Schema::new(columns.iter().map(field).collect::<Vec<_>>())
}

/// Rows of a study by columns.
#[cfg(feature = "arrow")]
pub(super) fn study_arrays(columns: &[Column], numbers: &[f64]) -> Vec<ArrayRef> {
    let width = columns.len();
    let array = |(index, column): (usize, &Column)| -> ArrayRef {
        let values = numbers.iter().skip(index).step_by(width).copied();
        match column.content {
            Content::Index => Arc::new(values.map(|x| x as u64).collect::<UInt64Array>()),
            Content::Status => Arc::new(values.map(word).map(Some).collect::<StringArray>()),
            Content::Number => Arc::new(values.map(|x| x.is_finite().then_some(x)).collect::<Float64Array>()),
        }
    };
    columns.iter().enumerate().map(array).collect()
}
