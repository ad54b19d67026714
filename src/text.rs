//! Texts of strangers: titles, labels and names from files, folders and command lines, and how each medium takes them.
//!
//! A terminal obeys escape sequences, a spreadsheet formulas, a browser tags, LaTeX commands. So a [`Untrusted`] has no
//! `Display`: it is opened by saying for what. Texts that are no `Untrusted` are names of points, links and quantities, which
//! are checked when they are read, and sentences that the program makes of these.

use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// A text that somebody else has written: a title, a label, the name of a student, of a file, of an exercise.
///
/// It compares with `&str` and is made from one; what it says can be had only for a medium.
///
/// ```
/// use kinegon::text::Untrusted;
///
/// let name = Untrusted::from("=1+1 \u{1b}[31m<b>");
/// assert_eq!(name.for_terminal(), "=1+1 \u{fffd}[31m<b>");
/// assert_eq!(name.for_cell(), "'=1+1 [31m<b>");
/// assert_eq!(name.for_xml(), "=1+1 [31m&lt;b&gt;");
/// ```
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize)]
#[serde(transparent)]
pub struct Untrusted(String);

impl Untrusted {
    /// Whether it shows nothing: empty, or blanks and invisible characters alone.
    #[must_use]
    pub fn is_blank(&self) -> bool {
        !self.0.chars().any(is_ink)
    }

    /// For a line on a terminal: whole, without anything that a terminal obeys.
    #[must_use]
    pub fn for_terminal(&self) -> String {
        on_a_line(&self.0)
    }

    /// For a message: as on a terminal, and shortened.
    #[must_use]
    pub fn for_message(&self) -> String {
        shown(&self.0)
    }

    /// For a cell of a table that a spreadsheet opens: on one line, and no formula.
    #[must_use]
    pub fn for_cell(&self) -> String {
        cell(&self.0)
    }

    /// For text and attributes of SVG and HTML.
    #[must_use]
    pub fn for_xml(&self) -> String {
        xml(&self.0).into_owned()
    }

    /// For a comment of LaTeX: on one line.
    #[must_use]
    pub fn for_tex_comment(&self) -> String {
        tex_comment(&self.0)
    }

    /// For the metadata of PDF.
    #[must_use]
    pub fn for_pdf(&self) -> String {
        clean(&self.0)
    }

    /// For setting in letters: on one line, with no more marks on a letter than can be set; the writer of the drawing escapes
    /// what it sets.
    pub(crate) fn for_setting(&self) -> String {
        let mut marks = 0;
        let is_set = |letter: &char| {
            marks = if is_mark(*letter) { marks + 1 } else { 0 };
            marks <= MOST_MARKS
        };
        clean(&self.0).chars().filter(is_set).collect()
    }

    /// For finding the file or the exercise that has this name; never to be shown.
    pub(crate) fn for_comparing(&self) -> &str {
        &self.0
    }

    /// Two texts with a dash between them; the second alone where the first is blank.
    #[must_use]
    pub fn with(&self, other: &Untrusted) -> Untrusted {
        if self.is_blank() { other.clone() } else { Untrusted(format!("{} – {}", self.0, other.0)) }
    }

    /// It with a number in brackets; the number alone where it is blank.
    #[must_use]
    pub(crate) fn numbered(&self, number: &str) -> Untrusted {
        if self.is_blank() { Untrusted(number.to_owned()) } else { Untrusted(format!("{} ({number})", self.0)) }
    }

    /// Of the name of a file what stands before its ending.
    #[cfg(feature = "cli")]
    pub(crate) fn stem(&self) -> Untrusted {
        Untrusted(self.0.rsplit_once('.').map_or(&*self.0, |(stem, _)| stem).to_owned())
    }

    /// It on one line, cut to so many characters.
    #[must_use]
    pub(crate) fn cut(&self, most: usize) -> Untrusted {
        let words: Vec<&str> = self.0.split_whitespace().take(most).collect();
        let line = words.join(" ");
        Untrusted(match line.char_indices().nth(most) {
            Some((end, _)) => format!("{}…", &line[..end]),
            None => line,
        })
    }
}

