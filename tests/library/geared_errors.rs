//! Every stated error where wheels, racks, belts or contacts carry cranks, where the angle of another link stands in place of the drive's, and with
//! several drives, over whole turns, against the truth of 256 bits (`support::whole_errors::truth`).

use crate::whole_errors::{Seen, compare, remove_notes};
use serde_json::{Value, json};
use std::sync::Mutex;
use support::comparison::entries;
use support::files;
use support::random::Random;
use support::stages::solved;
use support::survey::{self, GEARED_STEP};
use support::whole_errors::carried::Carried;
use support::whole_errors::truth::Real;

/// Starting scenes with wheels, racks or contacts, some of which carry cranks.
const STARTING: [&str; 10] = [
    "geared-five-bar",
    "planetary",
    "planetary-sun-fixed",
    "sun-and-planet",
    "differential",
    "gear-train",
    "reverted-train",
    "rack-and-pinion",
    "eccentric-cam",
    "flat-follower",
];

/// So few of all numbers may be without a bound: next to limits, of which a link has one where it turns back.
const UNBOUNDED: f64 = 0.01;

/// A scene, each of whose points is of one link or of several.
fn scene(ground: Value, links: Value, sliders: Value, gears: Value, near: Value) -> Value {
    json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": ground, "links": links, "sliders": sliders, "gears": gears, "near": near })
}

