//! Sliders: prismatic joints, each with a point of one link on a straight guide of another body.

use super::{AngularConstraint, Joint, Mark};
use crate::geometry::{Point, Turn, Vector, complex_product, direction_of_degrees, quarter_turn, turn_of_degrees};
use crate::mechanism::shape::direction;
use crate::mechanism::{Body, BodyId, GROUND, JointId, Mechanism, PointId, Role, SliderId};
use crate::scene::{self, Along, At, Equivalent, GivenBy, Scene, SliderDrive, SlidingName};
use crate::sheet::Order;
use crate::words::{Notation, SlidePart, SliderNames, Wording, under};
use smallvec::smallvec;

/// A link that slides along a straight guide of another body and keeps its angle to it.
#[derive(Clone, Debug)]
pub struct Slider {
    /// The sliding link.
    pub link: BodyId,
    /// The point of the sliding link that stays on the guide.
    pub at: PointId,
    /// The body that carries the guide.
    pub on: BodyId,
    /// The guide.
    pub guide: Guide,
    /// In a drawn configuration: the point of the guide from which the slider's position counts; `None` if there is
    /// none.
    pub counted_from: Option<PointId>,
    /// Angle from the guide to the sliding link's axis, in degrees.
    pub turned: f64,
    /// Its drive, if it is driven; the drive has no position in a drawn configuration.
    pub drive: Option<SliderDrive>,
    /// The least and the greatest position at which the guide holds it, if it has ends.
    pub travel: Option<[f64; 2]>,
    /// Whether it is the pin of a contact with a flat profile, which has no slot of its own.
    pub is_contact: bool,
    /// Its index among the sliders of the scene; none in a [`Placing`](super::super::Placing)'s carriage.
    pub given: Option<usize>,
}

/// A straight guide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Guide {
    /// In the frame of its body.
    Local {
        /// A point of the guide, from which the slider's position counts.
        through: Point,
        /// Unit direction.
        direction: Vector,
    },
    /// As drawn, through the slider's `at`, in the direction from the first to the second of these points of its body.
    DrawnBetween(PointId, PointId),
    /// As drawn, through the slider's `at`, in this direction of the fixed frame.
    Drawn(Vector),
}

/// Distance from the end of a guide, in parts of its length, up to which a slider is still on it.
const AT_END: f64 = 1e-9;

impl Slider {
    /// How far beyond an end of its guide it is at a position; `None` on the guide.
    pub(crate) fn beyond(&self, position: f64) -> Option<f64> {
        let [low, high] = self.travel?;
        let off = (low - position).max(position - high);
        (off > AT_END * (high - low)).then_some(off)
    }

    /// The guide in the frame of its body: the place from which the slider's position counts, and the unit direction.
    /// In a drawn configuration only a given direction is known here; otherwise origin and x axis are returned.
    #[must_use]
    pub fn line(&self) -> (Point, Vector) {
        match self.guide {
            Guide::Local { through, direction } => (through, direction),
            Guide::Drawn(direction) => (Point::origin(), direction),
            Guide::DrawnBetween(..) => (Point::origin(), Vector::x()),
        }
    }

    /// The rotation from the frame of the guide's body to that of the sliding link.
    #[must_use]
    pub fn turn(&self) -> Turn {
        let (_, direction) = self.line();
        Turn::from_cos_sin_unchecked(direction.x, direction.y) * turn_of_degrees(self.turned)
    }
}

/// A driven slider between two links of a compound link, and the direction in which it is passed.
///
/// The two bodies of a driven slider have one rotation, and their sliding is given: their relative motion is known. So
/// all links that driven sliders join, directly or over others, are one *compound link* to groups and loops, with
/// lengths that change as the scene says: a hydraulic cylinder with its rod is a link of varying length between its two
/// pins. One of its links, the lead, stands for all of them; where the lead's motion is known, so are those of the
/// others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrivenSlide {
    /// The slider.
    pub slider: SliderId,
    /// The body from which the slider is passed.
    pub from: BodyId,
    /// The body to which it is passed.
    pub to: BodyId,
    /// +1 from the guide's body to the sliding link, −1 from the sliding link to the guide's body.
    pub sign: f64,
}

