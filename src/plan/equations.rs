use super::cut::{CutLine, LegKind, Special};
use super::driven::SlideMeasure;
use crate::geometry::{Line, LinearSystem, Numbers, Point, UNIT_ROUNDOFF, Vector, quarter_turn, span};
use crate::mechanism::{BodyId, Group, LoopEquations, Mechanism, PointId, SliderId};
use crate::motion::{BodyMotion, Motion, Order};
use crate::position::Pose;
use nalgebra::{DMatrix, DVector};

/// One leg of a special point as constructed: the ray that it gives in each plan and what is measured along it.
#[derive(Clone, Debug)]
pub struct LegMeasure {
    /// What the driven sliders on the way add, one after the other.
    pub slides: Vec<SlideMeasure>,
    /// Plan vector from which the velocity ray starts (v_B, and what driven sliders add).
    pub velocity_start: Vector,
    /// Plan vector of the acceleration from which the normal part is laid off (a_B, and what driven sliders add).
    pub acceleration_start: Vector,
    /// The normal part (Coriolis included), along the cut line.
    pub normal: Vector,
    /// Unit direction of the rays, a quarter turn from the cut line.
    pub ray: Vector,
    /// Signed segment of the velocity plan along `ray`, from the start to the special point's image.
    pub velocity: f64,
    /// Signed segment of the acceleration plan along `ray`, from the end of the normal part.
    pub acceleration: f64,
}

/// The graphical construction of one group, carried out in numbers.
#[derive(Clone, Debug)]
pub struct Construct {
    /// For each special point: its two legs.
    pub legs: Vec<[LegMeasure; 2]>,
    /// For each special point: its velocity.
    pub velocities: Vec<Vector>,
    /// For each special point: its acceleration.
    pub accelerations: Vec<Vector>,
    /// What the equations give, and how it compares with the loop equations.
    pub agreement: Agreement,
}

/// How the two routes to the rates compare.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The largest difference of an angular or slide rate between the routes, velocity or acceleration,
    /// relative to the largest rate of its kind.
    pub difference: f64,
    /// The difference that rounding, the condition and the sines of the crossings allow, in the same measure.
    pub allowed: f64,
}

/// Roundings that go into a crossing, its direction and a length measured to it.
const CROSSING_ROUNDINGS: f64 = 4.0;

/// Carries out the construction for a group whose special points are all at finite places; `None` where one is not, or where
/// the equations have no solution.
pub(super) fn construct(
    mechanism: &Mechanism,
    group: &Group,
    pose: &Pose,
    motion: &Motion,
    special: &[Special],
) -> Option<Construct> {
    let equations = LoopEquations::new(mechanism, group);
    let size = span(group_points(mechanism, group, pose));
    let unknowns = equations.unknowns;
    if special.is_empty() || 2 * special.len() != unknowns {
        return None;
    }
    let mut board = Board {
        mechanism,
        pose,
        motion,
        equations: &equations,
        matrix: DMatrix::zeros(unknowns, unknowns),
        doubt: DMatrix::zeros(unknowns, unknowns),
        known: [DVector::zeros(unknowns), DVector::zeros(unknowns)],
    };
    let mut legs: Vec<[LegMeasure; 2]> = Vec::new();
    for (index, point) in special.iter().enumerate() {
        for (side, cut) in point.cuts.iter().enumerate() {
            board.equation(2 * index + side, cut, point, size)?;
        }
        let [first, second] = &point.cuts;
        legs.push([board.start(first)?, board.start(second)?]);
    }
    let mut velocities = Vec::new();
    let mut sides = Sides::new(unknowns);
    for (index, (point, pair)) in special.iter().zip(&mut legs).enumerate() {
        let start = |leg: &LegMeasure| leg.velocity_start;
        velocities.push(cross_rays(pair, start, |leg, m| leg.velocity = m));
        sides.measure(index, point, pair, start, |leg| leg.velocity);
    }
    let first = board.solve(&sides, 0)?;

    let mut accelerations = Vec::new();
    let mut second = None;
    if motion.order == Order::Acceleration {
        let mut sides = Sides::new(unknowns);
        for (index, (point, pair)) in special.iter().zip(&mut legs).enumerate() {
            for (side, (cut, leg)) in point.cuts.iter().zip(pair.iter_mut()).enumerate() {
                let slid = board.slide_accelerations(leg, &first);
                let (normal, doubt) = board.normal(cut, point, &first, size)?;
                leg.normal = normal;
                sides.uncertain[2 * index + side] += doubt + slid;
            }
            let start = |leg: &LegMeasure| leg.acceleration_start + leg.normal;
            let doubts = [sides.uncertain[2 * index], sides.uncertain[2 * index + 1]];
            accelerations.push(cross_rays(pair, start, |leg, m| leg.acceleration = m));
            sides.measure(index, point, pair, start, |leg| leg.acceleration);
            // A normal part laid off wrongly shifts both rays' crossing by its error over the sine.
            let shift = (doubts[0] + doubts[1]) / point.crossing.sine().abs();
            sides.uncertain[2 * index] += shift;
            sides.uncertain[2 * index + 1] += shift;
        }
        second = Some(board.solve(&sides, 1)?);
    }
    let agreement = board.agreement(group, size, &first, second.as_ref());
    Some(Construct { legs, velocities, accelerations, agreement })
}

