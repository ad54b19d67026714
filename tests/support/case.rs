//! A command line with its files, as a small JSON file:
//! `{ "arguments": ["check", "scene.json", "class/"], "files": { "scene.json": { … }, "class/a.csv": "…" } }`.
//! Whatever they say, it ends with one of the program's exit codes, and all that it prints and writes can be read back.

use super::outputs;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::path::{Component, Path};

/// What a run of the program came to.
pub struct Outcome {
    /// Its exit code; `None` where a signal has ended it.
    pub code: Option<i32>,
    pub stdout: Vec<u8>,
    pub stderr: Vec<u8>,
}

/// A command line and the files beside it.
pub struct Case {
    pub arguments: Vec<String>,
    files: BTreeMap<String, Vec<u8>>,
    text: String,
}

/// Bytes of all files of a folder by their paths in it.
pub type Found = BTreeMap<String, Vec<u8>>;

impl Case {
    /// The case that a text tells; `None` for other texts, and for files that would lie elsewhere.
    pub fn read(text: &str) -> Option<Case> {
        let json: Value = serde_json::from_str(text).ok()?;
        let arguments = json.get("arguments")?.as_array()?;
        let arguments: Vec<String> = arguments.iter().filter_map(|a| Some(a.as_str()?.to_owned())).collect();
        // No argument leads out of the folder, and no character of an argument ends it.
        let is_inside = |path: &str| {
            !path.contains(['\0', '~'])
                && Path::new(path).components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
        };
        let leads_out =
            |argument: &String| argument.split(['=', ',']).any(|part| part.starts_with('/') || part.contains(".."));
        if arguments.iter().any(|a| a.contains('\0') || leads_out(a)) {
            return None;
        }
        // Without a file to write, `app` starts a browser.
        if arguments.first().is_some_and(|a| a == "app") && arguments.get(1).is_none_or(|a| a != "-o") {
            return None;
        }
        let none = Map::new();
        let files = json.get("files").and_then(Value::as_object).unwrap_or(&none).iter().take(12);
        let files =
            files.filter(|(path, _)| is_inside(path) && !path.is_empty() && path.len() < 200).map(|(path, content)| {
                let bytes = match content {
                    Value::String(text) => text.clone().into_bytes(),
                    json => json.to_string().into_bytes(),
                };
                (path.clone(), bytes)
            });
        Some(Case { arguments, files: files.collect(), text: text.to_owned() })
    }

    /// Puts the files into a folder. Some names are no file's names: what cannot be written is left out.
    pub fn lay_out(&self, folder: &Path) {
        for (path, bytes) in &self.files {
            let path = folder.join(path);
            let _ = path.parent().map(std::fs::create_dir_all);
            let _ = std::fs::write(path, bytes);
        }
    }

    /// Looks at everything that a run of it has printed, and written into the folder, which held `before`.
    pub fn judge(&self, outcome: &Outcome, folder: &Path, before: &Found) {
        let said = String::from_utf8_lossy(&outcome.stderr);
        assert!(matches!(outcome.code, Some(0..=2)), "{:?}: exit code {:?}\n{said}", self.arguments, outcome.code);
        assert!(!said.contains("panicked"), "{:?}\n{said}", self.arguments);
        let said = outputs::message(&outcome.stderr);
        self.numbers(&said);
        if outcome.code == Some(2) && !self.has_rows() {
            assert!(!said.trim().is_empty(), "{:?}: nothing is said", self.arguments);
        }
        self.printed(&outcome.stdout);
        for (path, bytes) in found(folder).iter().filter(|(path, bytes)| before.get(*path) != Some(bytes)) {
            assert!(!path.ends_with(".part"), "{path} is left");
            self.written(path, bytes);
        }
    }

    /// Whether the table of a class says what is wrong.
    fn has_rows(&self) -> bool {
        self.arguments.first().is_some_and(|command| command == "check")
    }

    fn numbers(&self, text: &str) {
        outputs::numbers(text, &self.text);
    }

    /// What is printed is told apart by how it begins.
    fn printed(&self, bytes: &[u8]) {
        let begins = |mark: &str| bytes.starts_with(mark.as_bytes());
        if bytes.is_empty() {
        } else if begins("%PDF") {
            outputs::pdf(bytes);
        } else if begins("\u{89}PNG") || bytes.starts_with(b"\x89PNG") || begins("ARROW1") || begins("PAR1") {
        } else if begins("<svg") {
            outputs::svg(&outputs::terminal(bytes));
        } else if begins("<!DOCTYPE") {
            self.page(&outputs::terminal(bytes));
        } else if begins("{") {
            self.json(&outputs::terminal(bytes));
        } else if begins("file,") {
            outputs::csv(&outputs::terminal(bytes));
        } else {
            let text = outputs::terminal(bytes);
            if text.contains("\\begin{tikzpicture}") {
                outputs::tex(&text);
            } else {
                self.numbers(&text);
            }
        }
    }

    fn written(&self, path: &str, bytes: &[u8]) {
        let text = || outputs::terminal(bytes);
        match path.rsplit('.').next().unwrap_or_default() {
            "svg" => outputs::svg(&text()),
            "pdf" => outputs::pdf(bytes),
            "tex" => outputs::tex(&text()),
            "html" => self.page(&text()),
            "json" | "jsonl" | "ndjson" => self.json(&text()),
            "csv" => outputs::csv(&text()),
            "png" => assert!(bytes.starts_with(b"\x89PNG")),
            _ => {}
        }
    }

    fn page(&self, text: &str) {
        if text.contains("kinegon-feedback") {
            outputs::html(text);
        } else if text.contains("id=\"kinegon-scene\"") {
            outputs::workbench(text);
        }
    }

    /// One value, or one a line.
    fn json(&self, text: &str) {
        if serde_json::from_str::<Value>(text).is_err() {
            text.lines().for_each(|line| _ = outputs::json(line));
        }
    }
}

/// All files of a folder.
pub fn found(folder: &Path) -> Found {
    let (mut found, mut folders) = (Found::new(), vec![folder.to_owned()]);
    while let Some(inside) = folders.pop() {
        for entry in std::fs::read_dir(inside).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if let Ok(bytes) = std::fs::read(&path) {
                let inside = path.strip_prefix(folder).unwrap_or(&path);
                found.insert(inside.to_string_lossy().into_owned(), bytes);
            }
        }
    }
    found
}
