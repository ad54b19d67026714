//! What Python calls on a scene and on a solution.

use crate::check::CheckOptions;
use crate::exercise::{ExerciseOptions, Exercises};
use crate::pool::on_all_cores;
use crate::scene::Scene;
use crate::sheet::Form;
use crate::solution::{Solution, ValueOf, tolerance};
use crate::sweep::{Extremes, extremes_of, table, table_of};
use crate::table::Table;
use crate::wanted::Wanted;
use kinegon::Order;
use kinegon::drawing::Timing;
use kinegon::format::{self, json_line};
use kinegon::mechanism::mechanism;
use kinegon::words::Wording;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

#[pymethods]
impl Scene {
    #[new]
    fn new(py: Python<'_>, text: String, is_seen: bool) -> PyResult<Scene> {
        Ok(py.detach(|| Scene::read(text, is_seen))?)
    }

    fn title(&self) -> Option<String> {
        self.scene.title.as_ref().map(|title| title.for_message())
    }

    fn with_figure(&self, keys: &str) -> PyResult<Scene> {
        Ok(self.with_keys(keys)?)
    }

    fn solve(&self, py: Python<'_>, mode: Option<usize>) -> PyResult<Solution> {
        Ok(py.detach(|| Solution::of(self, mode))?)
    }

    /// The Assur groups in solving order, as `kinegon structure` prints them.
    fn structure(&self, py: Python<'_>) -> PyResult<String> {
        let words = Wording::of(&self.scene.figure);
        let text = || Ok(format::structure(&mechanism(&self.scene)?, &words));
        let text = py.detach(|| text().map_err(|error: kinegon::Error| self.refused(error)));
        Ok(text?)
    }

    /// The text of `kinegon modes`, and the modes as JSON.
    fn modes(&self, py: Python<'_>) -> PyResult<(String, String)> {
        Ok(py.detach(|| self.all_modes())?)
    }

    fn sweep(&self, py: Python<'_>, mode: Option<usize>, wanted: Wanted) -> PyResult<Table> {
        py.detach(|| table(self, mode, &wanted))
    }

    fn exercises(&self, py: Python<'_>, seed: u64, options: ExerciseOptions) -> PyResult<Exercises> {
        Ok(py.detach(|| Exercises::of(self, seed, &options))?)
    }
}

#[pymethods]
impl Solution {
    /// The result file of `kinegon solve`, as JSON.
    fn result(&self, py: Python<'_>) -> PyResult<String> {
        let result = py.detach(|| {
            let solution = self.solved(Order::Acceleration)?;
            solution.whole_result().map(|result| json_line(&result)).map_err(|error| self.scene.refused(error))
        });
        Ok(result?)
    }

    fn quantity(&self, py: Python<'_>, name: &str) -> PyResult<ValueOf> {
        Ok(py.detach(|| self.value(name))?)
    }

    /// The table of `kinegon solve --digits`.
    fn digits(&self, py: Python<'_>) -> PyResult<String> {
        Ok(py.detach(|| self.solved(Order::Acceleration).map(|solution| solution.digits()))?)
    }

    /// The warnings of all stages, and of panels that are cut off.
    fn warnings(&self) -> PyResult<Vec<String>> {
        let solution = self.solved(Order::Acceleration)?;
        Ok(solution.warnings().collect())
    }

    /// The figure with other keys, in the same position.
    fn with_figure(&self, keys: &str) -> PyResult<Solution> {
        Ok(self.with_keys(keys)?)
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

    /// The film of the figure as a file.
    fn film<'py>(
        &self,
        py: Python<'py>,
        form: Form,
        seconds: Option<f64>,
        fps: Option<u16>,
        drive: Option<&str>,
        style: Option<&str>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let usual = Timing::default();
        let timing = Timing { seconds: seconds.unwrap_or(usual.seconds), per_second: fps.unwrap_or(usual.per_second) };
        let film = || form.film(&self.film_of(timing, drive, style)?);
        let file = py.detach(|| on_all_cores(film).flatten());
        Ok(PyBytes::new(py, &file?))
    }

    /// The text of `kinegon steps`, and the steps as JSON.
    fn steps(&self, py: Python<'_>, mm: Option<f64>, degrees: Option<f64>) -> PyResult<(String, String)> {
        Ok(py.detach(|| self.told_steps(tolerance(mm, degrees)?.unwrap_or_default()))?)
    }

    /// The velocity plan, or that of accelerations, as JSON.
    fn plan(&self, py: Python<'_>, is_of_accelerations: bool) -> PyResult<String> {
        let order = if is_of_accelerations { Order::Acceleration } else { Order::Velocity };
        Ok(py.detach(|| self.plan_of(order))?)
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

    /// Kinegon's own construction as a drawing.
    fn drawing(&self, py: Python<'_>) -> PyResult<String> {
        Ok(py.detach(|| self.own_drawing())?)
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
fn bytes(py: Python<'_>, files: Vec<Vec<u8>>) -> Vec<Bound<'_, PyBytes>> {
    files.iter().map(|file| PyBytes::new(py, file)).collect()
}
