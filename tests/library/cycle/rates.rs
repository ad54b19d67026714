//! Rates on a path against two judges: the loop equations solved anew at the path's positions, and differences of its positions.

use super::{U, followed, posed, scenes};
use kinegon::Order;
use kinegon::cycle::{Path, Position};
use kinegon::geometry::span;
use kinegon::mechanism::{BodyId, Mechanism, Role, SliderId};
use kinegon::motion::motion;
use kinegon::quantity::State;
use std::f64::consts::{PI, TAU};
use support::exact::exceeds;

/// Halving the step of central differences quarters their error, within this part.
const ORDER_WITHIN: f64 = 0.02;

/// Second rates of all drives over their first ones.
const FACTOR: f64 = 0.7;

/// Values of the drive at which a path is looked at, away from its ends by this part of it.
fn values(path: &Path, count: usize, margin: f64) -> Vec<f64> {
    let [low, high] = [path.low(), path.high()];
    let part = |k: usize| margin + (1.0 - 2.0 * margin) * k as f64 / (count - 1) as f64;
    (0..count).map(|k| low + (high - low) * part(k)).collect()
}

/// The two routes have nothing in common but the position. The second is right to the last digit there; the first, of plain f64, may
/// differ by what rounding of positions does too. Near a dead centre of a rate that vanishes that is nothing; here what is left is
/// rounding of the fastest rate.
#[test]
fn they_solve_the_loop_equations() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let path = followed(&mechanism, &pose);
        let mut walker = path.walker();
        let mut worst: f64 = 0.0;
        for value in values(&path, 721, 1e-6) {
            let position = walker.position(value).expect("it is on the path");
            let pose = position.pose();
            let other = motion(&mechanism, &pose, Order::Acceleration).expect("it is regular");
            // A group's errors are enlarged by its condition, and by those of the groups on which it hangs.
            let condition: f64 = other.conditions.iter().product();
            let fastest = [0, 1].map(|order| {
                let links = mechanism.links().map(|(id, _)| position.angular_rates(id)[order]);
                links.fold(0.0, |fastest: f64, rate| fastest.max(rate.abs()))
            });
            let largest = [fastest[0], fastest[1].max(fastest[0] * fastest[0])];
            let mut check = |own: [f64; 2], others: [f64; 2], arm: f64| {
                for (order, other) in others.into_iter().enumerate() {
                    let off = (own[order] - other).abs();
                    let allowed = 8.0 * U * condition.powi(order as i32 + 1) * largest[order] * arm;
                    assert!(
                        !exceeds(off, allowed),
                        "{name} at {value}: {} and {other} differ by {off:e}, allowed is {allowed:e}",
                        own[order]
                    );
                    worst = worst.max(off / allowed.max(f64::MIN_POSITIVE));
                }
            };
            for (id, _) in mechanism.links() {
                let body = other.body(id);
                check(position.angular_rates(id), [body.omega, body.alpha], 1.0);
            }
            let size = span(pose.points.iter().copied());
            for id in (0..mechanism.sliders.len()).map(SliderId) {
                let slide = other.slide(id);
                check(position.slide_rates(id), [slide.velocity, slide.acceleration], size);
            }
        }
        println!("{name}: differences up to {worst:.2} of what is allowed");
    }
}

/// Angles of all links in radians, then positions of all sliders and coordinates of all points, on each body that has them;
/// and their first and second derivatives.
fn quantities(position: &Position, mechanism: &Mechanism) -> Vec<[f64; 3]> {
    let links = mechanism.links().map(|(id, _)| {
        let axis = position.axis(id).expect("a link has one");
        let [omega, alpha] = position.angular_rates(id);
        [libm::atan2(axis.y, axis.x), omega, alpha]
    });
    let sliders = (0..mechanism.sliders.len()).map(SliderId).map(|id| {
        let place = position.slide_position(id).expect("it has one");
        let [speed, second] = position.slide_rates(id);
        [place, speed, second]
    });
    let bodies = mechanism.bodies.iter().enumerate();
    let points = bodies.flat_map(|(id, body)| {
        body.points.iter().flat_map(move |&point| {
            let place = position.place(point);
            let [velocity, acceleration] = position.motion_at(BodyId(id), place);
            [0, 1].map(|axis| [place[axis], velocity[axis], acceleration[axis]])
        })
    });
    links.chain(sliders).chain(points).collect()
}

