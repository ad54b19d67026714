//! The scene file, version 1, as it is written: the contract, key by key.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

use super::figure::Figure;
use super::link::LinkFile;
use super::motion::PointMotion;
use super::points::Ground;
use super::slider::SliderFile;
use super::units::Units;
use super::value::{Entries, NearValue, Vector};
use super::write::write_keys;

/// A planar mechanism: x right, y up, counter-clockwise positive, angles in degrees.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a scene as { "kinegon": 1, … }"#)]
#[schemars(rename = "scene")]
pub(super) struct SceneFile {
    /// Version of the scene format.
    #[schemars(schema_with = "version")]
    pub kinegon: u64,
    /// Title of the mechanism, for example the publication it is from.
    pub title: Option<String>,
    /// Units of every length and time of the scene. They are labels; nothing is converted.
    pub units: Units,
    /// The frame's points with their coordinates; in a drawn configuration their names are enough.
    pub ground: Option<Ground>,
    /// A drawn configuration: coordinates of every point. Then there are no lengths, shapes or angles.
    pub points: Option<Entries<Vector>>,
    /// Points of known motion, in a drawn configuration.
    pub known: Option<Entries<PointMotion>>,
    /// The links by name. A point named in two links is a revolute joint between them.
    pub links: Entries<LinkFile>,
    /// Links that slide along straight guides, and pins that ride in slots.
    pub sliders: Option<Vec<SliderFile>>,
    /// Approximate coordinates of some points, and angles of links as "angle(3)", to choose the assembly mode.
    /// A slotted lever with one point has its slider on the positive side of `through`, unless its angle stands here.
    pub near: Option<Entries<NearValue>>,
    /// What the figure shows, and how large.
    pub figure: Option<Figure>,
    /// Names of the quantities asked for, as "omega(2)" or "a(S3)"; left out: everything.
    pub want: Option<Vec<String>>,
}

fn version(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "const": 1 })
}

write_keys!(SceneFile { kinegon, title, units, ground, points, known, links, sliders, near, figure, want });
