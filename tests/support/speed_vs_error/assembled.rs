//! Positions from lengths by Newton's method on the equations of all joints, in numbers of any kind: in 256 bits the truth, in f64 what
//! a general program for mechanisms does. Nothing here uses the library's loops.
//!
//! Given are the coordinates that links have in their own frames, as the library has them from the scene's lengths, the ground's points,
//! and one drive's angle. Of each link the place of its frame and the direction of its x axis are looked for.

use super::joints::{Given, JointEquations, Real, Vector, dot, exactly, minus, plus, scaled, turned};
use super::truth::{Precise, Truth, rounded};
use kinegon::mechanism::{BodyId, JointId, Mechanism, Role};
use kinegon::position::Pose;
use nalgebra::{DMatrix, DVector};

/// Most Newton steps; from a position in f64 the reference takes six, as its matrix has the digits of f64.
const STEPS: usize = 40;

/// What an assembly asks of its numbers, beside [`Real`].
pub trait Digits: Real {
    /// The nearest f64.
    fn nearest(&self) -> f64;

    /// The direction of an angle in degrees.
    fn direction(degrees: f64) -> Vector<Self>;

    /// A correction of this part of the mechanism's size ends Newton's method.
    const LAST: f64;
}

impl Digits for f64 {
    fn nearest(&self) -> f64 {
        *self
    }

    fn direction(degrees: f64) -> Vector<f64> {
        let (sine, cosine) = libm::sincos(degrees.to_radians());
        [cosine, sine]
    }

    /// After a correction of 1e-9 the next one would be lost in rounding.
    const LAST: f64 = 1e-9;
}

impl Digits for Precise {
    fn nearest(&self) -> f64 {
        rounded(self)
    }

    /// By the series of exp(iφ) for the 2^−40th part of the angle, squared 40 times.
    fn direction(degrees: f64) -> Vector<Precise> {
        let number = |x: f64| <Precise as Real>::exactly(x);
        let part = number(degrees) * pi() / number(180.0 * 1_099_511_627_776.0);
        let mut term = exactly([1.0, 0.0]);
        let mut sum: Vector<Precise> = term.clone();
        for k in 1..12 {
            term = scaled(turned(term), &(part.clone() / number(f64::from(k))));
            sum = plus(sum, term.clone());
        }
        (0..40).fold(sum, |sum, _| times(&sum, &sum))
    }

    const LAST: f64 = 1e-50;
}

/// π by Machin's formula.
fn pi() -> Precise {
    let number = |x: f64| <Precise as Real>::exactly(x);
    let arctangent = |n: f64| {
        let mut power = number(1.0) / number(n);
        let mut sum = power.clone();
        for k in 1..120 {
            power = -(power / number(n * n));
            sum += power.clone() / number(f64::from(2 * k + 1));
        }
        sum
    };
    number(16.0) * arctangent(5.0) - number(4.0) * arctangent(239.0)
}

/// The product of two directions as complex numbers: one turned by the angle of the other.
fn times<T: Real>([a, b]: &Vector<T>, [c, d]: &Vector<T>) -> Vector<T> {
    let [a, b, c, d] = [a, b, c, d].map(Clone::clone);
    [a.clone() * c.clone() - b.clone() * d.clone(), a * d + b * c]
}

/// A vector of nearly length 1 made of length 1.
fn unit<T: Real>(mut v: Vector<T>) -> Vector<T> {
    // Newton's method for the inverse root, without division.
    for _ in 0..8 {
        let excess = dot(v.clone(), v.clone()) * T::exactly(-0.5) + T::exactly(1.5);
        v = scaled(v, &excess);
    }
    v
}

/// Frames of all bodies of a mechanism that is given by lengths.
pub struct Assembly<'a, T> {
    mechanism: &'a Mechanism,
    /// By body: origin and direction of the x axis of its frame.
    frames: Vec<[Vector<T>; 2]>,
    /// By body: the number of the link, of those that are looked for.
    links: Vec<Option<usize>>,
}

impl<'a, T: Digits> Assembly<'a, T> {
    /// The assembly next to `pose`, with the driven links at these angles in degrees, by body; `None` where Newton's method
    /// does not end, or a joint is of another kind than a pin or an undriven slider.
    pub fn new(mechanism: &'a Mechanism, pose: &Pose, angle: impl Fn(BodyId) -> f64) -> Option<Self> {
        let known = mechanism.joints.iter().all(|j| j.angular.is_none() || j.slider.is_some())
            && mechanism.sliders.iter().all(|s| s.drive.is_none())
            && mechanism.bodies.iter().all(|b| matches!(b.role, Role::Ground | Role::Driver { .. } | Role::Member));
        if !known {
            return None;
        }
        let mut count = 0;
        let links = mechanism.bodies.iter().map(|body| {
            matches!(body.role, Role::Member).then(|| {
                count += 1;
                count - 1
            })
        });
        let links = links.collect();
        let frames = (0..mechanism.bodies.len()).map(|b| frame(mechanism, pose, BodyId(b), &angle)).collect();
        let mut assembly = Assembly { mechanism, frames, links };
        assembly.close(count, pose)?;
        Some(assembly)
    }

