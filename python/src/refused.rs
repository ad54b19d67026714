//! Why something cannot be done, on its way to an exception of `kinegon._errors`.

use kinegon::check::CheckError;
use kinegon::cycle::CycleError;
use kinegon::exercise::ExerciseError;
use kinegon::mechanism::StructureError;
use kinegon::motion::MotionError;
use kinegon::position::AssemblyError;
use kinegon::quantity::QuantityError;
use kinegon::scene::SceneError;
use kinegon::{Error, Problem};
use pyo3::PyErr;
use pyo3::prelude::*;

/// What is wrong, where, and what to try.
#[derive(Debug)]
pub struct Refused {
    /// The exception's class.
    class: &'static str,
    message: String,
    hint: Option<String>,
    /// The JSON path.
    path: String,
    /// Line and column in the text.
    place: Option<(usize, usize)>,
}

impl Refused {
    pub fn new(class: &'static str, message: impl Into<String>, hint: Option<&str>) -> Refused {
        Refused { class, message: message.into(), hint: hint.map(str::to_owned), path: String::new(), place: None }
    }

    /// The same where the person has not seen the text: its lines say nothing.
    pub fn without_place(self) -> Refused {
        Refused { place: None, ..self }
    }

    /// The same, of a text that the person has seen or not.
    pub fn seen(self, is_seen: bool) -> Refused {
        if is_seen { self } else { self.without_place() }
    }

    fn told(class: &'static str, problem: &Problem) -> Refused {
        Refused::new(class, problem.message.to_string(), problem.hint.as_ref().map(ToString::to_string).as_deref())
    }
}

impl From<SceneError> for Refused {
    fn from(error: SceneError) -> Refused {
        Refused {
            class: "SceneError",
            message: error.message.to_string(),
            hint: error.hint.map(|hint| hint.to_string()),
            path: error.path,
            place: error.place.map(|place| (place.line, place.column)),
        }
    }
}

impl From<CheckError> for Refused {
    fn from(error: CheckError) -> Refused {
        Refused::new("CheckError", error.to_string(), error.hint.as_ref().map(ToString::to_string).as_deref())
    }
}

impl From<ExerciseError> for Refused {
    fn from(error: ExerciseError) -> Refused {
        Refused::new("ExerciseError", error.to_string(), None)
    }
}

impl From<Error> for Refused {
    fn from(error: Error) -> Refused {
        if let Some(error) = error.in_scene() {
            return error.clone().into();
        }
        let class = match error {
            Error::Structure(_) => "StructureError",
            Error::Assembly(_) => "AssemblyError",
            Error::Motion(_) => "MotionError",
            Error::Cycle(_) => "CycleError",
            Error::Quantity(_) => "QuantityError",
            _ => "KinegonError",
        };
        Refused::told(class, &error.problem())
    }
}

/// Errors of single stages are errors of a scene.
macro_rules! stages {
    ($($stage:ty),*) => {
        $(impl From<$stage> for Refused {
            fn from(error: $stage) -> Refused {
                Error::from(error).into()
            }
        })*
    };
}

stages!(StructureError, AssemblyError, MotionError, CycleError, QuantityError);

impl From<Refused> for PyErr {
    fn from(refused: Refused) -> PyErr {
        let Refused { class, message, hint, path, place } = refused;
        let (line, column) = place.unzip();
        Python::attach(|py| {
            let made = || py.import("kinegon._errors")?.getattr(class)?.call1((message, hint, path, line, column));
            made().map_or_else(|error| error, PyErr::from_value)
        })
    }
}
