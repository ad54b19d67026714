//! In: what is said in a language, in Fluent (<https://projectfluent.org>). Out: its sentences by their keys, and one with its blanks filled.
//!
//! Of Fluent a sentence has words, blanks `{$name}`, texts in quotes as `{" "}`, and choices `{$count -> [one] … *[other] …}` by what fills a blank: by the
//! word or number itself, or by the form that the language has for this number. The parser is Fluent's own; its bundle, which looks references,
//! functions and languages up when it is asked, would do what nothing here needs.

use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement, VariantKey};
use fluent_syntax::parser::{self, ParserError};
use fluent_syntax::unicode;
use intl_pluralrules::{PluralCategory, PluralRuleType, PluralRules};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::{LazyLock, OnceLock};
use unic_langid::LanguageIdentifier;

/// The sentences of a language.
pub struct Catalogue {
    sentences: BTreeMap<&'static str, Written>,
    /// The forms of words for numbers; `None` for a language that nobody has told them of.
    plurals: Option<PluralRules>,
}

/// A sentence as it is written with its key, and as it is read once somebody says it: most commands say few of a thousand.
struct Written {
    text: &'static str,
    read: OnceLock<Sentence>,
}

/// A sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sentence(Vec<Part>);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Part {
    Words(Cow<'static, str>),
    Blank(&'static str),
    /// By what fills this blank: words for some of it, and for all other.
    Choice(&'static str, Vec<(&'static str, Sentence)>, Sentence),
}

/// A catalogue's text as far as the library says it: the workbench's part, its last, is within the page, and would be there twice.
macro_rules! library_part {
    ($file:literal) => {{
        const WHOLE: &str = include_str!($file);
        const OWN: [u8; $crate::fluent::library_length(WHOLE)] = $crate::fluent::beginning(WHOLE);
        const TEXT: &str = match std::str::from_utf8(&OWN) {
            Ok(text) => text,
            Err(_) => panic!("a line feed stands where it ends"),
        };
        TEXT
    }};
}
pub(crate) use library_part;

/// English, in which errors are displayed.
pub fn english() -> &'static Catalogue {
    static ENGLISH: LazyLock<Catalogue> = LazyLock::new(|| Catalogue::new("en", library_part!("words/en.ftl")));
    &ENGLISH
}

/// How many bytes of a catalogue stand before the workbench's part.
pub(crate) const fn library_length(text: &str) -> usize {
    const HEADING: &[u8] = b"\n## The workbench";
    let text = text.as_bytes();
    let mut at = 0;
    while at + HEADING.len() <= text.len() {
        let mut same = 0;
        while same < HEADING.len() && text[at + same] == HEADING[same] {
            same += 1;
        }
        if same == HEADING.len() {
            return at;
        }
        at += 1;
    }
    text.len()
}

/// The first bytes of a text.
pub(crate) const fn beginning<const COUNT: usize>(text: &str) -> [u8; COUNT] {
    let mut copied = [0; COUNT];
    let mut at = 0;
    while at < COUNT {
        copied[at] = text.as_bytes()[at];
        at += 1;
    }
    copied
}

impl Catalogue {
    /// The catalogue of the language of this code.
    #[must_use]
    pub fn new(code: &str, text: &'static str) -> Catalogue {
        let begins = |line: &str| line.starts_with(|c: char| c.is_ascii_alphabetic());
        let ends = |line: &str| begins(line) || line.starts_with(['#', '-']);
        let mut sentences = BTreeMap::new();
        let mut starts = Vec::new();
        let mut at = 0;
        for line in text.split_inclusive('\n') {
            if ends(line) {
                starts.push((at, begins(line)));
            }
            at += line.len();
        }
        let next = starts.iter().skip(1).map(|(start, _)| *start).chain([text.len()]);
        for (&(start, is_sentence), end) in starts.iter().zip(next) {
            let text = &text[start..end];
            if let (true, Some((key, _))) = (is_sentence, text.split_once('=')) {
                sentences.insert(key.trim_end(), Written { text, read: OnceLock::new() });
            }
        }
        let rules =
            |code: &str| PluralRules::create(code.parse::<LanguageIdentifier>().ok()?, PluralRuleType::CARDINAL).ok();
        Catalogue { sentences, plurals: rules(code) }
    }

    /// The catalogue of the language of this code; and what is wrong with its text, a line each.
    #[must_use]
    pub fn read(code: &str, text: &'static str) -> (Catalogue, Vec<String>) {
        let (resource, errors) = match parser::parse_runtime(text) {
            Ok(resource) => (resource, Vec::new()),
            Err((resource, errors)) => (resource, errors),
        };
        let fault = |error: &ParserError| {
            // Where the sentence begins: its end is noticed in the line after it.
            let at = error.slice.as_ref().map_or(error.pos.start, |slice| slice.start);
            format!("line {}: {}", 1 + text[..at].matches('\n').count(), error.kind)
        };
        let mut faults: Vec<String> = errors.iter().map(fault).collect();
        let mut seen = BTreeSet::new();
        for entry in resource.body {
            if let Some((key, read)) = message(entry) {
                faults.extend(read.err().map(|says| format!("`{key}`: {says}")));
                if !seen.insert(key) {
                    faults.push(format!("`{key}` is here for the second time"));
                }
            }
        }
        (Catalogue::new(code, text), faults)
    }

