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
