//! Whether a mechanism has what the loads of its scene name: sliders over whose positions they change, joints that have friction.

use super::{Mechanism, StructureError, says};
use crate::scene::{Gauge, GivenBy, RubbingJoint, Scene};
use crate::text::shown;

/// Checks the loads of a scene against its mechanism, whose pins are joined.
pub(super) fn check_loads(scene: &Scene, mechanism: &Mechanism) -> Result<(), StructureError> {
    check_gauges(scene, mechanism)?;
    check_friction(scene, mechanism)
}

/// Whether there are the sliders over whose positions loads change.
fn check_gauges(scene: &Scene, mechanism: &Mechanism) -> Result<(), StructureError> {
    let loads = scene.loads.iter().flat_map(|loads| &loads.loads).enumerate();
    let gauges = loads.filter_map(|(index, load)| Some((index, &load.over.as_ref()?.of)));
    for (index, gauge) in gauges {
        let Gauge::Position(name) = gauge else { continue };
        let message = match mechanism.slider_named(name) {
            None => says::over_no_slider(shown(name)),
            Some(id) if scene.given_by == GivenBy::Drawing && mechanism.slider(id).counted_from.is_none() => {
                says::over_no_zero(name)
            }
            Some(_) => continue,
        };
        let path = ["forces", &index.to_string(), "over", "of"];
        return Err(scene.error_at(&path, message, None).into());
    }
    Ok(())
}

/// Whether there are the joints that have friction.
fn check_friction(scene: &Scene, mechanism: &Mechanism) -> Result<(), StructureError> {
    let all = scene.loads.iter().flat_map(|loads| &loads.friction).enumerate();
    for (index, friction) in all {
        let (key, message, hint) = match &friction.joint {
            RubbingJoint::Guide(name) if mechanism.slider_named(name).is_none() => {
                let names: Vec<String> = mechanism.slider_ids().map(|id| mechanism.slider_name(id)).collect();
                let hint = (!names.is_empty()).then(|| says::the_sliders_are(names.join(", ")));
                ("guide", says::friction_no_slider(shown(name)), hint)
            }
            RubbingJoint::Guide(name)
                if mechanism.slider_named(name).is_some_and(|id| mechanism.slider(id).is_contact) =>
            {
                ("guide", says::friction_of_contact(shown(name)), Some(says::no_friction_of_contact()))
            }
            RubbingJoint::Pin { point, .. } if mechanism.is_center_of_contact(point) => {
                ("pin", says::friction_of_contact(point), Some(says::no_friction_of_contact()))
            }
            RubbingJoint::Pin { point, fixed_in, .. } => {
                let links: Vec<&str> =
                    mechanism.holders_of_pin(point).filter(|b| !b.block).map(|b| b.name.as_str()).collect();
                match (mechanism.joints_at_pin(point).count(), fixed_in) {
                    (0, _) => ("pin", says::friction_no_joint(point), None),
                    (1, Some(_)) => ("fixed_in", says::pin_of_two(point), Some(says::leave_fixed_in_out())),
                    (2.., None) => {
                        let message = says::pin_of_several(point, links.join(", "));
                        ("pin", message, links.first().map(|link| says::write_fixed_in(*link)))
                    }
                    _ => continue,
                }
            }
            _ => continue,
        };
        return Err(scene.error_at(&["friction", &index.to_string(), key], message, hint).into());
    }
    Ok(())
}
