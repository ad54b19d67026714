//! Forces in the result file.

use crate::accuracy::Bounds;
use crate::construction::Solution;
use crate::forces::{Forces, Source, rubbed_joints};
use crate::geometry::{Ball, Pair};
use crate::mechanism::{BodyId, JointId, PointId};
use indexmap::IndexMap;
use serde::Serialize;

/// What joints carry and what drives need, in the scene's unit of force; moments in force · length, counter-clockwise positive.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ForcesResult {
    /// By pin, then by link or `ground`: the force that it receives there from all others; those of a pin add up to zero.
    pub reactions: IndexMap<String, IndexMap<String, ForceResult>>,
    /// By slider: what its sliding link receives from the guide.
    pub sliders: IndexMap<String, GuideForceResult>,
    /// By pair of wheels, as `1/2`, or of a wheel and its rack: what the first of the two receives from the other one's teeth. Left out without
    /// such pairs.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub meshes: IndexMap<String, MeshForceResult>,
    /// By drive: what it needs.
    pub drives: IndexMap<String, DriveResult>,
    /// By link: its inertia, where it has a mass.
    pub inertia: IndexMap<String, InertiaResult>,
    /// What the links and springs do to the frame: the shaking force, and the moment about the frame's first point.
    pub frame: FrameResult,
    /// The largest difference between the two routes to the drives' torques, equilibrium of the links and virtual power, in parts of the
    /// largest power of a load.
    pub disagreement: f64,
    /// The difference that rounding allows.
    pub disagreement_allowed: f64,
}

/// A force.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct ForceResult {
    /// Its components.
    pub force: [f64; 2],
    /// Bound on the error of both components.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub force_error: f64,
    /// The couple of friction that it receives beside; left out at a pin without friction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
    /// Bound on the error of `friction`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_error: Option<f64>,
}

/// What a sliding link receives from its guide.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct GuideForceResult {
    /// The force across the guide, along its direction turned by +90°.
    pub normal: f64,
    /// Bound on the error of `normal`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub normal_error: f64,
    /// The couple, about the slider's point.
    pub couple: f64,
    /// Bound on the error of `couple`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub couple_error: f64,
    /// How far from the slider's point along the guide the line of the force runs; left out where there is no force across the guide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub offset: Option<f64>,
    /// Bound on the error of `offset`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub offset_error: Option<f64>,
    /// The friction along the guide, in its direction; left out of a guide without friction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
    /// Bound on the error of `friction`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_error: Option<f64>,
}

/// What a wheel receives from the teeth of another one, at the pitch point.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct MeshForceResult {
    /// The pitch point.
    pub pitch_point: [f64; 2],
    /// The force along the tangent: along the direction from the first wheel's centre to the second's, or from the wheel's centre to its rack,
    /// turned by +90°.
    pub tangential: f64,
    /// Bound on the error of `tangential`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub tangential_error: f64,
    /// The whole force, with the part by which teeth push each other apart.
    pub force: [f64; 2],
    /// Bound on the error of both components of `force`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub force_error: f64,
}

/// What a drive needs.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct DriveResult {
    /// The torque on the link that it turns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque: Option<f64>,
    /// The force along the guide on the sliding link that it pushes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// Bound on the error of the torque or force.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub error: f64,
    /// By load: its power while this drive runs at rate 1 and the others stand. The torque or force is the negative sum.
    pub powers: IndexMap<String, f64>,
}

/// The inertia of a link.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct InertiaResult {
    /// Where the centre of mass is.
    pub center: [f64; 2],
    /// The acceleration of the centre of mass.
    pub acceleration: [f64; 2],
    /// The inertia force, −m a.
    pub force: [f64; 2],
    /// Bound on the error of both components of `force`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub force_error: f64,
    /// The inertia couple, −J α.
    pub couple: f64,
    /// Bound on the error of `couple`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub couple_error: f64,
}

/// What the links do to the frame.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct FrameResult {
    /// The force.
    pub force: [f64; 2],
    /// Bound on the error of both components.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub force_error: f64,
    /// The moment about the frame's first point.
    pub moment: f64,
    /// Bound on the error of `moment`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub moment_error: f64,
}

impl ForcesResult {
    pub(super) fn new(solution: &Solution, forces: &Forces, bounds: &Bounds<'_>) -> ForcesResult {
        let Solution { mechanism, .. } = solution;
        let agreement = forces.agreement();
        let rubbed = rubbed_joints(mechanism);
        ForcesResult {
            reactions: reactions(solution, forces, bounds, &rubbed),
            sliders: mechanism
                .slider_ids()
                .map(|id| {
                    let guide = Pair::within(solution.pose.guide(id), 0.0);
                    let normal = forces.normal(mechanism, id, guide);
                    let couple = forces.couple(mechanism, id);
                    let offset = couple / normal;
                    let is_there = offset.is_known() && normal.smallest() > 0.0;
                    let friction = rubbed.contains(&mechanism.slider_joint(id));
                    let friction = friction.then(|| forces.friction_along(mechanism, id, guide).high);
                    let result = GuideForceResult {
                        friction,
                        friction_error: friction.map(|friction| {
                            bounds.of_force(friction, |f, guide| Some(f.friction_along(mechanism, id, guide(id))))
                        }),
                        normal: normal.high,
                        normal_error: bounds.of_force(normal.high, |f, guide| Some(f.normal(mechanism, id, guide(id)))),
                        couple: couple.high,
                        couple_error: bounds.of_force(couple.high, |f, _| Some(f.couple(mechanism, id))),
                        offset: is_there.then_some(offset.high),
                        offset_error: is_there.then(|| {
                            bounds.of_force(offset.high, |f, guide| {
                                Some(f.couple(mechanism, id) / f.normal(mechanism, id, guide(id)))
                            })
                        }),
                    };
                    (mechanism.slider_name(id), result)
                })
                .collect(),
            meshes: meshes(solution, forces, bounds),
            drives: drives(solution, forces, bounds),
            inertia: inertia(solution, forces, bounds),
            frame: FrameResult {
                force: forces.frame.force.rounded().into(),
                force_error: bounds.of_force_vector(forces.frame.force.rounded(), |f| Some(f.frame.force)),
                moment: forces.frame.moment.high,
                moment_error: bounds.of_force(forces.frame.moment.high, |f, _| Some(f.frame.moment)),
            },
            disagreement: agreement.difference,
            disagreement_allowed: agreement.allowed,
        }
    }
}

