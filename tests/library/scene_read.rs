//! What a scene says is what the `Scene` holds.

use kinegon::Sheet;
use kinegon::scene::{
    Along, At, GivenBy, LengthUnit, MAX_BYTES, On, Page, PageSize, Scene, SceneError, Shape, SliderDrive, TimeUnit,
};

const FIGURE_2: &str = r#"{ "$schema": "scene.schema.json", "kinegon": 1, "note": "from the paper",
  "title": "Quintero et al. (2011), Figure 2",
  "units":  { "length": "mm", "time": "s", "note": ["any", null, "value"] },
  "ground": { "A": [0, 0], "G": [275, 0], "note": "the frame" },
  "links": {
    "1": { "points": ["A", "B"],      "lengths": { "AB": 100 }, "drive": { "angle": 70, "omega": -1, "alpha": 0 } },
    "2": { "points": ["B", "E"],      "lengths": { "B-E": 500 } },
    "3": { "points": ["D"] },
    "4": { "points": ["G", "D", "F"], "lengths": { "GD": 300, "FG": 150, "FD": 180 } },
    "5": { "points": ["E", "F"],      "lengths": { "EF": 300 } } },
  "sliders": [ { "link": "3", "at": "D", "on": "2", "along": "BE" } ],
  "near":   { "D": [263, 300], "E": [406, 428], "F": [338, 136], "angle(2)": 42 },
  "figure": { "panels": ["velocity", "scheme"], "mu_v": 2.5, "page": "a3-portrait", "labels": { "B": "B₁" },
              "special_points": false },
  "want": ["omega(2)"] }"#;

/// A scene in the lengths form with these links and this after them.
fn with_links(links: &str, more: &str) -> Result<Scene, SceneError> {
    Scene::read(&format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "m", "time": "min" }}, "ground": {{ "A": [0, 0] }},
             "links": {{ {links} }} {more} }}"#
    ))
}

#[test]
fn the_lengths_form_is_read_in_file_order() {
    let scene = Scene::read(FIGURE_2).unwrap();
    assert_eq!(scene.given_by, GivenBy::Lengths);
    assert_eq!((scene.units.length, scene.units.time), (LengthUnit::Mm, TimeUnit::S));
    assert_eq!(scene.ground, ["A", "G"]);
    assert_eq!(scene.coordinates["G"], [275.0, 0.0]);
    assert_eq!(scene.links.keys().collect::<Vec<_>>(), ["1", "2", "3", "4", "5"]);
    let drive = scene.links["1"].drive.unwrap();
    assert_eq!((drive.angle_deg, drive.omega, drive.alpha), (Some(70.0), -1.0, 0.0));
    assert_eq!(scene.links["3"].shape, Shape::Bare);
    let Shape::Lengths(lengths) = &scene.links["4"].shape else { panic!("link 4 has lengths") };
    let shown: Vec<_> = lengths.iter().map(|l| (l.from.as_str(), l.to.as_str(), l.value, l.key.as_str())).collect();
    assert_eq!(shown, [("G", "D", 300.0, "GD"), ("F", "G", 150.0, "FG"), ("F", "D", 180.0, "FD")]);
    let slider = &scene.sliders[0];
    assert_eq!((slider.link.as_deref(), slider.at.as_deref(), slider.pin.as_deref()), (Some("3"), Some("D"), None));
    assert_eq!(slider.on, On::Link("2".into()));
    assert_eq!((&slider.through, slider.turned_deg, slider.drive), (&None, 0.0, None));
    assert_eq!(slider.along, Along::Points("B".into(), "E".into()));
    assert_eq!(scene.near.points.keys().collect::<Vec<_>>(), ["D", "E", "F"]);
    assert_eq!(scene.near.angles_deg["2"], 42.0);
    assert_eq!(scene.figure.panels, [Sheet::Velocity, Sheet::Scheme]);
    assert_eq!(scene.figure.page, Page { size: PageSize::A3, landscape: false });
    assert_eq!(scene.figure.mu.given().collect::<Vec<_>>(), [(Sheet::Velocity, 2.5)]);
    assert_eq!(
        (scene.figure.special_points, scene.figure.construction),
        (false, kinegon::scene::ConstructionShown::Whole)
    );
    assert_eq!(scene.figure.labels["B"], "B₁");
    assert_eq!(scene.want, Some(vec!["omega(2)".into()]));
}

#[test]
fn the_drawn_form_is_read() {
    let scene = Scene::read(
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
          "points": { "B": [0, 0], "C": [70, 150], "D": [9, 1], "Bi": [0, 0] },
          "known": { "D": { "velocity": [51.8, 193.2] } },
          "links": { "2": ["B", "C"], "3": ["C", "D"], "5": ["D"],
            "iB": { "points": ["Bi"], "motion": { "at": "Bi", "velocity": [1, 2], "acceleration": { "size": 150, "angle": 210 },
                                                  "omega": 1.3, "alpha": -4.9 } } },
          "sliders": [ { "link": "2", "at": "B", "on": "iB", "along": [1, 2] }, { "pin": "C", "on": "5" } ] }"#,
    )
    .unwrap();
    assert_eq!(scene.given_by, GivenBy::Drawing);
    assert!(scene.ground.is_empty());
    assert_eq!(scene.known["D"].acceleration, [0.0, 0.0]);
    let motion = scene.links["iB"].motion.as_ref().unwrap();
    assert_eq!((&motion.at, motion.omega, motion.alpha), (&At::Point("Bi".into()), 1.3, -4.9));
    assert!((motion.acceleration[1] + 75.0).abs() < 1e-12);
    assert_eq!(scene.sliders[0].along, Along::Direction([1.0, 2.0]));
    assert_eq!(scene.sliders[1].pin.as_deref(), Some("C"));
    assert_eq!(scene.sliders[1].along, Along::Degrees(0.0));
}