impl DrivenSlide {
    pub(in crate::mechanism) fn new(mechanism: &Mechanism, slider: SliderId, from: BodyId) -> Self {
        let ends = mechanism.slider(slider);
        let forward = ends.on == from;
        Self { slider, from, to: if forward { ends.link } else { ends.on }, sign: if forward { 1.0 } else { -1.0 } }
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
            angular: Some(AngularConstraint::fixed([slider.on, slider.link], slider.turn())),
            pitch: None,
            rack: None,
            belt: None,
            marks: if slider.is_contact { smallvec![] } else { smallvec![Mark::Block(id)] },
        });
        self.sliders.push(slider);
    }

    /// The slider that is off its guide farthest where sliders have these positions, and its distance from the guide's end; `None` where all are on
    /// theirs, as guides without ends always hold them. What is off by rounding alone, as at the bottom of a slot, is on its guide.
    pub(crate) fn off_guide(&self, position: impl Fn(SliderId) -> Option<f64>) -> Option<(SliderId, f64)> {
        let off = |id: SliderId| Some((id, self.slider(id).beyond(position(id)?)?));
        self.slider_ids().filter_map(off).max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The slider of that index in the scene.
    pub(crate) fn given_slider(&self, index: usize) -> Option<SliderId> {
        self.sliders.iter().position(|slider| slider.given == Some(index)).map(SliderId)
    }

    /// The joint of a slider.
    pub(crate) fn slider_joint(&self, id: SliderId) -> JointId {
        let index = self.joints.iter().position(|joint| joint.slider == Some(id));
        JointId(index.expect("every slider is a joint"))
    }

    /// The slider of that index.
    #[must_use]
    pub fn slider(&self, id: SliderId) -> &Slider {
        &self.sliders[id.0]
    }

    /// The name of a slider in results: sliding link / guide's body, as `3/2`, or pin / guide's body, as `P/3`. Further
    /// sliders between the same two, as of a pin in two slots of a link, are `P/3#2` and so on in scene order.
    #[must_use]
    pub fn slider_name(&self, id: SliderId) -> String {
        self.slider_name_with(id, &self.body(GROUND).name)
    }

    /// The slider of that name.
    #[must_use]
    pub fn slider_named(&self, name: &str) -> Option<SliderId> {
        self.slider_ids().find(|&id| self.slider_name(id) == name)
    }

    /// The same in sentences: `5/bastidor` or `5/0` for `5/ground`.
    #[must_use]
    pub fn slider_in_words(&self, id: SliderId, words: &Wording) -> String {
        self.slider_name_with(id, words.ground())
    }

    /// What symbols of a notation name a slider by; `shown` gives the text for a name.
    #[must_use]
    pub fn slider_shown(&self, id: SliderId, notation: &Notation, shown: &dyn Fn(&str) -> String) -> SliderNames {
        let slider = self.slider(id);
        let ground = self.body(GROUND).name.as_str();
        let text = |name: &str| match (shown(name), notation.frame) {
            (own, Some(frame)) if name == ground && own == ground => frame.as_str().to_owned(),
            (own, _) => own,
        };
        let pair: Vec<String> = self.slider_name(id).split('/').map(text).collect();
        let at = self.point_name(slider.at);
        // A block without a name belongs to the link that has its pin.
        let block = self.body(slider.link);
        let link = match block.block {
            true => self.bodies.iter().find(|body| !body.is_nameless() && body.has(slider.at)),
            false => Some(block),
        };
        let point = |body: &Body| under(&text(at), &text(&body.name));
        let mut points = [link.map_or_else(|| text(at), point), point(self.body(slider.on))];
        // A pin in two slots of a link.
        let is_alike = |other: &&Slider| {
            let same = self.body(other.link).name == block.name && self.body(other.link).block == block.block;
            same && (other.at, other.on) == (slider.at, slider.on)
        };
        let before = self.sliders[..id.0].iter().filter(is_alike).count();
        if before > 0 {
            points[1].push_str(&format!("#{}", before + 1));
        }
        SliderNames { pair: pair.join("/"), points }
    }

    fn slider_name_with(&self, id: SliderId, ground: &str) -> String {
        let name = |body: BodyId| if body == GROUND { ground } else { self.body(body).name.as_str() };
        let names = |slider: &Slider| [slider.link, slider.on].map(name);
        let own @ [link, on] = names(self.slider(id));
        match self.sliders[..id.0].iter().filter(|slider| names(slider) == own).count() {
            0 => format!("{link}/{on}"),
            count => format!("{link}/{on}#{}", count + 1),
        }
    }

    /// The symbol of a driven slider's velocity or acceleration beside its drive: `v_{3}` or `v_{2/1}`, in a notation by points as
    /// everywhere.
    #[must_use]
    pub fn push_symbol(&self, of: Order, id: SliderId, notation: &Notation, shown: &dyn Fn(&str) -> String) -> String {
        match notation.sliding {
            SlidingName::Slider => format!("{}_{{{}}}", of.vector(), shown(&self.push_name(id))),
            SlidingName::Points => {
                notation.slide(of, SlidePart::Relative, &self.slider_shown(id, notation, shown)).markup()
            }
        }
    }

    /// The name of a driven slider as a drive: that of the sliding link on the ground, as in [`Self::slider_name`] on a
    /// moving link.
    #[must_use]
    pub fn push_name(&self, id: SliderId) -> String {
        let slider = self.slider(id);
        if slider.on == GROUND { self.body(slider.link).name.clone() } else { self.slider_name(id) }
    }
}

