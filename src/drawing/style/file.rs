//! The format of the style file, version 1, key by key.

use super::super::look::{Cap, Colour, Dash, Pen};
use super::paint::{DashList, Dashes, Millimetres, Paint};
use crate::scene::{Measure, Sizes, StyleName};
use indexmap::IndexMap;
use serde::de::{Error, IntoDeserializer, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

/// How a figure looks: colours, widths and dashes of its pens. What is left out is as in the style that this one is based on.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "style"))]
#[serde(deny_unknown_fields, expecting = r#"a style as { "kinegon_style": 1, … }"#)]
pub(super) struct StyleFile {
    /// Version of the style format.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "crate::scene::schema_made::version"))]
    #[serde(rename = "kinegon_style")]
    pub _version: u64,
    /// Where an editor finds the schema.
    #[cfg_attr(feature = "schemas", schemars(skip))]
    #[serde(rename = "$schema")]
    pub _schema: Option<String>,
    /// The style that this one differs from; left out: "paper".
    pub based_on: Option<StyleName>,
    /// Colour of the paper, and of the halos around letters.
    pub background: Option<Colour>,
    /// Colour of everything that has no other.
    pub ink: Option<Colour>,
    /// Colour of what comes with the step that a sheet shows.
    pub accent: Option<Colour>,
    /// Colours of the links in their order, again from the first where there are more links; [] for none.
    pub links: Option<Vec<Colour>>,
    /// Tints of the links' areas, likewise.
    pub tints: Option<Vec<Colour>>,
    /// Colours of the curves in a panel, likewise.
    pub curves: Option<Vec<Colour>>,
    /// Dashes of the curves: all colours with the first, then all with the second, and so on.
    pub curve_dashes: Option<Vec<DashList>>,
    /// Sizes of letters and signs; everything else on a sheet is in proportion to its letters.
    #[serde(default)]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<SizesFile>"))]
    pub sizes: SizesFile,
    /// Whether figures show values where the scene does not say so; left out: as the style that this one is based on.
    pub values: Option<bool>,
    /// How each kind of mark looks.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "pens"))]
    #[serde(default)]
    pub pens: IndexMap<PenName, PenFile>,
}

/// Sizes of letters and signs on a sheet: in mm, or as "3.6 %" of the sheet's shorter side.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "sizes"))]
#[serde(deny_unknown_fields, expecting = r#"sizes as { "letters": 6, "arrowheads": 3.5 }"#)]
pub(super) struct SizesFile {
    /// Size of letters, one em; subscripts are smaller.
    pub letters: Option<Measure>,
    /// Length of the arrowheads of long vectors.
    pub arrowheads: Option<Measure>,
    /// Diameter of the dots in plans.
    pub points: Option<Measure>,
    /// Diameter of the circles of joints.
    pub joints: Option<Measure>,
}

impl SizesFile {
    fn over(self, sizes: Sizes) -> Sizes {
        Sizes {
            letters: self.letters.unwrap_or(sizes.letters),
            arrowheads: self.arrowheads.unwrap_or(sizes.arrowheads),
            points: self.points.unwrap_or(sizes.points),
            joints: self.joints.unwrap_or(sizes.joints),
            lines: sizes.lines,
        }
    }
}

/// A pen as a key, read as a text first: a message about its value can then name it.
#[derive(Debug, PartialEq, Eq, Hash)]
pub(super) struct PenName(Pen);

impl<'de> Deserialize<'de> for PenName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Name;
        impl Visitor<'_> for Name {
            type Value = PenName;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a pen")
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<PenName, E> {
                Pen::deserialize(name.into_deserializer()).map(PenName)
            }
        }
        deserializer.deserialize_str(Name)
    }
}

/// How one kind of mark looks.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "pen"))]
#[serde(deny_unknown_fields, expecting = r##"a pen as { "stroke": "#b5361c", "width": 0.25 }"##)]
pub(super) struct PenFile {
    /// Colour of lines and arrowheads.
    pub stroke: Option<Paint>,
    /// Width of lines, in mm.
    pub width: Option<Millimetres>,
    /// Dashes and gaps in turn, in mm; [] for full lines.
    pub dash: Option<Dashes>,
    /// Colour inside polygons and circles.
    pub fill: Option<Paint>,
    /// How lines end: "flat" at the very end, "round" beyond it.
    pub cap: Option<Cap>,
    /// Colour of letters; left out: that of lines, else the style's ink.
    pub ink: Option<Paint>,
    /// Width of the line in the background's colour around letters that stand on lines, in mm; 0 for none.
    pub halo: Option<Millimetres>,
}

impl PenFile {
    /// This pen, with the values of the other where it has none.
    fn or(self, other: PenFile) -> PenFile {
        PenFile {
            stroke: self.stroke.or(other.stroke),
            width: self.width.or(other.width),
            dash: self.dash.or(other.dash),
            fill: self.fill.or(other.fill),
            cap: self.cap.or(other.cap),
            ink: self.ink.or(other.ink),
            halo: self.halo.or(other.halo),
        }
    }
}

impl StyleFile {
    /// The values of a style, with those of this file in place of its own.
    pub(super) fn over(self, mut all: StyleValues) -> StyleValues {
        all.background = self.background.unwrap_or(all.background);
        all.ink = self.ink.unwrap_or(all.ink);
        all.accent = self.accent.unwrap_or(all.accent);
        all.links = self.links.unwrap_or(all.links);
        all.tints = self.tints.unwrap_or(all.tints);
        all.curves = self.curves.unwrap_or(all.curves);
        if let Some(dashes) = self.curve_dashes {
            all.curve_dashes = dashes.into_iter().map(|DashList(dash)| dash).collect();
        }
        all.sizes = self.sizes.over(all.sizes);
        all.values = self.values.unwrap_or(all.values);
        all.pens.resize(Pen::COUNT, PenFile::default());
        for (PenName(pen), own) in self.pens {
            let place = &mut all.pens[pen as usize];
            *place = own.or(std::mem::take(place));
        }
        all
    }
}

/// All values of a style, from its file and those on which it is based.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct StyleValues {
    pub background: Colour,
    pub ink: Colour,
    pub accent: Colour,
    pub links: Vec<Colour>,
    pub tints: Vec<Colour>,
    pub curves: Vec<Colour>,
    pub curve_dashes: Vec<Dash>,
    pub sizes: Sizes,
    pub values: bool,
    /// By pen.
    pub pens: Vec<PenFile>,
}

/// An object with a key for each pen.
#[cfg(feature = "schemas")]
fn pens(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let pen = generator.subschema_for::<PenFile>();
    let names = <Pen as schemars::JsonSchema>::json_schema(generator).to_value();
    let mut properties = serde_json::Map::new();
    for name in names["oneOf"].as_array().into_iter().flatten() {
        let Some(key) = name["const"].as_str() else {
            continue;
        };
        let mut schema = pen.clone();
        schema.insert("description".into(), name["description"].clone());
        properties.insert(key.to_owned(), schema.to_value());
    }
    schemars::json_schema!({
        "description": "How each kind of mark looks",
        "type": "object", "properties": serde_json::Value::Object(properties), "additionalProperties": false
    })
}
