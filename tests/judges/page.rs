//! The page for the classroom: one file that needs nothing else, the same marks as the SVG, steps and motion in a real browser.

use crate::support::browser::Browser;
use crate::support::files;
use crate::support::program::{kinegon, scratch, stderr};
use crate::support::stages::solved;
use base64::Engine;
use flate2::read::GzDecoder;
use kinegon::cycle::Drive;
use serde_json::Value;
use std::collections::BTreeSet;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Writes the page of a scene.
fn page(scene: &str, folder: &Path, arguments: &[&str]) -> PathBuf {
    let file = folder.join("page.html");
    let mut command = kinegon();
    command.args(["draw", scene, "-o"]).arg(&file);
    let output = command.args(arguments).output().expect("it runs");
    assert!(output.status.success(), "{scene}: {}", stderr(&output));
    file
}

/// What the page's script reads.
fn film(page: &str) -> Value {
    let (_, rest) = page.split_once("<script id=\"data\"").expect("data");
    let (_, rest) = rest.split_once('>').expect("data");
    let (data, _) = rest.split_once("</script>").expect("its end");
    let decoder = base64::prelude::BASE64_STANDARD.decode(data.trim());
    let mut text = String::new();
    let mut unpacked = GzDecoder::new(decoder.as_deref().expect("base64"));
    unpacked.read_to_string(&mut text).expect("gzip of UTF-8");
    serde_json::from_str(&text).expect("JSON")
}

/// All lines of a position that the page can show there.
fn lines(film: &Value, frame: usize) -> BTreeSet<&str> {
    let layers = film["frames"][frame].as_array().expect("layers");
    let indices = layers.iter().flat_map(|l| l.as_array().expect("lines"));
    let line = |index: &Value| film["lines"][index.as_u64().expect("an index") as usize].as_str();
    indices.map(|i| line(i).expect("a line")).collect()
}

#[test]
fn a_page_needs_nothing_else_and_shows_what_the_svg_shows() {
    let folder = scratch("page-alone");
    for (name, text) in files::scenes("templates") {
        let scene = folder.join("scene.json");
        std::fs::write(&scene, &text).expect("it can be written");
        let scene = scene.to_str().expect("UTF-8");
        let file = page(scene, &folder, &["--positions", "5"]);
        let page = std::fs::read_to_string(file).expect("UTF-8");
        for outside in ["http:", "https:", "src=", "@import", "url("] {
            let own = page.replace("http://www.w3.org/2000/svg", "");
            assert!(!own.contains(outside), "{name}: {outside}");
        }
        // Of these the fonts are 115 000.
        assert!(page.len() < 365_000, "{name}: {} bytes", page.len());
        let film = film(&page);
        let frames = film["frames"].as_array().expect("frames").len();
        assert_eq!(film["values"].as_array().expect("values").len(), frames);
        let solution = solved(&text).expect("a good scene");
        let moves = Drive::new(&solution.mechanism, None).is_ok();
        let wanted = if moves { 4..=6 } else { 1..=1 };
        assert!(wanted.contains(&frames), "{name}: {frames} positions");
        // The finished figure of the scene's own position is drawn by marks that the page has too, but for the scales of its panels.
        let own = film["own"].as_u64().expect("an index") as usize;
        let shown = lines(&film, own);
        let count =
            solution.construction.scheme.len() + solution.construction.plans().map(|p| p.steps.len()).sum::<usize>();
        assert_eq!(film["steps"].as_array().expect("steps").len(), count, "{name}");
        let ids = |text: &str| -> BTreeSet<String> {
            let ids = text.split(" id=\"").skip(1);
            ids.map(|rest| rest[..rest.find('"').expect("its end")].to_owned()).collect()
        };
        let finished = ids(&solution.stepwise_figure().after_step(count + 1).svg());
        let on_page: BTreeSet<String> = shown.iter().flat_map(|line| ids(line)).collect();
        // At another scale points may share a name.
        let shared = |id: &&String| id.contains("-point-") || id.contains("-label-");
        let missing = finished.difference(&on_page).filter(|id| !shared(id));
        let missing: Vec<&String> = missing.collect();
        assert!(missing.is_empty(), "{name}: {missing:?}");
    }
}

