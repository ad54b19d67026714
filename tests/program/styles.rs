//! Styles: the four that come with the program, files of one's own, and what must hold of each whatever its taste: letters that can be read, links that
//! are told apart with any colour vision, black and grey where it says so.

use kinegon::drawing::{Colour, Drawing, Emphasis, Look, Mark, Pen, Shape, Style};
use kinegon::scene::StyleName;
use std::collections::BTreeSet;
use support::files;
use support::program::{kinegon, scratch, stderr};
use support::stages::solved;

fn example(number: u8) -> Drawing {
    let solution = solved(&files::read(&format!("examples/figure-{number}.json")));
    solution.expect("the example is sound").figure()
}

fn text_of(name: StyleName) -> String {
    files::read(&format!("templates/styles/{}.json", name.as_str()))
}

/// A scene with a figure that asks for a style.
fn with_style(text: &str, name: StyleName) -> String {
    let mut scene: serde_json::Value = serde_json::from_str(text).expect("JSON");
    scene["figure"]["style"] = name.as_str().into();
    scene.to_string()
}

/// The looks of all marks of both figures and of the curves in a style.
fn looks(name: StyleName) -> Vec<(Pen, Look)> {
    let style = Style::named(name);
    let drawn = [1, 2].into_iter().flat_map(|number| example(number).marks);
    let marks = drawn.map(|mark| (mark.pen, mark.number));
    let curves = (0..12).flat_map(|i| [Pen::Curve, Pen::Dead].map(|pen| (pen, Some(i))));
    let traces = (0..6).flat_map(|i| [Pen::Trace, Pen::Beyond, Pen::Ghost].map(|pen| (pen, Some(i))));
    let others = [Pen::Grid, Pen::Zero, Pen::Limit, Pen::Change, Pen::Stand].map(|pen| (pen, None));
    let student = [Pen::Student, Pen::StudentPoint].map(|pen| (pen, None));
    let all = marks.chain(curves).chain(traces).chain(others).chain(student);
    all.map(|(pen, number)| (pen, style.look(pen, number))).collect()
}

#[test]
fn every_style_draws_the_same_marks() {
    for number in [1, 2] {
        let paper = example(number);
        let mut files = BTreeSet::new();
        for name in StyleName::ALL {
            let text = files::read(&format!("examples/figure-{number}.json"));
            let text = with_style(&text, name);
            let drawing = solved(&text).expect("a good scene").figure();
            assert_eq!(drawing.style, Style::named(name));
            // A style with other sizes is another layout.
            if drawing.style.sizes() == paper.style.sizes() {
                assert_eq!(drawing.marks, paper.marks);
            }
            let svg = drawing.svg();
            let ground = format!("<rect fill=\"{}\"", drawing.style.background());
            assert!(svg.contains(&ground), "{}", name.as_str());
            files.insert(svg);
        }
        assert_eq!(files.len(), StyleName::ALL.len());
    }
}

#[test]
fn styles_of_the_program_are_read_as_strictly_as_others() {
    for name in StyleName::ALL {
        let text = text_of(name);
        assert_eq!(Style::read(&text).expect("sound"), Style::named(name));
        assert!(text.contains("\"$schema\": \"../style.schema.json\""));
    }
    // What a person's file is based on says all of it.
    let paper: serde_json::Value = serde_json::from_str(&text_of(StyleName::Paper)).expect("JSON");
    let schema = Style::schema();
    let keys = |value: &serde_json::Value| -> BTreeSet<String> {
        let object = value.as_object().expect("an object");
        object.keys().filter(|k| *k != "note").cloned().collect()
    };
    assert_eq!(keys(&paper["pens"]), keys(&schema["properties"]["pens"]["properties"]));
    let mut all = keys(&schema["properties"]);
    all.remove("based_on");
    assert_eq!(keys(&paper), all);
}

