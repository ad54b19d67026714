//! The sentences of the steps of the speed diagram, and what it lacks.

use super::{SpeedDiagram, SpeedStep};
use crate::construction::markup::{Formula, marked, rate_symbol};
use crate::construction::number::Rate;
use crate::construction::sentence::Teller;
use crate::construction::step::Action;
use crate::mechanism::BodyId;
use crate::sheet::{Order, QuantityKind};

impl Teller<'_> {
    /// The symbol of a link's angular velocity on the diagram, or of its speed in turns a minute.
    #[must_use]
    pub fn speed_symbol(&self, link: BodyId) -> String {
        let symbol = rate_symbol(&Rate::Angular(Order::Velocity, link).name(self.mechanism));
        let is_in_turns = self.construction.speeds.as_ref().is_some_and(|diagram| diagram.turns.is_some());
        if is_in_turns { symbol.replacen('ω', "n", 1) } else { symbol }
    }

    fn speed_step(&self, action: &Action) -> Option<(&SpeedDiagram, SpeedStep)> {
        let Action::Speeds(step) = action else { return None };
        Some((self.construction.speeds.as_ref()?, *step))
    }

    /// The caption of a step of the diagram; none for other steps.
    pub(in crate::construction) fn caption_of_speeds(&self, action: &Action) -> Option<String> {
        let (diagram, step) = self.speed_step(action)?;
        let language = self.words.language;
        let name = |spot: usize| marked(&diagram.spots[spot].name);
        Some(match step {
            SpeedStep::Train => {
                let turned = self.turned_in_speeds(&marked);
                std::iter::once(language.speeds_train().to_owned()).chain(turned).collect::<Vec<_>>().join(" ")
            }
            SpeedStep::Pole => language.speeds_pole().to_owned(),
            SpeedStep::Line(index) => {
                let line = diagram.lines.get(index)?;
                let [from, to] = line.through.map(name);
                let link = &self.mechanism.body(line.link).name;
                match (line.slides, line.follows) {
                    (false, true) => language.speeds_line(link, &from, &to),
                    (false, false) => language.speeds_given(link, &from, &to),
                    (true, true) => language.speeds_slides(link, &from),
                    (true, false) => language.speeds_slides_given(link, &from),
                }
            }
            SpeedStep::Belt { from, to, .. } => language.speeds_belt(&name(from), &name(to)),
            SpeedStep::Ray(index) => {
                let link = diagram.lines.get(index)?.link;
                language.speeds_ray(&self.mechanism.body(link).name, &self.speed_symbol(link))
            }
        })
    }

    /// The sentence on centres that are turned onto the line of the others, with their names as `shown`; none where there are none.
    pub(crate) fn turned_in_speeds(&self, shown: &dyn Fn(&str) -> String) -> Option<String> {
        let turned = &self.construction.speeds.as_ref()?.turned;
        let names: Vec<String> = turned.iter().map(|&point| shown(self.mechanism.point_name(point))).collect();
        (!names.is_empty()).then(|| self.words.language.speeds_turned(&names.join(", ")))
    }

    /// The symbol of what such a step finds.
    pub(in crate::construction) fn formula_of_speeds(&self, action: &Action) -> Option<Formula> {
        let (diagram, SpeedStep::Ray(index)) = self.speed_step(action)? else { return None };
        Some(self.speed_symbol(diagram.lines.get(index)?.link).into())
    }

    /// The number that such a step finds, and its kind.
    pub(in crate::construction) fn value_of_speeds(&self, action: &Action) -> Option<(f64, QuantityKind)> {
        let (diagram, SpeedStep::Ray(index)) = self.speed_step(action)? else { return None };
        Some((diagram.rate(diagram.lines.get(index)?), diagram.kind()))
    }

    /// What is said of a figure whose diagram lacks meshes, racks or belts, or that has none.
    pub(in crate::construction) fn missing_of_speeds(&self, is_asked: bool) -> Vec<String> {
        let language = self.words.language;
        if !is_asked {
            return Vec::new();
        }
        let unsized_belts = self.mechanism.joints.iter().filter(|joint| joint.belt.is_some_and(|belt| !belt.is_sized));
        let mut missing: Vec<String> = unsized_belts
            .map(|joint| {
                let [first, second] = joint.bodies.map(|body| &self.mechanism.body(body).name);
                language.speeds_unsized_belt(first, second)
            })
            .collect();
        match &self.construction.speeds {
            None => missing.insert(0, language.speeds_none().to_owned()),
            Some(diagram) if !diagram.left_out.is_empty() => {
                let names: Vec<String> = diagram.left_out.iter().map(|name| marked(name)).collect();
                let centers = diagram.spots.iter().filter(|spot| matches!(spot.at, super::SpotName::Center(_)));
                let line: Vec<String> = centers.map(|spot| marked(&spot.name)).collect();
                missing.push(language.speeds_left_out(&names.join(", "), &line.join(", ")));
            }
            Some(_) => {}
        }
        missing
    }
}
