//! The boxes of a form, for a page that shows them one by one.

use super::answer_key::AnswerKey;
use super::names::Names;
use super::rows::FormNames;
use super::sheet::Measured;
use super::shown::ShownNames;
use crate::construction::{Plan, Solution};
use crate::drawing::{RichText, SheetLabels};
use crate::quantity::{QuantityRequest, What};
use crate::sheet::Sheet;
use indexmap::IndexSet;

/// A box for a value.
#[derive(Clone, Debug)]
pub struct FormBox {
    /// The name under which its value stands in a form.
    pub name: String,
    /// The quantity.
    pub asked: QuantityRequest,
    /// How the sheets write it.
    pub label: RichText,
    /// The sheet from which it is read.
    pub sheet: Sheet,
    /// The number of the step that gives it.
    pub step: usize,
}

impl FormBox {
    fn new(labels: &SheetLabels<'_>, name: String, asked: QuantityRequest, step: usize) -> FormBox {
        let (label, sheet) = (labels.quantity(&asked), asked.sheet());
        FormBox { name, asked, label, sheet, step }
    }
}

/// The boxes of a scene's form, in its order.
#[must_use]
pub fn form_boxes(solution: &Solution) -> Vec<FormBox> {
    let (shown, labels) = (ShownNames::of(solution), SheetLabels::of(solution));
    let construction = &solution.construction;
    let (rows, steps) = (FormNames::new(construction), construction.steps_of_quantities());
    let of_row = |name: &str| {
        let asked = QuantityRequest::new(name, &solution.mechanism).ok()?;
        let step = steps.get(name).map_or(0, |step| construction.step_number(*step));
        Some(FormBox::new(&labels, shown.in_form(name, &rows), asked, step))
    };
    rows.names().filter_map(of_row).collect()
}

/// Boxes for values of a filled form that the empty one does not ask for; names that are not understood have none.
#[must_use]
pub fn further_boxes(measured: &Measured, key: &AnswerKey<'_>) -> Vec<FormBox> {
    let names = Names::new(key.solution);
    let (shown, labels) = (ShownNames::of(key.solution), SheetLabels::of(key.solution));
    let asked_for: Vec<String> = names.rows.names().map(|name| shown.in_form(name, &names.rows)).collect();
    let further = measured.values.iter().map(|given| given.name.trim_end_matches("/mu"));
    let further = further.filter(|name| !asked_for.iter().any(|asked| asked == name));
    let of_name = |name: &str| {
        let meant = names.quantity(name).ok()?;
        Some(FormBox::new(&labels, name.to_owned(), meant.asked, meant.step))
    };
    further.filter_map(of_name).collect()
}

/// By plan the points between which the form's segments lie, the pole first: the names under which a form gives their
/// places, and their labels.
#[must_use]
pub fn plan_points(solution: &Solution) -> [Vec<(String, RichText)>; 2] {
    let labels = SheetLabels::of(solution);
    let boxes = form_boxes(solution);
    let of_plan = |plan: &Plan| {
        let mut names = vec![plan.sheet.pole().to_owned()];
        for found in &boxes {
            if let What::Segment { kind, from, to, .. } = found.asked.what()
                && *kind == plan.sheet
            {
                names.extend([from, to].map(ToString::to_string));
            }
        }
        let names: IndexSet<String> = names.into_iter().collect();
        names.into_iter().map(|name| (name.clone(), labels.plan_point(plan, &name))).collect()
    };
    let construction = &solution.construction;
    Sheet::PLANS.map(|sheet| construction.plan_on(sheet).map_or_else(Vec::new, of_plan))
}
