//! Sheets to be drawn on, with markers or without.

use std::path::Path;
use std::process::Output;
use support::files;
use support::program::{kinegon, scratch, stderr};

fn scene(folder: &Path) -> String {
    let path = folder.join("lever.json");
    std::fs::write(&path, files::read("templates/slotted-lever.json")).expect("it is written");
    path.to_str().expect("a path").to_owned()
}

fn run(arguments: &[&str]) -> Output {
    kinegon().args(arguments).output().expect("it runs")
}

/// The names of the files in a folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = entries.map(|name| name.to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[cfg(feature = "pdf")]
fn pages(pdf: &Path) -> usize {
    lopdf::Document::load(pdf).expect("a PDF").get_pages().len()
}

#[test]
fn blank_sheets_are_pages_of_one_pdf() {
    let folder = scratch("blank-sheets");
    let scene = scene(&folder);
    let [drawn, pdf] = ["drawn", "blank.pdf"].map(|name| folder.join(name).to_str().expect("a path").to_owned());
    let output = run(&["draw", &scene, "--worksheet=blank", "--format", "svg", "-o", &format!("{drawn}/")]);
    assert!(output.status.success() && output.stderr.is_empty(), "{}", stderr(&output));
    let sheets = names(Path::new(&drawn));
    assert!(
        sheets.len() >= 2 && sheets.contains(&"lever.svg".into()) && sheets.contains(&"lever-2.svg".into()),
        "{sheets:?}"
    );
    let first = std::fs::read_to_string(folder.join("drawn/lever.svg")).expect("a sheet");
    assert!(first.contains("id=\"marker-8\"") && first.contains("id=\"code\""));
    let output = run(&["draw", &scene, "--worksheet=blank", "-o", &pdf]);
    assert!(output.status.success(), "{}", stderr(&output));
    #[cfg(feature = "pdf")]
    assert_eq!(pages(Path::new(&pdf)), sheets.len());
    assert_eq!(names(&folder), ["blank.pdf", "drawn", "lever.json"]);
    // Without markers the same sheets in the usual frame.
    let output =
        run(&["draw", &scene, "--worksheet=blank", "--no-markers", "--format", "svg", "-o", &format!("{drawn}/")]);
    assert!(output.status.success() && output.stderr.is_empty(), "{}", stderr(&output));
    let plain = std::fs::read_to_string(folder.join("drawn/lever-2.svg")).expect("a sheet");
    assert!(!plain.contains("marker") && plain.contains("point-"));
}

#[test]
fn what_blank_sheets_do_not_have_is_refused() {
    let folder = scratch("blank-refused");
    let scene = scene(&folder);
    for (more, message) in [
        (&["--steps", "fine"][..], "sheets to be drawn on have no steps"),
        (&["--upto", "2"], "sheets to be drawn on have no steps"),
        (&["--layered"], "sheets to be drawn on have no steps"),
        (&["--values"], "sheets to be drawn on tell no values"),
        (&["--format", "html"], "a page has no sheets to be drawn on"),
    ] {
        let output =
            run(&[&["draw", &scene, "--worksheet=blank", "-o", folder.to_str().expect("a path")], more].concat());
        assert_eq!(output.status.code(), Some(2), "{more:?}");
        assert!(
            stderr(&output).contains(message) && stderr(&output).contains("leave out") || more.contains(&"html"),
            "{}",
            stderr(&output)
        );
    }
    let output = run(&["draw", &scene, "--worksheet=half", "-o", folder.to_str().expect("a path")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("half"), "{}", stderr(&output));
}

#[test]
fn a_sheet_without_markers_says_why() {
    let folder = scratch("no-markers");
    let scene = scene(&folder);
    let svg = folder.join("w.svg");
    let drawn = |more: &[&str]| {
        let output = run(&[&["draw", &scene, "--worksheet", "-o", svg.to_str().expect("a path")], more].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        (stderr(&output), std::fs::read_to_string(&svg).expect("a sheet").contains("id=\"marker-1\""))
    };
    assert_eq!(drawn(&["--scales", "sheet"]), (String::new(), true));
    assert_eq!(drawn(&["--scales", "sheet", "--no-markers"]), (String::new(), false));
    let (said, has_markers) = drawn(&["--page", "16x9"]);
    assert!(said.contains("proportions have no markers") && !has_markers, "{said}");
    assert_eq!(drawn(&["--page", "16x9", "--no-markers"]), (String::new(), false));
    // So small a scale that the scheme fills the sheet.
    let (said, has_markers) = drawn(&["--mu-l", "0.5", "--mu-v", "0.5", "--mu-a", "0.5"]);
    assert!(said.contains("no room for markers") && !has_markers, "{said}");
}

#[test]
fn exercises_bring_sheets_for_their_plans() {
    let folder = scratch("exercise-sheets");
    let made = |name: &str, more: &[&str]| {
        let path = folder.join(name);
        let arguments =
            [&["exercise", "slider-crank", "--seed", "4", "-o", path.to_str().expect("a path")], more].concat();
        let output = run(&arguments);
        assert!(output.status.success(), "{}", stderr(&output));
        path.join("slider-crank-4-1")
    };
    let (with, without) = (made("with", &[]), made("without", &["--no-markers"]));
    let usual = [
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
    let usual = usual.into_iter().filter(|name| cfg!(feature = "pdf") || !name.ends_with("pdf"));
    assert!(names(&without).into_iter().eq(usual));
    let more: Vec<String> = names(&with).into_iter().filter(|name| name.starts_with("sheet-")).collect();
    assert!(more.contains(&"sheet-2.svg".into()), "{more:?}");
    #[cfg(feature = "pdf")]
    assert_eq!([pages(&with.join("sheet.pdf")), pages(&without.join("sheet.pdf"))], [more.len() + 1, 1]);
    for name in ["scene.json", "form.json", "form.csv", "key.json", "key.svg"] {
        assert!(std::fs::read(with.join(name)).ok() == std::fs::read(without.join(name)).ok(), "{name}");
    }
    let [said, plain] =
        [&with, &without].map(|folder| std::fs::read_to_string(folder.join("sheet.svg")).expect("a sheet"));
    assert!(said.contains("Sheets for the plans follow") && !said.contains("or larger"));
    assert!(plain.contains("or larger") && !plain.contains("marker"));
}
