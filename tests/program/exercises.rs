//! Exercises: every kind of mechanism gives some; they are the same for the same seed, and can be drawn by hand.

use kinegon::Sheet;
use kinegon::Solution;
use kinegon::check::{AnswerKey, Given, Marks, Measured, Student, Verdict, check};
use kinegon::construction::Action;
use kinegon::drawing::{Drawing, Pen, Rect, Shape};
use kinegon::exercise::{Exercise, ExerciseError, Exercises, Refusal};
use kinegon::geometry::{Point, Vector};
use kinegon::quantity::Quantity;
use kinegon::scene::{LanguageName, Page, PageSize};
use serde_json::Value;
use std::path::Path;
use std::sync::OnceLock;
use support::files;
use support::program::{self, kinegon, scratch, stderr};
use support::random::Random;
use support::stages::{answer_key, solved};
use support::survey::{ALIKE, KEYS, KINDS, Size};

/// All kinds of `kinegon new` with their scenes.
fn kinds() -> Vec<(String, String)> {
    let mut kinds = files::templates();
    for name in ["figure-1", "figure-2"] {
        kinds.push((name.into(), files::read(&format!("examples/{name}.json"))));
    }
    assert_eq!(kinds.len(), 31);
    kinds
}

fn exercises(text: &str, seed: u64) -> Exercises {
    let base = solved(text).expect("a good scene");
    Exercises::new(&base, None, seed).expect("it can vary")
}

fn exercise(text: &str, seed: u64) -> Exercise {
    exercises(text, seed).next().expect("one can be found")
}

/// One exercise of every kind, with different seeds, looked for once for all tests.
fn of_every_kind() -> &'static [(String, Exercise)] {
    static FOUND: OnceLock<Vec<(String, Exercise)>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let kinds = kinds().into_iter().zip((1..=12).cycle()).step_by(KINDS.now());
        kinds.map(|((kind, text), seed)| (kind, exercise(&text, seed))).collect()
    })
}

/// Everything that is asked of an exercise, seen anew.
#[test]
fn every_kind_gives_exercises_that_a_hand_draws_well() {
    for (kind, exercise) in of_every_kind() {
        let solution = solved(&exercise.text).unwrap_or_else(|e| panic!("{kind}: {e}"));
        numbers_are_round(kind, &exercise.text);
        lines_cross_well(kind, &solution);
        segments_are_long(kind, &solution);
        boxes_are_long(kind, exercise);
        special_points_are_on_the_sheet(kind, exercise);
        let conditions = solution.motion.conditions.iter().copied();
        assert!(conditions.fold(1.0, f64::max) <= 40.0, "{kind}");
        // The scales stand in the file, of the series 1, 2, 2.5, 5.
        let figure = &solution.scene.figure;
        for sheet in Sheet::USUAL {
            let digits = format!("{:e}", figure.mu[sheet].unwrap_or_else(|| panic!("{kind}: no scale")));
            let digits = digits.split('e').next().unwrap_or_default();
            assert!(["1", "2", "2.5", "5"].contains(&digits), "{kind}: {digits}");
        }
        keys_hold(kind, exercise);
    }
}

/// Lengths and places have few digits and no odd ones, drives stand at multiples of 5°.
fn numbers_are_round(kind: &str, text: &str) {
    let scene: Value = serde_json::from_str(text).expect("JSON");
    let links = scene["links"].as_object().expect("links");
    for link in links.values() {
        for (key, length) in link["lengths"].as_object().into_iter().flatten() {
            let Some(length) = length.as_f64() else {
                continue;
            };
            let written = format!("{length:e}");
            let digits = written.split('e').next().unwrap_or_default().replace('.', "");
            // Distances between wheels follow from their teeth.
            let most = if scene["gears"].is_null() { 3 } else { 4 };
            assert!(digits.len() <= most, "{kind}: {key} {length}");
        }
        for angle in [&link["drive"]["angle"], &link["angle"]] {
            let angle = angle.as_f64().unwrap_or(0.0);
            assert_eq!(angle % 5.0, 0.0, "{kind}");
        }
    }
}

