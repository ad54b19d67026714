//! What quantity a written name means: by the names of the sheets or of results, its ends in either order, and with
//! letters that a program has lost.

use super::error::CheckError;
use super::rows::FormNames;
use super::shown::ShownNames;
use crate::construction::{Solution, image_name};
use crate::quantity::{Quantity, QuantityError, QuantityRequest};
use crate::scene::{Head, QuantityName};
use crate::sheet::Sheet;
use indexmap::IndexMap;

/// The names of a scene's quantities.
#[derive(Debug)]
pub(super) struct Names<'a> {
    pub solution: &'a Solution,
    /// All quantities of the steps, in order, with the numbers of their steps.
    pub order: IndexMap<String, usize>,
    /// Those that the form asks for.
    pub rows: FormNames,
}

/// A quantity that a name means.
pub(super) struct Meant {
    /// The quantity, by the name that steps and results give it.
    pub asked: QuantityRequest,
    /// The name by which the form asks for it.
    pub row: String,
    /// Its exact value.
    pub expected: f64,
    /// The sheet from which it is read.
    pub sheet: Sheet,
    /// The number of the step that gives it.
    pub step: usize,
}

impl<'a> Names<'a> {
    pub fn new(solution: &'a Solution) -> Names<'a> {
        let construction = &solution.construction;
        let steps = construction.steps_of_quantities().into_iter();
        Names {
            solution,
            order: steps.map(|(name, step)| (name, construction.step_number(step))).collect(),
            rows: FormNames::new(construction),
        }
    }

    /// The quantity that a name means in a form. The pole may stand in it for the image of the ground under a slider, but
    /// not in a form that `names_ground`, where the pole is itself.
    pub fn meant(&self, name: &str, names_ground: bool) -> Result<Meant, CheckError> {
        let usual = || ShownNames::of(self.solution).usual(name);
        let of_ground =
            if names_ground { None } else { self.rows.row_with_pole(&self.solution.construction, &usual()) };
        self.quantity(of_ground.unwrap_or(name))
    }

    /// The quantity of a name.
    pub fn quantity(&self, written: &str) -> Result<Meant, CheckError> {
        let solution = self.solution;
        let wrong = |error| self.unknown(written, error);
        let shown = ShownNames::of(solution);
        let name = &shown.usual(written);
        if let Some(error) = shown.lost_pole(name, |name| self.order.contains_key(name)) {
            return Err(error);
        }
        let usual = self.usual(name);
        let name = usual.as_deref().unwrap_or(name);
        let mut asked = QuantityRequest::new(name, &solution.mechanism).map_err(wrong)?;
        if asked.is_vector() {
            asked = QuantityRequest::new(&format!("{name}.size"), &solution.mechanism).map_err(wrong)?;
        }
        let value = asked.value(&solution.snapshot(), Some(&solution.construction), None);
        let expected = match value.map_err(wrong)? {
            Quantity::Number(x) => x,
            Quantity::Vector(v) => v.norm(),
        };
        let row = self.rows.of(&solution.construction, asked.name()).to_owned();
        let sheet = asked.sheet();
        let step = self.order.get(asked.name()).copied().unwrap_or_else(|| self.step_of(&asked, sheet));
        Ok(Meant { asked, row, expected, sheet, step })
    }

    /// The error of a name that means nothing here, with the nearest name that does.
    fn unknown(&self, name: &str, mut error: QuantityError) -> CheckError {
        let own = match &mut error {
            QuantityError::Unknown { nearest, .. } => nearest.take().map(|near| format!("did you mean `{near}`?")),
            _ => None,
        };
        let all = "`kinegon check SCENE --template` lists the names";
        if let QuantityError::Form(_) = error {
            let near = crate::scene::nearest(name, self.order.keys().map(String::as_str));
            let hint = near.map_or_else(|| all.to_owned(), |near| format!("the nearest name is `{near}`; {all}"));
            return CheckError::about(name, "is no quantity of this scene", hint);
        }
        CheckError::new(error.problem().message, own.unwrap_or_else(|| all.to_owned()))
    }

    /// The steps' name of a segment or length whose ends are written in the other order, or called as if every leg had
    /// a normal part; `None` for other names.
    fn usual(&self, name: &str) -> Option<String> {
        if self.order.contains_key(name) {
            return None;
        }
        let name = QuantityName::parse(name).filter(QuantityName::is_plain)?;
        let Head::Between(sheet) = name.head else { return None };
        let plan_name = |point: &String| self.solution.construction.plan_name(sheet, point).to_owned();
        let name = name.with_arguments(name.arguments.iter().map(plan_name).collect());
        [name.to_string(), name.reversed().to_string()].into_iter().find(|n| self.order.contains_key(n))
    }

    /// The number of the step after which a quantity that no step names can be read: that which makes the image of its
    /// point, or else the last of its sheet. 0 on the scheme.
    fn step_of(&self, asked: &QuantityRequest, sheet: Sheet) -> usize {
        if sheet == Sheet::Scheme {
            return 0;
        }
        let subject = asked.subject();
        let image = image_name(subject.split(['/', ',']).next().unwrap_or(""));
        let steps = || self.solution.construction.numbered_steps();
        let maker = steps().find(|s| s.sheet == sheet && s.action.image() == Some(image.as_str()));
        let last = steps().filter(|s| s.sheet <= sheet).last();
        maker.or(last).map_or(0, |s| s.number)
    }
}
