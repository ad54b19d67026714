//! What a text says of a mechanism that somebody is putting together: as much as is known, be it complete or not.

use indexmap::IndexMap;
use serde_json::Value as Json;

use super::document::Document;
use super::names::Names;
use super::present::{Present, two_numbers};
use crate::geometry::{Point, Turn, Vector, direction_of_degrees, turn_of_degrees, unit};
use crate::scene::{SceneError, pair};

/// A mechanism as far as its text tells it. Of a scene that can be solved all is known; of one that is not complete yet, what
/// rough places, lengths and angles say; what has no place is left out.
#[derive(Clone, Debug)]
pub struct Draft {
    /// The points whose places are known.
    pub points: IndexMap<String, DraftPoint>,
    /// The links.
    pub links: Vec<DraftLink>,
    /// The sliders, in the order of the text.
    pub sliders: Vec<DraftSlider>,
    /// Pitch circles of wheels, and circles of curvature of profiles that touch.
    pub circles: Vec<DraftCircle>,
    /// The forces and couples.
    pub loads: Vec<DraftLoad>,
    /// The springs.
    pub springs: Vec<DraftSpring>,
    /// Whether the scene can be solved for its position.
    pub is_complete: bool,
}

/// A point of a [`Draft`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DraftPoint {
    /// Its place in the fixed frame, in units of length.
    pub at: Point,
    /// Whether it is a point of the ground.
    pub is_fixed: bool,
}

/// A link of a [`Draft`].
#[derive(Clone, Debug, PartialEq)]
pub struct DraftLink {
    /// Its name.
    pub name: String,
    /// Its points, also those without a known place.
    pub points: Vec<String>,
    /// A drive that turns it: positive where that is counter-clockwise or not said.
    pub turning: Option<f64>,
}

/// A slider of a [`Draft`].
#[derive(Clone, Debug, PartialEq)]
pub struct DraftSlider {
    /// The sliding link; `None` for a pin in a slot.
    pub link: Option<String>,
    /// The point of it that is on the guide, or the pin.
    pub at: String,
    /// What carries the guide: a link, or `ground`.
    pub on: String,
    /// Its guide; `None` where that is not known.
    pub guide: Option<DraftGuide>,
    /// The speed of a drive that pushes it along the guide, in the scene's units.
    pub drive: Option<f64>,
}

/// The guide of a slider in the fixed frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DraftGuide {
    /// The place from which positions count.
    pub through: Point,
    /// Its unit direction.
    pub along: Vector,
}

/// A circle of a [`Draft`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DraftCircle {
    /// Its centre in the fixed frame.
    pub at: Point,
    /// Its radius, positive.
    pub radius: f64,
}

/// A spring of a [`Draft`].
#[derive(Clone, Debug, PartialEq)]
pub struct DraftSpring {
    /// Its ends in the fixed frame, each with the link or `ground` that it is fixed to.
    pub ends: [(String, Point); 2],
}

/// A force or a couple of a [`Draft`].
#[derive(Clone, Debug, PartialEq)]
pub struct DraftLoad {
    /// Its name.
    pub name: String,
    /// Where it acts.
    pub at: Point,
    /// The force in the fixed frame; zero of a couple.
    pub force: Vector,
    /// The couple, counter-clockwise positive.
    pub couple: f64,
}

impl Draft {
    /// What a text tells.
    ///
    /// # Errors
    /// The text is not JSON.
    pub fn of(text: &str) -> Result<Draft, SceneError> {
        let document = Document::new(text)?;
        let sketch = Sketch::of(&document, Present::of(&document));
        let Sketch { scene, names, present, .. } = &sketch;
        let points = present.places.iter().map(|(name, place)| {
            let is_fixed = names.ground.contains(name);
            (name.clone(), DraftPoint { at: *place, is_fixed })
        });
        let links = names.links.iter().map(|(name, points)| {
            let turning = turning(&scene["links"][name]["drive"]);
            DraftLink { name: name.clone(), points: points.clone(), turning }
        });
        let sliders = sliders(scene).iter().enumerate().filter_map(|(index, slider)| {
            let link = slider["link"].as_str().map(str::to_owned);
            let own = &slider["drive"];
            let drive = if own.is_object() { own } else { &scene["links"][link.as_deref().unwrap_or("")]["drive"] };
            Some(DraftSlider {
                at: slider["at"].as_str().or(slider["pin"].as_str())?.to_owned(),
                on: slider["on"].as_str()?.to_owned(),
                guide: sketch.guide(index),
                drive: pushing(drive),
                link,
            })
        });
        Ok(Draft {
            points: points.collect(),
            links: links.collect(),
            sliders: sliders.collect(),
            circles: sketch.circles(),
            loads: sketch.loads(),
            springs: sketch.springs(),
            is_complete: present.solved().is_some(),
        })
    }

