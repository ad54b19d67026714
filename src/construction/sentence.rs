//! Captions of steps, the equations that are said with them, and the vectors of a plan by their symbols.

use super::constructed::Construction;
use super::cut::Special;
use super::markup::{Formula, Known, marked, measured, no_construction, rate_symbol, subscript};
use super::name::{coincident_name, image_name, point_on};
use super::number::Rate;
use super::solution::Solution;
use super::step::{
    Action, Arrow, NumberedStep, Plan, PointRole, RateEquation, Ray, RayOf, Relation, VectorOf, VectorPart,
};
use crate::geometry::{Place, degrees_of};
use crate::mechanism::{BodyId, DrivenSlide, GROUND, Mechanism, PointId, Role, SliderId};
use crate::position::Pose;
use crate::scene::TurnedName;
use crate::sheet::{Order, Sheet};
use crate::words::{Language, NumberStyle, SlidePart, Wording};

/// Writes steps in a language and a notation.
#[derive(Clone, Copy, Debug)]
pub struct Teller<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) pose: &'a Pose,
    pub(super) construction: &'a Construction,
    pub(super) words: &'a Wording,
}

/// A vector between two plan points.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanVector {
    /// The plan points where it begins and where its head is.
    pub ends: [String; 2],
    /// Its symbol in markup, as in `v_{CB}`.
    pub symbol: String,
    /// What it shows.
    pub part: VectorPart,
    /// The plan point with which it is there.
    pub made: String,
    /// The link that it belongs to, where a ray carries it, and no arrow.
    pub link: Option<BodyId>,
}

impl<'a> Teller<'a> {
    /// A teller of the steps of a solved scene.
    #[must_use]
    pub fn new(solution: &'a Solution, words: &'a Wording) -> Self {
        let Solution { mechanism, pose, construction, .. } = solution;
        Self { mechanism, pose, construction, words }
    }

    /// A teller of the steps as figures show them, which may have the velocity plan turned.
    #[must_use]
    pub fn shown(solution: &'a Solution, words: &'a Wording) -> Self {
        Self::of(solution, solution.shown_construction(), words)
    }

    /// A teller of the steps of a construction of the solved scene.
    pub(crate) fn of(solution: &'a Solution, construction: &'a Construction, words: &'a Wording) -> Self {
        Self { construction, ..Self::new(solution, words) }
    }

    /// Whether a hand draws on that sheet.
    pub(crate) fn draws(&self, sheet: Sheet) -> bool {
        self.construction.by_hand.contains(&sheet)
    }

    /// The heading of a sheet; of a turned plan with its angle.
    #[must_use]
    pub fn sheet_name(&self, sheet: Sheet) -> String {
        let name = self.words.language.sheet(sheet);
        match self.turned(sheet) {
            Some(TurnedName::CounterClockwise) => self.words.language.turned_plan(name, "+90"),
            Some(TurnedName::Clockwise) => self.words.language.turned_plan(name, "−90"),
            None => name.to_owned(),
        }
    }

    /// How the plan of a sheet is turned, where it is.
    fn turned(&self, sheet: Sheet) -> Option<TurnedName> {
        self.construction.turned.filter(|_| sheet == Sheet::Velocity)
    }

