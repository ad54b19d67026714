use crate::checks::measured;
use crate::desk::Desk;
use crate::refused::Refused;
use kinegon::check::{AnswerKey, FormBox, Measured, form_boxes, further_boxes, sheet_points};
use kinegon::drawing::SheetLabels;
use kinegon::format::html_text;
use kinegon::{Sheet, Solution};
use serde::Serialize;
use std::collections::BTreeMap;

/// The form of a scene.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Form {
    /// Its boxes in the order of the construction; behind them those of further values that a filled form has.
    pub rows: Vec<FormRow>,
    /// By sheet: its scale, in units per mm of paper.
    pub scales: BTreeMap<Sheet, Option<f64>>,
    /// By plan: the pole and the points whose places can be given, by the names of the form file.
    pub points: BTreeMap<Sheet, Vec<PlanPoint>>,
    /// The empty form, as `kinegon check --template` writes it.
    pub json: String,
    /// The same as a table.
    pub csv: String,
}

/// A box of the form of measured values.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct FormRow {
    /// The name under which its value stands in the form file.
    pub name: String,
    /// As the sheet writes it: HTML of `<i>`, `<sub>`, `<sup>` and text alone.
    pub label: String,
    /// The velocity or acceleration that a segment of a plan is, in the same HTML; empty for what is none.
    pub vector: String,
    /// The scene's unit of it.
    pub unit: String,
    /// The sheet from which it is read.
    pub panel: Sheet,
    /// The step that gives it.
    pub step: usize,
    /// That step's caption.
    pub caption: String,
    /// Whether it has a sense, which a sign tells.
    pub has_sense: bool,
    /// Whether that sense is one of rotation.
    pub turns: bool,
    /// Whether it can be given in millimetres of paper, with `/mu` behind its name.
    pub on_paper: bool,
    /// Whether it is a length of the scheme or a segment of a plan, which `"in": "mm"` makes millimetres of paper.
    pub is_segment: bool,
    /// Whether the empty form asks for it.
    pub is_asked: bool,
}

/// A point of a plan.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct PlanPoint {
    /// The name under which its place stands in the form file.
    pub name: String,
    /// As the sheet writes it, in HTML.
    pub label: String,
}

/// What values are compared with: the scene with a careful hand.
pub fn usual_key(solution: &Solution) -> AnswerKey<'_> {
    AnswerKey::new(solution, None)
}

impl Desk {
    /// The form of a scene, with boxes for all values of a form that is filled in already; that may be empty.
    pub fn form(&mut self, text: &str, filled: &str) -> Result<Form, Refused> {
        let solution = &*self.told(text)?;
        let figure = solution.stepwise_figure();
        let labels = SheetLabels::of(solution);
        let row = |asked: bool| {
            let (figure, labels) = (&figure, &labels);
            move |found: FormBox| FormRow {
                label: html_text(&found.label),
                vector: labels.vector(&found.asked).as_ref().map(html_text).unwrap_or_default(),
                unit: found.asked.kind().unit(solution.scene.units),
                panel: found.asked.sheet(),
                step: found.step,
                caption: found.step.checked_sub(1).and_then(|at| figure.steps.get(at)).cloned().unwrap_or_default(),
                has_sense: found.asked.is_rate(),
                turns: found.asked.turns(),
                on_paper: found.asked.is_length_on_sheet(),
                is_segment: found.asked.is_distance(),
                is_asked: asked,
                name: found.name,
            }
        };
        let mut rows: Vec<FormRow> = form_boxes(solution).into_iter().map(row(true)).collect();
        if !filled.trim().is_empty() {
            let further = further_boxes(&measured(filled)?, &usual_key(solution));
            rows.extend(further.into_iter().map(row(false)));
        }
        let scales = solution.scales();
        let empty = Measured::empty(scales, None);
        let point = |(name, label)| PlanPoint { name, label: html_text(&label) };
        let mut points = sheet_points(solution);
        let points = Sheet::ALL
            .into_iter()
            .filter(|sheet| sheet.has_places())
            .map(|sheet| (sheet, std::mem::take(&mut points[sheet])));
        Ok(Form {
            rows,
            scales: Sheet::ALL.into_iter().map(|sheet| (sheet, scales[sheet])).collect(),
            points: points.map(|(plan, points)| (plan, points.into_iter().map(point).collect())).collect(),
            json: empty.json(solution),
            csv: empty.csv(solution),
        })
    }

    /// A form, JSON or a table, as JSON with the names by which the scene's empty form asks.
    pub fn read_form(&mut self, text: &str, form: &str) -> Result<String, Refused> {
        let measured = measured(form)?;
        let fault = measured.faults.first().cloned();
        fault.map_or(Ok(()), |fault| Err(Refused::from(fault)))?;
        let solution = self.solution(text)?;
        Ok(measured.json(solution))
    }

    /// A form as a table.
    pub fn write_form(&mut self, text: &str, form: &str) -> Result<String, Refused> {
        let measured = measured(form)?;
        let solution = self.solution(text)?;
        Ok(measured.csv(solution))
    }
}
