use super::{position, solvable};
use kinegon::editing::{Edit, apply};
use kinegon::scene::Scene;

#[test]
fn what_is_dropped_is_named_nowhere() {
    for (name, text) in solvable() {
        let (scene, mechanism, _) = position(&text).expect("solvable");
        let points = mechanism.points.iter().map(|point| Edit::DropPoint { drop_point: point.clone() });
        let links = scene.links.keys().map(|link| Edit::DropLink { drop_link: link.clone() });
        for edit in points.chain(links) {
            let left = apply(&text, std::slice::from_ref(&edit)).unwrap_or_else(|error| panic!("{name}: {error}"));
            match Scene::read(&left) {
                Err(error) => assert!(
                    ["a mechanism has at least one link", "a drive to move", "there is no drive to move"]
                        .iter()
                        .any(|message| error.message.to_string().starts_with(message)),
                    "{name} {edit:?}: {error}\n{left}"
                ),
                Ok(left) => {
                    let gone = |point: &String| matches!(&edit, Edit::DropPoint { drop_point } if drop_point == point);
                    assert!(!left.links.values().any(|link| link.points.iter().any(gone)), "{name} {edit:?}");
                    assert!(
                        !left.near.points.keys().any(gone) && !left.coordinates.keys().any(gone),
                        "{name} {edit:?}"
                    );
                    let is_gone = |link: &String| matches!(&edit, Edit::DropLink { drop_link } if drop_link == link);
                    assert!(!left.links.keys().any(is_gone), "{name} {edit:?}");
                }
            }
            // The rest stays as it stands.
            let notes = |text: &str| text.matches("\"note\"").count();
            assert!(notes(&left) <= notes(&text));
        }
    }
}

#[test]
fn labels_paths_and_quantities_go_too() {
    let text = include_str!("../../../examples/figure-2.json");
    let with = text.replace("\"construction\": \"paper\"", "\"trace\": [\"E\", \"D\"]");
    let with =
        with.replacen("\"figure\"", "\"want\": [\"v(E)\", \"omega(5)\", \"omega(4)\", \"a(S4)\"], \"figure\"", 1);
    Scene::read(&with).expect("a scene");
    let left = apply(&with, &[Edit::DropLink { drop_link: "5".to_owned() }]).expect("it is there");
    assert!(
        left.contains(r#""labels": { "ground": "6", "k_b3": "", "n_b3": "n_{s3b}", "n_g3": "n_{s3g}" }"#),
        "{left}"
    );
    assert!(left.contains(r#""want": ["v(E)", "omega(4)", "a(S4)"]"#), "{left}");
    let left = apply(&with, &[Edit::DropPoint { drop_point: "E".to_owned() }]).expect("it is there");
    assert!(left.contains(r#""trace": ["D"]"#) && left.contains(r#""want": ["omega(4)", "a(S4)"]"#), "{left}");
    assert!(left.contains(r#""2": { "points": ["B"] }"#) && !left.contains("\"5\": {"), "{left}");
    assert!(left.contains(r#""near": { "D": [263, 300], "F": [338, 136] }"#), "{left}");
}

/// An empty list of centres would ask for none of them; without the key the usual ones are shown.
#[test]
fn the_last_named_centre_takes_its_key_along() {
    let mut scene: serde_json::Value =
        serde_json::from_str(include_str!("../../../templates/four-bar.json")).expect("a scene");
    let dropped = |scene: &serde_json::Value| -> serde_json::Value {
        let edit = Edit::DropLink { drop_link: "2".to_owned() };
        serde_json::from_str(&apply(&scene.to_string(), &[edit]).expect("it can be dropped")).expect("a scene")
    };
    scene["figure"] = serde_json::json!({ "panels": ["scheme", "centers"], "centers": ["P(2,ground)", "P(1,2)"] });
    assert!(dropped(&scene)["figure"].get("centers").is_none());
    scene["figure"]["centers"] = serde_json::json!(["P(2,ground)", "P(1,3)"]);
    assert_eq!(dropped(&scene)["figure"]["centers"], serde_json::json!(["P(1,3)"]));
}