/// Where a step marks a crossing, the last two lines drawn towards it meet at 20° or more.
fn lines_cross_well(kind: &str, solution: &Solution) {
    let mut crossings = 0;
    for plan in solution.construction.plans() {
        let mut rays: Vec<(&str, Vector)> = Vec::new();
        for action in &solution.construction.steps[plan.sheet()] {
            match action {
                Action::Ray(ray) => rays.push((&ray.to, ray.direction)),
                Action::Cross { point, .. } => {
                    let own: Vec<Vector> =
                        rays.iter().filter(|(to, _)| to == point).map(|(_, direction)| *direction).collect();
                    let [.., a, b] = own.as_slice() else {
                        panic!("{kind}: {point} has no two lines");
                    };
                    let sine = a.perp(b).abs() / (a.norm() * b.norm());
                    assert!(sine >= libm::sin(20_f64.to_radians()), "{kind}: {sine}");
                    crossings += 1;
                }
                _ => {}
            }
        }
    }
    // Wheels turn by measured segments.
    assert!(crossings > 0 || !solution.scene.gears.is_empty(), "{kind}");
    // Cut lines, by their joints and directions.
    for special in solution.construction.special.iter() {
        let [a, b] = special.cuts.each_ref().map(|cut| cut.line.direction());
        if let (true, Some(a), Some(b)) = (special.is_assur, a, b) {
            assert!(a.perp(&b).abs() >= 0.34, "{kind}: {}", special.name);
        }
    }
}

fn segments_are_long(kind: &str, solution: &Solution) {
    let figure = &solution.scene.figure;
    for plan in solution.construction.plans() {
        let mu = figure.mu[plan.sheet()];
        for action in &solution.construction.steps[plan.sheet()] {
            if let Action::Measure { from, to, .. } = action {
                let way = plan.points[to].vector - plan.points[from].vector;
                let mm = way.norm() / mu.expect("a scale");
                assert!(!(1e-6..5.0).contains(&mm), "{kind}: {from} {to} {mm} mm");
            }
        }
    }
}

/// Whatever has a box in millimetres is as long as the guide promises.
fn boxes_are_long(kind: &str, exercise: &Exercise) {
    let heads = [("L(", Sheet::Scheme), ("vplan(", Sheet::Velocity), ("aplan(", Sheet::Acceleration)];
    for (name, value) in &exercise.key().values {
        let Some((_, sheet)) = heads.iter().find(|(head, _)| name.starts_with(head)) else { continue };
        let mm = value.value.abs() / exercise.scales[*sheet].expect("a scale");
        assert!(!(1e-6..4.0).contains(&mm), "{kind}: {name} {mm} mm");
    }
}

/// Normal parts, too: those of these kinds are often small.
#[test]
fn boxes_in_millimetres_are_long() {
    for (kind, count) in [("four-bar", 6), ("third-class", 2), ("watt-1", 2)].into_iter().step_by(ALIKE.now()) {
        let mut exercises = exercises(&files::read(&format!("templates/{kind}.json")), 5);
        for _ in 0..count {
            boxes_are_long(kind, &exercises.next().expect("one can be found"));
        }
    }
}