/// Mechanisms of our own: phases, radii and positions of few digits, none of which f64 holds, and arms that hang on wheels, on planets and on racks.
fn own() -> Vec<(&'static str, Value)> {
    let two = |points: [&str; 2], length: f64| json!({ "points": points, "lengths": { points.concat(): length } });
    let driven = |points: [&str; 2], length: f64, drive: Value| json!({ "points": points, "lengths": { points.concat(): length }, "drive": drive });
    let none = || json!([]);
    vec![
        (
            "double-crank press",
            scene(
                json!({ "A": [-60, 0], "E": [60, 0] }),
                json!({ "1": driven(["A", "B"], 30.0, json!({ "angle": 110, "omega": 6 })), "2": two(["B", "C"], 150.0), "3": two(["D", "C"], 150.0),
                    "4": two(["E", "D"], 30.0), "5": two(["C", "F"], 120.0), "6": { "points": ["F"] } }),
                json!([{ "link": "6", "at": "F", "on": "ground", "through": [0, -250], "along": 90 }]),
                json!([{ "mesh": ["1", "4"], "teeth": [40, 40], "on": "ground", "phase": 150 }]),
                json!({ "C": [0, -130], "F": [0, -250] }),
            ),
        ),
        (
            "hypocycloid dwell",
            scene(
                json!({ "A": [0, 0] }),
                json!({ "1": driven(["A", "B"], 40.1, json!({ "angle": 75, "rpm": 50 })), "2": two(["B", "C"], 12.3), "3": two(["C", "D"], 150.7), "4": { "points": ["D"] } }),
                json!([{ "link": "4", "at": "D", "on": "ground", "through": "A", "along": 0.7 }]),
                json!([{ "mesh": ["2", "ground"], "teeth": [20, -60], "on": "1", "phase": 180.3 }]),
                json!({ "D": [160, 0] }),
            ),
        ),
        (
            "planet with a crank between two drives",
            scene(
                json!({ "A": [0.1, 0.2] }),
                json!({ "1": driven(["A", "B"], 60.3, json!({ "angle": 33.3, "omega": 2.7, "alpha": 0.3 })), "2": two(["B", "C"], 17.9),
                    "3": driven(["A", "E"], 40.0, json!({ "angle": -12.7, "omega": -4.1, "alpha": 1.1 })), "5": two(["C", "D"], 190.3), "6": { "points": ["D"] } }),
                json!([{ "link": "6", "at": "D", "on": "ground", "through": [3.3, 7.7], "along": 5.1 }]),
                json!([{ "mesh": ["3", "2"], "teeth": [40, 23], "on": "1", "phase": 31.7 }]),
                json!({ "D": [240, 20] }),
            ),
        ),
        (
            "rack that a lever's wheel pushes",
            scene(
                json!({ "A": [0, 0], "D": [180.3, 150.1], "G": [430.3, -120.1] }),
                json!({ "1": driven(["A", "B"], 40.0, json!({ "angle": 70, "rpm": 180 })), "2": two(["B", "C"], 190.3), "3": two(["D", "C"], 130.7), "4": { "points": ["E"] },
                    "5": two(["E", "F"], 210.3), "6": two(["G", "F"], 180.9) }),
                json!([{ "link": "4", "at": "E", "on": "ground", "through": [260.3, 150], "along": 90.7 }]),
                json!([{ "mesh": ["3", "4"], "teeth": [40, "rack"], "radius": 80.7, "on": "ground", "position": -200.3 }]),
                json!({ "C": [190, 20], "F": [400, 0] }),
            ),
        ),
        (
            "crank on a wheel that a driven rack turns",
            scene(
                json!({ "D": [0, 0], "G": [420.3, 160.7] }),
                json!({ "1": { "points": ["F"], "drive": { "position": -60.3, "speed": 40.7, "acceleration": 15.1 } }, "2": two(["D", "C"], 50.3),
                    "3": two(["C", "E"], 370.1), "4": two(["G", "E"], 200.9) }),
                json!([{ "link": "1", "at": "F", "on": "ground", "through": [0, -70.1], "along": 0.3 }]),
                json!([{ "mesh": ["2", "1"], "teeth": [28, "rack"], "radius": 70.1, "on": "ground", "position": -220.7 }]),
                json!({ "E": [360, -40] }),
            ),
        ),
        (
            "five-bar with an open belt",
            scene(
                json!({ "A": [0, 0], "E": [90.1, 3.3] }),
                json!({ "1": driven(["A", "B"], 40.3, json!({ "angle": 22, "omega": 4.4, "alpha": 0.7 })), "2": two(["B", "C"], 110.9), "3": two(["D", "C"], 101.3), "4": two(["E", "D"], 30.7) }),
                none(),
                json!([{ "mesh": ["1", "4"], "teeth": [48, 16], "on": "ground", "belt": "open", "radius": 30, "phase": 17.3 }]),
                json!({ "C": [60, 120] }),
            ),
        ),
        (
            "five-bar with a crossed belt",
            scene(
                json!({ "A": [0, 0], "E": [90.1, 3.3] }),
                json!({ "1": driven(["A", "B"], 40.3, json!({ "angle": 22, "omega": 4.4, "alpha": 0.7 })), "2": two(["B", "C"], 110.9), "3": two(["D", "C"], 101.3), "4": two(["E", "D"], 30.7) }),
                none(),
                json!([{ "mesh": ["1", "4"], "teeth": [20, 30], "on": "ground", "belt": "crossed", "radius": 30, "phase": -71.9 }]),
                json!({ "C": [60, 120] }),
            ),
        ),
    ]
}

/// Mechanisms with a hollow cam, with a cam of wheels' angle, and with a face of its own direction.
fn with_contacts() -> Vec<(&'static str, Value)> {
    let contact = |ground: Value, links: Value, sliders: Value, contacts: Value, gears: Value, near: Value| {
        let mut scene = scene(ground, links, sliders, gears, near);
        scene["contacts"] = contacts;
        scene
    };
    vec![
        (
            "roller in a hollow cam",
            contact(
                json!({ "A": [0.3, 0.1] }),
                json!({ "1": { "points": ["A", "K"], "lengths": { "AK": 20.1 }, "drive": { "angle": 50, "omega": 15.3, "alpha": 2.1 } }, "3": { "points": ["C"] } }),
                json!([{ "link": "3", "at": "C", "on": "ground", "through": [8.1, 0], "along": 90.3 }]),
                json!([{ "links": ["1", "3"], "centers": ["K", "C"], "radii": [-70.3, 12.1], "roller": true, "circular": true }]),
                json!([]),
                json!({ "C": [8, 60] }),
            ),
        ),
        (
            "disc on a meshed wheel under a flat follower",
            contact(
                json!({ "A": [0, 0], "B": [-110.3, 30.1], "M": [60.2, -70.1] }),
                json!({ "1": { "points": ["M", "N"], "lengths": { "MN": 12 }, "drive": { "angle": 10, "omega": 3.1, "alpha": 0.9 } },
                    "2": { "points": ["A", "K"], "lengths": { "AK": 18.3 } }, "3": { "points": ["B", "E"], "lengths": { "BE": 170.7 } } }),
                json!([]),
                json!([{ "links": ["2", "3"], "centers": ["K"], "radii": [38.1], "along": "BE", "circular": true }]),
                json!([{ "mesh": ["1", "2"], "teeth": [30, 17], "on": "ground", "phase": 40.7 }]),
                json!({ "E": [60, 60] }),
            ),
        ),
    ]
}

