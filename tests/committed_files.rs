//! Files in the repository that the program makes are what it makes now: the schemas, the two figures of the paper, the gallery.
//!
//! `kinegon schema scene > templates/scene.schema.json`, likewise `result`, `kinegon draw` and
//! `cargo run --release --example gallery` make them anew.

#[allow(dead_code)] // it is a program, too
#[path = "../examples/gallery.rs"]
mod gallery;

use kinegon::scene::Scene;
use kinegon::{drawing, format, mechanism, motion, plan, position};
use std::path::{Path, PathBuf};

fn committed(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// Compares, and leaves what came out beside the test's other products for a look.
fn same(path: &str, now: &str) {
    let there = std::fs::read_to_string(committed(path)).unwrap_or_default();
    // A checkout may have turned the line ends.
    if there.replace("\r\n", "\n") != now {
        let left = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(path.replace('/', "-"));
        std::fs::write(&left, now).expect("the test's folder can be written");
        panic!(
            "{path} is not what the program makes now: see {}",
            left.display()
        );
    }
}

fn figure(name: &str) -> drawing::Drawing {
    let text = std::fs::read_to_string(committed(&format!("examples/{name}.json")))
        .expect("the example is there");
    let scene = Scene::read(&text).expect("a good scene");
    let mechanism = mechanism::mechanism(&scene).expect("a mechanism");
    let pose = position::pose(&mechanism, &scene.near).expect("it can be assembled");
    let motion =
        motion::motion(&mechanism, &pose, motion::Order::Acceleration).expect("it is not singular");
    let plans = plan::construction(&mechanism, &pose, &motion);
    drawing::figure(&scene, &mechanism, &pose, &plans)
}

#[test]
fn schemas_are_current() {
    same(
        "templates/scene.schema.json",
        &format::json(&Scene::schema()),
    );
    same(
        "templates/result.schema.json",
        &format::json(&format::result_schema()),
    );
}

#[test]
fn examples_name_the_schema_and_fit_it() {
    // The schema's own rules are those of the reader; here only that every example reads and points to it.
    let folder = std::fs::read_dir(committed("examples")).expect("the folder is there");
    let mut seen = 0;
    for entry in folder {
        let path = entry.expect("the folder can be listed").path();
        if path.extension().is_some_and(|e| e == "json") {
            let text = std::fs::read_to_string(&path).expect("it can be read");
            assert!(
                text.contains("\"$schema\": \"../templates/scene.schema.json\""),
                "{}",
                path.display()
            );
            Scene::read(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            seen += 1;
        }
    }
    assert!(seen >= 3);
}

#[test]
fn figures_are_redrawn_to_the_byte() {
    for name in ["figure-1", "figure-2"] {
        same(&format!("out/{name}.svg"), &format::svg(&figure(name)));
    }
}

#[test]
fn the_gallery_is_current_and_complete() {
    let files = gallery::files().expect("every scene can be drawn");
    for (path, text) in &files {
        same(path, text);
    }
    let names = |folder: &str, ending: &str| -> Vec<String> {
        let files = std::fs::read_dir(committed(folder)).expect("the folder is there");
        let names = files.map(|file| file.expect("the folder can be listed").file_name());
        let names = names.filter_map(|name| Some(name.to_str()?.strip_suffix(ending)?.to_owned()));
        names.filter(|name| !name.ends_with(".schema")).collect()
    };
    let is_shown = |name: &str| {
        let picture = format!("docs/gallery/{name}.svg");
        files.iter().any(|(path, _)| *path == picture)
    };
    let mut templates = names("templates", ".json");
    templates.retain(|name| !is_shown(name));
    assert!(templates.is_empty(), "not in the gallery: {templates:?}");
    let mut pictures = names("docs/gallery", ".svg");
    pictures.retain(|name| !is_shown(name));
    assert!(pictures.is_empty(), "not made any more: {pictures:?}");
}

#[cfg(feature = "png")]
#[test]
fn pictures_are_redrawn_within_one_level_per_channel() {
    fn pixels(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
            .read_info()
            .expect("a PNG");
        let size = reader.output_buffer_size().expect("a size that fits");
        let mut data = vec![0; size];
        let info = reader.next_frame(&mut data).expect("a frame");
        (info.width, info.height, data)
    }
    for name in ["figure-1", "figure-2"] {
        let there = std::fs::read(committed(&format!("out/{name}.png"))).expect("it is there");
        let now = format::png(&figure(name), 100.0).expect("a picture");
        let ((w, h, a), (x, y, b)) = (pixels(&there), pixels(&now));
        assert_eq!((w, h), (x, y), "{name}");
        let worst = a.iter().zip(&b).map(|(a, b)| a.abs_diff(*b)).max();
        if worst > Some(1) {
            let left = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
            std::fs::write(&left, &now).expect("the test's folder can be written");
            panic!(
                "out/{name}.png differs by up to {worst:?} levels: see {}",
                left.display()
            );
        }
    }
}
