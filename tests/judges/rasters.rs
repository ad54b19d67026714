//! What other programs make of our files: the rasters of librsvg, Chromium and Poppler beside that of resvg.
//!
//! Programs smooth edges in their own ways, so pixels cannot be compared one by one. A pixel is *astray* if none within a small distance of it
//! in the other picture is like it: if they all differ by more than half of black to white in some colour. Edges never are, whatever the
//! smoothing; a label that has moved by half a millimetre, a subscript or a prime that is missing leave dozens of such pixels, or at least five.

use kinegon::drawing::{Drawing, Mark, Pen, Shape, Vec2};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::path::{Path, PathBuf};
use std::process::Command;
use support::browser::Browser;
use support::ink::outlined;
use support::program::scratch;
use support::stages::solved;
use support::survey;
use support::{files, tools};

/// Dots per inch of all rasters: 0.17 mm a pixel.
const DPI: f64 = 150.0;
/// Colours further apart than this are unlike.
const UNLIKE: u8 = 128;
/// So many pixels astray are a speck that nobody sees.
const SPECK: usize = 3;

/// The two figures of the paper and some more, which quick runs leave out.
const SCENES: [&str; 5] = [
    "examples/figure-1",
    "examples/figure-2",
    "templates/hydraulic-boom",
    "templates/third-class",
    "templates/slotted-lever",
];

fn drawing(scene: &str) -> Drawing {
    let solution = solved(&files::read(&format!("{scene}.json")));
    solution.unwrap_or_else(|error| panic!("{scene}: {error}")).figure()
}

/// Red, green and blue of pixels, row by row.
struct Picture {
    width: usize,
    rows: usize,
    pixels: Vec<[u8; 3]>,
}

impl Picture {
    fn read(bytes: &[u8]) -> Picture {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().expect("it is PNG");
        let mut data = vec![0; reader.output_buffer_size().expect("it fits")];
        let info = reader.next_frame(&mut data).expect("it has pixels");
        let colours = info.color_type.samples();
        assert!(colours >= 3, "{:?}", info.color_type);
        Picture {
            width: info.width as usize,
            rows: info.height as usize,
            pixels: data.chunks_exact(colours).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect(),
        }
    }

    /// What resvg makes of an SVG file, with its texts set from the bundled fonts.
    fn of(svg: &str) -> Picture {
        let tree = Tree::from_str(&outlined(svg), &Options::default()).expect("it is SVG");
        let scale = DPI as f32 / 96.0;
        let pixels = |side: f32| (side * scale).ceil() as u32;
        let mut pixmap = Pixmap::new(pixels(tree.size().width()), pixels(tree.size().height())).expect("it has a size");
        pixmap.fill(Color::WHITE);
        resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
        Picture {
            width: pixmap.width() as usize,
            rows: pixmap.height() as usize,
            pixels: pixmap.data().chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect(),
        }
    }

    /// How many pixels of either picture are astray in the other one, looked for within a distance. Where one picture is a row or a column
    /// larger, that counts for nothing.
    fn astray(&self, other: &Picture, distance: usize) -> usize {
        assert!(self.width.abs_diff(other.width) < 2 && self.rows.abs_diff(other.rows) < 2);
        let (width, rows) = (self.width.min(other.width), self.rows.min(other.rows));
        let is_astray = |a: &Picture, b: &Picture, x: usize, y: usize| {
            let own = a.pixels[y * a.width + x];
            let unlike = |x: usize, y: usize| {
                let there = b.pixels[y * b.width + x];
                own.iter().zip(there).any(|(own, there)| own.abs_diff(there) > UNLIKE)
            };
            let near = |at: usize, end: usize| at.saturating_sub(distance)..(at + distance + 1).min(end);
            // Nearly all pixels are white in both.
            unlike(x, y) && near(y, rows).all(|y| near(x, width).all(|x| unlike(x, y)))
        };
        let places = (0..rows).flat_map(|y| (0..width).map(move |x| (x, y)));
        places.filter(|&(x, y)| is_astray(self, other, x, y) || is_astray(other, self, x, y)).count()
    }
}

/// Keeps a picture for a look where it has pixels astray.
fn assert_alike(what: &str, expected: &Picture, made: &Path, distance: usize) {
    let bytes = std::fs::read(made).unwrap_or_else(|error| panic!("{what}: {}: {error}", made.display()));
    let astray = expected.astray(&Picture::read(&bytes), distance);
    assert!(astray <= SPECK, "{what}: {astray} pixels astray, see {}", made.display());
    std::fs::remove_file(made).expect("it was there");
}

/// A label of a drawing by its name.
fn label<'a>(drawing: &'a mut Drawing, id: &str) -> &'a mut Mark {
    let mut marks = drawing.marks.iter_mut();
    marks.find(|mark| mark.id.as_deref() == Some(id)).expect("it is there")
}

