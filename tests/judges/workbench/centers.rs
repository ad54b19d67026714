//! Instant centres in the workbench: asked for by its controls, they move with the hand; centrodes and inflection circles beside them; in all looks.

use super::bench::Bench;
use serde_json::{Value, json};
use support::files;

fn field(key: &str) -> String {
    format!("[data-path=\"figure.{key}\"]")
}

/// Where a mark of the picture is on the screen: the middle of its box.
fn mark(bench: &mut Bench, id: &str) -> [f64; 2] {
    let place = bench.value(&format!(
        "(() => {{ const r = document.querySelector(`#sheet [id=\"{id}\"]`)?.getBoundingClientRect(); \
         return r ? [r.x + r.width / 2, r.y + r.height / 2] : null; }})()"
    ));
    [0, 1].map(|axis| place[axis].as_f64().unwrap_or_else(|| panic!("no mark {id}")))
}

fn apart([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    libm::hypot(c - a, d - b)
}

#[test]
#[ignore = "needs Chromium"]
fn they_are_asked_for_and_follow_the_hand() {
    let mut bench = Bench::of("centers", &files::read("templates/four-bar.json"));
    bench.panel("figure");
    // A scene that says nothing has the usual panels, of which one more is chosen.
    bench.press_named(&field("panels"), "Instant centres");
    assert_eq!(bench.at("/figure/panels"), json!(["scheme", "velocity", "acceleration", "centers"]));
    for plan in ["Velocity", "Acceleration"] {
        bench.press_named(&field("panels"), plan);
    }
    assert_eq!(bench.at("/figure/panels"), json!(["scheme", "centers"]));
    bench.until("document.querySelector('#sheet [id=\"centers-center-Pu281-3u29\"]') !== null");
    let ids = ["centers-center-Pu281-3u29", "centers-line-Pu281-3u29-1"];
    let before = ids.map(|id| mark(&mut bench, id));
    bench.pull_joint("B", [12.0, 14.0]);
    let after = ids.map(|id| mark(&mut bench, id));
    for (id, (before, after)) in ids.into_iter().zip(before.into_iter().zip(after)) {
        assert!(apart(before, after) > 2.0, "{id} stays at {after:?}");
    }
    // Those that are wanted.
    bench.press_named(&field("centers"), "these");
    assert_eq!(bench.at("/figure/centers"), json!(["P(1,ground)"]));
    bench.press_named("#panel-figure fieldset[data-path=\"figure.centers\"] .checks", "P(2,ground)");
    assert_eq!(bench.at("/figure/centers"), json!(["P(1,ground)", "P(2,ground)"]));
    bench.press_named(&field("centers"), "all");
    assert_eq!(bench.at("/figure/centers"), json!("all"));
    bench.press_named(&field("centers"), "the usual ones");
    assert_eq!(bench.at("/figure/centers"), Value::Null);
    for (key, name, id) in [
        ("velocities", "C", "centers-velocity-C"),
        ("centrodes", "2", "scheme-fixed-centrode-2-1"),
        ("inflection", "2", "scheme-inflection-circle-2-1"),
    ] {
        bench.press_named(&field(key), name);
        assert_eq!(bench.at(&format!("/figure/{key}")), json!([name]));
        bench.until(&format!("document.querySelector('#sheet [id=\"{id}\"]') !== null"));
    }
    bench.picture("centers");
    bench.click("#dark");
    bench.settle();
    bench.picture("centers-dark");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn they_fit_on_a_telephone() {
    let mut scene: Value = serde_json::from_str(&files::read("examples/figure-2.json")).expect("JSON");
    scene["figure"] = json!({ "panels": ["scheme", "centers"], "centers": "all" });
    let text = scene.to_string();
    let scene = kinegon::format::OpenScene { text: &text, step: None };
    let mut bench = Bench::closed("centers-telephone", Some(scene));
    bench.telephone([360, 640]);
    bench.load("");
    assert_eq!(bench.value("document.documentElement.scrollWidth"), 360);
    bench.picture("centers-telephone");
    bench.click("#focus-centers");
    bench.settle();
    bench.picture("centers-telephone-large");
    bench.value("kinegon.app.show('figure')");
    bench.settle();
    assert_eq!(bench.value("document.documentElement.scrollWidth"), 360);
    bench.picture("centers-telephone-figure");
    bench.assert_quiet();
}
