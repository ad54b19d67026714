//! Slips in equations and formulas: another length or segment than should stand there.

use super::entry::Solve;
use super::formula::Formula;
use super::slips::{Slip, between_others, lengths, segments};
use crate::check::Told;
use crate::sheet::Sheet;

impl Slip<'_, '_> {
    /// Equations in which another length or segment stands than should.
    pub(super) fn solved(&self, solve: &Solve, right: &[(String, f64)]) -> Option<Told> {
        let unknown = |name: &str| right.iter().find(|(own, _)| own == name).map(|(_, number)| *number);
        solve.equations.iter().find_map(|text| {
            let [left, other] = Formula::sides(text).ok()?;
            let remains = |exchanged: &str, by: f64| -> Option<f64> {
                let mut number = |own: &str| match unknown(own) {
                    _ if own == exchanged => Ok(by),
                    Some(number) => Ok(number),
                    None => self.table.number(own),
                };
                let [a, b] = [left.value(&mut number).ok()?, other.value(&mut number).ok()?];
                Some((a - b).abs() / a.abs().max(b.abs()).max(f64::MIN_POSITIVE))
            };
            if remains("", 0.0)? <= self.tolerance {
                return None;
            }
            self.exchanged(&[&left, &other], &|own, by| remains(own, by).is_some_and(|rest| rest <= self.tolerance))
        })
    }

    /// A length or a segment that stands for another, which would be right: one between points that are drawn before others.
    pub(super) fn exchanged(&self, formulas: &[&Formula], is_right: &dyn Fn(&str, f64) -> bool) -> Option<Told> {
        let is_drawn = |name: &str| {
            super::names::segment_of(name)
                .is_some_and(|(sheet, ends)| ends.iter().all(|end| self.table.place(sheet, end).is_some()))
        };
        let drawn = self.exchanged_for(formulas, is_right, &is_drawn);
        drawn.or_else(|| self.exchanged_for(formulas, is_right, &|_| true))
    }

    fn exchanged_for(
        &self,
        formulas: &[&Formula],
        is_right: &dyn Fn(&str, f64) -> bool,
        is_meant: &dyn Fn(&str) -> bool,
    ) -> Option<Told> {
        formulas.iter().flat_map(|formula| formula.names()).find_map(|own| {
            let (sheet, ends) = super::names::segment_of(own).or_else(|| self.measured.get(own).cloned())?;
            let all = match sheet.order() {
                None if sheet == Sheet::Centers => super::centers::distances(self.table),
                None => lengths(self.table),
                Some(order) => segments(self.table, order),
            };
            let (other, _) = all.into_iter().find(|(other, length)| is_meant(other) && is_right(own, *length))?;
            let [from, to] = &ends;
            Some(between_others(self.table.given, sheet, &other, [from, to]))
        })
    }
}
