//! The reference: the joint equations solved with 256 bits.

use super::joints::{Given, JointEquations, Real, State, dot, minus};
use dashu_float::round::mode::HalfEven;
use dashu_float::{FBig, ops::Abs};
use kinegon::mechanism::Mechanism;
use std::cmp::Ordering;

/// A number of 256 bits. Of these the joint equations of the hardest groups lose about 110.
pub type Precise = FBig<HalfEven, 2>;

const BITS: usize = 256;

impl Real for Precise {
    fn exactly(number: f64) -> Precise {
        let number = Precise::try_from(number).expect("positions and motions are finite");
        number.with_precision(BITS).value()
    }

    fn root(self) -> Precise {
        self.sqrt()
    }
}

/// How a mechanism truly moves at given positions.
pub struct Truth {
    /// By body.
    pub bodies: Vec<State<Precise>>,
    /// By slider: velocity and acceleration along its guide.
    pub slides: Vec<[Precise; 2]>,
    given: Given<Precise>,
}

impl Truth {
    /// `None` where the equations are singular.
    pub fn new(mechanism: &Mechanism, points: &[[f64; 2]], guides: &[[f64; 2]]) -> Option<Truth> {
        Truth::of(mechanism, Given::new(mechanism, points, guides))
    }

    /// The truth for positions that have 256 bits themselves.
    pub fn of(mechanism: &Mechanism, given: Given<Precise>) -> Option<Truth> {
        let equations = JointEquations::new(mechanism);
        let size = equations.size();
        let mut matrix = vec![vec![Precise::exactly(0.0); size]; size];
        equations.matrix(&given, |row, column, value| {
            matrix[row][column] = matrix[row][column].clone() + value;
        });
        let factors = Factors::new(matrix)?;
        let first = factors.solve(equations.velocity_sides(&given));
        let second = factors.solve(equations.acceleration_sides(&given, &first));
        let bodies = equations.states(&given, &first, &second);
        let slides = mechanism.sliders.iter().enumerate().map(|(index, slider)| {
            let guide = given.guides[index].clone();
            let length = dot(guide.clone(), guide.clone()).root();
            let place = given.points[slider.at.0].clone();
            let [on, link] = [slider.on, slider.link].map(|b| &bodies[b.0]);
            let along = |a: [Precise; 2], b| dot(guide.clone(), minus(a, b)) / length.clone();
            [
                along(link.velocity_at(place.clone()), on.velocity_at(place.clone())),
                along(link.acceleration_at(place.clone()), on.acceleration_at(place)),
            ]
        });
        Some(Truth { slides: slides.collect(), bodies, given })
    }

    /// Velocity and acceleration of a point of a body.
    pub fn at(&self, body: usize, point: usize) -> [[Precise; 2]; 2] {
        let place = self.given.points[point].clone();
        let body = &self.bodies[body];
        [body.velocity_at(place.clone()), body.acceleration_at(place)]
    }
}

/// Below this a number of the reference, in units of ordinary size, is the rounding of zero.
pub const ROUNDING: f64 = 1e-50;

/// The number, or zero in place of its rounding.
pub fn without_rounding(number: Precise) -> Precise {
    if rounded(&number).abs() < ROUNDING {
        return Precise::exactly(0.0);
    }
    number
}

/// The nearest f64.
pub fn rounded(number: &Precise) -> f64 {
    number.to_f64().value()
}

/// By how much a number is wrong.
pub fn error(number: f64, truth: &Precise) -> f64 {
    if !number.is_finite() {
        return f64::INFINITY;
    }
    rounded(&(Precise::exactly(number) - truth.clone())).abs()
}

/// By how much a vector is wrong, in its worse component.
pub fn error_of_pair(pair: [f64; 2], truth: &[Precise; 2]) -> f64 {
    error(pair[0], &truth[0]).max(error(pair[1], &truth[1]))
}

/// Triangular factors with the largest pivot of each column; zeros are passed over.
struct Factors {
    /// Above and on the diagonal U, below it L.
    rows: Vec<Vec<Precise>>,
    /// Which row of the matrix each has become.
    order: Vec<usize>,
}

impl Factors {
    fn new(mut rows: Vec<Vec<Precise>>) -> Option<Factors> {
        let size = rows.len();
        let mut order: Vec<usize> = (0..size).collect();
        for k in 0..size {
            let larger = |a: &usize, b: &usize| {
                let [a, b] = [*a, *b].map(|row| rows[row][k].clone().abs());
                a.partial_cmp(&b).unwrap_or(Ordering::Equal)
            };
            let pivot = (k..size).max_by(larger)?;
            rows.swap(k, pivot);
            order.swap(k, pivot);
            if is_zero(&rows[k][k]) {
                return None;
            }
            let (done, rest) = rows.split_at_mut(k + 1);
            let pivot = &done[k];
            for row in rest.iter_mut().filter(|row| !is_zero(&row[k])) {
                let factor = &row[k] / &pivot[k];
                for column in k + 1..size {
                    if !is_zero(&pivot[column]) {
                        row[column] = &row[column] - &factor * &pivot[column];
                    }
                }
                row[k] = factor;
            }
        }
        Some(Factors { rows, order })
    }

    fn solve(&self, sides: Vec<Precise>) -> Vec<Precise> {
        let size = sides.len();
        let mut x: Vec<Precise> = self.order.iter().map(|&row| sides[row].clone()).collect();
        let less = |x: &mut Vec<Precise>, row: usize, column: usize| {
            if !is_zero(&self.rows[row][column]) {
                x[row] = &x[row] - &self.rows[row][column] * &x[column];
            }
        };
        for row in 0..size {
            (0..row).for_each(|column| less(&mut x, row, column));
        }
        for row in (0..size).rev() {
            (row + 1..size).for_each(|column| less(&mut x, row, column));
            x[row] = &x[row] / &self.rows[row][row];
        }
        x
    }
}

fn is_zero(x: &Precise) -> bool {
    x.repr().significand().is_zero()
}
