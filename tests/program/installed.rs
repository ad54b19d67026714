//! The program as people install it: help that fits a terminal, completions, manual pages, colours, and a package that has what it is built from.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::files;
use support::program::{kinegon, scratch, stderr};

/// What the program prints.
fn printed(arguments: &[&str]) -> String {
    let output = kinegon().args(arguments).output().expect("it starts");
    assert!(output.status.success(), "{arguments:?}: {}", stderr(&output));
    String::from_utf8(output.stdout).expect("text")
}

/// The commands that the README lists.
fn commands() -> Vec<String> {
    let readme = files::read("README.md");
    let rows = readme.lines().filter_map(|line| line.strip_prefix("| `kinegon "));
    let names = rows.filter_map(|row| row.split([' ', '`']).next()).map(str::to_owned);
    let names: Vec<String> = names.collect();
    assert!(names.len() > 12, "{names:?}");
    names
}

/// The kinds of mechanisms whose scenes lie in `templates/` and whose names begin so.
fn kinds(beginning: &str) -> BTreeSet<String> {
    let all = std::fs::read_dir(files::path("templates")).expect("a folder");
    let names = all.map(|entry| entry.expect("an entry").file_name().into_string().expect("text"));
    let names = names.filter(|name| !name.contains("schema"));
    let names = names.filter_map(|name| name.strip_suffix(".json").map(str::to_owned));
    names.filter(|name| name.starts_with(beginning)).collect()
}

/// What a shell prints that runs a script.
fn said(shell: &str, script: &str, folder: &Path) -> String {
    let output = Command::new(shell).args(["-c", script]).current_dir(folder).output().expect("it starts");
    assert!(output.status.success(), "{shell}: {}", stderr(&output));
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn help_fits_the_terminal_and_ends_in_examples() {
    let mut pages: Vec<Vec<String>> = commands().into_iter().map(|name| vec![name, "--help".to_owned()]).collect();
    pages.push(vec!["--help".to_owned()]);
    for page in pages {
        for width in [80, 100] {
            let output = kinegon().args(&page).env("COLUMNS", width.to_string()).output().expect("it starts");
            let help = String::from_utf8(output.stdout).expect("text");
            for line in help.lines() {
                assert!(line.chars().count() <= width, "{page:?} at {width} columns: {line}");
            }
            let examples = help.split("\nExamples:\n").nth(1).unwrap_or_else(|| panic!("{page:?} has no examples"));
            let examples: Vec<&str> = examples.lines().take_while(|line| !line.is_empty()).collect();
            assert!(!examples.is_empty(), "{page:?}");
            // None goes on in a second line.
            for line in examples {
                assert!(line.starts_with("  kinegon "), "{page:?} at {width} columns: {line}");
            }
        }
    }
}

#[test]
fn completions_name_every_command() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = printed(&["completions", shell]);
        for command in commands() {
            assert!(script.contains(&command), "{shell}: {command}");
        }
        for word in ["--worksheet", "tikz", "lecture", "russian"] {
            let word = if shell == "fish" { word.trim_start_matches('-') } else { word };
            let has_no_values = ["powershell", "elvish"].contains(&shell) && !word.starts_with("--");
            assert!(has_no_values || script.contains(word), "{shell}: {word}");
        }
    }
}

/// A folder with a scene and what a shell needs to complete.
fn with_completions(shell: &str) -> PathBuf {
    let folder = scratch(&format!("completions-{shell}"));
    std::fs::write(folder.join("scene.json"), "{}").expect("it can be written");
    std::fs::write(folder.join(shell), printed(&["completions", shell])).expect("it can be written");
    folder
}

/// Styles that a shell completes, once it has completed kinds and languages: `script` makes a script of the words and the beginning
/// of the last one.
fn completed_styles(shell: &str, script: impl Fn(&str, &str) -> String) -> BTreeSet<String> {
    let folder = with_completions(shell);
    let asked = |words: &str, last: &str| -> BTreeSet<String> {
        let lines = said(shell, &script(words, last), &folder);
        lines.lines().filter_map(|line| line.split('\t').next()).map(str::to_owned).collect()
    };
    assert_eq!(asked("new", "f"), kinds("f"));
    assert_eq!(asked("steps --language", ""), ["de", "en", "es", "pt"].map(str::to_owned).into());
    let styles = asked("draw --style", "");
    for style in ["paper", "print", "lecture", "board"] {
        assert!(styles.contains(style), "{styles:?}");
    }
    styles
}

