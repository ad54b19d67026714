//! Captions and equations of steps. Names of points stand between backticks; `_{…}` is low, `^{…}` high.

use super::construct::{Construction, NumberedStep};
use super::cut::{CutLine, Special, Term};
use super::formula::{Formula, Known, NamedPart};
use super::name::{image_name, point_on};
use super::solution::Solution;
use super::step::{Action, Added, Arrow, LegEquation, Plan, Ray, RayOf, Relation, RelativePart, VectorOf};
use crate::geometry::{Place, Vector, degrees_of, quarter_turn};
use crate::mechanism::{BodyId, DrivenSlide, GROUND, Mechanism, PointId, Role};
use crate::position::Pose;
use crate::sheet::Sheet;
use crate::words::{Language, NumberStyle, Wording};

/// A point's name, marked for a caption.
pub(super) fn marked(name: &str) -> String {
    format!("`{name}`")
}

/// A caption or an equation as plain text: names as they are, subscripts after `_`.
#[must_use]
pub fn plain_text(markup: &str) -> String {
    let mut text = String::with_capacity(markup.len());
    push_plain(&mut text, markup);
    text
}

/// A caption or an equation as plain text, with the names of plan points in the notation of `words`.
#[must_use]
pub fn shown_text(markup: &str, plan: Option<&Plan>, words: &Wording) -> String {
    let mut text = String::with_capacity(markup.len());
    for (index, piece) in markup.split('`').enumerate() {
        match (index % 2, plan) {
            (1, Some(plan)) => {
                let shown = plan.shown(piece, piece.to_owned(), words.notation);
                push_plain(&mut text, &shown);
            }
            _ => push_plain(&mut text, piece),
        }
    }
    text
}

/// Adds markup without braces and backticks; `^2` becomes `²`.
fn push_plain(text: &mut String, markup: &str) {
    let mut letters = markup.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '{' | '}' | '`' => {}
            '^' if letters.next_if_eq(&'2').is_some() => text.push('²'),
            other => text.push(other),
        }
    }
}

/// A subscript of several names, as in `_{S3B}`.
fn subscript(names: &[&str]) -> String {
    format!("_{{{}}}", names.concat())
}

/// The symbol of a rate by its quantity name, in markup: `ω_{2}` for `omega(2)`.
#[must_use]
pub fn rate_symbol(name: &str) -> String {
    let turning = [("omega(", "ω"), ("alpha(", "α")];
    let found = turning.into_iter().find_map(|(head, letter)| {
        let link = name.strip_prefix(head)?.strip_suffix(')')?;
        Some(format!("{letter}_{{{link}}}"))
    });
    found.unwrap_or_else(|| name.to_owned())
}

/// The sentence that there is no construction; `far` are the names of special points at infinity.
#[must_use]
pub fn no_construction(words: &Wording, far: &[String]) -> String {
    let language = words.language;
    if far.is_empty() {
        return language.no_construction().to_owned();
    }
    let names: Vec<String> = far.iter().map(|name| marked(name)).collect();
    language.no_construction_far(&names.join(language.and()))
}

/// Writes steps in a language and a notation.
#[derive(Clone, Copy, Debug)]
pub struct Teller<'a> {
    pub(super) mechanism: &'a Mechanism,
    pose: &'a Pose,
    pub(super) construction: &'a Construction,
    pub(super) words: &'a Wording,
}

impl<'a> Teller<'a> {
    /// A teller of the steps of a solved scene.
    #[must_use]
    pub fn new(solution: &'a Solution, words: &'a Wording) -> Self {
        let Solution { mechanism, pose, construction, .. } = solution;
        Self { mechanism, pose, construction, words }
    }

