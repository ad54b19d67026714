//! The part of a turn in which a drive moves a link with a slot, and that in which this rests, as of a Geneva wheel.

use super::Drive;
use super::path::{Happening, Path};
use crate::construction::Solution;
use crate::words::{NumberStyle, Wording};

/// The style of its angles: the ends themselves are told with all their digits.
const HUNDREDTHS: NumberStyle = NumberStyle::decimals(2).trimmed();

impl Path<'_> {
    /// From where to where the drive moves what has the slot: between both ends of its travel. `None` where the path has other ends or none, or
    /// has not been followed to them.
    #[must_use]
    pub fn engagement(&self) -> Option<[f64; 2]> {
        let leaves = |above: bool| {
            let end = self.end(above)?;
            matches!(end.what, Happening::Leaves { .. }).then_some(end.at)
        };
        Some([leaves(false)?, leaves(true)?])
    }

    /// The same in words, for a drive that turns.
    #[must_use]
    pub fn told_engagement(&self, words: &Wording) -> Option<String> {
        let [from, to] = self.engagement().filter(|_| self.drive.is_angle)?;
        let degrees = |x: f64| format!("{}°", words.write(x, HUNDREDTHS));
        let (held, free) = (degrees(to - from), degrees(self.unit() - (to - from)));
        Some(words.language.engaged(&self.drive.quantity, &degrees(from), &degrees(to), &held, &free))
    }
}

/// The part of a turn in which the first drive of a scene moves a link with a slot, in words; `None` without ends of guides, and where they do not
/// hold the motion up at both sides.
#[must_use]
pub fn told_engagement(solution: &Solution, words: &Wording) -> Option<String> {
    let mechanism = &solution.mechanism;
    mechanism.sliders.iter().find(|slider| slider.travel.is_some())?;
    let drive = Drive::new(mechanism, None).ok()?;
    let mut path = Path::new(mechanism, &solution.pose, drive).ok()?;
    path.once().ok()?;
    path.told_engagement(words)
}
