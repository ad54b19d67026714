//! Arms of forces: their values are those of independent forces and places, forms have boxes for them where a scene asks, and a check names what
//! went wrong with them.

use crate::forces::cases;
use kinegon::Solution;
use kinegon::check::{AnswerKey, Measured, Mistake, Student, Verdict, arm_names, asked_names, check};
use kinegon::exercise::Exercises;
use kinegon::scene::QuantityName;
use serde_json::{Value, json};
use support::files;
use support::stages::solved;

fn with_polygons(mut scene: Value) -> Value {
    scene["figure"] = json!({ "panels": ["scheme", "forces"] });
    scene
}

fn solution(scene: &Value) -> Solution {
    solved(&scene.to_string()).expect("it can be solved")
}

/// A slider-crank with a gas force and a heavy rod.
fn engine() -> Value {
    let mut scene: Value = serde_json::from_str(&files::read("templates/slider-crank.json")).expect("a scene");
    scene["units"] = json!({ "length": "mm", "time": "s", "mass": "kg", "force": "N" });
    scene["links"]["2"]["mass"] = json!(20);
    scene["links"]["2"]["inertia"] = json!(80000);
    scene["links"]["2"]["center"] = json!(60);
    scene["forces"] = json!([{ "name": "P", "on": "3", "at": "C", "force": [-200, 0] }]);
    with_polygons(scene)
}

/// The scene, whose form asks for these alone.
fn asking(mut scene: Value, names: impl IntoIterator<Item = String>) -> Value {
    scene["form"] = names.into_iter().map(|name| (name, json!(1))).collect::<serde_json::Map<_, _>>().into();
    scene
}

fn pair(value: &Value) -> Option<[f64; 2]> {
    let number = |value: &Value| value.as_f64().or_else(|| value.as_str()?.parse().ok());
    Some([number(&value[0])?, number(&value[1])?])
}

/// A place of a force's line and its direction, by the places of a drawn scene and the independent digits of a case.
fn line(case: &Value, name: &str) -> Option<([f64; 2], [f64; 2])> {
    let (scene, expected) = (&case["scene"], &case["expected"]);
    let given = scene["forces"].as_array().into_iter().flatten().find(|load| load["name"] == name);
    if let Some(load) = given {
        let at = pair(&load["at"]).or_else(|| pair(&scene["points"][load["at"].as_str()?]))?;
        return Some((at, pair(&load["force"])?));
    }
    let (head, inside) = name.strip_suffix(')')?.split_once('(')?;
    match head {
        "weight" => Some((pair(&expected["inertia"][inside]["center"])?, pair(&scene["gravity"])?)),
        "inertia" => {
            let own = &expected["inertia"][inside];
            Some((pair(&own["center"])?, pair(&own["a_center"])?))
        }
        "R" => {
            let (pin, link) = inside.split_once(',')?;
            Some((pair(&scene["points"][pin])?, pair(&expected["reactions"][pin][link])?))
        }
        _ => None,
    }
}

/// The digits of forces are those of absolute coordinates and free bodies; the distance of a point from a line is worked out here.
#[test]
fn arms_are_distances_from_independent_lines_of_action() {
    let mut compared = 0;
    for case in cases() {
        let Ok(solution) = solved(&with_polygons(case["scene"].clone()).to_string()) else { continue };
        for name in arm_names(&solution) {
            let QuantityName { arguments, .. } = QuantityName::parse(&name).expect("a name");
            let [of, about] = &arguments[..] else { continue };
            let at = pair(&case["scene"]["points"][about]);
            let Some(((from, along), at)) = line(&case, of).zip(at) else { continue };
            let moment = (at[0] - from[0]) * along[1] - (at[1] - from[1]) * along[0];
            let right = moment.abs() / libm::hypot(along[0], along[1]);
            let found = solution.quantity(&name).expect("a value").as_number();
            let size = libm::hypot(at[0] - from[0], at[1] - from[1]).max(1.0);
            assert!((found - right).abs() <= 1e-9 * size, "{} {name}: {found}, not {right}", case["id"]);
            compared += 1;
        }
    }
    assert!(compared >= 100, "{compared}");
}

/// Across the line of its joints a force has the link's length as its arm about the other one; along it none.
#[test]
fn parts_of_a_reaction_have_the_arms_of_their_lines() {
    let solution = solution(&engine());
    let value = |name: &str| solution.quantity(name).expect("a value").as_number();
    assert!((value("arm(R_t(B,2),C)") - 150.0).abs() < 1e-12 * 150.0);
    assert!(value("arm(R_n(B,2),C)").abs() < 1e-10);
    // The guide's force acts in the slider's point, its couple is apart: the arm is how far the guide's normal through C is from A.
    assert!((value("arm(N(3/ground),A)") - value("x(C)")).abs() < 1e-9);
    // Where a force's line and the normal of the guide cross.
    let (b, c) = ([value("x(B)"), value("y(B)")], [value("x(C)"), value("y(C)")]);
    let right = (b[1] / b[0] * c[0] - c[1]).abs();
    let found = value("arm(P,R_n(A,1),N(3/ground))");
    assert!((found - right).abs() < 1e-9 * right, "{found}, not {right}");
}

