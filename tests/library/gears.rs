//! Gear pairs through all stages: independent truth of 60 digits, trains by Willis' formula, geared five-bars by closed forms, curves of rolling
//! wheels, and what wheels say of instant centres.
//!
//! `tests/gears/README.md` says where the true numbers come from.

use kinegon::Solution;
use kinegon::centers::LinkPair;
use kinegon::cycle::{Drive, Path};
use kinegon::geometry::{Place, Point, Vector, turn_of_degrees};
use kinegon::motion::Train;
use kinegon::quantity::Quantity;
use serde_json::{Value, json};
use support::comparison::{decimal, entries};
use support::exact::{exceeds, minus};
use support::files;
use support::random::Random;
use support::stages::solved;

/// Mechanisms of each random family.
const COUNT: u64 = 500;

pub(crate) fn solution(scene: &Value) -> Solution {
    solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"))
}

pub(crate) fn number(solution: &Solution, name: &str) -> f64 {
    match solution.quantity(name).unwrap_or_else(|error| panic!("{name}: {error}")) {
        Quantity::Number(number) => number,
        other => panic!("{name} is {other:?}"),
    }
}

/// How far a number is from the truth.
fn off(found: &Value, truth: &Value) -> f64 {
    minus(found.as_f64().expect("a number"), decimal(truth)).abs()
}

#[test]
fn wheels_have_true_rates_and_centres() {
    let text = std::fs::read_to_string(files::path("tests/gears/gears.jsonl")).expect("the cases can be read");
    let mut compared = 0;
    for line in text.lines() {
        let case: Value = serde_json::from_str(line).expect("a case is JSON");
        let result = serde_json::to_value(solution(&case["scene"]).result()).expect("a result is JSON");
        assert_eq!(result["proved"], true, "{}", case["id"]);
        let mut scene = case["scene"].clone();
        let centers: Vec<&str> = entries(&case["expected"]["centers"]).map(|(name, _)| name).collect();
        scene["want"] = json!(centers);
        let wanted =
            serde_json::to_value(solution(&scene).whole_result().expect("it has values")).expect("a result is JSON");
        let mut see = |what: &str, found: &Value, error: &Value, truth: &Value| {
            assert!(found.is_number(), "{}: {what} is {found}", case["id"]);
            let (off, stated) = (off(found, truth), error.as_f64().unwrap_or_else(|| panic!("{what} has no bound")));
            // The f64 next to a given decimal is printed as that decimal.
            let stated = if stated == 0.0 { 0.5 * f64::EPSILON * found.as_f64().unwrap_or(0.0).abs() } else { stated };
            assert!(!exceeds(off, stated), "{}: {what} is off by {off:e}, stated {stated:e}", case["id"]);
            compared += 1;
        };
        for (link, truth) in entries(&case["expected"]["links"]).filter(|(link, _)| !result["links"][*link].is_null()) {
            let own = &result["links"][link];
            see("omega", &own["omega"], &own["omega_error"], &truth["omega"]);
            see("alpha", &own["alpha"], &own["alpha_error"], &truth["alpha"]);
        }
        for (point, truth) in entries(&case["expected"]["points"]) {
            let own = &result["points"][point];
            for axis in 0..2 {
                see("v", &own["velocity"][axis], &own["velocity_error"], &truth["velocity"][axis]);
                see("a", &own["acceleration"][axis], &own["acceleration_error"], &truth["acceleration"][axis]);
            }
        }
        for (name, truth) in entries(&case["expected"]["centers"]).filter(|(_, truth)| !truth["at"].is_null()) {
            let own = &wanted["centers"][name];
            for axis in 0..2 {
                see(name, &own["position"][axis], &own["error"], &truth["at"][axis]);
            }
        }
    }
    assert!(compared > 100, "{compared}");
}

fn teeth(dice: &mut Random) -> i32 {
    17 + dice.below(84) as i32
}

fn angle(dice: &mut Random) -> f64 {
    (dice.below(14_400) as f64 - 7_200.0) / 10.0
}

/// The difference of two angles in degrees, without whole turns.
fn apart(a: f64, b: f64) -> f64 {
    let turns = (a - b) / 360.0;
    360.0 * (turns - turns.round()).abs()
}

