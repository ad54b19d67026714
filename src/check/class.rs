//! The report on a whole class for its teacher: a row for each drawing, and the commonest mistakes.

use super::checked::{Checked, Finding, Verdict};
use super::marks::{Awarded, MarkScheme};
use super::measured::AnswerKey;
use super::mistakes::Mistake;
use super::names::Names;
use crate::scene::schema;
use crate::text::{Untrusted, cell};
use crate::words::Wording;
use serde::Serialize;
use std::collections::BTreeMap;

/// The report on a class.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ClassResult {
    /// Version of the format.
    pub kinegon_class: u64,
    /// The files in the order of their names.
    pub rows: Vec<ClassRow>,
    /// Counts of the files, and the commonest first mistakes.
    pub summary: ClassSummary,
}

/// What is said of one file.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ClassRow {
    /// The file's name; of forms of several exercises its path in the folder.
    pub file: Untrusted,
    /// The exercise that it belongs to, in a report on several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exercise: Option<Untrusted>,
    /// Whose drawing it is, as the form says.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<Untrusted>,
    /// Whether the file was understood, and all that it asks for is there and right.
    pub passed: bool,
    /// What was found; not there where the file was not understood.
    #[serde(flatten)]
    pub found: Option<ClassFound>,
    /// Why the file was not understood, or what is to be known of it beside its verdict.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<Untrusted>,
}

/// What was found in a file that was understood.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ClassFound {
    /// How many values it has.
    pub values: usize,
    /// How many of them are right.
    pub right: usize,
    /// How many are within the tolerance.
    pub within: usize,
    /// How many are off.
    pub off: usize,
    /// How many are rates of the right size whose sense is not told.
    pub sense_missing: usize,
    /// How many are not wrong but tell nothing: too few digits, or too small on the sheet.
    pub cannot_tell: usize,
    /// How many are asked for and not there.
    pub missing: usize,
    /// How many stages of hints were opened in the workbench.
    pub hints: u64,
    /// The exercise of the class whose values these are, where they are those of another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub values_of: Option<Untrusted>,
    /// The first mistake that was probably made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first: Option<ClassMistake>,
    /// What was probably done there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub done: Option<String>,
    /// What was probably done, with the names of quantities as they stand on sheets.
    #[serde(skip)]
    told: String,
    /// Whether it is a drawing, whose first mistake is its first wrong operation.
    #[serde(skip)]
    is_drawing: bool,
    /// All further mistakes.
    pub further: Vec<ClassMistake>,
    /// How sure these are together, from 0 to 1; not there where nothing is to be explained.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probability: Option<f64>,
    /// Values that nothing explains.
    pub unexplained: Vec<String>,
    /// The marks that the values earn, where a marking scheme is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub marks: Option<Awarded>,
}

/// A mistake, and where it was made.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ClassMistake {
    /// The number of its step; 0 for the whole drawing.
    pub step: usize,
    /// Its name in the catalogue.
    pub mistake: &'static str,
}

#[cfg(feature = "cli")]
impl ClassMistake {
    /// A mistake at a step.
    pub(crate) fn new(step: usize, mistake: &'static str) -> ClassMistake {
        ClassMistake { step, mistake }
    }
}

/// Which columns a table has beside those that every table has.
#[derive(Clone, Copy, Debug, Default)]
pub struct ClassColumns {
    /// The exercises: in a report on several.
    pub exercise: bool,
    /// The marks: where there is a marking scheme.
    pub marks: bool,
}

/// Most characters of a name or a message in a row.
const SHOWN: usize = 300;

