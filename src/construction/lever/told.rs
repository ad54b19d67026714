//! Captions, equations and symbols of the steps of a lever.

use super::{LeverForce, LeverStep};
use crate::construction::markup::{Formula, rate_symbol};
use crate::construction::number::Rate;
use crate::construction::sentence::Teller;
use crate::construction::step::Action;
use crate::forces::Driven;
use crate::sheet::{Order, QuantityKind, Sheet};
use crate::words::SlidePart;

impl Teller<'_> {
    /// The symbol of what a drive needs.
    #[must_use]
    pub fn effort_symbol(&self, drive: Driven) -> String {
        match drive {
            Driven::Body(body) => self.torque_symbol(body),
            Driven::Slider(slider) => self.push_symbol(slider),
        }
    }

    /// The symbol of a force on a lever: of a couple's two forces that over a distance.
    #[must_use]
    pub fn lever_symbol(&self, force: &LeverForce) -> String {
        let loads = self.construction.forces.as_ref().map(|plan| &plan.loads);
        let Some(load) = loads.and_then(|loads| loads.get(force.load)) else { return String::new() };
        match force.is_of_couple {
            true => format!("{}/L", self.couple_symbol(load.source, load.body)),
            false => self.load_symbol(load.source, load.body),
        }
    }

    /// The caption of a step of a lever; none for other steps.
    pub(in crate::construction) fn caption_of_lever(&self, action: &Action) -> Option<String> {
        let Action::Lever(step) = action else { return None };
        let language = self.words.language;
        let levers = &self.construction.levers;
        Some(match *step {
            LeverStep::Turn(index) => match levers.get(index)?.drive {
                _ if levers.len() == 1 => language.lever_turn().to_owned(),
                Driven::Body(body) => language.lever_turn_for(&self.link_in_symbol(body)),
                Driven::Slider(slider) => language.lever_turn_for(&self.slider_name(slider)),
            },
            LeverStep::Arm(index, force) => {
                language.lever_arm(&self.lever_symbol(levers.get(index)?.forces.get(force)?))
            }
            LeverStep::Effort(index) => language.lever_effort(&self.effort_symbol(levers.get(index)?.drive)),
        })
    }

    /// The equation of such a step.
    pub(in crate::construction) fn formula_of_lever(&self, action: &Action) -> Option<Formula> {
        let Action::Lever(step) = action else { return None };
        let levers = &self.construction.levers;
        Some(match *step {
            LeverStep::Turn(_) => Formula::default(),
            LeverStep::Arm(index, force) => {
                let symbol = self.lever_symbol(levers.get(index)?.forces.get(force)?);
                format!("{symbol} · h {}", Sheet::Lever.facts().scale_symbol).into()
            }
            LeverStep::Effort(index) => {
                let lever = levers.get(index)?;
                let effort = self.effort_symbol(lever.drive);
                let rate = match lever.drive {
                    Driven::Body(body) => rate_symbol(&Rate::Angular(Order::Velocity, body).name(self.mechanism)),
                    Driven::Slider(slider) => self.slide(Order::Velocity, SlidePart::Relative, slider),
                };
                format!("{effort} · {rate} = −Σ F h {},   {effort}", Sheet::Lever.facts().scale_symbol).into()
            }
        })
    }

    /// The number that such a step finds, and its kind.
    pub(in crate::construction) fn value_of_lever(&self, action: &Action) -> Option<(f64, QuantityKind)> {
        if let Action::Lever(LeverStep::Arm(index, force)) = action {
            // Of a load with several forces no one of them has its power.
            let lever = self.construction.levers.get(*index)?;
            let load = lever.forces.get(*force)?.load;
            let is_alone = lever.forces.iter().filter(|other| other.load == load).count() == 1;
            let power = lever.powers.iter().find(|power| power.load == load && power.name.is_some());
            let power = power.filter(|_| is_alone)?;
            return Some((self.construction.record.exact.numbers[power.number.0].high, QuantityKind::Power));
        }
        let Action::Lever(LeverStep::Effort(index)) = action else { return None };
        let lever = self.construction.levers.get(*index)?;
        let kind = if matches!(lever.drive, Driven::Body(_)) { QuantityKind::Moment } else { QuantityKind::Force };
        Some((lever.effort, kind))
    }
}
