//! Errors and warnings are said in every language: each declared message has its line in every catalogue, with the blanks that
//! it has in English; and whatever refuses a bad scene is such a message, down to its blanks.

use kinegon::message::Declared;
use kinegon::scene::{LanguageName, Scene};
use kinegon::words::catalogue::read;
use kinegon::words::{Language, catalogue_of};
use kinegon::{
    accuracy, check, cycle, drawing, editing, exercise, mechanism, motion, photo, position, quantity, scene,
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
        cycle::says::DECLARED,
        editing::says::DECLARED,
        drawing::says::DECLARED,
        check::says::DECLARED,
        exercise::says::DECLARED,
        photo::says::DECLARED,
    ];
    let by_key: BTreeMap<_, _> = all.into_iter().flatten().map(|declared| (declared.key, declared)).collect();
    assert_eq!(by_key.len(), all.iter().map(|messages| messages.len()).sum::<usize>(), "a key stands twice");
    by_key
}

/// The blanks of a sentence: other braces are those of JSON.
fn blanks<'s>(sentence: &'s str, declared: &Declared) -> BTreeSet<&'s str> {
    let named = sentence.split('{').skip(1).filter_map(|part| part.split_once('}'));
    named.map(|(name, _)| name).filter(|name| declared.blanks.contains(name)).collect()
}

#[test]
fn every_language_says_every_message() {
    for language in LanguageName::ALL.into_iter().filter(|name| *name != LanguageName::English) {
        let tables = read(catalogue_of(language), &[]).0.tables;
        for (key, declared) in declared() {
            let own = tables.get(key).unwrap_or_else(|| panic!("{language:?} lacks {key} = {}", declared.english));
            let all: BTreeSet<&str> = declared.blanks.iter().copied().collect();
            assert_eq!(blanks(declared.english, declared), all, "the English words of `{key}`");
            assert_eq!(blanks(own, declared), all, "the blanks of `{key}` in {language:?}");
            assert!(all.is_empty() || own.contains('{'), "{key}");
        }
    }
}

/// Words that stand in nearly every English message, and in no Spanish one.
const ENGLISH: [&str; 16] = [
    " the ", " is ", " are ", " has ", " of ", " with ", " and ", " cannot ", "write ", "add ", "remove ", "expected",
    "found ", " missing", "unknown", "keep ",
];

#[test]
fn every_refusal_of_a_scene_is_said_in_spanish() {
    let spanish = Language::of(LanguageName::Spanish);
    for case in refused("tests/bad_scenes.txt") {
        let Some(error) = Scene::read(&case.text).err() else { continue };
        for message in [Some(&error.message), error.hint.as_ref()].into_iter().flatten() {
            let told = format!(" {} ", spanish.says(message));
            let left: Vec<&str> = ENGLISH.into_iter().filter(|word| told.contains(word)).collect();
            assert!(left.is_empty(), "{}: {told}: {left:?}", case.name);
            assert!(message.declared().is_some(), "{}: {told} is no declared message", case.name);
        }
    }
}
