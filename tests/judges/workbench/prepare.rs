//! A teacher before class: a kind, own lengths, joints pulled into shape, scales and looks; mistakes are told where they are.

use super::bench::Bench;
use support::files;

#[test]
#[ignore = "needs Chromium"]
fn a_kind_is_made_ones_own() {
    let mut bench = Bench::open("prepare");
    bench.panel("mechanism");
    bench.click("#panel-mechanism details.gallery > summary");
    bench.until("document.querySelectorAll('#panel-mechanism button.kind').length >= 17");
    bench.settle();
    bench.picture("kinds");
    bench.press_named("#panel-mechanism", "Four-bar");
    let kind = bench.scene();
    assert!(kind.contains("Four-bar linkage"), "{kind}");
    bench.fill("#panel-mechanism [data-path=\"links.2.lengths.BC\"] input", "150");
    assert_eq!(bench.at("/links/2/lengths/BC"), 150);
    // Shape: C is pulled, the rocker's length is pinned and stays.
    bench.press_named("#panel-mechanism", "Hold length 3.CD");
    bench.click("#hand-shape");
    bench.settle();
    bench.pull_joint("C", [30.0, 20.0]);
    assert_eq!(bench.at("/links/3/lengths/CD"), 110, "a pinned length stays");
    assert_ne!(bench.at("/links/2/lengths/BC"), 150, "the coupler follows");
    bench.picture("shape");
    // A fixed point moves with the same hand.
    bench.pull_joint("D", [25.0, 0.0]);
    assert_ne!(bench.at("/ground/D/0"), 160);
    bench.click("#hand-move");
    // Looks: scales, style, notation, language.
    bench.panel("figure");
    bench.fill("#panel-figure [data-path=\"figure.mu_v\"] input", "20");
    assert_eq!(bench.at("/figure/mu_v"), 20);
    bench.picture("figure");
    for (key, value) in [("style", "lecture"), ("notation", "german"), ("language", "es"), ("page", "a3")] {
        let before = bench.marks();
        let words = bench.value(&format!(
            "(() => {{ const box = document.querySelector('#panel-figure [data-path=\"figure.{key}\"]'); \
             const input = [...box.querySelectorAll('input[type=radio]')].at(1) ?? box.querySelector('select'); \
             if (input.type === 'radio') {{ input.click(); return true; }} input.selectedIndex = 1; \
             input.dispatchEvent(new Event('change', {{ bubbles: true }})); return true; }})()"
        ));
        assert_eq!(words, true);
        bench.settle();
        assert!(bench.at(&format!("/figure/{key}")).is_string(), "{key} {value}: {}", bench.scene());
        if key != "page" {
            assert_ne!(bench.marks(), before, "{key} shows");
        }
    }
    bench.picture("figure-spanish");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_mistake_is_told_at_its_place_and_the_picture_stays() {
    let text = files::read("templates/four-bar.json");
    let mut bench = Bench::of("mistake", &text);
    let good = bench.shown();
    bench.panel("mechanism");
    let field = "#panel-mechanism [data-path=\"links.2.lengths.BC\"] input";
    bench.fill(field, "10");
    assert!(!bench.message().is_empty(), "a linkage that cannot be assembled is told");
    // What is told takes some of the pane, for which the picture is laid out anew.
    assert_eq!(bench.shown(), good, "the last good picture stays");
    bench.picture("cannot-be-assembled");
    bench.fill(field, "140");
    assert_eq!(bench.message(), "");
    // A key that nobody knows: the message leads to its line.
    bench.put(&text.replacen("\"near\"", "\"nearby\"", 1));
    let message = bench.message();
    assert!(message.contains("nearby") && message.contains("Line"), "{message}");
    bench.click("#message-place");
    bench.settle();
    bench
        .until("document.querySelector('#panel-text .cm-lintRange-error, #panel-text .cm-lint-marker-error') !== null");
    bench.picture("mistake-in-the-text");
    bench.click("#undo");
    bench.settle();
    assert_eq!(bench.message(), "");
    assert_eq!(bench.shown(), good);
    bench.assert_quiet();
}
