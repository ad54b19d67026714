use crate::check::CheckOptions;
use crate::pool::on_all_cores;
use crate::refused::Refused;
use crate::scene::Scene;
use crate::sheet::Form;
use crate::sweep::{Extremes, extremes_of, table_of};
use crate::table::Table;
use crate::wanted::Wanted;
use kinegon::Sheet;
use kinegon::accuracy::bounds;
use kinegon::construction::{Action, NumberedStep, Teller, Tolerance, shown_text};
use kinegon::cycle::Traces;
use kinegon::drawing::{Drawing, Style};
use kinegon::editing::with_mode;
use kinegon::format::{OpenScene, json_line, workbench};
use kinegon::mechanism::Mechanism;
use kinegon::position::Pose;
use kinegon::quantity::{Asked, Quantity, step_pencil};
use kinegon::scene::SizeLimit;
use kinegon::{order_of_figure, order_of_result};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde_json::{Value, json};
use std::sync::OnceLock;

/// A solved scene: its position, and its motion as far as it was asked for.
#[pyclass(frozen, module = "kinegon._kinegon")]
pub struct Solution {
    pub scene: Scene,
    mode: Option<usize>,
    mechanism: Mechanism,
    pose: Pose,
    /// Solved for velocities, and for accelerations.
    solved: [OnceLock<kinegon::Solution>; 2],
}

/// A value, of a vector two, its unit, and the bound of its error.
type ValueOf = (Vec<f64>, String, Option<f64>);

impl Solution {
    /// A scene in the assembly mode of that number, or in its own.
    pub fn of(scene: &Scene, mode: Option<usize>) -> Result<Solution, Refused> {
        let (mechanism, pose) = scene.posed(SizeLimit::NUMBERS, mode)?;
        let scene = Scene { text: scene.text.clone(), is_seen: scene.is_seen, scene: scene.scene.clone() };
        let solution = Solution { scene, mode, mechanism, pose, solved: Default::default() };
        solution.solved(order_of_result(&solution.scene.scene))?;
        Ok(solution)
    }

    /// The scene solved for this order of motion.
    pub fn solved(&self, order: Sheet) -> Result<&kinegon::Solution, Refused> {
        let kept = &self.solved[usize::from(order == Sheet::Acceleration)];
        if let Some(solution) = kept.get() {
            return Ok(solution);
        }
        let (mechanism, pose) = (self.mechanism.clone(), self.pose.clone());
        let solution = kinegon::Solution::new(self.scene.scene.clone(), mechanism, pose, order);
        let solution = solution.map_err(|error| self.scene.refused(error))?;
        Ok(kept.get_or_init(|| solution))
    }

    /// Solved for what is drawn by hand.
    pub fn by_hand(&self) -> Result<&kinegon::Solution, Refused> {
        self.allow(SizeLimit::HAND)?;
        self.solved(Sheet::Acceleration)
    }

    fn allow(&self, limit: SizeLimit) -> Result<(), Refused> {
        limit.check(&self.scene.scene).map_err(|error| self.scene.refused(error))
    }

    fn value(&self, name: &str) -> Result<ValueOf, Refused> {
        let solution = self.solved(Sheet::Acceleration)?;
        let asked = Asked::new(name, &solution.mechanism)?;
        let scales = asked.is_on_paper().then(|| solution.scales());
        let value = asked.value(&solution.snapshot(), Some(&solution.construction), scales.as_ref())?;
        let numbers = match value {
            Quantity::Number(x) => vec![x],
            Quantity::Vector(v) => vec![v.x, v.y],
        };
        let bounds = bounds(&solution.scene, &solution.mechanism, &solution.pose, &solution.motion);
        let error = bounds.of(&asked).filter(|error| error.is_finite());
        let unit = if asked.is_on_paper() { "mm".to_owned() } else { asked.kind().unit(solution.scene.units) };
        Ok((numbers, unit, error))
    }