/// All of these by name.
fn scenes() -> Vec<(String, Value)> {
    let starting = files::templates().into_iter().filter(|(name, _)| STARTING.contains(&name.as_str()));
    let mut all: Vec<(String, Value)> = starting
        .map(|(name, text)| (name, serde_json::from_str(&text).expect("a scene is JSON")))
        .chain(own().into_iter().chain(with_contacts()).map(|(name, scene)| (name.to_owned(), scene)))
        .collect();
    assert_eq!(all.len(), STARTING.len() + own().len() + with_contacts().len(), "every starting scene is there");
    for (_, scene) in &mut all {
        remove_notes(scene);
        scene.as_object_mut().expect("an object").shift_remove("want");
    }
    all
}

/// The scene with its drives turned by so many degrees: the first by that, further ones by other multiples; sliders are pushed to and fro.
fn turned(scene: &Value, degrees: u64) -> Value {
    let mut scene = scene.clone();
    let mut times = 1;
    for link in scene["links"].as_object_mut().expect("links").values_mut() {
        let Some(drive) = link.get_mut("drive") else { continue };
        let moved = |from: &Value, by: f64| json!(((from.as_f64().expect("a number") + by) * 10.0).round() / 10.0);
        if let Some(angle) = drive.get_mut("angle") {
            *angle = moved(angle, (times * degrees) as f64);
            times += 1;
        }
        if let Some(position) = drive.get_mut("position") {
            *position = moved(position, 0.3 * degrees as f64);
        }
    }
    scene
}

/// The same position given by the angle of another link, if that tells it: with few digits, so that it is a position beside that one.
fn by_another_angle(scene: &Value) -> Vec<(String, Value)> {
    let Ok(solution) = solved(&scene.to_string()) else { return Vec::new() };
    let mechanism = &solution.mechanism;
    let driven: Vec<&String> = scene["links"]
        .as_object()
        .expect("links")
        .iter()
        .filter(|(_, link)| link["drive"].get("angle").is_some())
        .map(|(name, _)| name)
        .collect();
    let [driver] = driven.as_slice() else { return Vec::new() };
    let mut found = Vec::new();
    for (id, body) in mechanism.links().filter(|(_, body)| body.points.len() > 1) {
        let is_own = scene["links"].get(&body.name).is_some() && body.name != **driver;
        let Some(axis) = solution.pose.axes[id.0].filter(|_| is_own) else { continue };
        let mut scene = scene.clone();
        scene["links"][driver.as_str()]["drive"].as_object_mut().expect("a drive").shift_remove("angle");
        let degrees = libm::atan2(axis.y, axis.x).to_degrees();
        scene["links"][&body.name]["angle"] = json!((degrees * 10.0).round() / 10.0);
        for (name, place) in mechanism.points.iter().zip(&solution.pose.points) {
            if scene["ground"].get(name).is_none() {
                scene["near"][name] = json!([place.x, place.y]);
            }
        }
        found.push((body.name.clone(), scene));
    }
    found
}

/// Compares all results of a scene with the truth.
fn see(name: &str, scene: &Value, seen: &mut Seen) {
    match solved(&scene.to_string()) {
        Ok(solution) => compare(name, scene, &solution, 0, seen),
        Err(error) => seen.refuse(name, &error.to_string()),
    }
}

/// Goes through these cases on all cores.
fn see_all(cases: &[(String, Value)]) -> Seen {
    see_all_by(cases, see)
}

