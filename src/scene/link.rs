//! Links: their keys in the file and their checked form, with points, shape, and drive or motion.

use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::Deserialize;

use super::error::Wrong;
use super::given::{DRAWN, Drive, GivenBy, LinkDriveFile, LinkMotion, SliderDrive, first_given};
use super::name::{check_list, check_name};
use super::shape::{Shape, lengths, local};
use super::units::TimeUnit;
use super::value::{NamesOr, ShapePoint, several_forms};
use super::write::{write_forms, write_keys};

/// A rigid link. Its axis runs from its first to its second point.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
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
    pub motion: Option<LinkMotion>,
}

write_keys!(LinkFields { points, shape, lengths, drive, angle, motion });

/// A link in the file: a list of points, or an object.
#[derive(Debug, Clone)]
pub(super) struct LinkFile(pub LinkFields);

write_forms! { LinkFile { LinkFile(fields) => fields } }

several_forms!(LinkFile, "link", NamesOr {
    expecting: r#"a link as { "points": ["A", "B"], … }, or a list of its points ["A", "B"]"#,
    names: |points| LinkFile(LinkFields { points: Some(points), ..LinkFields::default() }),
    other: LinkFile,
}, generator => {
    "anyOf": [
        generator.subschema_for::<LinkFields>(),
        { "type": "array", "items": { "type": "string" }, "description": "The link's points" },
    ]
});

/// A rigid link.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Names of its points, in file order; of a shape without a list of points in the order of the shape. Its axis runs
    /// from the first to the second, except with [`Shape::Local`].
    pub points: Vec<String>,
    /// The distances between its points; always [`Shape::Bare`] in a drawn configuration.
    pub shape: Shape,
    /// The drive that turns it, if any.
    pub drive: Option<Drive>,
    /// Angle of its axis from +x, in degrees, given in place of the angle of another link's drive. The angle of a link
    /// with a drive of its own is in the drive.
    pub angle_deg: Option<f64>,
    /// Its motion, if it is a body of given motion; only in a drawn configuration.
    pub motion: Option<LinkMotion>,
}

/// Drives along a guide that are written in the sliding link, by the name of the link.
pub(super) type Pushes = IndexMap<String, SliderDrive>;

/// The links, and the drives in them that belong to sliders.
pub(super) fn links(
    given_by: GivenBy,
    time: TimeUnit,
    file: IndexMap<String, LinkFile>,
) -> Result<(IndexMap<String, Link>, Pushes), Wrong> {
    if file.is_empty() {
        return Err(Wrong::value(&["links"], "a mechanism has at least one link"));
    }
    let mut links = IndexMap::with_capacity(file.len());
    let mut pushes = Pushes::new();
    for (name, LinkFile(fields)) in file {
        let read = check_name("a link", &name).and_then(|()| link(given_by, time, &name, fields));
        let (link, push) = read.map_err(|wrong| wrong.inside(&["links", &name]))?;
        if let Some(push) = push {
            pushes.insert(name.clone(), push);
        }
        links.insert(name, link);
    }
    Ok((links, pushes))
}

/// A link, and the drive in it that belongs to its slider.
fn link(
    given_by: GivenBy,
    time: TimeUnit,
    name: &str,
    fields: LinkFields,
) -> Result<(Link, Option<SliderDrive>), Wrong> {
    check_given_by(given_by, name, &fields)?;
    let points = points(name, &fields)?;
    let shape = match (fields.shape, fields.lengths) {
        (Some(_), Some(_)) => {
            let message = format!("link {name} has both `lengths` and `shape`");
            return Err(Wrong::key(&["lengths"], message).hint("keep one of them"));
        }
        (Some(shape), None) => local(name, &points, shape)?,
        (None, given) if given_by == GivenBy::Lengths => lengths(name, &points, given.unwrap_or_default())?,
        (None, _) => Shape::Bare,
    };
    if fields.drive.is_some() && fields.motion.is_some() {
        let message = format!("link {name} has both a drive and a known motion");
        return Err(Wrong::key(&["drive"], message).hint("keep one of them"));
    }
    let read = fields.drive.map(|drive| drive.read(time, name)).transpose();
    let (mut drive, push) = read.map_err(|wrong| wrong.inside(&["drive"]))?.unwrap_or_default();
    let mut angle_deg = fields.angle;
    if let Some(drive) = &mut drive {
        if angle_deg.is_some() && drive.angle_deg.is_some() {
            let message = format!("link {name} has an angle and its drive has one too");
            return Err(Wrong::value(&["angle"], message).hint("keep one of them"));
        }
        drive.angle_deg = drive.angle_deg.or(angle_deg.take());
    }
    Ok((Link { points, shape, drive, angle_deg, motion: fields.motion }, push))
}

/// Refuses keys of lengths in a drawing, and keys of a drawing in a scene given by lengths.
fn check_given_by(given_by: GivenBy, name: &str, fields: &LinkFields) -> Result<(), Wrong> {
    if given_by == GivenBy::Lengths {
        if fields.motion.is_some() {
            let message = format!("link {name}: a known `motion` belongs to a drawn configuration");
            let hint = r#"give the coordinates of every point in "points": { … }, or drive the link"#;
            return Err(Wrong::key(&["motion"], message).hint(hint));
        }
        return Ok(());
    }
    let given =
        [("lengths", fields.lengths.is_some()), ("shape", fields.shape.is_some()), ("angle", fields.angle.is_some())];
    if let Some(key) = first_given(&given) {
        let message = format!("link {name} has `{key}`, but this scene is a drawn configuration");
        let hint = format!("remove `{key}`: {DRAWN}; or remove `points` and give `ground` its coordinates");
        return Err(Wrong::key(&[key], message).hint(hint));
    }
    let check = |drive: &LinkDriveFile| drive.check_given_by(given_by, name);
    fields.drive.as_ref().map_or(Ok(()), check).map_err(|wrong| wrong.inside(&["drive"]))
}

/// The names of a link's points: those of `points`, else of `shape`.
fn points(name: &str, fields: &LinkFields) -> Result<Vec<String>, Wrong> {
    let shape = fields.shape.as_ref().map(IndexMap::keys);
    for point in shape.clone().into_iter().flatten() {
        check_name("a point", point).map_err(|wrong| wrong.inside(&["shape", point]))?;
    }
    let Some(points) = &fields.points else {
        return match (shape, &fields.motion) {
            (Some(shape), _) => Ok(shape.cloned().collect()),
            (None, Some(_)) => Ok(Vec::new()),
            (None, None) => {
                Err(Wrong::value(&[], format!("link {name} has no `points`")).hint(r#"add "points": ["A", "B"]"#))
            }
        };
    };
    check_list(points, &format!(" in link {name}")).map_err(|wrong| wrong.inside(&["points"]))?;
    Ok(points.clone())
}
