//! Kutzbach's speed diagram: the slopes of its lines against Willis' formula in whole numbers of teeth, its parallels as they are drawn, what is said
//! where it lacks meshes.

use crate::gears::solution;
use kinegon::Solution;
use kinegon::construction::{SpeedLine, Tolerance};
use kinegon::cycle::Pull;
use kinegon::drawing::{Drawing, HeldLayout, Pane, Point, Shape};
use kinegon::geometry::direction_of_degrees;
use kinegon::quantity::pencil;
use serde_json::{Value, json};
use std::collections::BTreeMap;
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
            let [from, to] = line.through.map(|spot| &diagram.spots[spot]);
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

/// The names below the base, each with its number.
fn told(drawing: &Drawing) -> Vec<(String, String)> {
    let text = |id: &str| {
        let mark = drawing.marks.iter().find(|mark| mark.id.as_deref() == Some(id))?;
        let Shape::Text(text) = &mark.shape else { return None };
        Some(text.text.content())
    };
    let all = (0..20).filter_map(|line| {
        Some((text(&format!("speeds-label-rate-{line}"))?, text(&format!("speeds-label-value-{line}"))?))
    });
    all.collect()
}

/// What lies close on paper and is not equal has a name and a number of its own; equal are speeds whose whole fractions are.
#[test]
fn only_equal_speeds_are_told_as_equal() {
    // Carrier 300; planets 300 − 30/18 and 300 + 30/18, the other sun 299 rpm: all within a hair's breadth of each other.
    let scene = serde_json::from_str(&files::read("tests/trains/differential-301.json")).expect("JSON");
    let mut found = told(&solution(&scene).figure());
    found.sort();
    let wanted = [("n1", "300"), ("n2", "298"), ("n3", "302"), ("n4", "301"), ("n5", "299")];
    assert_eq!(found, wanted.map(|(name, number)| (name.to_owned(), number.to_owned())));
    // Arm and sun of a planetary train with a free ring driven by whole numbers that are nearly or quite the same.
    for seed in 0..COUNT {
        let mut dice = Random(seed);
        let [sun, planet] = [0; 2].map(|_| 17 + dice.below(44) as i64);
        let (ring, arm, turned) = (sun + 2 * planet, 5000 + dice.below(3) as i64, dice.below(2) as i64);
        let mut scene = planetary([sun, planet], arm, 20);
        scene["links"]["3"] =
            json!({ "points": ["A", "E"], "lengths": { "AE": 9 }, "drive": { "angle": 0, "omega": arm + turned } });
        scene["links"]["4"] = json!(["A"]);
        scene["gears"][1]["mesh"][1] = json!("4");
        // Numerators of ω over planet · ring.
        let rates =
            [("1", 0), ("2", -turned * sun * ring), ("3", turned * planet * ring), ("4", -turned * sun * planet)];
        let mut wanted: BTreeMap<i64, Vec<String>> = BTreeMap::new();
        rates.into_iter().for_each(|(link, rate)| wanted.entry(rate).or_default().push(format!("\u{3c9}{link}")));
        let found = told(&solution(&scene).figure());
        let parted = |(names, _): &(String, String)| {
            let mut parts: Vec<String> = names.split('=').map(|name| name.trim().to_owned()).collect();
            parts.sort();
            parts
        };
        let mut found: Vec<Vec<String>> = found.iter().map(parted).collect();
        found.sort();
        let mut wanted: Vec<Vec<String>> = wanted.into_values().collect();
        wanted.sort();
        assert_eq!(found, wanted, "{seed}: arm {arm}, sun {}", arm + turned);
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

/// ω of a link by its line, from the velocities of two spots of it and their heights; none of what slides.
fn slopes(solution: &Solution) -> Vec<(String, f64)> {
    let diagram = solution.construction.speeds.as_ref().expect("a diagram");
    let turning = diagram.lines.iter().filter(|line| !line.slides);
    let slope = |line: &SpeedLine| {
        let [from, to] = line.through.map(|spot| &diagram.spots[spot]);
        let name = solution.mechanism.body(line.link).name.clone();
        (name, -(to.velocity - from.velocity) / (to.height - from.height))
    };
    turning.map(slope).collect()
}

fn velocity(solution: &Solution, spot: &str) -> f64 {
    let diagram = solution.construction.speeds.as_ref().expect("a diagram");
    diagram.spots.iter().find(|own| own.name == spot).unwrap_or_else(|| panic!("no {spot}")).velocity
}

/// A chain of wheels on the frame, each in any direction from the one before it; ω by the teeth alone, each idler changing the sense.
#[test]
fn trains_that_bend_are_turned_onto_one_line() {
    for seed in 0..COUNT {
        let mut dice = Random(seed);
        let count = 3 + dice.below(3);
        let teeth: Vec<i64> = (0..count).map(|_| 17 + dice.below(60) as i64).collect();
        let (mut at, mut ground, mut links) = ([0.0, 0.0], json!({}), json!({}));
        for (index, own) in teeth.iter().enumerate() {
            if index > 0 {
                let way = direction_of_degrees(dice.below(360) as f64);
                let distance = (teeth[index - 1] + own) as f64;
                at = [at[0] + distance * way.x, at[1] + distance * way.y];
            }
            ground[format!("C{index}")] = json!(at);
            links[(index + 1).to_string()] = json!([format!("C{index}")]);
        }
        links["1"] = json!({ "points": ["C0", "E"], "lengths": { "C0E": 20 }, "drive": { "angle": 10, "omega": 3 } });
        let mesh = |index: usize| json!({ "mesh": [index.to_string(), (index + 1).to_string()], "teeth": teeth[index - 1..=index], "on": "ground" });
        let gears: Vec<Value> = (1..count).map(mesh).collect();
        let solution = solution(&json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": ground,
            "links": links, "gears": gears, "figure": { "panels": ["scheme", "speeds"] } }));
        let diagram = solution.construction.speeds.as_ref().expect("a diagram");
        assert!(diagram.left_out.is_empty(), "{seed}: {:?}", diagram.left_out);
        assert_eq!(diagram.lines.len(), count, "{seed}");
        for (name, slope) in slopes(&solution) {
            let index = name.parse::<usize>().expect("a number") - 1;
            let sense = if index % 2 == 0 { 1.0 } else { -1.0 };
            let truth = sense * 3.0 * teeth[0] as f64 / teeth[index] as f64;
            assert!((slope - truth).abs() < 1e-9, "{seed}: ω of {name} is {slope}, not {truth}");
        }
        // A rim has the speed of the first one all along the chain: ω z m / 2, here with a module of 2.
        for index in 1..count {
            let rim = velocity(&solution, &format!("P{}{}", index, index + 1)).abs();
            assert!((rim - 3.0 * teeth[0] as f64).abs() < 1e-9, "{seed}: {rim}");
        }
    }
}