impl ClassRow {
    /// The row of a file that was understood; sentences in the language of the scene's figure.
    #[must_use]
    pub fn checked(
        file: Untrusted,
        name: Option<&Untrusted>,
        checked: &Checked,
        key: &AnswerKey<'_>,
        scheme: Option<&MarkScheme>,
    ) -> ClassRow {
        let words = &key.solution.wording();
        let diagnosis = &checked.diagnosis;
        let findings = &diagnosis.best.findings;
        let mistake = |finding: &Finding| ClassMistake {
            step: finding.candidate.step,
            mistake: finding.candidate.mistake().id(),
        };
        let told = findings.first().map(|finding| {
            let told = &finding.candidate.told;
            let names = Names::new(key.solution);
            let as_shown = told.sentences_with(words, &|name| names.named(name));
            let [[done, _], [told, _]] = [told.sentences(words), as_shown];
            (done, told)
        });
        let (done, told) = told.unzip();
        ClassRow {
            file,
            name: name.map(|name| name.cut(SHOWN)).filter(|name| !name.is_blank()),
            passed: checked.is_passed(),
            found: Some(ClassFound {
                values: checked.values.len(),
                right: checked.count(Verdict::Right),
                within: checked.count(Verdict::WithinTolerance),
                off: checked.count(Verdict::Off),
                sense_missing: checked.count(Verdict::SenseMissing),
                cannot_tell: checked.count(Verdict::TooCoarse) + checked.count(Verdict::TooSmall),
                missing: checked.missing.len(),
                hints: checked.hints,
                values_of: checked.values_of.as_deref().map(Untrusted::from),
                first: findings.first().map(mistake),
                told: told.unwrap_or_default(),
                is_drawing: false,
                done,
                further: findings.iter().skip(1).map(mistake).collect(),
                probability: (!findings.is_empty()).then_some(diagnosis.best.probability),
                unexplained: checked.names(&diagnosis.unexplained),
                marks: scheme.map(|scheme| scheme.award(checked)),
            }),
            ..ClassRow::default()
        }
    }

    /// Puts the wrong operations of a drawing in place of what its values let guess: each with its step, its mistake and what was done.
    #[cfg(feature = "cli")]
    pub(crate) fn judge_drawing(&mut self, wrong: Vec<(ClassMistake, String)>) {
        let Some(found) = &mut self.found else { return };
        self.passed &= wrong.is_empty();
        found.is_drawing = true;
        (found.first, found.done, found.probability) = (None, None, None);
        found.further.clear();
        for (mistake, done) in wrong {
            match found.first {
                None => {
                    found.first = Some(mistake);
                    found.told.clone_from(&done);
                    found.done = Some(done);
                }
                Some(_) => found.further.push(mistake),
            }
        }
    }

    /// The row of a file that was not understood.
    #[must_use]
    pub fn broken(file: Untrusted, message: &str) -> ClassRow {
        ClassRow { file, message: Some(Untrusted::from(message).cut(SHOWN)), ..ClassRow::default() }
    }

    /// The first line of the table: the names of its columns.
    #[must_use]
    pub fn csv_head(columns: ClassColumns) -> String {
        let cells = ClassRow::broken(Untrusted::default(), "").cells(columns);
        csv_line(cells.iter().map(|(column, _)| *column))
    }

    /// The row as a line of that table.
    #[must_use]
    pub fn csv(&self, columns: ClassColumns) -> String {
        csv_line(self.cells(columns).iter().map(|(_, cell)| cell.as_str()))
    }

    /// The cells of the row, each behind the name of its column.
    fn cells(&self, columns: ClassColumns) -> Vec<(&'static str, String)> {
        let text = |text: &Option<Untrusted>| text.as_ref().map_or_else(String::new, Untrusted::for_cell);
        let found = |of: fn(&ClassFound) -> String| self.found.as_ref().map_or_else(String::new, of);
        let first = |of: fn(&ClassMistake) -> String| {
            self.found.as_ref().and_then(|found| found.first.as_ref()).map_or_else(String::new, of)
        };
        let marks = |of: fn(&Awarded) -> f64| {
            let marks = self.found.as_ref().and_then(|found| found.marks.as_ref());
            marks.map_or_else(String::new, |marks| Awarded::written(of(marks)))
        };
        let further = |f: &ClassFound| {
            let further: Vec<String> = f.further.iter().map(|m| format!("{} (step {})", m.mistake, m.step)).collect();
            further.join("; ")
        };
        let mut cells = vec![("file", self.file.for_cell())];
        cells.extend(columns.exercise.then(|| ("exercise", text(&self.exercise))));
        cells.extend([
            ("name", text(&self.name)),
            ("passed", self.passed.to_string()),
            ("values", found(|f| f.values.to_string())),
            ("right", found(|f| f.right.to_string())),
            ("within", found(|f| f.within.to_string())),
            ("off", found(|f| f.off.to_string())),
            ("step", first(|mistake| mistake.step.to_string())),
            ("mistake", first(|mistake| mistake.mistake.to_owned())),
            ("done", found(|f| f.done.as_deref().map_or_else(String::new, cell))),
            ("further", found(further)),
            ("probability", found(|f| f.probability.map_or_else(String::new, |p| format!("{p:.2}")))),
            ("unexplained", found(|f| cell(&f.unexplained.join("; ")))),
        ]);
        if columns.marks {
            cells.extend([("marks", marks(|m| m.earned)), ("marks_of", marks(|m| m.of))]);
        }
        cells.extend([("message", text(&self.message)), ("sense_missing", found(|f| f.sense_missing.to_string()))]);
        cells.extend([
            ("cannot_tell", found(|f| f.cannot_tell.to_string())),
            ("missing", found(|f| f.missing.to_string())),
            ("values_of", found(|f| f.values_of.as_ref().map_or_else(String::new, Untrusted::for_cell))),
            ("hints", found(|f| f.hints.to_string())),
        ]);
        cells
    }
}

