//! `kinegon check` with photographs.

use std::path::{Path, PathBuf};
use std::process::Output;
use std::sync::OnceLock;
use support::camera::chance::Kind;
use support::camera::drawn::drawn;
use support::files;
use support::photographs::{by_lot, given, panels, photographed};
use support::program::{kinegon, scratch, stderr};
use support::random::Random;
use support::students::hand::SKILLS;
use support::survey::BROKEN_BYTES;

/// The exercise whose plans are photographed.
const NUMBER: u64 = 8;

/// An exercise and photographs of its plans, by the names of their files.
struct Taken {
    kind: &'static str,
    scene: String,
    photos: Vec<(String, Vec<u8>)>,
}

/// The photographs are taken once for all tests: it takes seconds.
fn taken() -> &'static Taken {
    static TAKEN: OnceLock<Taken> = OnceLock::new();
    TAKEN.get_or_init(|| {
        let given = given(NUMBER).expect("an exercise");
        let of_plans = given.sheets.iter().filter(|sheet| !panels(&sheet.0).is_empty());
        let photos = of_plans.map(|sheet| {
            let drawing = drawn(&given.task, None, SKILLS[1], NUMBER, &panels(&sheet.0));
            let shot = photographed(sheet, &drawing, &by_lot(sheet, Kind::Flat, NUMBER, 1200));
            (format!("Ana-{}.jpg", sheet.0.number), shot.jpeg)
        });
        Taken { kind: given.task.kind, scene: given.task.text().to_owned(), photos: photos.collect() }
    })
}

/// A folder with the scene of an exercise and photographs of its plans.
fn photographs(name: &str) -> (PathBuf, PathBuf, Vec<PathBuf>) {
    let (folder, taken) = (scratch(name), taken());
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        std::fs::write(&path, bytes).expect("it is written");
        path
    };
    let scene = write("scene.json", taken.scene.as_bytes());
    let photos = taken.photos.iter().map(|(name, bytes)| write(name, bytes)).collect();
    (folder, scene, photos)
}

fn check(scene: &Path, more: &[&str]) -> Output {
    kinegon().arg("check").arg(scene).args(more).output().expect("it runs")
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn a_photograph_gives_pictures_and_a_form() {
    let (folder, scene, photos) = photographs("photo-form");
    let out = folder.join("out");
    let out_text = out.to_str().expect("a path").to_owned();
    let mut arguments: Vec<&str> = photos.iter().map(|photo| photo.to_str().expect("a path")).collect();
    arguments.extend(["-o", &out_text]);
    let output = check(&scene, &arguments);
    assert!(matches!(output.status.code(), Some(0 | 1)), "{}", stderr(&output));
    let text = stdout(&output);
    assert!(text.contains(&taken().kind.to_uppercase()), "{text}");
    assert!(text.contains("right") && text.contains("p c"), "{text}");
    let form = out.join("Ana.json");
    assert!(stderr(&output).contains("--accept"), "{}", stderr(&output));
    for photo in &photos {
        let stem = photo.file_stem().expect("a name").to_string_lossy().into_owned();
        let png = std::fs::read(out.join(format!("{stem}-check.png"))).expect("a picture");
        assert!(png.starts_with(b"\x89PNG"));
        #[cfg(feature = "pdf")]
        assert!(lopdf::Document::load(out.join(format!("{stem}-check.pdf"))).is_ok());
    }
    // The form is checked as any other, and `--accept` says the same at once.
    let checked = check(&scene, &[form.to_str().expect("a path")]);
    assert!(matches!(checked.status.code(), Some(0 | 1)), "{}", stderr(&checked));
    arguments.push("--accept");
    let accepted = check(&scene, &arguments);
    assert!(stdout(&accepted).ends_with(&stdout(&checked)), "{}\n{}", stdout(&accepted), stdout(&checked));
    // Another scene's sheet is refused by its name.
    let other = folder.join("other.json");
    std::fs::write(&other, files::read("templates/slider-crank.json")).expect("it is written");
    let refused = check(&other, &[photos[0].to_str().expect("a path")]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("which is not of this scene"), "{}", stderr(&refused));
}

#[test]
fn a_folder_of_photographs_is_a_class() {
    let (folder, scene, photos) = photographs("photo-class");
    let class = folder.join("photos");
    std::fs::create_dir_all(class.join("Bo")).expect("a folder");
    let own = |photo: &Path, folder: &Path| {
        std::fs::copy(photo, folder.join(photo.file_name().expect("a name"))).expect("a copy");
    };
    photos.iter().for_each(|photo| own(photo, &class));
    // Who hands in one of two plans belongs to the class, too.
    own(&photos[0], &class.join("Bo"));
    std::fs::write(class.join("Cid.jpg"), b"\xff\xd8\xff no picture").expect("it is written");
    std::fs::write(class.join("Dan.docx"), b"PK").expect("it is written");
    let forms = folder.join("forms");
    let [class, forms_text] = [&class, &forms].map(|path| path.to_str().expect("a path"));
    let output = check(&scene, &[class, "-o", forms_text]);
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(2), "{text}{}", stderr(&output));
    let rows: Vec<&str> = text.lines().collect();
    assert_eq!(rows.len(), 5, "{text}");
    assert!(
        rows[1].starts_with("\"Ana\"") && rows[2].starts_with("\"Bo\"") && rows[3].starts_with("\"Cid\""),
        "{text}"
    );
    assert!(rows[4].starts_with("\"Dan.docx\",0,") && rows[4].contains("no photograph"), "{text}");
    assert!(forms.join("Ana.json").is_file() && forms.join("Bo.json").is_file() && !forms.join("Cid.json").exists());
    let few = Path::new(class).join("Bo");
    let accepted = check(&scene, &[few.to_str().expect("a path"), "-o", forms_text, "--accept"]);
    assert!(stdout(&accepted).starts_with("file,name,passed,"), "{}{}", stdout(&accepted), stderr(&accepted));
}