/// Sun, planet and ring on an arm, two of sun, ring and arm driven: z_s ω_s + z_r ω_r = (z_s + z_r) ω_arm (R. Willis, 1841).
#[test]
fn planetary_trains_keep_to_willis_formula() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (sun, planet) = (teeth(dice), teeth(dice));
        let ring = sun + 2 * planet;
        let free = ["arm", "sun", "ring"][dice.below(3)];
        let mut given = std::collections::BTreeMap::new();
        let mut links = json!({ "planet": { "points": ["B", "Q"], "lengths": { "BQ": 7 } } });
        for (name, point) in [("arm", "B"), ("sun", "S"), ("ring", "R")] {
            links[name] = json!({ "points": ["A", point], "lengths": { format!("A{point}"): 60 } });
            if name != free {
                let rates = [angle(dice), dice.coarse(), dice.coarse()];
                given.insert(name, rates);
                links[name]["drive"] = json!({ "angle": rates[0], "omega": rates[1], "alpha": rates[2] });
            }
        }
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [3, 4] }, "links": links,
            "gears": [ { "mesh": ["sun", "planet"], "teeth": [sun, planet], "on": "arm" }, { "mesh": ["ring", "planet"], "teeth": [-ring, planet], "on": "arm" } ] });
        let s = solution(&scene);
        let (z_s, z_r, z_p) = (f64::from(sun), f64::from(ring), f64::from(planet));
        for order in 0..3 {
            let of = |name: &str| given.get(name).map_or(f64::NAN, |rates| rates[order]);
            let (arm, own_sun) = match free {
                "arm" => ((z_s * of("sun") + z_r * of("ring")) / (z_s + z_r), of("sun")),
                "sun" => (of("arm"), ((z_s + z_r) * of("arm") - z_r * of("ring")) / z_s),
                _ => (of("arm"), of("sun")),
            };
            let own_ring = ((z_s + z_r) * arm - z_s * own_sun) / z_r;
            let own_planet = arm - (own_sun - arm) * z_s / z_p;
            let truth = [("arm", arm), ("sun", own_sun), ("ring", own_ring), ("planet", own_planet)];
            for (link, truth) in truth {
                let found = number(&s, &format!("{}({link})", ["angle", "omega", "alpha"][order]));
                let off = if order == 0 { apart(found, truth) } else { (found - truth).abs() };
                assert!(off <= 1e-11 * truth.abs().max(100.0), "{link}: {found}, {truth}\n{scene}");
            }
        }
    }
}

/// Willis' table: what each wheel turns against the carrier is the fraction of the teeth on the way to it, worked out here in whole numbers, and with the
/// carrier's angular velocity it adds up to that of the motion. Two carriers give two trains.
#[test]
fn wheels_turn_against_their_carrier_as_teeth_say() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (sun, planet) = (teeth(dice), teeth(dice));
        let ring = sun + 2 * planet;
        let other = [teeth(dice), teeth(dice)];
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [3, 4], "D": [90, 4] },
            "links": {
                "arm": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": angle(dice), "omega": dice.coarse() } },
                "planet": { "points": ["B"] },
                "sun": { "points": ["A"] },
                "out": { "points": ["D"] } },
            "gears": [
                { "mesh": ["planet", "ground"], "teeth": [planet, -ring], "on": "arm" },
                { "mesh": ["sun", "planet"], "teeth": [sun, planet], "on": "arm" },
                { "mesh": ["sun", "out"], "teeth": other, "on": "ground" } ] });
        let s = solution(&scene);
        let trains = Train::all(&s.mechanism);
        assert_eq!(trains.len(), 2, "{scene}");
        let name = |body| s.mechanism.body(body).name.as_str();
        let wheels =
            |index: usize| trains[index].wheels.iter().map(|wheel| (name(wheel.body), wheel.turns)).collect::<Vec<_>>();
        let [sun, planet, ring] = [sun, planet, ring].map(i128::from);
        let other = other.map(i128::from);
        // The same fractions, not in lowest terms: a · d = b · c.
        let same = |[a, b]: [i128; 2], [c, d]: [i128; 2]| b > 0 && a * d == b * c;
        let is_first = wheels(0).iter().all(|(name, turns)| match *name {
            "planet" => same(*turns, [1, 1]),
            "sun" => same(*turns, [-planet, sun]),
            _ => same(*turns, [planet, ring]),
        });
        let is_second = wheels(1)
            .iter()
            .all(|(name, turns)| same(*turns, if *name == "sun" { [1, 1] } else { [-other[0], other[1]] }));
        assert!(is_first && is_second && wheels(0).len() == 3 && wheels(1).len() == 2, "{:?}\n{scene}", trains);
        for train in &trains {
            let omega = |body| s.motion.body(body).omega;
            let held = omega(train.wheels[0].body) - omega(train.carrier);
            for wheel in &train.wheels {
                let sum = omega(train.carrier) + wheel.ratio() * held;
                assert!(
                    (sum - omega(wheel.body)).abs() < 1e-12 * (1.0 + held.abs()) * 100.0,
                    "{}\n{scene}",
                    name(wheel.body)
                );
            }
        }
    }
}

