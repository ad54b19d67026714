//! Joints. A joint tells whether it constrains places, rotations or both; later stages ask for that, and never for its
//! kind.
//!
//! To add a kind of joint: a file like `slider` with all that belongs to it, and its line in [`add_given`]. It is read
//! by a file beside `scene/joint/slider.rs`, with a line in `scene/read.rs`.

mod contact;
mod gear;
mod slider;

pub use contact::{Contact, Touch, Touching};
pub(super) use contact::{held_here_alone, refresh as refresh_contacts};
pub(super) use gear::unlike_wheels;
pub(super) use slider::guide_line;
pub use slider::{DrivenSlide, Guide, Slider};

use super::{Body, BodyId, GROUND, JointId, Mechanism, PointId, SliderId};
use crate::geometry::{Number, Pair, Point, Turn, Vector, degrees_of, turn_of_degrees};
use crate::scene::{RubbingJoint, Scene};
use smallvec::{SmallVec, smallvec};

/// A joint between two bodies.
///
/// A pin makes a point of both bodies coincide. A slider keeps a point on a line, and the angle between the two bodies
/// constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The letter of its kind in patterns: R revolute, P prismatic.
    pub letter: char,
    /// The bodies that it joins; for a slider the guide's body, then the sliding link.
    pub bodies: [BodyId; 2],
    /// The point that coincides on both bodies, for a revolute joint.
    pub pin: Option<PointId>,
    /// The slider whose point it keeps on a guide, for a prismatic joint.
    pub slider: Option<SliderId>,
    /// The relation between angles of bodies that it keeps, if any.
    pub angular: Option<AngularConstraint>,
    /// Where its bodies roll on each other, for a gear pair.
    pub pitch: Option<Pitch>,
    /// The line on which one of its bodies rolls, for a wheel and its rack.
    pub rack: Option<Rack>,
    /// The belt that runs around its bodies, for wheels with one.
    pub belt: Option<Belt>,
    /// The marks by which it is drawn.
    pub marks: SmallVec<[Mark; 2]>,
}

/// Where two wheels roll on each other: the pitch point, on the line of their centres. It is their instant centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pitch {
    /// The centres of the wheels, on their carrier.
    pub centers: [PointId; 2],
    /// Their numbers of teeth in the smallest whole numbers, that of a ring negative.
    pub teeth: [i32; 2],
    /// The numbers of teeth themselves.
    pub all_teeth: [i32; 2],
    /// The angle of the line of action from the common tangent, in degrees.
    pub pressure_deg: f64,
}

impl Pitch {
    /// How far from the first centre towards the second it lies, in parts of their distance: z₁ / (z₁ + z₂), beyond the wheel in a ring.
    #[must_use]
    pub fn share<N: Number + From<i32>>(&self) -> N {
        let [first, second] = self.teeth;
        N::from(first) / N::from(first + second)
    }

    /// The pitch point where the centres are at these places.
    #[must_use]
    pub fn point<N: Number + From<i32>>(&self, [first, second]: [Pair<N>; 2]) -> Pair<N> {
        first.plus_scaled(second - first, self.share())
    }
}

/// Where a wheel rolls on the pitch line of a rack: the foot of the perpendicular from its centre. It is their instant centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rack {
    /// Which of the joint's two bodies is the wheel.
    pub wheel: usize,
    /// The wheel's centre, on its carrier.
    pub center: PointId,
    /// The slider whose guide has the direction of the pitch line.
    pub slider: SliderId,
    /// +1 where the line lies to the right of the wheel's centre, looking along the guide, −1 to the left.
    pub side: f64,
    /// The radius of the wheel's pitch circle.
    pub radius: f64,
    /// Its number of teeth.
    pub teeth: i32,
    /// The angle of the line of action from the pitch line, in degrees.
    pub pressure_deg: f64,
}

