//! Where the picture is seen: laid out for its pane, still while the mechanism moves, legible on a telephone; on paper it is
//! the file.

use super::bench::Bench;
use serde_json::{Value, json};
use support::{files, survey};

/// Notes of each picture what must stand still: panels, poles, bars of scales; and what is cut.
const WATCH: &str = r#"(() => {
    const place = (id) => {
        const mark = document.querySelector(`#sheet [id="${id}"]`);
        if (mark === null) return null;
        const { x, y, width, height } = mark.getBoundingClientRect();
        return [x + width / 2, y + height / 2, width];
    };
    const seen = () => {
        const { panels, notes } = kinegon.app.picture.value;
        const plans = panels.map(({ key }) => key).filter((key) => key !== 'scheme');
        const poles = [['velocity', 'p'], ['acceleration', 'pi']].filter(([plan]) => plans.includes(plan));
        return {
            cut: panels.filter(({ is_cut }) => is_cut).map(({ key }) => key),
            boxes: panels.map(({ box }) => box),
            poles: poles.map(([plan, pole]) => place(`${plan}-point-${pole}`)),
            bars: panels.map(({ key }) => place(`scale-${key}`)),
            notes,
        };
    };
    window.seen = seen;
    window.pictures = [seen()];
    window.unwatch = kinegon.app.picture.on(() => window.pictures.push(seen()));
})()"#;

/// So many pictures after it began to move nothing of its scales is as it was at rest.
const EASED: usize = 20;

/// The farthest that something is from where it was at first, in pixels or mm.
fn wander(pictures: &[Value], what: &str) -> f64 {
    let numbers = |value: &Value| -> Vec<f64> {
        let lists = value[what].as_array().expect("a list").iter();
        lists.flat_map(|list| list.as_array().cloned().unwrap_or_default()).filter_map(|n| n.as_f64()).collect()
    };
    let first = numbers(&pictures[0]);
    let off = |picture: &Value| {
        let now = numbers(picture);
        assert_eq!(now.len(), first.len(), "{what}: {picture}");
        now.iter().zip(&first).map(|(now, first)| (now - first).abs()).fold(0.0, f64::max)
    };
    pictures.iter().map(off).fold(0.0, f64::max)
}

