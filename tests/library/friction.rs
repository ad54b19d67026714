//! Friction in joints against closed forms, hands that solve again and again, and what is said where it locks or is not known. Random mechanisms
//! with friction are in `free_bodies.rs`.

use kinegon::construction::Tolerance;
use kinegon::editing::{Edit, Named, apply};
use kinegon::quantity::{QuantityRequest, pencil};
use serde_json::{Value, json};
use support::stages::solved;

/// Errors allowed, in parts of a number.
const OFF: f64 = 1e-12;

/// A crank of 60 mm at this angle, a rod of 180 mm, a force of 1000 N on the slider against its motion away from the crank.
fn slider_crank(angle: f64, force: f64, friction: &Value) -> Value {
    json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "force": "N" }, "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": angle, "omega": 10 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 180 } },
            "3": { "points": ["C"] },
        },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0 }],
        "forces": [{ "on": "3", "at": "C", "force": [force, 0] }],
        "friction": friction, "near": { "C": [200, 0] },
    })
}

fn quantity(scene: &Value, name: &str) -> f64 {
    let solution = solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"));
    solution.quantity(name).unwrap_or_else(|error| panic!("{error}\n{scene}")).as_number()
}

fn is_about(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= OFF * expected.abs().max(1.0), "{what} is {found}, not {expected}");
}

/// A rod without mass pushes along itself at the angle β, so the guide carries N = X tan β; X (1 ± μ tan β) is the force on the slider.
#[test]
fn a_guide_resists_with_its_coefficient_times_its_force() {
    for angle in [30.0_f64, 75.0, 120.0, 200.0, 290.0] {
        let (sine, cosine) = libm::sincos(angle.to_radians());
        let beta = libm::asin(60.0 * sine / 180.0);
        let omega_2 = -60.0 * 10.0 * cosine / (180.0 * libm::cos(beta));
        let speed = -600.0 * sine - 180.0 * -libm::sin(beta) * omega_2;
        // What the slider needs along its guide is more than 1000 N where it moves against the force, else less.
        let sense = speed.signum();
        // X + 1000·(−sense) − sense·μ|N| = 0 with the force against the motion, |N| = X |tan β|.
        let push = 1000.0 / (1.0 - 0.2 * libm::tan(beta).abs());
        let scene = slider_crank(angle, -1000.0 * sense, &json!([{ "guide": "3/ground", "coefficient": 0.2 }]));
        is_about(quantity(&scene, "R(C,3).x"), sense * push, "R(C,3).x");
        is_about(quantity(&scene, "F_f(3/ground)"), -sense * 0.2 * push * libm::tan(beta).abs(), "the friction");
        // An angle says the same.
        let degrees = libm::atan(0.2).to_degrees();
        let by_angle = slider_crank(angle, -1000.0 * sense, &json!([{ "guide": "3/ground", "angle": degrees }]));
        is_about(quantity(&by_angle, "T(1)"), quantity(&scene, "T(1)"), "T(1) by an angle");
    }
}

/// In a rod with friction at both pins alone the force runs along a line that touches both circles of friction (S. Timoshenko and others): here on
/// opposite sides, so that it is turned from the rod by the angle whose sine is the sum of the radii over the rod's length.
#[test]
fn a_rod_carries_its_force_along_the_common_tangent_of_its_circles() {
    let pins = json!([{ "pin": "B", "coefficient": 0.15, "radius": 20 }, { "pin": "C", "angle": 8, "radius": 15 }]);
    let scene = slider_crank(50.0, -1000.0, &pins);
    let rod = libm::asin(-60.0 * libm::sin(50.0_f64.to_radians()) / 180.0);
    let radii = 20.0 * libm::sin(libm::atan(0.15)) + 15.0 * libm::sin(8.0_f64.to_radians());
    // Links 1 and 2 turn against each other, and the rod turns the same way against the slider: both couples add up.
    let turned = libm::asin(radii / 180.0);
    let across = quantity(&scene, "R(B,2).y") / quantity(&scene, "R(B,2).x");
    is_about(across, libm::tan(rod + turned), "the slope of the force");
    is_about(quantity(&scene, "R(B,2).x"), 1000.0, "R(B,2).x");
}

