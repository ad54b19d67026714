//! The legs of a special point: cut lines, equations of the segments measured along the rays (Eqs. 7, 8, 15, 16 and 35
//! to 38 of Quintero et al., 2011), normal parts and Coriolis accelerations.

use super::arrow::{Arrow, VectorOf, VectorPart};
use super::cut::{Course, CutLine, Special, SpecialId, Term};
use super::number::{Equation, NumberId, Product, ProductKind};
use super::operation::{Along, LineId, OperationRole, PlaceId};
use super::plan::PointRole;
use super::step::Action;
use super::writer::Writer;
use crate::geometry::quarter_turn;
use crate::mechanism::{AngularRate, AngularTerms, LoopEquations, PointId};
use crate::sheet::{Order, Sheet};

/// Directions of a leg on the sheets.
#[derive(Clone, Copy)]
pub(super) struct LegLines {
    /// Direction of the cut line.
    pub along: Along,
    /// Direction of the rays, a quarter turn counter-clockwise from the cut line.
    pub ray: Along,
    /// The cut line, once drawn on the scheme.
    pub line: Option<LineId>,
}

/// A special point on the scheme, with its legs.
pub(super) struct DrawnSpecial<'a> {
    pub special: &'a Special,
    pub id: SpecialId,
    pub legs: [LegLines; 2],
    /// Its place on the scheme.
    pub place: PlaceId,
    /// By leg: the length from its joint to the point, where an equation contains it.
    pub lengths: [Option<NumberId>; 2],
}

