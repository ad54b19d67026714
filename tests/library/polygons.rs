//! Force plans: polygons that close, found by moments with arms measured on the scheme, hold what the equations of equilibrium give,
//! for cases of independent digits and for random groups of all classes under random loads.

use crate::forces::loaded;
use kinegon::construction::{Action, Corner, ForceOf, ForcePart, ForcePlan, ForceStep, SideKind};
use kinegon::format::QuantityResult;
use kinegon::geometry::Vector;
use kinegon::mechanism::Mechanism;
use kinegon::{Sheet, Solution};
use serde_json::{Value, json};
use support::comparison::{decimal, entries};
use support::exact::{exceeds, minus};
use support::files;
use support::planted::{Planted, pattern};
use support::random::Random;
use support::stages::solved;
use support::survey::FORCED;

/// Largest difference of both routes, in parts of the largest force, where no position is close to a singular one.
const OFF: f64 = 1e-9;

fn with_plan(mut scene: Value) -> Value {
    scene["figure"]["panels"] = json!(["scheme", "forces", "lever"]);
    scene
}

fn plan(solution: &Solution) -> &ForcePlan {
    solution.construction.forces.as_deref().expect("a force plan")
}

/// Whether all groups are constructed.
fn is_constructed(solution: &Solution) -> bool {
    let steps = &solution.construction.steps[Sheet::Forces];
    !steps.iter().any(|action| matches!(action, Action::Force(ForceStep::ByNumbers(_))))
}

/// Each polygon's sides but its diagonals add up to nothing, and so do the forces on each link of a dyad.
fn check_closed(id: &str, mechanism: &Mechanism, plan: &ForcePlan) {
    for polygon in &plan.polygons {
        let size = polygon.sides.iter().map(|side| side.vector.norm()).fold(0.0, f64::max);
        let around: Vector =
            polygon.sides.iter().filter(|side| side.kind != SideKind::Diagonal).map(|side| side.vector).sum();
        assert!(!exceeds(around.norm(), 1e-9 * size), "{id}: {around} of {size}");
        // In the polygon of a dyad what the inner joint does to one link closes the polygon of each.
        let &[first, second] = polygon.links.as_slice() else { continue };
        for link in [first, second] {
            let sum: Vector = polygon
                .sides
                .iter()
                .map(|side| match side.of {
                    ForceOf::Joint { part, .. } if part != ForcePart::Whole => Vector::zeros(),
                    _ if side.on == link => side.vector,
                    ForceOf::Joint { joint, .. } if mechanism.joint(joint).bodies.contains(&link) => -side.vector,
                    _ => Vector::zeros(),
                })
                .sum();
            assert!(!exceeds(sum.norm(), 1e-9 * size), "{id}: link {link:?}: {sum} of {size}");
        }
    }
}

fn check(id: &str, solution: &Solution, off: f64) {
    let plan = plan(solution);
    check_closed(id, &solution.mechanism, plan);
    let agreement = plan.agreement.expect("forces to compare");
    assert!(!exceeds(agreement.difference, agreement.allowed), "{id}: {agreement:?}");
    assert!(!exceeds(agreement.difference, off), "{id}: {agreement:?}");
}

/// Each drive needs what its lever says: for a lever of its own moments about the pole, without any joint's force.
fn check_levers(id: &str, solution: &Solution, truth: Option<&Value>) {
    let result = serde_json::to_value(solution.result()).expect("a result is JSON");
    let drives: Vec<(String, Value)> =
        entries(&result["forces"]["drives"]).map(|(name, drive)| (name.to_owned(), drive.clone())).collect();
    let levers = &solution.construction.levers;
    assert_eq!(levers.len(), drives.len(), "{id}");
    for (lever, (name, drive)) in levers.iter().zip(drives) {
        let key = if drive["torque"].is_null() { "force" } else { "torque" };
        let size: f64 = lever.forces.iter().map(|force| (force.size * force.arm).abs()).sum::<f64>() / lever.rate.abs();
        let found = drive[key].as_f64().expect("a number");
        assert!(!exceeds((lever.effort - found).abs(), 1e-10 * size), "{id}: {name}: {} {found}", lever.effort);
        if let Some(truth) = truth {
            let right: f64 = decimal(&truth[&name][key]).parse().expect("a number");
            assert!(!exceeds((lever.effort - right).abs(), 1e-8 * size), "{id}: {name}: {} {right}", lever.effort);
        }
    }
}

