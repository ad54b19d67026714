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
    /// Its kind, for parts of a velocity or an acceleration that have a name.
    pub part: Option<NamedPart>,
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

/// A part of a velocity or acceleration that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NamedPart {
    /// Normal (centripetal) acceleration.
    Normal,
    /// Tangential acceleration.
    Tangential,
    /// Relative velocity or acceleration along a guide.
    Sliding,
    /// Coriolis acceleration.
    Coriolis,
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

    /// Adds a sign or a number.
    pub(super) fn sign(&mut self, markup: &str) {
        self.vector(markup.to_owned(), Known::Sign, None);
    }

    /// Adds words.
    pub(super) fn words(&mut self, words: &str) {
        self.vector(words.to_owned(), Known::Words, None);
    }

    /// Adds a term.
    pub(super) fn vector(&mut self, markup: String, known: Known, part: Option<NamedPart>) {
        self.terms.push(FormulaTerm { markup, known, part });
    }
}

impl From<String> for Formula {
    /// An equation of scalars, as one term.
    fn from(markup: String) -> Self {
        let mut formula = Self::default();
        if !markup.is_empty() {
            formula.sign(&markup);
        }
        formula
    }
}
