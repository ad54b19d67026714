//! In: the text of a scene, and what a hand does with it: values that are set, names that change, links and points that come and go.
//! Out: the text with these changes and no others: layout, order of keys and notes stay. The text need only be JSON, except
//! where a change follows from the mechanism's position. Nothing is drawn here, and nothing is kept between two changes.
//!
//! `document` changes a text value by value, so that what is added looks like what is there; `names` reads the names that a text
//! gives, and changes one. On these stand the changes of an [`Edit`]: `add`, `drop`; and those that a hand makes on the picture: `position`
//! moves the mechanism and makes the text choose the assembly that was seen, `reshape` pulls a joint to another place; `placed` does so
//! in a scene that is not complete, too, of which a `draft` says what is known.
//!
//! # The text is the document
//!
//! A change made by hand, in a form or on the picture, is a change of the scene's text: values are replaced, the rest
//! stays byte for byte. A pulled joint gets the lengths that it has at its new place while all other joints stay; a
//! guide that this would take off a joint turns with its link where nothing else hangs on that, else holds the pulled
//! joint on its line. What comes out is solved at once, and `near` says as little as chooses that assembly: first
//! what it said, then present places, then all places.

mod add;
mod document;
mod draft;
mod draft_parts;
mod drop;
#[doc(hidden)] // for tests
pub mod measure;
mod names;
mod placed;
mod position;
mod present;
#[doc(hidden)] // for tests
pub mod reshape;
#[doc(hidden)] // for tests
pub mod says;
mod tables;

pub use add::{Along, NewLink, NewPoint, NewSlider, PlacedPoint, blank};
pub use draft::{Draft, DraftCircle, DraftGuide, DraftLink, DraftLoad, DraftPoint, DraftSlider, DraftSpring};
pub use names::Named;
pub use placed::{apply_in_place, with_places};
pub use position::{with_mode, with_position};
pub use present::places;
#[doc(inline)]
pub use reshape::{Pins, Reshape, Reshaped};
pub use tables::{PutTable, TableFile, TableInFile, lines_of_table, tables_in_files, with_tables};

use crate::scene::{Figure, Scene, SceneError, figure_keys};
use document::Document;
use serde::{Deserialize, Serialize};
use serde_json::Value as Json;

/// One change of a scene's text.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(untagged)]
#[non_exhaustive]
pub enum Edit {
    /// Puts a value at a JSON path, in place of what is there; `null` removes it.
    Set {
        /// The path: keys, and indices of lists.
        set: Vec<Key>,
        /// The value.
        #[serde(default)]
        value: Json,
    },
    /// Removes what is at a JSON path, if something is.
    Remove {
        /// The path.
        remove: Vec<Key>,
    },
    /// Gives a point or a link another name everywhere.
    Rename {
        /// What is renamed.
        rename: Named,
        /// Its name.
        from: String,
        /// Its new name.
        to: String,
    },
    /// A new link between points; those that are new get a place.
    AddLink {
        /// The link.
        add_link: NewLink,
    },
    /// A further point of a link, or of the ground.
    AddPoint {
        /// The point.
        add_point: NewPoint,
    },
    /// A point of a link slides along a guide on the ground or on another link.
    AddSlider {
        /// The slider.
        add_slider: NewSlider,
    },
    /// Removes a link with all that names it, and the points that no other link has.
    DropLink {
        /// Its name.
        drop_link: String,
    },
    /// Removes a point with all that names it, and the links that it leaves without an end.
    DropPoint {
        /// Its name.
        drop_point: String,
    },
}

/// A step of a JSON path.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(untagged)]
#[non_exhaustive]
pub enum Key {
    /// An index of a list, or a name of digits.
    Index(u64),
    /// A key of an object.
    Name(String),
}

impl From<&str> for Key {
    fn from(name: &str) -> Key {
        Key::Name(name.to_owned())
    }
}

/// The text of a scene after some changes, one after the other. It need not be a scene that can be solved, neither before
/// nor after: it need only be JSON. What is not changed stays as it is, to the byte.
///
/// ```
/// use kinegon::editing::{Edit, Key, apply};
///
/// let text = r#"{ "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 } } } }"#;
/// let path = ["links", "1", "lengths", "AB"].map(Key::from);
/// let edits = [Edit::Set { set: path.to_vec(), value: 65.into() }];
/// assert_eq!(apply(text, &edits)?, text.replace("60", "65"));
/// # Ok::<(), kinegon::scene::SceneError>(())
/// ```
///
/// # Errors
/// The text is not JSON, or a change means something that is not there; the place is in `text`.
pub fn apply(text: &str, edits: &[Edit]) -> Result<String, SceneError> {
    let mut document = Document::new(text)?;
    for edit in edits {
        match edit {
            Edit::Set { set, value } => document.set_all(&[(written(set), value.clone())])?,
            Edit::Remove { remove } => document.set_all(&[(written(remove), Json::Null)])?,
            Edit::Rename { rename, from, to } => names::rename(&mut document, *rename, from, to)?,
            Edit::AddLink { add_link } => add::link(&mut document, add_link)?,
            Edit::AddPoint { add_point } => add::point(&mut document, add_point)?,
            Edit::AddSlider { add_slider } => add::slider(&mut document, add_slider)?,
            Edit::DropLink { drop_link } => drop::link(&mut document, drop_link)?,
            Edit::DropPoint { drop_point } => drop::point(&mut document, drop_point)?,
        }
    }
    Ok(document.text())
}

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

/// A path as a document takes it.
fn written(path: &[Key]) -> Vec<String> {
    let name = |key: &Key| match key {
        Key::Index(index) => index.to_string(),
        Key::Name(name) => name.clone(),
    };
    path.iter().map(name).collect()
}
