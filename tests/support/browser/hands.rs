//! What a person's hands do: mouse, keys, fingers.

use super::Browser;
use serde_json::{Value, json};
use std::path::Path;

/// Keys that write nothing, with the numbers that browsers know them by.
const NAMED: [(&str, u32); 14] = [
    ("Backspace", 8),
    ("Tab", 9),
    ("Enter", 13),
    ("Escape", 27),
    ("PageUp", 33),
    ("PageDown", 34),
    ("End", 35),
    ("Home", 36),
    ("ArrowLeft", 37),
    ("ArrowUp", 38),
    ("ArrowRight", 39),
    ("ArrowDown", 40),
    ("Delete", 46),
    ("F11", 122),
];

impl Browser {
    /// Presses a key, by its letter or name, with others held: `a`, `Tab`, `Shift+Tab`, `Control+z`.
    pub fn press(&mut self, keys: &str) {
        let mut held = 0;
        let mut key = keys;
        for (name, bit) in [("Alt+", 1), ("Control+", 2), ("Shift+", 8)] {
            if let Some(rest) = key.strip_prefix(name) {
                (held, key) = (held | bit, rest);
            }
        }
        if let Some(rest) = key.strip_prefix("Shift+") {
            (held, key) = (held | 8, rest);
        }
        let event = key_event(key, held);
        for kind in ["keyDown", "keyUp"] {
            let mut event = event.clone();
            event["type"] = kind.into();
            if let (Value::Object(event), "keyUp") = (&mut event, kind) {
                event.remove("text");
            }
            self.call("Input.dispatchKeyEvent", event);
        }
    }

    /// Types a text letter by letter.
    pub fn type_text(&mut self, text: &str) {
        for letter in text.chars() {
            match letter {
                '\n' => self.press("Enter"),
                _ if letter.is_ascii() => self.press(&letter.to_string()),
                _ => _ = self.call("Input.insertText", json!({ "text": letter.to_string() })),
            }
        }
    }

    /// Puts a text in at once, as from the clipboard.
    pub fn insert(&mut self, text: &str) {
        self.call("Input.insertText", json!({ "text": text }));
    }

    /// The middle of the first element that a selector finds, and its size; it is brought into sight.
    pub fn place(&mut self, selector: &str) -> [f64; 4] {
        let expression = format!(
            "(() => {{ const e = document.querySelector({}); if (!e) return null; \
             e.scrollIntoView({{ block: 'center', inline: 'nearest' }}); const r = e.getBoundingClientRect(); \
             return [r.x + r.width / 2, r.y + r.height / 2, r.width, r.height]; }})()",
            json!(selector)
        );
        let value = self.value(&expression);
        assert!(!value.is_null(), "there is no {selector}");
        std::array::from_fn(|k| value[k].as_f64().expect("a number"))
    }

    /// Clicks on an element, wherever it is.
    pub fn click(&mut self, selector: &str) {
        let [x, y, ..] = self.place(selector);
        self.drag(&[[x, y]]);
    }

    /// Puts the keys on an element.
    pub fn focus(&mut self, selector: &str) {
        self.value(&format!("document.querySelector({}).focus()", json!(selector)));
    }

    /// Presses the mouse at the first place, goes through the others, and lets go at the last.
    pub fn drag(&mut self, way: &[[f64; 2]]) {
        self.take_hold(way[0]);
        way[1..].iter().for_each(|&place| self.pull(place));
        self.let_go(way[way.len() - 1]);
    }

    /// Presses the mouse.
    pub fn take_hold(&mut self, place: [f64; 2]) {
        self.mouse("mouseMoved", place, 0);
        self.mouse("mousePressed", place, 1);
    }

    /// Moves the pressed mouse.
    pub fn pull(&mut self, place: [f64; 2]) {
        self.mouse("mouseMoved", place, 1);
    }

    /// Lets go of the mouse.
    pub fn let_go(&mut self, place: [f64; 2]) {
        self.mouse("mouseReleased", place, 0);
    }

    fn mouse(&mut self, kind: &str, [x, y]: [f64; 2], buttons: u32) {
        let button = if kind == "mouseMoved" && buttons == 0 { "none" } else { "left" };
        let event = json!({ "type": kind, "x": x, "y": y, "button": button, "buttons": buttons, "clickCount": 1 });
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Turns the wheel at a place.
    pub fn wheel(&mut self, [x, y]: [f64; 2], down: f64) {
        let event = json!({ "type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": down });
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Puts fingers down at the first places, moves them through the others, and lifts them.
    pub fn touch(&mut self, way: &[&[[f64; 2]]]) {
        let points = |places: &[[f64; 2]]| -> Vec<Value> {
            places.iter().enumerate().map(|(id, [x, y])| json!({ "x": x, "y": y, "id": id })).collect()
        };
        for (index, places) in way.iter().enumerate() {
            let kind = if index == 0 { "touchStart" } else { "touchMove" };
            self.call("Input.dispatchTouchEvent", json!({ "type": kind, "touchPoints": points(places) }));
        }
        self.call("Input.dispatchTouchEvent", json!({ "type": "touchEnd", "touchPoints": [] }));
    }

    /// Gives files to a box for files, as a person chooses them.
    pub fn give_files(&mut self, selector: &str, files: &[&Path]) {
        let root = self.call("DOM.getDocument", json!({ "depth": 0 }));
        let asked = json!({ "nodeId": root["root"]["nodeId"], "selector": selector });
        let node = self.call("DOM.querySelector", asked);
        self.call("DOM.setFileInputFiles", json!({ "nodeId": node["nodeId"], "files": files }));
    }

    /// Taps on an element.
    pub fn tap(&mut self, selector: &str) {
        let [x, y, ..] = self.place(selector);
        self.touch(&[&[[x, y]]]);
    }
}

/// The event of a key without its kind.
fn key_event(key: &str, held: u32) -> Value {
    let named = NAMED.iter().find(|(name, _)| *name == key);
    let letter = key.chars().next().unwrap_or_default();
    let mut event = json!({ "key": key, "code": key, "modifiers": held });
    match named {
        Some((name, code)) => {
            event["windowsVirtualKeyCode"] = (*code).into();
            if *name == "Enter" {
                event["text"] = "\r".into();
            }
        }
        None => {
            event["code"] = match letter {
                'a'..='z' | 'A'..='Z' => format!("Key{}", letter.to_ascii_uppercase()),
                '0'..='9' => format!("Digit{letter}"),
                ' ' => "Space".to_owned(),
                _ => String::new(),
            }
            .into();
            if letter.is_ascii_alphanumeric() || letter == ' ' {
                event["windowsVirtualKeyCode"] = u32::from(letter.to_ascii_uppercase()).into();
            }
            // With Control or Alt a key writes nothing.
            if held & 3 == 0 {
                event["text"] = key.into();
            }
        }
    }
    event
}
