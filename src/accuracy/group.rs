use super::bounds::{BodyErrors, Bounds, SlideErrors};
use crate::geometry::{LinearSystem, Numbers, UNIT_ROUNDOFF};
use crate::mechanism::{BodyId, Group, JointId, LoopEquations, SlideRate, SliderId, Spin};
use crate::scene::GivenBy;

/// Roundings, of the size of the mechanism, by which a loop closed from lengths may stay open; of a radian, by which an angle in a tie.
const OPEN: f64 = 8.0;

/// Adds the bounds of a group, whose outer bodies' are there.
///
/// With A the matrix of the loop equations, angles and slides found from lengths are uncertain by |A⁻¹| times what rounding leaves the
/// loops open. An arm r that is turned wrongly by t changes the velocity equations by |ω| |r| t and those of the acceleration by
/// (|α| + ω²) |r| t; a wrong motion of the outer joints enters both as it is. |A⁻¹| takes that to the rates.
pub(super) fn carry_group(bounds: &mut Bounds<'_>, group: &Group) {
    let equations = LoopEquations::new(bounds.mechanism, group);
    let pose = bounds.pose;
    // A group without a definite motion has been refused before.
    let Some(system) = equations.factored(&pose.points, &pose.guides) else {
        return;
    };
    let known = |bounds: &Bounds<'_>, of: fn(&BodyErrors) -> f64| {
        let errors = bounds.bodies.iter().map(of);
        errors.collect::<Vec<f64>>()
    };
    let turns = known(bounds, |b| b.turn);
    let spread = Spread { equations: &equations, system: &system };
    let places = spread.places(bounds, &turns);
    let turn = |spin: Spin| of_spin(spin, &places, &turns);
    let omegas = known(bounds, |b| b.omega);
    let rates = spread.velocities(bounds, &turn, &omegas);
    let alphas = known(bounds, |b| b.alpha);
    let seconds = spread.accelerations(bounds, &turn, [&omegas, &alphas], &rates);

    for &link in &group.bodies {
        let own = bounds.motion.errors[link.0];
        let spin = equations.spin_of(link);
        bounds.bodies[link.0] = BodyErrors {
            turn: turn(spin),
            omega: own.omega + of_spin(spin, &rates, &omegas),
            alpha: own.alpha + of_spin(spin, &seconds, &alphas),
            ..BodyErrors::default()
        };
    }
    for slider in (0..bounds.slides.len()).map(SliderId) {
        if let Some(unknown) = equations.slide_unknown(slider) {
            let own = bounds.motion.slide(slider);
            bounds.slides[slider.0] = SlideErrors {
                position: places[unknown],
                velocity: own.velocity_error + rates[unknown],
                acceleration: own.acceleration_error + seconds[unknown],
            };
        }
    }
    carry_places(bounds, group);
}

/// The element for an unknown rotation, or that of the body whose rotation is known.
fn of_spin(spin: Spin, unknowns: &[f64], bodies: &[f64]) -> f64 {
    match spin {
        Spin::Unknown(unknown) => unknowns[unknown],
        Spin::Known(body) => bodies[body.0],
    }
}

/// Takes what is uncertain in the loops to their unknowns.
struct Spread<'a> {
    equations: &'a LoopEquations,
    system: &'a LinearSystem,
}

impl Spread<'_> {
    /// |A⁻¹| times what is uncertain in each loop, the same for both of its equations, and in each tie: by `any` in every rotation, and by
    /// what is `known` of each body in those that are not looked for.
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

    /// How uncertain the unknown angles and slides are as found from lengths; not at all as drawn.
    fn places(&self, bounds: &Bounds<'_>, turns: &[f64]) -> Numbers {
        let Bounds { mechanism, pose, .. } = bounds;
        let largest = pose.points.iter().flat_map(|p| [p.x.abs(), p.y.abs()]);
        let size = largest.fold(0.0, f64::max);
        let open = match mechanism.given_by {
            GivenBy::Lengths => OPEN * UNIT_ROUNDOFF,
            GivenBy::Drawing => 0.0,
        };
        let loops = self.equations.loops.iter().map(|terms| {
            let ends = terms.ends.map_or(0.0, |[start, end]| {
                bounds.at(start, pose.point(terms.first)).position + bounds.at(end, pose.point(terms.last)).position
            });
            let arms = terms.arms.iter().map(|arm| match arm.spin {
                Spin::Unknown(_) => 0.0,
                Spin::Known(body) => pose.arm(arm.from, arm.to).norm() * turns[body.0],
            });
            open * size + ends + arms.sum::<f64>()
        });
        self.to_unknowns(loops, open, turns)
    }

    /// What inexact places and outer motions add to the errors of the rates.
    fn velocities(&self, bounds: &Bounds<'_>, turn: &dyn Fn(Spin) -> f64, omegas: &[f64]) -> Numbers {
        let Bounds { pose, motion, .. } = bounds;
        let loops = self.equations.loops.iter().map(|terms| {
            let ends = terms.ends.map_or(0.0, |[start, end]| {
                bounds.at(start, pose.point(terms.first)).velocity + bounds.at(end, pose.point(terms.last)).velocity
            });
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

    /// The same for the accelerations; `rates` are the errors that [`Self::velocities`] has found.
    fn accelerations(
        &self,
        bounds: &Bounds<'_>,
        turn: &dyn Fn(Spin) -> f64,
        [omegas, alphas]: [&[f64]; 2],
        rates: &[f64],
    ) -> Numbers {
        let Bounds { pose, motion, .. } = bounds;
        let loops = self.equations.loops.iter().map(|terms| {
            let ends = terms.ends.map_or(0.0, |[start, end]| {
                bounds.at(start, pose.point(terms.first)).acceleration
                    + bounds.at(end, pose.point(terms.last)).acceleration
            });
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

    /// ω and α of a rotation of the loops.
    fn rate(&self, bounds: &Bounds<'_>, spin: Spin) -> [f64; 2] {
        let body = match spin {
            Spin::Unknown(unknown) => self.equations.link_of(unknown),
            Spin::Known(body) => Some(body),
        };
        let motion = body.map(|body| bounds.motion.body(body));
        motion.map_or([0.0; 2], |m| [m.omega, m.alpha])
    }
}

/// Gives the place of each link's motion its bounds: over whichever joint it may have been reached, the largest.
fn carry_places(bounds: &mut Bounds<'_>, group: &Group) {
    let mechanism = bounds.mechanism;
    let mut waiting = group.bodies.clone();
    let mut before = usize::MAX;
    while waiting.len() < before {
        before = waiting.len();
        let reached = |body: BodyId| !waiting.contains(&body);
        let at = |body: BodyId| bounds.motion.body(body).at;
        let found = waiting.iter().find_map(|&link| {
            let joints = (0..mechanism.joints.len()).map(JointId);
            let errors = joints.filter_map(|id| {
                let [a, b] = mechanism.joint(id).bodies;
                let other = if a == link { b } else { a };
                let joins = (a == link || b == link) && reached(other) && mechanism.joint(id).holds_places();
                let place = || bounds.pose.point(mechanism.joint_point(id));
                (joins && place() == at(link)).then(|| bounds.across(id, other))
            });
            let largest = errors.reduce(|a, b| super::bounds::PlaceErrors {
                position: a.position.max(b.position),
                velocity: a.velocity.max(b.velocity),
                acceleration: a.acceleration.max(b.acceleration),
            });
            Some((link, largest?))
        });
        if let Some((link, errors)) = found {
            bounds.bodies[link.0].place = errors;
            waiting.retain(|&other| other != link);
        }
    }
}
