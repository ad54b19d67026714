//! A drawing as a form of measured values, by which it is checked and marked like any other.

use super::file::HandDrawing;
use super::judge::Judge;
use crate::check::{Given as GivenValue, Measured, form_boxes};
use crate::quantity::What;
use crate::sheet::Scales;

impl Judge {
    /// The form that the hand would fill in: of the values that the scene's form asks for those that its drawing gives.
    #[must_use]
    pub fn form(&self, drawing: &HandDrawing) -> Measured {
        let (table, _) = self.drawn(drawing);
        let scales: Scales = self.scales(drawing).map(Some);
        let mut form = Measured::empty(scales, None);
        form.name.clone_from(&drawing.name);
        form.exercise.clone_from(&drawing.exercise);
        form.hints = drawing.hints;
        for asked in form_boxes(&self.given().solution) {
            let name = asked.asked.name();
            // What the hand has found itself, or what its sheets show; what the scene gives is no finding.
            let is_of_sheets = matches!(asked.asked.what, What::Segment(..) | What::Length(..));
            let found = table.numbers().find(|(own, _)| *own == name).map(|(_, number)| number);
            let number = found.or_else(|| table.known(name).filter(|_| is_of_sheets));
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
}