#[test]
fn what_it_cannot_show_is_said() {
    let folder = scratch("page-refused");
    let run = |arguments: &[&str]| {
        let mut command = kinegon();
        command.args(["draw", "examples/figure-2.json", "-o"]);
        let output = command.arg(&folder).args(arguments).output();
        let output = output.expect("it runs");
        (output.status.code(), stderr(&output))
    };
    for (arguments, code, words) in [
        (vec!["--format", "html", "--steps"], 2, "leave out --steps"),
        (vec!["--format", "html", "--drive", "7"], 2, "no drive `7`"),
        (vec!["--format", "html", "--positions", "0"], 2, "1..=1440"),
    ] {
        let (exit, said) = run(&arguments);
        assert_eq!(exit, Some(code), "{arguments:?}: {said}");
        assert!(said.contains(words), "{arguments:?}: {said}");
    }
    let left = std::fs::read_dir(&folder).expect("it is there").count();
    assert_eq!(left, 0, "a refused command wrote a file");
    // A drawn configuration has one position and no crank.
    let file = page("examples/figure-1.json", &folder, &[]);
    let film = film(&std::fs::read_to_string(file).expect("UTF-8"));
    assert_eq!(film["frames"].as_array().map(Vec::len), Some(1));
}

/// Loads, steps, drags, plays, zooms, turns dark; no error on the way.
#[test]
fn it_works_in_a_browser() {
    let folder = scratch("page-browser");
    let file = page("examples/figure-2.json", &folder, &[]);
    let Some(mut browser) = Browser::start(&folder.join("profile"), [1280, 800]) else {
        return;
    };
    browser.open(&file, "document.documentElement?.dataset.ready === 'yes'");
    let count = browser.value("film.steps.length").as_u64().expect("steps");
    assert_eq!(count, 42);
    assert_eq!(browser.value("by('value').textContent"), "70.0°");

    // Step by step by keys and buttons.
    browser.press("Home");
    assert_eq!(browser.value("state.step"), 1);
    for _ in 0..6 {
        browser.press("ArrowRight");
    }
    browser.click("forward");
    assert_eq!(browser.value("by('step').textContent"), "8 / 42");
    let said = browser.value("by('caption').textContent");
    assert_eq!(said, "Lay off the velocity of B, normal to AB, in the sense of ω_1.");
    let arrow = "document.getElementById('velocity-vector-p-b')";
    assert_eq!(browser.value(&format!("{arrow} !== null")), true);
    assert_eq!(
        browser.value(&format!("getComputedStyle({arrow}.querySelector('path')).stroke")),
        "rgb(196, 0, 160)",
        "what comes with a step has the accent colour"
    );
    // Letters stand where they were measured: the page has brought its fonts.
    for style in ["normal", "italic"] {
        let has = format!("[...document.fonts].some((f) => f.style === '{style}' && f.status === 'loaded')");
        assert_eq!(browser.value(&has), true, "{style}");
    }
    browser.press("ArrowLeft");
    assert_eq!(browser.value(&format!("{arrow} !== null")), false);
    // The senses of solved rates and the underlines of equations belong to their step alone, and have its accent.
    let solve = "film.steps.findIndex((text) => text.startsWith('Solve')) + 1";
    browser.value(&format!("goTo({solve})"));
    let strokes = "[...document.querySelectorAll('#sheet .now g[stroke] path')].map((p) => getComputedStyle(p).stroke)";
    assert_eq!(browser.value(&format!("{strokes}.includes('rgb(196, 0, 160)')")), true);
    assert_eq!(browser.value(&format!("{strokes}.includes('rgb(26, 26, 26)')")), false);
    // On a wide screen the figure fills the width or the height, and dragging marks no letters.
    let fills = "(() => { const [sheet, room] = ['sheet', 'main'].map((id) => by(id).getBoundingClientRect()); \
                 return sheet.width > room.width - 40 || sheet.height > innerHeight - 40; })()";
    assert_eq!(browser.value(fills), true);
    assert_eq!(browser.value("getComputedStyle(by('sheet')).userSelect"), "none");
    browser.click("last");
    assert_eq!(browser.value("state.step"), count + 1);
    assert_eq!(browser.value("document.querySelectorAll('.old, .new').length"), 0);

    // The crank by the mouse: the link's end follows.
    let end = "document.getElementById('scheme-link-1').getAttribute('d')";
    let (before, frame) = (browser.value(end), browser.value("state.frame"));
    let [x, y, width, _] = browser.place("crank");
    let share = browser.value("state.frame / (film.frames.length - 1)");
    let handle = x + (share.as_f64().expect("a number") - 0.5) * (width - 16.0);
    browser.drag([handle, y], [x - 0.3 * width, y]);
    assert_ne!(browser.value("state.frame"), frame, "the slider was dragged");
    assert_ne!(browser.value(end), before);
    let shown = browser.value("film.values[state.frame] === by('value').textContent");
    assert_eq!(shown, true);
    browser.click("home");
    assert_eq!(browser.value(end), before, "back in the scene's own position");

    // Panels, dark and light, printing.
    browser.value("document.querySelectorAll('#panels button')[2].click()");
    let zoomed = "by('sheet').viewBox.baseVal.width < film.width / 1.5 && !by('words').hidden";
    assert_eq!(browser.value(zoomed), true);
    // The words of a step stay readable beside a panel: px for a millimetre, of letters 3.5 mm high and more.
    browser.value("goTo(8)");
    let scale = browser.value("by('words').getBoundingClientRect().width / by('words').viewBox.baseVal.width");
    assert!(scale.as_f64().is_some_and(|scale| scale > 4.0), "{scale}");
    browser.value("goTo(film.steps.length + 1)");
    browser.value("window.dispatchEvent(new Event('beforeprint'))");
    assert_eq!(browser.value("by('sheet').viewBox.baseVal.width"), 297);
    browser.value("window.dispatchEvent(new Event('afterprint'))");
    assert_eq!(browser.value(zoomed), true);
    browser.value("document.querySelectorAll('#panels button')[0].click()");
    browser.value("dark(false)");
    browser.click("dark");
    let dark = "getComputedStyle(document.body).backgroundColor";
    assert_eq!(browser.value(dark), "rgb(14, 15, 17)");

    // Motion: how many pictures a second there are, and how long the script works for one.
    browser.value("document.activeElement.blur()");
    browser.press(" ");
    browser.until("state.playing");
    let counted = browser.value(
        "new Promise((done) => { const from = state.drawn, start = performance.now(); \
         setTimeout(() => done((state.drawn - from) / (performance.now() - start) * 1000), 3000); })",
    );
    browser.press(" ");
    browser.until("!state.playing");
    let work = browser.value(
        "(() => { const times = []; for (let k = 0; k < 60; k++) { const from = performance.now(); turnTo(k); \
         times.push(performance.now() - from); } return times.sort((a, b) => a - b)[30]; })()",
    );
    let [pictures, work] = [counted, work].map(|v| v.as_f64().expect("a number"));
    println!("{pictures:.0} pictures a second in software rendering, {work:.1} ms of script for each");
    assert!(pictures > 5.0, "it moves");
    assert_eq!(browser.errors, Vec::<String>::new());
}

