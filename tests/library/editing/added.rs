use super::{position, size};
use kinegon::editing::{Along, Edit, Key, NewLink, NewPoint, NewSlider, PlacedPoint, apply, blank};
use kinegon::scene::{LengthUnit, TimeUnit, Units};
use serde_json::json;

fn link(points: &[(&str, [f64; 2])]) -> Edit {
    let points = points.iter().map(|(name, at)| PlacedPoint { name: (*name).to_owned(), at: *at }).collect();
    Edit::AddLink { add_link: NewLink { points } }
}

fn point(link: &str, name: &str, at: [f64; 2]) -> Edit {
    Edit::AddPoint { add_point: NewPoint { link: link.to_owned(), name: name.to_owned(), at } }
}

fn drive(link: &str, angle: i32) -> Edit {
    let set = ["links", link, "drive"].map(Key::from).to_vec();
    Edit::Set { set, value: json!({ "angle": angle, "omega": 10 }) }
}

fn slider(link: &str, at: &str, on: &str, along: Along) -> Edit {
    Edit::AddSlider { add_slider: NewSlider { link: link.to_owned(), at: at.to_owned(), on: on.to_owned(), along } }
}

fn edited(text: &str, edits: &[Edit]) -> String {
    apply(text, edits).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// All points are where they were put, within rounded lengths.
fn is_at(text: &str, places: &[(&str, [f64; 2])]) {
    let (_, mechanism, pose) = position(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert!(
        pose.warnings.is_empty() && mechanism.warnings.is_empty(),
        "{:?} {:?}\n{text}",
        pose.warnings,
        mechanism.warnings
    );
    for (name, place) in places {
        let off = (pose.point(mechanism.point(name).expect(name)) - kinegon::geometry::Point::from(*place)).norm();
        assert!(off < 0.005 * size(&pose), "{name} is off by {off}\n{text}");
    }
}

const MM: Units = Units::new(LengthUnit::Mm, TimeUnit::S);

#[test]
fn a_mechanism_is_drawn_from_nothing() {
    let places = [("A", [0.0, 0.0]), ("B", [30.0, 52.0]), ("C", [157.34, 110.21]), ("D", [200.0, 0.0])];
    let [a, b, c, d] = places;
    let text = edited(&blank(MM), &[link(&[a, b]), link(&[b, c]), link(&[d, c]), drive("1", 60)]);
    let expected = r#"{
  "kinegon": 1,
  "units": { "length": "mm", "time": "s" },
  "ground": { "A": [0, 0], "D": [200, 0] },
  "links": {
    "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 60, "omega": 10 } },
    "2": { "points": ["B", "C"], "lengths": { "BC": 140 } },
    "3": { "points": ["D", "C"], "lengths": { "DC": 118.2 } }
  },
  "near": { "B": [30, 52], "C": [157.3, 110.2] }
}
"#;
    assert_eq!(text, expected);
    is_at(&text, &places);
    // The other way to assemble it.
    let c = ("C", [157.34, -110.21]);
    let text = edited(&blank(MM), &[link(&[a, b]), link(&[b, c]), link(&[d, c]), drive("1", 60)]);
    is_at(&text, &[a, b, c, d]);
}

#[test]
fn points_are_added_to_links() {
    let four_bar = include_str!("../../../templates/four-bar.json");
    let (_, mechanism, pose) = position(four_bar).expect("a template");
    let c = pose.point(mechanism.point("C").expect("C"));
    for at in [[90.0, 150.0], [90.0, 20.0], [93.0, 81.5]] {
        let text = edited(four_bar, &[point("2", "P", at)]);
        is_at(&text, &[("P", at), ("C", c.into())]);
        let text = edited(&text, &[point("2", "Q", [70.0, 100.0]), point("2", "R", [71.0, 20.0])]);
        is_at(&text, &[("P", at), ("C", c.into()), ("Q", [70.0, 100.0]), ("R", [71.0, 20.0])]);
        assert!(text.contains("\"For a coupler point P, write"), "{text}");
    }
    // On a crank, on the ground, on a block.
    let text = edited(four_bar, &[point("1", "P", [20.0, -10.0])]);
    is_at(&text, &[("P", [20.0, -10.0])]);
    let text = edited(four_bar, &[point("ground", "E", [20.0, -10.0])]);
    assert!(text.contains(r#""D": [160, 0], "E": [20, -10], "note": "The two fixed pivots." }"#), "{text}");
    let drawn = include_str!("../../../templates/dyad-rrr.json");
    let text = edited(drawn, &[point("2", "P", [61.23, 72.0])]);
    is_at(&text, &[("P", [61.2, 72.0])]);
}

#[test]
fn links_and_sliders_join_what_is_there() {
    let four_bar = include_str!("../../../templates/four-bar.json");
    let (_, mechanism, pose) = position(four_bar).expect("a template");
    let c: [f64; 2] = pose.point(mechanism.point("C").expect("C")).into();
    let block = ("E", [300.0, 40.0]);
    let edits = [link(&[("C", c), block]), link(&[block]), slider("5", "E", "ground", Along::Degrees(0.0))];
    let text = edited(four_bar, &edits);
    assert!(
        text.contains(r#""sliders": [{ "link": "5", "at": "E", "on": "ground", "through": [300, 40], "along": 0 }]"#),
        "{text}"
    );
    is_at(&text, &[block, ("C", c)]);
    // A link of three points and one of four, each of which a dyad.
    let three = [("C", c), ("P", [250.0, 150.0]), ("Q", [220.0, 90.0])];
    let ground = Edit::Set { set: ["ground", "G"].map(Key::from).to_vec(), value: json!([300, 0]) };
    let text = edited(four_bar, &[ground.clone(), link(&three), link(&[("G", [300.0, 0.0]), ("P", [250.0, 150.0])])]);
    is_at(&text, &three);
    let four = [("C", c), ("P", [250.0, 150.0]), ("Q", [220.0, 90.0]), ("R", [220.0, 190.0])];
    let text = edited(four_bar, &[ground, link(&four), link(&[("G", [300.0, 0.0]), ("P", [250.0, 150.0])])]);
    is_at(&text, &four);
    assert!(text.contains(r#""shape": { "C": 0, "P": "#), "{text}");
    // A lever with a slot: a pin that rides in it.
    let lever = link(&[("G", [80.0, -60.0]), ("H", [200.0, 300.0])]);
    let ground = Edit::Set { set: ["ground", "G"].map(Key::from).to_vec(), value: json!([80, -60]) };
    let text = edited(four_bar, &[ground, lever, slider("", "C", "4", Along::Points("GH".to_owned()))]);
    is_at(&text, &[("C", c)]);
}

#[test]
fn what_cannot_be_added_is_refused() {
    let four_bar = include_str!("../../../templates/four-bar.json");
    let refused = [
        (link(&[]), "a new link has no points"),
        (link(&[("B-C", [0.0, 0.0])]), "the name `B-C` of a point contains `-`"),
        (link(&[("P", [0.0, 0.0]), ("P", [1.0, 0.0])]), "point P stands twice in the new link"),
        (link(&[("P", [0.0, 0.0]), ("Q", [0.0, 0.0])]), "link 4 would have P and Q in one place"),
        (point("9", "P", [0.0, 0.0]), "there is no link 9"),
        (point("2", "B", [0.0, 0.0]), "link 2 has a point B already"),
        (slider("9", "B", "ground", Along::Degrees(0.0)), "there is no link 9"),
        (slider("2", "D", "ground", Along::Degrees(0.0)), "there is no point D"),
        (slider("2", "B", "1", Along::Degrees(0.0)), "point B is a point of 1, so it cannot slide on it"),
    ];
    for (edit, message) in refused {
        let error = apply(four_bar, &[edit]).expect_err(message);
        assert!(error.message.to_string().starts_with(message), "{error}");
    }
}
