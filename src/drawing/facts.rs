//! What is looked up in a solution once, for all its sheets.

use super::view::Extent;
use crate::construction::{Action, Construction, NumberedStep, Solution, Special, display, image_name, point_on};
use crate::geometry;
use crate::mechanism::{BodyId, GROUND, Mark, Mechanism};
use crate::sheet::PerSheet;
use indexmap::IndexMap;

/// Answers by name, by body and by point.
pub(super) struct Facts {
    /// Markup of names that have another than [`display`] gives them.
    markup: IndexMap<String, String>,
    /// By name: the step that finds a special point.
    special_steps: IndexMap<String, u16>,
    /// By plan: the steps that make what is on it.
    pub plan_steps: PerSheet<PlanSteps>,
    /// By body: its number among the links, none for the ground and for blocks without name.
    pub numbers: Vec<Option<usize>>,
    /// By point: whether it is a pin.
    pub pins: Vec<bool>,
    /// By point: whether a slider is there.
    pub slides: Vec<bool>,
    /// By point: the bodies that have it.
    pub holders: Vec<Vec<BodyId>>,
    /// The middle of all points.
    pub middle: geometry::Point,
}

impl Facts {
    pub(super) fn of(solution: &Solution) -> Self {
        let Solution { mechanism, pose, construction, .. } = solution;
        let mut numbers = vec![None; mechanism.bodies.len()];
        for (number, (link, _)) in mechanism.links().enumerate() {
            numbers[link.0] = Some(number);
        }
        let mut pins = vec![false; mechanism.points.len()];
        for mark in mechanism.joints.iter().flat_map(|joint| &joint.marks) {
            if let Mark::Circle { center, .. } = mark {
                pins[center.0] = true;
            }
        }
        let mut slides = vec![false; mechanism.points.len()];
        mechanism.sliders.iter().for_each(|slider| slides[slider.at.0] = true);
        let (mut special_steps, mut plan_steps) = (IndexMap::new(), PerSheet::<PlanSteps>::default());
        for NumberedStep { number, sheet, action, .. } in construction.numbered_steps() {
            if let Action::SpecialPoint { point, .. } = action {
                special_steps.insert(point.clone(), number as u16);
            }
            plan_steps[sheet].add(number as u16, action);
        }
        let extent = Extent::of(pose.points.iter().copied());
        Self {
            markup: markup(mechanism, construction),
            special_steps,
            plan_steps,
            numbers,
            pins,
            slides,
            holders: mechanism.holders(),
            middle: nalgebra::center(&extent.low, &extent.high),
        }
    }

    /// The step that finds a special point.
    pub(super) fn step_of_special(&self, point: &str) -> u16 {
        self.special_steps.get(point).copied().unwrap_or_default()
    }

    /// The markup of a name.
    pub(super) fn markup(&self, name: &str) -> String {
        self.markup.get(name).cloned().unwrap_or_else(|| display(name))
    }
}

/// Markup of the names that [`display`] would set without commas between a special point's links, where these have names
/// longer than a letter: `S24` as `S_{24}`, `Srodarm` of the legs rod and arm as `S_{rod,arm}`, `n_b_rodC` as
/// `n_{b_{rod}C}`.
fn markup(mechanism: &Mechanism, construction: &Construction) -> IndexMap<String, String> {
    let mut shown = IndexMap::new();
    for special in construction.special.iter() {
        let links = links(mechanism, special);
        let long = links.iter().any(|link| link.chars().count() > 1);
        let low = links.join(if long { "," } else { "" });
        if special.is_assur {
            shown.insert(special.name.clone(), format!("S_{{{low}}}"));
            shown.insert(image_name(&special.name), format!("s_{{{low}}}"));
        }
        let normals = special.normal_names(mechanism);
        for (side, (cut, name)) in special.cuts.iter().zip(normals).enumerate() {
            let Some(start) = cut.start() else { continue };
            // The frame under a slider has no name of its own in a plan.
            let start = match cut.leg.base {
                GROUND => mechanism.point_name(start).to_owned(),
                base => point_on(mechanism, base, start),
            };
            let image = display(&image_name(&start));
            if let Some(slide) = cut.slide() {
                let entered = &mechanism.body(slide.to).name;
                shown.insert(special.coriolis_name(mechanism, side), format!("k_{{{image}{entered}}}"));
            }
            let end = match (special.is_assur, long) {
                (true, true) => format!(",{low}"),
                (true, false) => low.clone(),
                (false, _) => display(&special.name),
            };
            let letter = name.split('_').next().unwrap_or("n");
            let markup = format!("{letter}_{{{image}{end}}}");
            shown.insert(name, markup);
        }
    }
    shown
}

/// The links in a special point's name: those of its legs, or its own link.
fn links<'a>(mechanism: &'a Mechanism, special: &'a Special) -> Vec<&'a str> {
    let name = special.name.strip_prefix('S').unwrap_or(&special.name);
    let legs = special.cuts.each_ref().map(|cut| cut.carrier);
    let legs = legs.map(|link| mechanism.body(link).name.as_str());
    if legs.concat() == name { legs.to_vec() } else { vec![name] }
}

/// For points, rays, vectors and rates of a plan the step of the construction that makes them. Steps count from 1, through
/// the scheme and all plans.
#[derive(Default)]
pub(super) struct PlanSteps {
    last: u16,
    points: IndexMap<String, u16>,
    rays: IndexMap<[String; 2], u16>,
    vectors: IndexMap<[String; 2], u16>,
    /// Solved rates, by the names of their quantities.
    rates: IndexMap<String, u16>,
}

impl PlanSteps {
    /// Adds the next step of a sheet.
    fn add(&mut self, number: u16, action: &Action) {
        self.last = number;
        let mut made = |point: &str| {
            self.points.entry(point.to_owned()).or_insert(number);
        };
        match action {
            Action::Pole { order, images } => {
                made(order.pole());
                images.iter().for_each(|image| made(image));
            }
            // The start of a vector may have no step of its own.
            Action::LayOff(arrow) => {
                [&arrow.from, &arrow.to].into_iter().for_each(|point| made(point));
                self.vectors.entry([arrow.from.clone(), arrow.to.clone()]).or_insert(number);
            }
            Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => made(point),
            Action::Ray(ray) => {
                self.rays.entry([ray.through.clone(), ray.to.clone()]).or_insert(number);
            }
            Action::Solve { unknowns, .. } => {
                self.rates.extend(unknowns.iter().map(|(name, _)| (name.clone(), number)));
            }
            _ => {}
        }
    }

    /// The step that makes a point; the plan's last for a point without a step.
    pub(super) fn point(&self, name: &str) -> u16 {
        self.points.get(name).copied().unwrap_or(self.last)
    }

    /// The step that lays off a vector.
    pub(super) fn vector(&self, from: &str, to: &str) -> u16 {
        self.vectors.get(&[from, to].map(str::to_owned)).copied().unwrap_or(self.last)
    }

    /// The step that draws the ray through one point to another.
    pub(super) fn ray(&self, through: &str, to: &str) -> u16 {
        self.rays.get(&[through, to].map(str::to_owned)).copied().unwrap_or(self.last)
    }

    /// The step that solves for a rate; the last for one that no step solves for.
    pub(super) fn rate(&self, name: &str) -> u16 {
        self.rates.get(name).copied().unwrap_or(self.last)
    }
}

/// How finely a construction is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// Every step by itself.
    Fine,
    /// Steps that belong together at once.
    Coarse,
}