    /// The caption of a step, one line; names of points between backticks, the rest in markup.
    #[must_use]
    pub fn caption(&self, NumberedStep { action, plan, .. }: &NumberedStep<'_>) -> String {
        let language = self.words.language;
        match action {
            Action::Pole { order, images } => self.pole(*order, images),
            Action::SpecialPoint { special, .. } => self.special_point(self.construction.special(*special)),
            Action::LayOff(arrow) => self.lay_off(arrow).1,
            Action::Ray(ray) => {
                let sentence = match (ray.relation, self.guide_of(ray)) {
                    (Relation::Perpendicular, None) => Language::ray_normal,
                    (Relation::Perpendicular, Some(_)) => Language::ray_normal_to_guide,
                    (Relation::Parallel, None) => Language::ray_parallel_to_line,
                    (Relation::Parallel, Some(_)) => Language::ray_parallel,
                    (Relation::Angle, _) => Language::ray_at_angle,
                };
                sentence(language, &marked(&ray.through), &self.line_of(ray), &marked(&ray.to))
            }
            Action::Cross { point, .. } => language.cross(&marked(point)),
            Action::Divide { point, between: [from, to], points } => {
                let [first, second, third] = points.map(|point| self.mechanism.point_name(point));
                let ratio = [format!("{first}{third}"), format!("{first}{second}")];
                language.divide(&marked(from), &marked(to), &ratio[0], &ratio[1], &marked(point))
            }
            Action::Coincide { point, with, link: GROUND } => language.pitch_at_rest(&marked(point), &marked(with)),
            Action::Coincide { point, with, link } => {
                language.coincide(&self.mechanism.body(*link).name, &marked(point), &marked(with))
            }
            Action::Measure { from, to, .. } => {
                let sentence = if plan.is_some() { Language::measure_segment } else { Language::measure_length };
                sentence(language, &marked(from), &marked(to))
            }
            Action::Solve { equations, unknowns } => {
                let names: Vec<String> = unknowns.iter().map(|u| self.rate(&u.0)).collect();
                let names = names.join(", ");
                match equations.first() {
                    Some(RateEquation::Wheel(_)) if equations.len() > 1 => language.solve_wheel_with_mesh(&names),
                    Some(RateEquation::Wheel(_)) => language.solve_wheel(&names),
                    Some(RateEquation::Rolling(..)) => language.solve_rims(&names),
                    Some(RateEquation::Mesh(Order::Velocity, _)) => language.solve_meshes(&names),
                    Some(RateEquation::Mesh(Order::Acceleration, _)) => language.solve_meshes_accelerated(&names),
                    _ => language.solve(&names),
                }
            }
            Action::NoConstruction(far) => no_construction(self.words, far),
            other => {
                let found = self.caption_of_centers(other).or_else(|| self.caption_of_forces(other));
                found
                    .or_else(|| self.caption_of_lever(other))
                    .or_else(|| self.caption_of_speeds(other))
                    .unwrap_or_default()
            }
        }
    }

    /// The equation that belongs to a step, as `v_{S3} = v_B + v_{S3B}`; empty where there is none.
    #[must_use]
    pub fn formula(&self, &NumberedStep { sheet, plan, action, .. }: &NumberedStep<'_>) -> Formula {
        match action {
            Action::LayOff(arrow) => self.lay_off(arrow).0,
            Action::Ray(ray) => self.ray_equation(ray),
            Action::Measure { from, to, .. } if plan.is_none() => format!("L{}", subscript(&[from, to])).into(),
            Action::Measure { from, to, .. } => measured(sheet, from, to).into(),
            Action::Divide { point, between: [from, to], points } => {
                let [first, second, third] = points.map(|point| self.mechanism.point_name(point));
                let [from, to, point] = [from, to, point].map(|name| marked(name));
                format!("{from} {point} : {from} {to} = {first}{third} : {first}{second}").into()
            }
            Action::Pole { .. }
            | Action::SpecialPoint { .. }
            | Action::Cross { .. }
            | Action::Coincide { .. }
            | Action::Solve { .. }
            | Action::NoConstruction(_) => Formula::default(),
            other => {
                let found = self.formula_of_centers(other).or_else(|| self.formula_of_forces(other));
                found
                    .or_else(|| self.formula_of_lever(other))
                    .or_else(|| self.formula_of_speeds(other))
                    .unwrap_or_default()
            }
        }
    }

    /// The line of the mechanism that gives a ray its direction, by name.
    pub(crate) fn line_of(&self, ray: &Ray) -> String {
        let name = |point: PointId| self.mechanism.point_name(point);
        let (special, side) = match ray.of {
            RayOf::Leg(special, side) => (self.construction.special(special), side),
            RayOf::Arm { from, to, other, .. } if ray.relation == Relation::Angle => {
                return format!("∠{}{}{}", name(other), name(from), name(to));
            }
            RayOf::Arm { from, to, .. } => return format!("{}{}", name(from), name(to)),
        };
        let cut = &special.cuts[side];
        match cut.guide() {
            Some(slider) => self.words.language.guide_of(&self.slider_name(slider)),
            None => cut.name(self.words, self.mechanism, &special.name),
        }
    }

    /// The slider on whose guide a ray's direction depends, if it is a guide's.
    fn guide_of(&self, ray: &Ray) -> Option<SliderId> {
        match ray.of {
            RayOf::Leg(special, side) => self.construction.special(special).cuts[side].guide(),
            RayOf::Arm { .. } => None,
        }
    }

    /// The name of a slider in the language.
    pub(super) fn slider_name(&self, slider: SliderId) -> String {
        self.mechanism.slider_in_words(slider, self.words)
    }

