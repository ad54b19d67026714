//! The example of Quintero et al. (2011), Figure 2: where its branch ends, how it grows there, and its true motion at 36 crank
//! angles for two drives, all from one path each.

use super::{TURN, U, followed, posed};
use kinegon::cycle::{Happening, Mover, Position};
use kinegon::geometry::degrees_of;
use kinegon::mechanism::{Mechanism, Role, SliderId};
use kinegon::quantity::State;
use serde_json::Value;
use std::collections::BTreeMap;
use support::exact::{exceeds, minus};

const FIGURE_2: &str = include_str!("../../../examples/figure-2.json");

/// The motion at 72 crank angles; `tests/reference/README.md` says where it comes from.
const TRUTH: &str = include_str!("../../reference/paper.jsonl");

/// Where the branch ends on both sides of zero, in degrees.
const LIMIT: &str = "137.582082139174023594169921565";

/// Near the limit each quantity is x* + c √δ; c of the angles of links 2 and 4 in rad, and of the slider in mm.
const GROWTH: [f64; 3] = [0.208_316_168_621_543_87, -0.497_530_652_798_679_3, 146.364_838_782_531_67];

/// The largest error in units u·cond; careful code stays below 2.
const BOUND: f64 = 4.0;

#[test]
fn both_limits_are_located() {
    let (mechanism, pose) = posed(FIGURE_2);
    let path = followed(&mechanism, &pose);
    for (above, limit) in [(true, LIMIT.to_owned()), (false, format!("-{LIMIT}"))] {
        let end = path.end(above).expect("the branch ends");
        let error = minus(end.at, &limit);
        assert!(error.abs() <= 1e-12 * TURN, "{limit} is wrong by {error:e}");
        let Happening::Limit(links) = &end.what else { panic!("{end:?}") };
        assert_eq!(links, "2, 3, 4, 5");
    }
    // Beyond there is nothing, and nothing is made up.
    let mut walker = path.walker();
    for value in [137.5821, -137.5821, 150.0, 180.0, -179.0, f64::NAN, f64::INFINITY] {
        assert!(walker.position(value).is_none(), "{value}");
    }
}

/// Rates of a crank that runs away from the limit are c / (2 √δ), but for a part of the order √δ.
#[test]
fn rates_grow_as_the_square_root_says() {
    let (mechanism, pose) = posed(FIGURE_2);
    let path = followed(&mechanism, &pose);
    let limit: f64 = LIMIT.parse().expect("a number");
    let [two, four] = ["2", "4"].map(|name| mechanism.link(name).expect("a link"));
    let mut walker = path.walker();
    let mut errors = |exponent: i32| {
        let delta = libm::exp10(f64::from(-exponent));
        let position = walker.position(limit - delta.to_degrees());
        let position = position.expect("it is before the limit");
        let [omega, speed] = [0, 1].map(|k| [position.angular_rates(two), position.angular_rates(four)][k][0]);
        let rates = [omega, speed, position.slide_rates(SliderId(0))[0]];
        [0, 1, 2].map(|k| rates[k] / (GROWTH[k] / (2.0 * delta.sqrt())) - 1.0)
    };
    // Nearer than 1e-8 rad, rounding of the crank angle shows.
    for exponent in 5..8 {
        let (far, near) = (errors(exponent), errors(exponent + 1));
        for k in 0..3 {
            let ratio = far[k] / near[k];
            assert!(
                near[k].abs() < 5e-3 && (ratio / 10_f64.sqrt() - 1.0).abs() < 0.08,
                "1e-{exponent}: {far:?} {near:?}"
            );
        }
    }
}

