//! Racks, rolling wheels, belts and the forces of teeth: independent truth of 60 digits, and closed forms.

use kinegon::Solution;
use kinegon::quantity::Quantity;
use serde_json::{Value, json};
use support::comparison::{decimal, entries};
use support::exact::{exceeds, minus};
use support::files;
use support::random::Random;
use support::stages::solved;

/// Mechanisms of each random family.
const COUNT: u64 = 200;

fn solution(scene: &Value) -> Solution {
    solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"))
}

fn vector(solution: &Solution, name: &str) -> [f64; 2] {
    match solution.quantity(name).unwrap_or_else(|error| panic!("{name}: {error}")) {
        Quantity::Vector(vector) => [vector.x, vector.y],
        other => panic!("{name} is {other:?}"),
    }
}

fn number(solution: &Solution, name: &str) -> f64 {
    match solution.quantity(name).unwrap_or_else(|error| panic!("{name}: {error}")) {
        Quantity::Number(number) => number,
        other => panic!("{name} is {other:?}"),
    }
}

/// A number of tenths from −50 to 50.
fn tenths(dice: &mut Random) -> f64 {
    dice.below(1001) as f64 / 10.0 - 50.0
}

#[test]
fn teeth_carry_true_forces() {
    let text = std::fs::read_to_string(files::path("tests/gears/forces.jsonl")).expect("the cases can be read");
    let mut compared = 0;
    for line in text.lines() {
        let case: Value = serde_json::from_str(line).expect("a case is JSON");
        let result = serde_json::to_value(solution(&case["scene"]).result()).expect("a result is JSON");
        let (forces, expected) = (&result["forces"], &case["expected"]);
        let mut see = |what: &str, found: &Value, error: &Value, truth: &Value| {
            let own = found.as_f64().unwrap_or_else(|| panic!("{}: {what} is {found}", case["id"]));
            let (off, stated) = (minus(own, decimal(truth)).abs(), error.as_f64().expect("a bound"));
            // The f64 next to a given decimal is printed as that decimal.
            let stated = stated.max(0.5 * f64::EPSILON * own.abs());
            assert!(!exceeds(off, stated), "{}: {what} is off by {off:e}, stated {stated:e}", case["id"]);
            assert!(stated < 1e-9, "{}: {what} has the bound {stated:e}", case["id"]);
            compared += 1;
        };
        for (link, truth) in entries(&expected["links"]) {
            let own = &result["links"][link];
            see("omega", &own["omega"], &own["omega_error"], &truth["omega"]);
            see("alpha", &own["alpha"], &own["alpha_error"], &truth["alpha"]);
        }
        for (pin, truths) in entries(&expected["reactions"]) {
            for (link, truth) in entries(truths) {
                let own = &forces["reactions"][pin][link];
                for axis in 0..2 {
                    see(&format!("R({pin},{link})"), &own["force"][axis], &own["force_error"], &truth[axis]);
                }
            }
        }
        for (slider, truth) in entries(&expected["sliders"]) {
            let own = &forces["sliders"][slider];
            see("N", &own["normal"], &own["normal_error"], &truth["N"]);
            see("M", &own["couple"], &own["couple_error"], &truth["M"]);
        }
        for (drive, truth) in entries(&expected["drives"]) {
            let own = &forces["drives"][drive];
            see("torque", &own["torque"], &own["error"], &truth["torque"]);
        }
        for truth in expected["meshes"].as_array().expect("a list") {
            let [a, b] = [0, 1].map(|index| truth["mesh"][index].as_str().expect("a link"));
            let own = &forces["meshes"][format!("{a}/{b}")];
            see("W", &own["tangential"], &own["tangential_error"], &truth["tangential_force_on_first"]);
        }
        assert!(forces["disagreement"].as_f64().expect("a number") < 1e-25, "{}", case["id"]);
    }
    assert_eq!(compared, 89);
}

/// A wheel that rolls along a line draws a cycloid: from where it started, the angle is the length rolled off over the radius.
#[test]
fn rolling_wheels_draw_cycloids() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (radius, rim) = (5.0 + dice.below(300) as f64 / 10.0, 1.0 + dice.below(400) as f64 / 10.0);
        let (at, start, along) = (12.0 * tenths(dice), tenths(dice), 7.2 * tenths(dice));
        let (speed, acceleration) = (tenths(dice), tenths(dice));
        // The line lies to the right of the wheel's centre, also where the guide is another line on the same side, else to the left.
        let side = [1.0, -1.0][dice.below(2)];
        let (guided, out) = if dice.below(3) == 0 && side > 0.0 { (0.0, "C") } else { (-side * 3.5, "S") };
        let carriage = if out == "C" {
            json!({ "points": ["C"] })
        } else {
            json!({ "points": ["C", "S"], "shape": { "C": [0, 0], "S": [0, guided] } })
        };
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [3, 4] },
            "links": { "1": carriage, "2": { "points": ["C", "Q"], "lengths": { "CQ": rim } } },
            "sliders": [ { "link": "1", "at": out, "on": "ground", "through": [3, 4], "along": along,
                           "drive": { "position": at, "speed": speed, "acceleration": acceleration } } ],
            "gears": [ { "mesh": if seed % 2 == 0 { ["2", "ground"] } else { ["ground", "2"] },
                         "teeth": if seed % 2 == 0 { json!([20, "rack"]) } else { json!(["rack", 20]) },
                         "radius": radius, "on": "1", "position": start } ] });
        let s = solution(&scene);
        let omega = -side * speed / radius;
        assert!((number(&s, "omega(2)") - omega).abs() <= 1e-12 * omega.abs().max(1.0), "{scene}");
        let alpha = -side * acceleration / radius;
        assert!((number(&s, "alpha(2)") - alpha).abs() <= 1e-12 * alpha.abs().max(1.0), "{scene}");
        let (sine, cosine) = libm::sincos(along.to_radians());
        let (u, n) = ([cosine, sine], [-sine, cosine]);
        // In the axes of the guide: along it and to the left.
        let turned = along.to_radians() - side * (at - start) / radius;
        let center = [0, 1].map(|i| [3.0, 4.0][i] + at * u[i] - guided * n[i]);
        let arm = [rim * libm::cos(turned), rim * libm::sin(turned)];
        let point = s.mechanism.point("Q").expect("Q");
        let found = s.pose.point(point);
        for (i, found) in [found.x, found.y].into_iter().enumerate() {
            assert!((found - center[i] - arm[i]).abs() < 1e-10, "{scene}");
        }
        let velocity = vector(&s, "v(Q)");
        let spun = [-arm[1] * omega, arm[0] * omega];
        let swung = [-arm[1] * alpha - arm[0] * omega * omega, arm[0] * alpha - arm[1] * omega * omega];
        let accelerated = vector(&s, "a(Q)");
        for i in 0..2 {
            assert!((velocity[i] - speed * u[i] - spun[i]).abs() < 1e-9, "{scene}");
            assert!(
                (accelerated[i] - acceleration * u[i] - swung[i]).abs() < 1e-8 * swung[i].abs().max(1.0),
                "{scene}"
            );
        }
        let centre = vector(&s, "P(2,ground)");
        for i in 0..2 {
            assert!((centre[i] - center[i] + side * radius * n[i]).abs() < 1e-10, "{centre:?}\n{scene}");
        }
        assert!(s.result().proved, "{scene}");
    }
}