/// Ratios of large numbers that are no simpler in lowest terms: bounds of a wheel's angle grow with the teeth and not as a power of 2 by each.
/// The true angles are decimals.
#[test]
fn many_teeth_have_close_bounds() {
    for (teeth, truth) in
        [([199, 200], "-37.3125"), ([499, 500], "-37.425"), ([4999, 5000], "-37.4925"), ([9999, 10_000], "-37.49625")]
    {
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "B": [50, 0] },
            "links": { "1": { "points": ["A"], "drive": { "angle": 37.5, "omega": 1 } }, "2": { "points": ["B", "Q"], "lengths": { "BQ": 20 } } },
            "gears": [ { "mesh": ["1", "2"], "teeth": teeth, "on": "ground" } ] });
        let result = serde_json::to_value(solution(&scene).result()).expect("a result is JSON");
        let own = &result["links"]["2"];
        let stated = own["angle_error"].as_f64().unwrap_or(f64::INFINITY);
        let off = minus(own["angle"].as_f64().expect("an angle"), decimal(&json!(truth))).abs();
        assert!(stated < 2e-13 && !exceeds(off, stated), "{teeth:?}: off by {off:e}, stated {stated:e}");
    }
}

/// Wheels one after the other on a driven arm: each turns from its arm z₁/z₂ times as much as the one before, the other way, from its phase.
/// The coupler of a parallelogram stands at 180° whatever rounding makes of it, so that the wheel which it drives stands still against the ground as
/// Willis' formula says with 180°, and not a third of a turn away: 30 θ₂ + 20 θ₅ − 50 θ₁ = 0.
#[test]
fn an_angle_of_half_a_turn_has_one_sense() {
    for angle in (5..175).step_by(5).map(f64::from) {
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [100, 0] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 41 }, "drive": { "angle": angle, "omega": 1 } },
                       "2": { "points": ["C", "B"], "lengths": { "BC": 100 } },
                       "3": { "points": ["D", "C"], "lengths": { "CD": 41 } },
                       "5": { "points": ["A", "E"], "lengths": { "AE": 10 } } },
            "gears": [{ "mesh": ["2", "5"], "teeth": [30, 20], "on": "1" }],
            "near": { "C": [100.0 + 41.0 * libm::cos(angle.to_radians()), 41.0 * libm::sin(angle.to_radians())] } });
        let found = solution(&scene).quantity("angle(5)").expect("an angle").as_number();
        let expected = (50.0 * angle - 30.0 * 180.0) / 20.0;
        assert!(apart(found, expected) < 1e-9, "{angle}: {found}, not {expected}");
    }
}

#[test]
fn trains_count_whole_turns() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let count = 2 + dice.below(5);
        let (arm, first) = (angle(dice), angle(dice));
        let mut links = json!({
            "arm": { "points": ["A"], "shape": { "A": [0, 0] }, "drive": { "angle": arm, "omega": 1.25 } },
            "w0": { "points": ["A", "P0"], "lengths": { "AP0": 5 }, "drive": { "angle": first, "omega": -2.5 } }
        });
        let (mut gears, mut truth) = (Vec::new(), vec![(first, -2.5)]);
        for index in 1..=count {
            let (center, rim) = (format!("C{index}"), format!("P{index}"));
            links["arm"]["points"].as_array_mut().expect("a list").push(json!(center));
            links["arm"]["shape"][&center] = json!([30 * index, 10 * dice.below(3)]);
            links[format!("w{index}")] =
                json!({ "points": [center, rim], "lengths": { format!("{center}-{rim}"): 4 } });
            let (z, phase) = ([teeth(dice), teeth(dice)], angle(dice));
            gears.push(json!({ "mesh": [format!("w{}", index - 1), format!("w{index}")], "teeth": z, "on": "arm", "phase": phase }));
            let ratio = f64::from(z[0]) / f64::from(z[1]);
            let (turned, rate) = truth[index - 1];
            truth.push((arm + phase - ratio * (turned - arm), 1.25 - ratio * (rate - 1.25)));
        }
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] }, "links": links, "gears": gears });
        let s = solution(&scene);
        for (index, (turned, rate)) in truth.into_iter().enumerate() {
            let found = number(&s, &format!("angle(w{index})"));
            assert!(apart(found, turned) <= 1e-11 * turned.abs().max(100.0), "w{index}: {found}, {turned}\n{scene}");
            assert!((number(&s, &format!("omega(w{index})")) - rate).abs() <= 1e-12 * rate.abs().max(1.0), "{scene}");
        }
        assert!(s.pose.assemblies.iter().flatten().all(|assembly| assembly.modes == 1), "{scene}");
    }
}