/// Planets on arms in any directions between a fixed ring and a sun.
#[test]
fn planets_on_radial_arms_are_turned_onto_one_line() {
    let mut scene = planetary([40, 20], 4, 40);
    scene["links"]["1"] = json!({ "shape": { "A": 0, "B": 60, "K": [-33, 48] }, "drive": { "angle": 40, "omega": 4 } });
    scene["links"]["5"] = json!(["K"]);
    let [distance, sun] = [f64::sqrt(33.0 * 33.0 + 48.0 * 48.0), 40.0];
    scene["gears"].as_array_mut().expect("gears").push(json!({ "mesh": ["3", "5"], "teeth": [40, 17], "on": "1" }));
    let solution = solution(&scene);
    let diagram = solution.construction.speeds.as_ref().expect("a diagram");
    assert!(diagram.left_out.is_empty(), "{:?}", diagram.left_out);
    // With the arm held ω_5 − 4 = −(12 − 4) · 40/17.
    let truth = 4.0 - 8.0 * sun / 17.0;
    let found = slopes(&solution).into_iter().find(|(name, _)| name == "5").expect("link 5").1;
    assert!((found - truth).abs() < 1e-9, "{found}");
    assert!((velocity(&solution, "K").abs() - 4.0 * distance).abs() < 1e-9);
    // A mesh between two planets on arms that are not in one line cannot be turned: distances from the sun would not stay.
    scene["gears"].as_array_mut().expect("gears").pop();
    scene["gears"].as_array_mut().expect("gears").push(json!({ "mesh": ["2", "5"], "teeth": [20, 17], "on": "1" }));
    let bent = crate::gears::solution(&scene);
    assert_eq!(bent.construction.speeds.as_ref().expect("a diagram").left_out, ["P25"]);
    assert!(bent.warnings().any(|text| text.contains("P25") && text.contains("cannot be turned")));
}

/// ω = v / r on a rack; equal rim speeds of an open belt, and of a crossed one in the other sense.
#[test]
fn racks_and_belts_have_lines() {
    for seed in 0..COUNT {
        let mut dice = Random(seed);
        let [radius, speed] = [0; 2].map(|_| 5.0 + dice.below(900) as f64 / 10.0);
        let along = dice.below(360);
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [150, 40] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 30 } }, "2": { "points": ["F"], "drive": { "position": 60, "speed": speed } }, "3": ["D"] },
            "sliders": [{ "link": "2", "at": "F", "on": "ground", "along": along, "through": "A" }],
            "gears": [ { "mesh": ["1", "2"], "teeth": [20, "rack"], "radius": radius, "on": "ground" },
                       { "mesh": ["1", "3"], "teeth": [2, 3], "belt": if seed % 2 == 0 { "open" } else { "crossed" }, "radius": 20, "on": "ground" } ],
            "figure": { "panels": ["scheme", "speeds"] } });
        let solution = solution(&scene);
        let diagram = solution.construction.speeds.as_ref().expect("a diagram");
        assert!(diagram.left_out.is_empty(), "{seed}: {:?}", diagram.left_out);
        let found = slopes(&solution);
        // The guide runs through the centre, so the pitch line lies to its right: the wheel turns with + (s − position) / r.
        let truth = speed / radius;
        let other = if seed % 2 == 0 { truth * 2.0 / 3.0 } else { -truth * 2.0 / 3.0 };
        for (name, truth) in [("1", truth), ("3", other)] {
            let own = found.iter().find(|(link, _)| link == name).expect("its line").1;
            assert!((own - truth).abs() < 1e-9 * truth.abs().max(1.0), "{seed}: ω of {name} is {own}, not {truth}");
        }
        assert!((velocity(&solution, "P12").abs() - speed).abs() < 1e-9 * speed, "{seed}");
        let rims = ["R13", "R31"].map(|rim| velocity(&solution, rim));
        assert!((rims[0] - rims[1]).abs() < 1e-9 * speed && (rims[0].abs() - truth * 20.0).abs() < 1e-9 * speed * 20.0);
    }
}

