//! Forces of a table's positions, which are found several at once, against those that the same scene has with its drive there: all links'
//! equations of equilibrium with bounds, one position at a time.

use kinegon::cycle::{Drive, Path, Steps, Sweep};
use serde_json::{Value, json};
use support::files;
use support::stages::solved;

/// Errors allowed, in parts of the largest number of a row.
const OFF: f64 = 1e-9;

/// A slider-crank with all kinds of loads: masses, a weight, gravity, forces that turn and that change, a couple, a spring.
fn slider_crank() -> Value {
    json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" }, "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "angle": 0, "omega": 40 }, "weight": 9, "center": [12, 3] },
            "2": { "points": ["B", "C"], "lengths": { "BC": 150 }, "mass": 0.8, "inertia": 2100, "center": 45 },
            "3": { "points": ["C"], "mass": 0.6, "center": "C" },
        },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 5], "along": 2 }],
        "gravity": [0, -9810],
        "forces": [
            { "on": "3", "at": "C", "force": [-1, 0], "over": { "of": "angle(1)", "table": [[0, 200], [15, 2600], [180, 100], [360, 200]] } },
            { "on": "2", "at": [70, 10], "force": [3, -20], "turns": true },
            { "on": "3", "couple": 400, "over": { "of": "position(3/ground)", "table": [[90, 0], [210, 2]] } },
        ],
        "springs": [{ "between": [["2", 30], ["ground", [20, 90]]], "rate": 0.7, "length": 60 }],
        "near": { "C": [190, 0] },
    })
}

/// A group of class III between two cranks would need two drives; this one hangs on a crank and two pivots.
fn third_class() -> Value {
    let mut scene: Value = serde_json::from_str(&files::read("templates/third-class.json")).expect("JSON");
    scene["units"]["mass"] = "kg".into();
    scene["units"]["force"] = "N".into();
    scene["gravity"] = json!([0, -9810]);
    for (_, link) in scene["links"].as_object_mut().expect("links").iter_mut() {
        let first = link["points"][0].clone();
        for (key, value) in [("mass", json!(1.5)), ("inertia", json!(800)), ("center", first)] {
            link[key] = value;
        }
    }
    scene
}

/// Each number of these rows is what the scene tells with its drive at that angle.
fn are_as_solved(mut scene: Value, crank: &str, [from, to]: [f64; 2], names: &[&str]) {
    let solution = solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"));
    let drive = Drive::new(&solution.mechanism, None).expect("a crank");
    let mut path = Path::new(&solution.mechanism, &solution.pose, drive).expect("it moves");
    path.cover(Some(from), Some(to)).expect("it gets there");
    let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
    let sweep = Sweep::new(&path, Steps::new(from, to, (to - from) / 100.0).expect("a range"), Some(&names));
    let sweep = sweep.expect("known quantities");
    let columns = sweep.header().len();
    let numbers = sweep.rows(0..sweep.steps.count());
    assert!(numbers.len() >= 100 * columns);
    scene["want"] = json!(names);
    for row in numbers.chunks(columns).step_by(7) {
        let row: Vec<f64> = row.iter().map(|x| x.unwrap_or_else(|| panic!("{names:?}: {row:?}"))).collect();
        scene["links"][crank]["drive"]["angle"] = row[0].into();
        let mut walker = path.walker();
        let pose = walker.position(row[0]).expect("it is on the path").pose();
        scene["near"] = solution
            .mechanism
            .points
            .iter()
            .zip(&pose.points)
            .filter(|(name, _)| scene["ground"].get(name.as_str()).is_none())
            .map(|(name, place)| (name.clone(), json!([place.x, place.y])))
            .collect::<serde_json::Map<String, Value>>()
            .into();
        let alone = solved(&scene.to_string()).unwrap_or_else(|error| panic!("at {}: {error}", row[0]));
        let whole = serde_json::to_value(alone.whole_result().expect("all has values")).expect("a result is JSON");
        let expected = names.iter().flat_map(|name| match &whole["quantities"][name] {
            Value::Array(pair) => pair.iter().map(|x| x.as_f64().expect("a number")).collect(),
            number => vec![number.as_f64().expect("a number")],
        });
        let expected: Vec<f64> = expected.collect();
        assert_eq!(expected.len(), columns - 1);
        let size = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for (found, expected) in row[1..].iter().zip(&expected) {
            assert!((found - expected).abs() <= OFF * size, "at {}: {found}, not {expected}; {names:?}", row[0]);
        }
    }
}

