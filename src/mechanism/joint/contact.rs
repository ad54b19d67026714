//! Contacts of two profiles. What moves as they do, a link or a slider, is among the others; here is what belongs to the contact itself: where it is,
//! and how the profiles slide on each other.

use crate::geometry::{Number, Pair};
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId, says};
use crate::message::Message;
use crate::scene::{self, Equivalent, Scene};

/// Two profiles that touch.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// The bodies that touch.
    pub bodies: [BodyId; 2],
    /// Where, and what moves as they do.
    pub touch: Touch,
    /// Whether the second body touches with a roller about its centre.
    pub has_roller: bool,
    /// Whether what moves as they do does so in every position.
    pub is_circular: bool,
}

/// Where two profiles touch, and what moves as they do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Touch {
    /// On the line of their centres of curvature; a link between these moves as they do.
    Arcs {
        /// The equivalent link.
        link: BodyId,
        /// The centres.
        centers: [PointId; 2],
        /// The radii of curvature, that of a hollow profile negative.
        radii: Option<[f64; 2]>,
    },
    /// Beside the centre of curvature of the first, on a flat profile of the second; a pin on a guide along this moves as they do.
    Face {
        /// The pin on its guide.
        slider: SliderId,
        /// The centre of curvature.
        center: PointId,
        /// The radius of curvature.
        radius: Option<f64>,
    },
}

/// What of a position and a motion contacts ask for, in numbers of one kind.
pub trait Touching<N> {
    /// The place of a point.
    fn place(&self, point: PointId) -> Pair<N>;
    /// The unit direction of a guide.
    fn guide(&self, slider: SliderId) -> Pair<N>;
    /// A number of the scene.
    fn given(&self, number: f64) -> N;
    /// The angular velocity of a body.
    fn omega(&self, body: BodyId) -> N;
    /// The velocity of a slider along its guide.
    fn slide(&self, slider: SliderId) -> N;
}

impl Contact {
    /// The link that moves as the profiles do, if they have one.
    #[must_use]
    pub fn equivalent_link(&self) -> Option<BodyId> {
        match self.touch {
            Touch::Arcs { link, .. } => Some(link),
            Touch::Face { .. } => None,
        }
    }

    /// The centre of curvature of the first profile.
    #[must_use]
    pub fn first_center(&self) -> PointId {
        match self.touch {
            Touch::Arcs { centers: [center, _], .. } | Touch::Face { center, .. } => center,
        }
    }

    /// Where the profiles touch; `None` where no radii say it.
    pub fn point<N: Number + From<i32>>(&self, at: &impl Touching<N>) -> Option<Pair<N>> {
        match self.touch {
            Touch::Arcs { centers, radii, .. } => {
                let [first, second] = radii?.map(|radius| at.given(radius));
                let [from, to] = centers.map(|center| at.place(center));
                Some(from.plus_scaled(to - from, first / (first + second)))
            }
            Touch::Face { slider, center, radius } => {
                let across = at.guide(slider).quarter_turn();
                Some(at.place(center).plus_scaled(across, at.given(radius?)))
            }
        }
    }

    /// The common normal, of length 1: from the first centre towards the second, or into the flat profile.
    pub fn normal<N: Number + From<i32>>(&self, at: &impl Touching<N>) -> Pair<N> {
        match self.touch {
            Touch::Arcs { centers: [from, to], .. } => {
                let arm = at.place(to) - at.place(from);
                let one = N::from(1) / arm.dot(arm).sqrt();
                arm * one
            }
            Touch::Face { slider, .. } => at.guide(slider).quarter_turn(),
        }
    }