#[test]
fn only_a_form_that_names_arms_has_boxes_for_them() {
    let scene = engine();
    let bare = solution(&scene);
    let usual = asked_names(&bare);
    assert!(!usual.iter().any(|name| name.starts_with("arm")), "{usual:?}");
    let arms = arm_names(&bare);
    assert_eq!(arms, ["arm(inertia(2),C)", "arm(R_t(B,2),C)", "arm(R(B,1),A)"]);
    let asked = solution(&asking(scene, usual.iter().chain(&arms).cloned()));
    let names = asked_names(&asked);
    // Each stands before what its moment finds.
    let place = |name: &str| names.iter().position(|own| own == name).unwrap_or_else(|| panic!("{name} in {names:?}"));
    assert_eq!(names.len(), usual.len() + 3);
    assert!(
        place("arm(R_t(B,2),C)") + 1 == place("R_t(B,2)") && place("arm(R(B,1),A)") + 1 == place("T(1)"),
        "{names:?}"
    );
}

fn form(solution: &Solution, values: &Value) -> Measured {
    let mut form = json!({ "kinegon_measured": 1, "positive": "counter-clockwise", "values": values });
    for (sheet, mu) in solution.scales().given() {
        form[sheet.facts().scale_key] = json!(mu);
    }
    Measured::read_json(&form.to_string()).expect("a form")
}

#[test]
fn arms_are_judged_in_units_and_in_millimetres_of_paper() {
    let bare = solution(&engine());
    let asked = solution(&asking(engine(), arm_names(&bare)));
    let mu = asked.scales()[kinegon::Sheet::Scheme].expect("a scheme");
    let right = |name: &str| asked.quantity(name).expect("a value").as_number();
    let (across, at_crank) = (right("arm(R_t(B,2),C)"), right("arm(R(B,1),A)"));
    let key = AnswerKey::new(&asked, None);
    let judged = |values: Value| check(&form(&asked, &values), &key).expect("a form");
    let all_right = judged(json!({
        "arm(R_t(B,2),C)": format!("{across:.1}"),
        "arm(R(B,1),A)/mu": format!("{:.1}", at_crank / mu),
    }));
    assert!(all_right.values.iter().all(|value| value.verdict != Verdict::Off), "{:?}", all_right.values);
    let off =
        judged(json!({ "arm(R_t(B,2),C)": format!("{:.1}", across * 0.8), "arm(R(B,1),A)": format!("{at_crank:.1}") }));
    assert_eq!(off.values.iter().filter(|value| value.verdict == Verdict::Off).count(), 1, "{:?}", off.values);
}

/// The arms of a sum of moments are in millimetres of paper, its force follows from them: the mistake is found by the arms already.
#[test]
fn mistakes_with_arms_show_in_their_boxes() {
    let mut scene = engine();
    scene["figure"]["mu_l"] = json!(2);
    let oblique = json!({ "name": "Q", "on": "2", "at": 60, "force": { "size": 150, "angle": -50 } });
    scene["forces"].as_array_mut().expect("forces").push(oblique);
    let bare = solution(&scene);
    let asked = solution(&asking(scene, asked_names(&bare).into_iter().chain(arm_names(&bare))));
    let key = AnswerKey::new(&asked, None);
    let student = Student::new(&key).expect("a form");
    for id in ["arm-in-paper-mm", "arm-to-point"] {
        let mistake = Mistake::all().find(|mistake| mistake.id() == id).expect("a mistake");
        let ways = student.ways(mistake);
        assert!(!ways.is_empty(), "{id}");
        let right = student.exact(None);
        let changes = |way: &&kinegon::check::Candidate| {
            let found = student.exact(Some(way));
            let mut arms = (0..found.len()).filter(|place| student.names()[*place].starts_with("arm("));
            arms.any(|place| match (found[place], right[place]) {
                (Some(found), Some(right)) => (found - right).abs() > 0.1 * right,
                _ => false,
            })
        };
        let way = ways.iter().find(changes).unwrap_or_else(|| panic!("{id} changes no arm"));
        let drawn = student.draw(&[way], [0.05; 2], &mut || 0.3, &[]);
        let checked = check(&drawn, &key).expect("a form");
        let told: Vec<&str> = checked.diagnosis.best.findings.iter().map(|f| f.candidate.mistake().id()).collect();
        assert_eq!(told, [id]);
        let off = checked.values.iter().filter(|value| value.verdict == Verdict::Off);
        assert!(off.map(|value| value.entry.asked.name()).any(|name| name.starts_with("arm(")), "{id}");
    }
}

#[test]
fn exercises_ask_for_arms_where_they_are_to() {
    let scene = solution(&engine());
    let of = |exercises: Exercises| exercises.clone().next().expect("an exercise");
    let (usual, with) =
        (Exercises::new(&scene, None, 3).expect("it varies"), Exercises::new(&scene, None, 3).expect("it varies"));
    let (usual, with) = (of(usual), of(with.with_arms()));
    let form = |text: &str| serde_json::from_str::<Value>(text).expect("JSON")["form"].clone();
    let (own, more) = (form(&usual.text), form(&with.text));
    let arms = |form: &Value| form.as_object().expect("a form").keys().filter(|name| name.starts_with("arm(")).count();
    assert!(arms(&own) == 0 && arms(&more) >= 2, "{own} {more}");
    let key = with.key();
    for (name, value) in &key.values {
        assert_eq!(name.starts_with("arm("), value.unit == "mm", "{name}");
        assert!(value.step > 0 && value.allowed.is_some(), "{name}");
    }
    assert!(with.form("x").json(&with.solution).contains("\"arm(R_t(B,2),C)\": \"\""));
}
