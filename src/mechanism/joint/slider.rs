//! Sliders: prismatic joints, each a point of one link on a straight guide of another body.

use super::{Joint, Mark, Tie};
use crate::geometry::{Point, Turn, Vector, direction_of_degrees, turn_of_degrees};
use crate::mechanism::shape::direction;
use crate::mechanism::{Body, BodyId, GROUND, JointId, Mechanism, PointId, Role, SliderId};
use crate::scene::{self, Along, At, GivenBy, On, Scene, SliderDrive};
use smallvec::smallvec;

/// A link that slides along a straight guide of another body and keeps its angle to it.
#[derive(Clone, Debug)]
pub struct Slider {
    /// The sliding link.
    pub link: BodyId,
    /// Its point that stands on the guide's line.
    pub at: PointId,
    /// The body that carries the guide.
    pub on: BodyId,
    /// The guide.
    pub guide: Guide,
    /// In a drawn configuration: the point of the guide from which the slider's position counts, if there is one.
    pub counted_from: Option<PointId>,
    /// Degrees from the guide to the sliding link's axis.
    pub turned: f64,
    /// How it is pushed along the guide, if it is driven; the position is none in a drawn configuration.
    pub drive: Option<SliderDrive>,
}

/// A straight guide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Guide {
    /// In the frame of its body: a point of it, and its unit direction.
    Local {
        /// A point of the guide, from which the slider's position counts.
        through: Point,
        /// Unit direction.
        direction: Vector,
    },
    /// As drawn, through the slider's `at`: between two points of its body, from the first to the second.
    DrawnBetween(PointId, PointId),
    /// As drawn, through the slider's `at`: in this direction.
    Drawn(Vector),
}

impl Slider {
    /// The guide in the frame of its body: the place from which the slider's position counts, and the unit direction. Of a drawn guide only a direction that
    /// the scene gives is known here; the rest is the origin and the x axis.
    #[must_use]
    pub fn line(&self) -> (Point, Vector) {
        match self.guide {
            Guide::Local { through, direction } => (through, direction),
            Guide::Drawn(direction) => (Point::origin(), direction),
            Guide::DrawnBetween(..) => (Point::origin(), Vector::x()),
        }
    }

    /// The sliding link's frame seen from that of the guide's body.
    #[must_use]
    pub fn turn(&self) -> Turn {
        let (_, direction) = self.line();
        Turn::from_cos_sin_unchecked(direction.x, direction.y) * turn_of_degrees(self.turned)
    }
}

impl Mechanism {
    /// Adds a slider and its joint.
    pub(in crate::mechanism) fn add_slider(&mut self, slider: Slider) {
        let id = SliderId(self.sliders.len());
        let bodies = [slider.on, slider.link];
        self.joints.push(Joint {
            letter: 'P',
            bodies,
            pin: None,
            slider: Some(id),
            tie: Some(Tie::alike(bodies, slider.turn())),
            marks: smallvec![Mark::Block(id)],
        });
        self.sliders.push(slider);
    }

    /// The joint that a slider is.
    #[must_use]
    pub fn slider_joint(&self, id: SliderId) -> JointId {
        let index = self.joints.iter().position(|joint| joint.slider == Some(id));
        JointId(index.expect("every slider is a joint"))
    }

    /// Where the sliding point is on its link, in the link's frame.
    #[must_use]
    pub fn slider_at(&self, id: SliderId) -> Point {
        let slider = self.slider(id);
        self.body(slider.link).local_of(slider.at).unwrap_or_else(Point::origin)
    }

    /// The slider of that index.
    #[must_use]
    pub fn slider(&self, id: SliderId) -> &Slider {
        &self.sliders[id.0]
    }

