//! The languages, each a text file.

use super::catalogue::{Declared, Language, Read, Sentence, read};
use super::sentences::sentences;
use crate::scene::LanguageName;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The text of a language's catalogue.
pub fn catalogue(name: LanguageName) -> &'static str {
    match name {
        LanguageName::English => include_str!("english.txt"),
        LanguageName::Spanish => include_str!("spanish.txt"),
    }
}

/// The declarations of all sentences.
pub fn declared() -> Vec<Declared> {
    sentences().copied().collect()
}

/// The languages in the order of [`LanguageName::ALL`]. A sentence that a catalogue lacks is taken from the English
/// one; one that English lacks is its key.
static LANGUAGES: LazyLock<[Language; LanguageName::ALL.len()]> = LazyLock::new(|| {
    let declared = declared();
    let language = |name: LanguageName, instead: &Language| {
        let (Read { sentences, tables }, _) = read(catalogue(name), &declared);
        let sentences = sentences.into_iter().zip(&instead.sentences);
        Language {
            code: name.as_str(),
            sentences: sentences.map(|(found, instead)| found.unwrap_or_else(|| instead.clone())).collect(),
            tables: instead.tables.iter().map(|(key, text)| (*key, *text)).chain(tables).collect(),
        }
    };
    let keys = declared.iter().map(|one| Sentence::of_words(one.key)).collect();
    let keys = Language { code: "", sentences: keys, tables: BTreeMap::new() };
    let english = language(LanguageName::English, &keys);
    LanguageName::ALL.map(|name| language(name, &english))
});

impl Language {
    /// The language of that name.
    #[must_use]
    pub fn of(name: LanguageName) -> &'static Language {
        &LANGUAGES[name as usize]
    }
}
