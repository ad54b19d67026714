//! Sheets step by step: everything keeps its place, each step shows and says something of its own, words keep to their box.

use kinegon::Solution;
use kinegon::construction::Action;
use kinegon::drawing::{Drawing, Emphasis, Mark, Pen, Rect, Shape};
use kinegon::format::{Text, layered_svg};
use std::collections::BTreeSet;
#[cfg(feature = "cli")]
use support::files::{self, read};
use support::stages::solved;

/// By how much a slanted letter may lean over the next word, in mm.
const LEAN: f64 = 0.3;

/// The steps of a scene and all of them drawn.
fn drawn(text: &str) -> (Solution, Drawing) {
    let solution = solved(text).expect("a good scene");
    let all = solution.stepwise_figure();
    (solution, all)
}

fn scenes() -> Vec<(String, String)> {
    let mut all = files::scenes("templates");
    for name in ["figure-1", "figure-2"] {
        let text = read(&format!("examples/{name}.json"));
        // Sentences are longer in Spanish.
        let mut spanish: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        spanish["figure"]["language"] = "es".into();
        all.push((format!("{name} in Spanish"), spanish.to_string()));
        all.push((name.to_owned(), text));
    }
    all
}

/// The same mark whatever its emphasis.
fn plain(mark: &Mark) -> Mark {
    Mark { emphasis: Emphasis::Plain, ..mark.clone() }
}

#[test]
fn sheets_grow_and_nothing_moves() {
    for (name, text) in scenes() {
        let (solution, all) = drawn(&text);
        let count = all.steps.len();
        let construction = &solution.construction;
        assert_eq!(count, construction.step_count(), "{name}");
        let mut before: Vec<Mark> = Vec::new();
        for step in 1..=count {
            let sheet = all.after_step(step);
            let lasting: Vec<Mark> = sheet.marks.iter().filter(|m| !m.passing).map(plain).collect();
            // A name to which another is added is replaced.
            let replaced = |mark: &Mark| mark.until.is_some_and(|until| usize::from(until) <= step);
            let stays = before.iter().all(|mark| lasting.contains(mark) || replaced(mark));
            assert!(stays, "{name}, step {step} drops something");
            let is_new = |mark: &Mark| usize::from(mark.since) == step;
            for mark in &sheet.marks {
                let want = match (mark.since, is_new(mark)) {
                    (0, _) => Emphasis::Plain,
                    (_, true) => Emphasis::New,
                    (_, false) => Emphasis::Earlier,
                };
                assert_eq!(mark.emphasis, want, "{name}, step {step}");
            }
            before = lasting;
        }
        let lasting = all.marks.iter().filter(|m| !m.passing && m.until.is_none()).count();
        assert_eq!(before.len(), lasting, "{name}: the last sheet is not complete");
    }
}

#[test]
fn each_step_draws_what_it_does() {
    let mut seen = BTreeSet::new();
    for (name, text) in scenes() {
        let (solution, all) = drawn(&text);
        let construction = &solution.construction;
        for step in construction.numbered_steps() {
            let number = step.number;
            let new: Vec<&Mark> = all.marks.iter().filter(|m| usize::from(m.since) == number).collect();
            let has = |wanted: &dyn Fn(&Mark) -> bool| new.iter().any(|mark| wanted(mark));
            let named = |id: &str| {
                let ends = |mark: &Mark| mark.id.as_deref().is_some_and(|own| own.ends_with(id));
                has(&ends)
            };
            let (kind, good) = match step.action {
                Action::Pole { .. } => ("pole", named("point-p") || named("point-pi") || has(&|m| m.pen == Pen::Pole)),
                Action::SpecialPoint { point, .. } => {
                    ("special point", named(&format!("point-{point}")) && named(&format!("label-{point}")))
                }
                Action::Ray(ray) => ("ray", named(&format!("ray-{}-{}", ray.through, ray.to))),
                Action::Measure { .. } => ("measuring", has(&|m| m.pen == Pen::Hint)),
                Action::Cross { .. } => ("crossing", has(&|m| matches!(m.shape, Shape::Arrow { .. }) && !m.passing)),
                _ => continue,
            };
            seen.insert(kind);
            // Names with primes and the like are spelt otherwise in ids; a vector that is nothing has no arrow, a length no line.
            let spelt = |s: &str| s.is_ascii() && !s.contains(|c: char| "'π()/".contains(c));
            let whole = match step.action {
                Action::Ray(ray) => spelt(&ray.through) && spelt(&ray.to),
                Action::Measure { value, .. } => *value > 1.0,
                Action::Cross { point, .. } => {
                    construction.plans().all(|plan| plan.points.get(point).is_none_or(|p| p.vector.norm() > 1e-6))
                }
                Action::SpecialPoint { point, .. } => spelt(point),
                _ => true,
            };
            assert!(good || !whole, "{name}, step {number} ({kind}): {:?}", step.action);
        }
    }
    assert_eq!(seen.len(), 5, "{seen:?}");
}

