//! Masses and forces in the form: added, changed and taken away, by mouse and by keys; what is there is seen beside the picture's joints.

use super::bench::Bench;
use serde_json::json;
use support::files;

const GROUP: &str = "#panel-mechanism [data-path='forces']";

/// A bench with a slider-crank, its group of loads open.
fn opened(name: &str) -> Bench {
    let mut bench = Bench::of(name, &files::read("templates/slider-crank.json"));
    bench.panel("mechanism");
    bench.click(&format!("{GROUP} > summary"));
    bench.settle();
    bench
}

/// The loads that the picture shows.
fn drawn(bench: &mut Bench) -> f64 {
    bench.number("document.querySelectorAll('#sheet [id*=\"-load-\"]').length")
}

#[test]
#[ignore = "needs Chromium"]
fn loads_come_change_and_go() {
    let mut bench = opened("loads");
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
#[ignore = "needs Chromium"]
fn loads_are_added_and_removed_by_keys() {
    let mut bench = opened("loads-keys");
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
#[ignore = "needs Chromium"]
fn loads_fit_a_telephone() {
    let text = files::read("tests/forces/figure-2.json");
    let mut bench = Bench::closed("loads-telephone", None);
    bench.telephone([360, 640]);
    bench.load("");
    bench.put(&text);
    bench.value("kinegon.app.show('mechanism')");
    bench.settle();
    bench.value(
        "document.querySelectorAll(\"#panel-mechanism [data-path='forces'] .more\").forEach((more) => more.click())",
    );
    bench.settle();
    // A table with its curve, too.
    bench.value("document.querySelector(\"[data-path='forces.0.+over'] button\").click()");
    bench.settle();
    assert!(bench.at("/forces/0/over/table").is_array());
    bench.value("document.querySelector(\"[data-path='forces.0.over']\").scrollIntoView({ block: 'center' })");
    bench.frame();
    bench.picture("loads-table-telephone");
    bench.value("document.querySelector(\"#panel-mechanism [data-path='forces']\").scrollIntoView()");
    bench.frame();
    bench.picture("loads-telephone");
    assert_eq!(bench.value("document.documentElement.scrollWidth"), 360);
    let wide = bench.value(&format!(
        "[...document.querySelectorAll(\"{GROUP} :is(button, input, select, label, textarea, svg)\")] \
         .filter((e) => e.getBoundingClientRect().right > 361).map((e) => e.className || e.tagName)"
    ));
    assert_eq!(wide, json!([]), "wider than the screen");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_force_is_drawn_and_a_couple_tapped_in_build() {
    let mut bench = Bench::of("loads-build", &files::read("templates/slider-crank.json"));
    bench.panel("mechanism");
    bench.press("b");
    bench.until("document.activeElement.id === 'build-stage'");
    bench.settle();
    let place = |bench: &mut Bench, point: &str| {
        let all = super::build::places(bench);
        let at = all.into_iter().find(|(name, _)| name == point).expect("a point").1;
        [at.re, at.im]
    };
    let [x, y] = place(&mut bench, "C");
    let fine = bench.number("Number(document.querySelector('#build .seen button').textContent.match(/[\\d.]+/)[0])");
    super::build::tool(&mut bench, "load");
    super::build::drag(&mut bench, [x, y], [x - 12.0 * fine, y + 5.0 * fine]);
    let load = bench.at("/forces/0");
    assert_eq!([&load["on"], &load["at"], &load["force"]], [&json!("3"), &json!("C"), &json!([-120, 50])], "{load}");
    assert_eq!(bench.at("/units/force"), "N");
    bench.until("document.querySelector(\"[data-path='forces.0']\") !== null");
    // It is seen, and its card is.
    assert_eq!(bench.value("document.querySelector('#build .drawn [id*=\"load-1\"]') !== null"), true);
    // Along the coupler: halfway, as a distance along it.
    let [a, b] = [place(&mut bench, "B"), place(&mut bench, "C")];
    let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    super::build::drag(&mut bench, middle, [middle[0], middle[1] - 8.0 * fine]);
    let load = bench.at("/forces/1");
    let half = 0.5 * libm::hypot(b[0] - a[0], b[1] - a[1]);
    let at = load["at"].as_f64().expect("a distance");
    assert!(load["on"] == "2" && (at - half).abs() < 0.02 * half, "{load} {half}");
    // A tap on the crank is a couple.
    let origin = place(&mut bench, "A");
    super::build::click(&mut bench, [0.5 * (origin[0] + a[0]), 0.5 * (origin[1] + a[1])]);
    assert_eq!(bench.at("/forces/2"), json!({ "on": "1", "couple": 1000 }));
    bench.picture("loads-build");
    bench.press("Control+z");
    bench.settle();
    assert!(bench.at("/forces/2").is_null());
    // An empty place carries nothing.
    super::build::click(&mut bench, [x + 30.0 * fine, y + 30.0 * fine]);
    assert!(bench.at("/forces/2").is_null());
    // By keys: the cross on a joint, Enter, arrows, Enter.
    bench.value("document.querySelector('#build-stage').focus()");
    bench.press("9");
    bench.press("PageDown");
    bench.settle();
    bench.press("Enter");
    bench.settle();
    for _ in 0..4 {
        bench.press("ArrowUp");
    }
    bench.press("Enter");
    bench.settle();
    let load = bench.at("/forces/2");
    assert!(load["force"][1].as_f64().is_some_and(|up| up > 0.0), "{load}");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_table_over_the_stroke_comes_changes_and_goes() {
    let mut bench = opened("loads-table");
    bench.choose("[data-path='forces.+'] select", "link 3 at C");
    bench.click("[data-path='forces.+'] button");
    bench.settle();
    bench.click("[data-path='forces.0'] button.more");
    bench.settle();
    bench.choose("[data-path='forces.0.+over'] select", "position of 3/ground");
    bench.click("[data-path='forces.0.+over'] button");
    bench.settle();
    assert_eq!(bench.at("/forces/0/over/of"), "position(3/ground)");
    assert_eq!(bench.value("kinegon.app.solved.value.refused"), json!(null), "{}", bench.scene());
    // Lines as a spreadsheet pastes them: semicolons, decimal commas, a head.
    let table = "[data-path='forces.0.over.table'] textarea";
    bench.value(&format!("document.querySelector(\"{table}\").focus()"));
    bench.press("Control+a");
    bench.insert("place;factor\n60;0\n90,5;1,5\n150;0,25");
    bench.press("Tab");
    bench.settle();
    assert_eq!(bench.at("/forces/0/over/table"), json!([[60, 0], [90.5, 1.5], [150, 0.25]]));
    assert_eq!(bench.value("document.querySelectorAll(\"[data-path='forces.0.over.table'] svg path\").length"), 2);
    bench.picture("loads-table");
    // What is no number is told at the field, and the scene stays.
    bench.value(&format!("document.querySelector(\"{table}\").focus()"));
    bench.press("Control+a");
    bench.insert("60, 0\n90, much");
    bench.press("Tab");
    bench.settle();
    let told = bench.text("document.querySelector(\"[data-path='forces.0.over.table'] .why\")?.textContent ?? ''");
    assert!(told.contains("line 2, column 2"), "{told:?}");
    assert_eq!(bench.at("/forces/0/over/table/1"), json!([90.5, 1.5]));
    bench.choose("[data-path='forces.0.over.of'] select", "angle of 1");
    assert_eq!(bench.at("/forces/0/over/of"), "angle(1)");
    bench.press("Control+z");
    bench.press("Control+z");
    bench.settle();
    assert_eq!(bench.at("/forces/0/over/table/1/1"), 1, "the table to begin with");
    bench.press_named("#panel-mechanism [data-path='forces.0.over']", "Remove the table");
    assert!(bench.at("/forces/0/over").is_null());
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_finger_loads_in_build() {
    let text = files::read("templates/slider-crank.json");
    let mut bench = Bench::closed("loads-finger", None);
    bench.telephone([360, 640]);
    bench.load("");
    bench.put(&text);
    bench.value("kinegon.app.show('')");
    bench.click("#hand-build");
    bench.until("document.querySelector('#build-stage')?.dataset.window !== undefined");
    bench.settle();
    bench.value("document.querySelector('#build .tools [data-value=load]').click()");
    bench.settle();
    let all = super::build::places(&mut bench);
    let crank: Vec<_> = all.iter().filter(|(name, _)| name == "A" || name == "B").map(|(_, at)| *at).collect();
    let middle = (crank[0] + crank[1]) * 0.5;
    let at = super::build::on_screen(&mut bench, [middle.re, middle.im]);
    bench.touch(&[&[at]]);
    bench.settle();
    assert_eq!(bench.at("/forces/0"), json!({ "on": "1", "couple": 1000 }), "{}", bench.scene());
    let slider = all.iter().find(|(name, _)| name == "C").expect("a point").1;
    let [x, y] = super::build::on_screen(&mut bench, [slider.re, slider.im]);
    bench.touch(&[&[[x, y]], &[[x - 30.0, y]], &[[x - 70.0, y]]]);
    bench.settle();
    let load = bench.at("/forces/1");
    assert!(load["on"] == "3" && load["force"][0].as_f64().is_some_and(|x| x < 0.0), "{load}");
    bench.picture("loads-finger");
    bench.assert_quiet();
}

/// Where on the stage that part of the load of this index is, in the scene.
fn handle(bench: &mut Bench, index: usize, part: &str) -> [f64; 2] {
    let all = bench.value("JSON.parse(document.querySelector('#build-stage').dataset.loads)");
    let is_it = |load: &&serde_json::Value| load["index"] == index && load["part"] == part;
    let found = all.as_array().expect("loads").iter().find(is_it).unwrap_or_else(|| panic!("{part} {index} in {all}"));
    [0, 1].map(|axis| found["at"][axis].as_f64().expect("a number"))
}

/// A slider-crank with a force on its coupler, one on the slider, one that turns with the crank, and a couple.
fn loaded() -> String {
    let mut scene: serde_json::Value = serde_json::from_str(&files::read("templates/slider-crank.json")).expect("JSON");
    scene["units"] = json!({ "length": "mm", "time": "s", "force": "N" });
    scene["analysis"] = json!("static");
    scene["forces"] = json!([
        { "name": "P", "on": "2", "at": 60, "force": [0, -100] },
        { "name": "Q", "on": "3", "at": "C", "force": { "size": 1500, "angle": 180 } },
        { "on": "2", "couple": 1000 },
    ]);
    serde_json::to_string_pretty(&scene).expect("JSON")
}

#[test]
#[ignore = "needs Chromium"]
fn loads_are_dragged_in_build() {
    let mut bench = Bench::of("loads-dragged", &loaded());
    bench.panel("mechanism");
    bench.press("b");
    bench.until("document.activeElement.id === 'build-stage'");
    bench.settle();
    super::build::tool(&mut bench, "select");
    let fine = bench.number("Number(document.querySelector('#build .seen button').textContent.match(/[\\d.]+/)[0])");
    // The tip: three steps to the right, four down, ten units each.
    let [x, y] = handle(&mut bench, 0, "tip");
    super::build::drag(&mut bench, [x, y], [x + 3.0 * fine, y - 4.0 * fine]);
    assert_eq!(bench.at("/forces/0/force"), json!([30, -140]));
    bench.press("Control+z");
    bench.settle();
    assert_eq!(bench.at("/forces/0/force"), json!([0, -100]), "one entry of undo");
    // A large force by larger steps, still by size and direction.
    let [x, y] = handle(&mut bench, 1, "tip");
    super::build::drag(&mut bench, [x, y], [x - 5.0 * fine, y]);
    assert_eq!(bench.at("/forces/1/force"), json!({ "size": 2000, "angle": 180 }));
    // The shaft takes the force along its link, to a joint of it in the end.
    let [x, y] = handle(&mut bench, 0, "shaft");
    super::build::drag(&mut bench, [x, y], [x + 4.0 * fine, y]);
    let further = bench.at("/forces/0/at").as_f64().expect("a distance");
    assert!(further > 61.0 && bench.at("/forces/0/force") == json!([0, -100]), "{further}");
    let places = super::build::places(&mut bench);
    let joint = places.iter().find(|(name, _)| name == "B").expect("B").1;
    let [x, y] = handle(&mut bench, 0, "shaft");
    let text: serde_json::Value = serde_json::from_str(&bench.scene()).expect("JSON");
    let along = text["forces"][0]["at"].as_f64().expect("a distance");
    let end = places.iter().find(|(name, _)| name == "C").expect("C").1;
    let way = (joint - end) / 150.0 * along;
    super::build::drag(&mut bench, [x, y], [x + way.re, y + way.im]);
    assert_eq!(bench.at("/forces/0/at"), "B");
    // A couple grows to the right.
    let [x, y] = handle(&mut bench, 2, "couple");
    super::build::drag(&mut bench, [x, y], [x + 5.0 * fine, y]);
    assert_eq!(bench.at("/forces/2/couple"), 1500);
    bench.picture("loads-dragged");
    // A tap opens the row; no couple comes with the tool for loads.
    super::build::tool(&mut bench, "load");
    let tip = handle(&mut bench, 1, "tip");
    super::build::click(&mut bench, tip);
    assert!(bench.at("/forces/3").is_null());
    bench.until("document.querySelector(\"[data-path='forces.1']\") !== null");
    // By keys: the last thing is the couple; Enter, an arrow, Enter.
    super::build::tool(&mut bench, "select");
    bench.value("document.querySelector('#build-stage').focus()");
    bench.press("f");
    bench.press("PageUp");
    bench.settle();
    for _ in 0..8 {
        if bench.value("document.querySelector('#build-stage .cross text').textContent") == "load M2" {
            break;
        }
        bench.press("PageUp");
        bench.settle();
    }
    bench.press("Enter");
    bench.settle();
    bench.press("ArrowRight");
    bench.press("ArrowRight");
    bench.press("Enter");
    bench.settle();
    assert_eq!(bench.at("/forces/2/couple"), 1700);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_finger_drags_loads_in_build() {
    let mut bench = Bench::closed("loads-finger-drags", None);
    bench.telephone([360, 640]);
    bench.load("");
    bench.put(&loaded());
    bench.value("kinegon.app.show('')");
    bench.click("#hand-build");
    bench.until("document.querySelector('#build-stage')?.dataset.window !== undefined");
    bench.settle();
    bench.value("document.querySelector('#build .tools [data-value=load]').click()");
    bench.settle();
    let tip = handle(&mut bench, 0, "tip");
    let [x, y] = super::build::on_screen(&mut bench, tip);
    bench.touch(&[&[[x, y]], &[[x, y + 30.0]], &[[x, y + 70.0]]]);
    bench.settle();
    let force = bench.at("/forces/0/force");
    assert!(force[1].as_f64().is_some_and(|y| y < -100.0) && bench.at("/forces/3").is_null(), "{force}");
    bench.picture("loads-finger-drags");
    bench.assert_quiet();
}
