use crate::geometry::{Placement, Point, Turn, Vector, cross, degrees_of, quarter_turn, turn_of_degrees};
use crate::mechanism::{Body, BodyId, JointId, Mechanism, PointId, Role, Slider, SliderId};
use std::rc::Rc;

/// Angles so little above −180°, in degrees, count as 180°: more than rounding leaves of it.
const AT_THE_CUT: f64 = 1e-9;

/// By body: the placement of its frame in the fixed frame; none while it is unknown.
///
/// Copies share what stood when [`Frames::settle`] was called last: a group's few bodies cost nothing else.
#[derive(Clone, Debug)]
pub(super) struct Frames {
    settled: Rc<Vec<Option<Placement>>>,
    /// What has been set since.
    pub(super) set: Vec<(BodyId, Placement)>,
    /// Angles from +x in degrees with their whole turns, of bodies on which wheels may roll.
    turned: Vec<(BodyId, f64)>,
}

impl Frames {
    /// The frames of the ground and of the driven links, and of bodies that driven sliders place relative to these.
    pub(super) fn known(mechanism: &Mechanism) -> Frames {
        let given_frame = |body: &Body| match &body.role {
            Role::Ground => Some(Placement::identity()),
            Role::Driver { pivot, angle, .. } => {
                let turn = turn_of_degrees((*angle)?);
                let at = mechanism.given[pivot.0]?;
                Some(pinned(turn, body.local_of(*pivot)?, at))
            }
            _ => None,
        };
        let settled = mechanism.bodies.iter().map(given_frame).collect();
        let has_wheels = mechanism.has_wheels();
        let angle = |body: BodyId| match mechanism.body(body).role {
            Role::Driver { angle: Some(angle), .. } if has_wheels => Some((body, angle)),
            _ => None,
        };
        let turned = mechanism.body_ids().filter_map(angle).collect();
        let mut frames = Frames { settled: Rc::new(settled), set: Vec::new(), turned };
        for body in mechanism.body_ids() {
            if let Some(frame) = frames.of(body).copied() {
                frames.set_compound(mechanism, body, frame);
            }
        }
        let set = std::mem::take(&mut frames.set);
        frames.settle(&set);
        frames
    }

    pub(super) fn of(&self, body: BodyId) -> Option<&Placement> {
        let set = self.set.iter().find(|(other, _)| *other == body);
        set.map(|(_, frame)| frame).or(self.settled[body.0].as_ref())
    }

    pub(super) fn set(&mut self, body: BodyId, frame: Placement) {
        match self.set.iter_mut().find(|(other, _)| *other == body) {
            Some((_, place)) => *place = frame,
            None => self.set.push((body, frame)),
        }
    }

    /// Sets frames for all copies that are made from now on.
    pub(super) fn settle(&mut self, placed: &[(BodyId, Placement)]) {
        let settled = Rc::make_mut(&mut self.settled);
        placed.iter().for_each(|(body, frame)| settled[body.0] = Some(*frame));
    }

    /// Forgets the frames of bodies that have been settled.
    pub(super) fn forget(&mut self, bodies: &[BodyId]) {
        let settled = Rc::make_mut(&mut self.settled);
        bodies.iter().for_each(|body| settled[body.0] = None);
    }

    /// A body's angle from +x in degrees, with its whole turns where they are counted; else from −180 to 180.
    pub(super) fn degrees(&self, body: BodyId) -> Option<f64> {
        let of_frame = || Some(principal_degrees(self.of(body)?.rotation * Vector::x()));
        self.counted(body).or_else(of_frame)
    }

    /// The same, `None` where whole turns are not counted.
    pub(super) fn counted(&self, body: BodyId) -> Option<f64> {
        self.turned.iter().rev().find(|(other, _)| *other == body).map(|(_, degrees)| *degrees)
    }

    /// Counts the whole turns of a body's angle.
    pub(super) fn set_degrees(&mut self, body: BodyId, degrees: f64) {
        match self.turned.iter_mut().find(|(other, _)| *other == body) {
            Some((_, own)) => *own = degrees,
            None => self.turned.push((body, degrees)),
        }
    }

    /// The places of the points of these bodies, as far as their frames are known.
    pub(super) fn places(
        &self,
        mechanism: &Mechanism,
        bodies: impl IntoIterator<Item = BodyId>,
    ) -> impl Iterator<Item = (PointId, Point)> {
        bodies.into_iter().filter_map(|id| Some((mechanism.body(id), self.of(id)?))).flat_map(|(body, frame)| {
            body.points.iter().copied().zip(body.local.iter().map(move |local| frame * local))
        })
    }

    /// Sets a body's frame, and with it those of its compound link.
    pub(super) fn set_compound(&mut self, mechanism: &Mechanism, body: BodyId, frame: Placement) {
        let lead = mechanism.lead(body);
        for other in mechanism.compound(lead) {
            self.set(other, frame * placement_in_compound(mechanism, body, other));
        }
    }

    /// The place of a body's point; `None` for a point that it does not have, or while its frame is unknown.
    pub(super) fn place(&self, mechanism: &Mechanism, body: BodyId, point: PointId) -> Option<Point> {
        let local = mechanism.body(body).local_of(point)?;
        Some(self.of(body)? * local)
    }

