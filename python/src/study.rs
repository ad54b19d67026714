//! Rows of a study, in memory, column by column.

use crate::pool::on_all_cores;
use crate::refused::Refused;
use crate::table::{Notes, Table, empty};
use kinegon::study::{Column, Content, SceneGiven, StudyFile};
use kinegon::{Error, study};
use pyo3::prelude::*;
use std::collections::BTreeMap;

/// Rows for each core that are computed before Python may interrupt.
const ROWS: u64 = 512;

/// Many mechanisms that differ from one scene in some numbers.
#[pyclass(frozen, module = "kinegon._kinegon")]
pub struct Study {
    study: study::Study,
    columns: Vec<Column>,
    /// What a file of its rows says of where they come from.
    origin: Vec<(String, String)>,
}

/// The path of a study's scene, from the study's folder; none where the study has the scene itself.
#[pyfunction]
pub fn scene_of_study(text: &str, is_seen: bool) -> PyResult<Option<String>> {
    match read(text, is_seen)?.scene() {
        SceneGiven::Path(path) => Ok(Some(path)),
        SceneGiven::Inline(_) => Ok(None),
    }
}

fn read(text: &str, is_seen: bool) -> Result<StudyFile, Refused> {
    StudyFile::read(text).map_err(|error| Refused::from(error).seen(is_seen))
}

fn made(text: &str, is_seen: bool, scene: Option<String>) -> Result<Study, Refused> {
    let file = read(text, is_seen)?;
    let scene = match (scene, file.scene()) {
        (Some(text), _) | (None, SceneGiven::Inline(text)) => text,
        (None, SceneGiven::Path(path)) => {
            return Err(Refused::new("KinegonError", format!("{path} was not read"), None));
        }
    };
    let refused = |error: Error| Refused::from(error).seen(is_seen);
    let origin = file.origin(&scene);
    let scene = kinegon::Scene::read(&scene).map_err(|error| refused(error.into()))?;
    let study = file.of(scene).map_err(|error| refused(error.into()))?;
    Ok(Study { columns: study.columns(), study, origin })
}

#[pymethods]
impl Study {
    /// The study of a text; the text of its scene, where that is a file of its own.
    #[new]
    fn new(py: Python<'_>, text: &str, is_seen: bool, scene: Option<String>) -> PyResult<Study> {
        Ok(py.detach(|| made(text, is_seen, scene))?)
    }

    /// How many rows it has.
    fn count(&self) -> u64 {
        self.study.count()
    }

    /// What a file of its rows says of where they come from, by keys.
    fn origin(&self) -> BTreeMap<String, String> {
        self.origin.iter().cloned().collect()
    }

    /// The names of the columns.
    fn names(&self) -> Vec<String> {
        self.columns.iter().map(|column| column.name.clone()).collect()
    }

    /// The rows from `first` to before `last`, which are in order and there.
    fn rows(&self, py: Python<'_>, first: u64, last: u64, huge: bool) -> PyResult<Table> {
        py.detach(|| self.table(first, last.min(self.study.count()), huge))
    }
}

impl Study {
    fn table(&self, first: u64, last: u64, is_huge: bool) -> PyResult<Table> {
        let (rows, columns) = (last.saturating_sub(first) as usize, self.columns.len());
        let hint = "take a part of them, as rows(0, 100000); with huge=True it is made";
        let mut data = empty(rows, columns, is_huge, hint)?;
        let block = ROWS * on_all_cores(rayon::current_num_threads)? as u64;
        let mut row = 0;
        for from in (first..last).step_by(block as usize) {
            let block = on_all_cores(|| self.study.rows_on_all_cores(from..last.min(from + block)))?;
            for numbers in block.chunks_exact(columns) {
                for (column, number) in numbers.iter().enumerate() {
                    data[column * rows + row] = *number;
                }
                row += 1;
            }
            Python::attach(|py| py.check_signals())?;
        }
        let status = self.columns.iter().position(|column| column.content == Content::Status);
        let units = self.columns.iter().map(|column| column.unit.clone()).collect();
        Ok(Table::of(self.names(), units, rows, data, Notes::default()).with_status(status))
    }
}
