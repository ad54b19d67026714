//! In: language, notation and decimal mark of a scene's figure. Out: a [`Wording`]: the sentences, headings and symbols
//! of figures and of the text of the construction. Names of quantities and keys of files are the same in every language and are
//! not here. Errors and warnings are declared where they arise, in the `says.rs` of each folder; `Language::says` puts them
//! into words.
//!
//! `sentences.rs` declares every sentence once, with its named blanks and its English words, and gives it a method: the
//! compiler checks that every blank is filled. Every other language is a text file with the same keys, as `spanish.txt`;
//! a test checks that it has every sentence, another that it has every message. Sentences of mistakes are declared where the mistakes are, in
//! `check/mistakes/`; their words stand in the text files, those in English in `english.txt`. A file is read once; then a
//! sentence is found by its index. (Fluent and rust-i18n find sentences by name at run time, and bring plural forms that
//! two or three sentences would use.)

#[doc(hidden)] // for tests
pub mod catalogue;
mod number;
#[doc(hidden)] // for tests
pub mod sentences;

pub use catalogue::Language;
pub(crate) use number::certain_angle;
pub use number::{Medium, NumberStyle, power_of_ten};

use crate::scene::{DecimalMark, Figure, LanguageName};
use crate::sheet::Order;
use catalogue::{Declared, Read, Tables, read};
use sentences::DECLARED;
use std::sync::LazyLock;

/// The text of a language's catalogue; the English one has only the sentences of mistakes.
#[doc(hidden)] // for tests
pub fn catalogue_of(name: LanguageName) -> &'static str {
    match name {
        LanguageName::English => include_str!("english.txt"),
        LanguageName::Spanish => include_str!("spanish.txt"),
    }
}

/// The languages in the order of [`LanguageName::ALL`], each read when it is spoken.
static LANGUAGES: [LazyLock<Language>; LanguageName::ALL.len()] =
    [LazyLock::new(|| language(LanguageName::English)), LazyLock::new(|| language(LanguageName::Spanish))];

/// A language by its catalogue. What that lacks is said in English.
fn language(name: LanguageName) -> Language {
    let english_tables = read(catalogue_of(LanguageName::English), &[]).0.tables;
    let Read { sentences, tables } = match name {
        LanguageName::English => Read { sentences: Vec::new(), tables: Tables::new() },
        other => read(catalogue_of(other), DECLARED).0,
    };
    let sentence =
        |(index, declared): (usize, &Declared)| sentences.get(index).copied().flatten().unwrap_or(declared.english);
    Language {
        code: name.as_str(),
        sentences: DECLARED.iter().enumerate().map(sentence).collect(),
        tables: english_tables.into_iter().chain(tables).collect(),
    }
}

impl Language {
    /// The language of that name.
    #[must_use]
    pub fn of(name: LanguageName) -> &'static Language {
        &LANGUAGES[name as usize]
    }
}

/// Language, notation and decimal mark of figures and steps.
#[derive(Clone, Copy, Debug)]
pub struct Wording {
    /// The sentences.
    pub language: &'static Language,
    /// The symbols that schools write differently.
    pub notation: &'static Notation,
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
        Wording {
            language: Language::of(figure.language),
            notation: Notation::ALL[figure.notation as usize],
            decimal: figure.decimal,
        }
    }

    /// A number in this style, with the wording's decimal mark.
    #[must_use]
    pub fn write(&self, x: f64, style: NumberStyle) -> String {
        style.write(x, self.decimal)
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

/// How a school writes poles, images of points and parts of accelerations; in markup, where `_{…}` is an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Notation {
    /// The poles that are not written as in results.
    poles: &'static [(Order, &'static str)],
    /// Whether images of points bear a prime in the acceleration plan: `b′` beside `b` of the velocity plan.
    pub primes: bool,
    /// Index of the normal part of an acceleration.
    pub normal: &'static str,
    /// Index of the tangential part of an acceleration.
    pub tangential: &'static str,
    /// Index of the Coriolis part of an acceleration.
    pub coriolis: &'static str,
    /// Index of the part along a guide.
    pub relative: &'static str,
}

impl Notation {
    /// The notations in the order of [`NotationName::ALL`](crate::scene::NotationName::ALL).
    pub const ALL: [&'static Notation; 4] = [&PAPER, &ENGLISH, &RUSSIAN, &GERMAN];

    /// The symbol of a plan's pole, in markup.
    #[must_use]
    pub fn pole(&self, plan: Order) -> &'static str {
        self.poles.iter().find(|(order, _)| *order == plan).map_or(plan.pole(), |(_, pole)| pole)
    }
}

/// H. Quintero, G. Calle, A. Díaz, E. Henao, Rev. Fac. Ing. Univ. Antioquia 60 (2011) 81–91.
const PAPER: Notation =
    Notation { poles: &[], primes: false, normal: "n", tangential: "t", coriolis: "c", relative: "r" };

/// C. E. Wilson, J. P. Sadler, *Kinematics and Dynamics of Machinery*, 3rd ed., Pearson 2003.
const ENGLISH: Notation =
    Notation { poles: &[(Order::Velocity, "o"), (Order::Acceleration, "o′")], primes: true, ..PAPER };

/// K. V. Frolov (ed.), *Теория механизмов и машин*, Высшая школа, Moscow 1987.
const RUSSIAN: Notation = Notation { tangential: "τ", coriolis: "k", ..PAPER };

/// H. Kerle, B. Corves, M. Hüsing, *Getriebetechnik*, 5th ed., Springer Vieweg 2015.
const GERMAN: Notation = Notation { poles: &[(Order::Velocity, "P_{v}"), (Order::Acceleration, "P_{a}")], ..PAPER };

/// A name with a prime after its letter: `b′`, `d′_2`, `s′3`.
#[must_use]
pub fn with_prime(name: &str) -> String {
    let letters = name.split('_').next().unwrap_or(name);
    let letters = letters.trim_end_matches(|c: char| c.is_ascii_digit());
    let (letter, rest) = name.split_at(letters.len());
    format!("{letter}′{rest}")
}
