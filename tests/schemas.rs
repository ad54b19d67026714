//! The committed schemas of files are those of the types that read and write them. `KINEGON_WRITE=1 cargo test --features schemas --test schemas`
//! makes them anew.

use kinegon::board::drawing_schema;
use kinegon::check::{Marks, check_schema, class_schema};
use kinegon::drawing::Style;
use kinegon::exercise::key_schema;
use kinegon::format::{json, result_schema};
use kinegon::scene::Scene;
use kinegon::study::StudyFile;
use support::files;

#[test]
fn schemas_are_current() {
    let all = [
        ("scene", Scene::schema()),
        ("result", result_schema()),
        ("style", Style::schema()),
        ("check", check_schema()),
        ("marks", Marks::schema()),
        ("class", class_schema()),
        ("key", key_schema()),
        ("study", StudyFile::schema()),
        ("drawing", drawing_schema()),
    ];
    let mut of_others = Vec::new();
    for (name, schema) in &all {
        let (path, now) = (format!("templates/{name}.schema.json"), json(schema));
        let there = std::fs::read_to_string(files::path(&path)).unwrap_or_default();
        // A checkout may have turned the line ends.
        if there.replace("\r\n", "\n") == now {
            continue;
        }
        match std::env::var_os("KINEGON_WRITE") {
            Some(_) => std::fs::write(files::path(&path), now).expect("it can be written"),
            None => of_others.push(path),
        }
    }
    assert!(of_others.is_empty(), "{of_others:?} are not of the types: KINEGON_WRITE=1 makes them anew");
    let committed = files::list("templates").into_iter().filter(|file| file.ends_with(".schema.json"));
    assert_eq!(committed.count(), all.len());
}