    /// The known places of a link's points, or of the ground's.
    pub fn places_on(&self, carrier: &str) -> impl Iterator<Item = Point> + '_ {
        let link = self.links.iter().find(|link| link.name == carrier);
        let of_link = link.into_iter().flat_map(|link| &link.points).filter_map(|name| self.points.get(name));
        let is_ground = carrier == "ground";
        let of_ground = self.points.values().filter(move |point| is_ground && point.is_fixed);
        of_link.chain(of_ground).map(|point| point.at)
    }
}

/// The speed of a drive that turns.
fn turning(drive: &Json) -> Option<f64> {
    let speed = ["omega", "rpm"].into_iter().find_map(|key| drive[key].as_f64());
    (drive.is_object() && pushing(drive).is_none()).then_some(speed.unwrap_or(1.0))
}

/// The speed of a drive that pushes.
fn pushing(drive: &Json) -> Option<f64> {
    let pushes = ["position", "speed"].into_iter().any(|key| drive[key].is_number());
    pushes.then(|| drive["speed"].as_f64().unwrap_or(1.0))
}

/// The entries of the list of sliders.
pub(super) fn sliders(scene: &Json) -> &[Json] {
    scene["sliders"].as_array().map_or(&[], Vec::as_slice)
}

/// A text with its names and what is known of its places.
pub(super) struct Sketch {
    pub(super) scene: Json,
    pub(super) names: Names,
    pub(super) present: Present,
}

/// How many blocks may carry each other before a guide counts as unknown.
const DEPTH: usize = 8;

impl Sketch {
    pub(super) fn of(document: &Document<'_>, present: Present) -> Sketch {
        let scene = document.json();
        Sketch { names: Names::of(&scene), scene, present }
    }

    /// The guide of the slider of that index.
    pub(super) fn guide(&self, index: usize) -> Option<DraftGuide> {
        let slider = &self.scene["sliders"][index];
        let at = slider["at"].as_str().or(slider["pin"].as_str())?;
        if let Some(solved) = self.present.solved() {
            let along = *solved.pose.guides.get(index)?;
            let slid = solved.pose.slides.get(index).copied().flatten().unwrap_or_default();
            return Some(DraftGuide { through: self.present.places.get(at)? - along * slid, along });
        }
        Some(DraftGuide { through: self.through(slider, at)?, along: self.along(slider, DEPTH)? })
    }

    pub(super) fn place(&self, name: &str) -> Option<Point> {
        self.present.places.get(name).copied()
    }

    /// A place of the guide; where the text says none that is known, the point itself.
    fn through(&self, slider: &Json, at: &str) -> Option<Point> {
        let on = slider["on"].as_str()?;
        let said = match &slider["through"] {
            Json::String(point) => self.place(point),
            Json::Array(_) if on == "ground" => two_numbers(&slider["through"]),
            Json::Array(_) => {
                let shape = self.scene["links"][on]["shape"].as_object();
                let placement = shape.and_then(|shape| self.present.placement(on, shape));
                placement.zip(two_numbers(&slider["through"])).map(|(placement, local)| placement * local)
            }
            _ => {
                let points = self.names.of_carrier(on);
                let ends = slider["along"].as_str().and_then(|key| pair(key, points));
                ends.map(|(from, _)| from).or_else(|| points.first().cloned()).and_then(|name| self.place(&name))
            }
        };
        said.or_else(|| self.place(at))
    }

    /// The direction of the guide.
    fn along(&self, slider: &Json, depth: usize) -> Option<Vector> {
        let on = slider["on"].as_str()?;
        let axis = || if on == "ground" { Some(Vector::x()) } else { self.axis_within(on, depth) };
        match &slider["along"] {
            Json::String(key) => {
                let (from, to) = pair(key, self.names.of_carrier(on))?;
                unit(self.place(&to)? - self.place(&from)?)
            }
            Json::Array(_) => {
                let own = unit(two_numbers(&slider["along"])?.coords)?;
                Some(Turn::from_cos_sin_unchecked(own.x, own.y) * axis()?)
            }
            Json::Number(degrees) => {
                let own = direction_of_degrees(degrees.as_f64()?);
                Some(Turn::from_cos_sin_unchecked(own.x, own.y) * axis()?)
            }
            _ => axis(),
        }
    }

    /// The direction of a link's axis: between its first two points; of a block along its guide.
    pub(super) fn axis(&self, link: &str) -> Option<Vector> {
        self.axis_within(link, DEPTH)
    }

    fn axis_within(&self, link: &str, depth: usize) -> Option<Vector> {
        if let Some(shape) = self.scene["links"][link]["shape"].as_object() {
            return Some(self.present.placement(link, shape)?.rotation * Vector::x());
        }
        if let [from, to, ..] = self.names.of_carrier(link) {
            return unit(self.place(to)? - self.place(from)?);
        }
        let slider = sliders(&self.scene).iter().find(|slider| slider["link"] == *link)?;
        let along = self.along(slider, depth.checked_sub(1)?)?;
        Some(turn_of_degrees(slider["turned"].as_f64().unwrap_or_default()) * along)
    }
}
