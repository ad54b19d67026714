//! Catalogues: the sentences of one language, read once into a list in the order of their declarations.

use std::collections::BTreeMap;

/// All sentences of a language, with a method for each, which [`sentences`](super::sentences) declares.
#[derive(Clone, Debug)]
pub struct Language {
    /// Its code in scenes and on the command line, as `en`.
    pub code: &'static str,
    /// In the order of their declarations.
    pub(super) sentences: Vec<Sentence>,
    /// Those of tables elsewhere, as they stand in the file.
    pub(super) tables: Tables,
}

/// Sentences by keys with a dot, as `turned_ray.done`: a table elsewhere, as that of mistakes, declares them.
pub type Tables = BTreeMap<&'static str, &'static str>;

/// The declaration of a sentence.
#[derive(Clone, Copy, Debug)]
pub struct Declared {
    /// Its key in the catalogues.
    pub key: &'static str,
    /// The names of its blanks, in the order of the arguments that fill them.
    pub blanks: &'static [&'static str],
    /// What it says in English.
    pub english: &'static str,
}

impl Declared {
    /// The English sentence.
    #[must_use]
    pub fn in_english(&self) -> Sentence {
        Sentence::read_whole(self.english, self).expect("a test reads every English sentence")
    }
}

/// A sentence: the words before its first blank, then the index of each blank among those declared and the words behind
/// it.
#[derive(Clone, Debug)]
pub struct Sentence {
    start: &'static str,
    rest: Vec<(usize, &'static str)>,
}

impl Sentence {
    /// Reads a sentence with these blanks in braces.
    ///
    /// # Errors
    /// In words: a lone brace, or a blank that is not declared.
    pub fn read(text: &'static str, blanks: &[&str]) -> Result<Sentence, String> {
        let mut parts = text.split('{');
        let start = parts.next().unwrap_or_default();
        if start.contains('}') {
            return Err("a } without its {".to_owned());
        }
        let rest = parts.map(|part| {
            let (name, words) = part.split_once('}').ok_or("a { without its }")?;
            if words.contains('}') {
                return Err("a } without its {".to_owned());
            }
            let blank = blanks.iter().position(|blank| *blank == name);
            Ok((blank.ok_or_else(|| format!("there is no {{{name}}} here, only {}", braced(blanks)))?, words))
        });
        Ok(Sentence { start, rest: rest.collect::<Result<_, String>>()? })
    }

    /// Reads a declared sentence, in which every blank must occur.
    ///
    /// # Errors
    /// As of [`Sentence::read`], or a missing blank.
    fn read_whole(text: &'static str, declared: &Declared) -> Result<Sentence, String> {
        let sentence = Sentence::read(text, declared.blanks)?;
        let is_missing = |blank: &usize| sentence.rest.iter().all(|(used, _)| used != blank);
        match (0..declared.blanks.len()).find(is_missing) {
            Some(blank) => Err(format!("{{{}}} is missing", declared.blanks[blank])),
            None => Ok(sentence),
        }
    }

    /// The words of a sentence without blanks.
    pub fn plain(&self) -> &'static str {
        self.start
    }

    /// The sentence with its blanks filled; `blanks` in the order of their declaration.
    pub fn filled(&self, blanks: &[&str]) -> String {
        let length = self.rest.iter().map(|(blank, words)| blanks[*blank].len() + words.len()).sum::<usize>();
        let mut text = String::with_capacity(self.start.len() + length);
        text.push_str(self.start);
        for (blank, words) in &self.rest {
            text.push_str(blanks[*blank]);
            text.push_str(words);
        }
        text
    }

    /// The indices of its blanks, each once.
    pub fn blanks(&self) -> std::collections::BTreeSet<usize> {
        self.rest.iter().map(|(blank, _)| *blank).collect()
    }
}

impl Language {
    /// A sentence of a table by its key, with the blanks filled; the key where no language has it.
    #[must_use]
    pub(crate) fn of_table(&self, key: &str, blanks: &[(&str, String)]) -> String {
        let (names, filled): (Vec<&str>, Vec<&str>) =
            blanks.iter().map(|(name, shown)| (*name, shown.as_str())).unzip();
        let sentence = self.tables.get(key).and_then(|text| Sentence::read(text, &names).ok());
        sentence.map_or_else(|| key.to_owned(), |sentence| sentence.filled(&filled))
    }
}

/// Names of blanks in braces, as a catalogue writes them; `words` for a sentence without blanks.
fn braced(names: &[&str]) -> String {
    if names.is_empty() {
        return "words".to_owned();
    }
    names.iter().map(|name| format!("{{{name}}}")).collect::<Vec<_>>().join(", ")
}

/// The sentences of a catalogue.
pub struct Read {
    /// In the order of their declarations, `None` where missing or unreadable.
    pub sentences: Vec<Option<Sentence>>,
    /// Those of tables elsewhere.
    pub tables: Tables,
}

/// Reads the text of a catalogue; and what is wrong with it, a line each.
pub fn read(text: &'static str, declared: &[Declared]) -> (Read, Vec<String>) {
    let (mut sentences, mut tables) = (vec![None; declared.len()], Tables::new());
    let mut faults = Vec::new();
    let lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    for (number, line) in lines {
        let mut fault = |says: String| faults.push(format!("line {number}: {says}"));
        let Some((key, sentence)) = line.split_once('=') else {
            fault(format!("no = in `{line}`; a line is: key = sentence"));
            continue;
        };
        let (key, sentence) = (key.trim(), sentence.trim());
        let quoted = sentence.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
        let sentence = quoted.unwrap_or(sentence);
        let again = || format!("`{key}` is here for the second time");
        if key.contains('.') {
            if tables.insert(key, sentence).is_some() {
                fault(again());
            }
            continue;
        }
        let Some(index) = declared.iter().position(|one| one.key == key) else {
            fault(format!("no sentence is called `{key}`"));
            continue;
        };
        match Sentence::read_whole(sentence, &declared[index]) {
            Ok(_) if sentences[index].is_some() => fault(again()),
            Ok(sentence) => sentences[index] = Some(sentence),
            Err(says) => fault(format!("`{key}`: {says}")),
        }
    }
    let lacking = declared.iter().zip(&sentences).filter(|(_, sentence)| sentence.is_none());
    faults.extend(lacking.map(|(declared, _)| format!("`{}` is missing or cannot be read", declared.key)));
    (Read { sentences, tables }, faults)
}
