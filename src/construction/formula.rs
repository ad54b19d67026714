/// The equation of a step as it stands on the board, term by term.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Formula {
    /// Its vectors, and what stands between them, in reading order.
    pub terms: Vec<FormulaTerm>,
}

/// A vector of a formula, or what stands between two of them.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaTerm {
    /// As it is written: `_{…}` low, `^{…}` high.
    pub markup: String,
    /// How much of it is known when it is drawn.
    pub known: Known,
    /// Which part of an acceleration or a velocity it is, where that has a name.
    pub part: Option<NamedPart>,
}

/// How much of a vector is known: on the board two lines under what is known entirely, one under what is known in direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// It is no vector but a sign or a number.
    Sign,
    /// It is words.
    Words,
    /// Neither size nor direction.
    Nothing,
    /// The direction alone.
    Direction,
    /// Size and direction.
    Entirely,
}

/// A part that has a name of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NamedPart {
    /// Towards the centre of the turning.
    Normal,
    /// Square to it.
    Tangential,
    /// Along a guide.
    Sliding,
    /// Of what slides along a turning guide.
    Coriolis,
}

impl Formula {
    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.terms.iter().all(|term| term.markup.is_empty())
    }

    /// The whole of it, as it is written.
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

    /// Adds a vector, or what stands between two.
    pub(super) fn vector(&mut self, markup: String, known: Known, part: Option<NamedPart>) {
        self.terms.push(FormulaTerm { markup, known, part });
    }
}

impl From<String> for Formula {
    /// An equation of numbers, in one piece.
    fn from(markup: String) -> Self {
        let mut formula = Self::default();
        if !markup.is_empty() {
            formula.sign(&markup);
        }
        formula
    }
}
