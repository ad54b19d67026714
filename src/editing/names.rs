//! The names in a scene's text, whether it can be solved or not; and another name for a point or a link, everywhere: also within
//! names of quantities, of points of the plans and of parts of the construction.

use indexmap::{IndexMap, IndexSet};
use serde::{Deserialize, Serialize};
use serde_json::Value as Json;

use super::document::{Document, Word};
use super::says;
use crate::construction::image_name;
use crate::scene::{
    Argument, Bearer, Meaning, QuantityName, Scene, SceneError, close, couple_name, couple_number, meaning, pair,
    why_not,
};

/// What has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Named {
    /// A point.
    Point,
    /// A link.
    Link,
}

/// The names of points and links that a text gives.
#[derive(Clone, Debug, Default)]
pub(super) struct Names {
    /// The points of the ground.
    pub ground: Vec<String>,
    /// The points of each link.
    pub links: IndexMap<String, Vec<String>>,
    /// The names that contacts give to their equivalent links.
    pub equivalents: Vec<String>,
    /// By slider: what carries its guide.
    on: Vec<String>,
    /// By contact: the body with its flat profile.
    faces: Vec<String>,
    /// The links on which couples without names act.
    couples: IndexSet<String>,
    /// The names that loads are given.
    of_loads: IndexSet<String>,
    /// Points with coordinates in a drawn scene; `None` for a scene from lengths.
    pub drawn: Option<Vec<String>>,
}

impl Names {
    /// The names in a text.
    pub fn of(scene: &Json) -> Names {
        let links = scene["links"].as_object().into_iter().flatten().filter(|(name, _)| *name != "note");
        let sliders = scene["sliders"].as_array().into_iter().flatten();
        let contacts = || scene["contacts"].as_array().into_iter().flatten();
        let loads = || scene["forces"].as_array().into_iter().flatten();
        let text = |value: &Json| value.as_str().map(str::to_owned);
        let is_unnamed_couple = |load: &Json| load["name"].is_null() && load["force"].is_null();
        let usual = |index: usize| format!("E{}", index + 1);
        // A flat profile needs no equivalent link.
        let named = contacts().enumerate().filter(|(_, contact)| contact["along"].is_null());
        Names {
            equivalents: named
                .map(|(index, contact)| contact["name"].as_str().map_or_else(|| usual(index), str::to_owned))
                .collect(),
            faces: contacts().map(|contact| contact["links"][1].as_str().unwrap_or_default().to_owned()).collect(),
            couples: loads().filter(|load| is_unnamed_couple(load)).filter_map(|load| text(&load["on"])).collect(),
            of_loads: loads().filter_map(|load| text(&load["name"])).collect(),
            ground: keys_or_list(&scene["ground"]),
            links: links.map(|(name, link)| (name.clone(), points_of(link))).collect(),
            on: sliders.map(|slider| slider["on"].as_str().unwrap_or_default().to_owned()).collect(),
            drawn: scene.get("points").map(keys_or_list),
        }
    }

    /// All points, each once.
    pub fn points(&self) -> Vec<String> {
        self.named_points().collect::<IndexSet<_>>().into_iter().cloned().collect()
    }

    fn named_points(&self) -> impl Iterator<Item = &String> {
        self.ground.iter().chain(self.links.values().flatten()).chain(self.drawn.iter().flatten())
    }

    /// Whether there is such a point.
    pub fn has_point(&self, name: &str) -> bool {
        self.named_points().any(|point| point == name)
    }

    /// The points of a link or of `ground`.
    pub fn of_carrier(&self, carrier: &str) -> &[String] {
        match carrier {
            "ground" => &self.ground,
            link => self.links.get(link).map_or(&[], Vec::as_slice),
        }
    }

    /// What carries the guide of the slider of that index.
    pub fn carrier(&self, slider: &str) -> &str {
        self.carrier_in("sliders", slider)
    }

    /// What carries the guide, or the flat profile, of the joint of that index in a list.
    fn carrier_in(&self, list: &str, joint: &str) -> &str {
        let index: Option<usize> = joint.parse().ok();
        let all = if list == "contacts" { &self.faces } else { &self.on };
        index.and_then(|index| all.get(index)).map_or("", String::as_str)
    }
}

/// The points that a link's entry names.
fn points_of(link: &Json) -> Vec<String> {
    match link {
        Json::Array(_) => keys_or_list(link),
        _ if link["points"].is_array() => keys_or_list(&link["points"]),
        _ => keys_or_list(&link["shape"]),
    }
}

/// The texts of a list, or the keys of an object but for notes.
fn keys_or_list(value: &Json) -> Vec<String> {
    match value {
        Json::Array(names) => names.iter().filter_map(Json::as_str).map(str::to_owned).collect(),
        Json::Object(entries) => entries.keys().filter(|key| *key != "note").cloned().collect(),
        _ => Vec::new(),
    }
}