/// A toggle press without friction but at the pin of its three links.
fn toggle(angle: f64, fixed_in: &str) -> Value {
    let text = support::files::read("templates/toggle-press.json");
    let mut scene: Value = serde_json::from_str(&text).expect("a scene is JSON");
    scene["units"]["force"] = json!("N");
    scene["links"]["1"]["drive"]["angle"] = json!(angle);
    scene["forces"] = json!([{ "name": "P", "on": "5", "at": "E", "force": [0, 1000] }]);
    scene["friction"] = json!([{ "pin": "C", "coefficient": 0.3, "radius": 12, "fixed_in": fixed_in }]);
    scene
}

/// Each link k is free but for the force R_k of the pin and the couple of its friction, about its other end. The pin is fixed in one link, in which the
/// others turn: their couples are ρ|R_k| against their turning, and that link has them reversed. Links that turn on each other in pairs, as if the pin
/// were cut, would have others. Solved again and again with the couples of the time before.
#[test]
fn a_pin_of_three_links_rubs_on_the_link_in_which_it_is_fixed() {
    let rho = 12.0 * libm::sin(libm::atan(0.3));
    let mut torques = Vec::new();
    for (angle, fixed) in [60.0, 200.0].into_iter().flat_map(|angle| [0, 1, 2].map(|fixed| (angle, fixed))) {
        let names = ["2", "3", "4"];
        let solution = solved(&toggle(angle, names[fixed]).to_string()).expect("it moves");
        let place = |name: &str| solution.pose.point(solution.mechanism.point(name).expect("a point"));
        let number = |name: &str| solution.quantity(name).expect("there is one").as_number();
        let arms = ["B", "D", "E"].map(|end| place("C") - place(end));
        let omega = names.map(|link| number(&format!("omega({link})")));
        let mut forces = [nalgebra::Vector2::zeros(); 3];
        let mut couples = [0.0; 3];
        for _ in 0..200 {
            couples = [0.0; 3];
            for link in (0..3).filter(|link| *link != fixed) {
                couples[link] = -rho * forces[link].norm() * (omega[link] - omega[fixed]).signum();
                couples[fixed] -= couples[link];
            }
            // Moments about the other ends, the ram along its guide, and the pin.
            let mut matrix = nalgebra::DMatrix::<f64>::zeros(6, 6);
            let mut right = nalgebra::DVector::<f64>::zeros(6);
            for link in 0..3 {
                (matrix[(link, 2 * link)], matrix[(link, 2 * link + 1)]) = (-arms[link].y, arms[link].x);
                right[link] = -couples[link];
                (matrix[(4, 2 * link)], matrix[(5, 2 * link + 1)]) = (1.0, 1.0);
            }
            (matrix[(3, 5)], right[3]) = (1.0, -1000.0);
            let found = matrix.lu().solve(&right).expect("it carries");
            forces = [0, 1, 2].map(|link| nalgebra::Vector2::new(found[2 * link], found[2 * link + 1]));
        }
        let crank = place("B") - place("A");
        let torque = -(crank.x * forces[0].y - crank.y * forces[0].x);
        for (link, name) in names.iter().enumerate() {
            is_about(number(&format!("R(C,{name}).x")), forces[link].x, "R(C)");
            // Both others rub on the one in which the pin is fixed.
            is_about(number(&format!("power(friction(C,{name}))")), couples[link] * omega[link], "what friction takes");
        }
        let result = serde_json::to_value(solution.result()).expect("a result is JSON");
        let drive = &result["forces"]["drives"]["1"];
        let powers = drive["powers"].as_object().expect("powers by load").values();
        is_about(-powers.map(|power| power.as_f64().expect("a number")).sum::<f64>(), torque, "the sum of powers");
        is_about(number("T(1)"), torque, "the torque");
        let agreement = solution.forces().expect("there are some").agreement();
        assert!(agreement.difference <= agreement.allowed, "{agreement:?}");
        torques.push(torque);
    }
    let apart = torques.windows(2).take(2).map(|pair| (pair[0] - pair[1]).abs());
    assert!(apart.fold(f64::INFINITY, f64::min) > 10.0, "the link makes a difference: {torques:?}");
}

