//! Every scene of `tests/bad_scenes.txt` and every style of `tests/bad_styles.txt` is refused with exactly the message below it.
//! A new case is a few more lines there.

use kinegon::drawing::Style;
use kinegon::mechanism::{StructureError, mechanism};
use kinegon::scene::{Scene, SceneError};
use support::files::refused;

#[test]
fn every_bad_scene_is_refused_with_its_message() {
    each_is_refused("tests/bad_scenes.txt", 180, |text| match Scene::read(text).map(|scene| mechanism(&scene)) {
        Err(error) | Ok(Err(StructureError::Scene(error))) => Some(error),
        Ok(_) => None,
    });
}

#[test]
fn every_bad_style_is_refused_with_its_message() {
    each_is_refused("tests/bad_styles.txt", 30, |text| Style::read(text).err());
}

/// Checks all cases of a table, of which there are at least so many.
fn each_is_refused(table: &str, least: usize, read: impl Fn(&str) -> Option<SceneError>) {
    let cases = refused(table);
    assert!(cases.len() >= least, "only {} cases in {table}", cases.len());
    let mut wrong = Vec::new();
    for case in &cases {
        let actual = match read(&case.text) {
            None => "read without an error".to_owned(),
            Some(error) => {
                if let Some(place) = &error.place {
                    assert!(case.text.get(place.span.clone()).is_some(), "{}: the span is not in the text", case.name);
                }
                error.to_string()
            }
        };
        if actual != case.message {
            wrong.push(format!("{}\n  expected: {}\n  actual:   {actual}", case.name, case.message));
        }
    }
    assert!(wrong.is_empty(), "{} of {} cases of {table}:\n{}", wrong.len(), cases.len(), wrong.join("\n"));
}
