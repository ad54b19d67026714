use crate::construction::Solution;
use crate::geometry::{degrees_of, span};
use crate::mechanism::{Mechanism, Role};
use crate::position::{AssemblyError, Pose, first_poses};
use crate::words::Wording;

/// Difference of angles in degrees, or of slides in sizes of the mechanism, that counts as none.
const STANDS: f64 = 1e-9;

/// The other ways to assemble a mechanism, with its drives where they stand.
#[derive(Clone, Debug, Default)]
pub struct OtherModes {
    /// The first of them, each with its number among all modes from 1, the mechanism's own among them.
    pub shown: Vec<(usize, Pose)>,
    /// Whether there are more.
    pub has_more: bool,
    /// The number of the own mode, if it is among the first.
    pub own: Option<usize>,
}

impl OtherModes {
    /// Most modes that are shown: more cannot be told apart on a sheet.
    pub const MOST: usize = 12;

    /// The other modes of a mechanism that may have been moved from its scene's own position. A drawn configuration has
    /// none.
    ///
    /// # Errors
    /// The mechanism cannot be assembled, or only with too much work.
    pub fn of(solution: &Solution) -> Result<Self, AssemblyError> {
        let standing = standing(&solution.mechanism, &solution.pose);
        let mechanism = standing.as_ref().unwrap_or(&solution.mechanism);
        let poses = first_poses(mechanism, &solution.scene.near, Self::MOST + 2)?;
        let own = poses.iter().position(|pose| pose.is_same_as(&solution.pose)).map(|index| index + 1);
        let others = (1..).zip(poses).filter(|(number, _)| Some(*number) != own);
        let mut shown: Vec<(usize, Pose)> = others.collect();
        let has_more = shown.len() > Self::MOST;
        shown.truncate(Self::MOST);
        Ok(Self { shown, has_more, own })
    }

    /// That not all of them are drawn, in the figure's language; none where all are.
    #[must_use]
    pub fn note(&self, words: &Wording) -> Option<String> {
        self.has_more.then(|| words.language.modes_left_out(&self.shown.len().to_string()))
    }

    /// By mode: the point that is farthest from those of all other modes and of the own position, where its number can
    /// stand.
    #[must_use]
    pub fn apart(&self, own: &Pose) -> Vec<usize> {
        let poses = || self.shown.iter().map(|(_, pose)| pose);
        let farthest = |(index, pose): (usize, &Pose)| {
            let others = || poses().enumerate().filter(move |(other, _)| *other != index).map(|(_, pose)| pose);
            let distance = |point: &usize| {
                let all = others().chain(std::iter::once(own)).flat_map(|other| &other.points);
                all.map(|place| (place - pose.points[*point]).norm_squared()).fold(f64::INFINITY, f64::min)
            };
            (0..pose.points.len()).max_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or_default()
        };
        poses().enumerate().map(farthest).collect()
    }
}

/// The mechanism with its drives as they stand in a pose; `None` where that is as the scene gives them.
fn standing(mechanism: &Mechanism, pose: &Pose) -> Option<Mechanism> {
    let size = span(pose.points.iter().copied());
    let mut moved = Mechanism { placing: None, ..mechanism.clone() };
    let mut is_moved = false;
    for (body, axis) in moved.bodies.iter_mut().zip(&pose.axes) {
        if let (Role::Driver { angle, .. }, Some(axis)) = (&mut body.role, axis) {
            let now = degrees_of(*axis);
            is_moved |= angle.is_some_and(|given| libm::remainder(given - now, 360.0).abs() > STANDS);
            *angle = Some(now);
        }
    }
    for (slider, slide) in moved.sliders.iter_mut().zip(&pose.slides) {
        if let (Some(drive), Some(now)) = (&mut slider.drive, slide) {
            is_moved |= drive.position.is_some_and(|given| (given - now).abs() > STANDS * size);
            drive.position = Some(*now);
        }
    }
    if let Some(placing) = &mechanism.placing {
        let now = pose.axes[placing.link.0].map(degrees_of);
        is_moved |= now.is_some_and(|now| libm::remainder(placing.angle - now, 360.0).abs() > 1e3 * STANDS);
    }
    is_moved.then_some(moved)
}
