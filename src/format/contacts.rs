//! Contacts in the result file.

use crate::accuracy::Bounds;
use crate::construction::Solution;
use crate::forces::Forces;
use crate::geometry::{Ball, Number, Pair};
use crate::mechanism::{Contact, Touch};
use indexmap::IndexMap;
use serde::Serialize;

/// Two profiles that touch.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
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
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
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
    /// The force with which the profiles press on each other along the normal, in the scene's unit of force; negative where they would have to pull. Only
    /// of a scene with loads.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// Bound on the error of `force`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force_error: Option<f64>,
}

impl ContactResult {
    /// The contacts of a solution by the links that touch, as `1/3`; of further ones between the same two, `1/3#2`.
    pub(super) fn all(
        solution: &Solution,
        forces: Option<&Forces>,
        bounds: &Bounds<'_>,
    ) -> IndexMap<String, ContactResult> {
        let mechanism = &solution.mechanism;
        let mut all: IndexMap<String, ContactResult> = IndexMap::new();
        for contact in &mechanism.contacts {
            let [first, second] = contact.bodies.map(|body| mechanism.body(body).name.as_str());
            let name = format!("{first}/{second}");
            let count = all.keys().filter(|own| own.split('#').next() == Some(&name)).count();
            let name = if count == 0 { name } else { format!("{name}#{}", count + 1) };
            all.insert(name, ContactResult::of(solution, contact, forces, bounds));
        }
        all
    }

    /// Whether the profiles would have to pull at each other, beyond doubt.
    pub(super) fn pulls(&self) -> bool {
        self.force.zip(self.force_error).is_some_and(|(force, error)| force < -error)
    }

    fn of(solution: &Solution, contact: &Contact, forces: Option<&Forces>, bounds: &Bounds<'_>) -> ContactResult {
        let mechanism = &solution.mechanism;
        let known = bounds.contact(contact);
        let force = forces.and_then(|forces| pressing(solution, contact, forces, bounds));
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
            force: force.map(|(force, _)| force),
            force_error: force.map(|(_, error)| error),
        }
    }
}

/// The force with which profiles press on each other, and the bound of its error: that of the equivalent link, which has no other than along
/// itself, or of the pin on a flat profile.
fn pressing(solution: &Solution, contact: &Contact, forces: &Forces, bounds: &Bounds<'_>) -> Option<(f64, f64)> {
    let Solution { mechanism, pose, .. } = solution;
    match contact.touch {
        Touch::Arcs { link, centers: [from, to], radii } => {
            // What the link receives at the second centre, from where it pushes the first profile back.
            let force = forces.at_pin(mechanism, to, link)?.rounded();
            let backwards = -pose.arm(from, to).dot(&force);
            let inside = radii.is_some_and(|[first, second]| first + second < 0.0);
            let sense = if (backwards < 0.0) == inside { 1.0 } else { -1.0 };
            let size = |force: Pair<Ball>| force.dot(force).sqrt().signed(sense);
            let value = sense * force.norm();
            Some((value, bounds.of_force(value, |f, _| Some(size(f.at_pin(mechanism, to, link)?)))))
        }
        Touch::Face { slider, .. } => {
            let value = -forces.normal(mechanism, slider, Pair::within(pose.guide(slider), 0.0)).high;
            Some((value, bounds.of_force(value, |f, guide| Some(-f.normal(mechanism, slider, guide(slider))))))
        }
    }
}
