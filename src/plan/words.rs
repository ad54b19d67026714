//! Captions and equations of the steps. Names of points stand between backticks; `_{…}` is low, `^{…}` high.

use super::cut::{CutLine, LegKind, Special};
use super::equation::{Equation, Known, NamedPart};
use super::name::{image_name, point_on};
use super::step::{PlanKind, Relation};
use crate::geometry::{Place, Vector, degrees_of, quarter_turn};
use crate::mechanism::{BodyId, DrivenSlide, Mechanism, PointId, Role, SliderId};
use crate::position::Pose;

/// A name within a caption.
pub(super) fn written(name: &str) -> String {
    format!("`{name}`")
}

/// A caption or an equation as plain text: names as they are, subscripts after `_`.
#[must_use]
pub fn plain_text(markup: &str) -> String {
    markup.replace("^2", "²").replace(['{', '}', '`'], "")
}

/// A subscript made of several names, as in `S3B`.
fn low(names: &[&str]) -> String {
    format!("_{{{}}}", names.concat())
}

pub(super) fn pole(kind: PlanKind, images: &[String]) -> String {
    let (pole, scale) = (kind.pole(), kind.scale_name());
    if images.is_empty() {
        format!("Choose the pole {pole} and the scale {scale}.")
    } else {
        let images: Vec<String> = images.iter().map(|i| written(i)).collect();
        let images = images.join(", ");
        format!(
            "Choose the pole {pole} and the scale {scale}; points at rest have their images there: {images}."
        )
    }
}

pub(super) fn special_point(name: &str, link: &str, cuts: &[String; 2], place: &Place) -> String {
    let name = written(name);
    match place {
        Place::At(_) => format!(
            "{name}, special point of link {link}: where {} meets {}.",
            cuts[0], cuts[1]
        ),
        Place::AtInfinity(direction) => format!(
            "{name}, special point of link {link}, lies at infinity (direction {:.2}°): {} and {} are parallel.",
            degrees_of(*direction),
            cuts[0],
            cuts[1]
        ),
    }
}

pub(super) fn length(from: &str, to: &str) -> String {
    format!("L{}", low(&[from, to]))
}

pub(super) fn measure_length(from: &str, to: &str) -> String {
    format!(
        "Measure the length from {} to {}.",
        written(from),
        written(to)
    )
}

/// Equation and caption of a known vector: that of body `base` at a point.
pub(super) fn known(
    mechanism: &Mechanism,
    base: BodyId,
    point: PointId,
    kind: PlanKind,
) -> (Equation, String) {
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
            let arm = format!("L{}", low(&[k, name]));
            match kind {
                PlanKind::Velocity => (
                    format!("v{} = ω_{link} {arm}", low(&[name])).into(),
                    format!(
                        "Lay off the velocity of {name}, normal to {k}{name}, in the sense of ω_{link}."
                    ),
                ),
                PlanKind::Acceleration if *alpha == 0.0 => (
                    format!(
                        "a{} = a^n{} = ω_{link}^2 {arm}",
                        low(&[name]),
                        low(&[name, k])
                    )
                    .into(),
                    format!(
                        "Lay off the acceleration of {name}, from {name} towards {k}: link {link} turns uniformly."
                    ),
                ),
                PlanKind::Acceleration => (
                    format!(
                        "a{1} = a^n{0} + a^t{0}, a^n{0} = ω_{link}^2 {arm}, a^t{0} = α_{link} {arm}",
                        low(&[name, k]),
                        low(&[name])
                    )
                    .into(),
                    format!(
                        "Lay off the acceleration of {name}: normal part from {name} towards {k}, tangential part normal to {k}{name}."
                    ),
                ),
            }
        }
        Role::Carrier { .. } => (
            given(format!("{letter}_{name}")),
            format!("Lay off the given vector {letter}_{name} from the pole."),
        ),
        _ => (
            format!("{letter}{}", low(&[under, &body.name])).into(),
            format!(
                "Lay off the known vector of the point of {} under {}.",
                body.name,
                written(under)
            ),
        ),
    }
}

