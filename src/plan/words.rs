//! Captions and equations of the steps. Names of points stand between backticks; `_{…}` is low, `^{…}` high.

use super::cut::{CutLine, LegKind, Special};
use super::equation::{Equation, Known, NamedPart};
use super::name::{image_name, point_on};
use super::step::{Plan, PlanKind, Relation};
use crate::geometry::{Place, Vector, degrees_of, quarter_turn};
use crate::mechanism::{BodyId, DrivenSlide, Mechanism, PointId, Role, SliderId};
use crate::position::Pose;
use crate::words::{Language, NumberStyle, Wording};

/// A name within a caption.
pub(super) fn written(name: &str) -> String {
    format!("`{name}`")
}

/// A caption or an equation as plain text: names as they are, subscripts after `_`.
#[must_use]
pub fn plain_text(markup: &str) -> String {
    let mut text = String::with_capacity(markup.len());
    push_plain(&mut text, markup);
    text
}

/// A caption or an equation as plain text, names of plan points as the notation has them.
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

/// Adds markup without its marks.
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

/// A subscript made of several names, as in `S3B`.
fn low(names: &[&str]) -> String {
    format!("_{{{}}}", names.concat())
}

pub(super) fn pole(words: &Wording, kind: PlanKind, images: &[String]) -> String {
    let (pole, scale) = (kind.pole_in(words.notation), kind.scale_name());
    if images.is_empty() {
        return words.language.choose_pole(pole, scale);
    }
    let images: Vec<String> = images.iter().map(|i| written(i)).collect();
    words.language.choose_pole_with(pole, scale, &images.join(", "))
}

pub(super) fn special_point(
    words: &Wording,
    name: &str,
    link: &str,
    [first, second]: &[String; 2],
    place: &Place,
) -> String {
    let (name, language) = (written(name), words.language);
    match place {
        Place::At(_) => language.special_point(&name, link, first, second),
        Place::AtInfinity(direction) => {
            let direction = words.write(degrees_of(*direction), NumberStyle::decimals(2));
            language.special_point_at_infinity(&name, link, &direction, first, second)
        }
    }
}

pub(super) fn length(from: &str, to: &str) -> String {
    format!("L{}", low(&[from, to]))
}

pub(super) fn measure_length(words: &Wording, from: &str, to: &str) -> String {
    words.language.measure_length(&written(from), &written(to))
}

/// Equation and caption of a known vector: that of body `base` at a point.
pub(super) fn known(
    words: &Wording,
    mechanism: &Mechanism,
    base: BodyId,
    point: PointId,
    kind: PlanKind,
) -> (Equation, String) {
    let (language, notation) = (words.language, words.notation);
    let body = mechanism.body(base);
    let under = mechanism.point_name(point);
    let name = &point_on(mechanism, base, point);
    let letter = match kind {
        PlanKind::Velocity => "v",
        PlanKind::Acceleration => "a",
    };
    match &body.role {
        Role::Driver { pivot, alpha, .. } => {
            let (k, link) = (mechanism.point_name(*pivot), &body.name);
            let (arm, line) = (format!("L{}", low(&[k, name])), format!("{k}{name}"));
            let (own, both) = (low(&[name]), low(&[name, k]));
            let (n, t) = (notation.normal, notation.tangential);
            match kind {
                PlanKind::Velocity => (
                    format!("v{own} = ω_{link} {arm}").into(),
                    language.lay_off_velocity(name, &line, link),
                ),
                PlanKind::Acceleration if *alpha == 0.0 => (
                    format!("a{own} = a^{n}{both} = ω_{link}^2 {arm}").into(),
                    language.lay_off_normal_acceleration(name, k, link),
                ),
                PlanKind::Acceleration => (
                    format!(
                        "a{own} = a^{n}{both} + a^{t}{both}, a^{n}{both} = ω_{link}^2 {arm}, a^{t}{both} = α_{link} {arm}"
                    )
                    .into(),
                    language.lay_off_whole_acceleration(name, k, &line),
                ),
            }
        }
        Role::Carrier { .. } => {
            let vector = format!("{letter}_{name}");
            let caption = language.lay_off_given(&vector);
            (given(words, vector), caption)
        }
        _ => (
            format!("{letter}{}", low(&[under, &body.name])).into(),
            language.lay_off_point_under(&body.name, &written(under)),
        ),
    }
}

