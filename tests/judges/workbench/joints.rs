//! Wheels, racks, belts, profiles that touch and slots in the form: added, changed and taken away, by mouse, by keys and on a telephone.

use super::bench::Bench;
use serde_json::json;
use support::files;

/// A bench with a scene, the form in sight.
fn opened(name: &str, text: &str) -> Bench {
    let mut bench = Bench::of(name, text);
    bench.panel("mechanism");
    bench
}

/// What is wrong with the scene; empty where it is solved.
fn refused(bench: &mut Bench) -> String {
    bench.settle();
    bench.text("kinegon.app.solved.value.refused?.message ?? ''")
}

fn open_card(bench: &mut Bench, path: &str) {
    bench.click(&format!("[data-path='{path}'] button.more"));
    bench.settle();
}

/// The value of a quantity of the scene's position, to six digits.
fn value(bench: &mut Bench, name: &str) -> f64 {
    let text = json!(bench.scene());
    let rows = bench.ask("values", &[text]);
    let row = rows.as_array().and_then(|rows| rows.iter().find(|row| row["name"] == name));
    let value = row.and_then(|row| row["value"].as_str()?.split(' ').next()?.parse::<f64>().ok());
    value.map_or(f64::NAN, |value| libm::round(value * 1e6) / 1e6)
}

const SHAFT: &str = r#"{
  "kinegon": 1,
  "units": { "length": "mm", "time": "s" },
  "ground": { "A": [0, 0] },
  "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 25 }, "drive": { "angle": 30, "omega": 12 } } }
}
"#;