#[test]
fn photographs_of_several_exercises_are_a_class() {
    let folder = scratch("photo-exercises");
    let [class, photos] = ["class", "photos"].map(|name| folder.join(name));
    std::fs::create_dir_all(&photos).expect("a folder");
    let other = given(NUMBER + 1).expect("an exercise");
    let sheet = other.sheets.iter().rfind(|sheet| !panels(&sheet.0).is_empty()).expect("a sheet for plans");
    let drawing = drawn(&other.task, None, SKILLS[1], NUMBER, &panels(&sheet.0));
    let jpeg = photographed(sheet, &drawing, &by_lot(sheet, Kind::Flat, NUMBER, 1200)).jpeg;
    let first = &taken().photos[0].1;
    // Ana hands in sheets of both exercises, Bo of the other one.
    for (name, bytes) in [("Ana-1.jpg", first), ("Ana-2.jpg", &jpeg), ("Bo.jpg", &jpeg)] {
        std::fs::write(photos.join(name), bytes).expect("it is written");
    }
    for (name, text) in [("one", taken().scene.as_str()), ("other", other.task.text())] {
        std::fs::create_dir_all(class.join(name)).expect("a folder");
        std::fs::write(class.join(name).join("scene.json"), text).expect("it is written");
    }
    let forms = folder.join("forms");
    let [photos, forms_text] = [&photos, &forms].map(|path| path.to_str().expect("a path"));
    let output = check(&class, &[photos, "-o", forms_text]);
    assert!(matches!(output.status.code(), Some(0 | 1)), "{}{}", stdout(&output), stderr(&output));
    for (form, exercise) in [("Ana-one", "one"), ("Ana-other", "other"), ("Bo", "other")] {
        let text = std::fs::read_to_string(forms.join(format!("{form}.json"))).expect("a form");
        assert!(text.contains(&format!("\"exercise\": \"{exercise}\"")), "{text}");
    }
    // The forms are a class, and so are the photographs at once.
    let checked = stdout(&check(&class, &[forms_text]));
    assert_eq!(checked.lines().count(), 4, "{checked}");
    let accepted = check(&class, &[photos, "-o", forms_text, "--accept"]);
    assert_eq!(stdout(&accepted), checked, "{}", stderr(&accepted));
}

/// A pipe among photographs is not waited for: it has a row, wherever it lies.
#[cfg(unix)]
#[test]
fn a_pipe_is_no_photograph() {
    let folder = scratch("photo-pipe");
    let class = folder.join("photos");
    std::fs::create_dir_all(class.join("Bo")).expect("a folder");
    let scene = folder.join("scene.json");
    std::fs::write(&scene, files::read("templates/four-bar.json")).expect("it is written");
    for pipe in ["Ana.jpg", "Bo/1.jpg"] {
        let made = std::process::Command::new("mkfifo").arg(class.join(pipe)).status();
        assert!(made.expect("mkfifo runs").success());
    }
    let out = folder.join("out");
    let output = check(&scene, &[class.to_str().expect("a path"), "-o", out.to_str().expect("a path")]);
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(2), "{text}{}", stderr(&output));
    assert_eq!(text.lines().filter(|line| line.contains("is a pipe or a device")).count(), 2, "{text}");
    let alone = check(&scene, &[class.join("Ana.jpg").to_str().expect("a path")]);
    assert_eq!(alone.status.code(), Some(2));
    assert!(stderr(&alone).contains("is a pipe or a device"), "{}", stderr(&alone));
}

