//! Equations for numbers: solved, or held to given ones.

use super::entry::Solve;
use super::formula::Formula;
use super::says;
use super::table::{Made, Table};
use crate::message::Message;
use nalgebra::{DMatrix, DVector};

impl Table<'_> {
    /// What remains of each equation of [`Solve`] with these numbers for its unknowns, over the sum of its terms' sizes.
    pub(super) fn residuals(&self, entry: &Solve, unknowns: &[f64]) -> Result<Vec<f64>, Message> {
        let names = self.unknowns(entry);
        let remains = |text: &String| {
            let [left, right] = &Formula::sides(text)?;
            let [a, b] = [self.with(left, &names, unknowns)?, self.with(right, &names, unknowns)?];
            // The size of the terms: that of either side, and how far it moves with each unknown.
            let mut size = a.abs().max(b.abs());
            for at in 0..unknowns.len() {
                let mut without = unknowns.to_vec();
                without[at] = 0.0;
                let [c, d] = [self.with(left, &names, &without)?, self.with(right, &names, &without)?];
                size = size.max((a - c).abs()).max((b - d).abs());
            }
            Ok(if size == 0.0 { 0.0 } else { (a - b) / size })
        };
        entry.equations.iter().map(remains).collect()
    }

    fn unknowns(&self, Solve { solve, .. }: &Solve) -> Vec<String> {
        solve.iter().map(|name| name.chars().filter(|c| !c.is_whitespace()).collect()).collect()
    }

    /// A formula's value with numbers in place of some names.
    fn with(&self, formula: &Formula, names: &[String], numbers: &[f64]) -> Result<f64, Message> {
        formula.value(&mut |name| match names.iter().position(|own| own == name) {
            Some(at) => Ok(numbers[at]),
            None => self.number(name),
        })
    }

    pub(super) fn solve(&self, entry: &Solve) -> Result<Made, Message> {
        let names = self.unknowns(entry);
        let new: Vec<String> = names.iter().map(|name| self.new_number(name)).collect::<Result<_, _>>()?;
        let count = names.len();
        let mut matrix = DMatrix::<f64>::zeros(count, count);
        let mut sides = DVector::<f64>::zeros(count);
        for (row, text) in entry.equations.iter().enumerate() {
            let [left, right] = &Formula::sides(text)?;
            let remains = |numbers: &[f64]| -> Result<f64, Message> {
                Ok(self.with(left, &names, numbers)? - self.with(right, &names, numbers)?)
            };
            let zero = vec![0.0; count];
            let at_zero = remains(&zero)?;
            let (mut sum, mut all) = (at_zero, at_zero.abs());
            for column in 0..count {
                let mut one = zero.clone();
                one[column] = 1.0;
                matrix[(row, column)] = remains(&one)? - at_zero;
                sum += 2.0 * matrix[(row, column)];
                all += matrix[(row, column)].abs();
            }
            let two = remains(&vec![2.0; count])?;
            if (two - sum).abs() > 1e-9 * all {
                return Err(says::not_linear(text));
            }
            sides[row] = -at_zero;
        }
        let solved = matrix.full_piv_lu().solve(&sides).filter(|solved| solved.iter().all(|x| x.is_finite()));
        let solved = solved.ok_or_else(says::no_solution)?;
        Ok(Made::Numbers(new.into_iter().zip(solved.iter().copied()).collect()))
    }
}
