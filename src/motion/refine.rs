use super::moving::{BoundedMotion, Places, State};
use crate::geometry::{
    self, Ball, Balls, Elements, LinearSystem, Numbers, Pair, Point, Reduced, UNIT_ROUNDOFF, Vector, Verified, refined,
};
use crate::mechanism::{
    AngularRate, AngularTerms, LoopEquations, LoopTerms, PointId, Reduction, SlideRate, SliderId, Travelling,
};
use smallvec::SmallVec;

/// Solves a group's loop equations almost to the last digit ([`refined`]).
pub(super) struct Solver<'a, P> {
    equations: &'a LoopEquations,
    places: &'a P,
    /// What is proved of the matrices of all places that are meant.
    verified: Verified<'a>,
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
            places,
            verified: system.verified(&coefficient_errors(equations, places)),
            closed: ClosedForm::of(
                equations,
                |from, to| places.rounded_arm(from, to),
                |slider| places.rounded_guide(slider),
            ),
            last_correction: 1.0 / (16.0 * condition * condition),
        }
    }

    /// The unknowns for these right sides, with bounds of their errors.
    pub fn solve(&self, sides: Sides) -> Balls {
        let correct = |system: &LinearSystem, right: &[f64]| match &self.closed {
            Some(form) => form.solve_all(right),
            None => system.solve(right),
        };
        let left = |sides: &Sides, solution: &[Ball]| residuals(self.equations, self.places, sides, solution);
        refined(&self.verified, sides, self.last_correction, correct, left)
    }
}

