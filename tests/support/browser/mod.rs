//! A headless Chromium, spoken to by the Chrome DevTools Protocol: what it hears (`mod.rs`), what a person's hands do
//! (`hands.rs`), what is seen of it (`looks.rs`).

mod hands;
mod looks;

use super::{files, program, tools};
use base64::Engine as _;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

/// Where the pages of a site are that the browser is given from here, without a network.
const SERVED: &str = "https://site.test/";

/// How long anything may take.
const PATIENCE: Duration = Duration::from_secs(30);

/// The Chromium of all tests of a run: it takes a second to start.
struct Chromium {
    /// Where it is spoken to.
    address: String,
    /// A shell that ends it when nobody holds the other end of its stdin any more: so it does not outlive the tests, whatever
    /// becomes of them.
    _shell: Child,
}

/// What the shell does.
const UNTIL_STDIN_ENDS: &str = "\"$@\" & read -r _; kill $!";

/// The one Chromium.
fn chromium() -> &'static Chromium {
    static CHROMIUM: OnceLock<Chromium> = OnceLock::new();
    CHROMIUM.get_or_init(Chromium::start)
}

impl Chromium {
    fn start() -> Chromium {
        let program = tools::find("chromium");
        let folder = program::scratch("chromium");
        // Beside those of the machine it finds the bundled fonts by their names.
        let fonts = folder.join("fonts.conf");
        let text = format!(
            "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><include ignore_missing=\"yes\">\
             /etc/fonts/fonts.conf</include><dir>{}</dir></fontconfig>",
            files::path("src/drawing/fonts").display()
        );
        std::fs::write(&fonts, text).expect("the tests' folder can be written");
        let shell = Command::new("sh")
            .args(["-c", UNTIL_STDIN_ENDS, "sh"])
            .arg(program)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--mute-audio"])
            .args(["--disable-quic", "--no-first-run", "--hide-scrollbars"])
            .args(["--disable-background-networking", "--disable-sync"])
            .args(["--disable-component-update", "--remote-debugging-port=0"])
            // Pages of several tests are open, and none may wait for being the one in front.
            .args(["--disable-background-timer-throttling", "--disable-renderer-backgrounding"])
            .arg("--disable-backgrounding-occluded-windows")
            // Letters as they are compared with those of other programs.
            .args(["--disable-lcd-text", "--font-render-hinting=none", "--force-color-profile=srgb"])
            .arg("--host-resolver-rules=MAP * ~NOTFOUND")
            .arg(format!("--user-data-dir={}", folder.join("profile").display()))
            .arg("about:blank")
            .env("FONTCONFIG_FILE", fonts)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("there is a shell");
        let port = folder.join("profile/DevToolsActivePort");
        let address = wait("the browser", || {
            let text = std::fs::read_to_string(&port).ok()?;
            let (port, path) = text.trim().split_once('\n')?;
            Some(format!("ws://127.0.0.1:{port}{path}"))
        });
        Chromium { address, _shell: shell }
    }
}

/// A browser with one page, and with a memory of its own.
pub struct Browser {
    /// What it remembers goes with it.
    context: String,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: String,
    last: u64,
    /// A folder of its own.
    folder: PathBuf,
    /// All that the page and its workers have put out so far: exceptions, messages of any level.
    pub console: Vec<String>,
    /// What is at the addresses below [`SERVED`], by name.
    served: BTreeMap<String, Vec<u8>>,
    /// The addresses that the page and its workers have asked for, but for those that are in the page itself.
    pub requests: Vec<String>,
}

impl Browser {
    /// A browser with an empty page of that many pixels, without a network, and with a folder for what it saves.
    pub fn start(folder: &Path, [width, height]: [u32; 2]) -> Browser {
        let (socket, _) = tungstenite::connect(&chromium().address).expect("the browser answers");
        let mut browser = Browser {
            context: String::new(),
            socket,
            session: String::new(),
            last: 0,
            folder: folder.to_owned(),
            console: Vec::new(),
            requests: Vec::new(),
            served: BTreeMap::new(),
        };
        let context = browser.call("Target.createBrowserContext", json!({ "disposeOnDetach": true }));
        browser.context = context["browserContextId"].as_str().expect("a memory of its own").to_owned();
        let page = json!({
            "url": "about:blank",
            "browserContextId": browser.context,
            "newWindow": true,
            "width": width,
            "height": height,
        });
        let target = browser.call("Target.createTarget", page)["targetId"].clone();
        let attach = json!({ "targetId": target, "flatten": true });
        let attached = browser.call("Target.attachToTarget", attach);
        browser.session = attached["sessionId"].as_str().expect("a session").to_owned();
        for domain in ["Runtime.enable", "Log.enable", "Network.enable", "Page.enable"] {
            browser.call(domain, json!({}));
        }
        // Workers wait until they are listened to.
        let workers = json!({ "autoAttach": true, "waitForDebuggerOnStart": true, "flatten": true });
        browser.call("Target.setAutoAttach", workers);
        let offline = json!({ "offline": true, "latency": 0, "downloadThroughput": -1, "uploadThroughput": -1 });
        browser.call("Network.emulateNetworkConditions", offline);
        browser.call("Emulation.setFocusEmulationEnabled", json!({ "enabled": true }));
        browser.screen([width, height], 1.0);
        browser
    }

