//! Names of quantities as the sheets show them: in forms, and in reports to a person.
//!
//! Quantities keep their names in results; a form writes `vplan(o,b)` where the figure's notation calls the pole o. A
//! form may have either name, and the usual ones of poles in all notations.

use super::error::CheckError;
use super::rows::FormNames;
use crate::construction::{Plan, Solution};
use crate::quantity::{QuantityRequest, What};
use crate::scene::{Head, QuantityName};
use crate::sheet::Sheet;
use crate::text::{Untrusted, shown};
use crate::words::{Notation, Wording, with_prime};

/// Names of a solved scene's quantities in its figure's notation, with its labels.
#[derive(Clone, Copy)]
pub(super) struct ShownNames<'a> {
    solution: &'a Solution,
    words: Wording,
}

/// A name that asks for the distance of two points of a sheet, and the sheet.
fn between(name: &str) -> Option<(QuantityName, Sheet)> {
    let name = QuantityName::parse(name)?;
    match name.head {
        Head::Between(sheet) => Some((name, sheet)),
        _ => None,
    }
}

impl<'a> ShownNames<'a> {
    /// The names of a scene's quantities.
    pub fn of(solution: &'a Solution) -> ShownNames<'a> {
        ShownNames { solution, words: Wording::of(&solution.scene.figure) }
    }

    /// A quantity as a person reads it on the sheets: `p b`, `B S3`, `ω_2`.
    pub fn quantity(&self, asked: &QuantityRequest) -> String {
        let between = |sheet, from: &str, to: &str| {
            let [from, to] = [from, to].map(|name| self.point(sheet, name).unwrap_or_else(|| name.to_owned()));
            format!("{from} {to}")
        };
        match asked.what() {
            What::Segment { kind, from, to, .. } => between(*kind, from, to),
            What::Length(from, to) => between(Sheet::Scheme, from.name(), to.name()),
            _ => plain(&asked.symbol(&self.solution.mechanism, self.words.notation, &|name| self.label(name))),
        }
    }

    /// A quantity by its name as a person reads it; names that mean none stay as they are.
    pub fn named(&self, name: &str) -> String {
        let asked = QuantityRequest::new(name, &self.solution.mechanism);
        asked.map_or_else(|_| name.to_owned(), |asked| self.quantity(&asked))
    }

    /// The name by which a form in the figure's notation asks for a quantity; its usual name where that is not plain.
    pub fn in_form(&self, name: &str, rows: &FormNames) -> String {
        let shown = || {
            let (parts, sheet) = between(name)?;
            let ends = parts.arguments.iter().map(|end| Some(self.point(sheet, end)?.replace('′', "'")));
            let shown = parts.with_arguments(ends.collect::<Option<Vec<String>>>()?).to_string();
            let usual = self.usual(&shown);
            let is_from_pole = || rows.row_with_pole(&self.solution.construction, &usual) == Some(name);
            (usual == name || is_from_pole()).then_some(shown)
        };
        shown().unwrap_or_else(|| name.to_owned())
    }

    /// The usual name of a quantity written by the names of any notation; what is not known stays as it is.
    pub fn usual(&self, written: &str) -> String {
        let Some((parts, sheet)) = between(written) else { return written.to_owned() };
        let ends = parts.arguments.iter().map(|end| self.usual_point(sheet, end));
        parts.with_arguments(ends.collect()).to_string()
    }

    /// The error of a name whose π has become a question mark: an encoding without Greek letters lost it. `is_usual`:
    /// whether the steps have a quantity of that usual name.
    pub fn lost_pole(&self, name: &str, is_usual: impl Fn(&str) -> bool) -> Option<CheckError> {
        if !name.contains(['?', '\u{fffd}']) {
            return None;
        }
        let restored = name.replace(['?', '\u{fffd}'], "π");
        let is_known = |name: &str| is_usual(&self.usual(name));
        let reversed = || Some(QuantityName::parse(&restored)?.reversed().to_string());
        let was_pole = is_known(&restored) || reversed().is_some_and(|name| is_known(&name));
        was_pole.then(|| {
            let message = format!("the letter π was lost in `{}`", shown(name));
            CheckError::new(message, "save as CSV UTF-8, or write pi")
        })
    }

    /// The usual name of a point of a sheet written in any notation.
    pub fn usual_point(&self, sheet: Sheet, written: &str) -> String {
        let construction = &self.solution.construction;
        let name = written.trim().replace('′', "'");
        let Some(plan) = construction.plan_on(sheet) else {
            let known = self.scheme_points().any(|known| known == name);
            let labelled = || self.scheme_points().find(|known| self.point(sheet, known).as_ref() == Some(&name));
            return if known { name } else { labelled().map_or(name.clone(), str::to_owned) };
        };
        if plan.points.contains_key(construction.plan_name(sheet, &name)) {
            return name;
        }
        let shown = |point: &&String| self.point(sheet, point).is_some_and(|shown| shown.replace('′', "'") == name);
        if let Some(point) = plan.points.keys().find(shown) {
            return point.clone();
        }
        self.other_notation(plan, &name).unwrap_or(name)
    }

    /// The plan point with that name in some other notation.
    fn other_notation(&self, plan: &Plan, name: &str) -> Option<String> {
        let is_pole = |notation: &&Notation| plain(notation.pole(plan.sheet)).replace('′', "'") == name;
        if Notation::ALL.iter().any(is_pole) || (plan.sheet == Sheet::Acceleration && name == "pi") {
            return Some(plan.sheet.pole().to_owned());
        }
        // Images in an acceleration plan may bear a prime.
        let primed = plan.points.keys().find(|point| with_prime(point).replace('′', "'") == name);
        primed.filter(|_| plan.sheet == Sheet::Acceleration).cloned()
    }

    /// A point as a sheet shows it, without markup; `None` where its label has been taken away or is no plain name.
    fn point(&self, sheet: Sheet, name: &str) -> Option<String> {
        let labels = &self.solution.scene.figure.labels;
        let construction = &self.solution.construction;
        let shown = match (labels.get(name), construction.plan_on(sheet)) {
            (Some(label), _) => plain(&label.for_setting()),
            (None, Some(plan)) => plain(&plan.shown(name, name.to_owned(), self.words.notation)),
            (None, None) => name.to_owned(),
        };
        let is_plain = !shown.is_empty() && !shown.contains([',', '(', ')', ' ', '"', ';']);
        is_plain.then_some(shown)
    }

    /// A name of the scene with its label.
    fn label(&self, name: &str) -> String {
        self.solution
            .scene
            .figure
            .labels
            .get(name)
            .filter(|label| !label.is_blank())
            .map_or_else(|| name.to_owned(), Untrusted::for_setting)
    }

    /// The names of the points of the scheme.
    fn scheme_points(&self) -> impl Iterator<Item = &str> {
        let special = self.solution.construction.special.iter().map(|special| special.name.as_str());
        self.solution.mechanism.points.iter().map(String::as_str).chain(special)
    }
}

/// Markup without its braces.
fn plain(markup: &str) -> String {
    markup.chars().filter(|c| !matches!(c, '{' | '}' | '`')).collect()
}
