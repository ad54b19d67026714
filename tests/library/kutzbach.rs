//! Kutzbach's speed diagram: the slopes of its lines against Willis' formula in whole numbers of teeth, its parallels as they are drawn, what is said
//! where it lacks meshes.

use crate::gears::solution;
use kinegon::Solution;
use kinegon::drawing::{Drawing, Point, Shape};
use serde_json::{Value, json};
use support::files;
use support::random::Random;

/// Random trains.
const COUNT: u64 = 100;

fn template(name: &str, panels: &Value) -> Value {
    let text = std::fs::read_to_string(files::path(&format!("templates/{name}.json"))).expect("a starting scene");
    let mut scene: Value = serde_json::from_str(&text).expect("JSON");
    scene.as_object_mut().expect("an object").remove("$schema");
    scene["figure"] = json!({ "panels": panels });
    scene
}

/// A planetary train whose arm 1 drives, with planet 2 between the fixed ring and sun 3.
fn planetary([sun, planet]: [i64; 2], arm: i64, angle: usize) -> Value {
    json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [3, 4] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": angle, "omega": arm } },
                   "2": ["B"], "3": ["A"] },
        "gears": [ { "mesh": ["3", "2"], "teeth": [sun, planet], "on": "1" },
                   { "mesh": ["2", "ground"], "teeth": [planet, -(sun + 2 * planet)], "on": "1" } ],
        "figure": { "panels": ["scheme", "speeds"] } })
}

/// All turned with the arm, and the arm held while the ring is turned back.
#[test]
fn slopes_are_the_angular_velocities_of_willis() {
    for seed in 0..COUNT {
        let mut dice = Random(seed);
        let [sun, planet] = [0; 2].map(|_| 17 + dice.below(44) as i64);
        let (ring, arm) = (sun + 2 * planet, 1 + dice.below(30) as i64);
        let solution = solution(&planetary([sun, planet], arm, 7 * dice.below(50)));
        let diagram = solution.construction.speeds.as_ref().expect("a diagram");
        assert_eq!(diagram.lines.len(), 3);
        for line in &diagram.lines {
            // As whole fractions: ω = numerator / denominator.
            let (numerator, denominator) = match solution.mechanism.body(line.link).name.as_str() {
                "1" => (arm, 1),
                "2" => (arm * (planet - ring), planet),
                _ => (arm * (sun + ring), sun),
            };
            let truth = numerator as f64 / denominator as f64;
            let [from, to] = line.through.map(|spot| diagram.spots[spot]);
            let slope = -(to.velocity - from.velocity) / (to.height - from.height);
            let allowed = 1e-12 * truth.abs().max(arm as f64);
            assert!((slope - truth).abs() <= allowed, "{seed}: {slope} for {truth}");
            assert!((diagram.rate(line) - truth).abs() <= allowed, "{seed}: {}", line.omega);
        }
    }
}

fn drawn(drawing: &Drawing, id: &str) -> [Point; 2] {
    let mark = drawing.marks.iter().find(|mark| mark.id.as_deref() == Some(id)).unwrap_or_else(|| panic!("no {id}"));
    match mark.shape {
        Shape::Line(from, to) => [from, to],
        ref other => panic!("{other:?}"),
    }
}

fn names(solution: &Solution) -> Vec<(String, f64)> {
    let diagram = solution.construction.speeds.as_ref().expect("a diagram");
    let name = |link| solution.mechanism.body(link).name.clone();
    diagram.lines.iter().map(|line| (name(line.link), line.omega)).collect()
}

/// Each ray is parallel to its line, and what the rays cut off the base is in proportion to angular velocities, in the same direction.
#[test]
fn parallels_cut_angular_velocities_off_one_base() {
    for kind in ["planetary", "differential", "gear-train", "reverted-train", "geared-five-bar"] {
        let solution = solution(&template(kind, &json!(["scheme", "speeds"])));
        let drawing = solution.figure();
        let mut lengths = Vec::new();
        for (link, omega) in names(&solution) {
            let [line, ray] = ["line", "ray"].map(|what| drawn(&drawing, &format!("speeds-{what}-{link}")));
            let [along, parallel] = [line, ray].map(|[from, to]| (to - from) / (to - from).hypot());
            assert!(along.cross(parallel).abs() < 1e-9, "{kind}: the ray of {link} is not parallel to its line");
            lengths.push(((ray[1] - ray[0]).x / omega, ray[1].y));
        }
        for (length, height) in &lengths {
            assert!(*length > 0.0 && (length - lengths[0].0).abs() < 1e-9 * length, "{kind}: {lengths:?}");
            assert!((height - lengths[0].1).abs() < 1e-9, "{kind}: {lengths:?}");
        }
    }
}

/// Turns a minute where a drive is given in these.
#[test]
fn speeds_are_told_in_the_unit_of_the_scene() {
    let mut scene = planetary([40, 20], 4, 40);
    scene["links"]["1"]["drive"] = json!({ "angle": 40, "rpm": 120 });
    let solution = solution(&scene);
    let diagram = solution.construction.speeds.as_ref().expect("a diagram");
    let rates: Vec<f64> = diagram.lines.iter().map(|line| diagram.rate(line)).collect();
    for (rate, truth) in rates.iter().zip([120.0, -360.0, 360.0]) {
        assert!((rate - truth).abs() < 1e-9, "{rates:?}");
    }
}

#[test]
fn what_the_diagram_lacks_is_said() {
    let four_bar = solution(&template("four-bar", &json!(["scheme", "speeds"])));
    assert!(four_bar.construction.speeds.is_none());
    assert!(four_bar.warnings().any(|text| text.contains("no two wheels mesh")));
    let mut bent = template("gear-train", &json!(["scheme", "speeds"]));
    bent["ground"]["F"] = json!([120, 75]);
    let bent = solution(&bent);
    assert_eq!(bent.construction.speeds.as_ref().expect("a diagram").left_out.len(), 1);
    let told: Vec<String> = bent.warnings().collect();
    assert!(told.iter().any(|text| text.contains("P23") && text.contains("A, D")), "{told:?}");
    let straight = solution(&template("gear-train", &json!(["scheme", "speeds"])));
    assert!(straight.warnings().all(|text| !text.contains("line of centres")));
}
