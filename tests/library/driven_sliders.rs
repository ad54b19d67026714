//! Driven sliders on moving links: hydraulic cylinders, telescopes, sliders on driven cranks. True numbers from lengths and as
//! drawn, two routes that agree, plans that close and have what the drives add as vectors of their own.
//!
//! `tests/driven_sliders/README.md` says where the true numbers come from. A new case is a new pair of files.

use kinegon::Order;
use kinegon::Solution;
use kinegon::construction::{Action, Plan, VectorPart, image_name};
use kinegon::format::ResultFile;
use kinegon::geometry::{Vector, cross, direction_of_degrees};
use serde_json::{Value, json};
use std::path::PathBuf;
use support::comparison::{Comparison, decimal, entries};
use support::exact::exceeds;
use support::files;
use support::stages::solved;

/// Errors allowed, in units of the condition number of the velocity equations.
const BOUND: f64 = 1e-14;

/// How far a ray may pass by its crossing, in sizes of the plan and units of the condition number.
const CLOSED: f64 = 1e-14;

/// Groups of higher class: without plans, and their modes are searched for. The results say so.
const HIGHER: [&str; 2] = ["braced-mast", "scissor-lift"];

struct Case {
    name: String,
    scene: Value,
    expect: Value,
}

fn cases() -> Vec<Case> {
    let folder = files::path("tests/driven_sliders");
    let read = |path: PathBuf| -> Value {
        let text = std::fs::read_to_string(&path).expect("a case can be read");
        serde_json::from_str(&text).expect("a case is JSON")
    };
    let files = std::fs::read_dir(&folder).expect("the folder is there");
    let mut names: Vec<String> = files
        .map(|entry| entry.expect("the folder can be listed").file_name())
        .filter_map(|name| Some(name.to_str()?.strip_suffix(".expect.json")?.to_owned()))
        .collect();
    names.sort();
    assert!(names.len() >= 11, "only {names:?}");
    let case = |name: String| Case {
        scene: read(folder.join(format!("{name}.json"))),
        expect: read(folder.join(format!("{name}.expect.json"))),
        name,
    };
    names.into_iter().map(case).collect()
}

fn solution(name: &str, scene: &Value) -> Solution {
    solved(&scene.to_string()).unwrap_or_else(|error| panic!("{name}: {error}\n{scene}"))
}

fn condition(result: &ResultFile) -> f64 {
    let conditions = result.groups.iter().map(|group| group.condition);
    conditions.fold(1.0, f64::max)
}

fn number(truth: &Value) -> f64 {
    decimal(truth).parse().expect("a decimal number")
}

/// The case as a drawn configuration: places and guides' directions from the truth, speeds and accelerations only.
fn drawn(case: &Case) -> Value {
    let (scene, expect) = (&case.scene, &case.expect);
    let points: serde_json::Map<String, Value> = entries(&expect["points"])
        .map(|(name, point)| {
            let place = [0, 1].map(|axis| number(&point["position"][axis]));
            (name.to_owned(), json!(place))
        })
        .collect();
    let ground: Vec<&str> = entries(&scene["ground"]).map(|(name, _)| name).collect();
    let links: serde_json::Map<String, Value> = entries(&scene["links"])
        .map(|(name, link)| {
            let shape = entries(&link["shape"]).map(|(point, _)| json!(point));
            let points = link.get("points").cloned();
            let mut drawn = json!({ "points": points.unwrap_or_else(|| shape.collect()) });
            if let Some(drive) = link.get("drive") {
                drawn["drive"] = json!({ "omega": drive["omega"], "alpha": drive["alpha"] });
            }
            (name.to_owned(), drawn)
        })
        .collect();
    let sliders = scene["sliders"].as_array().into_iter().flatten();
    let sliders: Vec<Value> = sliders
        .map(|slider| {
            let on = slider["on"].as_str().expect("a name");
            let along = match &slider["along"] {
                Value::String(points) => json!(points),
                degrees => {
                    let own = expect["links"].get(on).map(|link| number(&link["angle"]));
                    let angle = own.unwrap_or(0.0) + degrees.as_f64().unwrap_or(0.0);
                    let direction = direction_of_degrees(angle);
                    json!([direction.x, direction.y])
                }
            };
            let mut drawn = json!({ "link": slider["link"], "at": slider["at"], "on": on, "along": along });
            if let Some(drive) = slider.get("drive") {
                let mut drive = drive.clone();
                drive.as_object_mut().expect("keys").remove("position");
                drawn["drive"] = drive;
            }
            drawn
        })
        .collect();
    json!({ "kinegon": 1, "units": scene["units"], "ground": ground, "points": points, "links": links, "sliders": sliders })
}

