//! Forces in joints and drives: independent truth of 60 digits, two routes for random mechanisms of all classes, energy over a cycle,
//! momentum, springs, and what a scene must say.
//!
//! `tests/forces/README.md` says where the true numbers come from.

use kinegon::Solution;
use kinegon::cycle::{Drive, Path};
use serde_json::{Value, json};
use support::comparison::{decimal, entries};
use support::exact::{Exact, exceeds};
use support::files;
use support::planted::{Planted, pattern};
use support::random::Random;
use support::stages::solved;
use support::survey::FORCED;

/// Errors allowed, in parts of the largest force of the mechanism.
const OFF: f64 = 1e-10;

fn result(solution: &Solution) -> Value {
    serde_json::to_value(solution.result()).expect("a result is JSON")
}

fn forces(scene: &Value) -> Value {
    let solution = solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"));
    result(&solution)["forces"].clone()
}

pub fn cases() -> Vec<Value> {
    let text = std::fs::read_to_string(files::path("tests/forces/forces.jsonl")).expect("the cases can be read");
    let cases: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).expect("a case is JSON")).collect();
    assert!(cases.len() >= 35, "only {}", cases.len());
    cases
}

/// The numbers of a result beside the true ones: what it is, what was found, its stated error, the truth.
type Compared = Vec<(String, f64, f64, Exact)>;

fn compare(id: &str, found: &Value, truth: &Value) -> Compared {
    let mut all = Vec::new();
    let mut see = |what: String, found: &Value, error: &Value, truth: &Value| {
        let number = |json: &Value| json.as_f64().unwrap_or_else(|| panic!("{id}: {what} is {json}"));
        all.push((what.clone(), number(found), number(error), Exact::read(decimal(truth))));
    };
    for (pin, bodies) in entries(&truth["reactions"]) {
        for (body, force) in entries(bodies) {
            let own = &found["reactions"][pin][body];
            // Points of given motion are on no body that could receive a force.
            if own.is_null() && id.starts_with('F') && body == "ground" {
                continue;
            }
            for axis in 0..2 {
                see(format!("R({pin},{body})[{axis}]"), &own["force"][axis], &own["force_error"], &force[axis]);
            }
        }
    }
    for (slider, truth) in entries(&truth["sliders"]) {
        let own = &found["sliders"][slider];
        see(format!("N({slider})"), &own["normal"], &own["normal_error"], &truth["N"]);
        see(format!("M({slider})"), &own["couple"], &own["couple_error"], &truth["M"]);
    }
    for (drive, truth) in entries(&truth["drives"]) {
        let own = &found["drives"][drive];
        let kind = if truth["torque"].is_null() { "force" } else { "torque" };
        see(format!("{kind} of {drive}"), &own[kind], &own["error"], &truth[kind]);
    }
    for (link, truth) in entries(&truth["inertia"]) {
        let own = &found["inertia"][link];
        if own.is_null() {
            continue;
        }
        for axis in 0..2 {
            see(
                format!("F_i({link})[{axis}]"),
                &own["force"][axis],
                &own["force_error"],
                &truth["inertia_force"][axis],
            );
        }
        see(format!("M_i({link})"), &own["couple"], &own["couple_error"], &truth["inertia_couple"]);
    }
    all
}

#[test]
fn joints_and_drives_carry_what_is_true() {
    let mut seen = 0;
    for case in cases() {
        let id = case["id"].as_str().expect("a name");
        let compared = compare(id, &forces(&case["scene"]), &case["expected"]);
        let largest = compared.iter().fold(0.0_f64, |most, (_, _, _, truth)| most.max(truth.rounded().abs()));
        let mut of_forces = 0.0_f64;
        for (what, _, _, truth) in &compared {
            if what.starts_with(['R', 'N', 'F']) {
                of_forces = of_forces.max(truth.rounded().abs());
            }
        }
        for (what, found, error, truth) in compared {
            let off = (truth + -Exact::from(found)).rounded().abs();
            // A couple may be far from a force in size: forces count among forces.
            let size = if what.starts_with(['R', 'N', 'F']) { of_forces } else { largest };
            assert!(!exceeds(off, OFF * size), "{id}: {what} is {found}, off by {off:e}");
            // True numbers have 30 digits.
            assert!(
                !exceeds(off, error + 1e-28 * truth.rounded().abs()),
                "{id}: {what} {found} ± {error:e} is off by {off:e}"
            );
            seen += 1;
        }
    }
    assert!(seen > 700, "only {seen}");
}