    /// The symbol of a part of the motion along a guide.
    pub(super) fn slide(&self, order: Order, part: SlidePart, slider: SliderId) -> String {
        let Wording { notation, .. } = self.words;
        let ground = &self.mechanism.body(GROUND).name;
        let shown = |name: &str| if name == ground { self.words.ground().to_owned() } else { name.to_owned() };
        notation.slide(order, part, &self.mechanism.slider_shown(slider, notation, &shown)).markup()
    }

    /// The symbol of a rate by its quantity name.
    pub(crate) fn rate(&self, name: &str) -> String {
        let slides = Order::ALL.into_iter().flat_map(|order| self.mechanism.slider_ids().map(move |id| (order, id)));
        let mut slides = slides.filter(|&(order, id)| Rate::Slide(order, id).name(self.mechanism) == name);
        slides.next().map_or_else(|| rate_symbol(name), |(order, id)| self.slide(order, SlidePart::Relative, id))
    }

    /// The name of a point in sentences: `F_0` for `F_ground`.
    fn point_in_words(&self, name: &str) -> String {
        let at = name.strip_suffix(&self.mechanism.body(GROUND).name).filter(|at| at.ends_with('_'));
        at.map_or_else(|| name.to_owned(), |at| format!("{at}{}", self.words.ground()))
    }

    fn pole(&self, order: Order, images: &[String]) -> String {
        let (pole, scale) = (self.words.notation.pole(order), order.sheet().facts().scale_symbol);
        if images.is_empty() {
            return self.words.language.choose_pole(pole, scale);
        }
        let images: Vec<String> = images.iter().map(|i| marked(i)).collect();
        self.words.language.choose_pole_with(pole, scale, &images.join(", "))
    }

    fn special_point(&self, special: &Special) -> String {
        let (name, language) = (marked(&special.name), self.words.language);
        let link = &self.mechanism.body(special.link).name;
        let cut = |side: usize| special.cuts[side].name(self.words, self.mechanism, &special.name);
        match special.place {
            Place::At(_) => language.special_point(&name, link, &cut(0), &cut(1)),
            Place::AtInfinity(direction) => {
                let direction = self.words.write(degrees_of(direction), NumberStyle::decimals(2));
                language.special_point_at_infinity(&name, link, &direction, &cut(0), &cut(1))
            }
        }
    }

    /// Equation and caption of a vector that is laid off.
    pub(super) fn lay_off(&self, arrow: &Arrow) -> (Formula, String) {
        let Arrow { order, from, to, of } = arrow;
        match of {
            VectorOf::Point(body, point) => self.known_vector(*order, *body, *point),
            VectorOf::Normal(special, side) => self.normal_part(self.construction.special(*special), *side, from, to),
            VectorOf::Relative { link, from, to, part } => self.relative(*link, [from, to], *part),
            VectorOf::Sliding(slider, under) => {
                let name = self.slider_name(*slider);
                let at = self.mechanism.point_name(self.mechanism.slider(*slider).at);
                let under = marked(&self.point_in_words(under));
                let sentence = match self.turned(Sheet::Velocity) {
                    Some(_) => Language::lay_off_sliding_velocity_turned,
                    None => Language::lay_off_sliding_velocity,
                };
                let caption = sentence(self.words.language, &name, &under, &marked(at));
                (self.slide(Order::Velocity, SlidePart::Relative, *slider).into(), caption)
            }
            VectorOf::Passed(slide, part) => self.passed_part(slide, *part, arrow),
        }
    }

    /// Equation and caption of the motion of one point of a link relative to another.
    fn relative(&self, link: BodyId, [from, to]: [&str; 2], part: VectorPart) -> (Formula, String) {
        let (language, notation) = (self.words.language, self.words.notation);
        let link = &self.mechanism.body(link).name;
        let (pair, line) = (subscript(&[to, from]), format!("{from}{to}"));
        let (to, from) = (marked(to), marked(from));
        let (equation, caption) = match part {
            VectorPart::Normal => (
                format!("a^{}{pair} = ω_{link}^2 L{pair}", notation.normal),
                language.lay_off_relative_normal(&to, &from, &line),
            ),
            VectorPart::Tangential => (
                format!("a^{}{pair} = α_{link} L{pair}", notation.tangential),
                language.lay_off_relative_tangential(link, &to, &from, &line),
            ),
            _ => {
                let is_pitch = self.construction.is_pitch_point(to.trim_matches('`'));
                let sentence = match self.turned(Sheet::Velocity) {
                    None if is_pitch => Language::lay_off_pitch,
                    Some(_) if is_pitch => Language::lay_off_pitch_turned,
                    Some(_) => Language::lay_off_relative_turned,
                    None => Language::lay_off_relative,
                };
                (format!("v{pair} = ω_{link} L{pair}"), sentence(language, link, &to, &from, &line))
            }
        };
        (equation.into(), caption)
    }

