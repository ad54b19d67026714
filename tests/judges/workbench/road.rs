//! The student's road to its end, by the link alone, on a large screen and on a telephone: the sheets printed, the plans drawn on the board, the
//! values typed as people type them.

use super::bench::Bench;
use super::board::{Hand, begin, known};
use super::share::papers;
use serde_json::{Value, json};
use support::files;

/// What is said below the sheets of the board.
const SAYS: &str = "document.querySelector('#board .says').textContent";
/// Whether that is a complaint.
const COMPLAINS: &str = "document.querySelector('#board .says').matches('.bad')";

/// Makes an exercise in the page, and gives the part of its link behind the page's name: for drawings on paper, or for the use of the board of this number.
fn given(bench: &mut Bench, board: usize) -> String {
    bench.panel("exercise");
    bench.choose("#panel-exercise select", "Four-bar");
    bench.until("document.querySelector('#panel-exercise').textContent.includes('four-bar-1-1')");
    bench.until("document.querySelector('#panel-exercise .sheet svg') !== null");
    bench.settle();
    bench.value(&format!(
        "(() => {{ const e = document.querySelector('#panel-exercise .board-choice select'); e.value = '{board}'; e.dispatchEvent(new Event('change')); }})()"
    ));
    bench.press_named("#panel-exercise", "Link for students");
    let address = "[...document.querySelectorAll('#panel-exercise input')].find((e) => e.value.includes('#1='))?.value";
    bench.until(&format!("{address} !== undefined"));
    let link = bench.text(address);
    // The page is a file of this computer.
    assert!(link.starts_with("file:"), "{link}");
    let said = bench.text("document.querySelector('#panel-exercise').textContent");
    assert!(said.contains("links work only here"), "{said}");
    link[link.find('#').expect("a link")..].to_owned()
}

/// Prints, and gives how large the sheets and their pages are, in mm.
fn printed(bench: &mut Bench, panel: &str) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    bench.value("window.print = () => { window.asked = true; }");
    bench.press_named(panel, "Print at 100");
    bench.until("window.asked === true");
    bench.media("print", &[]);
    let sides = bench.value(
        "[...document.querySelectorAll('#print svg')].map((e) => { const { width, height } = e.getBoundingClientRect(); \
         return [width, height].map((side) => side / 96 * 25.4); })",
    );
    bench.media("", &[]);
    let sides = sides.as_array().expect("sheets").iter();
    let sides = sides.map(|sheet| [0, 1].map(|k| sheet[k].as_f64().expect("a number")));
    (sides.collect(), papers(&bench.printed()))
}

/// A4 in these ways, every sheet true to scale on a page of its own.
fn assert_all_print(bench: &mut Bench, panel: &str, lies: &[bool]) {
    let (sheets, pages) = printed(bench, panel);
    assert_eq!((sheets.len(), pages.len()), (lies.len(), lies.len()), "{sheets:?}, {pages:?}");
    for (index, is_landscape) in lies.iter().enumerate() {
        let a4 = if *is_landscape { [297.0, 210.0] } else { [210.0, 297.0] };
        for (found, most) in [(sheets[index], 0.2), (pages[index], 0.6)] {
            let is_near = (0..2).all(|k| (found[k] - a4[k]).abs() < most);
            assert!(is_near, "sheet {index}: {found:?} mm for {a4:?}");
        }
    }
}

/// Fills the boxes of the board's sentence and draws.
fn write(bench: &mut Bench, tool: &str, blanks: &[(&str, &str)]) {
    bench.click(&format!("#board [data-tool={tool}]"));
    for (blank, value) in blanks {
        let found = bench.text(&format!(
            "(() => {{ const e = document.querySelector('#board .entry-form [data-blank={blank}]'); e.value = {}; \
             e.dispatchEvent(new Event(e.tagName === 'SELECT' ? 'change' : 'input')); return e.value; }})()",
            json!(value)
        ));
        assert_eq!(found, *value, "{tool}, {blank}");
    }
    bench.click("#board .strip > .main");
    bench.settle();
    assert_eq!(bench.value(COMPLAINS), false, "{tool} {blanks:?}: {}", bench.text(SAYS));
}