fn reactions(
    solution: &Solution,
    forces: &Forces,
    bounds: &Bounds<'_>,
    rubbed: &[JointId],
) -> IndexMap<String, IndexMap<String, ForceResult>> {
    let mechanism = &solution.mechanism;
    let at = |pin: PointId| {
        let has_friction = rubbed.iter().any(|joint| mechanism.joint(*joint).pin == Some(pin));
        let on = |body: BodyId| {
            let force = forces.at_pin(mechanism, pin, body)?.rounded();
            let read = |f: &Forces| f.at_pin(mechanism, pin, body);
            let friction = has_friction.then(|| forces.friction_at_pin(mechanism, pin, body).high);
            let result = ForceResult {
                force: force.into(),
                force_error: bounds.of_force_vector(force, read),
                friction,
                friction_error: friction
                    .map(|friction| bounds.of_force(friction, |f, _| Some(f.friction_at_pin(mechanism, pin, body)))),
            };
            Some((mechanism.body(body).name.clone(), result))
        };
        let bodies = mechanism.body_ids().filter(|&body| !mechanism.body(body).is_nameless());
        let all: IndexMap<String, ForceResult> = bodies.filter_map(on).collect();
        (!all.is_empty()).then(|| (mechanism.point_name(pin).to_owned(), all))
    };
    mechanism.point_ids().filter_map(at).collect()
}

fn meshes(solution: &Solution, forces: &Forces, bounds: &Bounds<'_>) -> IndexMap<String, MeshForceResult> {
    let Solution { mechanism, pose, .. } = solution;
    let of = |id: JointId| {
        let joint = mechanism.joint(id);
        let rolling = joint.rolling()?;
        let at = rolling.point(|point| pose.point(point).coords.into(), |slider| pose.guide(slider).into(), |x: f64| x);
        let (tangential, force) = (forces.tangential(id), forces.tooth_force(id).rounded());
        let names = joint.bodies.map(|body| mechanism.body(body).name.as_str());
        let result = MeshForceResult {
            pitch_point: [at.x, at.y],
            tangential: tangential.high,
            tangential_error: bounds.of_force(tangential.high, |f, _| Some(f.tangential(id))),
            force: force.into(),
            force_error: bounds.of_force_vector(force, |f| Some(f.tooth_force(id))),
        };
        Some((names.join("/"), result))
    };
    mechanism.joint_ids().filter_map(of).collect()
}

fn drives(solution: &Solution, forces: &Forces, bounds: &Bounds<'_>) -> IndexMap<String, DriveResult> {
    let names = solution.mechanism.drive_names();
    let drive = |(index, (name, drive)): (usize, (String, &crate::forces::Drive))| {
        let effort = drive.effort.high;
        let powers = forces.acting.iter().zip(&drive.powers);
        let mut by_name = IndexMap::new();
        for (load, power) in powers.filter(|(load, _)| load.body != crate::mechanism::GROUND) {
            // Friction from several links at one pin has one name on the link in which the pin is fixed.
            *by_name.entry(load.source.name(&solution.mechanism, load.body)).or_insert(0.0) += power.high;
        }
        let result = DriveResult {
            torque: drive.body.map(|_| effort),
            force: drive.slider.map(|_| effort),
            error: bounds.of_force(effort, |f, _| f.drives.get(index).map(|drive| drive.effort)),
            powers: by_name,
        };
        (name, result)
    };
    names.into_iter().zip(&forces.drives).enumerate().map(drive).collect()
}

fn inertia(solution: &Solution, forces: &Forces, bounds: &Bounds<'_>) -> IndexMap<String, InertiaResult> {
    let of = |body: BodyId| {
        let load = forces.load(Source::Inertia, body)?;
        let read = move |f: &Forces| f.load(Source::Inertia, body).map(|load| load.force);
        let (at, force) = (load.at.rounded(), load.force.rounded());
        let acceleration = solution.motion.body(body).acceleration_at(crate::geometry::Point::from(at));
        let couple: Ball = load.couple;
        let result = InertiaResult {
            center: at.into(),
            acceleration: acceleration.into(),
            force: force.into(),
            force_error: bounds.of_force_vector(force, read),
            couple: couple.high,
            couple_error: bounds.of_force(couple.high, |f, _| f.load(Source::Inertia, body).map(|load| load.couple)),
        };
        Some((solution.mechanism.body(body).name.clone(), result))
    };
    solution.mechanism.body_ids().filter_map(of).collect()
}