/// Two cranks on wheels, with a dyad between them, from lengths.
struct FiveBar {
    teeth: [i32; 2],
    phase: f64,
    lengths: [f64; 4],
    base: f64,
    side: f64,
}

impl FiveBar {
    fn random(dice: &mut Random) -> FiveBar {
        let length = |dice: &mut Random, least: f64| least + dice.below(400) as f64 / 10.0;
        let lengths = [length(dice, 10.0), length(dice, 120.0), length(dice, 120.0), length(dice, 10.0)];
        FiveBar {
            teeth: [teeth(dice), teeth(dice)],
            phase: angle(dice),
            lengths,
            base: 110.0,
            side: [1.0, -1.0][dice.below(2)],
        }
    }

    fn second(&self, first: f64) -> f64 {
        self.phase - first * f64::from(self.teeth[0]) / f64::from(self.teeth[1])
    }

    /// Where the dyad's pin is with the first crank at this angle.
    fn apex(&self, first: f64) -> Point {
        let [a, b, c, d] = self.lengths;
        let from = Point::origin() + turn_of_degrees(first) * Vector::new(a, 0.0);
        let to = Point::new(self.base, 0.0) + turn_of_degrees(self.second(first)) * Vector::new(d, 0.0);
        let way = to - from;
        let along = (way.norm_squared() + b * b - c * c) / (2.0 * way.norm());
        let across = self.side * (b * b - along * along).sqrt();
        let unit = way / way.norm();
        from + unit * along + Vector::new(-unit.y, unit.x) * across
    }

    fn scene(&self, first: f64) -> Value {
        let [a, b, c, d] = self.lengths;
        let near = self.apex(first);
        json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "E": [self.base, 0] },
            "links": {
                "1": { "points": ["A", "B"], "lengths": { "AB": a }, "drive": { "angle": first, "omega": 2, "alpha": -3 } },
                "2": { "points": ["B", "C"], "lengths": { "BC": b } },
                "3": { "points": ["D", "C"], "lengths": { "CD": c } },
                "4": { "points": ["E", "D"], "lengths": { "DE": d } } },
            "gears": [ { "mesh": ["1", "4"], "teeth": self.teeth, "on": "ground", "phase": self.phase } ],
            "near": { "C": [near.x, near.y] } })
    }
}

/// The first two derivatives of a function of time by differences of the fourth order.
fn derivatives(f: impl Fn(f64) -> Vector) -> [Vector; 2] {
    const H: f64 = 1e-3;
    let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| f(k * H));
    [((d - b) * 8.0 - (e - a)) / (12.0 * H), ((d + b) * 16.0 - (e + a) - c * 30.0) / (12.0 * H * H)]
}

#[test]
fn geared_five_bars_are_where_their_lengths_and_wheels_put_them() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (bar, first) = (FiveBar::random(dice), angle(dice));
        let scene = bar.scene(first);
        let s = solution(&scene);
        let c = s.mechanism.point("C").expect("C");
        assert!((s.pose.point(c) - bar.apex(first)).norm() < 1e-10, "{scene}");
        let at = |t: f64| bar.apex(first + (2.0 * t - 1.5 * t * t).to_degrees()).coords;
        let [velocity, acceleration] = derivatives(at);
        let motion = s.motion.body(s.mechanism.link("3").expect("3"));
        let found = [motion.velocity_at(s.pose.point(c)), motion.acceleration_at(s.pose.point(c))];
        assert!((found[0] - velocity).norm() < 1e-6 * velocity.norm().max(10.0), "{velocity} {}\n{scene}", found[0]);
        assert!((found[1] - acceleration).norm() < 1e-4 * acceleration.norm().max(100.0), "{acceleration}\n{scene}");
        assert!(s.result().proved, "{scene}");
    }
}