    /// The name of a slider in results: sliding link / guide body, as in `3/2`, or pin / guide body, as in `P/3`.
    ///
    /// Of further sliders with the same two, as where a pin rides in two slots of a link, `P/3#2`, in scene order.
    #[must_use]
    pub fn slider_name(&self, id: SliderId) -> String {
        let names = |slider: &Slider| [slider.link, slider.on].map(|b| self.body(b).name.as_str());
        let own = names(self.slider(id));
        let before = self.sliders[..id.0].iter().filter(|s| names(s) == own);
        match before.count() {
            0 => own.join("/"),
            count => format!("{}#{}", own.join("/"), count + 1),
        }
    }

    /// The name by which a driven slider is called as a drive.
    #[must_use]
    pub fn push_name(&self, id: SliderId) -> String {
        let slider = self.slider(id);
        if slider.on == GROUND { self.body(slider.link).name.clone() } else { self.slider_name(id) }
    }
}

/// Adds the sliders of a scene.
pub(super) fn add(scene: &Scene, mechanism: &mut Mechanism) {
    for given in &scene.sliders {
        let on = match &given.on {
            On::Ground => GROUND,
            On::Link(name) => mechanism.link(name).expect("checked by the scene"),
        };
        let (link, at) = match (&given.link, &given.at, &given.pin) {
            (Some(link), Some(at), _) => mechanism.link(link).zip(mechanism.point(at)),
            (_, _, pin) => pin.as_ref().and_then(|pin| add_block(mechanism, pin)),
        }
        .expect("checked by the scene");
        let counted_from = match (&given.through, &given.along) {
            (Some(At::Point(p)), _) | (None, Along::Points(p, _)) => mechanism.point(p),
            _ => None,
        };
        let guide = guide(mechanism, given, on);
        mechanism.add_slider(Slider {
            link,
            at,
            on,
            guide,
            counted_from,
            turned: given.turned_deg,
            drive: given.drive,
        });
    }
}

/// Adds the block of a pin that rides in a slot: a body with that one point.
fn add_block(mechanism: &mut Mechanism, pin: &str) -> Option<(BodyId, PointId)> {
    let point = mechanism.point(pin)?;
    let local = match mechanism.given_by {
        GivenBy::Lengths => vec![Point::origin()],
        GivenBy::Drawing => Vec::new(),
    };
    mechanism.bodies.push(Body { name: pin.to_owned(), points: vec![point], local, role: Role::Member, block: true });
    Some((BodyId(mechanism.bodies.len() - 1), point))
}

fn guide(mechanism: &Mechanism, slider: &scene::Slider, on: BodyId) -> Guide {
    let body = mechanism.body(on);
    let id = |name: &String| mechanism.point(name).expect("checked by the scene");
    if mechanism.given_by == GivenBy::Drawing {
        return match &slider.along {
            Along::Points(a, b) => Guide::DrawnBetween(id(a), id(b)),
            Along::Direction(d) => Guide::Drawn(direction(Vector::from(*d))),
            // Degrees count from the axis of the guide's body.
            Along::Degrees(angle) => {
                let axis = match body.points.as_slice() {
                    [a, b, ..] if on != GROUND => {
                        let place = |p: &PointId| mechanism.given[p.0];
                        place(b).zip(place(a)).map(|(b, a)| direction(b - a))
                    }
                    _ => None,
                };
                let (turn, axis) = (direction_of_degrees(*angle), axis.unwrap_or_else(Vector::x));
                Guide::Drawn(Vector::new(axis.x * turn.x - axis.y * turn.y, axis.x * turn.y + axis.y * turn.x))
            }
        };
    }
    let local = |name: &String| body.local_of(id(name)).unwrap_or_else(Point::origin);
    let along = match &slider.along {
        Along::Points(a, b) => direction(local(b) - local(a)),
        Along::Direction(d) => direction(Vector::from(*d)),
        Along::Degrees(angle) => direction_of_degrees(*angle),
    };
    let through = match (&slider.through, &slider.along) {
        (Some(At::Place(p)), _) => (*p).into(),
        (Some(At::Point(p)), _) => local(p),
        (None, Along::Points(a, _)) => local(a),
        (None, _) => body.local.first().copied().unwrap_or_else(Point::origin),
    };
    Guide::Local { through, direction: along }
}
