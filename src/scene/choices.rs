//! The units of a scene, and what its figure may choose among, with the sheet that it is drawn on: the words for it in a
//! scene file, and what they mean. Numbers of a scene and of results are never converted; a figure may show values in
//! another unit of length.

use schemars::JsonSchema;
use serde::de::{Error, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

use super::error::shortened;
use super::value::{choice, several_forms};
use super::write::{write_forms, write_keys};
use crate::geometry::Ball;

choice! {
    /// The plans for which scales are chosen that the scene does not give.
    #[derive(Default)]
    #[schemars(rename = "scalesFor")]
    ScalesFor {
        /// The plans in the scene's own position.
        #[default]
        Position = "position",
        /// Each sheet has the largest scales that fit it: those of a figure, its step sheets and its work sheet may differ.
        Sheet = "sheet",
        /// The largest plans over the range of the first drive: all sheets of the cycle then have one set of scales.
        Cycle = "cycle",
    }
}

choice! {
    /// A drawing style that comes with the program.
    #[derive(Default)]
    #[schemars(rename = "styleName")]
    StyleName {
        /// Black lines with a few dark accents on white.
        #[default]
        Paper = "paper",
        /// Black and grey: kinds of lines are told apart by widths, dashes and heads, in every photocopy.
        Print = "print",
        /// A colour for each link, the same in the scheme and in the plans; told apart with any colour vision.
        Lecture = "lecture",
        /// White and pastel lines on a dark ground.
        Board = "board",
    }
}

choice! {
    /// Notation of poles, images and parts of accelerations. Names of quantities stay the same.
    #[derive(Default)]
    #[schemars(rename = "notation")]
    NotationName {
        /// The source paper's: poles p and π, images b, parts n, t, c.
        #[default]
        Paper = "paper",
        /// Poles o and o′, images b and, in the acceleration plan, b′, parts n, t, c.
        English = "english",
        /// Poles p and π, images b, parts n, τ, k.
        Russian = "russian",
        /// Poles P_v and P_a, images b, parts n, t, c.
        German = "german",
    }
}

choice! {
    /// How the motion along a guide is written.
    #[derive(Default)]
    #[schemars(rename = "sliding")]
    SlidingName {
        /// By the slider: v_r(3/2), a_r(3/2), a_c(3/2).
        #[default]
        Slider = "slider",
        /// By the points of both links in one place: v_B3B2, and a_B3B2 with the parts r and c above.
        Points = "points",
    }
}

choice! {
    /// The index of the Coriolis part of an acceleration.
    #[schemars(rename = "coriolis")]
    CoriolisName {
        /// a_c
        Small = "c",
        /// a_C
        Capital = "C",
        /// a_k
        K = "k",
        /// a_cor
        Cor = "cor",
    }
}

choice! {
    /// The sense in which the velocity plan is turned by 90°.
    #[schemars(rename = "turned")]
    TurnedName {
        /// Every velocity by +90°.
        CounterClockwise = "counter-clockwise",
        /// Every velocity by −90°.
        Clockwise = "clockwise",
    }
}

choice! {
    /// The letter of instant centres.
    #[schemars(rename = "center")]
    #[derive(Default)]
    CenterName {
        /// P_13
        #[default]
        P = "P",
        /// I_13
        I = "I",
        /// CIR_13, centro instantáneo de rotación
        Cir = "CIR",
    }
}

choice! {
    /// The number of the frame, in place of the word for it.
    #[schemars(rename = "frame")]
    FrameName {
        /// The frame is link 0.
        Zero = "0",
        /// The frame is link 1.
        One = "1",
    }
}

choice! {
    /// A language of headings and captions.
    #[derive(Default)]
    #[schemars(rename = "language")]
    LanguageName {
        /// English.
        #[default]
        English = "en",
        /// Spanish.
        Spanish = "es",
        /// German.
        German = "de",
        /// Portuguese.
        Portuguese = "pt",
    }
}

choice! {
    /// Decimal mark of the numbers on figures and in the text of steps; results always have points.
    #[derive(Default)]
    #[schemars(rename = "decimal")]
    DecimalMark {
        /// 2.5
        #[default]
        Point = "point",
        /// 2,5
        Comma = "comma",
    }
}

/// How much of the construction a figure shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ConstructionShown {
    /// Images and vectors alone, without the lines that lead to them.
    Hidden,
    /// Everything: every point of every link has its image.
    #[default]
    Whole,
    /// As in the source paper (Quintero et al., 2011): after the rates are known, the acceleration plan goes on to no
    /// further joint, and neither plan to points that no joint needs.
    Paper,
}

