//! A link's `angle` in place of the drive's. Every starting scene is solved as it stands, then again from the angle of each of its
//! links in turn: the drive must come back to where it stood.

use kinegon::Error;
use kinegon::Order;
use kinegon::format::{listed_modes, structure};
use kinegon::geometry::degrees_of;
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::motion::motion;
use kinegon::position::{Count, Listed, Pose, pose, poses};
use kinegon::scene::Scene;
use kinegon::words::Wording;
use serde_json::{Value, json};
use support::files;
use support::survey::ALIKE;

/// Error of a recovered angle in degrees or of a place in the mechanism's size, for a position of condition 1; the angle of a link
/// that hardly turns with the drive says little of it.
const BOUND: f64 = 1e-11;

/// The scene's templates that have one drive, by name.
fn templates() -> Vec<(String, Value)> {
    let scenes = files::templates().into_iter().map(|(name, text)| {
        let scene: Value = serde_json::from_str(&text).expect("JSON");
        (name, scene)
    });
    scenes.collect()
}

fn solved(scene: &Value) -> Result<(Scene, Mechanism, Pose), Error> {
    let scene = Scene::read(&scene.to_string())?;
    let mechanism = mechanism(&scene)?;
    let pose = pose(&mechanism, &scene.near)?;
    Ok((scene, mechanism, pose))
}

/// Takes the number out of the scene's only drive.
fn opened(scene: &Value) -> Option<Value> {
    let mut scene = scene.clone();
    let mut found = 0;
    for part in ["links", "sliders"] {
        let entries: Vec<&mut Value> = match scene.get_mut(part) {
            Some(Value::Object(links)) => links.values_mut().collect(),
            Some(Value::Array(sliders)) => sliders.iter_mut().collect(),
            _ => Vec::new(),
        };
        for entry in entries {
            if let Some(drive) = entry.get_mut("drive").and_then(Value::as_object_mut) {
                let number = drive.remove("angle").or(drive.remove("position"));
                found += usize::from(number.is_some());
            }
        }
    }
    (found == 1).then_some(scene)
}

#[test]
fn the_drive_comes_back_from_the_angle_of_any_link() {
    let (mut back, mut constant, mut failures) = (0, 0, Vec::new());
    for (name, scene) in templates().into_iter().step_by(ALIKE.now()) {
        // The angle of a wheel, which knows no whole turns, tells the drive up to some teeth alone.
        if scene.get("gears").is_some() {
            continue;
        }
        let Some(open) = opened(&scene) else { continue };
        let (_, plain, truth) = solved(&scene).unwrap_or_else(|e| panic!("{name}: {e}"));
        let rates = motion(&plain, &truth, Order::Velocity).expect("it moves");
        let places = || (0..plain.points.len()).map(|p| (p, truth.points[p]));
        let size = places().fold(0.0, |m: f64, (_, p)| m.max(p.coords.norm()));
        for (id, body) in plain.links().filter(|(id, _)| plain.is_sought(*id)) {
            // Links that stand for contacts are no entries of the scene.
            if plain.is_equivalent(id) {
                continue;
            }
            let link = &body.name;
            let what = format!("{name} from angle({link})");
            let mut scene = open.clone();
            scene["links"][link]["angle"] = json!(degrees_of(truth.axes[id.0].expect("an axis")));
            for (p, place) in places() {
                scene["near"][&plain.points[p]] = json!([place.x, place.y]);
            }
            let omega = rates.body(id).omega.abs();
            match solved(&scene) {
                Ok((scene, again, pose)) => {
                    back += 1;
                    let fastest = rates.bodies.iter().fold(1.0, |m: f64, b| m.max(b.omega.abs()));
                    let bound = BOUND * fastest / omega;
                    for (p, place) in places() {
                        let off = (pose.points[p] - place).norm() / size;
                        if off.is_nan() || off > bound {
                            failures.push(format!("{what}: {} is {off:.1e} off", plain.points[p]));
                        }
                    }
                    // The same scene listed: the chosen mode is there under its number.
                    let all = poses(&again, &scene.near).expect("it was assembled");
                    let number = pose.assemblies[0].expect("a mode").mode;
                    let same = all[number - 1].points == pose.points;
                    assert!(same, "{what}: mode {number} is another");
                    let count = Count { number: all.len() as u64, is_exact: true };
                    let listed = listed_modes(&scene, &again, &Listed { poses: all, count });
                    assert!(listed.contains(&format!("{number:3}. ")));
                    let moved = motion(&again, &pose, Order::Acceleration).expect("it moves");
                    let error = (moved.body(id).omega - rates.body(id).omega).abs() / fastest;
                    assert!(error <= 100.0 * bound, "{what}: rate wrong by {error:.1e}");
                }
                Err(error) => {
                    // Links on guides of the ground never turn.
                    constant += 1;
                    let message = error.to_string();
                    if omega > 0.0 || !message.contains("does not change with that drive") {
                        failures.push(format!("{what}: {message}"));
                    }
                }
            }
        }
    }
    println!("{back} angles, {constant} links that do not turn");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    let every = ALIKE.now();
    assert!(back * every >= 31 && (every > 1 || constant >= 4), "{back}, {constant}");
}

