use super::joint::guide_line;
use super::says;
use super::shape::{Side, local_points};
use super::{Mechanism, Role, StructureError};
use crate::geometry::{Point, complex_product, direction_of_degrees};
use crate::message::Message;
use crate::scene::{self, At, GivenBy, On, Scene};
use indexmap::IndexMap;

/// The role of a link in the mechanism. `mechanism` has the ground's points already.
pub(super) fn role(
    scene: &Scene,
    mechanism: &Mechanism,
    name: &str,
    link: &scene::Link,
) -> Result<Role, StructureError> {
    if let Some(motion) = &link.motion {
        let at: Point = match &motion.at {
            At::Place(p) => (*p).into(),
            At::Point(p) => scene.coordinates.get(p).map_or_else(Point::origin, |&p| p.into()),
        };
        return Ok(Role::Moving {
            at,
            velocity: motion.velocity.into(),
            acceleration: motion.acceleration.into(),
            omega: motion.omega,
            alpha: motion.alpha,
        });
    }
    let Some(drive) = &link.drive else {
        let known = |p: &String| scene.known.contains_key(p);
        let slides = |s: &scene::Slider| s.link.as_deref() == Some(name) || s.on == On::Link(name.to_owned());
        let is_unsolved = !link.points.is_empty() && link.points.iter().all(known) && !scene.sliders.iter().any(slides);
        return Ok(if is_unsolved { Role::Unsolved } else { Role::Member });
    };
    let pivots: Vec<&String> = link.points.iter().filter(|p| scene.ground.contains(p)).collect();
    let [pivot] = pivots.as_slice() else {
        let message = says::one_ground_point(name, pivots.len());
        return Err(scene.error_at(&["links", name, "drive"], message, Some(says::list_pivot())).into());
    };
    let pivot = mechanism.point(pivot).expect("the ground's points were added first");
    Ok(Role::Driver { pivot, angle: drive.angle_deg, omega: drive.omega, alpha: drive.alpha })
}

/// A drive of a scene, which gives its position unless the angle of another link does.
struct Drive {
    /// Its path in the scene.
    path: [String; 3],
    /// What it drives.
    driven: Message,
    /// The key of its position: `angle` or `position`.
    key: &'static str,
    /// Whether the scene gives its position.
    has_position: bool,
}

/// The drives of a scene: those that turn links in file order, then those that push sliders.
fn drives(scene: &Scene) -> Vec<Drive> {
    let turning = scene.links.iter().filter_map(|(name, link)| {
        let drive = link.drive.as_ref()?;
        Some(Drive {
            path: ["links".to_owned(), name.clone(), "drive".to_owned()],
            driven: says::driven_link(name),
            key: "angle",
            has_position: drive.angle_deg.is_some(),
        })
    });
    let pushing = scene.sliders.iter().enumerate().filter_map(|(index, s)| {
        let drive = s.drive?;
        let sliding = s.link.as_ref().or(s.pin.as_ref());
        Some(Drive {
            path: ["sliders".to_owned(), index.to_string(), "drive".to_owned()],
            driven: says::driven_slider(sliding.map_or("", String::as_str)),
            key: "position",
            has_position: drive.position.is_some(),
        })
    });
    turning.chain(pushing).collect()
}

/// The link whose `angle` is given in place of the position of a drive, and that angle from +x in degrees; `None` if
/// every drive has its position, and in a drawn configuration.
///
/// # Errors
/// Several links give an angle; one does though every drive has its position; or more drives lack theirs than links
/// give an angle.
pub(super) fn link_angle_for_drive(scene: &Scene) -> Result<Option<(&str, f64)>, StructureError> {
    if scene.given_by == GivenBy::Drawing {
        return Ok(None);
    }
    let refuse = |path: &[&str], message: Message, hint: Message| Err(scene.error_at(path, message, Some(hint)).into());
    let drives = drives(scene);
    let mut open = drives.iter().filter(|d| !d.has_position);
    let mut angles = scene.links.iter().filter_map(|(name, link)| Some((name.as_str(), link.angle_deg?)));
    let (given, second) = (angles.next(), angles.next());
    if let (Some((first, _)), Some((second, _))) = (given, second) {
        return refuse(&["links", second, "angle"], says::two_angles(first, second), says::remove_one());
    }
    match (given, open.next(), open.next()) {
        (None, None, _) => Ok(None),
        (Some(given), Some(_), None) => Ok(Some(given)),
        (Some((link, _)), None, _) => {
            let path = ["links", link, "angle"];
            let (message, hint) = match drives.as_slice() {
                [] => (says::angle_without_drive(link), says::add_drive()),
                [only] => (says::angle_beside(link, only.driven.clone(), only.key), says::keep_one()),
                _ => (says::angle_beside_all(link), says::keep_one()),
            };
            refuse(&path, message, hint)
        }
        (Some((link, _)), Some(first), Some(second)) => {
            let message = says::two_open_drives(first.driven.clone(), second.driven.clone(), link);
            refuse(&second.path.each_ref().map(String::as_str), message, says::add_to_one(second.key))
        }
        (None, Some(drive), _) => {
            let message = says::open_drive(drive.driven.clone(), drive.key);
            let hint = if drive.key == "angle" { says::add_angle() } else { says::add_position() };
            refuse(&drive.path.each_ref().map(String::as_str), message, hint)
        }
    }
}

/// The places of points that given angles and positions determine, in the fixed frame: those of a link with a ground
/// point and a given angle, and the pushed point of a slider on the ground.
pub(super) fn places_from_drives(scene: &Scene) -> IndexMap<&str, Point> {
    let ground = |name: &str| scene.coordinates.get(name).map(|&p| Point::from(p));
    let mut places = IndexMap::new();
    for link in scene.links.values() {
        let angle = link.drive.as_ref().and_then(|drive| drive.angle_deg);
        let Some(axis) = angle.or(link.angle_deg).map(direction_of_degrees) else {
            continue;
        };
        // If the side of a triangle's third point is open, only the points of the axis are determined.
        let (mut local, side) = local_points(link, |_| None);
        if side == Side::Unknown {
            local.truncate(2);
        }
        let points = || link.points.iter().zip(&local);
        let Some((pivot, center)) = points().find_map(|(p, at)| Some((ground(p)?, *at))) else {
            continue;
        };
        for (name, at) in points() {
            places.insert(name.as_str(), pivot + complex_product(axis, at - center));
        }
    }
    for slider in scene.sliders.iter().filter(|s| s.on == On::Ground) {
        let position = slider.drive.and_then(|drive| drive.position);
        let (Some(at), Some(position)) = (&slider.at, position) else {
            continue;
        };
        if let (Some(start), Some(along)) = guide_line(slider, scene.ground.first(), |name| ground(name)) {
            places.insert(at, start + along * position);
        }
    }
    places
}
