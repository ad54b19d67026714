//! Cams: contacts of profiles by their equivalent linkage, against independent digits and closed forms over whole turns, with what belongs to the
//! contact itself: its point, sliding, rollers, instant centres, forces.

use crate::gears::{number, solution};
use kinegon::Solution;
use kinegon::construction::Tolerance;
use kinegon::cycle::{Animation, CycleError, Drive, Mover, Path};
use kinegon::drawing::Pen;
use kinegon::editing::{Edit, Named, NewLink, Pins, PlacedPoint, Reshape, apply};
use kinegon::exercise::Exercises;
use kinegon::format::ContactResult;
use kinegon::mechanism::Touch;
use kinegon::quantity::{Quantity, pencil};
use kinegon::scene::{Kind, Scene, Shape};
use serde_json::{Value, json};
use std::ops::{Add, Mul, Sub};
use support::comparison::{decimal, entries};
use support::exact::{exceeds, minus};
use support::files;
use support::random::Random;

/// Mechanisms of each random family.
const COUNT: u64 = 100;

/// A function of time with its first two derivatives.
#[derive(Clone, Copy, Debug)]
struct Jet([f64; 3]);

impl Jet {
    fn constant(x: f64) -> Jet {
        Jet([x, 0.0, 0.0])
    }

    /// A function of this, by its value and derivatives there.
    fn through(self, [f, df, ddf]: [f64; 3]) -> Jet {
        let Jet([_, v, a]) = self;
        Jet([f, df * v, df * a + ddf * v * v])
    }

    fn sqrt(self) -> Jet {
        let root = self.0[0].sqrt();
        self.through([root, 0.5 / root, -0.25 / (root * root * root)])
    }

    fn sin(self) -> Jet {
        let (sine, cosine) = libm::sincos(self.0[0]);
        self.through([sine, cosine, -sine])
    }

    fn cos(self) -> Jet {
        let (sine, cosine) = libm::sincos(self.0[0]);
        self.through([cosine, -sine, -cosine])
    }

    fn inverse(self) -> Jet {
        let x = self.0[0];
        self.through([1.0 / x, -1.0 / (x * x), 2.0 / (x * x * x)])
    }

    fn asin(self) -> Jet {
        let x = self.0[0];
        let root = (1.0 - x * x).sqrt();
        self.through([libm::asin(x), 1.0 / root, x / (root * root * root)])
    }

    fn acos(self) -> Jet {
        Jet::constant(std::f64::consts::FRAC_PI_2) - self.asin()
    }

    /// The angle of a vector: its derivative is (x y' − y x') / (x² + y²).
    fn angle(y: Jet, x: Jet) -> Jet {
        let square = x * x + y * y;
        let turning = (x * y.rate() - y * x.rate()) * square.inverse();
        Jet([libm::atan2(y.0[0], x.0[0]), turning.0[0], turning.0[1]])
    }

    fn rate(self) -> Jet {
        // The third derivative does not enter what is asked of it.
        Jet([self.0[1], self.0[2], 0.0])
    }
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, other: Jet) -> Jet {
        Jet([0, 1, 2].map(|i| self.0[i] + other.0[i]))
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, other: Jet) -> Jet {
        Jet([0, 1, 2].map(|i| self.0[i] - other.0[i]))
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, other: Jet) -> Jet {
        let (Jet([a, b, c]), Jet([x, y, z])) = (self, other);
        Jet([a * x, a * y + b * x, a * z + 2.0 * b * y + c * x])
    }
}

fn vector(solution: &Solution, name: &str) -> [f64; 2] {
    match solution.quantity(name).unwrap_or_else(|error| panic!("{name}: {error}")) {
        Quantity::Vector(vector) => [vector.x, vector.y],
        other => panic!("{name} is {other:?}"),
    }
}

/// The only contact of a result, by its name.
fn contact(solution: &Solution, name: &str) -> ContactResult {
    let mut result = solution.result();
    assert_eq!(result.contacts.len(), 1);
    result.contacts.swap_remove(name).unwrap_or_else(|| panic!("{name} is not there"))
}

fn near(found: f64, truth: f64, size: f64, what: &dyn std::fmt::Display) {
    assert!((found - truth).abs() <= 1e-12 * truth.abs().max(size), "{found} is not {truth}: {what}");
}

fn units() -> Value {
    json!({ "length": "mm", "time": "s" })
}

/// A number of tenths from `low` to `low + 100`.
fn from(low: f64, dice: &mut Random) -> f64 {
    low + dice.below(1001) as f64 / 10.0
}