impl ConstructionShown {
    /// Whether construction lines are shown.
    #[must_use]
    pub fn has_lines(self) -> bool {
        self != ConstructionShown::Hidden
    }
}

write_forms! { ConstructionShown {
    ConstructionShown::Hidden => &false, ConstructionShown::Whole => &true, ConstructionShown::Paper => "paper"
} }

several_forms!(ConstructionShown, "construction", YesNoOr {
    expecting: "true, false or \"paper\"",
    shown: |shown| if shown { ConstructionShown::Whole } else { ConstructionShown::Hidden },
    word: |word| (word == "paper").then_some(ConstructionShown::Paper).ok_or(None),
}, _generator => {
    "description": "Whether construction lines are shown; \"paper\": shown, and the plans end where the source paper's end",
    "anyOf": [{ "type": "boolean" }, { "const": "paper" }]
});

/// Whether a figure shows the values of its vectors, of the links' rates and of given lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ValuesShown {
    /// No values.
    Hidden,
    /// All values; those of velocities and accelerations with this unit of length, without one with the scene's.
    Shown(Option<LengthUnit>),
}

write_forms! { ValuesShown {
    ValuesShown::Hidden => &false,
    ValuesShown::Shown(None) => &true,
    ValuesShown::Shown(Some(unit)) => unit.as_str(),
} }

several_forms!(ValuesShown, "values", YesNoOr {
    expecting: "true, false or a unit of length",
    shown: |shown| if shown { ValuesShown::Shown(None) } else { ValuesShown::Hidden },
    word: |word| {
        let unit = LengthUnit::ALL.into_iter().find(|unit| unit.as_str() == word);
        let unknown = || Some(format!("there is no unit of length \"{}\"", shortened(word)));
        unit.map(|unit| ValuesShown::Shown(Some(unit))).ok_or_else(unknown)
    },
}, _generator => {
    "description": "Whether values stand at vectors and links; a unit of length: in this unit, as \"m\" for m/s",
    "anyOf": [{ "type": "boolean" }, { "enum": LengthUnit::ALL.map(LengthUnit::as_str) }]
});

/// Reads true, false or a word, whose error may say what is wrong with the word.
struct YesNoOr<T> {
    expecting: &'static str,
    shown: fn(bool) -> T,
    word: fn(&str) -> Result<T, Option<String>>,
}

impl<T> Visitor<'_> for YesNoOr<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expecting)
    }

    fn visit_bool<E: Error>(self, shown: bool) -> Result<T, E> {
        Ok((self.shown)(shown))
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<T, E> {
        (self.word)(word).map_err(|why| match why {
            Some(why) => E::custom(why),
            None => E::invalid_value(Unexpected::Str(word), &self),
        })
    }
}

/// Units of every length and time of the scene, and of masses and forces where it has some.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"units as { "length": "mm", "time": "s" }"#)]
#[schemars(rename = "units")]
pub struct Units {
    /// Unit of length.
    pub length: LengthUnit,
    /// Unit of time.
    pub time: TimeUnit,
    /// Unit of mass, where links have masses.
    pub mass: Option<MassUnit>,
    /// Unit of force, where there are masses, forces or springs.
    pub force: Option<ForceUnit>,
}

