//! Steps that a lecturer shows together: each passage reaches one aim of the construction.

use super::constructed::{Construction, NumberedStep};
use super::markup::{marked, rate_symbol};
use super::plan::PointRole;
use super::sentence::Teller;
use super::step::{Action, Arrow, RayOf, Relation, VectorOf};
use crate::sheet::Sheet;
use crate::words::Language;

/// What a passage reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// The special points of a group, and the lengths measured to them.
    SpecialPoints,
    /// The pole of a plan, and the vectors known from the start.
    Start,
    /// A point where two rays cross, with all that is laid off before and measured after.
    Crossing,
    /// The rates of a group, solved for from measured segments.
    Rates,
    /// Images of further points, from known rates and images.
    Images,
    /// That there is no construction.
    Nothing,
}

/// Steps that are shown together, on one sheet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Passage {
    /// What they reach.
    pub aim: Aim,
    /// The numbers of the first and the last of them.
    pub steps: [usize; 2],
}

impl Construction {
    /// All steps, joined to passages.
    ///
    /// A length or segment that is measured belongs to the equations if these follow at once, else to the point that
    /// has just been found.
    #[must_use]
    pub fn passages(&self) -> Vec<Passage> {
        let steps: Vec<NumberedStep<'_>> = self.numbered_steps().collect();
        let mut passages: Vec<Passage> = Vec::new();
        // What the present passage already has: its sheet, the group of special points, whether its aim is reached.
        let mut present: Option<(Sheet, Option<usize>, bool)> = None;
        for (index, step) in steps.iter().enumerate() {
            let last = passages.last().map(|passage| passage.aim);
            let aim = aim(&steps[index..], last);
            let group = match step.step.action {
                Action::SpecialPoint { special, .. } => self.group_of(special),
                _ => present.and_then(|(_, group, _)| group),
            };
            let joins = present.is_some_and(|(sheet, own, is_reached)| {
                sheet == step.sheet()
                    && last == Some(aim)
                    && match aim {
                        Aim::SpecialPoints => own == group,
                        Aim::Crossing => !is_reached || step.step.action.is_measured(),
                        Aim::Start | Aim::Images => true,
                        Aim::Rates => !is_reached,
                        Aim::Nothing => false,
                    }
            });
            let was_reached = joins && present.is_some_and(|(.., is_reached)| is_reached);
            let reached = matches!(step.step.action, Action::Cross { .. } | Action::Solve { .. });
            present = Some((step.sheet(), group, was_reached || reached));
            match passages.last_mut().filter(|_| joins) {
                Some(passage) => passage.steps[1] = step.number,
                None => passages.push(Passage { aim, steps: [step.number; 2] }),
            }
        }
        passages
    }

    /// The steps of a passage.
    pub fn steps_of(&self, passage: &Passage) -> impl Iterator<Item = NumberedStep<'_>> {
        let [first, last] = passage.steps;
        (first..=last).filter_map(|number| self.numbered_step(number))
    }
}

/// The aim of the first of some steps; `last` is that of the passage before it.
fn aim(steps: &[NumberedStep<'_>], last: Option<Aim>) -> Aim {
    let actions = || steps.iter().map(|step| &step.step.action);
    let Some(action) = actions().next() else { return Aim::Nothing };
    match action {
        Action::SpecialPoint { .. } | Action::MeasureLength { .. } => Aim::SpecialPoints,
        Action::Pole { .. } => Aim::Start,
        Action::Solve { .. } => Aim::Rates,
        Action::NoConstruction { .. } => Aim::Nothing,
        Action::Divide { .. } | Action::Coincide { .. } => Aim::Images,
        Action::Measure { .. } => {
            let after = actions().find(|action| !action.is_measured());
            if matches!(after, Some(Action::Solve { .. })) { Aim::Rates } else { Aim::Crossing }
        }
        // Of rays.
        Action::Cross { .. } => last.filter(|last| *last == Aim::Images).unwrap_or(Aim::Crossing),
        Action::LayOff(Arrow { of: VectorOf::Point(..), .. }) if last == Some(Aim::Start) => Aim::Start,
        _ => match towards(actions()) {
            Some(RayOf::Leg(..)) => Aim::Crossing,
            Some(RayOf::Arm { .. }) | None => Aim::Images,
        },
    }
}

/// What the next ray is, where all that is laid off before leads to its start.
fn towards<'a>(actions: impl Iterator<Item = &'a Action>) -> Option<RayOf> {
    for action in actions {
        match action {
            Action::LayOff(arrow) => match arrow.of {
                VectorOf::Point(..) | VectorOf::Normal(..) | VectorOf::Passed(..) => {}
                VectorOf::Relative { .. } | VectorOf::Sliding(..) => return None,
            },
            Action::Ray(ray) => return Some(ray.of),
            _ => return None,
        }
    }
    None
}

