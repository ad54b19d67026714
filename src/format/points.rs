//! Places and motions of points in the result file.

use crate::accuracy::Bounds;
use crate::construction::{Solution, coincident_name};
use crate::geometry::{Place, Point};
use crate::mechanism::{BodyId, PointId};
use crate::sheet::Order;
use indexmap::IndexMap;
use serde::Serialize;

/// The motion of a point.
#[derive(Debug, Default, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PointResult {
    /// Where it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<[f64; 2]>,
    /// Bound on the error of both coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position_error: Option<f64>,
    /// The direction in which it lies at infinity, in place of a position.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_infinity: Option<[f64; 2]>,
    /// Its velocity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity: Option<[f64; 2]>,
    /// Bound on the error of both components of `velocity`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity_error: Option<f64>,
    /// Its acceleration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<[f64; 2]>,
    /// Bound on the error of both components of `acceleration`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration_error: Option<f64>,
    /// The link of which it is a point, where its name does not say so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub on: Option<String>,
}

/// All points: joints, points of guides under sliders, special points.
pub(super) fn points(solution: &Solution, bounds: &Bounds<'_>) -> IndexMap<String, PointResult> {
    let Solution { mechanism, pose, motion, construction, .. } = solution;
    let mut points = IndexMap::new();
    let has_accelerations = motion.order == Order::Acceleration;
    let moving = |body: BodyId, place: Point, on: Option<BodyId>, errors: [f64; 3]| PointResult {
        position: Some([place.x, place.y]),
        position_error: Some(errors[0]),
        velocity: Some(motion.body(body).velocity_at(place).into()),
        velocity_error: Some(errors[1]),
        acceleration: has_accelerations.then(|| motion.body(body).acceleration_at(place).into()),
        acceleration_error: has_accelerations.then_some(errors[2]),
        on: on.map(|b| mechanism.body(b).name.clone()),
        ..PointResult::default()
    };
    let point_of = |body: BodyId, point: PointId, on: Option<BodyId>| {
        let [velocity, acceleration] = bounds.motion_of(body, point);
        moving(body, pose.point(point), on, [bounds.place(point), velocity, acceleration])
    };
    let holders = mechanism.holders();
    for point in mechanism.point_ids() {
        let holders = &holders[point.0];
        // Preferably a body of known motion.
        if let Some(&body) = holders.iter().find(|&&body| mechanism.is_known(body)).or(holders.first()) {
            let name = mechanism.point_name(point).to_owned();
            points.insert(name, point_of(body, point, None));
        }
    }
    for slider in &mechanism.sliders {
        let name = coincident_name(mechanism.point_name(slider.at), &mechanism.body(slider.on).name);
        let under = point_of(slider.on, slider.at, Some(slider.on));
        points.entry(name).or_insert(under);
    }
    for special in construction.special.iter().filter(|s| s.is_assur) {
        let result = match special.place {
            Place::At(place) => {
                let errors = bounds.special(special).unwrap_or_default();
                moving(special.link, place, Some(special.link), errors)
            }
            Place::AtInfinity(direction) => PointResult {
                at_infinity: Some(direction.into()),
                on: Some(mechanism.body(special.link).name.clone()),
                ..PointResult::default()
            },
        };
        points.insert(special.name.clone(), result);
    }
    points
}
