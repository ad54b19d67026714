//! Whatever hands do, undo leads back.

use super::bench::Bench;
use serde_json::json;
use support::files;
use support::survey::GESTURES;

/// Numbers by lot, always the same.
struct Lot(u64);

impl Lot {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % end
    }

    fn pixels(&mut self) -> f64 {
        self.below(161) as f64 - 80.0
    }
}

/// Does something by lot: pulls a joint in one of both hands, moves the drive, changes a number, a look, a mode.
fn act(bench: &mut Bench, lot: &mut Lot) -> String {
    let what = lot.below(6);
    match what {
        0 | 1 => {
            bench.click(if what == 0 { "#hand-move" } else { "#hand-shape" });
            bench.settle();
            let count = bench.number("document.querySelectorAll('#handles .handle').length") as usize;
            let name = bench.text(&format!(
                "document.querySelectorAll('#handles .handle')[{}].dataset.point",
                lot.below(count.max(1))
            ));
            let by = [lot.pixels(), lot.pixels()];
            bench.pull_joint(&name, by);
            format!("{what}: {name} by {by:?}")
        }
        2 => {
            bench.focus("#drives input");
            for _ in 0..1 + lot.below(5) {
                bench.press("ArrowRight");
            }
            bench.value("document.activeElement.blur()");
            "drive".to_owned()
        }
        3 => {
            let links = bench.value(
                "Object.entries(JSON.parse(kinegon.app.solved.value.good).links) \
                .flatMap(([n, l]) => Object.entries(l.lengths ?? {}).map(([k, v]) => [n, k, v]))",
            );
            let links = links.as_array().expect("lengths");
            let [link, key, value] = [0, 1, 2].map(|k| links[lot.below(links.len())][k].clone());
            let value = value.as_f64().unwrap_or(50.0) * (0.9 + 0.02 * lot.below(11) as f64);
            let edit = json!([{ "set": ["links", link, "lengths", key], "value": value.round() }]);
            bench.value(&format!(
                "kinegon.engine.edit(kinegon.history.now.value.text, {edit}).then((text) => kinegon.history.change({{ text }}), () => 0)"
            ));
            format!("{edit}")
        }
        4 => {
            let style = ["paper", "print", "lecture", "board"][lot.below(4)];
            let edit = json!([{ "set": ["figure", "style"], "value": style }]);
            bench.value(&format!(
                "kinegon.engine.edit(kinegon.history.now.value.text, {edit}).then((text) => kinegon.history.change({{ text }}), () => 0)"
            ));
            style.to_owned()
        }
        _ => {
            let number = 1 + lot.below(2);
            bench.value(&format!(
                "kinegon.engine.choose_mode(kinegon.history.now.value.text, {number}).then((text) => kinegon.history.change({{ text }}), () => 0)"
            ));
            format!("mode {number}")
        }
    }
}

#[test]
#[ignore = "needs Chromium"]
fn any_way_leads_back() {
    let start = files::read("templates/four-bar.json");
    let mut bench = Bench::of("walk", &start);
    let first = bench.marks();
    for seed in 1..=GESTURES.now() {
        let mut lot = Lot(seed);
        let mut done = Vec::new();
        for _ in 0..12 {
            done.push(act(&mut bench, &mut lot));
            bench.settle();
            assert!(bench.marks().contains("<path"), "{done:?}: blank");
        }
        let end = bench.scene();
        let mut back = 0;
        while bench.value("kinegon.history.canUndo.value") == true {
            bench.click("#undo");
            back += 1;
        }
        bench.settle();
        assert!(back <= done.len(), "{back} entries of {} gestures: {done:?}", done.len());
        assert_eq!(bench.scene(), start, "{done:?}");
        assert_eq!(bench.marks(), first, "{done:?}");
        for _ in 0..back {
            bench.click("#redo");
        }
        bench.settle();
        assert_eq!(bench.scene(), end, "{done:?}");
        for _ in 0..back {
            bench.click("#undo");
        }
        bench.settle();
    }
    bench.assert_quiet();
}
