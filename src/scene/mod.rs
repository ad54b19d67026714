//! Comes in: the text of a scene file (version 1). Goes out: a checked [`Scene`], or a [`SceneError`] with its place.
//! A `Scene` says what the person wrote, in the person's units, degrees and order; every name in it refers to something.
//! It does not solve positions, count degrees of freedom, look for groups or read files: later stages do.
//!
//! In reading order: `units`, `link`, `slider` and `figure` hold the types of a scene; `read` goes the whole way (`kind`: for any kind of file);
//! `text` turns text into JSON, `file` and `forms` say what the file looks like, `names` and the `check_…` files hold
//! what must be true; `error`, `place` and `words` say what is wrong and where; `schema` says all of it to editors.
//! `build`, `build_parts` and `write` put the text of a scene together in Rust, which then goes the same way.

mod figure;
mod link;
mod slider;
mod units;

mod kind;
mod read;
mod text;

mod file;
mod forms;
mod schema;

mod check_figure;
mod check_lengths;
mod check_links;
mod check_points;
mod check_sliders;
mod names;

mod build;
mod build_parts;
mod write;

mod error;
mod place;
mod words;

pub use build::Builder;
pub use build_parts::{Guide, NewLink, Push, Turn};
pub use error::{Place, SceneError};
pub use figure::{DecimalMark, Figure, LanguageName, NotationName, Page, PageSize, Panel, StyleName};
pub use forms::{Direction, polar};
pub use link::{At, Drive, Length, Link, LinkMotion, Shape};
pub use slider::{Along, On, Slider, SliderDrive};
pub use units::{LengthUnit, TimeUnit, Units};

pub(crate) use kind::FileKind;
pub(crate) use read::read_as;
pub(crate) use schema::schema_of;
pub(crate) use words::{nearest, nearest_within};

use indexmap::IndexMap;

/// The largest scene text that is read, in bytes; a larger one is refused before anything is parsed.
pub const MAX_BYTES: usize = 4 << 20;

/// A mechanism as its scene file describes it: checked, complete, in the file's order and units, angles in degrees.
///
/// Every coordinate is in the fixed frame (x right, y up) and in `units.length`, unless its field says otherwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The title, if the scene has one.
    pub title: Option<String>,
    /// The units of every length and time of the scene.
    pub units: Units,
    /// Whether the scene gives lengths or a drawn configuration.
    pub form: Form,
    /// Names of the frame's points, in file order.
    pub ground: Vec<String>,
    /// Given positions: of the ground points (lengths form), of every point (drawn form).
    pub coordinates: IndexMap<String, [f64; 2]>,
    /// Points whose motion is given (drawn form only).
    pub known: IndexMap<String, PointMotion>,
    /// The links by name. Without the frame.
    pub links: IndexMap<String, Link>,
    /// The sliders and pins in slots.
    pub sliders: Vec<Slider>,
    /// Approximate positions that choose the assembly mode (lengths form only).
    pub near: Near,
    /// What the figure shows, and how large.
    pub figure: Figure,
    /// Names of the quantities asked for; `None` asks for all. The names themselves are not checked here.
    pub want: Option<Vec<String>>,
    /// The scene's text, to find the places of later findings.
    text: String,
}

/// The two ways to give a mechanism.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Ground points, lengths or shapes, and drives with angles: positions have to be found.
    Lengths,
    /// Coordinates of every point: positions are given.
    Drawn,
}

/// The given motion of one point, in the fixed frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PointMotion {
    /// Velocity, in length per time.
    pub velocity: [f64; 2],
    /// Acceleration, in length per time squared; zero unless given.
    pub acceleration: [f64; 2],
}

/// Approximate positions, which choose among the assembly modes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Near {
    /// Approximate coordinates of points, in the fixed frame.
    pub points: IndexMap<String, [f64; 2]>,
    /// Approximate angles of links by link name, in degrees (written `"angle(3)"` in the file).
    pub angles_deg: IndexMap<String, f64>,
}

impl Scene {
    /// The scene that `text` describes, or the first thing that is wrong with it.
    ///
    /// ```
    /// use kinegon::scene::Scene;
    /// let scene = Scene::read(r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
    ///     "ground": { "A": [0, 0] },
    ///     "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 100 }, "drive": { "angle": 70, "omega": -1 } } } }"#)?;
    /// assert_eq!(scene.links["1"].points, ["A", "B"]);
    ///
    /// let error = Scene::read(r#"{ "kinegon": 1, "unit": {} }"#).unwrap_err();
    /// assert_eq!(error.to_string(), "1:17: unit: unknown key `unit`; hint: did you mean `units`?");
    /// # Ok::<(), kinegon::scene::SceneError>(())
    /// ```
    pub fn read(text: &str) -> Result<Scene, SceneError> {
        read::read(text)
    }

    /// An error at a JSON path of this scene, for findings of later stages; an index of a list is written in digits.
    ///
    /// Where the scene has nothing at the path, the place is that of the nearest part around it.
    pub fn error_at(&self, path: &[&str], message: impl Into<String>, hint: Option<String>) -> SceneError {
        place::Source(&self.text).error(path, message).maybe_hint(hint)
    }

    /// The JSON Schema (draft 2020-12) of the scene file, with descriptions, for editors.
    pub fn schema() -> serde_json::Value {
        schema::schema_of::<file::SceneFile>("Kinegon scene, version 1")
    }
}
