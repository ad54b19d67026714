//! In: what a scene's figure says of language, notation and decimal mark. Out: a [`Wording`]: every sentence, heading and symbol that figures
//! and the text of the construction show. Names of quantities, keys of files and messages of errors never change and are not here.
//!
//! Sentences are functions with their blanks as parameters, in one table a language: each stands whole in its file, the compiler sees that
//! none is missing and that every blank is filled, and nothing is looked up or parsed at run time. (Fluent and rust-i18n find sentences by
//! name at run time; with a few dozen sentences and no plural forms that buys nothing.)

mod check;
mod class;
mod english;
mod exercise;
mod language;
mod notation;
mod spanish;

pub use check::{CheckWords, MistakeWords};
pub use class::ClassWords;
pub use exercise::ExerciseWords;
pub use language::{Language, NormalParts, PageWords};
pub use notation::{Notation, with_prime};

use crate::scene::{DecimalMark, Figure, LanguageName, NotationName};

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
            language: match figure.language {
                LanguageName::English => &english::ENGLISH,
                LanguageName::Spanish => &spanish::SPANISH,
            },
            notation: match figure.notation {
                NotationName::Paper => &notation::PAPER,
                NotationName::English => &notation::ENGLISH,
                NotationName::Russian => &notation::RUSSIAN,
                NotationName::German => &notation::GERMAN,
            },
            decimal: figure.decimal,
        }
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