#[test]
fn steps_say_the_equations_of_racks_and_belts() {
    let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [150, 40] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 30 }, "drive": { "angle": 0, "omega": 6 } }, "2": ["F"], "3": ["D"] },
        "sliders": [{ "link": "2", "at": "F", "on": "ground", "along": 0, "through": "A" }],
        "gears": [ { "mesh": ["1", "2"], "teeth": [20, "rack"], "radius": 30, "on": "ground" },
                   { "mesh": ["1", "3"], "teeth": [2, 3], "belt": "open", "on": "ground" } ],
        "figure": { "panels": ["scheme", "speeds"] } });
    let solution = solution(&scene);
    let steps = solution.steps(&pencil(&solution, &solution.scales(), Tolerance::default(), Vec::new()));
    for equation in ["30 ω_1 = v_r(2/ground)", "2 ω_1 − 3 ω_3 = 0"] {
        assert!(steps.contains(equation), "{equation}\n{steps}");
    }
    let told: Vec<String> = solution.warnings().collect();
    assert!(told.iter().any(|text| text.contains("belt of 1 and 3") && text.contains("give its radius")), "{told:?}");
}

#[test]
fn what_the_diagram_lacks_is_said() {
    let four_bar = solution(&template("four-bar", &json!(["scheme", "speeds"])));
    assert!(four_bar.construction.speeds.is_none());
    assert!(four_bar.warnings().any(|text| text.contains("no two wheels mesh")));
    let mut bent = template("gear-train", &json!(["scheme", "speeds"]));
    bent["ground"]["F"] = json!([120, 75]);
    let bent = solution(&bent);
    let turned = &bent.construction.speeds.as_ref().expect("a diagram").turned;
    let names: Vec<&str> = turned.iter().map(|&point| bent.mechanism.point_name(point)).collect();
    assert_eq!(names, ["F"]);
    assert!(bent.warnings().all(|text| !text.contains("line of centres")));
    let straight = solution(&template("gear-train", &json!(["scheme", "speeds"])));
    assert!(straight.warnings().all(|text| !text.contains("line of centres")));
}

/// While a mechanism plays on a telephone scales and the line from which velocities are laid off stand still, and nothing is cut off.
#[test]
fn nothing_jumps_while_a_rack_plays() {
    for kind in ["rack-and-pinion", "planetary", "geared-five-bar", "differential"] {
        let own = solution(&template(kind, &json!(["scheme", "speeds"])));
        let telephone = Pane { width: 344.0, height: 420.0, letters: 12.0, words: false };
        let mut layout = HeldLayout::of_cycle(&own, None, None, Some(telephone));
        let mut pull = Pull::new(&own, None).expect("a drive");
        let from = pull.value();
        let mut scale = None;
        for quarter in 0..4 {
            let moved = own.moved(pull.to_value(from + 90.0 * f64::from(quarter)).pose).expect("it moves");
            let drawing = layout.drag(&moved, None, None);
            if let Ok(folder) = std::env::var("KINEGON_PICTURES_OF_SPEEDS") {
                std::fs::write(format!("{folder}/{kind}-{quarter}.svg"), drawing.svg()).expect("written");
            }
            assert!(layout.panels(&drawing).iter().all(|panel| !panel.is_cut), "{kind} {quarter}: something is cut");
            let diagram = moved.construction.speeds.as_ref().expect("a diagram");
            for spot in diagram.spots.iter().filter(|spot| spot.velocity.abs() > 1.0) {
                let id = format!("speeds-velocity-{}", spot.name);
                let Some(mark) = drawing.marks.iter().find(|mark| mark.id.as_deref() == Some(&id)) else { continue };
                let Shape::Arrow { from, to, .. } = mark.shape else { panic!("{:?}", mark.shape) };
                let now = [(to.x - from.x) / spot.velocity, from.x];
                let [length, zero] = *scale.get_or_insert(now);
                assert!((now[0] - length).abs() < 1e-6 * length, "{kind} {quarter}: the scale of velocities jumps");
                assert!((now[1] - zero).abs() < 1e-6, "{kind} {quarter}: velocities begin elsewhere");
            }
        }
    }
}
