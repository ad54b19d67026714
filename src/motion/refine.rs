use super::places::Places;
use super::sides::{Balls, Sides, residuals};
use crate::geometry::{Ball, LinearSystem, Numbers, Pair, Point, Reduced, UNIT_ROUNDOFF, Vector};
use crate::mechanism::{AngularRate, Arm, LoopEquations, Reduction, SlideRate};
use smallvec::smallvec;

/// Solves a group's loop equations almost to the last digit by iterative refinement.
///
/// The residual of the solution is computed with twice the digits, the same factors give a correction, and so on
/// (Wilkinson 1963; Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §12.1). Each pass multiplies the
/// error by about u·condition.
pub(super) struct Solver<'a, P> {
    equations: &'a LoopEquations,
    system: &'a LinearSystem,
    places: &'a P,
    closed: Option<ClosedForm>,
    /// Refinement ends after a correction smaller than this part of the solution.
    last_correction: f64,
}

impl<'a, P: Places> Solver<'a, P> {
    pub fn new(equations: &'a LoopEquations, system: &'a LinearSystem, places: &'a P) -> Self {
        // A correction δ leaves an error of about u·condition·δ. The error of the velocities enters the accelerations
        // multiplied by the condition once more, and should stay some bits below the last digit.
        let condition = system.condition();
        Self {
            equations,
            system,
            places,
            closed: ClosedForm::new(equations, places.points(), places.guides()),
            last_correction: 1.0 / (16.0 * condition * condition),
        }
    }

    /// The unknowns for these right sides, with bounds of their errors.
    pub fn solve(&self, sides: &Sides) -> Balls {
        let mut solution: Balls = smallvec![Ball::default(); self.equations.unknowns];
        let mut rest = sides.clone();
        let mut before = f64::INFINITY;
        loop {
            let right: Numbers = rest.numbers().map(|x| x.high).collect();
            let correction = match &self.closed {
                Some(form) => form.solve_all(&right),
                None => self.system.solve(&right),
            };
            for (x, &more) in solution.iter_mut().zip(&correction) {
                *x = *x + more.into();
            }
            let change = self.system.size(correction.iter().copied());
            let size = self.system.size(solution.iter().map(|x| x.high));
            // Corrections that no longer decrease are rounding.
            if change <= self.last_correction * size || change > 0.5 * before || !change.is_finite() {
                self.widen(&mut solution, &rest, &correction);
                return solution;
            }
            before = change;
            rest = residuals(self.equations, self.places, sides, &solution);
        }
    }

    /// Widens the solution by the bounds of its errors after the last `correction`, found for the residual `rest`.
    fn widen(&self, solution: &mut Balls, rest: &Sides, correction: &[f64]) {
        let right: Numbers = rest.numbers().map(|x| x.high).collect();
        let mut uncertain: Numbers = rest.numbers().map(Ball::error).collect();
        self.add_coefficient_errors(&mut uncertain, correction);
        let errors = self.system.error_bound(correction, &right, &uncertain);
        let growth = if P::UNCERTAIN { 1.0 / (1.0 - self.stretch()).max(0.0) } else { 1.0 };
        for (x, error) in solution.iter_mut().zip(errors) {
            *x = x.widened(growth * error);
        }
    }

    /// By what part of itself the inverse of the matrix may change within the bounds of the places, to first order: at
    /// most the condition times the sum of the columns' relative errors.
    fn stretch(&self) -> f64 {
        let mut columns = vec![[0.0_f64; 2]; self.equations.unknowns];
        for terms in &self.equations.loops {
            let mut add = |unknown: usize, [exact, error]: [f64; 2]| {
                let [size, sum] = &mut columns[unknown];
                (*size, *sum) = (size.max(exact), *sum + error);
            };
            for arm in &terms.arms {
                if let AngularRate::Unknown(unknown) = arm.angular {
                    let [exact, rounded] = self.arms(arm);
                    let [x, y] = exact.errors_from(rounded.rounded());
                    add(unknown, [rounded.rounded().amax(), x + y]);
                }
            }
            for slide in &terms.slides {
                if let SlideRate::Unknown(unknown) = slide.rate {
                    let [x, y] = self.places.guide(slide.slider).errors_from(self.places.guides()[slide.slider.0]);
                    add(unknown, [1.0, x + y]);
                }
            }
        }
        let relative = columns.iter().filter(|[size, _]| *size > 0.0).map(|[size, error]| error / size);
        2.0 * self.system.condition() * relative.sum::<f64>()
    }

    /// Adds the effect of rounded coefficients: their errors times the correction.
    fn add_coefficient_errors(&self, uncertain: &mut Numbers, correction: &[f64]) {
        for (terms, uncertain) in self.equations.loops.iter().zip(uncertain.chunks_mut(2)) {
            let mut add = |[x, y]: [f64; 2], times: f64| {
                uncertain[0] += x * times.abs();
                uncertain[1] += y * times.abs();
            };
            for arm in &terms.arms {
                if let AngularRate::Unknown(unknown) = arm.angular {
                    let [exact, rounded] = self.arms(arm);
                    // One rounding for each further arm of the same rotation.
                    let alike = terms.arms.iter().filter(|other| other.angular == arm.angular);
                    let rounding = alike.count() as f64 * UNIT_ROUNDOFF;
                    let [x, y] = exact.errors_from(rounded.rounded());
                    let sum = [x + rounding * rounded.x.high.abs(), y + rounding * rounded.y.high.abs()];
                    add(sum, correction[unknown]);
                }
            }
            for slide in &terms.slides {
                if let SlideRate::Unknown(unknown) = slide.rate {
                    let u = self.places.guides()[slide.slider.0];
                    add(self.places.guide(slide.slider).errors_from(u), correction[unknown]);
                }
            }
        }
    }

    /// An arm turned by +90°: as it is, and as it stands in the matrix.
    fn arms(&self, arm: &Arm) -> [Pair<Ball>; 2] {
        let points = self.places.points();
        let rounded = Pair::from(points[arm.to.0] - points[arm.from.0]);
        [self.places.arm(arm.from, arm.to).quarter_turn(), rounded.quarter_turn()]
    }
}

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
