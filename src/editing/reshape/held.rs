//! What holds a joint that is pulled: pins, and guides that have to go on through the joints that slide on them.

use super::Pins;
use super::lever::Lever;
use super::rule::Rule;
use crate::editing::names::joined;
use crate::editing::present::Solved;
use crate::geometry::{Point, Vector, cross, unit};
use crate::mechanism::{PointId, SliderId};
use crate::scene::{Along, At, GivenBy, On, Shape, Slider, pair};
use crate::words::Wording;

/// Largest distance of a drawn block from its guide, in parts of the distance of the guide's points, that counts as none.
const ON_LINE: f64 = 1e-4;

/// The rules of a joint, and why.
#[derive(Clone, Debug, Default)]
pub(super) struct Held {
    pub rules: Vec<Rule>,
    is_pinned: bool,
    /// Slotted levers that turn when the joint moves.
    pub levers: Vec<Lever>,
    /// What holds the joint, in words.
    pub note: Option<String>,
}

impl Held {
    /// What holds a point.
    pub fn new(solved: &Solved, point: PointId, pins: &Pins) -> Held {
        let name = solved.mechanism.point_name(point);
        if pins.points.iter().any(|pinned| pinned == name) {
            let note = Wording::of(&solved.scene.figure).language.held_point(name);
            return Held { is_pinned: true, note: Some(note), ..Held::default() };
        }
        let mut held = Held::default();
        let mut notes = Vec::new();
        let pinned = pins.lengths.iter().filter_map(|pin| pinned(solved, point, pin));
        let sliders = || (0..).map(SliderId).zip(&solved.scene.sliders);
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
        held.note = (!notes.is_empty()).then(|| notes.join("; "));
        held
    }

    /// Whether the joint cannot go anywhere.
    pub fn is_fast(&self) -> bool {
        let lines = self.rules.iter().filter(|rule| matches!(rule, Rule::Line(_)));
        self.is_pinned || self.rules.len() > 2 || lines.count() > 1
    }
}

/// The rule of a pinned length or angle of one of the point's links.
fn pinned(solved: &Solved, point: PointId, pin: &str) -> Option<(Rule, String)> {
    let (link, key) = pin.split_once('.')?;
    let points = &solved.scene.links.get(link)?.points;
    let name = solved.mechanism.point_name(point);
    let place = |name: &str| Some(solved.pose.point(solved.mechanism.point(name)?));
    if key == "angle" {
        let axis = points.get(..2).filter(|axis| axis.iter().any(|end| end == name))?;
        let along = unit(place(&axis[1])? - place(&axis[0])?)?;
        return Some((Rule::Line(along), Wording::of(&solved.scene.figure).language.held_angle(name, link)));
    }
    let (from, to) = pair(key, points)?;
    let (from_name, to_name) = (from.clone(), to.clone());
    let other = match (from == name, to == name) {
        (true, _) => to,
        (_, true) => from,
        _ => return None,
    };
    let note = Wording::of(&solved.scene.figure).language.held_length(name, &joined(&from_name, &to_name));
    Some((Rule::Circle(place(&other)?), note))
}

/// The rule of a guide that cannot be put elsewhere for the point.
fn guided(solved: &Solved, point: PointId, id: SliderId, slider: &Slider) -> Option<(Rule, String)> {
    let name = solved.mechanism.point_name(point);
    let slides = [&slider.at, &slider.pin].into_iter().flatten().any(|at| at == name);
    let is_end = matches!(&slider.along, Along::Points(a, b) if a == name || b == name);
    let is_held = match solved.scene.given_by {
        GivenBy::Drawing => (slides || is_end) && is_on_line(solved, slider),
        GivenBy::Lengths => {
            let is_free = slides && (slider.on == On::Ground || matches!(slider.through, Some(At::Place(_))));
            (slides && !is_free) || is_end || (is_through(solved, slider, name) && !can_be_placed(solved, slider))
        }
    };
    let along: Vector = *solved.pose.guides.get(id.0)?;
    let language = Wording::of(&solved.scene.figure).language;
    is_held.then(|| (Rule::Line(along), language.held_guide(name, &solved.mechanism.slider_name(id))))
}

/// Whether the guide goes through this point of its carrier and not through its direction's points.
pub(super) fn is_through(solved: &Solved, slider: &Slider, name: &str) -> bool {
    let carrier = match &slider.on {
        On::Ground => &solved.scene.ground,
        On::Link(link) => match solved.scene.links.get(link) {
            Some(link) => &link.points,
            None => return false,
        },
    };
    slider.counted_from(carrier.first()).is_some_and(|point| point == name)
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