#[test]
fn print_is_black_and_grey() {
    for (pen, look) in looks(StyleName::Print) {
        for colour in [look.stroke, look.fill, Some(look.ink)].into_iter().flatten() {
            let Colour { red, green, blue } = colour;
            assert!(red == green && green == blue, "{pen:?}: {colour}");
        }
        // A photocopier loses thin grey lines; grid and frame carry no meaning.
        let helper = matches!(pen, Pen::Frame | Pen::Leader | Pen::Grid | Pen::Stand | Pen::Ghost);
        assert!(helper || look.stroke.is_none_or(|c| c.red == 0), "{pen:?}");
        assert!(look.stroke.is_none() || look.width >= 0.18, "{pen:?}");
    }
    // What colours tell apart elsewhere, widths and dashes do here.
    let style = Style::named(StyleName::Print);
    let kinds = [Pen::Velocity, Pen::Normal, Pen::Tangential, Pen::Coriolis, Pen::Ray, Pen::Construction, Pen::Image];
    let lines: BTreeSet<String> = kinds
        .iter()
        .map(|&pen| {
            let look = style.look(pen, None);
            format!("{} {:?}", look.width, look.dash)
        })
        .collect();
    assert_eq!(lines.len(), kinds.len());
}

/// Red, green and blue from 0 to 1, proportional to light (IEC 61966-2-1).
fn light(colour: Colour) -> [f64; 3] {
    [colour.red, colour.green, colour.blue].map(|part| {
        let share = f64::from(part) / 255.0;
        if share <= 0.04045 { share / 12.92 } else { libm::pow((share + 0.055) / 1.055, 2.4) }
    })
}

fn times(matrix: [[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum())
}

/// CIE XYZ of light of sRGB's primaries, its white D65 at Y = 1 (IEC 61966-2-1).
const TO_XYZ: [[f64; 3]; 3] =
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]];

/// Contrast of two colours (WCAG 2.1, "contrast ratio"): 1 for the same, 21 for black on white.
fn contrast(a: Colour, b: Colour) -> f64 {
    let [a, b] = [a, b].map(|colour| times(TO_XYZ, light(colour))[1] + 0.05);
    a.max(b) / a.min(b)
}

#[test]
fn letters_stand_out_from_what_they_stand_on() {
    let black_on_white = contrast(Colour::new(0), Colour::new(0xffffff));
    assert!((black_on_white - 21.0).abs() < 1e-4);
    for name in StyleName::ALL {
        let style = Style::named(name);
        let looks = looks(name);
        let texts = [Pen::Label, Pen::Caption, Pen::Heading];
        let of = |pen| looks.iter().filter(move |(own, _)| *own == pen);
        let inks = texts.into_iter().flat_map(of).map(|(_, look)| look.ink);
        let areas = [Pen::LinkFill, Pen::ImageFill].into_iter().flat_map(of);
        let mut grounds: Vec<Colour> = areas.filter_map(|(_, look)| look.fill).collect();
        grounds.extend((0..12).filter_map(|i| style.look(Pen::LinkFill, Some(i)).fill));
        grounds.push(style.background());
        for ink in inks {
            for ground in &grounds {
                let contrast = contrast(ink, *ground);
                assert!(contrast >= 4.5, "{}: {ink} on {ground}: {contrast}", name.as_str());
            }
        }
        // On sheets of single steps names are in the accent colour, or paler.
        let mut drawing = Drawing::new(100.0, 100.0);
        drawing.style = style.clone();
        for emphasis in [Emphasis::New, Emphasis::Earlier] {
            let outline = Shape::Polygon(Vec::new());
            let mark = Mark { emphasis, ..Mark::new(Pen::Label, outline) };
            let contrast = contrast(drawing.look(&mark).ink, style.background());
            assert!(contrast >= 4.5, "{}: {emphasis:?}: {contrast}", name.as_str());
        }
        // Names and values of curves and of a student's points stand on the background; so do lines, for which 3 is enough (WCAG 2.1, 1.4.11).
        for (pen, look) in &looks {
            let least = match pen {
                Pen::Curve | Pen::Dead | Pen::StudentPoint => 4.5,
                // The eye need not find them.
                Pen::Leader | Pen::Grid | Pen::Ghost => 1.0,
                _ => 3.0,
            };
            let stroke = look.stroke.unwrap_or(look.ink);
            let contrast = contrast(stroke, style.background());
            assert!(contrast >= least, "{}: {pen:?} {stroke}: {contrast}", name.as_str());
        }
    }
}