/// As in Rust's source, and shortened: a log is read on a terminal, too.
impl fmt::Debug for Untrusted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", shown(&self.0))
    }
}

/// In files it is a text like others.
#[cfg(feature = "schemas")]
impl schemars::JsonSchema for Untrusted {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        String::schema_name()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        String::json_schema(generator)
    }
}

impl<T: AsRef<str> + ?Sized> From<&T> for Untrusted {
    fn from(text: &T) -> Untrusted {
        Untrusted(text.as_ref().to_owned())
    }
}

impl From<String> for Untrusted {
    fn from(text: String) -> Untrusted {
        Untrusted(text)
    }
}

impl From<&Untrusted> for Untrusted {
    fn from(text: &Untrusted) -> Untrusted {
        text.clone()
    }
}

impl PartialEq<str> for Untrusted {
    fn eq(&self, other: &str) -> bool {
        self.0 == other
    }
}

impl PartialEq<&str> for Untrusted {
    fn eq(&self, other: &&str) -> bool {
        self.0 == *other
    }
}

/// Most marks on one letter that are set: no writing has more (UAX #15, Stream-Safe Text Format), and tens of thousands of
/// them take a browser or a viewer seconds, and have no width by which a line would end.
const MOST_MARKS: usize = 30;

/// Whether a character stands over, under or through the one before it: the blocks of combining marks for any writing.
fn is_mark(c: char) -> bool {
    matches!(c, '\u{300}'..='\u{36f}' | '\u{1ab0}'..='\u{1aff}' | '\u{1dc0}'..='\u{1dff}' | '\u{20d0}'..='\u{20ff}' | '\u{fe20}'..='\u{fe2f}')
}

/// Most characters of a name in a message.
const SHOWN: usize = 80;
/// How many of them stand there if it has more.
const START: usize = 60;

/// A text as a message quotes it: on one line, harmless to a terminal; of a long one the start and the length.
pub(crate) fn shown(text: &str) -> String {
    if text.chars().nth(SHOWN).is_none() {
        return on_a_line(text);
    }
    let start: String = text.chars().take(START).collect();
    format!("{}… ({} characters)", on_a_line(&start), text.chars().count())
}

/// A text on one line, without anything that a terminal obeys; what is replaced shows as `\u{fffd}`.
pub(crate) fn on_a_line(text: &str) -> String {
    text.chars().map(|c| if is_command(c) { '\u{fffd}' } else { c }).collect()
}

/// Most characters of a line of a message; one that is longer has a name that nobody has shortened.
#[cfg(feature = "cli")]
const LINE: usize = 1000;

/// Text of many lines without anything that a terminal obeys.
#[cfg(feature = "cli")]
pub(crate) fn on_a_terminal(text: &str) -> String {
    text.chars().map(|c| if is_command(c) && c != '\n' { '\u{fffd}' } else { c }).collect()
}

/// The lines of a file, of which a message shows some, without anything that a terminal obeys. Every character keeps its
/// place among the bytes.
#[cfg(feature = "cli")]
pub(crate) fn source(text: &str) -> String {
    let safe = |c: char| match (is_command(c) && !"\n\r\t".contains(c), c.len_utf8()) {
        (false, _) => c.to_string(),
        (true, 1) => "?".to_owned(),
        (true, 2) => "¿".to_owned(),
        (true, 3) => "\u{fffd}".to_owned(),
        (true, _) => "¿¿".to_owned(),
    };
    text.chars().map(safe).collect()
}

/// Most lines of a message: somebody with more mistakes mends the first, and asks again.
#[cfg(feature = "cli")]
const LINES: usize = 40;

/// The lines of a message; of very many the first, and how many there are besides.
#[cfg(feature = "cli")]
pub(crate) fn first_lines(text: &str) -> Cow<'_, str> {
    let more = text.split('\n').count().saturating_sub(LINES);
    if more == 0 {
        return Cow::Borrowed(text);
    }
    let lines: Vec<&str> = text.split('\n').take(LINES).collect();
    Cow::Owned(format!("{}\n  … and {more} more", lines.join("\n")))
}

