//! Files in the repository that the program makes are what it makes now: the two figures of the paper, curves over the second
//! one's cycle and the paper's numbers checked, the gallery, the workbench.
//!
//! `kinegon draw`, `kinegon curves examples/figure-2.json --want "omega(4), alpha(4), v_r(3/2)"`,
//! `kinegon check examples/figure-2.json examples/paper-as-student.json --draw out/ --mu-l 5 --mu-v 2.5 --mu-a 2.5` and
//! `cargo run --release --example gallery` make them anew; `web/build` makes the workbench.

use crate::examples::gallery;
use kinegon::check::{Measured, check, redrawn};
use kinegon::cycle::{Curves, Drive, Path};
use kinegon::drawing::Drawing;
use kinegon::scene::Scene;
use kinegon::{PerSheet, Sheet, Solution, drawing};
use sha2::{Digest, Sha256};
use std::path::PathBuf;
use support::files;
use support::stages::{answer_key, solved};

/// Compares, and leaves what came out beside the test's other products for a look.
fn same(path: &str, now: &str) {
    let there = std::fs::read_to_string(files::path(path)).unwrap_or_default();
    // A checkout may have turned the line ends.
    if there.replace("\r\n", "\n") != now {
        let left = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(path.replace('/', "-"));
        std::fs::write(&left, now).expect("the test's folder can be written");
        panic!("{path} is not what the program makes now: see {}", left.display());
    }
}

fn figure(name: &str) -> Drawing {
    let solution = solved(&files::read(&format!("examples/{name}.json")));
    solution.expect("the example is sound").figure()
}

fn curves() -> Drawing {
    let Solution { scene, mechanism, pose, .. } = solved(&files::read("examples/figure-2.json")).expect("a good scene");
    let drive = Drive::new(&mechanism, None).expect("it has a drive");
    let mut path = Path::new(&mechanism, &pose, drive).expect("it is not singular");
    let range = path.cover(None, None).expect("it moves");
    let names = ["omega(4)", "alpha(4)", "v_r(3/2)"].map(str::to_owned);
    let curves = Curves::new(&path, range, Some(&names)).expect("known quantities");
    drawing::curves(&scene, &curves, None).expect("it fits")
}

/// The numbers that the paper prints, over the figure that they belong to; and their table.
fn checked() -> [Drawing; 2] {
    let solution = solved(&files::read("examples/figure-2.json"));
    let mut solution = solution.expect("the example is sound");
    let measured = Measured::read_json(&files::read("examples/paper-as-student.json"));
    let measured = measured.expect("the example is sound");
    let own = {
        // As deep as the program looks.
        let drawn = answer_key(&solution, 5);
        let checked = check(&measured, &drawn).expect("values that are understood");
        redrawn(&measured, &drawn, &checked).expect("scales are there")
    };
    let figure = &mut solution.scene.figure;
    figure.mu = PerSheet::from_fn(|sheet| Some(if sheet == Sheet::Scheme { 5.0 } else { 2.5 }));
    let sheets = drawing::overlay(&solution, &own);
    sheets.try_into().expect("a figure and a table")
}

