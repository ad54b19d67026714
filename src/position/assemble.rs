use super::closing::places;
use super::drawn::drawn_pose;
use super::frames::{Frames, driven_position};
use super::modes::{NoMode, modes};
use super::rough::Rough;
use super::{Assembly, AssemblyError, Pose};
use crate::geometry::{Vector, span};
use crate::mechanism::{BodyId, Class, Mechanism, Role, SliderId};
use crate::scene::{GivenBy, Near};

/// Most assemblies of a whole mechanism that are listed; of more, those nearest to the rough places are kept.
const MOST_WAYS: usize = 4096;

/// Lengths must lie between the inverse of this and this: closing a loop takes their fourth powers.
const LARGEST: f64 = 1e70;

/// The pose of a mechanism: as drawn, or assembled from its lengths in the way nearest to `near`.
///
/// Nearest is the least sum of squared distances from all rough places together; without any the first assembly is
/// taken.
pub fn pose(mechanism: &Mechanism, near: &Near) -> Result<Pose, AssemblyError> {
    if mechanism.given_by == GivenBy::Drawing {
        return Ok(drawn_pose(mechanism));
    }
    let rough = Rough::new(mechanism.for_positions(), near);
    let mut ways = ways(mechanism, &rough)?;
    let (chosen, remark) = rough.choose(mechanism.for_positions(), &ways);
    let mut pose = ways.swap_remove(chosen).pose(mechanism);
    pose.warnings.extend(remark);
    Ok(pose)
}

/// Every real assembly of a mechanism from its lengths; of a drawn configuration its one pose.
///
/// The modes of a group are numbered by the angle of its first rotating link, counter-clockwise from +x; the
/// mechanism's assemblies by the modes of its groups, of which the first group's is the most significant. Where a
/// link's angle is given in place of a drive's, the groups are those of [`Placing`](crate::mechanism::Placing), and
/// each group of the pose has the number of the mechanism's assembly.
///
/// A slotted lever with one point coincides with itself turned by 180° and counts once, with its slider on the positive
/// side of the guide's `through`; both orientations are listed where `near` gives its angle.
pub fn poses(mechanism: &Mechanism, near: &Near) -> Result<Vec<Pose>, AssemblyError> {
    if mechanism.given_by == GivenBy::Drawing {
        return Ok(vec![drawn_pose(mechanism)]);
    }
    let ways = ways(mechanism, &Rough::new(mechanism.for_positions(), near))?;
    Ok(ways.into_iter().map(|way| way.pose(mechanism)).collect())
}

/// An assembly of the whole mechanism, or of its first groups.
#[derive(Clone)]
pub(super) struct Way {
    pub frames: Frames,
    slides: Vec<f64>,
    /// By group: the number of its assembly mode.
    assemblies: Vec<Assembly>,
}

impl Way {
    /// The pose of `mechanism`. It may have fewer bodies and sliders than its [`Mechanism::for_positions`], to which
    /// this assembly belongs.
    fn pose(self, mechanism: &Mechanism) -> Pose {
        let (points, guides) = places(mechanism, &self.frames);
        let named = |id: usize| !matches!(mechanism.bodies[id].role, Role::Ground | Role::Carrier { .. });
        let axes = (0..mechanism.bodies.len()).map(|id| {
            let frame = self.frames.of(BodyId(id)).filter(|_| named(id))?;
            Some(frame.rotation * Vector::x())
        });
        Pose {
            axes: axes.collect(),
            points,
            guides,
            slides: self.slides[..mechanism.sliders.len()].iter().copied().map(Some).collect(),
            assemblies: self.assemblies.into_iter().map(Some).collect(),
            warnings: search_warnings(mechanism.for_positions()).collect(),
        }
    }
}

/// Warnings for groups whose assembly modes come from a search, not from a polynomial. A group without a loop has one
/// mode.
fn search_warnings(mechanism: &Mechanism) -> impl Iterator<Item = String> {
    let groups = mechanism.groups.iter();
    let higher = groups.filter(|group| group.class == Class::Higher && !group.loops.is_empty());
    higher.map(|group| {
        format!(
            "links {} form a group of higher class: its assembly modes were found by a search, and there may be more",
            group.link_names(mechanism)
        )
    })
}

