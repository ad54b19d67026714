//! The part of a turn in which a drive moves a link with a slot, and that in which this rests, as of a Geneva wheel.

use super::Drive;
use super::path::{Event, Happening, Path};
use super::segment::Node;
use crate::construction::Solution;
use crate::mechanism::SliderId;
use crate::words::{Medium, NumberStyle, Wording};

/// The style of its angles: the ends themselves are told with all their digits.
const HUNDREDTHS: NumberStyle = NumberStyle::decimals(2).trimmed();

/// Most halvings of a step in which a slider leaves its guide.
const BISECTIONS: usize = 60;

/// What the place of such an end may be off at least, in turns.
const ROUNDED: f64 = 1e-14;

impl Path<'_> {
    /// A position beyond a guide's end on the way between two nodes: the second one, or one between them where a slider turns back beyond the end.
    pub(super) fn beyond_guides(
        &self,
        last: &Node,
        node: &Node,
        advance: impl Fn(f64) -> Option<Node>,
    ) -> Option<Node> {
        let is_off = |node: &Node| self.off_guide(&node.block).is_some();
        if is_off(node) {
            return Some(node.clone());
        }
        let with_ends = self.mechanism.slider_ids().filter(|id| self.mechanism.slider(*id).travel.is_some());
        with_ends.into_iter().find_map(|id| {
            let speed = |node: &Node| node.block.speeds[id.0][0];
            if speed(last) * speed(node) >= 0.0 {
                return None;
            }
            let (mut low, mut high) = (last.value, node.value);
            for _ in 0..BISECTIONS {
                let between = advance(low + 0.5 * (high - low))?;
                let turned = speed(&between) * speed(last) < 0.0;
                if is_off(&between) {
                    return Some(between);
                }
                let end = if turned { &mut high } else { &mut low };
                if *end == between.value {
                    return None;
                }
                *end = between.value;
            }
            None
        })
    }

    /// The slider that is beyond an end of its guide in a position, by however little.
    fn past_an_end(&self, node: &Node) -> Option<SliderId> {
        let is_past = |id: &SliderId| {
            let (travel, at) = (self.mechanism.slider(*id).travel, node.block.slides[id.0][0]);
            travel.is_some_and(|[low, high]| !(low..=high).contains(&at))
        };
        self.mechanism.slider_ids().find(is_past)
    }

    /// Where a slider leaves its guide between two nodes, of which the first is on all guides, and the last position before, by a step that goes so far
    /// from the first. There may be none between, where the first stands at the end itself.
    pub(super) fn leaving(
        &self,
        last: &Node,
        beyond: Node,
        advance: impl Fn(f64) -> Option<Node>,
    ) -> (Option<Node>, Event) {
        let (mut low, mut high) = (last.value, beyond.value);
        let (mut kept, mut off) = (None, self.past_an_end(&beyond));
        for _ in 0..BISECTIONS {
            let middle = low + 0.5 * (high - low);
            if middle == low || middle == high {
                break;
            }
            let Some(node) = advance(middle) else { break };
            match self.past_an_end(&node) {
                None => (low, kept) = (middle, Some(node)),
                Some(farther) => (high, off) = (middle, Some(farther)),
            }
        }
        let within = (high - low).abs() + ROUNDED * self.unit();
        let what = off.map(|id| {
            let [least, most] = self.mechanism.slider(id).travel.unwrap_or_default();
            let at = kept.as_ref().unwrap_or(last).block.slides[id.0][0];
            let position = if (at - least).abs() < (most - at).abs() { least } else { most };
            Happening::Leaves { slider: self.mechanism.slider_name(id), position }
        });
        let what = what.unwrap_or_else(|| Happening::Singular(String::new()));
        (kept, Event { at: low, within, what })
    }

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
    pub fn told_engagement(&self, words: &Wording, medium: Medium) -> Option<String> {
        let [from, to] = self.engagement().filter(|_| self.drive.is_angle)?;
        let degrees = |x: f64| format!("{}°", words.write(x, HUNDREDTHS.on(medium)));
        let (held, free) = (degrees(to - from), degrees(self.unit() - (to - from)));
        Some(words.language.engaged(&self.drive.quantity, &degrees(from), &degrees(to), &held, &free))
    }
}

/// The part of a turn in which the first drive of a scene moves a link with a slot, in words; `None` without ends of guides, and where they do not
/// hold the motion up at both sides.
#[must_use]
pub fn told_engagement(solution: &Solution, words: &Wording, medium: Medium) -> Option<String> {
    let mechanism = &solution.mechanism;
    mechanism.sliders.iter().find(|slider| slider.travel.is_some())?;
    let drive = Drive::new(mechanism, None).ok()?;
    let mut path = Path::new(mechanism, &solution.pose, drive).ok()?;
    path.once().ok()?;
    path.told_engagement(words, medium)
}
