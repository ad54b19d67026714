use super::moving::State;
use super::places::Places;
use crate::geometry::{Ball, Pair};
use crate::mechanism::{AngularRate, AngularTerms, BodyId, LoopEquations, LoopTerms, SlideRate};
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

/// The right sides of the velocity equations; known bodies move as in `state`.
pub(super) fn velocity_sides(equations: &LoopEquations, places: &impl Places, state: &State) -> Sides {
    Sides {
        loops: equations.loops.iter().map(|terms| velocity_side(terms, places, state)).collect(),
        angular: equations.angular.iter().map(|terms| angular_side(terms, |body| state.body(body).omega)).collect(),
    }
}

/// The right sides of the acceleration equations; `rates` is the solution of the velocity equations.
pub(super) fn acceleration_sides(
    equations: &LoopEquations,
    places: &impl Places,
    state: &State,
    rates: &[Ball],
) -> Sides {
    Sides {
        loops: equations.loops.iter().map(|terms| acceleration_side(terms, places, state, rates)).collect(),
        angular: equations.angular.iter().map(|terms| angular_side(terms, |body| state.body(body).alpha)).collect(),
    }
}

/// The residuals of the equations for the unknowns `x`.
pub(super) fn residuals(equations: &LoopEquations, places: &impl Places, sides: &Sides, x: &[Ball]) -> Sides {
    let loops = equations.loops.iter().zip(&sides.loops);
    let angular = equations.angular.iter().zip(&sides.angular);
    Sides {
        loops: loops.map(|(terms, &side)| loop_residual(terms, places, side, x)).collect(),
        angular: angular.map(|(terms, &side)| angular_residual(terms, side, x)).collect(),
    }
}

/// side − Σ weight · rate with the unknowns `x`.
fn angular_residual(terms: &AngularTerms, side: Ball, x: &[Ball]) -> Ball {
    terms.iter().fold(side, |rest, &(rate, weight)| match rate {
        AngularRate::Unknown(unknown) => rest - x[unknown] * weight.into(),
        AngularRate::Known(_) => rest,
    })
}

/// The right side of a relation between angles: − Σ weight · rate of the bodies whose rotation is known.
fn angular_side(terms: &AngularTerms, rate_of: impl Fn(BodyId) -> Ball) -> Ball {
    terms.iter().fold(Ball::default(), |side, &(rate, weight)| match rate {
        AngularRate::Unknown(_) => side,
        AngularRate::Known(body) => side - rate_of(body) * weight.into(),
    })
}

/// side − Σ ω J r − Σ ṡ u with the unknowns `x`.
fn loop_residual(terms: &LoopTerms, places: &impl Places, side: Pair<Ball>, x: &[Ball]) -> Pair<Ball> {
    let mut rest = side;
    for arm in &terms.arms {
        if let AngularRate::Unknown(unknown) = arm.angular {
            let turned = places.arm(arm.from, arm.to).quarter_turn();
            rest = rest - turned * x[unknown];
        }
    }
    for slide in &terms.slides {
        if let SlideRate::Unknown(unknown) = slide.rate {
            rest = rest - places.guide(slide.slider) * (x[unknown] * slide.sign.into());
        }
    }
    rest
}

/// The right side of a loop's velocity equations: v_end − v_start − Σ ω J r − Σ ṡ u of known rotations and slides.
fn velocity_side(terms: &LoopTerms, places: &impl Places, state: &State) -> Pair<Ball> {
    let mut side = Pair::default();
    if let Some([start, end]) = terms.ends {
        let (first, last) = (places.place(terms.first), places.place(terms.last));
        let [start, end] = [start, end].map(|b| state.body(b));
        side = (end.velocity - start.velocity) + (end.swing(last) - start.swing(first));
    }
    for arm in &terms.arms {
        if let AngularRate::Known(body) = arm.angular {
            let turned = places.arm(arm.from, arm.to).quarter_turn();
            side = side - turned * state.body(body).omega;
        }
    }
    for slide in &terms.slides {
        if let SlideRate::Driven([speed, _]) = slide.rate {
            side = side - places.guide(slide.slider) * (places.given(speed) * slide.sign.into());
        }
    }
    side
}

/// The right side of a loop's acceleration equations: a_end − a_start + Σ ω² r − Σ 2 ω ṡ J u, and − Σ α J r − Σ s̈ u of
/// known rotations and slides.
fn acceleration_side(terms: &LoopTerms, places: &impl Places, state: &State, rates: &[Ball]) -> Pair<Ball> {
    let mut side = Pair::default();
    if let Some([start, end]) = terms.ends {
        let (first, last) = (places.place(terms.first), places.place(terms.last));
        let [start, end] = [start, end].map(|b| state.body(b));
        let turning = end.turning(last) - start.turning(first);
        side = (end.acceleration - start.acceleration) + turning;
    }
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
