//! The program from outside: results on stdout, one clear message on stderr, the right exit code, nothing half-written.

use std::path::Path;
use support::files;
use support::program::{kinegon, scratch, stderr, with_scene};

const FIGURE_2: &str = include_str!("../../examples/figure-2.json");
const BOOM: &str = include_str!("../../templates/hydraulic-boom.json");

/// A scene that must be refused: exit code, words that the message must have, the scene.
fn refused() -> Vec<(i32, Vec<&'static str>, Vec<u8>)> {
    let changed = |from: &str, to: &str| {
        assert!(FIGURE_2.contains(from), "{from}");
        FIGURE_2.replacen(from, to, 1).into_bytes()
    };
    let drawn = |points: &str| {
        format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "points": {{ {points} }},
            "known": {{ "B": {{ "velocity": [1, 0] }}, "E": {{ "velocity": [0, 1] }} }},
            "links": {{ "2": ["B", "C", "G"], "3": ["C", "D"], "4": ["E", "D", "F"], "5": ["G", "F"] }} }}"#
        )
        .into_bytes()
    };
    let boom = |from: &str, to: &str| {
        assert!(BOOM.contains(from), "{from}");
        BOOM.replacen(from, to, 1).into_bytes()
    };
    let mut huge = FIGURE_2.as_bytes().to_vec();
    huge.resize(50 << 20, b' ');
    vec![
        (2, vec!["empty"], b"".to_vec()),
        (2, vec!["empty"], b"  \n ".to_vec()),
        (
            2,
            vec!["stdin:2:"],
            b"{ \"kinegon\": 1,\n \"units\": }\n".to_vec(),
        ),
        (2, vec!["UTF-8", "byte 1"], b"{\xff}".to_vec()),
        (
            2,
            vec!["version"],
            changed("\"kinegon\": 1", "\"kinegon\": 2"),
        ),
        (
            2,
            vec![
                "unknown key `lenghts`",
                "did you mean `lengths`?",
                "links.1.lenghts",
            ],
            changed("\"lengths\"", "\"lenghts\""),
        ),
        (
            2,
            vec!["link 3 has no point X"],
            changed(
                "\"link\": \"3\", \"at\": \"D\"",
                "\"link\": \"3\", \"at\": \"X\"",
            ),
        ),
        (2, vec!["9"], changed("\"link\": \"3\"", "\"link\": \"9\"")),
        (
            2,
            vec!["link 4: lengths GD 300, FG 50, FD 180 cannot form a triangle: 50 + 180 < 300"],
            changed("\"FG\": 150", "\"FG\": 50"),
        ),
        (2, vec!["AB", "0"], changed("\"AB\": 100", "\"AB\": 0")),
        (
            2,
            vec!["text \"100\""],
            changed("\"AB\": 100", "\"AB\": \"100\""),
        ),
        (2, vec!["1e400"], changed("\"AB\": 100", "\"AB\": 1e400")),
        (2, vec!["larger than 4 MB"], huge),
        (
            2,
            vec!["B", "C"],
            drawn(
                r#""B": [0,0], "C": [0,0], "D": [0,0], "E": [4,0.5], "F": [4.75,-1.5], "G": [1.5,-1.25]"#,
            ),
        ),
        // Lines CD, GF and BE all vertical.
        (
            1,
            vec!["singular position", "CD", "GF", "BE", "parallel"],
            drawn(r#""B": [0,0], "C": [1,1], "D": [1,4], "E": [0,5], "F": [-2,3.5], "G": [-2,1]"#),
        ),
        // A number that no unit needs, and two links so short that they turn too fast.
        (
            2,
            vec!["too large to compute with", "1e100"],
            drawn(
                r#""B": [0,0], "C": [1e308,0], "D": [-1e308,1], "E": [4,0.5], "F": [4.75,-1.5], "G": [1.5,-1.25]"#,
            ),
        ),
        (
            1,
            vec!["too large to be represented"],
            drawn(
                r#""B": [0,0], "C": [1e-155,0], "D": [-2e-155,1e-155], "E": [4e-155,5e-156], "F": [5e-155,-2e-155], "G": [1e-155,-1e-155]"#,
            ),
        ),
        // Lengths whose fourth powers are no numbers.
        (
            1,
            vec!["lengths of about 4", "e71 are too large to assemble from", "another unit of length"],
            changed("\"EF\": 300", "\"EF\": 4e71"),
        ),
        // Link 5 is too short to reach.
        (
            1,
            vec!["cannot be assembled", "EF", "longer", "angle(1) = 70"],
            changed("\"EF\": 300", "\"EF\": 3"),
        ),
        (
            2,
            vec!["links 2, 3, 4 can still move", "add 1 drive"],
            changed("\"5\": {", "\"note\": {"),
        ),
        // A cylinder: without a stroke, without a drive, too long, with all its pins in one line.
        (
            2,
            vec!["gives no `position`", "sliders[0].drive"],
            boom("\"position\": 450, ", ""),
        ),
        (
            2,
            vec!["links 2, 3, 4 can still move (1 free motion left)", "add 1 drive"],
            boom("\"drive\"", "\"note\""),
        ),
        (
            1,
            vec!["links 2+3, 4 cannot be assembled", "position(3/2) = 4500", "longer"],
            boom("\"position\": 450", "\"position\": 4500"),
        ),
        (
            1,
            vec!["limit position at position(3/2)", "links 2+3, 4 can go no further", "AC and CO lie in one line"],
            boom("\"position\": 450", "\"position\": 1382.6237921249264"),
        ),
        // Drives too many: one that turns the boom, one that turns the cylinder, a ring of two, a pin of cylinder and rod together.
        (
            2,
            vec!["links 2, 3 cannot move as driven (1 constraint too many)"],
            boom("\"4\": {", "\"4\": { \"drive\": { \"angle\": 50, \"omega\": 1 },"),
        ),
        (
            2,
            vec!["link 4 cannot move as driven (1 constraint too many)"],
            boom("\"points\": [\"A\", \"B\"]", "\"drive\": { \"angle\": 50, \"omega\": 1 }, \"points\": [\"A\", \"B\"]"),
        ),
        (
            2,
            vec!["links 2, 3 cannot move as driven (3 constraints too many)"],
            boom(
                "\"sliders\": [",
                "\"sliders\": [{ \"link\": \"2\", \"at\": \"B\", \"on\": \"3\", \"drive\": { \"position\": 450, \"speed\": 0 } },",
            ),
        ),
        (
            2,
            vec!["links 2, 3 cannot move as driven (2 constraints too many)"],
            boom(
                "\"points\": [\"D\", \"C\"], \"lengths\": { \"DC\": 900 }",
                "\"points\": [\"D\", \"C\", \"B\"], \"lengths\": { \"DC\": 900, \"DB\": 450, \"BC\": 450 }",
            ),
        ),
        // Two cranks pinned together.
        (
            2,
            vec!["point C is given twice: by the drive of link 1 and by the drive of link 2"],
            br#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "B": [100, 0] },
                "links": { "1": { "points": ["A", "C"], "lengths": { "AC": 80 }, "drive": { "angle": 50, "omega": 1 } },
                           "2": { "points": ["B", "C"], "lengths": { "BC": 80 }, "drive": { "angle": 130, "omega": 1 } } } }"#
                .to_vec(),
        ),
    ]
}

