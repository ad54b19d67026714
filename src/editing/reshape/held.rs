//! What holds a joint that is pulled: pins, and guides that have to go on through the joints that slide on them. Slotted levers on
//! which nothing else hangs do not hold it: they turn.

use super::Pins;
use crate::editing::present::Solved;
use crate::editing::says;
use crate::geometry::{Point, Turn, Vector, cross, quarter_turn, unit};
use crate::mechanism::{BodyId, PointId, Role, SliderId};
use crate::message::Message;
use crate::position::Pose;
use crate::scene::{Along, At, Contact, Equivalent, GivenBy, On, RackOf, Shape, Slider, joined, pair};

/// Largest distance of a drawn block from its guide, in parts of the distance of the guide's points, that counts as none.
const ON_LINE: f64 = 1e-4;

/// The rules of a joint, and why.
#[derive(Clone, Debug, Default)]
pub(super) struct Held {
    pub rules: Vec<Rule>,
    is_pinned: bool,
    /// Slotted levers that turn when the joint moves.
    pub levers: Vec<Lever>,
    /// What holds the joint.
    pub note: Option<Message>,
}

impl Held {
    /// What holds a point.
    pub fn new(solved: &Solved, point: PointId, pins: &Pins) -> Held {
        let name = solved.mechanism.point_name(point);
        if pins.points.iter().any(|pinned| pinned == name) {
            let note = says::held_point(name);
            return Held { is_pinned: true, note: Some(note), ..Held::default() };
        }
        let mut held = Held::default();
        let mut notes = Vec::new();
        let pinned = pins.lengths.iter().filter_map(|pin| pinned(solved, point, pin));
        let sliders = || {
            let given = |id: SliderId| Some((id, solved.scene.sliders.get(solved.mechanism.slider(id).given?)?));
            solved.mechanism.slider_ids().filter_map(given)
        };
        held.levers = sliders().filter_map(|(id, slider)| Lever::of(solved, point, id, slider, pins)).collect();
        let is_fixed = |id: SliderId| held.levers.iter().all(|lever| lever.slider != id);
        let fixed = sliders().filter(|(id, _)| is_fixed(*id)).collect::<Vec<_>>();
        let guided = fixed.into_iter().filter_map(|(id, slider)| guided(solved, point, id, slider));
        for (rule, note) in pinned.chain(guided) {
            if !held.rules.iter().any(|other| other.is(rule)) {
                held.rules.push(rule);
                notes.push(note);
            }
        }
        held.note = (!notes.is_empty()).then(|| Message::list(notes, "; "));
        held
    }

    /// Whether the joint cannot go anywhere.
    pub fn is_fast(&self) -> bool {
        let lines = self.rules.iter().filter(|rule| matches!(rule, Rule::Line(_)));
        self.is_pinned || self.rules.len() > 2 || lines.count() > 1
    }
}

/// The rule of a pinned length or angle of one of the point's links.
fn pinned(solved: &Solved, point: PointId, pin: &str) -> Option<(Rule, Message)> {
    let (link, key) = pin.split_once('.')?;
    let points = &solved.scene.links.get(link)?.points;
    let name = solved.mechanism.point_name(point);
    let place = |name: &str| Some(solved.pose.point(solved.mechanism.point(name)?));
    if key == "angle" {
        let axis = points.get(..2).filter(|axis| axis.iter().any(|end| end == name))?;
        let along = unit(place(&axis[1])? - place(&axis[0])?)?;
        return Some((Rule::Line(along), says::held_angle(name, link)));
    }
    let (from, to) = pair(key, points)?;
    let note = says::held_length(name, joined(&from, &to));
    let other = match (from == name, to == name) {
        (true, _) => to,
        (_, true) => from,
        _ => return None,
    };
    Some((Rule::Circle(place(&other)?), note))
}