impl Rack {
    /// The pitch point where the wheel's centre is at this place and the guide has this unit direction; `radius` is that of the rack in such numbers.
    #[must_use]
    pub fn point<N: Number + From<i32>>(&self, center: Pair<N>, guide: Pair<N>, radius: N) -> Pair<N> {
        center.plus_scaled(guide.quarter_turn(), radius * N::from(if self.side < 0.0 { 1 } else { -1 }))
    }
}

/// A belt around two wheels. They turn as if they touched in the centre of similitude of their circles, the outer one of an open belt, the inner
/// one of a crossed belt: it is their instant centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Belt {
    /// The centres of the wheels, on their carrier.
    pub centers: [PointId; 2],
    /// The radii with which they are drawn.
    pub radii: [f64; 2],
    /// The ratio of the radii in the smallest whole numbers, the second negative for an open belt.
    pub teeth: [i32; 2],
    /// Whether it runs across, so that the wheels turn against each other.
    pub is_crossed: bool,
    /// Whether the scene says how large its wheels are.
    pub is_sized: bool,
}

impl Belt {
    /// The centre of similitude, as the pitch point of two wheels; `None` of wheels of equal size with an open belt, where it is at infinity.
    #[must_use]
    pub fn similitude(&self) -> Option<Pitch> {
        let Belt { centers, teeth, .. } = *self;
        (teeth[0] + teeth[1] != 0).then_some(Pitch { centers, teeth, all_teeth: teeth, pressure_deg: 0.0 })
    }
}

/// How two bodies roll on each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rolling {
    /// Two wheels.
    Wheels(Pitch),
    /// A wheel on a line.
    Rack(Rack),
}

impl Rolling {
    /// The pitch point, with these places of points and unit directions of guides; `number` makes such a number of one of the scene.
    #[must_use]
    pub fn point<N: Number + From<i32>>(
        &self,
        place: impl Fn(PointId) -> Pair<N>,
        guide: impl Fn(SliderId) -> Pair<N>,
        number: impl Fn(f64) -> N,
    ) -> Pair<N> {
        match self {
            Rolling::Wheels(pitch) => pitch.point(pitch.centers.map(place)),
            Rolling::Rack(rack) => rack.point(place(rack.center), guide(rack.slider), number(rack.radius)),
        }
    }
}

/// A mark by which a joint is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Mark {
    /// A circle to scale, but not smaller than that of a pin.
    Circle {
        /// Its centre.
        center: PointId,
        /// A point at a distance from the centre, to which the radius is proportional.
        towards: PointId,
        /// The radius in parts of that distance.
        part: f64,
    },
    /// A circle to scale, of this radius.
    Wheel {
        /// Its centre.
        center: PointId,
        /// Its radius.
        radius: f64,
    },
    /// A block on the guide of a slider.
    Block(SliderId),
}

/// A relation between the angles of some bodies, as a pair of gears keeps it: the angles, each times its weight, add up
/// to a constant angle.
///
/// Weights are whole numbers, as numbers of teeth are, so that a full turn of a body does not change the sum as an
/// angle. They add up to zero: bodies that turn as one satisfy every such relation.
#[derive(Clone, Debug, PartialEq)]
pub struct AngularConstraint {
    /// The bodies and their weights.
    pub terms: SmallVec<[(BodyId, i32); 3]>,
    /// The constant angle; not used in a drawn configuration.
    pub constant: Constant,
    /// What slides as the bodies turn, for a wheel and its rack.
    pub travel: Option<Travel>,
}

/// The constant angle of a relation between angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Constant {
    /// Between two bodies that turn alike, rounded: where it has to be known with its error it is found from the joint that keeps it.
    Fixed(Turn),
    /// So many times an angle of the scene.
    Phase {
        /// How many times.
        times: i32,
        /// The angle in degrees, as the scene gives it.
        degrees: f64,
    },
}

