//! The report as text, in the figure's language.

use super::mistakes::Mistake;
use super::search::{Explanation, Finding};
use super::verdict::{Checked, Drawn, Judged, Verdict};
use crate::plan::shown_text;
use crate::words::{CheckWords, Wording};

use super::order::numbered_steps;

/// What is said to the student: verdicts in the order of the construction, then what probably happened.
#[must_use]
pub fn report(checked: &Checked, drawn: &Drawn<'_>, words: &Wording) -> String {
    let page = Page {
        checked,
        drawn,
        words,
        own: words.language.check,
    };
    let mut lines = Vec::new();
    let count = |verdict| {
        checked
            .values
            .iter()
            .filter(|v| v.verdict == verdict)
            .count()
    };
    lines.push((page.own.counts)(
        count(Verdict::Right),
        count(Verdict::WithinTolerance),
        count(Verdict::Off),
    ));
    let tolerance = &drawn.tolerance;
    let [mm, degrees] = [tolerance.mm, tolerance.degrees].map(|x| words.number(x.to_string()));
    lines.push((page.own.tolerance)(&mm, &degrees));
    lines.push(String::new());
    lines.extend(page.table());
    lines.push(String::new());
    lines.extend(page.diagnosis());
    lines.join("\n") + "\n"
}

struct Page<'a> {
    checked: &'a Checked,
    drawn: &'a Drawn<'a>,
    words: &'a Wording,
    own: &'static CheckWords,
}

