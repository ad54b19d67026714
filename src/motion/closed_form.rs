use crate::geometry::{Numbers, Pair, Point, Reduced, UNIT_ROUNDOFF, Vector};
use crate::mechanism::{LoopEquations, Reduction};

/// The loop equations of a group reduced to two equations for two rates: second, third and fourth class.
///
/// A dyad's one loop has just two unknown rates. In a third- or fourth-class group each of the two loops has one rate of its own
/// besides the two that they share; see [`Reduced`].
/// For a fourth-class group with pins only this is ω2 (BC × CD) − ω4 (ED × CD) = Δv · CD and its like.
#[derive(Clone, Copy, Debug)]
pub enum ClosedForm {
    /// A dyad.
    OneLoop(Reduced<1, f64>),
    /// A third- or fourth-class group, and which unknowns its loops share and have of their own.
    TwoLoops(Reduced<2, f64>, [usize; 4]),
}

impl ClosedForm {
    /// The reduced form of the equations where the points and guides are these; `None` where there is none, or its determinant is
    /// lost in rounding, or numbers come near the ends of f64's range.
    #[inline]
    #[must_use]
    pub fn new(equations: &LoopEquations, points: &[Point], guides: &[Vector]) -> Option<Self> {
        let reduction = equations.reduction?;
        // A reduction has at most four unknowns in two loops.
        let mut all = [[Vector::zeros(); 4]; 2];
        for (terms, columns) in equations.loops.iter().zip(&mut all) {
            terms.add_columns(points, guides, columns);
        }
        // The squares of the own columns are inverted.
        let mut squares = 1.0;
        let (form, determinant, products) = match reduction {
            Reduction::OneLoop => {
                let [s, t, ..] = all[0];
                let system = Reduced::new([[Vector::zeros(), s, t].map(Pair::from)]);
                (Self::OneLoop(system), system.determinant(), system.products())
            }
            Reduction::TwoLoops { shared: [x, y], own } => {
                let columns = [0, 1].map(|i| [own[i], x, y].map(|u| Pair::from(all[i][u])));
                squares = columns.map(|[h, ..]| h.dot(h)).iter().product();
                let system = Reduced::new(columns);
                let order = [x, y, own[0], own[1]];
                let form = Self::TwoLoops(system, order);
                (form, system.determinant(), system.products())
            }
        };
        // False for a NaN too. Fourth powers of lengths must not come near the ends of f64's range.
        let size = determinant.abs();
        let uncertain = UNIT_ROUNDOFF * (products[0].abs() + products[1].abs());
        let inside = [size, squares].iter().all(|x| (1e-250..1e250).contains(x));
        let safe = size > 16.0 * uncertain && inside;
        safe.then_some(form)
    }

    /// The rates for the right sides of the loops in a row, as many as there are numbers.
    #[must_use]
    pub fn solve_all(&self, side: &[f64]) -> Numbers {
        let pair = |k: usize| Pair { x: side[2 * k], y: side[2 * k + 1] };
        let mut rates = [0.0; 4];
        match self {
            Self::OneLoop(system) => {
                rates = system.solve(1.0 / system.determinant(), [pair(0)]);
            }
            Self::TwoLoops(system, order) => {
                let solved = system.solve(1.0 / system.determinant(), [pair(0), pair(1)]);
                for (unknown, x) in order.iter().zip(solved) {
                    rates[*unknown] = x;
                }
            }
        }
        Numbers::from_slice(&rates[..side.len()])
    }
}
