//! The study file, version 1, key by key.

use super::task::Figure;
use crate::message::Message;
use crate::scene::{FileKind, SceneError, SceneTree, range_of, read_as, schema};
use crate::text::Untrusted;
use indexmap::IndexMap;
use jsonc_parser::ast::Value as Node;
use serde::Deserialize;
use serde_json::Value as Json;

/// The seed of a study that names none.
pub(super) const USUAL_SEED: u64 = 1;

const STUDY: FileKind = FileKind { what: crate::scene::says::study, key: "kinegon_study", version: 1 };

/// Many mechanisms that differ from one scene in some numbers, each moved through a cycle.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "study"))]
#[serde(deny_unknown_fields, expecting = r#"a study as { "kinegon_study": 1, … }"#)]
pub(super) struct Keys {
    /// Version of the format.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "crate::scene::schema_made::version"))]
    #[serde(rename = "kinegon_study")]
    _version: u64,
    /// Where an editor finds the schema.
    #[cfg_attr(feature = "schemas", schemars(skip))]
    #[serde(rename = "$schema")]
    _schema: Option<String>,
    /// What the study is for; not used.
    #[serde(rename = "title")]
    _title: Option<Untrusted>,
    /// The scene: the path of its file from the study's folder, or the scene itself.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "scene"))]
    scene: Json,
    /// The numbers of the scene that vary, by name: "2.BC" a length of link 2, "D.x" a coordinate of a ground point, "2.E.y" one in a
    /// link's shape, "1.omega" a number of a drive; or by their places in the scene, as "links.2.lengths.BC".
    pub vary: IndexMap<String, Range>,
    /// How many mechanisms are drawn by lot at each point of the grid; needed where a number varies at random.
    #[cfg_attr(feature = "schemas", schemars(range(min = 1)))]
    pub count: Option<u64>,
    /// Chooses the random numbers; left out: 1.
    pub seed: Option<u64>,
    /// Whether `max`, `min`, `max_abs` and `at_scene` each have a column with the bound of the error of the value there, as
    /// "omega(3).max_error"; left out: not. It takes some hundred times as long.
    #[serde(default)]
    #[cfg_attr(feature = "schemas", schemars(extend("default" = false)))]
    pub bounds: bool,
    /// Whether extremes of a mechanism that goes round smoothly are those of the positions at the steps, and are not looked for between them;
    /// left out: they are. It takes less time, and misses the true extremes by up to the height of the curve between two steps.
    #[serde(default)]
    #[cfg_attr(feature = "schemas", schemars(extend("default" = false)))]
    pub at_steps: bool,
    /// The motion of each mechanism.
    pub cycle: Cycle,
    /// By the name of a quantity, as "omega(3)": which figures of it; of vectors they are figures of the size.
    pub want: IndexMap<String, Vec<Figure>>,
}

/// The values that a number takes: a grid with `count`, all equally likely between `from` and `to` without it; about the scene's number
/// within `plus_minus`, all equally likely; or about it with the standard deviation `sigma`.
#[derive(Clone, Copy, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(
    deny_unknown_fields,
    expecting = r#"a range as { "from": 80, "to": 120, "count": 9 } or { "plus_minus": 0.5 }"#
)]
#[cfg_attr(feature = "schemas", schemars(rename = "range"))]
pub(super) struct Range {
    /// First value.
    pub from: Option<f64>,
    /// Last value.
    pub to: Option<f64>,
    /// Number of values of a grid, both ends among them.
    #[cfg_attr(feature = "schemas", schemars(range(min = 2)))]
    pub count: Option<u64>,
    /// The middle of `plus_minus` or `sigma`; left out: the scene's number.
    pub nominal: Option<f64>,
    /// Largest distance from the middle.
    pub plus_minus: Option<f64>,
    /// Standard deviation of a normal distribution.
    pub sigma: Option<f64>,
}

/// The motion of a drive in equal steps.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "cycle"))]
#[serde(deny_unknown_fields, expecting = r#"a cycle as { "from": 0, "to": 360, "step": 5 }"#)]
pub(super) struct Cycle {
    /// The drive that moves, if not the first.
    pub drive: Option<String>,
    /// First value of the drive: an angle in degrees, or a position along the guide.
    pub from: f64,
    /// Last value of the drive.
    pub to: f64,
    /// Distance from one position to the next; a whole number of steps leads from `from` to `to`.
    pub step: f64,
    /// Whether other drives stand still; left out: they run along in proportion to their speeds.
    #[serde(default)]
    #[cfg_attr(feature = "schemas", schemars(extend("default" = false)))]
    pub alone: bool,
}

