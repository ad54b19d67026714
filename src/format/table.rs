use crate::cycle::Sweep;

/// The names of a table's numbers as the first line of a CSV file (RFC 4180); a name with a comma is in quotes.
#[must_use]
pub fn csv_header(sweep: &Sweep) -> String {
    let quoted = |name: String| if name.contains(',') { format!("\"{name}\"") } else { name };
    sweep.header().into_iter().map(quoted).collect::<Vec<_>>().join(",") + "\n"
}

/// Rows of a table as lines of CSV: each number as the shortest text that reads back to it, an empty cell where there
/// is none.
#[must_use]
pub fn csv_rows(sweep: &Sweep, numbers: &[Option<f64>]) -> String {
    let mut text = String::with_capacity(numbers.len() * 20);
    let mut buffer = zmij::Buffer::new();
    for row in numbers.chunks_exact(sweep.header().len()) {
        for (index, number) in row.iter().enumerate() {
            if index > 0 {
                text.push(',');
            }
            if let Some(number) = number {
                text.push_str(buffer.format(*number));
            }
        }
        text.push('\n');
    }
    text
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