/// Numbers of one kind beside their truth.
#[derive(Default)]
struct Kinds<'a>(BTreeMap<&'static str, Vec<(f64, &'a Value)>>);

impl<'a> Kinds<'a> {
    fn put(&mut self, kind: &'static str, got: f64, truth: &'a Value) {
        self.0.entry(kind).or_default().push((got, truth));
    }

    /// The largest error relative to the number, or to the largest of its kind where that is more: the measure of
    /// `tests/library/reference.rs`.
    fn error(&self) -> f64 {
        let mut largest: f64 = 0.0;
        for numbers in self.0.values() {
            let decimal = |truth: &Value| truth.as_str().expect("true numbers are decimal strings").to_owned();
            let size = |truth: &Value| decimal(truth).parse::<f64>().expect("a number").abs();
            let scale = numbers.iter().map(|(_, truth)| size(truth)).fold(0.0, f64::max);
            for (got, truth) in numbers {
                let error = minus(*got, &decimal(truth)).abs() / scale;
                largest = if exceeds(error, largest) { error } else { largest };
            }
        }
        largest
    }
}

fn entries(json: &Value) -> impl Iterator<Item = (&String, &Value)> {
    json.as_object().into_iter().flatten()
}

fn error(position: &Position, mechanism: &Mechanism, expect: &Value) -> f64 {
    let mut kinds = Kinds::default();
    for (name, truth) in entries(&expect["links"]) {
        let link = mechanism.link(name).expect("a link");
        let [omega, alpha] = position.angular_rates(link);
        kinds.put("omega", omega, &truth["omega"]);
        kinds.put("alpha", alpha, &truth["alpha"]);
        // The truth counts angles from 0 to 360.
        let angle = degrees_of(position.axis(link).expect("an axis"));
        let rough: f64 = truth["angle"].as_str().expect("a decimal string").parse().expect("a number");
        kinds.put("angle", angle + TURN * ((rough - angle) / TURN).round(), &truth["angle"]);
    }
    for (name, truth) in entries(&expect["points"]) {
        let point = mechanism.point(name).expect("a point");
        let body = mechanism.bodies.iter().position(|b| b.points.contains(&point));
        let place = position.place(point);
        let body = kinegon::mechanism::BodyId(body.expect("a point of a body"));
        let [velocity, acceleration] = position.motion_at(body, place);
        for axis in 0..2 {
            kinds.put("position", place[axis], &truth["position"][axis]);
            kinds.put("velocity", velocity[axis], &truth["velocity"][axis]);
            kinds.put("acceleration", acceleration[axis], &truth["acceleration"][axis]);
        }
    }
    let truth = &expect["sliders"]["3"];
    let [speed, second] = position.slide_rates(SliderId(0));
    kinds.put("velocity", speed, &truth["velocity"]);
    kinds.put("acceleration", second, &truth["acceleration"]);
    let place = position.slide_position(SliderId(0)).expect("it has one");
    kinds.put("position", place, &truth["position"]);
    kinds.error()
}

#[test]
fn two_paths_and_two_movers_give_72_true_motions() {
    let (figure_2, pose) = posed(FIGURE_2);
    let mut worst: f64 = 0.0;
    let mut seen = 0;
    for drive in [(1.0, 0.0), (-2.5, 3.0)] {
        let mut mechanism = figure_2.clone();
        for body in &mut mechanism.bodies {
            if let Role::Driver { omega, alpha, .. } = &mut body.role {
                (*omega, *alpha) = drive;
            }
        }
        let path = followed(&mechanism, &pose);
        let mut walker = path.walker();
        let mut mover = Mover::new(&mechanism, &pose).expect("it is regular");
        for line in TRUTH.lines() {
            let case: Value = serde_json::from_str(line).expect("a line is JSON");
            let given = &case["scene"]["links"]["1"]["drive"];
            let number = |key: &str| given[key].as_f64().expect("a number");
            if (number("omega"), number("alpha")) != drive {
                continue;
            }
            seen += 1;
            let on_path = walker.position(number("angle")).expect("it is on the branch");
            let moved = mover.move_to(&[number("angle")]).expect("it can go there");
            let condition = case["cond"].as_f64().expect("a number").max(1.0);
            for position in [on_path, moved] {
                let error = error(&position, &mechanism, &case["expect"]) / (U * condition);
                println!("{} {error}", case["name"]);
                worst = worst.max(error);
            }
        }
    }
    println!("largest error {worst:.2} u·cond");
    assert_eq!(seen, 72);
    assert!(worst < BOUND, "{worst}");
}
