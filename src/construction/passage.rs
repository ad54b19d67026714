//! Steps that a lecturer shows together: each passage reaches one aim of the construction.

use super::arrow::{Arrow, Ray, RayOf, Relation, VectorOf};
use super::constructed::Construction;
use super::kennedy::CurvatureStep;
use super::lever::LeverStep;
use super::markup::marked;
use super::operation::StepId;
use super::plan::PointRole;
use super::polygon::ForceStep;
use super::sentence::Teller;
use super::speeds::SpeedStep;
use super::step::{Action, NumberedStep};
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
    /// The permanent instant centres.
    PermanentCenters,
    /// An instant centre, where two lines cross.
    Center,
    /// A velocity by centres.
    CenterVelocity,
    /// A sum of moments, or the force of a drive along its guide.
    Moments,
    /// A force polygon.
    Polygon,
    /// What a drive needs, by its lever.
    Lever,
    /// The lines of velocities along a line of centres.
    VelocityLines,
    /// The angular velocities that parallels to them cut off.
    SpeedFan,
    /// The centre of curvature of a path.
    Curvature,
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
        let mut polygon = None;
        for (index, step) in steps.iter().enumerate() {
            let last = passages.last().map(|passage| passage.aim);
            let aim = aim(&steps[index..], last);
            let group = match step.action {
                Action::SpecialPoint { special, .. } => Some(self.special(*special).group),
                _ => present.and_then(|(_, group, _)| group),
            };
            let joins = present.is_some_and(|(sheet, own, is_reached)| {
                sheet == step.sheet
                    && last == Some(aim)
                    && match aim {
                        Aim::SpecialPoints => own == group,
                        Aim::Crossing => !is_reached || step.action.is_measured(),
                        Aim::Start | Aim::Images | Aim::VelocityLines | Aim::SpeedFan => true,
                        Aim::Rates | Aim::Center | Aim::CenterVelocity | Aim::Curvature | Aim::Lever => !is_reached,
                        Aim::Polygon => step.action.polygon() == polygon,
                        Aim::Nothing | Aim::PermanentCenters | Aim::Moments => false,
                    }
            });
            let was_reached = joins && present.is_some_and(|(.., is_reached)| is_reached);
            let reached = matches!(
                step.action,
                Action::Cross { .. }
                    | Action::Solve { .. }
                    | Action::Center(_)
                    | Action::VelocityByCenters(_)
                    | Action::Lever(LeverStep::Effort(_))
                    | Action::Curvature { step: CurvatureStep::Center | CurvatureStep::InflectionPole, .. }
            );
            polygon = step.action.polygon();
            present = Some((step.sheet, group, was_reached || reached));
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
    let actions = || steps.iter().map(|step| step.action);
    let Some(first) = steps.first() else { return Aim::Nothing };
    match first.action {
        Action::SpecialPoint { .. } | Action::Measure { .. } if first.plan.is_none() => Aim::SpecialPoints,
        Action::Pole { .. } => Aim::Start,
        Action::Solve { .. } => Aim::Rates,
        Action::NoConstruction(_) | Action::CentersByRates(_) => Aim::Nothing,
        Action::PermanentCenters => Aim::PermanentCenters,
        Action::LeaveOut { .. } | Action::CenterLine { .. } | Action::Center(_) => Aim::Center,
        Action::RateByCenters { .. } | Action::RateBySlide { .. } | Action::VelocityByCenters(_) => Aim::CenterVelocity,
        Action::Curvature { .. } => Aim::Curvature,
        Action::Lever(_) => Aim::Lever,
        Action::Speeds(SpeedStep::Pole | SpeedStep::Ray(_)) => Aim::SpeedFan,
        Action::Speeds(_) => Aim::VelocityLines,
        Action::Force(ForceStep::ByNumbers(_)) => Aim::Nothing,
        Action::Force(_) => {
            if first.action.polygon().is_some() {
                Aim::Polygon
            } else {
                Aim::Moments
            }
        }
        Action::Divide { .. } | Action::Coincide { .. } => Aim::Images,
        Action::Measure { .. } => {
            let after = actions().find(|action| !action.is_measured());
            if matches!(after, Some(Action::Solve { .. })) { Aim::Rates } else { Aim::Crossing }
        }
        // Of rays.
        Action::Cross { .. } => last.filter(|last| *last == Aim::Images).unwrap_or(Aim::Crossing),
        Action::LayOff(Arrow { of: VectorOf::Point(..), .. }) if last == Some(Aim::Start) => Aim::Start,
        _ => {
            let leads_to_ray = |action: &Action| match action {
                Action::LayOff(Arrow { of, .. }) => !matches!(of, VectorOf::Relative { .. } | VectorOf::Sliding(..)),
                _ => false,
            };
            match actions().find(|action| !leads_to_ray(action)) {
                Some(Action::Ray(Ray { of: RayOf::Leg(..), .. })) => Aim::Crossing,
                _ => Aim::Images,
            }
        }
    }
}