#[test]
fn right_angles_give_exact_zeros() {
    let expected = [[2.0, 0.0], [0.0, 2.0], [-2.0, 0.0], [0.0, -2.0]];
    for turns in -6_i32..=6 {
        let link = r#""1": { "points": ["A", "B"], "lengths": { "AB": 1 } }"#;
        let near = format!(r#", "near": {{ "B": {{ "size": 2, "angle": {} }} }}"#, 90 * turns);
        let scene = with_links(link, &near).unwrap();
        assert_eq!(scene.near.points["B"], expected[turns.rem_euclid(4) as usize], "{turns} quarter turns");
    }
}

#[test]
fn turns_per_minute_count_in_the_unit_of_time() {
    let links = r#""1": { "points": ["A", "B"], "lengths": { "AB": 1 }, "drive": { "rpm": 60 } }"#;
    assert_eq!(with_links(links, "").unwrap().links["1"].drive.unwrap().omega, 60.0 * std::f64::consts::TAU);
    let seconds = FIGURE_2.replace(r#""omega": -1"#, r#""rpm": 30"#);
    assert_eq!(Scene::read(&seconds).unwrap().links["1"].drive.unwrap().omega, std::f64::consts::PI);
}

#[test]
fn a_lone_number_in_a_shape_lies_on_the_axis() {
    let scene = with_links(r#""1": { "shape": { "A": 0, "B": [40, 10], "E": 25 } }"#, "").unwrap();
    assert_eq!(scene.links["1"].points, ["A", "B", "E"]);
    let Shape::Local(places) = &scene.links["1"].shape else { panic!("link 1 has a shape") };
    assert_eq!(places["E"], [25.0, 0.0]);
}

#[test]
fn a_drive_in_a_sliding_link_is_that_of_its_slider() {
    let links = r#""1": { "points": ["A", "C"], "lengths": { "AC": 1 } },
                   "3": { "points": ["C"], "drive": { "position": 2, "speed": 1 } }"#;
    let scene = with_links(links, r#", "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 1] }]"#);
    let scene = scene.unwrap();
    assert_eq!(scene.links["3"].drive, None);
    assert_eq!(scene.sliders[0].drive, Some(SliderDrive { position: Some(2.0), speed: 1.0, acceleration: 0.0 }));
    assert_eq!(scene.sliders[0].through, Some(At::Place([0.0, 1.0])));
}

#[test]
fn straight_links_may_miss_by_rounding_only() {
    let link = |long: f64| {
        let lengths = format!(r#""AC": 0.1, "CD": 0.2, "AD": {long}"#);
        with_links(&format!(r#""1": {{ "points": ["A", "C", "D"], "lengths": {{ {lengths} }} }}"#), "")
    };
    assert!(link(0.1 + 0.2).is_ok());
    assert!(link(0.3 * (1.0 + 1e-13)).is_ok());
    assert!(link(0.3 * (1.0 + 1e-11)).is_err());
}

#[test]
fn names_are_words_of_any_script() {
    let links = r#""Kurbel": { "points": ["A", "B'"], "lengths": { "AB'": 1 } }, "шатун": { "points": ["B'", "Ω_1"], "lengths": { "B'Ω_1": 2 } }"#;
    assert_eq!(with_links(links, "").unwrap().links["шатун"].points, ["B'", "Ω_1"]);
}

#[test]
fn a_byte_order_mark_and_windows_lines_are_read() {
    let text = format!("\u{feff}{}", FIGURE_2.replace('\n', "\r\n"));
    assert!(Scene::read(&text).is_ok());
    let error = Scene::read("\u{feff}{ \"kinegon\": 2 }").unwrap_err();
    let place = error.place.unwrap();
    assert_eq!((place.line, place.column, place.span), (1, 14, 16..17));
}

#[test]
fn later_findings_have_a_place() {
    let scene = Scene::read(FIGURE_2).unwrap();
    let error = scene.error_at(&["sliders", "0", "at"], "cannot be reached", Some("try".into()));
    assert_eq!(error.to_string(), "11:37: sliders[0].at: cannot be reached; hint: try");
    assert_eq!(&FIGURE_2[error.place.unwrap().span], "\"D\"");
    // Of what is not there, the nearest part around it.
    let error = scene.error_at(&["links", "2", "drive"], "missing", None);
    assert_eq!(error.to_string(), "7:5: links.2.drive: missing");
    assert_eq!(scene.error_at(&[], "all of it", None).to_string(), "1:1: all of it");
}

#[test]
fn huge_and_deep_texts_are_refused_at_once() {
    let huge = Scene::read(&" ".repeat(MAX_BYTES + 1)).unwrap_err().to_string();
    assert_eq!(huge, "the scene has 4194305 bytes; at most 4194304 (4 MiB) are read");
    let deep = Scene::read(&"[".repeat(MAX_BYTES)).unwrap_err().to_string();
    assert_eq!(deep, "1:65: brackets are nested deeper than 64 levels");
}

#[test]
fn the_schema_names_every_key() {
    let schema = Scene::schema();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    let keys: Vec<_> = schema["properties"].as_object().unwrap().keys().map(String::as_str).collect();
    let expected = [
        "kinegon", "title", "units", "ground", "points", "known", "links", "sliders", "gears", "contacts", "gravity",
        "forces", "springs", "friction", "analysis", "near", "figure", "want", "form", "hints", "note", "$schema",
    ];
    assert_eq!(keys, expected);
    let text = schema.to_string();
    assert!(!text.contains("null"), "null is refused, so the schema does not offer it");
}
