//! The vectors of a plan by their symbols: whole velocities and accelerations from the pole, relative ones and their
//! parts between plan points.

use super::markup::{Known, NamedPart};
use super::name::{coincident_name, image_name};
use super::plan::{Plan, PointRole};
use super::sentence::Teller;
use super::step::{Action, ArrowKind, RayOf, VectorOf};
use crate::mechanism::{BodyId, Mechanism};

/// A vector between two plan points.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanVector {
    /// The plan points where it begins and where its head is.
    pub ends: [String; 2],
    /// Its symbol in markup, as in `v_{CB}`.
    pub symbol: String,
    /// Its kind.
    pub kind: ArrowKind,
    /// The plan point with which it is there.
    pub made: String,
    /// The link that it belongs to, where a ray says so.
    pub link: Option<BodyId>,
    /// Whether a ray carries it, and no arrow.
    pub on_ray: bool,
}

impl Teller<'_> {
    /// The vectors of a plan, first the whole ones; without those that lead to special points or follow from them.
    #[must_use]
    pub fn vectors(&self, plan: &Plan) -> Vec<PlanVector> {
        let mut vectors = self.whole_vectors(plan);
        for action in &plan.steps {
            let (ends, made, formula, kind, link) = match action {
                Action::LayOff(arrow) if matches!(arrow.of, VectorOf::Point(..)) => continue,
                Action::LayOff(arrow) => {
                    if matches!(arrow.of, VectorOf::Normal(special, _) if self.construction.special(special).is_assur) {
                        continue;
                    }
                    (arrow.ends(), &arrow.to, self.lay_off(plan.sheet, arrow).0, arrow.kind(), None)
                }
                Action::Ray(ray) => {
                    let RayOf::Leg(special, side) = ray.of else { continue };
                    let special = self.construction.special(special);
                    if special.is_assur {
                        continue;
                    }
                    let formula = self.ray_equation(plan.sheet, ray);
                    let link = Some(special.cuts[side].carrier);
                    ([ray.through.as_str(), ray.to.as_str()], &ray.to, formula, ArrowKind::Relative, link)
                }
                _ => continue,
            };
            // On a ray the vector is the one whose direction alone is known, with the sign before it; else the equation
            // begins with it.
            let on_ray = link.is_some();
            let index = match on_ray {
                true => formula.terms.iter().position(|term| term.known == Known::Direction),
                false => Some(0),
            };
            let Some((index, term)) = index.and_then(|index| Some((index, formula.terms.get(index)?))) else {
                continue;
            };
            let is_minus = index > 0 && formula.terms[index - 1].markup.contains('−');
            let kind = if term.part == Some(NamedPart::Sliding) { ArrowKind::Sliding } else { kind };
            let [from, to] = if is_minus { [ends[1], ends[0]] } else { ends };
            let symbol = term.markup.split(" = ").next().unwrap_or_default();
            vectors.push(PlanVector {
                ends: [from.to_owned(), to.to_owned()],
                symbol: symbol.to_owned(),
                kind,
                made: made.clone(),
                link,
                on_ray,
            });
        }
        vectors
    }

    /// The velocities or accelerations of all points with images, and of the points under sliders.
    fn whole_vectors(&self, plan: &Plan) -> Vec<PlanVector> {
        let letter = plan.sheet.vector();
        let is_image = |name: &str| {
            let role = plan.points.get(name).map(|point| point.role);
            matches!(role, Some(PointRole::Image | PointRole::Known))
        };
        let mut names = names_of_points(self.mechanism);
        names.retain(|name| is_image(&image_name(name)));
        let vector = |name: String| PlanVector {
            ends: [plan.sheet.pole().to_owned(), image_name(&name)],
            symbol: format!("{letter}_{{{name}}}"),
            kind: ArrowKind::Whole,
            made: image_name(&name),
            link: None,
            on_ray: false,
        };
        names.into_iter().map(vector).collect()
    }
}

/// The names of all points, and of the points of guides under sliders.
fn names_of_points(mechanism: &Mechanism) -> Vec<String> {
    let under = mechanism
        .sliders
        .iter()
        .map(|slider| coincident_name(mechanism.point_name(slider.at), &mechanism.body(slider.on).name));
    mechanism.points.iter().cloned().chain(under).collect()
}
