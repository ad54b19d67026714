//! What the plan finds, by the numbers of the construction and by the names of quantities.

use super::statics::Statics;
use super::{ForceOf, ForcePart, ForcePlan, ForceStep, Found, Side};
use crate::construction::number::NumberId;
use crate::construction::operation::{Along, PlaceId};
use crate::construction::step::Action;
use crate::geometry::Point;
use crate::mechanism::{BodyId, JointId, Mechanism, PointId, SliderId};
use crate::sheet::Sheet;
use indexmap::IndexMap;

/// A force that the plan finds along a line of known direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FoundForce {
    /// The force.
    pub of: ForceOf,
    /// Its size, positive along …
    pub size: NumberId,
    /// … this direction.
    pub along: Along,
}

/// A force that joins two corners of a polygon: what a joint does to a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WholeForce {
    /// The joint.
    pub joint: JointId,
    /// The body that receives it.
    pub on: BodyId,
    /// Where it begins and ends.
    pub ends: [PlaceId; 2],
    /// Its size, measured.
    pub size: NumberId,
}

/// What the plan finds, as numbers.
#[derive(Clone, Debug, Default)]
pub(crate) struct FoundNumbers {
    /// By load: the size of its force and its couple, as they are taken; none of what is nothing.
    pub loads: Vec<[Option<NumberId>; 2]>,
    /// Forces along lines of known direction, by moments or in polygons.
    pub parts: Vec<FoundForce>,
    /// What joints do to bodies, as the polygons show it.
    pub whole: Vec<WholeForce>,
    /// The couples that guides give their sliding links, each with its sign.
    pub couples: IndexMap<SliderId, (NumberId, f64)>,
    /// The torques of driven links.
    pub torques: IndexMap<BodyId, NumberId>,
    /// The forces along guides that drive sliders, each with its sign.
    pub pushes: IndexMap<SliderId, (NumberId, f64)>,
    /// The names of the quantities that the steps find, in order, each with its step.
    pub names: Vec<(ForceStep, String)>,
}

impl ForcePlan {
    /// The corners of all polygons, in the scene's unit of force.
    pub(crate) fn corners(&self) -> impl Iterator<Item = Point> + Clone {
        let sides = self.polygons.iter().flat_map(|polygon| &polygon.sides);
        sides.flat_map(|side| [side.from, side.from + side.vector]).map(Point::from)
    }

    /// The names of the quantities that a step finds.
    pub(in crate::construction) fn names(&self, step: &ForceStep) -> Vec<String> {
        let named = self.numbers.names.iter().filter(|(own, _)| own == step);
        named.map(|(_, name)| name.clone()).collect()
    }

    /// The name of the quantity that a number of the plan is; none of arms, of loads, and of what has no name.
    pub(in crate::construction) fn number_name(&self, mechanism: &Mechanism, number: NumberId) -> Option<String> {
        let found = &self.numbers;
        let whole = found.whole.iter().find(|force| force.size == number);
        if let Some(force) = whole {
            return whole_name(mechanism, force.joint, force.on).map(Name::of_size);
        }
        if let Some(part) = found.parts.iter().find(|part| part.size == number) {
            return part_name(mechanism, part.of);
        }
        let couple = found.couples.iter().find(|(_, (own, _))| *own == number);
        let push = found.pushes.iter().find(|(_, (own, _))| *own == number);
        let torque = found.torques.iter().find(|(_, own)| **own == number);
        couple
            .map(|(slider, _)| of_slider("M", mechanism, *slider))
            .or_else(|| push.map(|(slider, _)| of_slider("F", mechanism, *slider)))
            .or_else(|| torque.map(|(body, _)| of_link("T", mechanism, *body)))
    }
}

/// The name of a whole force.
enum Name {
    /// A vector, of which size and direction are read.
    Vector(String),
    /// One number.
    Number(String),
}

impl Name {
    fn of_size(self) -> String {
        match self {
            Name::Vector(name) => format!("{name}.size"),
            Name::Number(name) => name,
        }
    }

    fn all(self) -> Vec<String> {
        match self {
            Name::Vector(name) => ["size", "angle"].map(|part| format!("{name}.{part}")).to_vec(),
            Name::Number(name) => vec![name],
        }
    }
}

fn of_slider(letter: &str, mechanism: &Mechanism, slider: SliderId) -> String {
    format!("{letter}({})", mechanism.slider_name(slider))
}

fn of_link(letter: &str, mechanism: &Mechanism, body: BodyId) -> String {
    format!("{letter}({})", mechanism.body(body).name)
}

/// The pin by which alone a joint joins a body of a name to others.
fn pin_alone(mechanism: &Mechanism, joint: JointId, on: BodyId) -> Option<PointId> {
    let pin = mechanism.joint(joint).pin?;
    let same = mechanism.joints.iter().filter(|other| other.pin == Some(pin) && other.bodies.contains(&on));
    (same.count() == 1 && !mechanism.body(on).is_nameless()).then_some(pin)
}

