//! What the verdict of a report rests on: how many values are right, what is missing or tells nothing, by which scales, how plans lie,
//! how accurate the drawing is.

use super::ReportText;
use crate::check::checked::{Basis, Checked, Verdict};
use crate::check::common::CommonError;
use crate::check::placed::{COUNTED, TurnedPlan};
use crate::check::sensible::StatedScale;
use crate::check::verdicts::{COARSE, COARSE_DEGREES};
use crate::words::{Language, NumberStyle};

impl ReportText<'_> {
    /// The sentence that counts the values that are right, within the tolerance, and off.
    pub(super) fn counts(&self) -> String {
        let count = |verdict| self.checked.count(verdict).to_string();
        let [right, within, off] = [Verdict::Right, Verdict::WithinTolerance, Verdict::Off].map(count);
        match self.checked.count(Verdict::SenseMissing) {
            0 => self.own.check_counts(&right, &within, &off),
            missing => self.own.check_counts_and_senses(&right, &within, &missing.to_string(), &off),
        }
    }

    /// What is asked for and not there.
    pub(super) fn missing(&self) -> Option<String> {
        let Checked { values, missing, .. } = self.checked;
        let names: Vec<String> = missing.iter().map(|row| self.names.named(row)).collect();
        let [count, asked] = [missing.len(), values.len() + missing.len()].map(|count| count.to_string());
        (!missing.is_empty()).then(|| match names.len().checked_sub(NAMED) {
            Some(more @ 1..) => {
                self.own.check_missing_many(&count, &asked, &names[..NAMED].join(", "), &more.to_string())
            }
            _ => self.own.check_missing(&count, &asked, &names.join(", ")),
        })
    }

    /// Values on which the verdict does not rest, and by which scales it judges.
    pub(super) fn rests_on(&self) -> Vec<String> {
        let Checked { values, scales, .. } = self.checked;
        let with = |verdict| (0..values.len()).filter(|&i| values[i].verdict == verdict).collect::<Vec<usize>>();
        let [coarse, small] = [Verdict::TooCoarse, Verdict::TooSmall].map(with);
        let by_coarse: Vec<usize> = (0..values.len()).filter(|&i| values[i].basis == Basis::Coarse).collect();
        let number = |x: f64| self.words.write(x, NumberStyle::shortest());
        let by_coarse = (!by_coarse.is_empty())
            .then(|| self.own.check_coarse(&self.names(&by_coarse), &number(100.0 * COARSE), &number(COARSE_DEGREES)));
        let (coarse, rough): (Vec<usize>, Vec<usize>) = coarse.into_iter().partition(|&i| values[i].entry.doubt == 0.0);
        let coarse = (!coarse.is_empty()).then(|| self.own.check_coarse_digits(&self.names(&coarse)));
        let rough = (!rough.is_empty()).then(|| self.own.check_rough_places(&self.names(&rough), &number(COUNTED)));
        let small = (!small.is_empty()).then(|| self.own.check_too_small(&self.names(&small)));
        let scales = scales.iter().map(|scale| self.scale(scale));
        let common = self.checked.common.map(|common| self.common(common));
        let values_of = self.checked.values_of.as_ref().map(|exercise| self.own.check_values_of(exercise));
        let turned = self.checked.turned.iter().map(|plan| self.turned(plan));
        values_of
            .into_iter()
            .chain(common)
            .chain(by_coarse)
            .chain(coarse)
            .chain(rough)
            .chain(small)
            .chain(scales)
            .chain(turned)
            .collect()
    }

    /// The error that all measured lengths have in common.
    fn common(&self, common: CommonError) -> String {
        let number = |x: f64| self.words.write(x.abs(), NumberStyle::decimals(1));
        match common {
            CommonError::Scale(scale) if scale > 0.0 => self.own.check_all_larger(&number(100.0 * scale)),
            CommonError::Scale(scale) => self.own.check_all_smaller(&number(100.0 * scale)),
            CommonError::Zero(mm) if mm > 0.0 => self.own.check_all_longer(&number(mm)),
            CommonError::Zero(mm) => self.own.check_all_shorter(&number(mm)),
        }
    }

    /// That a plan lies turned to the scheme.
    fn turned(&self, plan: &TurnedPlan) -> String {
        let degrees = self.words.write(plan.degrees.abs(), NumberStyle::decimals(0));
        let own = self.own;
        let tell = if plan.degrees > 0.0 { Language::check_turned_left } else { Language::check_turned_right };
        tell(own, own.named_sheet(plan.sheet), &degrees)
    }

    /// What is to be said of a scale of the form.
    fn scale(&self, StatedScale { sheet, stated, asked, used }: &StatedScale) -> String {
        let number = |x: f64| self.words.write(x, NumberStyle::shortest());
        let (name, sheet) = (sheet.facts().scale_key, self.own.named_sheet(*sheet));
        match asked {
            Some(asked) if used == stated => self.own.check_other_scale(name, &number(*stated), &number(*asked)),
            _ => self.own.check_no_such_scale(name, &number(*stated), sheet, &self.number(*used, 3)),
        }
    }

    /// How much is allowed, and how accurate the drawing is.
    pub(super) fn accuracy(&self) -> Vec<String> {
        let number = |x: f64| self.words.write(x, NumberStyle::shortest());
        let asked = &self.key.tolerance;
        let [mm, degrees] = [asked.mm, asked.degrees].map(number);
        let mut lines = vec![self.own.check_tolerance(&mm, &degrees)];
        // A drawing program is more exact than a tenth of a millimetre.
        let Some(found) = self.checked.accuracy.filter(|found| found.mm >= SEEN) else {
            return lines;
        };
        let tenth = |x: f64| self.words.write(x.max(0.1), NumberStyle::decimals(1));
        let mut own = self.own.check_accuracy(&tenth(found.mm), &tenth(found.degrees));
        if found.percent > 0.0 {
            own = format!("{own} {}", self.own.check_slips(&number(found.percent)));
        }
        let size = found.mm / asked.mm;
        if size > 1.0 && self.key.leniency > 1.0 {
            own = format!("{own} {}", self.own.check_wider(&mm, &degrees));
        }
        let most = self.key.leniency.max(1.0);
        if size > 1.001 * most {
            let [mm, degrees] = [most * asked.mm, most * asked.degrees].map(tenth);
            own = format!("{own} {}", self.own.check_too_coarse(&mm, &degrees));
        }
        lines.push(own);
        lines
    }

    /// The sentence where nothing is off.
    pub(super) fn nothing_off(&self) -> String {
        let [right, within, senses] = [Verdict::Right, Verdict::WithinTolerance, Verdict::SenseMissing]
            .map(|verdict| self.checked.count(verdict));
        let (good, asked) = (right + within, self.checked.values.len() + self.checked.missing.len());
        match () {
            () if good + senses == 0 => self.own.check_tells_nothing().to_owned(),
            () if self.checked.is_passed() => self.own.check_nothing().to_owned(),
            () => self.own.check_so_far(&good.to_string(), &asked.to_string()),
        }
    }
}

/// Most of the values that are missing which a report names.
const NAMED: usize = 24;

/// Accuracy of a drawing from which on it is said, in mm.
const SEEN: f64 = 0.05;
