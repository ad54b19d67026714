//! What quantity a written name means: by the names of the sheets or of results, its ends in either order, and with
//! letters that a program has lost.

use super::answer_key::AnswerKey;
use super::rows::{FormNames, UNDER_SLIDER};
use super::sheet::{CheckError, Measured};
use super::shown::ShownNames;
use crate::construction::image_name;
use crate::quantity::{Asked, Quantity, QuantityError};
use crate::scene::{Head, QuantityName};
use crate::sheet::Sheet;
use crate::text;
use indexmap::IndexMap;

/// The names of a scene's quantities.
#[derive(Debug)]
pub(super) struct Names {
    /// All quantities of the steps, in order, with the numbers of their steps.
    pub order: IndexMap<String, usize>,
    /// Those that the form asks for.
    pub rows: FormNames,
}

impl Names {
    pub fn new(key: &AnswerKey<'_>) -> Names {
        let construction = &key.solution.construction;
        let steps = construction.steps_of_quantities().into_iter();
        Names {
            order: steps.map(|(name, step)| (name, construction.step_number(step))).collect(),
            rows: FormNames::new(construction),
        }
    }
}

/// Finds what the names of a form mean.
pub(super) struct Reader<'a> {
    pub measured: &'a Measured,
    pub key: &'a AnswerKey<'a>,
    pub names: &'a Names,
}

impl Reader<'_> {
    /// The row of the form that a name means which has the pole in place of the image of the ground under a slider. In
    /// forms that have names with that image the pole is itself.
    fn under_slider(&self, name: &str) -> Option<&str> {
        if self.measured.values.iter().any(|given| given.name.contains(UNDER_SLIDER)) {
            return None;
        }
        let solution = self.key.solution;
        self.names.rows.row_with_pole(&solution.construction, &ShownNames::of(solution).usual(name))
    }

    /// The name of the form's row that a written name means, and whether `/mu` stands behind it; `None` for no quantity.
    pub fn row(&self, written: &str) -> Option<(String, bool)> {
        let compact: String = written.chars().filter(|c| !c.is_whitespace()).collect();
        let name = compact.strip_suffix("/mu").unwrap_or(&compact);
        let (asked, ..) = self.meant(name).ok()?;
        let row = self.names.rows.of(&self.key.solution.construction, asked.name()).to_owned();
        Some((row, name != compact))
    }

    /// The quantity that a name means in this form; as [`Reader::quantity`].
    pub fn meant(&self, name: &str) -> Result<(Asked, f64, Sheet, usize), CheckError> {
        self.quantity(self.under_slider(name).unwrap_or(name))
    }

    /// The quantity that a name stands for, its exact value, its sheet and the number of its step.
    pub fn quantity(&self, name: &str) -> Result<(Asked, f64, Sheet, usize), CheckError> {
        let solution = self.key.solution;
        let wrong = |mut error: QuantityError| {
            let own = match &mut error {
                QuantityError::Unknown { nearest, .. } => nearest.take().map(|near| format!("did you mean `{near}`?")),
                _ => None,
            };
            let all = "`kinegon check SCENE --template` lists the names";
            let names = self.names.order.keys().map(String::as_str);
            let (message, near) = match error {
                QuantityError::Form(_) => (
                    format!("`{}` is no quantity of this scene", text::shown(name)),
                    crate::scene::nearest(name, names),
                ),
                error => (error.problem().message, None),
            };
            let near = near.map(|n| format!("the nearest name is `{n}`; {all}"));
            let hint = own.or(near).unwrap_or_else(|| all.to_owned());
            CheckError::new(message, hint)
        };
        let shown = ShownNames::of(self.key.solution);
        let name = &shown.usual(name);
        if let Some(error) = shown.lost_pole(name, |name| self.names.order.contains_key(name)) {
            return Err(error);
        }
        let usual = self.usual(name);
        let name = usual.as_deref().unwrap_or(name);
        let mut asked = Asked::new(name, &solution.mechanism).map_err(wrong)?;
        if asked.is_vector() {
            asked = Asked::new(&format!("{name}.size"), &solution.mechanism).map_err(wrong)?;
        }
        let value = asked.value(&solution.snapshot(), Some(&solution.construction), None);
        let expected = match value.map_err(wrong)? {
            Quantity::Number(x) => x,
            Quantity::Vector(v) => v.norm(),
        };
        let sheet = asked.sheet();
        let step = self.names.order.get(asked.name()).copied().unwrap_or_else(|| self.step_of(&asked, sheet));
        Ok((asked, expected, sheet, step))
    }

    /// The steps' name of a segment or length whose ends are written in the other order, or called as if every leg had
    /// a normal part; `None` for other names.
    fn usual(&self, name: &str) -> Option<String> {
        if self.names.order.contains_key(name) {
            return None;
        }
        let name = QuantityName::parse(name).filter(QuantityName::is_plain)?;
        let Head::Between(sheet) = name.head else { return None };
        let plan_name = |point: &String| self.key.solution.construction.plan_name(sheet, point).to_owned();
        let name = name.with_arguments(name.arguments.iter().map(plan_name).collect());
        [name.to_string(), name.reversed().to_string()].into_iter().find(|n| self.names.order.contains_key(n))
    }

    /// The number of the step after which a quantity that no step names can be read: that which makes the image of its
    /// point, or else the last of its sheet. 0 on the scheme.
    fn step_of(&self, asked: &Asked, sheet: Sheet) -> usize {
        if sheet == Sheet::Scheme {
            return 0;
        }
        let subject = asked.subject();
        let image = image_name(subject.split(['/', ',']).next().unwrap_or(""));
        let steps = || self.key.solution.construction.numbered_steps();
        let maker = steps().find(|s| s.sheet() == sheet && s.step.action.image() == Some(image.as_str()));
        let last = steps().filter(|s| s.sheet() <= sheet).last();
        maker.or(last).map_or(0, |s| s.number)
    }
}