    /// The sheets of the figure; those after a step where one is asked for.
    fn sheets(&self, style: Option<&str>, is_coarse: bool, is_layered: bool) -> Result<Vec<Drawing>, Refused> {
        let step = self.scene.scene.figure.step;
        let is_stepwise = step.is_some() || is_layered;
        self.allow(if is_stepwise { SizeLimit::STEPS } else { SizeLimit::FIGURE })?;
        let solution = self.solved(order_of_figure(&self.scene.scene))?;
        Traces::new(solution, None).map_err(|error| self.scene.refused(error))?;
        let style = style.map(Style::read).transpose()?;
        let styled = style.as_ref().map(|style| {
            let mut styled = solution.clone();
            let figure = &mut styled.scene.figure;
            (figure.sizes, figure.usual_values) = (Some(style.sizes()), Some(style.shows_values()));
            styled
        });
        let solution = styled.as_ref().unwrap_or(solution);
        let mut sheets = match step {
            Some(step) => vec![after(solution, step, is_coarse)?],
            None => solution.sheets(),
        };
        if let Some(style) = style {
            sheets.iter_mut().for_each(|sheet| sheet.style = style.clone());
        }
        Ok(sheets)
    }

    /// The workbench with the scene open at a step, or with the finished figure.
    fn page(&self, step: Option<usize>) -> Result<String, Refused> {
        self.allow(SizeLimit::STEPS)?;
        let Scene { text, scene, .. } = &self.scene;
        let moved = self.mode.map(|mode| with_mode(text, mode)).transpose()?;
        let text = moved.as_deref().unwrap_or(text);
        Ok(workbench(Some(OpenScene { text, step: scene.figure.step.or(step) })))
    }

    fn told_steps(&self, hand: Tolerance) -> Result<(String, String), Refused> {
        let solution = self.by_hand()?;
        let pencil = step_pencil(solution, hand).map_err(|error| self.scene.refused(error))?;
        Ok((solution.steps(&pencil), json!(steps(solution)).to_string()))
    }
}

/// The sheet after a step, or after the steps that a lecturer shows together.
fn after(solution: &kinegon::Solution, step: usize, is_coarse: bool) -> Result<Drawing, Refused> {
    let all = if is_coarse { solution.coarse_figure() } else { solution.stepwise_figure() };
    let count = all.steps.len();
    if (1..=count).contains(&step) {
        return Ok(all.after_step(step));
    }
    let hint = format!("the construction has steps 1 to {count}");
    Err(Refused::new("KinegonError", format!("there is no step {step}"), Some(&hint)))
}

/// The steps of the construction, in the figure's language.
fn steps(solution: &kinegon::Solution) -> Vec<Value> {
    let words = solution.wording();
    let teller = Teller::new(solution, &words);
    let equation = |step: &NumberedStep<'_>| match &step.step.action {
        Action::Solve { equations, .. } => {
            let kind = step.plan.map_or(Sheet::Velocity, |plan| plan.kind);
            let told: Vec<String> = equations.iter().map(|equation| teller.equation(kind, equation)).collect();
            told.join("; ")
        }
        _ => teller.formula(step).markup(),
    };
    let step = |step: NumberedStep<'_>| {
        json!({
            "number": step.number,
            "caption": shown_text(&teller.caption(&step), step.plan, &words),
            "equation": shown_text(&equation(&step), step.plan, &words),
            "panel": step.sheet().as_str(),
        })
    };
    solution.construction.numbered_steps().map(step).collect()
}

#[pymethods]
impl Solution {
    /// The result file of `kinegon solve`, as JSON.
    fn result(&self, py: Python<'_>) -> PyResult<String> {
        let result = py.detach(|| {
            let solution = self.solved(order_of_result(&self.scene.scene))?;
            solution.whole_result().map(|result| json_line(&result)).map_err(|error| self.scene.refused(error))
        });
        Ok(result?)
    }

    fn quantity(&self, py: Python<'_>, name: &str) -> PyResult<ValueOf> {
        Ok(py.detach(|| self.value(name))?)
    }

    /// The table of `kinegon solve --digits`.
    fn digits(&self, py: Python<'_>) -> PyResult<String> {
        Ok(py.detach(|| self.solved(order_of_result(&self.scene.scene)).map(|solution| solution.digits()))?)
    }