/// What the steps of a passage do, by the names of points, lines and rates.
#[derive(Default)]
struct Told {
    special: Vec<String>,
    lengths: Vec<String>,
    vectors: Vec<String>,
    rays: Vec<String>,
    crossing: String,
    segments: Vec<String>,
    unknowns: Vec<String>,
}

impl Teller<'_> {
    /// The caption of a passage: the sentences of its steps, shortened; names between backticks, as in
    /// [`caption`](Teller::caption).
    #[must_use]
    pub fn passage_caption(&self, passage: &Passage) -> String {
        let language = self.words.language;
        let steps: Vec<NumberedStep<'_>> = self.construction.steps_of(passage).collect();
        let first = match steps.as_slice() {
            [] => return String::new(),
            [step] if passage.aim != Aim::Polygon => return self.caption(step),
            [first, ..] => first,
        };
        let told = self.told(&steps);
        // A sentence with a list, empty for an empty one.
        let joined = |list: &[String], sentence: fn(&Language, &str) -> String| match list {
            [] => String::new(),
            _ => sentence(language, &list.join(", ")),
        };
        let measured = |list| joined(list, Language::join_measure);
        let laid_off = joined(&told.vectors, Language::join_lay_off);
        let sentences = match passage.aim {
            Aim::SpecialPoints if told.special.len() == 1 => vec![self.caption(first), measured(&told.lengths)],
            Aim::SpecialPoints => {
                vec![language.join_special_points(&told.special.join(", ")), measured(&told.lengths)]
            }
            Aim::Start => vec![self.caption(first), laid_off],
            Aim::Crossing => {
                let crossing = match told.rays.as_slice() {
                    [first, second] if !told.crossing.is_empty() => language.join_cross(first, second, &told.crossing),
                    _ => String::new(),
                };
                vec![laid_off, crossing, measured(&told.segments)]
            }
            Aim::Rates => vec![language.join_rates(&told.segments.join(", "), &told.unknowns.join(", "))],
            Aim::Images => {
                let images: Vec<String> = steps.iter().filter_map(|step| self.image_made(step)).map(marked).collect();
                // A motion along a guide may lie between two images that are there.
                vec![if images.is_empty() { laid_off } else { joined(&images, Language::join_images) }]
            }
            // Its lines are named in the caption of their crossing.
            Aim::Center => {
                let lines = |step: &&NumberedStep<'_>| !matches!(step.action, Action::CenterLine { .. });
                steps.iter().filter(lines).map(|step| self.caption(step)).collect()
            }
            Aim::Polygon => {
                let actions: Vec<&Action> = steps.iter().map(|step| step.action).collect();
                self.polygon_caption(&actions).into_iter().collect()
            }
            // Its forces are seen.
            Aim::Lever => {
                let is_told = |step: &&NumberedStep<'_>| !matches!(step.action, Action::Lever(LeverStep::Arm(..)));
                steps.iter().filter(is_told).map(|step| self.caption(step)).collect()
            }
            // The others do the same with further links.
            Aim::VelocityLines | Aim::SpeedFan => steps.iter().take(2).map(|step| self.caption(step)).collect(),
            Aim::Nothing | Aim::PermanentCenters | Aim::CenterVelocity | Aim::Curvature | Aim::Moments => {
                steps.iter().map(|step| self.caption(step)).collect()
            }
        };
        let said: Vec<String> = sentences.into_iter().filter(|sentence| !sentence.is_empty()).collect();
        said.join(" ")
    }

    fn told(&self, steps: &[NumberedStep<'_>]) -> Told {
        let pair = |from: &str, to: &str| format!("{} {}", marked(from), marked(to));
        let mut told = Told::default();
        for step in steps {
            match step.action {
                Action::SpecialPoint { point, .. } => told.special.push(marked(point)),
                Action::LayOff(arrow) => told.vectors.push(pair(&arrow.from, &arrow.to)),
                Action::Ray(ray) => {
                    let sentence = match ray.relation {
                        Relation::Perpendicular => Language::join_normal,
                        Relation::Parallel => Language::join_parallel,
                        Relation::Angle => Language::join_at_angle,
                    };
                    told.rays.push(sentence(self.words.language, &marked(&ray.through), &self.line_of(ray)));
                }
                Action::Cross { point, .. } => told.crossing = marked(point),
                Action::Measure { from, to, .. } => {
                    let list = if step.plan.is_some() { &mut told.segments } else { &mut told.lengths };
                    list.push(pair(from, to));
                }
                Action::Solve { unknowns, .. } => {
                    told.unknowns.extend(unknowns.iter().map(|(name, _)| self.rate(name)))
                }
                _ => {}
            }
        }
        told
    }

    /// The image that a step makes first, perhaps one from which a ray of a later group starts; not the end of a part of
    /// a vector that leads there.
    fn image_made<'a>(&self, step: &NumberedStep<'a>) -> Option<&'a str> {
        let (plan, name) = (step.plan?, step.action.image()?);
        let maker = StepId { sheet: step.sheet, index: *plan.makers.get(name)? };
        let is_image = matches!(plan.points.get(name)?.role, PointRole::Image | PointRole::Known);
        (is_image && self.construction.step_number(maker) == step.number).then_some(name)
    }
}