/// The figures by their names in `out`.
fn figures() -> [(&'static str, Drawing); 5] {
    let [checked, values] = checked();
    [
        ("figure-1", figure("figure-1")),
        ("figure-2", figure("figure-2")),
        ("figure-2-curves", curves()),
        ("paper-as-student-check", checked),
        ("paper-as-student-check-values", values),
    ]
}

#[test]
fn examples_name_the_schema_and_fit_it() {
    // The schema's own rules are those of the reader; here only that every example reads and points to it.
    let mut seen = 0;
    for (name, text) in files::scenes("examples") {
        assert!(text.contains("\"$schema\": \"../templates/scene.schema.json\""), "{name}");
        Scene::read(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
        seen += 1;
    }
    assert!(seen >= 3);
}

#[test]
fn figures_are_redrawn_to_the_byte() {
    for (name, drawing) in figures() {
        same(&format!("out/{name}.svg"), &drawing.svg());
    }
}

/// All files of a folder of the repository by their paths from its root, without those that the workbench is not made of.
fn sources_in(folder: &str) -> Vec<String> {
    let left_out = ["web/node_modules", "web/component", "src/cli", "src/main.rs", "templates/workbench.html"];
    let inside = files::list(folder).into_iter().map(|name| format!("{folder}/{name}"));
    let kept = inside.filter(|path| !left_out.contains(&path.as_str()));
    let all = kept.flat_map(|path| if files::path(&path).is_dir() { sources_in(&path) } else { vec![path] });
    all.collect()
}

/// The hash of all that the workbench is made of, as web/README.md defines it and `node web/sources.mjs` prints it.
fn sources() -> String {
    let hash = |bytes: &[u8]| Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect::<String>();
    let mut paths = ["Cargo.lock", "Cargo.toml"].map(str::to_owned).to_vec();
    paths.extend(["src", "templates", "web"].into_iter().flat_map(sources_in));
    paths.extend(sources_in("examples").into_iter().filter(|path| path.ends_with(".json")));
    paths.sort();
    let line = |path: &String| {
        let bytes = std::fs::read(files::path(path)).expect("it can be read");
        format!("{}  {path}\n", hash(&bytes))
    };
    hash(paths.iter().map(line).collect::<String>().as_bytes())
}

#[test]
fn the_workbench_is_made_of_the_sources_that_are_here() {
    let page = files::read("templates/workbench.html");
    let (_, rest) = page.split_once("<meta name=\"kinegon-sources\" content=\"").expect("it says what it was made of");
    let (made_of, _) = rest.split_once('"').expect("its end");
    assert_eq!(made_of, sources(), "templates/workbench.html was made of other sources: run web/build");
}

/// What stands between two marks of a text, the first of which is the first there.
fn between<'t>(text: &'t str, from: &str, to: &str) -> &'t str {
    let (_, rest) = text.split_once(from).unwrap_or_else(|| panic!("the page has no {from}"));
    rest.split_once(to).unwrap_or_else(|| panic!("no {to} after {from}")).0
}

/// Who changes the page's script or its engine by hand, or by a disk that is broken, is told.
#[test]
fn the_workbench_consists_of_what_it_says() {
    let page = files::read("templates/workbench.html");
    let packed = ["style", "script", "worker", "engine"];
    let packed = packed.map(|id| between(&page, &format!("<script type=\"text/plain\" id=\"{id}\">"), "</script>"));
    let boot = between(&page, "<script>", "</script>");
    let contents = [&packed[..], &[boot]].concat().join("\n");
    let hash: String = Sha256::digest(contents.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(between(&page, "<meta name=\"kinegon-contents\" content=\"", "\""), hash, "run web/build");
}

#[test]
fn the_workbench_is_small() {
    let page = files::read("templates/workbench.html");
    assert!(page.len() <= 3_010_000, "{} bytes", page.len());
}

#[test]
fn the_gallery_is_current_and_complete() {
    let made = gallery::files().expect("every scene can be drawn");
    for (name, text) in made.iter().filter(|(name, _)| name.ends_with(".svg")) {
        resvg::usvg::roxmltree::Document::parse(text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    for (path, text) in &made {
        same(path, text);
    }
    let is_shown = |name: &str| {
        let picture = format!("docs/gallery/{name}");
        made.iter().any(|(path, _)| *path == picture)
    };
    for (name, _) in files::templates() {
        assert!(is_shown(&format!("{name}.svg")), "{name} is not in the gallery");
    }
    for name in files::list("docs/gallery") {
        assert!(is_shown(&name), "{name} is not made any more");
    }
}

#[test]
fn pictures_are_redrawn_within_one_level_per_channel() {
    fn pixels(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
        let size = reader.output_buffer_size().expect("a size that fits");
        let mut data = vec![0; size];
        let info = reader.next_frame(&mut data).expect("a frame");
        (info.width, info.height, data)
    }
    for (name, drawing) in figures() {
        let there = std::fs::read(files::path(&format!("out/{name}.png"))).expect("it is there");
        let now = drawing.png(100.0).expect("a picture");
        let ((w, h, a), (x, y, b)) = (pixels(&there), pixels(&now));
        assert_eq!((w, h), (x, y), "{name}");
        let worst = a.iter().zip(&b).map(|(a, b)| a.abs_diff(*b)).max();
        if worst > Some(1) {
            let left = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
            std::fs::write(&left, &now).expect("the test's folder can be written");
            panic!("out/{name}.png differs by up to {worst:?} levels: see {}", left.display());
        }
    }
}
