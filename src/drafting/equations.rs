//! The legs of a special point and the equations of what is measured along them: Eqs. 7, 8, 15, 16 and 35 to 38 of Quintero et al. (2011).

use super::act::{Equation, How, LineId, NumberId, PlaceId, Product, Reference, Sheet};
use super::write::Drawn;
use super::writer::Writer;
use crate::geometry::{Vector, quarter_turn};
use crate::mechanism::{BodyId, LoopEquations, PointId, SliderId};
use crate::plan::{CutLine, LegKind, Special};

/// The directions of a leg, by what is on the scheme and quarter turns from it.
#[derive(Clone, Copy)]
pub(super) struct Leg {
    /// Along the cut line.
    pub along: (Reference, u8),
    /// Of the rays.
    pub ray: (Reference, u8),
    /// The joint through which the cut line runs.
    through: Option<PointId>,
    /// The cut line where it is drawn.
    line: Option<LineId>,
}

impl Writer<'_> {
    /// The directions of a leg. A cut line through two pins is joined; one normal to a guide has the guide for reference.
    pub(super) fn leg(&mut self, cut: &CutLine, special: &Special) -> Leg {
        let through = cut.start();
        match cut.kind {
            LegKind::Pin { outer } => self.pin_leg(outer, special.target.unwrap_or(outer)),
            LegKind::Pins { outer, inner } => self.pin_leg(outer, inner),
            LegKind::Slider { outer: slider, .. }
            | LegKind::PinThenSlider { inner: slider, .. }
            | LegKind::SliderThenPin { outer: slider, .. } => {
                let guide = Reference::Line(self.guide(slider));
                Leg { along: (guide, 1), ray: (guide, 2), through, line: None }
            }
            // The line at infinity: such a group has no construction.
            LegKind::Sliders => Leg {
                along: (Reference::Given(Vector::x()), 0),
                ray: (Reference::Given(Vector::x()), 1),
                through,
                line: None,
            },
        }
    }

    fn pin_leg(&mut self, outer: PointId, inner: PointId) -> Leg {
        let line = self.join(outer, inner);
        Leg {
            along: (Reference::Line(line), 0),
            ray: (Reference::Line(line), 1),
            through: Some(outer),
            line: Some(line),
        }
    }

    /// The cut line of a leg, drawn on the scheme.
    pub(super) fn cut_line(&mut self, leg: &mut Leg, special: &str) -> LineId {
        if let Some(line) = leg.line {
            return line;
        }
        let through: PlaceId = match leg.through {
            Some(point) => self.plot(point),
            None => self.plot_at("", self.drafting.origin),
        };
        let makes = format!("cut line of {special}");
        let line = self.draw(Sheet::Scheme, &makes, through, leg.along);
        leg.along = (Reference::Line(line), 0);
        leg.line = Some(line);
        line
    }

    /// The length from a leg's joint to the point looked for, where one enters an equation: to a special point it is measured.
    pub(super) fn reach(&mut self, drawn: &Drawn<'_>, side: usize) -> Option<NumberId> {
        let from = match drawn.special.cuts[side].kind {
            LegKind::Pins { inner, .. } | LegKind::SliderThenPin { inner, .. } => inner,
            LegKind::Pin { outer } | LegKind::PinThenSlider { outer, .. } => outer,
            LegKind::Slider { .. } | LegKind::Sliders => return None,
        };
        if let Some(target) = drawn.special.target {
            return (target != from).then(|| self.length(from, target));
        }
        let line = drawn.legs[side].line?;
        let joint = self.mechanism.point_name(from);
        let name = format!("L({joint},{})", drawn.special.name);
        let ends = [self.plot(from), drawn.place];
        let number = self.measure(Sheet::Scheme, &name, ends, How::Along(line));
        self.name_number(&name, number);
        Some(number)
    }

    /// What a leg sums along its ray: links that turn, with the length from which, and the slider that slides with its sign.
    fn terms(&mut self, drawn: &Drawn<'_>, side: usize) -> Option<Terms> {
        let cut = &drawn.special.cuts[side];
        let link = drawn.special.link;
        let mut terms = Terms::default();
        let slide = |slider, from| Some((slider, from, self.along_ray(cut, slider, from)));
        match cut.kind {
            LegKind::Pin { outer: _ } => terms.turn(link, drawn.reaches[side]),
            LegKind::Slider { outer, .. } => terms.slide = slide(outer, cut.leg.base),
            LegKind::Pins { outer, inner } => {
                let arm = self.length(outer, inner);
                terms.turn(cut.carrier, Some(arm));
                terms.turn(link, drawn.reaches[side]);
            }
            LegKind::PinThenSlider { outer: _, inner } => {
                terms.slide = slide(inner, cut.carrier);
                terms.turn(cut.carrier, drawn.reaches[side]);
            }
            LegKind::SliderThenPin { outer, inner: _ } => {
                terms.slide = slide(outer, cut.leg.base);
                terms.turn(link, drawn.reaches[side]);
            }
            LegKind::Sliders => return None,
        }
        Some(terms)
    }

    /// +1 or −1: how the guide, signed away from body `from`, lies to the ray.
    fn along_ray(&self, cut: &CutLine, slider: SliderId, from: BodyId) -> f64 {
        let ray = quarter_turn(cut.line.direction().unwrap_or_default());
        let guide = self.pose.guide(slider) * self.mechanism.slide_sign(slider, from);
        guide.dot(&ray).signum()
    }

    /// The equation of a measured segment: rates times lengths along the cut line make it up.
    pub(super) fn equation(
        &mut self,
        sheet: Sheet,
        equations: &LoopEquations,
        drawn: &Drawn<'_>,
        side: usize,
        segment: NumberId,
    ) -> Option<Equation> {
        let order = usize::from(sheet == Sheet::Acceleration);
        let terms = self.terms(drawn, side)?;
        let mut left = Vec::new();
        let mut right = vec![Product::new(1.0, &[segment])];
        for &(link, length) in &terms.turns {
            match equations.spin_unknown(link) {
                Some(unknown) => left.push((unknown, Product::new(1.0, &[length]))),
                None => {
                    if let Some(rate) = self.drafting.spins[link.0]?[order] {
                        right.push(Product::new(-1.0, &[rate, length]));
                    }
                }
            }
        }
        if let Some((slider, _, sign)) = terms.slide
            && let Some(unknown) = equations.slide_unknown(slider)
        {
            left.push((unknown, Product::new(sign, &[])));
        }
        Some(Equation { left, right })
    }

    /// The end of a leg's normal part, Coriolis's included, laid off along the cut line.
    pub(super) fn normal(&mut self, drawn: &Drawn<'_>, side: usize, from: PlaceId) -> Option<PlaceId> {
        let terms = self.terms(drawn, side)?;
        let mut sum = Vec::new();
        for &(link, length) in &terms.turns {
            if let Some(omega) = self.drafting.spins[link.0]?[0] {
                sum.push(Product::new(-1.0, &[omega, omega, length]));
            }
        }
        if let Some((slider, carries, sign)) = terms.slide {
            let omega = self.drafting.spins[carries.0]?[0];
            let velocity = self.drafting.slides[slider.0]?[0];
            if let (Some(omega), Some(velocity)) = (omega, velocity) {
                // The guide turned by a quarter lies along the cut line, against the ray turned by one.
                sum.push(Product::new(-2.0 * sign, &[omega, velocity]));
            }
        }
        let name = drawn.special.normal_names(self.mechanism)[side].clone();
        let along = drawn.legs[side].along;
        Some(self.lay_off(Sheet::Acceleration, &name, from, sum, along))
    }
}

/// What a leg sums.
#[derive(Default)]
struct Terms {
    /// A link and the length from one of its points, along the cut line.
    turns: Vec<(BodyId, NumberId)>,
    /// A slider, the body that it leaves, and how its guide lies to the ray.
    slide: Option<(SliderId, BodyId, f64)>,
}

impl Terms {
    fn turn(&mut self, link: BodyId, length: Option<NumberId>) {
        self.turns.extend(length.map(|length| (link, length)));
    }
}