fn see_all_by(cases: &[(String, Value)], see: impl Fn(&str, &Value, &mut Seen) + Sync) -> Seen {
    let all = Mutex::new(Seen::default());
    survey::on_all_cores(cases.len() as u64, |number, (): &mut ()| {
        let (name, scene) = &cases[number as usize];
        let mut seen = Seen::default();
        see(name, scene, &mut seen);
        all.lock().expect("no case failed").join(seen);
    });
    all.into_inner().expect("no case failed")
}

/// Every so many degrees of a whole turn.
fn turn() -> impl Iterator<Item = u64> + Clone {
    (0..360).step_by(GEARED_STEP.now())
}

#[test]
fn hold_over_whole_turns() {
    let scenes = scenes();
    let at = |(name, scene): &(String, Value)| {
        turn().map(|degrees| (format!("lengths {name} {degrees}°"), turned(scene, degrees))).collect::<Vec<_>>()
    };
    let cases: Vec<(String, Value)> = scenes.iter().flat_map(at).collect();
    let seen = see_all(&cases);
    println!("{} positions of {} scenes", cases.len(), scenes.len());
    assert!(seen.holds(UNBOUNDED) > 6 * cases.len(), "few rates were compared");
}

#[test]
fn hold_where_another_link_has_the_angle() {
    let mut cases = Vec::new();
    for (name, scene) in scenes() {
        for degrees in turn().step_by(3) {
            let all = by_another_angle(&turned(&scene, degrees));
            cases.extend(all.into_iter().map(|(link, scene)| (format!("lengths {name} {degrees}° by {link}"), scene)));
        }
    }
    let seen = see_all(&cases);
    println!("{} positions", cases.len());
    assert!(seen.holds(5.0 * UNBOUNDED) > 6 * cases.len(), "few rates were compared");
}

/// A train of wheels on fixed axles: the text of its scene, and the angle of each wheel in degrees as a fraction, found by the meshes in whole numbers.
fn train(random: &mut Random) -> (String, Vec<[i128; 2]>) {
    const ANGLES: [(&str, i128); 5] = [
        ("30.3", 30_300),
        ("-1234567.8", -1_234_567_800),
        ("12345678901.25", 12_345_678_901_250),
        ("99999999999.7", 99_999_999_999_700),
        ("-77777777777777.3", -77_777_777_777_777_300),
    ];
    const PHASES: [(&str, i128); 4] = [("0", 0), ("0.3", 300), ("180.7", 180_700), ("-33.1", -33_100)];
    let (angle, thousandths) = ANGLES[random.below(ANGLES.len())];
    let mut angles = vec![[thousandths, 1000]];
    let (mut ground, mut links, mut gears) = (String::from("\"P0\": [0, 0]"), String::new(), Vec::new());
    for wheel in 1..=1 + random.below(4) {
        let teeth = [5 + random.below(9995), 5 + random.below(9995)];
        let (phase, of_phase) = PHASES[random.below(PHASES.len())];
        ground += &format!(", \"P{wheel}\": [{}, 0]", 100 * wheel);
        links += &format!(", \"L{wheel}\": {{ \"points\": [\"P{wheel}\"] }}");
        let mesh = [format!("L{}", wheel - 1), format!("L{wheel}")];
        gears.push(format!("{{ \"mesh\": {mesh:?}, \"teeth\": {teeth:?}, \"on\": \"ground\", \"phase\": {phase} }}"));
        let ([over, under], [first, second]) = (angles[wheel - 1], teeth.map(|teeth| teeth as i128));
        angles.push([of_phase * (under / 1000) * second - first * over, under * second]);
    }
    let scene = format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ {ground} }},
            "links": {{ "L0": {{ "points": ["P0"], "drive": {{ "angle": {angle}, "omega": 2 }} }}{links} }}, "gears": [{}] }}"#,
        gears.join(", ")
    );
    (scene, angles)
}

