//! A system of linear equations, whose numbers may be known within bounds.

use super::{Ball, Elements, LinearSystem, Number, refined};
use nalgebra::DMatrix;

/// Corrections go on until they are below this part of the solution: then only the bounds of the coefficients are left.
const LAST_CORRECTION: f64 = 1e-24;

/// Numbers of which [`Equations`] may be made.
pub trait Solvable: Number + Default + PartialEq + From<i32> {
    /// The unknowns; `None` where the equations are singular, or may be within the bounds of their coefficients.
    fn solved(equations: &Equations<Self>) -> Option<Vec<Self>>;
}

/// A square system of linear equations, with coefficients and right sides in [`Ball`]s or in f64.
///
/// It is solved as the loop equations are. In f64 that is all. Balls go on by corrections from residuals of twice the digits, and the
/// bound of each unknown is proved ([`Verified`](super::Verified)).
#[derive(Clone, Debug)]
pub struct Equations<N> {
    size: usize,
    /// Of so many pairs of equations, the first ones, both are components of one vector.
    vectors: usize,
    /// Row by row.
    coefficients: Vec<N>,
    right: Vec<N>,
}

impl<N: Solvable> Equations<N> {
    /// `size` equations without coefficients, the first of them the components x and y of `vectors` vectors.
    #[must_use]
    pub fn new(size: usize, vectors: usize) -> Equations<N> {
        let zero = N::default();
        Equations { size, vectors, coefficients: vec![zero; size * size], right: vec![zero; size] }
    }

    /// Adds to a coefficient.
    pub fn add(&mut self, equation: usize, unknown: usize, coefficient: N) {
        let own = &mut self.coefficients[equation * self.size + unknown];
        *own = *own + coefficient;
    }

    /// Adds to a right side.
    pub fn add_right(&mut self, equation: usize, number: N) {
        self.right[equation] = self.right[equation] + number;
    }

    /// The unknowns, of balls with bounds of their errors; `None` where the equations are singular, or may be within the bounds of
    /// their coefficients.
    #[must_use]
    pub fn solved(&self) -> Option<Vec<N>> {
        if self.size == 0 { Some(Vec::new()) } else { N::solved(self) }
    }

    /// The same equations with other numbers in place of each.
    #[must_use]
    pub fn each<M>(&self, number: impl Fn(&N) -> M) -> Equations<M> {
        let Equations { size, vectors, .. } = *self;
        let all = |numbers: &[N]| numbers.iter().map(&number).collect();
        Equations { size, vectors, coefficients: all(&self.coefficients), right: all(&self.right) }
    }

    fn coefficient(&self, equation: usize, unknown: usize) -> N {
        self.coefficients[equation * self.size + unknown]
    }
}

impl Solvable for f64 {
    fn solved(equations: &Equations<f64>) -> Option<Vec<f64>> {
        let matrix = DMatrix::from_row_slice(equations.size, equations.size, &equations.coefficients);
        let solution = LinearSystem::solved_once(matrix, equations.vectors, &equations.right)?;
        solution.iter().all(|x| x.is_finite()).then_some(solution)
    }
}

impl Solvable for Ball {
    fn solved(equations: &Equations<Ball>) -> Option<Vec<Ball>> {
        equations.proved()
    }
}

impl Equations<Ball> {
    fn proved(&self) -> Option<Vec<Ball>> {
        let rounded = DMatrix::from_fn(self.size, self.size, |row, column| self.coefficient(row, column).high);
        let system = LinearSystem::of_vectors(rounded, self.vectors)?;
        let off: Elements = self.coefficients.iter().map(|coefficient| coefficient.error()).collect();
        let verified = system.verified(&off);
        let solution = refined(
            &verified,
            self.right.clone(),
            LAST_CORRECTION,
            |system, right| system.solve(right),
            |_, solution| self.residuals(solution),
        );
        solution.iter().all(|x| x.is_known()).then(|| solution.into_vec())
    }

    /// What these unknowns leave of the equations.
    fn residuals(&self, unknowns: &[Ball]) -> Vec<Ball> {
        let row = |(row, &right): (usize, &Ball)| {
            let coefficients = &self.coefficients[row * self.size..][..self.size];
            // Most coefficients are zero.
            let there = coefficients.iter().zip(unknowns).filter(|(coefficient, _)| **coefficient != Ball::default());
            there.fold(right, |left, (&coefficient, &x)| left - coefficient * x)
        };
        self.right.iter().enumerate().map(row).collect()
    }
}
