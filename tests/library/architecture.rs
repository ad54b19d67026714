//! The house rules that a compiler does not check: which folder may use which, what a library must not do, what a folder says of itself.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use support::files;

/// The folders of `src` in the order in which values flow; each may use itself and those before it.
const ORDER: [&str; 23] = [
    "geometry",
    "scene",
    "words",
    "mechanism",
    "kernel",
    "position",
    "motion",
    "centers",
    "forces",
    "construction",
    "quantity",
    "editing",
    "accuracy",
    "cycle",
    "study",
    "drawing",
    "format",
    "photo",
    "check",
    "exercise",
    "board",
    "course",
    "cli",
];

/// What only `cli` and the program itself may do: print, touch files, look at the surroundings or at the clock.
const FORBIDDEN: [&str; 10] = [
    "println!",
    "eprintln!",
    "print!",
    "eprint!",
    "dbg!",
    "std::fs",
    "std::env",
    "std::process",
    "Instant::now",
    "SystemTime::now",
];

fn source_folder() -> PathBuf {
    files::path("src")
}

/// Every Rust file under `folder`, sorted.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder of sources can be listed");
    let mut files = Vec::new();
    for path in entries.map(|entry| entry.expect("an entry can be read").path()) {
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The files of the library's folders: folder of `src`, path, text.
fn library() -> Vec<(String, PathBuf, String)> {
    let source = source_folder();
    let mut library = Vec::new();
    for path in rust_files(&source) {
        let inside = path.strip_prefix(&source).expect("it was found there");
        let mut parts = inside.components();
        let first = parts.next().expect("a file has a name");
        // `lib.rs` and `main.rs` stand above the folders.
        if parts.next().is_some() {
            let folder = first.as_os_str().to_string_lossy().into_owned();
            let text = std::fs::read_to_string(&path).expect("a source can be read");
            library.push((folder, path, text));
        }
    }
    library
}

/// `text` as a compiler of the library would see it: without comments, texts in quotes and items under `#[cfg(test)]`.
/// Every removed stretch leaves its line breaks, so that lines keep their numbers.
fn bare(text: &str) -> String {
    let mut bare = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let (skipped, mark) = if rest.starts_with("//") {
            (rest.find('\n').unwrap_or(rest.len()), "")
        } else if rest.starts_with("/*") {
            (rest.find("*/").map_or(rest.len(), |end| end + 2), "")
        } else if let Some(length) = quoted(rest) {
            (length, "\"\"")
        } else {
            // A word is taken whole, so that the r of `for` opens no raw string.
            let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len()).max(c.len_utf8());
            bare.push_str(&rest[..word]);
            rest = &rest[word..];
            continue;
        };
        bare.push_str(mark);
        bare.extend(rest[..skipped].chars().filter(|&c| c == '\n'));
        rest = &rest[skipped..];
    }
    without_tests(&bare)
}

fn opens_raw(rest: &str) -> bool {
    let rest = rest.strip_prefix('b').unwrap_or(rest);
    rest.strip_prefix('r').is_some_and(|r| r.trim_start_matches('#').starts_with('"'))
}

/// Length of the text or character in quotes with which `rest` starts.
fn quoted(rest: &str) -> Option<usize> {
    if opens_raw(rest) {
        let open = rest.find('"')?;
        let hashes = rest[..open].matches('#').count();
        let close = format!("\"{}", "#".repeat(hashes));
        return rest[open + 1..].find(&close).map(|end| open + 1 + end + close.len());
    }
    let mut chars = rest.char_indices();
    match chars.next()?.1 {
        '"' => {
            let mut escaped = false;
            chars.find_map(|(i, c)| {
                let ends = c == '"' && !escaped;
                escaped = c == '\\' && !escaped;
                ends.then_some(i + 1)
            })
        }
        // 'x' and '\n' are characters, 'a without a second quote is a lifetime.
        '\'' => {
            let (_, c) = chars.next()?;
            if c == '\\' {
                return rest[3..].find('\'').map(|end| end + 4);
            }
            let (i, next) = chars.next()?;
            (next == '\'').then_some(i + 1)
        }
        _ => None,
    }
}

/// `text` without the items under `#[cfg(test)]`; quotes and comments must be gone.
fn without_tests(text: &str) -> String {
    let mut kept = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find("#[cfg(test)]") {
        kept.push_str(&rest[..start]);
        let mut depth = 0_i32;
        let end = rest[start + 12..].find(|c| {
            depth += match c {
                '{' | '(' | '[' => 1,
                '}' | ')' | ']' => -1,
                _ => 0,
            };
            depth == 0 && (c == '}' || c == ';')
        });
        let end = end.map_or(rest.len(), |end| start + 12 + end + 1);
        kept.extend(rest[start..end].chars().filter(|&c| c == '\n'));
        rest = &rest[end..];
    }
    kept + rest
}

/// The modules that `text` names after `crate::`, with their lines; `crate::{a, b::c}` names a and b.
fn references(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for key in ["crate::", "kinegon::"] {
        for (at, _) in text.match_indices(key) {
            // `$crate::` of a macro counts too; `other_crate::` does not.
            if text[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_') {
                continue;
            }
            let line = text[..at].matches('\n').count() + 1;
            let after = text[at + key.len()..].trim_start();
            let names = match after.strip_prefix('{') {
                Some(group) => heads(group),
                None => vec![head(after)],
            };
            found.extend(names.into_iter().map(|name| (line, name)));
        }
    }
    found
}

