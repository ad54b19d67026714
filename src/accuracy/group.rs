use super::bounds::{BodyErrors, Bounds, PlaceErrors, SlideErrors};
use crate::geometry::{LinearSystem, Numbers, UNIT_ROUNDOFF};
use crate::mechanism::{BodyId, Group, JointId, LoopEquations, LoopTerms, SlideRate, SliderId, Spin};
use crate::scene::GivenBy;

/// Gap left in a closed loop by rounding, in [`UNIT_ROUNDOFF`] times the mechanism's size; of a tie, times a radian.
const OPEN: f64 = 8.0;

/// Adds the bounds of a group; those of its outer bodies must be known.
///
/// With A the matrix of the loop equations, angles and slides found from lengths have errors of |A⁻¹| times the gaps
/// that rounding leaves in the loops. An arm r with an angle error t changes the velocity equations by |ω| |r| t and
/// the acceleration equations by (|α| + ω²) |r| t; errors of the outer joints' motions enter both directly. |A⁻¹| takes
/// these residuals to the rates.
pub(super) fn add_group_bounds(bounds: &mut Bounds<'_>, group: &Group) {
    let equations = LoopEquations::new(bounds.mechanism, group);
    let pose = bounds.pose;
    // `motion` has refused singular groups before.
    let Some(system) = equations.factored(&pose.points, &pose.guides) else {
        return;
    };
    let known = |bounds: &Bounds<'_>, of: fn(&BodyErrors) -> f64| {
        let errors = bounds.bodies.iter().map(of);
        errors.collect::<Vec<f64>>()
    };
    let turns = known(bounds, |b| b.turn);
    let propagation = ErrorPropagation { equations: &equations, system: &system };
    let positions = propagation.positions(bounds, &turns);
    let turn = |spin: Spin| of_spin(spin, &positions, &turns);
    let omegas = known(bounds, |b| b.omega);
    let velocities = propagation.velocities(bounds, &turn, &omegas);
    let alphas = known(bounds, |b| b.alpha);
    let accelerations = propagation.accelerations(bounds, &turn, [&omegas, &alphas], &velocities);

    for &link in &group.bodies {
        let rounding = bounds.motion.errors[link.0];
        let spin = equations.spin_of(link);
        bounds.bodies[link.0] = BodyErrors {
            turn: turn(spin),
            omega: rounding.omega + of_spin(spin, &velocities, &omegas),
            alpha: rounding.alpha + of_spin(spin, &accelerations, &alphas),
            ..BodyErrors::default()
        };
    }
    for slider in (0..bounds.slides.len()).map(SliderId) {
        if let Some(unknown) = equations.slide_unknown(slider) {
            let rounding = bounds.motion.slide(slider);
            bounds.slides[slider.0] = SlideErrors {
                position: positions[unknown],
                velocity: rounding.velocity_error + velocities[unknown],
                acceleration: rounding.acceleration_error + accelerations[unknown],
            };
        }
    }
    add_reference_bounds(bounds, group);
}

/// The value for an unknown rotation, or else for the body whose rotation is known.
fn of_spin(spin: Spin, unknowns: &[f64], bodies: &[f64]) -> f64 {
    match spin {
        Spin::Unknown(unknown) => unknowns[unknown],
        Spin::Known(body) => bodies[body.0],
    }
}

/// The sum of the inherited errors at both ends of a loop; zero for a loop that closes on itself.
fn ends(bounds: &Bounds<'_>, terms: &LoopTerms, of: fn(&PlaceErrors) -> f64) -> f64 {
    terms.ends.map_or(0.0, |[start, end]| {
        let at = |body: BodyId, point| of(&bounds.inherited_at(body, bounds.pose.point(point)));
        at(start, terms.first) + at(end, terms.last)
    })
}

/// Takes residuals of the loop equations to errors of the unknowns.
struct ErrorPropagation<'a> {
    equations: &'a LoopEquations,
    system: &'a LinearSystem,
}