/// The rule of a guide that cannot be put elsewhere for the point.
fn guided(solved: &Solved, point: PointId, id: SliderId, slider: &Slider) -> Option<(Rule, Message)> {
    let name = solved.mechanism.point_name(point);
    let slides = slides(slider, name);
    let is_end = matches!(&slider.along, Along::Points(a, b) if a == name || b == name);
    // The radius changes in place of a guide along a flat profile.
    if solved.mechanism.slider(id).is_contact && solved.scene.given_by == GivenBy::Lengths && slides {
        return None;
    }
    let is_held = match solved.scene.given_by {
        GivenBy::Drawing => (slides || is_end) && is_on_line(solved, slider),
        GivenBy::Lengths => {
            (slides && !has_place(slider))
                || is_end
                || (is_through(solved, slider, name) && !can_be_placed(solved, slider))
        }
    };
    let along: Vector = *solved.pose.guides.get(id.0)?;
    let is_rack = |rack: &RackOf| rack.sliders.last().copied() == solved.mechanism.slider(id).given;
    if slides && !is_held && solved.scene.gears.iter().filter_map(|gear| gear.rack.as_ref()).any(is_rack) {
        // Its wheel says where along the guide it is.
        return Some((Rule::Line(quarter_turn(along)), says::held_rack(name)));
    }
    is_held.then(|| (Rule::Line(along), says::held_guide(name, solved.mechanism.slider_name(id))))
}

/// The contact with a flat profile, by its index, whose pin is the slider of that index.
pub(super) fn contact_of(solved: &Solved, slider: usize) -> Option<usize> {
    let is_it = |contact: &Contact| matches!(contact.equivalent, Equivalent::Slider { index, .. } if index == slider);
    solved.scene.contacts.iter().position(is_it)
}

/// Whether this point slides along the guide.
pub(super) fn slides(slider: &Slider, name: &str) -> bool {
    slider.at.as_deref().or(slider.pin.as_deref()) == Some(name)
}

/// Whether the guide has a place of its own, so that it can be moved without a point of its carrier.
pub(super) fn has_place(slider: &Slider) -> bool {
    slider.on == On::Ground || matches!(slider.through, Some(At::Place(_)))
}

/// Whether the guide goes through this point of its carrier and not through its direction's points.
pub(super) fn is_through(solved: &Solved, slider: &Slider, name: &str) -> bool {
    let points = match &slider.on {
        On::Ground => Some(&solved.scene.ground),
        On::Link(link) => solved.scene.links.get(link).map(|link| &link.points),
    };
    points.and_then(|points| slider.counted_from(points.first())).is_some_and(|point| point == name)
}

/// Whether `through` of a slider can be given as coordinates.
pub(super) fn can_be_placed(solved: &Solved, slider: &Slider) -> bool {
    match &slider.on {
        On::Ground => true,
        On::Link(link) => solved.scene.links.get(link).is_some_and(|link| matches!(link.shape, Shape::Local(_))),
    }
}

/// Whether the block of a drawn scene is on the line between the points of its guide.
fn is_on_line(solved: &Solved, slider: &Slider) -> bool {
    let place = |name: &str| solved.scene.coordinates.get(name).map(|&place| Point::from(place));
    let Along::Points(a, b) = &slider.along else { return false };
    let places = || Some([place(slider.at.as_ref().or(slider.pin.as_ref())?)?, place(a)?, place(b)?]);
    places().is_some_and(|[block, a, b]| cross(b - a, block - a).abs() <= ON_LINE * (b - a).norm_squared())
}

/// What holds a joint. Each rule holds where the joint is now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// It stays on the line through its place in this direction, a unit vector.
    Line(Vector),
    /// It stays at its distance from this place.
    Circle(Point),
}

/// Sine of the angle below which two directions count as one.
const PARALLEL: f64 = 1e-9;

impl Rule {
    /// Whether two rules are one.
    pub fn is(self, other: Rule) -> bool {
        match (self, other) {
            (Rule::Line(a), Rule::Line(b)) => cross(a, b).abs() < PARALLEL,
            (Rule::Circle(a), Rule::Circle(b)) => a == b,
            _ => false,
        }
    }
}

