//! The scene file, version 1, as it is written: the contract, key by key.

use indexmap::IndexMap;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

use super::figure::{DecimalMark, LanguageName, NotationName, Panel, StyleName};
use super::forms::{Direction, Ground, LinkForm, NameOrPlace, NearValue, ShapePoint, Vector};
use super::units::{LengthUnit, TimeUnit};

/// A planar mechanism: x right, y up, counter-clockwise positive, angles in degrees.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a scene as { "kinegon": 1, … }"#)]
#[schemars(rename = "scene")]
pub(super) struct SceneFile {
    /// Version of the scene format.
    #[schemars(schema_with = "version")]
    #[serde(rename = "kinegon")]
    pub _kinegon: u64,
    /// Title of the mechanism, for example the publication it is from.
    pub title: Option<String>,
    /// Units of every length and time of the scene. They are labels; nothing is converted.
    pub units: UnitsFile,
    /// The frame's points with their coordinates; in a drawn configuration their names are enough.
    pub ground: Option<Ground>,
    /// A drawn configuration: coordinates of every point. Then there are no lengths, shapes or angles.
    pub points: Option<IndexMap<String, Vector>>,
    /// Points of known motion, in a drawn configuration.
    pub known: Option<IndexMap<String, PointMotionFile>>,
    /// The links by name. A point named in two links is a revolute joint between them.
    pub links: IndexMap<String, LinkForm>,
    /// Links that slide along straight guides, and pins that ride in slots.
    #[serde(default)]
    pub sliders: Vec<SliderFile>,
    /// Approximate coordinates of some points, and angles of links as "angle(3)", to choose the assembly mode.
    /// A slotted lever with one point has its slider on the positive side of `through`, unless its angle stands here.
    pub near: Option<IndexMap<String, NearValue>>,
    /// What the figure shows, and how large.
    pub figure: Option<FigureFile>,
    /// Names of the quantities asked for, as "omega(2)" or "a(S3)"; left out: everything.
    pub want: Option<Vec<String>>,
}

fn version(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "const": 1 })
}

/// Units of every length and time of the scene.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"units as { "length": "mm", "time": "s" }"#)]
#[schemars(rename = "units")]
pub(super) struct UnitsFile {
    /// Unit of length.
    pub length: LengthUnit,
    /// Unit of time.
    pub time: TimeUnit,
}

/// A vector by size and angle.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a vector as { "size": 150, "angle": 210 }"#)]
#[schemars(rename = "sizeAngle")]
pub(super) struct SizeAngle {
    /// Size, not negative.
    #[schemars(range(min = 0.0))]
    pub size: f64,
    /// Angle from +x, in degrees.
    pub angle: f64,
}

/// Known motion of a point.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a motion as { "velocity": [x, y], "acceleration": [x, y] }"#)]
#[schemars(rename = "pointMotion")]
pub(super) struct PointMotionFile {
    /// Velocity, in length per time.
    pub velocity: Vector,
    /// Acceleration, in length per time squared; left out: zero.
    pub acceleration: Option<Vector>,
}

/// A rigid link. Its axis runs from its first to its second point.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = "a link")]
#[schemars(rename = "linkFields")]
pub(super) struct LinkFields {
    /// Names of its points.
    pub points: Option<Vec<String>>,
    /// Distances between its points, as { "AB": 100 } or { "A-B": 100 }: one for two points, three for three.
    pub lengths: Option<IndexMap<String, f64>>,
    /// Coordinates of its points in its own frame, whose x axis is the link's axis.
    pub shape: Option<IndexMap<String, ShapePoint>>,
    /// The drive that turns the link about its ground pivot.
    pub drive: Option<LinkDriveFile>,
    /// Angle of the link's axis from +x in degrees, in place of that of a drive: one link may give it where one drive does not.
    pub angle: Option<f64>,
    /// Known motion of the link, in a drawn configuration.
    pub motion: Option<LinkMotionFile>,
}

/// A drive: it turns the link (angle, omega or rpm, alpha), or pushes a sliding link (position, speed, acceleration).
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a drive as { "angle": 70, "omega": -1 }"#)]
#[schemars(rename = "linkDrive")]
pub(super) struct LinkDriveFile {
    /// Angle of the link's axis from +x, in degrees.
    pub angle: Option<f64>,
    /// Angular velocity, in radians per unit of time.
    pub omega: Option<f64>,
    /// Speed of rotation in turns per minute, in place of omega.
    pub rpm: Option<f64>,
    /// Angular acceleration, in radians per unit of time squared; left out: zero.
    pub alpha: Option<f64>,
    /// Of a sliding link: distance along its guide from the guide's `through`.
    pub position: Option<f64>,
    /// Of a sliding link: speed along its guide.
    pub speed: Option<f64>,
    /// Of a sliding link: acceleration along its guide; left out: zero.
    pub acceleration: Option<f64>,
}