impl ErrorPropagation<'_> {
    /// |A⁻¹| times the residuals: of each loop, equal for both components, and of each tie. A tie's residual is the sum
    /// of its weights times `any`, and for known rotations times `any` plus the error in `known`, by body.
    fn to_unknowns(&self, loops: impl Iterator<Item = f64>, any: f64, known: &[f64]) -> Numbers {
        let ties = self.equations.ties.iter().map(|terms| {
            let uncertain = terms.iter().map(|&(spin, weight)| match spin {
                Spin::Unknown(_) => weight.abs() * any,
                Spin::Known(body) => weight.abs() * (any + known[body.0]),
            });
            uncertain.sum()
        });
        let uncertain: Numbers = loops.flat_map(|x| [x, x]).chain(ties).collect();
        let zeros: Numbers = uncertain.iter().map(|_| 0.0).collect();
        self.system.error_bound(&zeros, &zeros, &uncertain)
    }

    /// Errors of the unknown angles and slides found from lengths; zero for a drawn configuration.
    fn positions(&self, bounds: &Bounds<'_>, turns: &[f64]) -> Numbers {
        let Bounds { mechanism, pose, .. } = bounds;
        let largest = pose.points.iter().flat_map(|p| [p.x.abs(), p.y.abs()]);
        let size = largest.fold(0.0, f64::max);
        let open = match mechanism.given_by {
            GivenBy::Lengths => OPEN * UNIT_ROUNDOFF,
            GivenBy::Drawing => 0.0,
        };
        let loops = self.equations.loops.iter().map(|terms| {
            let ends = ends(bounds, terms, |errors| errors.position);
            let arms = terms.arms.iter().map(|arm| match arm.spin {
                Spin::Unknown(_) => 0.0,
                Spin::Known(body) => pose.arm(arm.from, arm.to).norm() * turns[body.0],
            });
            open * size + ends + arms.sum::<f64>()
        });
        self.to_unknowns(loops, open, turns)
    }

    /// Errors of the velocity rates from inexact positions and outer motions.
    fn velocities(&self, bounds: &Bounds<'_>, turn: &dyn Fn(Spin) -> f64, omegas: &[f64]) -> Numbers {
        let Bounds { pose, motion, .. } = bounds;
        let loops = self.equations.loops.iter().map(|terms| {
            let ends = ends(bounds, terms, |errors| errors.velocity);
            let arms = terms.arms.iter().map(|arm| {
                let omega = self.rate(bounds, arm.spin)[0].abs();
                let known = match arm.spin {
                    Spin::Unknown(_) => 0.0,
                    Spin::Known(body) => omegas[body.0],
                };
                pose.arm(arm.from, arm.to).norm() * (omega * turn(arm.spin) + known)
            });
            let slides = terms.slides.iter();
            let slides = slides.map(|s| motion.slide(s.slider).velocity.abs() * turn(s.spin));
            ends + arms.sum::<f64>() + slides.sum::<f64>()
        });
        self.to_unknowns(loops, 0.0, omegas)
    }

    /// The same for the accelerations; `rates` are the errors found by [`Self::velocities`].
    fn accelerations(
        &self,
        bounds: &Bounds<'_>,
        turn: &dyn Fn(Spin) -> f64,
        [omegas, alphas]: [&[f64]; 2],
        rates: &[f64],
    ) -> Numbers {
        let Bounds { pose, motion, .. } = bounds;
        let loops = self.equations.loops.iter().map(|terms| {
            let ends = ends(bounds, terms, |errors| errors.acceleration);
            let arms = terms.arms.iter().map(|arm| {
                let [omega, alpha] = self.rate(bounds, arm.spin).map(f64::abs);
                let known = match arm.spin {
                    Spin::Unknown(_) => 0.0,
                    Spin::Known(body) => alphas[body.0],
                };
                let turned = (alpha + omega * omega) * turn(arm.spin);
                let squared = 2.0 * omega * of_spin(arm.spin, rates, omegas);
                pose.arm(arm.from, arm.to).norm() * (known + turned + squared)
            });
            let slides = terms.slides.iter().map(|s| {
                let omega = self.rate(bounds, s.spin)[0].abs();
                let slide = motion.slide(s.slider);
                let rate = slide.velocity.abs();
                let rate_error = match s.rate {
                    SlideRate::Unknown(unknown) => rates[unknown],
                    SlideRate::Driven(_) => 0.0,
                };
                let turned = (slide.acceleration.abs() + 2.0 * omega * rate) * turn(s.spin);
                let spin_error = of_spin(s.spin, rates, omegas);
                turned + 2.0 * (omega * rate_error + rate * spin_error)
            });
            ends + arms.sum::<f64>() + slides.sum::<f64>()
        });
        self.to_unknowns(loops, 0.0, alphas)
    }

    /// ω and α of a rotation in the loops.
    fn rate(&self, bounds: &Bounds<'_>, spin: Spin) -> [f64; 2] {
        let body = match spin {
            Spin::Unknown(unknown) => self.equations.link_of(unknown),
            Spin::Known(body) => Some(body),
        };
        let motion = body.map(|body| bounds.motion.body(body));
        motion.map_or([0.0; 2], |m| [m.omega, m.alpha])
    }
}

/// Adds the bounds of each link's reference point: the largest over all joints by which its motion may have been
/// computed.
fn add_reference_bounds(bounds: &mut Bounds<'_>, group: &Group) {
    let mechanism = bounds.mechanism;
    let mut unbounded = group.bodies.clone();
    let mut before = usize::MAX;
    while unbounded.len() < before {
        before = unbounded.len();
        let reached = |body: BodyId| !unbounded.contains(&body);
        let at = |body: BodyId| bounds.motion.body(body).at;
        let found = unbounded.iter().find_map(|&link| {
            let joints = (0..mechanism.joints.len()).map(JointId);
            let errors = joints.filter_map(|id| {
                let [a, b] = mechanism.joint(id).bodies;
                let other = if a == link { b } else { a };
                let joins = (a == link || b == link) && reached(other) && mechanism.joint(id).holds_places();
                let place = || bounds.pose.point(mechanism.joint_point(id));
                (joins && place() == at(link)).then(|| bounds.inherited_across(id, other))
            });
            let largest = errors.reduce(|a, b| PlaceErrors {
                position: a.position.max(b.position),
                velocity: a.velocity.max(b.velocity),
                acceleration: a.acceleration.max(b.acceleration),
            });
            Some((link, largest?))
        });
        if let Some((link, errors)) = found {
            bounds.bodies[link.0].place = errors;
            unbounded.retain(|&other| other != link);
        }
    }
}