#[test]
fn a_contact_has_the_true_motion_and_forces_of_its_equivalent_link() {
    let text = std::fs::read_to_string(files::path("tests/cams/cams.jsonl")).expect("the case can be read");
    let case: Value = serde_json::from_str(text.trim()).expect("a case is JSON");
    let mut scene = case["scene"].clone();
    scene["links"].as_object_mut().expect("links").remove("2");
    scene["contacts"] =
        json!([{ "links": ["1", "3"], "centers": ["K", "C"], "radii": [40, 10], "circular": true, "name": "2" }]);
    let result = serde_json::to_value(solution(&scene).result()).expect("a result is JSON");
    assert_eq!((&result["proved"], &result["warnings"]), (&json!(true), &json!([])));
    let mut compared = 0;
    let mut see = |what: &str, found: &Value, error: &Value, truth: &Value| {
        let own = found.as_f64().unwrap_or_else(|| panic!("{what} is {found}"));
        let (off, stated) = (minus(own, decimal(truth)).abs(), error.as_f64().expect("a bound"));
        let stated = stated.max(0.5 * f64::EPSILON * own.abs()).max(1e-50);
        assert!(!exceeds(off, stated), "{what} is off by {off:e}, stated {stated:e}");
        assert!(stated <= 1e-12 * own.abs().max(1000.0), "{what} has the bound {stated:e}");
        compared += 1;
    };
    for (link, truth) in entries(&case["expected"]["links"]) {
        let own = &result["links"][link];
        for key in ["angle", "omega", "alpha"] {
            see(key, &own[key], &own[format!("{key}_error")], &truth[key]);
        }
    }
    for (point, truth) in entries(&case["expected"]["points"]) {
        for (key, axis) in ["position", "velocity", "acceleration"].into_iter().flat_map(|key| [(key, 0), (key, 1)]) {
            let own = &result["points"][point];
            see(key, &own[key][axis], &own[format!("{key}_error")], &truth[key][axis]);
        }
    }
    for (pin, truths) in entries(&case["expected"]["reactions"]) {
        for (link, truth) in entries(truths) {
            let own = &result["forces"]["reactions"][pin][link];
            (0..2).for_each(|axis| see("R", &own["force"][axis], &own["force_error"], &truth[axis]));
        }
    }
    let drive = &result["forces"]["drives"]["1"];
    see("torque", &drive["torque"], &drive["error"], &case["expected"]["drives"]["1"]["torque"]);
    assert_eq!(compared, 9 + 18 + 12 + 1);
    // The force of the contact runs along the equivalent link, which is the common normal.
    for (pin, link) in [("K", "1"), ("C", "3")] {
        let force = |axis: usize| result["forces"]["reactions"][pin][link]["force"][axis].as_f64().expect("a force");
        let normal = |axis: usize| result["contacts"]["1/3"]["normal"][axis].as_f64().expect("a normal");
        assert!((force(0) * normal(1) - force(1) * normal(0)).abs() < 1e-11);
        assert!(libm::hypot(force(0), force(1)) > 80.0);
    }
    // It carries the weight, the spring and the inertia of the follower, over the cosine of the normal's angle with its way.
    let normal = |axis: usize| result["contacts"]["1/3"]["normal"][axis].as_f64().expect("a normal");
    let pressed = result["contacts"]["1/3"]["force"].as_f64().expect("a force");
    let carried = 1.5 * 9.81 + 80.0 + 1.5e-3 * -4236.361038506902;
    near(pressed, carried / normal(1), 1.0, &"the force of the contact");
}

/// An eccentric disc, radius R, centre e from the shaft; a roller, radius r, on a line beside the shaft by x: over a whole turn
/// y = e sin θ + √((R + r)² − (x − e cos θ)²).
#[test]
fn eccentric_cams_with_rollers_over_a_whole_turn() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (e, disc, roller) = (from(1.0, dice) / 4.0, from(30.0, dice), from(2.0, dice) / 5.0);
        let (x, angle) = (from(-50.0, dice) / 5.0, 3.6 * from(0.0, dice));
        let (omega, alpha) = (from(-50.0, dice), from(-50.0, dice));
        let theta = Jet([angle.to_radians(), omega, alpha]);
        let length = Jet::constant(disc + roller);
        let across = Jet::constant(x) - Jet::constant(e) * theta.cos();
        let Jet([y, v, a]) = Jet::constant(e) * theta.sin() + (length * length - across * across).sqrt();
        let scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0] },
            "links": { "1": { "points": ["A", "K"], "lengths": { "AK": e }, "drive": { "angle": angle, "omega": omega, "alpha": alpha } },
                       "3": ["C"] },
            "sliders": [ { "link": "3", "at": "C", "on": "ground", "through": [x, 0], "along": 90 } ],
            "contacts": [ { "links": ["1", "3"], "centers": ["K", "C"], "radii": [disc, roller], "roller": true, "circular": true } ],
            "near": { "C": [x, 100] } });
        let s = solution(&scene);
        let speed = e * (omega.abs() + 1.0);
        near(s.pose.point(s.mechanism.point("C").expect("C")).y, y, disc, &scene);
        near(number(&s, "v_r(3/ground)"), v, speed, &scene);
        near(number(&s, "a_r(3/ground)"), a, 10.0 * speed * (omega.abs() + alpha.abs()), &scene);
        // The point of contact, and the roller: there it has the velocity of the disc.
        let c = contact(&s, "1/3");
        assert!(!c.here_alone && c.equivalent == "E1" && c.sliding.is_none());
        let center = [e * libm::cos(theta.0[0]), e * libm::sin(theta.0[0])];
        let normal = [(x - center[0]) / length.0[0], (y - center[1]) / length.0[0]];
        let touch = [0, 1].map(|i| center[i] + disc * normal[i]);
        for i in 0..2 {
            near(c.position.expect("radii are given")[i], touch[i], disc, &scene);
            near(c.normal[i], normal[i], 1.0, &scene);
        }
        let spin = c.roller_omega.expect("a roller");
        let of_disc = [-omega * touch[1], omega * touch[0]];
        let of_roller = [-spin * (touch[1] - y), v + spin * (touch[0] - x)];
        (0..2).for_each(|i| near(of_roller[i], of_disc[i], 50.0 * disc, &scene));
        // The follower moves along y, so that its instant centre with the disc is on the x axis, and on the normal.
        if omega != 0.0 {
            let centre = vector(&s, "P(1,3)");
            near(centre[1], 0.0, disc, &scene);
            near(centre[0], v / omega, disc, &scene);
            let off = (centre[0] - center[0]) * normal[1] - (centre[1] - center[1]) * normal[0];
            near(off, 0.0, disc, &scene);
        }
        assert!(s.result().proved, "{scene}");
    }
}

