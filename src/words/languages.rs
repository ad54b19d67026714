//! The languages, each a text file.

use super::catalogue::{Declared, Language, Sentence, read};
use super::mistakes::MISTAKES;
use super::sentences::sentences;
use crate::scene::LanguageName;
use std::sync::LazyLock;

/// The text of a language's catalogue.
fn catalogue(name: LanguageName) -> &'static str {
    match name {
        LanguageName::English => include_str!("english.txt"),
        LanguageName::Spanish => include_str!("spanish.txt"),
    }
}

/// The declarations of all sentences: those of figures and reports, then those of mistakes.
fn declared() -> Vec<Declared> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::sentences::COUNT;

    /// The sentences of a catalogue, which must have no faults.
    fn faultless(name: LanguageName) -> Vec<Sentence> {
        let (sentences, faults) = read(catalogue(name), &declared());
        assert!(faults.is_empty(), "the catalogue of `{}`:\n{}", name.as_str(), faults.join("\n"));
        sentences.into_iter().flatten().collect()
    }

    #[test]
    fn every_catalogue_says_everything() {
        let english = faultless(LanguageName::English);
        for name in LanguageName::ALL {
            // Each sentence uses the same blanks as in English, where a sentence of a mistake may leave some out.
            for ((own, english), declared) in faultless(name).iter().zip(&english).zip(declared()) {
                let [own, english] = [own, english].map(Sentence::blanks);
                let different = own.symmetric_difference(&english).map(|blank| declared.blanks[*blank]);
                let different: Vec<&str> = different.collect();
                assert!(
                    different.is_empty(),
                    "`{}` in `{}` and in English: {different:?}",
                    declared.key,
                    name.as_str()
                );
            }
        }
    }

    #[test]
    fn every_blank_of_a_mistake_is_told() {
        let english = faultless(LanguageName::English);
        for (declared, sentences) in MISTAKES.chunks(2).zip(english[COUNT..].chunks(2)) {
            let told = &sentences[0].blanks() | &sentences[1].blanks();
            assert_eq!(told.len(), declared[0].blanks.len(), "`{}` does not tell all", declared[0].key);
        }
    }
}
