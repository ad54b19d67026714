//! What is said of a scene: why it is no mechanism, and which of its angles are probably meant in radians.

use super::{BodyId, Mechanism};
use crate::Problem;
use crate::scene::{Along, Scene, SceneError};
use std::f64::consts::{PI, TAU};

/// Why a scene is no mechanism, or one that cannot be solved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StructureError {
    /// The scene contradicts itself, or has too few or too many constraints or drives.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A group whose prismatic joints leave it without a definite motion in every position.
    #[error("{}", self.problem())]
    Singular {
        /// Names of the group's links.
        links: String,
        /// Its class.
        class: &'static str,
        /// Its joints in the order of [`Group::pattern`](super::Group::pattern), R revolute, P prismatic.
        pattern: String,
    },
}

impl StructureError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            StructureError::Scene(error) => error.problem(),
            StructureError::Singular { links, class, pattern } => Problem::new(format!(
                "links {links} have no definite motion in any position: a group of class {class} with its prismatic joints as in {pattern} \
                 is singular by its structure"
            ))
            .hint("make one of the prismatic joints revolute"),
        }
    }

    /// Links with `missing` free motions too many (`under`) and links with `surplus` constraints too many (`over`).
    pub(super) fn misfit(
        scene: &Scene,
        mechanism: &Mechanism,
        under: &[BodyId],
        missing: usize,
        over: &[BodyId],
        surplus: usize,
    ) -> Self {
        let names = |links: &[BodyId]| {
            let names = links.iter().map(|&b| mechanism.body(b).name.as_str());
            let noun = if links.len() == 1 { "link" } else { "links" };
            format!("{noun} {}", names.collect::<Vec<_>>().join(", "))
        };
        let many = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
        let mut parts = Vec::new();
        let mut hints = Vec::new();
        if !under.is_empty() {
            let free = many(missing, "free motion");
            parts.push(format!("{} can still move ({free} left)", names(under)));
            hints.push(format!("add {} or a joint there", many(missing, "drive")));
        }
        if !over.is_empty() {
            let surplus = many(surplus, "constraint");
            parts.push(format!("{} cannot move as driven ({surplus} too many)", names(over)));
            hints.push("take a drive or a joint away there".to_owned());
        }
        parts.extend(mobility(scene, missing, surplus));
        let hint = Some(hints.join("; "));
        scene.error_at(&["links"], parts.join("; "), hint).into()
    }
}

/// The mobility of the joined links without drives, by the count of Grübler, beside the number of drives; `None` where motions are given otherwise than by
/// drives.
fn mobility(scene: &Scene, missing: usize, surplus: usize) -> Option<String> {
    if !scene.known.is_empty() || scene.links.values().any(|link| link.motion.is_some()) {
        return None;
    }
    let turning = scene.links.values().filter(|link| link.drive.is_some()).count();
    let drives = turning + scene.sliders.iter().filter(|slider| slider.drive.is_some()).count();
    let links = scene.links.len();
    // The freedoms of the links that are joined but not driven: as many as drives, and those missing, less surplus constraints.
    let mobility = (drives + missing) as i64 - surplus as i64;
    let constraints = 3 * links as i64 - mobility;
    let drives = if drives == 1 { "1 drive".to_owned() } else { format!("{drives} drives") };
    Some(format!("mobility 3·{links} − {constraints} = {mobility} with {drives}"))
}

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
