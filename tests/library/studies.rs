//! Mechanisms of a study that are assembled side by side stand where each would by itself.

use kinegon::study::{Content, Status, StudyFile};
use kinegon::{Scene, solve};

/// A four-bar, a dyad on its coupler and a slider behind that: three dyads, eight assemblies.
const CHAIN: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
    "ground": { "A": [0, 0], "D": [160, 0], "G": [60, 180] },
    "links": {
        "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 60, "omega": 10 } },
        "2": { "points": ["B", "C"], "lengths": { "BC": LENGTH } },
        "3": { "points": ["D", "C"], "lengths": { "DC": 110 } },
        "4": { "points": ["C", "E"], "lengths": { "CE": OTHER } },
        "5": { "points": ["G", "E"], "lengths": { "GE": 70 } },
        "6": { "points": ["E", "F"], "lengths": { "EF": 150 } },
        "7": { "points": ["F"] } },
    "sliders": [{ "link": "7", "at": "F", "on": "ground", "through": [0, 200], "along": 10 }],
    "near": { NEAR } }"#;

fn chain(length: f64, other: f64, near: &str) -> String {
    let numbers = CHAIN.replace("LENGTH", &length.to_string()).replace("OTHER", &other.to_string());
    numbers.replace("NEAR", near)
}

/// The rows of 160 mechanisms against each solved by itself.
fn compared(near: &str) -> [usize; 2] {
    let study = format!(
        r#"{{ "kinegon_study": 1, "scene": {}, "count": 160, "seed": 4,
            "vary": {{ "2.BC": {{ "from": 60, "to": 220 }}, "4.CE": {{ "from": 30, "to": 200 }} }},
            "cycle": {{ "from": 60, "to": 62, "step": 1 }},
            "want": {{ "omega(3)": ["at_scene"], "omega(5)": ["at_scene"], "v(F)": ["at_scene"] }} }}"#,
        chain(140.0, 90.0, near)
    );
    let study = StudyFile::read(&study).expect("a study");
    let study = study.of(Scene::read(&chain(140.0, 90.0, near)).expect("a scene")).expect("it moves");
    let width = study.columns().len();
    let names: Vec<String> = study.columns().into_iter().map(|column| column.name).collect();
    let at = |name: &str| names.iter().position(|other| other == name).expect("a column");
    let [mut there, mut else_where] = [0; 2];
    for row in study.rows(0..study.count()).chunks_exact(width) {
        let text = chain(row[at("2.BC")], row[at("4.CE")], near);
        let Ok(solution) = solve(&Scene::read(&text).expect("a scene")) else {
            assert!(row[at("omega(3).at_scene")].is_nan(), "{text}");
            else_where += 1;
            continue;
        };
        there += 1;
        for (name, quantity) in [("omega(3)", "omega(3)"), ("omega(5)", "omega(5)"), ("v(F)", "v(F)")] {
            let own = solution.quantity(quantity).expect("a value").as_number();
            let found = row[at(&format!("{name}.at_scene"))];
            let condition =
                solution.whole_result().expect("a result").groups.iter().map(|group| group.condition).product::<f64>();
            assert!(
                (found - own).abs() <= 1e-13 * condition * (own.abs() + 1.0),
                "{name}: {found} in place of {own} of {text}"
            );
        }
    }
    [there, else_where]
}

#[test]
fn the_assembly_is_that_of_near() {
    for near in [
        r#""C": [155, 110], "E": [110, 130], "F": [250, 240]"#,
        // On the other side, and where it hangs on the lengths which is nearer.
        r#""C": [80, -60], "E": [110, 130]"#,
        r#""C": [95, 26], "E": [60, 150], "F": [60, 210]"#,
        r#""F": [-40, 190]"#,
    ] {
        let [there, else_where] = compared(near);
        assert!(there > 30 && else_where > 10, "{near}: {there} and {else_where}");
    }
}

/// Of a block of rows none may have a position, or even links.
#[test]
fn none_of_many_may_be_assembled() {
    for (range, status) in [([500.0, 600.0], Status::NotAssembled), ([-90.0, -10.0], Status::NoMechanism)] {
        let [from, to] = range;
        let scene = chain(140.0, 90.0, r#""C": [155, 110], "E": [110, 130]"#);
        let study = format!(
            r#"{{ "kinegon_study": 1, "scene": {scene}, "count": 40, "vary": {{ "2.BC": {{ "from": {from}, "to": {to} }} }},
                "cycle": {{ "from": 60, "to": 62, "step": 1 }}, "want": {{ "omega(3)": ["max"] }} }}"#
        );
        let study = StudyFile::read(&study).expect("a study");
        let study = study.of(Scene::read(&scene).expect("a scene")).expect("it moves");
        let at = study.columns().iter().position(|column| column.content == Content::Status).expect("a column");
        let rows = study.rows(0..40);
        assert!(rows.chunks_exact(study.columns().len()).all(|row| row[at] == f64::from(status as u8)), "{range:?}");
    }
}

