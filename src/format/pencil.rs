//! How far hand drawings are from the numbers, in the result file.

use crate::quantity::{Band, Pencil, Unread};
use crate::scene::Units;
use crate::sheet::Scales;
use indexmap::IndexMap;
use serde::Serialize;

/// How far hand drawings at the figure's scales are from the numbers, by quantity name.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct PencilResult {
    /// Limit of the error of a point set, along x and along y, and of a length laid off or measured: millimetres of paper.
    pub mm: f64,
    /// Limit of the error of a direction drawn or read: degrees.
    pub degrees: f64,
    /// The scales of the sheets: units per millimetre of paper.
    #[serde(flatten)]
    #[cfg_attr(feature = "schemas", schemars(schema_with = "scales_schema"))]
    pub mu: Scales,
    /// By quantity name: what an honest drawing gives. A vector stands here by its `.size` and its `.angle`.
    pub bands: IndexMap<String, BandResult>,
    /// By quantity name: why a drawing gives no such value. Given values and points at rest are left out.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub without: IndexMap<String, String>,
}

/// What an honest hand drawing gives for a quantity.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct BandResult {
    /// Its value, of lengths and segments without a sign.
    pub value: f64,
    /// At least 95 of 100 drawings are at most this far from it.
    pub band: f64,
    /// Unit of both.
    pub unit: String,
    /// Present and true where errors are so large against the quantity that the band is only a rough one.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub rough: bool,
}

#[cfg(feature = "schemas")]
fn scales_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    Scales::schema(generator, |sheet| {
        let per_mm = || format!(": {} per millimetre of paper", sheet.facts().scaled_units);
        let units = sheet.order().map_or_else(per_mm, |_| String::new());
        serde_json::json!({ "description": format!("Scale of the {}{units}.", sheet.name()) })
    })
}

/// The bands for the result file.
#[must_use]
pub fn pencil_result(pencil: &Pencil, units: Units) -> PencilResult {
    let (mut bands, mut without) = (IndexMap::new(), IndexMap::new());
    for (asked, band) in &pencil.quantities {
        let name = asked.name().to_owned();
        match band {
            Ok(Band { value, band, is_rough }) => {
                let unit = if asked.written.on_paper { "mm".to_owned() } else { asked.kind().unit(units) };
                let result = BandResult { value: *value, band: *band, unit, rough: *is_rough };
                bands.insert(name, result);
            }
            Err(Unread::Given) => {}
            Err(why) => {
                without.insert(name, why.to_string());
            }
        }
    }
    PencilResult { mm: pencil.tolerance.mm, degrees: pencil.tolerance.degrees, mu: pencil.scales, bands, without }
}