/// A vector that the scene gives.
fn given(vector: String) -> Equation {
    let mut equation = Equation::default();
    equation.vector(vector, Known::Entirely, None);
    equation.words(" given");
    equation
}

pub(super) fn ray(through: &str, relation: Relation, line: &str, to: &str) -> String {
    let relation = match relation {
        Relation::Perpendicular => "normal to",
        Relation::Parallel => "parallel to the",
    };
    format!(
        "Draw the ray through {} {relation} {line}; {} lies on it.",
        written(through),
        written(to)
    )
}

/// The equation behind a velocity ray; driven sliders on the way add their sliding velocities.
pub(super) fn relative_velocity(
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
        equation.vector(format!("v_r({name})"), Known::Entirely, sliding);
    }
    equation.sign(" + ");
    let relative = format!("v{}", low(&[special, start]));
    equation.vector(relative, Known::Direction, None);
    equation
}

/// The equation behind an acceleration ray; driven sliders on the way add their sliding and Coriolis accelerations.
pub(super) fn relative_acceleration(
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
    let mut equation = Equation::default();
    equation.vector(format!("a{}", low(&[special])), Known::Nothing, None);
    equation.sign(" = ");
    equation.vector(format!("a{}", low(&[start])), Known::Entirely, None);
    for slide in &cut.slides {
        let name = mechanism.slider_name(slide.slider);
        for (letter, part) in [("r", NamedPart::Sliding), ("c", NamedPart::Coriolis)] {
            equation.sign(&format!(" {} ", plus_or_minus(slide)));
            let added = format!("a_{letter}({name})");
            equation.vector(added, Known::Entirely, Some(part));
        }
    }
    let both = low(&[special, start]);
    let (known, direction) = (Known::Entirely, Known::Direction);
    for (letter, known, part) in [
        ("n", known, NamedPart::Normal),
        ("c", known, NamedPart::Coriolis),
        ("t", direction, NamedPart::Tangential),
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

pub(super) fn cross(image: &str) -> String {
    format!("Mark {} where the two rays cross.", written(image))
}

pub(super) fn measure(from: &str, to: &str) -> String {
    format!(
        "Measure the segment from {} to {}.",
        written(from),
        written(to)
    )
}

pub(super) fn measured(kind: PlanKind, from: &str, to: &str) -> String {
    format!("{} ({} {})", kind.scale_name(), written(from), written(to))
}

/// Equation and caption of a normal part.
pub(super) fn normal(
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
    let turning =
        |link: &str, to: &str, from: PointId| format!("ω_{link}^2 L{}", low(&[to, name(from)]));
    // A length that is nothing has no place in an equation.
    let to_special = |link: &str, from: PointId| {
        let arm = point.crossing.vector_from(pose.point(from));
        let turns = arm.is_some_and(|arm| arm != Vector::zeros());
        turns.then(|| turning(link, s, from))
    };
    let sliding = |slider: SliderId, omega: &str| {
        format!("2 ω_{omega} v_r({})", mechanism.slider_name(slider))
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
    let what = match (parts.len(), coriolis.is_some()) {
        (2, _) => "the normal parts of both links",
        (1, true) => "the normal and the Coriolis part",
        (_, true) => "the Coriolis part",
        (_, false) => "the normal part",
    };
    let mut equation = Equation::default();
    let whole = format!("a^n{}", low(&[s, start]));
    equation.vector(whole, Known::Entirely, None);
    let mut between = " from ";
    for part in parts {
        equation.words(between);
        equation.sign(&part);
        between = " and ";
    }
    if let Some(part) = coriolis {
        equation.words(&format!("{between}Coriolis "));
        equation.sign(&part);
    }
    (
        equation,
        format!(
            "Lay off {what} along {} from {} to {}.",
            cut.name(mechanism, s),
            written(from),
            written(to)
        ),
    )
}

/// The equation of a leg: its rates, counter-clockwise positive, times lengths make up the measured segment `signed`.
///
/// Every term has the sign that it takes along the segment from its start to the special point's image.
pub(super) fn leg_equation(
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
        (
            arm.dot(&direction),
            format!("{rate}_{{{link}}} L{}", low(&[to, name(from)])),
        )
    };
    let to_special = |from: PointId| {
        let arm = point.crossing.vector_from(pose.point(from));
        arm.unwrap_or_else(Vector::zeros)
    };
    let sliding = |slider: SliderId, from: BodyId| {
        let u = pose.guide(slider) * mechanism.slide_sign(slider, from);
        let along = u.dot(&quarter_turn(direction));
        (
            along,
            format!("{slide}_r({})", mechanism.slider_name(slider)),
        )
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
        LegKind::PinThenSlider { outer, inner } => vec![
            turning(carrier, outer, &point.name, to_special(outer)),
            sliding(inner, cut.carrier),
        ],
        LegKind::SliderThenPin { outer, inner } => vec![
            sliding(outer, cut.leg.base),
            turning(link, inner, &point.name, to_special(inner)),
        ],
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
    format!(
        "{left} = {}",
        measured(kind, from, &image_name(&point.name))
    )
}

pub(super) fn solve(unknowns: &[(String, f64)]) -> String {
    let names: Vec<String> = unknowns.iter().map(|u| rate_symbol(&u.0)).collect();
    format!(
        "Solve the equations of the measured segments for {}.",
        names.join(", ")
    )
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

pub(super) fn no_construction(far: &[String]) -> String {
    if far.is_empty() {
        "There is no construction by two rays for this group; the rates come from the loop equations alone."
            .to_owned()
    } else {
        format!(
            "{} at infinity: its rays are parallel, so the construction stops and the rates come from the loop equations alone.",
            far.join(" and ")
        )
    }
}

/// Equation and caption of a relative velocity, for the image of an inner joint.
pub(super) fn image(link: &str, from: &str, to: &str) -> (String, String) {
    (
        format!("v{0} = ω_{link} L{0}", low(&[to, from])),
        format!(
            "From ω_{link}: lay off the velocity of {} relative to {}, normal to {from}{to}.",
            written(to),
            written(from)
        ),
    )
}

/// Equation and caption of a sliding velocity.
pub(super) fn sliding(slider: &str, from: &str, to: &str) -> (String, String) {
    let what = format!("the sliding velocity of {slider} along its guide");
    (format!("v_r({slider})"), lay_off(&what, from, to))
}

/// Caption of a vector laid off between two plan points.
pub(super) fn lay_off(what: &str, from: &str, to: &str) -> String {
    format!("Lay off {what}, from {} to {}.", written(from), written(to))
}

/// What a driven slider adds, as it stands in an equation and in words: sliding velocity `v`, sliding acceleration `a`.
pub(super) fn driven(mechanism: &Mechanism, slide: &DrivenSlide, letter: char) -> [String; 2] {
    let name = mechanism.slider_name(slide.slider);
    let (minus, reversed) = reversal(slide);
    let what = match letter {
        'v' => "velocity",
        _ => "acceleration",
    };
    [
        format!("{minus}{letter}_r({name})"),
        format!("the sliding {what} of {name}{reversed} along its guide"),
    ]
}

/// The same for its Coriolis acceleration.
pub(super) fn driven_coriolis(mechanism: &Mechanism, slide: &DrivenSlide) -> [String; 2] {
    let name = mechanism.slider_name(slide.slider);
    let on = &mechanism.body(mechanism.slider(slide.slider).on).name;
    let (minus, reversed) = reversal(slide);
    [
        format!("{minus}a_c({name}) = {minus}2 ω_{on} v_r({name})"),
        format!("the Coriolis acceleration of {name}{reversed}, normal to its guide"),
    ]
}

/// Sign and word for a slider whose way leads from the sliding link to the guide.
fn reversal(slide: &DrivenSlide) -> (&'static str, &'static str) {
    if slide.sign < 0.0 {
        ("−", " reversed")
    } else {
        ("", "")
    }
}
