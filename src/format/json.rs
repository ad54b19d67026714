use crate::text::is_command;
use serde::Serialize;
use serde_json::ser::{Formatter, PrettyFormatter, Serializer};
use std::io;

/// A value as JSON text: one key of an object per line, lists on one line, numbers as the shortest text that reads back
/// to them.
#[must_use]
pub fn json(value: &impl Serialize) -> String {
    written(value, Lines(PrettyFormatter::new())) + "\n"
}

/// A value as JSON text on one line.
#[must_use]
pub fn json_line(value: &impl Serialize) -> String {
    written(value, OneLine)
}

fn written(value: &impl Serialize, formatter: impl Formatter) -> String {
    let mut bytes = Vec::new();
    let mut serializer = Serializer::with_formatter(&mut bytes, formatter);
    value.serialize(&mut serializer).expect("results have text keys and writing to memory does not fail");
    String::from_utf8(bytes).expect("serde_json writes UTF-8")
}

/// Letters of a text. JSON allows some that a terminal would obey; they are escaped.
fn write_harmless<W: ?Sized + io::Write>(out: &mut W, letters: &str) -> io::Result<()> {
    for part in letters.split_inclusive(is_command) {
        let end = part.chars().next_back().filter(|&c| is_command(c));
        out.write_all(&part.as_bytes()[..part.len() - end.map_or(0, char::len_utf8)])?;
        for unit in end.into_iter().flat_map(|c| c.encode_utf16(&mut [0; 2]).to_vec()) {
            write!(out, "\\u{unit:04x}")?;
        }
    }
    Ok(())
}

/// Everything on one line.
struct OneLine;

impl Formatter for OneLine {
    fn write_string_fragment<W: ?Sized + io::Write>(&mut self, out: &mut W, fragment: &str) -> io::Result<()> {
        write_harmless(out, fragment)
    }
}

/// Pretty-printing with lists kept on their line.
struct Lines<'a>(PrettyFormatter<'a>);

impl Formatter for Lines<'_> {
    fn begin_array_value<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        out.write_all(if first { b"" } else { b", " })
    }

    fn begin_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.0.begin_object(out)
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.0.end_object(out)
    }

    fn begin_object_key<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.0.begin_object_key(out, first)
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.0.begin_object_value(out)
    }

    fn end_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.0.end_object_value(out)
    }

    fn write_string_fragment<W: ?Sized + io::Write>(&mut self, out: &mut W, fragment: &str) -> io::Result<()> {
        write_harmless(out, fragment)
    }
}