/// The allowed place nearest to `wanted` of a joint that is at `now`.
pub fn allowed(now: Point, rules: &[Rule], wanted: Point) -> Point {
    match *rules {
        [] => wanted,
        [Rule::Line(along)] => now + along * along.dot(&(wanted - now)),
        [Rule::Circle(center)] => match unit(wanted - center) {
            Some(direction) => center + direction * (now - center).norm(),
            None => now,
        },
        // Two lines through one place cross there.
        [Rule::Line(_), Rule::Line(_)] => now,
        [Rule::Line(along), Rule::Circle(center)] | [Rule::Circle(center), Rule::Line(along)] => {
            nearest(wanted, [now, now + along * (2.0 * along.dot(&(center - now)))])
        }
        // The other crossing is the mirror image in the line of both centres.
        [Rule::Circle(a), Rule::Circle(b)] => match unit(b - a) {
            Some(axis) => {
                let across = quarter_turn(axis);
                nearest(wanted, [now, now - across * (2.0 * across.dot(&(now - a)))])
            }
            None => now,
        },
        _ => now,
    }
}

fn nearest(wanted: Point, [one, other]: [Point; 2]) -> Point {
    if (other - wanted).norm() < (one - wanted).norm() { other } else { one }
}

/// A link with a slot through one of its points, whose other points are joints of nothing else.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lever {
    pub slider: SliderId,
    pub link: BodyId,
    pivot: PointId,
    /// What slides in its slot.
    pin: PointId,
}

impl Lever {
    /// The lever of a slider, if `pulled` is its pivot or the pin in its slot, and it can turn as these ask.
    pub fn of(solved: &Solved, pulled: PointId, id: SliderId, slider: &Slider, pins: &Pins) -> Option<Lever> {
        let mechanism = &solved.mechanism;
        let given = mechanism.slider(id);
        let On::Link(name) = &slider.on else { return None };
        let link = solved.scene.links.get(name)?;
        let touches = |body: BodyId| mechanism.sliders.iter().filter(|s| s.on == body || s.link == body).count();
        let is_free = solved.scene.given_by == GivenBy::Lengths
            && slider.drive.is_none()
            && link.angle_deg.is_none()
            && mechanism.body(given.on).role == Role::Member
            && touches(given.on) == 1
            && mechanism.body(given.link).points.len() == 1;
        let through = slider.counted_from(link.points.first());
        // Either point that gives the direction is on the slot, if one of them is.
        let ends = match &slider.along {
            Along::Points(a, b) if through == Some(a) || through == Some(b) => [Some(a), Some(b)],
            _ => [None; 2],
        };
        let on_slot = through.into_iter().chain(ends.into_iter().flatten());
        let pivots = on_slot.filter_map(|point| mechanism.point(point)).filter(|_| is_free);
        let holders = mechanism.holders();
        let turns_freely = |pivot: &PointId| {
            let others = mechanism.body(given.on).points.iter().filter(|point| *point != pivot);
            let is_idle = |point: &PointId| {
                let is_pinned = pins.points.iter().any(|pinned| pinned == mechanism.point_name(*point));
                holders[point.0].len() == 1 && *point != pulled && !is_pinned
            };
            (pulled == *pivot || pulled == given.at) && others.into_iter().all(is_idle)
        };
        let pivot = pivots.into_iter().find(turns_freely)?;
        Some(Lever { slider: id, link: given.on, pivot, pin: given.at })
    }

    /// Turns the lever in a position in which pivot and pin are where they are wanted.
    pub fn turn(self, solved: &Solved, wanted: &mut Pose) {
        let before = &solved.pose;
        let ends = [before.arm(self.pivot, self.pin), wanted.arm(self.pivot, self.pin)].map(unit);
        let [Some(old), Some(new)] = ends else { return };
        let turn = Turn::from_cos_sin_unchecked(old.dot(&new), old.perp(&new));
        let pivot = wanted.point(self.pivot);
        for point in solved.mechanism.body(self.link).points.iter().filter(|point| **point != self.pivot) {
            wanted.points[point.0] = pivot + turn * before.arm(self.pivot, *point);
        }
        wanted.guides[self.slider.0] = turn * before.guides[self.slider.0];
        for body in [self.link, solved.mechanism.slider(self.slider).link] {
            wanted.axes[body.0] = before.axes[body.0].map(|axis| turn * axis);
        }
    }
}
