//! How long people wait: opening, dragging. Limits are wide, as tests run beside each other; what was measured is printed.

use super::bench::Bench;
use super::hostile::row;
use serde_json::{Value, json};
use support::files;

/// Notes when the first picture stands.
const FIRST: &str = "new MutationObserver((_, watch) => { if (document.querySelector('#sheet path')) { \
    requestAnimationFrame(() => (window.firstPicture ??= performance.now())); watch.disconnect(); } }) \
    .observe(document, { subtree: true, childList: true })";

#[test]
#[ignore = "needs Chromium"]
fn it_opens_at_once_from_a_file_without_a_network() {
    let mut bench = Bench::closed("opens", None);
    bench.call("Page.addScriptToEvaluateOnNewDocument", json!({ "source": FIRST }));
    let mut first = f64::INFINITY;
    for _ in 0..2 {
        bench.load("");
        first = first.min(bench.number("window.firstPicture"));
    }
    println!("first picture after {first:.0} ms");
    assert!(first < 3_000.0, "{first} ms");
    assert!(!bench.text("document.querySelector('#title').textContent").is_empty());
    assert_eq!(bench.value("document.fonts.size >= 2"), true, "the page has brought its letters");
    bench.picture("opened");
    bench.assert_quiet();
    let size = std::fs::metadata(bench.folder().join("kinegon.html")).expect("it is there").len();
    println!("{size} bytes");
    assert!(size <= 3_010_000);
}

/// Goes round with a joint for a second or two; the 95th percentile of the engine's share, of the page's, of the whole, in ms.
fn drag(bench: &mut Bench, joint: &str, radius: f64) -> [f64; 3] {
    let [x, y] = bench.joint(joint);
    bench.value("kinegon.frames.length = 0");
    bench.take_hold([x, y]);
    bench.frame();
    for k in 0..50 {
        let angle = 0.1 * f64::from(k);
        bench.pull([x + radius * (libm::cos(angle) - 1.0), y - radius * libm::sin(angle)]);
        bench.frame();
    }
    bench.let_go([x, y]);
    bench.settle();
    let count = bench.number("kinegon.frames.length");
    assert!(count > 10.0, "{count} pictures");
    ["engine", "page", "total"].map(|part| {
        bench.number(&format!(
            "kinegon.frames.map((f) => f.{part}).sort((a, b) => a - b)[Math.floor(0.95 * kinegon.frames.length)]"
        ))
    })
}

#[test]
#[ignore = "needs Chromium"]
fn the_picture_follows_the_hand() {
    let mut bench = Bench::open("drag");
    let jansen = files::read("tests/lecture/jansen.json");
    let mut centers: Value = serde_json::from_str(&files::read("examples/figure-2.json")).expect("JSON");
    centers["figure"] = json!({ "panels": ["scheme", "centers"], "centers": "all" });
    for (name, text, joint) in [
        ("Figure 2", None, "B"),
        ("Figure 2 with all centres", Some(centers.to_string()), "B"),
        ("Jansen", Some(jansen), "B"),
        ("41 links", Some(row(20)), "B"),
    ] {
        if let Some(text) = text {
            bench.put(&text);
        }
        let [engine, page, total] = drag(&mut bench, joint, 40.0);
        println!(
            "{name}, p95 of a picture: {engine:.1} ms of engine, {page:.1} ms of page, {total:.1} ms from hand to picture"
        );
        // Of so many links most is the search for places of names.
        let most = if name == "41 links" { [400.0, 900.0] } else { [60.0, 400.0] };
        assert!(engine < most[0] && total < most[1], "{name}: {engine} ms, {total} ms");
    }
    bench.assert_quiet();
}
