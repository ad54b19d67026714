//! Sliders: links on straight guides and pins in slots; their keys in the file, their checked form and the checks.

use std::collections::HashSet;

use indexmap::IndexMap;
use serde::Deserialize;

use super::{JointKind, Meaning};
use crate::message::Message;
use crate::scene::error::{Wrong, number};
use crate::scene::given::{GivenBy, SliderDrive};
use crate::scene::link::{Link, Shape};
use crate::scene::name::{checked_pair, no_point};
use crate::scene::names::{Coordinates, Names};
use crate::scene::says;
use crate::scene::value::{At, Direction};
use crate::scene::write::write_keys;
use crate::text::shown;

/// A link, by its point `at`, slides on a guide of `on`; or a pin rides in a slot of `on`.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "slider"))]
#[serde(deny_unknown_fields, expecting = r#"a slider as { "link": "3", "at": "D", "on": "2", "along": "BE" }"#)]
pub(in crate::scene) struct SliderFile {
    /// The sliding link.
    pub link: Option<String>,
    /// The point of the sliding link that is on the guide.
    pub at: Option<String>,
    /// A pin of another link that rides in the slot, in place of link and at.
    pub pin: Option<String>,
    /// What carries the guide: a link, or "ground".
    pub on: String,
    /// A place on the guide: a point of `on`, or [x, y] on the ground or in the shape of `on`.
    /// Left out: the first point of `along`, else of `on`.
    pub through: Option<At>,
    /// The direction of the guide; left out: 0.
    /// Degrees count from +x on the ground, from the axis of `on` otherwise.
    pub along: Option<Direction>,
    /// Degrees from the guide to the slider's axis; left out: 0.
    pub turned: Option<f64>,
    /// The least and the greatest position along the guide at which the guide still holds what slides: the ends of a slot. Not in a drawn
    /// configuration.
    #[cfg_attr(feature = "schemas", schemars(length(equal = 2)))]
    pub travel: Option<Vec<f64>>,
    /// The drive that pushes the slider.
    pub drive: Option<SliderDrive>,
}

write_keys!(SliderFile { link, at, pin, on, through, along, turned, travel, drive });

pub(super) const SLIDERS: JointKind = JointKind {
    list: "sliders",
    keys: &[
        ("link", Some(Meaning::Link)),
        ("at", Some(Meaning::Point)),
        ("pin", Some(Meaning::Point)),
        ("on", Some(Meaning::Link)),
        ("through", Some(Meaning::PointOfGuide)),
        ("along", Some(Meaning::PairOfGuide)),
        ("turned", None),
        ("travel", None),
        ("drive", None),
    ],
};

/// A link, or a pin without a block, that slides along a straight guide of another link or of the frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Slider {
    /// The sliding link; `None` for a pin in a slot.
    pub link: Option<String>,
    /// The point of `link` that slides; `None` for a pin in a slot.
    pub at: Option<String>,
    /// The pin in the slot, a point of another link or of the frame; `None` for a sliding link.
    pub pin: Option<String>,
    /// The carrier of the guide.
    pub on: On,
    /// A place on the guide: a point of `on`; or coordinates, on the ground in the fixed frame, else in the own frame
    /// of `on` (its shape). `None`: the first point of `along`, else of `on`; in a drawn configuration a guide given by
    /// its direction passes through the sliding point.
    pub through: Option<At>,
    /// The direction of the guide.
    pub along: Along,
    /// How far the guide runs beside that place, to the right of its direction: zero, but for the pin of a contact with a flat profile.
    pub beside: f64,
    /// Angle from the guide to the sliding link's axis, in degrees; zero by default and in a drawn configuration.
    pub turned_deg: f64,
    /// The least and the greatest position at which the guide holds it, if it has ends.
    pub travel: Option<[f64; 2]>,
    /// The drive along the guide, if any, whether the file has it in the slider or in the sliding link; it has no
    /// `position` in a drawn configuration.
    pub drive: Option<SliderDrive>,
}

/// The carrier of a guide.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum On {
    /// The frame.
    Ground,
    /// The link of this name.
    Link(String),
}

/// The direction of a guide.
#[derive(Debug, Clone, PartialEq)]
pub enum Along {
    /// From the first to the second of two points of the guide's carrier.
    Points(String, String),
    /// An angle in degrees, from +x on the ground, else from the axis of the carrier; zero by default.
    Degrees(f64),
    /// A direction, not zero: on the ground and in a drawn configuration in the fixed frame, else in the carrier's own.
    Direction([f64; 2]),
}

impl Slider {
    /// The point from which the position along the guide counts, where no coordinates say it; `first` is the first point
    /// of the carrier.
    #[must_use]
    pub fn counted_from<'a>(&'a self, first: Option<&'a String>) -> Option<&'a String> {
        match (&self.through, &self.along) {
            (Some(At::Place(_)), _) => None,
            (Some(At::Point(point)), _) | (None, Along::Points(point, _)) => Some(point),
            (None, _) => first,
        }
    }
}