impl Teller<'_> {
    /// The caption of a passage: the sentences of its steps, shortened; names between backticks, as in
    /// [`caption`](Teller::caption).
    #[must_use]
    pub fn passage_caption(&self, passage: &Passage) -> String {
        let steps: Vec<NumberedStep<'_>> = self.construction.steps_of(passage).collect();
        match steps.as_slice() {
            [] => return String::new(),
            [step] => return self.caption(step),
            _ => {}
        }
        let sentences = match passage.aim {
            Aim::SpecialPoints => self.joined_special_points(&steps),
            Aim::Start => vec![self.caption(&steps[0]), self.joined_vectors(&steps)],
            Aim::Crossing => vec![self.joined_vectors(&steps), self.joined_rays(&steps), self.joined_segments(&steps)],
            Aim::Rates => vec![self.joined_rates(&steps)],
            Aim::Images => vec![self.joined_images(&steps)],
            Aim::Nothing => steps.iter().map(|step| self.caption(step)).collect(),
        };
        let said: Vec<String> = sentences.into_iter().filter(|sentence| !sentence.is_empty()).collect();
        said.join(" ")
    }

    fn joined_special_points(&self, steps: &[NumberedStep<'_>]) -> Vec<String> {
        let language = self.words.language;
        let mut special = Vec::new();
        let mut lengths = Vec::new();
        for step in steps {
            match &step.step.action {
                Action::SpecialPoint { point, special: id, .. } => special.push((step, point, *id)),
                Action::MeasureLength { from, to, .. } => lengths.push(pair(from, to)),
                _ => {}
            }
        }
        let found = match special.as_slice() {
            [(step, ..)] => self.caption(step),
            _ => {
                let names: Vec<String> = special.iter().map(|(_, point, _)| marked(point)).collect();
                language.join_special_points(&names.join(", "))
            }
        };
        vec![found, self.joined(lengths, Language::join_measure)]
    }

    /// What is laid off.
    fn joined_vectors(&self, steps: &[NumberedStep<'_>]) -> String {
        let vectors = steps.iter().filter_map(|step| match &step.step.action {
            Action::LayOff(arrow) => Some(pair(&arrow.from, &arrow.to)),
            _ => None,
        });
        self.joined(vectors.collect(), Language::join_lay_off)
    }

    fn joined_rays(&self, steps: &[NumberedStep<'_>]) -> String {
        let language = self.words.language;
        let rays: Vec<String> = steps
            .iter()
            .filter_map(|step| match &step.step.action {
                Action::Ray(ray) => {
                    let sentence = match ray.relation {
                        Relation::Perpendicular => Language::join_normal,
                        Relation::Parallel => Language::join_parallel,
                        Relation::Angle => Language::join_at_angle,
                    };
                    Some(sentence(language, &marked(&ray.through), &self.line_of(ray)))
                }
                _ => None,
            })
            .collect();
        let point = steps.iter().find_map(|step| match &step.step.action {
            Action::Cross { point, .. } => Some(point),
            _ => None,
        });
        match (rays.as_slice(), point) {
            ([first, second], Some(point)) => language.join_cross(first, second, &marked(point)),
            _ => String::new(),
        }
    }

    fn joined_segments(&self, steps: &[NumberedStep<'_>]) -> String {
        self.joined(segments(steps), Language::join_measure)
    }

    fn joined_rates(&self, steps: &[NumberedStep<'_>]) -> String {
        let unknowns = steps.iter().find_map(|step| match &step.step.action {
            Action::Solve { unknowns, .. } => Some(unknowns),
            _ => None,
        });
        let names: Vec<String> = unknowns.into_iter().flatten().map(|(name, _)| rate_symbol(name)).collect();
        self.words.language.join_rates(&segments(steps).join(", "), &names.join(", "))
    }

    fn joined_images(&self, steps: &[NumberedStep<'_>]) -> String {
        // Images alone, each in the passage that makes it.
        let made = |step: &NumberedStep<'_>| {
            let (plan, name) = (step.plan?, step.step.action.image()?);
            let is_image = plan.points.get(name).is_some_and(|point| point.role == PointRole::Image);
            let maker = self.construction.made_by.get(&(step.sheet(), name.to_owned()))?;
            (is_image && std::ptr::eq(&plan.steps[*maker], step.step)).then(|| marked(name))
        };
        let names: Vec<String> = steps.iter().filter_map(made).collect();
        self.words.language.join_images(&names.join(", "))
    }

    /// A sentence with a list, empty for an empty one.
    fn joined(&self, list: Vec<String>, sentence: fn(&Language, &str) -> String) -> String {
        if list.is_empty() { String::new() } else { sentence(self.words.language, &list.join(", ")) }
    }
}

/// The measured segments of some steps, each by its ends.
fn segments(steps: &[NumberedStep<'_>]) -> Vec<String> {
    let measured = steps.iter().filter_map(|step| match &step.step.action {
        Action::Measure { from, to, .. } => Some(pair(from, to)),
        _ => None,
    });
    measured.collect()
}

/// A distance by its two ends, marked for a caption.
fn pair(from: &str, to: &str) -> String {
    format!("{} {}", marked(from), marked(to))
}