impl Constant {
    /// In degrees, rounded, with its whole turns: these count where an angle is found by a division, as that of a wheel with twice as many
    /// teeth.
    #[must_use]
    pub fn rounded_degrees(self) -> f64 {
        match self {
            Constant::Fixed(turn) => degrees_of(turn * Vector::x()),
            Constant::Phase { times, degrees } => f64::from(times) * degrees,
        }
    }

    /// As a rotation, rounded.
    #[must_use]
    pub fn rounded(self) -> Turn {
        match self {
            Constant::Fixed(turn) => turn,
            Constant::Phase { .. } => turn_of_degrees(self.rounded_degrees()),
        }
    }
}

/// What slides as angles change: these, each times its weight, add up to the travel of sliders from a start, divided by the radius of a wheel.
#[derive(Clone, Debug, PartialEq)]
pub struct Travel {
    /// The sliders, each with the sign with which its position counts.
    pub slides: SmallVec<[(SliderId, f64); 2]>,
    /// Their sum where the angles add up to the constant angle.
    pub start: f64,
    /// The radius of the wheel.
    pub radius: f64,
}

impl AngularConstraint {
    /// The relation whose constant is so many times an angle of the scene, in degrees.
    #[must_use]
    pub fn phased(terms: SmallVec<[(BodyId, i32); 3]>, times: i32, degrees: f64) -> AngularConstraint {
        AngularConstraint { terms, constant: Constant::Phase { times, degrees }, travel: None }
    }

    /// The constant angle `turn` from the first body to the second.
    #[must_use]
    pub fn fixed([first, second]: [BodyId; 2], turn: Turn) -> AngularConstraint {
        let terms = smallvec![(first, -1), (second, 1)];
        AngularConstraint { terms, constant: Constant::Fixed(turn), travel: None }
    }

    /// The two bodies with a constant angle between them, and the rotation from the frame of the first to that of the
    /// second; `None` for any other relation. Such bodies have one angular rate, so that the relation needs no equation.
    #[must_use]
    pub fn as_fixed_angle(&self) -> Option<([BodyId; 2], Turn)> {
        match (self.terms.as_slice(), self.constant) {
            (&[(first, _), (second, _)], Constant::Fixed(turn)) => Some(([first, second], turn)),
            _ => None,
        }
    }
}

impl Joint {
    /// A pin at a common point of both bodies.
    #[must_use]
    pub fn pin(point: PointId, bodies: [BodyId; 2]) -> Self {
        let circle = Mark::Circle { center: point, towards: point, part: 0.0 };
        Self {
            letter: 'R',
            bodies,
            pin: Some(point),
            slider: None,
            angular: None,
            pitch: None,
            rack: None,
            belt: None,
            marks: smallvec![circle],
        }
    }

    /// The bodies whose angles it relates; none if it constrains places alone.
    pub(crate) fn related_bodies(&self) -> impl Iterator<Item = BodyId> {
        self.angular.iter().flat_map(|angular| &angular.terms).map(|(body, _)| *body)
    }

    /// The number of degrees of freedom that it takes away between its bodies.
    #[must_use]
    pub fn constraints(&self) -> usize {
        2 * usize::from(self.pin.is_some()) + usize::from(self.slider.is_some()) + usize::from(self.angular.is_some())
    }

    /// Whether its bodies roll on each other.
    pub(crate) fn rolls(&self) -> bool {
        self.rolling().is_some()
    }

    /// How its bodies roll on each other, or turn as if they did; `None` of other joints.
    pub(crate) fn rolling(&self) -> Option<Rolling> {
        let wheels = self.pitch.or_else(|| self.belt?.similitude());
        wheels.map(Rolling::Wheels).or_else(|| self.rack.map(Rolling::Rack))
    }

    /// The body of which friction in the joint is shown; the frame's is not.
    pub(crate) fn rubbed(&self) -> BodyId {
        let [first, second] = self.bodies;
        if second == GROUND { first } else { second }
    }

