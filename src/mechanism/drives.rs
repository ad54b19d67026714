use super::joint::guide_line;
use super::shape::{Side, local_points};
use super::{Mechanism, Role, StructureError};
use crate::geometry::{Point, Vector, direction_of_degrees};
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
        let message =
            format!("link {name} is driven, so it must have one point on the ground; it has {}", pivots.len());
        let hint = "list the point about which it turns in `ground` and among the link's points";
        return Err(scene.error_at(&["links", name, "drive"], message, Some(hint.into())).into());
    };
    let pivot = mechanism.point(pivot).expect("the ground's points were added first");
    Ok(Role::Driver { pivot, angle: drive.angle_deg, omega: drive.omega, alpha: drive.alpha })
}

/// A drive of a scene, which gives its position unless the angle of another link does.
struct Drive {
    /// Its path in the scene.
    path: [String; 3],
    /// What it drives, in words: `link 1`, `slider 3`.
    driven: String,
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
            driven: format!("link {name}"),
            key: "angle",
            has_position: drive.angle_deg.is_some(),
        })
    });
    let pushing = scene.sliders.iter().enumerate().filter_map(|(index, s)| {
        let drive = s.drive?;
        let sliding = s.link.as_ref().or(s.pin.as_ref());
        Some(Drive {
            path: ["sliders".to_owned(), index.to_string(), "drive".to_owned()],
            driven: format!("slider {}", sliding.map_or("", String::as_str)),
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
    let refuse =
        |path: &[&str], message: String, hint: &str| Err(scene.error_at(path, message, Some(hint.into())).into());
    let drives = drives(scene);
    let mut open = drives.iter().filter(|d| !d.has_position);
    let mut angles = scene.links.iter().filter_map(|(name, link)| Some((name.as_str(), link.angle_deg?)));
    let (given, second) = (angles.next(), angles.next());
    if let (Some((first, _)), Some((second, _))) = (given, second) {
        let message =
            format!("links {first} and {second} both give an angle; that of one link can stand in place of a drive's");
        let hint = "remove one of them; approximate angles stand in `near`";
        return refuse(&["links", second, "angle"], message, hint);
    }
    match (given, open.next(), open.next()) {
        (None, None, _) => Ok(None),
        (Some(given), Some(_), None) => Ok(Some(given)),
        (Some((link, _)), None, _) => {
            let path = ["links", link, "angle"];
            let (message, hint) = match drives.as_slice() {
                [] => (
                    format!("link {link} gives an angle, but no link has a drive"),
                    "add a drive with `omega` to the link that turns about a ground point",
                ),
                [only] => (
                    format!(
                        "link {link} gives an angle, but the drive of {} gives its {} already",
                        only.driven, only.key
                    ),
                    "keep one of them; an approximate angle stands in `near`",
                ),
                _ => (
                    format!("link {link} gives an angle, but every drive says already where it stands"),
                    "keep one of them; an approximate angle stands in `near`",
                ),
            };
            refuse(&path, message, hint)
        }
        (Some((link, _)), Some(first), Some(second)) => {
            let message = format!(
                "the drives of {} and {} do not say where they stand; the angle of link {link} stands in place of one only",
                first.driven, second.driven
            );
            let hint = format!("add \"{}\" to one of them", second.key);
            refuse(&second.path.each_ref().map(String::as_str), message, &hint)
        }
        (None, Some(drive), _) => {
            let message = format!("the drive of {} gives no `{}`", drive.driven, drive.key);
            let hint = match drive.key {
                "angle" => {
                    "add \"angle\": degrees from +x to the link's axis; or give another link's `angle` in its place"
                }
                _ => {
                    "add \"position\": its distance along the guide from `through`; or give a link's `angle` in its place"
                }
            };
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
            let arm = at - center;
            let turned = Vector::new(axis.x * arm.x - axis.y * arm.y, axis.y * arm.x + axis.x * arm.y);
            places.insert(name.as_str(), pivot + turned);
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
