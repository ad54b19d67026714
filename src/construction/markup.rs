//! Markup of captions and equations: names of points stand between backticks; `_{…}` is low, `^{…}` high. Vector
//! equations term by term.

use super::arrow::VectorPart;
use super::plan::Plan;
use crate::scene::{Head, QuantityName};
use crate::sheet::{Order, Sheet};
use crate::words::Wording;

/// A point's name, marked for a caption.
pub(super) fn marked(name: &str) -> String {
    format!("`{name}`")
}

/// A caption or an equation as plain text: names as they are, subscripts after `_`.
pub(crate) fn plain_text(markup: &str) -> String {
    let mut text = String::with_capacity(markup.len());
    push_plain(&mut text, markup);
    text
}

/// A caption or an equation as plain text, with the names of plan points in the notation of `words`.
#[must_use]
pub fn shown_text(markup: &str, plan: Option<&Plan>, words: &Wording) -> String {
    let mut text = String::with_capacity(markup.len());
    for (index, piece) in markup.split('`').enumerate() {
        match (index % 2, plan) {
            (1, Some(plan)) => {
                let shown = plan.shown(piece, piece.to_owned(), &words.notation);
                push_plain(&mut text, &shown);
            }
            _ => push_plain(&mut text, piece),
        }
    }
    text
}

/// Adds markup without braces and backticks; `^2` becomes `²`.
fn push_plain(text: &mut String, markup: &str) {
    let mut letters = markup.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '{' | '}' | '`' => {}
            '^' if letters.next_if_eq(&'2').is_some() => text.push('²'),
            other => text.push(other),
        }
    }
}

/// A subscript of several names, as in `_{S3B}`.
pub(super) fn subscript(names: &[&str]) -> String {
    format!("_{{{}}}", names.concat())
}

/// The symbol of a rate by its quantity name, in markup: `ω_{2}` for `omega(2)`.
pub(crate) fn rate_symbol(name: &str) -> String {
    let parsed = QuantityName::parse(name);
    match parsed.as_ref().map(|name| (name.head, name.arguments.as_slice())) {
        Some((Head::Omega, [link])) => format!("{}_{{{link}}}", Order::Velocity.rate()),
        Some((Head::Alpha, [link])) => format!("{}_{{{link}}}", Order::Acceleration.rate()),
        _ => name.to_owned(),
    }
}

/// The sentence that there is no construction; `far` are the names of special points at infinity.
pub(super) fn no_construction(words: &Wording, far: &[String]) -> String {
    let language = words.language;
    if far.is_empty() {
        return language.no_construction().to_owned();
    }
    let names: Vec<String> = far.iter().map(|name| marked(name)).collect();
    language.no_construction_far(&names.join(language.and()))
}

/// A name with its subscript in braces: the part after the first `_`, else trailing digits, as in `n_{b3}`, `S_{3}`.
#[must_use]
pub fn display(name: &str) -> String {
    let (base, low) = match name.split_once('_') {
        Some((base, low)) => (base, low),
        None => {
            let digits = name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
            name.split_at(digits)
        }
    };
    // The last digit of a pair of links, as in 2/1, is no subscript.
    let is_name = base.ends_with(|c: char| c.is_alphabetic() || c == '\'');
    if low.is_empty() || !is_name { name.to_owned() } else { format!("{base}_{{{low}}}") }
}

/// A plan segment times its scale, as written in an equation.
pub(super) fn measured(sheet: Sheet, from: &str, to: &str) -> String {
    format!("{} ({} {})", sheet.facts().scale_symbol, marked(from), marked(to))
}

/// The vector equation of a step, term by term.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Formula {
    /// Its vectors, and the signs and words between them, in reading order.
    pub terms: Vec<FormulaTerm>,
}

/// A vector of a formula, or a sign, number or words beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaTerm {
    /// The term in markup: `_{…}` low, `^{…}` high.
    pub markup: String,
    /// How much of the vector is known when it is drawn.
    pub known: Known,
    /// What it shows, for parts of a velocity or an acceleration that have a name.
    pub part: Option<VectorPart>,
}

/// How much of a vector is known: on the board a vector known entirely is underlined twice, one known in direction
/// once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// A sign or a number, no vector.
    Sign,
    /// Words, no vector.
    Words,
    /// Neither size nor direction.
    Nothing,
    /// The direction alone.
    Direction,
    /// Size and direction.
    Entirely,
}

impl Formula {
    /// Whether there is no equation.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.terms.iter().all(|term| term.markup.is_empty())
    }

    /// The whole equation in markup.
    #[must_use]
    pub fn markup(&self) -> String {
        self.terms.iter().map(|t| t.markup.as_str()).collect()
    }

    /// The equation of the motion of a point: its vector, and that of the point from which it follows.
    pub(super) fn equal(order: Order, point: &str, start: &str) -> Formula {
        let mut formula = Formula::default();
        formula.vector(order.vector().to_owned() + &subscript(&[point]), Known::Nothing, None);
        formula.sign(" = ");
        formula.vector(order.vector().to_owned() + &subscript(&[start]), Known::Entirely, None);
        formula
    }

    /// Adds a sign and a vector.
    pub(super) fn add(&mut self, sign: char, markup: String, known: Known, part: Option<VectorPart>) {
        self.sign(&format!(" {sign} "));
        self.vector(markup, known, part);
    }

    /// Adds a sign or a number.
    pub(super) fn sign(&mut self, markup: &str) {
        self.vector(markup.to_owned(), Known::Sign, None);
    }

    /// Adds words.
    pub(super) fn words(&mut self, words: &str) {
        self.vector(words.to_owned(), Known::Words, None);
    }

    /// Adds a term.
    pub(super) fn vector(&mut self, markup: String, known: Known, part: Option<VectorPart>) {
        self.terms.push(FormulaTerm { markup, known, part });
    }
}

impl From<String> for Formula {
    /// An equation of scalars, as one term.
    fn from(markup: String) -> Self {
        Formula { terms: vec![FormulaTerm { markup, known: Known::Sign, part: None }] }
    }
}