/// How far the coefficients of the equations are from those of the matrix that has the rounded points and guides, row by
/// row.
pub(crate) fn coefficient_errors(equations: &LoopEquations, places: &impl Places) -> Elements {
    let width = equations.unknowns;
    let mut errors = Elements::from_elem(0.0, width * (2 * equations.loops.len() + equations.angular.len()));
    for (index, terms) in equations.loops.iter().enumerate() {
        let rows = &mut errors[2 * index * width..];
        let mut add = |unknown: usize, [x, y]: [f64; 2]| {
            rows[unknown] += x;
            rows[width + unknown] += y;
        };
        for arm in &terms.arms {
            if let AngularRate::Unknown(unknown) = arm.angular {
                let rounded = places.rounded_arm(arm.from, arm.to);
                // One rounding for each further arm of the same rotation.
                let alike = terms.arms.iter().filter(|other| other.angular == arm.angular);
                let rounding = alike.count() as f64 * UNIT_ROUNDOFF;
                let [x, y] = places.arm(arm.from, arm.to).errors_from(rounded);
                add(unknown, [y + rounding * rounded.y.abs(), x + rounding * rounded.x.abs()]);
            }
        }
        for slide in &terms.slides {
            if let SlideRate::Unknown(unknown) = slide.rate {
                let rounded = places.rounded_guide(slide.slider);
                add(unknown, places.guide(slide.slider).errors_from(rounded));
            }
        }
    }
    for (terms, row) in equations.angular.iter().zip(errors[2 * equations.loops.len() * width..].chunks_mut(width)) {
        let Some(travel) = &terms.travel else { continue };
        for Travelling { unknown, sign, .. } in &travel.slides {
            if let Some(unknown) = unknown {
                let exact = Ball::from(-1).signed(*sign) / places.given(travel.radius);
                row[*unknown] += exact.error_from(-sign / travel.radius);
            }
        }
    }
    errors
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
        Self::of(equations, |from, to| points[to.0] - points[from.0], |slider| guides[slider.0])
    }

    /// As [`Self::new`], with these vectors from one point to another and unit directions of guides.
    #[inline]
    fn of(
        equations: &LoopEquations,
        vector: impl Fn(PointId, PointId) -> Vector,
        guide: impl Fn(SliderId) -> Vector,
    ) -> Option<Self> {
        let reduction = equations.reduction?;
        // A reduction has at most four unknowns in two loops.
        let mut all = [[Vector::zeros(); 4]; 2];
        for (terms, columns) in equations.loops.iter().zip(&mut all) {
            terms.add_columns(&vector, &guide, columns);
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

/// Right sides of the equations, or residuals: a vector for each loop, a number for each relation between angles.
#[derive(Clone, Debug)]
pub(super) struct Sides {
    loops: SmallVec<[Pair<Ball>; 2]>,
    angular: SmallVec<[Ball; 1]>,
}

impl geometry::Sides for Sides {
    /// The components of all loops, then of all relations between angles: the order of the equations.
    fn numbers(&self) -> impl Iterator<Item = Ball> {
        self.loops.iter().flat_map(|side| [side.x, side.y]).chain(self.angular.iter().copied())
    }
}

/// The right sides of the velocity equations, v_end − v_start − Σ ω J r − Σ ṡ u of known rotations and slides; known
/// bodies move as in `state`.
pub(super) fn velocity_sides(equations: &LoopEquations, places: &impl Places, state: &State) -> Sides {
    let omega = |rate: AngularRate| match rate {
        AngularRate::Known(body) => Some(state.body(body).omega),
        AngularRate::Unknown(_) => None,
    };
    let speed = |rate: SlideRate| match rate {
        SlideRate::Driven([speed, _]) => Some(places.rate(speed)),
        SlideRate::Unknown(_) => None,
    };
    let side = |terms: &LoopTerms| {
        let ends = between_ends(terms, places, state, |body, place| [body.velocity, body.swing(place)]);
        less_rates(terms, places, ends, omega, speed)
    };
    Sides {
        loops: equations.loops.iter().map(side).collect(),
        angular: {
            let travels = |slide: &Travelling| slide.unknown.is_none().then(|| state.slide(slide.slider).velocity);
            let angular = equations.angular.iter();
            angular.map(|terms| less_angular(terms, places, Ball::default(), omega, travels)).collect()
        },
    }
}

/// The right sides of the acceleration equations; `rates` is the solution of the velocity equations.
pub(super) fn acceleration_sides(
    equations: &LoopEquations,
    places: &impl Places,
    state: &State,
    rates: &[Ball],
) -> Sides {
    let alpha = |rate: AngularRate| match rate {
        AngularRate::Known(body) => Some(state.body(body).alpha),
        AngularRate::Unknown(_) => None,
    };
    Sides {
        loops: equations.loops.iter().map(|terms| acceleration_side(terms, places, state, rates)).collect(),
        angular: {
            let travels = |slide: &Travelling| slide.unknown.is_none().then(|| state.slide(slide.slider).acceleration);
            let angular = equations.angular.iter();
            angular.map(|terms| less_angular(terms, places, Ball::default(), alpha, travels)).collect()
        },
    }
}

/// What the unknowns `x` leave of the equations with these right sides.
fn residuals(equations: &LoopEquations, places: &impl Places, sides: &Sides, x: &[Ball]) -> Sides {
    let angular_rate = |rate: AngularRate| match rate {
        AngularRate::Unknown(unknown) => Some(x[unknown]),
        AngularRate::Known(_) => None,
    };
    let slide_rate = |rate: SlideRate| match rate {
        SlideRate::Unknown(unknown) => Some(x[unknown]),
        SlideRate::Driven(_) => None,
    };
    let loops = equations.loops.iter().zip(&sides.loops);
    let angular = equations.angular.iter().zip(&sides.angular);
    Sides {
        loops: loops.map(|(terms, &side)| less_rates(terms, places, side, angular_rate, slide_rate)).collect(),
        angular: angular
            .map(|(terms, &side)| {
                less_angular(terms, places, side, angular_rate, |slide| slide.unknown.map(|unknown| x[unknown]))
            })
            .collect(),
    }
}

/// side − Σ weight · rate + Σ ṡ / r, of those rates that the functions give.
fn less_angular(
    terms: &AngularTerms,
    places: &impl Places,
    side: Ball,
    rate_of: impl Fn(AngularRate) -> Option<Ball>,
    speed_of: impl Fn(&Travelling) -> Option<Ball>,
) -> Ball {
    let rates = terms.rates.iter();
    let side = rates.fold(side, |side, &(rate, weight)| rate_of(rate).map_or(side, |x| side - x * Ball::from(weight)));
    let Some(travel) = &terms.travel else { return side };
    let radius = places.given(travel.radius);
    let slides = travel.slides.iter();
    slides.fold(side, |side, slide| speed_of(slide).map_or(side, |x| side + x.signed(slide.sign) / radius))
}

/// side − Σ ω J r − Σ ṡ u, of those ω and ṡ that the functions give.
fn less_rates(
    terms: &LoopTerms,
    places: &impl Places,
    mut side: Pair<Ball>,
    omega: impl Fn(AngularRate) -> Option<Ball>,
    speed: impl Fn(SlideRate) -> Option<Ball>,
) -> Pair<Ball> {
    for arm in &terms.arms {
        if let Some(omega) = omega(arm.angular) {
            side = side - places.arm(arm.from, arm.to).quarter_turn() * omega;
        }
    }
    for slide in &terms.slides {
        if let Some(speed) = speed(slide.rate) {
            side = side - places.guide(slide.slider) * speed.signed(slide.sign);
        }
    }
    side
}

/// The motion of a loop's end less that of its start; zero for a closed contour. `motion` gives that of a body's
/// reference point, and that of the point at a place relative to it.
fn between_ends(
    terms: &LoopTerms,
    places: &impl Places,
    state: &State,
    motion: impl Fn(&BoundedMotion, Pair<Ball>) -> [Pair<Ball>; 2],
) -> Pair<Ball> {
    let Some([start, end]) = terms.ends else {
        return Pair::default();
    };
    let start = motion(state.body(start), places.place(terms.first));
    let end = motion(state.body(end), places.place(terms.last));
    (end[0] - start[0]) + (end[1] - start[1])
}

/// The right side of a loop's acceleration equations: a_end − a_start + Σ ω² r − Σ 2 ω ṡ J u, and − Σ α J r − Σ s̈ u of
/// known rotations and slides.
fn acceleration_side(terms: &LoopTerms, places: &impl Places, state: &State, rates: &[Ball]) -> Pair<Ball> {
    let mut side = between_ends(terms, places, state, |body, place| [body.acceleration, body.turning(place)]);
    let omega = |rate: AngularRate| match rate {
        AngularRate::Unknown(unknown) => rates[unknown],
        AngularRate::Known(body) => state.body(body).omega,
    };
    for arm in &terms.arms {
        let r = places.arm(arm.from, arm.to);
        let omega = omega(arm.angular);
        side = side + r * (omega * omega);
        if let AngularRate::Known(body) = arm.angular {
            side = side - r.quarter_turn() * state.body(body).alpha;
        }
    }
    for slide in &terms.slides {
        let u = places.guide(slide.slider) * Ball::from(1).signed(slide.sign);
        let rate = match slide.rate {
            SlideRate::Unknown(unknown) => rates[unknown],
            SlideRate::Driven([speed, acceleration]) => {
                side = side - u * places.rate(acceleration);
                places.rate(speed)
            }
        };
        side = side - u.quarter_turn() * (omega(slide.angular) * rate).twice();
    }
    side
}
