//! README.md and the guide in `docs/`: what they tell people to type works and prints what they show, what they show as a
//! file is accepted, their links lead somewhere, and nothing that the program reads is left out.
//!
//! Each page has a folder of its own, empty at first, and is gone through from its top to its end. A comment above a block
//! says what the block is:
//!
//! - `<!-- file: crank.json -->`: the block is written to that file.
//! - `<!-- in: crank.json /links/1 without shape -->`: the keys of the block go to that place of that scene, keys named
//!   last are taken out, and the scene is solved and drawn. The file itself stays as it is.
//! - `<!-- exit: 1 -->`: the commands of the block end with that code in place of 0.
//! - `<!-- not run: reason -->`: nothing is done with the block.
//!
//! `<!-- copy: examples/figure-2.json -->` stands alone: that file of the repository is there from then on, under the same
//! path. Each line of a `sh` block is run by the shell; a `text` block right below is what the block prints, where a line
//! `…` stands for any lines. A command within a sentence is run, too; where it is only named, as in `kinegon draw`, it is
//! asked for its help. `scene.json` and words in capitals stand for any file. Blocks of Rust are doctests of the library, those of
//! Python are run by `python/tests`.

use kinegon::check::Mistake;
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use support::files;
use support::program::{kinegon, scratch};

/// README.md and every page of the guide.
fn pages() -> Vec<String> {
    let docs = files::list("docs").into_iter().filter(|name| name.ends_with(".md"));
    std::iter::once("README.md".to_owned()).chain(docs.map(|name| format!("docs/{name}"))).collect()
}

/// A part of a page that matters here.
struct Part<'a> {
    /// The line of the page on which it begins.
    line: usize,
    /// The comment above it, or itself.
    comment: Option<(&'a str, &'a str)>,
    /// The language of the block; empty where a comment stands alone, `sentence` for a command within one.
    language: &'a str,
    text: String,
    /// Whether nothing stands between it and the part before.
    follows: bool,
}

/// The blocks of a page, and the comments that stand alone.
fn parts(page: &str) -> Vec<Part<'_>> {
    let mut parts: Vec<Part<'_>> = Vec::new();
    let (mut comment, mut follows) = (None, false);
    let mut lines = page.lines().enumerate();
    while let Some((index, line)) = lines.next() {
        let line_number = index + 1;
        if let Some(language) = line.strip_prefix("```") {
            let inside = lines.by_ref().map(|(_, line)| line).take_while(|line| *line != "```");
            let text: String = inside.map(|line| format!("{line}\n")).collect();
            parts.push(Part { line: line_number, comment: comment.take(), language, text, follows });
            follows = true;
        } else if let Some(inside) = line.strip_prefix("<!--").and_then(|rest| rest.strip_suffix("-->")) {
            let said = inside.split_once(':').unwrap_or_else(|| panic!("line {line_number}: `{line}` says nothing"));
            let said = (said.0.trim(), said.1.trim());
            if said.0 == "copy" {
                parts.push(Part { line: line_number, comment: Some(said), language: "", text: String::new(), follows });
            } else {
                comment = Some(said);
            }
        } else if !line.trim().is_empty() {
            assert!(comment.is_none(), "line {line_number}: a comment for a block, and no block");
            follows = false;
            let commands = line.split('`').skip(1).step_by(2).filter(|code| code.starts_with("kinegon "));
            parts.extend(commands.map(|command| {
                let text = command.to_owned();
                Part { line: line_number, comment: None, language: "sentence", text, follows }
            }));
        }
    }
    parts
}

/// What is to be run where a sentence says `command`; nothing where a word of it stands for any file.
fn meant(command: &str) -> Option<String> {
    let mut words = command.split(' ');
    let stands_for_any =
        |word: &str| ["scene.json", "study.json"].contains(&word) || word.chars().all(|c| c.is_ascii_uppercase());
    match words.clone().count() {
        2 => Some(format!("{command} --help")),
        _ => (!words.any(stands_for_any)).then(|| command.to_owned()),
    }
}

/// What commands came to.
struct Outcome {
    printed: String,
    failure: Option<String>,
}

/// Runs the lines of a block in a folder, all of which are to end with that code.
fn run(commands: &str, code: i32, folder: &Path) -> Outcome {
    let program = Path::new(env!("CARGO_BIN_EXE_kinegon")).parent().expect("it lies in a folder");
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let mut outcome = Outcome { printed: String::new(), failure: None };
    for line in commands.lines() {
        let is_meant = ["kinegon ", "mkdir ", "cp "].iter().any(|command| line.starts_with(command));
        assert!(is_meant, "`{line}` is not for this test: say `not run` and why");
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", line]).current_dir(folder).env("PATH", &path).env_remove("CLICOLOR_FORCE");
        let output = shell.stdin(std::process::Stdio::null()).output().expect("a shell");
        outcome.printed += &String::from_utf8_lossy(&output.stdout);
        outcome.printed += &String::from_utf8_lossy(&output.stderr);
        if output.status.code() != Some(code) {
            outcome.failure.get_or_insert(format!("`{line}` ends with {} in place of {code}", output.status));
        }
    }
    outcome
}

