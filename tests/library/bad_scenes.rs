//! Every scene of `tests/bad_scenes` and every style of `tests/bad_styles` is refused with exactly the message beside it
//! (`NAME.json`, `NAME.txt`). A new case is a new pair of files.

use kinegon::drawing::Style;
use kinegon::scene::{Scene, SceneError};
use std::fs;
use std::path::Path;

#[test]
fn every_bad_scene_is_refused_with_its_message() {
    refused("tests/bad_scenes", 100, |text| Scene::read(text).err());
}

#[test]
fn every_bad_style_is_refused_with_its_message() {
    refused("tests/bad_styles", 20, |text| Style::read(text).err());
}

/// Checks all cases of a folder, of which there are at least so many.
fn refused(folder: &str, least: usize, read: impl Fn(&str) -> Option<SceneError>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut cases: Vec<_> = fs::read_dir(&folder)
        .expect("the folder of cases is there")
        .map(|entry| entry.expect("the folder can be listed").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    cases.sort();
    assert!(cases.len() >= least, "only {} cases found in {}", cases.len(), folder.display());

    let mut wrong = Vec::new();
    for case in &cases {
        let text = fs::read_to_string(case).expect("a case can be read");
        let expected = fs::read_to_string(case.with_extension("txt")).unwrap_or_default();
        let actual = match read(&text) {
            None => "read without an error".to_owned(),
            Some(error) => {
                if let Some(place) = &error.place {
                    assert!(text.get(place.span.clone()).is_some(), "{}: the span is not in the text", case.display());
                }
                error.to_string()
            }
        };
        if actual != expected.trim_end() {
            wrong.push(format!("{}\n  expected: {}\n  actual:   {actual}", case.display(), expected.trim_end()));
        }
    }
    assert!(wrong.is_empty(), "{} of {} cases:\n{}", wrong.len(), cases.len(), wrong.join("\n"));
}