/// A line of a table, with what its cells need to be quoted.
fn csv_line<'c>(cells: impl Iterator<Item = &'c str>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(cells).expect("writing to memory does not fail");
    let bytes = writer.into_inner().expect("writing to memory does not fail");
    String::from_utf8(bytes).expect("cells are text")
}

/// Counts of a class's drawings, and the commonest first mistakes.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ClassSummary {
    /// All files.
    pub files: usize,
    /// Those in which all is there and right.
    pub passed: usize,
    /// Those with values that are off.
    pub off: usize,
    /// Those without a value that is off in which something is missing or tells nothing.
    pub incomplete: usize,
    /// Those that were not understood.
    pub broken: usize,
    /// First mistakes that were made more than once, the commonest first; only such as are probable enough to be told.
    pub commonest: Vec<Common>,
    /// Those with values that are off without a cause that is probable enough to be told.
    pub unknown: usize,
    /// How often each mistake came first, by its step, name and sentence; and the sentence that is told.
    #[serde(skip)]
    firsts: BTreeMap<(usize, &'static str, String), (usize, String)>,
}

/// A first mistake that was made more than once.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Common {
    /// In how many drawings.
    pub count: usize,
    /// The number of its step; 0 for the whole drawing.
    pub step: usize,
    /// Its name in the catalogue.
    pub mistake: &'static str,
    /// What was probably done.
    pub done: String,
    /// What was probably done, with the names of quantities as they stand on sheets.
    #[serde(skip)]
    told: String,
}

/// Number of the commonest mistakes that are reported.
const COMMONEST: usize = 5;

impl ClassSummary {
    /// Counts a further file.
    pub fn add(&mut self, row: &ClassRow) {
        self.files += 1;
        let Some(found) = &row.found else {
            self.broken += 1;
            return;
        };
        if row.passed {
            self.passed += 1;
            return;
        }
        if found.off == 0 && found.first.is_none() {
            self.incomplete += 1;
            return;
        }
        self.off += 1;
        match (&found.first, &found.done) {
            // A diagnosis has only mistakes that are probable enough to be told.
            (Some(first), Some(done)) if found.is_drawing || first.mistake != Mistake::Unknown.id() => {
                let key = (first.step, first.mistake, done.clone());
                let (count, told) = self.firsts.entry(key).or_default();
                *count += 1;
                told.clone_from(&found.told);
            }
            _ => self.unknown += 1,
        }
    }

    /// The summary with the commonest of the mistakes counted.
    #[must_use]
    pub fn finished(mut self) -> ClassSummary {
        let repeated = core::mem::take(&mut self.firsts).into_iter().filter(|(_, (count, _))| *count > 1);
        let common = |((step, mistake, done), (count, told))| Common { count, step, mistake, done, told };
        self.commonest = repeated.map(common).collect();
        // The sort is stable: mistakes made equally often stay in the order of the construction.
        self.commonest.sort_by_key(|c| core::cmp::Reverse(c.count));
        self.commonest.truncate(COMMONEST);
        self
    }

    /// The summary in sentences, one a line.
    #[must_use]
    pub fn lines(&self, words: &Wording) -> Vec<String> {
        let language = words.language;
        let [files, passed, off, broken] = [self.files, self.passed, self.off, self.broken].map(|n| n.to_string());
        let counts = language.class_counts(&files, &passed, &off, &broken);
        let incomplete = (self.incomplete > 0).then(|| language.class_incomplete(&self.incomplete.to_string()));
        let understood = (self.files - self.broken).to_string();
        let common = self.commonest.iter().map(|common| {
            let count = common.count.to_string();
            match common.step {
                0 => language.class_common_whole(&count, &understood, &common.told),
                step => language.class_common(&count, &understood, &step.to_string(), &common.told),
            }
        });
        let unknown = (self.unknown > 0).then(|| language.class_unknown(&self.unknown.to_string(), &understood));
        [counts].into_iter().chain(incomplete).chain(common).chain(unknown).collect()
    }
}

/// The JSON Schema of the report on a class.
#[must_use]
pub fn class_schema() -> serde_json::Value {
    schema!("class", ClassResult, "Kinegon class report, version 1")
}
