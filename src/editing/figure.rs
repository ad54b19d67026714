//! Another figure in a scene's text.

use super::edit::{Edit, Key, apply};
use crate::scene::{Figure, Scene, SceneError, figure_keys};
use serde_json::Value as Json;

/// The scene's text with this figure in place of its own. Keys that do not change stay as they are.
///
/// # Errors
/// The text is no scene.
pub fn with_figure(text: &str, figure: &Figure) -> Result<String, SceneError> {
    let own = figure_keys(&Scene::read(text)?.figure);
    let wanted = figure_keys(figure);
    let gone = own.keys().filter(|key| !wanted.contains_key(*key));
    let changed = wanted.keys().chain(gone).filter(|key| wanted.get(*key) != own.get(*key));
    let edit = |key: &String| Edit::Set {
        set: [Key::from("figure"), Key::from(key.as_str())].to_vec(),
        value: wanted.get(key).cloned().unwrap_or(Json::Null),
    };
    apply(text, &changed.map(edit).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::with_figure;
    use crate::scene::{Scene, StyleName};

    const SCENE: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
  "note": "a < b",   "ground": { "A": [0, 0], "D": [160.000000000000000001, 0] },
  "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 60, "omega": 10 } },
    "2": { "points": ["B", "C"], "lengths": { "BC": 140 } }, "3": { "points": ["D", "C"], "lengths": { "CD": 110 } } } }"#;

    #[test]
    fn a_figure_is_put_in_and_taken_out() {
        let mut figure = Scene::read(SCENE).expect("it is good").figure;
        assert_eq!(with_figure(SCENE, &figure).as_deref(), Ok(SCENE));
        (figure.style, figure.mu_v) = (StyleName::Lecture, Some(2.5));
        figure.labels.insert("B".into(), "\"B₁\" </script>".into());
        let put = with_figure(SCENE, &figure).expect("it is good");
        assert_eq!(Scene::read(&put).expect("it is good").figure, figure);
        let rest = [r#"160.000000000000000001, 0] },"#, r#""note": "a < b",   "ground""#];
        assert!(rest.iter().all(|kept| put.contains(kept)), "{put}");
        (figure.style, figure.mu_v) = (StyleName::Paper, Some(5.0));
        let back = with_figure(&put, &figure).expect("it is good");
        assert_eq!(Scene::read(&back).expect("it is good").figure, figure);
        assert!(!back.contains("style"), "{back}");
    }
}