/// The mechanism with second rates of its drives in one proportion to the first, so that they stay on the path as they run;
/// and its first drive's rate.
fn proportional(mechanism: &Mechanism) -> (Mechanism, f64) {
    let mut changed = mechanism.clone();
    let mut first = None;
    let turned = changed.bodies.iter_mut();
    let turned = turned.filter_map(|body| match &mut body.role {
        Role::Driver { omega, alpha, .. } => Some((omega, alpha, 1_f64.to_degrees())),
        _ => None,
    });
    let pushed = changed.sliders.iter_mut();
    let pushed = pushed.filter_map(|slider| slider.drive.as_mut());
    let pushed = pushed.map(|drive| (&mut drive.speed, &mut drive.acceleration, 1.0));
    for (rate, second, unit) in turned.chain(pushed) {
        *second = FACTOR * *rate;
        first.get_or_insert(*rate * unit);
    }
    (changed, first.expect("it is driven"))
}

/// Central differences over a whole cycle: halving their step quarters the largest error of each quantity's first and second
/// derivative.
#[test]
fn they_are_derivatives_of_positions() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let (mechanism, rate) = proportional(&mechanism);
        let path = followed(&mechanism, &pose);
        let mut walker = path.walker();
        let mut at = |value: f64| {
            let position = walker.position(value).expect("it is on the path");
            quantities(&position, &mechanism)
        };
        let links = mechanism.links().count();
        let mut errors = vec![[[0.0_f64; 2]; 3]; at(path.low()).len()];
        // A margin keeps differences away from limits, where there are no derivatives.
        let step = 3e-3 * (path.high() - path.low()) / rate.abs();
        let mut rounding = [0.0_f64; 2];
        for value in values(&path, 241, 0.05) {
            let now = at(value);
            for (fineness, part) in [1.0, 0.5, 0.25].into_iter().enumerate() {
                let time = step * part;
                let moved = |t: f64| value + rate * t * (1.0 + 0.5 * FACTOR * t);
                let [before, after] = [-time, time].map(|t| at(moved(t)));
                for (index, errors) in errors.iter_mut().enumerate() {
                    let [a, b, c] = [&before, &now, &after].map(|q| q[index]);
                    // Angles may pass from 180° to −180°.
                    let short = |d: f64| match index < links && d.abs() > PI {
                        true => d - TAU.copysign(d),
                        false => d,
                    };
                    let (back, on) = (short(b[0] - a[0]), short(c[0] - b[0]));
                    let differences = [(on + back) / (2.0 * time), (on - back) / (time * time)];
                    for order in 0..2 {
                        let off = (differences[order] - b[1 + order]).abs();
                        errors[fineness][order] = errors[fineness][order].max(off);
                    }
                    let noise = 4.0 * U * b[0].abs().max(1.0) / time;
                    rounding = [rounding[0].max(noise), rounding[1].max(noise / time)];
                }
            }
        }
        let mut seen = 0;
        for (index, errors) in errors.iter().enumerate() {
            for order in 0..2 {
                let [coarse, middle, fine] = errors.map(|error| error[order]);
                // What stands still or runs evenly has no error but rounding.
                if coarse < 1600.0 * rounding[order] {
                    continue;
                }
                seen += 1;
                for ratio in [coarse / middle, middle / fine] {
                    assert!(
                        (ratio / 4.0 - 1.0).abs() < ORDER_WITHIN,
                        "{name}: quantity {index}, derivative {}: {coarse:e}, {middle:e}, {fine:e}",
                        order + 1
                    );
                }
            }
        }
        println!("{name}: {seen} of {} derivatives", 2 * errors.len());
        assert!(seen >= 4);
    }
}
