//! Kinegon's way through a fourth-class group with pins: its loop equations reduced to two, by `geometry::Reduced`, on any number.

use super::measure::{Pins, Rates};
use kinegon::geometry::{Number, Pair, Reduced};

/// Velocities and accelerations. Differences of positions and of input motions are taken in f64, as they are given; all else in
/// numbers of the kind that `number` makes.
pub fn rates<T: Number>(pins: &Pins, number: impl Fn(f64) -> T) -> Rates<T> {
    let [b, c, d, e, f, g] = pins.places;
    let arm = |[x, y]: [f64; 2], [z, w]: [f64; 2]| Pair { x: number(z - x), y: number(w - y) };
    let (bc, cd, ed) = (arm(b, c), arm(c, d), arm(e, d));
    let (bg, gf, ef) = (arm(b, g), arm(g, f), arm(e, f));
    // ω2 J BC + ω3 J CD − ω4 J ED = Δv, and the same by G, F with ω5.
    let column = |own: Pair<T>, second: Pair<T>, fourth: Pair<T>| {
        [own.quarter_turn(), second.quarter_turn(), -fourth.quarter_turn()]
    };
    let system = Reduced::new([column(cd, bc, ed), column(gf, bg, ef)]);
    let between = arm(pins.velocity[0], pins.velocity[1]);
    let inverse = number(1.0) / system.determinant();
    let omega = system.solve(inverse, [between; 2]);
    let [second, fourth, third, fifth] = omega.map(|w| w * w);
    let between = arm(pins.acceleration[0], pins.acceleration[1]);
    let sides = [between + bc * second + cd * third - ed * fourth, between + bg * second + gf * fifth - ef * fourth];
    let alpha = system.solve(inverse, sides);
    let known = |[x, y]: [f64; 2]| Pair { x: number(x), y: number(y) };
    let velocity = |from: usize, r: Pair<T>, link: usize| known(pins.velocity[from]) + r.quarter_turn() * omega[link];
    let squares = [second, fourth];
    let acceleration = |from: usize, r: Pair<T>, link: usize| {
        known(pins.acceleration[from]) + r.quarter_turn() * alpha[link] - r * squares[link]
    };
    let pair = |v: Pair<T>| [v.x, v.y];
    Rates {
        omega: [omega[0], omega[2], omega[1], omega[3]],
        alpha: [alpha[0], alpha[2], alpha[1], alpha[3]],
        velocity: [
            pair(velocity(0, bc, 0)),
            pair(velocity(1, ed, 1)),
            pair(velocity(1, ef, 1)),
            pair(velocity(0, bg, 0)),
        ],
        acceleration: [
            pair(acceleration(0, bc, 0)),
            pair(acceleration(1, ed, 1)),
            pair(acceleration(1, ef, 1)),
            pair(acceleration(0, bg, 0)),
        ],
    }
}
