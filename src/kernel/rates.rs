use super::close::{Sides, factor};
use super::compile::{Action, Chain, Closing, InputKind, Placing, Unknown};
use super::{Block, Kernel};
use crate::geometry::{Pairs, lane, quarter_turn, set_lane};

impl Kernel {
    /// Sets the rates of a drive: angular velocity and acceleration, or speed and acceleration along the guide.
    pub fn set_rates<const N: usize>(
        &self,
        block: &mut Block<N>,
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
        (*rates, *seconds) = ([rate; N], [second; N]);
    }

    /// All velocities and accelerations at assembled positions, from the rates of the drives.
    pub fn rates<const N: usize>(&self, block: &mut Block<N>) {
        for action in &self.actions {
            match action {
                Action::Place(placing) => carry(block, placing),
                Action::Close(closing) => solve(block, closing),
            }
        }
    }
}

/// The rates of a point from those of the one that it was placed from.
fn carry<const N: usize>(block: &mut Block<N>, placing: &Placing) {
    let velocities = block.point_velocities[placing.from];
    let accelerations = block.point_accelerations[placing.from];
    let reach = &block.reaches[placing.reach];
    let (omegas, alphas) = (&block.omegas[placing.class], &block.alphas[placing.class]);
    let velocity = &mut block.point_velocities[placing.to];
    let acceleration = &mut block.point_accelerations[placing.to];
    for i in 0..N {
        let (r, omega) = (lane(reach, i), omegas[i]);
        let arm = quarter_turn(r);
        set_lane(velocity, i, lane(&velocities, i) + arm * omega);
        let second = arm * alphas[i] - r * (omega * omega);
        set_lane(acceleration, i, lane(&accelerations, i) + second);
    }
    if let Some((slider, direction)) = placing.slide {
        let turn = &block.turns[placing.class];
        let (speeds, seconds) = (&block.speeds[slider], &block.accelerations[slider]);
        for i in 0..N {
            let u = super::block::turned(turn, direction, i);
            let coriolis = quarter_turn(u) * (2.0 * omegas[i] * speeds[i]);
            set_lane(velocity, i, lane(velocity, i) + u * speeds[i]);
            let second = u * seconds[i] + coriolis;
            set_lane(acceleration, i, lane(acceleration, i) + second);
        }
    }
}

/// The rates of a group, by its equations.
fn solve<const N: usize>(block: &mut Block<N>, closing: &Closing) {
    let factored = factor(block, closing);
    let sides: Sides<N> = closing
        .chains
        .iter()
        .map(|c| velocity_side(block, c))
        .collect();
    let rates = factored.solve(&sides, closing.unknowns.len());
    for (unknown, rate) in closing.unknowns.iter().zip(&rates) {
        match *unknown {
            Unknown::Spin(class) => block.omegas[class] = *rate,
            Unknown::Slide(slider) => block.speeds[slider] = *rate,
        }
    }
    let sides: Sides<N> = closing
        .chains
        .iter()
        .map(|c| acceleration_side(block, c))
        .collect();
    let seconds = factored.solve(&sides, closing.unknowns.len());
    for (unknown, second) in closing.unknowns.iter().zip(&seconds) {
        match *unknown {
            Unknown::Spin(class) => block.alphas[class] = *second,
            Unknown::Slide(slider) => block.accelerations[slider] = *second,
        }
    }
}

/// `to` − `from`, or zero for a loop that closes on itself.
fn difference<const N: usize>(values: &[Pairs<N>], ends: Option<[usize; 2]>) -> Pairs<N> {
    let mut side = [[0.0; N]; 2];
    if let Some([start, end]) = ends {
        for axis in 0..2 {
            for i in 0..N {
                side[axis][i] = values[end][axis][i] - values[start][axis][i];
            }
        }
    }
    side
}

/// v_end − v_start − Σ ω J r of the members whose rotation is known − Σ ṡ u of the known slides.
fn velocity_side<const N: usize>(block: &Block<N>, chain: &Chain) -> Pairs<N> {
    let mut side = difference(&block.point_velocities, chain.ends);
    for member in &chain.members {
        if member.unknown.is_none() {
            let (arm, omegas) = (&block.arms[member.arm], &block.omegas[member.class]);
            for i in 0..N {
                let term = quarter_turn(lane(arm, i)) * omegas[i];
                let rest = lane(&side, i) - term;
                set_lane(&mut side, i, rest);
            }
        }
        for rail in member.rails.iter().filter(|r| r.unknown.is_none()) {
            let (guide, speeds) = (&block.rails[rail.rail], &block.speeds[rail.slider]);
            for i in 0..N {
                let rest = lane(&side, i) - lane(guide, i) * speeds[i];
                set_lane(&mut side, i, rest);
            }
        }
    }
    side
}

/// a_end − a_start + Σ ω² r − Σ 2 ω ṡ J u, and of known members and slides − Σ α J r − Σ s̈ u.
fn acceleration_side<const N: usize>(block: &Block<N>, chain: &Chain) -> Pairs<N> {
    let mut side = difference(&block.point_accelerations, chain.ends);
    for member in &chain.members {
        let (arm, omegas) = (&block.arms[member.arm], &block.omegas[member.class]);
        for i in 0..N {
            let sum = lane(&side, i) + lane(arm, i) * (omegas[i] * omegas[i]);
            set_lane(&mut side, i, sum);
        }
        if member.unknown.is_none() {
            let alphas = &block.alphas[member.class];
            for i in 0..N {
                let rest = lane(&side, i) - quarter_turn(lane(arm, i)) * alphas[i];
                set_lane(&mut side, i, rest);
            }
        }
        for rail in &member.rails {
            let (guide, speeds) = (&block.rails[rail.rail], &block.speeds[rail.slider]);
            for i in 0..N {
                let coriolis = quarter_turn(lane(guide, i)) * (2.0 * omegas[i] * speeds[i]);
                let rest = lane(&side, i) - coriolis;
                set_lane(&mut side, i, rest);
            }
            if rail.unknown.is_none() {
                let seconds = &block.accelerations[rail.slider];
                for i in 0..N {
                    let rest = lane(&side, i) - lane(guide, i) * seconds[i];
                    set_lane(&mut side, i, rest);
                }
            }
        }
    }
    side
}
