//! Languages, notations and decimal marks: nothing is left in another language, numbers have their comma, and results stay what they are.

use kinegon::check::Mistake;
use kinegon::construction::Tolerance;
use kinegon::cycle::{Curves, Drive, Path};
use kinegon::drawing::{Drawing, Shape, curves};
use kinegon::position::{Count, Listed};
use kinegon::quantity::{QuantityRequest, pencil, step_names};
use kinegon::scene::{LanguageName, NotationName, Scene};
use kinegon::words::Wording;
use kinegon::{Order, Solution, format};
use kinegon_web::Engine;
use support::files;
use support::program::{self, kinegon, stderr};
use support::stages::solved;
use support::survey::ALIKE;

/// Scenes of every kind: starting scenes, examples, cylinders, drawn configurations with special points at infinity.
fn scenes() -> Vec<(String, String)> {
    let mut all = files::templates();
    all.extend(files::scenes("examples"));
    all.extend(files::scenes("tests/driven_sliders"));
    let drawn = files::read("tests/drawn_scenes.jsonl");
    let drawn = drawn.lines().enumerate();
    all.extend(drawn.map(|(index, line)| (format!("drawn scene {index}"), line.to_owned())));
    all.into_iter().step_by(ALIKE.now()).collect()
}

/// The scene with these entries in its figure, and a title that is in no language.
fn with(text: &str, entries: &[(&str, &str)]) -> String {
    let mut scene: serde_json::Value = serde_json::from_str(text).expect("JSON");
    scene["title"] = "X".into();
    for (key, value) in entries {
        scene["figure"][key] = (*value).into();
    }
    scene.to_string()
}

/// The text of `kinegon steps`.
fn steps(solution: &Solution) -> String {
    let names = step_names(&solution.construction);
    let asked = names.iter().map(|name| QuantityRequest::new(name, &solution.mechanism).expect("known"));
    let pencil = pencil(solution, &solution.scales(), Tolerance::default(), asked.collect());
    solution.steps(&pencil)
}

/// All that a drawing says, a line each.
fn said(drawing: &Drawing) -> Vec<String> {
    let texts = drawing.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some(text.text.content()),
        _ => None,
    });
    let others = [drawing.title.for_terminal(), drawing.description.clone()];
    texts.chain(others).chain(drawing.steps.clone()).collect()
}

/// All that is said of a scene: on the figure, on the sheets of its steps, in the text of the steps, on its curves, of its
/// structure, its assembly and its special positions.
fn all_said(name: &str, text: &str) -> Vec<String> {
    let solution = solved(text).unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut lines = said(&solution.figure());
    lines.extend(said(&solution.stepwise_figure()));
    lines.extend(steps(&solution).lines().map(str::to_owned));
    lines.extend(said_of_curves(&solution));
    let Solution { scene, mechanism, pose, .. } = &solution;
    let structure = format::structure(mechanism, &solution.wording());
    let listed = Listed { poses: vec![pose.clone()], count: Count { number: 1, is_exact: true } };
    let assembly = format::listed_modes(scene, mechanism, &listed);
    lines.extend([structure, assembly].iter().flat_map(|text| text.lines().map(str::to_owned)));
    lines
}

/// What the curves of link rates say and what happens on the way, for scenes that can be moved.
fn said_of_curves(solution: &Solution) -> Vec<String> {
    let Ok(drive) = Drive::new(&solution.mechanism, None) else {
        return Vec::new();
    };
    let Ok(mut path) = Path::new(&solution.mechanism, &solution.pose, drive) else {
        return Vec::new();
    };
    let Ok(range) = path.cover(None, None) else {
        return Vec::new();
    };
    let links = solution.mechanism.links();
    let names = links.flat_map(|(_, body)| ["omega", "angle"].map(|q| format!("{q}({})", body.name)));
    let names: Vec<String> = names.take(6).collect();
    let Ok(sampled) = Curves::new(&path, range, Some(&names)) else {
        return Vec::new();
    };
    let mut lines = said(&curves(&solution.scene, &sampled, None).expect("it fits"));
    let words = solution.wording();
    lines.extend(path.happenings(range, &words).into_iter().chain(path.limits(None, &words)));
    lines
}

