use crate::geometry::{Placement, Point, Turn, Vector, cross, quarter_turn, turn_of_degrees};
use crate::mechanism::{Body, BodyId, JointId, Mechanism, PointId, Role, Slider};

/// Where bodies are: the placement of each body's own frame in the fixed frame, as far as known.
#[derive(Clone, Debug)]
pub(super) struct Frames(Vec<Option<Placement>>);

impl Frames {
    /// The frames of the ground and the drivers, and of what drives push from them.
    pub(super) fn known(mechanism: &Mechanism) -> Frames {
        let own = |body: &Body| match &body.role {
            Role::Ground => Some(Placement::identity()),
            Role::Driver { pivot, angle, .. } => {
                let turn = turn_of_degrees((*angle)?);
                let at = mechanism.given[pivot.0]?;
                Some(pinned(turn, body.local_of(*pivot)?, at))
            }
            _ => None,
        };
        let mut frames = Frames(mechanism.bodies.iter().map(own).collect());
        for body in (0..mechanism.bodies.len()).map(BodyId) {
            if let Some(frame) = frames.of(body).copied() {
                frames.set_compound(mechanism, body, frame);
            }
        }
        frames
    }

    pub(super) fn of(&self, body: BodyId) -> Option<&Placement> {
        self.0[body.0].as_ref()
    }

    pub(super) fn set(&mut self, body: BodyId, frame: Placement) {
        self.0[body.0] = Some(frame);
    }

    /// Places a body and with it all those of its compound link.
    pub(super) fn set_compound(&mut self, mechanism: &Mechanism, body: BodyId, frame: Placement) {
        let lead = mechanism.lead(body);
        for other in mechanism.compound(lead) {
            self.set(other, frame * within(mechanism, body, other));
        }
    }

    /// Where a body holds one of its points; `None` while the body has no place.
    pub(super) fn place(&self, mechanism: &Mechanism, body: BodyId, point: PointId) -> Option<Point> {
        let local = mechanism.body(body).local_of(point)?;
        Some(self.of(body)? * local)
    }
}

/// The placement with this turn that brings the local point to a place.
pub(super) fn pinned(turn: Turn, local: Point, place: Point) -> Placement {
    Placement::from_parts((place - turn * local).into(), turn)
}

/// A local point of a body; the origin for a body that gives none.
pub(super) fn local(mechanism: &Mechanism, body: BodyId, point: PointId) -> Point {
    let local = mechanism.body(body).local_of(point);
    local.unwrap_or_else(Point::origin)
}

/// The sliding link's placement in the frame of the guide's body, at slider position `s`.
pub(super) fn slid(mechanism: &Mechanism, slider: &Slider, s: f64) -> Placement {
    let (through, direction) = slider.line();
    let at = local(mechanism, slider.link, slider.at);
    pinned(slider.turn(), at, through + direction * s)
}

/// The placement of `to` in the frame of `from`, across a prismatic joint at slider position `s`.
pub(super) fn across(mechanism: &Mechanism, slider: &Slider, from: BodyId, s: f64) -> Placement {
    let forward = slid(mechanism, slider, s);
    if slider.on == from { forward } else { forward.inverse() }
}

/// The position that a slider's drive sets; zero for a free one.
pub(super) fn driven_position(slider: &Slider) -> f64 {
    let position = slider.drive.and_then(|drive| drive.position);
    position.unwrap_or(0.0)
}

/// The placement of body `to` in the frame of `from`, both of one compound link.
pub(super) fn within(mechanism: &Mechanism, from: BodyId, to: BodyId) -> Placement {
    let way = mechanism.way(from, to).into_iter();
    way.fold(Placement::identity(), |frame, slide| {
        let slider = mechanism.slider(slide.slider);
        frame * across(mechanism, slider, slide.from, driven_position(slider))
    })
}

/// How one of the two bodies that a leg joins is held by the leg's middle body, in the middle body's frame.
#[derive(Clone, Copy, Debug)]
pub(super) enum Hold {
    /// By a pin: its own point stands at this place of the middle frame.
    Pin { local: Point, place: Point },
    /// By a slider: with this placement at slider position zero, free along a direction.
    Slide { frame: Placement, along: Vector },
}

impl Hold {
    /// How a side is held at `joint` by the middle body.
    ///
    /// Either side may stand for several bodies that do not move against each other, as the fixed frame does: `side` and
    /// `middle` are the joined bodies with their placements in the side's and in the middle's frame.
    pub(super) fn new(
        mechanism: &Mechanism,
        joint: JointId,
        (side, side_frame): (BodyId, Placement),
        (middle, middle_frame): (BodyId, Placement),
    ) -> Hold {
        match mechanism.joint(joint).slider.map(|id| mechanism.slider(id)) {
            None => Hold::Pin {
                local: side_frame * mechanism.joint_on(joint, side),
                place: middle_frame * mechanism.joint_on(joint, middle),
            },
            Some(slider) => {
                let at = |s: f64| middle_frame * across(mechanism, slider, middle, s) * side_frame.inverse();
                let (frame, moved) = (at(0.0), at(1.0));
                // Directions are differences of placements one unit of slide apart: exact enough for a start.
                let along = (moved.translation.vector - frame.translation.vector).normalize();
                Hold::Slide { frame, along }
            }
        }
    }
}

/// The placement that brings local points closest to their places, by least squares; `None` unless two of either are apart.
pub(super) fn fitted(pairs: &[(Point, Point)]) -> Option<Placement> {
    let count = pairs.len() as f64;
    let sums =
        pairs.iter().fold([Vector::zeros(); 2], |sums, (own, place)| [sums[0] + own.coords, sums[1] + place.coords]);
    let [own_mean, place_mean] = sums.map(|sum| Point::from(sum / count));
    let (mut cosine, mut sine) = (0.0, 0.0);
    for (own, place) in pairs {
        let (l, w) = (own - own_mean, place - place_mean);
        cosine += l.dot(&w);
        sine += cross(l, w);
    }
    let size = libm::hypot(cosine, sine);
    (size > 0.0).then(|| {
        let turn = Turn::from_cos_sin_unchecked(cosine / size, sine / size);
        pinned(turn, own_mean, place_mean)
    })
}

/// The placement (in the middle frame) of a body held by a pin, when a second place of it is known.
pub(super) fn turned_towards(local_from: Point, local_to: Point, from: Point, to: Point) -> Placement {
    let (l, w) = (local_to - local_from, to - from);
    let (cosine, sine) = (l.dot(&w), quarter_turn(l).dot(&w));
    let size = libm::hypot(cosine, sine);
    let turn = if size > 0.0 { Turn::from_cos_sin_unchecked(cosine / size, sine / size) } else { Turn::identity() };
    pinned(turn, local_from, from)
}
