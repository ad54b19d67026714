//! The sheets on which a mechanism is drawn: what each of them is, said here and nowhere else.
//!
//! A further sheet is a variant of [`Sheet`] and an entry of `FACTS`; neither compiles without the other. What is kept
//! for every sheet stands in a [`PerSheet`], so it has a place for the new one at once, and files, forms and options
//! have its scale. Only code with something of its own to say of a sheet matches on [`Sheet`], and the compiler names it.
//! What holds for the plans alone asks for an [`Order`], so a further sheet does not concern it.

use indexmap::IndexMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::ops::{Index, IndexMut};

/// A sheet of the construction, and the panel of the figure that shows it; each has its own scale.
///
/// Sheets are ordered as they are drawn. A plan needs the scheme, and that of accelerations the one of velocities; the centres need
/// none of them; forces need the motion for inertia alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schemas",
    derive(schemars::JsonSchema),
    schemars(rename = "Panel", description = "A part of the figure.")
)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Sheet {
    /// The mechanism itself.
    Scheme,
    /// The velocity plan.
    Velocity,
    /// The acceleration plan.
    Acceleration,
    /// The mechanism once more, with the lines that lead to its instant centres: at a scale of its own, as centres may be far.
    Centers,
    /// The force plan: polygons of the forces on links and groups.
    Forces,
    /// Zhukovsky's lever: the velocity plan turned by 90° clockwise, with forces at the images of their points.
    Lever,
    /// Kutzbach's speed diagram of a train: velocities along its line of centres, and from them angular velocities on one line.
    Speeds,
}

/// The order of a derivative of the position by time. Each has a plan, which is drawn from a pole, and needs those before
/// it: motion that is computed up to [`Order::Velocity`] has no accelerations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Order {
    /// The first.
    Velocity,
    /// The second.
    Acceleration,
}

/// What kind of value a quantity has; quantities of one kind may share an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum QuantityKind {
    /// An angle, in degrees.
    Angle,
    /// An angular velocity, in rad per unit of time.
    AngularVelocity,
    /// An angular acceleration.
    AngularAcceleration,
    /// An angular velocity in revolutions a minute.
    RotationalSpeed,
    /// The ratio of two angular velocities, without a unit.
    SpeedRatio,
    /// A coordinate, or a position along a guide.
    Position,
    /// A distance.
    Length,
    /// A velocity, or a segment of the velocity plan.
    Velocity,
    /// An acceleration, or a segment of the acceleration plan.
    Acceleration,
    /// A force.
    Force,
    /// A torque or a couple.
    Moment,
    /// The power of a load.
    Power,
}

/// What there is to say of a sheet.
#[derive(Debug)]
#[non_exhaustive]
pub struct SheetFacts {
    /// Which sheet it is.
    sheet: Sheet,
    /// The word for it in files and on the page, as `velocity`.
    word: &'static str,
    /// Its English name, as `velocity plan`.
    name: &'static str,
    /// The letter for it in the code of a printed sheet.
    pub letter: char,
    /// What is drawn on it to scale.
    pub drawn: QuantityKind,
    /// The key of its scale in scenes and forms, as `mu_v`.
    pub scale_key: &'static str,
    /// Its scale in sentences, as `μ_v`.
    pub scale_symbol: &'static str,
    /// What a millimetre of its paper stands for, in descriptions, as `units of velocity`.
    pub scaled_units: &'static str,
    /// How names of distances on it begin: `vplan` for segments of the velocity plan, `L` for lengths of the mechanism.
    pub segment: &'static str,
    /// Of what it is a plan: of velocities or of accelerations; none of the scheme.
    order: Option<Order>,
}