    /// Sends a command and waits for its answer; what the page says on the way is kept.
    pub fn call(&mut self, method: &str, parameters: Value) -> Value {
        let session = self.session.clone();
        let id = self.send(&session, method, parameters);
        loop {
            let heard = self.socket.read().expect("the browser answers");
            let Message::Text(text) = heard else { continue };
            let heard: Value = serde_json::from_str(&text).expect("it is JSON");
            if heard["id"] == id {
                assert!(heard["error"].is_null(), "{method}: {}", heard["error"]);
                return heard["result"].clone();
            }
            self.hear(&heard);
        }
    }

    fn send(&mut self, session: &str, method: &str, parameters: Value) -> u64 {
        self.last += 1;
        let mut message = json!({ "id": self.last, "method": method, "params": parameters });
        if !session.is_empty() {
            message["sessionId"] = session.into();
        }
        let sent = self.socket.send(Message::text(message.to_string()));
        sent.expect("the browser listens");
        self.last
    }

    /// Keeps what the page or a worker says by itself.
    fn hear(&mut self, heard: &Value) {
        let told = &heard["params"];
        match heard["method"].as_str() {
            Some("Runtime.exceptionThrown" | "Runtime.consoleAPICalled" | "Log.entryAdded") => {
                self.console.push(told.to_string());
            }
            Some("Network.requestWillBeSent") => {
                let address = told["request"]["url"].as_str().unwrap_or_default();
                let is_page = told["type"] == "Document" && address.starts_with("file:");
                if !is_page && !["blob:", "data:", SERVED].iter().any(|inside| address.starts_with(inside)) {
                    self.requests.push(address.to_owned());
                }
            }
            Some("Fetch.requestPaused") => self.answer(told),
            Some("Target.attachedToTarget") => {
                let worker = told["sessionId"].as_str().unwrap_or_default().to_owned();
                for method in ["Runtime.enable", "Log.enable", "Network.enable", "Runtime.runIfWaitingForDebugger"] {
                    self.send(&worker, method, json!({}));
                }
            }
            _ => {}
        }
    }

    /// Answers a request below [`SERVED`].
    fn answer(&mut self, asked: &Value) {
        let address = asked["request"]["url"].as_str().unwrap_or_default();
        let name = address.strip_prefix(SERVED).unwrap_or_default().split(['?', '#']).next().unwrap_or_default();
        let body = self.served.get(name).map(|bytes| base64::engine::general_purpose::STANDARD.encode(bytes));
        let html = json!([{ "name": "Content-Type", "value": "text/html; charset=utf-8" }]);
        let answer = json!({
            "requestId": asked["requestId"],
            "responseCode": if body.is_some() { 200 } else { 404 },
            "responseHeaders": html,
            "body": body.unwrap_or_default(),
        });
        let session = self.session.clone();
        self.send(&session, "Fetch.fulfillRequest", answer);
    }

    /// Opens a page of a site that has these files, and waits until `ready` is true there.
    pub fn visit(&mut self, files: BTreeMap<String, Vec<u8>>, page: &str, ready: &str) {
        self.served = files;
        self.call("Fetch.enable", json!({ "patterns": [{ "urlPattern": format!("{SERVED}*") }] }));
        self.call("Page.navigate", json!({ "url": format!("{SERVED}{page}") }));
        self.until(ready);
    }

    /// Opens a file, with what stands behind its name in the address, and waits until `ready` is true there.
    pub fn open_at(&mut self, file: &Path, behind: &str, ready: &str) {
        // Another part behind # alone would load nothing.
        self.call("Page.navigate", json!({ "url": "about:blank" }));
        self.until("location.href === 'about:blank'");
        let url = format!("file://{}{behind}", file.display());
        self.call("Page.navigate", json!({ "url": url }));
        self.until(ready);
    }

    /// Opens a file and waits until `ready` is true there.
    pub fn open(&mut self, file: &Path, ready: &str) {
        self.open_at(file, "", ready);
    }

    /// The value of an expression in the page; a promise's value.
    pub fn value(&mut self, expression: &str) -> Value {
        let asked = json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let answer = self.call("Runtime.evaluate", asked);
        let thrown = &answer["exceptionDetails"];
        assert!(thrown.is_null(), "{expression}: {thrown}");
        answer["result"]["value"].clone()
    }

    /// The number that an expression in the page is.
    pub fn number(&mut self, expression: &str) -> f64 {
        let value = self.value(expression);
        value.as_f64().unwrap_or_else(|| panic!("{expression}: {value} is no number"))
    }

    /// The text that an expression in the page is.
    pub fn text(&mut self, expression: &str) -> String {
        let value = self.value(expression);
        value.as_str().unwrap_or_else(|| panic!("{expression}: {value} is no text")).to_owned()
    }

    /// Waits until an expression is true.
    pub fn until(&mut self, expression: &str) {
        wait(expression, || (self.value(expression) == true).then_some(()));
    }

    /// Asserts that nothing was asked for outside, and nothing put out.
    pub fn assert_quiet(&mut self) {
        self.value("1");
        assert_eq!(self.requests, Vec::<String>::new(), "requests");
        assert_eq!(self.console, Vec::<String>::new(), "messages");
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let of = self.folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
            eprintln!("requests: {:?}\nmessages: {:#?}", self.requests, self.console);
            self.picture(&format!("failed-{of}"));
        }
    }
}

/// Asks until there is an answer.
fn wait<T>(what: &str, mut ask: impl FnMut() -> Option<T>) -> T {
    let begin = Instant::now();
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(begin.elapsed() < PATIENCE, "waited in vain for: {what}");
        std::thread::sleep(Duration::from_millis(20));
    }
}
