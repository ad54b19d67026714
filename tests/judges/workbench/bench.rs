//! A workbench in a browser.

use kinegon::format::{OpenScene, workbench};
use serde_json::{Value, json};
use std::ops::{Deref, DerefMut};
use std::path::PathBuf;
use support::browser::Browser;
use support::files;
use support::program::scratch;

/// Whether the page stands with its first picture.
pub const READY: &str = "document.documentElement?.dataset.ready === 'yes'";

/// Whether everything is shown as the text says: solved, drawn, no gesture under way.
const QUIET: &str = "kinegon.app.solved.value.text === kinegon.history.now.value.text \
    && document.querySelector('#busy').textContent === '' && document.querySelector('#bubble').hidden";
/// Waits for all that the engine is asked for by now, and for two pictures on the screen.
const ALL_ANSWERED: &str = "kinegon.engine.kinds().then(() => new Promise((done) => \
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 10)))))";

/// A browser with a workbench.
pub struct Bench {
    browser: Browser,
    folder: PathBuf,
    page: PathBuf,
}

/// The page, with a scene in it if one is given.
fn page(scene: Option<OpenScene<'_>>) -> String {
    let built = match std::env::var_os("KINEGON_PAGE") {
        Some(path) => std::fs::read_to_string(path).expect("KINEGON_PAGE is a page"),
        None => files::read("templates/workbench.html"),
    };
    let is_built = !built.contains("name=\"kinegon-sources\" content=\"\"");
    assert!(is_built, "the workbench has not been built: web/build");
    let Some(scene) = scene else {
        return built;
    };
    // What the program puts into its own page.
    let with = workbench(Some(scene));
    let start = with.find("<script type=\"application/json\" id=\"kinegon-scene\">").expect("a scene");
    let end = start + with[start..].find("</head>").expect("a head");
    built.replacen("</head>", &format!("{}</head>", &with[start..end]), 1)
}

impl Bench {
    /// A workbench with the paper's Figure 2.
    pub fn open(name: &str) -> Bench {
        Bench::of(name, &files::read("examples/figure-2.json"))
    }

    /// A workbench that opens with the text of a scene.
    pub fn of(name: &str, text: &str) -> Bench {
        Bench::with(name, Some(OpenScene { text, step: None }))
    }

    /// A workbench that opens with a scene, if one is given.
    pub fn with(name: &str, scene: Option<OpenScene<'_>>) -> Bench {
        let mut bench = Bench::closed(name, scene);
        bench.load("");
        bench
    }

    /// The same before the page is loaded.
    pub fn closed(name: &str, scene: Option<OpenScene<'_>>) -> Bench {
        let folder = scratch(&format!("workbench-{name}"));
        let file = folder.join("kinegon.html");
        std::fs::write(&file, page(scene)).expect("the test's folder can be written");
        let browser = Browser::start(&folder, [1280, 800]);
        Bench { browser, folder, page: file }
    }

    /// Puts another scene into the page's file; it is there when the page is loaded.
    pub fn put_into_file(&self, scene: OpenScene<'_>) {
        std::fs::write(&self.page, page(Some(scene))).expect("the test's folder can be written");
    }

    /// Loads the page, with what stands behind its name in the address.
    pub fn load(&mut self, behind: &str) {
        let page = self.page.clone();
        self.browser.open_at(&page, behind, READY);
        self.settle();
    }

    /// The folder of the test.
    pub fn folder(&self) -> PathBuf {
        self.folder.clone()
    }

    /// Waits until everything is shown as the text says.
    pub fn settle(&mut self) {
        for _ in 0..2 {
            self.until(QUIET);
            self.value(ALL_ANSWERED);
        }
    }

    /// The scene's text.
    pub fn scene(&mut self) -> String {
        self.text("kinegon.history.now.value.text")
    }

    /// What is in the scene's text at a JSON pointer, as `/links/1/drive/angle`.
    pub fn at(&mut self, pointer: &str) -> Value {
        let scene: Value = serde_json::from_str(&self.scene()).expect("JSON");
        scene.pointer(pointer).cloned().unwrap_or(Value::Null)
    }

    /// Opens another scene in place of the one that is there.
    pub fn put(&mut self, text: &str) {
        self.value(&format!("kinegon.app.open({})", json!(text)));
        self.settle();
    }

    /// What the engine answers; its refusal as `{ "refused": … }`.
    pub fn ask(&mut self, function: &str, given: &[Value]) -> Value {
        let given: Vec<String> = given.iter().map(Value::to_string).collect();
        self.value(&format!(
            "kinegon.engine.{function}({}).then((v) => v instanceof Uint8Array \
             ? Array.from(v, (b) => b.toString(16).padStart(2, '0')).join('') : v, (refused) => ({{ refused }}))",
            given.join(", ")
        ))
    }