/// The sheets in the order of their variants, which is that in which they are drawn.
const FACTS: [SheetFacts; 7] = [
    SheetFacts {
        sheet: Sheet::Scheme,
        word: "scheme",
        name: "scheme",
        letter: 'L',
        drawn: QuantityKind::Length,
        scale_key: "mu_l",
        scale_symbol: "μ_l",
        scaled_units: "units of length",
        segment: "L",
        order: None,
    },
    SheetFacts {
        sheet: Sheet::Velocity,
        word: "velocity",
        name: "velocity plan",
        letter: 'V',
        drawn: QuantityKind::Velocity,
        scale_key: "mu_v",
        scale_symbol: "μ_v",
        scaled_units: "units of velocity",
        segment: "vplan",
        order: Some(Order::Velocity),
    },
    SheetFacts {
        sheet: Sheet::Acceleration,
        word: "acceleration",
        name: "acceleration plan",
        letter: 'A',
        drawn: QuantityKind::Acceleration,
        scale_key: "mu_a",
        scale_symbol: "μ_a",
        scaled_units: "units of acceleration",
        segment: "aplan",
        order: Some(Order::Acceleration),
    },
    SheetFacts {
        sheet: Sheet::Centers,
        word: "centers",
        name: "figure of instant centres",
        letter: 'C',
        drawn: QuantityKind::Length,
        scale_key: "mu_c",
        scale_symbol: "μ_c",
        scaled_units: "units of length",
        segment: "L",
        order: None,
    },
    SheetFacts {
        sheet: Sheet::Forces,
        word: "forces",
        name: "force plan",
        letter: 'F',
        drawn: QuantityKind::Force,
        scale_key: "mu_f",
        scale_symbol: "μ_F",
        scaled_units: "units of force",
        segment: "fplan",
        order: None,
    },
    SheetFacts {
        sheet: Sheet::Lever,
        word: "lever",
        name: "lever",
        letter: 'H',
        drawn: QuantityKind::Velocity,
        scale_key: "mu_h",
        scale_symbol: "μ_h",
        scaled_units: "units of velocity",
        segment: "hplan",
        order: None,
    },
    SheetFacts {
        sheet: Sheet::Speeds,
        word: "speeds",
        name: "speed diagram",
        letter: 'K',
        drawn: QuantityKind::Length,
        scale_key: "mu_k",
        scale_symbol: "μ_k",
        scaled_units: "units of length",
        segment: "L",
        order: None,
    },
];

impl Sheet {
    /// All sheets, in the order in which they are drawn.
    pub const ALL: [Sheet; FACTS.len()] = {
        let (mut all, mut at) = ([Sheet::Scheme; FACTS.len()], 0);
        while at < all.len() {
            all[at] = FACTS[at].sheet;
            assert!(all[at] as usize == at, "the facts stand in the order of the variants");
            at += 1;
        }
        all
    };

    /// The sheets that a figure has unless its scene says otherwise: the mechanism and its plans.
    pub const USUAL: [Sheet; 3] = [Sheet::Scheme, Sheet::Velocity, Sheet::Acceleration];

    /// What there is to say of it.
    #[must_use]
    pub fn facts(self) -> &'static SheetFacts {
        // The compiler asks for a further sheet here, and refuses an index that `FACTS` does not have.
        match self {
            Sheet::Scheme => &FACTS[0],
            Sheet::Velocity => &FACTS[1],
            Sheet::Acceleration => &FACTS[2],
            Sheet::Centers => &FACTS[3],
            Sheet::Forces => &FACTS[4],
            Sheet::Lever => &FACTS[5],
            Sheet::Speeds => &FACTS[6],
        }
    }

    /// The word for it in files, as `velocity`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        self.facts().word
    }

    /// The sheet of this word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Sheet> {
        Sheet::ALL.into_iter().find(|sheet| sheet.as_str() == word)
    }

    /// Its English name, as `velocity plan`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.facts().name
    }

    /// Whether it is a plan, and of what: of velocities or of accelerations.
    #[must_use]
    pub fn order(self) -> Option<Order> {
        self.facts().order
    }

    /// Whether places of its points are read from paper, by forms and photographs: all from one point that the sheet has from the start.
    #[must_use]
    pub fn has_places(self) -> bool {
        match self {
            Sheet::Velocity | Sheet::Acceleration | Sheet::Centers => true,
            Sheet::Scheme | Sheet::Forces | Sheet::Lever | Sheet::Speeds => false,
        }
    }

    /// The sheets that are drawn before it can be, and itself.
    #[must_use]
    pub fn with_those_needed(self) -> &'static [Sheet] {
        match self {
            Sheet::Scheme => &[Sheet::Scheme],
            Sheet::Velocity => &[Sheet::Scheme, Sheet::Velocity],
            Sheet::Acceleration => &[Sheet::Scheme, Sheet::Velocity, Sheet::Acceleration],
            Sheet::Centers => &[Sheet::Centers],
            Sheet::Forces => &[Sheet::Scheme, Sheet::Forces],
            Sheet::Lever => &[Sheet::Lever],
            Sheet::Speeds => &[Sheet::Speeds],
        }
    }

    /// The name of the distance of two of its points, as `vplan(b,s3)`.
    #[must_use]
    pub fn segment_name(self, from: &str, to: &str) -> String {
        format!("{}({from},{to})", self.facts().segment)
    }
}

impl Order {
    /// Both, in the order in which their plans are drawn.
    pub const ALL: [Order; 2] = [Order::Velocity, Order::Acceleration];

    /// Its plan.
    #[must_use]
    pub const fn sheet(self) -> Sheet {
        match self {
            Order::Velocity => Sheet::Velocity,
            Order::Acceleration => Sheet::Acceleration,
        }
    }