impl Page<'_> {
    fn table(&self) -> Vec<String> {
        let mut rows: Vec<[String; 8]> = vec![self.own.columns.map(str::to_owned)];
        rows.extend(self.checked.values.iter().map(|value| self.row(value)));
        let width = |column: usize| rows.iter().map(|r| r[column].chars().count()).max();
        let widths: Vec<usize> = (0..8).map(|c| width(c).unwrap_or(0)).collect();
        let lines = rows.iter().map(|row| {
            let mut line = String::new();
            for (column, cell) in row.iter().enumerate() {
                let blanks = " ".repeat(widths[column] - cell.chars().count());
                match column {
                    0 | 7 => line.push_str(&format!("{cell}{blanks}  ")),
                    _ => line.push_str(&format!("{blanks}{cell}  ")),
                }
            }
            line.trim_end().to_owned()
        });
        lines.collect()
    }

    fn number(&self, value: f64, digits: i32) -> String {
        self.words.number(significant(value, digits))
    }

    fn row(&self, value: &Judged) -> [String; 8] {
        let entry = &value.entry;
        let unit = entry.asked.kind().unit(self.drawn.units);
        let expected = if entry.is_magnitude {
            entry.expected.abs()
        } else {
            entry.expected
        };
        let on_paper = entry.per_mm.map(|mu| {
            let mm = self.words.number(format!("{:+.2}", value.difference / mu));
            format!("{mm} mm")
        });
        let percent = (entry.expected != 0.0).then(|| {
            let percent = 100.0 * value.difference / entry.expected.abs();
            let digits = if percent.abs() < 10.0 { 2 } else { 0 };
            let percent = self.words.number(format!("{percent:+.digits$}"));
            format!("{percent} %")
        });
        let tolerance = value.tolerance.map(|t| format!("±{}", self.number(t, 2)));
        let verdict = match value.verdict {
            Verdict::Right => self.own.right,
            Verdict::WithinTolerance => self.own.within,
            Verdict::Off => self.own.off,
            Verdict::Unjudged => self.own.unjudged,
        };
        [
            entry.asked.name().to_owned(),
            self.number(entry.value, 7),
            format!("{} {unit}", self.number(expected, 7)),
            self.number(value.difference, 3),
            on_paper.unwrap_or_default(),
            percent.unwrap_or_default(),
            tolerance.unwrap_or_default(),
            verdict.to_owned(),
        ]
    }

    fn diagnosis(&self) -> Vec<String> {
        let diagnosis = &self.checked.diagnosis;
        let mut lines = Vec::new();
        match diagnosis.best.findings.len() {
            0 if self.checked.is_passed() && diagnosis.unexplained.is_empty() => {
                lines.push(self.own.nothing.to_owned());
                return lines;
            }
            0 => lines.push(self.own.none.to_owned()),
            1 => lines.push(self.own.probably.to_owned()),
            _ => lines.push(self.own.no_single.to_owned()),
        }
        for (finding, number) in diagnosis.best.findings.iter().zip(1..) {
            lines.extend(self.finding(finding, number));
        }
        if !diagnosis.best.findings.is_empty() {
            lines.push(self.sure(&diagnosis.best));
        }
        if !diagnosis.unexplained.is_empty() {
            let names = self.names(&diagnosis.unexplained);
            lines.push((self.own.unexplained)(&names));
        }
        if !diagnosis.others.is_empty() {
            lines.push(String::new());
            lines.push(self.own.others.to_owned());
            for other in &diagnosis.others {
                let best = &diagnosis.best.findings;
                let new = other.findings.iter().filter(|f| {
                    let same = |g: &&Finding| {
                        g.candidate.mistake == f.candidate.mistake
                            && g.candidate.blanks == f.candidate.blanks
                    };
                    !best.iter().any(|g| same(&g))
                });
                let told: Vec<String> = new
                    .map(|f| {
                        let done = (f.candidate.mistake.words(self.own).done)(&f.candidate.blanks);
                        format!("{}: {done}", self.step(f))
                    })
                    .collect();
                let end = if other.is_alike {
                    self.own.alike.to_owned()
                } else {
                    self.sure(other)
                };
                lines.push(format!("  - {} ({end})", told.join("; ")));
            }
        }
        lines
    }

    fn sure(&self, explanation: &Explanation) -> String {
        let percent = (100.0 * explanation.probability).clamp(1.0, 99.0);
        (self.own.sure)(&format!("{percent:.0}"))
    }

    fn step(&self, finding: &Finding) -> String {
        match finding.candidate.step {
            0 => self.own.whole.to_owned(),
            number => (self.own.step)(number),
        }
    }

    fn finding(&self, finding: &Finding, number: usize) -> Vec<String> {
        let Finding {
            candidate, follows, ..
        } = finding;
        let sentences = candidate.mistake.words(self.own);
        let mut lines = vec![format!(
            "{number}. {}: {}.",
            self.step(finding),
            (sentences.done)(&candidate.blanks)
        )];
        let steps = numbered_steps(self.drawn.construction);
        if let Some(step) = steps.iter().find(|s| s.number == candidate.step) {
            let caption = shown_text(&step.step.caption, step.plan, self.words);
            lines.push(format!("   ({caption})"));
        }
        let should = (sentences.should)(&candidate.blanks);
        lines.push(format!("   {}: {should}.", self.own.instead));
        if candidate.mistake == Mistake::Truncated {
            return lines;
        }
        lines.push(format!(
            "   {}",
            if follows.is_empty() {
                self.own.follows_none.to_owned()
            } else {
                (self.own.follows)(&self.names(follows))
            }
        ));
        lines
    }

    fn names(&self, values: &[usize]) -> String {
        let names = values
            .iter()
            .map(|&i| self.checked.values[i].entry.asked.name());
        names.collect::<Vec<&str>>().join(", ")
    }
}

/// A number with so many significant digits, without trailing zeros behind the point.
pub(crate) fn significant(x: f64, count: i32) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let exponent = libm::floor(libm::log10(x.abs())) as i32;
    if !(-5..12).contains(&exponent) {
        return format!("{x:.*e}", count as usize - 1);
    }
    let after = (count - 1 - exponent).max(0) as usize;
    let written = format!("{x:.after$}");
    if written.contains('.') {
        written
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned()
    } else {
        written
    }
}