/// Loads for a scene: masses of most links, gravity, two forces and a couple.
pub fn loaded(scene: &str, dice: &mut Random) -> Value {
    let mut scene: Value = serde_json::from_str(scene).expect("a scene is JSON");
    scene["units"]["mass"] = json!("kg");
    scene["units"]["force"] = json!("N");
    scene["gravity"] = json!([0, -9810]);
    let links: Vec<String> = entries(&scene["links"]).map(|(name, _)| name.to_owned()).collect();
    for link in &links {
        // A link without a load carries along its joints alone.
        if dice.below(4) > 0 {
            scene["links"][link]["mass"] = json!(dice.between(0.5, 5.0));
            scene["links"][link]["inertia"] = json!(dice.between(100.0, 5000.0));
            scene["links"][link]["center"] = json!([dice.within(80.0), dice.within(80.0)]);
        }
    }
    let mut load = || {
        let on = &links[dice.below(links.len())];
        let at = [dice.within(80.0), dice.within(80.0)];
        json!({ "on": on, "at": at, "force": [dice.within(300.0), dice.within(300.0)], "turns": dice.below(2) == 0 })
    };
    scene["forces"] = json!([load(), load(), { "on": links[1], "couple": 1500 }]);
    scene
}

/// Random mechanisms of all classes with pins and sliders: virtual power needs the same torque as the equilibrium of all links, and what
/// they differ by is within the bounds of both.
#[test]
fn power_and_equilibrium_agree() {
    let (mut dice, mut seen) = (Random(77), 0);
    for number in 0..FORCED.now() {
        let class = ["II", "III", "IV"][number as usize % 3];
        let (kinds, joints) = pattern(&mut dice, class);
        let scene = loaded(&Planted::new(&mut dice, &kinds, &joints).scene(), &mut dice);
        let Ok(solution) = solved(&scene.to_string()) else { continue };
        let result = result(&solution);
        let forces = &result["forces"];
        let number = |of: &Value| of.as_f64().unwrap_or(f64::NAN);
        let (difference, allowed) = (number(&forces["disagreement"]), number(&forces["disagreement_allowed"]));
        assert!(!exceeds(difference, allowed), "{kinds}: {difference:e} of {allowed:e}\n{scene}");
        assert!(!exceeds(difference, 1e-6), "{kinds}: {difference:e}\n{scene}");
        by_names_as_in_results(&solution, forces, &kinds);
        // Where positions are proved, so are forces.
        if result["proved"] == true {
            for (pin, bodies) in entries(&forces["reactions"]) {
                let mut sum = [0.0, 0.0];
                let mut size = 0.0_f64;
                for (_, force) in entries(bodies) {
                    assert!(force["force_error"].is_f64() || force["force_error"].is_u64(), "{kinds}: {pin}: {force}");
                    for axis in 0..2 {
                        sum[axis] += number(&force["force"][axis]);
                        size = size.max(number(&force["force"][axis]).abs());
                    }
                }
                assert!(sum.iter().all(|sum| !exceeds(sum.abs(), 1e-9 * size.max(1.0))), "{kinds}: {pin}: {bodies}");
            }
        }
        seen += 1;
    }
    assert!(seen * 10 > FORCED.now() * 8, "only {seen}");
}

/// What one of many positions says of forces, without bounds, by its own way, is within what `whole` states of this one.
fn by_names_as_in_results(solution: &Solution, forces: &Value, kinds: &str) {
    let number = |of: &Value| of.as_f64().unwrap_or(f64::NAN);
    let value = |name: String| {
        let found = solution.quantity(&name).unwrap_or_else(|error| panic!("{kinds}: {error}"));
        found.as_number()
    };
    let mut pairs: Vec<(String, &Value)> = Vec::new();
    for (pin, bodies) in entries(&forces["reactions"]) {
        for (body, force) in entries(bodies) {
            pairs.push((format!("R({pin},{body}).x"), &force["force"][0]));
            pairs.push((format!("R({pin},{body}).y"), &force["force"][1]));
        }
    }
    let largest = pairs.iter().fold(0.0_f64, |most, (_, force)| most.max(number(force).abs()));
    for (slider, carried) in entries(&forces["sliders"]) {
        pairs.push((format!("N({slider})"), &carried["normal"]));
    }
    for (name, force) in pairs {
        let (own, expected) = (value(name.clone()), number(force));
        assert!(!exceeds((own - expected).abs(), 1e-7 * largest), "{kinds}: {name} is {own}, not {expected}");
    }
    for (drive, needed) in entries(&forces["drives"]).filter(|(_, needed)| !needed["torque"].is_null()) {
        let (own, expected) = (value(format!("T({drive})")), number(&needed["torque"]));
        let power = entries(&needed["powers"]).map(|(_, power)| number(power).abs()).fold(0.0, f64::max);
        assert!(!exceeds((own - expected).abs(), 1e-7 * power), "{kinds}: T({drive}) is {own}, not {expected}");
    }
}

