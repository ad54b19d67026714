//! In: what a scene's figure says of language, notation and decimal mark. Out: a [`Wording`]: every sentence, heading and symbol that figures
//! and the text of the construction show. Names of quantities, keys of files and messages of errors never change and are not here.
//!
//! Each language is a text file of sentences with named blanks, `english.txt` and so on. `sentences.rs` and `mistakes.rs` declare every sentence
//! once, and give it a method: so the compiler sees that every blank is filled, and a test that every language says everything. A file is
//! read once; after that a sentence is found by its place. (Fluent and rust-i18n find sentences by name at run time, and bring plural forms
//! that two or three sentences would use.)

mod catalogue;
mod languages;
mod mistakes;
mod notation;
mod number;
mod sentences;

pub use catalogue::Language;
pub use mistakes::MistakeWords;
pub use notation::{Notation, with_prime};
pub use number::{Medium, NumberStyle, power_of_ten};

use crate::scene::{DecimalMark, Figure, NotationName};

/// How things are said and written on figures and in the steps.
#[derive(Clone, Copy, Debug)]
pub struct Wording {
    /// All sentences.
    pub language: &'static Language,
    /// All symbols that schools write differently.
    pub notation: &'static Notation,
    /// What stands before the decimals of a number.
    pub decimal: DecimalMark,
}

impl Default for Wording {
    /// English, as the source paper writes, with decimal points.
    fn default() -> Self {
        Wording::of(&Figure::default())
    }
}

impl Wording {
    /// What a figure asks for.
    #[must_use]
    pub fn of(figure: &Figure) -> Wording {
        Wording {
            language: Language::of(figure.language),
            notation: match figure.notation {
                NotationName::Paper => &notation::PAPER,
                NotationName::English => &notation::ENGLISH,
                NotationName::Russian => &notation::RUSSIAN,
                NotationName::German => &notation::GERMAN,
            },
            decimal: figure.decimal,
        }
    }

    /// A number, with the decimal mark.
    #[must_use]
    pub fn write(&self, x: f64, style: NumberStyle) -> String {
        style.write(x, self.decimal)
    }

    /// A number that was written with a point, with its decimal mark.
    #[must_use]
    pub fn number(&self, written: String) -> String {
        match self.decimal {
            DecimalMark::Point => written,
            DecimalMark::Comma => written.replace('.', ","),
        }
    }
}
