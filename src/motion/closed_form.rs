use crate::geometry::{Numbers, Pair, Point, Reduced, UNIT_ROUNDOFF, Vector};
use crate::mechanism::{LoopEquations, Reduction};

/// The loop equations of a group of class II, III or IV reduced to two equations for two rates.
///
/// A dyad's one loop has just two unknown rates. In a group of class III or IV each of the two loops has one rate of
/// its own besides the two that they share; see [`Reduced`]. For a class IV group with pins only the equations are ω2
/// (BC × CD) − ω4 (ED × CD) = Δv · CD and its counterpart.
#[derive(Clone, Copy, Debug)]
pub enum ClosedForm {
    /// A group of class II.
    OneLoop(Reduced<1, f64>),
    /// A group of class III or IV, with the unknowns in the order shared, shared, own, own.
    TwoLoops(Reduced<2, f64>, [usize; 4]),
}

impl ClosedForm {
    /// The reduced equations at these points and guides; `None` for other groups, where rounding dominates the
    /// determinant, or where numbers approach the limits of f64.
    #[inline]
    #[must_use]
    pub fn new(equations: &LoopEquations, points: &[Point], guides: &[Vector]) -> Option<Self> {
        let reduction = equations.reduction?;
        // A reduction has at most four unknowns in two loops.
        let mut all = [[Vector::zeros(); 4]; 2];
        for (terms, columns) in equations.loops.iter().zip(&mut all) {
            terms.add_columns(points, guides, columns);
        }
        // The squares of the own columns are inverted: they must not be too small either.
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
        // False for NaN too. The bounds keep fourth powers of lengths within the range of f64.
        let size = determinant.abs();
        let uncertain = UNIT_ROUNDOFF * (products[0].abs() + products[1].abs());
        let inside = [size, squares].iter().all(|x| (1e-250..1e250).contains(x));
        let safe = size > 16.0 * uncertain && inside;
        safe.then_some(form)
    }

    /// The rates for the right sides of the loops, two components each; as many rates as components.
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