/// A four-bar linkage; what stands in the drive of link 1, in link 2 and in link 3 comes from the case.
fn four_bar(drive: &str, second: &str, third: &str) -> String {
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [100, 0] }},
        "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 40 }}{drive} }},
                   "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 90 }}{second} }},
                   "3": {{ "points": ["C", "D"], "lengths": {{ "CD": 70 }}{third} }} }} }}"#
    )
}

#[test]
fn angles_that_do_not_count_out_get_a_message() {
    let message = |text: &str| {
        let scene = Scene::read(text).map_err(Error::from);
        let result = scene.and_then(|s| Ok(pose(&mechanism(&s)?, &s.near)?));
        let error = result.map(|_| ()).expect_err(text);
        error.to_string()
    };
    let (turned, open) = (r#", "drive": { "angle": 70, "omega": 1 }"#, r#", "drive": { "omega": 1 }"#);
    let angle = r#", "angle": 30"#;
    let cases = [
        (
            four_bar(turned, "", angle),
            "links.3.angle: link 3 gives an angle, but the drive of link 1 gives its angle already",
        ),
        (four_bar(open, "", ""), "links.1.drive: the drive of link 1 gives no `angle`"),
        (four_bar(open, angle, angle), "links.3.angle: links 2 and 3 both give an angle"),
        (four_bar("", "", angle), "links.3.angle: link 3 gives an angle, but no link has a drive"),
        (
            four_bar(open, "", open).replace(r#"BC": 90 }"#, r#"BC": 90 }, "angle": 30"#),
            "links.3.drive: the drives of link 1 and link 3 do not say where they stand",
        ),
        // CD turned so far that B cannot come round.
        (four_bar(open, "", r#", "angle": 180"#), "cannot be assembled at angle(3) = 180°"),
    ];
    for (text, words) in &cases {
        let message = message(text);
        assert!(message.contains(words), "`{words}` is not in: {message}");
    }
    // On the driven link itself it is the drive's own.
    let own = four_bar(&format!("{angle}{open}"), "", "");
    let same = four_bar(r#", "drive": { "angle": 30, "omega": 1 }"#, "", "");
    let places = |text: &str| {
        let scene: Value = serde_json::from_str(text).expect("JSON");
        solved(&scene).expect("it can be assembled").2.points
    };
    assert_eq!(places(&own), places(&same));
    let rocker = Scene::read(&four_bar(open, "", angle)).expect("a scene");
    let text = structure(&mechanism(&rocker).expect("a mechanism"), &Wording::default());
    let line = "positions from angle(3) = 30°: II(3) → II(1, 2)\n";
    assert!(text.contains(line), "{text}");
}

#[test]
fn a_pushed_piston_is_placed_by_its_crank() {
    let (crank, rod, angle) = (30.0, 80.0, 50.0_f64);
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": crank }, "angle": angle },
            "2": { "points": ["B", "C"], "lengths": { "BC": rod } },
            "3": { "points": ["C"], "drive": { "speed": 5 } }
        },
        "sliders": [{ "link": "3", "at": "C", "on": "ground" }],
        "near": { "C": [100, 0] }
    });
    let (_, mechanism, pose) = solved(&scene).expect("it can be assembled");
    let (sin, cos) = libm::sincos(angle.to_radians());
    let truth = crank * cos + (rod * rod - crank * crank * sin * sin).sqrt();
    let piston = pose.points[mechanism.point("C").expect("the piston's pin").0];
    assert!((piston.x - truth).abs() < 1e-12 * truth && piston.y.abs() < 1e-12);
    assert!((pose.slides[0].expect("a position") - truth).abs() < 1e-12 * truth);
}

/// Numbers are printed as the shortest text that reads as their f64, of which the text of the scene may have more digits: the bound is one of what is
/// printed, too.
#[test]
fn the_bound_of_a_given_angle_holds_for_its_printed_digits() {
    // 4.49e-15 more than the printed 107.90317726417761.
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [160, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "omega": 10 } },
                   "2": { "points": ["B", "C"], "lengths": { "BC": 140 } },
                   "3": { "points": ["D", "C"], "lengths": { "CD": 110 }, "angle": 107.90317726417761449 } },
        "near": { "B": [50, 40], "C": [150, 110] } }"#;
    let solution = support::stages::solved(scene).expect("a four-bar");
    let result = serde_json::to_value(solution.result()).expect("a result is JSON");
    let third = &result["links"]["3"];
    assert_eq!(third["angle"].to_string(), "107.90317726417761");
    let error = third["angle_error"].as_f64().expect("a bound");
    assert!((4.49e-15..2e-14).contains(&error), "{error:e}");
}