/// A four-bar with masses, a spring and gravity, its crank turning evenly at this angle.
fn four_bar(angle: f64) -> Value {
    json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" },
        "ground": { "A": [0, 0], "D": [160, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": angle, "omega": 10 },
                   "mass": 1.2, "inertia": 700, "center": [22, 4] },
            "2": { "points": ["B", "C"], "lengths": { "BC": 140 }, "mass": 1.6, "inertia": 3100, "center": [65, 8] },
            "3": { "points": ["D", "C"], "lengths": { "CD": 110 }, "mass": 1.1, "inertia": 1900, "center": 50 } },
        "near": { "angle(3)": 95 },
        "gravity": [0, -9810]
    })
}

fn torque(scene: &Value) -> f64 {
    forces(scene)["drives"]["1"]["torque"].as_f64().expect("a torque")
}

/// The trapezoidal rule of a periodic function is exact but for its highest harmonics.
const STEPS: u32 = 144;

fn mean(mut of: impl FnMut(f64) -> f64) -> f64 {
    (0..STEPS).map(|step| of(360.0 * f64::from(step) / f64::from(STEPS))).sum::<f64>() / f64::from(STEPS)
}

/// Over a whole turn inertia, gravity and springs give back what they take.
#[test]
fn what_is_conservative_needs_no_work_over_a_turn() {
    let mut worst = 0.0_f64;
    let mean = mean(|angle| {
        let mut scene = four_bar(angle);
        scene["springs"] = json!([{ "between": [["3", "C"], ["ground", [200, 180]]], "rate": 0.4, "length": 60 }]);
        let torque = torque(&scene);
        worst = worst.max(torque.abs());
        torque
    });
    assert!(worst > 500.0 && mean.abs() < 1e-9 * worst, "mean {mean} of {worst}");
}

/// What a force that turns with the coupler takes over a turn is the work of the drive: ∮ F · v dt by finite differences of places.
#[test]
fn the_drive_does_the_work_of_a_force_that_turns() {
    let with_force = |angle: f64| {
        let mut scene = four_bar(angle);
        scene["forces"] = json!([{ "on": "2", "at": [70, 30], "force": [60, -90], "turns": true }]);
        scene
    };
    let mean_torque = mean(|angle| torque(&with_force(angle)));
    let work_of_force = mean(|angle| {
        let solution = solved(&four_bar(angle).to_string()).expect("it has this position");
        let (mechanism, link) = (&solution.mechanism, solution.mechanism.link("2").expect("link 2"));
        let point = mechanism.point("B").expect("B");
        let axis = solution.pose.axes[link.0].expect("an axis").normalize();
        let turned = |x: f64, y: f64| kinegon::geometry::Vector::new(axis.x * x - axis.y * y, axis.y * x + axis.x * y);
        let place = solution.pose.point(point) + turned(70.0, 30.0);
        turned(60.0, -90.0).dot(&solution.motion.body(link).velocity_at(place))
    });
    // Power of the torque and of the force: T ω + F v = 0 on the mean.
    let left = mean_torque * 10.0 + work_of_force;
    assert!(left.abs() < 1e-9 * work_of_force.abs() && work_of_force.abs() > 100.0, "{mean_torque} {work_of_force}");
}

