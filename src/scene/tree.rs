//! In: the text of a scene. Out: its tree of JSON with ranges of bytes, for changes of the text; nothing is asked of the scene.

use jsonc_parser::ast::Value;

use super::error::SceneError;
use super::kind::FileKind;
use super::place::Source;
use super::text;
use super::wrong::Wrong;

/// The text of a scene as JSON.
#[derive(Debug, Clone)]
pub(crate) struct SceneTree<'a> {
    /// The text without a byte order mark. Ranges of the tree count in its bytes.
    pub body: &'a str,
    /// The value that the text holds.
    pub root: Value<'a>,
}

impl<'a> SceneTree<'a> {
    /// The tree of a text, or why this is not JSON.
    pub fn read(text: &'a str) -> Result<SceneTree<'a>, SceneError> {
        let source = Source(text);
        let root = text::tree(source, &FileKind::SCENE).map_err(|wrong| source.error(wrong))?;
        Ok(SceneTree { body: source.body(), root })
    }

    /// An error at a JSON path of a text; an index of a list is written in digits.
    pub fn error(text: &str, path: &[&str], message: impl Into<String>, hint: Option<&str>) -> SceneError {
        let wrong = Wrong::value(path, message).maybe_hint(hint.map(str::to_owned));
        Source(text).error(wrong)
    }
}

/// Why a point or a link cannot have this name; `what` is "a point" or "a link".
pub(crate) fn why_not(what: &str, name: &str) -> Option<(String, Option<String>)> {
    super::name::check_name(what, name).err().map(|wrong| (wrong.message, wrong.hint))
}

/// The two points of a link or of the ground that a key like `AB` or `A-B` names, if it names two of them.
pub(crate) fn pair(key: &str, points: &[String]) -> Option<(String, String)> {
    super::name::pair("", key, "", points, |name| points.iter().any(|point| point == name)).ok()
}
