//! Equations of legs: the vector equation behind a ray, the normal part, and the rates in a measured segment.

use super::cut::{CutLine, Special, Term};
use super::markup::{Formula, Known, marked, measured, subscript};
use super::name::{image_name, point_on};
use super::sentence::Teller;
use super::step::{LegEquation, RateEquation, Ray, RayOf, Relation, VectorPart, WheelEquation};
use crate::geometry::{Vector, quarter_turn};
use crate::mechanism::{BodyId, DrivenSlide, GROUND, JointId, PointId};
use crate::sheet::{Order, Sheet};
use crate::words::{NumberStyle, SlidePart};

impl Teller<'_> {
    /// The vector equation behind a ray: motion of the sought point relative to the leg's start, or of a further point
    /// of a link relative to one with an image.
    pub(super) fn ray_equation(&self, ray: &Ray) -> Formula {
        let (special, side) = match ray.of {
            RayOf::Leg(special, side) => (self.construction.special(special), side),
            // At an angle to a line of images no equation is needed.
            RayOf::Arm { .. } if ray.relation == Relation::Angle => return Formula::default(),
            RayOf::Arm { link, from, to, .. } => {
                let [from, to] = [from, to].map(|point| point_on(self.mechanism, link, point));
                let mut formula = Formula::equal(ray.order, &to, &from);
                let relative = ray.order.vector().to_owned() + &subscript(&[&to, &from]);
                formula.add('+', relative, Known::Direction, None);
                return formula;
            }
        };
        let cut = &special.cuts[side];
        let start = cut.start().map(|point| point_on(self.mechanism, cut.leg.base, point)).unwrap_or_default();
        let mut formula = self.leg_equation(ray.order, special, cut, &start);
        // A point of the ground has no velocity: its term is left out, with one of the plus signs beside it.
        let ground = self.mechanism.body(GROUND);
        let is_under = cut.leg.base == GROUND && cut.start().is_some_and(|start| !ground.points.contains(&start));
        if is_under && formula.terms.len() > 3 {
            let end = if formula.terms[3].markup == " + " { 4 } else { 3 };
            formula.terms.drain(2..end);
        }
        formula
    }

    /// The vector equation behind the ray of a leg: what the sliders of the leg add, then what the ray carries. Parts
    /// that are zero in every position are left out.
    fn leg_equation(&self, order: Order, point: &Special, cut: &CutLine, start: &str) -> Formula {
        let notation = self.words.notation;
        let mut formula = Formula::equal(order, &point.name, start);
        let add_slide = |formula: &mut Formula, slide: &DrivenSlide, known: Known, part: VectorPart| {
            let shown = if part == VectorPart::Coriolis { SlidePart::Coriolis } else { SlidePart::Relative };
            let markup = self.slide(order, shown, slide.slider);
            formula.add(if slide.sign < 0.0 { '−' } else { '+' }, markup, known, Some(part));
        };
        let has_coriolis = |slide: &DrivenSlide| order == Order::Acceleration && self.has_coriolis(slide);
        for slide in &cut.slides {
            add_slide(&mut formula, slide, Known::Entirely, VectorPart::Sliding);
            if has_coriolis(slide) {
                add_slide(&mut formula, slide, Known::Entirely, VectorPart::Coriolis);
            }
        }
        let passed = cut.slide();
        if let Some(slide) = passed.as_ref().filter(|slide| has_coriolis(slide)) {
            add_slide(&mut formula, slide, Known::Entirely, VectorPart::Coriolis);
        }
        let points = subscript(&[&point.name, start]);
        let turning: Vec<BodyId> = cut.terms.iter().filter_map(|term| self.turning(point, term)).collect();
        match order {
            // Turning and sliding together are one velocity along the ray.
            Order::Velocity => match passed.filter(|_| turning.is_empty()) {
                Some(slide) => add_slide(&mut formula, &slide, Known::Direction, VectorPart::Sliding),
                None => formula.add('+', format!("v{points}"), Known::Direction, None),
            },
            Order::Acceleration => {
                if turning.iter().any(|&link| self.turns(link)) {
                    let normal = format!("a^{}{points}", notation.normal);
                    formula.add('+', normal, Known::Entirely, Some(VectorPart::Normal));
                }
                if !turning.is_empty() {
                    let tangential = format!("a^{}{points}", notation.tangential);
                    formula.add('+', tangential, Known::Direction, Some(VectorPart::Tangential));
                }
                if let Some(slide) = passed {
                    add_slide(&mut formula, &slide, Known::Direction, VectorPart::Sliding);
                }
            }
        }
        formula
    }

    /// The link of a turning term, unless its arm has no length.
    pub(super) fn turning(&self, point: &Special, term: &Term) -> Option<BodyId> {
        match *term {
            Term::Turn { link, from, to } => {
                (to.is_some() || self.arm(point, from, to) != Vector::zeros()).then_some(link)
            }
            Term::Slide(_) => None,
        }
    }

    /// Whether a link has an angular velocity other than a given one of zero.
    fn turns(&self, link: BodyId) -> bool {
        self.construction.angular_rates[link.0].is_none_or(|[omega, _]| omega.is_some())
    }

    /// Whether a slider has a Coriolis acceleration: its guide turns, and something slides.
    fn has_coriolis(&self, slide: &DrivenSlide) -> bool {
        let slides = self.construction.slide_rates[slide.slider.0];
        self.turns(slide.from) && self.turns(slide.to) && slides.is_none_or(|[velocity, _]| velocity.is_some())
    }

    /// Equation and caption of a leg's normal part.
    pub(super) fn normal_part(&self, point: &Special, side: usize, from: &str, to: &str) -> (Formula, String) {
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

    /// An equation from which rates are found, counter-clockwise positive.
    #[must_use]
    pub fn equation(&self, equation: &RateEquation) -> String {
        match equation {
            RateEquation::Leg(leg) => self.equation_of_leg(leg),
            RateEquation::Wheel(wheel) => self.equation_of_wheel(wheel),
            RateEquation::Mesh(order, joint) => self.equation_of_mesh(*order, *joint),
            RateEquation::Rolling(order, joint) => {
                self.equation_of_rack(*order, *joint).unwrap_or_else(|| self.equation_of_mesh(*order, *joint))
            }
        }
    }

    /// The equation of a wheel or an arm: its angular velocity times the distance of two points, equal to the measured segment.
    fn equation_of_wheel(&self, WheelEquation { link, ends: [a, b], from, to, segment }: &WheelEquation) -> String {
        let minus = if *segment < 0.0 { "−" } else { "" };
        let rate = format!("{}_{{{}}}", Order::Velocity.rate(), self.mechanism.body(*link).name);
        format!("{minus}{rate} L{} = {}", subscript(&[a, b]), measured(Sheet::Velocity, from, to))
    }

    /// The equation of a mesh with its numbers of teeth: what rests is left out.
    fn equation_of_mesh(&self, order: Order, joint: JointId) -> String {
        let joint = self.mechanism.joint(joint);
        let teeth = joint.pitch.map(|pitch| pitch.all_teeth).or(joint.belt.map(|belt| belt.teeth));
        let (Some(teeth), Some(carrier)) = (teeth, joint.related_bodies().nth(2)) else { return String::new() };
        let wheels = joint.bodies.into_iter().zip(teeth);
        let left = wheels.map(|(wheel, teeth)| (teeth < 0, self.times(teeth.abs().to_string(), order, wheel)));
        let sum: i32 = teeth.iter().sum();
        let right = (sum < 0, self.times(sum.abs().to_string(), order, carrier).filter(|_| sum != 0));
        format!("{} = {}", signed_sum(left), signed_sum([right]))
    }

    /// The equation of a wheel on a rack: its radius times its angular rate against the carrier, equal to what slides, with the same for
    /// accelerations.
    fn equation_of_rack(&self, order: Order, joint: JointId) -> Option<String> {
        let joint = self.mechanism.joint(joint);
        let (rack, angular) = (joint.rack?, joint.angular.as_ref()?);
        let radius = || self.words.write(rack.radius, NumberStyle::shortest());
        let turning = angular.terms.iter().rev().map(|&(body, weight)| (weight < 0, self.times(radius(), order, body)));
        let slides = angular.travel.as_ref()?.slides.iter();
        let sliding = slides.map(|&(slider, sign)| (sign < 0.0, Some(self.slide(order, SlidePart::Relative, slider))));
        Some(format!("{} = {}", signed_sum(turning), signed_sum(sliding)))
    }

    /// The angular rate of a body times a number; none of the frame.
    fn times(&self, number: String, order: Order, body: BodyId) -> Option<String> {
        (body != GROUND).then(|| format!("{number} {}_{{{}}}", order.rate(), self.mechanism.body(body).name))
    }

    /// The equation of a leg: rates, counter-clockwise positive, times lengths, equal to the measured segment.
    ///
    /// Each term has the sign of its component along the segment from its start to the special point's image.
    fn equation_of_leg(&self, LegEquation { order, special, side, from, segment }: &LegEquation) -> String {
        let rate = order.rate();
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
                Term::Slide(DrivenSlide { slider, sign, .. }) => {
                    let guide = self.pose.guide(slider) * sign;
                    let along = guide.dot(&quarter_turn(direction));
                    (along, self.slide(*order, SlidePart::Relative, slider))
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
        format!("{left} = {}", measured(order.sheet(), from, &image_name(&point.name)))
    }
}

/// A sum of terms, each with whether it counts as negative; what is not there is left out.
fn signed_sum(terms: impl IntoIterator<Item = (bool, Option<String>)>) -> String {
    let mut sum = String::new();
    for (is_negative, term) in terms {
        let Some(term) = term else { continue };
        sum.push_str(match (sum.is_empty(), is_negative) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        });
        sum.push_str(&term);
    }
    if sum.is_empty() { "0".to_owned() } else { sum }
}
