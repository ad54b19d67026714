//! A drawing as a form of measured values, by which it is checked and marked like any other.

use super::file::HandDrawing;
use super::judge::{Judge, JudgedDrawing};
use super::table::Table;
use crate::check::{FormBox, Given as GivenValue, Measured, form_boxes};
use crate::construction::PointRole;
use crate::quantity::{QuantityRequest, What};
use crate::scene::{Component, QuantityName};
use crate::sheet::{Scales, Sheet};

impl Judge {
    /// The form that the hand would fill in: of the values that the scene's form asks for those that its drawing gives. A number to which
    /// nothing leads that is drawn is no finding.
    #[must_use]
    pub fn form(&self, drawing: &HandDrawing, judged: &JudgedDrawing) -> Measured {
        let (mut table, _) = self.drawn(drawing);
        table.numbers.retain(|name, _| !judged.unfounded.contains(name));
        let scales: Scales = self.scales(drawing).map(Some);
        let mut form = Measured::empty(scales, None);
        form.name.clone_from(&drawing.name);
        form.exercise.clone_from(&drawing.exercise);
        form.hints = drawing.hints;
        for asked in form_boxes(&self.given().solution) {
            let name = asked.asked.name();
            // What the hand has found itself, or what its sheets show; what the scene gives is no finding.
            let is_of_sheets = matches!(asked.asked.what, What::Segment(..) | What::Length(..));
            // A block turns as its lever does.
            let is_same = |own: &str| self.given().same_rates(name).any(|same| same == own);
            let is_it = |own: &str| own == name || name.strip_suffix(".size") == Some(own) || is_same(own);
            let found = table.numbers().find(|(own, _)| is_it(own)).map(|(_, number)| number);
            let number = self.center(&table, &asked.asked).or(found);
            let number = number.or_else(|| table.known(name).filter(|_| is_of_sheets));
            if let Some(number) = number.filter(|number| number.is_finite()) {
                form.values.push(GivenValue {
                    name: asked.name.clone(),
                    text: number.to_string(),
                    unit: None,
                    place: format!("values.{}", asked.name).into(),
                });
            }
        }
        form
    }

    /// What the scene's form asks for and a drawing's form does not have, by the names of its boxes. Where all points and rates are there, no
    /// parts on another way to them are missing: a tangential part may be laid off before the normal one.
    #[must_use]
    pub fn missing(&self, form: &Measured) -> Vec<String> {
        let is_there = |asked: &FormBox| form.values.iter().any(|value| value.name == asked.name);
        let boxes = form_boxes(&self.given().solution).into_iter();
        let (on_the_way, results): (Vec<FormBox>, Vec<FormBox>) =
            boxes.filter(|asked| !is_there(asked)).partition(|asked| self.is_on_the_way(&asked.asked));
        let missing =
            if results.is_empty() && !form.values.is_empty() { Vec::new() } else { [results, on_the_way].concat() };
        missing.into_iter().map(|asked| asked.name).collect()
    }

    /// The coordinate of an instant centre that the hand has found.
    fn center(&self, table: &Table<'_>, asked: &QuantityRequest) -> Option<f64> {
        let What::Pole(_) = &asked.what else { return None };
        let name = QuantityName { component: None, ..asked.written.clone() }.to_string();
        let place = self.given().construction().origin + table.place(Sheet::Centers, &name)?;
        match asked.written.component? {
            Component::X => Some(place.x),
            Component::Y => Some(place.y),
            _ => None,
        }
    }

    /// Whether a segment has an end that only leads to others, or a direction is asked for, which a drawing shows and no number says.
    fn is_on_the_way(&self, asked: &QuantityRequest) -> bool {
        if asked.written.component == Some(Component::Angle) {
            return true;
        }
        let What::Segment(order, ends) = &asked.what else { return false };
        let construction = self.given().construction();
        let role = |end: &String| construction.plan_on(order.sheet())?.points.get(end).map(|point| point.role);
        ends.iter().any(|end| matches!(role(end), Some(PointRole::Normal | PointRole::Slid | PointRole::Special)))
    }
}