/// How dichromats see light of sRGB's primaries: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A physiologically-based model for
/// simulation of color vision deficiency", IEEE Trans. Vis. Comput. Graphics 15 (2009) 1291–1298, table for severity 1.0: protanomaly, deuteranomaly,
/// tritanomaly.
const DICHROMATS: [[[f64; 3]; 3]; 3] = [
    [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
];
const SAME: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// CIE L*a*b* of a colour as seen through such a matrix (CIE 15:2004).
fn lab(colour: Colour, seen: [[f64; 3]; 3]) -> [f64; 3] {
    let xyz = |light: [f64; 3]| times(TO_XYZ, light);
    let (own, white) = (xyz(times(seen, light(colour)).map(|x| x.clamp(0.0, 1.0))), xyz([1.0; 3]));
    let [x, y, z] = std::array::from_fn(|i| {
        let share = own[i] / white[i];
        if share > 216.0 / 24389.0 { libm::cbrt(share) } else { (24389.0 / 27.0 * share + 16.0) / 116.0 }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// The CIE 1976 colour difference; 2.3 is just noticed side by side.
fn difference(a: Colour, b: Colour, seen: [[f64; 3]; 3]) -> f64 {
    let [a, b] = [a, b].map(|colour| lab(colour, seen));
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// What is new in a step is not taken for a ray, nor a Coriolis acceleration for another vector.
#[test]
fn accent_and_coriolis_have_hues_of_their_own() {
    for name in [StyleName::Paper, StyleName::Lecture, StyleName::Board] {
        let style = Style::named(name);
        let stroke = |pen| style.look(pen, None).stroke.expect("a line");
        let accent = style.accent();
        let apart = difference(accent, stroke(Pen::Ray), SAME);
        assert!(apart > 40.0, "{}: accent and rays: {apart}", name.as_str());
        for pen in [Pen::Velocity, Pen::Acceleration, Pen::Normal, Pen::Vector, Pen::Ray] {
            let apart = difference(stroke(Pen::Coriolis), stroke(pen), SAME);
            assert!(apart > 20.0, "{}: Coriolis and {pen:?}: {apart}", name.as_str());
        }
    }
}

#[test]
fn links_of_lecture_are_told_apart_with_any_colour_vision() {
    // Green and red of one lightness, which deuteranopes confuse, show that the measure sees it.
    let (green, red) = (Colour::new(0x6b8e23), Colour::new(0xc0602a));
    assert!(difference(green, red, SAME) > 3.0 * difference(green, red, DICHROMATS[1]));
    let style = Style::named(StyleName::Lecture);
    let links = style.links();
    assert!(links.len() >= 5);
    for (index, own) in links.iter().enumerate() {
        for (step, other) in links.iter().skip(index + 1).enumerate() {
            // Links that follow each other in the scene are joined more often than others.
            let least = if step == 0 { 40.0 } else { 20.0 };
            for seen in [SAME, DICHROMATS[0], DICHROMATS[1]] {
                let apart = difference(*own, *other, seen);
                assert!(apart >= least, "{own} and {other}: {apart}");
            }
            let apart = difference(*own, *other, DICHROMATS[2]);
            assert!(apart >= 15.0, "{own} and {other}: {apart}");
        }
    }
}

#[test]
fn a_student_s_lines_are_told_from_the_right_ones() {
    for name in StyleName::ALL {
        let mut drawing = Drawing::new(100.0, 100.0);
        drawing.style = Style::named(name);
        let look = |pen, emphasis| {
            let mark = Mark { emphasis, ..Mark::new(pen, Shape::Polygon(Vec::new())) };
            drawing.look(&mark)
        };
        let own = look(Pen::Student, Emphasis::Plain);
        assert!(!own.dash.is_empty());
        let right = [Pen::Velocity, Pen::Acceleration, Pen::Link, Pen::Image];
        for (pen, emphasis) in right.map(|pen| [(pen, Emphasis::Earlier), (pen, Emphasis::New)]).concat() {
            let other = look(pen, emphasis);
            // On any photocopy.
            assert!(own.dash != other.dash, "{}: {pen:?}", name.as_str());
            if name == StyleName::Print {
                continue;
            }
            let [a, b] = [&own, &other].map(|look| look.stroke.expect("a line"));
            for seen in [SAME, DICHROMATS[0], DICHROMATS[1], DICHROMATS[2]] {
                let apart = difference(a, b, seen);
                assert!(apart >= 20.0, "{}: {a} and {b}: {apart}", name.as_str());
            }
        }
        // Lines of construction are dashed, too, but thin.
        for pen in [Pen::Ray, Pen::Construction] {
            let thin = look(pen, Emphasis::New).width;
            assert!(own.width > 1.3 * thin, "{}: {pen:?} {thin}", name.as_str());
        }
    }
}

#[test]
fn a_link_has_one_colour_everywhere() {
    let mut drawing = example(2);
    drawing.style = Style::named(StyleName::Lecture);
    let links = drawing.style.links().to_vec();
    let stroke = |id: &str| {
        let of = |mark: &&Mark| mark.id.as_deref() == Some(id);
        let mark = drawing.marks.iter().find(of);
        let mark = mark.unwrap_or_else(|| panic!("there is no {id}"));
        drawing.look(mark).stroke
    };
    for (id, link) in [
        ("scheme-link-1", 0),
        ("scheme-omega-1", 0),
        ("scheme-link-2", 1),
        ("scheme-slider-3", 2),
        ("scheme-link-4", 3),
        ("scheme-link-5", 4),
    ] {
        assert_eq!(stroke(id), Some(links[link]), "{id}");
    }
    // The images of links 2 and 4 are b, e, d_2 and g, d, f; those of links 1 and 5 are lines. Link 3 is a block.
    let image = |corners: usize| {
        let of = |mark: &&Mark| {
            let count = match &mark.shape {
                Shape::Polygon(points) => points.len(),
                Shape::Line(..) => 2,
                _ => 0,
            };
            mark.pen == Pen::Image && count == corners
        };
        let found = drawing.marks.iter().filter(of);
        let strokes = found.filter_map(|mark| drawing.look(mark).stroke);
        strokes.map(|c| c.to_string()).collect::<BTreeSet<_>>()
    };
    let of = |numbers: &[usize]| -> BTreeSet<String> { numbers.iter().map(|&i| links[i].to_string()).collect() };
    assert_eq!(image(3), of(&[1, 3]));
    assert_eq!(image(2), of(&[0, 4]));
    // In the standard style no link has a colour of its own.
    drawing.style = Style::default();
    let link = |mark: &&Mark| mark.pen == Pen::Link;
    let strokes = drawing.marks.iter().filter(link);
    let strokes: BTreeSet<String> =
        strokes.filter_map(|mark| drawing.look(mark).stroke).map(|colour| colour.to_string()).collect();
    assert_eq!(strokes.len(), 1);
}

#[test]
fn twelve_curves_differ_in_every_style() {
    for name in StyleName::ALL {
        let style = Style::named(name);
        let looks: BTreeSet<String> = (0..12)
            .map(|number| {
                let look = style.look(Pen::Curve, Some(number));
                format!("{:?} {:?}", look.stroke, look.dash)
            })
            .collect();
        assert_eq!(looks.len(), 12, "{}", name.as_str());
    }
}

#[test]
fn halos_are_of_the_background() {
    let mut drawing = example(2);
    drawing.style = Style::named(StyleName::Board);
    assert!(drawing.halos().contains(&true));
    let ground = drawing.style.background();
    let svg = drawing.svg();
    let halo = format!("<g fill=\"{ground}\" stroke=\"{ground}\" stroke-width=\"0.6\"");
    assert!(svg.contains(&halo), "{svg}");
    assert!(!svg.contains("#ffffff"));
}

/// The figure of `examples/figure-2.json` as the program draws it with these arguments.
fn drawn(arguments: &[&str]) -> String {
    let scene = files::path("examples/figure-2.json");
    let output = kinegon().arg("draw").arg(scene).args(["-o", "-"]).args(arguments).output().expect("it runs");
    assert!(output.status.success(), "{}", stderr(&output));
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn a_file_is_as_good_as_a_name() {
    for name in StyleName::ALL {
        let path = files::path(&format!("templates/styles/{}.json", name.as_str()));
        let file = drawn(&["--style", path.to_str().expect("a plain path")]);
        assert_eq!(file, drawn(&["--style", name.as_str()]));
    }
    assert_eq!(drawn(&["--style", "paper"]), drawn(&[]));
}

#[test]
fn a_file_of_five_lines_changes_what_it_says() {
    let folder = scratch("style-file");
    let path = folder.join("mine.json");
    let text = r##"{ "kinegon_style": 1,
  "note": "Rays as wide green dashes.",
  "pens": {
    "ray": { "stroke": "#008000", "width": 0.4, "dash": [3.6, 0.9] } } }
"##;
    std::fs::write(&path, text).expect("it can be written");
    let path = path.to_str().expect("a plain path");
    let (own, paper) = (drawn(&["--style", path]), drawn(&[]));
    let ray =
        |colour, width, dash| format!("<g stroke=\"{colour}\" stroke-width=\"{width}\" stroke-dasharray=\"{dash}\"");
    let before = ray("#b5361c", "0.18", "3.6 0.9 0.5 0.9");
    assert!(paper.contains(&before));
    assert_eq!(paper.replace(&before, &ray("#008000", "0.4", "3.6 0.9")), own);
}

#[test]
fn a_style_file_is_not_written_over() {
    let path = scratch("style-kept").join("mine.svg");
    let text = "{ \"kinegon_style\": 1 }";
    std::fs::write(&path, text).expect("it can be written");
    let output = kinegon()
        .arg("draw")
        .arg(files::path("examples/figure-2.json"))
        .arg("--style")
        .arg(&path)
        .arg("-o")
        .arg(&path)
        .output()
        .expect("it runs");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("is the style itself"));
    assert_eq!(std::fs::read_to_string(path).expect("it is there"), text);
}

#[test]
fn the_command_line_goes_before_the_scene_and_reaches_curves() {
    let folder = scratch("style-of-scene");
    let scene = folder.join("scene.json");
    let text = with_style(&files::read("templates/four-bar.json"), StyleName::Board);
    std::fs::write(&scene, text).expect("it can be written");
    let ground = |arguments: &[&str]| {
        let output =
            kinegon().arg(arguments[0]).arg(&scene).args(["-o", "-"]).args(&arguments[1..]).output().expect("it runs");
        assert!(output.status.success(), "{}", stderr(&output));
        let svg = String::from_utf8(output.stdout).expect("text");
        let ground = svg.split("<rect").nth(1).expect("a background");
        let (_, colour) = ground.split_once("fill=\"").expect("it has a colour");
        colour[..7].to_owned()
    };
    let [board, white] = [StyleName::Board, StyleName::Print].map(|n| Style::named(n).background().to_string());
    assert_eq!(ground(&["draw"]), board);
    assert_eq!(ground(&["draw", "--style", "print"]), white);
    assert_eq!(ground(&["curves"]), board);
    assert_eq!(ground(&["curves", "--style", "lecture"]), white);
}

#[test]
fn wrong_styles_are_told_where_and_what() {
    let folder = scratch("wrong-style");
    let path = folder.join("mine.json");
    let text = "{ \"kinegon_style\": 1,\n  \"pens\": { \"rays\": {} } }";
    std::fs::write(&path, text).expect("it can be written");
    let path = path.to_str().expect("a plain path");
    for (style, says) in [
        ("lectur", &["there is no style `lectur`", "paper, print, lecture, board"][..]),
        ("nowhere.json", &["nowhere.json cannot be read", "a style file"]),
        (path, &["unknown key `rays`", "mine.json:2:13", "did you mean `ray`?"]),
    ] {
        let output = kinegon().args(["draw", "--style", style, "-o", "-"]).output().expect("it runs");
        assert_eq!(output.status.code(), Some(2));
        assert!(output.stdout.is_empty());
        for word in says {
            assert!(stderr(&output).contains(word), "{}", stderr(&output));
        }
    }
}
