//! Positions computed together against the same one by one.

use super::{U, followed, posed, scenes};
use kinegon::Order;
use kinegon::geometry::{MANY, Row, Vector};
use kinegon::kernel::{Block, vector};
use kinegon::motion::motion;

/// Angles, slides, places and all rates are those of one position but for rounding; without places, those of links to the last bit.
#[test]
fn together_is_as_one_by_one() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let path = followed(&mechanism, &pose);
        // Away from limits, where the condition is what it is for all quantities alike.
        let (low, wide) = (path.low(), path.high() - path.low());
        let value = |i: usize| low + wide * (0.05 + 0.9 * i as f64 / 1000.0);
        let values: Vec<f64> = (0..1000).map(value).collect();
        let (mut many, mut bare) = (path.many_walker(), path.many_walker_without_places());
        let mut one = path.walker();
        let mut rest = values.as_slice();
        while let Some(first) = rest.first() {
            let (count, together) = many.motions(rest);
            let (same, alone) = bare.motions(rest);
            assert_eq!(count, same);
            assert!((1..=MANY.min(rest.len())).contains(&count), "{name} {count}");
            assert_eq!(together.is_some(), alone.is_some(), "{name} {first}");
            let (Some(together), Some(alone)) = (together, alone) else {
                assert!(rest[..count].iter().any(|v| one.motions(&[*v]).is_none()));
                rest = &rest[count..];
                continue;
            };
            for lane in [0, count - 1] {
                let position = one.position(rest[lane]).expect("as together");
                let solved = motion(&mechanism, &position.pose(), Order::Acceleration);
                let conditions = solved.expect("regular").conditions;
                let condition = conditions.into_iter().fold(1.0, f64::max);
                let single = one.motions(&[rest[lane]]).expect("as before").clone();
                let near = |a: Vector, b: Vector, size: f64, times: f64, what: &str| {
                    let off = (a - b).norm() / size.max(f64::MIN_POSITIVE);
                    let allowed = 100.0 * U * times;
                    assert!(off <= allowed, "{name} {} {what} {off:e} {allowed:e}", rest[lane]);
                };
                let sizes = |rows: &[[[f64; 1]; 2]]| rows.iter().map(|r| vector(r, 0).norm()).fold(0.0, f64::max);
                let largest = |rows: &[[f64; 1]]| rows.iter().fold(0.0, |m: f64, r| m.max(r[0].abs()));
                for (class, turn) in single.turns.iter().enumerate() {
                    near(vector(&together.turns[class], lane), vector(turn, 0), 1.0, condition, "turn");
                }
                for (slot, place) in single.points.iter().enumerate() {
                    let size = sizes(&single.points);
                    near(vector(&together.points[slot], lane), vector(place, 0), size, condition, "place");
                    let (a, b) = (&together.point_accelerations[slot], &single.point_accelerations[slot]);
                    let size = sizes(&single.point_accelerations);
                    near(vector(a, lane), vector(b, 0), size, condition.powi(3), "acceleration");
                }
                let rates = [
                    (&together.omegas, &alone.omegas, &single.omegas, condition.powi(2)),
                    (&together.alphas, &alone.alphas, &single.alphas, condition.powi(3)),
                    (&together.speeds, &alone.speeds, &single.speeds, condition.powi(2)),
                    (&together.accelerations, &alone.accelerations, &single.accelerations, condition.powi(3)),
                ];
                for (together, alone, single, times) in rates {
                    for ((a, b), c) in together.iter().zip(alone).zip(single) {
                        assert_eq!(a[lane].to_bits(), b[lane].to_bits(), "{name}");
                        let number = |x: f64| Vector::new(x, 0.0);
                        near(number(a[lane]), number(c[0]), largest(single), times, "rate");
                    }
                }
            }
            rest = &rest[count..];
        }
    }
}

/// The bits of all numbers in a block at one position.
fn bits<R: Row>(block: &Block<R>, position: usize) -> Vec<u64> {
    let vectors = [&block.turns, &block.points, &block.point_velocities, &block.point_accelerations];
    let numbers = [&block.slides, &block.omegas, &block.alphas, &block.speeds, &block.accelerations];
    let rows = vectors.into_iter().flatten().flatten().chain(numbers.into_iter().flatten());
    rows.map(|row| row[position].to_bits()).collect()
}

/// Also where a correction is not sure, or a position refined.
#[test]
fn motions_at_once_are_positions_and_then_rates() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let path = followed(&mechanism, &pose);
        let (low, wide) = (path.low(), path.high() - path.low());
        let values: Vec<f64> = (0..1000).map(|i| low + wide * f64::from(i) / 999.0).collect();
        let (mut at_once, mut after) = (path.many_walker(), path.many_walker());
        let mut rest = values.as_slice();
        while !rest.is_empty() {
            let (count, found) = at_once.motions(rest);
            let (same, positions) = after.positions(rest);
            assert_eq!((count, found.is_some()), (same, positions.is_some()), "{name} {}", rest[0]);
            if let Some(found) = found {
                let expected = after.rates();
                for (lane, value) in rest[..count].iter().enumerate() {
                    assert_eq!(bits(found, lane), bits(expected, lane), "{name} {value}");
                }
            }
            rest = &rest[count..];
        }
        let (mut at_once, mut after) = (path.walker(), path.walker());
        for value in values {
            let found = at_once.motions(&[value]).map(|block| bits(block, 0));
            let expected = after.positions(&[value]).is_some().then(|| bits(after.rates(), 0));
            assert_eq!(found, expected, "{name} {value}");
        }
    }
}

/// What cannot be reached is told apart from what can, and a value out of order only ends a block early.
#[test]
fn blocks_end_where_values_leave_the_segment() {
    let (name, text) = scenes().pop().expect("a scene");
    let (mechanism, pose) = posed(&text);
    let path = followed(&mechanism, &pose);
    let (low, high) = (path.low(), path.high());
    let middle = 0.5 * (low + high);
    let mut many = path.many_walker();
    assert_eq!(many.motions(&[]).0, 0);
    let (count, block) = many.motions(&[high + 1.0, middle]);
    assert!(count == 1 && block.is_none());
    let (count, block) = many.motions(&[f64::NAN, middle]);
    assert!(count == 1 && block.is_none());
    let mut values = vec![middle; MANY];
    assert_eq!(many.motions(&values).0, MANY);
    // The last is on the segment again, the one before is not.
    values[MANY - 2] = low;
    let (count, block) = many.motions(&values);
    assert_eq!(count, MANY - 2);
    assert!(block.is_some());
    values[MANY - 2] = f64::NAN;
    let (count, block) = many.motions(&values);
    assert!(count == MANY - 2 && block.is_some(), "{name} {count} {}", block.is_some());
}
