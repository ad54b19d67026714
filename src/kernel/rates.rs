use super::close::{differences, factor, solve};
use super::compile::{Action, Closing, InputKind, Placing, Unknown};
use super::{Block, Kernel};
use crate::geometry::Number;

impl Kernel {
    /// Sets the rates of a drive: angular velocity and acceleration, or speed and acceleration along the guide.
    #[inline(always)]
    pub fn set_rates<T: Number, const M: usize>(
        &self,
        block: &mut Block<T, M>,
        input: usize,
        rate: f64,
        second: f64,
    ) {
        let (rates, seconds) = match self.inputs[input].kind {
            InputKind::Turning { class } => (&mut block.omegas[class], &mut block.alphas[class]),
            InputKind::Sliding { slider } => {
                (&mut block.speeds[slider], &mut block.accelerations[slider])
            }
        };
        (*rates, *seconds) = ([T::splat(rate); M], [T::splat(second); M]);
    }

    /// All velocities and accelerations at assembled positions, from the rates of the drives.
    #[inline(always)]
    pub fn rates<T: Number, const M: usize>(&self, block: &mut Block<T, M>) {
        for action in &self.actions {
            match action {
                Action::Place(placing) => carry(block, placing),
                Action::Close(closing) => move_group(block, closing),
            }
        }
    }
}

/// The rates of a point from those of the one that it was placed from.
#[inline(always)]
fn carry<T: Number, const M: usize>(block: &mut Block<T, M>, placing: &Placing) {
    let reach = &block.reaches[placing.reach];
    let (omegas, alphas) = (&block.omegas[placing.class], &block.alphas[placing.class]);
    for k in 0..M {
        let (r, omega) = (reach[k], omegas[k]);
        let arm = r.quarter_turn();
        let mut velocity = block.point_velocities[placing.from][k] + arm * omega;
        let mut acceleration =
            block.point_accelerations[placing.from][k] + arm * alphas[k] - r * (omega * omega);
        if let Some((slider, direction)) = placing.slide {
            let u = block.turns[placing.class][k].turn(direction);
            let speed = block.speeds[slider][k];
            velocity = velocity + u * speed;
            acceleration = acceleration
                + u * block.accelerations[slider][k]
                + u.quarter_turn() * (omega * speed * 2.0);
        }
        block.point_velocities[placing.to][k] = velocity;
        block.point_accelerations[placing.to][k] = acceleration;
    }
}

/// The rates of a group, by its equations.
#[inline(always)]
fn move_group<T: Number, const M: usize>(block: &mut Block<T, M>, closing: &Closing) {
    factor(block, closing);
    velocity_sides(block, closing);
    solve(block, closing);
    for (unknown, rates) in closing.unknowns.iter().zip(&block.solution) {
        match *unknown {
            Unknown::Spin(class) => block.omegas[class] = *rates,
            Unknown::Slide(slider) => block.speeds[slider] = *rates,
        }
    }
    acceleration_sides(block, closing);
    solve(block, closing);
    for (unknown, seconds) in closing.unknowns.iter().zip(&block.solution) {
        match *unknown {
            Unknown::Spin(class) => block.alphas[class] = *seconds,
            Unknown::Slide(slider) => block.accelerations[slider] = *seconds,
        }
    }
}

/// v_end − v_start − Σ ω J r of the members whose rotation is known − Σ ṡ u of the known slides.
#[inline(always)]
fn velocity_sides<T: Number, const M: usize>(block: &mut Block<T, M>, closing: &Closing) {
    differences(&mut block.sides, &block.point_velocities, closing);
    for member in closing.members.iter().filter(|m| m.known) {
        let (arm, omegas) = (&block.arms[member.arm], &block.omegas[member.class]);
        let side = &mut block.sides[member.chain];
        for k in 0..M {
            side[k] = side[k] - arm[k].quarter_turn() * omegas[k];
        }
    }
    for rail in closing.rails.iter().filter(|r| r.known) {
        let (guide, speeds) = (&block.rails[rail.rail], &block.speeds[rail.slider]);
        let side = &mut block.sides[rail.chain];
        for k in 0..M {
            side[k] = side[k] - guide[k] * speeds[k];
        }
    }
}

/// a_end − a_start + Σ ω² r − Σ 2 ω ṡ J u, and of known members and slides − Σ α J r − Σ s̈ u.
#[inline(always)]
fn acceleration_sides<T: Number, const M: usize>(block: &mut Block<T, M>, closing: &Closing) {
    differences(&mut block.sides, &block.point_accelerations, closing);
    for member in &closing.members {
        let (arm, omegas) = (&block.arms[member.arm], &block.omegas[member.class]);
        let side = &mut block.sides[member.chain];
        for k in 0..M {
            side[k] = side[k] + arm[k] * (omegas[k] * omegas[k]);
        }
        if member.known {
            let alphas = &block.alphas[member.class];
            for k in 0..M {
                side[k] = side[k] - arm[k].quarter_turn() * alphas[k];
            }
        }
    }
    for rail in &closing.rails {
        let (guide, speeds) = (&block.rails[rail.rail], &block.speeds[rail.slider]);
        let (omegas, side) = (&block.omegas[rail.class], &mut block.sides[rail.chain]);
        for k in 0..M {
            side[k] = side[k] - guide[k].quarter_turn() * (omegas[k] * speeds[k] * 2.0);
        }
        if rail.known {
            let seconds = &block.accelerations[rail.slider];
            for k in 0..M {
                side[k] = side[k] - guide[k] * seconds[k];
            }
        }
    }
}
