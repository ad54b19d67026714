//! What a scene's links weigh and what acts on them: masses, gravity, forces, couples, springs and friction, from which forces in joints and
//! drives follow. A scene without any of these keys has none, and nothing is computed of them.

use super::error::Wrong;
use super::friction::{Friction, FrictionFile, at_least_zero};
use super::given::GivenBy;
use super::joint::On;
use super::load_names::LoadNames;
use super::names::Names;
use super::over::{Over, OverFile};
use super::says;
use super::units::Units;
use super::value::{Direction, OneOf, Vector, choice, several_forms};
use super::write::{Write, Written, write_forms, write_keys};
use crate::text::shown;
use indexmap::{IndexMap, IndexSet};
use serde::Deserialize;

choice! {
    /// Whether inertia counts among the loads.
    #[derive(Default)]
    #[cfg_attr(feature = "schemas", schemars(rename = "analysis"))]
    Analysis {
        /// Inertia forces and couples count, by d'Alembert's principle.
        #[default]
        Dynamic = "dynamic",
        /// They are left out: forces as if all stood still.
        Static = "static",
    }
}

/// A place of a link: one of its points, coordinates in its own frame (in a drawn configuration in the fixed frame), or a
/// distance along its axis from its first point.
#[derive(Debug, Clone, PartialEq)]
pub enum LinkPlace {
    /// At this point of the link.
    Point(String),
    /// At these coordinates.
    Place([f64; 2]),
    /// At this distance along the link's axis; not in a drawn configuration.
    Distance(f64),
}

several_forms!(LinkPlace, "linkPlace", OneOf {
    expecting: "the name of a point in double quotes, its coordinates [x, y], or a distance along the link's axis",
    from: |given| Some(match given {
        Direction::Points(name) => LinkPlace::Point(name),
        Direction::Vector(place) => LinkPlace::Place(place),
        Direction::Degrees(distance) => LinkPlace::Distance(distance),
    }),
}, generator => {
    "description": "A point of the link; coordinates in its own frame, in a drawn configuration in the fixed frame; or a distance along its axis",
    "anyOf": [{ "type": "string" }, generator.subschema_for::<Vector>(), { "type": "number" }]
});

write_forms! {
    LinkPlace { LinkPlace::Point(name) => name, LinkPlace::Place(place) => place, LinkPlace::Distance(distance) => distance }
}

/// What a link's keys say of its mass.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct MassFields {
    pub mass: Option<f64>,
    pub weight: Option<f64>,
    pub inertia: Option<f64>,
    pub center: Option<LinkPlace>,
}

/// The mass of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Mass {
    /// How much there is of it.
    pub amount: Amount,
    /// Moment of inertia about the centre of mass, in mass · length²; zero for a mass in one point.
    pub inertia: f64,
    /// The centre of mass.
    pub center: LinkPlace,
}

/// How much mass a link has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// In the scene's unit of mass.
    Mass(f64),
    /// By its weight, in the scene's unit of force.
    Weight(f64),
}

/// A force or a couple on a link, in the file.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "load"))]
#[serde(deny_unknown_fields, expecting = r#"a load as { "on": "3", "at": "C", "force": [-150, 0] }"#)]
pub(super) struct LoadFile {
    /// Its name in tables and figures; left out: F1, F2 … for forces; M1 for a couple on link 1, M2 for one on link 2 ….
    name: Option<String>,
    /// The link on which it acts.
    on: String,
    /// Where the force acts.
    at: Option<LinkPlace>,
    /// The force, in the scene's unit of force.
    force: Option<Vector>,
    /// The couple, in force · length, counter-clockwise positive.
    couple: Option<f64>,
    /// Whether the force turns with the link: then its components are along the link's axis and normal to it.
    turns: Option<bool>,
    /// How often the force and the couple act over the motion; left out: once everywhere.
    over: Option<OverFile>,
}

write_keys!(LoadFile { name, on, at, force, couple, turns, over });

