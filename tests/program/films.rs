//! `kinegon draw -o film.gif`: what is written, told and refused.

use std::path::Path;
use std::process::Output;
use support::files;
use support::program::{kinegon, scratch, stderr, with_scene};

const FOUR_BAR: &str = include_str!("../../templates/four-bar.json");
const FIGURE_1: &str = include_str!("../../examples/figure-1.json");

/// A short and small film.
const SMALL: [&str; 6] = ["--seconds", "1", "--fps", "8", "--width", "240"];

fn draw(more: &[&str], scene: &str) -> Output {
    with_scene(&[&["draw", "-"], more].concat(), scene.as_bytes())
}

/// Width and height of a GIF, and how many pictures its control blocks announce.
fn gif(bytes: &[u8]) -> ([u16; 2], usize) {
    assert!(bytes.starts_with(b"GIF89a") && bytes.ends_with(b";"));
    let side = |at: usize| u16::from_le_bytes([bytes[at], bytes[at + 1]]);
    let controls = bytes.windows(4).filter(|window| window[..3] == [0x21, 0xf9, 4] && window[3] & 0xe2 == 0);
    ([side(6), side(8)], controls.count())
}

#[test]
fn a_film_is_written_to_files_and_stdout_alike() {
    let folder = scratch("films");
    for (format, start) in [("gif", b"GIF89a".as_slice()), ("apng", b"\x89PNG")] {
        let file = folder.join(format!("film.{format}"));
        let path = file.to_str().expect("UTF-8");
        let output = draw(&[&["-o", path], SMALL.as_slice()].concat(), FOUR_BAR);
        assert_eq!((output.status.code(), stderr(&output).as_str()), (Some(0), ""), "{format}");
        let bytes = std::fs::read(&file).expect("it is there");
        assert!(bytes.starts_with(start), "{format}");
        let on_stdout = draw(&[&["-o", "-", "--format", format], SMALL.as_slice()].concat(), FOUR_BAR);
        assert!(on_stdout.stdout == bytes, "{format}: the same on stdout");
        let on_one_core = kinegon()
            .env("RAYON_NUM_THREADS", "1")
            .args(["draw".as_ref(), files::path("templates/four-bar.json").as_os_str()])
            .args(["-o", "-", "--format", format])
            .args(SMALL)
            .output();
        assert!(on_one_core.expect("it runs").stdout == bytes, "{format}: the same on one core");
        if format == "gif" {
            let ([width, height], pictures) = gif(&bytes);
            assert_eq!((width, height, pictures), (240, 170, 8), "A4, 8 pictures");
        }
    }
    // Into a folder, with sheets.
    let output =
        draw(&[&["-o", folder.to_str().expect("UTF-8"), "--format", "svg,gif"], SMALL.as_slice()].concat(), FOUR_BAR);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let [film, again] = ["film.gif", "figure.gif"].map(|name| std::fs::read(folder.join(name)).expect("it is there"));
    assert!(film == again && folder.join("figure.svg").is_file());
}

#[test]
fn looks_of_figures_are_those_of_films() {
    let film = |more: &[&str]| {
        let output = draw(&[&["-o", "-", "--format", "gif"], SMALL.as_slice(), more].concat(), FOUR_BAR);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        output.stdout
    };
    let plain = film(&[]);
    for more in [
        ["--style", "lecture"].as_slice(),
        &["--page", "16x9"],
        &["--focus", "velocity"],
        &["--ghosts", "5"],
        &["--trace", "C"],
        &["--language", "es"],
        &["--values"],
    ] {
        assert!(film(more) != plain, "{more:?}");
    }
    assert_eq!(gif(&film(&["--page", "16x9"])).0, [240, 135]);
    assert_eq!(film(&["--drive", "1"]), plain, "the first drive is the usual one");
}

#[test]
fn what_is_no_film_is_refused() {
    let folder = scratch("no-films");
    let file = folder.join("film.gif");
    let path = file.to_str().expect("UTF-8");
    for (more, scene, told) in [
        (["--steps"].as_slice(), FOUR_BAR, "does not go with --steps"),
        (&["--layered"], FOUR_BAR, "does not go with --layered"),
        (&["--upto", "3"], FOUR_BAR, "does not go with --upto"),
        (&["--worksheet"], FOUR_BAR, "does not go with --worksheet"),
        (&["--seconds", "0"], FOUR_BAR, "cannot last 0 seconds"),
        (&["--seconds", "-3"], FOUR_BAR, "cannot last -3 seconds"),
        (&["--fps", "100"], FOUR_BAR, "cannot have 100 pictures a second"),
        (&["--seconds", "100", "--fps", "50"], FOUR_BAR, "would have 5000 pictures"),
        (&["--seconds", "40", "--fps", "50"], FOUR_BAR, "with --yes it is written"),
        (&["--width", "20000"], FOUR_BAR, "take fewer dots per inch"),
        (&["--width", "500", "--dpi", "100"], FOUR_BAR, "cannot be used with"),
        (&["--drive", "7"], FOUR_BAR, "there is no drive `7`"),
        (&[], FIGURE_1, "cannot be moved"),
    ] {
        let output = draw(&[&["-o", path], more].concat(), scene);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(told), "{more:?}: {}", stderr(&output));
        assert!(stderr(&output).lines().count() < 8, "{more:?}: {}", stderr(&output));
    }
    assert_eq!(std::fs::read_dir(&folder).expect("the folder").count(), 0, "nothing is left");
    for ending in ["webp", "webm", "mp4"] {
        let output = draw(&["-o", &format!("film.{ending}")], FOUR_BAR);
        assert_eq!(output.status.code(), Some(2));
        assert!(stderr(&output).contains("`.gif` or `.apng` for a film"), "{}", stderr(&output));
    }
    let curves = with_scene(&["curves", "-", "-o", path], FOUR_BAR.as_bytes());
    assert!(stderr(&curves).contains("curves do not move"), "{}", stderr(&curves));
    assert!(!Path::new(path).exists());
}

/// A drive that cannot turn round goes to and fro, and that is told.
#[test]
fn a_swing_is_told() {
    let scene = files::read("templates/hydraulic-boom.json");
    let output = draw(&[&["-o", "-", "--format", "gif"], SMALL.as_slice()].concat(), &scene);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stderr(&output).contains("to and fro"), "{}", stderr(&output));
    assert_eq!(gif(&output.stdout).1, 8);
}
