//! Values asked for on the command line: their unit, those without room, and what is refused.

use support::files;
use support::program::{kinegon, scratch, stderr};

fn run(arguments: &[&str]) -> std::process::Output {
    kinegon().args(arguments).current_dir(files::path(".")).output().expect("the program runs")
}

#[test]
fn values_have_the_unit_asked_for() {
    let svg = |values: &str| {
        let output = run(&["draw", "tests/lecture/shaper.json", values, "-o", "-"]);
        assert!(output.status.success(), "{}", stderr(&output));
        String::from_utf8(output.stdout).expect("SVG is text")
    };
    assert!(svg("--values").contains("mm/s"));
    // The scales keep the scene's unit.
    assert!(svg("--values=m").matches(" m/s").count() > 4);
    assert!(!svg("--values=none").contains("-value-"));
}

/// What stands nowhere is named, once and with what helps.
#[test]
fn values_without_room_are_named() {
    let folder = scratch("values-without-room");
    let [svg, next] = ["valve.svg", "valve-2.svg"].map(|name| folder.join(name));
    let output = run(&["draw", "tests/lecture/valve.json", "--values", "-o", svg.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{}", stderr(&output));
    let said = stderr(&output);
    let notes: Vec<&str> = said.lines().filter(|line| line.contains("no room for the values of")).collect();
    assert_eq!(notes.len(), 1, "{said}");
    assert!(notes[0].contains("next sheet"), "{said}");
    let [svg, next] = [svg, next].map(|path| std::fs::read_to_string(path).expect("a sheet"));
    let names = notes[0].split("of ").nth(1).and_then(|rest| rest.split(';').next()).expect("names");
    // Values that are the same have one label.
    let first = |names: &str| names.split(" = ").next().unwrap_or_default().to_owned();
    for name in names.split(", ").map(first).filter(|name| name.starts_with("v_") && !name.contains('(')) {
        assert!(!svg.contains(&format!("id=\"velocity-value-{name}\"")), "{name}");
        assert!(next.contains(&format!("listed-velocity-value-{name}-name")), "{name}");
    }
    assert!(!stderr(&run(&["draw", "tests/lecture/valve.json", "-o", "-"])).contains("no room for the values"));
}

/// On a slide two panels leave no room for Willis' table: it has a sheet of its own, and that is said; on paper it stands with them.
#[test]
fn willis_table_is_on_the_figure_or_on_a_further_sheet() {
    let folder = scratch("values-willis");
    let [svg, next] = ["train.svg", "train-2.svg"].map(|name| folder.join(name));
    let draw = |more: &[&str]| {
        let path = svg.to_str().expect("UTF-8");
        let output = run(&[&["draw", "tests/trains/ravigneaux.json", "--willis", "-o", path][..], more].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        let has_table =
            |path: &std::path::Path| std::fs::read_to_string(path).is_ok_and(|svg| svg.contains("willis-4-1-together"));
        (stderr(&output).contains("no room for Willis' table"), has_table(&svg), has_table(&next))
    };
    assert_eq!(draw(&[]), (false, true, false));
    assert_eq!(draw(&["--style", "lecture", "--page", "16x9"]), (true, false, true));
}

/// What a scene wants stands beside everything else, and takes nothing away: not the accelerations, where it wants an angle, a velocity or nothing.
#[test]
fn what_is_wanted_takes_nothing_away() {
    let folder = scratch("values-wanted");
    let scene = |want: Option<serde_json::Value>| {
        // An offset slider-crank.
        let mut scene = serde_json::json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
            "links": { "2": { "points": ["A", "B"], "lengths": { "AB": 40 }, "drive": { "angle": 60, "omega": 30, "alpha": 20 } },
                       "3": { "points": ["B", "C"], "lengths": { "BC": 120 } }, "4": ["C"] },
            "sliders": [{ "link": "4", "at": "C", "on": "ground", "through": [0, -20], "along": 0 }],
            "near": { "C": [127, -20] } });
        if let Some(want) = want {
            scene["want"] = want;
        }
        std::fs::write(folder.join("scene.json"), scene.to_string()).expect("it can be written");
    };
    let solve = |more: &[&str]| {
        let path = folder.join("scene.json");
        let output = run(&[&["solve", path.to_str().expect("UTF-8")][..], more].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let without = |mut result: serde_json::Value| {
        for key in ["quantities", "quantity_errors"] {
            result.as_object_mut().expect("an object").remove(key);
        }
        result
    };
    let json = |text: String| serde_json::from_str(&text).expect("JSON");
    scene(None);
    let (whole, table) = (without(json(solve(&[]))), solve(&["--digits"]));
    for want in [serde_json::json!(["angle(3)"]), serde_json::json!([]), serde_json::json!(["omega(3)", "v(C)"])] {
        scene(Some(want.clone()));
        let result = without(json(solve(&[])));
        assert_eq!(result, whole, "{want}");
        // α of the rod and a of the slider by the derivatives of 40 sin 60° + 120 sin φ = −20.
        let own = [&result["links"]["3"]["alpha"], &result["points"]["C"]["acceleration"][0]];
        for (own, truth) in own.into_iter().zip([271.940_489_809_7, -7_203.303_063_209_7]) {
            let own = own.as_f64().expect("a number");
            assert!((own - truth).abs() < 1e-6 * truth.abs(), "{want}: {own} for {truth}");
        }
        let digits = solve(&["--digits"]);
        assert!(table.lines().all(|line| digits.contains(line)), "{want}: {digits}");
    }
}

#[test]
fn a_unit_that_is_none_is_refused() {
    let output = run(&["draw", "tests/lecture/valve.json", "--values=furlong", "-o", "-"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("furlong"), "{}", stderr(&output));
}