#[test]
fn bad_scenes_get_one_message_and_the_right_exit_code() {
    for (code, words, scene) in refused() {
        let shown = String::from_utf8_lossy(&scene[..scene.len().min(2000)]).into_owned();
        for task in ["solve", "draw", "steps"] {
            let folder = scratch("refused");
            let out = folder.join("figures");
            let out = out.to_str().expect("a path in UTF-8");
            let arguments = match task {
                "draw" => vec!["draw", "-", "-o", out],
                task => vec![task, "-"],
            };
            let output = with_scene(&arguments, &scene);
            let message = stderr(&output);
            assert_eq!(output.status.code(), Some(code), "{task}: {message}\n{shown}");
            assert!(output.stdout.is_empty(), "{task}\n{shown}");
            assert!(!Path::new(out).exists(), "{task}\n{shown}");
            assert_eq!(message.matches("error").count(), 1, "{message}");
            for word in &words {
                assert!(message.contains(word), "no `{word}` in: {message}\n{shown}");
            }
        }
    }
}

#[test]
fn near_far_from_every_mode_gives_a_warning() {
    let scene = FIGURE_2.replace("[263, 300]", "[2630, 3000]");
    let output = with_scene(&["solve", "-"], scene.as_bytes());
    assert_eq!(output.status.code(), Some(0));
    let message = stderr(&output);
    assert!(message.contains("warning") && message.contains("`near`"), "{message}");
    assert!(message.contains("away"), "{message}");
    let calm = with_scene(&["solve", "-"], FIGURE_2.as_bytes());
    assert!(calm.stderr.is_empty(), "{}", stderr(&calm));
}

