//! Files of the repository.

use std::path::{Path, PathBuf};

/// The path of a file or folder of the repository.
pub fn path(of: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("this crate lies in tests/support");
    root.join(of)
}

/// The folder of a profile, as `target/debug`, that the running test is of.
pub fn built() -> PathBuf {
    let test = std::env::current_exe().expect("a test knows its own file");
    test.ancestors().nth(2).expect("tests lie in `deps`, examples in `examples`").to_owned()
}

/// The folder for what tests leave: `CARGO_TARGET_TMPDIR`, which cargo tells test programs alone.
pub fn left() -> PathBuf {
    let folder = built().with_file_name("tmp");
    std::fs::create_dir_all(&folder).expect("the tests' folder can be made");
    folder
}

/// The text of a file of the repository.
pub fn read(of: &str) -> String {
    std::fs::read_to_string(path(of)).unwrap_or_else(|error| panic!("{of}: {error}"))
}

/// What lies in a folder of the repository, sorted.
pub fn list(folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(path(folder)).expect("the folder is there");
    let names = entries.map(|entry| entry.expect("it can be listed").file_name());
    let mut names: Vec<String> = names.map(|name| name.into_string().expect("a plain name")).collect();
    names.sort();
    names
}

/// Names and texts of the starting scenes, sorted.
pub fn templates() -> Vec<(String, String)> {
    scenes("templates")
}

/// Names and texts of the scenes in a folder, sorted; schemas, expected numbers and measured values are none.
pub fn scenes(folder: &str) -> Vec<(String, String)> {
    let files = list(folder).into_iter();
    let names = files.filter_map(|file| Some(file.strip_suffix(".json")?.to_owned()));
    let scenes = names.filter(|name| !name.ends_with(".schema") && !name.ends_with(".expect"));
    let with_text = |name: String| {
        let text = read(&format!("{folder}/{name}.json"));
        (name, text)
    };
    let scenes = scenes.map(with_text);
    // A study may have its scene in it.
    scenes.filter(|(_, text)| text.contains("\"kinegon\":") && !text.contains("\"kinegon_study\":")).collect()
}

/// A text that must be refused, and the message that does it.
pub struct Refused {
    pub name: String,
    pub text: String,
    pub message: String,
}

/// The cases of a table such as `tests/bad_scenes.txt`, whose first line says how it is written.
pub fn refused(table: &str) -> Vec<Refused> {
    let whole = read(table);
    let case = |case: &str| {
        let (name, rest) = case.split_once('\n').unwrap_or_else(|| panic!("{table}: nothing under {case}"));
        let (text, message) =
            rest.split_at(rest.rfind("-- ").unwrap_or_else(|| panic!("{table}: no message of {name}")));
        Refused { name: name.to_owned(), text: text.to_owned(), message: message[3..].trim_end().to_owned() }
    };
    whole.split("\n== ").skip(1).map(case).collect()
}

/// The text of the scene in a line of `tests/reference`, so that its numbers are read by the library and nobody before it.
pub fn scene_text(line: &str) -> &str {
    let key = "\"scene\":";
    let start = line.find(key).expect("a case has a scene") + key.len();
    let mut depth = 0;
    for (i, byte) in line.bytes().enumerate().skip(start) {
        match byte {
            b'{' => depth += 1,
            b'}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return &line[start..=i];
        }
    }
    panic!("the scene ends")
}
