//! What a figure may choose among: the words for it in a scene file, and what they mean.

use serde::de::{Error, Unexpected, Visitor};
use std::fmt;

use super::error::shortened;
use super::units::LengthUnit;
use super::value::{choice, several_forms};
use super::write::write_forms;

choice! {
    /// The plans for which scales are chosen that the scene does not give.
    #[derive(Default)]
    #[cfg_attr(feature = "schemas", schemars(rename = "scalesFor"))]
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
    #[cfg_attr(feature = "schemas", schemars(rename = "styleName"))]
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
    #[cfg_attr(feature = "schemas", schemars(rename = "notation"))]
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
    #[cfg_attr(feature = "schemas", schemars(rename = "sliding"))]
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
    #[cfg_attr(feature = "schemas", schemars(rename = "coriolis"))]
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
    #[cfg_attr(feature = "schemas", schemars(rename = "turned"))]
    TurnedName {
        /// Every velocity by +90°.
        CounterClockwise = "counter-clockwise",
        /// Every velocity by −90°.
        Clockwise = "clockwise",
    }
}

choice! {
    /// The letter of instant centres.
    #[cfg_attr(feature = "schemas", schemars(rename = "center"))]
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
    #[cfg_attr(feature = "schemas", schemars(rename = "frame"))]
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
    #[cfg_attr(feature = "schemas", schemars(rename = "language"))]
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
    #[cfg_attr(feature = "schemas", schemars(rename = "decimal"))]
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