/// The measure sees what a reader would miss, and nothing else.
#[test]
#[ignore = "takes long"]
fn the_measure_sees_small_changes() {
    let drawing = drawing("examples/figure-2");
    let before = drawing.svg();
    let picture = Picture::of(&before);
    assert_eq!(picture.astray(&Picture::of(&before), 1), 0);
    for (id, by) in [
        ("scheme-label-E", Vec2::new(0.5, 0.0)),
        ("scheme-label-1", Vec2::new(0.0, 0.5)),
        ("velocity-label-s3-", Vec2::new(-0.5, 0.0)),
    ] {
        let mut moved = drawing.clone();
        let Shape::Text(text) = &mut label(&mut moved, id).shape else { panic!("{id} is a text") };
        text.origin += by;
        let astray = picture.astray(&Picture::of(&moved.svg()), 1);
        assert!(astray > 2 * SPECK, "{id}: {astray}");
    }
    let start = before.find("id=\"velocity-label-s3-\"").expect("it is there");
    let (head, tail) = before.split_at(start);
    for (what, after) in [
        ("a subscript", format!("{head}{}", tail.replacen(">3</tspan>", "></tspan>", 1))),
        ("a Greek letter", before.replacen(">ω<", "><", 1)),
        ("a comma", before.replacen(">,<", "><", 1)),
        // A prime after the name A.
        (
            "a prime",
            before.replacen(
                "</svg>",
                "<text font-size=\"4.2\" x=\"13.5\" y=\"135.482\" fill=\"#1a1a1a\">′</text></svg>",
                1,
            ),
        ),
        ("the dash of a line", before.replacen(" stroke-dasharray=\"3.6 0.9 0.5 0.9\"", "", 1)),
    ] {
        assert_ne!(before, after, "{what}");
        let astray = picture.astray(&Picture::of(&after), 1);
        assert!(astray > SPECK, "{what}: {astray}");
    }
}

/// A program that finds the bundled fonts and no others, and a folder of its own for its files.
fn with_fonts(program: &Path, name: &str) -> (Command, PathBuf) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("the test's folder can be written");
    let fonts = format!(
        "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><dir>{}</dir><cachedir>{}</cachedir></fontconfig>",
        files::path("src/drawing/fonts").display(),
        folder.join("cache").display()
    );
    std::fs::write(folder.join("fonts.conf"), fonts).expect("the test's folder can be written");
    let mut command = Command::new(program);
    command.env("FONTCONFIG_FILE", folder.join("fonts.conf")).current_dir(&folder);
    (command, folder)
}

fn done(mut command: Command) {
    let output = command.output().expect("the program starts");
    assert!(output.status.success(), "{command:?}\n{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
#[ignore = "needs librsvg"]
fn librsvg_draws_the_same() {
    let program = tools::find("rsvg-convert");
    for scene in SCENES.into_iter().take(survey::RASTERS.now()) {
        let svg = drawing(scene).svg();
        let (mut command, folder) = with_fonts(&program, "librsvg");
        std::fs::write(folder.join("figure.svg"), &svg).expect("the test's folder can be written");
        let dpi = DPI.to_string();
        command.args(["--dpi-x", &dpi, "--dpi-y", &dpi, "figure.svg", "-o", "figure.png"]);
        done(command);
        assert_alike(scene, &Picture::of(&svg), &folder.join("figure.png"), 1);
    }
}

/// Chromium sets a line of 200 mm up to 0.4 mm shorter; so captions and headings have two pixels more.
#[test]
#[ignore = "needs Chromium"]
fn chromium_draws_the_same() {
    let folder = scratch("chromium-draws");
    let mut browser = Browser::start(&folder, [800, 600]);
    for scene in SCENES.into_iter().take(survey::RASTERS.now()) {
        let whole = drawing(scene);
        let mut labels = whole.clone();
        labels.marks.retain(|mark| !matches!(mark.pen, Pen::Caption | Pen::Heading));
        let is_first = scene == SCENES[0];
        for (drawing, distance) in is_first.then_some((whole, 3)).into_iter().chain([(labels, 1)]) {
            let svg = drawing.svg();
            let [file, picture] = ["figure.svg", "figure.png"].map(|name| folder.join(name));
            std::fs::write(&file, &svg).expect("the test's folder can be written");
            browser.screen([drawing.width, drawing.height].map(|mm| (mm * 96.0 / 25.4).ceil() as u32), DPI / 96.0);
            browser.open(&file, "location.href !== 'about:blank' && document.readyState === 'complete'");
            std::fs::write(&picture, browser.shot()).expect("the test's folder can be written");
            assert_alike(scene, &Picture::of(&svg), &picture, distance);
        }
    }
}

#[test]
#[ignore = "needs Poppler"]
fn poppler_draws_the_pdf_as_resvg_draws_the_svg() {
    let program = tools::find("pdftoppm");
    for scene in SCENES.into_iter().take(survey::RASTERS.now()) {
        let drawing = drawing(scene);
        let (mut command, folder) = with_fonts(&program, "poppler");
        let file = drawing.pdf().expect("the sheet has a size");
        std::fs::write(folder.join("figure.pdf"), file).expect("the test's folder can be written");
        command.args(["-r", &DPI.to_string(), "-png", "-singlefile", "figure.pdf", "figure"]);
        done(command);
        assert_alike(scene, &Picture::of(&drawing.svg()), &folder.join("figure.png"), 1);
    }
}