/// All assemblies, group after group. Of more than [`MOST_WAYS`] those nearest to the rough places are kept after each
/// group.
fn ways(mechanism: &Mechanism, rough: &Rough) -> Result<Vec<Way>, AssemblyError> {
    let bodies = mechanism.bodies.iter();
    let spans = bodies.map(|b| span(b.local.iter().copied()));
    let size = spans.fold(0.0, f64::max);
    let way = if size > LARGEST { "large" } else { "small" };
    if size != 0.0 && !(1.0 / LARGEST..=LARGEST).contains(&size) {
        return Err(AssemblyError::Size { size, way });
    }
    let whole = mechanism;
    let mechanism = whole.for_positions();
    let mut ways = vec![Way {
        frames: Frames::known(mechanism),
        slides: mechanism.sliders.iter().map(driven_position).collect(),
        assemblies: Vec::new(),
    }];
    for (index, group) in mechanism.groups.iter().enumerate() {
        let mut extended: Vec<Way> = Vec::new();
        let mut failure = None;
        for way in &ways {
            match modes(mechanism, index, &way.frames, &way.slides, rough) {
                Ok(found) => {
                    let modes = found.len();
                    extended.extend(found.into_iter().enumerate().map(|(index, assembled)| {
                        let mut assemblies = way.assemblies.clone();
                        let mode = index + 1;
                        assemblies.push(Assembly { mode, modes });
                        Way { frames: assembled.frames, slides: assembled.slides, assemblies }
                    }));
                }
                Err(no_mode) => failure = failure.or(Some(no_mode)),
            }
        }
        if let (true, Some(failure)) = (extended.is_empty(), failure) {
            let (links, at) = (group.link_names(mechanism), given_angles(whole));
            return Err(match failure {
                NoMode::Apart(miss) => AssemblyError::NoMode { links, at, miss },
                NoMode::NotFound(tried) => AssemblyError::NotFound { links, at, tried },
            });
        }
        ways = closest(mechanism, rough, extended);
    }
    if whole.placing.is_some() {
        let modes = ways.len();
        for (index, way) in ways.iter_mut().enumerate() {
            let mode = index + 1;
            way.assemblies = vec![Assembly { mode, modes }; whole.groups.len()];
        }
    }
    Ok(ways)
}

/// At most [`MOST_WAYS`] assemblies, those nearest to the rough places, in their order.
fn closest(mechanism: &Mechanism, rough: &Rough, ways: Vec<Way>) -> Vec<Way> {
    if ways.len() <= MOST_WAYS {
        return ways;
    }
    let distances = ways.iter().map(|way| rough.distance(mechanism, way));
    let mut ranked: Vec<(f64, usize)> = distances.zip(0..).collect();
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut kept = vec![false; ways.len()];
    for (_, index) in ranked.iter().take(MOST_WAYS) {
        kept[*index] = true;
    }
    let kept = ways.into_iter().zip(kept).filter(|(_, kept)| *kept);
    kept.map(|(way, _)| way).collect()
}

/// The given drive angles and positions in words, as in ` at angle(1) = 70°`.
fn given_angles(mechanism: &Mechanism) -> String {
    let turned = mechanism.bodies.iter().filter_map(|b| match b.role {
        Role::Driver { angle: Some(angle), .. } => Some(format!(" at angle({}) = {angle}°", b.name)),
        _ => None,
    });
    let pushed = (0..mechanism.sliders.len()).map(SliderId).filter_map(|id| {
        let position = mechanism.slider(id).drive?.position?;
        let name = mechanism.push_name(id);
        Some(format!(" at position({name}) = {position}"))
    });
    let placed = mechanism.placing.iter().map(|placing| {
        let name = &mechanism.body(placing.link).name;
        format!(" at angle({name}) = {}°", placing.angle)
    });
    turned.chain(pushed).chain(placed).collect::<Vec<_>>().join(",")
}
