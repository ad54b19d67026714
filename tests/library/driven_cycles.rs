//! Sliders driven along moving links: rates on the way against the loop equations, and against differences of positions.

use kinegon::Order;
use kinegon::cycle::{Drive, Path, alone};
use kinegon::geometry::{Point, Vector, span};
use kinegon::mechanism::{BodyId, GROUND, Mechanism, PointId, Role, SliderId};
use kinegon::motion::motion;
use kinegon::quantity::State;
use support::files;
use support::stages::solved;

/// How far a drive is moved to each side: degrees, or parts of the mechanism's size.
const TO_EACH_SIDE: [f64; 2] = [8.0, 0.01];

/// How far apart rates may be, in parts of the largest and by the condition: the loop equations begin at rounded places, the way
/// at angles and slides.
const ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// How near the order of differences is to 2.
const ORDER_WITHIN: f64 = 0.1;

/// Errors of differences below this part of the largest rate are rounding.
const ROUNDING: f64 = 1e-9;

/// Every drive of every scene moved by itself, the path followed to both sides of where it stands.
fn all(check: impl Fn(&str, &Path<'_>, f64)) {
    let mut scenes = files::scenes("tests/driven_sliders");
    let boom = files::read("templates/hydraulic-boom.json");
    scenes.push(("hydraulic-boom".to_owned(), boom));
    let (mut seen, mut given) = (0, 0);
    for (scene, text) in scenes {
        given += text.matches("\"drive\"").count();
        let solution = solved(&text).unwrap_or_else(|error| panic!("{scene}: {error}"));
        let (mechanism, pose) = (solution.mechanism, solution.pose);
        for name in mechanism.drive_names() {
            let alone = alone(&mechanism, &name);
            let drive = Drive::new(&alone, Some(&name)).expect("it is one of the drives");
            let turns = drive.is_angle;
            let width = match turns {
                true => TO_EACH_SIDE[0],
                false => TO_EACH_SIDE[1] * span(pose.points.iter().copied()),
            };
            let name = format!("{scene}, drive {name}");
            let path = Path::new(&alone, &pose, drive);
            let mut path = path.unwrap_or_else(|error| panic!("{name}: {error}"));
            let start = path.low();
            let range = [start - width, start + width];
            let covered = path.cover(Some(range[0]), Some(range[1]));
            covered.unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(
                path.low() <= range[0] && path.high() >= range[1],
                "{name}: only from {} to {}",
                path.low(),
                path.high()
            );
            check(&name, &path, width);
            seen += 1;
        }
    }
    assert_eq!(seen, given, "drives");
}

#[test]
fn rates_on_the_way_are_those_of_the_loop_equations() {
    all(|name, path, width| {
        let mechanism = &path.mechanism;
        let middle = 0.5 * (path.low() + path.high());
        let mut walker = path.walker();
        for part in -4..=4 {
            let value = middle + 0.25 * f64::from(part) * width;
            let position = walker.position(value).expect("it is on the path");
            let pose = position.pose();
            let motion = motion(mechanism, &pose, Order::Acceleration)
                .unwrap_or_else(|error| panic!("{name} at {value}: {error}"));
            // A group's errors are enlarged by its condition, and by those of the groups on which it hangs.
            let condition: f64 = motion.conditions.iter().product();
            let rates = mechanism.links().map(|(id, _)| motion.body(id));
            let largest = rates.fold([0.0, 0.0], |[first, second]: [f64; 2], body| {
                [first.max(body.omega.abs()), second.max(body.alpha.abs()).max(body.omega * body.omega)]
            });
            let near = |what: &str, got: f64, other: f64, order: usize, arm: f64| {
                let bound = ROUNDINGS * condition.powi(order as i32 + 1) * (largest[order] * arm + other.abs());
                let off = (got - other).abs();
                assert!(
                    off <= bound,
                    "{name} at {value}: {what} is {got:e} or {other:e}, {off:e} apart, allowed is {bound:e}"
                );
            };
            for (id, body) in mechanism.links() {
                let [omega, alpha] = position.angular_rates(id);
                let is = |what| format!("{what} of {}", body.name);
                near(&is("ω"), omega, motion.body(id).omega, 0, 1.0);
                near(&is("α"), alpha, motion.body(id).alpha, 1, 1.0);
            }
            let size = span(pose.points.iter().copied());
            for id in (0..mechanism.sliders.len()).map(SliderId) {
                let ([first, second], other) = (position.slide_rates(id), motion.slide(id));
                let is = |what| format!("{what} of {}", mechanism.slider_name(id));
                near(&is("v_r"), first, other.velocity, 0, size);
                near(&is("a_r"), second, other.acceleration, 1, size);
            }
        }
    });
}

#[test]
fn rates_are_differences_of_positions_to_second_order() {
    all(|name, path, width| {
        let middle = 0.5 * (path.low() + path.high());
        let errors = [0.5, 0.25, 0.125].map(|part| differences(path, middle, part * width));
        for (order, what) in ["velocities", "accelerations"].into_iter().enumerate() {
            let [coarse, middle, fine] = errors.map(|e| e[order]);
            if coarse < ROUNDING {
                continue;
            }
            let orders = [coarse / middle, middle / fine].map(libm::log2);
            assert!(
                (orders[1] - 2.0).abs() < ORDER_WITHIN,
                "{name}: {what} are differences to the orders {orders:?} with errors of {coarse:e}, {middle:e}, {fine:e}"
            );
        }
    });
}

/// Rate and its rate of a drive's value, in degrees or lengths.
fn drive_rates(mechanism: &Mechanism, name: &str) -> [f64; 2] {
    let turned = mechanism.bodies.iter().find_map(|body| match body.role {
        Role::Driver { omega, alpha, .. } if body.name == name => Some([omega, alpha]),
        _ => None,
    });
    if let Some(rates) = turned {
        return rates.map(f64::to_degrees);
    }
    let mut sliders = (0..mechanism.sliders.len()).map(SliderId);
    let drive = sliders.find_map(|id| {
        let drive = mechanism.slider(id).drive?;
        (mechanism.push_name(id) == name).then_some(drive)
    });
    let drive = drive.expect("one of both");
    [drive.speed, drive.acceleration]
}

/// How far the points' velocities and accelerations are from central differences with this step, in parts of the largest.
fn differences(path: &Path<'_>, value: f64, step: f64) -> [f64; 2] {
    let (mechanism, mut walker) = (&path.mechanism, path.walker());
    let [rate, second] = drive_rates(mechanism, &path.drive.name);
    let [before, now, after] = [value - step, value, value + step].map(|value| {
        let position = walker.position(value).expect("it is on the path");
        position.pose().points
    });
    let position = walker.position(value).expect("it is on the path");
    let mut errors = [0.0_f64; 2];
    let mut largest = [f64::MIN_POSITIVE; 2];
    for (index, place) in now.iter().enumerate() {
        let body = holder(mechanism, PointId(index));
        let slope = (after[index] - before[index]) / (2.0 * step);
        let bend = second_difference([before[index], *place, after[index]]) / (step * step);
        let expected = [slope * rate, bend * (rate * rate) + slope * second];
        let got = position.motion_at(body, *place);
        for k in 0..2 {
            errors[k] = errors[k].max((got[k] - expected[k]).norm());
            largest[k] = largest[k].max(got[k].norm());
        }
    }
    [0, 1].map(|k| errors[k] / largest[k])
}

fn second_difference([before, now, after]: [Point; 3]) -> Vector {
    (after - now) - (now - before)
}

/// A body that has the point.
fn holder(mechanism: &Mechanism, point: PointId) -> BodyId {
    let mut links = mechanism.links();
    let found = links.find(|(_, body)| body.points.contains(&point));
    found.map_or(GROUND, |(id, _)| id)
}