/// Polygons hold the true forces: those of all pins of 35 cases, some beside singular positions.
#[test]
fn polygons_hold_what_is_true() {
    let text = std::fs::read_to_string(files::path("tests/forces/forces.jsonl")).expect("the cases can be read");
    let mut seen = 0;
    for case in text.lines().map(|line| serde_json::from_str::<Value>(line).expect("a case is JSON")) {
        let id = case["id"].as_str().expect("a name");
        let solution = solved(&with_plan(case["scene"].clone()).to_string()).expect("it is solved");
        assert!(is_constructed(&solution), "{id}");
        check(id, &solution, OFF);
        check_levers(id, &solution, Some(&case["expected"]["drives"]));
        let mechanism = &solution.mechanism;
        let truth = &case["expected"]["reactions"];
        let vector = |json: &Value| Vector::new(decimal(&json[0]).parse().unwrap(), decimal(&json[1]).parse().unwrap());
        let all = entries(truth).flat_map(|(_, bodies)| entries(bodies));
        let largest = all.map(|(_, force)| vector(force).norm()).fold(0.0, f64::max);
        for side in plan(&solution).polygons.iter().flat_map(|polygon| &polygon.sides) {
            let ForceOf::Joint { joint, on, part: ForcePart::Whole } = side.of else { continue };
            let Some(pin) = mechanism.joint(joint).pin else { continue };
            // What several joints of one pin do to a link is one number there.
            let joints = mechanism.joints.iter().filter(|other| other.pin == Some(pin));
            if joints.count() > 1 {
                continue;
            }
            let force = &truth[mechanism.point_name(pin)][&mechanism.body(on).name];
            if force.is_null() {
                continue;
            }
            let off = (vector(force) - side.vector).norm();
            assert!(!exceeds(off, 1e-8 * largest), "{id}: {} {}: {off}", mechanism.point_name(pin), side.vector);
            seen += 1;
        }
    }
    assert!(seen > 200, "only {seen}");
}

/// Random groups of all classes and patterns of pins and guides: both routes agree within what is allowed, and no group goes without a
/// construction.
#[test]
fn polygons_and_equations_agree() {
    let (mut dice, mut seen, mut constructed) = (Random(4711), 0, 0);
    for number in 0..FORCED.now() {
        let class = ["II", "III", "IV"][number as usize % 3];
        let (kinds, joints) = pattern(&mut dice, class);
        let scene = with_plan(loaded(&Planted::new(&mut dice, &kinds, &joints).scene(), &mut dice));
        let Ok(solution) = solved(&scene.to_string()) else { continue };
        if solution.construction.forces.is_none() {
            continue;
        }
        check(&format!("{class} {kinds}\n{scene}"), &solution, 1e-5);
        check_levers(&format!("{class} {kinds}\n{scene}"), &solution, None);
        constructed += u32::from(is_constructed(&solution));
        seen += 1;
    }
    assert!(seen * 10 > FORCED.now() as u32 * 8, "only {seen}");
    assert!(constructed * 100 >= seen * 99, "{constructed} of {seen}");
}

/// Without the panel there is no force plan, and a scene without loads has none.
#[test]
fn a_plan_is_drawn_where_it_is_asked_for() {
    let text = std::fs::read_to_string(files::path("tests/forces/forces.jsonl")).expect("the cases can be read");
    let case: Value = serde_json::from_str(text.lines().next().expect("a case")).expect("a case is JSON");
    let solution = solved(&case["scene"].to_string()).expect("it is solved");
    assert!(solution.construction.forces.is_none() && solution.construction.steps[Sheet::Forces].is_empty());
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [160, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 50, "omega": 10 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 140 } },
            "3": { "points": ["D", "C"], "lengths": { "CD": 110 } } },
        "near": { "angle(3)": 95 }
    });
    let solution = solved(&with_plan(scene).to_string()).expect("it is solved");
    assert!(solution.construction.forces.is_none());
}

/// The name of a polygon's corner at a place.
fn corner_at(plan: &ForcePlan, polygon: usize, at: Vector) -> String {
    let near = |corner: &Corner| corner.polygon == polygon && (corner.at - at).norm() <= 1e-12 * at.norm().max(1.0);
    let found = plan.named_corners().find(|(_, corner)| near(corner));
    found.map(|(name, _)| name.to_owned()).expect("every side ends in a corner with a name")
}