/// A disc under a flat follower that moves along y: y = e sin θ + R, touched e cos θ beside the shaft; and the same face tilted.
#[test]
fn eccentric_cams_with_flat_followers_over_a_whole_turn() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (e, disc, angle) = (from(1.0, dice) / 4.0, from(30.0, dice), 3.6 * from(0.0, dice));
        let (omega, alpha) = (from(-50.0, dice), from(-50.0, dice));
        // The face is tilted by so much against the normal of the follower's way, and its own place is as far from the line of motion as x.
        let tilt = [0.0, 0.6 * from(-50.0, dice)][dice.below(2)];
        let x = from(-50.0, dice) / 5.0;
        let theta = Jet([angle.to_radians(), omega, alpha]);
        let (sine, cosine) = libm::sincos(tilt.to_radians());
        // The face (x, y) + t (cos, sin) is at the distance R from the centre: n · ((x, y) − e) = R with n = (−sin, cos).
        let along_normal = Jet::constant(e) * (Jet::constant(cosine) * theta.sin() - Jet::constant(sine) * theta.cos());
        let Jet([y, v, a]) = (along_normal + Jet::constant(disc + x * sine)) * Jet::constant(1.0 / cosine);
        let scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0] },
            "links": { "1": { "points": ["A", "K"], "lengths": { "AK": e }, "drive": { "angle": angle, "omega": omega, "alpha": alpha } },
                       "2": ["F"] },
            "sliders": [ { "link": "2", "at": "F", "on": "ground", "through": [x, 0], "along": 90 } ],
            "contacts": [ { "links": ["1", "2"], "centers": ["K"], "radii": [disc], "along": tilt - 90.0, "circular": true } ] });
        let s = solution(&scene);
        let speed = e * (omega.abs() + 1.0);
        near(number(&s, "position(2/ground)"), y, disc, &scene);
        near(number(&s, "v_r(2/ground)"), v, 10.0 * speed, &scene);
        near(number(&s, "a_r(2/ground)"), a, 10.0 * speed * (omega.abs() + alpha.abs()), &scene);
        let c = contact(&s, "1/2");
        assert_eq!(c.equivalent, "K/2");
        let center = [e * libm::cos(theta.0[0]), e * libm::sin(theta.0[0])];
        let touch = [center[0] - disc * sine, center[1] + disc * cosine];
        for i in 0..2 {
            near(c.position.expect("a radius is given")[i], touch[i], disc, &scene);
            near(c.normal[i], [-sine, cosine][i], 1.0, &scene);
        }
        // The disc against the follower, where they touch: nothing along the normal, and along the normal turned by 90° the sliding.
        let against = [-omega * touch[1], omega * touch[0] - v];
        near(against[0] * -sine + against[1] * cosine, 0.0, 50.0 * disc, &scene);
        near(c.sliding.expect("it slides"), -against[0] * cosine - against[1] * sine, 50.0 * disc, &scene);
        assert!(s.result().proved, "{scene}");
    }
}

/// What moves as a disc on a flat face is a pin on a guide beside it: said by a contact and by a slider, results are the same within their bounds.
#[test]
fn flat_faces_have_the_bounds_of_guides_beside_them() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (e, disc, angle) = (from(1.0, dice) / 10.0, from(20.0, dice) / 3.0, 3.6 * from(0.0, dice));
        let base = [from(-180.0, dice), from(-20.0, dice) / 2.0];
        let side = [1.0, -1.0][dice.below(2)];
        let mut scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0], "B": base },
            "links": { "1": { "points": ["A", "K"], "lengths": { "AK": e }, "drive": { "angle": angle, "omega": 3, "alpha": -2 } },
                       "2": { "shape": { "B": 0, "E": 150 } } } });
        let mut other = scene.clone();
        let along = if side > 0.0 { 0 } else { 180 };
        scene["contacts"] = json!([{ "links": ["1", "2"], "centers": ["K"], "radii": [disc], "along": along, "through": "B", "circular": true }]);
        other["sliders"] = json!([{ "pin": "K", "on": "2", "through": [0, -side * disc], "along": along }]);
        let [by_contact, by_slider] = [&scene, &other].map(|scene| solution(scene).result());
        let mut compared = 0;
        let mut see = |what: &str, values: [f64; 2], errors: [f64; 2]| {
            let allowed = 1.001 * (errors[0] + errors[1]) + 4.0 * f64::EPSILON * values[0].abs();
            assert!((values[0] - values[1]).abs() <= allowed, "{what}: {values:?} {errors:?}\n{scene}");
            assert!(errors[0] <= 2.0 * errors[1] + 1e-13 * values[0].abs().max(1.0), "{what}: {errors:?}\n{scene}");
            compared += 1;
        };
        let [a, b] = [&by_contact.links["2"], &by_slider.links["2"]];
        see("omega", [a.omega, b.omega], [a.omega_error, b.omega_error]);
        see("alpha", [a.alpha, b.alpha].map(Option::unwrap), [a.alpha_error, b.alpha_error].map(Option::unwrap));
        see("angle", [a.angle, b.angle].map(Option::unwrap), [a.angle_error, b.angle_error].map(Option::unwrap));
        let [a, b] = [&by_contact.sliders["K/2"], &by_slider.sliders["K/2"]];
        see("v_r", [a.velocity, b.velocity], [a.velocity_error, b.velocity_error]);
        see(
            "s",
            [a.position, b.position].map(Option::unwrap),
            [a.position_error, b.position_error].map(Option::unwrap),
        );
        assert_eq!(compared, 5);
    }
}

/// A flat lever about B that lies on a disc: its angle is that of BK and the angle between, of which the sine is R / BK.
#[test]
fn flat_levers_on_eccentric_cams() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (e, disc, angle) = (from(1.0, dice) / 10.0, from(20.0, dice) / 3.0, 3.6 * from(0.0, dice));
        let (omega, alpha, base) =
            (from(-50.0, dice), from(-50.0, dice), [from(-180.0, dice), from(-20.0, dice) / 2.0]);
        // The disc lies to the right of the face: below a lever to +x, above one on which the face runs back.
        let side = [1.0, -1.0][dice.below(2)];
        let theta = Jet([angle.to_radians(), omega, alpha]);
        let arm = [Jet::constant(e) * theta.cos(), Jet::constant(e) * theta.sin()];
        let arm = [0, 1].map(|i| arm[i] - Jet::constant(base[i]));
        let distance = (arm[0] * arm[0] + arm[1] * arm[1]).sqrt();
        let between = (Jet::constant(side * disc) * distance.inverse()).asin();
        let lever = Jet::angle(arm[1], arm[0]) + between;
        let scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0], "B": base },
            "links": { "1": { "points": ["A", "K"], "lengths": { "AK": e }, "drive": { "angle": angle, "omega": omega, "alpha": alpha } },
                       "2": { "points": ["B", "E"], "lengths": { "BE": 150 } } },
            "contacts": [ { "links": ["1", "2"], "centers": ["K"], "radii": [disc], "along": if side > 0.0 { "BE" } else { "EB" },
                            "circular": true } ],
            "near": { "angle(2)": lever.0[0].to_degrees() } });
        let s = solution(&scene);
        let turned = (number(&s, "angle(2)") - lever.0[0].to_degrees()) / 360.0;
        assert!((turned - turned.round()).abs() < 1e-13, "{turned}\n{scene}");
        near(number(&s, "omega(2)"), lever.0[1], 10.0, &scene);
        near(number(&s, "alpha(2)"), lever.0[2], 1e4, &scene);
        let c = contact(&s, "1/2");
        let touch = c.position.expect("a radius is given");
        // It is on the lever's line, and R from the centre; where the profiles touch they have one velocity along the normal.
        let (sine, cosine) = libm::sincos(lever.0[0]);
        near((touch[1] - base[1]) * cosine - (touch[0] - base[0]) * sine, 0.0, 100.0, &scene);
        let along_lever = (touch[0] - base[0]) * cosine + (touch[1] - base[1]) * sine;
        near(along_lever * along_lever + disc * disc, distance.0[0] * distance.0[0], 1e4, &scene);
        let against = [
            -omega * touch[1] + lever.0[1] * (touch[1] - base[1]),
            omega * touch[0] - lever.0[1] * (touch[0] - base[0]),
        ];
        near(against[0] * c.normal[0] + against[1] * c.normal[1], 0.0, 1e4, &scene);
        near(c.sliding.expect("it slides"), -against[0] * c.normal[1] + against[1] * c.normal[0], 1e4, &scene);
        assert!(s.result().proved, "{scene}");
    }
}