/// A mesh as an equation between directions holds for each tooth by which a wheel may be shifted. With so many teeth and turns f64 cannot tell which
/// of these positions is meant, and then no bound may be stated.
#[test]
fn whole_turns_are_counted_or_nothing_is_stated() {
    let mut random = Random(7);
    let (mut stated, mut unstated) = (0, 0);
    for number in 0..300 {
        let (scene, angles) = train(&mut random);
        // Where f64 has lost the turns, it is refused, too.
        let Ok(solution) = solved(&scene) else { continue };
        let result = serde_json::to_value(solution.result()).expect("a result is JSON");
        for (wheel, [over, under]) in angles.into_iter().enumerate() {
            let own = &result["links"][format!("L{wheel}")];
            let Some(error) = own["angle_error"].as_f64() else {
                unstated += 1;
                continue;
            };
            let within_a_turn = (over % (360 * under)) as f64 / under as f64;
            let off = (own["angle"].as_f64().expect("an angle") - within_a_turn).rem_euclid(360.0);
            let off = off.min(360.0 - off);
            assert!(off <= error + 1e-12, "{number}: wheel {wheel} is {off}° off, {error}° are stated: {scene}");
            stated += 1;
        }
    }
    println!("{stated} stated, {unstated} not");
    assert!(stated > 800 && unstated > 0, "{stated} angles stated, {unstated} not");
}

#[test]
fn angles_that_lose_their_turns_are_refused_beside_gears_alone() {
    let train = files::read("templates/gear-train.json");
    let mut scene: Value = serde_json::from_str(&train).expect("a scene is JSON");
    let drive = scene["links"]
        .as_object_mut()
        .expect("links")
        .values_mut()
        .find_map(|link| link.get_mut("drive"))
        .expect("a drive");
    drive["angle"] = json!(1e15);
    let told = solved(&scene.to_string()).expect_err("its turns are lost").to_string();
    assert!(told.contains("too large for an angle beside gears"), "{told}");
    let four_bar = files::read("templates/four-bar.json").replacen("\"angle\": 60", "\"angle\": 1e15", 1);
    assert!(four_bar.contains("1e15"), "the angle is replaced");
    solved(&four_bar).expect("a link comes back after a turn");
}

/// The scene with masses, forces, a table over the first link's angle and one over a slider's position, a spring and teeth that push apart.
fn loaded(scene: &Value) -> Value {
    let mut scene = scene.clone();
    scene["units"] = json!({ "length": "mm", "time": "s", "mass": "kg", "force": "N" });
    scene["gravity"] = json!([0.7, -9810.3]);
    for gear in scene.get_mut("gears").and_then(Value::as_array_mut).into_iter().flatten() {
        gear["pressure"] = json!(20.3);
    }
    let (mut forces, mut last) = (Vec::new(), None);
    let (mut crank, sliders) = (None, scene["sliders"].clone());
    for (name, link) in scene["links"].as_object_mut().expect("links") {
        if link["drive"].get("angle").is_some() {
            crank.get_or_insert(name.clone());
        }
        let Some(points) = link["points"].as_array().filter(|points| points.len() > 1).cloned() else { continue };
        (link["mass"], link["inertia"], link["center"]) = (json!(0.7), json!(1350.3), json!([11.3, 4.1]));
        forces.push(json!({ "on": name, "couple": 170.3 }));
        last = Some((name.clone(), points[1].clone()));
    }
    let (last, end) = last.expect("a link with two points");
    if let Some(crank) = crank {
        let table = json!([[0.1, 0.3], [90.3, 1.7], [200.7, -0.3], [200.7, -1.1], [300.1, 0.9]]);
        forces.push(json!({ "on": last, "at": end, "force": [-140.7, 30.1], "over": { "of": format!("angle({crank})"), "table": table } }));
        let table = json!([[-170.7, 0.1], [-20.3, 1.3], [170.9, 0.7]]);
        forces.push(json!({ "on": last, "at": 7.3, "force": [10.1, 50.3], "turns": true, "over": { "of": format!("angle({last})"), "table": table } }));
    }
    for slider in sliders.as_array().into_iter().flatten().filter(|slider| slider["link"].is_string()) {
        let (link, at) = (slider["link"].as_str().expect("a link"), &slider["at"]);
        let table = json!([[-1000.1, 0.3], [90.1, 1.1], [91.3, -0.7], [1000.3, 2.9]]);
        let of = format!("position({link}/{})", slider["on"].as_str().expect("a link"));
        forces.push(json!({ "on": link, "at": at, "force": [35.3, 21.1], "over": { "of": of, "table": table } }));
    }
    let (frame, _) = scene["ground"].as_object().and_then(|ground| ground.iter().next()).expect("a point of the frame");
    scene["springs"] = json!([{ "between": [["ground", frame], [last, [30.7, 9.1]]], "rate": 0.37, "length": 25.3 }]);
    scene["forces"] = forces.into();
    scene
}