/// The mean over all places hides one that is far off.
#[test]
fn one_point_far_from_its_rough_place_gives_a_warning() {
    let moved = FIGURE_2.replace("\"E\": [406, 428]", "\"E\": [406, 228]");
    assert_ne!(moved, FIGURE_2);
    let message = stderr(&with_scene(&["solve", "-"], moved.as_bytes()));
    assert!(message.contains("point E is at") && message.contains("away from its place in `near`"), "{message}");
}

#[test]
fn angles_that_look_like_radians_give_a_warning() {
    let shaper = files::read("tests/lecture/shaper.json");
    for (angle, degrees) in [("1.0472", Some("60")), ("0.5236", Some("30")), ("1.5", None), ("60", None)] {
        let scene = shaper.replace("\"angle\": 30", &format!("\"angle\": {angle}"));
        let message = stderr(&with_scene(&["solve", "-"], scene.as_bytes()));
        let warned = degrees.map(|degrees| format!("looks like radians: angles are in degrees, so {degrees} if"));
        match warned {
            Some(warned) => assert!(message.contains(&warned), "{angle}: {message}"),
            None => assert!(!message.contains("radians"), "{angle}: {message}"),
        }
    }
}

/// A four-bar with a second coupler: Grübler counts 3·4 − 2·6 = 0.
#[test]
fn too_many_constraints_are_told_with_the_count_of_freedoms() {
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [160, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 60, "omega": 10 } },
                   "2": { "points": ["B", "C"], "lengths": { "BC": 140 } },
                   "3": { "points": ["D", "C"], "lengths": { "CD": 110 } },
                   "4": { "points": ["B", "D"], "lengths": { "BD": 150 } } } }"#;
    let message = stderr(&with_scene(&["solve", "-"], scene.as_bytes()));
    assert!(
        message.contains("1 constraint too many") && message.contains("mobility 3·4 − 12 = 0 with 1 drive"),
        "{message}"
    );
}

#[test]
fn without_near_the_modes_are_listed() {
    let at = FIGURE_2.find("\"near\"").expect("the example has it");
    let end = FIGURE_2[at..].find("},").expect("it ends") + at + 2;
    // Without `near` the triangle's hand is open too, so it is given as a shape.
    let shape = r#""4": { "shape": { "G": [0, 0], "D": [300, 0], "F": [133.5, -68.39407869106799] } },"#;
    let scene = format!("{}{}", &FIGURE_2[..at], &FIGURE_2[end..]);
    let from = scene.find("\"4\"").expect("link 4");
    let to = scene.find("\"5\"").expect("link 5");
    let scene = format!("{}{shape}{}", &scene[..from], &scene[to..]);
    let output = with_scene(&["solve", "-"], scene.as_bytes());
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(0), "{message}");
    assert!(message.contains("2 ways") && message.contains("mode 1"), "{message}");
    assert!(message.contains("E (405.96, 428.33)"), "{message}");
}