#[test]
fn files_that_are_no_pictures_get_one_message() {
    let (folder, scene, photos) = photographs("photo-hostile");
    let good = std::fs::read(&photos[0]).expect("a picture");
    let mut random = Random(5);
    let mut files: Vec<(String, Vec<u8>)> = vec![
        ("empty".into(), Vec::new()),
        ("text".into(), b"no picture at all".to_vec()),
        ("cut".into(), good[..good.len() / 2].to_vec()),
        ("heic".into(), b"\0\0\0\x18ftypheic\0\0\0\0mif1heic".to_vec()),
        ("large".into(), png_head(40_000, 40_000)),
        ("wide".into(), png_head(u32::MAX, 1)),
        ("nothing".into(), png_head(0, 0)),
        ("deep".into(), png([8000, 8000], [16, 2])),
    ];
    // What an Exif block says of the turn is taken or left, whatever it is.
    if let Some(at) = good.windows(4).position(|part| part == b"Exif") {
        let mut turned = good.clone();
        (at..at + 60).for_each(|byte| turned[byte] ^= 0x55);
        files.push(("exif".into(), turned));
    }
    for number in 0..BROKEN_BYTES.now() {
        let mut broken = good.clone();
        for _ in 0..1 + random.below(30) {
            let at = random.below(broken.len());
            broken[at] = random.below(256) as u8;
        }
        files.push((format!("broken-{number}"), broken));
    }
    for (name, bytes) in files {
        let path = folder.join(format!("{name}.jpg"));
        std::fs::write(&path, bytes).expect("it is written");
        let out = folder.join(format!("out-{name}"));
        let output = check(&scene, &[path.to_str().expect("a path"), "-o", out.to_str().expect("a path")]);
        let said = stderr(&output);
        match output.status.code() {
            Some(0 | 1) => assert!(name.starts_with("broken") || name == "exif", "{name} is read"),
            Some(2) => {
                assert_eq!(said.matches("error:").count(), 1, "{name}: {said}");
                assert!(said.contains("hint") || said.contains("help"), "{name}: {said}");
                assert!(!out.exists(), "{name} leaves something");
                assert!(name != "cut" || said.contains("is cut short"), "{name}: {said}");
                assert!(name != "deep" || said.contains("16 bits for each colour, which are 366 MB"), "{name}: {said}");
            }
            other => panic!("{name}: {other:?} {said}"),
        }
    }
}

/// The start of a PNG in grey that says it is that large.
fn png_head(width: u32, height: u32) -> Vec<u8> {
    let mut file = png([width, height], [8, 0]);
    file.truncate(33);
    file
}

/// A PNG that says it is that large, of so many bits and of this kind of colours, and has no pixels.
fn png([width, height]: [u32; 2], [bits, colours]: [u8; 2]) -> Vec<u8> {
    let head = [&width.to_be_bytes()[..], &height.to_be_bytes(), &[bits, colours, 0, 0, 0]].concat();
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    for (name, content) in [(b"IHDR", head), (b"IDAT", Vec::new()), (b"IEND", Vec::new())] {
        let mut sum = flate2::Crc::new();
        sum.update(name);
        sum.update(&content);
        file.extend((content.len() as u32).to_be_bytes());
        file.extend([&name[..], &content].concat());
        file.extend(sum.sum().to_be_bytes());
    }
    file
}

#[test]
fn wrong_uses_are_told() {
    let folder = scratch("photo-uses");
    let scene = folder.join("scene.json");
    std::fs::write(&scene, files::read("templates/four-bar.json")).expect("it is written");
    std::fs::write(folder.join("form.json"), r#"{"kinegon_measured": 1, "values": {"omega(2)": "1"}}"#)
        .expect("written");
    let form = folder.join("form.json");
    let form = form.to_str().expect("a path");
    for (arguments, message) in [
        (&[form, "--accept"][..], "--accept is of photographs"),
        (&[form, form], "one form too many"),
        (&["missing.jpg"], "cannot be read"),
    ] {
        let output = check(&scene, arguments);
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
        assert!(stderr(&output).contains(message), "{}", stderr(&output));
    }
}
