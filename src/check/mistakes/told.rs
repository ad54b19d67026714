//! The mistakes, and what is told of them: which sentences, and what stands in their blanks.

use super::catalogue::catalogue;
use crate::geometry::with_turns;
use crate::scene::{Head, QuantityName};
use crate::sheet::{QuantityKind, Sheet};
use crate::words::{Language, Wording};

/// Largest difference, in degrees, of crank angles that are reported as one.
const NEAR: f64 = 5.0;

/// What a row of the catalogue says of a mistake.
struct Row {
    mistake: Mistake,
    id: &'static str,
    percent: f64,
    /// The keys of its sentences, with the names of their blanks.
    sentences: &'static [(&'static str, &'static [&'static str])],
}

macro_rules! mistakes {
    ($($(#[$about:meta])+ $mistake:ident $id:literal $percent:literal $find:path {
        $($(#[$case:meta])* $key:ident($($blank:ident),*))+
    })+) => {
        /// A mistake of the catalogue.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Mistake { $($(#[$about])+ $mistake),+ }

        const ROWS: &[Row] = &[$(Row {
            mistake: Mistake::$mistake,
            id: $id,
            percent: $percent,
            sentences: &[$((stringify!($key), &[$(stringify!($blank)),*])),+],
        }),+];

        /// The sentences of the mistakes: a function for each pair, which fills its blanks.
        pub(crate) mod tell {
            use super::{Blank, Mistake, Told};

            $($($(#[$case])*
            pub fn $key($($blank: Blank),*) -> Told {
                let blanks = vec![$((stringify!($blank), $blank)),*];
                Told { mistake: Mistake::$mistake, key: stringify!($key), blanks }
            })+)+
        }
    };
}

catalogue!(mistakes);

impl Mistake {
    /// All mistakes, in the order of the catalogue.
    pub fn all() -> impl Iterator<Item = Mistake> {
        ROWS.iter().map(|row| row.mistake)
    }

    /// Its name in results, as `coriolis-forgotten`.
    #[must_use]
    pub fn id(self) -> &'static str {
        self.row().id
    }

    /// The approximate share of the drawings with a mistake that have this one, in per cent.
    #[must_use]
    pub fn share(self) -> f64 {
        self.row().percent
    }

    /// Its sentences with nothing in their blanks, each pair once.
    pub fn sentences(self) -> impl Iterator<Item = Told> {
        let sentences = self.row().sentences.iter();
        sentences.map(move |(key, blanks)| Told {
            mistake: self,
            key,
            blanks: blanks.iter().map(|blank| (*blank, "".into())).collect(),
        })
    }

    fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }
}

/// A pair of sentences about a mistake, what was probably done and what should be, with their blanks filled.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Told {
    /// The mistake.
    pub mistake: Mistake,
    /// The common key of the two sentences in the languages' files.
    pub key: &'static str,
    /// The blanks with their names in the sentences.
    pub blanks: Vec<(&'static str, Blank)>,
}

/// What stands in a blank.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Blank {
    /// Words that stand as they are: names of points and links, ends of vectors, units, scales.
    Words(String),
    /// A number as it is written with a decimal point.
    Number(String),
    /// A quantity, by its name.
    Quantity(String),
    /// A rate or a length as it stands in formulas, by the name of its quantity.
    Symbol(String),
    /// The cut line for a special point.
    CutLine(String),
    /// The guide of a slider.
    Guide(String),
    /// A line through two points.
    LineThrough(String),
    /// The horizontal component of a segment.
    Horizontal,
    /// Its vertical component.
    Vertical,
    /// All segments of a sheet.
    AllSegments,
    /// All values of a kind.
    AllOf(QuantityKind),
}

impl From<&str> for Blank {
    fn from(words: &str) -> Blank {
        Blank::Words(words.to_owned())
    }
}

impl Blank {
    /// Its name, number or words as results write them.
    #[must_use]
    pub fn text(&self) -> &str {
        match self {
            Blank::Words(text)
            | Blank::Number(text)
            | Blank::Quantity(text)
            | Blank::Symbol(text)
            | Blank::CutLine(text)
            | Blank::Guide(text)
            | Blank::LineThrough(text) => text,
            Blank::Horizontal => "x",
            Blank::Vertical => "y",
            Blank::AllSegments | Blank::AllOf(_) => "",
        }
    }