    /// The sentence of a key.
    #[must_use]
    pub fn sentence(&self, key: &str) -> Option<&Sentence> {
        let Written { text, read } = self.sentences.get(key)?;
        Some(read.get_or_init(|| {
            let entries = parser::parse_runtime(*text).map(|resource| resource.body).unwrap_or_default();
            let sentence = entries.into_iter().find_map(message).and_then(|(_, read)| read.ok());
            sentence.unwrap_or(Sentence::nothing())
        }))
    }

    /// All keys, in the order of the alphabet.
    pub fn keys(&self) -> impl Iterator<Item = &'static str> {
        self.sentences.keys().copied()
    }

    /// A sentence with what stands for each of its blanks; a blank that is not among `blanks` stays empty.
    #[must_use]
    pub fn filled(&self, sentence: &Sentence, blanks: &[&str], by: &[&str]) -> String {
        let mut text = String::new();
        self.fill(&mut text, sentence, &|blank| {
            blanks.iter().zip(by).find(|(name, _)| **name == blank).map_or("", |(_, by)| by)
        });
        text
    }

    fn fill<'b>(&self, text: &mut String, Sentence(parts): &Sentence, by: &dyn Fn(&str) -> &'b str) {
        for part in parts {
            match part {
                Part::Words(words) => text.push_str(words),
                Part::Blank(blank) => text.push_str(by(blank)),
                Part::Choice(blank, forms, other) => {
                    let by_what = by(blank);
                    let form = |name: &str| forms.iter().find(|(form, _)| *form == name);
                    let chosen = form(by_what).or_else(|| form(self.form_for(by_what)?));
                    self.fill(text, chosen.map_or(other, |(_, sentence)| sentence), by);
                }
            }
        }
    }

    /// The name of the form that words have beside this number.
    fn form_for(&self, number: &str) -> Option<&'static str> {
        Some(match self.plurals.as_ref()?.select(number).ok()? {
            PluralCategory::ZERO => "zero",
            PluralCategory::ONE => "one",
            PluralCategory::TWO => "two",
            PluralCategory::FEW => "few",
            PluralCategory::MANY => "many",
            PluralCategory::OTHER => "other",
        })
    }
}

impl fmt::Debug for Catalogue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.sentences.keys()).finish()
    }
}

impl Sentence {
    /// One that says nothing.
    #[must_use]
    pub const fn nothing() -> Sentence {
        Sentence(Vec::new())
    }

    /// What it says, if it has neither blanks nor choices.
    #[must_use]
    pub fn words(&self) -> Option<&str> {
        match self.0.as_slice() {
            [] => Some(""),
            [Part::Words(words)] => Some(words),
            _ => None,
        }
    }

    /// The names of its blanks, and of those that it chooses by.
    #[must_use]
    pub fn blanks(&self) -> BTreeSet<&'static str> {
        let mut blanks = BTreeSet::new();
        for part in &self.0 {
            match part {
                Part::Words(_) => {}
                Part::Blank(blank) => _ = blanks.insert(*blank),
                Part::Choice(blank, forms, other) => {
                    blanks.insert(*blank);
                    let all = forms.iter().map(|(_, sentence)| sentence).chain([other]);
                    blanks.extend(all.flat_map(Sentence::blanks));
                }
            }
        }
        blanks
    }

    /// Words that stand beside each other are one part.
    fn push(&mut self, part: Part) {
        match (self.0.last_mut(), part) {
            (Some(Part::Words(before)), Part::Words(words)) => before.to_mut().push_str(&words),
            (_, part) => self.0.push(part),
        }
    }
}

/// The key of an entry, and its sentence; `None` for a comment.
fn message(entry: Entry<&'static str>) -> Option<(&'static str, Result<Sentence, &'static str>)> {
    let (key, pattern) = match entry {
        Entry::Message(message) if message.attributes.is_empty() => (message.id.name, message.value),
        Entry::Message(message) => (message.id.name, None),
        Entry::Term(term) => (term.id.name, None),
        _ => return None,
    };
    Some((key, pattern.ok_or("only sentences are read, no terms and no attributes").and_then(sentence)))
}

/// A sentence as it is parsed.
fn sentence(pattern: Pattern<&'static str>) -> Result<Sentence, &'static str> {
    let mut whole = Sentence::nothing();
    for element in pattern.elements {
        whole.push(match element {
            PatternElement::TextElement { value } => Part::Words(Cow::Borrowed(value)),
            PatternElement::Placeable { expression: Expression::Inline(inline) } => match inline {
                InlineExpression::StringLiteral { value } => Part::Words(unicode::unescape_unicode_to_string(value)),
                InlineExpression::VariableReference { id } => Part::Blank(id.name),
                _ => return Err("in braces stand blanks as {$name} and texts in quotes"),
            },
            PatternElement::Placeable { expression: Expression::Select { selector, variants } } => {
                let InlineExpression::VariableReference { id } = selector else {
                    return Err("a choice is made by a blank, as {$count -> …}");
                };
                let (mut forms, mut other) = (Vec::new(), Sentence::nothing());
                for variant in variants {
                    let (VariantKey::Identifier { name } | VariantKey::NumberLiteral { value: name }) = variant.key;
                    let read = sentence(variant.value)?;
                    if variant.default { other = read } else { forms.push((name, read)) }
                }
                Part::Choice(id.name, forms, other)
            }
        });
    }
    Ok(whole)
}