/// Words of the English sentences that no Spanish one has, and that are no accelerations of points either (`an`, `at`).
const ENGLISH: &str = "the of and or to on by in is are it its where from through with without towards under over lies lie meets \
    choose draw lay off mark measure solve pole scale scales scheme velocity velocities acceleration accelerations plan plans point points \
    special link links guide ray rays crossing crossings segment segments measured image images infinity parallel tangential sliding \
    relative reversed given known part parts both body sense turns uniformly construction loop equations equation agree differ \
    rates rate largest allow printed value values paper direction roughly honest hand drawings keep least greatest bound position angle \
    length drive limit change scene dead curves panels groups class mechanism two cross stops come alone figure so depends higher \
    extreme back further modes degrees freedom known contour";

/// Words of the Spanish sentences that English ones do not have.
const SPANISH: &str = "el la los las del de polo escala plano velocidad velocidades aceleraciones eslabón eslabones trazar medir marcar recta \
    posición cambio grados libertad montaje clase";

/// English words that German has, too.
const GERMAN_TOO: &str = "in so parallel pole relative tangential plan position";

/// The languages, each with words that none of its sentences has.
fn languages() -> [(&'static str, String); 4] {
    let german: Vec<&str> = GERMAN_TOO.split_whitespace().collect();
    let no_german = ENGLISH.split_whitespace().filter(|word| !german.contains(word)).collect::<Vec<_>>().join(" ");
    [("es", ENGLISH.to_owned()), ("en", SPANISH.to_owned()), ("de", no_german), ("pt", ENGLISH.to_owned())]
}

/// The words of a list that a line has, apart from names of quantities such as `angle(2)` and of lengths such as DE.
fn words_of<'a>(list: &'a str, line: &str) -> Vec<&'a str> {
    let is_length = |word: &str| word.len() == 2 && word.chars().all(|c| c.is_ascii_uppercase());
    let mut own: Vec<String> = Vec::new();
    let is_letter = |c: char| c.is_alphanumeric() || c == '_';
    let mut rest = line;
    while let Some(start) = rest.find(is_letter) {
        rest = &rest[start..];
        let end = rest.find(|c: char| !is_letter(c)).unwrap_or(rest.len());
        if !rest[end..].starts_with('(') && !is_length(&rest[..end]) {
            own.push(rest[..end].to_lowercase());
        }
        rest = &rest[end..];
    }
    list.split_whitespace().filter(|word| own.iter().any(|own| own == word)).collect()
}

#[test]
fn every_sentence_is_in_the_language_asked_for() {
    let mut sentences = 0;
    for (name, text) in scenes() {
        for (language, foreign) in &languages() {
            for line in all_said(&name, &with(&text, &[("language", *language)])) {
                // Names of links and points may be words.
                let names = ["rod", "arm", "C o D"];
                if names.contains(&line.as_str()) {
                    continue;
                }
                let found = words_of(foreign, &line);
                assert!(found.is_empty(), "{name} in {language}: {found:?} in {line:?}");
                sentences += usize::from(line.ends_with('.'));
            }
        }
    }
    assert!(sentences * ALIKE.now() > 1000, "only {sentences} sentences seen");
}

#[test]
fn every_mistake_is_told_in_the_language_asked_for() {
    for (language, foreign) in &languages() {
        let scene = with(&files::read("examples/figure-2.json"), &[("language", language)]);
        let scene = solved(&scene).expect("a good scene").scene;
        let words = Wording::of(&scene.figure);
        let other = Wording::of(&with_other(&scene, language));
        let mut told = 0;
        for mistake in Mistake::all() {
            for sentences in mistake.sentences() {
                let own = sentences.sentences(&words);
                for (said, other) in own.iter().zip(sentences.sentences(&other)) {
                    let found = words_of(foreign, said);
                    assert!(found.is_empty(), "{language}: {found:?} in {said:?}");
                    told += usize::from(*said != other);
                }
            }
        }
        // Some say no more than a number or a formula.
        assert!(told > 100, "only {told} differ");
    }
}

/// The figure in the other language.
fn with_other(scene: &Scene, language: &str) -> kinegon::scene::Figure {
    let mut figure = scene.figure.clone();
    figure.language = match language {
        "es" => LanguageName::English,
        _ => LanguageName::Spanish,
    };
    figure
}

