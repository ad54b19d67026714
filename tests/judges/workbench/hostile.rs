//! What others send: broken, huge and foreign links, large scenes, texts that are not whole yet.

use super::bench::Bench;
use base64::Engine;
use base64::prelude::BASE64_URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use serde_json::{Value, json};
use std::io::Write;
use support::{files, survey};

/// The address part of a link with that JSON in it.
fn packed(version: u32, json: &str) -> String {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(json.as_bytes()).expect("memory");
    format!("#{version}={}", BASE64_URL_SAFE_NO_PAD.encode(encoder.finish().expect("memory")))
}

#[test]
#[ignore = "needs Chromium"]
fn a_bad_link_is_told_and_harms_nothing() {
    let mut bench = Bench::open("bad-link");
    let own = bench.scene();
    let whole = packed(1, &json!({ "text": own }).to_string());
    let bomb = packed(1, &format!("{{\"text\":\"{}\"}}", " ".repeat(200_000_000)));
    assert!(bomb.len() < 300_000);
    for (what, link, said) in [
        ("cut", whole[..whole.len() / 2].to_owned(), "damaged"),
        ("no base64", "#1=!!!%%%".to_owned(), "damaged"),
        ("no JSON", packed(1, "not json"), "damaged"),
        ("no document", packed(1, "[1, 2]"), "damaged"),
        ("newer", packed(9, "{}"), "newer"),
        ("huge", bomb, "more text"),
    ] {
        bench.load(&link);
        let told = bench.text("document.querySelector('#said').textContent");
        assert!(told.contains(said), "{what}: {told}");
        assert_eq!(bench.scene(), own, "{what}");
        assert!(bench.marks().contains("<path"), "{what}: a picture stands");
    }
    bench.load("#chapter-3");
    assert_eq!(bench.scene(), own, "an anchor is no link");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_foreign_text_is_text() {
    let mut bench = Bench::open("foreign");
    let odd = "<img src=x onerror=alert(1)></script><script>window.harmed = 1</script>\u{202e}";
    let mut scene: Value = serde_json::from_str(&files::read("templates/four-bar.json")).expect("JSON");
    scene["title"] = odd.into();
    scene["figure"] = json!({ "labels": { "B": odd, "3": odd } });
    let text = serde_json::to_string_pretty(&scene).expect("JSON");
    bench.load(&packed(1, &json!({ "text": text, "form": odd, "panel": odd }).to_string()));
    assert_eq!(bench.scene(), text);
    for panel in ["mechanism", "text", "figure", "values", "curves", "modes", "check", "exercise", "save"] {
        bench.panel(panel);
    }
    // The editor has pictures of its own beside what it shows in place of signs that nobody sees.
    let strange = "document.querySelectorAll('img:not(.cm-widgetBuffer), #panels script, #sheet script').length";
    let found = bench.value(&format!("[window.harmed, {strange}]"));
    assert_eq!(found, json!([null, 0]));
    bench.put(&text.replace("\"links\"", &format!("\"{}\"", odd.replace('"', ""))));
    assert!(!bench.message().is_empty());
    assert_eq!(bench.value("window.harmed ?? null"), Value::Null);
    bench.picture("foreign");
    bench.assert_quiet();
}

/// A row of that many four-bar linkages, each driven by the rocker of the one before.
pub fn row(linkages: usize) -> String {
    let (mut ground, mut links, mut near) = (String::new(), String::new(), String::new());
    for k in 0..linkages {
        let x = 100 * k;
        ground += &format!(", \"D{k}\": [{}, 0]", x + 100);
        let (pin, link) =
            if k == 0 { ("B".to_owned(), "1".to_owned()) } else { (format!("C{}", k - 1), format!("r{}", k - 1)) };
        if k == 0 {
            links += "\"1\": { \"points\": [\"A\", \"B\"], \"lengths\": { \"AB\": 40 }, \"drive\": { \"angle\": 80, \"omega\": 3 } }";
        }
        let _ = link;
        links += &format!(
            ", \"c{k}\": {{ \"points\": [\"{pin}\", \"C{k}\"], \"lengths\": {{ \"{pin}C{k}\": 100 }} }}, \
             \"r{k}\": {{ \"points\": [\"D{k}\", \"C{k}\"], \"lengths\": {{ \"D{k}C{k}\": 40 }} }}"
        );
        near += &format!("{}\"C{k}\": [{}, 39]", if k == 0 { "" } else { ", " }, x + 107);
    }
    format!(
        "{{ \"kinegon\": 1, \"units\": {{ \"length\": \"mm\", \"time\": \"s\" }}, \"ground\": {{ \"A\": [0, 0]{ground} }}, \
         \"links\": {{ {links} }}, \"near\": {{ {near} }} }}"
    )
}

#[test]
#[ignore = "needs Chromium"]
fn a_scene_of_two_hundred_links_is_drawn() {
    let mut bench = Bench::open("large");
    let before = bench.marks();
    let begin = bench.number("performance.now()");
    bench.put(&row(100));
    bench.until("/201/.test(document.querySelector('#warnings').textContent)");
    println!("201 links after {:.0} ms", bench.number("performance.now()") - begin);
    assert_eq!(bench.message(), "");
    assert_ne!(bench.marks(), before, "it is drawn, without steps and joints to pull");
    bench.picture("large");
    let begin = bench.number("performance.now()");
    bench.put(&row(70));
    bench.until("kinegon.app.picture.value.handles.length > 60");
    println!("141 links after {:.0} ms", bench.number("performance.now()") - begin);
    bench.pull_joint("B", [6.0, 6.0]);
    bench.click("#undo");
    bench.settle();
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_scene_typed_letter_by_letter_never_leaves_the_page_blank() {
    let mut bench = Bench::open("typed");
    let whole: Value = serde_json::from_str(&files::read("templates/slider-crank.json")).expect("JSON");
    let whole = serde_json::to_string(&whole).expect("JSON");
    // Beginnings of the text up to all of it, as fast as the page can take them.
    let blank = bench.value(&format!(
        "(async () => {{ const whole = {}; const bad = []; \
         for (let k = whole.length % {every}; k <= whole.length; k += {every}) {{ \
           const text = whole.slice(0, k); kinegon.history.change({{ text }}, 'typing'); \
           while (kinegon.app.solved.value.text !== text) await new Promise((done) => setTimeout(done)); \
           const told = !document.querySelector('#message').hidden; \
           const refused = kinegon.app.solved.value.refused !== null; \
           if (told !== refused || !document.querySelector('#sheet path')) bad.push(k); }} \
         return bad; }})()",
        json!(whole),
        every = survey::BEGINNINGS.now()
    ));
    assert_eq!(blank, json!([]));
    bench.settle();
    assert_eq!((bench.message(), bench.scene()), (String::new(), whole.clone()));
    // The same by keys in the editor, for its end.
    bench.panel("text");
    bench.focus("#panel-text .cm-content");
    bench.press("Control+End");
    for _ in 0..12 {
        bench.press("Backspace");
    }
    bench.until("!document.querySelector('#message').hidden");
    bench.picture("typed");
    bench.press("Control+z");
    bench.settle();
    assert_eq!(bench.scene(), whole);
    bench.assert_quiet();
}
