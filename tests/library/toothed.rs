//! Force plans of wheels: the force between teeth by moments about a wheel's pin, polygons that close, and what the equations of equilibrium
//! give, in cases of independent digits and in random trains, whose tooth forces are those of their torques.

use kinegon::Sheet;
use kinegon::Solution;
use kinegon::construction::{Action, ForcePlan, ForceStep, SideKind};
use kinegon::geometry::Vector;
use serde_json::{Value, json};
use support::files;
use support::random::Random;
use support::stages::solved;

/// Errors allowed, in parts of the largest force.
const OFF: f64 = 1e-12;

fn with_plan(mut scene: Value) -> Solution {
    scene["figure"] = json!({ "panels": ["scheme", "forces"] });
    solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"))
}

/// Both routes agree, and each polygon but its diagonals adds up to nothing.
fn is_right<'s>(solution: &'s Solution, what: &str) -> &'s ForcePlan {
    let plan = solution.construction.forces.as_deref().expect("a force plan");
    let agreement = plan.agreement.expect("forces are found");
    let (difference, allowed) = (agreement.difference, agreement.allowed);
    assert!(difference <= allowed && difference < OFF, "{what}: {difference} of {allowed}");
    for polygon in &plan.polygons {
        let size = polygon.sides.iter().map(|side| side.vector.norm()).fold(0.0, f64::max);
        let sides = polygon.sides.iter().filter(|side| side.kind != SideKind::Diagonal);
        // Parts whose sum stands as a diagonal are sides, too.
        let around: Vector = sides.map(|side| side.vector).sum();
        assert!(around.norm() <= OFF * size, "{what}: {around} of {size}");
    }
    plan
}

fn laid_off(solution: &Solution) -> usize {
    let steps = solution.construction.steps[Sheet::Forces].iter();
    steps.filter(|action| matches!(action, Action::Force(ForceStep::ByNumbers(_)))).count()
}

#[test]
fn cases_of_independent_digits_have_polygons_that_close() {
    let mut seen = 0;
    for line in files::read("tests/gears/forces.jsonl").lines() {
        let case: Value = serde_json::from_str(line).expect("JSON");
        let id = case["id"].as_str().expect("a name");
        let solution = with_plan(case["scene"].clone());
        is_right(&solution, id);
        // Links whose moments hang together, and racks, are laid off.
        let expected = usize::from(id.starts_with("G03") || id.starts_with("G09"));
        assert_eq!(laid_off(&solution), expected, "{id}");
        seen += 1;
    }
    assert_eq!(seen, 5);
}

/// Wheels one behind the other, each on a pin of the frame, the first one driven and a couple on the last one.
fn train(dice: &mut Random, pressure: f64) -> (Value, f64, Vec<f64>) {
    let count = 2 + dice.below(3);
    let module = dice.between(1.0, 4.0);
    let teeth: Vec<f64> = (0..count).map(|_| (17 + dice.below(60)) as f64).collect();
    let radii: Vec<f64> = teeth.iter().map(|teeth| 0.5 * module * teeth).collect();
    let couple = dice.between(-9000.0, 9000.0);
    let (mut at, mut ground, mut links, mut gears) = ([0.0, 0.0], json!({}), json!({}), Vec::new());
    for wheel in 0..count {
        let (center, rim) = (format!("C{wheel}"), format!("Q{wheel}"));
        ground[&center] = json!(at);
        let mut link = json!({ "points": [center, rim], "lengths": { format!("{center}-{rim}"): 0.5 * radii[wheel] } });
        if wheel == 0 {
            link["drive"] = json!({ "angle": dice.between(0.0, 360.0), "omega": 10 });
        }
        links[format!("{}", wheel + 1)] = link;
        if wheel + 1 < count {
            let (sine, cosine) = libm::sincos(dice.between(-0.9, 0.9));
            let distance = radii[wheel] + radii[wheel + 1];
            at = [at[0] + distance * cosine, at[1] + distance * sine];
            gears.push(json!({
                "mesh": [format!("{}", wheel + 1), format!("{}", wheel + 2)], "teeth": [teeth[wheel], teeth[wheel + 1]],
                "on": "ground", "pressure": pressure
            }));
        }
    }
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "force": "N" }, "ground": ground, "links": links,
        "gears": gears, "forces": [{ "on": format!("{count}"), "couple": couple }],
    });
    (scene, couple, radii)
}

/// Each mesh carries the couple over the last wheel's radius along its tangent, and that over cos α in all.
#[test]
fn random_trains_carry_their_couple_over_the_radius() {
    let mut dice = Random(2_027);
    for number in 0..100 {
        let pressure = [0.0, 14.5, 20.0, 25.0][number % 4];
        let (scene, couple, radii) = train(&mut dice, pressure);
        let solution = with_plan(scene.clone());
        let plan = is_right(&solution, &scene.to_string());
        assert_eq!(laid_off(&solution), 0, "{scene}");
        assert_eq!(plan.polygons.len(), radii.len(), "{scene}");
        let tangential = (couple / radii[radii.len() - 1]).abs();
        let whole = tangential / libm::cos(pressure.to_radians());
        let result = serde_json::to_value(solution.result()).expect("a result is JSON");
        for (mesh, force) in result["forces"]["meshes"].as_object().expect("meshes") {
            let [x, y] = [0, 1].map(|axis| force["force"][axis].as_f64().expect("a number"));
            assert!((libm::hypot(x, y) - whole).abs() <= 1e-9 * whole, "{mesh} of {scene}");
        }
        // The drive's torque is that of the first radius; it turns against the couple where both wheels turn one way.
        let sense = if radii.len() % 2 == 1 { -1.0 } else { 1.0 };
        let torque = solution.quantity("T(1)").expect("a torque").as_number();
        let expected = sense * couple * radii[0] / radii[radii.len() - 1];
        assert!((torque - expected).abs() <= 1e-9 * expected.abs(), "{torque}, not {expected}: {scene}");
        // A bearing between two meshes carries both forces; the first and the last carry one.
        for wheel in [1, radii.len()] {
            let name = format!("R(C{},{wheel}).size", wheel - 1);
            let bearing = solution.quantity(&name).expect("a bearing").as_number();
            assert!((bearing - whole).abs() <= 1e-9 * whole, "{name} of {scene}");
        }
    }
}