    /// The caption of a step, one line; names of points between backticks, the rest in markup.
    #[must_use]
    pub fn caption(&self, NumberedStep { plan, step, .. }: &NumberedStep<'_>) -> String {
        let language = self.words.language;
        match &step.action {
            Action::Pole { images } => self.pole(plan.map_or(Sheet::Velocity, |plan| plan.kind), images),
            Action::SpecialPoint { special, .. } => self.special_point(self.construction.special(*special)),
            Action::MeasureLength { from, to, .. } => language.measure_length(&marked(from), &marked(to)),
            Action::LayOff(arrow) => self.lay_off(plan.map_or(Sheet::Velocity, |plan| plan.kind), arrow).1,
            Action::Ray(ray) => {
                let sentence = match ray.relation {
                    Relation::Perpendicular => Language::ray_normal,
                    Relation::Parallel => Language::ray_parallel,
                    Relation::Angle => Language::ray_at_angle,
                };
                sentence(language, &marked(&ray.through), &self.line_of(ray), &marked(&ray.to))
            }
            Action::Cross { point, .. } => language.cross(&marked(point)),
            Action::Divide { point, between: [from, to], points } => {
                let [first, second, third] = points.map(|point| self.mechanism.point_name(point));
                let ratio = [format!("{first}{third}"), format!("{first}{second}")];
                language.divide(&marked(from), &marked(to), &ratio[0], &ratio[1], &marked(point))
            }
            Action::Coincide { point, with, link } => {
                language.coincide(&self.mechanism.body(*link).name, &marked(point), &marked(with))
            }
            Action::Measure { from, to, .. } => language.measure_segment(&marked(from), &marked(to)),
            Action::Solve { unknowns, .. } => {
                let names: Vec<String> = unknowns.iter().map(|u| rate_symbol(&u.0)).collect();
                language.solve(&names.join(", "))
            }
            Action::NoConstruction { far } => no_construction(self.words, far),
        }
    }

    /// The equation that belongs to a step, as `v_{S3} = v_B + v_{S3B}`; empty where there is none.
    #[must_use]
    pub fn formula(&self, NumberedStep { plan, step, .. }: &NumberedStep<'_>) -> Formula {
        let kind = plan.map_or(Sheet::Velocity, |plan| plan.kind);
        match &step.action {
            Action::MeasureLength { from, to, .. } => format!("L{}", subscript(&[from, to])).into(),
            Action::LayOff(arrow) => self.lay_off(kind, arrow).0,
            Action::Ray(ray) => self.ray_equation(kind, ray),
            Action::Measure { from, to, .. } => measured(kind, from, to).into(),
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
            | Action::NoConstruction { .. } => Formula::default(),
        }
    }

