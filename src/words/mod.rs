//! In: language, notation and decimal mark of a scene's figure. Out: a [`Wording`]: the sentences, headings and symbols
//! of figures and of the text of the construction. Names of quantities and keys of files are the same in every language and are
//! not here. Errors and warnings are declared where they arise, in the `says.rs` of each folder; `Language::says` puts them
//! into words.
//!
//! `sentences/` declares every sentence once, with its named blanks, and gives it a method: the
//! compiler checks that every blank is filled. What they say, and what errors, warnings and the workbench say, stands in a file for each
//! language, as `de.ftl`; tests name what a file lacks. Sentences of mistakes are declared where the mistakes are, in
//! `check/mistakes/`. A sentence is read when it is first said (`fluent.rs`). Symbols stand in `notation.rs`.

mod notation;
mod number;
#[doc(hidden)] // for tests
pub mod sentences;

pub use notation::{FrameSign, Notation, SlidePart, SlideSymbol, SliderNames, under, with_prime};
pub(crate) use number::certain_angle;
pub use number::{Medium, NumberStyle, power_of_ten};
pub(crate) use sentences::sheet_told;

use crate::fluent::{Catalogue, Sentence, english, library_part};
use crate::message::{Declared, Message};
use crate::scene::{DecimalMark, Figure, FrameName, LanguageName};
use crate::sheet::Sheet;
use std::sync::OnceLock;

/// About the rounding of a number near 1.
const ROUNDED: f64 = 1e-16;

/// All sentences of a language, with a method for each, which [`sentences`] declares.
#[derive(Debug)]
pub struct Language(LanguageName);

/// The text of a language's catalogue, with the workbench's part.
#[doc(hidden)] // for tests
#[must_use]
pub fn catalogue_of(name: LanguageName) -> &'static str {
    match name {
        LanguageName::English => include_str!("en.ftl"),
        LanguageName::Spanish => include_str!("es.ftl"),
        LanguageName::German => include_str!("de.ftl"),
        LanguageName::Portuguese => include_str!("pt.ftl"),
    }
}

fn catalogue(name: LanguageName) -> &'static Catalogue {
    static READ: [OnceLock<Catalogue>; LanguageName::ALL.len()] = [const { OnceLock::new() }; LanguageName::ALL.len()];
    match name {
        LanguageName::English => english(),
        other => READ[other as usize].get_or_init(|| Catalogue::new(other.as_str(), own_part_of(other))),
    }
}

/// The text of a language's catalogue as far as the library says it.
fn own_part_of(name: LanguageName) -> &'static str {
    match name {
        LanguageName::English => library_part!("en.ftl"),
        LanguageName::Spanish => library_part!("es.ftl"),
        LanguageName::German => library_part!("de.ftl"),
        LanguageName::Portuguese => library_part!("pt.ftl"),
    }
}

impl Language {
    /// The language of that name.
    #[must_use]
    pub fn of(name: LanguageName) -> &'static Language {
        match name {
            LanguageName::English => &Language(LanguageName::English),
            LanguageName::Spanish => &Language(LanguageName::Spanish),
            LanguageName::German => &Language(LanguageName::German),
            LanguageName::Portuguese => &Language(LanguageName::Portuguese),
        }
    }

    /// Its code in scenes and on the command line, as `en`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.0.as_str()
    }

    fn catalogue(&self) -> &'static Catalogue {
        catalogue(self.0)
    }

    /// The sentence of a key; of what the language lacks, the English one.
    fn sentence(&self, key: &str) -> Option<&'static Sentence> {
        self.catalogue().sentence(key).or_else(|| english().sentence(key))
    }

    /// The words of a sentence without blanks.
    fn words(&self, key: &str) -> &str {
        self.sentence(key).and_then(Sentence::words).unwrap_or_default()
    }

    /// A declared sentence with its blanks filled.
    fn filled(&self, Declared { key, blanks }: &Declared, by: &[&str]) -> String {
        self.sentence(key).map_or_else(String::new, |sentence| self.catalogue().filled(sentence, blanks, by))
    }

    /// What an error or a warning says in this language; in English what this language lacks.
    #[must_use]
    pub fn says(&self, message: &Message) -> String {
        message.told(self.catalogue())
    }

    /// A sentence that is declared elsewhere, as those of mistakes, by its key, with the blanks filled; the key where no language has it.
    #[must_use]
    pub(crate) fn of_table(&self, key: &str, blanks: &[(&str, String)]) -> String {
        let (names, by): (Vec<&str>, Vec<&str>) = blanks.iter().map(|(name, shown)| (*name, shown.as_str())).unzip();
        let sentence = self.sentence(key);
        sentence.map_or_else(|| key.to_owned(), |sentence| self.catalogue().filled(sentence, &names, &by))
    }
}