/// Adds the sliders of a scene in the order of what slides and on what, so that theirs in the file decides nothing.
pub(super) fn add(scene: &Scene, mechanism: &mut Mechanism) {
    let is_contact = |index: usize| {
        let mut contacts = scene.contacts.iter();
        contacts.any(|contact| matches!(contact.equivalent, Equivalent::Slider { index: own, .. } if own == index))
    };
    let on =
        |given: &scene::Slider, mechanism: &Mechanism| mechanism.body_named(&given.on).expect("checked by the scene");
    let pinned = |(index, given): (usize, &scene::Slider)| {
        Some((mechanism.point(given.pin.as_ref()?)?, on(given, mechanism), index))
    };
    let mut pinned: Vec<(PointId, BodyId, usize)> = scene.sliders.iter().enumerate().filter_map(pinned).collect();
    pinned.sort_unstable();
    let linked = |(index, given): (usize, &scene::Slider)| {
        let link = mechanism.link(given.link.as_ref()?)?;
        Some((link, on(given, mechanism), mechanism.point(given.at.as_ref()?)?, index))
    };
    let mut sliding: Vec<(BodyId, BodyId, PointId, usize)> =
        scene.sliders.iter().enumerate().filter_map(linked).collect();
    sliding.sort_unstable();
    for (pin, on, index) in pinned {
        sliding.push((add_block(mechanism, pin), on, pin, index));
    }
    for (link, on, at, index) in sliding {
        let given = &scene.sliders[index];
        let counted_from = given.counted_from(None).and_then(|point| mechanism.point(point));
        let guide = guide(mechanism, given, on);
        mechanism.add_slider(Slider {
            link,
            at,
            on,
            guide,
            counted_from,
            turned: given.turned_deg,
            drive: given.drive,
            travel: given.travel,
            is_contact: is_contact(index),
            given: Some(index),
        });
    }
}

/// Adds the block of a pin in a slot: a body with that one point.
fn add_block(mechanism: &mut Mechanism, pin: PointId) -> BodyId {
    let local = match mechanism.given_by {
        GivenBy::Lengths => vec![Point::origin()],
        GivenBy::Drawing => Vec::new(),
    };
    let name = mechanism.point_name(pin).to_owned();
    mechanism.bodies.push(Body { name, points: vec![pin], local, role: Role::Member, block: true });
    BodyId(mechanism.bodies.len() - 1)
}

fn guide(mechanism: &Mechanism, slider: &scene::Slider, on: BodyId) -> Guide {
    let body = mechanism.body(on);
    let id = |name: &String| mechanism.point(name).expect("checked by the scene");
    if mechanism.given_by == GivenBy::Drawing {
        return match &slider.along {
            Along::Points(a, b) => Guide::DrawnBetween(id(a), id(b)),
            Along::Direction(d) => Guide::Drawn(direction(Vector::from(*d))),
            // Degrees count from the axis of the guide's body, on the ground from +x.
            Along::Degrees(angle) => {
                let axis = match body.points.as_slice() {
                    [a, b, ..] if on != GROUND => {
                        let place = |p: &PointId| mechanism.given[p.0];
                        place(b).zip(place(a)).map(|(b, a)| direction(b - a))
                    }
                    _ => None,
                };
                let (turn, axis) = (direction_of_degrees(*angle), axis.unwrap_or_else(Vector::x));
                Guide::Drawn(complex_product(axis, turn))
            }
        };
    }
    let local = |name: &String| body.local_of(id(name));
    let first = mechanism.first_point(on).map(|point| &mechanism.points[point.0]);
    let (through, direction) = guide_line(slider, first, local);
    Guide::Local { through: through.unwrap_or_else(Point::origin), direction: direction.unwrap_or_else(Vector::x) }
}

/// The place from which a slider's position counts and the direction of its guide, where `place` knows their points;
/// `first` is the carrier's first point.
pub(in crate::mechanism) fn guide_line(
    slider: &scene::Slider,
    first: Option<&String>,
    place: impl Fn(&String) -> Option<Point>,
) -> (Option<Point>, Option<Vector>) {
    let through = match &slider.through {
        Some(At::Place(through)) => Some((*through).into()),
        _ => slider.counted_from(first).and_then(&place),
    };
    let along = match &slider.along {
        Along::Points(a, b) => place(a).zip(place(b)).map(|(a, b)| direction(b - a)),
        Along::Direction(along) => Some(direction(Vector::from(*along))),
        Along::Degrees(angle) => Some(direction_of_degrees(*angle)),
    };
    // To the right of its direction.
    let beside = along.filter(|_| slider.beside != 0.0).map(|along| quarter_turn(along) * -slider.beside);
    (through.map(|through| through + beside.unwrap_or_default()), along)
}
