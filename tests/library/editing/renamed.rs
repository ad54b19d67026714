use super::{position, solvable};
use kinegon::editing::{Edit, Named, apply};
use kinegon::scene::Scene;

fn rename(text: &str, what: Named, from: &str, to: &str) -> Result<String, kinegon::scene::SceneError> {
    apply(text, &[Edit::Rename { rename: what, from: from.to_owned(), to: to.to_owned() }])
}

fn renamed(text: &str, what: Named, from: &str, to: &str) -> String {
    rename(text, what, from, to).unwrap_or_else(|error| panic!("{from} to {to}: {error}"))
}

#[test]
fn renamed_and_renamed_back_is_the_same_text() {
    let mut seen = 0;
    for (name, text) in solvable() {
        let (scene, mechanism, pose) = position(&text).expect("solvable");
        let points = mechanism.points.iter().map(|point| (Named::Point, point.clone(), "Qx9"));
        let links = scene.links.keys().map(|link| (Named::Link, link.clone(), "77"));
        for (what, old, new) in points.chain(links) {
            let other = renamed(&text, what, &old, new);
            let (_, there, now) = position(&other).unwrap_or_else(|error| panic!("{name} {old}: {error}\n{other}"));
            // Places may differ in the last digits only where the order of names counts.
            let is_new =
                |name: &str| if name == old && what == Named::Point { new.to_owned() } else { name.to_owned() };
            assert_eq!(pose.points.len(), now.points.len(), "{name} {old}");
            for (a, point) in pose.points.iter().zip(&mechanism.points) {
                let b = now.points[there.point(&is_new(point)).expect("it has its new name").0];
                assert!((a - b).norm() <= 1e-9 * super::size(&pose), "{name} {old}");
            }
            assert_eq!(renamed(&other, what, new, &old), text, "{name} {old}\n{other}");
            seen += 1;
        }
    }
    assert!(seen > 300, "{seen}");
}

#[test]
fn names_change_wherever_they_are_meant() {
    let text = r#"{
  "kinegon": 1, "title": "B and 4 stay here", "note": "B",
  "units": { "length": "mm", "time": "s" },
  "ground": { "A": [0, 0], "G": [275, 0] },
  "links": {
    "1": { "points": ["A", "B"], "lengths": { "AB": 100 }, "drive": { "angle": 70, "omega": -1, "alpha": 0 } },
    "2": { "points": ["B", "E"], "lengths": { "B-E": 500 } },
    "3": { "points": ["D"] },
    "4": { "points": ["G", "D", "F"], "lengths": { "GD": 300, "FG": 150, "FD": 180 } },
    "5": { "points": ["E", "F"], "lengths": { "EF": 300 } }
  },
  "sliders": [{ "link": "3", "at": "D", "on": "2", "through": "B", "along": "BE" }],
  "near": { "D": [263, 300], "E": [406, 428], "F": [338, 136], "angle(4)": 80 },
  "figure": { "labels": { "B": "x", "b": "y", "4": "5", "n_b4": "1", "D_2": "2", "k_b3": "", "S4": "S", "d_2": "" }, "trace": ["D", "E"] },
  "want": ["omega(4)", "v(B)", "v(D/B).size", "vplan( p , b )/mu", "a_n(B/S4)", "position(3/2)", "L(D_2,B)", "aplan(n_b4,s4)"]
}"#;
    let point = renamed(text, Named::Point, "B", "K1");
    let expected = text
        .replace(r#"["A", "B"], "lengths": { "AB""#, r#"["A", "K1"], "lengths": { "AK1""#)
        .replace(r#"["B", "E"], "lengths": { "B-E""#, r#"["K1", "E"], "lengths": { "K1-E""#)
        .replace(r#""through": "B", "along": "BE""#, r#""through": "K1", "along": "K1E""#)
        .replace(r#""B": "x", "b": "y""#, r#""K1": "x", "k1": "y""#)
        .replace("n_b4", "n_k14")
        .replace("k_b3", "k_k13")
        .replace("v(B)", "v(K1)")
        .replace("D/B", "D/K1")
        .replace("p , b )", "p , k1 )")
        .replace("B/S4", "K1/S4")
        .replace("D_2,B", "D_2,K1");
    assert_eq!(point, expected);
    let link = renamed(text, Named::Link, "4", "crank");
    let expected = text
        .replace(r#""4": { "points""#, r#""crank": { "points""#)
        .replace("angle(4)", "angle(crank)")
        .replace(r#""4": "5""#, r#""crank": "5""#)
        .replace("n_b4", "n_bcrank")
        .replace("S4", "Scrank")
        .replace("omega(4)", "omega(crank)")
        .replace("s4", "scrank");
    assert_eq!(link, expected);
    let link = renamed(text, Named::Link, "2", "b");
    let expected = text
        .replace(r#""2": { "points""#, r#""b": { "points""#)
        .replace(r#""on": "2""#, r#""on": "b""#)
        .replace("D_2", "D_b")
        .replace("d_2", "d_b")
        .replace("3/2", "3/b");
    assert_eq!(link, expected);
}

#[test]
fn names_that_cannot_be_are_refused() {
    let text = include_str!("../../../examples/figure-2.json");
    for (what, from, to, message) in [
        (Named::Point, "B", "E", "there is a point E already"),
        (Named::Link, "2", "3", "there is a link 3 already"),
        (Named::Point, "X", "Y", "there is no point X"),
        (Named::Link, "9", "Y", "there is no link 9"),
        (Named::Point, "B", "B-C", "the name `B-C` of a point contains `-`"),
        (Named::Link, "2", "ground", "a link cannot be called `ground`"),
        (Named::Point, "B", "S4", "the name `S4` is kept for the special point of link 4"),
        (Named::Point, "B", "d", "the name `D` is kept for the image of d in the plans"),
    ] {
        let error = rename(text, what, from, to).expect_err(to);
        assert!(error.message.to_string().starts_with(message), "{error}");
    }
    assert_eq!(rename(text, Named::Point, "B", "B").expect("nothing to do"), text);
    assert!(Scene::read(text).is_ok());
}

/// A couple without a name has that of its link, which changes with it; one of the scene's own names stays.
#[test]
fn a_couple_is_called_by_its_link_under_its_new_name() {
    let scene = |link: &str, index: &str| {
        format!(
            r#"{{ "kinegon": 1, "links": {{ "1": ["A", "B"], "{link}": ["B", "C"] }}, "forces": [{{ "on": "{link}", "couple": 5 }}, {{ "name": "M1", "on": "{link}", "couple": 5 }}], "want": ["power(M{index})", "power(M'{index})", "power(M{index}-3)", "moment(M{index},A)", "power(M1)"] }}"#
        )
    };
    assert_eq!(renamed(&scene("3", "3"), Named::Link, "3", "7"), scene("7", "7"));
    assert_eq!(renamed(&scene("3", "3"), Named::Link, "3", "rod"), scene("rod", "_rod"));
    assert_eq!(renamed(&scene("3", "3"), Named::Link, "1", "8"), scene("3", "3").replace("\"1\"", "\"8\""));
}