#[test]
#[ignore = "needs bash"]
fn bash_completes_kinds_and_styles() {
    // It looks for files itself where no name fits.
    completed_styles("bash", |words, last| {
        format!(
            "source ./bash; COMP_WORDS=(kinegon {words} '{last}'); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); \
             _kinegon kinegon '{last}' \"${{COMP_WORDS[COMP_CWORD-1]}}\"; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        )
    });
}

#[test]
#[ignore = "needs fish"]
fn fish_completes_kinds_and_styles() {
    let styles = completed_styles("fish", |words, last| format!("source ./fish; complete -C 'kinegon {words} {last}'"));
    assert!(styles.contains("scene.json"), "{styles:?}");
}

/// It completes in a terminal alone.
#[test]
#[ignore = "needs zsh"]
fn zsh_reads_its_completions() {
    said("zsh", "zsh -n ./zsh", &with_completions("zsh"));
}

/// All manual pages, in a folder of that name.
fn manual(name: &str) -> Vec<PathBuf> {
    let folder = scratch(name);
    printed(&["man", "-o", folder.to_str().expect("text")]);
    std::fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect()
}

#[test]
fn every_command_has_a_manual_page() {
    let there = manual("manual");
    let folder = there[0].parent().expect("a folder");
    let commands: BTreeSet<String> = commands().into_iter().collect();
    assert_eq!(there.len(), commands.len() + 1, "{there:?}");
    for command in &commands {
        let page = std::fs::read_to_string(folder.join(format!("kinegon-{command}.1"))).expect("its page");
        assert_eq!(page, printed(&["man", command]), "{command}");
        // Roff writes a hyphen-minus with a backslash.
        let page = page.replace("\\-", "-");
        let help = printed(&[command, "--help"]);
        let options = help
            .lines()
            .filter_map(|line| line.trim_start().split("--").nth(1).filter(|_| line.trim_start().starts_with('-')));
        for option in options.map(|rest| rest.split([' ', ',', '[']).next().expect("a split has a first part")) {
            assert!(page.contains(&format!("--{option}")), "{command}: --{option}");
        }
    }
}

#[test]
#[ignore = "needs man"]
fn manual_pages_are_read() {
    for path in manual("manual-read") {
        let output = Command::new("man").args(["--warnings", "-l"]).arg(&path).env("MANWIDTH", "80").output();
        let output = output.expect("it starts");
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(text.contains("NAME") && text.contains("EXAMPLES"), "{}: {text}", path.display());
    }
}

#[test]
fn what_has_no_page_or_no_completions_is_told() {
    for (arguments, words) in [
        (&["man", "nothing"][..], &["no command `nothing`", "kinegon --help"][..]),
        (&["man", "help"], &["no command `help`"]),
        (&["man", "draw", "-o", "somewhere"], &["cannot be used with"]),
        (&["completions", "tcsh"], &["tcsh", "possible values: bash"]),
        (&["completions"], &["required"]),
        (&["solve", "scene.json", "--color", "red"], &["red", "possible values: auto, always, never"]),
    ] {
        let output = kinegon().args(arguments).output().expect("it starts");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
        for word in words {
            assert!(stderr(&output).contains(word), "{arguments:?}: {}", stderr(&output));
        }
    }
    assert!(!Path::new("somewhere").exists());
}

#[test]
fn colours_are_those_that_are_asked_for() {
    for (command, on_stdout) in [(&["--help"][..], true), (&["nothing"], false), (&["solve", "no/scene.json"], false)] {
        for (color, variable, is_coloured) in [
            (None, None, false),
            (None, Some(("CLICOLOR_FORCE", "1")), true),
            (Some("--color=always"), None, true),
            (Some("--color=always"), Some(("NO_COLOR", "1")), true),
            (Some("--color=never"), Some(("CLICOLOR_FORCE", "1")), false),
        ] {
            let mut program = kinegon();
            program.env_remove("NO_COLOR").envs(variable).args(color).args(command);
            let output = program.output().expect("it starts");
            let said = if on_stdout { output.stdout } else { output.stderr };
            assert_eq!(said.contains(&0x1b), is_coloured, "{color:?} {variable:?} {command:?}");
        }
    }
}

/// The files that a source takes into itself, from the folder of the package.
fn taken_in(source: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(source).expect("a source");
    let code = text.lines().filter(|line| !line.trim_start().starts_with("///")).collect::<Vec<_>>().join("\n");
    let calls = ["include_str!(\"", "include_bytes!(\""];
    let named = calls.iter().flat_map(|call| code.split(call).skip(1));
    let root = files::path("").canonicalize().expect("a folder");
    let folder = source.parent().expect("it lies in a folder");
    let inside = |name: &str| {
        let path = folder.join(name).canonicalize().unwrap_or_else(|error| panic!("{name}: {error}"));
        path.strip_prefix(&root).expect("it is ours").to_string_lossy().replace('\\', "/")
    };
    named.filter_map(|rest| rest.split('"').next()).map(inside).collect()
}

#[test]
fn the_package_has_what_it_is_built_from_and_little_else() {
    let mut list = Command::new(std::env::var_os("CARGO").expect("cargo has started this"));
    list.args(["package", "--list", "--allow-dirty", "--offline", "--package", "kinegon"]).current_dir(files::path(""));
    let output = list.output().expect("cargo starts");
    assert!(output.status.success(), "{}", stderr(&output));
    let listed = String::from_utf8(output.stdout).expect("text").replace('\\', "/");
    let listed: BTreeSet<&str> = listed.lines().collect();
    let sources = listed.iter().filter(|path| path.starts_with("src/") && path.ends_with(".rs"));
    let taken: Vec<String> = sources.flat_map(|path| taken_in(&files::path(path))).collect();
    assert!(taken.len() > 10, "{taken:?}");
    let scenes = kinds("").into_iter().map(|kind| format!("templates/{kind}.json"));
    let fixed = [
        "LICENSE-MIT",
        "LICENSE-APACHE",
        "THIRD-PARTY.txt",
        "README.md",
        "src/drawing/fonts/OFL-1.1.txt",
        "templates/workbench.html",
    ];
    let schemas = files::list("templates").into_iter().filter(|name| name.ends_with(".schema.json"));
    let schemas = schemas.map(|name| format!("templates/{name}"));
    for path in taken.into_iter().chain(scenes).chain(schemas).chain(fixed.map(str::to_owned)) {
        assert!(listed.contains(path.as_str()), "{path} is not in the package");
    }
    for path in listed {
        let is_apart = ["web/", "fuzz/", "out/", ".ci/", "docs/gallery/", "tests/reference/"];
        assert!(!is_apart.iter().any(|folder| path.starts_with(folder)), "{path} is in the package");
    }
}
