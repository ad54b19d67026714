//! On a telephone: nothing wider than the screen, targets for fingers, joints and pictures under them.

use super::bench::Bench;

/// Visible controls that are lower or narrower than a finger's 44 px; those of lines of text are excepted.
const SMALL: &str = "[...document.querySelectorAll('button, select, input:not([type=checkbox]):not([type=radio]), summary')] \
    .map((e) => [e, e.getBoundingClientRect()]) \
    .filter(([e, r]) => r.width > 0 && !e.matches('.handle, .cm-editor *') && (r.height < 43.5)) \
    .map(([e, r]) => `${e.id || e.className || e.tagName}: ${Math.round(r.width)}×${Math.round(r.height)}`)";

/// The place of the picture farthest from all joints.
const FAR: &str = "(() => { const { left, top, width, height } = document.querySelector('#pane').getBoundingClientRect(); \
    const joints = [...document.querySelectorAll('.handle')].map((e) => e.getBoundingClientRect()).map((r) => [r.x + r.width / 2, r.y + r.height / 2]); \
    const places = [0.25, 0.4, 0.55, 0.7].flatMap((y) => [0.3, 0.5, 0.7].map((x) => [left + x * width, top + y * height])); \
    const near = ([x, y]) => Math.min(...joints.map(([a, b]) => Math.hypot(x - a, y - b))); \
    return places.reduce((best, next) => (near(next) > near(best) ? next : best)); })()";

#[test]
#[ignore = "needs Chromium"]
fn it_is_used_with_fingers() {
    let mut bench = Bench::closed("telephone", None);
    bench.telephone([360, 640]);
    bench.load("");
    assert_eq!(bench.value("document.documentElement.scrollWidth"), 360);
    bench.picture("telephone");
    let height = bench.number("document.querySelector('#pane').getBoundingClientRect().height");
    assert!(height > 200.0, "the picture is {height} px high");
    // A finger turns the crank.
    let angle = bench.at("/links/1/drive/angle");
    let [x, y] = bench.joint("B");
    bench.touch(&[&[[x, y]], &[[x - 8.0, y + 4.0]], &[[x - 20.0, y + 8.0]], &[[x - 24.0, y + 10.0]]]);
    bench.settle();
    assert_ne!(bench.at("/links/1/drive/angle"), angle);
    // Two fingers make it larger.
    let sight = "document.querySelector('#sheet').viewBox.baseVal.width";
    let before = bench.number(sight);
    // On the ground, where no joint is near.
    let far = bench.value(FAR);
    let [x, y] = [0, 1].map(|k| far[k].as_f64().expect("a place"));
    let apart = |d: f64| [[x - d, y], [x + d, y]];
    bench.touch(&[&apart(20.0), &apart(40.0), &apart(70.0)]);
    bench.until(&format!("{sight} < {before}"));
    bench.press("0");
    bench.until(&format!("Math.abs({sight} - {before}) < 1"));
    let mut small = Vec::new();
    for panel in ["mechanism", "text", "figure", "values", "curves", "modes", "check", "exercise", "save"] {
        bench.value(&format!("kinegon.app.show('{panel}')"));
        bench.settle();
        bench.picture(&format!("telephone-{panel}"));
        assert_eq!(bench.value("document.documentElement.scrollWidth"), 360, "{panel}");
        let wide = bench.value("[...document.querySelectorAll('#panels .panel:not([hidden]) :is(button, input, select, p, label, h2, h3, td)')].filter((e) => e.getBoundingClientRect().right > 361 \
            && !e.closest('.cm-scroller, svg, table, [class*=scroll]')).map((e) => e.className || e.tagName).slice(0, 5)");
        assert_eq!(wide, serde_json::json!([]), "{panel}: wider than the screen");
        small.extend(bench.value(SMALL).as_array().expect("a list").iter().map(|s| format!("{panel}: {s}")));
    }
    small.dedup();
    assert!(small.is_empty(), "{}", small.join("\n"));
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn the_narrowest_screen_has_room() {
    let mut bench = Bench::closed("narrow", None);
    bench.telephone([320, 568]);
    bench.load("");
    assert_eq!(bench.value("document.documentElement.scrollWidth"), 320);
    bench.picture("narrow");
    // A film filled the width, too.
    bench.telephone([640, 360]);
    bench.settle();
    assert_eq!(bench.value("document.documentElement.scrollWidth"), 640);
    bench.picture("telephone-lying");
    bench.assert_quiet();
}