    /// A slider's position along its guide; `None` while the frame of either body is unknown.
    pub(super) fn slide(&self, mechanism: &Mechanism, id: SliderId) -> Option<f64> {
        let slider = mechanism.slider(id);
        let (on, link) = (self.of(slider.on)?, self.of(slider.link)?);
        let (through, direction) = slider.line();
        let at = link * mechanism.local(slider.link, slider.at);
        Some((on.inverse() * at - through).dot(&direction))
    }
}

/// The angle of a direction from +x in degrees, from −180 to 180. At the ends, where rounding would decide, it is 180: the turns of a wheel
/// that rolls on it differ for both.
pub(crate) fn principal_degrees(direction: Vector) -> f64 {
    let degrees = degrees_of(direction);
    if degrees < -180.0 + AT_THE_CUT { degrees + 360.0 } else { degrees }
}

/// The placement with rotation `turn` that brings the point `local` to `place`.
pub(super) fn pinned(turn: Turn, local: Point, place: Point) -> Placement {
    Placement::from_parts((place - turn * local).into(), turn)
}

/// Placement of the body on the other side of a slider in the frame of `from`, at slider position `s`.
fn placement_across(mechanism: &Mechanism, slider: &Slider, from: BodyId, s: f64) -> Placement {
    let (through, direction) = slider.line();
    let at = mechanism.local(slider.link, slider.at);
    // The sliding link in the frame of the guide's body.
    let forward = pinned(slider.turn(), at, through + direction * s);
    if slider.on == from { forward } else { forward.inverse() }
}

/// The direction in the frame of `from` in which the body on the other side of a slider moves as its position grows.
fn way_across(slider: &Slider, from: BodyId) -> Vector {
    let (_, direction) = slider.line();
    if slider.on == from { direction } else { -(slider.turn().inverse() * direction) }
}

/// The given position of a driven slider; zero for a free one.
pub(super) fn driven_position(slider: &Slider) -> f64 {
    let position = slider.drive.and_then(|drive| drive.position);
    position.unwrap_or(0.0)
}

/// Placement of body `to` in the frame of `from`, both of one compound link.
pub(super) fn placement_in_compound(mechanism: &Mechanism, from: BodyId, to: BodyId) -> Placement {
    let slides = mechanism.slides_between(from, to).into_iter();
    slides.fold(Placement::identity(), |frame, slide| {
        let slider = mechanism.slider(slide.slider);
        frame * placement_across(mechanism, slider, slide.from, driven_position(slider))
    })
}

/// The joint between a leg's middle body and body a or b, in the middle body's frame.
#[derive(Clone, Copy, Debug)]
pub(super) enum LegJoint {
    /// A pin: the point `local` of a or b is at `place` of the middle frame.
    Pin { local: Point, place: Point },
    /// A slider: the placement of a or b at slider position zero, free to move along the unit vector `along`.
    Slide { frame: Placement, along: Vector },
}

impl LegJoint {
    /// The joint between the middle body and a or b.
    ///
    /// `side` and `middle` are the bodies at `joint`, with their placements in the frames of a or b and of the middle
    /// body: either may belong to a compound link or to the fixed frame.
    pub(super) fn new(
        mechanism: &Mechanism,
        joint: JointId,
        (side, side_frame): (BodyId, Placement),
        (middle, middle_frame): (BodyId, Placement),
    ) -> LegJoint {
        match mechanism.joint(joint).slider.map(|id| mechanism.slider(id)) {
            None => LegJoint::Pin {
                local: side_frame * mechanism.joint_on(joint, side),
                place: middle_frame * mechanism.joint_on(joint, middle),
            },
            Some(slider) => {
                let frame = middle_frame * placement_across(mechanism, slider, middle, 0.0) * side_frame.inverse();
                let along = middle_frame.rotation * way_across(slider, middle);
                LegJoint::Slide { frame, along }
            }
        }
    }
}

/// The placement that brings points from their local coordinates closest to their places, by least squares; `None`
/// where either set coincides in one point.
pub(super) fn least_squares_placement(pairs: &[(Point, Point)]) -> Option<Placement> {
    let count = pairs.len() as f64;
    let sums = pairs
        .iter()
        .fold([Vector::zeros(); 2], |sums, (local, place)| [sums[0] + local.coords, sums[1] + place.coords]);
    let [local_mean, place_mean] = sums.map(|sum| Point::from(sum / count));
    let (mut cosine, mut sine) = (0.0, 0.0);
    for (local, place) in pairs {
        let (l, w) = (local - local_mean, place - place_mean);
        cosine += l.dot(&w);
        sine += cross(l, w);
    }
    aligning(cosine, sine).map(|turn| pinned(turn, local_mean, place_mean))
}

/// Placement, in the middle frame, of a body with a pin at `from`, turned so that its point `local_to` lies towards
/// `to`. The identity rotation where either distance is zero.
pub(super) fn placement_towards(local_from: Point, local_to: Point, from: Point, to: Point) -> Placement {
    let (l, w) = (local_to - local_from, to - from);
    let (cosine, sine) = (l.dot(&w), quarter_turn(l).dot(&w));
    pinned(aligning(cosine, sine).unwrap_or_else(Turn::identity), local_from, from)
}

/// The rotation whose cosine and sine are in this ratio; `None` where both are zero.
fn aligning(cosine: f64, sine: f64) -> Option<Turn> {
    let size = libm::hypot(cosine, sine);
    (size > 0.0).then(|| Turn::from_cos_sin_unchecked(cosine / size, sine / size))
}
