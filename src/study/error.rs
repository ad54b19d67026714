use crate::cycle::CycleError;
use crate::mechanism::StructureError;
use crate::position::AssemblyError;
use crate::scene::SceneError;

/// Why a study cannot be made of a scene.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The study asks for what the scene does not have; the place is in the study.
    #[error(transparent)]
    Study(#[from] SceneError),
    /// The scene is no mechanism that can be solved.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// The scene cannot be assembled.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// The scene cannot be moved.
    #[error(transparent)]
    Cycle(#[from] CycleError),
}
