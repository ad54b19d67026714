//! A mechanism that is being put together, in the page's hand Build.

use crate::answers::Pane;
use crate::refused::Refused;
use kinegon::drawing::{self, DraftView};
use kinegon::editing::{self, Draft, DraftSlider, Edit, PlacedPoint};
use serde::{Deserialize, Serialize};

/// What of the mechanism is seen.
#[derive(Clone, Copy, Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct DraftedView {
    /// The part of the screen.
    pub pane: Pane,
    /// The place of the mechanism in its middle, in units of length.
    pub centre: [f64; 2],
    /// Pixels for a unit of length.
    pub scale: f64,
}

/// What is known of a mechanism, complete or not, with its picture.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Drafted {
    /// The picture.
    pub svg: String,
    /// Width of the picture in mm.
    pub width: f64,
    /// Height of the picture in mm.
    pub height: f64,
    /// The points whose places are known.
    pub points: Vec<DraftedPoint>,
    /// The sliders, in the order of the scene.
    pub sliders: Vec<DraftedSlider>,
    /// Whether the mechanism is complete: it has a position.
    pub is_complete: bool,
}

/// A point of it.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct DraftedPoint {
    /// Its name.
    pub name: String,
    /// Its place, in units of length.
    pub at: [f64; 2],
    /// Whether it is a point of the ground.
    pub is_fixed: bool,
}

/// A slider of it.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct DraftedSlider {
    /// The unit direction of its guide; none where that is not known.
    pub along: Option<[f64; 2]>,
    /// How far it is along its guide now, in units of length; none where that is not known.
    pub position: Option<f64>,
}

/// Points that are to be elsewhere.
pub type Moves = Vec<PlacedPoint>;

/// What is known of the mechanism of a scene's text.
pub fn drafted(text: &str, view: &DraftedView) -> Result<Drafted, Refused> {
    let draft = Draft::of(text).map_err(|error| Refused::of(text, error))?;
    let scale = if view.scale > 0.0 && view.scale.is_finite() { view.scale } else { 1.0 };
    let drawing = drawing::draft(&draft, &DraftView { pane: view.pane.into(), centre: view.centre, scale });
    let slider = |slider: &DraftSlider| {
        let place = draft.points.get(&slider.at).map(|point| point.at);
        DraftedSlider {
            along: slider.guide.map(|guide| guide.along.into()),
            position: slider.guide.zip(place).map(|(guide, place)| (place - guide.through).dot(&guide.along)),
        }
    };
    Ok(Drafted {
        svg: drawing.svg(),
        width: drawing.width,
        height: drawing.height,
        points: draft
            .points
            .iter()
            .map(|(name, point)| DraftedPoint { name: name.clone(), at: point.at.into(), is_fixed: point.is_fixed })
            .collect(),
        sliders: draft.sliders.iter().map(slider).collect(),
        is_complete: draft.is_complete,
    })
}

/// The scene's text after some changes, with all points where they were.
pub fn edited(text: &str, edits: &[Edit]) -> Result<String, Refused> {
    editing::apply_in_place(text, edits).map_err(|error| Refused::of(text, error))
}

/// The lines of the table of a load of this name, which may be empty.
pub fn load_table(table: &str, load: &str) -> Result<Vec<[f64; 2]>, Refused> {
    editing::lines_of_table(table, Some(load).filter(|load| !load.is_empty())).map_err(Refused::whole)
}

/// The scene's text with points elsewhere.
pub fn moved(text: &str, moves: &Moves) -> Result<String, Refused> {
    editing::with_places(text, moves).map_err(|error| Refused::of(text, error))
}