    /// The text that is shown; `quantity` tells a quantity by its name.
    fn shown(&self, words: &Wording, quantity: &dyn Fn(&str) -> String) -> String {
        let language = words.language;
        match self {
            Blank::Words(text) => text.clone(),
            Blank::Number(written) => words.number(written.clone()),
            Blank::Quantity(name) => quantity(name),
            Blank::Symbol(name) => symbol(name).unwrap_or_else(|| quantity(name)),
            Blank::CutLine(special) => language.line_cut(special),
            Blank::Guide(slider) => language.line_guide(slider),
            Blank::LineThrough(points) => language.line_through(points),
            Blank::Horizontal => language.horizontal().to_owned(),
            Blank::Vertical => language.vertical().to_owned(),
            Blank::AllSegments => language.all_segments().to_owned(),
            Blank::AllOf(kind) => all_of(*kind, language).to_owned(),
        }
    }
}

/// All values of a kind, as a sentence begins with them.
fn all_of(kind: QuantityKind, language: &Language) -> &str {
    match kind {
        QuantityKind::AngularVelocity => language.all_angular_velocities(),
        QuantityKind::AngularAcceleration => language.all_angular_accelerations(),
        QuantityKind::Velocity => language.all_velocities(),
        QuantityKind::Acceleration => language.all_accelerations(),
        QuantityKind::Force => language.all_forces(),
        QuantityKind::Moment => language.all_moments(),
        _ => language.all_lengths(),
    }
}

/// The symbol of a rate of rotation or of a length: `ω_2` for `omega(2)`, `L_AB` for `L(A,B)`.
pub(in crate::check) fn symbol(name: &str) -> Option<String> {
    let name = QuantityName::parse(name).filter(QuantityName::is_plain)?;
    let letter = match name.head {
        Head::Omega => "ω",
        Head::Alpha => "α",
        Head::Between(Sheet::Scheme) if name.arguments.iter().all(|end| QuantityName::parse(end).is_none()) => "L",
        _ => return None,
    };
    Some(format!("{letter}_{}", name.arguments.concat()))
}

impl Told {
    /// What was probably done, and what should be, with quantities by their names as in results.
    #[must_use]
    pub fn sentences(&self, words: &Wording) -> [String; 2] {
        self.sentences_with(words, &str::to_owned)
    }

    /// What was probably done, and what should be; `quantity` tells a quantity by its name.
    pub(in crate::check) fn sentences_with(&self, words: &Wording, quantity: &dyn Fn(&str) -> String) -> [String; 2] {
        let shown: Vec<(&str, String)> =
            self.blanks.iter().map(|(name, blank)| (*name, blank.shown(words, quantity))).collect();
        ["done", "should"].map(|which| words.language.of_table(&format!("{}-{which}", self.key), &shown))
    }

    /// What is told where values show the mistake, but not which of several wrong things was taken; `None` where nothing less can be told.
    pub(in crate::check) fn wider(&self) -> Option<Told> {
        match (self.key, self.blanks.as_slice()) {
            ("moment_about_wrong_point", [(_, found), _, (_, right)]) => {
                Some(tell::moment_about_another_point(found.clone(), right.clone()))
            }
            _ => None,
        }
    }

    /// Whether it tells the same of the same place; numbers may differ, as those of another scene.
    pub(crate) fn is_same_place(&self, other: &Told) -> bool {
        let is_number = |blank: &Blank| matches!(blank, Blank::Number(_));
        let alike =
            |(one, two): (&(&str, Blank), &(&str, Blank))| one == two || (is_number(&one.1) && is_number(&two.1));
        self.key == other.key && self.blanks.iter().zip(&other.blanks).all(alike)
    }

    /// Whether it is the same mistake by nearly the same angle: of a drawing by hand several whole degrees are as good.
    pub(in crate::check) fn is_near(&self, other: &Told) -> bool {
        let wrong = |told: &Told| {
            let number = told.blanks.iter().find(|(name, _)| *name == "wrong")?;
            number.1.text().parse::<f64>().ok()
        };
        let is_angle = self.mistake == Mistake::CrankAngle && other.mistake == self.mistake;
        let apart = wrong(self).zip(wrong(other)).filter(|_| is_angle);
        apart.is_some_and(|(one, other)| with_turns(one - other, 0.0).abs() <= NEAR)
    }

    /// Whether it is a mistake in all values of a kind.
    pub(in crate::check) fn is_of_a_kind(&self) -> bool {
        matches!(self.blanks.first(), Some((_, Blank::AllOf(_))))
    }

    /// The quantity with which the sentences begin, as that of a rate that was taken wrongly.
    pub(in crate::check) fn quantity(&self) -> Option<&str> {
        match self.blanks.first() {
            Some((_, Blank::Quantity(name) | Blank::Symbol(name))) => Some(name),
            _ => None,
        }
    }
}
