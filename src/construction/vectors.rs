//! The vectors of a plan by their symbols.

use super::arrow::{Arrow, Ray, RayOf, VectorOf, VectorPart};
use super::markup::Known;
use super::name::{coincident_name, image_name};
use super::plan::{Plan, PointRole};
use super::sentence::Teller;
use super::step::Action;
use crate::mechanism::BodyId;

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

impl Teller<'_> {
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