#[cfg(feature = "schemas")]
fn scene(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({ "anyOf": [{ "type": "string", "description": "Path of a scene file" }, { "type": "object", "description": "A scene" }] })
}

/// Where a study has its scene.
#[derive(Clone, Debug, PartialEq)]
pub enum SceneGiven {
    /// In a file, whose path is from the study's folder.
    Path(String),
    /// In the study itself: the scene's text, with its places in the study.
    Inline(String),
}

/// A study as it is written; with its scene it becomes a [`Study`](super::Study).
#[derive(Clone, Debug)]
pub struct StudyFile {
    text: String,
    pub(super) keys: Keys,
}

impl StudyFile {
    /// The study of a text.
    ///
    /// # Errors
    /// The first thing that is wrong with the text, with its place.
    pub fn read(text: &str) -> Result<StudyFile, SceneError> {
        let keys: Keys = read_as(text, &STUDY)?;
        let file = StudyFile { text: text.to_owned(), keys };
        if !matches!(file.keys.scene, Json::String(_) | Json::Object(_)) {
            let hint = r#"write "scene": "four-bar.json", or the scene itself as { "kinegon": 1, … }"#;
            return file.refuse(&["scene"], "a scene is the path of a file or an object", Some(hint));
        }
        if file.keys.bounds && file.keys.at_steps {
            let hint = "leave out one of them";
            return file.refuse(&["at_steps"], "bounds are those of extremes that are looked for", Some(hint));
        }
        if file.keys.vary.is_empty() {
            let hint = r#"add what varies, as "vary": { "2.BC": { "from": 80, "to": 120, "count": 9 } }"#;
            return file.refuse(&["vary"], "nothing varies", Some(hint));
        }
        let empty = file.keys.want.iter().find(|(_, figures)| figures.is_empty());
        let hint = r#"add what is wanted, as "want": { "omega(3)": ["max", "min"] }"#;
        match empty {
            Some((name, _)) => file.refuse(&["want", name], "no figure of this quantity is wanted", Some(hint)),
            None if file.keys.want.is_empty() => file.refuse(&["want"], "nothing is wanted", Some(hint)),
            None => Ok(file),
        }
    }

    /// Where its scene is.
    #[must_use]
    pub fn scene(&self) -> SceneGiven {
        match &self.keys.scene {
            Json::String(path) => SceneGiven::Path(path.clone()),
            _ => SceneGiven::Inline(self.inline()),
        }
    }

    /// The text of the inline scene, with blanks in place of what stands before it, so that places in it are those in the study.
    fn inline(&self) -> String {
        let Ok(SceneTree { body, root: Node::Object(root) }) = SceneTree::read(&self.text) else {
            return String::new();
        };
        let scene = root.properties.iter().rev().find(|property| property.name.as_str() == "scene");
        let Some(range) = scene.map(|property| range_of(&property.value)) else {
            return String::new();
        };
        let before: String = body[..range.start].chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
        before + &body[range]
    }

    /// What a file of its rows says of where they come from, so that they can be made again: `kinegon.version`, `kinegon.seed`,
    /// `kinegon.study` with the study's text, and `kinegon.scene` with that of its scene where this is a file of its own.
    #[must_use]
    pub fn origin(&self, scene: &str) -> Vec<(String, String)> {
        let seed = self.keys.seed.unwrap_or(USUAL_SEED).to_string();
        let is_apart = matches!(self.scene(), SceneGiven::Path(_));
        let own = [("version", env!("CARGO_PKG_VERSION")), ("seed", &seed), ("study", &self.text)];
        let all = own.into_iter().chain(is_apart.then_some(("scene", scene)));
        all.map(|(key, said)| (format!("kinegon.{key}"), said.to_owned())).collect()
    }

    /// An error at a place of the study.
    pub(super) fn error(&self, path: &[&str], message: impl Into<Message>, hint: Option<Message>) -> SceneError {
        SceneTree::error(&self.text, path, message.into(), hint)
    }

    /// Refuses what stands at a place of the study.
    pub(super) fn refuse<T, E: From<SceneError>>(
        &self,
        path: &[&str],
        message: impl Into<Message>,
        hint: Option<&str>,
    ) -> Result<T, E> {
        Err(self.error(path, message, hint.map(Message::from)).into())
    }

    /// The JSON Schema (draft 2020-12) of studies, with descriptions, for editors.
    #[must_use]
    pub fn schema() -> Json {
        schema!("study", Keys, "Kinegon study, version 1")
    }
}
