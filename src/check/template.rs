//! Empty forms: every quantity of the steps, in the order of the construction.

use crate::construction::Construction;
use crate::quantity::Scales;
use indexmap::IndexMap;
use serde::Serialize;

/// The names of all quantities of the steps, once each: those that a form asks for.
#[must_use]
pub fn form_names(construction: &Construction) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for name in construction.numbered_steps().flat_map(|step| step.names()) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// The form as JSON: values are to be written between the quotes, or as numbers in place of them.
#[derive(Debug, Serialize)]
struct Form {
    kinegon_measured: u64,
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    mu_l: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mu_v: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mu_a: Option<f64>,
    values: IndexMap<String, String>,
}

/// An empty form as JSON, at the figure's scales.
#[must_use]
pub fn template_json(construction: &Construction, scales: &Scales) -> String {
    let values = form_names(construction).into_iter();
    let form = Form {
        kinegon_measured: 1,
        name: String::new(),
        mu_l: scales.length,
        mu_v: scales.velocity,
        mu_a: scales.acceleration,
        values: values.map(|name| (name, String::new())).collect(),
    };
    crate::format::json(&form)
}

/// An empty form as a table, at the figure's scales.
#[must_use]
pub fn template_csv(construction: &Construction, scales: &Scales) -> String {
    let mut text = String::from("quantity,value,unit\nname,,\n");
    let given = [("mu_l", scales.length), ("mu_v", scales.velocity), ("mu_a", scales.acceleration)];
    for (name, scale) in given {
        if let Some(scale) = scale {
            text.push_str(&format!("{name},{scale},\n"));
        }
    }
    for name in form_names(construction) {
        text.push_str(&format!("\"{name}\",,\n"));
    }
    text
}
