//! Drawings made on the board, changed as trees, held against two mechanisms: judged, shown, hinted at, made a form of; what is drawn is finite.

#![no_main]

#[path = "../support.rs"]
mod support;

use kinegon::board::{HandDrawing, Judge, Screen};
use kinegon::check::AnswerKey;
use kinegon::{Scene, Sheet};
use libfuzzer_sys::{Corpus, fuzz_mutator, fuzz_target, fuzzer_mutate};
use std::cell::OnceCell;
use support::{mutations, whole_way};

thread_local! {
    static SCREENS: OnceCell<[Screen; 2]> = const { OnceCell::new() };
}

fn screen(text: &str) -> Screen {
    let scene = Scene::read(text).expect("a good scene");
    let solution = kinegon::solve(&scene).expect("a good scene");
    Screen::new(Judge::new(&AnswerKey::new(&solution, None)), solution.wording())
}

fuzz_target!(|data: &[u8]| -> Corpus {
    let read = std::str::from_utf8(data).ok().and_then(|text| Some((text, HandDrawing::read(text).ok()?)));
    let Some((text, drawing)) = read else {
        return Corpus::Reject;
    };
    SCREENS.with(|screens| {
        let screens = screens.get_or_init(|| {
            [include_str!("../../templates/four-bar.json"), include_str!("../../examples/figure-2.json")].map(screen)
        });
        for screen in screens {
            let judged = screen.judge.judge(&drawing).ok();
            let board = screen.board(text.to_owned(), &drawing);
            assert_eq!(board.refused.is_some(), judged.is_none());
            for sheet in Sheet::ALL {
                screen.picture(&drawing, sheet, None, 3.5, judged.as_ref()).iter().for_each(whole_way::drawing_is_finite);
            }
            screen.hint(&drawing, judged.as_ref(), 3);
            screen.judge.form(&drawing).json(&screen.judge.given().solution);
            if let Some(judged) = judged {
                judged.result(&screen.judge, &drawing, &screen.words()).report(&screen.words());
            }
        }
    });
    Corpus::Keep
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed % 16 {
        0 => fuzzer_mutate(data, size, max_size),
        _ => mutations::mutate(data, size, max_size, seed),
    }
});