/// Checks all numbers of a result against the truth.
fn demand_truth(name: &str, case: &Case, result: &ResultFile, places: bool) {
    let mut expect = case.expect.clone();
    if !places {
        // As drawn a slider's position counts from elsewhere, and a link with one point has its guide for axis.
        for slider in expect["sliders"].as_object_mut().expect("sliders").values_mut() {
            slider.as_object_mut().expect("keys").remove("position");
        }
        for link in expect["links"].as_object_mut().expect("links").values_mut() {
            link.as_object_mut().expect("keys").remove("angle");
        }
    }
    let mut comparison = Comparison::new(&expect, &case.scene, result);
    comparison.all();
    assert_eq!(comparison.problems, [""; 0], "{name}");
    assert!(comparison.errors.len() > 20, "{name}");
    let bound = BOUND * condition(result);
    for (error, what) in &comparison.errors {
        assert!(!exceeds(*error, bound), "{name}: {what} is wrong by {error:e}, allowed is {bound:e}");
    }
    assert!(result.warnings.is_empty() || HIGHER.contains(&case.name.as_str()), "{name}: {:?}", result.warnings);
}

#[test]
fn numbers_are_true_from_lengths_and_as_drawn() {
    for case in cases() {
        let result = solution(&case.name, &case.scene).result();
        demand_truth(&case.name, &case, &result, true);
        // Of modes that a search finds there is no true number.
        if !HIGHER.contains(&case.name.as_str()) {
            let modes = |group: &Value| group["modes"].as_u64();
            let truth = case.expect["groups"].as_array().into_iter().flatten();
            let found: Vec<_> = result.groups.iter().map(|g| g.modes.map(|m| m as u64)).collect();
            assert_eq!(found, truth.map(modes).collect::<Vec<_>>(), "{}", case.name);
        }
        let name = format!("{} as drawn", case.name);
        let result = solution(&name, &drawn(&case)).result();
        demand_truth(&name, &case, &result, false);
        let truth = case.expect["groups"].as_array().expect("a list");
        assert_eq!(result.groups.len(), truth.len(), "{name}");
        for (group, truth) in result.groups.iter().zip(truth) {
            let mut links = group.links.clone();
            links.sort();
            let mut expected: Vec<&str> =
                truth["links"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
            expected.sort_unstable();
            assert_eq!(
                (links, truth["class"].as_str()),
                (expected.iter().map(|&l| l.to_owned()).collect(), Some(group.class)),
                "{name}"
            );
        }
    }
}

#[test]
fn both_routes_agree() {
    for case in cases() {
        let scene = drawn(&case);
        for group in solution(&case.name, &scene).result().groups {
            let (Some(difference), Some(allowed)) = (group.disagreement, group.disagreement_allowed) else {
                assert_eq!(group.class, "higher", "{}: {:?}", case.name, group.links);
                continue;
            };
            assert!(!exceeds(difference, allowed), "{}: {difference:e} > {allowed:e}", case.name);
            // The allowance says something.
            assert!(allowed < 1e-11 * group.condition, "{}: {allowed:e}", case.name);
        }
    }
}

/// Checks that every step starts where the plan has come, that each ray leads to its crossing, and that the images of the
/// mechanism's points are their velocities or accelerations by the loop equations.
fn demand_closed(name: &str, solution: &Solution, plan: &Plan) {
    let size = plan.points.values().fold(0.0, |m: f64, p| m.max(p.vector.norm()));
    let bound = CLOSED * condition(&solution.result()) * size;
    let mut reached: Vec<&str> = Vec::new();
    // The image of a point at rest under a slider is there from the beginning.
    let is_there =
        |reached: &[&str], point: &str| reached.contains(&point) || plan.points[point].vector == Vector::zeros();
    for action in &solution.construction.steps[plan.sheet()] {
        match action {
            Action::Pole { images, .. } => {
                reached.push(plan.order.pole());
                reached.extend(images.iter().map(String::as_str));
            }
            Action::LayOff(arrow) => {
                assert!(is_there(&reached, &arrow.from), "{name}: {arrow:?}");
                reached.push(&arrow.to);
            }
            Action::Ray(ray) => {
                let start = plan.points[&ray.through].vector;
                assert!(is_there(&reached, &ray.through), "{name}: {ray:?}");
                let miss = cross(ray.direction, plan.points[&ray.to].vector - start);
                assert!(!exceeds(miss.abs(), bound), "{name}: {ray:?} misses by {miss:e}");
            }
            Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => {
                reached.push(point);
            }
            _ => {}
        }
    }
    for (index, point) in solution.mechanism.points.iter().enumerate() {
        let Some(image) = plan.points.get(&image_name(point)) else {
            continue;
        };
        let bodies = solution.mechanism.bodies.iter();
        let holds = |b: &kinegon::mechanism::Body| b.points.iter().any(|p| p.0 == index);
        for (body, _) in bodies.enumerate().filter(|(_, b)| holds(b)) {
            let (motion, at) = (&solution.motion.bodies[body], solution.pose.points[index]);
            let truth = match plan.order {
                Order::Velocity => motion.velocity_at(at),
                Order::Acceleration => motion.acceleration_at(at),
            };
            let off = (image.vector - truth).norm();
            assert!(!exceeds(off, bound), "{name}: the image of {point} is {off:e} off");
        }
    }
}

#[test]
fn plans_close_and_show_what_drives_add() {
    for case in cases() {
        let name = &case.name;
        let solution = solution(name, &drawn(&case));
        let condition = condition(&solution.result());
        let constructed = solution.construction.agreement.iter().all(Option::is_some);
        for plan in solution.construction.plans() {
            demand_closed(name, &solution, plan);
            if !constructed {
                continue;
            }
            let has = |kind: VectorPart, length: f64| {
                let arrows = solution.construction.arrows(plan.order).filter(|arrow| arrow.part() == kind);
                let mut lengths = arrows.filter_map(|a| Some(plan.segment(&a.from, &a.to)?.norm()));
                let close = |l: f64| (l - length).abs() <= 1e-13 * condition * length;
                assert!(
                    length == 0.0 || lengths.any(close),
                    "{name}: no {kind:?} vector of {length} in the {:?} plan",
                    plan.order
                );
            };
            for slider in case.scene["sliders"].as_array().into_iter().flatten() {
                let Some(drive) = slider.get("drive") else {
                    continue;
                };
                let rate = |key: &str| drive[key].as_f64().unwrap_or(0.0).abs();
                match plan.order {
                    Order::Velocity => has(VectorPart::Sliding, rate("speed")),
                    Order::Acceleration => {
                        has(VectorPart::Sliding, rate("acceleration"));
                        let key = ["link", "on"].map(|key| slider[key].as_str().expect("a name"));
                        let truth = &case.expect["sliders"][key.join("/")];
                        has(VectorPart::Coriolis, number(&truth["coriolis"]).abs());
                    }
                }
            }
        }
    }
}

/// Shapes that are places of one drawing: the x axis of a rod's shape lies along the guide, where its author means the line of its points.
#[test]
fn a_cylinder_by_places_of_a_drawing_says_what_lies_along_its_guide() {
    let scene = |turned: &str| {
        format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "m", "time": "s" }}, "ground": {{ "A": [1, 0], "O": [0, 0] }},
            "links": {{ "1": {{ "shape": {{ "A": [1, 0], "B": [1.2, 1.2] }} }},
                "2": {{ "shape": {{ "C": [1.1, 0.6], "D": [1.4, 2.4] }}, "drive": {{ "position": 0.6082762530298219, "speed": 0.1 }} }},
                "3": {{ "shape": {{ "O": [0, 0], "D": [1.4, 2.4] }} }} }},
            "sliders": [{{ "link": "2", "at": "C", "on": "1", "along": "AB"{turned} }}], "near": {{ "D": [1.4, 2.4] }} }}"#
        )
    };
    let angle = libm::atan2(1.8, 0.3).to_degrees();
    let turned = format!(", \"turned\": {:.4}", -angle);
    let said = |solution: &Solution| -> Vec<String> {
        let language = solution.wording().language;
        solution.mechanism.warnings.iter().map(|warning| language.says(warning)).collect()
    };
    let as_written = solved(&scene("")).expect("a sound scene");
    assert!(said(&as_written).iter().any(|warning| warning.contains(&turned[2..])), "{:?}", said(&as_written));
    let turned = solved(&scene(&turned)).expect("a sound scene");
    assert_eq!(said(&turned), [""; 0]);
    // v_D along AD is the cylinder's speed: ω₃ (O→D turned by 90°)·AD = 0.1 |AD|.
    let omega = 0.1 * libm::hypot(0.4, 2.4) / (-2.4 * 0.4 + 1.4 * 2.4);
    let link = turned.mechanism.link("3").expect("the boom");
    assert!((turned.motion.bodies[link.0].omega - omega).abs() < 1e-5, "{omega}");
}