    /// The warnings of all stages, and of panels that are cut off.
    fn warnings(&self) -> PyResult<Vec<String>> {
        let solution = self.solved(order_of_result(&self.scene.scene))?;
        Ok(solution.warnings().collect())
    }

    /// The figure with other keys, in the same position.
    fn with_figure(&self, keys: &str) -> PyResult<Solution> {
        let scene = self.scene.with_keys(keys)?;
        let (mechanism, pose) = (self.mechanism.clone(), self.pose.clone());
        Ok(Solution { scene, mode: self.mode, mechanism, pose, solved: Default::default() })
    }

    /// The files of the figure's sheets.
    fn draw<'py>(
        &self,
        py: Python<'py>,
        form: Form,
        coarse: bool,
        style: Option<&str>,
    ) -> PyResult<Vec<Bound<'py, PyBytes>>> {
        let files = py.detach(|| match form.format.as_str() {
            // As `kinegon draw -o page.html` writes it.
            "html" => Ok(vec![self.page(Some(1))?.into_bytes()]),
            "workbench" => Ok(vec![self.page(None)?.into_bytes()]),
            _ => form.files(&self.sheets(style, coarse, form.layered)?),
        });
        Ok(bytes(py, files?))
    }

    /// The text of `kinegon steps`, and the steps as JSON.
    fn steps(&self, py: Python<'_>, mm: Option<f64>, degrees: Option<f64>) -> PyResult<(String, String)> {
        Ok(py.detach(|| self.told_steps(tolerance(mm, degrees)?.unwrap_or_default()))?)
    }

    fn sweep(&self, py: Python<'_>, wanted: Wanted) -> PyResult<Table> {
        py.detach(|| table_of(&self.scene, &self.mechanism, &self.pose, &wanted))
    }

    /// Extremes of quantities, and that a part of the range cannot be reached.
    fn extremes(&self, py: Python<'_>, wanted: Wanted) -> PyResult<(Vec<Extremes>, Option<String>)> {
        py.detach(|| extremes_of(&self.scene, &self.mechanism, &self.pose, &wanted))
    }

    /// The empty form of measured values: JSON or a table.
    fn form(&self, py: Python<'_>, is_table: bool) -> PyResult<String> {
        Ok(py.detach(|| self.empty_form(is_table))?)
    }

    /// The result of a check as JSON, its report, and whether it is passed.
    fn check(&self, py: Python<'_>, form: &str, options: CheckOptions) -> PyResult<(String, String, bool)> {
        Ok(py.detach(|| on_all_cores(|| self.checked(form, &options)).flatten())?)
    }

    /// The page for the student.
    fn feedback(&self, py: Python<'_>, form: &str, options: CheckOptions) -> PyResult<String> {
        Ok(py.detach(|| on_all_cores(|| self.page_for_student(form, &options)).flatten())?)
    }

    /// The student's drawing over the right one.
    fn correction<'py>(
        &self,
        py: Python<'py>,
        form: &str,
        options: CheckOptions,
        sheet: Form,
    ) -> PyResult<Vec<Bound<'py, PyBytes>>> {
        let sheets = || sheet.files(&self.overlay(form, &options)?);
        let files = py.detach(|| on_all_cores(sheets).flatten());
        Ok(bytes(py, files?))
    }
}

/// Files as Python has them.
pub fn bytes(py: Python<'_>, files: Vec<Vec<u8>>) -> Vec<Bound<'_, PyBytes>> {
    files.iter().map(|file| PyBytes::new(py, file)).collect()
}

/// The limits of a hand's errors, if one is given.
pub fn tolerance(mm: Option<f64>, degrees: Option<f64>) -> Result<Option<Tolerance>, Refused> {
    if [mm, degrees].into_iter().flatten().any(|limit| !(0.0..=Tolerance::LARGEST).contains(&limit)) {
        let message = format!("the limits of a pencil's errors are from 0 to {}", Tolerance::LARGEST);
        return Err(Refused::new("KinegonError", message, None));
    }
    let usual = Tolerance::default();
    let given = Tolerance { mm: mm.unwrap_or(usual.mm), degrees: degrees.unwrap_or(usual.degrees) };
    Ok((mm.is_some() || degrees.is_some()).then_some(given))
}
