//! Runs of letters as LaTeX: prose as text, italic letters and scripts as formulas.

use crate::drawing::{Run, Script};

/// Runs as LaTeX; `None` where plain LaTeX lacks one of their letters.
pub(super) fn latex(runs: &[Run]) -> Option<String> {
    let mut writer = Writer::default();
    for run in runs {
        writer.run(run)?;
    }
    writer.leave(0);
    writer.end_formula();
    Some(writer.text)
}

/// Writes run after run.
#[derive(Default)]
struct Writer {
    text: String,
    /// The formula that is being written, without its dollar signs.
    formula: Option<String>,
    /// The open sub- and superscripts.
    scripts: Vec<Script>,
    /// For the baseline and each open script: the scripts that the last letter there already has.
    carried: Vec<Vec<Script>>,
}

impl Writer {
    fn run(&mut self, run: &Run) -> Option<()> {
        let shared = self.scripts.iter().zip(&run.scripts).take_while(|(a, b)| a == b).count();
        self.leave(shared);
        if run.spaced {
            self.space();
        }
        for script in &run.scripts[shared..] {
            self.enter(*script);
        }
        if !run.scripts.is_empty() {
            return self.in_formula(run);
        }
        if run.italic {
            if run.content.chars().all(|letter| in_formula(letter).is_some()) {
                return self.in_formula(run);
            }
            self.end_formula();
            let letters: Option<String> = run.content.chars().map(in_text).collect();
            self.text.push_str(&format!("\\textit{{{}}}", letters?));
            return Some(());
        }
        self.on_baseline(&run.content)
    }

    /// Writes upright letters on the baseline: signs and Greek letters in a formula, the rest as text.
    fn on_baseline(&mut self, content: &str) -> Option<()> {
        for letter in content.chars() {
            match (sign(letter), greek(letter)) {
                (Some(sign), _) => self.sign(sign),
                (None, Some(name)) => self.put(name),
                (None, None) => {
                    self.end_formula();
                    let written = in_text(letter)?;
                    // LaTeX would join two hyphens or quotes into another character.
                    if self.text.ends_with(['-', '\'', '`', '!', '?']) && written.starts_with(['-', '\'', '`']) {
                        self.text.push_str("{}");
                    }
                    self.text.push_str(&written);
                }
            }
        }
        Some(())
    }

    fn in_formula(&mut self, run: &Run) -> Option<()> {
        let letters: Vec<char> = run.content.chars().collect();
        // A name of more than two letters, or an upright one, is set as a word, not as a product.
        let is_word = letters.len() > 2 || !run.italic;
        for stretch in letters.chunk_by(|a, b| a.is_ascii_alphabetic() && b.is_ascii_alphabetic()) {
            let Some(first) = stretch.first() else {
                continue;
            };
            if let Some(sign) = sign(*first) {
                self.sign(sign);
                continue;
            }
            let written: Option<String> = stretch.iter().map(|letter| in_formula(*letter)).collect();
            let written = written?;
            let written = match (first.is_alphabetic() && is_word, run.italic) {
                (false, _) => written,
                (true, true) => format!("\\mathit{{{written}}}"),
                (true, false) => format!("\\mathrm{{{written}}}"),
            };
            self.put(&written);
        }
        Some(())
    }

    /// Writes a mathematical sign; on the baseline in braces, so that TeX adds no space around it.
    fn sign(&mut self, sign: &str) {
        if sign.starts_with(['\'', '^']) {
            // A prime or degree sign is a superscript, of which a letter can have only one.
            self.carry(Script::Super);
            self.push(sign);
        } else if self.scripts.is_empty() {
            self.put(&format!("{{{sign}}}"));
        } else {
            self.put(sign);
        }
    }

    fn enter(&mut self, script: Script) {
        self.carry(script);
        self.push(match script {
            Script::Sub => "_{",
            Script::Super => "^{",
        });
        self.scripts.push(script);
    }

    /// Closes scripts until `depth` of them are open.
    fn leave(&mut self, depth: usize) {
        while self.scripts.len() > depth {
            self.scripts.pop();
            self.carried.truncate(self.scripts.len() + 1);
            self.push("}");
        }
    }

    /// Notes a script of the last letter; where the letter has one of this kind already, an empty group gets the new
    /// one.
    fn carry(&mut self, script: Script) {
        let depth = self.scripts.len();
        self.carried.resize(depth + 1, Vec::new());
        if self.carried[depth].contains(&script) {
            self.push("{}");
            self.carried[depth].clear();
        }
        self.carried[depth].push(script);
    }

    /// Appends a letter to the formula, which is opened if need be.
    fn put(&mut self, written: &str) {
        self.carried.resize(self.scripts.len() + 1, Vec::new());
        self.carried[self.scripts.len()].clear();
        self.push(written);
    }

    fn push(&mut self, written: &str) {
        let formula = self.formula.get_or_insert_default();
        // A space ends a command's name before a letter.
        let ends_in_name =
            formula.rsplit_once('\\').is_some_and(|(_, name)| name.chars().all(|c| c.is_ascii_alphabetic()));
        if ends_in_name && written.starts_with(|c: char| c.is_ascii_alphabetic()) {
            formula.push(' ');
        }
        formula.push_str(written);
    }