/// A force and a couple on a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Its name.
    pub name: String,
    /// The link on which it acts.
    pub on: String,
    /// Where the force acts, or a couple is drawn.
    pub at: Option<LinkPlace>,
    /// The force, in the fixed frame; in that of the link where it turns with it.
    pub force: [f64; 2],
    /// The couple, counter-clockwise positive.
    pub couple: f64,
    /// Whether the force turns with the link.
    pub turns: bool,
    /// How often both act over the motion; once everywhere where there is none.
    pub over: Option<Over>,
}

/// A spring between two places, in the file.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(
    deny_unknown_fields,
    expecting = r#"a spring as { "between": [["3", "C"], ["ground", "A"]], "rate": 1.5, "length": 120 }"#
)]
#[cfg_attr(feature = "schemas", schemars(rename = "spring"))]
pub(super) struct SpringFile {
    /// Its name in tables and figures; left out: K1, K2 …
    name: Option<String>,
    /// Its two ends, each a link or "ground" and a place of it.
    between: Vec<EndFile>,
    /// Force per length of extension.
    rate: f64,
    /// Its length without a force.
    length: f64,
}

write_keys!(SpringFile { name, between, rate, length });

/// An end of a spring in the file: a link or "ground", and a place of it.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "springEnd"))]
#[serde(expecting = r#"an end of a spring as ["3", "C"], a link and a place on it"#)]
pub(super) struct EndFile(String, LinkPlace);

impl Write for EndFile {
    fn written(&self) -> Written {
        Written::List(vec![self.0.written(), self.1.written()])
    }
}

/// A spring: it pulls its ends together with `rate` times what it is longer than `length`.
#[derive(Debug, Clone, PartialEq)]
pub struct Spring {
    /// Its name.
    pub name: String,
    /// Its ends.
    pub ends: [SpringEnd; 2],
    /// Force per length of extension.
    pub rate: f64,
    /// Its length without a force.
    pub length: f64,
}

/// An end of a spring.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringEnd {
    /// The body to which it is fixed.
    pub on: On,
    /// The place where it is.
    pub at: LinkPlace,
}

/// All that loads the links of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Loads {
    /// Whether inertia counts.
    pub analysis: Analysis,
    /// The acceleration of free fall, in length per time²; zero where none is given.
    pub gravity: [f64; 2],
    /// The masses, by the links' names.
    pub masses: IndexMap<String, Mass>,
    /// Forces and couples, in file order.
    pub loads: Vec<Load>,
    /// Springs, in file order.
    pub springs: Vec<Spring>,
    /// Friction in joints, in file order.
    pub friction: Vec<Friction>,
}

/// What the file says of loads: its keys at the top, and those in the links.
#[derive(Debug, Default)]
pub(super) struct LoadFields {
    pub analysis: Option<Analysis>,
    pub gravity: Option<Vector>,
    pub masses: IndexMap<String, MassFields>,
    pub forces: Option<Vec<LoadFile>>,
    pub springs: Option<Vec<SpringFile>>,
    pub friction: Option<Vec<FrictionFile>>,
}

impl MassFields {
    /// Whether no key is given.
    pub fn is_empty(&self) -> bool {
        *self == MassFields::default()
    }