write_keys!(Units { length, time, mass, force });

impl Units {
    /// Units of length and time alone, of a scene without masses and forces.
    #[must_use]
    pub const fn new(length: LengthUnit, time: TimeUnit) -> Units {
        Units { length, time, mass: None, force: None }
    }
}

impl TimeUnit {
    /// How many of this unit are a minute.
    #[must_use]
    pub const fn in_a_minute(self) -> f64 {
        match self {
            TimeUnit::S => 60.0,
            TimeUnit::Min => 1.0,
        }
    }
}

choice! {
    /// A unit of length.
    LengthUnit {
        /// metre
        M = "m",
        /// millimetre
        Mm = "mm",
        /// centimetre
        Cm = "cm",
        /// inch
        In = "in",
        /// foot
        Ft = "ft",
    }
}

impl LengthUnit {
    /// Its length in metres.
    #[must_use]
    pub fn metres(self) -> f64 {
        match self {
            LengthUnit::M => 1.0,
            LengthUnit::Mm => 1e-3,
            LengthUnit::Cm => 1e-2,
            LengthUnit::In => 0.0254,
            LengthUnit::Ft => 0.3048,
        }
    }
}

choice! {
    /// A unit of time.
    #[derive(Default)]
    TimeUnit {
        /// second
        #[default]
        S = "s",
        /// minute
        Min = "min",
    }
}

choice! {
    /// A unit of mass.
    MassUnit {
        /// kilogram
        Kg = "kg",
        /// gram
        G = "g",
        /// tonne
        T = "t",
        /// pound: 0.45359237 kg
        Lb = "lb",
        /// slug: lbf s²/ft
        Slug = "slug",
        /// blob: lbf s²/in
        Blob = "blob",
    }
}

choice! {
    /// A unit of force.
    ForceUnit {
        /// newton
        N = "N",
        /// kilonewton
        Kn = "kN",
        /// millinewton
        Mn = "mN",
        /// kilogram-force: 9.80665 N
        Kgf = "kgf",
        /// pound-force: 0.45359237 kgf
        Lbf = "lbf",
    }
}

/// Newtons in a kilogram-force: standard gravity in m/s².
const STANDARD_GRAVITY: &str = "9.80665";
/// Kilograms in a pound.
const POUND: &str = "0.45359237";

impl Units {
    /// The force that one unit of mass needs for one unit of acceleration, in units of force: 0.001 for mm, s, kg and N. All units are
    /// exact decimals of SI units, or quotients of such. One where a unit of mass or force is missing.
    pub(crate) fn force_of_mass_times_acceleration(self) -> Ball {
        let one = Ball::from(1.0);
        let (Some(mass), Some(force)) = (self.mass, self.force) else { return one };
        let of = Ball::of_decimal;
        let foot = of("0.3048");
        let inch = of("0.0254");
        let pound_force = of(POUND) * of(STANDARD_GRAVITY);
        let kilograms = match mass {
            MassUnit::Kg => one,
            MassUnit::G => of("0.001"),
            MassUnit::T => of("1000"),
            MassUnit::Lb => of(POUND),
            MassUnit::Slug => pound_force / foot,
            MassUnit::Blob => pound_force / inch,
        };
        let metres = match self.length {
            LengthUnit::M => one,
            LengthUnit::Mm => of("0.001"),
            LengthUnit::Cm => of("0.01"),
            LengthUnit::In => inch,
            LengthUnit::Ft => foot,
        };
        let seconds = match self.time {
            TimeUnit::S => one,
            TimeUnit::Min => of("60"),
        };
        let newtons = match force {
            ForceUnit::N => one,
            ForceUnit::Kn => of("1000"),
            ForceUnit::Mn => of("0.001"),
            ForceUnit::Kgf => of(STANDARD_GRAVITY),
            ForceUnit::Lbf => pound_force,
        };
        // Numerator and denominator first: what stands in both cancels to the last digit.
        kilograms * metres / (seconds * seconds * newtons)
    }
}

