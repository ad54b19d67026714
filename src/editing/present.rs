//! The present position of a scene, as far as its text tells it.

use indexmap::IndexMap;
use serde_json::{Map, Value as Json};

use super::document::Document;
use crate::Problem;
use crate::geometry::{Placement, Point, Vector, span, unit};
use crate::mechanism::{BodyId, Mechanism, StructureError, mechanism};
use crate::position::{Pose, pose, with_nearest_sides};
use crate::scene::{LARGEST, Scene, SceneError};

/// A scene with its position.
#[derive(Clone, Debug)]
pub(super) struct Solved {
    pub scene: Scene,
    pub mechanism: Mechanism,
    pub pose: Pose,
}

impl Solved {
    /// The position of the scene in a text.
    ///
    /// # Errors
    /// The text is no scene, or the scene cannot be assembled.
    pub fn of(text: &str) -> Result<Solved, SceneError> {
        let scene = Scene::read(text)?;
        let mechanism = of_scene(&scene)?;
        let pose = pose(&mechanism, &scene.near).map_err(|error| refused(&scene, error.problem()))?;
        Ok(Solved { scene, mechanism, pose })
    }

    /// The places of all points, in their order.
    pub fn places(&self) -> IndexMap<String, Point> {
        self.mechanism.points.iter().cloned().zip(self.pose.points.iter().copied()).collect()
    }

    /// Where a link is: from its own frame to the fixed one. `None` for a drawn scene.
    pub fn placement(&self, link: BodyId) -> Option<Placement> {
        let body = self.mechanism.body(link);
        let axis = unit(self.pose.axes.get(link.0).copied().flatten()?)?;
        let (local, place) = (body.local.first()?, self.pose.point(*body.points.first()?));
        Some(placed(axis, *local, place))
    }
}

/// The placement with its x axis along a unit vector that takes `local` to `place`.
pub(super) fn placed(axis: Vector, local: Point, place: Point) -> Placement {
    let turn = crate::geometry::Turn::from_cos_sin_unchecked(axis.x, axis.y);
    Placement::from_parts((place - turn * local.coords).coords.into(), turn)
}

/// The mechanism of a scene.
pub(super) fn of_scene(scene: &Scene) -> Result<Mechanism, SceneError> {
    match mechanism(scene) {
        Ok(mechanism) => Ok(with_nearest_sides(scene, mechanism)),
        Err(StructureError::Scene(error)) => Err(error),
        Err(error) => Err(refused(scene, error.problem())),
    }
}

/// A problem of a stage as one of the scene's links.
pub(super) fn refused(scene: &Scene, Problem { message, hint }: Problem) -> SceneError {
    scene.error_at(&["links"], message, hint)
}

/// What is known of the places of points: all, if the scene can be solved; else those that the text gives.
#[derive(Clone, Debug)]
pub(super) struct Present {
    /// By point.
    pub places: IndexMap<String, Point>,
    solved: Option<Solved>,
}

impl Present {
    /// What a text tells.
    pub fn of(document: &Document<'_>) -> Present {
        let solved = Solved::of(&document.text()).ok();
        let places = solved.as_ref().map_or_else(|| given_places(&document.json()), Solved::places);
        Present { places, solved }
    }

    /// The scene with its position, if it has one.
    pub fn solved(&self) -> Option<&Solved> {
        self.solved.as_ref()
    }

    /// The same places, of a scene that counts as not solved: for one whose points are being put elsewhere.
    pub fn told_roughly(self) -> Present {
        Present { solved: None, ..self }
    }

    /// The size of what is known, with further places.
    pub fn size(&self, further: impl IntoIterator<Item = Point>) -> f64 {
        span(self.places.values().copied().chain(further))
    }

    /// Where a link with a shape is: from its own frame to the fixed one.
    pub fn placement(&self, link: &str, shape: &Map<String, Json>) -> Option<Placement> {
        if let Some(solved) = &self.solved {
            return solved.placement(solved.mechanism.link(link)?);
        }
        let points = shape.iter().filter_map(|(name, local)| Some((local_place(local)?, *self.places.get(name)?)));
        let points: Vec<(Point, Point)> = points.collect();
        let (first, last) = (points.first()?, points.last()?);
        let (own, fixed) = (unit(last.0 - first.0)?, unit(last.1 - first.1)?);
        let axis = Vector::new(own.dot(&fixed), own.perp(&fixed));
        Some(placed(unit(axis)?, first.0, first.1))
    }
}

/// Where the points of a scene are in the fixed frame, in its unit of length: as solved; of a text that is no complete scene, or
/// cannot be assembled, those that it says, be it roughly.
///
/// # Errors
/// The text is not JSON.
pub fn places(text: &str) -> Result<IndexMap<String, [f64; 2]>, SceneError> {
    let present = Present::of(&Document::new(text)?);
    Ok(present.places.into_iter().map(|(name, place)| (name, place.into())).collect())
}

/// The places that a text gives: those of the ground, of a drawing and of `near`.
fn given_places(scene: &Json) -> IndexMap<String, Point> {
    let tables = ["near", "points", "ground"].map(|key| scene[key].as_object());
    let entries = tables.into_iter().flatten().flatten();
    entries.filter_map(|(name, place)| Some((name.clone(), two_numbers(place)?))).collect()
}

/// A number that a scene may have: what is reckoned with larger ones is not finite.
fn number(value: &Json) -> Option<f64> {
    value.as_f64().filter(|number| number.abs() <= LARGEST)
}

/// A list of two numbers as a place.
pub(super) fn two_numbers(value: &Json) -> Option<Point> {
    match value.as_array().map(Vec::as_slice) {
        Some([x, y]) => Some(Point::new(number(x)?, number(y)?)),
        _ => None,
    }
}

/// A place of a shape: two numbers, or one on the axis.
fn local_place(value: &Json) -> Option<Point> {
    number(value).map(|x| Point::new(x, 0.0)).or_else(|| two_numbers(value))
}