#[test]
fn a_check_speaks_the_language_asked_for() {
    let [scene, form] = ["figure-2", "paper-as-student"].map(|name| {
        let path = files::path(&format!("examples/{name}.json"));
        path.to_str().expect("a plain path").to_owned()
    });
    for (language, foreign) in &languages() {
        let run = |more: &[&str]| {
            let mut command = kinegon();
            command.args(["check", &scene, &form, "--language", language, "--depth", "1"]);
            let output = command.args(more).output().expect("it runs");
            assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
            String::from_utf8(output.stdout).expect("text")
        };
        for line in run(&["--decimal", "comma"]).lines() {
            let found = words_of(foreign, line);
            assert!(found.is_empty(), "{language}: {found:?} in {line:?}");
            assert!(!has_decimals(line, '.'), "{line}");
        }
        let result: serde_json::Value = serde_json::from_str(&run(&["--json"])).expect("JSON");
        let mistakes = result["diagnosis"]["mistakes"].as_array().expect("a list");
        assert_eq!(mistakes.len(), 1);
        for mistake in mistakes {
            for key in ["done", "should_be"] {
                let said = mistake[key].as_str().expect("a text");
                let found = words_of(foreign, said);
                assert!(found.is_empty(), "{language}: {found:?} in {said:?}");
            }
        }
        let done = mistakes[0]["done"].as_str().expect("a text");
        assert_eq!(done.contains("se midió"), *language == "es", "{done}");
    }
}

