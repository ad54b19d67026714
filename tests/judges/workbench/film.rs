//! The browser records a turn of the drive.

use super::bench::Bench;
use std::collections::BTreeMap;
use support::browser::Browser;
use support::files;
use support::program::scratch;

/// Whether the film in the page can be played to its end; and how wide it is, and how much ink its last picture has.
const PLAYED: &str = "(async () => { const video = document.querySelector('video'); video.muted = true; \
    await video.play(); await new Promise((done) => (video.ontimeupdate = () => video.currentTime > 1 && done())); \
    const canvas = Object.assign(document.createElement('canvas'), { width: video.videoWidth, height: video.videoHeight }); \
    const context = canvas.getContext('2d'); context.drawImage(video, 0, 0); \
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height); \
    let dark = 0; for (let at = 0; at < data.length; at += 4) dark += data[at] < 128; \
    return [video.videoWidth, video.currentTime, dark]; })()";

#[test]
#[ignore = "needs Chromium"]
fn a_turn_is_filmed_and_can_be_played() {
    let mut bench = Bench::of("film", &files::read("templates/four-bar.json"));
    bench.panel("save");
    let before = bench.marks();
    let (name, film) = bench.saved(|bench| bench.click("#film"));
    assert_eq!(name, "four-bar-linkage.webm");
    assert!(film.starts_with(&[0x1a, 0x45, 0xdf, 0xa3]) && film.len() > 50_000, "{} bytes of Matroska", film.len());
    bench.settle();
    assert_eq!(bench.marks(), before, "all is put back");
    assert_eq!(bench.value("kinegon.history.canUndo.value"), false, "and nothing is changed");
    assert_eq!(bench.value("document.querySelector('#film').disabled"), false);
    bench.assert_quiet();
    let mut browser = Browser::start(&scratch("film-played"), [800, 600]);
    let page = b"<video src='film.webm' preload='auto'></video>".to_vec();
    let served = BTreeMap::from([("film.html".to_owned(), page), ("film.webm".to_owned(), film)]);
    browser.visit(served, "film.html", "document.querySelector('video')?.readyState >= 2");
    let played = browser.value(PLAYED);
    let [width, end, ink] = [0, 1, 2].map(|index| played[index].as_f64().expect("a number"));
    assert!(width == 1280.0 && end > 1.0 && ink > 2000.0, "{played}");
}

/// Whatever happens while it is recorded is told once; then everything can be done again.
#[test]
#[ignore = "needs Chromium"]
fn a_film_that_is_broken_off_says_why() {
    let mut bench = Bench::of("film-broken", &files::read("templates/four-bar.json"));
    bench.panel("save");
    bench.value("(window.told = [])");
    bench.value("new MutationObserver(() => { const said = document.querySelector('#said').textContent; if (said) window.told.push(said); }).observe(document.querySelector('#said'), { childList: true })");
    let edited = files::read("templates/four-bar.json").replace("\"AB\": 60", "\"AB\": 55");
    let hide = "(Object.defineProperty(document, 'hidden', { get: () => true, configurable: true }), document.dispatchEvent(new Event('visibilitychange')))";
    for (what, act, said) in [
        ("changed", format!("kinegon.app.open({})", serde_json::json!(edited)), "moved or changed"),
        ("typed", "kinegon.history.change({ text: '{' })".to_owned(), "moved or changed"),
        ("undone", "kinegon.history.undo()".to_owned(), ""),
        ("hidden", hide.to_owned(), "not in sight"),
        ("seen", "delete document.hidden".to_owned(), ""),
    ] {
        bench.value("window.told = []");
        if said.is_empty() {
            bench.value(&act);
            bench.settle();
            continue;
        }
        // The second click is one too many, and makes no second film.
        bench.click("#film");
        bench.click("#film");
        bench.until("document.querySelector('#film').disabled && kinegon.frames.length > 0");
        bench.value("new Promise((done) => setTimeout(done, 400))");
        bench.value(&act);
        bench.until("!document.querySelector('#film').disabled");
        bench.settle();
        let told = bench.value("window.told.filter((text) => text.includes('film'))");
        assert_eq!(told.as_array().map(Vec::len), Some(1), "{what}: {told}");
        assert!(told[0].as_str().is_some_and(|text| text.contains(said)), "{what}: {told}");
        assert_eq!(bench.value("document.querySelector('#play').ariaPressed"), "false", "{what}");
    }
    assert!(bench.scene().contains("\"AB\": 55"), "what was changed stays");
    bench.assert_quiet();
}

/// What does not move has no film.
#[test]
#[ignore = "needs Chromium"]
fn a_drawn_configuration_is_not_filmed() {
    let mut bench = Bench::of("no-film", &files::read("examples/figure-1.json"));
    bench.panel("save");
    assert_eq!(bench.value("document.querySelector('#film').disabled"), true);
    bench.assert_quiet();
}