fn group_points(mechanism: &Mechanism, group: &Group, pose: &Pose) -> impl Iterator<Item = Point> {
    let points = group.bodies.iter();
    let points = points.flat_map(|&l| &mechanism.body(l).points);
    points.map(|&p| pose.point(p))
}

/// Crosses the rays of two legs; stores the signed segments and returns the crossing, as a plan vector.
fn cross_rays(
    pair: &mut [LegMeasure; 2],
    start: impl Fn(&LegMeasure) -> Vector,
    store: impl Fn(&mut LegMeasure, f64),
) -> Vector {
    let [a, b] = [start(&pair[0]), start(&pair[1])];
    let along = |leg: &LegMeasure, from: Vector| Line::Through { point: Point::from(from), direction: leg.ray };
    // The rays are the cut lines turned by 90°: they cross at the same angle.
    let crossing = along(&pair[0], a).crossing(&along(&pair[1], b));
    let place = crossing.place().finite();
    let image = place.map_or(a, |p| p.coords);
    for leg in pair.iter_mut() {
        let segment = (image - start(leg)).dot(&leg.ray);
        store(leg, segment);
    }
    image
}

/// A solution of the equations with bounds of its errors.
struct Solution {
    rates: Numbers,
    errors: Numbers,
}

/// The measured segments.
struct Sides {
    value: DVector<f64>,
    uncertain: DVector<f64>,
}

impl Sides {
    fn new(unknowns: usize) -> Self {
        Self { value: DVector::zeros(unknowns), uncertain: DVector::zeros(unknowns) }
    }

    fn measure(
        &mut self,
        index: usize,
        point: &Special,
        pair: &[LegMeasure; 2],
        start: impl Fn(&LegMeasure) -> Vector,
        segment: impl Fn(&LegMeasure) -> f64,
    ) {
        let [a, b] = [start(&pair[0]), start(&pair[1])];
        let size = a.norm() + b.norm();
        let error = CROSSING_ROUNDINGS * UNIT_ROUNDOFF * size / point.crossing.sine().abs();
        for (side, leg) in pair.iter().enumerate() {
            self.value[2 * index + side] = segment(leg);
            self.uncertain[2 * index + side] += error;
        }
    }
}

/// The equations of the measured segments (for a fourth-class group the paper's four), and what they are made from.
struct Board<'a> {
    mechanism: &'a Mechanism,
    pose: &'a Pose,
    motion: &'a Motion,
    equations: &'a LoopEquations,
    matrix: DMatrix<f64>,
    /// How uncertain the crossings leave the elements of `matrix`.
    doubt: DMatrix<f64>,
    /// Contributions of known rates to the left sides: velocity, acceleration.
    known: [DVector<f64>; 2],
}

