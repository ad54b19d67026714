use super::build::groups;
use super::joint::add_pins;
use super::{Body, BodyId, GROUND, Guide, Mechanism, Placing, Role, Slider, StructureError};
use crate::geometry::{Point, Vector};
use crate::scene::Scene;

/// How positions are found where `link` is at `angle` degrees from +x and one drive has no position.
///
/// That drive is removed, and a carriage without mass or size holds the given link at its angle: the carriage slides
/// along y of the ground, and the link along x of the carriage. So the same groups, loops and assembly modes serve as
/// for a drive. `mechanism` has its bodies and sliders, but neither compound links nor pins yet.
///
/// # Errors
/// The angle does not depend on the drive: one part of the mechanism then has a constraint too many, another one too
/// few.
pub(super) fn placing(
    scene: &Scene,
    mut mechanism: Mechanism,
    link: &str,
    angle: f64,
) -> Result<Placing, StructureError> {
    for body in &mut mechanism.bodies {
        if matches!(body.role, Role::Driver { angle: None, .. }) {
            body.role = Role::Member;
        }
    }
    for slider in &mut mechanism.sliders {
        slider.drive = slider.drive.filter(|drive| drive.position.is_some());
    }
    mechanism.join_driven();
    let held = mechanism.link(link).expect("it is a link of the scene");
    add_carriage(&mut mechanism, held, angle);
    add_pins(&mut mechanism);
    mechanism.groups = groups(scene, &mechanism).map_err(|_| {
        let message = format!(
            "the angle of link {link} cannot stand in place of the drive's: it does not change with that drive"
        );
        let hint = "say in the drive where it stands, or give the angle of a link that turns with it";
        let path = ["links", link, "angle"];
        StructureError::from(scene.error_at(&path, message, Some(hint.into())))
    })?;
    Ok(Placing { link: held, angle, mechanism })
}

/// Adds the carriage on which `link` keeps its angle, in degrees from +x.
fn add_carriage(mechanism: &mut Mechanism, link: BodyId, angle: f64) {
    let carriage = BodyId(mechanism.bodies.len());
    mechanism.bodies.push(Body {
        name: String::new(),
        points: Vec::new(),
        local: Vec::new(),
        role: Role::Member,
        block: true,
    });
    // Both sliders hold the link's first point; the choice only changes the zero of their positions.
    let points = &mechanism.body(link).points;
    let at = *points.first().expect("a link given by lengths has a point");
    // Positions count from a point of the ground, so that no digits are lost where the origin is far away.
    let ground = mechanism.body(GROUND).local.first().copied();
    // The carriage does not turn: from its guide, at 90°, to its axis are −90°.
    let slides = [(GROUND, carriage, ground, Vector::y(), -90.0), (carriage, link, None, Vector::x(), angle)];
    for (on, link, through, direction, turned) in slides {
        let through = through.unwrap_or_else(Point::origin);
        let guide = Guide::Local { through, direction };
        mechanism.add_slider(Slider { link, at, on, guide, counted_from: None, turned, drive: None });
    }
}