#[test]
fn solve_answers_want() {
    let want = r#""want": ["omega(2)", "vplan(b,s3)", "vplan(b,s3)/mu", "v(D)", "a_n(S3/B)"], "figure""#;
    let scene = FIGURE_2.replace("\"figure\"", want);
    let output = with_scene(&["solve", "-"], scene.as_bytes());
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let quantities = result["quantities"].as_object().expect("an object");
    assert_eq!(quantities.len(), 5);
    let near = |name: &str, value: f64| {
        let got = quantities[name].as_f64().expect("a number");
        assert!((got - value).abs() < 1e-9, "{name}: {got}");
    };
    near("omega(2)", -0.00860783887219);
    near("vplan(b,s3)", 59.40764643033);
    near("vplan(b,s3)/mu", 59.40764643033);

    // Who wants a velocity gets everything else, too.
    let scene = FIGURE_2.replace("\"figure\"", r#""want": ["omega(2)"], "figure""#);
    let output = with_scene(&["solve", "-"], scene.as_bytes());
    assert!(String::from_utf8_lossy(&output.stdout).contains("acceleration"));

    let scene = FIGURE_2.replace("\"figure\"", r#""want": ["omega(22)"], "figure""#);
    let output = with_scene(&["solve", "-"], scene.as_bytes());
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(2));
    assert!(message.contains("did you mean `2`?") && message.contains("want"), "{message}");
}

#[test]
fn draw_writes_both_paper_figures() {
    let folder = scratch("draw");
    let out = folder.join("new/folder");
    let run = kinegon().arg("draw").arg("-o").arg(&out).arg("--format").arg("svg").output();
    assert_eq!(run.expect("the program runs").status.code(), Some(0));
    let mut names: Vec<String> = std::fs::read_dir(&out)
        .expect("it was made")
        .map(|e| e.expect("listed").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert_eq!(names, ["figure-1.svg", "figure-2.svg"]);
}

#[test]
fn output_follows_the_ending_and_never_covers_the_scene() {
    let folder = scratch("ending");
    let scene = folder.join("scene.svg");
    std::fs::write(&scene, FIGURE_2).expect("written");
    let run = |out: &Path| {
        let mut command = kinegon();
        command.arg("draw").arg(&scene).arg("-o").arg(out);
        command.output().expect("the program runs")
    };
    let refused = run(&scene);
    assert_eq!(refused.status.code(), Some(2));
    assert_eq!(std::fs::read_to_string(&scene).expect("read"), FIGURE_2);
    let unknown = run(&folder.join("figure.bmp"));
    assert_eq!(unknown.status.code(), Some(2));
    assert!(stderr(&unknown).contains("known endings: svg"));
    assert_eq!(run(&folder.join("figure.svg")).status.code(), Some(0));
    assert!(std::fs::read_to_string(folder.join("figure.svg")).expect("read").starts_with("<svg"));
    let stdout = run(Path::new("-"));
    assert!(stdout.stdout.starts_with(b"<svg"));
}

/// What each format's files start with, by its name and its ending.
const FORMATS: &[(&str, &str, &[u8])] = &[
    ("svg", "svg", b"<svg"),
    #[cfg(feature = "pdf")]
    ("pdf", "pdf", b"%PDF-1."),
    ("tikz", "tex", b"% Quintero et al. (2011), Figure 2\n"),
    #[cfg(feature = "png")]
    ("png", "png", b"\x89PNG"),
];

/// Those that are made of a scene and not of a sheet.
const OF_SCENES: &str = if cfg!(feature = "png") { "html, gif, apng" } else { "html" };

#[test]
fn draw_and_curves_write_all_formats() {
    let folder = scratch("formats");
    for task in ["draw", "curves"] {
        let (mut formats, mut endings) = (String::new(), String::new());
        for (format, ending, start) in FORMATS {
            let on_stdout = with_scene(&[task, "-", "--format", format, "-o", "-"], FIGURE_2.as_bytes());
            assert!(on_stdout.stdout.starts_with(start), "{task}: {}", stderr(&on_stdout));
            let file = folder.join(format!("{task}.{ending}"));
            let place = file.to_str().expect("a path in UTF-8");
            let to_file = with_scene(&[task, "-", "-o", place], FIGURE_2.as_bytes());
            assert_eq!(to_file.status.code(), Some(0), "{task}: {}", stderr(&to_file));
            // The file says the same as stdout did.
            assert!(std::fs::read(&file).expect("it was written") == on_stdout.stdout, "{task}: {format}");
            let apart = if formats.is_empty() { "" } else { ", " };
            formats = formats + apart + format;
            endings = endings + apart + ending;
        }
        let unknown = with_scene(&[task, "-", "-o", "figure.bmp"], FIGURE_2.as_bytes());
        assert!(stderr(&unknown).contains(&format!("known endings: {endings}, {OF_SCENES}; ")), "{}", stderr(&unknown));
        let unknown = with_scene(&[task, "-", "--format", "bmp"], FIGURE_2.as_bytes());
        assert!(
            stderr(&unknown).contains(&format!("[possible values: {formats}, {OF_SCENES}]")),
            "{}",
            stderr(&unknown)
        );
    }
}

#[test]
fn a_missing_file_and_a_misspelt_task_are_misuse() {
    let missing = kinegon().args(["solve", "no such file.json"]).output();
    let missing = missing.expect("the program runs");
    assert_eq!(missing.status.code(), Some(2));
    assert!(stderr(&missing).contains("no such file.json"));
    let misspelt = kinegon().arg("slove").output().expect("the program runs");
    assert_eq!(misspelt.status.code(), Some(2));
}

#[test]
fn steps_are_numbered_and_measured_on_paper() {
    let output = with_scene(&["steps", "-"], FIGURE_2.as_bytes());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    for line in [
        "  1. S3, special point of link 3: where the normal to the guide of 3/2 through B meets GD.",
        "L_BS3 = 370.9648 mm (74.19 mm on paper)",
        "b s3 = 59.40765 mm/s (59.41 mm on paper)",
        "ω_2 L_S3B + v_r(3/2) = μ_v (b s3)",
        "omega(4) = -0.4746638 rad/s",
        "a_r(3/2) = -58.41247 mm/s²",
    ] {
        assert!(text.contains(line), "no `{line}` in\n{text}");
    }
}

#[test]
fn structure_is_written_as_a_formula() {
    let output = with_scene(&["structure", "-"], FIGURE_2.as_bytes());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(text.starts_with("I(1) → IV(2, 3, 4, 5; RRP-RRR)\n"), "{text}");
    assert!(text.contains("degrees of freedom: 1"), "{text}");
    assert!(text.contains("special points S3, S5"), "{text}");
}

#[test]
fn a_cylinder_and_its_rod_are_one_link() {
    let output = |task: &str, more: &[&str]| {
        let output = with_scene(&[&[task, "-"], more].concat(), BOOM.as_bytes());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let structure = output("structure", &[]);
    assert!(
        structure.starts_with("I(3/2) → II(2+3, 4; RRR)\ndegrees of freedom: 1, as many as drives\n"),
        "{structure}"
    );
    let modes = output("modes", &[]);
    assert!(modes.starts_with("2 assembly modes"), "{modes}");
    // 2 ω_2 v_r and ω_2² L_AC, with ω_2 = 0.09740614212 and AC = 1350.
    let steps = output("steps", &["--mu-v", "2", "--mu-a", "1"]);
    for line in [
        "Lay off the sliding velocity of 3/2 along its guide, from a to r_a3.",
        "a r_a3 = 80.00000 mm/s (40.00 mm on paper), direction 68.46°",
        "v_C = v_A + v_r(3/2) + v_CA; direction 158.46°",
        "ω_3 L_CA = μ_v (r_a3 c)",
        "omega(4) = 0.1026143 rad/s",
        "a r_a3 = 30.00000 mm/s² (30.00 mm on paper), direction 68.46°",
        "Lay off the Coriolis acceleration of 3/2, its sliding velocity turned by 90° in the sense of ω_2, from r_a3 to k_a3.",
        "r_a3 k_a3 = 15.58498 mm/s² (15.58 mm on paper), direction 158.46°",
        "k_a3 n_aC = 12.80874 mm/s² (12.81 mm on paper), direction -111.54°",
        "a_C = a_A + a_r(3/2) + a_c(3/2) + a^n_CA + a^t_CA; direction 158.46°",
    ] {
        assert!(steps.contains(line), "no `{line}` in\n{steps}");
    }
    // The normal part starts where the Coriolis acceleration ends.
    let want = r#""want": ["a_n(C/A)", "a_c(3/2)", "a_r(3/2)"], "figure""#;
    let output = with_scene(&["solve", "-"], BOOM.replace("\"figure\"", want).as_bytes());
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let size = |name: &str| {
        let vector = [0, 1].map(|i| result["quantities"][name][i].as_f64().expect("a number"));
        libm::hypot(vector[0], vector[1])
    };
    assert!((size("a_n(C/A)") - 12.808741305796).abs() < 1e-8, "{}", size("a_n(C/A)"));
    assert!((size("a_c(3/2)") - 15.584982739290568).abs() < 1e-12, "{}", size("a_c(3/2)"));
    assert_eq!(result["quantities"]["a_r(3/2)"], 30.0);
}

#[test]
fn modes_are_numbered_and_can_be_asked_for() {
    let output = with_scene(&["modes", "-"], FIGURE_2.as_bytes());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(text.starts_with("2 assembly modes"), "{text}");
    // The other mode of the paper's mechanism at 70°.
    assert!(text.contains("angle(2) -74.017"), "{text}");
    let output = with_scene(&["solve", "-", "--mode", "2"], FIGURE_2.as_bytes());
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(result["groups"][0]["mode"], 2);
    let angle = result["links"]["4"]["angle"].as_f64().expect("a number");
    assert!((angle - -117.28350).abs() < 1e-5, "{angle}");
    let output = with_scene(&["solve", "-", "--mode", "3"], FIGURE_2.as_bytes());
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("there are 2"), "{}", stderr(&output));
}

#[test]
fn modes_are_numbered_from_1() {
    for task in ["solve", "draw", "steps"] {
        let output = with_scene(&[task, "-", "--mode", "0"], FIGURE_2.as_bytes());
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{task}: {message}");
        assert!(output.stdout.is_empty());
        let words = "invalid value '0' for '--mode <MODE>': assembly modes are numbered from 1";
        assert!(message.contains(words), "{message}");
    }
}

#[test]
fn too_many_or_too_few_drives_name_the_links() {
    let second = r#""4": { "drive": { "angle": 92, "omega": 1 }, "#;
    let scene = FIGURE_2.replacen("\"4\": { ", second, 1);
    let output = with_scene(&["structure", "-"], scene.as_bytes());
    assert_eq!(output.status.code(), Some(2));
    let message = stderr(&output);
    assert!(message.contains("too many"), "{message}");
    let drive = r#", "drive": { "angle": 70, "omega": -1, "alpha": 0 }"#;
    let scene = FIGURE_2.replacen(drive, "", 1);
    let output = with_scene(&["structure", "-"], scene.as_bytes());
    assert_eq!(output.status.code(), Some(2));
    let message = stderr(&output);
    assert!(message.contains("can still move (1 free motion left)"), "{message}");
}

#[test]
fn a_pin_in_a_slot_moves_as_a_block_on_a_lever() {
    let scene = |lever: &str, slider: &str| {
        format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "O": [0, 0], "A": [0, 80] }},
            "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 30 }}, "drive": {{ "angle": 45, "omega": 4 }} }},
                       {lever} "3": {{ "points": ["O", "C"], "lengths": {{ "OC": 130 }} }} }},
            "sliders": [{{ {slider}, "on": "3", "along": "OC" }}], "near": {{ "C": [30, 120] }} }}"#
        )
    };
    let solved = |scene: String| -> serde_json::Value {
        let output = with_scene(&["solve", "-"], scene.as_bytes());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        serde_json::from_slice(&output.stdout).expect("JSON")
    };
    let pin = solved(scene("", r#""pin": "B""#));
    let block = solved(scene(r#""2": { "points": ["B"] },"#, r#""link": "2", "at": "B""#));
    // The lever of a crank pin: ω_3 = ω_1 · AB · cos(angle between crank and lever) / OB.
    let (angle, distance) = (33.1627607686381_f64.to_radians(), 103.41234234701112);
    let omega = 4.0 * 30.0 * libm::cos(angle) / distance;
    for result in [&pin, &block] {
        let got = result["links"]["3"]["omega"].as_f64().expect("a number");
        assert!((got - omega).abs() < 1e-12, "{got} {omega}");
    }
    assert_eq!(pin["sliders"]["B/3"]["on"], "3");
    assert_eq!(pin["links"].as_object().expect("links").len(), 2);
    let coriolis = |r: &serde_json::Value, name: &str| r["sliders"][name]["coriolis"].clone();
    assert_eq!(coriolis(&pin, "B/3"), coriolis(&block, "2/3"));
    // Steps name the rates of the lever, with which the pin's own block turns, and have no heading with nothing below it.
    let output = with_scene(&["steps", "-"], scene("", r#""pin": "B""#).as_bytes());
    let steps = String::from_utf8(output.stdout).expect("UTF-8");
    let told = steps.split("omega(3) = ").nth(1).and_then(|rest| rest.split(' ').next());
    let told: f64 = told.expect("it is solved for").parse().expect("a number");
    assert!((told - omega).abs() < 1e-6, "{steps}");
    assert!(steps.contains("equations of the measured segments for α_3, a_r(B/3)."), "{steps}");
    assert!(!steps.contains("On the mechanism"), "{steps}");
}

/// A pin in two crossing slots of a link is held like a pin of that link: both sliders have names of their own.
#[test]
fn two_sliders_of_the_same_two_have_two_names() {
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "Q": [120, -30] },
        "links": { "1": { "points": ["A", "P"], "lengths": { "AP": 40 }, "drive": { "angle": 30, "omega": 2 } },
                   "3": { "shape": { "M": [0, 0] } } },
        "sliders": [{ "pin": "P", "on": "3", "along": 0 }, { "pin": "P", "on": "3", "through": [50, -10], "along": 90 },
                    { "pin": "Q", "on": "3", "along": 0 }],
        "near": { "M": [-10, 40] }, "want": ["v_r(P/3)", "v_r(P/3#2)", "v_r(Q/3)"] }"#;
    let output = with_scene(&["solve", "-"], scene.as_bytes());
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let mut keys: Vec<&String> = result["sliders"].as_object().expect("sliders").keys().collect();
    keys.sort();
    assert_eq!(keys, ["P/3", "P/3#2", "Q/3"]);
    let near = |value: &serde_json::Value, want: f64| {
        let got = value.as_f64().expect("a number");
        assert!((got - want).abs() < 1e-10, "{got} in place of {want}");
    };
    // Link 3 turns with the line from P to Q, along which Q slides by the change of their distance.
    let (sin, cos) = libm::sincos(30_f64.to_radians());
    let (x, y) = (120.0 - 40.0 * cos, -30.0 - 40.0 * sin);
    let (u, v) = (80.0 * sin, -80.0 * cos);
    let length = libm::hypot(x, y);
    near(&result["sliders"]["P/3"]["position"], 50.0);
    near(&result["sliders"]["P/3#2"]["position"], 10.0);
    near(&result["sliders"]["Q/3"]["position"], 50.0 + length);
    near(&result["links"]["3"]["omega"], (x * v - y * u) / (length * length));
    near(&result["quantities"]["v_r(P/3)"], 0.0);
    near(&result["quantities"]["v_r(P/3#2)"], 0.0);
    near(&result["quantities"]["v_r(Q/3)"], (x * u + y * v) / length);
}

#[test]
fn new_writes_every_kind_it_lists_and_nothing_over_a_file() {
    let new = |arguments: &[&str]| {
        let output = kinegon().arg("new").args(arguments).output();
        output.expect("the program runs")
    };
    let listed = new(&[]);
    assert_eq!(new(&["--list"]).stdout, listed.stdout);
    let listed = String::from_utf8(listed.stdout).expect("UTF-8");
    assert_eq!(listed.lines().count(), 31);
    let is_first = listed.starts_with("four-bar ")
        && listed.lines().next().is_some_and(|line| line.ends_with(" Four-bar linkage"));
    assert!(is_first, "{listed}");
    for line in listed.lines() {
        let (kind, title) = line.split_once(' ').expect("a kind and its title");
        let scene = new(&[kind]).stdout;
        assert!(!String::from_utf8_lossy(&scene).contains("$schema"), "{kind}");
        let written: serde_json::Value = serde_json::from_slice(&scene).expect("JSON");
        assert_eq!(written["title"], title.trim_start());
        let solved = with_scene(&["solve", "-"], &scene);
        assert_eq!(solved.status.code(), Some(0), "{kind}: {}", stderr(&solved));
        // A Geneva wheel notes when it is engaged; nothing warns.
        assert!(stderr(&solved).lines().all(|line| line.starts_with("note: ")), "{kind}: {}", stderr(&solved));
    }

    let folder = scratch("new");
    let file = folder.join("deep/mine.json");
    let path = file.to_str().expect("a path in UTF-8");
    assert_eq!(new(&["four-bar", "-o", path]).status.code(), Some(0));
    let first = std::fs::read(&file).expect("it was written");
    let again = new(&["watt-1", "-o", path]);
    assert_eq!(again.status.code(), Some(2));
    assert!(stderr(&again).contains("not overwritten"), "{}", stderr(&again));
    assert_eq!(std::fs::read(&file).expect("it is still there"), first);
    // A folder takes a file of the kind's name.
    let path = folder.to_str().expect("a path in UTF-8");
    assert_eq!(new(&["watt-1", "-o", path]).status.code(), Some(0));
    assert!(folder.join("watt-1.json").exists());

    let unknown = new(&["fourbar"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(stderr(&unknown).contains("'four-bar'"), "{}", stderr(&unknown));
    assert_eq!(new(&["-o", path]).status.code(), Some(2));
}

#[test]
fn curves_that_cannot_be_drawn_get_one_message_and_nothing_is_written() {
    let drawn = include_str!("../../examples/figure-1.json");
    let every_kind = "omega(2),alpha(2),angle(2),v(D),a(D)";
    let coordinates = ["x(D)", "y(D)", "x(E)", "y(E)", "x(F)", "y(F)", "x(B)", "y(B)"];
    let special = ["x(S3)", "y(S3)", "x(S5)", "y(S5)", "position(3/2)"];
    let crowd = [&coordinates[..], &special[..]].concat().join(",");
    let cases: [(i32, &[&str], &[&str], &str); 12] = [
        (2, &["--want", "omega(44)"], &["no link `44`", "did you mean `4`?"], FIGURE_2),
        (2, &["--want", "speed(4)"], &["`speed(4)` is no quantity"], FIGURE_2),
        (2, &["--want", "vplan(b,zz)"], &["no plan point `zz`"], FIGURE_2),
        (2, &["--want", "vplan(b,s3)/mu"], &["length on paper", "without `/mu`"], FIGURE_2),
        (2, &["--want", every_kind], &["5 panels", "room for 4"], FIGURE_2),
        (2, &["--want", &crowd], &["13 curves in one panel"], FIGURE_2),
        (2, &["--drive", "7"], &["no drive `7`", "the drives are: 1"], FIGURE_2),
        (2, &[], &["a drawn configuration cannot be moved"], drawn),
        (1, &["--from", "150", "--to", "200"], &["cannot be reached", "137.58"], FIGURE_2),
        (2, &["--from", "70", "--to", "70"], &["no room for a curve"], FIGURE_2),
        (1, &["--mode", "9"], &["no assembly mode 9"], FIGURE_2),
        (2, &["-o", "curves.bmp"], &["no format", "known endings: svg"], FIGURE_2),
    ];
    for (code, arguments, words, scene) in cases {
        let folder = scratch("no-curves");
        let out = folder.join("figures");
        let out = out.to_str().expect("a path in UTF-8");
        let mut all = vec!["curves", "-"];
        if !arguments.contains(&"-o") {
            all.extend(["-o", out]);
        }
        all.extend(arguments);
        let output = with_scene(&all, scene.as_bytes());
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {message}");
        assert!(output.stdout.is_empty() && !Path::new(out).exists(), "{arguments:?}");
        assert_eq!(message.matches("error").count(), 1, "{message}");
        for word in words {
            assert!(message.contains(word), "no `{word}` in: {message}");
        }
    }
}

#[test]
fn curves_keep_what_can_be_reached() {
    let folder = scratch("curves");
    let out = folder.join("deep/part.svg");
    let place = out.to_str().expect("a path in UTF-8");
    let part = ["curves", "-", "--from", "100", "--to", "150", "-o", place];
    let output = with_scene(&part, FIGURE_2.as_bytes());
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("only a part of the range from 100° to 150° can be reached"), "{message}");
    let drawing = std::fs::read_to_string(&out).expect("it was kept");
    assert!(drawing.contains("Over angle(1) from 100° to 137.582"), "{drawing}");

    // Into a folder under the scene's name, so that the scene's own figure stays.
    let scene = folder.join("mine.json");
    std::fs::write(&scene, FIGURE_2).expect("written");
    let run = kinegon()
        .args(["curves", "--format", "svg", "--want", "omega(4), v_r(3/2)"])
        .arg(&scene)
        .arg("-o")
        .arg(&folder)
        .output()
        .expect("the program runs");
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    assert!(stderr(&run).contains("limit position at angle(1) = 137.58"));
    assert!(folder.join("mine-curves.svg").exists());

    // What the scene wants, else ω of all links that follow, on stdout.
    let described = |scene: &str| {
        let output = with_scene(&["curves", "-", "-o", "-"], scene.as_bytes());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let text = String::from_utf8(output.stdout).expect("UTF-8");
        let text = text.split("<desc>").nth(1).expect("a description");
        text.split("</desc>").next().unwrap_or_default().to_owned()
    };
    let plain = described(FIGURE_2);
    for name in ["omega(2) = omega(3)", "omega(4)", "omega(5)"] {
        assert!(plain.contains(name), "{plain}");
    }
    assert!(!plain.contains("omega(1)"), "{plain}");
    let wanting = FIGURE_2.replace("\"figure\"", r#""want": ["alpha(4)"], "figure""#);
    let wanting = described(&wanting);
    assert!(wanting.contains("alpha(4)") && !wanting.contains("omega"), "{wanting}");
    // A full turn is drawn from 0° to 360° wherever the scene stands.
    let turn = described(include_str!("../../templates/four-bar.json"));
    assert!(turn.starts_with("Over angle(1) from 0° to 360°:"), "{turn}");
}

/// A value that stands behind `=` and was written behind a space: the message says what to type, wherever the scene stands.
#[test]
fn a_value_without_its_equals_sign_is_told_with_it() {
    for (arguments, tip) in [
        (["draw", "--centers", "all", "-"], "write --centers=all"),
        (["draw", "-", "--values", "m"], "write --values=m"),
        (["draw", "-", "--worksheet", "blank"], "write --worksheet=blank"),
    ] {
        let output = with_scene(&arguments, FIGURE_2.as_bytes());
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(tip), "{message}");
    }
}
