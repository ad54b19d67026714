//! Errors and warnings are said in every language: each declared message has its line in every catalogue, with the blanks that
//! it has in English; and whatever refuses a bad scene is such a message, down to its blanks.

use kinegon::fluent::Catalogue;
use kinegon::message::Declared;
use kinegon::scene::{LanguageName, Scene};
use kinegon::words::{Language, catalogue_of};
use kinegon::{
    accuracy, board, check, cycle, drawing, editing, exercise, forces, mechanism, motion, photo, position, quantity,
    scene,
};
use std::collections::{BTreeMap, BTreeSet};
use support::files::refused;

/// All messages, by their keys.
pub fn declared() -> BTreeMap<&'static str, &'static Declared> {
    let all = [
        scene::says::DECLARED,
        mechanism::says::DECLARED,
        position::says::DECLARED,
        motion::says::DECLARED,
        accuracy::says::DECLARED,
        quantity::says::DECLARED,
        forces::says::DECLARED,
        cycle::says::DECLARED,
        editing::says::DECLARED,
        drawing::says::DECLARED,
        board::says::DECLARED,
        check::says::DECLARED,
        exercise::says::DECLARED,
        photo::says::DECLARED,
    ];
    let by_key: BTreeMap<_, _> = all.into_iter().flatten().map(|declared| (declared.key, declared)).collect();
    assert_eq!(by_key.len(), all.iter().map(|messages| messages.len()).sum::<usize>(), "a key stands twice");
    by_key
}

#[test]
fn every_language_says_every_message() {
    for language in LanguageName::ALL {
        let (catalogue, faults) = Catalogue::read(language.as_str(), catalogue_of(language));
        assert!(faults.is_empty(), "{language:?}: {faults:?}");
        for (key, declared) in declared() {
            let own = catalogue.sentence(key).unwrap_or_else(|| panic!("{language:?} lacks {key}"));
            let all: BTreeSet<&str> = declared.blanks.iter().copied().collect();
            assert_eq!(own.blanks(), all, "the blanks of `{key}` in {language:?}");
        }
    }
}

/// Words that stand in nearly every English message, and in none of another language.
const ENGLISH: [&str; 16] = [
    " the ", " is ", " are ", " has ", " of ", " with ", " and ", " cannot ", "write ", "add ", "remove ", "expected",
    "found ", " missing", "unknown", "keep ",
];

#[test]
fn every_refusal_of_a_scene_is_said_in_every_language() {
    for name in LanguageName::ALL.into_iter().filter(|name| *name != LanguageName::English) {
        let language = Language::of(name);
        for case in refused("tests/bad_scenes.txt") {
            let Some(error) = Scene::read(&case.text).err() else { continue };
            for message in [Some(&error.message), error.hint.as_ref()].into_iter().flatten() {
                let told = format!(" {} ", language.says(message));
                let left: Vec<&str> = ENGLISH.into_iter().filter(|word| told.contains(word)).collect();
                assert!(left.is_empty(), "{name:?}: {}: {told}: {left:?}", case.name);
                assert!(message.declared().is_some(), "{}: {told} is no declared message", case.name);
            }
        }
    }
}