/// Draws what is not there yet of Kinegon's own construction.
fn draw_the_rest(bench: &mut Bench) {
    let own = bench.text("kinegon.engine.board_own(kinegon.app.solved.value.good)");
    let own: Value = serde_json::from_str(&own).expect("a drawing");
    for entry in own["did"].as_array().expect("entries") {
        let text = |key: &str| entry[key].as_str().unwrap_or_default().to_owned();
        let item = |key: &str, index: usize| entry[key][index].as_str().unwrap_or_default().to_owned();
        let joined = |key: &str, sign: &str| {
            let all = entry[key].as_array().expect("a list").iter();
            all.filter_map(Value::as_str).collect::<Vec<&str>>().join(sign)
        };
        let (tool, made) = entry.as_object().expect("an entry").iter().next().expect("what it does");
        let known = known(bench);
        let lists = [(&known["things"], text("on")), (&known["numbers"], String::new())];
        let is_there = lists.iter().any(|(list, on)| {
            let all = list.as_array().expect("a list").iter();
            all.filter(|one| on.is_empty() || one["sheet"] == **on).any(|one| one["name"] == *made)
        });
        // The crossing of two lines is on their sheet.
        let is_crossed = tool == "cross" && item("of", 0) == "r1";
        if is_crossed || (tool != "cross" && is_there) {
            continue;
        }
        let how = if entry["along"]["normal"].is_null() { "parallel" } else { "normal" };
        let along = entry["along"][how].as_str().unwrap_or_default().to_owned();
        let made = made.as_str().unwrap_or_default().to_owned();
        let blanks: Vec<(&str, String)> = match tool.as_str() {
            "lay_off" => vec![
                ("on", text("on")),
                ("size", text("size")),
                ("from", text("from")),
                ("how", how.to_owned()),
                ("reference", along),
                ("name", made),
            ],
            "line" => {
                vec![
                    ("on", text("on")),
                    ("how", how.to_owned()),
                    ("reference", along),
                    ("through", text("through")),
                    ("name", made),
                ]
            }
            "cross" => vec![("first", item("of", 0)), ("second", item("of", 1)), ("name", made)],
            "measure" => vec![("on", text("on")), ("from", text("from")), ("to", text("to")), ("name", made)],
            "solve" => vec![("solve", joined("solve", ",")), ("equations", joined("equations", "\n"))],
            other => panic!("no boxes for {other}"),
        };
        let blanks: Vec<(&str, &str)> = blanks.iter().map(|(blank, value)| (*blank, value.as_str())).collect();
        write(bench, tool, &blanks);
    }
}

/// The boxes that are asked for, and what the key has for each.
fn asked(bench: &mut Bench) -> Vec<(Value, f64)> {
    let key = bench.text(
        "(async () => { const { name, seed, number, options } = kinegon.app.task.value; \
         const { text } = (await kinegon.engine.kinds()).find((kind) => kind.name === name); \
         return (await kinegon.engine.exercise(text, name, seed, number, options)).key_values; })()",
    );
    let key: Value = serde_json::from_str(&key).expect("a key");
    let scene = bench.scene();
    let form = bench.ask("form", &[json!(scene), json!("")]);
    let rows = form["rows"].as_array().expect("rows").iter().filter(|row| row["is_asked"] == true);
    let value = |row: &Value| key["values"][row["name"].as_str().expect("a name")]["value"].as_f64().expect("a value");
    rows.map(|row| (row.clone(), value(row))).collect()
}

/// Types into the box of that number and leaves it; what the box is called, what its value comes to, and the verdict.
fn typed(bench: &mut Bench, index: usize, text: &str) -> [String; 3] {
    bench.value(&format!(
        "(() => {{ document.querySelectorAll('[data-box]').forEach((e) => delete e.dataset.box); \
         document.querySelectorAll('#panel-check .row input[inputmode=decimal]')[{index}].dataset.box = ''; }})()"
    ));
    bench.fill("[data-box]", text);
    let of = |class: &str| format!("document.querySelector('[data-box]').closest('.row').querySelector('{class}')");
    bench.until(&format!("!['', 'writing', undefined].includes({}.dataset.kind)", of(".verdict")));
    bench.settle();
    let texts = ["label", ".echo"].map(|class| bench.text(&format!("{}.textContent", of(class))));
    let [label, echo] = texts;
    [label, echo, bench.text(&format!("{}.dataset.kind", of(".verdict")))]
}

