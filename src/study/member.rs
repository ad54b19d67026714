//! One mechanism of a study in its position, and the values of its quantities.

use super::number::has_links;
use super::task::Status;
use crate::Error;
use crate::mechanism::Mechanism;
use crate::position::Pose;
use crate::quantity::{Quantity, QuantityRequest, State};
use crate::scene::{Scene, SceneError, SizeLimit};
use crate::solve::posed;

/// Why a study cannot be made of a scene.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The study asks for what the scene does not have; the place is in the study.
    #[error(transparent)]
    Study(#[from] SceneError),
    /// The scene gives no mechanism that can be assembled and moved.
    #[error(transparent)]
    Scene(#[from] Error),
}

/// The mechanism of a varied scene, in its position; else what became of it.
pub(super) fn member(scene: &Scene) -> Result<(Mechanism, Pose), Status> {
    if !has_links(scene) {
        return Err(Status::NoMechanism);
    }
    posed(scene, SizeLimit::NUMBERS, None).map_err(|error| match error {
        Error::Assembly(_) => Status::NotAssembled,
        _ => Status::NoMechanism,
    })
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