/// A sheet of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Page {
    /// Its size.
    pub size: PageSize,
    /// Whether its longer side lies horizontally.
    pub landscape: bool,
}

choice! {
    /// A standard size of paper.
    PageSize {
        /// 210 mm × 297 mm
        A4 = "a4",
        /// 297 mm × 420 mm
        A3 = "a3",
        /// 8.5 in × 11 in
        Letter = "letter",
        /// 180 mm × 320 mm, in the proportions of a projector
        Wide = "16x9",
    }
}

impl Default for Page {
    /// A4 landscape.
    fn default() -> Self {
        Page { size: PageSize::A4, landscape: true }
    }
}

impl Page {
    /// All names of pages in a scene file: of each size the one without a suffix, which is landscape, and those with one.
    pub const NAMES: [[&str; 3]; PageSize::ALL.len()] = [
        ["a4", "a4-landscape", "a4-portrait"],
        ["a3", "a3-landscape", "a3-portrait"],
        ["letter", "letter-landscape", "letter-portrait"],
        ["16x9", "16x9-landscape", "16x9-portrait"],
    ];

    /// The page of this name; `None` if there is none. Without a suffix it is landscape.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Page> {
        let mut all = PageSize::ALL.into_iter().zip(Page::NAMES);
        let (size, [.., portrait]) = all.find(|(_, names)| names.contains(&name))?;
        Some(Page { size, landscape: name != portrait })
    }

    /// Its name in a scene file: `"a4"`, `"a4-portrait"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        let [landscape, _, portrait] = Page::NAMES[self.size as usize];
        if self.landscape { landscape } else { portrait }
    }

    /// Width and height, in millimetres.
    pub fn size_mm(self) -> [f64; 2] {
        let [short, long] = match self.size {
            PageSize::A4 => [210.0, 297.0],
            PageSize::A3 => [297.0, 420.0],
            PageSize::Letter => [215.9, 279.4],
            PageSize::Wide => [180.0, 320.0],
        };
        if self.landscape { [long, short] } else { [short, long] }
    }
}

write_forms! { Page { page => page.name() } }

impl<'de> Deserialize<'de> for Page {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Page, D::Error> {
        let name = String::deserialize(deserializer)?;
        Page::from_name(&name)
            .ok_or_else(|| serde::de::Error::custom(format!("there is no page \"{}\"", shortened(&name))))
    }
}

/// Sizes of what is drawn on a sheet. All that has no size here (joints' feet, blocks, white between things) is in
/// proportion to the letters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// One em of labels and captions; no word of a figure is smaller, subscripts excepted.
    pub letters: Measure,
    /// Length of an arrowhead on a vector long enough for it.
    pub arrowheads: Measure,
    /// Diameter of the dot at the end of a vector; poles and special points of plans are in proportion.
    pub points: Measure,
    /// Diameter of the circle of a joint or a special point of the scheme.
    pub joints: Measure,
    /// Width of the line of a link, in mm of paper: labels keep off lines by it.
    pub lines: f64,
}

/// A length on a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// In mm of paper.
    Millimetres(f64),
    /// In hundredths of the sheet's shorter side: the same on every projector.
    Percent(f64),
}

impl Measure {
    /// Its length in mm on a sheet of that width and height.
    #[must_use]
    pub fn on(self, [width, height]: [f64; 2]) -> f64 {
        match self {
            Measure::Millimetres(mm) => mm,
            Measure::Percent(part) => 0.01 * part * width.min(height),
        }
    }
}

impl Default for Sizes {
    /// Those of the style `paper`.
    fn default() -> Self {
        Sizes {
            letters: Measure::Millimetres(4.7),
            arrowheads: Measure::Millimetres(2.6),
            points: Measure::Millimetres(0.9),
            joints: Measure::Millimetres(2.3),
            lines: 0.5,
        }
    }
}
