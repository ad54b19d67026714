//! `kinegon check` from outside: forms, verdicts, exit codes, and values that nobody can understand.

use serde_json::{Value, json};
use std::process::Output;
use support::files;
use support::program::{kinegon, scratch, stderr};

const SCENE: &str = "examples/figure-2.json";

/// Checks a form with that text against Figure 2.
fn check(name: &str, text: &str, more: &[&str]) -> Output {
    // A folder for each: tests run side by side.
    let file = scratch(&format!("check-{name}")).join(name);
    std::fs::write(&file, text).expect("it can be written");
    let mut command = kinegon();
    command.args(["check", SCENE]).arg(&file).args(more);
    command.output().expect("the program starts")
}

fn form(inside: &str) -> String {
    format!(r#"{{ "kinegon_measured": 1, {inside} }}"#)
}

/// The message of what is refused, on one line.
fn refused(name: &str, text: &str) -> String {
    let output = check(name, text, &[]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(output.stdout.is_empty(), "{name}");
    said.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn right_values_are_right_in_any_unit_scale_and_sense() {
    for (name, text) in [
        ("units.json", form(r#""values": { "L(B,S3)": 370.96, "vplan(s3,b)": 59.41, "omega(4)": -0.4747 }"#)),
        (
            "metres.json",
            form(
                r#""values": { "L(B,S3)": { "value": 0.37096, "unit": "m" }, "omega(4)": { "value": -4.533, "unit": "rpm" } }"#,
            ),
        ),
        ("paper.json", form(r#""mu_l": 2, "mu_v": 0.5, "values": { "L(B,S3)/mu": 185.5, "vplan(b,s3)/mu": 118.8 }"#)),
        (
            "all-mm.json",
            form(r#""in": "mm", "mu_l": 2, "mu_v": 0.5, "values": { "L(B,S3)": 185.5, "vplan(b,s3)": "118.8" }"#),
        ),
        ("clockwise.json", form(r#""positive": "clockwise", "values": { "omega(4)": 0.475, "alpha(4)": -0.448 }"#)),
        ("magnitudes.json", form(r#""values": { "omega(4)": 0.475, "a_r(3/2)": 58.4 }"#)),
        (
            "table.csv",
            "quantity,value,unit\nmu_v,0.5,\nL(B,S3),370.96,mm\n\"vplan(b,s3)/mu\",118.8,\nomega(4),-0.475,rad/s\n"
                .to_owned(),
        ),
        ("comma.csv", "quantity;value\nL(B,S3);370,96\nomega(4);-0,475\n".to_owned()),
        ("points.csv", "mu_v,1\nvelocity:p,10,20\nvelocity:b,44.2,114.0\nvelocity:s3,4.5,158.1\n".to_owned()),
        ("points-comma.csv", "mu_v;1\nvelocity:p;10;20\nvelocity:b;44,2;114,0\nvelocity:s3;4,5;158,1\n".to_owned()),
        // Turned by 90° and shifted: b 100 mm from p at −20°.
        (
            "points.json",
            form(r#""mu_v": 1, "points": { "velocity": { "p": [10, 20], "b": [44.2, 114.0], "s3": [4.5, 158.1] } }"#),
        ),
    ] {
        let output = check(name, &text, &[]);
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        // A few of the values that the steps give: right so far, but not all that is asked for.
        assert_eq!(output.status.code(), Some(1), "{name}: {said}{}", stderr(&output));
        assert!(said.contains("Nothing is off: ") && said.contains("Missing: "), "{name}: {said}");
    }
}

/// In the scene's own units 5000 N mm, in all that people write for it: those that Kinegon prints among them.
#[test]
fn units_of_forces_moments_and_powers_are_read_as_they_are_printed() {
    let scene = scratch("units-of-forces").join("scene.json");
    std::fs::write(&scene, files::read("tests/files/loaded-four-bar.json")).expect("written");
    let scene = scene.to_str().expect("UTF-8");
    let torque = |value: &str, unit: &str| {
        let form = scratch("units-of-forces-form").join("form.csv");
        std::fs::write(&form, format!("T(1),{value},{unit}\n")).expect("written");
        let output = kinegon().args(["check", scene]).arg(&form).args(["--json", "--depth", "1"]).output();
        let output = output.expect("the program starts");
        let result: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap_or_default();
        (result["values"][0]["value"].as_f64(), stderr(&output))
    };
    for (value, unit) in [
        ("5000", "N mm"),
        ("5000", "N·mm"),
        ("5000", "Nmm"),
        ("5000", "N*mm"),
        ("5", "Nm"),
        ("5", "N m"),
        ("0.005", "kN·m"),
        ("500", "N cm"),
        ("500", "daN mm"),
        ("5", "J"),
    ] {
        let (found, told) = torque(value, unit);
        assert!(found.is_some_and(|found| (found - 5000.0).abs() < 1e-9), "{value} {unit}: {found:?} {told}");
    }
    // 1 lbf is 0.45359237 · 9.80665 N, an inch 25.4 mm.
    let (found, _) = torque("10", "lbf in");
    assert!(found.is_some_and(|found| (found - 10.0 * 0.453_592_37 * 9.806_65 * 25.4).abs() < 1e-6), "{found:?}");
    for unit in ["N", "N/mm", "mm", "kg m", "N mm/s", "Nn", "W"] {
        assert!(torque("5000", unit).1.contains("is no unit of a moment"), "{unit}");
    }
}

/// A line that is not understood is told, not passed over.
#[test]
fn no_line_of_a_table_is_passed_over() {
    for (line, part) in [(",5.3,mm", "without the name"), ("omega(4),,-0.475", "in the place of the unit")] {
        let output = check("passed-over.csv", &format!("quantity,value,unit\nL(B,S3),370.96,mm\n{line}\n"), &[]);
        assert_eq!(output.status.code(), Some(2), "{line}");
        assert!(stderr(&output).contains("line 3") && stderr(&output).contains(part), "{line}: {}", stderr(&output));
    }
    // The unit of a blank is none.
    let blank = check("blank-unit.csv", "L(B,S3),370.96,mm\nomega(4),,rad/s\nalpha(4),,1/s²\n", &[]);
    assert_eq!(blank.status.code(), Some(1), "{}", stderr(&blank));
}

/// A line that stands twice is refused as JSON refuses it, whatever it says; a blank is none.
#[test]
fn no_line_of_a_table_stands_twice() {
    for [first, second] in [
        ["mu_v,2,", "mu_v,4,"],
        ["positive,counter-clockwise", "positive,clockwise"],
        ["name,A,", "name,B,"],
        ["velocity:p,0,0", "velocity: p,1,1"],
        ["omega(4),-0.475", "omega(4),5"],
        ["omega(4),-0.475", "omega(4),-0.475"],
    ] {
        let said = refused("twice.csv", &format!("quantity,value,unit\n{first}\nL(B,S3),370.96,mm\n{second}\n"));
        let name = first.split(',').next().expect("a name");
        assert!(said.contains(&format!("line 4: key `{name}` stands twice: first at line 2")), "{said}");
        assert!(said.contains("keep one of them"), "{said}");
    }
    let blank = check("blank-twice.csv", "omega(4),,\nL(B,S3),370.96,mm\nomega(4),-0.475\nomega(4),\n", &[]);
    assert_eq!(blank.status.code(), Some(1), "{}", stderr(&blank));
}

#[test]
fn a_wrong_value_fails_and_json_says_the_same() {
    let text = form(r#""values": { "L(B,S3)": 370.96, "vplan(b,s3)": 79.41 }"#);
    assert_eq!(check("wrong.json", &text, &[]).status.code(), Some(1));
    let output = check("wrong-json.json", &text, &["--json", "--depth", "1"]);
    assert_eq!(output.status.code(), Some(1));
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(result["passed"], false);
    let verdicts: Vec<&str> =
        result["values"].as_array().expect("a list").iter().filter_map(|v| v["verdict"].as_str()).collect();
    assert_eq!(verdicts, ["right", "off"]);
}

#[test]
fn scales_of_a_drawing_that_is_not_asked_for_are_refused() {
    let text = form(r#""values": { "L(B,S3)": 370.96 }"#);
    for more in [["--mu-v", "2"], ["--page", "a3"], ["--style", "print"]] {
        let output = check("no-drawing.json", &text, &more);
        assert_eq!(output.status.code(), Some(2), "{more:?}");
        assert!(stderr(&output).contains("--draw out/"), "{more:?}");
    }
}

#[test]
fn a_mirrored_plan_is_told() {
    // The points of the right plan, x the other way.
    let places = r#""p": [90, 20], "b": [55.8, 114.0], "s3": [95.5, 158.1]"#;
    let text = form(&format!(r#""mu_v": 1, "points": {{ "velocity": {{ {places} }} }}"#));
    let output = check("mirrored.json", &text, &[]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("velocity plan are the mirror image"), "{said}");
    let output = check("mirrored-json.json", &text, &["--json"]);
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(result["mirrored"], serde_json::json!(["velocity"]));
    assert_eq!(result["passed"], false);
}

#[test]
fn clockwise_values_taken_for_counter_clockwise_are_off() {
    let text = form(r#""positive": "counter-clockwise", "values": { "omega(4)": 0.475 }"#);
    let output = check("sense.json", &text, &["--depth", "1"]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(1));
    assert!(said.contains("wrong sense"), "{said}");
}

#[test]
fn what_is_not_understood_is_said_clearly() {
    for (name, text, parts) in [
        ("name.json", form(r#""values": { "omga(4)": 1 }"#), vec!["`omga(4)` is no quantity", "omega(4)"]),
        ("point.json", form(r#""values": { "vplan(b,s4)": 1 }"#), vec!["no plan point `s4`", "did you mean `s3`"]),
        (
            "far-point.json",
            form(r#""mu_v": 1, "points": { "velocity": { "p": [0, 0], "zz": [1, 2] } }"#),
            vec!["no plan point `zz`", "--template` lists the names"],
        ),
        (
            "far-name.json",
            form(r#""values": { "speed": 1 }"#),
            vec!["`speed` is no quantity", "help: `kinegon check SCENE --template`"],
        ),
        (
            "unit.json",
            form(r#""values": { "omega(4)": { "value": 1, "unit": "mm" } }"#),
            vec!["`mm` is no unit of an angular velocity", "rad/s"],
        ),
        ("scale.json", form(r#""values": { "vplan(b,s3)/mu": 59 }"#), vec!["mu_v is missing", "add mu_v"]),
        ("zero.json", form(r#""mu_v": 0, "values": { "vplan(b,s3)/mu": 59 }"#), vec!["mu_v is no scale"]),
        (
            "twice.json",
            form(r#""mu_v": 1, "values": { "vplan(b,s3)/mu": 59, "vplan(b,s3)": 69 }"#),
            vec!["two values", "59", "69"],
        ),
        ("empty.json", form(r#""values": { "vplan(b,s3)": "" }"#), vec!["the form is empty", "--template"]),
        (
            "digits.json",
            form(r#""values": { "vplan(b,s3)": "59,4 mm" }"#),
            vec!["`mm` is no unit of a velocity", "`mm/s`"],
        ),
        ("pole.json", form(r#""mu_v": 1, "points": { "velocity": { "b": [0, 0] } }"#), vec!["do not have its pole p"]),
        ("text.csv", "quantity,value\nL(B,S3),long\n".to_owned(), vec!["line 2", "`long` is no number"]),
        ("nan.csv", "quantity,value\nL(B,S3),NaN\n".to_owned(), vec!["line 2", "`NaN` is no number"]),
        ("twice.csv", "L(B,S3),370\nL(S3,B),248\n".to_owned(), vec!["line 2", "two values"]),
        (
            "coordinate.csv",
            "mu_v,1\nvelocity:p,0,0\nvelocity:b,1,\n".to_owned(),
            vec!["line 3", "no coordinate", "velocity:b,114,-2.7"],
        ),
        ("key.json", form(r#""valus": {}"#), vec!["unknown key `valus`", "values"]),
    ] {
        let said = refused(name, &text);
        let is_far = name.starts_with("far-");
        assert!(!is_far || !said.contains("nearest") && !said.contains("did you mean"), "{said}");
        for part in parts {
            assert!(said.contains(part), "{name}: {said}");
        }
    }
    let large = "L(B,S3),370.96\n".repeat(7_000_000);
    let said = refused("large.csv", &large);
    assert!(said.contains("larger than 4 MB"), "{said}");
}

#[test]
fn the_empty_form_names_every_quantity_of_the_steps_and_is_seen_to_be_empty() {
    let print = |more: &[&str]| {
        let output = kinegon().args(["check", SCENE]).args(more).output();
        let output = output.expect("the program starts");
        assert!(output.status.success(), "{}", stderr(&output));
        String::from_utf8(output.stdout).expect("text")
    };
    let json = print(&["--template"]);
    let csv = print(&["--template", "csv"]);
    let names = ["L(B,S3)", "vplan(p,b)", "vplan(b,s3)", "omega(4)", "aplan(b,k_b3)", "aplan(k_b3,n_b3)", "alpha(5)"];
    let mut last = [0, 0];
    for name in names {
        for (place, text) in last.iter_mut().zip([&json, &csv]) {
            let at = text.find(&format!("\"{name}\"")).unwrap_or_else(|| panic!("{name}"));
            assert!(at > *place, "{name} stands in the order of the steps");
            *place = at;
        }
    }
    assert!(refused("form.json", &json).contains("empty"));
    assert!(refused("form.csv", &csv).contains("empty"));
}

/// The numbers of Quintero et al. (2011) as they are printed, taken for a student's: word for word.
#[test]
fn the_paper_as_a_student() {
    let output = kinegon().args(["check", SCENE, "examples/paper-as-student.json"]).output();
    let output = output.expect("the program starts");
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stdout).expect("text");
    let start = said.find("No single mistake").expect("more than one mistake");
    let diagnosis = &said[start..];
    let expected = include_str!("../files/paper-as-student.txt");
    assert_eq!(diagnosis.trim(), expected.trim(), "\n{diagnosis}");
    let off: Vec<&str> = said.lines().filter(|l| l.ends_with("OFF")).filter_map(|l| l.split("  ").next()).collect();
    assert_eq!(off, ["B S3", "|v_BA|", "a_r(3/2)"]);
}

/// The verdicts of a check as JSON.
fn verdicts(name: &str, text: &str) -> (Option<i32>, Vec<String>) {
    let output = check(name, text, &["--json", "--depth", "1"]);
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let values = result["values"].as_array().expect("a list").iter();
    (output.status.code(), values.filter_map(|v| v["verdict"].as_str()).map(str::to_owned).collect())
}

/// ω₄ = −0.4747 rad/s and a_r = −58.41 mm/s²: a number without a sign is a positive one where the form says which sense
/// is, and has no sense where it does not.
#[test]
fn a_rate_without_a_sense_is_never_right() {
    let asks = r#""positive": "counter-clockwise", "#;
    for (values, asked, verdict, code) in [
        (r#""omega(4)": 0.4747"#, false, "sense-missing", 1),
        (r#""omega(4)": 0.48"#, false, "sense-missing", 1),
        (r#""omega(4)": 0.9"#, false, "off", 1),
        (r#""omega(4)": "+0.4747""#, false, "off", 1),
        (r#""omega(4)": -0.4747"#, false, "right", 1),
        (r#""omega(4)": 0.4747"#, true, "off", 1),
        (r#""omega(4)": "-0.4747""#, true, "right", 1),
        (r#""a_r(3/2)": 58.4"#, false, "sense-missing", 1),
        (r#""a_r(3/2)": 58.4"#, true, "off", 1),
        (r#""a_r(3/2)": -58.4"#, true, "right", 1),
        // Segments have no sense.
        (r#""vplan(b,s3)": 59.41"#, false, "right", 1),
    ] {
        let text = form(&format!(r#"{}"values": {{ {values} }}"#, if asked { asks } else { "" }));
        let told = verdicts("senses.json", &text);
        assert_eq!(told, (Some(code), vec![verdict.to_owned()]), "{text}");
    }
    let said = check("senses.json", &form(r#""values": { "omega(4)": 0.4747 }"#), &[]).stdout;
    let said = String::from_utf8(said).expect("text");
    for part in ["1 without a sense", "sense missing", "Write + or − before it", "Nothing is off: 0 of"] {
        assert!(said.contains(part), "{said}");
    }
}

/// A form as a spreadsheet saves it, in whatever encoding and with whatever separators.
#[test]
fn spreadsheets_may_save_a_form_as_they_like() {
    let lines =
        ["quantity;value;unit", "name;Zoë;", "aplan(π,s3);67,84;", "omega(4);−0,4747;rad/s", "alpha(4);-0,4485;"];
    let plain = lines.join("\r\n");
    let without_greek = plain.replace('π', "pi").replace('−', "-");
    let utf16 = |text: &str, bytes: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(bytes).collect::<Vec<u8>>();
    let marked = format!("\u{feff}{plain}");
    let latin: Vec<u8> = without_greek.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1")).collect();
    for (name, bytes) in [
        ("utf-8.csv", plain.clone().into_bytes()),
        ("utf-8-bom.csv", marked.clone().into_bytes()),
        ("utf-16-le.csv", utf16(&marked, u16::to_le_bytes)),
        ("utf-16-be.csv", utf16(&marked, u16::to_be_bytes)),
        ("utf-16-no-mark.csv", utf16(&without_greek, u16::to_le_bytes)),
        ("windows-1252.csv", latin),
        ("mac.csv", plain.replace("\r\n", "\r").into_bytes()),
        ("tabs.csv", plain.replace(';', "\t").into_bytes()),
        ("separator.csv", format!("sep=;\r\n{plain}").into_bytes()),
        ("commas.csv", plain.replace(',', ".").replace(';', ",").replace("aplan(π.s3)", "aplan(π,s3)").into_bytes()),
        (
            "comma.json",
            form(
                r#""name": "Zoë", "values": { "aplan(pi,s3)": "67,84", "omega(4)": "-0,4747", "alpha(4)": "-0.4485" }"#,
            )
            .into_bytes(),
        ),
    ] {
        let file = scratch(&format!("check-{name}")).join(name);
        std::fs::write(&file, bytes).expect("it can be written");
        let output = kinegon().args(["check", SCENE, "--json"]).arg(&file).output().expect("the program starts");
        let result: serde_json::Value =
            serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{name}: {}", stderr(&output)));
        assert_eq!(result["name"], "Zoë", "{name}");
        let values: Vec<f64> =
            result["values"].as_array().expect("a list").iter().filter_map(|v| v["value"].as_f64()).collect();
        assert_eq!(values, [-0.4747, 67.84, -0.4485], "{name}");
    }
    let file = scratch("check-binary").join("binary.csv");
    std::fs::write(&file, [0x50, 0x4b, 3, 4, 20, 0, 6, 0]).expect("written");
    let output = kinegon().args(["check", SCENE]).arg(&file).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("is no text"), "{}", stderr(&output));
}

/// All that is wrong with a form is told at once, each with its line and what to try.
#[test]
fn all_faults_of_a_form_are_told_together() {
    let csv = "quantity;value\naplan(?,s3);67,8\nmu_v;two\nomga(4);1\nomega(4);fast\nalpha(4);-0,448\n";
    let said = refused("faults.csv", csv);
    let parts = ["4 things", "line 2: the letter π was lost in `aplan(?,s3)`: save as CSV UTF-8, or write pi"];
    for part in parts.into_iter().chain(["line 3: mu_v is `two`", "line 4: `omga(4)` is no quantity", "line 5: `fast`"])
    {
        assert!(said.contains(part), "{said}");
    }
    let said = refused("faults.json", &form(r#""mu_v": 0, "values": { "omga(4)": 1, "omega(4)": "fast" }"#));
    for part in ["3 things", "mu_v is no scale", "values.omga(4)", "values.omega(4): `fast` is no number"] {
        assert!(said.contains(part), "{said}");
    }
}

/// A form has the names of the sheet in any notation, and a check takes those of all notations.
#[test]
fn forms_and_sheets_have_the_same_names() {
    let template = |notation: &str| {
        let arguments = ["check", "templates/four-bar.json", "--template", "--notation", notation];
        let output = kinegon().args(arguments).output().expect("the program starts");
        let form: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(form["positive"], "counter-clockwise");
        let names: Vec<String> = form["values"].as_object().expect("values").keys().cloned().collect();
        names
    };
    assert!(template("paper").contains(&"aplan(π,b)".to_owned()));
    assert!(template("english").contains(&"aplan(o',b')".to_owned()));
    assert!(template("german").contains(&"vplan(P_v,b)".to_owned()));
    for notation in ["paper", "english", "russian", "german"] {
        // p b of the crank: 600 mm/s, and 6000 mm/s².
        for [v, a] in [["vplan(o,b)", "aplan(o′,b′)"], ["vplan(p,b)", "aplan(pi,b)"], ["vplan(P_v,b)", "aplan(P_a,b)"]]
        {
            let text = form(&format!(r#""values": {{ "{v}": 600, "{a}": 6000 }}"#));
            let file = scratch("check-notation").join("form.json");
            std::fs::write(&file, text).expect("written");
            let arguments = ["check", "templates/four-bar.json", "--json", "--notation", notation];
            let output = kinegon().args(arguments).arg(&file).output().expect("the program starts");
            let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
            for value in result["values"].as_array().expect("a list") {
                assert_eq!(value["verdict"], "right", "{v} {notation}: {}", stderr(&output));
            }
            assert_eq!(result["values"][0]["quantity"], "vplan(p,b)");
            assert_eq!(result["values"][1]["quantity"], "aplan(π,b)");
        }
    }
    // What a person reads has the names of the sheet, also in sentences.
    let points =
        form(r#""mu_v": 1, "points": { "velocity": { "o": [10, 20], "b": [44.2, 114.0], "s3": [4.5, 158.1] } }"#);
    let output = check("points-english.json", &points, &["--notation", "english"]);
    let said = String::from_utf8(output.stdout).expect("text");
    assert!(said.contains("o b ") && !said.contains("vplan"), "{said}");
}

/// A template has boxes for arms where it is to, each before what its moment finds; a figure without force polygons has none.
#[test]
fn arms_are_asked_for_by_an_option() {
    let folder = scratch("check-arms");
    let mut scene: Value = serde_json::from_str(&files::read("templates/four-bar.json")).expect("a scene");
    scene["units"] = json!({ "length": "mm", "time": "s", "mass": "kg", "force": "N" });
    scene["analysis"] = json!("static");
    scene["forces"] = json!([{ "name": "P", "on": "2", "at": 60, "force": { "size": 150, "angle": 250 } }]);
    scene["figure"] = json!({ "panels": ["scheme", "forces"] });
    let file = folder.join("scene.json");
    std::fs::write(&file, scene.to_string()).expect("it can be written");
    let template = |more: &[&str]| {
        let output =
            kinegon().arg("check").arg(&file).args(["--template", "json"]).args(more).output().expect("it starts");
        assert!(output.status.success(), "{}", stderr(&output));
        let form: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        form["values"].as_object().expect("values").keys().cloned().collect::<Vec<_>>()
    };
    let (usual, with) = (template(&[]), template(&["--arms"]));
    let (arms, others): (Vec<String>, Vec<String>) = with.into_iter().partition(|name| name.starts_with("arm("));
    assert_eq!(others, usual);
    assert!(arms.contains(&"arm(P,C)".to_owned()) && arms.contains(&"arm(R_t(B,2),C)".to_owned()), "{arms:?}");
    let refused = kinegon().args(["check", SCENE, "--template", "--arms"]).output().expect("it starts");
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("no force polygons"), "{}", stderr(&refused));
}

/// Corners that the force polygons do not have are refused alike, whatever is made of the scene; whoever asks for other panels does without.
#[test]
fn corners_that_are_not_there_are_refused_everywhere() {
    let folder = scratch("corners");
    let mut scene: Value = serde_json::from_str(&files::read("templates/four-bar.json")).expect("a scene");
    scene["units"] = json!({ "length": "mm", "time": "s", "mass": "kg", "force": "N" });
    scene["analysis"] = json!("static");
    scene["forces"] = json!([{ "name": "P", "on": "2", "at": 60, "force": { "size": 150, "angle": 250 } }]);
    scene["figure"] = json!({ "panels": ["scheme", "forces"] });
    scene["want"] = json!(["omega(3)", "fplan(o1,z9)"]);
    let file = folder.join("scene.json");
    std::fs::write(&file, serde_json::to_string_pretty(&scene).expect("JSON")).expect("it can be written");
    let said = |arguments: &[&str]| {
        let output = kinegon().arg(arguments[0]).arg(&file).args(&arguments[1..]).current_dir(&folder).output();
        let output = output.expect("it starts");
        (output.status.code(), stderr(&output))
    };
    let (code, solved) = said(&["solve"]);
    assert!(code == Some(2) && solved.contains("z9") && solved.contains("scene.json"), "{solved}");
    for command in [&["draw", "-o", "x.svg"][..], &["steps"], &["check", "--template"]] {
        assert_eq!(said(command), (Some(2), solved.clone()), "{command:?}");
    }
    let (code, said) = said(&["draw", "--focus", "scheme", "-o", "x.svg"]);
    assert_eq!(code, Some(0), "{said}");
}

/// A scene's form that asks for what is not there is refused at its place by all that make something of the form.
#[test]
fn a_form_that_asks_for_what_is_not_there_is_refused() {
    let folder = scratch("asked-not-there");
    let (scene, form) = (folder.join("scene.json"), folder.join("form.json"));
    std::fs::write(&form, r#"{ "kinegon_measured": 1, "values": { "L(A,D)": 160 } }"#).expect("written");
    for (asked, message) in [
        (json!({ "omega(9)": 1 }), "`omega(9)`: there is no link `9` here"),
        (json!({ "omega(3)": 1, "vplan(x,y)": 3 }), "`vplan(x,y)`: there is no plan point `x` here"),
        (json!({ "omega(3)": 1, "v(B)": 1 }), "no step finds `v(B)`"),
    ] {
        let mut text: Value = serde_json::from_str(&files::read("templates/four-bar.json")).expect("a scene");
        text["form"] = asked;
        std::fs::write(&scene, serde_json::to_string_pretty(&text).expect("JSON")).expect("written");
        let [path, form] = [&scene, &form].map(|path| path.to_str().expect("UTF-8"));
        let out = folder.join("out");
        let exercise = ["exercise", path, "--seed", "1", "-o", out.to_str().expect("UTF-8")];
        for arguments in [&["check", path, form][..], &["check", path, "--template"], &["solve", path], &exercise] {
            let output = kinegon().args(arguments).output().expect("it starts");
            let said = stderr(&output);
            assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
            assert!(said.contains(message) && said.contains("scene.json:") && said.contains("help"), "{said}");
        }
        assert!(!out.exists());
    }
}