#[test]
#[ignore = "needs Chromium"]
fn it_stands_still_while_it_plays() {
    let mut bench = Bench::open("still");
    // What is as drawn does not move.
    let moves =
        |(_, text): &(String, String)| serde_json::from_str::<Value>(text).expect("JSON").get("points").is_none();
    let folders = ["templates", "tests/lecture", "examples"];
    let scenes = folders.into_iter().flat_map(files::scenes).filter(moves);
    let mut turned = 0;
    for (name, text) in scenes.step_by(survey::PLAYED.now()) {
        bench.put(&text);
        let drives = bench.value("kinegon.app.solved.value.opened.drives");
        if drives == json!([]) || bench.value("kinegon.app.solved.value.opened.is_drawn") == true {
            continue;
        }
        bench.value(WATCH);
        bench.choose("#speed", "4");
        bench.press(" ");
        bench.until("document.querySelector('#play').ariaPressed === 'true' && window.pictures.length > 12");
        bench.value("new Promise((done) => setTimeout(done, 1700))");
        bench.press(" ");
        bench.until("document.querySelector('#play').ariaPressed === 'false'");
        bench.settle();
        // Letting go changes nothing.
        let pictures = bench.value("(window.unwatch(), window.pictures.push(window.seen()), window.pictures)");
        let pictures = pictures.as_array().expect("a list");
        assert!(pictures.len() > 8, "{name}: {} pictures", pictures.len());
        for what in ["boxes", "poles"] {
            let off = wander(pictures, what);
            assert!(off <= 0.5, "{name}: {what} wander by {off}");
        }
        // Plans that are larger at rest have the scales of the cycle after some pictures.
        let off = wander(&pictures[EASED.min(pictures.len() - 1)..], "bars");
        assert!(off <= 0.5, "{name}: bars wander by {off}");
        // A drive that swings may send vectors to infinity at the ends of its range; several together stop where the first
        // of them does.
        let is_round = drives[0]["low"].is_null() && drives[1].is_null();
        let cut = pictures.iter().filter(|picture| picture["cut"] != json!([])).count();
        println!("{name}: {} pictures, cut in {cut}", pictures.len());
        assert!(cut == 0 || !is_round, "{name}: cut in {cut} of {} pictures", pictures.len());
        turned += usize::from(drives[0]["low"].is_null());
    }
    assert!(turned > 0);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn on_paper_the_screen_is_the_file() {
    let mut bench = Bench::open("paper");
    let (screen, shown) = (bench.marks(), bench.shown());
    bench.click("#as-paper");
    bench.until_other(&screen);
    let svg = "kinegon.app.picture.value.svg";
    let count = bench.number("kinegon.app.solved.value.opened.steps.length");
    let text = bench.scene();
    let file = |bench: &mut Bench, of: Value| {
        let asked = json!({ "format": "svg", "of": of });
        bench.text(&format!(
            "kinegon.engine.file({}, {asked}).then((bytes) => new TextDecoder().decode(bytes))",
            json!(text)
        ))
    };
    let of_program = support::program::with_scene(&["draw", "-", "-o", "-"], text.as_bytes()).stdout;
    assert_eq!(file(&mut bench, json!("figure")).as_bytes(), of_program);
    assert!(bench.text(svg).as_bytes() == of_program, "at rest");
    for step in [1.0, (count / 2.0).floor(), count] {
        bench.value(&format!("kinegon.app.view.set({{ ...kinegon.app.view.value, step: {step} }})"));
        bench.settle();
        let saved = file(&mut bench, json!({ "step": step }));
        assert!(bench.text(svg) == saved, "at step {step}");
    }
    bench.press("End");
    bench.settle();
    assert!(bench.text(svg).as_bytes() == of_program, "at the end");
    bench.picture("paper");
    let paper = bench.marks();
    bench.click("#as-paper");
    bench.until_other(&paper);
    // The bar of the steps leaves less of the pane.
    bench.click("#steps-toggle");
    bench.settle();
    assert_eq!(bench.shown(), shown);
    bench.assert_quiet();
}

/// The smallest letters of the picture that are no marks of others, in pixels.
const LETTERS: &str = "Math.min(...[...document.querySelectorAll('#sheet text')].map((text) => \
    parseFloat(getComputedStyle(text).fontSize) * document.querySelector('#sheet').getScreenCTM().a))";

#[test]
#[ignore = "needs Chromium"]
fn letters_are_read_on_every_screen() {
    let mut bench = Bench::open("letters");
    for (name, size, least) in [
        ("desk", [1280, 800], 12.0),
        ("large", [1920, 1080], 14.0),
        ("tablet", [820, 1180], 12.0),
        ("telephone", [390, 844], 11.0),
        ("lying", [844, 390], 11.0),
        // That of 1280 pixels at twice its size.
        ("zoomed", [640, 400], 11.0),
    ] {
        if size[0].min(size[1]) < 400 {
            bench.telephone(size);
        } else {
            bench.screen(size, 1.0);
        }
        if size[0] < 960 {
            bench.value("kinegon.app.show('')");
        }
        bench.frame();
        bench.settle();
        let letters = bench.number(LETTERS);
        assert!(letters >= least - 0.05, "{name}: {letters} px");
        let [.., width, height] = bench.place("#pane");
        let share = width * height / f64::from(size[0] * size[1]);
        println!("{name}: letters of {letters:.1} px, the picture has {:.0} % of the window", 100.0 * share);
        assert!(share > 0.4, "{name}: {share}");
        bench.picture(&format!("surface-{name}"));
    }
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_plan_is_large_beside_the_scheme() {
    let mut bench = Bench::open("focus");
    let panels = "kinegon.app.picture.value.panels";
    let before = bench.marks();
    bench.press("2");
    bench.until_other(&before);
    let keys = bench.value(&format!("{panels}.map(({{ key }}) => key)"));
    assert_eq!(keys, json!(["scheme", "velocity"]));
    let share = bench.number(
        "(({ panels, width, height }) => panels[1].box[2] * panels[1].box[3] / (width * height))(kinegon.app.picture.value)"
    );
    assert!(share > 0.5, "the plan has {share} of the picture");
    bench.press("p");
    bench.until("document.body.classList.contains('presenting')");
    bench.settle();
    let filled = bench.number("document.querySelector('#pane').clientHeight / innerHeight");
    assert!(filled > 0.99, "{filled}");
    bench.picture("full-screen-plan");
    bench.press("Escape");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_message_leaves_the_picture_where_it_is() {
    let mut bench = Bench::open("message");
    let seen = "[document.querySelector('#sheet').getAttribute('viewBox'), document.querySelector('#pane').clientHeight, kinegon.app.picture.value.svg]";
    for size in [[1280, 800], [390, 844]] {
        bench.screen(size, 1.0);
        bench.frame();
        bench.settle();
        let before = bench.value(seen);
        bench.value(
            "kinegon.history.change({ text: kinegon.history.now.value.text.replace('\"links\"', '\"linkz\"') })",
        );
        bench.settle();
        assert!(!bench.message().is_empty());
        bench.frame();
        assert_eq!(bench.value(seen), before, "{size:?}");
        // It can be read and used: nothing lies over its button.
        let [x, y, ..] = bench.place("#message-place");
        assert_eq!(bench.text(&format!("document.elementFromPoint({x}, {y}).closest('button').id")), "message-place");
        bench.picture(&format!("message-{}", size[0]));
        bench.value("kinegon.history.undo()");
        bench.settle();
    }
    bench.assert_quiet();
}

/// Notes which pictures of those to come the page holds otherwise than if it had been filled with them anew, and how many elements stay from one to the next.
const MENDED: &str = r#"(() => {
    const sheet = document.querySelector('#sheet');
    const fresh = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    Object.assign(window, { count: 0, other: [], stayed: 0, elements: 0 });
    let before = new Set();
    window.unwatch = kinegon.app.picture.on(({ svg }) => {
        fresh.innerHTML = svg.slice(svg.indexOf('>', svg.indexOf('<svg')) + 1, svg.lastIndexOf('</svg>'));
        fresh.querySelectorAll(':scope > title, :scope > desc').forEach((element) => (element.previousSibling?.remove(), element.remove()));
        if (fresh.innerHTML !== sheet.innerHTML) window.other.push(window.count);
        const now = [...sheet.querySelectorAll('*')];
        if (window.count > 0) {
            window.stayed += now.filter((element) => before.has(element)).length;
            window.elements += now.length;
        }
        before = new Set(now);
        window.count += 1;
    });
})()"#;

#[test]
#[ignore = "needs Chromium"]
fn a_moving_picture_is_mended_as_if_it_were_filled_anew() {
    let mut bench = Bench::open("mended");
    for scene in ["examples/figure-2.json", "tests/lecture/jansen.json"] {
        bench.put(&files::read(scene));
        bench.value(MENDED);
        bench.press(" ");
        bench.until("window.count > 25");
        bench.press(" ");
        bench.until("document.querySelector('#play').ariaPressed === 'false'");
        bench.settle();
        bench.value("window.unwatch()");
        assert_eq!(bench.value("window.other"), json!([]), "{scene}");
        let share = bench.number("window.stayed / window.elements");
        println!("{scene}: {:.0} % of the elements stay", 100.0 * share);
        assert!(share > 0.5, "{scene}: {share}");
    }
    bench.assert_quiet();
}