/// Two links about fixed points with round profiles, one of them perhaps hollow: a four-bar linkage whose coupler is R ± r.
#[test]
fn round_profiles_of_two_levers() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (e, one, other) = (from(1.0, dice) / 6.0, from(20.0, dice) / 2.0, from(20.0, dice) / 4.0);
        let is_hollow = dice.below(2) == 0;
        // A hollow profile has the larger radius.
        let radii = if is_hollow { [-(one + other + 30.0), other] } else { [one, other] };
        let coupler = (radii[0] + radii[1]).abs();
        let (angle, omega, alpha) = (3.6 * from(0.0, dice), from(-50.0, dice), from(-50.0, dice));
        let (base, rocker) = (coupler + e + 20.0, e + 30.0);
        let theta = Jet([angle.to_radians(), omega, alpha]);
        let arm = [Jet::constant(e) * theta.cos() - Jet::constant(base), Jet::constant(e) * theta.sin()];
        let square = arm[0] * arm[0] + arm[1] * arm[1];
        let cosine = (square + Jet::constant(rocker * rocker - coupler * coupler))
            * (Jet::constant(2.0 * rocker) * square.sqrt()).inverse();
        if cosine.0[0].abs() > 0.95 {
            continue;
        }
        let lever = Jet::angle(arm[1], arm[0]) - cosine.acos();
        let turned = lever.0[0].to_degrees();
        let scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0], "B": [base, 0] },
            "links": { "1": { "points": ["A", "K"], "lengths": { "AK": e }, "drive": { "angle": angle, "omega": omega, "alpha": alpha } },
                       "3": { "points": ["B", "C"], "lengths": { "BC": rocker } } },
            "contacts": [ { "links": ["1", "3"], "centers": ["K", "C"], "radii": radii } ],
            "near": { "angle(3)": turned } });
        let s = solution(&scene);
        let size = 100.0 * (omega.abs() + 1.0);
        near(number(&s, "omega(3)"), lever.0[1], size, &scene);
        near(number(&s, "alpha(3)"), lever.0[2], size * size, &scene);
        let c = contact(&s, "1/3");
        assert!(c.here_alone && s.warnings().count() == 1, "{scene}");
        let centers = ["K", "C"].map(|name| s.pose.point(s.mechanism.point(name).expect("a centre")));
        let touch = c.position.expect("radii are given");
        for (center, radius) in centers.iter().zip(radii) {
            near(libm::hypot(touch[0] - center.x, touch[1] - center.y), radius.abs(), 100.0, &scene);
        }
        let against = [-omega * touch[1] + lever.0[1] * touch[1], omega * touch[0] - lever.0[1] * (touch[0] - base)];
        near(against[0] * c.normal[0] + against[1] * c.normal[1], 0.0, 100.0 * size, &scene);
        near(c.sliding.expect("it slides"), -against[0] * c.normal[1] + against[1] * c.normal[0], 100.0 * size, &scene);
    }
}

/// A roller on an arm that turns runs around a fixed disc: its place s on the arm keeps to |s u − d| = R + r, with d from the axis to the disc's centre.
/// And a disc on a connecting rod slides on a fixed face: its centre goes along a line, as a slider does.
#[test]
fn profiles_of_the_frame() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (disc, roller) = (from(40.0, dice) / 2.0, from(10.0, dice) / 5.0);
        let center = [from(-50.0, dice) / 5.0, from(-50.0, dice) / 5.0];
        let (angle, omega, alpha) = (3.6 * from(0.0, dice), from(-50.0, dice), from(-50.0, dice));
        let theta = Jet([angle.to_radians(), omega, alpha]);
        let unit = [theta.cos(), theta.sin()];
        let along = Jet::constant(center[0]) * unit[0] + Jet::constant(center[1]) * unit[1];
        let length = disc + roller;
        let rest = Jet::constant(length * length - center[0] * center[0] - center[1] * center[1]);
        let place = along + (along * along + rest).sqrt();
        let scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0], "K": center },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 90 }, "drive": { "angle": angle, "omega": omega, "alpha": alpha } },
                       "3": ["C"] },
            "sliders": [ { "link": "3", "at": "C", "on": "1", "along": "AB" } ],
            "contacts": [ { "links": ["ground", "3"], "centers": ["K", "C"], "radii": [disc, roller], "roller": true, "circular": true } ],
            "near": { "C": [place.0[0] * unit[0].0[0], place.0[0] * unit[1].0[0]] } });
        let s = solution(&scene);
        let size = 100.0 * (omega.abs() + 1.0);
        near(number(&s, "position(3/1)"), place.0[0], disc, &scene);
        near(number(&s, "v_r(3/1)"), place.0[1], size, &scene);
        near(number(&s, "a_r(3/1)"), place.0[2], size * (omega.abs() + alpha.abs() + 1.0), &scene);
        // The roller rolls: where it touches the frame it rests.
        let (c, at) = (contact(&s, "ground/3"), s.pose.point(s.mechanism.point("C").expect("C")));
        let (touch, spin, velocity) =
            (c.position.expect("radii"), c.roller_omega.expect("a roller"), vector(&s, "v(C)"));
        near(velocity[0] - spin * (touch[1] - at.y), 0.0, size, &scene);
        near(velocity[1] + spin * (touch[0] - at.x), 0.0, size, &scene);
        let rod = from(100.0, dice);
        let scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 30 }, "drive": { "angle": angle, "omega": omega, "alpha": alpha } },
                       "2": { "points": ["B", "K"], "lengths": { "BK": rod } } },
            "contacts": [ { "links": ["2", "ground"], "centers": ["K"], "radii": [disc], "along": 180, "through": [0, -30], "circular": true } ],
            "near": { "K": [rod, disc - 30.0] } });
        let s = solution(&scene);
        let down = Jet::constant(30.0) * theta.sin() - Jet::constant(disc - 30.0);
        let across = Jet::constant(30.0) * theta.cos() + (Jet::constant(rod * rod) - down * down).sqrt();
        let [x, v, _] = across.0;
        near(s.pose.point(s.mechanism.point("K").expect("K")).x, x, rod, &scene);
        near(vector(&s, "v(K)")[0], v, size, &scene);
        // The lowest point of the disc, and how it slides along −x turned from the normal, which points down: along +x.
        let c = contact(&s, "2/ground");
        near(c.position.expect("a radius")[1], -30.0, 10.0, &scene);
        near(c.sliding.expect("it slides"), v + number(&s, "omega(2)") * disc, size, &scene);
    }
}

