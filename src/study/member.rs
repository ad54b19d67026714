//! One mechanism of a study in its position, and the values of its quantities.

use super::number::has_links;
use super::task::Status;
use crate::cycle::CycleError;
use crate::mechanism::{Mechanism, StructureError, mechanism};
use crate::position::{AssemblyError, Pose, pose, with_nearest_sides};
use crate::quantity::{Quantity, QuantityRequest, State};
use crate::scene::{Scene, SceneError, SizeLimit};

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

/// The mechanism of a varied scene, in its position; else what became of it.
pub(super) fn member(scene: &Scene) -> Result<(Mechanism, Pose), Status> {
    if !has_links(scene) {
        return Err(Status::NoMechanism);
    }
    posed(scene).map_err(|error| match error {
        StudyError::Assembly(_) => Status::NotAssembled,
        _ => Status::NoMechanism,
    })
}

/// The mechanism of a scene in the assembly mode that `near` picks.
pub(super) fn posed(scene: &Scene) -> Result<(Mechanism, Pose), StudyError> {
    SizeLimit::NUMBERS.check(scene)?;
    let mechanism = with_nearest_sides(scene, mechanism(scene)?);
    let pose = pose(&mechanism, &scene.near)?;
    Ok((mechanism, pose))
}

/// The value of a quantity that needs no construction, of a vector its size; NaN where it has none.
pub(super) fn value(asked: &QuantityRequest, state: &impl State) -> f64 {
    asked.value(state, None, None).map_or(f64::NAN, size)
}

/// A number, or the size of a vector.
pub(super) fn size(quantity: Quantity) -> f64 {
    match quantity {
        Quantity::Number(x) => x,
        Quantity::Vector(v) => v.norm(),
    }
}