#[test]
fn letters_can_be_outlines() {
    let folder = scratch("page-outlines");
    let file = page("templates/four-bar.json", &folder, &["--positions", "5", "--outlines"]);
    let page = std::fs::read_to_string(file).expect("UTF-8");
    let film = film(&page);
    assert!(!lines(&film, 0).iter().any(|line| line.contains("<text")));
    assert!(page.contains("<script id=\"fonts\" type=\"application/octet-stream\"></script>"));
}

/// On a telephone: nothing wider than the screen, buttons large enough for fingers.
#[test]
fn it_fits_a_telephone() {
    let folder = scratch("page-telephone");
    let file = page("templates/four-bar.json", &folder, &["--positions", "60"]);
    let Some(mut browser) = Browser::start(&folder.join("profile"), [500, 900]) else {
        return;
    };
    let metrics = serde_json::json!({ "width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": true });
    browser.call("Emulation.setDeviceMetricsOverride", metrics);
    browser.open(&file, "document.documentElement?.dataset.ready === 'yes'");
    assert_eq!(browser.value("document.documentElement.scrollWidth"), 390);
    let small = browser.value(
        "[...document.querySelectorAll('nav button')].filter((b) => b.getBoundingClientRect().height < 40).length",
    );
    assert_eq!(small, 0);
    assert_eq!(browser.value("by('caption').getBoundingClientRect().height > 20"), true);
    let inside =
        "by('stack').getBoundingClientRect().right <= 390 && by('print').getBoundingClientRect().bottom <= 844";
    assert_eq!(browser.value(inside), true);
    // The panels use the height that there is.
    let height = browser.value("by('stack').getBoundingClientRect().height");
    assert!(height.as_f64().is_some_and(|height| height > 400.0), "{height}");
    assert_eq!(browser.errors, Vec::<String>::new());
}