    /// Equation and caption of the known velocity or acceleration of body `base` at a point.
    fn known_vector(&self, order: Order, base: BodyId, point: PointId) -> (Formula, String) {
        let (mechanism, language, notation) = (self.mechanism, self.words.language, self.words.notation);
        let body = mechanism.body(base);
        let under = mechanism.point_name(point);
        let name = &point_on(mechanism, base, point);
        let letter = order.vector();
        match &body.role {
            Role::Driver { pivot, omega, alpha, .. } => {
                let (k, link) = (mechanism.point_name(*pivot), &body.name);
                let (arm, line) = (format!("L{}", subscript(&[k, name])), format!("{k}{name}"));
                let (end, pair) = (subscript(&[name]), subscript(&[name, k]));
                let (n, t) = (notation.normal, notation.tangential);
                match order {
                    Order::Acceleration if *alpha == 0.0 => (
                        format!("a{end} = a^{n}{pair} = ω_{link}^2 {arm}").into(),
                        language.lay_off_normal_acceleration(name, k, link),
                    ),
                    Order::Acceleration => (
                        format!(
                            "a{end} = a^{n}{pair} + a^{t}{pair}, a^{n}{pair} = ω_{link}^2 {arm}, a^{t}{pair} = α_{link} {arm}"
                        )
                        .into(),
                        language.lay_off_whole_acceleration(name, k, &line),
                    ),
                    Order::Velocity => {
                        let caption = match self.turned(Sheet::Velocity) {
                            // ω × r, turned as ω turns, points from the end of r to its start.
                            Some(sense) => {
                                let is_alike = (sense == TurnedName::CounterClockwise) == (*omega > 0.0);
                                let [from, to] = if is_alike { [name.as_str(), k] } else { [k, name.as_str()] };
                                language.lay_off_velocity_turned(name, &line, from, to)
                            }
                            None => language.lay_off_velocity(name, &line, link),
                        };
                        (format!("v{end} = ω_{link} {arm}").into(), caption)
                    }
                }
            }
            Role::Carrier { .. } => {
                let vector = format!("{letter}_{name}");
                let caption = match self.turned(order.sheet()) {
                    Some(_) => language.lay_off_given_turned(&vector),
                    None => language.lay_off_given(&vector),
                };
                let mut formula = Formula::default();
                formula.vector(vector, Known::Entirely, None);
                formula.words(language.given());
                (formula, caption)
            }
            _ => (
                format!("{letter}{}", subscript(&[under, &body.name])).into(),
                language.lay_off_point_under(&body.name, &marked(under)),
            ),
        }
    }

    /// Equation and caption of a slider's relative velocity, relative acceleration or Coriolis acceleration.
    ///
    /// A chain may pass the slider from the sliding link to the guide: then the vector is laid off backwards, so that
    /// its head is where the chain has come from.
    fn passed_part(&self, slide: &DrivenSlide, part: VectorPart, arrow: &Arrow) -> (Formula, String) {
        let mechanism = self.mechanism;
        let name = self.slider_name(slide.slider);
        let on = &mechanism.body(mechanism.slider(slide.slider).on).name;
        let language = self.words.language;
        let symbol = |order, part| self.slide(order, part, slide.slider);
        let equation = match part {
            VectorPart::Coriolis => {
                let coriolis = symbol(Order::Acceleration, SlidePart::Coriolis);
                format!("{coriolis} = 2 ω_{on} {}", symbol(Order::Velocity, SlidePart::Relative))
            }
            _ => symbol(arrow.order, SlidePart::Relative),
        };
        let [from, to] = arrow.ends().map(marked);
        let caption = match (part, arrow.is_backwards()) {
            (VectorPart::Coriolis, false) => language.lay_off_coriolis(&name, on, &from, &to),
            (VectorPart::Coriolis, true) => language.lay_off_coriolis_backwards(&name, on, &from, &to),
            (_, is_backwards) => {
                let sentence = match (arrow.order, self.turned(arrow.order.sheet()), is_backwards) {
                    (Order::Acceleration, _, false) => Language::lay_off_sliding_acceleration,
                    (Order::Acceleration, _, true) => Language::lay_off_sliding_acceleration_backwards,
                    (Order::Velocity, None, false) => Language::lay_off_sliding_velocity,
                    (Order::Velocity, None, true) => Language::lay_off_sliding_velocity_backwards,
                    (Order::Velocity, Some(_), false) => Language::lay_off_sliding_velocity_turned,
                    (Order::Velocity, Some(_), true) => Language::lay_off_sliding_velocity_turned_backwards,
                };
                sentence(language, &name, &from, &to)
            }
        };
        (equation.into(), caption)
    }

