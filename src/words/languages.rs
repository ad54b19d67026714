//! The languages, each a text file.

use super::catalogue::{Declared, Language, Sentence, read};
use super::mistakes::MISTAKES;
use super::sentences::sentences;
use crate::scene::LanguageName;
use std::sync::LazyLock;

/// The text of a language's catalogue.
pub fn catalogue(name: LanguageName) -> &'static str {
    match name {
        LanguageName::English => include_str!("english.txt"),
        LanguageName::Spanish => include_str!("spanish.txt"),
    }
}

/// The declarations of all sentences: those of figures and reports, then those of mistakes.
pub fn declared() -> Vec<Declared> {
    sentences().chain(MISTAKES).copied().collect()
}

/// The languages in the order of [`LanguageName::ALL`]. A sentence that a catalogue lacks is taken from the English
/// one; one that English lacks is its key.
static LANGUAGES: LazyLock<[Language; LanguageName::ALL.len()]> = LazyLock::new(|| {
    let declared = declared();
    let sentences = |name: LanguageName, instead: &[Sentence]| -> Vec<Sentence> {
        let (found, _) = read(catalogue(name), &declared);
        found.into_iter().zip(instead).map(|(found, instead)| found.unwrap_or_else(|| instead.clone())).collect()
    };
    let keys: Vec<Sentence> = declared.iter().map(|one| Sentence::of_words(one.key)).collect();
    let english = sentences(LanguageName::English, &keys);
    LanguageName::ALL.map(|name| Language { code: name.as_str(), sentences: sentences(name, &english) })
});

impl Language {
    /// The language of that name.
    #[must_use]
    pub fn of(name: LanguageName) -> &'static Language {
        &LANGUAGES[name as usize]
    }
}
