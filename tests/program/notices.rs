//! `THIRD-PARTY.txt` and its part for the workbench name everybody whose work is in what we release, and have the texts of
//! their licences. `.ci/notices/make` writes both.

use serde_json::Value;
use std::collections::BTreeSet;
use std::process::Command;
use support::files;
use support::program::stderr;

/// The file for program, package for Python and courses, and that for the page.
const ALL: &str = "THIRD-PARTY.txt";
const PAGE: &str = "templates/workbench-third-party.txt";

/// The names of a file's list, each with what it is licensed under.
fn listed(file: &str) -> BTreeSet<String> {
    let text = files::read(file);
    let (list, _) = text.split_once("\n=").expect("texts follow");
    list.lines().skip(2).filter_map(|line| Some(line.split_once(": ")?.0.to_owned())).collect()
}

/// The crates that are in what is built of a package, on this system. To tell them, cargo reads those of all packages.
fn crates(of: &str) -> BTreeSet<String> {
    let mut tree = Command::new(std::env::var_os("CARGO").expect("cargo has started this"));
    tree.args(["tree", "--frozen", "--edges", "normal,no-proc-macro", "--prefix", "none", "--format", "{p}", "-p", of]);
    let output = tree.current_dir(files::path("")).output().expect("cargo starts");
    assert!(output.status.success(), "{}", stderr(&output));
    let names = String::from_utf8(output.stdout).expect("text");
    let names = names.lines().filter_map(|line| line.split(' ').next()).filter(|name| !name.starts_with("kinegon"));
    names.map(str::to_owned).collect()
}

#[test]
#[ignore = "needs the crates of all features: cargo fetch"]
fn everybody_whose_work_is_shipped_is_named() {
    for (package, file) in [("kinegon", ALL), ("kinegon-python", ALL), ("kinegon-web", ALL), ("kinegon-web", PAGE)] {
        let crates = crates(package);
        assert!(crates.len() > 20, "{package}: {crates:?}");
        let missing: Vec<&String> = crates.iter().filter(|name| !listed(file).contains(*name)).collect();
        assert!(missing.is_empty(), "{file} does not name {missing:?}, which are in {package}: run .ci/notices/make");
    }
    let lock: Value = serde_json::from_str(&files::read("web/package-lock.json")).expect("it is JSON");
    let packages = lock["packages"].as_object().expect("they have names").iter();
    let shipped = packages.filter(|(path, about)| !path.is_empty() && about["dev"] != true);
    for name in shipped.filter_map(|(path, _)| path.strip_prefix("node_modules/")) {
        assert!(listed(PAGE).contains(name) && listed(ALL).contains(name), "{name} is not named: run .ci/notices/make");
    }
}

#[test]
fn every_licence_has_its_text() {
    let (all, page) = (files::read(ALL), files::read(PAGE));
    let texts = [
        ("Apache-2.0", "END OF TERMS AND CONDITIONS", "nalgebra"),
        ("BSD-2-Clause", "2. Redistributions in binary form", "arrayref"),
        ("BSD-3-Clause", "Neither the name", "tiny-skia"),
        ("CC0-1.0", "Affirmer", "tiny-keccak"),
        ("ISC", "Permission to use, copy, modify, and/or distribute", "rqrr"),
        ("MIT", "Permission is hereby granted, free of charge", "serde"),
        ("NOTICE", "The Apache Software Foundation", "arrow-array"),
        ("OFL-1.1", "SIL OPEN FONT LICENSE", "Libertinus Serif"),
        ("Unicode-3.0", "Unicode, Inc", "unicode-ident"),
        ("Zlib", "The origin of this software must not be misrepresented", "foldhash"),
    ];
    for (licence, words, whose) in texts {
        let of_it = |file: &str| {
            let mut parts = file.split("\n====").filter_map(|part| part.trim_start_matches('=').strip_prefix('\n'));
            parts.any(|part| part.starts_with(licence) && part.contains(words) && part.contains(whose))
        };
        assert!(of_it(&all), "{ALL} lacks the text of {licence}, or {whose} beside it");
        // The page has no Python, whose crates alone need these.
        assert!(of_it(&page) || ["CC0-1.0", "NOTICE"].contains(&licence), "{PAGE} lacks the text of {licence}");
    }
    for text in [all, page] {
        assert!(!text.contains("<copyright holders>") && !text.contains("/root/"), "a blank is left, or a path");
    }
}

#[test]
fn everybody_who_holds_a_copyright_is_named() {
    for file in [ALL, PAGE] {
        let text = files::read(file);
        let parts = text.split("\n====").skip(1).filter_map(|part| part.trim_start_matches('=').strip_prefix('\n'));
        let with_holders = ["BSD", "ISC", "MIT", "OFL", "Unicode", "Zlib"];
        let mut counted = 0;
        for part in parts.filter(|part| with_holders.iter().any(|licence| part.starts_with(licence))) {
            let head: Vec<&str> = part.lines().skip(2).take_while(|line| !line.is_empty()).collect();
            for pair in head.windows(2).filter(|pair| !pair[0].starts_with("  ")) {
                assert!(pair[1].starts_with("  "), "{file}: nobody holds the copyright of {}", pair[0]);
                counted += 1;
            }
        }
        assert!(counted > 50, "{file}: {counted}");
        for (name, holder) in
            [("@codemirror/view", "Marijn Haverbeke"), ("rqrr", "Daniel Beer"), ("serde", "David Tolnay")]
        {
            let block = text.lines().skip_while(|line| !line.ends_with(':') || !line.contains(name));
            let holders: Vec<&str> = block.skip(1).take_while(|line| line.starts_with("  ")).collect();
            assert!(holders.iter().any(|line| line.contains(holder)), "{file}: {name} has {holders:?}");
        }
    }
}