impl Board<'_> {
    /// Writes the equation of one leg: its rates times lengths along the cut line make up the measured segment.
    ///
    /// Eqs. 7, 8, 15, 16 of Quintero et al. (2011) with every length signed along the cut line, and Eqs. 35 to 38.
    fn equation(&mut self, row: usize, cut: &CutLine, point: &Special, size: f64) -> Option<()> {
        let e = cut.line.direction()?;
        let ray = quarter_turn(e);
        // The signed length from a joint to the special point, and how well it is known.
        let reach = |from: PointId| {
            let arm = point.crossing.vector_from(self.pose.point(from))?;
            let rounding = CROSSING_ROUNDINGS * UNIT_ROUNDOFF * (arm.norm() + size);
            Some((arm.dot(&e), rounding / point.crossing.sine().abs()))
        };
        match cut.kind {
            LegKind::Pin { outer } => self.turn(row, point.link, reach(outer)?),
            LegKind::Slider { outer, .. } => self.slide(row, outer, cut.leg.base, ray),
            LegKind::Pins { outer, inner } => {
                let arm = self.pose.arm(outer, inner).dot(&e);
                self.turn(row, cut.carrier, (arm, 0.0));
                self.turn(row, point.link, reach(inner)?);
            }
            LegKind::PinThenSlider { outer, inner } => {
                self.turn(row, cut.carrier, reach(outer)?);
                self.slide(row, inner, cut.carrier, ray);
            }
            LegKind::SliderThenPin { outer, inner } => {
                self.slide(row, outer, cut.leg.base, ray);
                self.turn(row, point.link, reach(inner)?);
            }
            LegKind::Sliders => return None,
        }
        Some(())
    }

    fn turn(&mut self, row: usize, link: BodyId, (length, doubt): (f64, f64)) {
        if let Some(unknown) = self.equations.spin_unknown(link) {
            self.matrix[(row, unknown)] += length;
            self.doubt[(row, unknown)] += doubt;
        } else {
            let body = self.motion.body(link);
            self.known[0][row] += body.omega * length;
            self.known[1][row] += body.alpha * length;
        }
    }

    fn slide(&mut self, row: usize, slider: SliderId, from: BodyId, ray: Vector) {
        if let Some(unknown) = self.equations.slide_unknown(slider) {
            self.matrix[(row, unknown)] += self.guide(slider, from).dot(&ray);
        }
    }

    /// The guide's direction, signed away from body `from`.
    fn guide(&self, slider: SliderId, from: BodyId) -> Vector {
        self.pose.guide(slider) * self.mechanism.slide_sign(slider, from)
    }

    /// The angular velocity of a body from the constructed rates, and a bound of its error.
    fn spin(&self, link: BodyId, first: &Solution) -> (f64, f64) {
        let known = |b: BodyId| self.motion.body(b).omega;
        let unknown = self.equations.spin_unknown(link);
        let omega = self.equations.spin(link, &first.rates, known);
        (omega, unknown.map_or(0.0, |u| first.errors[u]))
    }

    /// Adds to the start of a leg's normal part what driven sliders add to accelerations; bounds the error of that.
    fn slide_accelerations(&self, leg: &mut LegMeasure, first: &Solution) -> f64 {
        let mut doubt = 0.0;
        for measure in &mut leg.slides {
            let (omega, error) = self.spin(measure.slide.to, first);
            *measure = SlideMeasure::new(self.mechanism, self.pose, &measure.slide, omega);
            leg.acceleration_start += measure.acceleration;
            leg.acceleration_start += measure.coriolis;
            doubt += 2.0 * measure.velocity.norm() * error
                + 4.0 * UNIT_ROUNDOFF * (measure.acceleration.norm() + measure.coriolis.norm());
        }
        doubt
    }

    /// Where the rays of a leg start, in both plans.
    fn start(&self, cut: &CutLine) -> Option<LegMeasure> {
        let base: &BodyMotion = self.motion.body(cut.leg.base);
        let at = self.pose.point(cut.start()?);
        // The Coriolis parts follow when the rates are known.
        let slides = cut.slides.iter();
        let slides: Vec<SlideMeasure> =
            slides.map(|slide| SlideMeasure::new(self.mechanism, self.pose, slide, 0.0)).collect();
        let add = |sum: Vector, slide: &SlideMeasure| sum + slide.velocity;
        Some(LegMeasure {
            velocity_start: slides.iter().fold(base.velocity_at(at), add),
            slides,
            acceleration_start: base.acceleration_at(at),
            normal: Vector::zeros(),
            ray: quarter_turn(cut.line.direction()?),
            velocity: 0.0,
            acceleration: 0.0,
        })
    }

    /// The normal part of a leg from the constructed rates, and a bound of its error.
    fn normal(&self, cut: &CutLine, point: &Special, first: &Solution, size: f64) -> Option<(Vector, f64)> {
        let spin = |link: BodyId| self.spin(link, first);
        let rate = |slider: SliderId| {
            let unknown = self.equations.slide_unknown(slider);
            unknown.map_or((0.0, 0.0), |u| (first.rates[u], first.errors[u]))
        };
        let sine = point.crossing.sine().abs();
        let reach = |from: PointId| point.crossing.vector_from(self.pose.point(from));
        let centripetal = |arm: Vector, (omega, error): (f64, f64)| {
            let length = arm.norm();
            let rounding = CROSSING_ROUNDINGS * UNIT_ROUNDOFF * (length + size) / sine;
            let doubt = 2.0 * omega.abs() * error * length + omega * omega * rounding;
            (arm * -(omega * omega), doubt)
        };
        let coriolis = |slider: SliderId, from: BodyId, (omega, omega_error): (f64, f64)| {
            let (s, s_error) = rate(slider);
            let vector = quarter_turn(self.guide(slider, from)) * (2.0 * omega * s);
            let doubt = 2.0 * (omega.abs() * s_error + s.abs() * omega_error) + 4.0 * UNIT_ROUNDOFF * vector.norm();
            (vector, doubt)
        };
        let nothing = (Vector::zeros(), 0.0);
        let parts = match cut.kind {
            LegKind::Pin { outer } => [centripetal(reach(outer)?, spin(point.link)), nothing],
            LegKind::Slider { outer, .. } => [coriolis(outer, cut.leg.base, spin(cut.leg.base)), nothing],
            LegKind::Pins { outer, inner } => {
                let arm = self.pose.arm(outer, inner);
                [centripetal(arm, spin(cut.carrier)), centripetal(reach(inner)?, spin(point.link))]
            }
            LegKind::PinThenSlider { outer, inner } => {
                let omega = spin(cut.carrier);
                [centripetal(reach(outer)?, omega), coriolis(inner, cut.carrier, omega)]
            }
            LegKind::SliderThenPin { outer, inner } => {
                [coriolis(outer, cut.leg.base, spin(cut.leg.base)), centripetal(reach(inner)?, spin(point.link))]
            }
            LegKind::Sliders => [nothing; 2],
        };
        // All parts lie along the cut line; what rounding has left across it is dropped.
        let e = cut.line.direction()?;
        let normal = e * (parts[0].0 + parts[1].0).dot(&e);
        Some((normal, parts[0].1 + parts[1].1))
    }

    /// Solves the equations for the measured segments; `order` 0 for rates, 1 for their derivatives.
    ///
    /// By nalgebra's full elimination, so that not even the elimination is shared with the loop equations.
    fn solve(&self, sides: &Sides, order: usize) -> Option<Solution> {
        let right = &sides.value - &self.known[order];
        let solution = self.matrix.clone().full_piv_lu().solve(&right)?;
        let rounding = (self.known[order].abs() + right.abs()) * (8.0 * UNIT_ROUNDOFF);
        // Lengths along a cut line are products of three.
        let lengths = &self.doubt + self.matrix.abs() * (4.0 * UNIT_ROUNDOFF);
        let uncertain = lengths * solution.abs() + rounding + &sides.uncertain;
        let rates: Numbers = solution.iter().copied().collect();
        let errors =
            LinearSystem::new(self.matrix.clone())?.error_bound(&rates, right.as_slice(), uncertain.as_slice());
        let finite = rates.iter().chain(&errors).all(|x| x.is_finite());
        finite.then_some(Solution { rates, errors })
    }

    /// Compares with the motion from the loop equations.
    fn agreement(&self, group: &Group, size: f64, first: &Solution, second: Option<&Solution>) -> Agreement {
        let mut result = Agreement { difference: 0.0, allowed: 0.0 };
        for (order, solution) in [Some(first), second].into_iter().enumerate() {
            let Some(solution) = solution else { continue };
            let mut spins = Vec::new();
            for &link in &group.bodies {
                let (body, errors) = (self.motion.body(link), self.motion.errors[link.0]);
                let (rate, error) = match order {
                    0 => (body.omega, errors.omega),
                    _ => (body.alpha, errors.alpha),
                };
                if let Some(u) = self.equations.spin_unknown(link) {
                    spins.push((u, rate, error));
                }
            }
            let mut slides = Vec::new();
            for slider in (0..self.mechanism.sliders.len()).map(SliderId) {
                let slide = self.motion.slide(slider);
                let (rate, error) = match order {
                    0 => (slide.velocity, slide.velocity_error),
                    _ => (slide.acceleration, slide.acceleration_error),
                };
                if let Some(u) = self.equations.slide_unknown(slider) {
                    slides.push((u, rate, error));
                }
            }
            // One measure for both kinds: a slide rate counts as the rate at the mechanism's size.
            let spin_scale = spins.iter().fold(0.0, |m: f64, s| m.max(s.1.abs()));
            let slide_scale = slides.iter().fold(0.0, |m: f64, s| m.max(s.1.abs()));
            let scale = spin_scale.max(slide_scale / size);
            // Rates too small to have all their digits are zero but for rounding.
            if scale < f64::MIN_POSITIVE {
                continue;
            }
            let weighed = spins.iter().map(|s| (s, scale)).chain(slides.iter().map(|s| (s, scale * size)));
            for (&(unknown, rate, error), scale) in weighed {
                let difference = (solution.rates[unknown] - rate).abs() / scale;
                let allowed = (solution.errors[unknown] + error) / scale;
                // A rate may be that much smaller than its rounding; what is not a number, of no size at all, is no difference.
                let finite = |x: f64| if x == f64::INFINITY { f64::MAX } else { x };
                result.difference = result.difference.max(finite(difference));
                result.allowed = result.allowed.max(finite(allowed));
            }
        }
        result
    }
}