/// Language, notation and decimal mark of figures and steps.
#[derive(Clone, Copy, Debug)]
pub struct Wording {
    /// The sentences.
    pub language: &'static Language,
    /// The symbols that schools write differently.
    pub notation: Notation,
    /// The decimal mark of numbers.
    pub decimal: DecimalMark,
}

impl Default for Wording {
    /// English, the source paper's notation, decimal points.
    fn default() -> Self {
        Wording::of(&Figure::default())
    }
}

impl Wording {
    /// The wording that a figure asks for.
    #[must_use]
    pub fn of(figure: &Figure) -> Wording {
        Wording { language: Language::of(figure.language), notation: Notation::of(figure), decimal: figure.decimal }
    }

    /// The title of a figure whose scene has none: what it shows.
    #[must_use]
    pub fn title_of(&self, figure: &Figure) -> String {
        let panels = figure.shown_panels();
        let is_titled = |panel: &Sheet| panel.order().is_none() && *panel != Sheet::Scheme;
        let titled = panels.iter().copied().filter(is_titled);
        let shown: Vec<&str> = titled.map(|panel| self.language.sheet(panel)).collect();
        match panels.iter().any(|panel| panel.order().is_some()) || shown.is_empty() {
            true => self.language.title().to_owned(),
            false => shown.join(", "),
        }
    }

    /// The frame, in symbols and sentences: its number, or else the word for it.
    #[must_use]
    pub fn ground(&self) -> &'static str {
        self.notation.frame.map_or(self.language.ground(), FrameName::as_str)
    }

    /// A number in this style, with the wording's decimal mark.
    #[must_use]
    pub fn write(&self, x: f64, style: NumberStyle) -> String {
        style.write(x, self.decimal)
    }

    /// By which part of the largest two routes to the same numbers differ, or may differ. What is below the rounding of a number is not told
    /// apart from nothing.
    #[must_use]
    pub fn agreement(&self, part: f64, style: NumberStyle) -> String {
        if part < ROUNDED { format!("< {}", self.write(ROUNDED, style)) } else { self.write(part, style) }
    }

    /// A place by its written coordinates, as `(10, 5)`; beside decimal commas a semicolon separates them.
    #[must_use]
    pub fn place(&self, [x, y]: [String; 2]) -> String {
        let mark = if self.decimal == DecimalMark::Comma { ";" } else { "," };
        format!("({x}{mark} {y})")
    }

    /// A length in millimetres of paper at the scale `mu`, in units per millimetre; `None` for one of a kilometre and
    /// more, which no paper has.
    #[must_use]
    pub fn on_paper(&self, length: f64, mu: f64, style: NumberStyle) -> Option<String> {
        let mm = length / mu;
        (mm.abs() < 1e6).then(|| self.write(mm, style))
    }

    /// A number that was written with a decimal point, with the wording's decimal mark.
    #[must_use]
    pub fn number(&self, written: String) -> String {
        number::marked(written, self.decimal)
    }
}
