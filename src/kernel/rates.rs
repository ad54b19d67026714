use super::action::{Action, Chain, Closing, InputKind, Placing, Reducible, Reducing, Unknown};
use super::solve::{factor, general_systems, solve_general};
use super::{Block, Kernel, Single};
use crate::geometry::{Lanes, Many, Number, OneByOne, Pair, Registers, Row, TOGETHER, portions};
use fearless_simd::{Level, dispatch};

impl Kernel {
    /// Sets the rates of a drive: angular velocity and acceleration, in rad, or velocity and acceleration along the
    /// guide.
    #[inline(always)]
    pub fn set_rates<R: Row>(&self, block: &mut Block<R>, input: usize, rate: f64, second: f64) {
        let (rates, seconds) = match self.inputs[input].kind {
            InputKind::Turning { class } => (&mut block.omegas[class], &mut block.alphas[class]),
            InputKind::Sliding { slider } => (&mut block.speeds[slider], &mut block.accelerations[slider]),
        };
        (*rates, *seconds) = (R::splat(rate), R::splat(second));
    }

    /// Computes all velocities and accelerations at assembled positions, from the rates of the drives.
    pub fn rates(&self, block: &mut Single) {
        rates(&self.actions, block);
    }

    /// As [`Self::rates`], for many positions in the widest registers of the processor.
    pub fn rates_many(&self, registers: Level, block: &mut Block<Many>) {
        rates_many(&self.actions, registers, block);
    }
}

/// The rates that these actions give.
#[inline(never)]
pub(super) fn rates(actions: &[Action], block: &mut Single) {
    rates_in(OneByOne, actions, block);
}

#[inline(never)]
pub(super) fn rates_many(actions: &[Action], registers: Level, block: &mut Block<Many>) {
    dispatch!(registers, simd => rates_in(Registers::<_, TOGETHER>(simd), actions, block));
}

#[inline(always)]
fn rates_in<L: Lanes, R: Row>(lanes: L, actions: &[Action], block: &mut Block<R>) {
    for action in actions {
        match action {
            Action::Place(placing) => point_rates(lanes, block, placing),
            Action::Close(closing) => group_rates(lanes, block, closing),
        }
    }
}

/// Computes velocity and acceleration of a placed point from those of the earlier point.
#[inline(always)]
pub(super) fn point_rates<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, placing: &Placing) {
    let Block { reaches, omegas, alphas, point_velocities, point_accelerations, .. } = block;
    let reach = &reaches[placing.reach];
    let (omegas, alphas) = (&omegas[placing.class], &alphas[placing.class]);
    let ends = [placing.from, placing.to];
    let velocities = point_velocities.get_disjoint_mut(ends);
    let [from_velocity, velocity] = velocities.expect("a point is placed from another one");
    let accelerations = point_accelerations.get_disjoint_mut(ends);
    let [from_acceleration, acceleration] = accelerations.expect("a point is placed from another one");
    for k in portions::<L, R>() {
        let reach = lanes.pair(reach, k);
        let (omega, alpha) = (lanes.load(omegas, k), lanes.load(alphas, k));
        let moved = lanes.pair(from_velocity, k).plus_turned(reach, omega);
        lanes.store_pair(velocity, k, moved);
        let moved = lanes.pair(from_acceleration, k);
        let moved = moved.minus_scaled(reach, omega * omega);
        lanes.store_pair(acceleration, k, moved.plus_turned(reach, alpha));
    }
    let Some(slider) = placing.slide else {
        return;
    };
    let (turn, way) = (&block.turns[placing.class], &block.lengths.guides[placing.reach]);
    let (speeds, seconds) = (&block.speeds[slider], &block.accelerations[slider]);
    for k in portions::<L, R>() {
        let way = lanes.pair(turn, k).turn(lanes.pair(way, k));
        let (omega, speed) = (lanes.load(omegas, k), lanes.load(speeds, k));
        let slid = lanes.pair(velocity, k).plus_scaled(way, speed);
        lanes.store_pair(velocity, k, slid);
        let slid = lanes.pair(acceleration, k);
        let slid = slid.plus_scaled(way, lanes.load(seconds, k));
        let coriolis = omega * (speed + speed);
        lanes.store_pair(acceleration, k, slid.plus_turned(way, coriolis));
    }
}

/// Solves a group's equations for its velocities, then for its accelerations.
#[inline(always)]
fn group_rates<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    match &closing.reduced {
        Some(Reducing::One(equations)) => reduced_rates(lanes, block, closing, equations),
        // The columns of two loops fill the registers once.
        Some(Reducing::Two(equations)) => reduced_rates(lanes.narrow(), block, closing, equations),
        None => general_rates(lanes, block, closing),
    }
}

/// Those of a group that reduces, each portion in registers.
#[inline(always)]
fn reduced_rates<L: Lanes, R: Row, const LOOPS: usize>(
    lanes: L,
    block: &mut Block<R>,
    closing: &Closing,
    equations: &Reducible<LOOPS>,
) {
    let Block { columns, systems, omegas, alphas, speeds, accelerations, .. } = block;
    let chains: &[Chain; LOOPS] = closing.chains.first_chunk().expect("as many loops");
    let zero = lanes.splat(0.0);
    for k in portions::<L, R>() {
        let (system, inverse) = factor(lanes, k, equations, columns, &mut systems[closing.group]);
        let mut sides = [Pair { x: zero, y: zero }; LOOPS];
        for index in 0..LOOPS {
            sides[index] = chains[index].velocity_side(lanes, k, &block.point_velocities, columns, omegas, speeds);
        }
        let rates = system.solve(inverse, sides);
        for (index, rate) in rates.into_iter().enumerate().take(2 * LOOPS) {
            let row = match closing.unknowns[index] {
                Unknown::Spin(class) => &mut omegas[class],
                Unknown::Slide(slider) => &mut speeds[slider],
            };
            lanes.store(row, k, rate);
        }
        for index in 0..LOOPS {
            let difference = chains[index].difference(lanes, k, &block.point_accelerations);
            sides[index] = chains[index].acceleration_side(
                lanes,
                k,
                difference,
                columns,
                [omegas, alphas],
                [speeds, accelerations],
            );
        }
        let seconds = system.solve(inverse, sides);
        for (index, rate) in seconds.into_iter().enumerate().take(2 * LOOPS) {
            let row = match closing.unknowns[index] {
                Unknown::Spin(class) => &mut alphas[class],
                Unknown::Slide(slider) => &mut accelerations[slider],
            };
            lanes.store(row, k, rate);
        }
    }
}

