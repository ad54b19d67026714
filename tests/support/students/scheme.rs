//! What a sheet gives to a student: places, lengths, drives, guides, scales, and the names that the form asks for.

use super::plane::{DEGREE, Place, direction, unit};
use kinegon::Sheet;
use kinegon::check::form_names;
use kinegon::{Scene, Solution};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// The motion of a point or a link that is given, not found.
#[derive(Clone, Debug, Default)]
pub struct Given {
    pub velocity: Place,
    pub acceleration: Place,
}

/// A guide: a slider's name, as `2/1`, and the direction in which its position grows.
#[derive(Clone, Debug)]
pub struct Guide {
    pub name: String,
    pub direction: f64,
    /// Speed and acceleration of a driven slider.
    pub drive: Option<[f64; 2]>,
}

/// A scene as it lies before the student.
#[derive(Clone, Debug)]
pub struct Scheme {
    pub places: BTreeMap<String, Place>,
    pub ground: BTreeSet<String>,
    /// Lengths that are given, by their ends.
    pub lengths: BTreeMap<[String; 2], f64>,
    pub guides: Vec<Guide>,
    /// ω and α that are given, by `omega(1)` and `alpha(1)`.
    pub rates: BTreeMap<String, f64>,
    /// Points whose motion is given.
    pub known: BTreeMap<String, Given>,
    /// Units per mm of the scheme, the velocity plan and the acceleration plan.
    pub scales: [f64; 3],
    pub form: Vec<String>,
}

impl Scheme {
    /// Reads a scene; the places and the form's names are all that is taken from its solution.
    pub fn new(text: &str) -> Option<(Scheme, Solution)> {
        let json: Value = serde_json::from_str(text).ok()?;
        let solution = kinegon::solve(&Scene::read(text).ok()?).ok()?;
        let names = solution.mechanism.points.iter();
        let places = names.filter_map(|name| {
            let place = solution.pose.point(solution.mechanism.point(name)?);
            Some((name.clone(), Place::new(place.x, place.y)))
        });
        let scales = solution.scales();
        let mut scheme = Scheme {
            places: places.collect(),
            ground: named(&json["ground"]).map(|(name, _)| name.to_owned()).collect(),
            lengths: BTreeMap::new(),
            guides: Vec::new(),
            rates: BTreeMap::new(),
            known: BTreeMap::new(),
            scales: [scales[Sheet::Scheme]?, scales[Sheet::Velocity]?, scales[Sheet::Acceleration]?],
            form: form_names(&solution.construction),
        };
        scheme.read_links(&json);
        scheme.read_guides(&json);
        scheme.read_known(&json);
        Some((scheme, solution))
    }

    fn read_links(&mut self, json: &Value) {
        for (link, of) in named(&json["links"]) {
            for (ends, length) in named(&of["lengths"]) {
                let (Some(ends), Some(length)) = (self.ends(ends), length.as_f64()) else {
                    continue;
                };
                self.lengths.insert(ends, length);
            }
            let (drive, motion) = (&of["drive"], &of["motion"]);
            for given in [drive, motion].into_iter().filter(|given| given.is_object()) {
                let omega = given["omega"].as_f64().or(given["rpm"].as_f64().map(|rpm| rpm * 6.0 * DEGREE));
                self.rates.insert(format!("omega({link})"), omega.unwrap_or(0.0));
                self.rates.insert(format!("alpha({link})"), given["alpha"].as_f64().unwrap_or(0.0));
            }
            if let Some(at) = motion["at"].as_str() {
                self.known.insert(at.to_owned(), given_motion(motion));
            }
        }
    }

    fn read_guides(&mut self, json: &Value) {
        for slider in json["sliders"].as_array().into_iter().flatten() {
            let text = |key: &str| slider[key].as_str().unwrap_or_default().to_owned();
            let name = format!("{}/{}", text("link"), text("on"));
            let direction = match &slider["along"] {
                Value::String(ends) => self.ends(ends).map_or(0.0, |[a, b]| direction(self.at(&b) - self.at(&a))),
                Value::Array(_) => direction(vector(&slider["along"])),
                degrees => degrees.as_f64().unwrap_or(0.0) * DEGREE,
            };
            let drive = &slider["drive"];
            let number = |key: &str| drive[key].as_f64().unwrap_or(0.0);
            let drive = drive.is_object().then(|| [number("speed"), number("acceleration")]);
            self.guides.push(Guide { name, direction, drive });
        }
    }

    fn read_known(&mut self, json: &Value) {
        for (point, motion) in named(&json["known"]) {
            self.known.insert(point.to_owned(), given_motion(motion));
        }
    }

    /// The two points of a name like `AB` or `A1-B1`.
    fn ends(&self, name: &str) -> Option<[String; 2]> {
        (1..name.len()).filter(|&k| name.is_char_boundary(k)).find_map(|k| {
            let (a, b) = name.split_at(k);
            let b = b.trim_start_matches('-');
            (self.places.contains_key(a) && self.places.contains_key(b)).then(|| [a.to_owned(), b.to_owned()])
        })
    }

    /// Where a point lies; `B_3` is the point of link 3 at B.
    pub fn at(&self, point: &str) -> Place {
        let own = self.places.get(point).or_else(|| self.places.get(point.split('_').next().unwrap_or_default()));
        *own.unwrap_or_else(|| panic!("there is no point {point}"))
    }

    /// The direction from a point to another.
    pub fn along(&self, from: &str, to: &str) -> f64 {
        direction(self.at(to) - self.at(from))
    }

    /// A length that is given.
    pub fn given_length(&self, a: &str, b: &str) -> Option<f64> {
        let [a, b] = [a, b].map(str::to_owned);
        self.lengths.get(&[a.clone(), b.clone()]).or_else(|| self.lengths.get(&[b, a])).copied()
    }

    pub fn guide(&self, name: &str) -> &Guide {
        self.guides.iter().find(|guide| guide.name == name).unwrap_or_else(|| panic!("there is no slider {name}"))
    }
}

/// The entries of an object, without its notes.
fn named(json: &Value) -> impl Iterator<Item = (&str, &Value)> {
    let entries = json.as_object().into_iter().flatten();
    entries.map(|(name, value)| (name.as_str(), value)).filter(|(name, _)| *name != "note")
}

/// A vector by components, or by size and angle in degrees.
fn vector(json: &Value) -> Place {
    let number = |value: &Value| value.as_f64().unwrap_or(0.0);
    match json {
        Value::Array(both) if both.len() == 2 => Place::new(number(&both[0]), number(&both[1])),
        polar => unit(number(&polar["angle"]) * DEGREE) * number(&polar["size"]),
    }
}

fn given_motion(json: &Value) -> Given {
    Given { velocity: vector(&json["velocity"]), acceleration: vector(&json["acceleration"]) }
}
