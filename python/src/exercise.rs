use crate::pool::on_all_cores;
use crate::refused::Refused;
use crate::scene::Scene;
use crate::sheet::Form;
use kinegon::board::{Given, own_drawing};
use kinegon::format::json;
use kinegon::scene::SizeLimit;
use kinegon::{exercise, format};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::{Mutex, PoisonError};

/// Which figure exercises have.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ExerciseOptions {
    /// Keys of the scene's figure, as JSON.
    figure: String,
    /// Whether the sheet is among them.
    has_page: bool,
}

/// The exercises of a scene, one after another.
#[pyclass(frozen, module = "kinegon._kinegon")]
pub struct Exercises(Mutex<exercise::Exercises>);

/// An exercise with its sheets.
#[pyclass(frozen, module = "kinegon._kinegon")]
pub struct Exercise(exercise::Exercise);

impl Exercises {
    pub fn of(scene: &Scene, seed: u64, options: &ExerciseOptions) -> Result<Exercises, Refused> {
        let asked = scene.with_keys(&options.figure)?;
        SizeLimit::HAND.check(&asked.scene).map_err(|error| scene.refused(error))?;
        let solution = kinegon::solve(&asked.scene).map_err(|error| scene.refused(error))?;
        solution.check_form().map_err(|error| scene.refused(error))?;
        let page = options.has_page.then_some(solution.scene.figure.page);
        let found = on_all_cores(|| exercise::Exercises::new(&solution, page, seed))?;
        Ok(Exercises(Mutex::new(found?)))
    }
}

#[pymethods]
impl Exercises {
    /// The next exercise.
    fn next(&self, py: Python<'_>) -> PyResult<Exercise> {
        let next = || on_all_cores(|| self.0.lock().unwrap_or_else(PoisonError::into_inner).next());
        let found = py.detach(next)?;
        Ok(Exercise(found.map_err(Refused::from)?))
    }
}

#[pymethods]
impl Exercise {
    /// The text of its scene.
    fn text(&self) -> String {
        self.0.text.clone()
    }

    /// The values of the key, as JSON.
    fn key(&self) -> String {
        format::json_line(&self.0.key())
    }

    /// The file key.json.
    fn key_file(&self) -> String {
        json(&self.0.key())
    }

    /// The file key-drawing.json.
    fn key_drawing(&self) -> String {
        own_drawing(&Given::new(&self.0.solution), &self.0.solution.scales())
    }

    /// The empty form of the exercise with that name: JSON or a table.
    fn form(&self, name: &str, is_table: bool) -> String {
        let form = self.0.form(name);
        if is_table { form.csv(&self.0.solution) } else { form.json(&self.0.solution) }
    }

    /// The drawn key.
    fn draw_key<'py>(&self, py: Python<'py>, form: Form) -> PyResult<Bound<'py, PyBytes>> {
        let file = py.detach(|| form.bytes(&self.0.key_sheet()));
        Ok(PyBytes::new(py, &file?))
    }

    /// The student's sheets of the exercise with that name; as PDF one file with all of them.
    fn draw<'py>(&self, py: Python<'py>, name: &str, form: Form) -> PyResult<Vec<Bound<'py, PyBytes>>> {
        let files = py.detach(|| form.joined(&self.0.sheets(name)))?;
        Ok(files.iter().map(|file| PyBytes::new(py, file)).collect())
    }
}