/// Those of any other group.
#[inline(always)]
fn general_rates<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    let Block { columns, omegas, speeds, .. } = block;
    for (chain, rows) in closing.chains.iter().zip(&mut block.sides) {
        for k in portions::<L, R>() {
            let side = chain.velocity_side(lanes, k, &block.point_velocities, columns, omegas, speeds);
            lanes.store_pair(rows, k, side);
        }
    }
    tie_sides(lanes, closing, &mut block.tie_sides, [omegas, speeds]);
    block.systems[closing.group].general = general_systems(columns, closing);
    solve_general(block, closing);
    for (unknown, rates) in closing.unknowns.iter().zip(&block.solution) {
        match *unknown {
            Unknown::Spin(class) => block.omegas[class] = *rates,
            Unknown::Slide(slider) => block.speeds[slider] = *rates,
        }
    }
    let Block { columns, omegas, alphas, speeds, accelerations, .. } = block;
    for (chain, rows) in closing.chains.iter().zip(&mut block.sides) {
        for k in portions::<L, R>() {
            let difference = chain.difference(lanes, k, &block.point_accelerations);
            let side =
                chain.acceleration_side(lanes, k, difference, columns, [omegas, alphas], [speeds, accelerations]);
            lanes.store_pair(rows, k, side);
        }
    }
    tie_sides(lanes, closing, &mut block.tie_sides, [alphas, accelerations]);
    solve_general(block, closing);
    for (unknown, seconds) in closing.unknowns.iter().zip(&block.solution) {
        match *unknown {
            Unknown::Spin(class) => block.alphas[class] = *seconds,
            Unknown::Slide(slider) => block.accelerations[slider] = *seconds,
        }
    }
}

impl Chain {
    /// v_end − v_start − Σ ω J r of the members whose rotation is known − Σ ṡ u of the known slides.
    #[inline(always)]
    fn velocity_side<L: Lanes, R: Row>(
        &self,
        lanes: L,
        k: usize,
        velocities: &[[R; 2]],
        columns: &[[R; 2]],
        omegas: &[R],
        speeds: &[R],
    ) -> Pair<L::Number> {
        let mut side = self.difference(lanes, k, velocities);
        if self.has_known {
            for member in self.members.iter().filter(|m| m.spin.is_none()) {
                let column = lanes.pair(&columns[member.column], k);
                side = side.minus_scaled(column, lanes.load(&omegas[member.class], k));
            }
            for rail in self.rails.iter().filter(|r| r.slide.is_none()) {
                let guide = lanes.pair(&columns[rail.column], k);
                side = side.minus_scaled(guide, lanes.load(&speeds[rail.slider], k));
            }
        }
        side
    }

    /// a_end − a_start + Σ ω² r − Σ 2 ω ṡ J u, and of known members and slides − Σ α J r − Σ s̈ u; the first difference
    /// is given.
    #[inline(always)]
    fn acceleration_side<L: Lanes, R: Row>(
        &self,
        lanes: L,
        k: usize,
        difference: Pair<L::Number>,
        columns: &[[R; 2]],
        [omegas, alphas]: [&[R]; 2],
        [speeds, accelerations]: [&[R]; 2],
    ) -> Pair<L::Number> {
        let mut side = difference;
        for member in &self.members {
            let (arm, omega) = (lanes.pair(&columns[member.column], k), lanes.load(&omegas[member.class], k));
            // A column is J r, and r = −J (J r).
            side = side.minus_turned(arm, omega * omega);
            if member.spin.is_none() {
                side = side.minus_scaled(arm, lanes.load(&alphas[member.class], k));
            }
        }
        for rail in &self.rails {
            let guide = lanes.pair(&columns[rail.column], k);
            let (omega, speed) = (lanes.load(&omegas[rail.class], k), lanes.load(&speeds[rail.slider], k));
            side = side.minus_turned(guide, omega * (speed + speed));
            if rail.slide.is_none() {
                side = side.minus_scaled(guide, lanes.load(&accelerations[rail.slider], k));
            }
        }
        side
    }
}

/// − Σ weight · rate of the classes whose rotation is known, and of known slides.
#[inline(always)]
fn tie_sides<L: Lanes, R: Row>(lanes: L, closing: &Closing, sides: &mut [R], [rates, speeds]: [&[R]; 2]) {
    for (tied, side) in closing.ties.iter().zip(sides) {
        for k in portions::<L, R>() {
            let known = tied.classes.iter().filter(|c| c.spin.is_none());
            let sum = known.fold(lanes.splat(0.0), |sum, c| {
                sum.minus_product(lanes.splat(c.weight), lanes.load(&rates[c.class], k))
            });
            let known = tied.slides.iter().filter(|s| s.slide.is_none());
            let sum =
                known.fold(sum, |sum, s| sum.minus_product(lanes.splat(s.weight), lanes.load(&speeds[s.slider], k)));
            lanes.store(side, k, sum);
        }
    }
}