    /// All up to this one.
    #[must_use]
    pub fn and_lower(self) -> &'static [Order] {
        &Order::ALL[..=self as usize]
    }

    /// The name of the pole of its plan in results, in every notation.
    #[must_use]
    pub fn pole(self) -> &'static str {
        ["p", "π"][self]
    }

    /// The letter of its vectors.
    #[must_use]
    pub fn vector(self) -> &'static str {
        ["v", "a"][self]
    }

    /// The letter of the rates of links that are computed from its plan.
    #[must_use]
    pub fn rate(self) -> &'static str {
        ["ω", "α"][self]
    }
}

impl From<Order> for Sheet {
    fn from(order: Order) -> Sheet {
        order.sheet()
    }
}

/// A velocity and an acceleration, by which of them is meant.
impl<T> Index<Order> for [T; 2] {
    type Output = T;

    fn index(&self, order: Order) -> &T {
        &self[order as usize]
    }
}

impl<T> IndexMut<Order> for [T; 2] {
    fn index_mut(&mut self, order: Order) -> &mut T {
        &mut self[order as usize]
    }
}

/// One value for each sheet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PerSheet<T>([T; Sheet::ALL.len()]);

impl<T> PerSheet<T> {
    /// The values that a function gives for the sheets.
    pub fn from_fn(of: impl FnMut(Sheet) -> T) -> PerSheet<T> {
        PerSheet(Sheet::ALL.map(of))
    }

    /// The sheets with their values, in the order in which sheets are drawn.
    pub fn iter(&self) -> impl Iterator<Item = (Sheet, &T)> + Clone {
        Sheet::ALL.into_iter().zip(&self.0)
    }

    /// The sheets with their values, which may be changed.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = (Sheet, &mut T)> {
        Sheet::ALL.into_iter().zip(&mut self.0)
    }

    /// What a function makes of each value.
    pub fn map<U>(self, of: impl FnMut(T) -> U) -> PerSheet<U> {
        PerSheet(self.0.map(of))
    }
}

/// Scales in units of the scene per millimetre of paper; `None` for a sheet that is not there, or that is to fit.
///
/// In files the scale of each sheet has a key of its own, [`SheetFacts::scale_key`].
pub type Scales = PerSheet<Option<f64>>;

impl Scales {
    /// The name of a field for the scales, whose keys stand among the others of the object that is read: the reader of
    /// strict files puts them together.
    pub(crate) const FIELD: &str = "mu_*";

    /// Whether a key of a file is that of a scale.
    pub(crate) fn is_key(key: &str) -> bool {
        Sheet::ALL.into_iter().any(|sheet| sheet.facts().scale_key == key)
    }

    /// The schema of an object with the scales; `says` gives what is said of each.
    #[cfg(feature = "schemas")]
    pub(crate) fn schema(
        generator: &mut schemars::SchemaGenerator,
        says: impl Fn(Sheet) -> serde_json::Value,
    ) -> schemars::Schema {
        let mut properties = serde_json::Map::new();
        for sheet in Sheet::ALL {
            let mut property = generator.subschema_for::<Option<f64>>();
            property.ensure_object().extend(says(sheet).as_object().cloned().unwrap_or_default());
            properties.insert(sheet.facts().scale_key.to_owned(), property.to_value());
        }
        schemars::json_schema!({ "type": "object", "properties": properties })
    }

    /// These scales, and others where they have none.
    #[must_use]
    pub fn or(self, others: Scales) -> Scales {
        PerSheet::from_fn(|sheet| self[sheet].or(others[sheet]))
    }

    /// The scales that are there.
    pub fn given(&self) -> impl Iterator<Item = (Sheet, f64)> {
        self.iter().filter_map(|(sheet, scale)| Some((sheet, (*scale)?)))
    }
}

impl Serialize for Scales {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.given().map(|(sheet, scale)| (sheet.facts().scale_key, scale)))
    }
}

impl<'de> Deserialize<'de> for Scales {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Scales, D::Error> {
        let given = IndexMap::<String, f64>::deserialize(deserializer)?;
        Ok(PerSheet::from_fn(|sheet| given.get(sheet.facts().scale_key).copied()))
    }
}

impl<T> Index<Sheet> for PerSheet<T> {
    type Output = T;

    fn index(&self, sheet: Sheet) -> &T {
        &self.0[sheet as usize]
    }
}

impl<T> IndexMut<Sheet> for PerSheet<T> {
    fn index_mut(&mut self, sheet: Sheet) -> &mut T {
        &mut self.0[sheet as usize]
    }
}
