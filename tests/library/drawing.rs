//! Drawings as readers see them: nothing covers a label, nothing leaves its panel, lengths on paper are to scale.
//!
//! Drawn configurations are in `tests/drawn_scenes.jsonl`, one scene a line; a new case is a new line.

use kinegon::drawing::{Drawing, Mark, Pen, Point, Shape};
use kinegon::format::{Text, svg_with};
use kinegon::scene::NotationName;
use support::faults::{covers, faults, id};
use support::files::{self, read};
use support::stages::solved;

/// Points by name and where they are.
type Places = Vec<(String, [f64; 2])>;

/// The drawing of a scene given as text, or why there is none; and where its points are.
fn drawn(text: &str) -> Result<(Drawing, Places), kinegon::Error> {
    let solution = solved(text)?;
    let points = solution.mechanism.points.iter().zip(&solution.pose.points);
    let places = points.map(|(name, place)| (name.clone(), [place.x, place.y]));
    Ok((solution.figure(), places.collect()))
}

fn example(number: u8) -> Drawing {
    let text = read(&format!("examples/figure-{number}.json"));
    drawn(&text).expect("the example can be drawn").0
}

/// Figure 2 at crank angles from 130° to −130°, each on the branch of its neighbour; angles that cannot be assembled are left out.
fn turned() -> Vec<(String, Drawing)> {
    let text = read("examples/figure-2.json");
    let at = |angle: i32, near: &[(String, [f64; 2])]| {
        let mut scene: serde_json::Value = serde_json::from_str(&text).expect("the example is JSON");
        scene["links"]["1"]["drive"]["angle"] = angle.into();
        if !near.is_empty() {
            let near = near.iter().filter(|(name, _)| ["D", "E", "F"].contains(&name.as_str()));
            let near = near.map(|(name, place)| (name.clone(), serde_json::json!(place)));
            scene["near"] = serde_json::Value::Object(near.collect());
        }
        drawn(&scene.to_string())
    };
    let mut all = Vec::new();
    for way in [1, -1] {
        let mut near = Vec::new();
        let mut angle: i32 = 70;
        while angle.abs() <= 130 {
            if let Ok((drawing, places)) = at(angle, &near) {
                near = places;
                if way == 1 || angle != 70 {
                    all.push((format!("figure 2 at {angle}°"), drawing));
                }
            }
            angle += 10 * way;
        }
    }
    all
}

/// The scenes of a folder: the starting scenes of `kinegon new`, the mechanisms with cylinders.
fn scenes(folder: &str) -> Vec<(String, Drawing)> {
    let draw = |(name, text): (String, String)| match drawn(&text) {
        Ok((drawing, _)) => (name, drawing),
        Err(error) => panic!("{name}: {error}"),
    };
    files::scenes(folder).into_iter().map(draw).collect()
}

fn drawings() -> Vec<(String, Drawing)> {
    let mut all: Vec<(String, Drawing)> = [1, 2].map(|number| (format!("figure {number}"), example(number))).into();
    all.extend(turned());
    all.extend(scenes("templates"));
    all.extend(scenes("tests/driven_sliders"));
    for (index, line) in read("tests/drawn_scenes.jsonl").lines().enumerate() {
        let name = format!("drawn scene {}", index + 1);
        match drawn(line) {
            Ok((drawing, _)) => all.push((name, drawing)),
            Err(error) => panic!("{name}: {error}"),
        }
    }
    all
}

/// Some scenes in every notation, in Spanish with decimal commas.
fn worded() -> Vec<(String, Drawing)> {
    let mut all = Vec::new();
    for path in [
        "examples/figure-1.json",
        "examples/figure-2.json",
        "templates/hydraulic-boom.json",
        "templates/third-class.json",
        "templates/whitworth.json",
    ] {
        for notation in NotationName::ALL.map(NotationName::as_str) {
            let mut scene: serde_json::Value = serde_json::from_str(&read(path)).expect("a scene is JSON");
            for (key, value) in [("notation", notation), ("language", "es"), ("decimal", "comma")] {
                scene["figure"][key] = value.into();
            }
            let (drawing, _) = drawn(&scene.to_string()).expect("it can be drawn");
            all.push((format!("{path} in {notation} notation"), drawing));
        }
    }
    all
}

