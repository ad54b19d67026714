use super::{Scene, SceneError};

/// How large a scene may be for what is done with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SizeLimit {
    links: usize,
    points: usize,
    what: &'static str,
}

impl SizeLimit {
    /// For numbers: no more than a scene may have.
    pub const NUMBERS: SizeLimit = SizeLimit { links: usize::MAX, points: usize::MAX, what: "a scene" };
    /// For a figure, which takes three seconds then.
    pub const FIGURE: SizeLimit = SizeLimit { links: 3_000, points: 10_000, what: "a figure" };
    /// For steps, whose sheets grow as the square of the links.
    pub const STEPS: SizeLimit = SizeLimit { links: 150, points: 1_000, what: "a figure with steps" };
    /// For what is drawn by hand: errors of all lines go through to all later ones.
    pub const HAND: SizeLimit = SizeLimit { links: 1_000, points: 2_000, what: "a construction by hand" };

    /// Refuses a scene that is larger.
    ///
    /// # Errors
    /// What there is too much of, and how much there may be.
    pub fn check(self, scene: &Scene) -> Result<(), SceneError> {
        scene.check_size(self.links, self.points, self.what)
    }
}
