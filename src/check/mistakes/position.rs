//! The whole mechanism drawn in a wrong position.

use super::candidate::Candidate;
use super::site::Site;
use super::told::{Blank, tell};
use crate::check::model::Edit;
use crate::construction::{Along, OperationKind, OperationRole, Reference};
use crate::mechanism::{BodyId, Role};
use crate::position::{Pose, pose};

/// The whole drawing made in another assembly mode.
pub(super) fn other_mode(site: &Site<'_>) -> Vec<Candidate> {
    (1..=site.other_modes).map(|mode| Candidate { mode, ..Candidate::at(tell::other_mode(), 0) }).collect()
}

/// A crank drawn at another angle than the given one, in degrees from +x, as a protractor is commonly misread: from its
/// other end, clockwise, from the vertical, by one of its long marks.
fn misread(angle: f64) -> Vec<f64> {
    let all = [180.0 - angle, -angle, 90.0 - angle, angle + 10.0, angle - 10.0, angle + 20.0, angle - 20.0];
    // From −180° to 180°.
    let within = |degrees: f64| degrees - 360.0 * libm::round(degrees / 360.0);
    let apart = |a: f64, b: f64| within(a - b).abs() > 1.0;
    let mut found: Vec<f64> = Vec::new();
    for wrong in all.map(within) {
        if apart(wrong, angle) && found.iter().all(|&other| apart(wrong, other)) {
            found.push(wrong);
        }
    }
    found
}

/// The mechanism drawn with a crank at a wrong angle.
pub(super) fn crank_angle(site: &Site<'_>) -> Vec<Candidate> {
    let solution = site.key.solution;
    // Groups without a construction take long to assemble and are not drawn.
    if solution.construction.agreement.iter().any(Option::is_none) || solution.mechanism.placing.is_some() {
        return Vec::new();
    }
    let mut found = Vec::new();
    for crank in 0..solution.mechanism.bodies.len() {
        let Role::Driver { angle: Some(right), .. } = solution.mechanism.body(BodyId(crank)).role else { continue };
        for wrong in misread(right) {
            let mut mechanism = solution.mechanism.clone();
            if let Role::Driver { angle, .. } = &mut mechanism.bodies[crank].role {
                *angle = Some(wrong);
            }
            let Ok(pose) = pose(&mechanism, &solution.scene.near) else { continue };
            let link = solution.mechanism.body(BodyId(crank)).name.as_str().into();
            let [was, is] = [wrong, right].map(|angle| Blank::Number(format!("{angle:.0}")));
            let told = tell::crank_angle(link, was, is);
            found.push(Candidate { edits: in_pose(site, &pose), ..Candidate::at(told, 0) });
        }
    }
    found
}

/// The joints plotted, and the guides drawn, in another pose.
fn in_pose(site: &Site<'_>, pose: &Pose) -> Vec<(usize, Edit)> {
    let origin = site.model.construction.origin;
    let plotted = site.operations().filter_map(|(index, operation)| {
        let kind = match (operation.role, &operation.kind) {
            (OperationRole::Joint(point), &OperationKind::Plot { place, .. }) => {
                OperationKind::Plot { place, at: pose.point(point) - origin }
            }
            (OperationRole::Guide(slider), &OperationKind::Draw { line, through, along }) => match along.reference {
                Reference::Given(_) => {
                    let given = Along::given(pose.guide(slider));
                    OperationKind::Draw { line, through, along: Along { quarter_turns: along.quarter_turns, ..given } }
                }
                _ => return None,
            },
            _ => return None,
        };
        Some((index, Edit::Instead(kind)))
    });
    plotted.collect()
}
