//! Catalogues: the sentences of one language in a text file, read once into a list in the order of the declarations.

/// All sentences of a language, with a method for each; `sentences/` declares them.
#[derive(Clone, Debug)]
pub struct Language {
    /// Its code in scenes and on the command line, as `en`.
    pub code: &'static str,
    /// In the order of their declarations, those of mistakes last.
    pub(super) sentences: Vec<Sentence>,
}

/// The declaration of a sentence.
#[derive(Clone, Copy, Debug)]
pub struct Declared {
    /// Its key in the catalogues.
    pub key: &'static str,
    /// The names of its blanks, in the order of the arguments that fill them.
    pub blanks: &'static [&'static str],
    /// Whether every blank must occur in the sentence.
    pub needs_all: bool,
}

/// A sentence: the words before its first blank, then the index of each blank in [`Declared::blanks`] and the words
/// behind it.
#[derive(Clone, Debug)]
pub struct Sentence {
    start: &'static str,
    rest: Vec<(usize, &'static str)>,
}

impl Sentence {
    /// A sentence without blanks.
    pub fn of_words(words: &'static str) -> Sentence {
        Sentence { start: words, rest: Vec::new() }
    }

    /// Reads a sentence with its blanks in braces.
    ///
    /// # Errors
    /// In words: a lone brace, a blank that is not declared, or a missing one.
    fn read(text: &'static str, declared: &Declared) -> Result<Sentence, String> {
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
            let blank = declared.blanks.iter().position(|blank| *blank == name);
            Ok((blank.ok_or_else(|| format!("there is no {{{name}}} here, only {}", braced(declared.blanks)))?, words))
        });
        let rest: Vec<(usize, &str)> = rest.collect::<Result<_, String>>()?;
        let is_missing = |blank: usize| declared.needs_all && rest.iter().all(|(used, _)| *used != blank);
        match (0..declared.blanks.len()).find(|blank| is_missing(*blank)) {
            Some(blank) => Err(format!("{{{}}} is missing", declared.blanks[blank])),
            None => Ok(Sentence { start, rest }),
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

/// Names of blanks in braces, as a catalogue writes them; `words` for a sentence without blanks.
fn braced(names: &[&str]) -> String {
    if names.is_empty() {
        return "words".to_owned();
    }
    names.iter().map(|name| format!("{{{name}}}")).collect::<Vec<_>>().join(", ")
}

/// The sentences of a catalogue in the order of their declarations, `None` where missing or unreadable; and its faults,
/// a line each.
pub fn read(text: &'static str, declared: &[Declared]) -> (Vec<Option<Sentence>>, Vec<String>) {
    let mut sentences = vec![None; declared.len()];
    let mut faults = Vec::new();
    let lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    for (number, line) in lines {
        let mut fault = |says: String| faults.push(format!("line {number}: {says}"));
        let Some((key, sentence)) = line.split_once('=') else {
            fault(format!("no = in `{line}`; a line is: key = sentence"));
            continue;
        };
        let key = key.trim();
        let Some(index) = declared.iter().position(|one| one.key == key) else {
            fault(format!("no sentence is called `{key}`"));
            continue;
        };
        let sentence = sentence.trim();
        let quoted = sentence.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
        match Sentence::read(quoted.unwrap_or(sentence), &declared[index]) {
            Ok(_) if sentences[index].is_some() => fault(format!("`{key}` is here for the second time")),
            Ok(sentence) => sentences[index] = Some(sentence),
            Err(says) => fault(format!("`{key}`: {says}")),
        }
    }
    let lacking = declared.iter().zip(&sentences).filter(|(_, sentence)| sentence.is_none());
    faults.extend(lacking.map(|(declared, _)| format!("`{}` is missing or cannot be read", declared.key)));
    (sentences, faults)
}