    /// Shows a panel.
    pub fn panel(&mut self, id: &str) {
        if self.text("kinegon.app.shown.value") != id {
            self.click(&format!("#tab-{id}"));
        }
        self.settle();
    }

    /// Presses the first control of an element whose name, as it is read out, begins with these words.
    pub fn press_named(&mut self, within: &str, words: &str) {
        let find = format!(
            "(() => {{ const name = (e) => (e.getAttribute('aria-label') ?? e.textContent ?? '').trim(); \
             const all = [...document.querySelectorAll({within} + ' :is(button, summary, label, a, [role=radio], [role=tab])')]; \
             const found = all.find((e) => name(e).startsWith({words}) && e.getClientRects().length > 0); \
             window.heard = false; if (!found) return null; \
             found.addEventListener('click', () => (window.heard = true), {{ once: true, capture: true }}); \
             found.scrollIntoView({{ block: 'center', inline: 'nearest' }}); const r = found.getBoundingClientRect(); \
             return [r.x + r.width / 2, r.y + r.height / 2]; }})()",
            within = json!(within),
            words = json!(words),
        );
        // What moves or is made anew while the pointer is on its way, as below a picture that comes late, is pressed again where it is then.
        for turn in 0..3 {
            let place = self.value(&find);
            assert!(turn > 0 || !place.is_null(), "nothing is called {words:?} in {within}");
            let [Some(x), Some(y)] = [0, 1].map(|axis| place[axis].as_f64()) else { break };
            self.drag(&[[x, y]]);
            if self.value("window.heard !== false") == true {
                break;
            }
        }
        self.settle();
    }

    /// Puts a value into a box and leaves it, as a person with keys does.
    pub fn fill(&mut self, selector: &str, value: &str) {
        self.place(selector);
        self.value(&format!(
            "(() => {{ const e = document.querySelector({}); e.focus(); e.select?.(); }})()",
            json!(selector)
        ));
        if value.is_empty() {
            self.press("Delete");
        } else {
            self.insert(value);
        }
        self.press("Tab");
        self.settle();
    }

    /// Chooses an option of a list by its words.
    pub fn choose(&mut self, selector: &str, words: &str) {
        let chosen = self.value(&format!(
            "(() => {{ const e = document.querySelector({}); const o = [...e.options].find((o) => o.text.startsWith({})); \
             if (!o) return [...e.options].map((o) => o.text).join(' | '); e.value = o.value; \
             e.dispatchEvent(new Event('input', {{ bubbles: true }})); e.dispatchEvent(new Event('change', {{ bubbles: true }})); \
             return true; }})()",
            json!(selector),
            json!(words)
        ));
        assert_eq!(chosen, true, "{words} in {selector}");
        self.settle();
    }

    /// Where a joint is on the screen.
    pub fn joint(&mut self, name: &str) -> [f64; 2] {
        let [x, y, ..] = self.place(&format!("#handle-{name}"));
        [x, y]
    }

    /// What the picture shows, laid out anew: waits for one that is other than this.
    pub fn until_other(&mut self, marks: &str) {
        self.until(&format!("document.querySelector('#sheet').innerHTML !== {}", json!(marks)));
        self.settle();
    }

    /// Pulls a joint to a place on the screen, in steps, as a hand does, and lets go.
    pub fn pull_joint(&mut self, name: &str, by: [f64; 2]) {
        let from = self.joint(name);
        self.take_hold(from);
        for k in 1..=6 {
            let share = f64::from(k) / 6.0;
            self.pull([from[0] + share * by[0], from[1] + share * by[1]]);
            self.frame();
        }
        self.let_go([from[0] + by[0], from[1] + by[1]]);
        self.settle();
    }

    /// Waits for the next picture on the screen.
    pub fn frame(&mut self) {
        self.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
    }

    /// The marks of the picture that is seen.
    pub fn marks(&mut self) -> String {
        self.text("document.querySelector('#sheet').innerHTML")
    }

    /// The points and links that the picture shows, wherever they stand.
    pub fn shown(&mut self) -> String {
        self.text("[...new Set([...document.querySelectorAll('#sheet :is([id*=-point-], [id*=-link-])')].map((e) => e.id))].sort().join(' ')")
    }

    /// Waits for a picture in a panel, which is in a tree of its own.
    pub fn until_drawn(&mut self, selector: &str) {
        let selector = json!(format!("{selector} .drawn"));
        self.until(&format!("document.querySelector({selector})?.shadowRoot?.querySelector('svg path') != null"));
    }

    /// What the page says of a mistake; empty where there is none.
    pub fn message(&mut self) -> String {
        self.text("(document.querySelector('#message:not([hidden])')?.textContent ?? '').trim()")
    }
}

impl Deref for Bench {
    type Target = Browser;

    fn deref(&self) -> &Browser {
        &self.browser
    }
}

impl DerefMut for Bench {
    fn deref_mut(&mut self) -> &mut Browser {
        &mut self.browser
    }
}