/// The same position as drawn, with its radii and without, moves as from lengths.
#[test]
fn drawn_profiles_move_as_those_from_lengths() {
    let from_lengths = solution(&json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0], "B": [100, 10] },
        "links": { "1": { "points": ["A", "K"], "lengths": { "AK": 20 }, "drive": { "angle": 60, "omega": 15, "alpha": 4 } },
                   "3": { "points": ["B", "C"], "lengths": { "BC": 50 } } },
        "contacts": [ { "links": ["1", "3"], "centers": ["K", "C"], "radii": [30, 20] } ], "near": { "C": [60, 45] } }));
    let place = |name: &str| {
        let at = from_lengths.pose.point(from_lengths.mechanism.point(name).expect("a point"));
        json!([at.x, at.y])
    };
    for radii in [json!([30, 20]), Value::Null] {
        let mut scene = json!({ "kinegon": 1, "units": units(), "ground": ["A", "B"],
            "points": { "A": [0, 0], "B": [100, 10], "K": place("K"), "C": place("C") },
            "links": { "1": { "points": ["A", "K"], "drive": { "omega": 15, "alpha": 4 } }, "3": ["B", "C"] },
            "contacts": [ { "links": ["1", "3"], "centers": ["K", "C"] } ] });
        if radii.is_array() {
            scene["contacts"][0]["radii"] = radii.clone();
        }
        let drawn = solution(&scene);
        for name in ["omega(3)", "alpha(3)", "omega(E1)"] {
            near(number(&drawn, name), number(&from_lengths, name), 10.0, &scene);
        }
        assert_eq!(contact(&drawn, "1/3").position.is_some(), radii.is_array());
    }
}

/// Radii are added with all their digits: 0.1 and 0.2 make 0.3, and not the sum of what f64 makes of them.
/// A flat profile is drawn where the radius puts it, on the side that its direction says, however that is written; else it is refused.
#[test]
fn flat_profiles_are_drawn_where_the_radius_puts_them() {
    for seed in 0..COUNT {
        let mut dice = Random(seed);
        // The face runs along `way` through F, and the centre K lies to its right, `radius` below it.
        let degrees = dice.below(3600) as f64 / 10.0;
        let turn = |x: f64, y: f64| {
            let (sin, cos) = libm::sincos(degrees.to_radians());
            [x * cos - y * sin, x * sin + y * cos]
        };
        let radius = if seed % 10 == 0 { 0.0 } else { from(5.0, &mut dice) };
        let [beside, second] = [0; 2].map(|_| from(3.0, &mut dice));
        let at = |[x, y]: [f64; 2]| [40.0 + x, 30.0 + y];
        let places = json!({ "A": [0, 0], "K": at(turn(beside, -radius)), "F": [40, 30], "G": at(turn(second, 0.0)), "D": [-70, 90] });
        let is_on_ground = seed % 2 == 0;
        let drawn = |along: Value, radius: Option<f64>| {
            let face = json!({ "links": ["1", if is_on_ground { "ground" } else { "2" }], "centers": ["K"], "along": along, "through": "F" });
            let mut scene = json!({ "kinegon": 1, "units": units(), "ground": ["A"], "points": places,
                "links": { "1": { "points": ["A", "K"], "drive": { "omega": 2 } }, "2": ["D", "F", "G"] }, "contacts": [face] });
            scene["ground"] = if is_on_ground { json!(["A", "F", "G"]) } else { json!(["A", "D"]) };
            if is_on_ground {
                scene["links"]["2"] = json!(["K", "D"]);
            }
            scene["contacts"][0]["radii"] = json!(radius.map(|radius| [radius]));
            if radius.is_none() {
                scene["contacts"][0].as_object_mut().expect("an object").remove("radii");
            }
            Scene::read(&scene.to_string())
        };
        let axis = if is_on_ground { 0.0 } else { libm::atan2(30.0 - 90.0, 40.0 + 70.0).to_degrees() };
        let ways = |sign: f64| {
            let points = if sign > 0.0 { "F-G" } else { "G-F" };
            let turned = if sign > 0.0 { 0.0 } else { 180.0 };
            [json!(points), json!(turn(sign, 0.0)), json!(degrees - axis + turned)]
        };
        for along in ways(1.0) {
            for own in [Some(radius), Some(radius * 1.005), None] {
                drawn(along.clone(), own).unwrap_or_else(|error| panic!("{seed}: {along}, {own:?}: {error}"));
            }
            let off =
                [radius + 0.05 * radius.max(beside), 0.95 * radius - 0.05 * if radius > 0.0 { 0.0 } else { beside }];
            for own in off.into_iter().filter(|own| *own >= 0.0) {
                let error = drawn(along.clone(), Some(own)).expect_err("another radius").to_string();
                assert!(
                    error.contains("contacts[0].radii: K is drawn") && error.contains("but the radius is"),
                    "{error}"
                );
            }
        }
        if radius > 0.0 {
            for along in ways(-1.0) {
                for own in [Some(radius), None] {
                    let error = drawn(along.clone(), own).expect_err("the other side").to_string();
                    assert!(error.contains("contacts[0].along: K is drawn on the wrong side"), "{error}");
                }
            }
        }
    }
}