/// After a turn of the crank the other wheel stands elsewhere: the path goes on, and does not jump back.
#[test]
fn a_path_goes_on_over_whole_turns() {
    let bar = FiveBar { teeth: [20, 30], phase: 40.0, lengths: [25.0, 130.0, 125.0, 20.0], base: 110.0, side: 1.0 };
    let s = solution(&bar.scene(70.0));
    let mut path =
        Path::new(&s.mechanism, &s.pose, Drive::new(&s.mechanism, None).expect("a drive")).expect("not singular");
    path.cover(Some(-700.0), Some(1_100.0)).expect("it goes round");
    let mut walker = path.walker();
    let c = s.mechanism.point("C").expect("C");
    for step in 0..180 {
        let angle = -700.0 + f64::from(step * 77 % 180) * 10.0;
        let place = walker.position(angle).expect("it is there").pose().point(c);
        assert!((place - bar.apex(angle)).norm() < 1e-10, "at {angle}: {place}, {}", bar.apex(angle));
        // Solved anew, it is the same assembly: whole turns of the drive count.
        let anew = solution(&bar.scene(angle));
        assert!((anew.pose.point(c) - bar.apex(angle)).norm() < 1e-10, "at {angle}");
    }
}

/// A point on the rim of a wheel in a ring of twice its size moves on a straight line (Cardano); where a wheel touches a fixed one it rests.
#[test]
fn rolling_wheels_draw_known_curves() {
    for turn in 0..36 {
        let arm = f64::from(turn) * 10.0 + 1.0;
        let scene = |teeth: i32, ring: i32, phase: f64| {
            json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
                "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 40 }, "drive": { "angle": arm, "omega": 1.5, "alpha": 2 } },
                           "2": { "points": ["B", "Q"], "lengths": { "BQ": 40 } } },
                "gears": [ { "mesh": ["ground", "2"], "teeth": [ring, teeth], "on": "1", "phase": phase } ] })
        };
        let cardan = solution(&scene(30, -60, 0.0));
        let q = cardan.mechanism.point("Q").expect("Q");
        let place = cardan.pose.point(q);
        let expected = 80.0 * turn_of_degrees(arm).re;
        assert!((place - Point::new(expected, 0.0)).norm() < 1e-12, "{place}");
        let motion = cardan.motion.body(cardan.mechanism.link("2").expect("2"));
        assert!(motion.velocity_at(place).y.abs() < 1e-11 && motion.acceleration_at(place).y.abs() < 1e-11);
        // 20 teeth on 20: the rim of the wheel is 20 mm from B, so Q is beyond it; the pitch point is half-way.
        let rolling = solution(&scene(20, 20, 0.0));
        let pitch = rolling.pose.point(rolling.mechanism.point("B").expect("B")) * 0.5;
        let motion = rolling.motion.body(rolling.mechanism.link("2").expect("2"));
        assert!(motion.velocity_at(pitch).norm() < 1e-12, "{}", motion.velocity_at(pitch));
        assert!((motion.omega - 3.0).abs() < 1e-15);
    }
}

/// Pitch points are permanent centres, so that Kennedy's lines lead to all others.
#[test]
fn pitch_points_lead_to_all_centres() {
    let bar = FiveBar { teeth: [20, 30], phase: 40.0, lengths: [25.0, 130.0, 125.0, 20.0], base: 110.0, side: 1.0 };
    let mut scene = bar.scene(70.0);
    scene["figure"] = json!({ "panels": ["scheme", "centers"], "centers": "all" });
    let s = solution(&scene);
    let centers = s.construction.centers.as_ref().expect("centres are drawn");
    let names = ["ground", "1", "2", "3", "4"];
    for (index, a) in names.iter().enumerate() {
        for b in &names[index + 1..] {
            let pair = LinkPair::new(
                s.mechanism.link(a).unwrap_or(kinegon::mechanism::GROUND),
                s.mechanism.link(b).expect("a link"),
            );
            let drawn =
                centers.all.iter().find(|center| Some(center.pair) == pair).unwrap_or_else(|| panic!("no P({a},{b})"));
            let Place::At(drawn) = drawn.place else { panic!("P({a},{b}) is at infinity") };
            let Quantity::Vector(found) = s.quantity(&format!("P({a},{b})")).expect("a centre") else {
                panic!("no place")
            };
            assert!((drawn.coords - found).norm() < 1e-9 * found.norm().max(100.0), "P({a},{b}): {drawn}, {found}");
        }
    }
    let Quantity::Vector(pitch) = s.quantity("P(1,4)").expect("a centre") else { panic!("no place") };
    assert_eq!([pitch.x, pitch.y], [44.0, 0.0]);
}

