//! `<kinegon-plan>` in a page of somebody else: `web/build --component` makes it.

use serde_json::{Value, json};
use std::path::PathBuf;
use support::browser::Browser;
use support::files;
use support::program::scratch;
use support::stages::solved;

/// The component's file.
fn built() -> PathBuf {
    let given = std::env::var_os("KINEGON_COMPONENT").map(PathBuf::from);
    let file = given.unwrap_or_else(|| files::path("target/component")).join("kinegon-plan.js");
    assert!(file.is_file(), "the component has not been built: web/build --component");
    file
}

/// Tells which workers are started and which events come.
const WATCH: &str = "<script>window.workers = 0; window.heard = []; \
    window.Worker = class extends Worker { constructor(...given) { super(...given); window.workers += 1; } }; \
    for (const name of ['ready', 'step', 'change', 'play', 'error']) \
        document.addEventListener(`kinegon-${name}`, (e) => heard.push([e.target.id, name, e.detail]));</script>";

/// A page with these elements, in a browser; all plans are brought into sight.
fn page(name: &str, body: &str) -> Browser {
    // Within the page, for a test may ask for nothing outside.
    let component = std::fs::read_to_string(built()).expect("it can be read");
    let folder = scratch(&format!("component-{name}"));
    let text = format!(
        "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>Lecture</title>{WATCH}\
         <script>{component}</script></head><body><main><h1>Lecture</h1>{body}</main></body></html>"
    );
    let file = folder.join("lecture.html");
    std::fs::write(&file, text).expect("the test's folder can be written");
    let mut browser = Browser::start(&folder, [900, 800]);
    browser.open(&file, "document.readyState === 'complete'");
    browser.value(
        "(async () => { for (const plan of document.querySelectorAll('kinegon-plan')) { plan.scrollIntoView(); await plan.ready; } })()",
    );
    browser
}

/// An element with a scene.
fn plan(id: &str, attributes: &str, scene: &str) -> String {
    format!("<kinegon-plan id=\"{id}\" {attributes}><script type=\"application/json\">{scene}</script></kinegon-plan>")
}

/// What was heard of one of them by this name.
fn heard(browser: &mut Browser, id: &str, name: &str) -> Vec<Value> {
    let all = browser.value("heard");
    let all = all.as_array().expect("a list").iter();
    all.filter(|one| one[0] == id && one[1] == name).map(|one| one[2].clone()).collect()
}

#[test]
#[ignore = "needs Chromium, and the component: web/build --component"]
fn two_plans_share_a_page_and_an_engine() {
    let figure = files::read("examples/figure-2.json");
    let own = solved(&figure).expect("it is solved");
    let body =
        plan("a", "controls step=\"3\"", &figure) + &plan("b", "controls", &files::read("templates/four-bar.json"));
    let mut browser = page("two", &body);
    assert_eq!(browser.value("workers"), 1, "one worker for all");
    let steps = own.construction.numbered_steps().count();
    assert_eq!(heard(&mut browser, "a", "ready")[0]["steps"], steps);
    browser.picture("component-two");
    // By its own methods, by keys, by the attribute.
    browser.value("a.next()");
    assert_eq!(browser.value("a.step"), 4);
    browser.value("a.shadowRoot.querySelector('#step-slider').focus()");
    browser.press("ArrowRight");
    assert_eq!(browser.value("a.step"), 5);
    browser.value("a.setAttribute('step', '2')");
    let told: Vec<Value> = heard(&mut browser, "a", "step").iter().map(|step| step["step"].clone()).collect();
    assert_eq!(told, [4, 5, 2]);
    assert_eq!(browser.value("b.step"), Value::Null, "the other one stays");
    // A joint goes by keys, and the scene with it; the other plan's stays.
    browser.value("b.shadowRoot.querySelector('#handle-B').focus()");
    let [before, others] = ["JSON.stringify(b.scene)", "JSON.stringify(a.scene)"].map(|text| browser.text(text));
    browser.press("ArrowRight");
    browser.until(&format!("JSON.stringify(b.scene) !== {}", json!(before)));
    assert_eq!(browser.text("JSON.stringify(a.scene)"), others);
    // Both run at once.
    browser.value("a.step = null; a.play(); b.play()");
    for id in ["a", "b"] {
        let at = format!("{id}.shadowRoot.querySelector('#drives input[type=text]').value");
        let began = browser.text(&at);
        browser.until(&format!("{at} !== {}", json!(began)));
        // Each shows its own mechanism: joint E is in the first alone.
        let has_e = browser.value(&format!("{id}.shadowRoot.querySelector('#handle-E') !== null"));
        assert_eq!(has_e, id == "a", "{id}");
        browser.value(&format!("{id}.pause()"));
        assert_eq!(browser.value(&format!("{id}.playing")), false);
    }
    browser.assert_quiet();
}