/// The key of two points in place of another one of points with these new names: with a hyphen where that one has it or
/// where the names would run together.
fn joined_like(old: &str, from: &str, to: &str, points: &[String]) -> String {
    let together = format!("{from}{to}");
    let is_clear = pair(&together, points).is_some_and(|(a, b)| a == from && b == to);
    if old.contains('-') || !is_clear { format!("{from}-{to}") } else { together }
}

/// Gives a point or a link another name, in all places where the scene means it.
///
/// # Errors
/// There is none of that name, the new name is no name, is there already or is kept for something.
pub(super) fn rename(document: &mut Document<'_>, what: Named, from: &str, to: &str) -> Result<(), SceneError> {
    let names = Names::of(&document.json());
    check(document, &names, what, from, to)?;
    if from == to {
        return Ok(());
    }
    let was_read = Scene::read(&document.text()).is_ok();
    let renamer = Renamer::new(&names, what, from, to);
    document.reword(&|word| renamer.word(word))?;
    match Scene::read(&document.text()) {
        // The name is kept for something. The place is in the new text, which nobody sees.
        Err(error) if was_read => Err(SceneError { place: None, ..error }),
        _ => Ok(()),
    }
}

fn check(document: &Document<'_>, names: &Names, what: Named, from: &str, to: &str) -> Result<(), SceneError> {
    let (there, all) = match what {
        Named::Point => (says::point_there(to), names.points()),
        Named::Link => (says::link_there(to), names.links.keys().chain(&names.equivalents).cloned().collect()),
    };
    if !all.iter().any(|name| name == from) {
        return Err(no_such(document, what, from, &all));
    }
    check_name(document, what, to)?;
    if from != to && all.iter().any(|name| name == to) {
        return Err(document.error(&[], there, Some(says::other_name())));
    }
    Ok(())
}

/// Refuses what is no name of a point or a link.
pub(super) fn check_name(document: &Document<'_>, what: Named, name: &str) -> Result<(), SceneError> {
    let bearer = match what {
        Named::Point => Bearer::Point,
        Named::Link => Bearer::Link,
    };
    match why_not(bearer, name) {
        Some((message, hint)) => Err(document.error(&[], message, hint)),
        None => Ok(()),
    }
}

/// There is no point or link of that name.
pub(super) fn no_such(document: &Document<'_>, what: Named, name: &str, all: &[String]) -> SceneError {
    let (hint, name) = (close(name, all.iter().map(String::as_str)), crate::text::shown(name));
    let message = match what {
        Named::Point => says::no_point(name),
        Named::Link => says::no_link(name),
    };
    document.error(&[], message, hint)
}

/// Where names mean one point or one link, and the new name of it.
pub(super) struct Renamer<'a> {
    names: &'a Names,
    what: Named,
    from: &'a str,
    to: &'a str,
    points: Vec<String>,
}

