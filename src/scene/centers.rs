//! The instant centres that a figure asks for, and the velocities and curvatures by them.

use super::error::{Wrong, shortened};
use super::figure::Figure;
use super::head::Head;
use super::names::Names;
use super::quantity_name::QuantityName;
use super::says;
use super::write::{Write, Written};
use serde::de::{SeqAccess, Unexpected, Visitor};
use std::fmt;

/// Which instant centres a figure shows, besides those that lead to them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub enum CentersShown {
    /// All of a mechanism with at most four links, of a larger one those of all links with the frame.
    #[default]
    Usual,
    /// All.
    All,
    /// These, by their names, as `P(2,ground)`.
    Named(Vec<String>),
}

impl Write for CentersShown {
    fn written(&self) -> Written {
        match self {
            CentersShown::Usual => Written::Nothing,
            CentersShown::All => ALL.written(),
            CentersShown::Named(names) => names.written(),
        }
    }
}

/// The word for all centres.
const ALL: &str = "all";

super::value::several_forms!(CentersShown, "centers", CentersVisitor, _generator => {
    "description": "\"all\", or centres by their links, as [\"P(2,ground)\", \"P(1,3)\"]",
    "anyOf": [{ "const": ALL }, { "type": "array", "items": { "type": "string" }, "uniqueItems": true }]
});

struct CentersVisitor;

impl<'de> Visitor<'de> for CentersVisitor {
    type Value = CentersShown;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(r#""all", or centres as ["P(2,ground)", "P(1,3)"]"#)
    }

    fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<CentersShown, E> {
        match word {
            ALL => Ok(CentersShown::All),
            _ => Err(E::invalid_type(Unexpected::Str(word), &self)),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<CentersShown, A::Error> {
        let mut names = Vec::new();
        while let Some(name) = list.next_element()? {
            names.push(name);
        }
        Ok(CentersShown::Named(names))
    }
}

/// Refuses centres of what is no pair of links, velocities and curvatures of what is no point of a moving link.
pub(super) fn check_centers(names: &Names<'_>, figure: &Figure) -> Result<(), Wrong> {
    if let CentersShown::Named(centers) = &figure.centers {
        for (index, center) in centers.iter().enumerate() {
            let path = ["centers", &index.to_string()];
            check_center(&path, names, center)?;
            if centers[..index].contains(center) {
                return Err(Wrong::value(&path, says::center_twice(shortened(center))));
            }
        }
    }
    for (key, points) in [("velocities", &figure.velocities), ("curvature", &figure.curvature)] {
        for (index, point) in points.iter().enumerate() {
            let path = [key, &index.to_string()];
            names.point(&path, point)?;
            if names.on_ground(point) {
                return Err(Wrong::value(&path, says::ground_is_at_rest(point)));
            }
            if points[..index].contains(point) {
                return Err(Wrong::value(&path, says::point_twice(point)));
            }
        }
    }
    Ok(())
}

fn check_center(path: &[&str], names: &Names<'_>, center: &str) -> Result<(), Wrong> {
    let named = QuantityName::parse(center).filter(|name| name.head == Head::Center && name.is_plain());
    let no_center = || Wrong::value(path, says::no_center(shortened(center))).hint(says::name_center());
    let links = named.ok_or_else(no_center)?.arguments;
    for link in links.iter().filter(|link| *link != "ground") {
        names.link(path, link)?;
    }
    match links.as_slice() {
        [a, b] if a != b => Ok(()),
        _ => Err(no_center()),
    }
}