/// The frame receives the weights less the change of momentum, here by differences of the centres' velocities.
#[test]
fn the_shaking_force_is_the_change_of_momentum() {
    let momentum = |angle: f64| {
        let solution = solved(&four_bar(angle).to_string()).expect("it has this position");
        let mut sum = kinegon::geometry::Vector::zeros();
        for (name, mass, [x, y]) in [("1", 1.2, [22.0, 4.0]), ("2", 1.6, [65.0, 8.0]), ("3", 1.1, [50.0, 0.0])] {
            let link = solution.mechanism.link(name).expect("a link");
            let axis = solution.pose.axes[link.0].expect("an axis").normalize();
            let first = solution.mechanism.body(link).points[0];
            let arm = kinegon::geometry::Vector::new(axis.x * x - axis.y * y, axis.y * x + axis.x * y);
            sum += mass * solution.motion.body(link).velocity_at(solution.pose.point(first) + arm);
        }
        sum
    };
    let step = 0.01_f64;
    for angle in [20.0, 75.0, 140.0, 260.0] {
        let seconds = 2.0 * step.to_radians() / 10.0;
        let change = (momentum(angle + step) - momentum(angle - step)) / seconds * 1e-3;
        let frame = forces(&four_bar(angle))["frame"]["force"].clone();
        let weights = -(1.2 + 1.6 + 1.1) * 9.81;
        let found = [frame[0].as_f64().expect("x"), frame[1].as_f64().expect("y") - weights];
        for axis in 0..2 {
            assert!((found[axis] + change[axis]).abs() < 1e-5 * change.norm(), "{angle}: {found:?} {change}");
        }
    }
}

