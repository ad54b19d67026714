use super::Pose;
use crate::geometry::{Point, Vector, unit};
use crate::mechanism::{Body, Guide, Mechanism, Role};

/// The pose of a drawn configuration: the scene's coordinates, unchanged.
pub(super) fn drawn_pose(mechanism: &Mechanism) -> Pose {
    // Reading the scene has checked that every point has a place.
    let places = mechanism.given.iter();
    let points: Vec<Point> = places.map(|p| p.unwrap_or_else(Point::origin)).collect();
    let guides: Vec<Vector> = mechanism
        .sliders
        .iter()
        .map(|slider| match slider.guide {
            Guide::DrawnBetween(a, b) => unit(points[b.0] - points[a.0]).unwrap_or_else(Vector::x),
            Guide::Drawn(direction) | Guide::Local { direction, .. } => direction,
        })
        .collect();
    let axes = mechanism.bodies.iter().enumerate();
    let axes = axes.map(|(index, body)| match body.points.as_slice() {
        _ if is_nameless(body) => None,
        [a, b, ..] => Some(points[b.0] - points[a.0]),
        // The axis of a link with one point is its guide.
        _ => {
            let mut sliders = mechanism.sliders.iter().zip(&guides);
            let guide = sliders.find(|(s, _)| s.on.0 == index || s.link.0 == index);
            guide.map(|(_, direction)| *direction)
        }
    });
    let slides = mechanism.sliders.iter().zip(&guides).map(|(slider, along)| {
        let from = slider.counted_from?;
        Some((points[slider.at.0] - points[from.0]).dot(along))
    });
    Pose {
        slides: slides.collect(),
        axes: axes.collect(),
        assemblies: vec![None; mechanism.groups.len()],
        points,
        guides,
        warnings: Vec::new(),
    }
}

/// Whether a body has no name in the scene.
fn is_nameless(body: &Body) -> bool {
    body.role == Role::Ground || body.is_nameless()
}
