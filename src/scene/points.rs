//! The frame and the points: their coordinates where they are needed, and approximate places.

use indexmap::IndexMap;

use super::error::{Wrong, close};
use super::given::GivenBy;
use super::link::check_apart;
use super::name::{check_list, check_name};
use super::names::Names;
use super::value::{NamesOr, Vector, several_forms};
use super::write::write_forms;

/// The frame's points: names, or names with coordinates.
#[derive(Debug, Clone)]
pub(super) enum Ground {
    Names(Vec<String>),
    Places(IndexMap<String, Vector>),
}

write_forms! { Ground { Ground::Names(names) => names, Ground::Places(places) => places } }

several_forms!(Ground, "ground", NamesOr {
    expecting: r#"the frame's points as { "A": [x, y], … }, or their names as ["A", …]"#,
    names: Ground::Names,
    other: Ground::Places,
}, generator => {
    "anyOf": [
        generator.subschema_for::<IndexMap<String, Vector>>(),
        { "type": "array", "items": { "type": "string" }, "description": "Names only, in a drawn configuration" },
    ]
});

/// Coordinates in the fixed frame, by the name of the point.
pub(super) type Coordinates = IndexMap<String, [f64; 2]>;

/// The names of the frame's points, and all coordinates that the scene gives.
pub(super) fn ground(
    given_by: GivenBy,
    ground: Option<Ground>,
    points: Option<IndexMap<String, Vector>>,
) -> Result<(Vec<String>, Coordinates), Wrong> {
    let mut coordinates = Coordinates::new();
    for (name, Vector(place)) in points.unwrap_or_default() {
        check_name("a point", &name).map_err(|wrong| wrong.inside(&["points", &name]))?;
        coordinates.insert(name, place);
    }
    let names = match ground {
        None => Vec::new(),
        Some(Ground::Names(_)) if given_by == GivenBy::Lengths => {
            let hint = r#"write { "A": [x, y], … }; or give the coordinates of every point in "points": { … }"#;
            return Err(Wrong::value(&["ground"], "the frame's points have no coordinates").hint(hint));
        }
        Some(Ground::Names(names)) => {
            check_list(&names, "").map_err(|wrong| wrong.inside(&["ground"]))?;
            names
        }
        Some(Ground::Places(places)) => {
            let mut names = Vec::with_capacity(places.len());
            for (name, Vector(place)) in places {
                check_name("a point", &name).map_err(|wrong| wrong.inside(&["ground", &name]))?;
                if coordinates.get(&name).is_some_and(|other| *other != place) {
                    let message = format!("point {name} has other coordinates in `points`");
                    let hint = "name it only in a list: \"ground\": [\"A\", …]";
                    return Err(Wrong::value(&["ground", &name], message).hint(hint));
                }
                coordinates.insert(name.clone(), place);
                names.push(name);
            }
            names
        }
    };
    Ok((names, coordinates))
}

/// Refuses points without coordinates, points on no link and not on the ground, names that results need, and links of
/// zero length.
pub(super) fn check_points(given_by: GivenBy, names: &Names<'_>, coordinates: &Coordinates) -> Result<(), Wrong> {
    let place_of = |point: &str| {
        coordinates.get(point).copied().ok_or_else(|| {
            let near = close(point, coordinates.keys().map(String::as_str));
            let hint = near.unwrap_or_else(|| format!("add \"{point}\": [x, y] to `points`"));
            Wrong::key(&[], format!("point {point} has no coordinates in `points`")).hint(hint)
        })
    };
    for (index, point) in names.ground.iter().enumerate() {
        names
            .check_reserved(point)
            .and_then(|()| place_of(point))
            .map_err(|wrong| wrong.at_first(&[&["ground", &index.to_string()], &["ground", point]]))?;
    }
    for (name, link) in names.links {
        let mut places = Vec::with_capacity(link.points.len());
        for (index, point) in link.points.iter().enumerate() {
            // A scene given by lengths has no places of moving points yet.
            let place = || if given_by == GivenBy::Drawing { place_of(point).map(Some) } else { Ok(None) };
            let place = names.check_reserved(point).and_then(|()| place()).map_err(|wrong| {
                let index = index.to_string();
                wrong.at_first(&[&["points", &index], &["shape", point], &[&index]]).inside(&["links", name])
            })?;
            places.extend(place.map(|place| (point.as_str(), place)));
        }
        check_apart(name, places.into_iter()).map_err(|(_, wrong)| wrong.inside(&["links", name]))?;
    }
    if let Some(point) = coordinates.keys().find(|point| !names.is_point(point)) {
        let all = names.links.values().flat_map(|link| &link.points).map(String::as_str);
        let hint = close(point, all).unwrap_or_else(|| "name it in the `points` of a link, or remove it".into());
        let message = format!("point {point} is on no link and not on the ground");
        return Err(Wrong::key(&["points", point], message).hint(hint));
    }
    Ok(())
}