    /// Whether it constrains places: the place of one of its bodies then limits that of the other. Loops run over such
    /// joints only.
    pub(crate) fn holds_places(&self) -> bool {
        self.pin.is_some() || self.slider.is_some()
    }
}

impl Mechanism {
    /// Whether wheels mesh: where they stand depends on the whole turns of drives.
    pub(crate) fn has_wheels(&self) -> bool {
        let relations = self.joints.iter().filter_map(|joint| joint.angular.as_ref());
        relations.into_iter().any(|angular| angular.as_fixed_angle().is_none())
    }

    /// The joint of that index.
    #[must_use]
    pub fn joint(&self, id: JointId) -> &Joint {
        &self.joints[id.0]
    }

    /// The point of a joint: the pin, or the slider's point on the guide.
    ///
    /// # Panics
    /// If the joint does not constrain places, as every joint of a loop does.
    #[must_use]
    pub fn joint_point(&self, id: JointId) -> PointId {
        let joint = self.joint(id);
        let sliding = || joint.slider.map(|slider| self.slider(slider).at);
        joint.pin.or_else(sliding).expect("a joint of a loop holds places")
    }

    /// The joints at the pin of a point.
    pub(crate) fn joints_at_pin(&self, point: &str) -> impl Iterator<Item = JointId> {
        let pin = self.point(point);
        self.joint_ids().filter(move |id| pin.is_some() && self.joint(*id).pin == pin)
    }

    /// The bodies that have a pin.
    pub(crate) fn holders_of_pin(&self, point: &str) -> impl Iterator<Item = &Body> {
        let pin = self.point(point);
        self.bodies.iter().filter(move |body| pin.is_some_and(|pin| body.has(pin)))
    }

    /// The body in which the scene says that a pin is fixed, so that the others turn on it.
    pub(crate) fn fixed_in(&self, pin: PointId) -> Option<BodyId> {
        let (loads, _) = &**self.loads.as_ref()?;
        let fixed = loads.friction.iter().find_map(|friction| match &friction.joint {
            RubbingJoint::Pin { point, fixed_in, .. } if point == self.point_name(pin) => fixed_in.as_ref(),
            _ => None,
        });
        self.body_named(fixed?)
    }

    /// The two bodies between which friction at a joint acts, which are those that it joins but at a pin that is fixed in another one: there
    /// what the joint's second body carries rubs on that, and what the body carries at which the joints are rubs at its own joint.
    pub(crate) fn rubbing_bodies(&self, id: JointId) -> [BodyId; 2] {
        let joint = self.joint(id);
        let [first, second] = joint.bodies;
        match joint.pin.and_then(|pin| self.fixed_in(pin)) {
            Some(fixed) if fixed == second => [second, first],
            Some(fixed) => [fixed, second],
            None => [first, second],
        }
    }

    /// Whether a pin is fixed in another body than that at which its joints are: then none of its joints alone carries all that rubs.
    pub(crate) fn is_fixed_elsewhere(&self, id: JointId) -> bool {
        let joint = self.joint(id);
        joint.pin.and_then(|pin| self.fixed_in(pin)).is_some_and(|fixed| fixed != joint.bodies[0])
    }

    /// The place of a joint in the frame of one of its bodies: the pin; on the guide's body the place from which the
    /// slider's position counts; on the sliding link its point. The origin in a drawn configuration.
    pub(crate) fn joint_on(&self, id: JointId, body: BodyId) -> Point {
        let joint = self.joint(id);
        match joint.slider.map(|slider| self.slider(slider)) {
            Some(slider) if slider.on == body => slider.line().0,
            _ => self.local(body, self.joint_point(id)),
        }
    }
}

/// Adds the joints that a scene lists; pins follow from shared points.
pub(super) fn add_given(scene: &Scene, mechanism: &mut Mechanism) {
    slider::add(scene, mechanism);
    gear::add(scene, mechanism);
    contact::refresh(scene, mechanism);
}
