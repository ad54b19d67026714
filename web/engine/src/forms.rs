use crate::desk::Desk;
use crate::refused::Refused;
use kinegon::Sheet;
use kinegon::Solution;
use kinegon::check::{
    AnswerKey, DEPTH, EmptyForm, FilledForm, FormBox, LATITUDE, Measured, form_boxes, further_boxes, plan_points,
};
use kinegon::construction::Tolerance;
use kinegon::format::html_text;
use schemars::JsonSchema;
use serde::Serialize;

/// The form of a scene.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Form {
    /// Its boxes in the order of the construction; behind them those of further values that a filled form has.
    pub rows: Vec<FormRow>,
    /// Scale of the scheme in units per mm of paper.
    pub mu_l: Option<f64>,
    /// Scale of the velocity plan.
    pub mu_v: Option<f64>,
    /// Scale of the acceleration plan.
    pub mu_a: Option<f64>,
    /// By plan: the pole and the points whose places can be given.
    pub points: PlanPoints,
    /// The empty form, as `kinegon check --template` writes it.
    pub json: String,
    /// The same as a table.
    pub csv: String,
}

/// A box of the form of measured values.
#[derive(Debug, Serialize, JsonSchema)]
pub struct FormRow {
    /// The name under which its value stands in the form file.
    pub name: String,
    /// As the sheet writes it: HTML of `<i>`, `<sub>`, `<sup>` and text alone.
    pub label: String,
    /// The scene's unit of it.
    pub unit: String,
    /// `scheme`, `velocity`, `acceleration`.
    pub panel: &'static str,
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
    /// Whether the empty form asks for it.
    pub is_asked: bool,
}

/// Points whose places on paper can be given, by the names of the form file; the pole first.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlanPoints {
    /// Of the velocity plan.
    pub velocity: Vec<PlanPoint>,
    /// Of the acceleration plan.
    pub acceleration: Vec<PlanPoint>,
}

/// A point of a plan.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlanPoint {
    /// The name under which its place stands in the form file.
    pub name: String,
    /// As the sheet writes it, in HTML.
    pub label: String,
}

/// The values of a form: JSON or a table.
pub fn measured(text: &str) -> Result<Measured, Refused> {
    if Measured::is_json(text) {
        Measured::read_json(text).map_err(|error| Refused::of(text, error))
    } else {
        Measured::read_csv(text).map_err(Refused::from)
    }
}

/// What values are compared with: the scene with a careful hand.
pub fn usual_key(solution: &Solution) -> AnswerKey<'_> {
    let (scales, tolerance) = (solution.scales(), Tolerance::default());
    AnswerKey { solution, scales, tolerance, latitude: LATITUDE, depth: DEPTH }
}

impl Desk {
    /// The form of a scene, with boxes for all values of a form that is filled in already; that may be empty.
    pub fn form(&mut self, text: &str, filled: &str) -> Result<Form, Refused> {
        let solution = self.solution(text)?;
        let figure = solution.stepwise_figure();
        let row = |asked: bool| {
            let figure = &figure;
            move |found: FormBox| FormRow {
                label: html_text(&found.label),
                unit: found.asked.kind().unit(solution.scene.units),
                panel: panel(found.sheet),
                step: found.step,
                caption: found.step.checked_sub(1).and_then(|at| figure.steps.get(at)).cloned().unwrap_or_default(),
                has_sense: found.asked.is_rate(),
                turns: found.asked.turns(),
                on_paper: found.asked.is_length_on_sheet(),
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
        let empty = EmptyForm { solution, scales, exercise: None };
        let [velocity, acceleration] = plan_points(solution).map(|points| {
            let point = |(name, label)| PlanPoint { name, label: html_text(&label) };
            points.into_iter().map(point).collect()
        });
        Ok(Form {
            rows,
            mu_l: scales[Sheet::Scheme],
            mu_v: scales[Sheet::Velocity],
            mu_a: scales[Sheet::Acceleration],
            points: PlanPoints { velocity, acceleration },
            json: empty.json(),
            csv: empty.csv(),
        })
    }

    /// A form, JSON or a table, as JSON with the names by which the scene's empty form asks.
    pub fn read_form(&mut self, text: &str, form: &str) -> Result<String, Refused> {
        let measured = measured(form)?;
        let fault = measured.faults.first().cloned();
        fault.map_or(Ok(()), |fault| Err(Refused::from(fault)))?;
        let solution = self.solution(text)?;
        Ok(FilledForm { measured: &measured, key: &usual_key(solution) }.json())
    }

    /// A form as a table.
    pub fn write_form(&mut self, text: &str, form: &str) -> Result<String, Refused> {
        let measured = measured(form)?;
        let solution = self.solution(text)?;
        Ok(FilledForm { measured: &measured, key: &usual_key(solution) }.csv())
    }
}

fn panel(sheet: Sheet) -> &'static str {
    match sheet {
        Sheet::Scheme => "scheme",
        Sheet::Velocity => "velocity",
        _ => "acceleration",
    }
}
