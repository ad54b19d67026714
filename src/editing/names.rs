//! The names in a scene's text, whether it can be solved or not.

use indexmap::{IndexMap, IndexSet};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value as Json;

use crate::scene::pair;

/// What has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Named {
    /// A point.
    Point,
    /// A link.
    Link,
}

/// The names of points and links that a text gives.
#[derive(Clone, Debug, Default)]
pub(super) struct Names {
    /// The points of the ground.
    pub ground: Vec<String>,
    /// The points of each link.
    pub links: IndexMap<String, Vec<String>>,
    /// By slider: what carries its guide.
    on: Vec<String>,
    /// Points with coordinates in a drawn scene; `None` for a scene from lengths.
    pub drawn: Option<Vec<String>>,
}

impl Names {
    /// The names in a text.
    pub fn of(scene: &Json) -> Names {
        let links = scene["links"].as_object().into_iter().flatten().filter(|(name, _)| *name != "note");
        let sliders = scene["sliders"].as_array().into_iter().flatten();
        Names {
            ground: keys_or_list(&scene["ground"]),
            links: links.map(|(name, link)| (name.clone(), points_of(link))).collect(),
            on: sliders.map(|slider| slider["on"].as_str().unwrap_or_default().to_owned()).collect(),
            drawn: scene.get("points").map(keys_or_list),
        }
    }

    /// All points, each once.
    pub fn points(&self) -> Vec<String> {
        self.named_points().collect::<IndexSet<_>>().into_iter().cloned().collect()
    }

    fn named_points(&self) -> impl Iterator<Item = &String> {
        self.ground.iter().chain(self.links.values().flatten()).chain(self.drawn.iter().flatten())
    }

    /// Whether there is such a point.
    pub fn has_point(&self, name: &str) -> bool {
        self.named_points().any(|point| point == name)
    }

    /// The points of a link or of `ground`.
    pub fn of_carrier(&self, carrier: &str) -> &[String] {
        match carrier {
            "ground" => &self.ground,
            link => self.links.get(link).map_or(&[], Vec::as_slice),
        }
    }

    /// What carries the guide of the slider of that index.
    pub fn carrier(&self, slider: &str) -> &str {
        let index: Option<usize> = slider.parse().ok();
        index.and_then(|index| self.on.get(index)).map_or("", String::as_str)
    }
}

/// The points that a link's entry names.
fn points_of(link: &Json) -> Vec<String> {
    match link {
        Json::Array(_) => keys_or_list(link),
        _ if link["points"].is_array() => keys_or_list(&link["points"]),
        _ => keys_or_list(&link["shape"]),
    }
}

/// The texts of a list, or the keys of an object but for notes.
fn keys_or_list(value: &Json) -> Vec<String> {
    match value {
        Json::Array(names) => names.iter().filter_map(Json::as_str).map(str::to_owned).collect(),
        Json::Object(entries) => entries.keys().filter(|key| *key != "note").cloned().collect(),
        _ => Vec::new(),
    }
}

/// The key of two points in place of another one of points with these new names: with a hyphen where that one has it or
/// where the names would run together.
pub(super) fn joined_like(old: &str, from: &str, to: &str, points: &[String]) -> String {
    let together = format!("{from}{to}");
    let is_clear = pair(&together, points).is_some_and(|(a, b)| a == from && b == to);
    if old.contains('-') || !is_clear { format!("{from}-{to}") } else { together }
}