    fn space(&mut self) {
        if self.scripts.is_empty() {
            self.end_formula();
            self.text.push(' ');
        } else {
            self.push("\\ ");
        }
    }

    fn end_formula(&mut self) {
        let Some(formula) = self.formula.take() else {
            return;
        };
        self.carried.clear();
        // A sign that is the whole formula needs no braces: TeX adds no space beside it.
        let alone = formula.strip_prefix('{').and_then(|rest| rest.strip_suffix('}'));
        let formula = alone.filter(|inner| !inner.contains(['{', '}'])).unwrap_or(&formula);
        self.text.push_str(&format!("${formula}$"));
    }
}

/// A letter in a formula; `None` for one that LaTeX's formulas lack.
fn in_formula(letter: char) -> Option<String> {
    Some(match letter {
        'a'..='z' | 'A'..='Z' | '0'..='9' => letter.to_string(),
        '(' | ')' | '[' | ']' | '/' | '.' | '!' | '?' | '=' | '+' | '-' | '*' | '|' | '<' | '>' | '@' => {
            letter.to_string()
        }
        ',' | ';' | ':' => format!("{{{letter}}}"),
        '%' | '&' | '#' | '_' | '$' | '{' | '}' => format!("\\{letter}"),
        ' ' => "\\ ".into(),
        _ => return greek(letter).or(sign(letter)).map(str::to_owned),
    })
}

/// A letter in prose; `None` for one that plain LaTeX lacks.
fn in_text(letter: char) -> Option<String> {
    Some(match letter {
        '\\' => "\\textbackslash{}".into(),
        '%' | '&' | '#' | '_' | '$' | '{' | '}' => format!("\\{letter}"),
        '~' => "\\textasciitilde{}".into(),
        '^' => "\\textasciicircum{}".into(),
        '`' => "\\`{}".into(),
        '"' => "''".into(),
        '<' | '>' | '|' => format!("${letter}$"),
        ' '..='~' => letter.to_string(),
        // UTF-8 characters that LaTeX's kernel supports in the encoding OT1; the second line lists those it lacks.
        '¡' | '¿' | '§' | '©' | '‘' | '’' | '“' | '”' | '–' | '—' | '…' => letter.to_string(),
        'Ð' | 'ð' | 'Þ' | 'þ' | 'Ą' | 'ą' | 'Đ' | 'đ' | 'Ę' | 'ę' | 'Ħ' | 'ħ' | 'Į' | 'į' | 'ĸ' | 'Ŀ' | 'ŀ' | 'ŉ'
        | 'Ŋ' | 'ŋ' | 'Ŧ' | 'ŧ' | 'Ų' | 'ų' | 'ſ' => return None,
        'À'..='ž' => letter.to_string(),
        _ => return greek(letter).map(|name| format!("${name}$")),
    })
}

/// A mathematical sign.
fn sign(letter: char) -> Option<&'static str> {
    Some(match letter {
        '′' => "'",
        '″' => "''",
        '−' => "-",
        '×' => "\\times",
        '·' => "\\cdot",
        '±' => "\\pm",
        '÷' => "\\div",
        '°' => "^{\\circ}",
        '¹' => "^{1}",
        '²' => "^{2}",
        '³' => "^{3}",
        '⊥' => "\\perp",
        '∥' => "\\parallel",
        '∠' => "\\angle",
        '≈' => "\\approx",
        '≠' => "\\neq",
        '≤' => "\\leq",
        '≥' => "\\geq",
        '→' => "\\to",
        '←' => "\\leftarrow",
        '↔' => "\\leftrightarrow",
        '√' => "\\surd",
        '∞' => "\\infty",
        '∈' => "\\in",
        '¬' => "\\neg",
        _ => return None,
    })
}

/// The commands of α to ω.
const SMALL: &str = r"\alpha \beta \gamma \delta \varepsilon \zeta \eta \theta \iota \kappa \lambda \mu \nu \xi o \pi \rho
\varsigma \sigma \tau \upsilon \varphi \chi \psi \omega";

/// The commands of Α to Ω; there is no capital of the ς at the end of words.
const CAPITAL: &str = r"A B \Gamma \Delta E Z H \Theta I K \Lambda M N \Xi O \Pi P
none \Sigma T \Upsilon \Phi X \Psi \Omega";

/// The command of a Greek letter; letters that look like Latin ones are Latin.
fn greek(letter: char) -> Option<&'static str> {
    let (first, commands) = match letter {
        'α'..='ω' => ('α', SMALL),
        'Α'..='Ω' => ('Α', CAPITAL),
        'ϵ' => return Some("\\epsilon"),
        'ϑ' => return Some("\\vartheta"),
        'µ' => return Some("\\mu"),
        'ϕ' => return Some("\\phi"),
        _ => return None,
    };
    let mut commands = commands.split_whitespace();
    commands.nth(letter as usize - first as usize).filter(|command| *command != "none")
}
