use crate::Problem;
use crate::cycle::CycleError;
use crate::drawing::CurvesError;
use crate::mechanism::StructureError;
use crate::motion::MotionError;
use crate::position::AssemblyError;
use crate::quantity::QuantityError;
use crate::scene::SceneError;
use crate::study::StudyError;

/// Why a scene gives no result: the error of the stage that found it.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The scene cannot be understood.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// It is no mechanism that can be solved.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// It cannot be assembled.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// It is in a singular position.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// It cannot be moved as was asked for.
    #[error(transparent)]
    Cycle(#[from] CycleError),
    /// A quantity that was asked for has no value.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// Curves do not fit on the sheet.
    #[error(transparent)]
    Curves(#[from] CurvesError),
}

impl Error {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            Error::Scene(error) => error.problem(),
            Error::Structure(error) => error.problem(),
            Error::Assembly(error) => error.problem(),
            Error::Motion(error) => error.problem(),
            Error::Cycle(error) => error.problem(),
            Error::Quantity(error) => error.problem(),
            Error::Curves(error) => error.problem(),
        }
    }

    /// The error of the scene's own, which has a place in its text; `None` for what only a later stage finds.
    #[must_use]
    pub fn in_scene(&self) -> Option<&SceneError> {
        match self {
            Error::Scene(error) | Error::Structure(StructureError::Scene(error)) => Some(error),
            _ => None,
        }
    }
}

impl From<StudyError> for Error {
    fn from(error: StudyError) -> Error {
        match error {
            StudyError::Study(error) => error.into(),
            StudyError::Structure(error) => error.into(),
            StudyError::Assembly(error) => error.into(),
            StudyError::Cycle(error) => error.into(),
        }
    }
}
