//! Masses and forces in the form: added, changed and taken away, by mouse and by keys; what is there is seen beside the picture's joints.

use super::bench::Bench;
use serde_json::json;
use support::files;

const GROUP: &str = "#panel-mechanism [data-path='forces']";

/// A bench with a slider-crank, its group of loads open.
fn opened(name: &str) -> Option<Bench> {
    let mut bench = Bench::of(name, &files::read("templates/slider-crank.json"))?;
    bench.panel("mechanism");
    bench.click(&format!("{GROUP} > summary"));
    bench.settle();
    Some(bench)
}

/// The loads that the picture shows.
fn drawn(bench: &mut Bench) -> f64 {
    bench.number("document.querySelectorAll('#sheet [id*=\"-load-\"]').length")
}

#[test]
fn loads_come_change_and_go() {
    let Some(mut bench) = opened("loads") else { return };
    assert_eq!(drawn(&mut bench), 0.0);
    bench.choose("[data-path='forces.+'] select", "link 3 at C");
    bench.click("[data-path='forces.+'] button");
    bench.settle();
    assert_eq!(bench.at("/forces/0"), json!({ "on": "3", "at": "C", "force": [0, -100] }));
    assert_eq!(bench.at("/units/force"), "N");
    assert!(drawn(&mut bench) > 0.0, "the force is not seen");
    let torque = bench.value("kinegon.app.solved.value.opened !== null && kinegon.app.solved.value.refused === null");
    assert_eq!(torque, true);
    // Its size, then its name.
    bench.fill("[data-path='forces.0.force.0'] input", "-1500");
    assert_eq!(bench.at("/forces/0/force"), json!([-1500, -100]));
    bench.click("[data-path='forces.0'] button.more");
    bench.settle();
    bench.fill("[data-path='forces.0.name'] input", "P");
    assert_eq!(bench.at("/forces/0/name"), "P");
    // Onto another link: the place goes with it.
    bench.choose("[data-path='forces.0.on'] select", "Link 1");
    assert_eq!([bench.at("/forces/0/on"), bench.at("/forces/0/at")], ["1", "A"]);
    bench.press("Control+z");
    bench.settle();
    assert_eq!(bench.at("/forces/0/on"), "3");
    // A mass with its inertia, and gravity.
    bench.choose("[data-path='links.+mass'] select", "Link 2");
    bench.click("[data-path='links.+mass'] button");
    bench.settle();
    bench.fill("[data-path='links.2.inertia'] input", "2100");
    assert_eq!(bench.at("/links/2/inertia"), 2100);
    bench.click("[data-path='gravity'] button");
    bench.settle();
    assert_eq!(bench.at("/gravity"), json!([0, -9810]));
    // What cannot be is told at its field.
    bench.fill("[data-path='links.2.mass'] input", "-1");
    let told = bench.text("document.querySelector(\"[data-path='links.2.mass'] .why\")?.textContent ?? ''");
    assert!(!told.is_empty(), "a negative mass is not refused");
    bench.press("Control+z");
    bench.settle();
    bench.picture("loads");
    // All of it away again.
    bench.press_named(GROUP, "Remove the mass of link 2");
    bench.press_named(GROUP, "Remove P");
    assert!(
        bench.at("/forces").is_null() && bench.at("/links/2/mass").is_null() && bench.at("/links/2/inertia").is_null()
    );
    assert_eq!(drawn(&mut bench), 0.0);
    bench.assert_quiet();
}

#[test]
fn loads_are_added_and_removed_by_keys() {
    let Some(mut bench) = opened("loads-keys") else { return };
    bench.value("document.querySelector(\"[data-path='forces.+couple'] button\").focus()");
    bench.press("Enter");
    bench.settle();
    let first = bench.at("/forces/0");
    assert!(first["couple"].is_number(), "{first}");
    // The focus has stayed in the form: Tab goes on from there.
    assert_eq!(bench.value("document.activeElement.closest('#panel-mechanism') !== null"), true);
    bench.value("document.querySelector(\"[data-path='forces.0.couple'] input\").focus()");
    bench.press("ArrowUp");
    bench.settle();
    assert_ne!(bench.at("/forces/0/couple"), first["couple"]);
    bench.value("document.querySelector(\"[data-path='forces.0'] header .buttons button\").focus()");
    bench.press("Enter");
    bench.settle();
    assert!(bench.at("/forces").is_null());
    bench.assert_quiet();
}

#[test]
fn loads_fit_a_telephone() {
    let text = files::read("tests/forces/figure-2.json");
    let Some(mut bench) = Bench::closed("loads-telephone", None) else { return };
    bench.telephone([360, 640]);
    bench.load("");
    bench.put(&text);
    bench.value("kinegon.app.show('mechanism')");
    bench.settle();
    bench.value(
        "document.querySelectorAll(\"#panel-mechanism [data-path='forces'] .more\").forEach((more) => more.click())",
    );
    bench.settle();
    bench.value("document.querySelector(\"#panel-mechanism [data-path='forces']\").scrollIntoView()");
    bench.frame();
    bench.picture("loads-telephone");
    assert_eq!(bench.value("document.documentElement.scrollWidth"), 360);
    let wide = bench.value(&format!(
        "[...document.querySelectorAll(\"{GROUP} :is(button, input, select, label)\")] \
         .filter((e) => e.getBoundingClientRect().right > 361).map((e) => e.className || e.tagName)"
    ));
    assert_eq!(wide, json!([]), "wider than the screen");
    bench.assert_quiet();
}