/// Known motion of a link.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a motion as { "at": "B", "velocity": [x, y], "omega": 1 }"#)]
#[schemars(rename = "linkMotion")]
pub(super) struct LinkMotionFile {
    /// The point or the place where the link has the velocity and the acceleration given here.
    pub at: NameOrPlace,
    /// Velocity there, in length per time.
    pub velocity: Vector,
    /// Acceleration there, in length per time squared; left out: zero.
    pub acceleration: Option<Vector>,
    /// Angular velocity, in radians per unit of time; left out: zero.
    pub omega: Option<f64>,
    /// Angular acceleration, in radians per unit of time squared; left out: zero.
    pub alpha: Option<f64>,
}

/// A link, by its point `at`, slides on a guide of `on`; or a pin rides in a slot of `on`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a slider as { "link": "3", "at": "D", "on": "2", "along": "BE" }"#)]
#[schemars(rename = "slider")]
pub(super) struct SliderFile {
    /// The sliding link.
    pub link: Option<String>,
    /// The point of the sliding link that is on the guide.
    pub at: Option<String>,
    /// A pin of another link that rides in the slot, in place of link and at.
    pub pin: Option<String>,
    /// What carries the guide: a link, or "ground".
    pub on: String,
    /// A place on the guide: a point of `on`, or [x, y] on the ground or in the shape of `on`.
    /// Left out: the first point of `along`, else of `on`.
    pub through: Option<NameOrPlace>,
    /// The direction of the guide; left out: 0.
    /// Degrees count from +x on the ground, from the axis of `on` otherwise.
    pub along: Option<Direction>,
    /// Degrees from the guide to the slider's axis; left out: 0.
    pub turned: Option<f64>,
    /// The drive that pushes the slider.
    pub drive: Option<SliderDriveFile>,
}

/// A drive that pushes a slider along its guide.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a drive as { "position": 40, "speed": 10 }"#)]
#[schemars(rename = "sliderDrive")]
pub(super) struct SliderDriveFile {
    /// Distance along the guide from `through`.
    pub position: Option<f64>,
    /// Speed along the guide.
    pub speed: f64,
    /// Acceleration along the guide; left out: zero.
    pub acceleration: Option<f64>,
}

/// What the figure shows, and how large.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a figure as { "panels": ["scheme", "velocity"] }"#)]
#[schemars(rename = "figure")]
pub(super) struct FigureFile {
    /// The panels, in order; left out: all three.
    #[schemars(length(min = 1), extend("uniqueItems" = true))]
    pub panels: Option<Vec<Panel>>,
    /// Scale of the scheme: units of length per millimetre of paper.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mu_l: Option<f64>,
    /// Scale of the velocity plan: units of velocity per millimetre of paper.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mu_v: Option<f64>,
    /// Scale of the acceleration plan: units of acceleration per millimetre of paper.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mu_a: Option<f64>,
    /// The sheet: "a4", "a3" or "letter", with "-portrait" where it does not lie; left out: "a4".
    #[schemars(extend("enum" = super::figure::Page::NAMES))]
    pub page: Option<String>,
    /// Whether it is a work sheet: with a table of all measured lengths and a ruler to test the printer; left out: false.
    pub worksheet: Option<bool>,
    /// How lines and letters look; left out: "paper".
    pub style: Option<StyleName>,
    /// How poles, images and parts of accelerations are written; left out: "paper". Names of quantities stay the same.
    pub notation: Option<NotationName>,
    /// Language of headings and captions; left out: "en".
    pub language: Option<LanguageName>,
    /// What stands before the decimals of numbers on figures and in the text of steps; left out: "point".
    pub decimal: Option<DecimalMark>,
    /// Text to show in place of a name: { "B'": "B₁" }.
    pub labels: Option<IndexMap<String, String>>,
    /// Whether special points are shown; left out: true.
    pub special_points: Option<bool>,
    /// Whether construction lines are shown; left out: true.
    pub construction: Option<bool>,
    /// The step of the construction up to which the figure is drawn, from 1; left out: finished.
    #[schemars(range(min = 1))]
    pub step: Option<u16>,
}