/// The first names of the entries of a `use` group, up to its closing brace.
fn heads(group: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut depth = 0;
    let mut start = 0;
    for (i, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            '}' | ',' if depth == 0 => {
                names.push(head(group[start..i].trim_start()));
                start = i + 1;
                if c == '}' {
                    break;
                }
            }
            _ => {}
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

fn head(path: &str) -> String {
    path.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// Paths that climb out of their folder with `super::` would go past the check.
fn climbs_out(path: &Path, text: &str) -> bool {
    let inside = path.strip_prefix(source_folder()).expect("it was found there");
    let depth = inside.components().count() - 1;
    // In a `mod.rs` one `super` less reaches the crate.
    let levels = if path.ends_with("mod.rs") { depth } else { depth + 1 };
    text.contains(&"super::".repeat(levels))
}

fn place(path: &Path, line: usize) -> String {
    let inside = path.strip_prefix(source_folder()).expect("it was found there");
    format!("src/{}:{line}", inside.display())
}

#[test]
fn folders_use_earlier_folders_only() {
    let rank: BTreeMap<&str, usize> = ORDER.into_iter().zip(0..).collect();
    let mut wrong = Vec::new();
    let mut seen = 0;
    for (folder, path, text) in library() {
        let Some(&own) = rank.get(folder.as_str()) else {
            wrong.push(format!("src/{folder} has no place in the order of folders"));
            continue;
        };
        let text = bare(&text);
        for (line, name) in references(&text) {
            seen += 1;
            match rank.get(name.as_str()) {
                Some(&other) if other <= own => {}
                // What goes through all stages, and its error, which wraps theirs: for the program alone.
                None if folder == "cli" && ["Error", "order_of_figure", "posed"].contains(&name.as_str()) => {}
                // Work on all cores, below all folders.
                None if name == "cores" => {}
                // What goes wrong, what is said, sheets and texts of strangers, below all folders; the first also by its type.
                None if ["Message", "Problem", "fluent", "message", "problem", "sheet", "text"]
                    .contains(&name.as_str()) => {}
                Some(_) => wrong.push(format!("{}: {folder} uses {name}, which comes later", place(&path, line))),
                None => wrong.push(format!("{}: `{name}` is no folder of src", place(&path, line))),
            }
        }
        if climbs_out(&path, &text) {
            wrong.push(format!("{}: `super` leaves the folder; write `crate::`", place(&path, 1)));
        }
    }
    assert!(seen > 50, "only {seen} references found: this test no longer sees the sources");
    wrong.dedup();
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn the_library_neither_prints_nor_looks_around() {
    let mut wrong = Vec::new();
    for (folder, path, text) in library() {
        if folder == "cli" {
            continue;
        }
        let text = bare(&text);
        for (number, line) in text.lines().enumerate() {
            for word in FORBIDDEN {
                let preceded = |at: usize| line[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
                if line.match_indices(word).any(|(at, _)| !preceded(at)) {
                    wrong.push(format!("{}: {word}", place(&path, number + 1)));
                }
            }
            // `use std::{fs, …}` is the same thing in other words.
            if let Some((_, group)) = line.split_once("std::{") {
                for name in heads(group).iter().filter(|n| ["fs", "env", "process"].contains(&n.as_str())) {
                    wrong.push(format!("{}: std::{name}", place(&path, number + 1)));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn every_folder_says_what_it_is() {
    let mut folders: Vec<String> = library().into_iter().map(|(folder, ..)| folder).collect();
    folders.dedup();
    let mut wrong = Vec::new();
    for folder in &folders {
        let file = source_folder().join(folder).join("mod.rs");
        let text = std::fs::read_to_string(file).unwrap_or_default();
        let said = text.lines().take_while(|line| line.starts_with("//!")).count();
        if said < 3 {
            wrong.push(format!("src/{folder}/mod.rs begins with {said} lines of `//!`; at least three say what comes in, what goes out and what is not done here"));
        }
    }
    assert!(folders.len() >= 7, "only {folders:?} found");
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn the_reader_of_sources_sees_what_a_compiler_sees() {
    let text = r##"
//! crate::cli in a comment
use crate::geometry::{Point, Line}; /* crate::cli */
use crate::{scene::Scene, motion::{Motion, solve}, plan};
fn f<'a>(x: &'a str) -> char { let _ = "crate::cli \" }"; let _ = r#"crate::"cli"#; let b = '"'; crate::position::pose(x); '}' }
#[cfg(test)]
mod tests { use crate::cli::Run; fn g() { crate::check::h(); } }
fn h() { not_crate::cli(); $crate::mechanism::m() }
#[cfg(test)]
use crate::cli::x;
fn i() { for_print!(); crate::format::svg() }
"##;
    let seen = bare(text);
    let mut found = references(&seen);
    found.sort();
    let found: Vec<(usize, &str)> = found.iter().map(|(line, name)| (*line, name.as_str())).collect();
    let expected =
        [(3, "geometry"), (4, "motion"), (4, "plan"), (4, "scene"), (5, "position"), (8, "mechanism"), (11, "format")];
    assert_eq!(found, expected, "{seen}");
}
