//! Forms, styles, marking schemes and texts of strangers, taken the whole way: an error that can be shown, or outputs that
//! other programs can read.

use super::outputs;
use super::stages::{answer_key, solved};
use kinegon::Solution;
use kinegon::check::{self, AnswerKey, ClassColumns, ClassRow, Feedback, MarkScheme, Marks, Measured, Prepared};
use kinegon::drawing::{Drawing, Style};
use kinegon::format::{self, Text};
use kinegon::quantity::{QuantityRequest, pencil, step_names};
use kinegon::scene::{Figure, SceneError};
use kinegon::text::Untrusted;
use kinegon::words::Wording;
use std::sync::LazyLock;

/// A mechanism, solved, with its answers made ready for many forms.
pub struct Subject {
    solution: &'static Solution,
    prepared: Prepared<'static>,
    scheme: MarkScheme,
}

/// A four-bar linkage and a slotted lever: a form is held against both.
static SUBJECTS: LazyLock<Vec<Subject>> = LazyLock::new(|| {
    let scenes = [include_str!("../../templates/four-bar.json"), include_str!("../../templates/slotted-lever.json")];
    let subject = |text: &str| {
        let solution: &Solution = Box::leak(Box::new(solved(text).expect("a starting scene is good")));
        let key = answer_key(solution, 2);
        let marks = Marks::read(r#"{ "kinegon_marks": 1, "each": 1 }"#).expect("it is good");
        let scheme = marks.of(&key).expect("it fits every scene");
        Subject { solution, prepared: Prepared::new(&key), scheme }
    };
    scenes.map(subject).into()
});

/// Reads a form, as JSON or as a table, and checks it; its report, row and page can be read back.
pub fn form(text: &str) {
    let measured = if text.trim_start().starts_with(['{', '[']) {
        Measured::read_json(text).map_err(|error| refused(text, &error))
    } else {
        Measured::read_csv(text).map_err(|error| {
            said(&format!("{error}\n{}", error.hint.as_ref().map_or_else(String::new, ToString::to_string)))
        })
    };
    let Ok(measured) = measured else { return };
    for subject in SUBJECTS.iter() {
        checked(subject, &measured, text);
    }
}

/// Checks a form against one mechanism.
fn checked(subject: &Subject, measured: &Measured, given: &str) {
    let (key, words) = (subject.prepared.key(), Wording::of(&subject.solution.scene.figure));
    let columns = ClassColumns { exercise: true, marks: true };
    // A name of a file is a stranger's text, too.
    let file: Untrusted = measured.name.clone().unwrap_or_else(|| "form.csv".into());
    let found = match subject.prepared.check(measured) {
        Ok(found) => found,
        Err(error) => {
            said(&format!("{error}\n{}", error.hint.as_ref().map_or_else(String::new, ToString::to_string)));
            table(&ClassRow::broken(file.clone(), &error.to_string()).csv(columns), columns);
            let page = Feedback::refused(Some(&subject.solution.scene), &file, &error.to_string(), &words);
            return outputs::html(&page.html());
        }
    };
    let report = check::report(&found, key);
    outputs::numbers(&outputs::terminal(report.as_bytes()), given);
    let result = check::check_result(&found, key, measured.name.clone());
    outputs::json(&format::json(&result));
    let row = ClassRow::checked(file, measured.name.as_ref(), &found, key, Some(&subject.scheme));
    table(&row.csv(columns), columns);
    outputs::json(&format::json_line(&row));
    let marks = subject.scheme.award(&found);
    let page = Feedback::new(measured, key, &found, Some(&marks)).expect("what was checked has its scales");
    outputs::html(&page.html());
    for sheet in page.sheets() {
        pictures(&sheet);
    }
}

fn table(row: &str, columns: ClassColumns) {
    outputs::csv(&(ClassRow::csv_head(columns) + row));
}

/// Reads a marking scheme and applies it.
pub fn marks(text: &str) {
    let marks = match Marks::read(text) {
        Ok(marks) => marks,
        Err(error) => return refused(text, &error),
    };
    for subject in SUBJECTS.iter() {
        let key: &AnswerKey<'_> = subject.prepared.key();
        match marks.of(key) {
            Err(error) => {
                said(&format!("{error}\n{}", error.hint.as_ref().map_or_else(String::new, ToString::to_string)))
            }
            Ok(scheme) => {
                let form = r#"{ "kinegon_measured": 1, "values": { "omega(3)": 1, "omega(4)": -3 } }"#;
                let measured = Measured::read_json(form).expect("it is a form");
                if let Ok(found) = subject.prepared.check(&measured) {
                    let awarded = scheme.award(&found);
                    let line = awarded.line(&Wording::of(&Figure::default()));
                    outputs::numbers(&outputs::terminal(line.as_bytes()), "");
                }
            }
        }
    }
}

/// Reads a style and draws in it.
pub fn style(text: &str) {
    match Style::read(text) {
        Err(error) => refused(text, &error),
        Ok(style) => {
            let subject = &SUBJECTS[0];
            let mut scene = subject.solution.scene.clone();
            scene.figure.sizes = Some(style.sizes());
            scene.figure.usual_values = Some(style.shows_values());
            let solution = Solution { scene, ..subject.solution.clone() };
            let mut drawing = solution.figure();
            drawing.style = style;
            pictures(&drawing);
        }
    }
}

/// Puts texts wherever strangers write some into a scene and a form, and draws and prints them: one text a line.
pub fn texts(lines: &str) {
    let mut lines = lines.split('\n').cycle();
    let mut next = || Untrusted::from(lines.next().unwrap_or_default());
    let subject = &SUBJECTS[0];
    let mut scene = subject.solution.scene.clone();
    scene.title = Some(next());
    for name in ["A", "B", "C", "D", "2", "3"] {
        scene.figure.labels.insert(name.to_owned(), next());
    }
    let solution = Solution { scene, ..subject.solution.clone() };
    pictures(&solution.figure());
    let steps = step_names(&solution.construction);
    let asked = steps
        .iter()
        .map(|name| QuantityRequest::new(name, &solution.mechanism).expect("steps measure quantities"))
        .collect();
    let pencil = pencil(&solution, &solution.scales(), Default::default(), asked);
    outputs::terminal(solution.steps(&pencil).as_bytes());
    let key = answer_key(&solution, 1);
    let scheme = Marks::read(r#"{ "kinegon_marks": 1 }"#).expect("it is good").of(&key).expect("it fits");
    let form = r#"{ "kinegon_measured": 1, "mu_v": 5, "values": { "omega(3)": 7, "vplan(p,b)": 12 } }"#;
    let measured = Measured { name: Some(next()), ..Measured::read_json(form).expect("it is a form") };
    let columns = ClassColumns { exercise: true, marks: true };
    table(&ClassRow::broken(next(), next().for_message().as_str()).csv(columns), columns);
    if let Ok(found) = check::check(&measured, &key) {
        outputs::terminal(check::report(&found, &key).as_bytes());
        let row = ClassRow::checked(next(), measured.name.as_ref(), &found, &key, Some(&scheme));
        table(&row.csv(columns), columns);
        outputs::json(&format::json_line(&row));
        let page = Feedback::new(&measured, &key, &found, None).expect("it has its scales");
        outputs::html(&page.html());
        page.sheets().iter().for_each(pictures);
    }
    for line in 0..3 {
        let text = next();
        outputs::message(text.for_message().as_bytes());
        outputs::message(format!("{line} {text:?}").as_bytes());
        // The program writes the scene of an exercise anew.
        let json = format::json(&serde_json::json!({ "title": text }));
        assert_eq!(outputs::json(&json)["title"], serde_json::json!(text));
    }
}

/// A drawing as every format has it.
fn pictures(drawing: &Drawing) {
    outputs::svg(&drawing.svg());
    outputs::svg(&format::svg_with(drawing, Text::Outlines));
    outputs::svg(&format::layered_svg(drawing, Text::Letters));
    outputs::tex(&drawing.tikz());
    outputs::pdf(&drawing.pdf().expect("a sheet has a size"));
}

/// A message of the library; the program shortens its lines.
fn said(message: &str) {
    assert!(!message.trim().is_empty());
    outputs::terminal(message.as_bytes());
}

fn refused(text: &str, error: &SceneError) {
    said(&error.to_string());
    {
        let shown = kinegon::cli::shown("file\u{1b}[31m.json", text, &kinegon::Error::Scene(error.clone()));
        // The program's own colours are no part of what strangers write.
        let plain =
            shown.split("\u{1b}[").map(|part| part.split_once('m').map_or(part, |(_, rest)| rest)).collect::<String>();
        outputs::terminal(plain.as_bytes());
    }
}