#[test]
fn nothing_covers_a_label_and_nothing_leaves_its_panel() {
    let mut drawings = drawings();
    drawings.extend(worded());
    assert!(drawings.len() >= 108, "only {} drawings", drawings.len());
    let mut wrong = Vec::new();
    for (name, drawing) in &drawings {
        for fault in faults(drawing) {
            wrong.push(format!("{name}: {fault}"));
        }
    }
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}

/// The value of an attribute in the element of an id.
fn attribute(file: &str, id: &str, name: &str) -> f64 {
    let id = format!("id=\"{id}\"");
    let rest = &file[file.find(&id).unwrap_or_else(|| panic!("{id} is missing"))..];
    let element = &rest[..rest.find('>').expect("the element ends")];
    let name = format!(" {name}=\"");
    let value = &element[element.find(&name).expect("the attribute is there") + name.len()..];
    value[..value.find('"').expect("the value ends")].parse().expect("it is a number")
}

#[test]
fn a_ruler_on_paper_reads_the_velocity() {
    let drawing = example(2);
    for mode in [Text::Letters, Text::Outlines] {
        let file = svg_with(&drawing, mode);
        let place = |id: &str| Point::new(attribute(&file, id, "cx"), attribute(&file, id, "cy"));
        let apart = (place("velocity-point-s3") - place("velocity-point-b")).hypot();
        // Speed of the special point of link 3 against B in mm/s, at 1 mm/s per mm.
        assert!((apart / 59.41 - 1.0).abs() < 1e-3, "{apart} mm");
        let (width, height) = (drawing.width, drawing.height);
        let size = format!("width=\"{width}mm\" height=\"{height}mm\"");
        let view = format!("viewBox=\"0 0 {width} {height}\"");
        let root = &file[..file.find('>').expect("the root ends")];
        let has = |attributes: &str| attributes.split("\" ").all(|part| root.contains(part.trim_end_matches('"')));
        assert!(has(&size) && has(&view), "{root}");
    }
}

/// What the labels of a panel say, by their ids.
fn labels<'a>(drawing: &'a Drawing, panel: &str) -> Vec<(&'a str, String)> {
    let prefix = format!("{panel}-label-");
    let label = |mark: &'a Mark| match &mark.shape {
        Shape::Text(text) => Some((id(mark).strip_prefix(&prefix)?, text.text.content())),
        _ => None,
    };
    drawing.marks.iter().filter_map(label).collect()
}

/// Checks that each name is among the labels of a panel, alone or with others of the same place.
fn shows(drawing: &Drawing, panel: &str, names: &str) {
    let labels = labels(drawing, panel);
    for name in names.split(' ') {
        let found = labels.iter().any(|(_, shown)| shown.split(',').any(|one| one.trim() == name));
        assert!(found, "no label {name} in the {panel} panel: {labels:?}");
    }
}

/// Checks that marks of these ids are drawn with a pen.
fn draws(drawing: &Drawing, pen: Pen, ids: &str) {
    for wanted in ids.split(' ') {
        let found = drawing.marks.iter().find(|mark| id(mark) == wanted);
        assert_eq!(found.map(|mark| mark.pen), Some(pen), "{wanted}");
    }
}

#[test]
fn a_title_is_taken_letter_by_letter() {
    let text = read("examples/figure-2.json").replace("Quintero et al. (2011), Figure 2", "four_bar^2");
    let (drawing, _) = drawn(&text).expect("it can be drawn");
    let heading = drawing.marks.iter().find(|mark| mark.pen == Pen::Heading);
    let Some(Shape::Text(heading)) = heading.map(|mark| &mark.shape) else { panic!("no heading") };
    assert_eq!(heading.text.content(), "four_bar^2");
}