/// Joints on the student's sheet lie as in the scheme at its scale; special points, which are not drawn, have room in the same panel.
fn special_points_are_on_the_sheet(kind: &str, exercise: &Exercise) {
    let marks = &exercise.sheet.marks;
    let circles = marks.iter().filter_map(|mark| match (&mark.id, &mark.shape) {
        (Some(id), Shape::Circle { center, .. }) => {
            let name = id.strip_prefix("scheme-point-")?;
            let point = exercise.solution.mechanism.point(name)?;
            Some((exercise.solution.pose.point(point), *center))
        }
        _ => None,
    });
    let circles: Vec<(Point, kinegon::drawing::Point)> = circles.collect();
    let mu = exercise.scales[Sheet::Scheme].expect("a scale");
    let (origin, centre) = circles[0];
    let on_sheet = |place: Point| {
        let way = (place - origin) / mu;
        kinegon::drawing::Point::new(centre.x + way.x, centre.y - way.y)
    };
    for (place, centre) in &circles {
        assert!((on_sheet(*place) - *centre).hypot() < 1e-6, "{kind}");
    }
    let (_, frame) = &exercise.sheet.panels[0];
    for special in exercise.solution.construction.special.iter() {
        let place = special.place.finite().expect("not at infinity");
        assert!(frame.contains(on_sheet(place)), "{kind}: {}", special.name);
        let drawn = format!("scheme-point-{}", special.name);
        let is_joint = exercise.solution.mechanism.point(&special.name).is_some();
        let mut shown = marks.iter().filter(|m| m.id.as_deref() == Some(&drawn));
        assert!(is_joint || shown.next().is_none(), "{kind} gives it away");
    }
}

/// The key's values are right, a careful hand's pass, the empty form is empty.
fn keys_hold(kind: &str, exercise: &Exercise) {
    let answers = AnswerKey { scales: exercise.scales, ..answer_key(&exercise.solution, 0) };
    let key = exercise.key();
    assert!(key.values.len() >= 6, "{kind}");
    let values = key.values.iter().map(|(name, value)| Given {
        name: name.clone(),
        // With so many digits that half a unit of the last one is nothing beside the bands.
        text: format!("{:+.15}", value.value),
        unit: Some(value.unit.clone()),
        place: name.clone().into(),
    });
    let measured = Measured { values: values.collect(), ..Measured::default() };
    let checked = check(&measured, &answers).unwrap_or_else(|e| panic!("{kind}: {e}"));
    assert_eq!(checked.values.len(), key.values.len(), "{kind}");
    for value in &checked.values {
        let name = value.entry.asked.name();
        let own = &key.values[name];
        assert_eq!(value.entry.step, own.step, "{kind}: {name}");
        let near = value.difference.abs() <= 1e-12 * value.entry.expected.abs();
        assert!(value.verdict == Verdict::Right || near, "{kind}: {name} {value:?}");
        let allowed = own.allowed.map(|own| (own, value.tolerance));
        let (allowed, judged) = allowed.unwrap_or((0.0, 0.0));
        // A rate of a wheel that follows from given ones alone allows nothing; half a unit of the last digit is left.
        let digits = 1e-12 * value.entry.expected.abs();
        assert!((allowed - judged).abs() <= 1e-6 * judged + digits, "{kind}: {name}: {allowed:e}, {judged:e}");
    }
    let student = Student::new(&answers).unwrap_or_else(|e| panic!("{kind}: {e}"));
    let mut random = Random(5);
    let careful = student.draw(&[], [0.2, 0.2], &mut || random.within(1.0), &[]);
    let checked = check(&careful, &answers).expect("understood");
    let off = checked.values.iter().filter(|v| v.verdict == Verdict::Off);
    let off: Vec<&str> = off.map(|v| v.entry.asked.name()).collect();
    assert!(off.is_empty(), "{kind}: {off:?}");
    let empty = Measured::read_json(&exercise.form("one-1-1").json(&exercise.solution)).expect("a form");
    assert_eq!(empty.exercise, Some("one-1-1".into()), "{kind}");
    let error = check(&empty, &answers).expect_err("nothing is filled in");
    assert!(error.message.to_string().contains("empty"), "{kind}: {error}");
    let empty = Measured::read_csv(&exercise.form("one-1-1").csv(&exercise.solution)).expect("a form");
    assert_eq!(empty.exercise, Some("one-1-1".into()), "{kind}");
    assert!(check(&empty, &answers).is_err(), "{kind}");
    let boxes = exercise.sheet.marks.iter().filter_map(|m| m.id.as_deref());
    let boxes = boxes.filter(|id| id.starts_with("box-") && id.ends_with("-value"));
    assert_eq!(boxes.count(), key.values.len(), "{kind}");
}

