//! A teacher after class: links, files, prints.

use super::bench::Bench;
use serde_json::json;
use support::files;
use support::program::with_scene;

const FIGURE: &str = "examples/figure-2.json";

/// A link as it stands behind the page's name.
fn link(bench: &mut Bench, shared: serde_json::Value) -> String {
    bench.text(&format!("kinegon.app.link({shared}).then((link) => link.slice(link.indexOf('#')))"))
}

#[test]
#[ignore = "needs Chromium"]
fn a_link_holds_the_scene() {
    let text = files::read("templates/whitworth.json").replace("\"title\": \"", "\"title\": \"Ω <b> & ");
    let mut bench = Bench::open("link");
    let hash = link(&mut bench, json!({ "text": text, "view": { "step": 5, "coarse": false, "modes": false } }));
    assert!(hash.starts_with("#1=") && hash.len() < 2_500, "{} letters", hash.len());
    bench.load(&hash);
    assert_eq!(bench.scene(), text);
    assert_eq!(bench.value("kinegon.app.view.value.step"), 5);
    assert_eq!(bench.text("location.hash"), "", "the address is cleaned");
    // The button says how long it is.
    bench.panel("save");
    bench.press_named("#panel-save", "Copy the link");
    // It is packed before it is shown.
    let box_with_link = "[...document.querySelectorAll('#panel-save input')].find((e) => e.value.includes('#1='))";
    bench.until(&format!("{box_with_link} !== undefined"));
    let shown = bench.text(&format!("{box_with_link}.value"));
    let (_, own) = shown.split_once('#').expect("a link");
    bench.load(&format!("#{own}"));
    assert_eq!(bench.scene(), text);
    bench.picture("save");
    bench.assert_quiet();
}