/// What lies between two corners is the force that truth has, within the stated error: whole forces of joints by their components, parts by their size.
#[test]
fn what_lies_between_corners_is_the_force_there() {
    let (mut whole, mut parts, mut bounded) = (0, 0, 0);
    for case in crate::forces::cases().iter().filter(|case| !case["expected"]["reactions"].is_null()) {
        let mut scene = with_plan(case["scene"].clone());
        let drawn = solved(&scene.to_string()).expect("it can be solved");
        if !is_constructed(&drawn) {
            continue;
        }
        let (id, mechanism) = (case["id"].as_str().expect("an id"), &drawn.mechanism);
        let names = |number: usize, from: Vector, to: Vector| [from, to].map(|at| corner_at(plan(&drawn), number, at));
        // Names of what lies between corners, each with the truth.
        let mut expected: Vec<(String, String)> = Vec::new();
        for (number, polygon) in plan(&drawn).polygons.iter().enumerate() {
            for side in &polygon.sides {
                let [from, to] = names(number, side.from, side.from + side.vector);
                match side.of {
                    ForceOf::Joint { joint, on, part: ForcePart::Whole } => {
                        let joint = mechanism.joint(joint);
                        let at_pin = mechanism.joints.iter().filter(|other| other.pin == joint.pin).count();
                        let Some(pin) = joint.pin.filter(|_| at_pin == 1) else { continue };
                        let truth = &case["expected"]["reactions"][mechanism.point_name(pin)][&mechanism.body(on).name];
                        for (axis, index) in [("x", 0), ("y", 1)].into_iter().filter(|_| !truth.is_null()) {
                            expected.push((format!("fplan({from},{to}).{axis}"), decimal(&truth[index]).to_owned()));
                            whole += 1;
                        }
                    }
                    ForceOf::Joint { joint, on, part: ForcePart::Normal | ForcePart::Tangential } => {
                        let letter =
                            if matches!(side.of, ForceOf::Joint { part: ForcePart::Normal, .. }) { "n" } else { "t" };
                        let Some(pin) = mechanism.joint(joint).pin else { continue };
                        let name = format!("R_{letter}({},{})", mechanism.point_name(pin), mechanism.body(on).name);
                        let groups = case["expected"]["groups"].as_array().into_iter().flatten();
                        let truth = groups.filter_map(|group| group["parts"].get(&name)).next();
                        if let Some(truth) = truth {
                            let size = decimal(truth).trim_start_matches('-').to_owned();
                            expected.push((format!("fplan({from},{to})"), size));
                            parts += 1;
                        }
                    }
                    _ => {}
                }
            }
        }
        scene["want"] = json!(expected.iter().map(|(name, _)| name).collect::<Vec<_>>());
        let result =
            solved(&scene.to_string()).expect("it can be solved").whole_result().expect("every corner is there");
        let sides = plan(&drawn).polygons.iter().flat_map(|polygon| &polygon.sides);
        let largest = sides.map(|side| side.vector.norm()).fold(0.0, f64::max);
        for (name, truth) in expected {
            let QuantityResult::Number(value) = result.quantities[&name] else { panic!("{id}: {name} is no number") };
            let (off, stated) = (minus(value, &truth).abs(), result.quantity_errors[&name]);
            assert!(!exceeds(off, 1e-9 * largest), "{id}: {name}: {value}");
            // The truth has sixty digits.
            assert!(
                !exceeds(off, stated + 1e-50 * largest),
                "{id}: {name}: {value} is off by {off}, stated is {stated}"
            );
            bounded += usize::from(stated < 1e-6 * largest);
        }
    }
    assert!(whole > 300 && parts > 80 && bounded * 10 > 9 * (whole + parts), "{whole} {parts} {bounded}");
}

/// Corners of two polygons, of no polygon, and of a figure without a force plan have nothing between them.
#[test]
fn corners_have_a_meaning_in_one_polygon_and_one_position() {
    let scene = crate::forces::cases().swap_remove(0)["scene"].clone();
    let drawn = solved(&with_plan(scene.clone()).to_string()).expect("it can be solved");
    let says = |solution: &Solution, name: &str| solution.quantity(name).expect_err("no value").to_string();
    assert!(says(&drawn, "fplan(o1,a2)").contains("two polygons"));
    assert!(says(&drawn, "fplan(o1,z9)").contains("z9"));
    assert!(drawn.quantity("fplan(o1,a1)").is_ok() && drawn.quantity("fplan(o1,a1).angle").is_ok());
    let bare = solved(&scene.to_string()).expect("it can be solved");
    assert!(says(&bare, "fplan(o1,a1)").contains("panel"));
}