#[test]
fn figure_1_shows_all_its_names() {
    let drawing = example(1);
    shows(&drawing, "scheme", "B C D E F G S3 S5 1 2 3 4 5 6");
    for name in ["BC", "ED", "BG", "EF"] {
        let (start, special) = (&name[..1], if "BC ED".contains(name) { "S3" } else { "S5" });
        draws(&drawing, Pen::Construction, &format!("scheme-cut-{special}-{start}"));
    }
    shows(&drawing, "velocity", "p b e s3 s5 c d g f");
    draws(
        &drawing,
        Pen::Ray,
        "velocity-ray-b-s3 velocity-ray-e-s3 velocity-ray-b-s5 velocity-ray-e-s5 \
         acceleration-ray-n_b3-s3 acceleration-ray-n_e3-s3 acceleration-ray-n_b5-s5 acceleration-ray-n_e5-s5",
    );
    draws(
        &drawing,
        Pen::Normal,
        "acceleration-vector-b-n_b3 acceleration-vector-e-n_e3 acceleration-vector-b-n_b5 acceleration-vector-e-n_e5",
    );
    shows(&drawing, "acceleration", "π b e nb3 ne3 nb5 ne5 s3 s5");
}

#[test]
fn figure_2_shows_all_its_names() {
    let drawing = example(2);
    shows(&drawing, "scheme", "A B D E F G S3 S5 1 2 3 4 5 6");
    shows(&drawing, "acceleration", "ns3b ns3g ns5b ns5g");
    draws(&drawing, Pen::Slider, "scheme-slider-3");
    let written: Vec<String> = drawing
        .marks
        .iter()
        .filter_map(|mark| match &mark.shape {
            Shape::Text(text) => Some(text.text.content()),
            _ => None,
        })
        .collect();
    for scale in ["μl", "μv", "μa"] {
        assert!(written.iter().any(|text| text == scale), "no {scale}: {written:?}");
    }
}

/// Half the width of a link's line, and white beside it, in mm.
const BESIDE: f64 = 0.25 + 0.2;

