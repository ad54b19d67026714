//! Sets of files are written as a whole or not at all.

use kinegon::cli::output::FileSet;
use std::fs;
use std::path::Path;
use support::program::scratch;

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("listed").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Where the third of four renames fails, the first two are undone.
#[test]
fn a_rename_that_fails_undoes_those_before() {
    let folder = scratch("set-undone");
    let [replaced, blocked, last] = ["replaced", "blocked", "last"].map(|name| folder.join(name));
    fs::write(&replaced, "before").expect("written");
    let mut set = FileSet::default();
    set.add(&replaced, b"after").expect("staged");
    set.add(&folder.join("new/a/b"), b"after").expect("staged");
    set.add(&blocked, b"after").expect("staged");
    set.add(&last, b"after").expect("staged");
    // Someone makes a folder there meanwhile.
    fs::create_dir_all(blocked.join("full")).expect("made");
    let message = set.finish().expect_err("a folder is no file").line("");
    assert!(message.contains("blocked cannot be written"), "{message}");
    assert_eq!(fs::read_to_string(&replaced).expect("there"), "before");
    assert_eq!(names(&folder), ["blocked", "replaced"]);
    let _ = fs::remove_dir_all(folder);
}

/// A file that appears meanwhile is not replaced by one that must be the first.
#[test]
fn what_must_be_first_replaces_nothing() {
    let folder = scratch("set-first");
    let (file, other) = (folder.join("scene.json"), folder.join("other"));
    let mut set = FileSet::default();
    set.add(&other, b"after").expect("staged");
    set.add_first(&file, b"after").expect("staged");
    fs::write(&file, "before").expect("written");
    let message = set.finish().expect_err("it is there").line("");
    assert!(message.contains("is there already and is not overwritten"), "{message}");
    assert_eq!(fs::read_to_string(&file).expect("there"), "before");
    assert_eq!(names(&folder), ["scene.json"]);
    let _ = fs::remove_dir_all(folder);
}

/// A set that is not finished leaves nothing; new folders come with all that is in them.
#[test]
fn a_set_is_there_as_a_whole() {
    let folder = scratch("set-whole");
    let mut set = FileSet::default();
    set.add(&folder.join("new/a/1"), b"1").expect("staged");
    set.add(&folder.join("new/../new/b/2"), b"2").expect("staged");
    assert!(!folder.join("new").exists());
    drop(set);
    assert!(names(&folder).is_empty(), "{:?}", names(&folder));
    let mut set = FileSet::default();
    set.add(&folder.join("new/a/1"), b"1").expect("staged");
    set.add(&folder.join("new/../new/b/2"), b"2").expect("staged");
    set.add(&folder.join("new/a/1"), b"3").expect("staged");
    set.finish().expect("written");
    assert_eq!(fs::read(folder.join("new/a/1")).expect("there"), b"3");
    assert_eq!(fs::read(folder.join("new/b/2")).expect("there"), b"2");
    assert_eq!(names(&folder), ["new"]);
    let _ = fs::remove_dir_all(folder);
}
