//! Kinegon for Python, the part in Rust: texts, names and numbers in; JSON, files and tables out. `package/kinegon` dresses it; that is
//! what people see. Nothing here reads a file or prints, but [`program`], which is the whole command line.
//!
//! Long work is done without Python's lock.

mod check;
mod exercise;
mod methods;
mod plot;
mod pool;
mod refused;
mod scene;
mod sheet;
mod solution;
mod study;
mod sweep;
mod table;
mod wanted;

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs a command line, the program's name first; its exit code.
#[pyfunction]
fn program(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| kinegon::cli::run_with(arguments))
}

/// The module `kinegon._kinegon`.
#[pymodule]
fn _kinegon(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("KINDS", kinegon::scene::Kind::NAMES.to_vec())?;
    module.add("MAX_BYTES", kinegon::scene::MAX_BYTES)?;
    module.add_function(wrap_pyfunction!(program, module)?)?;
    module.add_function(wrap_pyfunction!(scene::kind, module)?)?;
    module.add("STATUSES", kinegon::study::Status::ALL.map(|status| status.word()).to_vec())?;
    module.add_function(wrap_pyfunction!(study::scene_of_study, module)?)?;
    module.add_class::<study::Study>()?;
    module.add_class::<scene::Scene>()?;
    module.add_class::<solution::Solution>()?;
    module.add_class::<table::Table>()?;
    module.add_class::<exercise::Exercises>()?;
    module.add_class::<exercise::Exercise>()
}