#[test]
fn names_in_the_scheme_keep_off_links() {
    let figures = [1, 2].map(|number| (format!("figure {number}"), example(number)));
    let mut wrong = Vec::new();
    for (name, drawing) in figures.into_iter().chain(scenes("templates")) {
        let labels = drawing.marks.iter().filter(|mark| mark.pen == Pen::Label);
        for label in labels.filter(|mark| id(mark).starts_with("scheme-")) {
            let ink = label.shape.bounds().inflate(BESIDE, BESIDE);
            for mark in drawing.marks.iter().filter(|mark| mark.pen == Pen::Link) {
                let touched = match &mark.shape {
                    Shape::Line(a, b) => covers(&[*a, *b], ink),
                    Shape::Polygon(corners) => {
                        let next = corners.iter().cycle().skip(1);
                        corners.iter().zip(next).any(|(a, b)| covers(&[*a, *b], ink))
                    }
                    _ => false,
                };
                if touched {
                    wrong.push(format!("{name}: {} touches {}", id(label), id(mark)));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn long_names_of_links_are_set_apart_in_special_points() {
    let renamed = |text: &str, names: &[&str]| {
        let mut scene: serde_json::Value = serde_json::from_str(text).expect("a template is JSON");
        let links = scene["links"].as_object_mut().expect("links by name");
        let values: Vec<_> = std::mem::take(links).into_iter().map(|(_, link)| link).collect();
        links.extend(names.iter().map(|name| name.to_string()).zip(values));
        drawn(&scene.to_string()).expect("it can be drawn").0
    };
    let says = |drawing: &Drawing, panel: &str, name: &str| {
        let labels = labels(drawing, panel);
        assert!(labels.iter().any(|(_, shown)| shown == name), "no {name} in {labels:?}");
    };
    let text = read("templates/third-class.json");
    let third = renamed(&text, &["crank", "rod", "plate", "arm", "leg"]);
    says(&third, "scheme", "Sarm,rod");
    says(&third, "velocity", "sarm,rod");
    // Each is a point of its own.
    for name in ["nb,arm,rod", "nf,arm,rod", "nf,arm,leg"] {
        says(&third, "acceleration", name);
    }
    let text = read("templates/fourth-class.json");
    let fourth = renamed(&text, &["crank", "left", "top", "right", "rod2"]);
    says(&fourth, "scheme", "Stop");
    says(&fourth, "scheme", "Srod2");
    says(&fourth, "acceleration", "ne,rod2");
}

#[test]
fn a_cylinder_shows_what_its_drive_adds() {
    let text = read("templates/hydraulic-boom.json");
    let (drawing, _) = drawn(&text).expect("it can be drawn");
    shows(&drawing, "scheme", "A B C D E O 2 3 4 v3/2");
    shows(&drawing, "velocity", "p a o c ra3");
    shows(&drawing, "acceleration", "π a o c ra3 ka3 naC noC");
    draws(&drawing, Pen::Slider, "scheme-slider-3");
    draws(&drawing, Pen::Vector, "velocity-vector-a-r_a3 acceleration-vector-a-r_a3");
    draws(&drawing, Pen::Coriolis, "acceleration-vector-r_a3-k_a3");
    draws(&drawing, Pen::Normal, "acceleration-vector-k_a3-n_aC");
    draws(&drawing, Pen::Ray, "velocity-ray-r_a3-c acceleration-ray-n_aC-c");
    // The arrow beside the block points the way it is pushed: from A to B, or back.
    let arrow = |drawing: &Drawing| {
        let found = drawing.marks.iter().find(|m| id(m) == "scheme-speed-3u2f2");
        let Some(Shape::Arrow { from, to, .. }) = found.map(|m| m.shape.clone()) else { panic!("no arrow") };
        to - from
    };
    let (back, _) = drawn(&text.replace("\"speed\": 80", "\"speed\": -80")).expect("it can be drawn");
    let (angle, length) = (68.457_610_487_18_f64.to_radians(), 10.0);
    // The sheet's y runs down.
    let (x, y) = (length * libm::cos(angle), -length * libm::sin(angle));
    for (drawing, sign) in [(&drawing, 1.0), (&back, -1.0)] {
        let arrow = arrow(drawing);
        let off = (arrow.x - sign * x).abs().max((arrow.y - sign * y).abs());
        assert!(off < 1e-9, "{arrow:?}");
    }
}

/// At a dead centre a normal acceleration ends in the image of the slider's point: both names stand there. One that vanishes has none.
#[test]
fn the_end_of_a_normal_acceleration_is_named_on_an_image_too() {
    let names = |angle: f64| {
        let scene = format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0] }},
            "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 30 }}, "drive": {{ "angle": {angle}, "omega": 10 }} }},
                "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 80 }} }}, "3": {{ "points": ["C"] }} }},
            "sliders": [{{ "link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0 }}], "near": {{ "C": [80, 0] }} }}"#
        );
        let svg = drawn(&scene).expect("a sound scene").0.svg();
        let texts = svg.split("<text").skip(1).filter_map(|text| Some(text.split_once("</text>")?.0.to_owned()));
        let plain = |text: String| {
            text.split('<')
                .filter_map(|part| part.split_once('>'))
                .map(|(_, words)| words.to_owned())
                .collect::<String>()
        };
        texts.map(|text| plain(format!("<{text}"))).collect::<Vec<String>>()
    };
    let is_named = |names: &[String]| names.iter().any(|name| name.replace(' ', "").contains("nbC"));
    assert!(is_named(&names(0.0)), "{:?}", names(0.0));
    assert!(is_named(&names(40.0)));
    // With the crank across the guide the rod does not turn: its normal part is nothing.
    assert!(!is_named(&names(90.0)));
}