/// The carrier of a guide, with the names of the scene.
struct Carrier<'a> {
    given_by: GivenBy,
    names: &'a Names<'a>,
    on: &'a On,
}

impl Carrier<'_> {
    /// "link 2" or "the ground".
    fn name(&self) -> Message {
        match self.on {
            On::Ground => says::the_ground(),
            On::Link(link) => says::link_named(link),
        }
    }

    /// The link, unless it is the ground.
    fn link(&self) -> Option<&Link> {
        match self.on {
            On::Ground => None,
            On::Link(link) => self.names.links.get(link),
        }
    }

    fn points(&self) -> &[String] {
        self.link().map_or(self.names.ground, |link| &link.points)
    }

    fn has(&self, point: &str) -> bool {
        match self.on {
            On::Ground => self.names.on_ground(point),
            On::Link(link) => self.names.on_link(link, point),
        }
    }

    /// An error if the sliding point is a point of the carrier.
    fn check_free(&self, key: &str, point: &str) -> Result<(), Wrong> {
        if self.has(point) {
            let message = says::slides_on_own(point, self.name());
            return Err(Wrong::value(&[key], message).hint(says::other_sliding_name()));
        }
        Ok(())
    }

    fn through(&self, given: At) -> Result<At, Wrong> {
        match (&given, self.link()) {
            (At::Point(point), _) if !self.has(point) => {
                Err(Wrong::value(&["through"], no_point(self.name(), point, self.points())))
            }
            (At::Place(_), Some(link)) if !matches!(link.shape, Shape::Local(_)) => {
                let hint = match self.given_by {
                    GivenBy::Lengths => says::point_or_shape(self.name()),
                    GivenBy::Drawing => says::point_or_without(self.name()),
                };
                Err(Wrong::value(&["through"], says::no_frame(self.name())).hint(hint))
            }
            _ => Ok(given),
        }
    }

    fn along(&self, coordinates: &Coordinates, given: Option<Direction>) -> Result<Along, Wrong> {
        // Without the key the error is at the slider as a whole.
        let path: &[&str] = if given.is_some() { &["along"] } else { &[] };
        match given.unwrap_or(Direction::Degrees(0.0)) {
            Direction::Points(key) => self.along_points(coordinates, &key),
            Direction::Vector([0.0, 0.0]) => Err(Wrong::value(path, says::no_direction()).hint(says::give_direction())),
            Direction::Vector(direction) => Ok(Along::Direction(direction)),
            Direction::Degrees(_)
                if self.given_by == GivenBy::Drawing && self.link().is_some_and(|link| link.points.is_empty()) =>
            {
                Err(Wrong::value(path, says::no_axis(self.name())).hint(says::give_drawn_direction()))
            }
            Direction::Degrees(degrees) => Ok(Along::Degrees(degrees)),
        }
    }

    fn along_points(&self, coordinates: &Coordinates, key: &str) -> Result<Along, Wrong> {
        let points = checked_pair(says::along_key, key, &self.name(), self.points(), |point| self.has(point));
        let (from, to) = points.map_err(|Wrong { message, hint, .. }| {
            let number = key.trim().parse::<f64>().is_ok();
            let degrees = number.then(|| says::degrees_unquoted(key.trim()));
            Wrong::value(&["along"], message).maybe_hint(degrees.or(hint))
        })?;
        match (coordinates.get(&from), coordinates.get(&to)) {
            (Some(a), Some(b)) if a == b => Err(Wrong::value(&["along"], says::one_place(&from, &to))),
            _ => Ok(Along::Points(from, to)),
        }
    }
}

/// The sliders. `pushes` are the drives written in sliding links, which are moved to their sliders.
pub(in crate::scene) fn sliders(
    given_by: GivenBy,
    names: &Names<'_>,
    coordinates: &Coordinates,
    file: Vec<SliderFile>,
    mut pushes: IndexMap<String, SliderDrive>,
) -> Result<Vec<Slider>, Wrong> {
    let mut sliders: Vec<Slider> = Vec::with_capacity(file.len());
    let mut pushed: HashSet<String> = HashSet::new();
    for (index, given) in file.into_iter().enumerate() {
        let inside = |wrong: Wrong| wrong.inside(&["sliders", &index.to_string()]);
        let mut slider = slider(given_by, names, coordinates, given).map_err(inside)?;
        if let Some((link, push)) = slider.link.as_ref().and_then(|link| pushes.swap_remove_entry(link)) {
            if slider.drive.is_some() {
                return Err(inside(Wrong::key(&["drive"], says::two_drives(&link)).hint(says::keep_one())));
            }
            slider.drive = Some(push);
            pushed.insert(link);
        } else if let Some(link) = slider.link.as_ref().filter(|link| pushed.contains(*link)) {
            let message = says::which_slider(link);
            return Err(Wrong::key(&["links", link, "drive"], message).hint(says::drive_into_sliders()));
        }
        sliders.push(slider);
    }
    if let Some(link) = pushes.keys().next() {
        let message = says::pushed_without_slider(link);
        return Err(Wrong::key(&["links", link, "drive"], message).hint(says::add_slider()));
    }
    let carriers: HashSet<&On> = sliders.iter().map(|slider| &slider.on).collect();
    for (name, link) in names.links {
        let is_idle = link.points.is_empty() && link.motion.is_none();
        if is_idle && !carriers.contains(&On::Link(name.clone())) {
            return Err(Wrong::value(&["links", name], says::idle_link(name)).hint(says::remove_or_name()));
        }
    }
    Ok(sliders)
}