/// A value as somebody may write it, and whether it is then said what it comes to.
fn written(row: &Value, value: f64, scale: f64, index: usize) -> (String, bool) {
    let size = value.abs();
    let mm = size / scale;
    if row["is_segment"] == true {
        let unit = row["unit"].as_str().expect("a unit");
        return match index % 6 {
            0 => (format!("{size:.1} {unit}"), true),
            1 => (format!("{:.4} {}", size / 1000.0, unit.replacen("mm", "m", 1)), true),
            2 => (format!("{mm:.1}"), false),
            3 => (format!("{:.2} cm", mm / 10.0).replace('.', ","), true),
            4 => (format!("{size:.1}/{scale}"), false),
            _ => (format!("{:.2} {}", size / 10.0, unit.replacen("mm", "cm", 1)), true),
        };
    }
    let is_alpha = row["unit"].as_str().is_some_and(|unit| unit.ends_with('²'));
    match (is_alpha, index % 2) {
        (false, 0) => (format!("{:+.2} 1/min", value * 30.0 / core::f64::consts::PI), true),
        (false, _) => (format!("{:+.1} °/s", value.to_degrees()), true),
        (true, 0) => (format!("{:+.1} deg/s2", value.to_degrees()), true),
        (true, _) => (format!("{value:+.3}").replace('.', ","), false),
    }
}