    /// Newton's method; the matrix in f64.
    fn close(&mut self, count: usize, pose: &Pose) -> Option<()> {
        let size = kinegon::geometry::span(pose.points.iter().copied());
        for _ in 0..STEPS {
            let mut matrix = DMatrix::zeros(3 * count, 3 * count);
            let gaps: Vec<T> = self.gaps(|row, column, value| matrix[(row, column)] += value);
            let right = DVector::from_iterator(gaps.len(), gaps.iter().map(|gap| -gap.nearest()));
            let step = matrix.lu().solve(&right)?;
            for (body, link) in self.links.iter().enumerate() {
                let Some(link) = link else { continue };
                let [origin, direction] = &mut self.frames[body];
                let [x, y, turn] = [0, 1, 2].map(|k| step[3 * link + k]);
                *origin = plus(origin.clone(), exactly([x, y]));
                *direction = unit(times(direction, &exactly([1.0, turn])));
            }
            let turns = (0..count).map(|link| step[3 * link + 2].abs() * size);
            let largest = turns.chain(step.iter().enumerate().filter(|(k, _)| k % 3 < 2).map(|(_, x)| x.abs()));
            if largest.fold(0.0, f64::max) <= T::LAST * size {
                return Some(());
            }
        }
        None
    }

    /// What is left of all joints' equations; puts their derivatives, row, column, value.
    fn gaps(&self, mut put: impl FnMut(usize, usize, f64)) -> Vec<T> {
        let mut gaps: Vec<T> = Vec::new();
        for (index, joint) in self.mechanism.joints.iter().enumerate() {
            let sides = joint.bodies;
            if sides.iter().all(|b| self.links[b.0].is_none()) {
                continue;
            }
            let row = gaps.len();
            let nearest = |v: &Vector<T>| [v[0].nearest(), v[1].nearest()];
            let mut derive = |row: usize, body: BodyId, along: [f64; 2], place: &Vector<T>, sign: f64| {
                let Some(link) = self.links[body.0] else { return };
                let arm = nearest(&minus(place.clone(), self.frames[body.0][0].clone()));
                put(row, 3 * link, sign * along[0]);
                put(row, 3 * link + 1, sign * along[1]);
                put(row, 3 * link + 2, sign * (along[1] * arm[0] - along[0] * arm[1]));
            };
            match joint.slider {
                None => {
                    let point = self.mechanism.joint_point(JointId(index));
                    let places = sides.map(|body| self.place(body, point.0));
                    for (body, sign) in sides.into_iter().zip([1.0, -1.0]) {
                        let place = &places[usize::from(sign < 0.0)];
                        derive(row, body, [1.0, 0.0], place, sign);
                        derive(row + 1, body, [0.0, 1.0], place, sign);
                    }
                    let [first, second] = places;
                    gaps.extend(minus(first, second));
                }
                Some(id) => {
                    let slider = self.mechanism.slider(id);
                    let ((through, along), turn) = (slider.line(), slider.turn());
                    let [on, link] = [slider.on, slider.link].map(|b| self.frames[b.0].clone());
                    // The sliding link keeps its angle to the guide.
                    let expected = times(&on[1], &unit(exactly([turn.re, turn.im])));
                    let off = dot(turned(expected), link[1].clone());
                    // Its point stays on the guide.
                    let guide = times(&on[1], &unit(exactly([along.x, along.y])));
                    let start = plus(on[0].clone(), times(&on[1], &exactly([through.x, through.y])));
                    let at = self.place(slider.link, slider.at.0);
                    let across = turned(guide);
                    let beside = dot(across.clone(), minus(at.clone(), start));
                    for (body, sign) in [(slider.link, 1.0), (slider.on, -1.0)] {
                        derive(row + 1, body, nearest(&across), &at, sign);
                    }
                    for (body, sign) in [(slider.link, 1.0), (slider.on, -1.0)] {
                        if let Some(link) = self.links[body.0] {
                            put(row, 3 * link + 2, sign);
                        }
                    }
                    gaps.extend([off, beside]);
                }
            }
        }
        gaps
    }