    /// The vectors of a plan, first the whole ones; without those that lead to special points or follow from them.
    #[must_use]
    pub fn vectors(&self, plan: &Plan) -> Vec<PlanVector> {
        let mut vectors = self.whole_vectors(plan);
        vectors.extend(self.construction.steps[plan.sheet()].iter().filter_map(|action| match action {
            Action::LayOff(arrow) => self.laid_off_vector(arrow),
            Action::Ray(ray) => match ray.of {
                RayOf::Leg(special, _) if !self.construction.special(special).is_assur => self.vector_on(ray),
                _ => None,
            },
            _ => None,
        }));
        vectors
    }

    /// The part of a motion that a step lays off; none for whole vectors, and for what leads to special points.
    fn laid_off_vector(&self, arrow: &Arrow) -> Option<PlanVector> {
        match arrow.of {
            VectorOf::Point(..) => return None,
            VectorOf::Normal(special, _) if self.construction.special(special).is_assur => return None,
            _ => {}
        }
        // Its equation begins with it.
        let formula = self.lay_off(arrow).0;
        let term = formula.terms.first()?;
        Some(PlanVector {
            ends: arrow.ends().map(str::to_owned),
            symbol: term.markup.split(" = ").next().unwrap_or_default().to_owned(),
            part: term.part.unwrap_or(arrow.part()),
            made: arrow.to.clone(),
            link: None,
        })
    }

    /// The vector that a ray carries, once the point on it is there: all of its equation that is known in direction
    /// alone. None where the ray has no equation.
    #[must_use]
    pub fn vector_on(&self, ray: &Ray) -> Option<PlanVector> {
        let formula = self.ray_equation(ray);
        let first = formula.terms.iter().position(|term| term.known == Known::Direction)?;
        let (link, is_backwards) = match ray.of {
            RayOf::Leg(special, side) => {
                let special = self.construction.special(special);
                let cut = &special.cuts[side];
                // What turns has the direction of the chain, what slides alone that of the slider.
                let turns = || cut.terms.iter().any(|term| self.turning(special, term).is_some());
                (cut.carrier, cut.slide().is_some_and(|slide| slide.sign < 0.0) && !turns())
            }
            RayOf::Arm { link, .. } => (link, false),
        };
        let [from, to] = [&ray.through, &ray.to].map(Clone::clone);
        Some(PlanVector {
            ends: if is_backwards { [to, from] } else { [from, to] },
            symbol: formula.terms[first..].iter().map(|term| term.markup.as_str()).collect(),
            part: formula.terms[first].part.unwrap_or(VectorPart::Relative),
            made: ray.to.clone(),
            link: Some(link),
        })
    }

    /// The velocities or accelerations of all points with images, and of the points under sliders.
    fn whole_vectors(&self, plan: &Plan) -> Vec<PlanVector> {
        let letter = plan.order.vector();
        let is_image = |name: &str| {
            let role = plan.points.get(name).map(|point| point.role);
            matches!(role, Some(PointRole::Image | PointRole::Known))
        };
        let mechanism = self.mechanism;
        let under = mechanism.sliders.iter();
        let under = under.map(|s| coincident_name(mechanism.point_name(s.at), &mechanism.body(s.on).name));
        let names = mechanism.points.iter().cloned().chain(under).filter(|name| is_image(&image_name(name)));
        let vector = |name: String| PlanVector {
            ends: [plan.order.pole().to_owned(), image_name(&name)],
            symbol: format!("{letter}_{{{name}}}"),
            part: VectorPart::Whole,
            made: image_name(&name),
            link: None,
        };
        names.map(vector).collect()
    }
}