/// Whether a text is what a page shows of it.
fn is_shown(text: &str, shown: &str) -> bool {
    let (text, shown): (Vec<&str>, Vec<&str>) = (text.lines().collect(), shown.lines().collect());
    let mut rest = &text[..];
    let mut spans = shown.split(|line| *line == "…");
    let first = spans.next().unwrap_or_default();
    if !rest.starts_with(first) {
        return false;
    }
    rest = &rest[first.len()..];
    let mut spans: Vec<&[&str]> = spans.collect();
    let Some(last) = spans.pop() else { return rest.is_empty() };
    for span in spans {
        let Some(at) = (0..=rest.len()).find(|&at| rest[at..].starts_with(span)) else { return false };
        rest = &rest[at + span.len()..];
    }
    rest.ends_with(last)
}

/// The scene with the keys of a block put in: `place` is as in `crank.json /links/1 without shape, lengths`.
fn with_keys(block: &str, place: &str, folder: &Path) -> String {
    let (place, without) = place.split_once(" without ").unwrap_or((place, ""));
    let (file, pointer) = place.split_once(' ').unwrap_or((place, ""));
    let text = fs::read_to_string(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
    let mut scene: Value = serde_json::from_str(&text).expect("a scene is JSON");
    let keys: Map<String, Value> =
        serde_json::from_str(&format!("{{{block}}}")).unwrap_or_else(|error| panic!("not keys of JSON: {error}"));
    let target = scene.pointer_mut(pointer).and_then(Value::as_object_mut);
    let target = target.unwrap_or_else(|| panic!("{file} has nothing at {pointer}"));
    for key in without.split(", ").filter(|key| !key.is_empty()) {
        assert!(target.remove(key).is_some(), "{file} has no {key} at {pointer}");
    }
    target.extend(keys);
    scene.to_string()
}

/// What is wrong on a page, with its lines.
fn failures(page: &str) -> Vec<String> {
    let text = files::read(page);
    let folder = scratch(&format!("guide-{}", page.replace('/', "-")));
    let mut failures = Vec::new();
    let mut printed: Option<String> = None;
    for part in parts(&text) {
        let mut fail = |what: String| failures.push(format!("{page}:{}: {what}", part.line));
        let output = printed.take().filter(|_| part.follows);
        match (part.comment, part.language) {
            (Some(("copy", file)), "") => {
                let to = folder.join(file);
                fs::create_dir_all(to.parent().expect("a folder")).expect("the test's folder can be written");
                fs::copy(files::path(file), to).unwrap_or_else(|error| panic!("{page}: {file}: {error}"));
            }
            (Some(("not run", reason)), _) if !reason.is_empty() => {}
            (Some(("file", file)), _) => fs::write(folder.join(file), &part.text).expect("it can be written"),
            (Some(("in", place)), "json") => {
                fs::write(folder.join("changed.json"), with_keys(&part.text, place, &folder))
                    .expect("it can be written");
                let commands = "kinegon solve changed.json\nkinegon draw changed.json -o changed.svg";
                let outcome = run(commands, 0, &folder);
                outcome.failure.into_iter().for_each(|why| fail(format!("{why}: {}", outcome.printed)));
            }
            (None | Some(("exit", _)), "sh") => {
                let code = part.comment.map_or(0, |(_, code)| code.parse().expect("an exit code"));
                let outcome = run(&part.text, code, &folder);
                outcome.failure.into_iter().for_each(|why| fail(format!("{why}: {}", outcome.printed)));
                printed = Some(outcome.printed);
            }
            (None, "sentence") => {
                let outcome = meant(&part.text).map(|command| run(&command, 0, &folder));
                outcome.and_then(|outcome| outcome.failure).into_iter().for_each(fail);
            }
            (None, "text") if output.as_ref().is_some_and(|text| is_shown(text, &part.text)) => {}
            (None, "text") if output.is_some() => {
                fail(format!("in place of this stands\n{}", output.unwrap_or_default()))
            }
            (None, language) if language.starts_with("rust") && ["README.md", "docs/library.md"].contains(&page) => {}
            // Run as they stand by python/tests.
            (None, "python") if ["README.md", "docs/python.md", "docs/courses.md"].contains(&page) => {}
            (comment, language) => fail(format!("nothing tries this block of {language:?} with {comment:?}")),
        }
    }
    failures
}

#[test]
fn every_page_does_what_it_says() {
    let pages = pages();
    let failures: Vec<String> = std::thread::scope(|scope| {
        let tried: Vec<_> = pages.iter().map(|page| scope.spawn(|| failures(page))).collect();
        tried.into_iter().flat_map(|page| page.join().expect("a page can be read")).collect()
    });
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

/// The text of a page outside its blocks.
fn outside_blocks(page: &str) -> String {
    let mut is_inside = false;
    let outside = page.lines().filter(|line| {
        is_inside ^= line.starts_with("```");
        !is_inside && !line.starts_with("```")
    });
    outside.map(|line| format!("{line}\n")).collect()
}

/// What leads to a heading, as GitHub and mdBook make it.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn links_lead_to_pages_and_headings() {
    let (mut followed, mut failures) = (0, Vec::new());
    for page in pages().iter().map(String::as_str).chain(["ARCHITECTURE.md", "CONTRIBUTING.md"]) {
        let text = outside_blocks(&files::read(page));
        let targets = text.split("](").skip(1).filter_map(|rest| Some(rest.split_once(')')?.0));
        for target in targets.filter(|target| !target.starts_with("https://")) {
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let file = match file {
                "" => files::path(page),
                file => files::path(page).parent().expect("a folder").join(file),
            };
            let headings = || {
                let there = outside_blocks(&fs::read_to_string(&file).unwrap_or_default());
                let headings = there.lines().filter(|line| line.starts_with('#'));
                headings.map(|line| anchor(line.trim_start_matches('#').trim())).collect::<Vec<String>>()
            };
            let is_there = file.exists() && (heading.is_empty() || headings().iter().any(|own| own == heading));
            // The built book holds what lies in `docs`, and nothing else.
            let leaves_the_book = page.starts_with("docs/") && target.starts_with("..");
            if !is_there || leaves_the_book {
                failures.push(format!("{page}: {target}"));
            }
            followed += 1;
        }
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
    assert!(followed > 50, "{followed} links");
}

#[test]
fn the_summary_lists_every_page() {
    let summary = files::read("docs/SUMMARY.md");
    for page in pages().iter().filter_map(|page| page.strip_prefix("docs/")).filter(|page| *page != "SUMMARY.md") {
        assert!(summary.contains(&format!("]({page})")), "docs/SUMMARY.md does not list {page}");
    }
}

#[test]
fn the_readme_lists_every_command() {
    let help = kinegon().arg("--help").output().expect("it starts").stdout;
    let help = String::from_utf8(help).expect("text");
    let list = help.split("Options:\n").next().expect("a split has a first part");
    let readme = files::read("README.md");
    // Lines that go on are indented further.
    let names = list.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    for command in names.filter(|name| !["", "help"].contains(name)) {
        assert!(readme.contains(&format!("| `kinegon {command}")), "README.md does not list {command}");
    }
}

/// The names of all keys in a schema, and every word that stands for a choice.
fn words_of(schema: &Value, words: &mut BTreeSet<String>) {
    match schema {
        Value::Object(map) => {
            if let Some(Value::Object(properties)) = map.get("properties") {
                words.extend(properties.keys().cloned());
            }
            let choices = map.get("enum").and_then(Value::as_array).into_iter().flatten().chain(map.get("const"));
            words.extend(choices.filter_map(Value::as_str).map(str::to_owned));
            map.values().for_each(|part| words_of(part, words));
        }
        Value::Array(parts) => parts.iter().for_each(|part| words_of(part, words)),
        _ => {}
    }
}

#[test]
fn the_guide_names_every_key_and_choice() {
    for (kind, page) in [("scene", "docs/scenes.md"), ("style", "docs/styles.md"), ("marks", "docs/classes.md")] {
        let schema = kinegon().args(["schema", kind]).output().expect("it starts").stdout;
        let mut words = BTreeSet::new();
        words_of(&serde_json::from_slice(&schema).expect("a schema is JSON"), &mut words);
        let text = files::read(page);
        let is_named = |word: &String| text.contains(&format!("`{word}`")) || text.contains(&format!("\"{word}\""));
        let missing: Vec<&String> = words.iter().filter(|word| !is_named(word)).collect();
        assert!(missing.is_empty(), "{page} does not name {missing:?}");
    }
}

#[test]
fn the_guide_explains_every_mistake_that_the_check_knows() {
    let page = files::read("docs/checking.md");
    for mistake in Mistake::all().map(Mistake::id) {
        assert!(page.contains(&format!("| `{mistake}` |")), "docs/checking.md does not explain {mistake}");
    }
}

#[test]
fn the_tutorial_shows_the_scene_and_the_form_of_its_pictures() {
    let page = files::read("docs/tutorial.md");
    for file in ["examples/wiper.json", "examples/wiper-as-student.json"] {
        // The file names its schema, which a student's need not.
        let shown = files::read(file).replace("  \"$schema\": \"../templates/scene.schema.json\",\n", "");
        assert!(page.contains(&format!("```json\n{shown}```")), "docs/tutorial.md does not show {file}");
    }
}

#[test]
fn the_page_of_accuracy_shows_the_picture_of_its_run() {
    assert_eq!(files::read("docs/accuracy.svg"), files::read("out/speed-vs-error.svg"));
}