impl Writer<'_> {
    /// The directions of a leg; `None` for a cut line at infinity. A cut line through two pins is drawn through them,
    /// one normal to a guide is set to the guide.
    pub(super) fn leg(&mut self, cut: &CutLine, target: Option<PointId>) -> Option<LegLines> {
        cut.line.direction()?;
        match cut.course {
            Course::Through(from, to) => {
                let line = self.join(from, to.or(target)?);
                let along = Along::line(line);
                Some(LegLines { along, ray: along.turned(1), line: Some(line) })
            }
            Course::Normal(slider, _) => {
                let guide = Along::line(self.guide(slider));
                Some(LegLines { along: guide.turned(1), ray: guide.turned(2), line: None })
            }
            Course::AtInfinity => None,
        }
    }

    /// The cut line of a leg; draws it on the scheme unless it is there.
    pub(super) fn cut_line(&mut self, leg: &mut LegLines, cut: &CutLine, special: SpecialId) -> Option<LineId> {
        if leg.line.is_none() {
            let through = self.plot(cut.start()?);
            let line = self.draw(Sheet::Scheme, OperationRole::CutLine(special), through, leg.along);
            leg.along = Along::line(line);
            leg.line = Some(line);
        }
        leg.line
    }

    /// The length of the arm of a term that turns; none for one that slides, and for an arm of length zero.
    fn arm_length(&mut self, drawn: &DrawnSpecial<'_>, side: usize, term: &Term) -> Option<NumberId> {
        match *term {
            Term::Turn { from, to: Some(to), .. } => Some(self.length(from, to)),
            Term::Turn { to: None, .. } => drawn.lengths[side],
            Term::Slide(_) => None,
        }
    }

    /// The equation of a measured segment, which is the sum of the leg's terms.
    pub(super) fn equation(
        &mut self,
        order: Order,
        equations: &LoopEquations,
        drawn: &DrawnSpecial<'_>,
        side: usize,
        segment: NumberId,
    ) -> Option<Equation> {
        let (mut left, mut right) = (Vec::new(), vec![Product::plain(segment)]);
        let cut = &drawn.special.cuts[side];
        for term in &cut.terms {
            let length = self.arm_length(drawn, side, term);
            match (*term, length) {
                (Term::Turn { link, .. }, Some(length)) => match equations.angular_unknown(link) {
                    Some(unknown) => left.push((unknown, Product::plain(length))),
                    None => {
                        if let Some(rate) = self.construction.angular_rates[link.0]?[order] {
                            right.push(Product::new(ProductKind::Turning, -1.0, &[rate, length]));
                        }
                    }
                },
                (Term::Slide(slide), _) => {
                    if let Some(unknown) = equations.slide_unknown(slide.slider) {
                        let guide = self.pose.guide(slide.slider) * slide.sign;
                        // +1 where the guide, signed away from the base, has the direction of the ray, else −1.
                        let sign = guide.dot(&quarter_turn(cut.line.direction()?)).signum();
                        left.push((unknown, Product::new(ProductKind::Sliding, sign, &[])));
                    }
                }
                (Term::Turn { .. }, None) => {}
            }
        }
        Some(Equation { left, right })
    }

    /// The equation of a relation between angles, as of gears; `None` where the rate of a known body or slider has no number.
    pub(super) fn angular_equation(&self, order: Order, terms: &AngularTerms) -> Option<Equation> {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for &(rate, weight) in &terms.rates {
            let weight = f64::from(weight);
            match rate {
                AngularRate::Unknown(unknown) => left.push((unknown, Product::new(ProductKind::Plain, weight, &[]))),
                AngularRate::Known(body) => {
                    let rate = self.construction.angular_rates[body.0]?[order];
                    right.extend(rate.map(|rate| Product::new(ProductKind::Plain, -weight, &[rate])));
                }
            }
        }
        for (slide, radius) in
            terms.travel.iter().flat_map(|travel| travel.slides.iter().map(|slide| (slide, travel.radius)))
        {
            let factor = -slide.sign / radius;
            match slide.unknown {
                Some(unknown) => left.push((unknown, Product::new(ProductKind::Plain, factor, &[]))),
                None => {
                    let rate = self.construction.slide_rates[slide.slider.0]?[order];
                    right.extend(rate.map(|rate| Product::new(ProductKind::Plain, -factor, &[rate])));
                }
            }
        }
        Some(Equation { left, right })
    }

    /// Lays off the known parts of a leg's acceleration from the plan point `from` on, each in a step of its own: the
    /// Coriolis acceleration of its slider, then its normal part. A part that is zero whatever the position, as the
    /// Coriolis acceleration on a guide that never turns, has no step. Returns name and place of the end.
    pub(super) fn known_parts(
        &mut self,
        drawn: &DrawnSpecial<'_>,
        side: usize,
        from: (String, PlaceId),
    ) -> Option<(String, PlaceId)> {
        let order = Order::Acceleration;
        let usual = drawn.special.normal_names(self.mechanism)[side].clone();
        let start = from.0.clone();
        let mut at = from;
        if let Some(slide) = drawn.special.cuts[side].slide()
            && self.slide_part_size(order, &slide, VectorPart::Coriolis).is_some_and(|sum| !sum.is_empty())
        {
            let name = drawn.special.coriolis_name(self.mechanism, side);
            let name = self.free_name(order, name);
            let of = VectorOf::Passed(slide, VectorPart::Coriolis);
            let step = self.begin(order);
            let end = self.lay_off_slide_part(order, at.1, &slide, VectorPart::Coriolis)?;
            self.show(order, &name, end, PointRole::Slid);
            self.finish(step, Action::LayOff(Arrow { order, from: at.0, to: name.clone(), of }));
            at = (name, end);
        }
        let normal = self.normal_part(drawn, side)?;
        if !normal.is_empty() {
            let of = VectorOf::Normal(drawn.id, side);
            let step = self.begin(order);
            let end = self.lay_off(order, at.1, normal, drawn.legs[side].along);
            self.show(order, &usual, end, PointRole::Normal);
            self.finish(step, Action::LayOff(Arrow { order, from: at.0, to: usual.clone(), of }));
            at = (usual.clone(), end);
        }
        self.construction.known_parts.insert(usual, [start, at.0.clone()]);
        Some(at)
    }

    /// The signed size of a leg's normal part, against the cut line: an empty sum where nothing turns.
    fn normal_part(&mut self, drawn: &DrawnSpecial<'_>, side: usize) -> Option<Vec<Product>> {
        let mut sum = Vec::new();
        for term in &drawn.special.cuts[side].terms {
            if let (Term::Turn { link, .. }, Some(length)) = (*term, self.arm_length(drawn, side, term))
                && let Some(omega) = self.construction.angular_rates[link.0]?[0]
            {
                sum.push(Product::new(ProductKind::Normal, -1.0, &[omega, omega, length]));
            }
        }
        Some(sum)
    }
}
