//! Drawings made on the board, changed as trees, held against the mechanism that they name: judged whole and half, shown, hinted at, gone on with
//! by a press of every tool, made a form of; what is drawn is finite.

#![no_main]

#[path = "../support.rs"]
mod support;

use kinegon::board::{HandDrawing, Judge, Pressed, Screen};
use kinegon::check::AnswerKey;
use kinegon::{Scene, Sheet};
use libfuzzer_sys::{Corpus, fuzz_mutator, fuzz_target, fuzzer_mutate};
use std::cell::RefCell;
use std::collections::BTreeMap;
use support::{mutations, whole_way};

macro_rules! scenes {
    ($($name:literal $file:literal),* $(,)?) => { [$(($name, include_str!(concat!("../../", $file)))),*] };
}

/// Groups of all classes, sliders, given motions, instant centres. A drawing says by its exercise which of them it is of; else it is of the first.
const SCENES: [(&str, &str); 11] = scenes![
    "four-bar" "templates/four-bar.json",
    "slider-crank" "templates/slider-crank.json",
    "slotted-lever" "templates/slotted-lever.json",
    "watt-1" "templates/watt-1.json",
    "third-class" "templates/third-class.json",
    "fourth-class" "templates/fourth-class.json",
    "dyad-prp" "templates/dyad-prp.json",
    "platform-3rrr" "templates/platform-3rrr.json",
    "hydraulic-boom" "templates/hydraulic-boom.json",
    "figure-2" "examples/figure-2.json",
    "centers" "fuzz/scenes/centers.json",
];

/// Entries of which a press says what comes next.
const BEGUN: [&str; 10] = [
    r#"{"line":"","along":{"normal":""}}"#,
    r#"{"line":"","along":{"parallel":"A,B"}}"#,
    r#"{"lay_off":"","size":"5","from":"p","along":{"normal":""}}"#,
    r#"{"join":"","points":["A"]}"#,
    r#"{"cross":""}"#,
    r#"{"like":"","points":["A","B"]}"#,
    r#"{"measure":"","from":"p"}"#,
    r#"{"mark":""}"#,
    r#"{"rub":""}"#,
    r#"{"join":"","points":["P(1,2)"]}"#,
];

thread_local! {
    static SCREENS: RefCell<BTreeMap<usize, Screen>> = const { RefCell::new(BTreeMap::new()) };
}

fn screen(text: &str) -> Screen {
    let scene = Scene::read(text).expect("a good scene");
    let solution = kinegon::solve(&scene).expect("a good scene");
    Screen::new(Judge::new(&AnswerKey::new(&solution, None)), solution.wording())
}

/// The mechanism that a drawing is of.
fn scene_of(text: &str) -> usize {
    let drawing: serde_json::Value = serde_json::from_str(text).unwrap_or_default();
    SCENES.iter().position(|(name, _)| drawing["exercise"] == *name).unwrap_or(0)
}

fn tried(screen: &Screen, text: &str, drawing: &HandDrawing) {
    let judged = screen.judge.judge(drawing).ok();
    let board = screen.board(text.to_owned(), drawing);
    assert_eq!(board.refused.is_some(), judged.is_none());
    for sheet in Sheet::ALL {
        screen.picture(drawing, sheet, None, 3.5, judged.as_ref()).iter().for_each(whole_way::drawing_is_finite);
        for begun in BEGUN {
            let has = serde_json::from_str(begun).expect("JSON");
            for snap in screen.snapped(drawing, &Pressed { has, sheet, at: [60.0, 60.0], reach: 40.0 }) {
                assert!(snap.at.iter().all(|side| side.is_finite()), "{snap:?}");
            }
        }
    }
    screen.hint(drawing, judged.as_ref(), 3);
    screen.judge.form(drawing).json(&screen.judge.given().solution);
    assert_eq!(screen.judge.steps(drawing).len(), drawing.did.len());
    if let Some(judged) = judged {
        judged.result(&screen.judge, drawing, &screen.words()).report(&screen.words());
        // Whatever can be carried out, its beginning can.
        let mut half = drawing.clone();
        half.did.truncate(drawing.did.len() / 2);
        assert!(screen.judge.judge(&half).is_ok());
    }
}

fuzz_target!(|data: &[u8]| -> Corpus {
    let read = std::str::from_utf8(data).ok().and_then(|text| Some((text, HandDrawing::read(text).ok()?)));
    let Some((text, drawing)) = read else {
        return Corpus::Reject;
    };
    SCREENS.with_borrow_mut(|screens| {
        let scene = scene_of(text);
        tried(screens.entry(scene).or_insert_with(|| screen(SCENES[scene].1)), text, &drawing);
    });
    Corpus::Keep
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed % 16 {
        0 => fuzzer_mutate(data, size, max_size),
        _ => mutations::mutate(data, size, max_size, seed),
    }
});
