//! The first minutes: what letters mean, links in rows, refusals in the page's language, a sheet on a telephone, edges that are seen.

use super::bench::Bench;
use serde_json::{Value, json};
use support::files;

/// The pointer rests at the middle of an element.
fn rest(bench: &mut Bench, selector: &str) {
    let [x, y, ..] = bench.place(selector);
    bench.call(
        "Input.dispatchMouseEvent",
        json!({ "type": "mouseMoved", "x": x, "y": y, "button": "none", "buttons": 0 }),
    );
}

const MEANING: &str =
    "(document.querySelector('#meaning').hidden ? '' : document.querySelector('#meaning').textContent)";

#[test]
#[ignore = "needs Chromium"]
fn letters_of_the_picture_say_what_they_mean() {
    let mut bench = Bench::open("letters");
    bench.choose("#language", "English");
    for (label, told) in [
        ("velocity-label-b-", "the velocity of B"),
        ("velocity-label-p-", "all velocities begin here"),
        ("acceleration-label-pi-", "all accelerations begin here"),
        ("acceleration-label-n_g5-", "the end of a normal part"),
        ("scheme-label-S3", "the special point of link 3"),
        ("velocity-label-s5-", "the image of the special point of link 5"),
    ] {
        rest(&mut bench, &format!("#{label}"));
        bench.until(&format!("{MEANING}.includes({})", json!(told)));
    }
    // d₂ stands alone or behind names of the same place.
    let under =
        bench.text("[...document.querySelectorAll('#sheet text')].find((text) => text.textContent.includes('d2')).id");
    rest(&mut bench, &format!("#{under}"));
    bench.until(&format!("{MEANING}.includes('of link 2 that lies under D')"));
    bench.picture("meaning");
    // What moves says nothing of itself, and keys put the words away.
    bench.press("Escape");
    assert_eq!(bench.text(MEANING), "");
    bench.telephone([390, 844]);
    bench.settle();
    bench.tap("#velocity-label-p-");
    bench.until(&format!("{MEANING}.includes('the pole')"));
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_link_is_a_row_that_opens_for_the_rest() {
    let mut bench = Bench::of("rows", &files::read("templates/four-bar.json"));
    bench.screen([1440, 900], 1.0);
    bench.panel("mechanism");
    bench.settle();
    // Of a template nothing has to be scrolled to.
    let [form, room] = ["#panel-mechanism", "#panels"].map(|part| {
        bench.number(&format!(
            "document.querySelector('{part}').{}",
            if part == "#panels" { "clientHeight" } else { "scrollHeight" }
        ))
    });
    assert!(form <= room, "the form is {form} px high, its panel {room}");
    let row = "[data-path=\"links.2\"]";
    let chips = format!("document.querySelectorAll('{row} .chip').length");
    assert_eq!(bench.number(&chips), 0.0);
    bench.click(&format!("{row} .more"));
    assert_eq!(bench.number(&chips), 2.0);
    assert_eq!(bench.value(&format!("document.activeElement.matches('{row} .more[aria-expanded=true]')")), true);
    // It stays open while its numbers change.
    bench.fill("[data-path=\"links.2.lengths.BC\"] input", "125");
    bench.settle();
    assert_eq!(bench.at("/links/2/lengths/BC"), 125);
    assert_eq!(bench.number(&chips), 2.0);
    bench.click(&format!("{row} .more"));
    assert_eq!(bench.number(&chips), 0.0);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn what_is_wrong_is_said_in_the_pages_language() {
    let mut bench = Bench::of("wrong", &files::read("templates/four-bar.json"));
    bench.choose("#language", "Español");
    let scene = |change: &dyn Fn(&mut Value)| {
        let mut scene: Value = serde_json::from_str(&files::read("templates/four-bar.json")).expect("JSON");
        change(&mut scene);
        scene.to_string()
    };
    bench.put(&scene(&|scene| scene["links"]["2"]["lengths"]["BC"] = 1.into()));
    bench.until("document.querySelector('#message').textContent.includes('no se pueden montar')");
    assert!(bench.message().contains("tendría que ser"), "{}", bench.message());
    bench.put(&scene(&|scene| scene["links"]["2"]["lenghts"] = json!({})));
    bench.until("document.querySelector('#message').textContent.includes('clave desconocida')");
    // A warning: nothing chooses the assembly.
    bench.put(&scene(&|scene| {
        scene.as_object_mut().expect("an object").remove("near");
    }));
    bench.until("document.querySelector('#warnings').textContent.includes('se pueden montar de 2 maneras')");
    // The same in the other language, without the scene being touched.
    bench.choose("#language", "English");
    bench.until("document.querySelector('#warnings').textContent.includes('can be assembled in 2 ways')");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_sheet_is_read_on_a_telephone() {
    let mut bench = Bench::of("sheet", &files::read("templates/four-bar.json"));
    bench.telephone([390, 844]);
    let link = bench.text(
        "(async () => { const k = (await kinegon.engine.kinds()).find((k) => k.name === 'four-bar'); \
         const options = { page: null, language: null, notation: null, decimal: null }; \
         const e = await kinegon.engine.exercise(k.text, 'four-bar', 7, 1, options); \
         return kinegon.app.link({ text: e.text, form: e.form, panel: 'check', student: true, \
           task: { name: 'four-bar', text: '', seed: 7, number: 1, options, steps: false, more: false } }); })()",
    );
    let behind = link.split_once('#').map_or("", |(_, behind)| behind);
    bench.load(&format!("#{behind}"));
    bench.until("document.querySelector('#panel-check .task svg') !== null");
    bench.click("#panel-check .task .sheet");
    bench.until("document.body.classList.contains('reading')");
    bench.until("document.querySelectorAll('#sheet text').length > 20");
    bench.settle();
    bench.picture("sheet-read");
    // Letters but indices have at least 11 pixels.
    let least = bench.number(
        "Math.min(...[...document.querySelectorAll('#sheet text')].map((t) => t.getAttribute('font-size') * t.getScreenCTM().a))",
    );
    assert!(least >= 11.0, "letters of {least} px");
    bench.click("#pane .back:not([hidden])");
    bench.until("!document.body.classList.contains('reading')");
    bench.settle();
    // The scheme is there again, as wide as the screen.
    let wide = bench.number("kinegon.app.picture.value.width * document.querySelector('#sheet').getScreenCTM().a");
    assert!(wide > 360.0, "{wide}");
    bench.assert_quiet();
}

/// Contrast of the borders of all controls that are seen, with what is around them.
const EDGES: &str = r"(() => {
  const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  const rgba = (c) => { canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = c; canvas.fillRect(0, 0, 1, 1); const d = canvas.getImageData(0, 0, 1, 1).data; return [d[0], d[1], d[2], d[3] / 255]; };
  const over = (a, b) => [0, 1, 2].map((i) => a[i] * a[3] + b[i] * (1 - a[3])).concat(1);
  const part = (v) => ((v /= 255) <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4);
  const light = ([r, g, b]) => .2126 * part(r) + .7152 * part(g) + .0722 * part(b);
  const ratio = (a, b) => { const [x, y] = [light(a), light(b)].sort((p, q) => q - p); return (x + .05) / (y + .05); };
  const ground = (e) => { const all = []; for (let n = e; n; n = n.parentElement) all.push(rgba(getComputedStyle(n).backgroundColor)); return all.reverse().reduce((under, c) => over(c, under), [255, 255, 255, 1]); };
  return [...document.querySelectorAll('input:not([type=range], [type=radio], [type=checkbox], [type=file]), select, textarea, button, summary, .adder')].flatMap((e) => {
    const box = e.getBoundingClientRect();
    const style = getComputedStyle(e);
    const edge = rgba(style.borderBottomColor);
    if (box.width < 2 || !e.checkVisibility({ visibilityProperty: true, opacityProperty: true }) || edge[3] < .05) return [];
    if (parseFloat(style.borderBottomWidth) === 0 || style.borderBottomStyle === 'none') {
      return e.matches('input, textarea') && !e.closest('.adder') ? [`${e.id}.${e.className}: no edge`] : [];
    }
    const around = ground(e.parentElement);
    const is = ratio(over(edge, around), around);
    return is < 3 ? [`${e.localName}#${e.id}.${e.className} ${e.textContent.slice(0, 20)}: ${is.toFixed(2)}`] : [];
  });
})()";

#[test]
#[ignore = "needs Chromium"]
fn edges_of_controls_are_seen() {
    let mut bench = Bench::open("edges");
    for theme in ["light", "dark"] {
        bench.media("", &[("prefers-color-scheme", theme), ("prefers-reduced-motion", "reduce")]);
        for panel in ["mechanism", "text", "figure", "values", "curves", "modes", "check", "exercise", "save"] {
            bench.value(&format!("kinegon.app.show('{panel}')"));
            bench.settle();
            bench.value("document.querySelectorAll('.more[aria-expanded=false]').forEach((more) => more.click())");
            let faint = bench.value(EDGES);
            assert_eq!(faint, json!([]), "{theme}, {panel}");
        }
    }
    bench.assert_quiet();
}
