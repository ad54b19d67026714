//! Masses and loads as the sheet of a student gives them.

use super::sheets::Teller;
use crate::construction::{LoadShown, Solution, display};
use crate::forces::Source;
use crate::quantity::{Quantity, QuantityKind};
use crate::scene::{Amount, Analysis, ForceUnit, MassUnit};
use crate::sheet::Sheet;
use serde_json::Value;

impl Teller<'_> {
    /// Masses, the acceleration of free fall, forces and couples; with inertia also the accelerations from which its forces follow, where no plan
    /// gives them. Where loads act the scheme shows.
    pub fn loads(&self, solution: &Solution, file: &Value) -> Vec<String> {
        let Some(loads) = solution.mechanism.loads.as_ref().map(|loads| &loads.0) else { return Vec::new() };
        let by_hand = &solution.construction.by_hand;
        if !by_hand.contains(&Sheet::Forces) && !by_hand.contains(&Sheet::Lever) {
            return Vec::new();
        }
        let has_inertia = loads.analysis == Analysis::Dynamic;
        let needs_accelerations = has_inertia && !by_hand.contains(&Sheet::Acceleration);
        let mut told = Vec::new();
        for (link, mass) in &loads.masses {
            told.push(match mass.amount {
                Amount::Mass(amount) => self.amount(&format!("m_{{{link}}}"), amount, &self.mass_unit()),
                Amount::Weight(weight) => self.value(
                    &format!("{}_{{{link}}}", self.words.language.weight_letter()),
                    weight,
                    QuantityKind::Force,
                ),
            });
            if has_inertia && mass.inertia != 0.0 {
                let unit = format!("{} {}²", self.mass_unit(), self.unit(QuantityKind::Length));
                told.push(self.amount(&format!("J_{{{link}}}"), mass.inertia, &unit));
            }
            if needs_accelerations {
                told.extend(self.acceleration(solution, link));
                if let Ok(Quantity::Number(alpha)) = solution.quantity(&format!("alpha({link})"))
                    && mass.inertia != 0.0
                {
                    told.push(self.value(&format!("α_{{{link}}}"), alpha, QuantityKind::AngularAcceleration));
                }
            }
        }
        if loads.gravity != [0.0; 2] && !loads.masses.is_empty() {
            let [x, y] = loads.gravity;
            told.push(self.value("g", libm::hypot(x, y), QuantityKind::Acceleration));
        }
        for (index, load) in loads.loads.iter().enumerate() {
            let name = display(&load.name);
            // What changes over the motion is given as it is in this position.
            let (force, couple, written) = match &load.over {
                Some(_) => {
                    let Some(acting) = plan_load(solution, index) else { continue };
                    (acting.force.map(four_digits).into(), four_digits(acting.couple), &Value::Null)
                }
                None => (load.force, load.couple, &file["forces"][index]["force"]),
            };
            if force != [0.0; 2] {
                told.push(self.force(&name, force, written));
            }
            if couple != 0.0 {
                told.push(self.value(&name, couple, QuantityKind::Moment));
            }
        }
        told
    }

    fn mass_unit(&self) -> String {
        self.scene.units.mass.map_or("", MassUnit::as_str).to_owned()
    }

    fn amount(&self, symbol: &str, x: f64, unit: &str) -> String {
        format!("{symbol} = {} {unit}", self.number(x))
    }

    /// The acceleration of a link's centre of mass.
    fn acceleration(&self, solution: &Solution, link: &str) -> Option<String> {
        let part = |part: &str| solution.quantity(&format!("a_cm({link}).{part}")).ok().map(Quantity::as_number);
        let (size, angle) = (part("size")?, part("angle")?);
        let size = format!("{} {}", self.number(size), self.unit(QuantityKind::Acceleration));
        let angle = self.number(libm::round(angle * 100.0) / 100.0);
        Some(format!("a_{{cm{link}}} = {}", self.words.language.with_direction(&size, &angle)))
    }

    /// A force as the file writes it.
    fn force(&self, name: &str, force: [f64; 2], written: &Value) -> String {
        let unit = self.scene.units.force.map_or("", ForceUnit::as_str);
        match ["size", "angle"].map(|part| written[part].as_f64()) {
            [Some(size), Some(angle)] => {
                let size = format!("{} {unit}", self.number(size));
                format!("{name} = {}", self.words.language.with_direction(&size, &self.number(angle)))
            }
            _ => format!("{name} = {} {unit}", self.pair(force)),
        }
    }
}

/// A given load as it acts in the position.
fn plan_load(solution: &Solution, index: usize) -> Option<&LoadShown> {
    let plan = solution.construction.forces.as_deref()?;
    plan.loads.iter().find(|load| load.source == Source::Given(index))
}

/// A number rounded to four digits, which no hand can tell from all of them.
fn four_digits(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}