fn slider(given_by: GivenBy, names: &Names<'_>, coordinates: &Coordinates, given: SliderFile) -> Result<Slider, Wrong> {
    let on = match given.on.as_str() {
        "ground" => On::Ground,
        name => {
            names.link(&["on"], name)?;
            On::Link(given.on)
        }
    };
    let carrier = Carrier { given_by, names, on: &on };
    check_sliding(&carrier, given.link.as_deref(), given.at.as_deref(), given.pin.as_deref())?;
    let through = given.through.map(|through| carrier.through(through)).transpose()?;
    let along = carrier.along(coordinates, given.along)?;
    let placed = through.is_some() || matches!(along, Along::Points(..)) || !carrier.points().is_empty();
    if given_by == GivenBy::Lengths && !placed {
        let message = says::guide_nowhere(carrier.name());
        let hint = match on {
            On::Ground => says::add_through(),
            On::Link(link) => says::name_on_guide(link),
        };
        return Err(Wrong::value(&[], message).hint(hint));
    }
    if given_by == GivenBy::Drawing && given.turned.is_some() {
        return Err(Wrong::key(&["turned"], says::turned_is_drawn()).hint(says::remove_it_drawn()));
    }
    if given_by == GivenBy::Drawing && given.drive.is_some_and(|drive| drive.position.is_some()) {
        let hint = says::remove_drawn("position");
        return Err(Wrong::key(&["drive", "position"], says::position_is_drawn()).hint(hint));
    }
    let travel = given.travel.map(|travel| checked_travel(given_by, travel)).transpose()?;
    let SliderFile { link, at, pin, turned, drive, .. } = given;
    Ok(Slider { link, at, pin, on, through, along, beside: 0.0, turned_deg: turned.unwrap_or(0.0), travel, drive })
}

/// The ends of a guide, the lower one first.
fn checked_travel(given_by: GivenBy, travel: Vec<f64>) -> Result<[f64; 2], Wrong> {
    if given_by == GivenBy::Drawing {
        return Err(Wrong::key(&["travel"], says::travel_is_drawn()).hint(says::leave_key_out()));
    }
    match <[f64; 2]>::try_from(travel) {
        Ok([low, high]) if low < high => Ok([low, high]),
        Ok([low, high]) => {
            let message = says::travel_backwards(number(low), number(high));
            Err(Wrong::value(&["travel"], message).hint(says::lower_end_first()))
        }
        Err(travel) => Err(Wrong::value(&["travel"], says::travel_has_two_ends(travel.len()))),
    }
}

/// The pin of a contact with a flat profile, on a guide beside this at such a distance.
pub(super) fn face(
    given_by: GivenBy,
    names: &Names<'_>,
    coordinates: &Coordinates,
    given: SliderFile,
    beside: f64,
) -> Result<Slider, Wrong> {
    slider(given_by, names, coordinates, given).map(|slider| Slider { beside, ..slider })
}

/// Refuses a link, point or pin that cannot slide on the carrier.
fn check_sliding(carrier: &Carrier<'_>, link: Option<&str>, at: Option<&str>, pin: Option<&str>) -> Result<(), Wrong> {
    match (link, at, pin) {
        (None, None, None) => Err(Wrong::value(&[], says::nothing_slides()).hint(says::give_link_or_pin())),
        (Some(_), _, Some(_)) | (_, Some(_), Some(_)) => {
            Err(Wrong::key(&["pin"], says::pin_and_link()).hint(says::block_or_pin()))
        }
        (Some(link), None, None) => Err(Wrong::value(&[], says::missing("at")).hint(says::add_at(shown(link)))),
        (None, Some(at), None) => Err(Wrong::value(&[], says::missing("link")).hint(says::add_link_or_pin(shown(at)))),
        (Some(link), Some(at), None) => {
            carrier.names.link(&["link"], link)?;
            if matches!(carrier.on, On::Link(on) if on == link) {
                return Err(Wrong::value(&["on"], says::slides_on_itself(link)));
            }
            carrier.names.point_of_link(&["at"], link, at)?;
            carrier.check_free("at", at)
        }
        (None, None, Some(pin)) => {
            carrier.names.point(&["pin"], pin)?;
            carrier.check_free("pin", pin)
        }
    }
}
