use super::action::{Action, Chain, Closing, InputKind, Placing, Unknown};
use super::solve::solve;
use super::{Block, Kernel};
use crate::geometry::{Lanes, MANY, Number, Pair, Row, portions};
use std::marker::PhantomData;

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
    #[inline(always)]
    pub fn rates<L: Lanes, R: Row>(&self, lanes: L, block: &mut Block<R>) {
        for action in &self.actions {
            match action {
                Action::Place(placing) => point_rates(lanes, block, placing),
                Action::Close(closing) => group_rates(lanes, block, closing),
            }
        }
    }
}

/// Computes velocity and acceleration of a placed point from those of the earlier point.
#[inline(always)]
fn point_rates<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, placing: &Placing) {
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
    let Some((slider, _)) = placing.slide else {
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
    velocity_sides(lanes, block, closing);
    tie_sides(lanes, closing, &mut block.tie_sides, &block.omegas);
    solve::<_, _, true>(lanes, block, closing);
    for (unknown, rates) in closing.unknowns.iter().zip(&block.solution) {
        match *unknown {
            Unknown::Spin(class) => block.omegas[class] = *rates,
            Unknown::Slide(slider) => block.speeds[slider] = *rates,
        }
    }
    acceleration_sides(lanes, block, closing);
    tie_sides(lanes, closing, &mut block.tie_sides, &block.alphas);
    solve::<_, _, false>(lanes, block, closing);
    for (unknown, seconds) in closing.unknowns.iter().zip(&block.solution) {
        match *unknown {
            Unknown::Spin(class) => block.alphas[class] = *seconds,
            Unknown::Slide(slider) => block.accelerations[slider] = *seconds,
        }
    }
}

/// v_end − v_start − Σ ω J r of the members whose rotation is known − Σ ṡ u of the known slides.
#[inline(always)]
fn velocity_sides<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    for (chain, rows) in closing.chains.iter().zip(&mut block.sides) {
        let mut side = Side::new(lanes, chain, &block.point_velocities);
        if chain.has_known {
            side.subtract_known(chain, &block.columns, &block.omegas, &block.speeds);
        }
        side.store(rows);
    }
}

/// a_end − a_start + Σ ω² r − Σ 2 ω ṡ J u, and of known members and slides − Σ α J r − Σ s̈ u.
#[inline(always)]
fn acceleration_sides<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    for (chain, rows) in closing.chains.iter().zip(&mut block.sides) {
        let mut side = Side::new(lanes, chain, &block.point_accelerations);
        let (arms, guides) = chain.own(&block.columns);
        for (member, arm) in chain.members.iter().zip(arms) {
            side.add_normal(arm, &block.omegas[member.class]);
            if member.spin.is_none() {
                side.subtract(arm, &block.alphas[member.class]);
            }
        }
        for (rail, guide) in chain.rails.iter().zip(guides) {
            side.subtract_coriolis(guide, &block.omegas[rail.class], &block.speeds[rail.slider]);
            if rail.slide.is_none() {
                side.subtract(guide, &block.accelerations[rail.slider]);
            }
        }
        side.store(rows);
    }
}

/// − Σ weight · rate of the classes whose rotation is known.
#[inline(always)]
fn tie_sides<L: Lanes, R: Row>(lanes: L, closing: &Closing, sides: &mut [R], rates: &[R]) {
    for (tied, side) in closing.ties.iter().zip(sides) {
        for k in portions::<L, R>() {
            let known = tied.classes.iter().filter(|c| c.spin.is_none());
            let sum = known.fold(lanes.splat(0.0), |sum, c| {
                sum.minus_product(lanes.splat(c.weight), lanes.load(&rates[c.class], k))
            });
            lanes.store(side, k, sum);
        }
    }
}

/// The right side of a loop's two equations, during summation.
struct Side<L: Lanes, R> {
    lanes: L,
    sums: [Pair<L::Number>; MANY],
    rows: PhantomData<R>,
}

impl<L: Lanes, R: Row> Side<L, R> {
    /// The value at the loop's end less that at its start.
    #[inline(always)]
    fn new(lanes: L, chain: &Chain, values: &[[R; 2]]) -> Self {
        Side { lanes, sums: chain.difference(lanes, values), rows: PhantomData }
    }

    /// − c x of a column c with the rates x.
    #[inline(always)]
    fn subtract(&mut self, column: &[R; 2], rates: &R) {
        for k in portions::<L, R>() {
            let column = self.lanes.pair(column, k);
            self.sums[k] = self.sums[k].minus_scaled(column, self.lanes.load(rates, k));
        }
    }

    /// − c x of the members whose rotation is known and of the known slides.
    #[inline(always)]
    fn subtract_known(&mut self, chain: &Chain, columns: &[[R; 2]], omegas: &[R], speeds: &[R]) {
        let (arms, guides) = chain.own(columns);
        for (member, arm) in chain.members.iter().zip(arms) {
            if member.spin.is_none() {
                self.subtract(arm, &omegas[member.class]);
            }
        }
        for (rail, guide) in chain.rails.iter().zip(guides) {
            if rail.slide.is_none() {
                self.subtract(guide, &speeds[rail.slider]);
            }
        }
    }

    /// + ω² r; a column is J r, and r = −J (J r).
    #[inline(always)]
    fn add_normal(&mut self, column: &[R; 2], omegas: &R) {
        for k in portions::<L, R>() {
            let (column, omega) = (self.lanes.pair(column, k), self.lanes.load(omegas, k));
            self.sums[k] = self.sums[k].minus_turned(column, omega * omega);
        }
    }

    /// − 2 ω ṡ J u of a guide u.
    #[inline(always)]
    fn subtract_coriolis(&mut self, guide: &[R; 2], omegas: &R, speeds: &R) {
        for k in portions::<L, R>() {
            let (omega, speed) = (self.lanes.load(omegas, k), self.lanes.load(speeds, k));
            let guide = self.lanes.pair(guide, k);
            self.sums[k] = self.sums[k].minus_turned(guide, omega * (speed + speed));
        }
    }

    #[inline(always)]
    fn store(&self, rows: &mut [R; 2]) {
        for k in portions::<L, R>() {
            self.lanes.store_pair(rows, k, self.sums[k]);
        }
    }
}