/// A vector that the scene gives.
fn given(words: &Wording, vector: String) -> Equation {
    let mut equation = Equation::default();
    equation.vector(vector, Known::Entirely, None);
    equation.words(words.language.given());
    equation
}

pub(super) fn ray(words: &Wording, through: &str, relation: Relation, line: &str, to: &str) -> String {
    let sentence = match relation {
        Relation::Perpendicular => Language::ray_normal,
        Relation::Parallel => Language::ray_parallel,
    };
    sentence(words.language, &written(through), line, &written(to))
}

/// The equation behind a velocity ray; driven sliders on the way add their sliding velocities.
pub(super) fn relative_velocity(
    words: &Wording,
    mechanism: &Mechanism,
    slides: &[DrivenSlide],
    special: &str,
    start: &str,
) -> Equation {
    let mut equation = Equation::default();
    equation.vector(format!("v{}", low(&[special])), Known::Nothing, None);
    equation.sign(" = ");
    equation.vector(format!("v{}", low(&[start])), Known::Entirely, None);
    for slide in slides {
        let name = mechanism.slider_name(slide.slider);
        equation.sign(&format!(" {} ", plus_or_minus(slide)));
        let sliding = Some(NamedPart::Sliding);
        let added = format!("v_{}({name})", words.notation.relative);
        equation.vector(added, Known::Entirely, sliding);
    }
    equation.sign(" + ");
    let relative = format!("v{}", low(&[special, start]));
    equation.vector(relative, Known::Direction, None);
    equation
}

/// The equation behind an acceleration ray; driven sliders on the way add their sliding and Coriolis accelerations.
pub(super) fn relative_acceleration(
    words: &Wording,
    mechanism: &Mechanism,
    cut: &CutLine,
    special: &str,
    start: &str,
) -> Equation {
    let (has_normal, has_coriolis) = match cut.kind {
        LegKind::Pin { .. } | LegKind::Pins { .. } => (true, false),
        LegKind::PinThenSlider { .. } | LegKind::SliderThenPin { .. } => (true, true),
        LegKind::Slider { .. } => (false, true),
        LegKind::Sliders => (false, false),
    };
    let notation = words.notation;
    let mut equation = Equation::default();
    equation.vector(format!("a{}", low(&[special])), Known::Nothing, None);
    equation.sign(" = ");
    equation.vector(format!("a{}", low(&[start])), Known::Entirely, None);
    for slide in &cut.slides {
        let name = mechanism.slider_name(slide.slider);
        for (letter, part) in [(notation.relative, NamedPart::Sliding), (notation.coriolis, NamedPart::Coriolis)] {
            equation.sign(&format!(" {} ", plus_or_minus(slide)));
            let added = format!("a_{letter}({name})");
            equation.vector(added, Known::Entirely, Some(part));
        }
    }
    let both = low(&[special, start]);
    let (known, direction) = (Known::Entirely, Known::Direction);
    for (letter, known, part) in [
        (notation.normal, known, NamedPart::Normal),
        (notation.coriolis, known, NamedPart::Coriolis),
        (notation.tangential, direction, NamedPart::Tangential),
    ] {
        let has = match part {
            NamedPart::Normal => has_normal,
            NamedPart::Coriolis => has_coriolis,
            _ => true,
        };
        if !has {
            continue;
        }
        equation.sign(" + ");
        equation.vector(format!("a^{letter}{both}"), known, Some(part));
    }
    equation
}

fn plus_or_minus(slide: &DrivenSlide) -> char {
    if slide.sign < 0.0 { '−' } else { '+' }
}

pub(super) fn cross(words: &Wording, image: &str) -> String {
    words.language.cross(&written(image))
}

pub(super) fn measure(words: &Wording, from: &str, to: &str) -> String {
    words.language.measure_segment(&written(from), &written(to))
}

pub(super) fn measured(kind: PlanKind, from: &str, to: &str) -> String {
    format!("{} ({} {})", kind.scale_name(), written(from), written(to))
}