#[test]
fn a_slider_crank_with_all_loads_is_as_one_by_one() {
    let scene = slider_crank();
    let forces = ["R(B,2)", "R(C,3).x", "N(3/ground)", "M(3/ground)", "R(A,ground).size", "shaking", "R_n(B,2)"];
    are_as_solved(scene.clone(), "1", [10.0, 370.0], &forces);
    let moments = ["T(1)", "moment(F1,A)", "shaking(A)", "M_i(2)", "power(F2)", "power(K1(2))", "power(M3)"];
    are_as_solved(scene, "1", [10.0, 370.0], &moments);
}

#[test]
fn a_slider_crank_with_friction_is_as_one_by_one() {
    let mut scene = slider_crank();
    scene["friction"] = json!([
        { "guide": "3/ground", "coefficient": 0.08 }, { "pin": "A", "coefficient": 0.1, "radius": 12 },
        { "pin": "B", "angle": 5, "radius": 10 }, { "pin": "C", "coefficient": 0.1, "radius": 7 },
    ]);
    let forces = ["R(B,2)", "N(3/ground)", "T(1)", "F_f(3/ground)", "M_f(B,2)", "power(friction(C,2))", "shaking"];
    are_as_solved(scene, "1", [10.0, 370.0], &forces);
}

#[test]
fn groups_of_higher_class_are_as_one_by_one() {
    let paper: Value = serde_json::from_str(&files::read("tests/forces/figure-2.json")).expect("JSON");
    are_as_solved(paper, "1", [40.0, 100.0], &["R(B,2)", "R(E,5)", "R(G,ground)", "N(3/2)", "F_i(4)"]);
    let scene = third_class();
    let angle = scene["links"]["1"]["drive"]["angle"].as_f64().expect("a crank");
    let [link, other] = ["2", "3"].map(str::to_owned);
    let pin = scene["links"][&link]["points"][0].as_str().expect("a pin").to_owned();
    let names = [format!("R({pin},{link})"), format!("F_i({other})")];
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    are_as_solved(scene, "1", [angle - 5.0, angle + 5.0], &names);
}

/// Between corners is a sum of forces in every position: by the equations what the polygons drawn there have, as long as they begin with the
/// same forces.
#[test]
fn corners_of_polygons_are_as_one_by_one() {
    let mut scene = slider_crank();
    scene["figure"] = json!({ "panels": ["scheme", "forces"] });
    // No load is there in one position and not in another.
    for load in scene["forces"].as_array_mut().expect("forces") {
        load.as_object_mut().expect("a load").remove("over");
    }
    let corners = ["fplan(o1,c1).x", "fplan(o1,c1).y", "fplan(o1,d1)", "fplan(b1,e1).y", "fplan(o2,a2).x"];
    are_as_solved(scene, "1", [10.0, 370.0], &corners);
}

/// A load that is nothing somewhere leaves no gap: what lies between the corners goes on, as the sum of what is left.
#[test]
fn corners_have_values_where_a_load_is_nothing() {
    let mut scene: Value = serde_json::from_str(&files::read("templates/slider-crank.json")).expect("a scene");
    scene["units"] = json!({ "length": "mm", "time": "s", "force": "N" });
    scene["analysis"] = json!("static");
    let over = json!({ "of": "angle(1)", "table": [[0, 1], [90, 1], [180, 0], [270, 0], [360, 1]] });
    scene["forces"] = json!([{ "name": "P", "on": "3", "at": "C", "force": [-200, 0], "over": over }]);
    scene["figure"] = json!({ "panels": ["scheme", "forces"] });
    let solution = solved(&scene.to_string()).expect("it can be solved");
    let drive = Drive::new(&solution.mechanism, None).expect("a drive");
    let mut path = Path::new(&solution.mechanism, &solution.pose, drive).expect("regular");
    path.cover(Some(0.0), Some(360.0)).expect("a turn");
    let names = ["fplan(o1,a1).x", "load(P).x"].map(str::to_owned);
    let sweep = Sweep::new(&path, Steps::new(0.0, 360.0, 15.0).expect("steps"), Some(&names)).expect("corners");
    for row in sweep.rows(0..sweep.steps.count()).chunks(3) {
        let [at, corner, load] = [row[0], row[1], row[2]].map(|x| x.unwrap_or_else(|| panic!("{row:?}")));
        assert!((corner - load).abs() <= 1e-12 * 200.0, "at {at}: {corner}, not {load}");
    }
    let wrong = Sweep::new(&path, Steps::new(0.0, 9.0, 1.0).expect("steps"), Some(&["fplan(o1,z1)".to_owned()]));
    assert!(wrong.expect_err("no corner").to_string().contains("z1"));
}