#[test]
fn radii_are_added_with_all_their_digits() {
    let scene = |contacts: Value, link: Value| {
        let mut scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0] },
            "links": { "1": { "points": ["A", "K"], "lengths": { "AK": 0.1 }, "drive": { "angle": 90, "omega": 1 } }, "3": ["C"] },
            "sliders": [ { "link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 90 } ], "near": { "C": [0, 1] } });
        if contacts.is_array() {
            scene["contacts"] = contacts;
        } else {
            scene["links"]["E1"] = link;
        }
        solution(&scene).result()
    };
    let contacts = json!([{ "links": ["1", "3"], "centers": ["K", "C"], "radii": [0.1, 0.2], "circular": true }]);
    let by_contact = scene(contacts, Value::Null);
    let by_link = scene(Value::Null, json!({ "points": ["K", "C"], "lengths": { "KC": 0.3 } }));
    assert_eq!(by_contact.points["C"].position, by_link.points["C"].position);
    let [error, truth] = [&by_contact, &by_link].map(|result| result.points["C"].position_error.expect("a bound"));
    assert!((error - truth).abs() < 1e-6 * truth, "{error} {truth}");
    let read = Scene::read(
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "B": [1, 0] },
             "links": { "1": { "points": ["A", "K"], "lengths": { "AK": 0.1 }, "drive": { "angle": 90, "omega": 1 } },
                        "3": { "points": ["B", "C"], "lengths": { "BC": 1 } } },
             "contacts": [ { "links": ["1", "3"], "centers": ["K", "C"], "radii": [0.1, 0.2] } ] }"#,
    );
    let read = read.expect("a scene");
    assert!(matches!(&read.links["E1"].shape, Shape::Lengths(lengths) if lengths[0].value == 0.3));
    let [_, y] = by_contact.points["C"].position.expect("a place");
    let off = minus(y, "0.4").abs();
    assert!(
        !exceeds(off, by_contact.points["C"].position_error.expect("a bound").max(0.5 * f64::EPSILON * y)),
        "{off}"
    );
}

/// Circles go round; profiles of which only the contact is known stand.
#[test]
fn only_circular_profiles_can_be_followed() {
    let text = Kind::named("eccentric-cam").expect("a kind").text;
    let own = solution(&serde_json::from_str(&text).expect("JSON"));
    let mut path =
        Path::new(&own.mechanism, &own.pose, Drive::new(&own.mechanism, None).expect("a drive")).expect("regular");
    path.cover(Some(0.0), Some(360.0)).expect("it goes round");
    for angle in 0..36 {
        let angle = 10.0 * f64::from(angle);
        let pose = path.walker().position(angle).expect("it is there").pose();
        let theta = angle.to_radians();
        let across = 8.0 - 20.0 * libm::cos(theta);
        let y = 20.0 * libm::sin(theta) + (52.0 * 52.0 - across * across).sqrt();
        assert!((pose.point(own.mechanism.point("C").expect("C")).y - y).abs() < 1e-11, "at {angle}");
    }
    let momentary = text.replace(", \"circular\": true", "");
    assert_ne!(text, momentary);
    let alone = solution(&serde_json::from_str(&momentary).expect("JSON"));
    assert_eq!(Drive::new(&alone.mechanism, None).expect_err("it stands"), CycleError::AtContact);
    let still = Animation::new(&alone, None, 12).expect("one position");
    assert_eq!(still.positions.len(), 1);
    assert_eq!(number(&alone, "omega(2)"), number(&own, "omega(2)"));
    // What a figure would show of other positions is refused where it stands in the scene.
    let traced = momentary.replace("\"panels\"", "\"ghosts\": 6, \"panels\"");
    let error = Scene::read(&traced).expect_err("there are no ghosts");
    assert_eq!(error.path, "figure.ghosts");
    assert!(Scene::read(&text.replace("\"panels\"", "\"ghosts\": 6, \"panels\"")).is_ok());
}

/// A load on a flat follower presses along the normal, beside the shaft: its torque is the load times that distance.
#[test]
fn a_flat_follower_presses_along_the_normal() {
    for turn in 0..12 {
        let angle = 30.0 * f64::from(turn) + 7.0;
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" }, "ground": { "A": [0, 0] },
            "links": { "1": { "points": ["A", "K"], "lengths": { "AK": 20 }, "drive": { "angle": angle, "omega": 15 } }, "2": ["F"] },
            "sliders": [ { "link": "2", "at": "F", "on": "ground", "through": [6, 0], "along": 90 } ],
            "contacts": [ { "links": ["1", "2"], "centers": ["K"], "radii": [40], "along": -90, "circular": true } ],
            "forces": [ { "name": "P", "on": "2", "at": "F", "force": [0, -100] } ], "analysis": "static" });
        let s = solution(&scene);
        let beside = 20.0 * libm::cos(angle.to_radians());
        near(number(&s, "T(1)"), 100.0 * beside, 100.0, &scene);
        let result = serde_json::to_value(s.result()).expect("a result is JSON");
        let force = |axis: usize| result["forces"]["reactions"]["K"]["1"]["force"][axis].as_f64().expect("a force");
        near(force(0), 0.0, 100.0, &scene);
        near(force(1), -100.0, 100.0, &scene);
        near(contact(&s, "1/2").force.expect("a load"), 100.0, 100.0, &scene);
        let mut lifted = scene.clone();
        lifted["forces"][0]["force"] = json!([0, 7]);
        let lifted = solution(&lifted).result();
        near(lifted.contacts["1/2"].force.expect("a load"), -7.0, 100.0, &scene);
        assert_eq!(lifted.warnings.len(), 1, "{:?}", lifted.warnings);
        // The follower's own guide carries the couple of the eccentric force.
        let couple = result["forces"]["sliders"]["2/ground"]["couple"].as_f64().expect("a couple");
        near(couple.abs(), 100.0 * (beside - 6.0).abs(), 100.0, &scene);
    }
}