    /// The line of the mechanism that gives a ray its direction, by name.
    #[must_use]
    pub fn line_of(&self, ray: &Ray) -> String {
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
            Some(slider) => self.words.language.guide_of(&self.mechanism.slider_name(slider)),
            None => cut.name(self.words, self.mechanism, &special.name),
        }
    }

    fn pole(&self, kind: Sheet, images: &[String]) -> String {
        let (pole, scale) = (self.words.notation.pole(kind), kind.scale_symbol());
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
    pub(super) fn lay_off(&self, kind: Sheet, arrow: &Arrow) -> (Formula, String) {
        let Arrow { from, to, of } = arrow;
        match of {
            VectorOf::Point(body, point) => self.known_vector(*body, *point, kind),
            VectorOf::Normal(special, side) => self.normal_part(self.construction.special(*special), *side, from, to),
            VectorOf::Relative { link, from, to, part } => self.relative(*link, [from, to], *part),
            VectorOf::Sliding(slider, under) => {
                let name = self.mechanism.slider_name(*slider);
                let at = self.mechanism.point_name(self.mechanism.slider(*slider).at);
                let (language, notation) = (self.words.language, self.words.notation);
                let caption = language.lay_off_sliding_velocity(&name, &marked(under), &marked(at));
                (format!("v_{}({name})", notation.relative).into(), caption)
            }
            VectorOf::Passed(slide, added) => self.passed_part(slide, *added, arrow),
        }
    }

    /// Equation and caption of the motion of one point of a link relative to another.
    fn relative(&self, link: BodyId, [from, to]: [&str; 2], part: RelativePart) -> (Formula, String) {
        let (language, notation) = (self.words.language, self.words.notation);
        let link = &self.mechanism.body(link).name;
        let (pair, line) = (subscript(&[to, from]), format!("{from}{to}"));
        let (to, from) = (marked(to), marked(from));
        let (equation, caption) = match part {
            RelativePart::Velocity => {
                (format!("v{pair} = ω_{link} L{pair}"), language.lay_off_relative(link, &to, &from, &line))
            }
            RelativePart::Normal => (
                format!("a^{}{pair} = ω_{link}^2 L{pair}", notation.normal),
                language.lay_off_relative_normal(&to, &from, &line),
            ),
            RelativePart::Tangential => (
                format!("a^{}{pair} = α_{link} L{pair}", notation.tangential),
                language.lay_off_relative_tangential(link, &to, &from, &line),
            ),
        };
        (equation.into(), caption)
    }

    /// Equation and caption of the known velocity or acceleration of body `base` at a point.
    fn known_vector(&self, base: BodyId, point: PointId, kind: Sheet) -> (Formula, String) {
        let (mechanism, language, notation) = (self.mechanism, self.words.language, self.words.notation);
        let body = mechanism.body(base);
        let under = mechanism.point_name(point);
        let name = &point_on(mechanism, base, point);
        let letter = kind.vector();
        match &body.role {
            Role::Driver { pivot, alpha, .. } => {
                let (k, link) = (mechanism.point_name(*pivot), &body.name);
                let (arm, line) = (format!("L{}", subscript(&[k, name])), format!("{k}{name}"));
                let (end, pair) = (subscript(&[name]), subscript(&[name, k]));
                let (n, t) = (notation.normal, notation.tangential);
                match kind {
                    Sheet::Acceleration if *alpha == 0.0 => (
                        format!("a{end} = a^{n}{pair} = ω_{link}^2 {arm}").into(),
                        language.lay_off_normal_acceleration(name, k, link),
                    ),
                    Sheet::Acceleration => (
                        format!(
                            "a{end} = a^{n}{pair} + a^{t}{pair}, a^{n}{pair} = ω_{link}^2 {arm}, a^{t}{pair} = α_{link} {arm}"
                        )
                        .into(),
                        language.lay_off_whole_acceleration(name, k, &line),
                    ),
                    _ => (
                        format!("v{end} = ω_{link} {arm}").into(),
                        language.lay_off_velocity(name, &line, link),
                    ),
                }
            }
            Role::Carrier { .. } => {
                let vector = format!("{letter}_{name}");
                let caption = language.lay_off_given(&vector);
                (self.given_vector(vector), caption)
            }
            _ => (
                format!("{letter}{}", subscript(&[under, &body.name])).into(),
                language.lay_off_point_under(&body.name, &marked(under)),
            ),
        }
    }

    /// The formula of a given vector: its symbol and the word for "given".
    fn given_vector(&self, vector: String) -> Formula {
        let mut formula = Formula::default();
        formula.vector(vector, Known::Entirely, None);
        formula.words(self.words.language.given());
        formula
    }

    /// The vector equation behind a ray: motion of the sought point relative to the leg's start.
    pub(super) fn ray_equation(&self, kind: Sheet, ray: &Ray) -> Formula {
        let (special, side) = match ray.of {
            RayOf::Leg(special, side) => (self.construction.special(special), side),
            RayOf::Arm { link, from, to, .. } => return self.arm_equation(kind, link, [from, to]),
        };
        let cut = &special.cuts[side];
        let start = cut.start().map(|point| point_on(self.mechanism, cut.leg.base, point)).unwrap_or_default();
        let mut formula = match kind {
            Sheet::Acceleration => self.relative_acceleration(special, cut, &start),
            _ => self.leg_velocity(special, cut, &start),
        };
        // A point of the ground under a slider is at rest: it is left out, with a plus behind it.
        let ground = self.mechanism.body(GROUND);
        let is_under = cut.leg.base == GROUND && cut.start().is_some_and(|start| !ground.points.contains(&start));
        if is_under && formula.terms.len() > 3 {
            let end = if formula.terms[3].markup == " + " { 4 } else { 3 };
            formula.terms.drain(2..end);
        }
        formula
    }

    /// The vector equation behind a ray for the image of a further point of a link.
    fn arm_equation(&self, kind: Sheet, link: BodyId, ends: [PointId; 2]) -> Formula {
        let [from, to] = ends.map(|point| point_on(self.mechanism, link, point));
        match kind {
            Sheet::Acceleration => Formula::default(),
            _ => self.relative_velocity(&to, &from),
        }
    }

    /// The vector equation of the velocity of one point by that of another of the same link.
    fn relative_velocity(&self, to: &str, from: &str) -> Formula {
        let mut formula = Formula::default();
        formula.vector(format!("v{}", subscript(&[to])), Known::Nothing, None);
        formula.sign(" = ");
        formula.vector(format!("v{}", subscript(&[from])), Known::Entirely, None);
        formula.sign(" + ");
        formula.vector(format!("v{}", subscript(&[to, from])), Known::Direction, None);
        formula
    }

    /// The vector equation behind a velocity ray: what driven sliders on the way add, then the velocity along the ray,
    /// which is a sliding velocity where nothing else moves.
    fn leg_velocity(&self, point: &Special, cut: &CutLine, start: &str) -> Formula {
        let mut formula = self.relative_velocity(&point.name, start);
        let along = formula.terms.split_off(formula.terms.len() - 2);
        let r = self.words.notation.relative;
        let sliding = |slide: &DrivenSlide| format!("v_{r}({})", self.mechanism.slider_name(slide.slider));
        for slide in &cut.slides {
            formula.sign(&format!(" {} ", plus_or_minus(slide)));
            formula.vector(sliding(slide), Known::Entirely, Some(NamedPart::Sliding));
        }
        let turns = cut.terms.iter().any(|term| self.turning(point, term).is_some());
        match cut.slide(self.mechanism).filter(|_| !turns) {
            Some(slide) => {
                formula.sign(&format!(" {} ", plus_or_minus(&slide)));
                formula.vector(sliding(&slide), Known::Direction, Some(NamedPart::Sliding));
            }
            None => formula.terms.extend(along),
        }
        formula
    }

    /// The vector equation behind an acceleration ray: what the sliders on the way add, normal and tangential part.
    /// Parts that are zero in every position are left out.
    fn relative_acceleration(&self, point: &Special, cut: &CutLine, start: &str) -> Formula {
        let notation = self.words.notation;
        let mut formula = Formula::default();
        formula.vector(format!("a{}", subscript(&[&point.name])), Known::Nothing, None);
        formula.sign(" = ");
        formula.vector(format!("a{}", subscript(&[start])), Known::Entirely, None);
        let slider = |slide: &DrivenSlide| self.mechanism.slider_name(slide.slider);
        let mut add = |sign: char, markup: String, known: Known, part: NamedPart| {
            formula.sign(&format!(" {sign} "));
            formula.vector(markup, known, Some(part));
        };
        let (relative, coriolis) = (notation.relative, notation.coriolis);
        for slide in &cut.slides {
            add(plus_or_minus(slide), format!("a_{relative}({})", slider(slide)), Known::Entirely, NamedPart::Sliding);
            if self.has_coriolis(slide) {
                let added = format!("a_{coriolis}({})", slider(slide));
                add(plus_or_minus(slide), added, Known::Entirely, NamedPart::Coriolis);
            }
        }
        let passed = cut.slide(self.mechanism);
        if let Some(slide) = passed.as_ref().filter(|slide| self.has_coriolis(slide)) {
            let added = format!("a_{coriolis}({})", slider(slide));
            add(plus_or_minus(slide), added, Known::Entirely, NamedPart::Coriolis);
        }
        let points = subscript(&[&point.name, start]);
        let turning = || cut.terms.iter().filter_map(|term| self.turning(point, term));
        if turning().any(|link| self.turns(link)) {
            add('+', format!("a^{}{points}", notation.normal), Known::Entirely, NamedPart::Normal);
        }
        if turning().next().is_some() {
            add('+', format!("a^{}{points}", notation.tangential), Known::Direction, NamedPart::Tangential);
        }
        if let Some(slide) = passed {
            add(
                plus_or_minus(&slide),
                format!("a_{relative}({})", slider(&slide)),
                Known::Direction,
                NamedPart::Sliding,
            );
        }
        formula
    }

    /// The link of a turning term, unless its arm has no length.
    fn turning(&self, point: &Special, term: &Term) -> Option<BodyId> {
        match *term {
            Term::Turn { link, from, to } => {
                (to.is_some() || self.arm(point, from, to) != Vector::zeros()).then_some(link)
            }
            Term::Slide { .. } => None,
        }
    }

    /// Whether a link has an angular velocity other than a given one of zero.
    fn turns(&self, link: BodyId) -> bool {
        self.construction.spins[link.0].is_none_or(|[omega, _]| omega.is_some())
    }

    /// Whether a slider has a Coriolis acceleration: its guide turns, and something slides.
    fn has_coriolis(&self, slide: &DrivenSlide) -> bool {
        let slides = self.construction.slides[slide.slider.0];
        self.turns(slide.from) && self.turns(slide.to) && slides.is_none_or(|[velocity, _]| velocity.is_some())
    }

    /// Equation and caption of a leg's normal part.
    fn normal_part(&self, point: &Special, side: usize, from: &str, to: &str) -> (Formula, String) {
        let (mechanism, words, s) = (self.mechanism, self.words, &point.name);
        let cut = &point.cuts[side];
        let mut normals = Vec::new();
        let mut centre = "";
        for term in &cut.terms {
            if let Term::Turn { link, from, to } = *term
                && self.turning(point, term).is_some_and(|link| self.turns(link))
            {
                let to = to.map_or(s.as_str(), |to| mechanism.point_name(to));
                let arm = subscript(&[to, mechanism.point_name(from)]);
                normals.push(format!("ω_{}^2 L{arm}", mechanism.body(link).name));
                centre = mechanism.point_name(from);
            }
        }
        let language = words.language;
        let start = cut.start().map_or("", |start| mechanism.point_name(start));
        let mut formula = Formula::default();
        formula.vector(format!("a^{}{}", words.notation.normal, subscript(&[s, start])), Known::Entirely, None);
        let both = normals.len() == 2;
        let mut between = language.made_from();
        for part in normals {
            formula.words(between);
            formula.sign(&part);
            between = language.and();
        }
        let line = cut.name(words, mechanism, s);
        let caption = match both {
            true => language.lay_off_normal_parts(&line, &marked(from), &marked(to)),
            false => language.lay_off_normal_part(&line, centre, &marked(from), &marked(to)),
        };
        (formula, caption)
    }

    /// The arm of a rotation term, to joint `to` or else to the sought point; zero for a point at infinity.
    fn arm(&self, point: &Special, from: PointId, to: Option<PointId>) -> Vector {
        let to_point = || point.crossing.vector_from(self.pose.point(from)).unwrap_or_else(Vector::zeros);
        to.map_or_else(to_point, |to| self.pose.arm(from, to))
    }

    /// The equation of a leg: rates, counter-clockwise positive, times lengths, equal to the measured segment.
    ///
    /// Each term has the sign of its component along the segment from its start to the special point's image.
    #[must_use]
    pub fn equation(&self, kind: Sheet, LegEquation { special, side, from, segment }: &LegEquation) -> String {
        let (rate, slide) = (kind.rate(), kind.vector());
        let mechanism = self.mechanism;
        let point = self.construction.special(*special);
        let cut = &point.cuts[*side];
        let direction = cut.line.direction().unwrap_or_else(Vector::zeros);
        let mut left = String::new();
        for term in &cut.terms {
            let (along, written) = match *term {
                Term::Turn { link, from, to } => {
                    let end = to.map_or(point.name.as_str(), |to| mechanism.point_name(to));
                    let length = subscript(&[end, mechanism.point_name(from)]);
                    let along = self.arm(point, from, to).dot(&direction);
                    (along, format!("{rate}_{{{}}} L{length}", mechanism.body(link).name))
                }
                Term::Slide { slider, from } => {
                    let guide = self.pose.guide(slider) * mechanism.slide_sign(slider, from);
                    let name = mechanism.slider_name(slider);
                    let along = guide.dot(&quarter_turn(direction));
                    (along, format!("{slide}_{}({name})", self.words.notation.relative))
                }
            };
            // Terms with a zero length are left out.
            if along == 0.0 {
                continue;
            }
            let minus = (along < 0.0) != (*segment < 0.0);
            left.push_str(match (left.is_empty(), minus) {
                (true, false) => "",
                (true, true) => "−",
                (false, false) => " + ",
                (false, true) => " − ",
            });
            left.push_str(&written);
        }
        format!("{left} = {}", measured(kind, from, &image_name(&point.name)))
    }

    /// Equation and caption of a slider's relative velocity, relative acceleration or Coriolis acceleration.
    ///
    /// A chain may pass the slider from the sliding link to the guide: then the vector is laid off backwards, so that
    /// its head is where the chain has come from.
    fn passed_part(&self, slide: &DrivenSlide, added: Added, arrow: &Arrow) -> (Formula, String) {
        let mechanism = self.mechanism;
        let name = mechanism.slider_name(slide.slider);
        let on = &mechanism.body(mechanism.slider(slide.slider).on).name;
        let (language, notation) = (self.words.language, self.words.notation);
        let (r, c) = (notation.relative, notation.coriolis);
        let equation = match added {
            Added::SlidingVelocity => format!("v_{r}({name})"),
            Added::SlidingAcceleration => format!("a_{r}({name})"),
            Added::Coriolis => format!("a_{c}({name}) = 2 ω_{on} v_{r}({name})"),
        };
        let [from, to] = arrow.ends().map(marked);
        let caption = match (added, arrow.is_backwards()) {
            (Added::SlidingVelocity, false) => language.lay_off_sliding_velocity(&name, &from, &to),
            (Added::SlidingVelocity, true) => language.lay_off_sliding_velocity_backwards(&name, &from, &to),
            (Added::SlidingAcceleration, false) => language.lay_off_sliding_acceleration(&name, &from, &to),
            (Added::SlidingAcceleration, true) => language.lay_off_sliding_acceleration_backwards(&name, &from, &to),
            (Added::Coriolis, false) => language.lay_off_coriolis(&name, on, &from, &to),
            (Added::Coriolis, true) => language.lay_off_coriolis_backwards(&name, on, &from, &to),
        };
        (equation.into(), caption)
    }
}

fn plus_or_minus(slide: &DrivenSlide) -> char {
    if slide.sign < 0.0 { '−' } else { '+' }
}

/// A plan segment times its scale, as written in an equation.
fn measured(kind: Sheet, from: &str, to: &str) -> String {
    format!("{} ({} {})", kind.scale_symbol(), marked(from), marked(to))
}