#[test]
#[ignore = "needs Chromium, and the component: web/build --component"]
fn values_and_verdicts_are_those_of_the_program() {
    let four_bar = files::read("templates/four-bar.json");
    let own = solved(&four_bar).expect("it is solved");
    let mut browser = page("values", &plan("a", "", &four_bar));
    let values = browser.value("a.values()");
    let values = values.as_array().expect("a list");
    let rows = own.digit_rows();
    assert_eq!(values.len(), rows.len());
    for (value, row) in values.iter().zip(&rows) {
        assert_eq!([&value["name"], &value["value"], &value["unit"]], [&row.name, &row.value, &row.unit]);
    }
    let [_, _, second] = ["omega(1)", "alpha(1)", "omega(2)"];
    let right = rows.iter().find(|row| row.name == second).expect("it has a value").value.clone();
    for (value, expected) in [(json!(right), "right"), (json!("1000"), "off")] {
        let verdict = browser.value(&format!("a.check({{ '{second}': Number({value}) }})"));
        assert_eq!(verdict["result"]["values"][0]["verdict"], expected, "{value}");
        // One value is not all that the scene asks for.
        assert_eq!(verdict["result"]["passed"], false, "{value}");
    }
    browser.assert_quiet();
}

#[test]
#[ignore = "needs Chromium, and the component: web/build --component"]
fn a_bad_scene_is_one_message_and_its_picture_stays() {
    let picture = "<img id=\"instead\" alt=\"Four-bar\" src=\"data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' width='40' height='30'/%3E\">";
    let bad = plan("bad", "controls", "{ \"kinegon\": 1, \"links\": [ }")
        .replace("</kinegon-plan>", &format!("{picture}</kinegon-plan>"));
    let body =
        bad + "<kinegon-plan id=\"none\"></kinegon-plan>" + &plan("good", "", &files::read("templates/four-bar.json"));
    let mut browser = page("bad", &body);
    for id in ["bad", "none"] {
        let shown = browser.text(&format!("{id}.shadowRoot.querySelector('[role=alert]').innerText"));
        let is_seen = browser.value(&format!("{id}.shadowRoot.querySelector('[role=alert]').getClientRects().length"));
        assert_eq!(is_seen, 1, "{id}");
        let errors = heard(&mut browser, id, "error");
        assert_eq!(errors.len(), 1, "{id}");
        assert_eq!(errors[0]["message"], shown);
        assert!(!shown.is_empty());
    }
    assert_eq!(browser.value("instead.getClientRects().length"), 1, "what stands in its place is seen");
    assert_eq!(heard(&mut browser, "good", "ready").len(), 1);
    // A good one in its place.
    browser.value(&format!("bad.scene = {}", json!(files::read("templates/watt-1.json"))));
    browser.until("bad.shadowRoot.querySelector('#sheet path') !== null");
    assert_eq!(
        browser.value("bad.shadowRoot.querySelector('#message').hidden && instead.getClientRects().length === 0"),
        true
    );
    browser.picture("component-bad");
    browser.assert_quiet();
}

#[test]
#[ignore = "needs Chromium, and the component: web/build --component"]
fn nobody_is_kept_out() {
    let body = plan("a", "controls step=\"3\"", &files::read("examples/figure-2.json"));
    let mut browser = page("axe", &body);
    browser.value(&super::workbench::access::axe());
    for (background, width) in [("white", 900), ("#111", 900), ("white", 320)] {
        browser.screen([width, 800], 1.0);
        browser.value(&format!(
            "document.body.style.background = '{background}'; document.querySelector('h1').style.color = 'gray'"
        ));
        let is_dark = background != "white";
        browser.until(&format!("(a.shadowRoot.querySelector('#component').dataset.theme === 'dark') === {is_dark}"));
        browser.value("new Promise((done) => setTimeout(done, 600))");
        let found = browser.text(
            "axe.run(document.querySelector('kinegon-plan'), { resultTypes: ['violations'] }).then(({ violations }) => \
             violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(' ')).join(', ')}`).join('\\n'))",
        );
        assert_eq!(found, "", "{background}, {width}");
        assert!(browser.number("document.documentElement.scrollWidth") <= f64::from(width), "{width}");
        browser.picture(&format!("component-{}-{width}", if is_dark { "dark" } else { "light" }));
    }
    browser.assert_quiet();
}
