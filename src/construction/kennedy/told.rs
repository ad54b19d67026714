//! What is said of instant centres: captions, equations and symbols.

use super::symbol::{link_in_words, symbol};
use super::{Center, CenterId, CenterLine, CenterOrigin, CenterVelocity, CurvatureStep, FigureOf, Spot};
use crate::centers::{LinkPair, link_in_index};
use crate::construction::markup::{Formula, display, rate_symbol};
use crate::construction::number::Rate;
use crate::construction::sentence::Teller;
use crate::construction::step::Action;
use crate::geometry::Place;
use crate::mechanism::{BodyId, GROUND};
use crate::sheet::{Order, QuantityKind};
use crate::words::{SlidePart, under};

impl Teller<'_> {
    /// The symbol of the centre of two links in markup, as `P_{13}`; of a centre without a link with primes.
    #[must_use]
    pub fn center_symbol(&self, pair: LinkPair, figure: FigureOf) -> String {
        symbol(pair, figure, self.mechanism, self.words)
    }

    /// A link in the index of a symbol.
    #[must_use]
    pub fn link_in_symbol(&self, link: BodyId) -> String {
        link_in_index(link, self.mechanism, &self.words.notation, &|name| {
            link_in_words(name, self.mechanism, self.words)
        })
    }

    fn symbol_of(&self, id: CenterId) -> String {
        self.construction.center(id).map_or_else(String::new, |center| self.center_symbol(center.pair, center.figure))
    }

    /// A line by the symbols of its two centres.
    fn line_by_centers(&self, line: &CenterLine) -> String {
        line.through.map(|id| self.symbol_of(id)).join(" ")
    }

    /// The caption of a step that leads to a centre or to a velocity by centres; none for other steps.
    pub(in crate::construction) fn caption_of_centers(&self, action: &Action) -> Option<String> {
        let language = self.words.language;
        let centers = self.construction.centers.as_ref()?;
        Some(match action {
            Action::PermanentCenters => {
                let permanent = centers.all.iter().filter(|center| center.is_permanent());
                let listed: Vec<String> = permanent.map(|center| self.permanent(center)).collect();
                language.permanent_centers(&listed.join(", "))
            }
            Action::CenterLine { pair, figure, line, .. } => {
                let found = self.center_symbol(*pair, *figure);
                let [first, second] = line.through.map(|id| centers.get(id));
                let [a, b] = line.through.map(|id| self.symbol_of(id));
                match (first.spot, second.spot) {
                    (Spot::Towards(_), _) => language.center_line_towards(&b, &a, &found),
                    (_, Spot::Towards(_)) => language.center_line_towards(&a, &b, &found),
                    _ => language.center_line(&a, &b, &found),
                }
            }
            Action::Center(id) => {
                let center = centers.get(*id);
                let found = self.center_symbol(center.pair, center.figure);
                let CenterOrigin::Lines { lines: [first, second], .. } = &center.origin else { return None };
                let [a, b] = [first, second].map(|line| self.line_by_centers(line));
                match (center.place, first.line, second.line) {
                    (Place::At(_), ..) => language.center_cross(&found, &a, &b),
                    (_, Some(_), Some(_)) => language.center_parallel(&found, &a, &b),
                    (_, Some(_), None) => language.center_along(&found, &a),
                    (_, None, _) => language.center_along(&found, &b),
                }
            }
            Action::LeaveOut { center, figure } => {
                let FigureOf::Glued { without, together, .. } = *figure else { return None };
                let [a, b] = together.links().map(|link| self.link_in_symbol(link));
                let center = self.center_symbol(*center, *figure);
                language.leave_out(&self.link_in_symbol(without), &a, &b, &center)
            }
            Action::CentersByRates(pairs) => {
                let symbols: Vec<String> =
                    pairs.iter().map(|pair| self.center_symbol(*pair, FigureOf::Mechanism)).collect();
                language.centers_by_rates(&symbols.join(", "))
            }
            Action::RateByCenters { link, driver, .. } => {
                let common = LinkPair::new(*link, *driver)?;
                let [driver, own] = [*driver, *link].map(|link| self.link_in_symbol(link));
                let symbol = self.center_symbol(common, FigureOf::Mechanism);
                language.rate_by_centers(&self.omega(*link), &driver, &own, &symbol)
            }
            Action::RateBySlide { link, at, slider, .. } => {
                let symbol = self.center_symbol(*at, FigureOf::Mechanism);
                let speed = self.slide(Order::Velocity, SlidePart::Relative, *slider);
                language.rate_by_slide(&self.omega(*link), &self.link_in_symbol(*link), &symbol, &speed)
            }
            Action::VelocityByCenters(index) => {
                let velocity = centers.velocities.get(*index)?;
                let point = display(self.mechanism.point_name(velocity.point));
                let vector = format!("v_{{{}}}", self.mechanism.point_name(velocity.point));
                match self.turns_about(velocity) {
                    Some(center) => language.velocity_by_centers(&vector, &center, &point),
                    None if velocity.link == velocity.driver => {
                        let slider = velocity.push?.slider;
                        language.velocity_along_guide(&vector, &self.slider_name(slider))
                    }
                    None => {
                        let common = LinkPair::new(velocity.driver, velocity.link)?;
                        let common = self.center_symbol(common, FigureOf::Mechanism);
                        language.velocity_of_center(&vector, &common, &self.link_in_symbol(velocity.link))
                    }
                }
            }
            Action::Curvature { index, step } => self.caption_of_curvature(*index, *step)?,
            _ => return None,
        })
    }

    fn caption_of_curvature(&self, index: usize, step: CurvatureStep) -> Option<String> {
        let (language, centers) = (self.words.language, self.construction.centers.as_ref()?);
        let met = |crossing: Place| match crossing {
            Place::At(_) => "Q".to_owned(),
            Place::AtInfinity(_) => language.at_infinity("Q"),
        };
        if let CurvatureStep::Axis | CurvatureStep::Tangent = step {
            let tangent = centers.tangents.get(index)?;
            let pole = self.symbol_of(tangent.pole);
            let [a, b] = tangent.rays.map(|ray| self.symbol_of(ray.pin));
            let [c, d] = tangent.rays.map(|ray| self.symbol_of(ray.center));
            return Some(match step {
                CurvatureStep::Axis => language.collineation_axis(&a, &b, &c, &d, &pole, &met(tangent.crossing)),
                _ => language.pole_tangent(&self.link_in_symbol(tangent.link), &pole, &a, &b),
            });
        }
        if let CurvatureStep::InflectionPoint | CurvatureStep::InflectionPole = step {
            let found = centers.inflections.get(index)?;
            let tangent = centers.tangents.get(found.tangent)?;
            let [pole, pin, fixed] =
                [tangent.pole, tangent.rays[found.by].pin, tangent.rays[found.by].center].map(|id| self.symbol_of(id));
            let is_pin = found.measured.is_empty();
            return Some(match step {
                CurvatureStep::InflectionPoint if is_pin => language.inflection_in_pin(&pin, &fixed),
                CurvatureStep::InflectionPoint => language.inflection_point(&pole, &pin, &fixed),
                _ => language.inflection_pole(
                    &pole,
                    &self.inflection_symbol(tangent.link),
                    if is_pin { &pin } else { "J" },
                ),
            });
        }
        let found = centers.curvatures.get(index)?;
        let tangent = centers.tangents.get(found.tangent)?;
        let (point, ray) = (display(self.mechanism.point_name(found.point)), tangent.rays[found.by]);
        let [pin, fixed] = [ray.pin, ray.center].map(|id| self.symbol_of(id));
        Some(match (step, found.center) {
            (CurvatureStep::OwnAxis, _) => {
                language.axis_of_point(&self.symbol_of(tangent.pole), &point, &pin, &met(found.crossing))
            }
            (_, Place::At(_)) => language.center_of_curvature(&point, &fixed, &under(&point, "0")),
            (_, Place::AtInfinity(_)) => language.path_inflection(&point, &fixed),
        })
    }

    /// The symbol of the inflection pole of a link.
    fn inflection_symbol(&self, link: BodyId) -> String {
        format!("W_{{{}}}", self.link_in_symbol(link))
    }

    fn permanent(&self, center: &Center) -> String {
        let (language, symbol) = (self.words.language, self.center_symbol(center.pair, center.figure));
        match center.origin {
            CenterOrigin::Pin(point) => language.center_in(&symbol, &display(self.mechanism.point_name(point))),
            CenterOrigin::Mesh(_) => language.center_of_mesh(&symbol),
            CenterOrigin::Guide(slider) => language.center_normal_to(&symbol, &self.slider_name(slider)),
            CenterOrigin::Lines { .. } => symbol,
        }
    }

    /// The symbol of a link's angular velocity.
    fn omega(&self, link: BodyId) -> String {
        rate_symbol(&Rate::Angular(Order::Velocity, link).name(self.mechanism))
    }

    /// The fixed centre of the link of a velocity; none where the link does not turn.
    fn turns_about(&self, velocity: &CenterVelocity) -> Option<String> {
        let pair = LinkPair::new(velocity.link, GROUND)?;
        let centers = self.construction.centers.as_ref()?;
        let center = centers.get(centers.of(pair)?);
        matches!(center.spot, Spot::At(_)).then(|| self.center_symbol(pair, FigureOf::Mechanism))
    }

    /// The equation of such a step.
    pub(in crate::construction) fn formula_of_centers(&self, action: &Action) -> Option<Formula> {
        let centers = self.construction.centers.as_ref()?;
        let fixed = |link: BodyId| Some(self.center_symbol(LinkPair::new(link, GROUND)?, FigureOf::Mechanism));
        Some(match action {
            Action::Center(id) => {
                let center = centers.get(*id);
                let CenterOrigin::Lines { lines, .. } = &center.origin else { return None };
                let [a, b] = lines.each_ref().map(|line| self.line_by_centers(line));
                format!("{} = {a} × {b}", self.center_symbol(center.pair, center.figure)).into()
            }
            Action::RateByCenters { link, driver, .. } => {
                let [own, given] = [*link, *driver].map(|link| self.omega(link));
                let pair = LinkPair::new(*link, *driver)?;
                let common = self.center_symbol(pair, FigureOf::Mechanism);
                let is_far = centers.of(pair).is_some_and(|id| matches!(centers.get(id).spot, Spot::Towards(_)));
                match is_far {
                    true => format!("{own} = {given}").into(),
                    false => {
                        format!("{own} = {given} · {} {common} / {} {common}", fixed(*driver)?, fixed(*link)?).into()
                    }
                }
            }
            Action::RateBySlide { link, at, slider, .. } => {
                let speed = self.slide(Order::Velocity, SlidePart::Relative, *slider);
                let symbol = self.center_symbol(*at, FigureOf::Mechanism);
                format!("{} = {speed} / {} {symbol}", self.omega(*link), fixed(*link)?).into()
            }
            Action::VelocityByCenters(index) => {
                let velocity = centers.velocities.get(*index)?;
                let point = self.mechanism.point_name(velocity.point);
                let product = match self.turns_about(velocity) {
                    Some(center) => format!("{} · {center} {}", self.omega(velocity.link), display(point)),
                    None if velocity.link == velocity.driver => {
                        self.slide(Order::Velocity, SlidePart::Relative, velocity.push?.slider)
                    }
                    None => {
                        let pair = LinkPair::new(velocity.driver, velocity.link)?;
                        let common = self.center_symbol(pair, FigureOf::Mechanism);
                        format!("{} · {} {common}", self.omega(velocity.driver), fixed(velocity.driver)?)
                    }
                };
                format!("v_{{{point}}} = {product}").into()
            }
            Action::Curvature { index, step: CurvatureStep::InflectionPoint } => {
                let found = centers.inflections.get(*index).filter(|found| !found.measured.is_empty())?;
                let tangent = centers.tangents.get(found.tangent)?;
                let [pole, pin, fixed] = [tangent.pole, tangent.rays[found.by].pin, tangent.rays[found.by].center]
                    .map(|id| self.symbol_of(id));
                format!("{pin} J = {pin} {pole}^2 / {pin} {fixed}").into()
            }
            Action::Curvature { index, step: CurvatureStep::Center } => {
                let found = centers.curvatures.get(*index)?;
                found.radius?;
                let point = display(self.mechanism.point_name(found.point));
                format!("ρ_{{{point}}} = {point} {}", under(&point, "0")).into()
            }
            _ => return None,
        })
    }

    /// The sine of the angle between the lines of a centre; none where one of them is at infinity, and of a permanent one.
    #[must_use]
    pub fn sine_of_center(&self, id: CenterId) -> Option<f64> {
        let center = self.construction.center(id)?;
        match (&center.origin, center.place) {
            (CenterOrigin::Lines { sine, .. }, Place::At(_)) => Some(*sine),
            _ => None,
        }
    }

    /// The number that a step finds which is no segment of a plan, and its kind.
    #[must_use]
    pub fn value_of_step(&self, action: &Action) -> Option<(f64, QuantityKind)> {
        let found = self.value_of_centers(action).or_else(|| self.value_of_forces(action));
        found.or_else(|| self.value_of_lever(action)).or_else(|| self.value_of_speeds(action))
    }

    /// The number that such a step finds, and its kind.
    fn value_of_centers(&self, action: &Action) -> Option<(f64, QuantityKind)> {
        match action {
            Action::RateByCenters { value, .. } | Action::RateBySlide { value, .. } => {
                Some((*value, QuantityKind::AngularVelocity))
            }
            Action::VelocityByCenters(index) => {
                let velocity = self.construction.centers.as_ref()?.velocities.get(*index)?;
                Some((velocity.velocity.norm(), QuantityKind::Velocity))
            }
            Action::Curvature { index, step: CurvatureStep::Center } => {
                let found = self.construction.centers.as_ref()?.curvatures.get(*index)?;
                Some((found.radius?, QuantityKind::Length))
            }
            _ => None,
        }
    }
}