/// A driven pinion pushes its rack by as much as it unrolls, whole turns and all.
#[test]
fn racks_slide_by_what_unrolls() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let (radius, angle, position) = (5.0 + dice.below(300) as f64 / 10.0, 30.0 * tenths(dice), tenths(dice));
        let (omega, alpha, along) = (tenths(dice), tenths(dice), 7.2 * tenths(dice));
        let side = [1.0, -1.0][dice.below(2)];
        let (sine, cosine) = libm::sincos(along.to_radians());
        // A guide beyond the wheel, on its right or on its left.
        let through = [side * 40.0 * sine, -side * 40.0 * cosine];
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 9 }, "drive": { "angle": angle, "omega": omega, "alpha": alpha } },
                       "2": ["R"] },
            "sliders": [ { "link": "2", "at": "R", "on": "ground", "through": through, "along": along } ],
            "gears": [ { "mesh": ["1", "2"], "teeth": [20, "rack"], "radius": radius, "on": "ground", "position": position } ] });
        let s = solution(&scene);
        let truth = position + side * radius * angle.to_radians();
        let size = truth.abs().max(100.0);
        assert!((number(&s, "position(2/ground)") - truth).abs() < 1e-12 * size, "{scene}");
        assert!((number(&s, "v_r(2/ground)") - side * radius * omega).abs() < 1e-11 * size, "{scene}");
        assert!((number(&s, "a_r(2/ground)") - side * radius * alpha).abs() < 1e-11 * size, "{scene}");
        assert!(s.result().proved, "{scene}");
    }
}

/// A pinion between two racks goes on by the mean of both; belts keep or turn the sense.
#[test]
fn pinions_between_racks_and_wheels_with_belts() {
    let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [0, 0] },
        "links": { "1": ["C"], "2": { "points": ["C", "Q"], "lengths": { "CQ": 20 } },
                   "3": { "points": ["R"], "drive": { "position": 60, "speed": 40, "acceleration": 3 } } },
        "sliders": [ { "link": "1", "at": "C", "on": "ground", "through": [0, 20], "along": 0 },
                     { "link": "3", "at": "R", "on": "ground", "through": [0, 45], "along": 180 } ],
        "gears": [ { "mesh": ["2", "ground"], "teeth": [20, "rack"], "radius": 20, "on": "1" },
                   { "mesh": ["3", "2"], "teeth": ["rack", 20], "radius": 20, "on": "1" } ] });
    let s = solution(&scene);
    assert!((number(&s, "v_r(1/ground)") + 20.0).abs() < 1e-13 && (number(&s, "omega(2)") - 1.0).abs() < 1e-14);
    assert!((number(&s, "position(1/ground)") + 30.0).abs() < 1e-12, "{}", number(&s, "position(1/ground)"));
    for (belt, sense) in [("open", 1.0), ("crossed", -1.0)] {
        for teeth in [[20, 30], [30, 20], [25, 25]] {
            let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [90, 0] },
                "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 5 }, "drive": { "angle": 400, "omega": 6, "alpha": 3 } },
                           "2": { "points": ["D", "E"], "lengths": { "DE": 5 } } },
                "gears": [ { "mesh": ["1", "2"], "teeth": teeth, "on": "ground", "belt": belt } ] });
            let s = solution(&scene);
            let ratio = sense * f64::from(teeth[0]) / f64::from(teeth[1]);
            assert!((number(&s, "omega(2)") - 6.0 * ratio).abs() < 1e-14 * 10.0, "{scene}");
            assert!((number(&s, "alpha(2)") - 3.0 * ratio).abs() < 1e-14 * 10.0, "{scene}");
            let turned = (number(&s, "angle(2)") - 400.0 * ratio) / 360.0;
            assert!((turned - turned.round()).abs() < 1e-13, "{scene}");
            if ratio != 1.0 {
                // The centre of similitude: the one place at which both wheels would have one velocity.
                let place = vector(&s, "P(1,2)");
                assert!((place[0] * 6.0 - (place[0] - 90.0) * 6.0 * ratio).abs() < 1e-9 && place[1].abs() < 1e-10);
            }
        }
    }
}
