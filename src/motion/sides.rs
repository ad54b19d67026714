use super::moving::{BoundedMotion, State};
use super::places::Places;
use crate::geometry::{Ball, Pair};
use crate::mechanism::{AngularRate, AngularTerms, LoopEquations, LoopTerms, SlideRate};
use smallvec::SmallVec;

/// A number for each unknown of a group.
pub(super) type Balls = SmallVec<[Ball; 4]>;

/// Right sides of the equations, or residuals: a vector for each loop, a number for each relation between angles.
#[derive(Clone, Debug)]
pub(super) struct Sides {
    loops: SmallVec<[Pair<Ball>; 2]>,
    angular: SmallVec<[Ball; 1]>,
}

impl Sides {
    /// The components of all loops, then of all relations between angles: the order of the equations.
    pub fn numbers(&self) -> impl Iterator<Item = Ball> {
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
        SlideRate::Driven([speed, _]) => Some(places.given(speed)),
        SlideRate::Unknown(_) => None,
    };
    let side = |terms: &LoopTerms| {
        let ends = between_ends(terms, places, state, |body, place| [body.velocity, body.swing(place)]);
        less_rates(terms, places, ends, omega, speed)
    };
    Sides {
        loops: equations.loops.iter().map(side).collect(),
        angular: equations.angular.iter().map(|terms| less_angular(terms, Ball::default(), omega)).collect(),
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
        angular: equations.angular.iter().map(|terms| less_angular(terms, Ball::default(), alpha)).collect(),
    }
}

/// What the unknowns `x` leave of the equations with these right sides.
pub(super) fn residuals(equations: &LoopEquations, places: &impl Places, sides: &Sides, x: &[Ball]) -> Sides {
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
        angular: angular.map(|(terms, &side)| less_angular(terms, side, angular_rate)).collect(),
    }
}

/// side − Σ weight · rate, of those rates that `rate_of` gives.
fn less_angular(terms: &AngularTerms, side: Ball, rate_of: impl Fn(AngularRate) -> Option<Ball>) -> Ball {
    terms.iter().fold(side, |side, &(rate, weight)| rate_of(rate).map_or(side, |x| side - x * weight.into()))
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
            side = side - places.guide(slide.slider) * (speed * slide.sign.into());
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
        let u = places.guide(slide.slider) * slide.sign.into();
        let rate = match slide.rate {
            SlideRate::Unknown(unknown) => rates[unknown],
            SlideRate::Driven([speed, acceleration]) => {
                side = side - u * places.given(acceleration);
                places.given(speed)
            }
        };
        side = side - u.quarter_turn() * (omega(slide.angular) * rate).twice();
    }
    side
}