/// A weight on a crank: T = m g r cos φ has the mean 0, and the work between its zeros at ±90° is 2 m g r. Over the half turn from 0 on it
/// goes up by m g r and down again, also where each mechanism goes by itself.
#[test]
fn a_flywheel_takes_in_what_a_weight_gives() {
    const WEIGHT: f64 = 2.0 * 9.81;
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" },
        "ground": { "A": [0, 0], "D": [160, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 60, "omega": 10 }, "mass": 2, "center": 30 },
            "2": { "points": ["B", "C"], "lengths": { "BC": 140 } },
            "3": { "points": ["D", "C"], "lengths": { "CD": 110 } } },
        "near": { "C": [155, 110] }, "gravity": [0, -9810], "analysis": "static" }"#;
    let ranges = [([0.0, 360.0], 2.0 * WEIGHT * 30.0), ([0.0, 180.0], WEIGHT * 30.0), ([90.0, -90.0], 0.0)];
    for (range, work) in ranges {
        for together in [true, false] {
            let [from, to] = range;
            let study = format!(
                r#"{{ "kinegon_study": 1, "scene": {scene}, "count": 8, "seed": 4, "at_steps": {together},
                    "vary": {{ "3.CD": {{ "from": 105, "to": 115 }} }}, "cycle": {{ "from": {from}, "to": {to}, "step": 2 }},
                    "want": {{ "T(1)": ["mean", "fluctuation", "max"] }} }}"#
            );
            let study = StudyFile::read(&study).expect("a study");
            let study = study.of(Scene::read(scene).expect("a scene")).expect("it moves");
            let names: Vec<String> = study.columns().into_iter().map(|column| column.name).collect();
            let at = |name: &str| names.iter().position(|other| other == name).expect("a column");
            // From −90° to 90° the torque is never less than nothing, and more than its mean in the middle.
            let mean = if range == [90.0, -90.0] { 2.0 * WEIGHT * 30.0 / std::f64::consts::PI } else { 0.0 };
            let work = if range == [90.0, -90.0] { above(mean, WEIGHT * 30.0) } else { work };
            for row in study.rows(0..study.count()).chunks_exact(names.len()) {
                let found = [row[at("T(1).mean")], row[at("T(1).fluctuation")]];
                assert!(
                    (found[0] - mean).abs() < 1e-3 * WEIGHT * 30.0,
                    "{range:?}, {together}: a mean of {}",
                    found[0]
                );
                assert!(
                    (found[1] - work).abs() < 1e-4 * WEIGHT * 30.0,
                    "{range:?}, {together}: {} is not {work}",
                    found[1]
                );
            }
        }
    }
}

/// ∫ (a cos φ − mean) between the two places where both are equal.
fn above(mean: f64, a: f64) -> f64 {
    let end = libm::acos(mean / a);
    2.0 * (a * libm::sin(end) - mean * end)
}

/// Forces of mechanisms with other lengths, masses at their own places and friction among them, are those of each by itself.
#[test]
fn forces_are_those_of_each_mechanism_by_itself() {
    let scene = |crank: f64, rod: f64| {
        serde_json::json!({
            "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" }, "ground": { "A": [0, 0] },
            "links": {
                "1": { "points": ["A", "B"], "lengths": { "AB": crank }, "drive": { "angle": 50, "omega": 30 } },
                "2": { "points": ["B", "C"], "lengths": { "BC": rod }, "mass": 0.8, "inertia": 2100, "center": 45 },
                "3": { "points": ["C"], "mass": 0.6, "center": "C" },
            },
            "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 5], "along": 2 }],
            "gravity": [0, -9810], "forces": [{ "on": "3", "at": "C", "force": [-400, 0] }],
            "friction": [{ "guide": "3/ground", "coefficient": 0.1 }, { "pin": "B", "coefficient": 0.1, "radius": 9 }],
            "near": { "C": [190, 0] },
        })
        .to_string()
    };
    let study = format!(
        r#"{{ "kinegon_study": 1, "scene": {}, "count": 60, "seed": 9,
            "vary": {{ "1.AB": {{ "from": 40, "to": 70 }}, "2.BC": {{ "from": 120, "to": 220 }} }},
            "cycle": {{ "from": 50, "to": 52, "step": 1 }},
            "want": {{ "T(1)": ["at_scene"], "R(B,2).size": ["at_scene"], "F_f(3/ground)": ["at_scene"] }} }}"#,
        scene(50.0, 150.0)
    );
    let study = StudyFile::read(&study).expect("a study");
    let study = study.of(Scene::read(&scene(50.0, 150.0)).expect("a scene")).expect("it moves");
    let names: Vec<String> = study.columns().into_iter().map(|column| column.name).collect();
    let at = |name: &str| names.iter().position(|other| other == name).expect("a column");
    let rows = study.rows(0..study.count());
    for row in rows.chunks_exact(names.len()) {
        let alone = scene(row[at("1.AB")], row[at("2.BC")]);
        let alone = solve(&Scene::read(&alone).expect("a scene")).expect("it can be assembled");
        for name in ["T(1)", "R(B,2).size", "F_f(3/ground)"] {
            let own = alone.quantity(name).expect("a value").as_number();
            let found = row[at(&format!("{name}.at_scene"))];
            assert!((found - own).abs() <= 1e-9 * (own.abs() + 1.0), "{name}: {found} in place of {own}");
        }
    }
    assert_eq!(rows.len(), 60 * names.len());
}