/// Profiles rub where they touch, not in the joints that stand for them: friction there is refused.
#[test]
fn contacts_have_no_friction() {
    let scene = |friction: Value| {
        json!({ "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" }, "ground": { "A": [0, 0] },
            "links": { "1": { "points": ["A", "K"], "lengths": { "AK": 20 }, "drive": { "angle": 40, "omega": 15 } }, "2": ["F"] },
            "sliders": [ { "link": "2", "at": "F", "on": "ground", "through": [6, 0], "along": 90 } ],
            "contacts": [ { "links": ["1", "2"], "centers": ["K"], "radii": [40], "along": -90, "circular": true } ],
            "forces": [ { "on": "2", "at": "F", "force": [0, -100] } ], "friction": [friction] })
    };
    let refused = |friction: Value| kinegon::solve(&Scene::read(&scene(friction).to_string()).expect("a scene"));
    for friction in
        [json!({ "guide": "K/2", "coefficient": 0.1 }), json!({ "pin": "K", "coefficient": 0.1, "radius": 5 })]
    {
        let error = refused(friction).expect_err("it is no joint that rubs").to_string();
        assert!(error.contains("stands for profiles that touch"), "{error}");
    }
    assert!(refused(json!({ "guide": "2/ground", "coefficient": 0.1 })).is_ok());
}

fn edited(text: &str, edits: &[Edit]) -> String {
    let edited = apply(text, edits).unwrap_or_else(|error| panic!("{error}"));
    Scene::read(&edited).unwrap_or_else(|error| panic!("{error}\n{edited}"));
    edited
}