#[test]
fn wheels_of_two_sizes_and_trains_without_a_ratio_are_told() {
    let scene = |sun: i32, ring: i32, distance: f64| {
        json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [distance, 0] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 5 }, "drive": { "angle": 10, "omega": 1 } },
                       "2": { "points": ["D", "E"], "lengths": { "DE": 5 } },
                       "3": { "points": ["F", "G"], "lengths": { "FG": 5 } } },
            "gears": [ { "mesh": ["1", "2"], "teeth": [sun, 20], "on": "ground" }, { "mesh": ["2", "3"], "teeth": [20, ring], "on": "ground" } ] })
    };
    let with = |place: f64| {
        let mut own = scene(30, 40, 50.0);
        own["ground"]["F"] = json!([50.0 + place, 0]);
        solution(&own).result().warnings
    };
    assert!(with(60.0).is_empty() && with(61.0).is_empty());
    let warnings = with(70.0);
    assert!(warnings.len() == 1 && warnings[0].contains("two pitch radii, 20.0000 and 23.3333"), "{warnings:?}");
    // A rim of 20 teeth in a mesh and on a rack, whose radius says how large it is; and wheels that a belt with such radii cannot run around.
    let on_rack = |radius: f64| {
        let mut own = scene(30, 40, 50.0);
        own["links"]["3"] = json!({ "points": ["F", "G"], "lengths": { "FG": 5 } });
        own["gears"][1] = json!({ "mesh": ["2", "3"], "teeth": [20, "rack"], "radius": radius, "on": "ground" });
        own["sliders"] = json!([{ "link": "3", "at": "F", "on": "ground", "through": [0, -30], "along": 0 }]);
        solution(&own).result().warnings
    };
    assert!(on_rack(20.3).is_empty());
    let warnings = on_rack(24.0);
    assert!(warnings.len() == 1 && warnings[0].contains("two pitch radii, 20.0000 and 24.0000"), "{warnings:?}");
    let with_belt = |belt: &str, radius: f64| {
        let mut own = scene(30, 40, 50.0);
        own["ground"] = json!({ "A": [0, 0], "D": [50, 0] });
        own["links"].as_object_mut().expect("an object").remove("3");
        own["gears"] =
            json!([{ "mesh": ["1", "2"], "teeth": [30, 20], "belt": belt, "radius": radius, "on": "ground" }]);
        solution(&own).result().warnings
    };
    // Radii r and 2 r / 3, centres 50 apart: crossed up to r = 30, open up to r = 150.
    for (belt, fits, too_large) in [("crossed", 29.9, 30.1), ("open", 149.0, 151.0)] {
        assert!(with_belt(belt, fits).is_empty(), "{belt}: {:?}", with_belt(belt, fits));
        let warnings = with_belt(belt, too_large);
        assert!(warnings.len() == 1 && warnings[0].contains("are 50.0000 apart: a belt cannot run"), "{warnings:?}");
    }
    // Two rims on the planet of equal size, two suns of equal size: both turn alike whatever the arm does.
    let locked = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
        "links": { "arm": { "points": ["A", "B"], "lengths": { "AB": 60 } }, "planet": ["B"],
                   "sun": { "points": ["A", "S"], "lengths": { "AS": 5 }, "drive": { "angle": 0, "omega": 1 } } },
        "gears": [ { "mesh": ["sun", "planet"], "teeth": [30, 20], "on": "arm" }, { "mesh": ["ground", "planet"], "teeth": [30, 20], "on": "arm" } ] });
    let error = solved(&locked.to_string()).map(|_| ()).expect_err("it cannot be solved").to_string();
    assert!(error.contains("basic ratio of the train is not 1"), "{error}");
}