/// A four-bar whose crank is too long to turn round, in this language with decimal commas.
fn rocking(language: &str) -> String {
    let text = files::read("templates/four-bar.json").replace(r#""AB": 60"#, r#""AB": 120"#);
    with(&text, &[("language", language), ("decimal", "comma")])
}

#[test]
fn structure_modes_and_limits_are_told_in_the_language_asked_for() {
    let run = |language: &str, arguments: &[&str]| {
        let output = program::with_scene(arguments, rocking(language).as_bytes());
        let told = [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("text"));
        (output.status.code(), told)
    };
    let limit = "posición límite en angle(1) = 125,869247732°: los eslabones 2, 3 no pueden ir más allá";
    for (arguments, heard) in [
        (&["structure", "-"][..], "\neslabones 2, 3: clase II, dos eslabones\n"),
        (&["modes", "-"], "2 modos de montaje; coordenadas en mm, ángulos en grados\n  1. C (56,065208; -36,021646)\n"),
        (&["sweep", "-", "--step", "90"], limit),
        (&["curves", "-", "-o", "-"], limit),
        (&["curves", "-", "-o", "-", "--path", "C"], limit),
    ] {
        let (code, [output, notes]) = run("es", arguments);
        assert_eq!(code, Some(0), "{notes}");
        assert!(output.contains(heard) || notes.contains(heard), "{arguments:?}: {notes}{output}");
        for line in notes.lines() {
            let line = line.strip_prefix("note: ").expect("notes alone");
            assert_eq!(words_of(ENGLISH, line), [""; 0], "{line}");
        }
    }
    // The option goes before the scene; errors are in English, as their hints are.
    let (_, [_, notes]) = run("es", &["curves", "-", "-o", "-", "--language", "en"]);
    assert!(notes.contains("note: limit position at angle(1) = 125,869247732°: links 2, 3 can go no"), "{notes}");
    let (code, [_, error]) = run("es", &["sweep", "-", "--step", "90", "--from", "0", "--to", "300"]);
    assert_eq!(code, Some(1));
    assert!(error.contains("limit position at angle(1) = 125.869247732°"), "{error}");
    // A table has the same bytes in every language.
    let table = |language: &str| run(language, &["sweep", "-", "--step", "90"]).1[0].clone();
    assert_eq!(table("es"), table("en"));
}

#[test]
fn the_workbench_tells_structure_and_limits_in_the_language_of_the_scene() {
    let mut engine = Engine::new();
    let parsed = |told: Result<String, String>| -> serde_json::Value {
        serde_json::from_str(&told.expect("an answer")).expect("JSON")
    };
    for (language, foreign, limit) in [("es", ENGLISH, "posición límite en"), ("en", SPANISH, "limit position at")] {
        let text = rocking(language);
        let structure = parsed(engine.open(&text))["structure"].as_str().expect("a text").to_owned();
        assert_eq!(structure.as_bytes(), program::with_scene(&["structure", "-"], text.as_bytes()).stdout);
        let events = parsed(engine.curves(&text, r#"{"curves":[]}"#, "null"))["events"].clone();
        let view = r#"{"step":null,"coarse":false,"modes":false}"#;
        parsed(engine.grab(&text, view, r#"{"kind":"drive","drive":"1"}"#));
        let notes = parsed(engine.drag(r#"{"value":300}"#))["notes"].clone();
        // A pull that puts two joints in one place is refused.
        let pins = r#"{"kind":"shape","point":"C","pins":{"points":[],"lengths":[]}}"#;
        let picture = parsed(engine.grab(&text, view, pins));
        let handles = picture["handles"].as_array().expect("a list");
        let fixed = handles.iter().find(|handle| handle["name"] == "D").expect("a joint");
        let refused = parsed(engine.drag(&serde_json::json!({ "to": fixed["at"] }).to_string()))["notes"].clone();
        let mut told = vec![structure];
        for notes in [&events, &notes, &refused] {
            let notes = notes.as_array().expect("a list");
            assert!(!notes.is_empty(), "{language}: nothing is told");
            told.extend(notes.iter().map(|note| note.as_str().expect("a text").to_owned()));
        }
        assert_eq!(told.iter().filter(|line| line.starts_with(limit)).count(), 3, "{told:?}");
        for line in told {
            assert_eq!(words_of(foreign, &line), [""; 0], "{language}: {line}");
        }
    }
}

/// Whether a line has a digit, the mark and a digit.
fn has_decimals(line: &str, mark: char) -> bool {
    let letters: Vec<char> = line.chars().collect();
    let digit = |c: char| c.is_ascii_digit();
    letters.windows(3).any(|w| digit(w[0]) && w[1] == mark && digit(w[2]))
}

#[test]
fn a_decimal_comma_stands_in_all_numbers() {
    let mut commas = 0;
    for (name, text) in scenes() {
        for line in all_said(&name, &with(&text, &[("decimal", "comma")])) {
            assert!(!has_decimals(&line, '.'), "{name}: {line}");
            commas += usize::from(has_decimals(&line, ','));
        }
        let point = all_said(&name, &with(&text, &[("decimal", "point")]));
        assert!(point.iter().any(|line| has_decimals(line, '.')), "{name}");
    }
    assert!(commas * ALIKE.now() > 1000, "only {commas} lines with commas");
}

#[test]
fn results_do_not_depend_on_the_wording() {
    for (name, text) in scenes() {
        let plain = with(&text, &[]);
        let result = |text: &str| {
            let solution = solved(text).unwrap_or_else(|error| panic!("{name}: {error}"));
            let plans = solution.construction.plans();
            let points: Vec<_> = plans.map(|plan| plan.points.clone()).collect();
            (format::json(&solution.result()), points, solution.warnings().collect::<Vec<String>>())
        };
        for notation in NotationName::ALL {
            let worded = with(&text, &[("notation", notation.as_str()), ("language", "es"), ("decimal", "comma")]);
            assert!(result(&worded) == result(&plain), "{name}");
        }
    }
}

/// What `kinegon steps` says of Figure 2 in a notation.
fn figure_2_in(notation: &str) -> String {
    let text = files::read("examples/figure-2.json");
    steps(&solved(&with(&text, &[("notation", notation)])).expect("a good scene"))
}

#[test]
fn notations_write_what_their_schools_write() {
    for (notation, has, has_not) in [
        (
            "paper",
            &["the pole p and", "the pole π and", "π b = ", "b k_b3 = ", "a^t_S3G", "a_c(3/2)"][..],
            &["′", "P_v", "τ"][..],
        ),
        (
            "english",
            &["the pole o and", "the pole o′ and", "o b = ", "o′ b′ = ", "b′ k_b3 = ", "o′ s′3 = ", "a^t_S3G"][..],
            &["π", "P_v"][..],
        ),
        ("russian", &["the pole p and", "the pole π and", "a^τ_S3G", "a_k(3/2)", "a^n_S3G"][..], &["a^t", "a_c"][..]),
        ("german", &["the pole P_v and", "the pole P_a and", "P_v b = ", "P_a s3 = ", "a^t_S3G"][..], &["π", "′"][..]),
    ] {
        let text = figure_2_in(notation);
        for word in has {
            assert!(text.contains(word), "{notation}: no {word} in\n{text}");
        }
        for word in has_not {
            assert!(!text.contains(word), "{notation}: {word} in\n{text}");
        }
        // Quantities keep their names.
        for name in ["omega(4) = ", "alpha(2) = ", "v_r(3/2) = ", "a_r(3/2) = "] {
            assert!(text.contains(name), "{notation}: no {name}");
        }
    }
}

/// Motions along guides by the points of both links, Coriolis by any index, the frame as a number: in equations, captions and figures;
/// quantities keep their names.
#[test]
fn motions_along_guides_and_the_frame_are_written_as_asked() {
    let whitworth = files::read("templates/whitworth.json");
    let said = |changes: &[(&str, &str)]| steps(&solved(&with(&whitworth, changes)).expect("a good scene"));
    let by_points = said(&[("sliding", "points"), ("coriolis", "C"), ("frame", "0")]);
    for words in [
        "v_B_3 = v_B − v_B_2B_3",
        "a^C_B_2B_3 = 2 ω_3 v_B_2B_3",
        "a_B_3 = a_B − a^C_B_2B_3 − a^r_B_2B_3",
        "for ω_4, v_F_5F_0.",
        "v_F_5F_0 = μ_v (p f)",
        "the guide of 5/0;",
        "sliding velocity of 5/0 along its guide, from F_0 to F",
        "v_r(5/ground) = 363.5287",
    ] {
        assert!(by_points.contains(words), "no {words} in\n{by_points}");
    }
    assert!(!by_points.contains("v_r(2/3) = μ") && !by_points.contains("a_c("), "{by_points}");
    let by_slider = said(&[("coriolis", "cor"), ("language", "es")]);
    for words in ["a_cor(2/3) = 2 ω_3 v_r(2/3)", "para ω_4, v_r(5/bastidor).", "desde F_bastidor hasta F"] {
        assert!(by_slider.contains(words), "no {words} in\n{by_slider}");
    }
    assert!(said(&[("sliding", "points"), ("notation", "russian")]).contains("a^k_B_2B_3 = 2 ω_3"));

    let label = |text: &str, id: &str, changes: &[(&str, &str)]| -> Vec<String> {
        let drawing = solved(&with(text, changes)).expect("a good scene").figure();
        let texts = drawing.marks.iter().filter_map(|mark| match &mark.shape {
            Shape::Text(text) if mark.id.as_deref() == Some(id) => Some(text.text.content()),
            _ => None,
        });
        texts.collect()
    };
    assert_eq!(label(&whitworth, "scheme-label-ground", &[("frame", "0")]), ["0"]);
    assert!(label(&whitworth, "scheme-label-ground", &[]).is_empty());
    let pushed = files::read("tests/driven_sliders/cylinder-on-slide.json");
    assert_eq!(label(&pushed, "scheme-label-speedu282u2f1u29", &[]), ["v2/1"]);
    assert_eq!(label(&pushed, "scheme-label-speedu282u2f1u29", &[("sliding", "points")]), ["vP2P1"]);
}

/// Turned velocities: the heading says so, vectors lie along their links and rays parallel to them; directions are those on the sheet.
/// Results and what a hand draws on do not change.
#[test]
fn a_velocity_plan_is_shown_turned() {
    let whitworth = files::read("templates/whitworth.json");
    let turned = |sense| solved(&with(&whitworth, &[("turned", sense)])).expect("a good scene");
    let plain = solved(&with(&whitworth, &[])).expect("a good scene");
    for (sense, has) in [
        ("counter-clockwise", ["turned by +90°", "in the direction from B to A", "direction -120.00°"]),
        ("clockwise", ["turned by −90°", "in the direction from A to B", "direction 60.00°"]),
    ] {
        let solution = turned(sense);
        let text = steps(&solution);
        let (velocities, accelerations) = text.split_once("Acceleration plan\n").expect("both plans");
        let both =
            ["through d parallel to DB_3", "through b normal to the guide of 2/3", "turned, normal to its guide"];
        for words in has.into_iter().chain(both) {
            assert!(velocities.contains(words), "{sense}: no {words} in\n{velocities}");
        }
        assert!(steps(&plain).ends_with(accelerations));
        let figure = solution.figure();
        let mut texts = figure.marks.iter().filter_map(|mark| match &mark.shape {
            Shape::Text(text) => Some(text.text.content()),
            _ => None,
        });
        // A sign in a run of its own loses the space before it.
        assert!(texts.any(|text| text.replace(' ', "").ends_with(&has[0].replace(' ', ""))), "{sense}");
        // The plan of turned velocities is the mechanism, link by link, in other sizes.
        let plan = solution.shown_construction().plan(Order::Velocity).expect("a plan");
        for [from, to] in [["A", "B"], ["D", "E"], ["E", "F"]] {
            let [a, b] = [from, to].map(|name| solution.pose.point(solution.mechanism.point(name).expect(name)));
            let image = plan.segment(&from.to_lowercase(), &to.to_lowercase()).expect("images");
            assert!((b - a).perp(&image).abs() < 1e-12 * (b - a).norm() * image.norm(), "{sense}: {from}{to}");
        }
        assert_eq!(format::json(&solution.result()), format::json(&plain.result()));
        let sheets =
            |solution: &Solution| -> Vec<String> { solution.drawing_sheets("w").iter().map(Drawing::svg).collect() };
        assert_eq!(sheets(&solution), sheets(&plain));
    }
}

#[test]
fn an_option_calls_the_frame_by_no_name_of_a_link() {
    let run = |frame: &str| {
        program::with_scene(&["steps", "-", "--frame", frame], files::read("templates/whitworth.json").as_bytes())
    };
    assert!(run("0").status.success());
    let output = run("1");
    assert!(!output.status.success());
    assert!(stderr(&output).contains("--frame: link 1 has this name"), "{}", stderr(&output));
}

#[test]
fn a_pole_shares_its_letter_with_nothing_that_moves() {
    // The fixed point O has its image at the pole; the moving point O of the other scene has not.
    let fixed = with(&files::read("templates/hydraulic-boom.json"), &[("notation", "english")]);
    let moving = files::read("templates/four-bar.json").replace("\"C\"", "\"O\"");
    let moving = moving.replace("\"BC\"", "\"BO\"").replace("\"CD\"", "\"OD\"");
    let moving = moving.replace("\"DC\"", "\"DO\"");
    let moving = with(&moving, &[("notation", "english")]);
    let labels = |text: &str, panel: &str| -> Vec<String> {
        let drawing = solved(text).expect("a good scene").figure();
        let prefix = format!("{panel}-label-");
        let of_plan = drawing.marks.iter().filter_map(|mark| match &mark.shape {
            Shape::Text(text) if mark.id.as_deref()?.starts_with(&prefix) => Some(text.text.content()),
            _ => None,
        });
        of_plan.flat_map(|label| label.split(", ").map(str::to_owned).collect::<Vec<_>>()).collect()
    };
    for panel in ["velocity", "acceleration"] {
        for text in [&fixed, &moving] {
            let mut shown = labels(text, panel);
            shown.sort();
            let count = shown.len();
            shown.dedup();
            assert!(count > 2 && shown.len() == count, "{panel}: {shown:?}");
        }
    }
}

#[test]
fn the_command_line_goes_before_the_scene() {
    let scene = with(&files::read("examples/figure-2.json"), &[("language", "es"), ("notation", "german")]);
    let run = |arguments: &[&str]| {
        let output = program::with_scene(arguments, scene.as_bytes());
        assert!(output.status.success(), "{}", stderr(&output));
        String::from_utf8(output.stdout).expect("text")
    };
    let own = run(&["steps", "-"]);
    assert!(own.contains("Elegir el polo P_v") && own.contains("39.68°"), "{own}");
    let other = ["steps", "-", "--language", "en", "--notation", "paper", "--decimal", "comma"];
    let other = run(&other);
    assert!(other.contains("Choose the pole p") && other.contains("39,68°"), "{other}");
    let drawn = run(&["draw", "-", "-o", "-", "--language", "en"]);
    assert!(drawn.contains("Velocity plan") && drawn.contains(">P</tspan>"), "{drawn}");
    let curves = run(&["curves", "-", "-o", "-", "--decimal", "comma"]);
    assert!(curves.contains("Velocidad angular") && curves.contains(">0,5<"), "{curves}");
    // Results have no words, and no options for them.
    assert_eq!(run(&["solve", "-"]), run(&["solve", "-"]));
    let refused = kinegon().args(["steps", "-", "--language", "fr"]).output();
    let refused = refused.expect("it runs");
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("[possible values: en, es, de, pt]"));
}