/// Equation and caption of a normal part.
pub(super) fn normal(
    words: &Wording,
    mechanism: &Mechanism,
    pose: &Pose,
    cut: &CutLine,
    point: &Special,
    from: &str,
    to: &str,
) -> (Equation, String) {
    let name = |p: PointId| mechanism.point_name(p);
    let body = |b: BodyId| mechanism.body(b).name.as_str();
    let (carrier, link, base) = (body(cut.carrier), body(point.link), body(cut.leg.base));
    let s = &point.name;
    let turning = |link: &str, to: &str, from: PointId| format!("ω_{link}^2 L{}", low(&[to, name(from)]));
    // A length that is nothing has no place in an equation.
    let to_special = |link: &str, from: PointId| {
        let arm = point.crossing.vector_from(pose.point(from));
        let turns = arm.is_some_and(|arm| arm != Vector::zeros());
        turns.then(|| turning(link, s, from))
    };
    let sliding = |slider: SliderId, omega: &str| {
        let name = mechanism.slider_name(slider);
        format!("2 ω_{omega} v_{}({name})", words.notation.relative)
    };
    let (start, normals, coriolis) = match cut.kind {
        LegKind::Pin { outer } => (name(outer), vec![to_special(link, outer)], None),
        LegKind::Slider { outer, at } => (name(at), vec![], Some(sliding(outer, base))),
        LegKind::Pins { outer, inner } => {
            let own = turning(carrier, name(inner), outer);
            (name(outer), vec![Some(own), to_special(link, inner)], None)
        }
        LegKind::PinThenSlider { outer, inner } => {
            let own = to_special(carrier, outer);
            (name(outer), vec![own], Some(sliding(inner, carrier)))
        }
        LegKind::SliderThenPin { outer, inner } => {
            let own = to_special(link, inner);
            (name(inner), vec![own], Some(sliding(outer, base)))
        }
        LegKind::Sliders => ("", vec![], None),
    };
    let parts: Vec<String> = normals.into_iter().flatten().collect();
    let sentence = match (parts.len(), coriolis.is_some()) {
        (2, _) => Language::lay_off_normal_parts,
        (1, true) => Language::lay_off_normal_and_coriolis,
        (_, true) => Language::lay_off_coriolis_part,
        (_, false) => Language::lay_off_normal_part,
    };
    let language = words.language;
    let mut equation = Equation::default();
    let whole = format!("a^{}{}", words.notation.normal, low(&[s, start]));
    equation.vector(whole, Known::Entirely, None);
    let mut between = language.made_from();
    for part in parts {
        equation.words(between);
        equation.sign(&part);
        between = language.and();
    }
    if let Some(part) = coriolis {
        equation.words(&format!("{between}{}", language.coriolis_word()));
        equation.sign(&part);
    }
    let line = cut.name(words, mechanism, s);
    let caption = sentence(language, &line, &written(from), &written(to));
    (equation, caption)
}

/// The equation of a leg: its rates, counter-clockwise positive, times lengths make up the measured segment `signed`.
///
/// Every term has the sign that it takes along the segment from its start to the special point's image.
pub(super) fn leg_equation(
    words: &Wording,
    mechanism: &Mechanism,
    pose: &Pose,
    cut: &CutLine,
    point: &Special,
    from: &str,
    (kind, signed): (PlanKind, f64),
) -> String {
    let (rate, slide) = match kind {
        PlanKind::Velocity => ("ω", "v"),
        PlanKind::Acceleration => ("α", "a"),
    };
    let direction = cut.line.direction().unwrap_or_else(Vector::zeros);
    let name = |p: PointId| mechanism.point_name(p);
    let link = &mechanism.body(point.link).name;
    let carrier = &mechanism.body(cut.carrier).name;
    let turning = |link: &str, from: PointId, to: &str, arm: Vector| {
        (arm.dot(&direction), format!("{rate}_{{{link}}} L{}", low(&[to, name(from)])))
    };
    let to_special = |from: PointId| {
        let arm = point.crossing.vector_from(pose.point(from));
        arm.unwrap_or_else(Vector::zeros)
    };
    let sliding = |slider: SliderId, from: BodyId| {
        let u = pose.guide(slider) * mechanism.slide_sign(slider, from);
        let along = u.dot(&quarter_turn(direction));
        (along, format!("{slide}_{}({})", words.notation.relative, mechanism.slider_name(slider)))
    };
    let terms = match cut.kind {
        LegKind::Pin { outer } => {
            vec![turning(link, outer, &point.name, to_special(outer))]
        }
        LegKind::Slider { outer, .. } => vec![sliding(outer, cut.leg.base)],
        LegKind::Pins { outer, inner } => vec![
            turning(carrier, outer, name(inner), pose.arm(outer, inner)),
            turning(link, inner, &point.name, to_special(inner)),
        ],
        LegKind::PinThenSlider { outer, inner } => {
            vec![turning(carrier, outer, &point.name, to_special(outer)), sliding(inner, cut.carrier)]
        }
        LegKind::SliderThenPin { outer, inner } => {
            vec![sliding(outer, cut.leg.base), turning(link, inner, &point.name, to_special(inner))]
        }
        LegKind::Sliders => Vec::new(),
    };
    let mut left = String::new();
    // A length that is nothing has no place in an equation.
    for (along, term) in terms.into_iter().filter(|t| t.0 != 0.0) {
        let minus = (along < 0.0) != (signed < 0.0);
        left.push_str(match (left.is_empty(), minus) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        });
        left.push_str(&term);
    }
    format!("{left} = {}", measured(kind, from, &image_name(&point.name)))
}

