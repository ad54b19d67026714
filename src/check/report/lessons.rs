//! What is said of a mistake for a student who wants to learn from it.

use super::ReportText;
use crate::check::checked::{Finding, Verdict};
use crate::check::lesson::{Factors, Lesson, Off, Worked};
use crate::check::mistakes::{Candidate, symbol};
use crate::construction::NumberedStep;
use crate::words::{Language, NumberStyle};

impl ReportText<'_> {
    /// The step worked out with the student's own numbers, and by how much what was drawn is off.
    pub(super) fn worked(&self, lesson: &Lesson) -> Vec<String> {
        let worked = lesson.worked.as_ref().map(|worked| self.worked_out(worked));
        let off = lesson.off.as_ref().and_then(|off| self.off_by(off));
        worked.into_iter().chain(off).collect()
    }

    fn worked_out(&self, Worked { name, sum, over, result, kind, own }: &Worked) -> String {
        let unit = kind.unit(self.key.solution.scene.units);
        let with_unit = |x: f64| format!("{} {unit}", self.number(x, 4));
        let sides = [false, true].map(|in_numbers| {
            let sum: Vec<String> = sum.iter().map(|product| self.product(product, in_numbers)).collect();
            let over = over.as_ref().map(|product| format!(" / {}", self.product(product, in_numbers)));
            sum.join(" + ") + &over.unwrap_or_default()
        });
        let name = name.as_ref().map(|name| format!("{} = ", self.symbol(name)));
        let [formula, numbers] = sides;
        let told = format!("{}{formula} = {numbers} = {}", name.unwrap_or_default(), with_unit(*result));
        match own {
            Some(own) => self.own.check_worked_beside(&told, &with_unit(*own)),
            None => self.own.check_worked(&told),
        }
    }

    /// A product in symbols or in numbers, a factor that stands there twice as a square.
    fn product(&self, Factors { constant, of }: &Factors, in_numbers: bool) -> String {
        let mut written: Vec<(String, usize)> = Vec::new();
        for (name, value) in of {
            let text = if in_numbers { self.number(*value, 4) } else { self.symbol(name) };
            match written.last_mut() {
                Some((last, count)) if *last == text => *count += 1,
                _ => written.push((text, 1)),
            }
        }
        let constant = (*constant != 1.0).then(|| self.number(*constant, 4));
        let factors = written.into_iter().map(|(text, count)| if count == 2 { format!("{text}²") } else { text });
        let all: Vec<String> = constant.into_iter().chain(factors).collect();
        all.join(if in_numbers { " · " } else { " " })
    }

    fn symbol(&self, name: &str) -> String {
        symbol(name).unwrap_or_else(|| self.names.named(name))
    }

    fn off_by(&self, off: &Off) -> Option<String> {
        let number = |x: f64, decimals: usize| self.words.write(x.abs(), NumberStyle::decimals(decimals));
        Some(match off {
            Off::Turned(degrees) => {
                let tell = if *degrees > 0.0 { Language::check_seems_left } else { Language::check_seems_right };
                tell(self.own, &number(*degrees, 0))
            }
            Off::Longer(mm) if *mm > 0.0 => self.own.check_seems_longer(&number(*mm, 1)),
            Off::Longer(mm) => self.own.check_seems_shorter(&number(*mm, 1)),
            Off::Elsewhere(mm, lines) => match lines.as_slice() {
                [(a, by), (b, other)] => {
                    self.own.check_seems_elsewhere(&number(*mm, 1), a, &number(*by, 0), b, &number(*other, 0))
                }
                _ => return None,
            },
        })
    }

    /// The stages of a hint, from the plan to the step.
    pub(super) fn hints(&self, finding: &Finding, step: Option<&NumberedStep<'_>>) -> Vec<String> {
        let plan = match step {
            Some(step) => self.own.check_hint_plan(self.own.named_sheet(step.sheet)),
            None => self.own.check_hint_whole().to_owned(),
        };
        let values = &self.checked.values;
        let first = finding.changed().into_iter().find(|&value| values[value].verdict == Verdict::Off);
        let first = first.map(|value| self.own.check_hint_value(&self.names.shown(&values[value].entry.asked)));
        let step =
            step.map(|step| format!("{}: {}", self.own.check_step(&step.number.to_string()), self.caption(step)));
        [plan].into_iter().chain(first).chain(step).collect()
    }

    /// Which steps are to be done again.
    pub(super) fn redo(&self, lesson: &Lesson, candidate: &Candidate) -> Option<String> {
        match lesson.redo.as_deref()? {
            _ if candidate.step == 0 => None,
            [] => Some(self.own.check_redo_number().to_owned()),
            [step] => Some(self.own.check_redo_one(&step.to_string())),
            steps => Some(self.own.check_redo(&ranges(steps))),
        }
    }
}

/// Rising numbers as ranges: `13–15, 18`.
fn ranges(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|a, b| a + 1 == *b);
    let run = |run: &[usize]| match run {
        [first, .., last] => format!("{first}–{last}"),
        _ => run[0].to_string(),
    };
    runs.map(run).collect::<Vec<String>>().join(", ")
}