/// A message without anything that a terminal obeys. Of very many lines, and of a line that is far too long, a part is left out.
#[cfg(feature = "cli")]
pub(crate) fn message(text: &str) -> String {
    short_lines(&first_lines(text))
}

/// The lines of a text without anything that a terminal obeys. Of one that is far too long the middle is left out.
#[cfg(feature = "cli")]
pub(crate) fn short_lines(text: &str) -> String {
    let line = |line: &str| {
        let length = line.chars().count();
        if length <= LINE {
            return on_a_line(line);
        }
        let start: String = line.chars().take(LINE / 2).collect();
        let end: String = line.chars().skip(length - LINE / 4).collect();
        format!("{}… ({length} characters) …{}", on_a_line(&start), on_a_line(&end))
    };
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// A text on one line, without what no file may hold: control characters, and those that turn the direction of writing.
pub(crate) fn clean(text: &str) -> String {
    text.chars().filter_map(printable).collect()
}

/// A letter as files hold it: white space is a space; none for one that must not reach a file.
pub(crate) fn printable(letter: char) -> Option<char> {
    match letter {
        letter if letter.is_whitespace() => Some(' '),
        letter if is_command(letter) => None,
        // Not allowed in XML.
        '\u{FFFE}' | '\u{FFFF}' => None,
        letter => Some(letter),
    }
}

/// A text for elements and attributes of SVG and HTML; nearly all are names and numbers, which stay as they are.
pub(crate) fn xml(text: &str) -> Cow<'_, str> {
    if text.bytes().all(|byte| matches!(byte, b' '..=b'~') && !matches!(byte, b'&' | b'<' | b'>' | b'"')) {
        return Cow::Borrowed(text);
    }
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars().filter_map(printable) {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            letter => escaped.push(letter),
        }
    }
    Cow::Owned(escaped)
}

/// A text for a comment of LaTeX, which ends with its line.
pub(crate) fn tex_comment(text: &str) -> String {
    text.chars().map(|letter| printable(letter).unwrap_or(' ')).collect()
}

/// A text for a cell of a table, which no spreadsheet takes for a formula: an apostrophe stands before a sign that begins
/// one, at the start and after whatever some program takes for a separator (OWASP, CSV Injection). Numbers stay numbers.
pub(crate) fn cell(text: &str) -> String {
    let text = clean(text);
    let is_number = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit() || "+-.eE".contains(c));
    if is_number(&text) && text.parse::<f64>().is_ok() {
        return text;
    }
    let mut safe = String::with_capacity(text.len() + 1);
    let mut at_start = true;
    for letter in text.chars() {
        if at_start && "=+-@\u{ff1d}\u{ff0b}\u{ff0d}\u{ff20}\u{fe62}\u{fe63}\u{fe66}\u{fe6b}".contains(letter) {
            safe.push('\'');
        }
        safe.push(letter);
        // What shows nothing is passed over, as spreadsheets do.
        at_start = matches!(letter, ';' | ',' | '"' | '\'' | '|') || (at_start && !is_ink(letter));
    }
    safe
}

/// The text of a cell in quotes, as tables with commas have it.
pub(crate) fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

/// Whether a terminal may obey the character, or a reader be misled by it: control characters, ends of lines, and those
/// that turn the direction of writing or hide what follows (Unicode TR 36).
pub(crate) fn is_command(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{206f}')
        || matches!(c, '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

/// Whether a character shows something by itself.
fn is_ink(c: char) -> bool {
    !(c.is_whitespace()
        || is_command(c)
        || matches!(
            c,
            '\u{ad}' | '\u{34f}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}' | '\u{180b}'..='\u{180f}'
        )
        || matches!(c, '\u{200b}'..='\u{200d}' | '\u{2060}'..='\u{2065}' | '\u{2800}' | '\u{3164}' | '\u{feff}')
        || matches!(c, '\u{fe00}'..='\u{fe0f}' | '\u{ffa0}' | '\u{fffe}' | '\u{ffff}' | '\u{e0100}'..='\u{e01ef}'))
}