    /// The place of a body's point.
    fn place(&self, body: BodyId, point: usize) -> Vector<T> {
        let b = self.mechanism.body(body);
        let index = b.points.iter().position(|p| p.0 == point);
        let own = match &b.role {
            Role::Ground => self.mechanism.given[point],
            _ => index.map(|index| b.local[index]),
        };
        let own = own.expect("a joint lies on its bodies");
        let [origin, direction] = self.frames[body.0].clone();
        plus(origin, times(&direction, &exactly([own.x, own.y])))
    }

    /// Positions and known motions, for the equations of rates.
    pub fn given(&self) -> Given<T> {
        let bodies = || (0..self.mechanism.bodies.len()).map(BodyId);
        let points = (0..self.mechanism.points.len()).map(|point| {
            let holds = |b: &BodyId| self.mechanism.body(*b).points.iter().any(|p| p.0 == point);
            bodies().find(holds).map_or_else(|| exactly([0.0; 2]), |body| self.place(body, point))
        });
        let guides = self.mechanism.sliders.iter().map(|slider| {
            let (_, along) = slider.line();
            times(&self.frames[slider.on.0][1], &unit(exactly([along.x, along.y])))
        });
        Given::at(self.mechanism, points.collect(), guides.collect())
    }
}

/// Where a body's frame is: known, or about, as `pose` has it.
fn frame<T: Digits>(mechanism: &Mechanism, pose: &Pose, id: BodyId, angle: &impl Fn(BodyId) -> f64) -> [Vector<T>; 2] {
    let body = mechanism.body(id);
    let axis = pose.axes[id.0].map_or([1.0, 0.0], |axis| axis.normalize().into());
    match body.role {
        Role::Ground => [exactly([0.0; 2]), exactly([1.0, 0.0])],
        Role::Driver { pivot, .. } => {
            let direction = T::direction(angle(id));
            let own = body.points.iter().position(|p| *p == pivot).map_or_else(Default::default, |k| body.local[k]);
            let start = pose.point(pivot);
            let arm = times(&direction, &exactly([own.x, own.y]));
            [minus(exactly([start.x, start.y]), arm), direction]
        }
        _ => {
            let direction: Vector<T> = unit(exactly(axis));
            let at = |place: kinegon::geometry::Point, own: kinegon::geometry::Point| {
                minus(exactly([place.x, place.y]), times(&direction, &exactly([own.x, own.y])))
            };
            let start = body.points.first().zip(body.local.first());
            let slider = || mechanism.sliders.iter().enumerate().find(|(_, s)| s.on == id);
            let origin = match start {
                Some((point, own)) => at(pose.point(*point), *own),
                None => slider().map_or_else(
                    || exactly([0.0; 2]),
                    |(index, slider)| {
                        let (through, along) = slider.line();
                        let own = through + along * pose.slides[index].unwrap_or(0.0);
                        at(pose.point(slider.at), own)
                    },
                ),
            };
            [origin, direction]
        }
    }
}

/// How a mechanism truly moves with its driven links at these angles, in the assembly next to `pose`.
pub fn truth(mechanism: &Mechanism, pose: &Pose, angle: impl Fn(BodyId) -> f64) -> Option<Truth> {
    Truth::of(mechanism, Assembly::<Precise>::new(mechanism, pose, angle)?.given())
}

/// ω and α of all bodies as a general program has them: positions by Newton's method and rates, both from the equations of all joints
/// in f64, by nalgebra's LU.
pub fn general(mechanism: &Mechanism, pose: &Pose, angle: impl Fn(BodyId) -> f64) -> Option<Vec<[f64; 2]>> {
    let given = Assembly::<f64>::new(mechanism, pose, angle)?.given();
    general_at(mechanism, &given)
}

/// Rates by the equations of all joints, at given positions.
pub fn general_at(mechanism: &Mechanism, given: &Given<f64>) -> Option<Vec<[f64; 2]>> {
    let equations = JointEquations::new(mechanism);
    let mut matrix = DMatrix::zeros(equations.size(), equations.size());
    equations.matrix(given, |row, column, value: f64| matrix[(row, column)] += value);
    let factors = matrix.lu();
    let first = factors.solve(&DVector::from_vec(equations.velocity_sides(given)))?;
    let second = factors.solve(&DVector::from_vec(equations.acceleration_sides(given, first.as_slice())))?;
    let states = equations.states(given, first.as_slice(), second.as_slice());
    Some(states.iter().map(|state| [state.omega, state.alpha]).collect())
}
