//! Catalogues: the sentences of one language, read once into a list in the order of their declarations.

use crate::message::{Message, filled};
use std::collections::{BTreeMap, BTreeSet};

pub use crate::message::Declared;

/// All sentences of a language, with a method for each, which [`sentences`](super::sentences) declares.
#[derive(Clone, Debug)]
pub struct Language {
    /// Its code in scenes and on the command line, as `en`.
    pub code: &'static str,
    /// In the order of their declarations.
    pub(super) sentences: Vec<&'static str>,
    /// Those of tables elsewhere, as they stand in the file.
    pub(super) tables: Tables,
}

/// Sentences by keys with a dot, as `turned_ray.done`: a table elsewhere, as that of mistakes, declares them.
pub type Tables = BTreeMap<&'static str, &'static str>;

/// The names of a sentence's blanks, which are among `known`.
///
/// # Errors
/// In words: a lone brace, or a blank that is not known.
pub fn blanks_of<'s>(sentence: &'s str, known: &[&str]) -> Result<BTreeSet<&'s str>, String> {
    let mut parts = sentence.split('{');
    let mut blanks = BTreeSet::new();
    let mut words = parts.next().unwrap_or_default();
    for part in parts {
        let (name, rest) = part.split_once('}').ok_or("a { without its }")?;
        if !known.contains(&name) {
            let braced: Vec<String> = known.iter().map(|name| format!("{{{name}}}")).collect();
            let only = if braced.is_empty() { "words".to_owned() } else { braced.join(", ") };
            return Err(format!("there is no {{{name}}} here, only {only}"));
        }
        blanks.insert(name);
        words = if words.contains('}') { words } else { rest };
    }
    if words.contains('}') { Err("a } without its {".to_owned()) } else { Ok(blanks) }
}

impl Language {
    /// What an error or a warning says in this language; in English what this language lacks.
    #[must_use]
    pub fn says(&self, message: &Message) -> String {
        message.told(&|declared| self.tables.get(declared.key).copied().unwrap_or(declared.english))
    }

    /// A sentence of a table by its key, with the blanks filled; the key where no language has it.
    #[must_use]
    pub(crate) fn of_table(&self, key: &str, blanks: &[(&str, String)]) -> String {
        let (names, by): (Vec<&str>, Vec<&str>) = blanks.iter().map(|(name, shown)| (*name, shown.as_str())).unzip();
        self.tables.get(key).map_or_else(|| key.to_owned(), |sentence| filled(sentence, &names, &by))
    }
}

/// The sentences of a catalogue.
pub struct Read {
    /// In the order of their declarations, `None` where missing or unreadable.
    pub sentences: Vec<Option<&'static str>>,
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
        let blanks = declared[index].blanks;
        match blanks_of(sentence, blanks) {
            Err(says) => fault(format!("`{key}`: {says}")),
            Ok(used) => match blanks.iter().find(|blank| !used.contains(*blank)) {
                Some(blank) => fault(format!("`{key}`: {{{blank}}} is missing")),
                None if sentences[index].is_some() => fault(again()),
                None => sentences[index] = Some(sentence),
            },
        }
    }
    let lacking = declared.iter().zip(&sentences).filter(|(_, sentence)| sentence.is_none());
    faults.extend(lacking.map(|(declared, _)| format!("`{}` is missing or cannot be read", declared.key)));
    (Read { sentences, tables }, faults)
}
