//! Joints. A joint says what it holds, places or rotations or both: every later stage asks for that, and none for its kind.
//!
//! To add a kind of joint: a file here like `slider`, with all that makes it one, and its line in [`add_given`]. Its reader is a file beside `scene/slider.rs`,
//! with a line in `scene/read.rs`.

mod pin;
mod slider;
mod tie;

pub use slider::{Guide, Slider};
pub use tie::Tie;

pub(super) use pin::add_pins;

use super::{BodyId, JointId, Mechanism, PointId, SliderId};
use crate::geometry::Point;
use crate::scene::Scene;
use smallvec::SmallVec;

/// A joint between two bodies.
///
/// A pin holds a point of both in one place. A slider holds a point on a line, and its tie keeps the angle between the two.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The letter of its kind in patterns: R revolute, P prismatic.
    pub letter: char,
    /// The bodies that it joins; of a slider: guide body, then sliding link.
    pub bodies: [BodyId; 2],
    /// The point that both bodies have in one place, where it holds one so.
    pub pin: Option<PointId>,
    /// The slider whose point it holds on a guide, where it does that.
    pub slider: Option<SliderId>,
    /// How it ties rotations, where it does.
    pub tie: Option<Tie>,
    /// How it is drawn.
    pub marks: SmallVec<[Mark; 2]>,
}

/// A mark by which a joint is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A circle to scale, but at least as large as that of a pin.
    Circle {
        /// The point about which it is.
        center: PointId,
        /// A point to which its radius is compared.
        towards: PointId,
        /// The radius as a part of the distance of the two.
        part: f64,
    },
    /// A block on the guide of a slider.
    Block(SliderId),
}

impl Joint {
    /// How many of the free motions between its bodies it takes away.
    #[must_use]
    pub fn constraints(&self) -> usize {
        2 * usize::from(self.pin.is_some()) + usize::from(self.slider.is_some()) + usize::from(self.tie.is_some())
    }

    /// Whether it holds places, so that where one of its bodies is says something of where the other is; loops run over such joints.
    #[must_use]
    pub fn holds_places(&self) -> bool {
        self.pin.is_some() || self.slider.is_some()
    }
}

impl Mechanism {
    /// The joint of that index.
    #[must_use]
    pub fn joint(&self, id: JointId) -> &Joint {
        &self.joints[id.0]
    }

    /// The point where a joint is: the pin, or the slider's point on the guide.
    ///
    /// # Panics
    /// When the joint does not hold places, as every joint of a loop does.
    #[must_use]
    pub fn joint_point(&self, id: JointId) -> PointId {
        let joint = self.joint(id);
        let sliding = || joint.slider.map(|slider| self.slider(slider).at);
        joint.pin.or_else(sliding).expect("a joint of a loop holds places")
    }

    /// Where a joint is on one of its bodies, in that body's frame: at the pin; on a guide at the place from which the slider's position counts, on the
    /// sliding link at its point. The origin where the body does not say.
    #[must_use]
    pub fn joint_on(&self, id: JointId, body: BodyId) -> Point {
        let joint = self.joint(id);
        match joint.slider.map(|slider| self.slider(slider)) {
            Some(slider) if slider.on == body => slider.line().0,
            _ => self.body(body).local_of(self.joint_point(id)).unwrap_or_else(Point::origin),
        }
    }
}

/// Adds the joints that a scene lists. Pins are not listed: they follow from shared points.
pub(super) fn add_given(scene: &Scene, mechanism: &mut Mechanism) {
    slider::add(scene, mechanism);
}