#[test]
fn words_keep_to_their_box() {
    for (name, text) in scenes() {
        let (_, all) = drawn(&text);
        for step in 1..=all.steps.len() {
            let sheet = all.after_step(step);
            let texts: Vec<Rect> = sheet
                .marks
                .iter()
                .filter(|mark| mark.passing && matches!(mark.shape, Shape::Text(_)))
                .map(|mark| mark.shape.bounds())
                .collect();
            assert!(!texts.is_empty(), "{name}: step {step} says nothing");
            let page = Rect::new(8.0, 8.0, sheet.width - 8.0, sheet.height - 8.0);
            let least = texts.iter().map(|t| t.height()).fold(0.0, f64::max);
            assert!(least > 2.0, "{name}: the words of step {step} are {least} mm high");
            for (index, one) in texts.iter().enumerate() {
                assert!(page.union(*one) == page, "{name}: words of step {step} leave the sheet at {one:?}");
                for other in &texts[..index] {
                    let both = one.intersect(*other);
                    assert!(
                        both.width() <= LEAN || both.height() <= LEAN,
                        "{name}: words of step {step} overlap by {both:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn layers_make_up_the_finished_figure() {
    for (name, text) in scenes() {
        let drawing = solved(&text).expect("a good scene").figure();
        let (flat, layered) = (drawing.svg(), layered_svg(&drawing, Text::Letters));
        // Every element of the flat file stands in the layered one too; groups and titles aside.
        let elements = |file: &str| {
            let lines = file.lines().map(str::trim);
            let lines = lines.filter(|line| {
                let group = line.starts_with("<g") && !line.contains("</g>");
                let around = ["<title", "</g>", "<svg", "<desc"];
                !group && !around.iter().any(|s| line.starts_with(s))
            });
            let mut lines: Vec<String> = lines.map(str::to_owned).collect();
            lines.sort();
            lines.dedup();
            lines
        };
        assert_eq!(elements(&flat), elements(&layered), "{name}");
        let steps: BTreeSet<u16> = drawing.marks.iter().map(|mark| mark.since).filter(|&since| since > 0).collect();
        for step in steps {
            let id = format!("id=\"step-{step:02}");
            assert!(layered.contains(&id), "{name}: no {id}");
        }
    }
}

#[test]
fn the_program_writes_them() {
    use support::program::{kinegon, scratch, stderr};
    let folder = scratch("step-sheets");
    let run = |arguments: &[&str]| {
        let scene = "examples/figure-2.json";
        let mut command = kinegon();
        command.args(["draw", scene, "-o"]).arg(&folder);
        command.args(arguments).output().expect("it runs")
    };
    let list = || {
        let entries = std::fs::read_dir(&folder).expect("it is there");
        let names = entries.map(|e| e.expect("an entry").file_name().into_string());
        let mut names: Vec<String> = names.map(|n| n.expect("UTF-8")).collect();
        names.sort();
        names
    };
    assert!(run(&["--upto", "7", "--format", "svg"]).status.success());
    assert_eq!(list(), ["figure-2-07.svg"]);
    assert!(run(&["--steps", "--format", "svg"]).status.success());
    let (_, all) = drawn(&read("examples/figure-2.json"));
    assert_eq!(list().len(), all.steps.len());
    assert!(list().contains(&"figure-2-42.svg".to_owned()));
    assert!(run(&["--layered"]).status.success());
    assert!(list().contains(&"figure-2-layered.svg".to_owned()));
    for (arguments, words) in [
        (&["--upto", "0"] as &[&str], "there is no step 0"),
        (&["--upto", "43"], "steps 1 to 42"),
        (&["--layered", "--format", "png"], "only SVG has layers"),
        (&["--steps", "--upto", "3"], "cannot be used with"),
    ] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let said = stderr(&output);
        assert!(said.contains(words), "{arguments:?}: {said}");
    }
    let count = list().len();
    assert_eq!(count, all.steps.len() + 1, "a refused command wrote a file");
}

/// Places too close for their names are shown larger: distances in the circle are exactly so many times as large.
#[test]
fn crowded_places_are_shown_larger_beside_the_plan() {
    let text = read("examples/figure-2.json");
    let drawing = solved(&text).expect("a good scene").figure();
    let place = |id: &str| {
        let mark = drawing.marks.iter().find(|m| m.id.as_deref() == Some(id));
        mark.map(|mark| mark.shape.bounds().center()).expect("it is drawn")
    };
    let factor = drawing.marks.iter().find_map(|mark| match &mark.shape {
        Shape::Text(text) => text.text.content().strip_suffix(": 1").map(str::to_owned),
        _ => None,
    });
    let factor: f64 = factor.expect("an inset").trim().parse().expect("a number");
    assert!(factor >= 2.0);
    // b, the ends of the Coriolis acceleration, of the tiny normal part beyond it and of another normal part, in the plan and in the circle.
    let names = ["b", "k_b3", "n_b3", "n_b5"].map(|name| place(&format!("acceleration-point-{name}")));
    let dots = drawing.marks.iter().filter(|m| m.pen == Pen::ImagePoint && m.id.is_none());
    let dots: Vec<_> = dots.map(|mark| mark.shape.bounds().center()).collect();
    assert_eq!(dots.len(), 4, "{dots:?}");
    for (k, l) in [(0, 1), (1, 3), (3, 0), (0, 2)] {
        let (small, large) = ((names[k] - names[l]).hypot(), (dots[k] - dots[l]).hypot());
        assert!((large / small - factor).abs() < 1e-9, "{small} {large}");
        assert!(small < 2.0 && large > 4.0);
    }
}

/// `steps` numbers on through the plan of accelerations; sheets end where the figure has no panel for it, and that is told.
#[test]
fn steps_without_a_panel_are_told() {
    use support::program::{kinegon, scratch, stderr};
    let folder = scratch("steps-without-a-panel");
    let mut scene: serde_json::Value = serde_json::from_str(&read("templates/four-bar.json")).expect("JSON");
    let with_panels = solved(&scene.to_string()).expect("a good scene").construction.step_count();
    scene["figure"] = serde_json::json!({ "panels": ["scheme", "velocity"] });
    let path = folder.join("scene.json");
    std::fs::write(&path, scene.to_string()).expect("the scene is written");
    let listed = kinegon().arg("steps").arg(&path).output().expect("it runs");
    let listed = String::from_utf8(listed.stdout).expect("UTF-8");
    assert!(listed.contains(&format!("{with_panels:3}. ")), "{listed}");
    let draw = |arguments: &[&str]| {
        let output = kinegon().arg("draw").arg(&path).arg("-o").arg(&folder).args(arguments).output();
        stderr(&output.expect("it runs"))
    };
    let said = draw(&["--upto", "99"]);
    assert!(said.contains("in the figure's panels") && said.contains("those of the acceleration plan"), "{said}");
    let said = draw(&["--steps", "--format", "svg"]);
    assert!(said.contains("no panel for the acceleration plan"), "{said}");
}