/// Back and forward go through the links that were opened; before the first stands what was there.
#[test]
#[ignore = "needs Chromium"]
fn back_and_forward_follow_links() {
    let mut bench = Bench::open("back");
    let texts = ["slider-crank", "whitworth"].map(|name| files::read(&format!("templates/{name}.json")));
    let links = texts.each_ref().map(|text| link(&mut bench, json!({ "text": text })));
    let begun = files::read("templates/five-bar.json");
    bench.value(&format!("kinegon.app.open({})", json!(begun)));
    let mut goes_to = |go: &str, text: &str| {
        bench.value(go);
        bench.until(&format!("kinegon.history.now.value.text === {}", json!(text)));
        assert_eq!(bench.text("location.hash"), "", "the address is cleaned");
    };
    for (link, text) in links.iter().zip(&texts) {
        goes_to(&format!("location.hash = {}", json!(link)), text);
    }
    for (go, text) in [("back", &texts[0]), ("back", &begun), ("forward", &texts[0]), ("forward", &texts[1])] {
        goes_to(&format!("history.{go}()"), text);
    }
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn saved_files_are_those_of_the_program() {
    let mut bench = Bench::open("saved");
    let text = files::read(FIGURE);
    bench.put(&text);
    bench.panel("save");
    for (button, ending, arguments) in [
        ("Figure as SVG", ".svg", &["draw", "-", "-o", "-"][..]),
        ("Figure as TikZ", ".tex", &["draw", "-", "-o", "-", "--format", "tikz"]),
        ("Figure as PDF", ".pdf", &["draw", "-", "-o", "-", "--format", "pdf"]),
        ("Figure as PNG", ".png", &["draw", "-", "-o", "-", "--format", "png", "--width", "1920"]),
        ("Motion over the cycle", ".csv", &["sweep", "-"]),
        ("Results", ".json", &["solve", "-"]),
    ] {
        let (name, saved) = bench_saved(&mut bench, button);
        assert!(name.ends_with(ending), "{button}: {name}");
        let printed = with_scene(arguments, text.as_bytes()).stdout;
        if ending == ".png" {
            // The browser draws it; the picture has the size of the program's of that width.
            assert_eq!(png_size(&saved), png_size(&printed), "{button}");
        } else {
            assert!(saved == printed, "{button}: other bytes than the program's");
        }
    }
    let (name, saved) = bench_saved(&mut bench, "Scene file");
    assert!(name.ends_with(".json") && saved == text.as_bytes());
    // The page with the scene in it is a workbench again.
    let (_, page) = bench_saved(&mut bench, "This page with the scene");
    let file = bench.folder().join("again.html");
    std::fs::write(&file, page).expect("written");
    bench.open(&file, super::bench::READY);
    bench.settle();
    assert_eq!(bench.scene(), text);
    bench.assert_quiet();
}

fn bench_saved(bench: &mut Bench, button: &str) -> (String, Vec<u8>) {
    bench.value(&format!(
        "(() => {{ document.querySelectorAll('[data-saves]').forEach((e) => delete e.dataset.saves); \
         [...document.querySelectorAll('#panel-save button')].find((e) => \
         (e.getAttribute('aria-label') ?? e.textContent).startsWith({})).dataset.saves = ''; }})()",
        json!(button)
    ));
    bench.saved(|browser| browser.click("[data-saves]"))
}

/// Side lengths of each page in mm.
pub fn papers(pdf: &[u8]) -> Vec<[f64; 2]> {
    let pdf = lopdf::Document::load_mem(pdf).expect("PDF");
    let sides = |id| -> [f64; 2] {
        let page: &lopdf::Dictionary = pdf.get_dictionary(id).expect("a page");
        let found = page.get(b"MediaBox").and_then(lopdf::Object::as_array).expect("a box");
        let side = |k: usize| f64::from(found[k].as_float().expect("a number")) / 72.0 * 25.4;
        [side(2) - side(0), side(3) - side(1)]
    };
    pdf.get_pages().into_values().map(sides).collect()
}

#[test]
#[ignore = "needs Chromium"]
fn a_print_has_its_true_size() {
    let mut bench = Bench::open("print");
    bench.put(&files::read(FIGURE));
    bench.value("window.print = () => { window.asked = true; }");
    bench.panel("save");
    bench.until_drawn("#panel-save .preview");
    bench.press_named("#panel-save", "Print …");
    bench.until("window.asked === true");
    bench.media("print", &[]);
    let size = bench.number("document.querySelector('#print svg').getBoundingClientRect().width / 96 * 25.4");
    assert!((size - 297.0).abs() < 0.2, "{size} mm");
    bench.media("", &[]);
    let found = papers(&bench.printed());
    assert_eq!(found.len(), 1);
    let [width, height] = found[0];
    assert!((width - 297.0).abs() < 0.6 && (height - 210.0).abs() < 0.6, "{width} mm × {height} mm");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn values_and_curves_stand_beside_the_figure() {
    let mut bench = Bench::open("curves");
    bench.panel("values");
    bench.until("document.querySelectorAll('#panel-values tr').length > 10");
    let printed = with_scene(&["solve", "-", "--digits"], bench.scene().as_bytes()).stdout;
    let printed = String::from_utf8(printed).expect("UTF-8");
    let rows = bench.ask("values", &[json!(files::read(FIGURE))]);
    let rows = rows.as_array().expect("rows");
    for row in rows {
        let value = row["value"].as_str().expect("digits");
        assert!(printed.contains(value), "{row}");
    }
    bench.picture("values");
    bench.panel("curves");
    bench.until_drawn("#below");
    bench.settle();
    bench.picture("curves");
    bench.assert_quiet();
}

/// The middle of the ring on a path, and of the point where the path was drawn, in mm of the drawing.
const RING: &str = "(() => { const drawing = document.querySelector('#below .drawn').shadowRoot; \
    const [, x, y, radius] = /^M([-\\d.]+) ([-\\d.]+)a([-\\d.]+)/.exec(drawing.querySelector('path[aria-hidden]').getAttribute('d')).map(Number); \
    const own = drawing.querySelector('[id=path-a-own]'); return [x + radius, y, +own.getAttribute('cx'), +own.getAttribute('cy')]; })()";

#[test]
#[ignore = "needs Chromium"]
fn a_path_is_in_the_picture_and_followed_along_its_curve() {
    let mut bench = Bench::of("path", &files::read("templates/four-bar.json"));
    bench.panel("curves");
    let traced = "document.querySelectorAll('#sheet [id^=scheme-path-]').length";
    assert_eq!(bench.number(traced), 0.0, "curves of ω are about no point");
    bench.click("#panel-curves .one-of label:nth-of-type(3)");
    bench.settle();
    bench.until_drawn("#below");
    bench.settle();
    assert_eq!(bench.number(traced), 1.0);
    let ring: [f64; 4] = serde_json::from_value(bench.value(RING)).expect("four numbers");
    assert!(libm::hypot(ring[0] - ring[2], ring[1] - ring[3]) < 0.02, "{ring:?}");
    // It goes with the drive, and the curve is drawn anew from there.
    bench.focus("#drive-1");
    bench.press("PageUp");
    bench.until(&format!("(([x, y, u, v]) => u !== {} && Math.hypot(x - u, y - v) < 0.05)({RING})", ring[2]));
    bench.picture("path");
    bench.panel("values");
    assert_eq!(bench.number(traced), 0.0, "it goes with the curves");
    bench.assert_quiet();
}

/// Width and height of a PNG in pixels.
fn png_size(bytes: &[u8]) -> (u32, u32) {
    let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
    reader.info().size()
}