impl<'a> Renamer<'a> {
    /// A new name for a point or a link.
    pub fn new(names: &'a Names, what: Named, from: &'a str, to: &'a str) -> Renamer<'a> {
        Renamer { names, what, from, to, points: names.points() }
    }

    /// The new form of a word of the scene.
    fn word(&self, Word { path, is_key, word }: Word<'_>) -> Option<String> {
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        let is = |name: &str| name == self.from;
        let angle = |link: &str| format!("angle({link})");
        match (meaning(&path, is_key)?, self.what) {
            (Meaning::OfPlan, _) => self.plan_name(word),
            (Meaning::Quantity, _) => self.quantity(word),
            (Meaning::PairOfLink, Named::Point) => self.pair(path[1], word),
            (Meaning::PairOfGuide, Named::Point) => self.pair(self.names.carrier_in(path[0], path[1]), word),
            (Meaning::PointOrAngle, Named::Link) => (word == angle(self.from)).then(|| angle(self.to)),
            (Meaning::Point | Meaning::PointOfGuide | Meaning::PointOrAngle, Named::Point) => {
                is(word).then(|| self.to.to_owned())
            }
            (Meaning::Link, Named::Link) => is(word).then(|| self.to.to_owned()),
            _ => None,
        }
    }

    /// The key of two points of a carrier with the new name.
    fn pair(&self, carrier: &str, key: &str) -> Option<String> {
        let points = self.names.of_carrier(carrier);
        let (from, to) = pair(key, points)?;
        let new = |name: &String| if name == self.from { self.to.to_owned() } else { name.clone() };
        let is_named = [&from, &to].iter().any(|name| *name == self.from);
        let points: Vec<String> = points.iter().map(new).collect();
        is_named.then(|| joined_like(key, &new(&from), &new(&to), &points))
    }

    /// A name of the construction with the new name, if it means what is renamed: a point, a link, `S3`, `D_2`, `d`,
    /// `n_b3`, `3/2`.
    pub fn plan_name(&self, name: &str) -> Option<String> {
        if let Some((sliding, on)) = name.split_once('/') {
            return self.slider(sliding, on);
        }
        match self.what {
            _ if name == self.from => Some(self.to.to_owned()),
            Named::Point => self.of_point(name),
            Named::Link => self.of_link(name),
        }
    }

    /// The name of a quantity with the new name, if it means what is renamed.
    pub fn quantity(&self, name: &str) -> Option<String> {
        QuantityName::reworded(name, |argument, name| match (argument, self.what) {
            (Argument::Slider, _) => name.split_once('/').and_then(|(sliding, on)| self.slider(sliding, on)),
            (Argument::Link, Named::Link) => (name == self.from).then(|| self.to.to_owned()),
            (Argument::Load, _) => self.load(name),
            (Argument::Link, Named::Point) | (Argument::Nothing, _) => None,
            (Argument::Point, _) => self.plan_name(name),
        })
    }

    /// The name of a load, as `weight(2)`, `friction(3/2)` or `friction(B,2)`, or of a couple without a name of its own, as `M3`.
    fn load(&self, name: &str) -> Option<String> {
        let is_numbered =
            self.what == Named::Link && self.names.couples.contains(self.from) && !self.names.of_loads.contains(name);
        if let Some(number) = couple_number(name, self.from).filter(|_| is_numbered) {
            return Some(couple_name(number, self.to));
        }
        let (of, link) = name.strip_suffix(')')?.split_once('(')?;
        if let Some((sliding, on)) = link.split_once('/') {
            return Some(format!("{of}({})", self.slider(sliding, on)?));
        }
        let new = |name: &str| if name.trim() == self.from { self.to.to_owned() } else { name.to_owned() };
        if let Some((pin, link)) = link.split_once(',') {
            let both = if self.what == Named::Link { [pin.to_owned(), new(link)] } else { [new(pin), link.to_owned()] };
            return (both != [pin, link]).then(|| format!("{of}({})", both.join(",")));
        }
        if self.what == Named::Point {
            return None;
        }
        (link.trim() == self.from).then(|| format!("{of}({})", self.to))
    }

    /// The name of a slider, as `3/2`, `P/3` or `P/3#2`.
    fn slider(&self, sliding: &str, on: &str) -> Option<String> {
        let (on, number) = on.split_at(on.find('#').unwrap_or(on.len()));
        let new = |name: &str| if name.trim() == self.from { self.to.to_owned() } else { name.to_owned() };
        let is_link = self.names.links.contains_key(sliding.trim());
        let (first, second) = match self.what {
            Named::Link => (new(sliding), new(on)),
            Named::Point if is_link => return None,
            Named::Point => (new(sliding), on.to_owned()),
        };
        (first != sliding || second != on).then(|| format!("{first}/{second}{number}"))
    }

    fn of_point(&self, name: &str) -> Option<String> {
        let (from, to) = (self.from, self.to);
        if name == image_name(from) {
            return Some(image_name(to));
        }
        let under = self.names.links.keys().map(|link| [from, to].map(|point| format!("{point}_{link}")));
        renamed(name, under).or_else(|| {
            let (mark, image, tail) = self.part(name)?;
            (image == from).then(|| format!("{mark}{}{tail}", image_name(to)))
        })
    }

    fn of_link(&self, name: &str) -> Option<String> {
        let (from, to) = (self.from, self.to);
        for special in ["S", "s"] {
            if name.strip_prefix(special) == Some(from) {
                return Some(format!("{special}{to}"));
            }
        }
        let under = self.points.iter().map(|point| [from, to].map(|link| format!("{point}_{link}")));
        renamed(name, under).or_else(|| {
            let (mark, image, tail) = self.part(name)?;
            (tail == from).then(|| format!("{mark}{}{to}", image_name(image)))
        })
    }

    /// A part of a plan, as `n_b3`: its mark, the point from whose image it is laid off, and its link.
    fn part<'n>(&self, name: &'n str) -> Option<(&'n str, &str, &'n str)> {
        let (mark, rest) =
            ["n_", "r_", "k_"].iter().find_map(|mark| name.strip_prefix(mark).map(|rest| (&name[..2], rest)))?;
        let of = |point: &'_ String| rest.strip_prefix(&image_name(point)).filter(|tail| !tail.is_empty());
        let found = self.points.iter().filter_map(|point| Some((point, of(point)?)));
        let (point, tail) = found.min_by_key(|(_, tail)| tail.len())?;
        Some((mark, point, tail))
    }
}

/// The new name of what has one of these old ones, or of its image.
fn renamed(name: &str, mut all: impl Iterator<Item = [String; 2]>) -> Option<String> {
    all.find_map(|[old, new]| match name == old {
        true => Some(new),
        false => (name == image_name(&old)).then(|| image_name(&new)),
    })
}
