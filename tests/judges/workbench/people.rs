//! What people meet first: numbers half typed, a browser in another language, scenes as large as they come.

use super::bench::Bench;
use super::hostile::row;
use serde_json::{Value, json};
use support::files;

/// Notes how long the page does not answer, in ms.
const WATCHED: &str = "(window.gaps = [], new PerformanceObserver((seen) => seen.getEntries().forEach(({ duration }) => \
    window.gaps.push(duration))).observe({ entryTypes: ['longtask'] }))";

/// The nodes and listeners that the page holds, seen or not.
fn held(bench: &mut Bench) -> [f64; 2] {
    bench.call("HeapProfiler.collectGarbage", json!({}));
    let counted = bench.call("Memory.getDOMCounters", json!({}));
    ["nodes", "jsEventListeners"].map(|what| counted[what].as_f64().expect("a number"))
}

#[test]
fn half_a_number_is_no_mistake() {
    let Some(mut bench) = Bench::of("typed", &files::read("templates/four-bar.json")) else { return };
    bench.panel("mechanism");
    let field = "[data-path=\"links.2.lengths.BC\"] input";
    bench.place(field);
    bench.value(&format!("(() => {{ const e = document.querySelector({}); e.focus(); e.select(); }})()", json!(field)));
    // 1 mm, then 14 mm: neither closes the loop.
    for letter in ["1", "4", "5"] {
        bench.insert(letter);
        bench.frame();
        assert_eq!(bench.message(), "", "after {letter}");
    }
    bench.settle();
    assert_eq!(bench.at("/links/2/lengths/BC"), 145);
    // A number that stays too short is told of when nobody types any more.
    bench.value(&format!("document.querySelector({}).select()", json!(field)));
    bench.insert("1");
    bench.until("!document.querySelector('#message').hidden");
    assert!(bench.message().contains("assemble") || bench.message().contains("close"), "{}", bench.message());
    bench.press("Tab");
    bench.assert_quiet();
}

#[test]
fn the_page_speaks_the_browsers_language_and_the_figure_its_own() {
    let Some(mut bench) = Bench::closed("language", None) else { return };
    let agent = bench.text("navigator.userAgent");
    bench.call("Emulation.setUserAgentOverride", json!({ "userAgent": agent, "acceptLanguage": "es-CO,es" }));
    bench.load("");
    assert_eq!(bench.text("document.documentElement.lang"), "es");
    let scene = bench.scene();
    bench.click("#steps-toggle");
    bench.settle();
    let told = bench.text("document.querySelector('#step-caption').textContent");
    assert!(told.contains("Elegir") || told.contains("Elija") || told.contains("polo"), "{told}");
    let drawn = |bench: &mut Bench| bench.text("document.querySelector('#sheet').textContent");
    assert!(drawn(&mut bench).contains("Velocity plan"), "the figure is English, as its scene says");
    // Another scene does not change the page's language, nor does the page's language change the scene.
    let mut spanish: Value = serde_json::from_str(&files::read("templates/slider-crank.json")).expect("JSON");
    spanish["figure"]["language"] = "es".into();
    bench.choose("#language", "English");
    assert_eq!(bench.scene(), scene);
    bench.put(&spanish.to_string());
    assert_eq!(bench.text("document.documentElement.lang"), "en");
    assert!(drawn(&mut bench).contains("velocidades"), "the figure is Spanish, as its scene says");
    bench.load("");
    assert_eq!(bench.text("document.documentElement.lang"), "en", "what was chosen stays");
    bench.assert_quiet();
}

#[test]
fn a_thousand_links_leave_the_page_usable() {
    let Some(mut bench) = Bench::of("thousand", &files::read("templates/four-bar.json")) else { return };
    for panel in ["mechanism", "values", "check", "curves"] {
        bench.panel(panel);
    }
    bench.value(WATCHED);
    bench.put(&row(333));
    for panel in ["values", "check", "curves", "mechanism"] {
        bench.panel(panel);
    }
    // What comes into view is built.
    bench.value("document.querySelector('#panels').scrollTo(0, 1e7)");
    bench.frame();
    let longest = bench.number("Math.max(0, ...window.gaps)");
    println!("longest gap {longest:.0} ms; {} nodes", bench.number("document.querySelectorAll('*').length"));
    // Other tests run beside this one; alone it takes some 200 ms, and 144 s when all was built.
    assert!(longest < 2_000.0, "{longest} ms");
    assert!(bench.number("document.querySelectorAll('*').length") < 40_000.0);
    bench.assert_quiet();
}

#[test]
fn what_is_built_anew_leaves_nothing_behind() {
    let Some(mut bench) = Bench::of("renamed", &files::read("templates/four-bar.json")) else { return };
    for panel in ["text", "figure", "values", "curves", "check", "mechanism"] {
        bench.panel(panel);
    }
    let before = held(&mut bench);
    bench.value(
        "(async () => { for (let i = 0; i < 60; i += 1) { const [from, to] = i % 2 ? ['Z', 'B'] : ['B', 'Z']; \
         kinegon.history.change({ text: await kinegon.engine.edit(kinegon.history.now.value.text, [{ rename: 'point', from, to }]) }); } })()",
    );
    bench.settle();
    let after = held(&mut bench);
    for (before, after) in before.into_iter().zip(after) {
        assert!(after < 1.1 * before + 200.0, "{before} before, {after} after 60 renames");
    }
    bench.assert_quiet();
}