    /// The velocity with which the first profile slides on the second, positive along the normal turned by +90°.
    ///
    /// Where they touch, with n from centre to centre and ω_e of the equivalent link, each profile moves against the link as a wheel about its centre:
    /// v = r₁ (ω₁ − ω_e) + r₂ (ω₂ − ω_e), for radii of which the sum is positive. A flat profile has the pin's own sliding v_r besides: v = r (ω₁ − ω₂) − v_r,
    /// as the normal turned by +90° is the guide's direction backwards.
    pub fn sliding<N: Number + From<i32>>(&self, at: &impl Touching<N>) -> Option<N> {
        let [first, second] = self.bodies.map(|body| at.omega(body));
        match self.touch {
            Touch::Arcs { link, radii, .. } => {
                let radii = radii?;
                let [one, other] = radii.map(|radius| at.given(sense(radii) * radius));
                let link = at.omega(link);
                Some(one * (first - link) + other * (second - link))
            }
            Touch::Face { slider, radius, .. } => {
                let radius = at.given(radius?);
                Some(radius * (first - second) - at.slide(slider))
            }
        }
    }

    /// The angular velocity of the roller, which rolls on the first profile: r₁ (ω₁ − ω_e) + r₂ (ω − ω_e) = 0. `None` without a roller.
    pub fn roller<N: Number + From<i32>>(&self, at: &impl Touching<N>) -> Option<N> {
        let Touch::Arcs { link, radii, .. } = self.touch else { return None };
        let [one, other] = radii.filter(|_| self.has_roller)?.map(|radius| at.given(radius));
        let link = at.omega(link);
        Some(link - one * (at.omega(self.bodies[0]) - link) / other)
    }
}

/// +1 for radii whose sum is positive, −1 where the hollow one counts.
fn sense([first, second]: [f64; 2]) -> f64 {
    if first + second < 0.0 { -1.0 } else { 1.0 }
}

impl Mechanism {
    /// Whether a link stands for two profiles that touch.
    #[must_use]
    pub fn is_equivalent(&self, link: BodyId) -> bool {
        self.contacts.iter().any(|contact| contact.equivalent_link() == Some(link))
    }

    /// Whether a point is a centre of curvature of profiles that touch.
    pub(in crate::mechanism) fn is_center_of_contact(&self, point: &str) -> bool {
        let is_it = |id: PointId| self.point_name(id) == point;
        self.contacts.iter().any(|contact| match contact.touch {
            Touch::Arcs { centers, .. } => centers.into_iter().any(is_it),
            Touch::Face { center, .. } => is_it(center),
        })
    }

    /// Whether its motion is known in its position alone, as profiles that touch there may have any shape elsewhere.
    #[must_use]
    pub fn is_momentary(&self) -> bool {
        self.contacts.iter().any(|contact| !contact.is_circular)
    }
}

/// Gives a mechanism the contacts of a scene, with their numbers.
pub(in crate::mechanism) fn refresh(scene: &Scene, mechanism: &mut Mechanism) {
    mechanism.contacts = scene.contacts.iter().filter_map(|given| contact(mechanism, given)).collect();
}

fn contact(mechanism: &Mechanism, given: &scene::Contact) -> Option<Contact> {
    let bodies = [mechanism.body_named(&given.bodies[0])?, mechanism.body_named(&given.bodies[1])?];
    let touch = match &given.equivalent {
        Equivalent::Link { name, centers, radii } => Touch::Arcs {
            link: mechanism.link(name)?,
            centers: [mechanism.point(&centers[0])?, mechanism.point(&centers[1])?],
            radii: *radii,
        },
        Equivalent::Slider { index, center, radius } => {
            Touch::Face { slider: mechanism.given_slider(*index)?, center: mechanism.point(center)?, radius: *radius }
        }
    };
    Some(Contact { bodies, touch, has_roller: given.has_roller, is_circular: given.is_circular })
}

/// Warnings of contacts that are known in this position alone.
pub(in crate::mechanism) fn held_here_alone(mechanism: &Mechanism) -> Vec<Message> {
    let alone = mechanism.contacts.iter().filter(|contact| !contact.is_circular);
    let names = |contact: &Contact| contact.bodies.map(|body| mechanism.body(body).name.clone());
    alone.map(names).map(|[first, second]| says::holds_here_alone(first, second)).collect()
}