/// Compares what joints carry and drives need with the truth.
fn see_forces(name: &str, scene: &Value, seen: &mut Seen) {
    let solution = match solved(&scene.to_string()) {
        Ok(solution) => solution,
        Err(error) => return seen.refuse(name, &error.to_string()),
    };
    let Some(truth) = crate::whole_errors::truth_of(scene, &solution) else { return seen.untell() };
    let Some(carried) = Carried::new(scene, &truth) else { return seen.untell() };
    seen.solve();
    let result = serde_json::to_value(solution.result()).expect("a result is JSON");
    let found = &result["forces"];
    assert!(found.is_object(), "{name}: no forces\n{scene}");
    let bound = |error: &Value| error.as_f64().unwrap_or(f64::INFINITY);
    let mut one = |what: String, value: &Value, error: &Value, truth: &Real| {
        let value = value.as_f64().unwrap_or_else(|| panic!("{name}: {what} is {value}"));
        seen.number(|| format!("{name}: {what}"), value, bound(error), truth);
    };
    for (drive, own) in entries(&found["drives"]) {
        match carried.torque(drive) {
            Some(torque) => one(format!("T({drive})"), &own["torque"], &own["error"], &torque),
            None => {
                let guide =
                    scene["sliders"].as_array().expect("sliders").iter().position(|slider| slider["link"] == drive);
                let push = carried.push(guide.expect("a driven slider")).expect("a drive");
                one(format!("F({drive})"), &own["force"], &own["error"], &push);
            }
        }
    }
    let touching: Vec<&Value> = scene["contacts"]
        .as_array()
        .into_iter()
        .flatten()
        .flat_map(|c| c["centers"].as_array().expect("centres"))
        .collect();
    for (pin, links) in entries(&found["reactions"]).filter(|(pin, _)| touching.iter().all(|center| center != pin)) {
        for (link, own) in entries(links) {
            let force = carried.at_pin(pin, link);
            (0..2).for_each(|axis| {
                one(format!("R({pin},{link})[{axis}]"), &own["force"][axis], &own["force_error"], &force[axis])
            });
        }
    }
    for (index, (slider, own)) in entries(&found["sliders"]).enumerate() {
        let [across, couple] = carried.in_guide(index);
        one(format!("N({slider})"), &own["normal"], &own["normal_error"], &across.expect("its force"));
        if let Some(couple) = couple {
            one(format!("M({slider})"), &own["couple"], &own["couple_error"], &couple);
        }
    }
    for (mesh, own) in entries(&found["meshes"]) {
        let (first, second) = mesh.split_once('/').expect("two wheels");
        let force = carried.between(first, second).expect("its teeth");
        one(format!("W({mesh})"), &own["tangential"], &own["tangential_error"], &force);
    }
    assert!(found["disagreement"].as_f64() <= found["disagreement_allowed"].as_f64(), "{name}: {found}");
}

#[test]
fn forces_with_tables_hold_over_whole_turns() {
    let mut cases = Vec::new();
    for (name, scene) in scenes().into_iter().filter(|(_, scene)| !scene.to_string().contains("belt")) {
        let scene = loaded(&scene);
        cases.extend(turn().step_by(2).map(|degrees| (format!("{name} {degrees}°"), turned(&scene, degrees))));
    }
    let seen = see_all_by(&cases, see_forces);
    println!("{} positions", cases.len());
    assert!(seen.holds_numbers(UNBOUNDED) > 10 * cases.len(), "few forces were compared");
}
