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

/// A ring outwards, a planet inwards, a pinion off its rack, whichever of both the scene names first: torques by hand from radii, W^r by the pressure
/// angle, and W^r to the side away from the teeth.
#[test]
fn rings_and_driven_racks_push_as_their_teeth_do() {
    let base = |links: Value, gears: Value, forces: Value| {
        json!({
            "kinegon": 1, "units": { "length": "mm", "time": "s", "force": "N" }, "ground": { "A": [0, 0], "D": [40, 10] },
            "links": links, "gears": gears, "forces": forces,
        })
    };
    let mesh = |on: &str, [a, b]: [&str; 2], [z, y]: [Value; 2], is_turned: bool| {
        let (wheels, teeth) = if is_turned { ([b, a], [y, z]) } else { ([a, b], [z, y]) };
        json!({ "mesh": wheels, "teeth": teeth, "on": on, "pressure": 20 })
    };
    let slope = libm::tan(20.0_f64.to_radians());
    let number = |solution: &Solution, name: &str| solution.quantity(name).expect("a value").as_number();
    let is_about = |found: f64, expected: f64| {
        assert!((found - expected).abs() <= 1e-9 * expected.abs(), "{found}, not {expected}")
    };
    for is_turned in [false, true] {
        // The arm drives a planet of 20 teeth in a ring of 72, a couple holds the sun of 32: T ω = −M ω_sun, ω_sun/ω_arm = 104/32.
        let links = json!({
            "1": { "points": ["A", "B"], "lengths": { "AB": 46 }, "drive": { "angle": 37, "omega": 3 } },
            "2": { "points": ["B", "Q"], "lengths": { "BQ": 10 } }, "3": { "points": ["A", "S"], "lengths": { "AS": 15 } },
        });
        let ring = mesh("1", ["2", "ground"], [json!(20), json!(-72)], is_turned);
        let sun = mesh("1", ["2", "3"], [json!(20), json!(32)], is_turned);
        let train = with_plan(base(links, json!([ring, sun]), json!([{ "on": "3", "couple": -700 }])));
        is_right(&train, "a planetary train");
        assert_eq!(laid_off(&train), 0);
        is_about(number(&train, "T(1)"), 700.0 * 104.0 / 32.0);

        // A pinion of 20 teeth in a ring of 60 about D.
        let links = json!({
            "1": { "points": ["A", "B"], "lengths": { "AB": 10 }, "drive": { "angle": 20, "omega": 3 } },
            "2": { "points": ["D", "R"], "lengths": { "DR": 30 } },
        });
        let gear = mesh("ground", ["1", "2"], [json!(20), json!(-60)], is_turned);
        let ring = with_plan(base(links, json!([gear]), json!([{ "on": "2", "couple": -900 }])));
        is_right(&ring, "a ring");
        assert_eq!(laid_off(&ring), 0);
        is_about(number(&ring, "T(1)"), 900.0 * 20.0 / 60.0);
        // The ring is pushed from D towards the pitch point, which lies beyond A: its bearing holds it back along AD.
        let bearing = Vector::new(number(&ring, "R(D,2).x"), number(&ring, "R(D,2).y"));
        let towards = Vector::new(40.0, 10.0).normalize();
        let distance = libm::hypot(40.0, 10.0);
        is_about(bearing.dot(&towards), 900.0 / (1.5 * distance) * slope);

        // A rack drives a pinion of 20 mm radius above it, on which a couple acts.
        let links = json!({ "1": { "points": ["A", "B"], "lengths": { "AB": 15 } }, "2": { "points": ["R"] } });
        let gear = mesh("ground", ["1", "2"], [json!(20), json!("rack")], is_turned);
        let mut scene = base(links, json!([gear]), json!([{ "on": "1", "couple": 800 }]));
        scene["gears"][0]["radius"] = json!(20);
        scene["sliders"] = json!([{
            "link": "2", "at": "R", "on": "ground", "through": [0, -25], "along": 0, "drive": { "position": 10, "speed": 5 }
        }]);
        scene["near"] = json!({ "R": [10, -25] });
        let rack = with_plan(scene);
        is_right(&rack, "a rack");
        assert_eq!(laid_off(&rack), 0);
        is_about(number(&rack, "F(2/ground)").abs(), 40.0);
        // The pinion is pushed up, off its rack.
        is_about(number(&rack, "R(A,1).y"), -40.0 * slope);
    }
}