/// A crank, and two links without masses that make a mechanism of it and carry nothing.
fn crank(units: Value, angle: f64, length: f64) -> Value {
    json!({
        "kinegon": 1, "units": units, "ground": { "A": [0, 0], "D": [2.5 * length, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": length }, "drive": { "angle": angle, "omega": 0 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 2.5 * length } },
            "3": { "points": ["D", "C"], "lengths": { "CD": 2.0 * length } }
        },
        "near": { "angle(3)": 90 }
    })
}

/// A crank with a spring from its pin to the frame: T = −dE/dφ, E = k (L − L₀)²/2.
#[test]
fn a_spring_pulls_with_what_it_is_longer() {
    let mut dice = Random(5);
    for _ in 0..20 {
        let angle: f64 = 360.0 * dice.unit();
        let mut scene = crank(json!({ "length": "mm", "time": "s", "force": "N" }), angle, 50.0);
        scene["springs"] = json!([{ "between": [["1", "B"], ["ground", [120, 40]]], "rate": 1.5, "length": 70 }]);
        let (sin, cos) = libm::sincos(angle.to_radians());
        let (x, y) = (120.0 - 50.0 * cos, 40.0 - 50.0 * sin);
        let length = libm::hypot(x, y);
        // dL/dφ = (x, y)/L · (50 sin φ, −50 cos φ)
        let slope = (x * 50.0 * sin - y * 50.0 * cos) / length;
        let expected = 1.5 * (length - 70.0) * slope;
        let found = torque(&scene);
        assert!((found - expected).abs() < 1e-9 * (1.0 + expected.abs()), "{angle}: {found} {expected}");
    }
}

/// A pound of mass on a lever of a foot under standard gravity needs a pound-foot.
#[test]
fn units_of_mass_and_force_fit_each_other() {
    let moment = |units: Value, mass: f64, arm: f64, gravity: f64| {
        let mut scene = crank(units, 0.0, arm);
        scene["links"]["1"]["mass"] = json!(mass);
        scene["links"]["1"]["center"] = json!("B");
        scene["gravity"] = json!([0, -gravity]);
        torque(&scene)
    };
    let units =
        |length: &str, mass: &str, force: &str| json!({ "length": length, "time": "s", "mass": mass, "force": force });
    let (metres, feet, inches) = (9.80665, 9.80665 / 0.3048, 9.80665 / 0.0254);
    for (found, expected) in [
        (moment(units("ft", "lb", "lbf"), 1.0, 1.0, feet), 1.0),
        (moment(units("ft", "slug", "lbf"), 1.0, 1.0, feet), feet),
        (moment(units("in", "blob", "lbf"), 1.0, 1.0, inches), inches),
        (moment(units("m", "kg", "kgf"), 1.0, 1.0, metres), 1.0),
        (moment(units("mm", "t", "kN"), 1.0, 1.0, 9810.0), 9.81),
        (moment(units("cm", "g", "mN"), 1.0, 1.0, 981.0), 9.81),
    ] {
        assert!((found - expected).abs() < 1e-12 * expected, "{found} {expected}");
    }
}

/// Forces by name are those of the result, with the same bounds, and in a table those of each position.
#[test]
fn forces_have_names() {
    let mut scene = four_bar(40.0);
    scene["want"] = json!(["T(1)", "R(B,2)", "R(B,2).size", "R(C, 3).y", "R(A,ground).x"]);
    let solution = solved(&scene.to_string()).expect("it is solved");
    let forces = result(&solution)["forces"].clone();
    let whole = serde_json::to_value(solution.whole_result().expect("all has values")).expect("a result is JSON");
    let number = |json: &Value| json.as_f64().unwrap_or_else(|| panic!("{json}"));
    let near = |a: &Value, b: &Value| assert!((number(a) - number(b)).abs() <= 1e-11 * number(b).abs(), "{a} {b}");
    near(&whole["quantities"]["T(1)"], &forces["drives"]["1"]["torque"]);
    for axis in 0..2 {
        near(&whole["quantities"]["R(B,2)"][axis], &forces["reactions"]["B"]["2"]["force"][axis]);
    }
    near(&whole["quantities"]["R(C, 3).y"], &forces["reactions"]["C"]["3"]["force"][1]);
    near(&whole["quantities"]["R(A,ground).x"], &forces["reactions"]["A"]["ground"]["force"][0]);
    let error = number(&whole["quantity_errors"]["T(1)"]);
    assert!(error > 0.0 && error < 1e-10 * number(&whole["quantities"]["T(1)"]).abs(), "{error:e}");

    let drive = Drive::new(&solution.mechanism, None).expect("a crank");
    let mut path = Path::new(&solution.mechanism, &solution.pose, drive).expect("it moves");
    path.follow_to(260.0);
    let asked = kinegon::quantity::QuantityRequest::new("T(1)", &solution.mechanism).expect("it is known");
    for angle in [40.0, 100.0, 250.0] {
        let mut walker = path.walker();
        let there = walker.position(angle).expect("it has this position");
        let found = asked.value(&there, None, None).expect("a value").as_number();
        let expected = torque(&four_bar(angle));
        assert!((found - expected).abs() < 1e-9 * expected.abs(), "{angle}: {found} {expected}");
    }
    for (name, why) in [
        ("T(2)", "`T(2)` has no value here: it is not driven"),
        ("R(C,1)", "`R(C,1)` has no value here: that link has no joint at that pin"),
    ] {
        assert_eq!(solution.quantity(name).unwrap_err().to_string(), why);
    }
}

/// A scene without loads says nothing of forces.
#[test]
fn without_loads_nothing_is_said() {
    let mut scene = four_bar(30.0);
    scene.as_object_mut().expect("an object").remove("gravity");
    for link in ["1", "2", "3"] {
        for key in ["mass", "inertia", "center"] {
            scene["links"][link].as_object_mut().expect("an object").remove(key);
        }
    }
    let solution = solved(&scene.to_string()).expect("it is solved");
    assert!(solution.forces().is_none() && result(&solution).get("forces").is_none());
}

/// A slider-crank with a force on its slider of a size as a table says over the crank's angle or the slider's position.
fn pressed(angle: f64, force: &Value, over: &Value) -> Value {
    json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "force": "N" }, "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "angle": angle, "omega": 10 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 150 } }, "3": { "points": ["C"] },
        },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0 }],
        "near": { "C": [150, 0] },
        "forces": [{ "on": "3", "at": "C", "force": force, "over": over }],
    })
}

/// Where the slider of [`pressed`] is, by the law of cosines.
fn slider_at(angle: f64) -> f64 {
    let (sine, cosine) = (libm::sin(angle.to_radians()), libm::cos(angle.to_radians()));
    50.0 * cosine + libm::sqrt(150.0 * 150.0 - 2500.0 * sine * sine)
}

/// What the crank needs, and its stated error, is that of a force which is constant at the table's value here.
fn is_as_constant(angle: f64, over: &Value, times: f64) {
    let found = &forces(&pressed(angle, &json!([-2, 0]), over))["drives"]["1"];
    let mut constant = pressed(angle, &json!([-2.0 * times, 0]), &Value::Null);
    constant["forces"][0].as_object_mut().expect("a load").remove("over");
    let expected = torque(&constant);
    let [torque, error] = ["torque", "error"].map(|key| found[key].as_f64().expect("a number"));
    let off = (torque - expected).abs();
    assert!(
        off <= 1e-12 * expected.abs() + 1e-12 && error <= 1e-12 * expected.abs() + 1e-12,
        "{angle}: {torque} ± {error}, not {expected}"
    );
}

