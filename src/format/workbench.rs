use serde_json::{Value, json};
use std::fmt::Write;

/// The workbench: the page that `web/build` makes, with the engine inside.
const PAGE: &str = include_str!("../../templates/workbench.html");

/// What a workbench opens with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OpenScene<'a> {
    /// The text of a scene file.
    pub text: &'a str,
    /// The step of the construction that is shown first, from 1; `None` for the finished figure.
    pub step: Option<usize>,
}

/// One self-contained HTML file: the whole program to be used in a browser, with that scene open.
///
/// The scene stands in an element `<script type="application/json" id="kinegon-scene">` at the end of the page's head,
/// as `{ "text": "…", "step": 1 }`; without a scene the file is the page as it was built.
#[must_use]
pub fn workbench(scene: Option<OpenScene<'_>>) -> String {
    let Some(OpenScene { text, step }) = scene else {
        return PAGE.to_owned();
    };
    let (head, rest) = PAGE.split_once("</head>").unwrap_or(("", PAGE));
    let data = plain(&json!({ "text": text, "step": step }));
    format!("{head}<script type=\"application/json\" id=\"kinegon-scene\">{data}</script>\n</head>{rest}")
}

/// A value as JSON in letters that nothing obeys: whatever a stranger has written, it ends no element and turns no line
/// of a terminal.
fn plain(value: &Value) -> String {
    let mut written = String::new();
    for unit in value.to_string().encode_utf16() {
        match u8::try_from(unit) {
            Ok(byte) if byte != b'<' && matches!(byte, b' '..=b'~') => written.push(byte.into()),
            _ => {
                let _ = write!(written, "\\u{unit:04x}");
            }
        }
    }
    written
}
