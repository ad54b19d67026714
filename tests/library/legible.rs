//! No text of a panel runs together with another, and no line goes through one: on paper and in the hall, with values and without, in all
//! languages and notations, at several steps of the construction.

use kinegon::Scene;
use kinegon::drawing::{Drawing, FigureSheets, Steps};
use kinegon::scene::{LanguageName, NotationName, Page, StyleName, ValuesShown};
use support::files;
use support::legible::misread;
use support::stages::solved;
use support::survey::{LEGIBLE, MISREAD, on_all_cores};

/// What is counted in each group of drawings: pairs beside each other, pairs one above the other, texts struck through, names
/// left out; and all of them in words.
#[derive(Default)]
struct Count {
    drawings: usize,
    misread: [usize; 4],
    words: Vec<String>,
}

/// A sheet of each kind: its style, its page, whether values are asked for.
const SURFACES: [(StyleName, &str, bool); 4] = [
    (StyleName::Paper, "a4", false),
    (StyleName::Paper, "a4", true),
    (StyleName::Lecture, "16x9", false),
    (StyleName::Lecture, "16x9", true),
];

/// The finished figure, and the sheets after some of the steps.
fn drawings(scene: &Scene) -> Vec<(String, Drawing)> {
    let solution = kinegon::solve(scene).expect("it moves");
    let sheets = FigureSheets::new(&solution);
    let stepwise = sheets.steps(Steps::Fine);
    let last = stepwise.steps.len();
    let mut all = vec![("figure".to_owned(), sheets.figure())];
    all.extend([last / 3, 2 * last / 3, last].map(|step| (format!("step {step}"), stepwise.after_step(step))));
    all
}

fn judge(name: &str, drawing: &Drawing, count: &mut Count) {
    let found = misread(drawing);
    let left_out: Vec<String> = drawing.unlabelled.iter().flat_map(|(_, names)| names.clone()).collect();
    let kinds =
        [("beside", found.beside), ("stacked", found.stacked), ("struck", found.struck), ("left out", left_out)];
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
    let every = LEGIBLE.now();
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
        for (sheet, drawing) in drawings(&scene) {
            let name = format!("{name} on {page}, values {values}, {notation:?}, {language:?}, {sheet}");
            judge(&name, &drawing, count);
        }
    });
    let mut whole = Count::default();
    for Count { drawings, misread, words } in counts {
        whole.drawings += drawings;
        whole.misread.iter_mut().zip(misread).for_each(|(sum, own)| *sum += own);
        whole.words.extend(words);
    }
    whole.words.sort();
    let said = format!("{:?} in {} drawings\n{}", whole.misread, whole.drawings, whole.words.join("\n"));
    let few = whole.misread.iter().zip(MISREAD.now()).all(|(seen, most)| *seen <= most);
    assert!(few, "{said}");
}
