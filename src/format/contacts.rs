//! Contacts in the result file.

use crate::accuracy::Bounds;
use crate::construction::Solution;
use crate::mechanism::{Contact, Touch};
use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::Serialize;

/// Two profiles that touch.
#[derive(Debug, Serialize, JsonSchema)]
#[non_exhaustive]
pub struct ContactResult {
    /// What moves as they do: the name of a link, or of a slider where the second profile is flat.
    pub equivalent: String,
    /// Whether it does so in this position alone.
    pub here_alone: bool,
    /// Where they touch; left out where no radii say it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<[f64; 2]>,
    /// Bound on the error of both coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position_error: Option<f64>,
    /// The common normal, of length 1: from the first centre of curvature towards the second, or into the flat profile.
    pub normal: [f64; 2],
    /// Bound on the error of both components of `normal`.
    #[schemars(with = "Option<f64>")]
    pub normal_error: f64,
    /// The velocity of the first profile on the second where they touch, positive along the normal turned by +90°.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sliding: Option<f64>,
    /// Bound on the error of `sliding`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sliding_error: Option<f64>,
    /// The angular velocity of the roller, which rolls on the first profile.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roller_omega: Option<f64>,
    /// Bound on the error of `roller_omega`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roller_omega_error: Option<f64>,
}

impl ContactResult {
    /// The contacts of a solution by the links that touch, as `1/3`; of further ones between the same two, `1/3#2`.
    pub(super) fn all(solution: &Solution, bounds: &Bounds<'_>) -> IndexMap<String, ContactResult> {
        let mechanism = &solution.mechanism;
        let mut all: IndexMap<String, ContactResult> = IndexMap::new();
        for contact in &mechanism.contacts {
            let [first, second] = contact.bodies.map(|body| mechanism.body(body).name.as_str());
            let name = format!("{first}/{second}");
            let count = all.keys().filter(|own| own.split('#').next() == Some(&name)).count();
            let name = if count == 0 { name } else { format!("{name}#{}", count + 1) };
            all.insert(name, ContactResult::of(solution, contact, bounds));
        }
        all
    }

    fn of(solution: &Solution, contact: &Contact, bounds: &Bounds<'_>) -> ContactResult {
        let mechanism = &solution.mechanism;
        let known = bounds.contact(contact);
        ContactResult {
            equivalent: match contact.touch {
                Touch::Arcs { link, .. } => mechanism.body(link).name.clone(),
                Touch::Face { slider, .. } => mechanism.slider_name(slider),
            },
            here_alone: !contact.is_circular,
            position: known.point.map(|(place, _)| place),
            position_error: known.point.map(|(_, error)| error),
            normal: known.normal.0,
            normal_error: known.normal.1,
            sliding: known.sliding.map(|(velocity, _)| velocity),
            sliding_error: known.sliding.map(|(_, error)| error),
            roller_omega: known.roller.map(|(omega, _)| omega),
            roller_omega_error: known.roller.map(|(_, error)| error),
        }
    }
}