/// Keys show their plans whole: nothing is cut at a panel's edge, and the poles are there.
#[test]
fn no_key_cuts_a_plan() {
    let mut keys: Vec<(String, Drawing)> =
        of_every_kind().iter().map(|(kind, found)| (kind.clone(), found.key_sheet())).collect();
    for (kind, text) in kinds() {
        keys.extend((2..=KEYS.now()).map(|seed| (format!("{kind} {seed}"), exercise(&text, seed).key_sheet())));
    }
    let mut wrong = Vec::new();
    for (name, key) in &keys {
        let cut = key.marks.iter().filter_map(|mark| mark.id.as_deref()).filter(|id| id.ends_with("-cut"));
        wrong.extend(cut.map(|id| format!("{name}: {id}")));
        for pole in ["velocity-point-p", "acceleration-point-pi"] {
            let at = key.marks.iter().find(|mark| mark.id.as_deref() == Some(pole));
            let at = at.map(|mark| mark.shape.bounds().center());
            let is_there = at.is_some_and(|at| key.panels.iter().any(|(_, frame)| frame.inset(-1.0).contains(at)));
            if !is_there {
                wrong.push(format!("{name}: no {pole}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{} in {} keys\n{}", wrong.len(), keys.len(), wrong.join("\n"));
}

/// What a sheet says.
fn said(sheet: &Drawing) -> String {
    let texts = sheet.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some(text.text.content()),
        _ => None,
    });
    texts.collect::<Vec<_>>().join(" ").replace('\u{a0}', " ")
}

/// Words outside the scheme that leave the sheet or lie on each other.
fn words_in_the_way(sheet: &Drawing) -> Vec<String> {
    let paper = Rect::new(0.0, 0.0, sheet.width, sheet.height);
    let words = sheet.marks.iter().filter(|mark| matches!(mark.pen, Pen::Caption | Pen::Heading));
    let words: Vec<(String, Rect)> = words
        .filter_map(|mark| match &mark.shape {
            Shape::Text(text) => Some((text.text.content(), mark.shape.bounds())),
            _ => None,
        })
        .collect();
    assert!(words.len() > 10, "{words:?}");
    let mut wrong = Vec::new();
    for (index, (text, ink)) in words.iter().enumerate() {
        if paper.union(*ink) != paper {
            wrong.push(format!("{text} leaves the sheet"));
        }
        let other = words[..index].iter().find(|(_, other)| ink.intersect(*other).area() > 0.0);
        wrong.extend(other.map(|(other, _)| format!("{text} lies on {other}")));
    }
    wrong
}

/// A sheet says what a student needs besides the numbers; nothing on it lies on anything else, in either language.
#[test]
fn sheets_say_what_is_positive_and_what_paper_is_needed() {
    let text = files::read("templates/slotted-lever.json");
    let lever = exercise(&text, 7);
    let sheet = said(&lever.sheet);
    for part in [
        "Name:",
        "Date:",
        "counter-clockwise is +",
        "along the arrow marked +",
        "guide of 2 along DC",
        "draw each on A",
    ] {
        assert!(sheet.contains(part), "no {part} in {sheet}");
    }
    assert!(sheet.contains("end of a normal part") && sheet.contains("end of a Coriolis part"), "{sheet}");
    // The arrow has the guide's direction: from D to C.
    let arrow = lever.sheet.marks.iter().find(|mark| mark.id.as_deref().is_some_and(|id| id.contains("-sense-")));
    let Some(Shape::Arrow { from, to, .. }) = arrow.map(|mark| &mark.shape) else { panic!("{arrow:?}") };
    let [c, d] = ["C", "D"].map(|name| {
        let point = lever.solution.mechanism.point(name).expect("it is there");
        lever.solution.pose.point(point)
    });
    let (along, way) = ((c - d).normalize(), *to - *from);
    assert!((along.x * way.x - along.y * way.y) / way.hypot() > 1.0 - 1e-9, "{way:?}");
    let slider = exercise(&files::read("templates/slider-crank.json"), 7);
    assert!(said(&slider.sheet).contains("guide of 3 through"), "{}", said(&slider.sheet));
    let mut sheets: Vec<(String, Drawing)> =
        of_every_kind().iter().map(|(kind, found)| (kind.clone(), found.sheet.clone())).collect();
    for (kind, text) in kinds().into_iter().step_by(KINDS.now()) {
        let mut base = solved(&text).expect("a good scene");
        base.scene.figure.language = LanguageName::Spanish;
        let exercises = Exercises::new(&base, None, 3);
        sheets.push((format!("{kind} in Spanish"), exercises.expect("varies").next().expect("found").sheet));
    }
    let wrong = |(name, sheet): &(String, Drawing)| {
        words_in_the_way(sheet).into_iter().map(|fault| format!("{name}: {fault}")).collect::<Vec<_>>()
    };
    let wrong: Vec<String> = sheets.iter().flat_map(wrong).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A key has a row for every quantity of the form, with its value, and the paper that a sheet names holds the plans.
#[test]
fn keys_have_all_quantities() {
    for (kind, found) in of_every_kind() {
        let (key, sheet) = (found.key(), found.key_sheet());
        let rows = sheet.marks.iter().filter_map(|mark| mark.id.as_deref());
        let rows = rows.filter(|id| id.starts_with("key-") && id.ends_with("-value")).count();
        assert_eq!(rows, key.values.len(), "{kind}");
        // Segments are asked for once: no two rows name one segment of a plan.
        let segments = key.values.keys().filter_map(|name| {
            let (plan, ends) = name.strip_suffix(')')?.split_once("plan(")?;
            let (from, to) = ends.split_once(',')?;
            Some((plan, from.min(to), from.max(to)))
        });
        let segments: Vec<_> = segments.collect();
        for (index, segment) in segments.iter().enumerate() {
            assert!(!segments[..index].contains(segment), "{kind}: {segments:?}");
        }
        assert!(segments.len() >= 2, "{kind}: {segments:?}");
    }
}

/// Forms of an older kind ask for the rates of a block and of its lever, and marks may be given for both.
#[test]
fn rows_that_are_no_longer_asked_for_still_count() {
    let text = files::read("templates/slotted-lever.json");
    let lever = solved(&text).expect("a good scene");
    let answers = answer_key(&lever, 1);
    let omega = match lever.quantity("omega(3)") {
        Ok(Quantity::Number(omega)) => omega,
        other => panic!("{other:?}"),
    };
    let given = |name: &str| Given { name: name.into(), text: format!("{omega:+.4}"), unit: None, place: name.into() };
    let award = |marks: &str, names: &[&str]| {
        let scheme = Marks::read(marks).expect("a scheme").of(&answers).expect("of this scene");
        let measured = Measured { values: names.iter().map(|name| given(name)).collect(), ..Measured::default() };
        let checked = check(&measured, &answers).expect("understood");
        assert!(checked.is_nothing_off());
        scheme.award(&checked).earned
    };
    for both in [r#""omega(2)": 1, "omega(3)": 2"#, r#""omega(3)": 2, "omega(2)": 1"#] {
        let marks = format!(r#"{{ "kinegon_marks": 1, "values": {{ {both} }} }}"#);
        assert_eq!(award(&marks, &["omega(2)", "omega(3)"]), 3.0);
        assert_eq!(award(&marks, &["omega(3)"]), 3.0);
    }
    let pole = r#"{ "kinegon_marks": 1, "values": { "aplan(pi,b)": 1, "omega(3)": 1 } }"#;
    assert_eq!(award(pole, &["omega(3)"]), 1.0);
    let each = r#"{ "kinegon_marks": 1, "each": 1 }"#;
    assert_eq!(award(each, &["omega(2)"]), 1.0);
    assert_eq!(award(each, &["omega(3)"]), 1.0);
    assert_eq!(award(each, &["omega(2)", "omega(3)"]), 1.0);
}

/// Where a starting scene has a block on the line between two points of its guide, so have the exercises.
#[test]
fn blocks_stay_on_their_guides() {
    for (kind, block, line) in
        [("dyad-rpr", "B", ["D", "C"]), ("dyad-prp", "C", ["A", "B"]), ("dyad-rpp", "B", ["C", "D"])]
    {
        let text = files::read(&format!("templates/{kind}.json"));
        for seed in 0..5 {
            let found = exercise(&text, seed);
            let place = |name: &str| Point::from(found.solution.scene.coordinates[name]);
            let [from, to] = line.map(place);
            let off = (to - from).normalize().perp(&(place(block) - from));
            assert!(off.abs() < 1e-9, "{kind}: {off}");
        }
    }
}

#[test]
fn a_seed_gives_the_same_exercises_and_others_give_others() {
    for (kind, text) in kinds() {
        let some = ["four-bar", "slotted-lever", "dyad-rpr", "fourth-class"];
        if !some.into_iter().step_by(ALIKE.now()).any(|some| some == kind) {
            continue;
        }
        let texts = |seed: u64, count: usize| {
            let mut exercises = exercises(&text, seed);
            let next = (0..count).map(|_| exercises.next().expect("found").text);
            next.collect::<Vec<String>>()
        };
        let (three, one, other) = (texts(3, 3), texts(3, 1), texts(4, 1));
        assert_eq!(three[0], one[0], "{kind}");
        assert_eq!(three, texts(3, 3), "{kind}");
        let untitled = |text: &str| {
            let mut scene: Value = serde_json::from_str(text).expect("JSON");
            scene["title"].take();
            scene
        };
        let all: Vec<Value> = three.iter().chain(&other).map(|t| untitled(t)).collect();
        for (index, scene) in all.iter().enumerate() {
            assert!(!all[..index].contains(scene), "{kind}: twice the same");
        }
        assert!(three[1].contains("(3-2)"), "{kind}");
    }
}

#[test]
fn what_cannot_be_drawn_is_given_up_with_the_reason() {
    if Size::is_usual("a thousand variants, none of which can be drawn") {
        let text = files::read("templates/four-bar.json");
        let mut base = solved(&text).expect("a good scene");
        // A plan of some hundredths of a millimetre.
        base.scene.figure.mu[Sheet::Velocity] = Some(1e5);
        let mut small = Exercises::new(&base, Some(Page::default()), 1).expect("varies");
        let error = small.next().expect_err("too small");
        assert!(matches!(error, ExerciseError::GaveUp { most: Refusal::Short, percent: 50.., .. }), "{error}");
        assert!(error.to_string().contains("shorter than 5 mm"), "{error}");
    }
    // BC and ED parallel: the special point of link 3 lies at infinity.
    let parallel = files::read("examples/figure-1.json")
        .replace("\"C\": [70, 150]", "\"C\": [0, 150]")
        .replace("\"D\": [190, 240]", "\"D\": [300, 240]");
    let base = solved(&parallel).expect("a good scene");
    let none = Exercises::new(&base, None, 1);
    let error = none.expect_err("no construction");
    assert!(error.to_string().contains("at infinity"), "{error}");
}

fn run(arguments: &[&str], folder: &Path) -> std::process::Output {
    let mut command = kinegon();
    command.arg("exercise").args(arguments).arg("-o").arg(folder);
    command.output().expect("the program starts")
}

fn json(path: &Path) -> Value {
    let text = std::fs::read_to_string(path).expect("it is there");
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn files_hold_together() {
    let folder = scratch("exercises");
    for (kind, style) in [("slotted-lever", "print"), ("third-class", "lecture")] {
        let arguments = [kind, "--seed", "21", "--count", "2", "--style", style];
        let output = run(&arguments, &folder);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let own = folder.join(format!("{kind}-21-2"));
        let mut names: Vec<String> = std::fs::read_dir(&own)
            .expect("a folder")
            .map(|e| e.expect("listed").file_name().into_string().expect("plain"))
            .collect();
        // As many sheets for the plans as they need.
        assert!(names.contains(&"sheet-2.svg".to_owned()));
        names.retain(|name| !name.starts_with("sheet-"));
        names.sort();
        let mut expected = vec![
            "form.csv",
            "form.json",
            "key-drawing.json",
            "key.json",
            "key.pdf",
            "key.svg",
            "scene.json",
            "sheet.pdf",
            "sheet.svg",
        ];
        if !cfg!(feature = "pdf") {
            expected.retain(|name| !name.ends_with("pdf"));
        }
        assert_eq!(names, expected);
        // What the program itself says of the scene.
        let key = json(&own.join("key.json"));
        let values = key["values"].as_object().expect("values");
        let mut scene = json(&own.join("scene.json"));
        assert_eq!(scene["figure"]["style"], style);
        scene["want"] = values.keys().cloned().collect::<Vec<String>>().into();
        let solved = program::with_scene(&["solve", "-"], scene.to_string().as_bytes());
        assert_eq!(solved.status.code(), Some(0), "{}", stderr(&solved));
        let solved: Value = serde_json::from_slice(&solved.stdout).expect("JSON");
        for (name, value) in values {
            let exact = match &solved["quantities"][name] {
                Value::Array(v) => {
                    let [x, y] = [0, 1].map(|k| v[k].as_f64().expect("a number"));
                    libm::hypot(x, y)
                }
                number => number.as_f64().unwrap_or_else(|| panic!("{name}")),
            };
            let own = value["value"].as_f64().expect("a number");
            assert!((own - exact).abs() <= 1e-9 * exact.abs().max(1e-6), "{name}");
        }
        // Filled in with the key's values the form passes; empty it is refused.
        let scene = own.join("scene.json");
        let scene = scene.to_str().expect("UTF-8");
        let check = |form: &Path| {
            let output = kinegon().args(["check", scene]).arg(form).output();
            output.expect("the program starts")
        };
        let empty = check(&own.join("form.json"));
        assert_eq!(empty.status.code(), Some(2));
        assert!(stderr(&empty).contains("empty"), "{}", stderr(&empty));
        let mut form = json(&own.join("form.json"));
        assert_eq!(form["exercise"], format!("{kind}-21-2"));
        for (name, value) in values {
            let value = value["value"].as_f64().expect("a number");
            form["values"][name] = format!("{value:+}").into();
        }
        let filled = own.join("filled.json");
        std::fs::write(&filled, form.to_string()).expect("written");
        assert_eq!(check(&filled).status.code(), Some(0));
    }
}

#[test]
fn the_same_bytes_again_and_nothing_is_written_over() {
    let (first, second) = (scratch("exercises-first"), scratch("exercises-second"));
    let arguments = ["four-bar", "--seed", "2", "--language", "es", "--decimal", "comma", "--page", "a4"];
    for folder in [&first, &second] {
        let output = run(&arguments, folder);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    }
    let read = |folder: &Path, name: &str| std::fs::read(folder.join("four-bar-2-1").join(name)).expect("written");
    for name in ["scene.json", "sheet.svg", "key.svg", "key.json", "form.csv"] {
        assert!(read(&first, name) == read(&second, name), "{name}");
    }
    let sheet = String::from_utf8(read(&first, "sheet.svg")).expect("text");
    assert!(sheet.contains("width=\"297mm\"") && sheet.contains("Datos"));
    let key = String::from_utf8(read(&first, "key.svg")).expect("text");
    assert!(key.contains("width=\"420mm\"") && key.contains("Plano de velocidades"));
    let scene = json(&first.join("four-bar-2-1/scene.json"));
    assert_eq!(scene["figure"]["language"], "es");
    assert_eq!(scene["figure"]["decimal"], "comma");
    let before = read(&first, "scene.json");
    let again = run(&arguments, &first);
    assert_eq!(again.status.code(), Some(2));
    assert!(stderr(&again).contains("is not overwritten"), "{}", stderr(&again));
    assert!(before == read(&first, "scene.json"));
    // A scene of one's own, by its path.
    let own = run(&["templates/five-bar.json", "--seed", "2"], &first);
    assert_eq!(own.status.code(), Some(0), "{}", stderr(&own));
    assert!(first.join("five-bar-2-1/key.json").is_file());
    for (arguments, part) in [
        (["for-bar", "--seed", "1"], "nearest kind is `four-bar`"),
        (["tests/files", "--seed", "1"], "no file"),
        (["four-bar", "--seed", "-1"], "invalid value"),
        (["templates/workbench.html", "--seed", "1"], "workbench.html"),
    ] {
        let output = run(&arguments, &second);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&output).contains(part), "{}", stderr(&output));
    }
}

/// Sheets are of the size that is asked for; without it as large as need be.
#[test]
fn sheets_are_large_enough() {
    for (kind, width) in [("four-bar", 297.0), ("fourth-class", 420.0)] {
        let text = files::read(&format!("templates/{kind}.json"));
        assert_eq!(exercise(&text, 1).sheet.width, width, "{kind}");
    }
    let text = files::read("templates/four-bar.json");
    let base = solved(&text).expect("a good scene");
    let page = Page { size: PageSize::A3, landscape: false };
    let exercises = Exercises::new(&base, Some(page), 1);
    let exercise = exercises.expect("varies").next().expect("found");
    assert_eq!([exercise.sheet.width, exercise.sheet.height], [297.0, 420.0]);
}

/// A drive given in turns per minute is told so, and no number has more digits than a person writes.
#[test]
fn given_numbers_are_told_as_a_person_writes_them() {
    let text = files::read("tests/lecture/shaper.json");
    let exercise = exercise(&text, 1);
    let scene: Value = serde_json::from_str(&exercise.text).expect("JSON");
    let rpm = scene["links"]["1"]["drive"]["rpm"].as_f64().expect("still in turns per minute");
    let texts = exercise.sheet.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some(text.text.content()),
        _ => None,
    });
    let said: String = texts.collect::<Vec<_>>().join(" ");
    assert!(said.contains(&format!("{rpm}\u{a0}rpm")) || said.contains(&format!("{rpm} rpm")), "{said}");
    let long = said.split(|c: char| !c.is_ascii_digit() && c != '.').find(|number| number.len() > 8);
    assert_eq!(long, None, "{said}");
}

/// A link by coordinates is given by what a ruler and a protractor set: distances, and the angle of a line that stands on the sheet. The crank's
/// points are 36 and 48 mm apart, at 10° + 53.1301°; P is 60 and 80 mm from B, and 80 and 80 mm from C.
#[test]
fn links_by_coordinates_are_given_by_distances_and_the_angle_of_a_line() {
    let own = solved(
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [160, 0] },
            "links": { "1": { "shape": { "A": [0, 0], "B": [36, 48] }, "drive": { "angle": 10, "omega": 10 } },
                "2": { "shape": { "B": 0, "C": 140, "P": [60, 80] } }, "3": { "points": ["D", "C"], "lengths": { "CD": 110 } } },
            "near": { "C": [150, 110] } }"#,
    );
    let sheet = said(&own.expect("it moves").drawing_sheets("1")[0]);
    for part in ["AB = 60 mm", "BC = 140 mm", "BP = 100 mm", "CP = 113.137 mm", "CD = 110 mm", "63.1301°"] {
        assert!(sheet.replace('\u{a0}', " ").contains(part), "no {part} in {sheet}");
    }
    assert!(!sheet.contains("= 10°") && !sheet.contains("=\u{a0}10°"), "{sheet}");
}
