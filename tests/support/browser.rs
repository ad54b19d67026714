//! A headless Chromium, spoken to by the Chrome DevTools Protocol.

use serde_json::{Value, json};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

/// How long anything may take.
const PATIENCE: Duration = Duration::from_secs(60);

/// A browser with one page.
pub struct Browser {
    process: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: String,
    last: u64,
    /// Errors that the page has put out so far.
    pub errors: Vec<String>,
}

impl Browser {
    /// A browser with an empty page of that many pixels; `None`, with a word on stderr, where no Chromium is installed.
    pub fn start(folder: &Path, [width, height]: [u32; 2]) -> Option<Browser> {
        let process = Command::new("chromium")
            .args(["--headless", "--no-sandbox", "--disable-gpu"])
            .args(["--disable-quic", "--no-first-run", "--hide-scrollbars"])
            .args(["--disable-background-networking", "--disable-sync"])
            .args(["--disable-component-update", "--remote-debugging-port=0"])
            .arg(format!("--window-size={width},{height}"))
            .arg(format!("--user-data-dir={}", folder.display()))
            .arg("about:blank")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn();
        let Ok(process) = process else {
            eprintln!("SKIPPED: there is no `chromium` on this machine to try the page in");
            return None;
        };
        let port = folder.join("DevToolsActivePort");
        let address = wait(|| {
            let text = std::fs::read_to_string(&port).ok()?;
            let (port, path) = text.trim().split_once('\n')?;
            Some(format!("ws://127.0.0.1:{port}{path}"))
        });
        let (socket, _) = tungstenite::connect(address).expect("the browser answers");
        let mut browser = Browser { process, socket, session: String::new(), last: 0, errors: Vec::new() };
        let target = wait(|| {
            let targets = browser.call("Target.getTargets", json!({}));
            let mut targets = targets["targetInfos"].as_array()?.iter();
            let page = targets.find(|t| t["type"] == "page")?;
            Some(page["targetId"].clone())
        });
        let attach = json!({ "targetId": target, "flatten": true });
        let attached = browser.call("Target.attachToTarget", attach);
        browser.session = attached["sessionId"].as_str().expect("a session").to_owned();
        for domain in ["Runtime.enable", "Log.enable", "Page.enable"] {
            browser.call(domain, json!({}));
        }
        Some(browser)
    }

    /// Sends a command and waits for its answer; errors of the page on the way are kept.
    pub fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.last += 1;
        let mut message = json!({ "id": self.last, "method": method, "params": parameters });
        if !self.session.is_empty() {
            message["sessionId"] = self.session.clone().into();
        }
        let sent = self.socket.send(Message::text(message.to_string()));
        sent.expect("the browser listens");
        loop {
            let heard = self.socket.read().expect("the browser answers");
            let Message::Text(text) = heard else { continue };
            let heard: Value = serde_json::from_str(&text).expect("it is JSON");
            if heard["id"] == self.last {
                assert!(heard["error"].is_null(), "{method}: {}", heard["error"]);
                return heard["result"].clone();
            }
            let is_error = match heard["method"].as_str() {
                Some("Runtime.exceptionThrown") => true,
                Some("Runtime.consoleAPICalled") => heard["params"]["type"] == "error",
                Some("Log.entryAdded") => heard["params"]["entry"]["level"] == "error",
                _ => false,
            };
            if is_error {
                self.errors.push(heard["params"].to_string());
            }
        }
    }

    /// Opens a file and waits until `ready` is true there.
    pub fn open(&mut self, file: &Path, ready: &str) {
        let url = format!("file://{}", file.display());
        self.call("Page.navigate", json!({ "url": url }));
        self.until(ready);
    }

    /// The value of an expression in the page; a promise's value.
    pub fn value(&mut self, expression: &str) -> Value {
        let asked = json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let answer = self.call("Runtime.evaluate", asked);
        let thrown = &answer["exceptionDetails"];
        assert!(thrown.is_null(), "{expression}: {thrown}");
        answer["result"]["value"].clone()
    }

    /// Waits until an expression is true.
    pub fn until(&mut self, expression: &str) {
        wait(|| (self.value(expression) == true).then_some(()));
    }

    /// Presses a key.
    pub fn press(&mut self, key: &str) {
        for kind in ["keyDown", "keyUp"] {
            let mut event = json!({ "type": kind, "key": key });
            if key == " " && kind == "keyDown" {
                event["text"] = " ".into();
            }
            self.call("Input.dispatchKeyEvent", event);
        }
    }

    /// Presses the mouse at a place, moves to another, and lets go.
    pub fn drag(&mut self, from: [f64; 2], to: [f64; 2]) {
        for (kind, [x, y]) in [("mousePressed", from), ("mouseMoved", to), ("mouseReleased", to)] {
            let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "buttons": 1, "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", event);
        }
    }

    /// The middle of an element and its size.
    pub fn place(&mut self, id: &str) -> [f64; 4] {
        let expression = format!(
            "(() => {{ const r = document.getElementById('{id}').getBoundingClientRect(); \
             return [r.x + r.width / 2, r.y + r.height / 2, r.width, r.height]; }})()"
        );
        let value = self.value(&expression);
        std::array::from_fn(|k| value[k].as_f64().expect("a number"))
    }

    /// Clicks on an element.
    pub fn click(&mut self, id: &str) {
        let [x, y, ..] = self.place(id);
        self.drag([x, y], [x, y]);
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Asks until there is an answer.
fn wait<T>(mut ask: impl FnMut() -> Option<T>) -> T {
    let begin = Instant::now();
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(begin.elapsed() < PATIENCE, "nothing happens");
        std::thread::sleep(Duration::from_millis(50));
    }
}
