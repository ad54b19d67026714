//! Nobody is kept out: what axe-core finds, in all panels and in Build, light and dark, on a screen and on a telephone.

use super::bench::Bench;
use support::{files, survey};

/// Rules of WCAG 2.2, levels A and AA, and best practice: all of them, that of colours alone, or all others.
const RULES: [&str; 3] =
    ["{}", "{ runOnly: ['color-contrast'] }", "{ rules: { 'color-contrast': { enabled: false } } }"];

/// The script of axe-core.
pub fn axe() -> String {
    let script = std::fs::read_to_string(files::path("web/node_modules/axe-core/axe.min.js"));
    script.expect("axe-core is not installed: npm ci in web/")
}

/// What breaks some of the rules.
pub fn run(rules: &str) -> String {
    format!(
        "axe.run(document, {{ ...{rules}, resultTypes: ['violations'] }}).then(({{ violations }}) => \
         violations.map((v) => `${{v.id}}: ${{v.nodes.map((n) => n.target.join(' ')).slice(0, 4).join(', ')}}`))"
    )
}

#[test]
#[ignore = "needs Chromium"]
fn axe_finds_nothing() {
    let axe = axe();
    let mut bench = Bench::open("axe");
    bench.value(&axe);
    let mut found = Vec::new();
    // In the dark colours are others, on a telephone places.
    let looks = [("light", false), ("dark", false), ("light", true)].into_iter().zip(RULES);
    for ((look, is_small), rules) in looks.take(survey::LOOKS.now()) {
        bench.media("", &[("prefers-color-scheme", look), ("prefers-reduced-motion", "reduce")]);
        if is_small {
            bench.telephone([360, 640]);
        }
        let mut look_at = |bench: &mut Bench, place: &str| {
            let violations = bench.value(&run(rules));
            let violations = violations.as_array().expect("a list").iter();
            let screen = if is_small { "telephone" } else { "screen" };
            found.extend(violations.map(|v| format!("{look}, {screen}, {place}: {v}")));
        };
        for panel in ["mechanism", "text", "figure", "values", "curves", "modes", "check", "exercise", "save"] {
            bench.value(&format!("kinegon.app.show('{panel}')"));
            bench.settle();
            look_at(&mut bench, panel);
        }
        // Build, with the tool that has most to choose.
        bench.value("kinegon.app.show('mechanism'); kinegon.app.building.set(true)");
        bench.click("#build [data-value=slider]");
        bench.settle();
        look_at(&mut bench, "build");
        bench.value("kinegon.app.building.set(false)");
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn what_changes_is_said() {
    let mut bench = Bench::open("said");
    let live = bench.number("document.querySelectorAll('[aria-live], [role=status], [role=alert]').length");
    assert!(live >= 3.0);
    bench.press("Home");
    bench.settle();
    assert_eq!(bench.value("document.querySelector('#step-caption').closest('[aria-live]') !== null"), true);
    bench.put("{");
    assert_eq!(bench.value("document.querySelector('#message').getAttribute('role')"), "alert");
    let nameless = bench.value(
        "[...document.querySelectorAll('button, input, select, [role=slider]')].filter((e) => e.getClientRects().length > 0 \
         && !(e.ariaLabel || e.textContent.trim() || e.labels?.length || e.title || e.getAttribute('aria-labelledby'))).map((e) => e.outerHTML.slice(0, 90))",
    );
    assert_eq!(nameless, serde_json::json!([]));
}
