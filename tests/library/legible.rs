//! No text of a panel runs together with another, and no line goes through one: on paper and in the hall, with values and without, in all
//! languages and notations, at several steps of the construction.

use kinegon::Scene;
use kinegon::drawing::{Drawing, FigureSheets, Pen, RichText, Shape, Steps};
use kinegon::scene::{LanguageName, NotationName, Page, StyleName, ValuesShown};
use support::files;
use support::legible::misread;
use support::stages::solved;
use support::survey::{LEGIBLE, MISREAD, on_all_cores};

/// What is counted, and all of it in words.
#[derive(Default)]
struct Count {
    drawings: usize,
    /// Pairs beside each other, pairs one above the other, texts struck through, names without room, and names and values
    /// that stand nowhere.
    misread: [usize; 5],
    words: Vec<String>,
}

/// A sheet of each kind: its style, its page, whether values are asked for.
const SURFACES: [(StyleName, &str, bool); 8] = [
    (StyleName::Paper, "a4", false),
    (StyleName::Lecture, "16x9", true),
    (StyleName::Print, "a4", true),
    (StyleName::Board, "16x9", false),
    (StyleName::Lecture, "16x9", false),
    (StyleName::Paper, "a4", true),
    (StyleName::Lecture, "a4-portrait", false),
    (StyleName::Board, "16x9", true),
];

/// The finished figure, and the sheets after some of the steps, fine and coarse.
fn drawings(sheets: &FigureSheets<'_>) -> Vec<(String, Drawing)> {
    let mut all = vec![("figure".to_owned(), sheets.figure())];
    for (steps, word) in [(Steps::Fine, "step"), (Steps::Coarse, "coarse step")] {
        let stepwise = sheets.steps(steps);
        let last = stepwise.steps.len();
        all.extend([last / 3, 2 * last / 3, last].map(|step| (format!("{word} {step}"), stepwise.after_step(step))));
    }
    all
}

/// Names without room that the panel does not list.
fn unlisted(drawing: &Drawing) -> Vec<String> {
    let mut missing = Vec::new();
    for unlabelled in &drawing.unlabelled {
        let frame = drawing.panels.iter().find(|(name, _)| *name == unlabelled.panel).expect("it names a panel").1;
        let listed = drawing.marks.iter().filter_map(|mark| match &mark.shape {
            Shape::Text(text) if frame.overlaps(text.ink_box()) && mark.pen == Pen::Caption => Some(&text.text),
            _ => None,
        });
        let listed: Vec<&RichText> = listed.collect();
        let names = unlabelled.names.iter().filter(|name| !listed.contains(&&name.text));
        missing.extend(names.map(|name| name.text.content()));
    }
    missing
}

/// Values that the figure asks for and that stand neither on it nor on a further sheet.
fn values_nowhere(sheets: &FigureSheets<'_>, figure: &Drawing) -> Vec<String> {
    let all = sheets.sheets();
    let further = all.iter().skip(1).flat_map(|sheet| &sheet.marks).filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some(text.text.content()),
        _ => None,
    });
    let further: Vec<String> = further.collect();
    let count = further.len();
    let missing = sheets.values_without_room(figure);
    // Each has a row of three cells: symbols are set, so that only their number is compared.
    if count >= 2 * missing.len() { Vec::new() } else { missing }
}

fn judge(name: &str, drawing: &Drawing, nowhere: Vec<String>, count: &mut Count) {
    let found = misread(drawing);
    let names = drawing.unlabelled.iter().flat_map(|panel| &panel.names);
    let left_out: Vec<String> = names.map(|name| name.text.content()).collect();
    let kinds = [
        ("beside", found.beside),
        ("stacked", found.stacked),
        ("struck", found.struck),
        ("no room", left_out),
        ("nowhere", [unlisted(drawing), nowhere].concat()),
    ];
    count.drawings += 1;
    for ((kind, all), sum) in kinds.into_iter().zip(&mut count.misread) {
        *sum += all.len();
        count.words.extend(all.into_iter().map(|what| format!("{name}: {kind}: {what}")));
    }
}

#[test]
fn texts_are_read_as_they_are() {
    let scenes = ["templates", "examples", "tests/lecture"].into_iter().flat_map(files::scenes);
    // Some have gears, or no such position: they are refused.
    let scenes: Vec<(String, String)> = scenes.filter(|(_, text)| solved(text).is_ok()).collect();
    assert!(scenes.len() >= 40, "only {} scenes", scenes.len());
    let words: Vec<(NotationName, LanguageName)> = NotationName::ALL
        .into_iter()
        .flat_map(|notation| LanguageName::ALL.map(|language| (notation, language)))
        .collect();
    let all = scenes.len() * SURFACES.len() * words.len();
    // A step that shares no divisor with the number of scenes: they come in turn, none more often than others.
    let shared = |step: &usize| (2..=*step).any(|n| step.is_multiple_of(n) && scenes.len().is_multiple_of(n));
    let every = (LEGIBLE.now()..).find(|step| !shared(step)).expect("one of them");
    let counts = on_all_cores((all / every) as u64, |number, count: &mut Count| {
        let case = number as usize * every;
        let (name, text) = &scenes[case % scenes.len()];
        let (style, page, values) = SURFACES[case / scenes.len() % SURFACES.len()];
        let (notation, language) = words[case / scenes.len() / SURFACES.len()];
        let mut scene = Scene::read(text).expect("a good scene");
        let figure = &mut scene.figure;
        (figure.style, figure.notation, figure.language) = (style, notation, language);
        figure.page = Page::from_name(page).expect("it is a page");
        figure.values = Some(if values { ValuesShown::Shown(None) } else { ValuesShown::Hidden });
        let solution = kinegon::solve(&scene).expect("it moves");
        let sheets = FigureSheets::new(&solution);
        for (sheet, drawing) in drawings(&sheets) {
            let name = format!("{name} in {style:?} on {page}, values {values}, {notation:?}, {language:?}, {sheet}");
            let nowhere = if sheet == "figure" { values_nowhere(&sheets, &drawing) } else { Vec::new() };
            judge(&name, &drawing, nowhere, count);
        }
    });
    let mut whole = Count::default();
    for Count { drawings, misread, words } in counts {
        whole.drawings += drawings;
        whole.misread.iter_mut().zip(misread).for_each(|(sum, own)| *sum += own);
        whole.words.extend(words);
    }
    whole.words.sort();
    let counted = format!(
        "{:?} in {} drawings: pairs beside each other, above each other, texts struck, without room, nowhere",
        whole.misread, whole.drawings
    );
    eprintln!("{counted}");
    let few = whole.misread.iter().zip(MISREAD.now()).all(|(seen, most)| *seen <= most);
    assert!(few, "{counted}\n{}", whole.words.join("\n"));
}