fn road(name: &str, is_telephone: bool) {
    let mut bench = Bench::closed(name, None);
    bench.load("");
    let link = given(&mut bench, 1);
    bench.picture(&format!("{name}-1-teacher"));
    assert_all_print(&mut bench, "#panel-exercise", &[true, true, false]);
    if is_telephone {
        bench.telephone([390, 844]);
    }
    // The link leads to the board, and that to the exercise.
    bench.load(&link);
    bench.until("document.querySelector('#board .over[data-sheet=velocity]')?.dataset.window !== undefined");
    bench.settle();
    assert_eq!(bench.value(COMPLAINS), false, "{}", bench.text(SAYS));
    bench.picture(&format!("{name}-2-board"));
    bench.click("#board-close");
    bench.until("document.querySelector('#panel-check .task svg') !== null");
    bench.picture(&format!("{name}-3-exercise"));
    assert_all_print(&mut bench, "#panel-check", &[true, true, false]);
    // On the board.
    begin(&mut bench);
    assert_eq!(bench.value(COMPLAINS), false, "{}", bench.text(SAYS));
    bench.click("#board-check");
    bench.until(&format!("{SAYS} === 'Nothing is drawn yet.'"));
    let first = [("on", "velocity"), ("size", "omega(1)*L(A,B)"), ("from", "p"), ("reference", "1"), ("name", "b")];
    write(&mut bench, "lay_off", &first);
    // Along the coupler in place of across: it leads nowhere, and the next tool begins at right angles again.
    write(&mut bench, "line", &[("how", "parallel"), ("reference", "2"), ("through", "b")]);
    bench.click("#board-check");
    bench.until(&format!("{SAYS} === 'Operation 2 leads to no point of the plan yet. All others are right.'"));
    bench.picture(&format!("{name}-4-nowhere"));
    bench.click("#board [data-tool=lay_off]");
    assert_eq!(bench.text("document.querySelector('#board [data-blank=how]').value"), "normal");
    for _ in 0..2 {
        bench.click("#board-undo");
        bench.settle();
    }
    Hand { bench: &mut bench, is_finger: is_telephone, gestures: 0 }.velocity_plan("2");
    bench.click("#board-check");
    bench.until(&format!("{SAYS} === 'Right so far.'"));
    draw_the_rest(&mut bench);
    bench.click("#board-check");
    bench.until(&format!("{SAYS} === 'All is there, and all is right.'"));
    // What was drawn last is seen.
    let alone = if is_telephone { "acceleration" } else { "" };
    assert_eq!(bench.text("document.querySelector('#board .sheets').dataset.alone"), alone);
    bench.picture(&format!("{name}-5-drawn"));
    bench.click("#board-more");
    bench.press_named("#board-files", "Into the form");
    bench.until(&format!("{SAYS} === 'The values are in the form.'"));
    bench.click("#board-close");
    bench.until("document.querySelector('#panel-check .result .heading.good') !== null");
    bench.picture(&format!("{name}-6-handed-in"));
    // By values, typed as people type them.
    bench.load(&link);
    bench.click("#board-close");
    bench.settle();
    for (index, (row, value)) in asked(&mut bench).into_iter().enumerate() {
        let scale = if row["panel"] == "velocity" { 2.0 } else { 10.0 };
        let (text, is_said) = written(&row, value, scale, index);
        let [label, echo, verdict] = typed(&mut bench, index, &text);
        assert!(["right", "within-tolerance"].contains(&verdict.as_str()), "{label}: {text}: {verdict}");
        assert_eq!(echo.starts_with("= "), is_said, "{label}: {text}: {echo}");
        let says_vector = row["is_segment"] == true;
        assert_eq!(label.contains(" – "), says_vector, "{label}");
    }
    bench.until("document.querySelector('#panel-check .result .heading.good') !== null");
    bench.picture(&format!("{name}-7-typed"));
    // The commonest slip is named at once, and a unit goes with what it was typed with.
    let [.., verdict] = typed(&mut bench, 0, "325");
    assert_eq!(verdict, "off");
    let told = bench.text("document.querySelector('[data-box]').closest('.row').textContent");
    assert!(told.contains("325 is the value in mm/s") && told.contains("325 : 2 = 162.5 mm on paper"), "{told}");
    bench.picture(&format!("{name}-8-slip"));
    for (text, echo) in
        [("0.325 m/s", "= 162.5 mm on paper"), ("162,5", ""), ("16.25 cm", "= 162.5 mm on paper"), ("325/2", "")]
    {
        let [_, found, verdict] = typed(&mut bench, 0, text);
        assert_eq!((found.as_str(), verdict.as_str()), (echo, "right"), "{text}");
    }
    if is_telephone {
        assert_eq!(bench.value("document.documentElement.scrollWidth"), 390);
    }
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_students_road_on_a_large_screen() {
    road("road", false);
}

#[test]
#[ignore = "needs Chromium"]
fn a_students_road_on_a_telephone() {
    road("road-telephone", true);
}

/// Every use of the board opens without a complaint; who looks on sees it drawn.
#[test]
#[ignore = "needs Chromium"]
fn links_about_the_board_open_with_what_to_do() {
    let mut bench = Bench::closed("board-links", None);
    bench.load("");
    let links: Vec<String> = (1..=4).map(|board| given(&mut bench, board)).collect();
    for (board, link) in links.iter().enumerate() {
        // What is said in between counts, too.
        bench.load(link);
        bench.until("document.querySelector('#board .over[data-sheet=velocity]')?.dataset.window !== undefined");
        bench.settle();
        assert_eq!(bench.value(COMPLAINS), false, "{board}: {}", bench.text(SAYS));
        assert_ne!(bench.text(SAYS), "", "{board}");
    }
    // The last is to look on.
    let count = "document.querySelector('#board .replay output').textContent";
    bench.until(&format!("{count} === '0 / 16'"));
    bench.click("#board .replay .play");
    bench.until(&format!("Number({count}.split(' ')[0]) > 2"));
    bench.picture("board-look-on");
    bench.assert_quiet();
}

/// What of the form is seen, and what can be pressed for the answers.
const TOLD: &str = "[...document.querySelectorAll('#panel-check :is(.row, .files, .photograph + .photograph, .result, .foot), #panel-check .verdict:not(:empty)')] \
    .filter((e) => e.checkVisibility()).map((e) => e.className)";

/// In an exam nothing is judged, hinted or shown on any way until the drawing is handed in; then it is, and what comes after says so.
#[test]
#[ignore = "needs Chromium"]
fn an_exam_tells_nothing_before_it_is_handed_in() {
    let mut bench = Bench::closed("exam", None);
    bench.load("");
    let link = given(&mut bench, 3);
    bench.load(&link);
    bench.until("document.querySelector('#board .over[data-sheet=velocity]')?.dataset.window !== undefined");
    // Escape closes the open menu, and not the board.
    bench.click("#board-more");
    bench.until("document.querySelector('#board-files').matches(':popover-open')");
    bench.press("Escape");
    bench.until("!document.querySelector('#board-files').matches(':popover-open')");
    assert_eq!(bench.value("document.querySelector('#board').hidden"), false);
    let first = [("on", "velocity"), ("size", "omega(1)*L(A,B)"), ("from", "p"), ("reference", "1"), ("name", "b")];
    write(&mut bench, "lay_off", &first);
    bench.click("#board-close");
    bench.until("document.querySelector('#panel-check .task svg') !== null");
    bench.picture("exam-panel");
    assert_eq!(bench.value(TOLD), json!([]));
    // Neither another language, nor the help, nor another scene leads to the answers.
    bench.choose("#language", "Deutsch");
    let said = bench.text("document.querySelector('#panel-check').innerText");
    assert!(said.contains("Dies ist eine Prüfung"), "{said}");
    bench.choose("#language", "English");
    bench.click("#help-button");
    assert_eq!(bench.value("document.querySelectorAll('#help .ways button').length"), 1);
    bench.click("#help-close");
    for panel in ["values", "check"] {
        bench.value(&format!("kinegon.app.show('{panel}')"));
        assert_eq!(bench.text("kinegon.app.shown.value"), "check");
    }
    let scene = bench.scene();
    bench.value("kinegon.app.open('{}')");
    assert_eq!(bench.scene(), scene);
    bench.value("kinegon.app.brought.set({ name: 'a.json', text: kinegon.history.now.value.form })");
    bench.settle();
    assert_eq!(bench.value(TOLD), json!([]));
    // Handed in by name, it is judged, and a drawing that goes on after that says that all was told.
    begin(&mut bench);
    bench.click("#board-hand-in");
    bench.fill("#board-hand-in-name", "Ana Müller");
    bench.picture("exam-hand-in");
    let (name, bytes) = bench.saved(|browser| browser.click("#board-hand-in-now"));
    assert_eq!(name, "four-bar-1-1-ana-müller-drawing.json");
    let drawing: Value = serde_json::from_slice(&bytes).expect("JSON");
    assert_eq!((&drawing["name"], &drawing["hints"]), (&json!("Ana Müller"), &Value::Null));
    bench.until(&format!("{SAYS}.includes('{name}')"));
    bench.click("#board-close");
    bench.until("document.querySelector('#panel-check .result .heading') !== null");
    bench.until("JSON.parse(kinegon.history.now.value.drawing).hints === 48");
    assert_ne!(bench.value(TOLD), json!([]));
    bench.picture("exam-judged");
    bench.assert_quiet();
}

/// The right plan is shown for values, not for marks in the boxes, and the form says that it was.
#[test]
#[ignore = "needs Chromium"]
fn the_right_plan_is_noted_in_the_form() {
    let mut bench = Bench::closed("right-plan", None);
    bench.load("");
    let link = given(&mut bench, 0);
    bench.load(&link);
    bench.until("document.querySelector('#panel-check .task svg') !== null");
    let values = asked(&mut bench);
    let text = |row: &Value, value: f64| {
        let scale = if row["panel"] == "velocity" { 2.0 } else { 10.0 };
        if row["is_segment"] == true { format!("{:.1}", value / scale) } else { format!("{value:+.3}") }
    };
    for (index, (row, value)) in values.iter().enumerate() {
        let last = index + 1 == values.len();
        typed(&mut bench, index, &if last { "?".to_owned() } else { text(row, *value) });
    }
    let button = "[...document.querySelectorAll('#panel-check .result button')].some((e) => e.textContent === 'Show the right plan')";
    assert_eq!(bench.value(button), false);
    let (row, value) = values.last().expect("a value");
    typed(&mut bench, values.len() - 1, &text(row, *value));
    bench.until(button);
    bench.press_named("#panel-check .result", "Show the right plan");
    bench.until("!kinegon.app.student.value");
    let hints = "JSON.parse(kinegon.history.now.value.form).hints";
    assert_eq!(bench.value(hints), 4 * values.len());
    bench.click("#undo");
    bench.settle();
    assert_eq!(bench.value(hints), 4 * values.len());
    bench.assert_quiet();
}

/// The special points that an exercise asks for are not shown beside it.
#[test]
#[ignore = "needs Chromium"]
fn special_points_are_not_shown_to_students() {
    let mut bench = Bench::of("special-points", &files::read("templates/fourth-class.json"));
    let shows = "document.querySelector('#sheet :is([id^=scheme-cut], [id$=point-S3])') !== null";
    assert_eq!(bench.value(shows), true);
    bench.value("kinegon.app.student.set(true)");
    bench.until("document.querySelector('#sheet [id*=velocity]') === null");
    bench.settle();
    assert_eq!(bench.value(shows), false);
    bench.picture("special-points");
    bench.assert_quiet();
}

/// The field of a length.
const LENGTH: &str = "[data-path='links.2.lengths.BC'] input";

/// Types letter by letter, as quick as a hand, and keeps every length that the scene has meanwhile.
fn by_letters(bench: &mut Bench, text: &str) -> Vec<f64> {
    let seen = bench.value(&format!(
        "(async () => {{ const e = document.querySelector({LENGTH:?}); const seen = []; \
         const end = kinegon.history.now.on(({{ text }}) => seen.push(JSON.parse(text).links[2].lengths.BC)); e.focus(); e.value = ''; \
         for (const letter of {}) {{ e.value += letter; e.dispatchEvent(new Event('input')); await new Promise((done) => setTimeout(done, 40)); }} \
         await new Promise((done) => setTimeout(done, 1500)); end(); return seen; }})()",
        json!(text)
    ));
    seen.as_array().expect("lengths").iter().map(|length| length.as_f64().expect("a number")).collect()
}

#[test]
#[ignore = "needs Chromium"]
fn a_length_is_typed_with_its_unit() {
    let mut bench = Bench::of("typed-unit", &files::read("templates/four-bar.json"));
    bench.panel("mechanism");
    let shown = |bench: &mut Bench| bench.text(&format!("document.querySelector({LENGTH:?}).value"));
    let why = format!(
        "document.querySelector({LENGTH:?}).closest('.field').querySelector('.why:not([hidden])')?.textContent ?? ''"
    );
    // Nothing is solved on the way.
    assert_eq!(by_letters(&mut bench, "15 cm"), [140.0, 150.0]);
    assert_eq!(bench.message(), "");
    bench.press("Enter");
    bench.settle();
    assert_eq!(shown(&mut bench), "150");
    let root = *by_letters(&mut bench, "sqrt(2)*100").last().expect("a length");
    assert!((root - 141.421_356).abs() < 1e-5, "{root}");
    // What cannot be read stays there, with why; the scene is as it was.
    for (text, word) in [("15 kg", "cannot be converted to mm"), ("about 15", "Not a number")] {
        bench.press("Enter");
        by_letters(&mut bench, text);
        bench.press("Enter");
        bench.settle();
        assert_eq!(shown(&mut bench), text);
        let told = bench.text(&why);
        assert!(told.contains(word), "{text}: {told}");
        assert_eq!(bench.at("/links/2/lengths/BC"), json!(root), "{text}");
        assert_eq!(bench.message(), "");
    }
    bench.picture("typed-unit");
    bench.press("Escape");
    assert_eq!(bench.text(&why), "");
    bench.assert_quiet();
}