/// The body of a joint whose link has two joints in its group, along whose line a part acts: the other one where the force is that on a
/// drag link of a group of class IV.
fn two_jointed(mechanism: &Mechanism, joint: JointId, on: BodyId) -> BodyId {
    let lead = mechanism.lead(on);
    let Some(group) = mechanism.groups.iter().find(|group| group.links.contains(&lead)) else { return on };
    let count = |body: BodyId| {
        let links = mechanism.compound(mechanism.lead(body));
        let holds = |joint: &&JointId| mechanism.joint(**joint).bodies.iter().any(|body| links.contains(body));
        group.joints.iter().filter(holds).count()
    };
    let other = mechanism.joint(joint).bodies.into_iter().find(|body| *body != on);
    match other.filter(|other| group.bodies.contains(other)) {
        Some(other) if count(on) != 2 && count(other) == 2 => other,
        _ => on,
    }
}

fn whole_name(mechanism: &Mechanism, joint: JointId, on: BodyId) -> Option<Name> {
    if let Some(slider) = mechanism.joint(joint).slider {
        // What drives a slider has a part along its guide, too.
        let is_driven = mechanism.slider(slider).drive.is_some();
        return (!is_driven).then(|| Name::Number(of_slider("N", mechanism, slider)));
    }
    let pin = pin_alone(mechanism, joint, on)?;
    Some(Name::Vector(format!("R({},{})", mechanism.point_name(pin), mechanism.body(on).name)))
}

/// The name of a force whose line of action is that of a joint's force or of a part of it; none of a load, and of what has no name.
pub(super) fn line_name(mechanism: &Mechanism, of: ForceOf) -> Option<String> {
    match of {
        ForceOf::Joint { joint, on, part: ForcePart::Whole } => {
            whole_name(mechanism, joint, on).map(|(Name::Vector(name) | Name::Number(name))| name)
        }
        of => part_name(mechanism, of),
    }
}

pub(super) fn part_name(mechanism: &Mechanism, of: ForceOf) -> Option<String> {
    let ForceOf::Joint { joint, on, part } = of else { return None };
    if mechanism.joint(joint).slider.is_some() {
        return whole_name(mechanism, joint, on).map(Name::of_size);
    }
    let letter = match part {
        ForcePart::Normal | ForcePart::AcrossGuide => "R_n",
        ForcePart::Tangential | ForcePart::AlongGuide => "R_t",
        ForcePart::Whole => return whole_name(mechanism, joint, on).map(Name::of_size),
    };
    let on = two_jointed(mechanism, joint, on);
    let pin = pin_alone(mechanism, joint, on)?;
    Some(format!("{letter}({},{})", mechanism.point_name(pin), mechanism.body(on).name))
}

impl Statics<'_, '_> {
    /// Notes the names of all that the steps find.
    pub fn name_all(&mut self) {
        let mechanism = self.mechanism();
        let plan = &self.plan;
        let of_side = |side: &Side| match side.of {
            ForceOf::Joint { joint, on, part: ForcePart::Whole } => {
                whole_name(mechanism, joint, on).map(Name::all).unwrap_or_default()
            }
            of => part_name(mechanism, of).into_iter().collect(),
        };
        let mut names: Vec<(ForceStep, String)> = Vec::new();
        for step in &self.writer.construction.steps[Sheet::Forces] {
            let Action::Force(step) = step else { continue };
            let side = |polygon: usize, side: usize| plan.polygons.get(polygon).and_then(|own| own.sides.get(side));
            let found: Vec<String> = match step {
                ForceStep::Moments(index) => match plan.moments.get(*index).map(|moment| moment.finds) {
                    Some(Found::Force(of)) => part_name(mechanism, of).into_iter().collect(),
                    Some(Found::Couple(slider)) => self.of_couple(slider),
                    Some(Found::Torque(body)) => vec![of_link("T", mechanism, body)],
                    Some(Found::CoupleAbout(..)) | None => Vec::new(),
                },
                ForceStep::Cross(polygon, first) => [*first, first + 1]
                    .into_iter()
                    .filter_map(|index| side(*polygon, index))
                    .flat_map(of_side)
                    .collect(),
                ForceStep::Close(polygon, index) | ForceStep::Join(polygon, index) => {
                    side(*polygon, *index).map(of_side).unwrap_or_default()
                }
                ForceStep::Push(slider, _) => vec![of_slider("F", mechanism, *slider)],
                ForceStep::LayOff(..) | ForceStep::Direction(..) | ForceStep::ByNumbers(_) => Vec::new(),
            };
            names.extend(found.into_iter().map(|name| (step.clone(), name)));
        }
        self.plan.numbers.names = names;
    }

    /// The names of a guide's couple, and of the distance at which its force acts where there is one.
    fn of_couple(&self, slider: SliderId) -> Vec<String> {
        let mechanism = self.mechanism();
        let has_force = self.joints.get(&mechanism.slider_joint(slider)).is_some_and(Option::is_some);
        let letters: &[&str] = if has_force { &["M", "h"] } else { &["M"] };
        letters.iter().map(|letter| of_slider(letter, mechanism, slider)).collect()
    }
}