pub(super) fn solve(words: &Wording, unknowns: &[(String, f64)]) -> String {
    let names: Vec<String> = unknowns.iter().map(|u| rate_symbol(&u.0)).collect();
    words.language.solve(&names.join(", "))
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

pub(super) fn no_construction(words: &Wording, far: &[String]) -> String {
    let language = words.language;
    if far.is_empty() {
        language.no_construction().to_owned()
    } else {
        language.no_construction_far(&far.join(language.and()))
    }
}

/// Equation and caption of a relative velocity, for the image of an inner joint.
pub(super) fn image(words: &Wording, link: &str, from: &str, to: &str) -> (String, String) {
    let line = format!("{from}{to}");
    (
        format!("v{0} = ω_{link} L{0}", low(&[to, from])),
        words.language.lay_off_relative(link, &written(to), &written(from), &line),
    )
}

/// Equation and caption of a sliding velocity.
pub(super) fn sliding(words: &Wording, slider: &str, from: &str, to: &str) -> (String, String) {
    let caption = words.language.lay_off_sliding_velocity(slider, &written(from), &written(to));
    (format!("v_{}({slider})", words.notation.relative), caption)
}

/// What a driven slider adds to a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Added {
    SlidingVelocity,
    SlidingAcceleration,
    Coriolis,
}

/// Equation and caption of what a driven slider adds between two plan points.
pub(super) fn driven(
    words: &Wording,
    mechanism: &Mechanism,
    slide: &DrivenSlide,
    added: Added,
    [from, to]: [&str; 2],
) -> (String, String) {
    let name = mechanism.slider_name(slide.slider);
    let on = &mechanism.body(mechanism.slider(slide.slider).on).name;
    // The way may lead from the sliding link to the guide.
    let backwards = slide.sign < 0.0;
    let minus = if backwards { "−" } else { "" };
    let (language, notation) = (words.language, words.notation);
    let (r, c) = (notation.relative, notation.coriolis);
    let equation = match added {
        Added::SlidingVelocity => format!("{minus}v_{r}({name})"),
        Added::SlidingAcceleration => format!("{minus}a_{r}({name})"),
        Added::Coriolis => format!("{minus}a_{c}({name}) = {minus}2 ω_{on} v_{r}({name})"),
    };
    let sentence = match (added, backwards) {
        (Added::SlidingVelocity, false) => Language::lay_off_sliding_velocity,
        (Added::SlidingVelocity, true) => Language::lay_off_sliding_velocity_reversed,
        (Added::SlidingAcceleration, false) => Language::lay_off_sliding_acceleration,
        (Added::SlidingAcceleration, true) => Language::lay_off_sliding_acceleration_reversed,
        (Added::Coriolis, false) => Language::lay_off_coriolis,
        (Added::Coriolis, true) => Language::lay_off_coriolis_reversed,
    };
    let caption = sentence(language, &name, &written(from), &written(to));
    (equation, caption)
}
