//! Angles of a scene that are probably meant in radians.

use crate::scene::{Along, Scene};
use std::f64::consts::{PI, TAU};

/// Most by which a rounded angle may differ from a multiple of 15° in radians.
const ROUNDED: f64 = 1e-3;

/// Warnings of angles that are near multiples of π/12, less than a turn in radians, and no round number of degrees.
pub(super) fn radians_warnings(scene: &Scene) -> Vec<String> {
    let links = scene.links.iter().filter_map(|(name, link)| {
        let angle = link.angle_deg.or(link.drive.and_then(|drive| drive.angle_deg))?;
        Some((format!("the angle of link {name}"), angle))
    });
    let sliders = scene.sliders.iter().filter_map(|slider| match slider.along {
        Along::Degrees(angle) => {
            let slides = slider.link.as_ref().or(slider.pin.as_ref())?;
            Some((format!("the guide of {slides}"), angle))
        }
        _ => None,
    });
    let near = scene.near.angles_deg.iter().map(|(name, &angle)| (format!("`near` for angle({name})"), angle));
    let all = links.chain(sliders).chain(near);
    let warning = |(what, angle): (String, f64)| {
        let degrees = degrees_meant(angle)?;
        Some(format!(
            "{what} is taken as {angle}°, which looks like radians: angles are in degrees, so {degrees} if that is meant"
        ))
    };
    all.filter_map(warning).collect()
}

/// The multiple of 15° that an angle is in radians; `None` where it looks like degrees.
fn degrees_meant(angle: f64) -> Option<f64> {
    let tenths = angle * 10.0;
    let is_round = (tenths - libm::round(tenths)).abs() < 1e-9;
    let step = PI / 12.0;
    let count = libm::round(angle / step);
    let is_near = count != 0.0 && (angle - count * step).abs() <= ROUNDED;
    (!is_round && is_near && angle.abs() < TAU + ROUNDED).then_some(15.0 * count)
}