#[test]
fn a_load_over_an_angle_follows_its_table() {
    let table = json!({ "of": "angle(1)", "table": [[0, 10], [40, 30], [120, -10], [120, 5], [300, 20]] });
    // In proportion between two lines; from 300° on to the first line of the next turn.
    for (angle, times) in
        [(20.0, 20.0), (60.0, 20.0), (80.0, 10.0), (121.0, 5.0 + 15.0 / 180.0), (210.0, 12.5), (330.0, 15.0)]
    {
        is_as_constant(angle, &table, times);
        is_as_constant(angle - 360.0, &table, times);
    }
    // On either side of the jump; a table may begin anywhere in the turn.
    is_as_constant(120.0 - 1e-9, &table, -10.0 + 0.5e-9);
    is_as_constant(120.0 + 1e-9, &table, 5.0 + 15.0 / 180.0 * 1e-9);
    is_as_constant(10.0, &json!({ "of": "angle(1)", "table": [[-90, 0], [90, 18], [270, 0]] }), 10.0);
    // At the jump itself nobody knows on which side the crank is: the bound has both.
    let at = &forces(&pressed(120.0, &json!([-2, 0]), &table))["drives"]["1"];
    let [torque, error] = ["torque", "error"].map(|key| at[key].as_f64().expect("a number"));
    let mut other = pressed(120.0, &json!([20, 0]), &Value::Null);
    other["forces"][0].as_object_mut().expect("a load").remove("over");
    let other = self::torque(&other);
    assert!((torque - other).abs() <= error * (1.0 + 1e-12), "{torque} ± {error}, {other}");
}

#[test]
fn a_load_over_a_position_follows_its_table() {
    let table = json!({ "of": "position(3/ground)", "table": [[120, 4], [160, 4], [160, 8], [190, 2]] });
    let expected = |at: f64| match at {
        ..160.0 => 4.0,
        160.0..190.0 => 8.0 - 6.0 * (at - 160.0) / 30.0,
        _ => 2.0,
    };
    for angle in [5.0, 25.0, 50.0, 70.0, 100.0, 150.0, 175.0, 300.0] {
        is_as_constant(angle, &table, expected(slider_at(angle)));
    }
}

#[test]
fn a_load_over_no_slider_is_refused() {
    let over = json!({ "of": "position(2/ground)", "table": [[0, 1], [1, 2]] });
    let error =
        solved(&pressed(30.0, &json!([1, 0]), &over).to_string()).expect_err("there is no such slider").to_string();
    assert!(error.contains("there is no slider 2/ground over whose position a load could change"), "{error}");
}

/// A table of a motion takes the force of each position.
#[test]
fn over_a_cycle_each_position_has_its_load() {
    let table = json!({ "of": "angle(1)", "table": [[0, 0], [90, 100], [180, 0]] });
    let solution = solved(&pressed(10.0, &json!([-1, 0]), &table).to_string()).expect("it can be solved");
    let drive = Drive::new(&solution.mechanism, None).expect("a crank");
    let mut path = Path::new(&solution.mechanism, &solution.pose, drive).expect("it moves");
    path.follow_to(360.0);
    let asked = kinegon::quantity::QuantityRequest::new("T(1)", &solution.mechanism).expect("it is known");
    for angle in [10.0, 45.0, 100.0, 135.0, 200.0, 355.0] {
        let mut walker = path.walker();
        let there = walker.position(angle).expect("it has this position");
        let found = asked.value(&there, None, None).expect("a value").as_number();
        let times = if (0.0..180.0).contains(&angle) { 100.0 - (angle - 90.0).abs() / 0.9 } else { 0.0 };
        let (at, step) = (slider_at(angle), 1e-4);
        let rate = (slider_at(angle + step) - slider_at(angle - step)) / (2.0 * step.to_radians());
        assert!((found - times * rate).abs() <= 1e-5 * (1.0 + (times * rate).abs()), "{angle}: {found} at {at}");
    }
}
