//! The legs of a special point: their lines, the equations of what is measured along them (Eqs. 7, 8, 15, 16 and 35 to 38 of Quintero et al., 2011), their
//! normal parts.

use super::cut::{Course, CutLine, Special, SpecialId, Term};
use super::operation::{
    Along, End, Equation, How, LineId, NumberId, NumberKind, Part, PlaceId, Product, ProductKind, Sheet,
};
use super::writer::Writer;
use crate::geometry::quarter_turn;
use crate::mechanism::{BodyId, LoopEquations, PointId, SliderId};

/// A leg as it is drawn.
#[derive(Clone, Copy)]
pub(super) struct Leg {
    /// Along the cut line.
    pub along: Along,
    /// Of the rays.
    pub ray: Along,
    /// The cut line where it is drawn.
    line: Option<LineId>,
}

/// A special point as it is drawn.
pub(super) struct Drawn<'a> {
    pub special: &'a Special,
    pub id: SpecialId,
    pub legs: [Leg; 2],
    /// Where it is on the scheme.
    pub place: PlaceId,
    /// By leg: the length from its joint to it, where one enters an equation.
    pub reaches: [Option<NumberId>; 2],
}

/// What a leg adds, in numbers.
enum Summand {
    /// A link turns with this length.
    Turn(BodyId, NumberId),
    /// A slider slides; the body with which its guide turns; +1 or −1: how the guide, signed away from that body, lies to the ray.
    Slide(SliderId, BodyId, f64),
}

impl Writer<'_> {
    /// The directions of a leg whose cut line is not at infinity. A cut line through two pins is joined; one normal to a guide has the guide for reference.
    pub(super) fn leg(&mut self, cut: &CutLine, target: Option<PointId>) -> Option<Leg> {
        cut.line.direction()?;
        match cut.course {
            Course::Through(from, to) => {
                let line = self.join(from, to.or(target)?);
                let along = Along::line(line);
                Some(Leg { along, ray: along.turned(1), line: Some(line) })
            }
            Course::Normal(slider, _) => {
                let guide = Along::line(self.guide(slider));
                Some(Leg { along: guide.turned(1), ray: guide.turned(2), line: None })
            }
            Course::AtInfinity => None,
        }
    }

    /// The cut line of a leg, drawn on the scheme.
    pub(super) fn cut_line(&mut self, leg: &mut Leg, cut: &CutLine, special: SpecialId) -> Option<LineId> {
        if leg.line.is_none() {
            let through = self.plot(cut.start()?);
            let line = self.draw(Sheet::Scheme, Part::CutLine(special), through, leg.along);
            leg.along = Along::line(line);
            leg.line = Some(line);
        }
        leg.line
    }

    /// The length from a leg's joint to the point looked for, where one enters an equation: to a special point it is measured.
    pub(super) fn reach(&mut self, drawn: &Drawn<'_>, side: usize) -> Option<NumberId> {
        let from = drawn.special.cuts[side].measured_from()?;
        if let Some(target) = drawn.special.target {
            return (target != from).then(|| self.length(from, target));
        }
        let line = drawn.legs[side].line?;
        let ends = [self.plot(from), drawn.place];
        let kind = NumberKind::Length([End::Joint(from), End::Special(drawn.id)]);
        Some(self.measure(Sheet::Scheme, kind, ends, How::Along(line)))
    }

    /// What a leg adds, in numbers; lengths that are nothing are left out.
    fn summands(&mut self, drawn: &Drawn<'_>, side: usize) -> Vec<Summand> {
        let cut = &drawn.special.cuts[side];
        let summand = |term: &Term| match *term {
            Term::Turn { link, from, to: Some(to) } => Some(Summand::Turn(link, self.length(from, to))),
            Term::Turn { link, to: None, .. } => drawn.reaches[side].map(|length| Summand::Turn(link, length)),
            Term::Slide { slider, from } => {
                let ray = quarter_turn(cut.line.direction()?);
                let guide = self.pose.guide(slider) * self.mechanism.slide_sign(slider, from);
                Some(Summand::Slide(slider, from, guide.dot(&ray).signum()))
            }
        };
        cut.terms.iter().filter_map(summand).collect()
    }

    /// The equation of a measured segment: what the leg adds makes it up.
    pub(super) fn equation(
        &mut self,
        sheet: Sheet,
        equations: &LoopEquations,
        drawn: &Drawn<'_>,
        side: usize,
        segment: NumberId,
    ) -> Option<Equation> {
        let (mut left, mut right) = (Vec::new(), vec![Product::plain(segment)]);
        for summand in self.summands(drawn, side) {
            match summand {
                Summand::Turn(link, length) => match equations.spin_unknown(link) {
                    Some(unknown) => left.push((unknown, Product::plain(length))),
                    None => {
                        if let Some(rate) = self.construction.spins[link.0]?[sheet.order()] {
                            right.push(Product::new(ProductKind::Turning, -1.0, &[rate, length]));
                        }
                    }
                },
                Summand::Slide(slider, _, sign) => {
                    if let Some(unknown) = equations.slide_unknown(slider) {
                        left.push((unknown, Product::new(ProductKind::Sliding, sign, &[])));
                    }
                }
            }
        }
        Some(Equation { left, right })
    }

    /// The end of a leg's normal part, Coriolis's included, laid off along the cut line.
    pub(super) fn normal(&mut self, drawn: &Drawn<'_>, side: usize, from: PlaceId) -> Option<PlaceId> {
        let mut sum = Vec::new();
        for summand in self.summands(drawn, side) {
            match summand {
                Summand::Turn(link, length) => {
                    if let Some(omega) = self.construction.spins[link.0]?[0] {
                        sum.push(Product::new(ProductKind::Normal, -1.0, &[omega, omega, length]));
                    }
                }
                Summand::Slide(slider, carries, sign) => {
                    let omega = self.construction.spins[carries.0]?[0];
                    let velocity = self.construction.slides[slider.0]?[0];
                    if let (Some(omega), Some(velocity)) = (omega, velocity) {
                        // The guide turned by a quarter lies along the cut line, against the ray turned by one.
                        sum.push(Product::new(ProductKind::Coriolis, -2.0 * sign, &[omega, velocity]));
                    }
                }
            }
        }
        Some(self.lay_off(Sheet::Acceleration, from, sum, drawn.legs[side].along))
    }
}