/// Whatever is fixed there is told, and a pin of two links has no choice.
#[test]
fn a_pin_of_three_links_asks_where_it_is_fixed() {
    let error = |scene: &Value| solved(&scene.to_string()).err().map(|error| error.to_string()).unwrap_or_default();
    let mut asked = toggle(60.0, "2");
    asked["friction"][0].as_object_mut().expect("friction").remove("fixed_in");
    let told = error(&asked);
    assert!(told.contains("2, 3, 4") && told.contains(r#""fixed_in": "2""#), "{told}");
    assert!(error(&toggle(60.0, "5")).contains("link 5 has no point C"), "{}", error(&toggle(60.0, "5")));
    assert!(error(&toggle(60.0, "ground")).contains("ground"), "{}", error(&toggle(60.0, "ground")));
    let mut two = toggle(60.0, "1");
    two["friction"][0]["pin"] = json!("B");
    assert!(error(&two).contains("pin B joins two links"), "{}", error(&two));
}

/// A pencil that errs in directions alone, by d at most: the load Q and the friction F = μN are laid off along the guide, the guide is drawn and its normal, and the rod's
/// direction is taken from the scheme. With t = tan β these change N = (Q + F) t by Q, F, N t twice, and (Q + F)(1 + t²), each times its error. What N is wrong by
/// changes F, so N once more by k = μt/(1 − μt) of it, where F is from the same drawing; it adds that with an error of its own, where F is from an earlier one. Half and
/// half are the variance (1 + k/2)² + ¾k² of that without; and an angle of friction φ that is wrong by δ brings k N δ/(sin φ cos φ).
#[test]
fn the_band_of_a_guides_force_has_what_its_friction_inherits() {
    let (crank, phi) = (75.0_f64, 14.0_f64.to_radians());
    let t = libm::tan(libm::asin(60.0 * libm::sin(crank.to_radians()) / 180.0));
    let mut scene = slider_crank(crank, 1000.0, &json!([{ "guide": "3/ground", "angle": 14 }]));
    scene["figure"] = json!({ "panels": ["scheme", "forces"], "mu_l": 2, "mu_f": 10 });
    let solution = solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"));
    let asked = vec![QuantityRequest::new("N(3/ground)", &solution.mechanism).expect("a name")];
    let found = pencil(&solution, &solution.scales(), Tolerance { mm: 0.0, degrees: 0.3 }, asked);
    let band = found.band("N(3/ground)").expect("a band");

    let mu = libm::tan(phi);
    let push = 1000.0 / (1.0 - mu * t);
    let normal = push * t;
    is_about(band.value.abs(), normal, "N");
    let own = [1000.0, mu * normal, normal * t, normal * t, push * (1.0 + t * t)];
    let k = mu * t / (1.0 - mu * t);
    let squares: f64 = own.iter().map(|x| x * x).sum();
    let of_angle = k * normal / (libm::sin(phi) * libm::cos(phi));
    let variance = squares * ((1.0 + k / 2.0).powi(2) + 0.75 * k * k) + of_angle * of_angle;
    let expected = 2.1 * 0.3_f64.to_radians() * (variance / 3.0).sqrt();
    assert!((band.band - expected).abs() < 2e-3 * expected, "{} is not {expected}", band.band);
}

#[test]
fn friction_takes_power_from_the_drive_in_every_position() {
    let all = json!([
        { "guide": "3/ground", "coefficient": 0.1 }, { "pin": "A", "coefficient": 0.1, "radius": 12 },
        { "pin": "B", "coefficient": 0.1, "radius": 12 }, { "pin": "C", "coefficient": 0.1, "radius": 9 },
    ]);
    for angle in (5..360).step_by(10) {
        let (rough, smooth) =
            (slider_crank(f64::from(angle), -800.0, &all), slider_crank(f64::from(angle), -800.0, &json!([])));
        // T ω is what the drive gives.
        let more = quantity(&rough, "T(1)") - quantity(&smooth, "T(1)");
        assert!(more > 0.0, "at {angle}°: {more}");
    }
}

#[test]
fn what_locks_and_what_is_at_rest_is_told() {
    let warnings = |scene: &Value| {
        let solution = solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"));
        (solution.warnings().collect::<Vec<_>>().join("\n"), solution.forces().is_some())
    };
    let guide = |coefficient: f64| json!([{ "guide": "3/ground", "coefficient": coefficient }]);
    // At 80° the rod stands at 19.2°: with μ above cot 19.2° = 2.88 it locks.
    for (coefficient, is_free) in [(2.8, true), (2.95, false)] {
        let (said, has_forces) = warnings(&slider_crank(80.0, 1000.0, &guide(coefficient)));
        assert_eq!((has_forces, said.contains("friction locks")), (is_free, !is_free), "{coefficient}: {said}");
    }
    let (said, has_forces) = warnings(&slider_crank(0.0, -1000.0, &guide(0.1)));
    assert!(has_forces && said.contains("at rest") && said.contains("3/ground"), "{said}");
    assert_eq!(warnings(&slider_crank(50.0, -1000.0, &guide(0.1))), (String::new(), true));
}

#[test]
fn names_follow_what_is_renamed_or_removed() {
    let mut scene = slider_crank(
        50.0,
        -1000.0,
        &json!([
            { "guide": "3/ground", "coefficient": 0.1 }, { "pin": "B", "coefficient": 0.1, "radius": 12 },
        ]),
    );
    scene["want"] = json!(["power(friction(3/ground))", "power(friction(B,2))", "M_f(B,2)", "F_f(3/ground)"]);
    let text = scene.to_string();
    let edited = |edits: &[Edit]| -> Value {
        serde_json::from_str(&apply(&text, edits).unwrap_or_else(|error| panic!("{error}"))).expect("JSON")
    };
    let rename = |what, from: &str, to: &str| Edit::Rename { rename: what, from: from.to_owned(), to: to.to_owned() };
    let other = edited(&[rename(Named::Link, "3", "7"), rename(Named::Point, "B", "Q"), rename(Named::Link, "2", "9")]);
    assert_eq!(other["friction"][0]["guide"], "7/ground");
    assert_eq!(other["friction"][1]["pin"], "Q");
    let wanted = json!(["power(friction(7/ground))", "power(friction(Q,9))", "M_f(Q,9)", "F_f(7/ground)"]);
    assert_eq!(other["want"], wanted);
    let solution = solved(&other.to_string()).expect("it is the same mechanism");
    for name in wanted.as_array().expect("names") {
        let name = name.as_str().expect("a name");
        assert!(solution.quantity(name).expect(name).as_number() != 0.0, "{name}");
    }
    // A pin that joins two links alone is no longer said to be fixed in one of them.
    let text = toggle(60.0, "3").to_string();
    for (gone, left) in [("4", json!(null)), ("3", json!(null))] {
        let dropped =
            apply(&text, &[Edit::DropLink { drop_link: gone.to_owned() }]).unwrap_or_else(|error| panic!("{error}"));
        let dropped: Value = serde_json::from_str(&dropped).expect("JSON");
        assert_eq!(dropped["friction"][0]["pin"], "C", "{dropped}");
        assert_eq!(dropped["friction"][0]["fixed_in"], left, "{dropped}");
    }
    let renamed = apply(&text, &[rename(Named::Link, "3", "7")]).unwrap_or_else(|error| panic!("{error}"));
    assert!(renamed.contains(r#""fixed_in":"7""#), "{renamed}");
    let without: Value = edited(&[Edit::DropPoint { drop_point: "B".to_owned() }]);
    assert!(!without.to_string().contains("\"pin\""), "{without}");
}

/// What pages list has a value, or says that it has none here.
#[test]
fn listed_names_have_values() {
    let scene = slider_crank(
        50.0,
        -1000.0,
        &json!([
            { "guide": "3/ground", "coefficient": 0.1 }, { "pin": "B", "coefficient": 0.1, "radius": 12 },
        ]),
    );
    let solution = solved(&scene.to_string()).expect("a scene");
    let names = kinegon::quantity::force_names(&solution.mechanism);
    for name in &names {
        assert!(solution.quantity(name).is_ok(), "{name}");
    }
    let wanted =
        ["R(A,ground)", "R(B,1)", "M_f(B,2)", "N(3/ground)", "h(3/ground)", "F_f(3/ground)", "T(1)", "shaking"];
    assert!(wanted.iter().all(|name| names.iter().any(|own| own == name)), "{names:?}");
    assert!(!names.iter().any(|name| name.starts_with("M_f(A") || name.starts_with("F(")), "{names:?}");
}

/// Whether there are such joints the mechanism knows.
#[test]
fn friction_where_nothing_rubs_is_refused() {
    let refused = |friction: Value| {
        let scene = slider_crank(50.0, -1000.0, &json!([friction]));
        solved(&scene.to_string()).map(|_| ()).expect_err("it is refused").to_string()
    };
    let said = refused(json!({ "guide": "2/ground", "coefficient": 0.1 }));
    assert!(said.contains("no slider 2/ground") && said.contains("3/ground"), "{said}");
    let mut scene = slider_crank(50.0, -1000.0, &json!([{ "pin": "E", "coefficient": 0.1, "radius": 5 }]));
    scene["links"]["2"] = json!({ "points": ["B", "C", "E"], "lengths": { "BC": 180, "CE": 50, "BE": 140 } });
    let said = solved(&scene.to_string()).map(|_| ()).expect_err("it is refused").to_string();
    assert!(said.contains("no links are joined at E"), "{said}");
}