#[test]
fn editing_keeps_contacts() {
    let text = Kind::named("eccentric-cam").expect("a kind").text;
    let rename = |rename, from: &str, to: &str| Edit::Rename { rename, from: from.into(), to: to.into() };
    let renamed =
        edited(&text, &[rename(Named::Point, "K", "M"), rename(Named::Link, "3", "5"), rename(Named::Link, "2", "4")]);
    assert!(renamed.contains(r#""links": ["1", "5"], "centers": ["M", "C"]"#), "{renamed}");
    assert!(renamed.contains(r#""name": "4""#), "{renamed}");
    // A new link does not take the name of the equivalent one.
    let points = [("X", [60.0, 0.0]), ("Y", [90.0, 10.0])];
    let points = points.map(|(name, at)| PlacedPoint { name: name.to_owned(), at }).to_vec();
    let added = apply(&text, &[Edit::AddLink { add_link: NewLink { points } }]).expect("a link");
    assert!(added.contains(r#""4": {"#), "{added}");
    // A centre that is pulled changes the disc's radius, and nothing jumps.
    let before = solution(&serde_json::from_str(&text).expect("JSON"));
    let pulled = Reshape::new(&text, "C", &Pins::default()).expect("C").to([8.0, 80.0]).expect("it goes there");
    let at = pulled.pose.point(pulled.mechanism.point("C").expect("C"));
    assert!((at.x - 8.0).abs() < 1e-6 && (at.y - 80.0).abs() < 0.05, "{at}");
    let k = before.mechanism.point("K").expect("K");
    assert!((pulled.pose.point(k) - before.pose.point(k)).norm() < 1e-9);
    let scene: Value = serde_json::from_str(&pulled.text).expect("JSON");
    assert_eq!(scene["contacts"][0]["radii"][1], 12);
    assert!(scene["contacts"][0]["radii"][0].as_f64().expect("a radius") > 45.0, "{}", pulled.text);
    assert!(scene["links"].get("2").is_none(), "{}", pulled.text);
    // On a flat face likewise.
    let flat = Kind::named("flat-follower").expect("a kind").text;
    let pulled = Reshape::new(&flat, "K", &Pins::default()).expect("K").to([12.0, 8.0]).expect("it goes there");
    let at = pulled.pose.point(pulled.mechanism.point("K").expect("K"));
    assert!((at.x - 12.0).abs() < 0.05 && (at.y - 8.0).abs() < 0.05, "{at}\n{}", pulled.text);
    // What is taken away takes its contact along.
    let link = |name: &str| Edit::DropLink { drop_link: name.into() };
    let point = |name: &str| Edit::DropPoint { drop_point: name.into() };
    for edit in [link("2"), link("1"), point("C")] {
        let left = apply(&text, std::slice::from_ref(&edit)).expect("it can go");
        let left: Value = serde_json::from_str(&left).expect("JSON");
        assert_eq!(left["contacts"].as_array().map_or(0, Vec::len), 0, "{edit:?}");
    }
    for name in ["E", "K"] {
        let left = apply(&flat, &[point(name)]).expect("it can go");
        let left: Value = serde_json::from_str(&left).expect("JSON");
        assert_eq!(left["contacts"].as_array().map_or(0, Vec::len), 0, "{name}");
    }
}

#[test]
fn exercises_and_steps_say_what_moves_as_the_profiles_do() {
    for (name, said) in [
        (
            "eccentric-cam",
            "Link 2 is equivalent to the contact of 1 and 3: it joins their centres of curvature K and C.",
        ),
        (
            "flat-follower",
            "A pin in K, the centre of curvature of 1, that slides along the flat face of 2 is equivalent to their contact.",
        ),
    ] {
        let text = Kind::named(name).expect("a kind").text;
        let own = solution(&serde_json::from_str(&text).expect("JSON"));
        let steps = own.steps(&pencil(&own, &own.scales(), Tolerance::default(), Vec::new()));
        assert!(steps.contains(said), "{steps}");
        let dashed = own.figure().marks.iter().filter(|mark| mark.pen == Pen::Equivalent).count();
        assert!(dashed > 0, "{name}");
        let mut exercises = Exercises::new(&own, None, 3).expect("it has a construction");
        for _ in 0..4 {
            let exercise = exercises.next().unwrap_or_else(|error| panic!("{name}: {error}"));
            let contact = &exercise.solution.mechanism.contacts[0];
            let radii = match contact.touch {
                Touch::Arcs { radii, .. } => radii.expect("radii").to_vec(),
                Touch::Face { radius, .. } => vec![radius.expect("a radius")],
            };
            assert!(radii.iter().all(|radius| *radius > 0.0), "{radii:?}");
        }
    }
}

/// A Geneva wheel: crank r, distance of the axes a, slot from t₀ to t₁ from the wheel's axis. The pin is in the slot while its distance from that axis,
/// √(r² + a² − 2 r a cos θ), is at most t₁.
#[test]
fn geneva_wheels_are_engaged_while_the_pin_is_in_the_slot() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (apart, crank) = (from(80.0, dice), from(20.0, dice) / 2.0);
        let (least, greatest) = ((apart - crank).abs(), apart + crank);
        let open = least + (greatest - least) * (0.15 + 0.7 * from(0.0, dice) / 100.0);
        let away = libm::acos((crank * crank + apart * apart - open * open) / (2.0 * crank * apart));
        let angle = libm::round(away.to_degrees() * from(-50.0, dice) / 6.0) / 10.0;
        let omega = from(-50.0, dice) + 0.03;
        let theta = Jet([angle.to_radians(), omega, 0.0]);
        let arm = [Jet::constant(crank) * theta.cos() - Jet::constant(apart), Jet::constant(crank) * theta.sin()];
        let wheel = Jet::angle(arm[1], arm[0]);
        let scene = |angle: f64| {
            json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0], "D": [apart, 0] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": crank }, "drive": { "angle": angle, "omega": omega } }, "3": ["D"] },
            "sliders": [ { "pin": "B", "on": "3", "travel": [0.5 * least, open] } ] })
        };
        let s = solution(&scene(angle));
        near(number(&s, "omega(3)"), wheel.0[1], 50.0, &scene(angle));
        near(number(&s, "alpha(3)"), wheel.0[2], 1e4, &scene(angle));
        let result = s.result();
        assert_eq!(result.sliders["B/3"].engaged, Some(true));
        assert!(result.warnings.is_empty(), "{:?}\n{}", result.warnings, scene(angle));
        let mut path =
            Path::new(&s.mechanism, &s.pose, Drive::new(&s.mechanism, None).expect("a drive")).expect("in the slot");
        path.cover(None, None).expect("from end to end");
        let ends = path.engagement().expect("both ends are those of the slot");
        for (found, truth) in ends.into_iter().zip([-away.to_degrees(), away.to_degrees()]) {
            let stated = path.events().into_iter().find(|event| event.at == found).expect("an event").within;
            assert!((found - truth).abs() <= stated + 1e-11, "{found} {truth} {stated:e}\n{}", scene(angle));
            assert!(stated < 1e-9, "{stated:e}");
        }
        // Beyond, nothing follows from the slot.
        let beyond = solution(&scene((away + 0.3 * (std::f64::consts::PI - away)).to_degrees()));
        let result = beyond.result();
        assert_eq!((result.sliders["B/3"].engaged, result.warnings.len()), (Some(false), 1));
        let drive = Drive::new(&beyond.mechanism, None).expect("a drive");
        assert_eq!(
            Path::new(&beyond.mechanism, &beyond.pose, drive).expect_err("it rests"),
            CycleError::OffGuide("B/3".to_owned())
        );
        // A hand cannot pull the pin out of the slot either.
        let mut mover = Mover::new(&s.mechanism, &s.pose).expect("regular");
        assert!(mover.move_to(&[0.9 * away.to_degrees()]).is_some());
        assert!(mover.move_to(&[away.to_degrees() + 5.0]).is_none());
        assert!((mover.drives()[0] - 0.9 * away.to_degrees()).abs() < 1e-12);
    }
}

/// The bottom of a slot that is just deep enough lets the pin pass; one that is not, by however narrow a part of the turn, does not.
#[test]
fn slots_are_as_deep_as_they_are_said_to_be() {
    let ends = |bottom: f64| {
        let scene = json!({ "kinegon": 1, "units": units(), "ground": { "A": [0, 0], "D": [100, 0] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 70.7 }, "drive": { "angle": 20, "omega": 10 } }, "3": ["D"] },
            "sliders": [ { "pin": "B", "on": "3", "travel": [bottom, 70] } ], "near": { "angle(3)": 145 } });
        let s = solution(&scene);
        let mut path =
            Path::new(&s.mechanism, &s.pose, Drive::new(&s.mechanism, None).expect("a drive")).expect("in the slot");
        path.cover(None, None).expect("from end to end");
        path.engagement().expect("both ends are those of the slot")
    };
    let away = |t: f64| libm::acos((70.7 * 70.7 + 1e4 - t * t) / (2.0 * 70.7 * 100.0)).to_degrees();
    for bottom in [20.0, 29.3] {
        let [low, high] = ends(bottom);
        assert!((high - away(70.0)).abs() < 1e-9 && (low + high).abs() < 1e-9, "{bottom}: {low} {high}");
    }
    for bottom in [29.301, 29.4, 30.0] {
        let [low, high] = ends(bottom);
        assert!((high - away(70.0)).abs() < 1e-9 && (low - away(bottom)).abs() < 1e-9, "{bottom}: {low} {high}");
    }
}

/// The part of the turn is told; guides without ends are not touched.
#[test]
fn the_engaged_part_of_a_turn_is_told() {
    let text = std::fs::read_to_string(files::path("templates/geneva.json")).expect("the scene can be read");
    let s = solution(&serde_json::from_str(&text).expect("JSON"));
    let said = "The slot is engaged at angle(1) from -45° to 45°, 90° of a turn; for the other 270° it dwells.";
    let said = said.replace('-', "\u{2212}");
    assert!(s.result().notes.iter().any(|note| note.replace('-', "\u{2212}") == said), "{:?}", s.result().notes);
    let without = text.replace(", \"travel\": [25, 70.71]", "");
    assert_ne!(text, without);
    let s = solution(&serde_json::from_str(&without).expect("JSON"));
    let result = s.result();
    assert_eq!((result.sliders["B/2"].engaged, result.notes.len()), (None, 0));
    let mut path = Path::new(&s.mechanism, &s.pose, Drive::new(&s.mechanism, None).expect("a drive")).expect("regular");
    path.cover(None, None).expect("it goes round");
    assert!(path.engagement().is_none() && path.end(true).is_none());
}