#[test]
#[ignore = "needs Chromium"]
fn a_train_of_wheels_comes_changes_and_goes() {
    let mut bench = opened("joints-wheels", SHAFT);
    bench.click("#panel-mechanism [data-path='gears'] > summary");
    bench.settle();
    // The crank's shaft gets a wheel of 20 teeth, and one of 40 beside it.
    bench.click("[data-path='gears.+'] button");
    bench.settle();
    assert_eq!(refused(&mut bench), "", "{}", bench.scene());
    assert_eq!(bench.at("/gears/0"), json!({ "mesh": ["1", "2"], "teeth": [20, 40], "on": "ground" }));
    assert_eq!(value(&mut bench, "omega(2)"), -6.0, "z₁ ω₁ = −z₂ ω₂");
    bench.fill("[data-path='gears.0.teeth.1'] input", "60");
    assert_eq!(value(&mut bench, "omega(2)"), -4.0);
    open_card(&mut bench, "gears.0");
    bench.fill("[data-path='gears.0.phase'] input", "15");
    assert_eq!(bench.at("/gears/0/phase"), 15);
    // A ring turns with the wheel in it, an open belt turns both the same way.
    bench.choose("[data-path='gears.0.belt'] select", "the second is a ring");
    assert_eq!(bench.at("/gears/0/teeth"), json!([20, -60]));
    assert_eq!(value(&mut bench, "omega(2)"), 4.0);
    bench.choose("[data-path='gears.0.belt'] select", "open belt");
    assert_eq!([bench.at("/gears/0/belt"), bench.at("/gears/0/teeth")], [json!("open"), json!([20, 60])]);
    assert_eq!(value(&mut bench, "omega(2)"), 4.0);
    bench.choose("[data-path='gears.0.belt'] select", "crossed");
    assert_eq!(value(&mut bench, "omega(2)"), -4.0);
    bench.picture("joints-belt");
    bench.press("Control+z");
    bench.press("Control+z");
    bench.settle();
    assert_eq!(bench.at("/gears/0/teeth"), json!([20, -60]), "each choice is one entry of undo");
    // What cannot be is told at its field.
    bench.fill("[data-path='gears.0.teeth.1'] input", "-20");
    let told = bench.text("document.querySelector(\"[data-path='gears.0'] .refusal\")?.textContent ?? ''");
    assert!(told.contains("ring"), "a ring as large as its wheel: {told:?}");
    bench.press("Control+z");
    bench.settle();
    // A third wheel, on the second.
    bench.choose("[data-path='gears.+'] select", "Link 2");
    bench.click("[data-path='gears.+'] button");
    bench.settle();
    assert_eq!([bench.at("/gears/1/mesh"), bench.at("/gears/1/teeth")], [json!(["2", "3"]), json!([60, 60])]);
    assert_eq!(refused(&mut bench), "", "{}", bench.scene());
    bench.picture("joints-wheels");
    bench.press_named("#panel-mechanism [data-path='gears.1']", "Remove");
    bench.press_named("#panel-mechanism [data-path='gears.0']", "Remove");
    assert!(bench.at("/gears").is_null());
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_rack_is_added_and_slid() {
    let mut bench = opened("joints-rack", SHAFT);
    bench.click("#panel-mechanism [data-path='gears'] > summary");
    bench.settle();
    bench.choose("[data-path='gears.+'] select:nth-of-type(2)", "a new rack");
    bench.click("[data-path='gears.+'] button");
    bench.settle();
    assert_eq!(refused(&mut bench), "", "{}", bench.scene());
    assert_eq!(bench.at("/gears/0/teeth"), json!([20, "rack"]));
    let radius = bench.at("/gears/0/radius").as_f64().expect("a radius");
    // The rack below the wheel goes with its rim: v = ω r towards +x.
    assert_eq!(value(&mut bench, "v_r(2/ground)"), 12.0 * radius);
    open_card(&mut bench, "gears.0");
    bench.fill("[data-path='gears.0.position'] input", "4");
    bench.fill("[data-path='gears.0.radius'] input", "12.5");
    assert_eq!([bench.at("/gears/0/position"), bench.at("/gears/0/radius")], [json!(4), json!(12.5)]);
    bench.picture("joints-rack");
    // A slot ends somewhere.
    open_card(&mut bench, "sliders.0");
    bench.press_named("#panel-mechanism [data-path='sliders.0']", "Ends of the slot");
    let ends = bench.at("/sliders/0/travel");
    assert!(ends[0].as_f64() < ends[1].as_f64(), "{ends}");
    assert_eq!(refused(&mut bench), "");
    bench.fill("[data-path='sliders.0.travel.1'] input", "-900");
    let told = bench.text("document.querySelector(\"[data-path='sliders.0.travel'] .refusal\")?.textContent ?? ''");
    assert!(told.contains("travel"), "{told:?}");
    bench.press("Control+z");
    bench.settle();
    bench.press_named("#panel-mechanism [data-path='sliders.0.travel']", "Remove the ends");
    assert!(bench.at("/sliders/0/travel").is_null());
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_cam_comes_changes_and_goes() {
    let text = files::read("templates/eccentric-cam.json");
    let start = text.find("  \"contacts\": [").expect("contacts");
    let end = start + text[start..].find("  ],\n").expect("an end") + 5;
    let mut bench = opened("joints-cam", &format!("{}{}", &text[..start], &text[end..]));
    assert!(
        refused(&mut bench).contains("drive") || !refused(&mut bench).is_empty(),
        "without the contact it is loose"
    );
    bench.click("#panel-mechanism [data-path='gears'] > summary");
    bench.settle();
    bench.choose("[data-path='contacts.+'] select", "link 1 at K");
    bench.choose("[data-path='contacts.+'] select:nth-of-type(2)", "link 3 at C");
    bench.click("[data-path='contacts.+'] button");
    bench.settle();
    assert_eq!(refused(&mut bench), "", "{}", bench.scene());
    assert_eq!(bench.at("/contacts/0/centers"), json!(["K", "C"]));
    bench.fill("[data-path='contacts.0.radii.0'] input", "40");
    bench.fill("[data-path='contacts.0.radii.1'] input", "12");
    assert_eq!(bench.at("/contacts/0/radii"), json!([40, 12]));
    open_card(&mut bench, "contacts.0");
    bench.fill("[data-path='contacts.0.name'] input", "2");
    assert_eq!(bench.at("/contacts/0/name"), "2");
    // The paper's cam again: what it gives is what the starting scene gives.
    // The starting scene gives the same numbers. By hand: K is 20 mm from A at 50°, C above (8, 0) at 52 mm from K; where the roller touches, the
    // velocity of D, straight up, and that of K, ω · 20 mm at 140°, have one part along KC.
    let angle = 50.0_f64.to_radians();
    let [x, y] = [20.0 * libm::cos(angle), 20.0 * libm::sin(angle)];
    let [along_x, along_y] = [8.0 - x, libm::sqrt(52.0 * 52.0 - (8.0 - x) * (8.0 - x))];
    let wanted = (-15.0 * y * along_x + 15.0 * x * along_y) / along_y;
    let found = value(&mut bench, "v_r(3/ground)");
    assert!((found - wanted).abs() < 1e-5, "{found} {wanted}");
    bench.picture("joints-cam");
    // A flat follower: the second profile has a direction.
    bench.choose("[data-path='contacts.0.roller'] select", "flat");
    assert_eq!([bench.at("/contacts/0/centers"), bench.at("/contacts/0/roller")], [json!(["K"]), json!(null)]);
    bench.choose("[data-path='contacts.0.along'] select", "an angle");
    bench.fill("[data-path='contacts.0.along'] input", "-90");
    assert_eq!(refused(&mut bench), "", "{}", bench.scene());
    bench.picture("joints-flat");
    bench.value("document.querySelector(\"[data-path='contacts.0.circular'] input\").click()");
    bench.settle();
    assert!(bench.at("/contacts/0/circular").is_null(), "what is usual is not written");
    bench.press_named("#panel-mechanism [data-path='contacts.0']", "Remove");
    assert!(bench.at("/contacts").is_null());
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn wheels_are_added_and_removed_by_keys() {
    let mut bench = opened("joints-keys", SHAFT);
    bench.value("document.querySelector(\"[data-path='gears'] > summary\").focus()");
    bench.press("Enter");
    bench.value("document.querySelector(\"[data-path='gears.+'] button\").focus()");
    bench.press("Enter");
    bench.settle();
    assert_eq!(bench.at("/gears/0/teeth"), json!([20, 40]));
    assert_eq!(bench.value("document.activeElement.closest('#panel-mechanism') !== null"), true);
    bench.value("document.querySelector(\"[data-path='gears.0.teeth.0'] input\").focus()");
    bench.press("ArrowUp");
    bench.settle();
    assert_eq!(bench.at("/gears/0/teeth"), json!([21, 40]));
    bench.value("document.querySelector(\"[data-path='gears.0'] header .buttons button\").focus()");
    bench.press("Enter");
    bench.settle();
    assert!(bench.at("/gears").is_null());
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn wheels_and_cams_fit_a_telephone() {
    for (name, text) in [
        ("planetary", files::read("templates/planetary.json")),
        ("eccentric-cam", files::read("templates/eccentric-cam.json")),
    ] {
        let mut bench = Bench::closed(&format!("joints-telephone-{name}"), None);
        bench.telephone([360, 640]);
        bench.load("");
        bench.put(&text);
        bench.value("kinegon.app.show('mechanism')");
        bench.settle();
        let groups = "#panel-mechanism [data-path='gears']";
        bench.value(&format!("document.querySelectorAll(\"{groups} .more\").forEach((more) => more.click())"));
        bench.settle();
        bench.value(&format!("document.querySelector(\"{groups} .card\").scrollIntoView()"));
        bench.frame();
        bench.picture(&format!("joints-telephone-{name}"));
        assert_eq!(bench.value("document.documentElement.scrollWidth"), 360);
        let wide = bench.value(&format!(
            "[...document.querySelectorAll(\"{groups} :is(button, input, select, label)\")] \
             .filter((e) => e.getBoundingClientRect().right > 361).map((e) => e.className || e.tagName)"
        ));
        assert_eq!(wide, json!([]), "wider than the screen");
        bench.assert_quiet();
    }
}
