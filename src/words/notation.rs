//! Symbols that schools write differently.

use crate::scene::{CoriolisName, Figure, FrameName, SlidingName};
use crate::sheet::Order;

/// How a school writes poles, images of points, parts of accelerations and motions along guides; in markup, where `_{…}` is an
/// index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Notation {
    /// The poles that are not written as in results.
    poles: &'static [(Order, &'static str)],
    /// Whether images of points bear a prime in the acceleration plan: `b′` beside `b` of the velocity plan.
    pub primes: bool,
    /// Index of the normal part of an acceleration.
    pub normal: &'static str,
    /// Index of the tangential part of an acceleration.
    pub tangential: &'static str,
    /// Index of the Coriolis part of an acceleration.
    pub coriolis: &'static str,
    /// Index of the part along a guide.
    pub relative: &'static str,
    /// How motions along guides are written.
    pub sliding: SlidingName,
    /// The letter of instant centres.
    pub center: &'static str,
    /// The number of the frame; without one it has a word.
    pub frame: Option<FrameName>,
    /// The frame's own label, where it is short enough for an index.
    pub frame_sign: Option<FrameSign>,
}

/// A label of the frame that stands in indices, as 6 in P₁₆: at most three letters or digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameSign([Option<char>; 3]);

impl FrameSign {
    /// The label that a figure gives the frame; `None` of a longer one, and where there is none.
    fn of(figure: &Figure) -> Option<FrameSign> {
        let label = figure.labels.get("ground")?.for_setting();
        let mut signs = label.trim().chars();
        let sign = FrameSign(core::array::from_fn(|_| signs.next()));
        let is_short = signs.next().is_none() && sign.text().chars().all(char::is_alphanumeric);
        (is_short && sign.0[0].is_some()).then_some(sign)
    }

    /// The label.
    #[must_use]
    pub fn text(self) -> String {
        self.0.into_iter().flatten().collect()
    }
}

impl Notation {
    /// The notations in the order of [`NotationName::ALL`](crate::scene::NotationName::ALL).
    pub const ALL: [&'static Notation; 4] = [&PAPER, &ENGLISH, &RUSSIAN, &GERMAN];

    /// The notation that a figure asks for.
    #[must_use]
    pub fn of(figure: &Figure) -> Notation {
        let school = *Notation::ALL[figure.notation as usize];
        Notation {
            coriolis: figure.coriolis.map_or(school.coriolis, CoriolisName::as_str),
            sliding: figure.sliding,
            center: figure.center_letter.as_str(),
            frame: figure.frame,
            frame_sign: FrameSign::of(figure),
            ..school
        }
    }

    /// The symbol of a part of the motion along a guide: `v_r(3/2)`, or `v_B3B2`, whose velocity is a whole one.
    #[must_use]
    pub fn slide(&self, of: Order, part: SlidePart, slider: &SliderNames) -> SlideSymbol {
        let index = match part {
            SlidePart::Relative => self.relative,
            SlidePart::Coriolis => self.coriolis,
        };
        let (upper, lower, after) = match (self.sliding, of) {
            (SlidingName::Slider, _) => ("", index.to_owned(), format!("({})", slider.pair)),
            (SlidingName::Points, Order::Velocity) => ("", slider.points.concat(), String::new()),
            (SlidingName::Points, Order::Acceleration) => (index, slider.points.concat(), String::new()),
        };
        SlideSymbol { letter: of.vector(), upper, lower, after }
    }

    /// The symbol of a plan's pole, in markup.
    #[must_use]
    pub fn pole(&self, plan: Order) -> &'static str {
        self.poles.iter().find(|(order, _)| *order == plan).map_or(plan.pole(), |(_, pole)| pole)
    }
}

/// H. Quintero, G. Calle, A. Díaz, E. Henao, Rev. Fac. Ing. Univ. Antioquia 60 (2011) 81–91.
const PAPER: Notation = Notation {
    poles: &[],
    primes: false,
    normal: "n",
    tangential: "t",
    coriolis: "c",
    relative: "r",
    sliding: SlidingName::Slider,
    center: "P",
    frame: None,
    frame_sign: None,
};

/// C. E. Wilson, J. P. Sadler, *Kinematics and Dynamics of Machinery*, 3rd ed., Pearson 2003.
const ENGLISH: Notation =
    Notation { poles: &[(Order::Velocity, "o"), (Order::Acceleration, "o′")], primes: true, ..PAPER };

/// K. V. Frolov (ed.), *Теория механизмов и машин*, Высшая школа, Moscow 1987.
const RUSSIAN: Notation = Notation { tangential: "τ", coriolis: "k", ..PAPER };

/// H. Kerle, B. Corves, M. Hüsing, *Getriebetechnik*, 5th ed., Springer Vieweg 2015.
const GERMAN: Notation = Notation { poles: &[(Order::Velocity, "P_{v}"), (Order::Acceleration, "P_{a}")], ..PAPER };

/// A name with a prime after its letter: `b′`, `d′_2`, `s′3`.
#[must_use]
pub fn with_prime(name: &str) -> String {
    let letters = name.split('_').next().unwrap_or(name);
    let letters = letters.trim_end_matches(|c: char| c.is_ascii_digit());
    let (letter, rest) = name.split_at(letters.len());
    format!("{letter}′{rest}")
}

/// The point of a link at a place, in markup: `B_{3}`, and `B_{1,3}` of a point that has an index of its own.
#[must_use]
pub fn under(point: &str, link: &str) -> String {
    match point.strip_suffix('}') {
        Some(open) => format!("{open},{link}}}"),
        None => format!("{point}_{{{link}}}"),
    }
}

/// A part of the motion along a guide that has a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlidePart {
    /// Along the guide.
    Relative,
    /// Normal to it, by the guide's turning.
    Coriolis,
}

/// What symbols name a slider by, in markup.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SliderNames {
    /// Its links, or its pin and its link: `3/2`.
    pub pair: String,
    /// The point of what slides and that of the guide's link: `B_{3}`, `B_{2}`.
    pub points: [String; 2],
}

/// The symbol of a part of the motion along a guide.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SlideSymbol {
    /// Its letter.
    pub letter: &'static str,
    /// Its upper index; often none.
    pub upper: &'static str,
    /// Its lower index.
    pub lower: String,
    /// What stands behind it on the line.
    pub after: String,
}

impl SlideSymbol {
    /// The symbol in markup.
    #[must_use]
    pub fn markup(&self) -> String {
        let script = |mark: char, text: &str| match text.chars().count() {
            0 => String::new(),
            1 => format!("{mark}{text}"),
            _ => format!("{mark}{{{text}}}"),
        };
        format!("{}{}{}{}", self.letter, script('^', self.upper), script('_', &self.lower), self.after)
    }
}