    /// The checked mass of a link; `gravity` is the acceleration of free fall.
    fn read(self, link: &str, units: Units, gravity: [f64; 2]) -> Result<Mass, Wrong> {
        let amount = match (self.mass, self.weight) {
            (Some(_), Some(_)) => {
                return Err(Wrong::key(&["weight"], says::mass_and_weight(link)).hint(says::keep_one()));
            }
            (Some(mass), None) => Amount::Mass(at_least_zero("mass", mass)?),
            (None, Some(weight)) => Amount::Weight(at_least_zero("weight", weight)?),
            (None, None) => {
                let key = if self.inertia.is_some() { "inertia" } else { "center" };
                return Err(Wrong::key(&[key], says::without_mass(link, key)).hint(says::add(r#""mass": 1.5"#)));
            }
        };
        match amount {
            Amount::Mass(_) if units.mass.is_none() => {
                return Err(Wrong::key(&["mass"], says::no_unit_of_mass(link)).hint(says::add_unit_of_mass()));
            }
            Amount::Weight(_) if gravity == [0.0; 2] => {
                return Err(Wrong::key(&["weight"], says::weight_without_gravity(link)).hint(says::add_gravity()));
            }
            _ => {}
        }
        if self.inertia.is_some() && units.mass.is_none() {
            return Err(Wrong::key(&["inertia"], says::no_unit_of_mass(link)).hint(says::add_unit_of_mass()));
        }
        let inertia = at_least_zero("inertia", self.inertia.unwrap_or(0.0))?;
        let Some(center) = self.center else {
            return Err(Wrong::value(&[], says::no_center_of_mass(link)).hint(says::add_center()));
        };
        Ok(Mass { amount, inertia, center })
    }
}

/// The checked loads; none where no link has a mass and there is no force and no spring.
pub(super) fn loads(
    given_by: GivenBy,
    names: &Names<'_>,
    units: Units,
    fields: LoadFields,
) -> Result<Option<Box<Loads>>, Wrong> {
    let LoadFields { analysis, gravity, masses, forces, springs, friction } = fields;
    let mut joints = IndexSet::new();
    let rubbing = friction.unwrap_or_default().into_iter().enumerate().map(|(index, file)| {
        let read = file.read(names, &mut joints);
        read.map_err(|wrong| wrong.inside(&["friction", &index.to_string()]))
    });
    let rubbing: Vec<Friction> = rubbing.collect::<Result<_, _>>()?;
    // Gravity alone loads nothing, and where nothing presses, nothing rubs.
    if masses.is_empty() && forces.is_none() && springs.is_none() {
        return Ok(None);
    }
    let places = Places { given_by, names };
    let gravity = gravity.map_or([0.0; 2], |Vector(gravity)| gravity);
    let mut read = IndexMap::new();
    for (link, fields) in masses {
        let mass = fields.read(&link, units, gravity);
        let mass = mass.and_then(|mass| {
            places.check(&link, &mass.center).map_err(|wrong| wrong.inside(&["center"]))?;
            Ok(mass)
        });
        read.insert(link.clone(), mass.map_err(|wrong| wrong.inside(&["links", &link]))?);
    }
    if units.force.is_none() {
        let keys = [("forces", forces.is_some()), ("springs", springs.is_some())];
        let message = says::no_unit_of_force();
        let wrong = match keys.into_iter().find(|(_, given)| *given) {
            Some((key, _)) => Wrong::key(&[key], message),
            None => Wrong::value(&["units"], message),
        };
        return Err(wrong.hint(says::add_unit_of_force()));
    }
    let (forces, springs) = (forces.unwrap_or_default(), springs.unwrap_or_default());
    let given = forces.iter().map(|file| &file.name).chain(springs.iter().map(|file| &file.name));
    let mut usual = LoadNames::new(given.flatten().cloned());
    let mut taken = IndexSet::new();
    let mut loads = Vec::new();
    for (index, file) in forces.into_iter().enumerate() {
        let load = places.load(file, &mut taken, &mut usual);
        loads.push(load.map_err(|wrong| wrong.inside(&["forces", &index.to_string()]))?);
    }
    let mut sprung = Vec::new();
    for (index, file) in springs.into_iter().enumerate() {
        let spring = places.spring(file, &mut taken, index);
        sprung.push(spring.map_err(|wrong| wrong.inside(&["springs", &index.to_string()]))?);
    }
    let analysis = analysis.unwrap_or_default();
    Ok(Some(Box::new(Loads { analysis, gravity, masses: read, loads, springs: sprung, friction: rubbing })))
}

/// Reads what refers to places of links.
struct Places<'a> {
    given_by: GivenBy,
    names: &'a Names<'a>,
}

impl Places<'_> {
    /// Whether a link has the place.
    fn check(&self, link: &str, at: &LinkPlace) -> Result<(), Wrong> {
        match at {
            LinkPlace::Point(point) => self.names.point_of_link(&[], link, point),
            LinkPlace::Distance(_) if self.given_by == GivenBy::Drawing => {
                Err(Wrong::value(&[], says::distance_is_drawn(link)).hint(says::place_as_drawn()))
            }
            _ => Ok(()),
        }
    }

    fn load(&self, file: LoadFile, taken: &mut IndexSet<String>, usual: &mut LoadNames) -> Result<Load, Wrong> {
        let LoadFile { name, on, at, force, couple, turns, over } = file;
        self.names.link(&["on"], &on)?;
        if force.is_none() && couple.is_none() {
            return Err(Wrong::value(&[], says::neither_force_nor_couple()).hint(says::add(r#""force": [0, -80]"#)));
        }
        if force.is_some() && at.is_none() {
            return Err(Wrong::value(&[], says::force_nowhere()).hint(says::add_at_of_force()));
        }
        if let Some(at) = &at {
            self.check(&on, at).map_err(|wrong| wrong.inside(&["at"]))?;
        }
        if turns == Some(true) && (force.is_none() || self.given_by == GivenBy::Drawing) {
            let message = if force.is_none() { says::couple_turns() } else { says::turns_is_drawn() };
            return Err(Wrong::key(&["turns"], message).hint(says::leave_key_out()));
        }
        let over = over.map(|over| over.read(self.names).map_err(|wrong| wrong.inside(&["over"]))).transpose()?;
        let counted = force.as_ref().map(|_| usual.force());
        let name = name.or(counted).unwrap_or_else(|| usual.couple(&on));
        let name = own_name(name, taken)?;
        let force = force.map_or([0.0; 2], |Vector(force)| force);
        Ok(Load { name, on, at, force, couple: couple.unwrap_or(0.0), turns: turns.unwrap_or(false), over })
    }

    fn spring(&self, file: SpringFile, taken: &mut IndexSet<String>, index: usize) -> Result<Spring, Wrong> {
        let SpringFile { name, between, rate, length } = file;
        at_least_zero("rate", rate)?;
        at_least_zero("length", length)?;
        let count = between.len();
        let Ok([first, second]) = <[EndFile; 2]>::try_from(between) else {
            return Err(Wrong::value(&["between"], says::spring_ends(count)).hint(says::spring_between_links()));
        };
        let end = |index, end| self.end(end).map_err(|wrong| wrong.inside(&["between", index]));
        let ends = [end("0", first)?, end("1", second)?];
        if ends[0].on == ends[1].on {
            return Err(Wrong::value(&["between"], says::spring_within_link()).hint(says::spring_between_links()));
        }
        let name = name.unwrap_or_else(|| format!("K{}", index + 1));
        Ok(Spring { name: own_name(name, taken)?, ends, rate, length })
    }

    fn end(&self, EndFile(on, at): EndFile) -> Result<SpringEnd, Wrong> {
        if on == "ground" {
            return match &at {
                LinkPlace::Point(point) if !self.names.on_ground(point) => {
                    Err(Wrong::value(&["1"], says::no_point_of_ground(shown(point))))
                }
                LinkPlace::Distance(_) => Err(Wrong::value(&["1"], says::distance_on_ground())),
                _ => Ok(SpringEnd { on: On::Ground, at }),
            };
        }
        self.names.link(&["0"], &on)?;
        self.check(&on, &at).map_err(|wrong| wrong.inside(&["1"]))?;
        Ok(SpringEnd { on: On::Link(on), at })
    }
}

/// The name of a load, if it may be one; each stands once.
fn own_name(name: String, taken: &mut IndexSet<String>) -> Result<String, Wrong> {
    if name.trim().is_empty() || name.contains(['(', ')', ',']) {
        return Err(Wrong::value(&["name"], says::load_name(shown(&name))).hint(says::other_load_name()));
    }
    if !taken.insert(name.clone()) {
        return Err(Wrong::value(&["name"], says::load_name_twice(shown(&name))).hint(says::other_load_name()));
    }
    Ok(name)
}
