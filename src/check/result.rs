//! The report as JSON.

use super::checked::{Accuracy, Basis, Checked, Explanation, Finding, Verdict};
use super::common::CommonError;
use super::marks::Awarded;
use super::measured::AnswerKey;
use super::placed::TurnedPlan;
use super::sensible::StatedScale;
use crate::text::Untrusted;
use serde::Serialize;

/// Verdicts and diagnosis of one drawing.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CheckResult {
    /// Version of the format.
    pub kinegon_check: u64,
    /// Whose drawing it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<Untrusted>,
    /// Whether all that the scene asks for is there and right: nothing off, missing, without a sense or without information, no plan mirrored.
    pub passed: bool,
    /// The values in the order of the construction.
    pub values: Vec<ValueResult>,
    /// What explains them best.
    pub diagnosis: ExplanationResult,
    /// What explains them, too.
    pub others: Vec<ExplanationResult>,
    /// Values that nothing explains.
    pub unexplained: Vec<String>,
    /// How accurate the drawing is, as the scatter of all values shows; not there where too few values are drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// Plans whose places on paper are the mirror image of the right ones: "velocity", "acceleration".
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mirrored: Vec<&'static str>,
    /// Plans whose places on paper lie turned to the scheme, with all of the sheet; directions are judged without that.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub turned: Vec<TurnedResult>,
    /// What the scene asks for, by its `form` or else by all its steps, and the form has no value of.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<String>,
    /// The exercise of the class whose values these are, where they are those of another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub values_of: Option<String>,
    /// Scales of the form that are not those asked for, or at which no sheet can be drawn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub scales: Vec<ScaleResult>,
    /// An error that all measured lengths have in common, taken out of the values: `{ "scale": 0.031 }` where they are 3.1 % too
    /// large, `{ "zero": 2 }` where they are 2 mm too long.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub common: Option<CommonError>,
    /// How many stages of hints the student opened in the workbench.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hints: Option<u64>,
    /// The marks that the values earn, where a marking scheme is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub marks: Option<Awarded>,
}

/// A plan that lies turned to the scheme.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct TurnedResult {
    /// The plan: "velocity", "acceleration".
    pub plan: &'static str,
    /// By how many degrees, positive counter-clockwise.
    pub degrees: f64,
}

/// A scale of a form that is not the one asked for, or at which no sheet can be drawn.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ScaleResult {
    /// Its name in the form: `mu_l`, `mu_v`, `mu_a`.
    pub scale: &'static str,
    /// What the form states, in units per millimetre.
    pub stated: f64,
    /// What the scene's figure states.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asked: Option<f64>,
    /// The scale by which the values are judged.
    pub used: f64,
}

/// A value with its verdict.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ValueResult {
    /// The quantity's name.
    pub quantity: String,
    /// The number of the step that gives it.
    pub step: usize,
    /// The value in the scene's units and senses.
    pub value: f64,
    /// The exact value.
    pub expected: f64,
    /// Unit of both.
    pub unit: String,
    /// The value less the exact one.
    pub difference: f64,
    /// The same in millimetres of paper.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference_mm: Option<f64>,
    /// The same in per cent of the exact value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub percent: Option<f64>,
    /// Largest difference that is within the tolerance; left out where the scene gives the value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub allowed: Option<f64>,
    /// Whether that is a coarse tolerance, as no construction by hand gives the value.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub coarse: bool,
    /// "right", "within-tolerance", "sense-missing" (the size is right, the sense is not told), "off", "too-coarse" (its digits tell nothing)
    /// or "unjudged" (it is too small on its sheet).
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub verdict: Verdict,
}

/// Mistakes that explain the values together.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ExplanationResult {
    /// The mistakes in the order of the construction.
    pub mistakes: Vec<MistakeResult>,
    /// The probability that these were made, or others that the values alone cannot tell from them, from 0 to 1; an
    /// honest share is left for mistakes that the catalogue does not have. Causes are told from 0.6 on. Without mistakes:
    /// the probability that none was made that the catalogue has.
    pub probability: f64,
    /// Whether the given values alone cannot tell it from the diagnosis.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub indistinguishable: bool,
    /// Whether it is one way in which what the diagnosis tells as "unknown", only by its place, may have happened: its probability is a part
    /// of the diagnosis's.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub within: bool,
}

/// A mistake that was probably made.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MistakeResult {
    /// Its name in the catalogue.
    pub mistake: &'static str,
    /// The number of its step; 0 for the whole drawing.
    pub step: usize,
    /// What was probably done.
    pub done: String,
    /// What it should be.
    pub should_be: String,
    /// Values written otherwise than meant.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub written: Vec<String>,
    /// Values that follow from it and are consistent with it.
    pub follows: Vec<String>,
}

/// The result as JSON shows it, sentences in the language of the scene's figure.
#[must_use]
pub fn check_result(checked: &Checked, key: &AnswerKey<'_>, name: Option<Untrusted>) -> CheckResult {
    let words = key.solution.wording();
    let values = checked.values.iter().map(|value| {
        let entry = &value.entry;
        ValueResult {
            quantity: entry.asked.name().to_owned(),
            step: entry.step,
            value: entry.value,
            expected: entry.expected,
            unit: entry.asked.kind().unit(key.solution.scene.units),
            difference: value.difference,
            difference_mm: entry.per_mm.map(|mu| value.difference / mu).filter(|mm| mm.is_finite()),
            percent: Some(100.0 * value.difference / entry.expected.abs()).filter(|percent| percent.is_finite()),
            allowed: (value.basis != Basis::Given).then_some(value.tolerance),
            coarse: value.basis == Basis::Coarse,
            verdict: value.verdict,
        }
    });
    let mistake = |finding: &Finding| {
        let candidate = &finding.candidate;
        let [done, should_be] = candidate.told.sentences(&words);
        MistakeResult {
            mistake: candidate.mistake().id(),
            step: candidate.step,
            done,
            should_be,
            written: checked.names(&finding.written),
            follows: checked.names(&finding.follows),
        }
    };
    let explanation = |explanation: &Explanation| ExplanationResult {
        mistakes: explanation.findings.iter().map(mistake).collect(),
        probability: explanation.probability,
        indistinguishable: explanation.is_alike,
        within: explanation.is_within,
    };
    let scale = |scale: &StatedScale| {
        let StatedScale { sheet, stated, asked, used } = *scale;
        ScaleResult { scale: sheet.facts().scale_key, stated, asked, used }
    };
    let mirrored = checked.mirrored.iter().map(|plan| plan.as_str());
    let turned =
        checked.turned.iter().map(|&TurnedPlan { sheet, degrees }| TurnedResult { plan: sheet.as_str(), degrees });
    let diagnosis = &checked.diagnosis;
    CheckResult {
        kinegon_check: 1,
        name,
        passed: checked.is_passed(),
        values: values.collect(),
        diagnosis: explanation(&diagnosis.best),
        others: diagnosis.others.iter().map(explanation).collect(),
        unexplained: checked.names(&diagnosis.unexplained),
        accuracy: checked.accuracy,
        mirrored: mirrored.collect(),
        turned: turned.collect(),
        missing: checked.missing.clone(),
        values_of: checked.values_of.clone(),
        scales: checked.scales.iter().map(scale).collect(),
        common: checked.common,
        hints: Some(checked.hints).filter(|hints| *hints > 0),
        marks: None,
    }
}

/// The JSON Schema of the result.
#[must_use]
pub fn check_schema() -> serde_json::Value {
    crate::scene::schema!("check", CheckResult, "Kinegon check, version 1")
}
