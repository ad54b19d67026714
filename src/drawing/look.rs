use schemars::JsonSchema;
use serde::Deserialize;
use smallvec::SmallVec;
use std::fmt;

/// An sRGB colour of the screen; black by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Colour {
    /// Red, 0 to 255.
    pub red: u8,
    /// Green, 0 to 255.
    pub green: u8,
    /// Blue, 0 to 255.
    pub blue: u8,
}

impl Colour {
    /// The colour written `0xRRGGBB`.
    pub const fn new(rgb: u32) -> Self {
        Self { red: (rgb >> 16) as u8, green: (rgb >> 8) as u8, blue: rgb as u8 }
    }

    /// The colour at a share (0 to 1) of the way to another, component by component.
    pub(super) fn towards(self, other: Colour, share: f64) -> Colour {
        let mix = |a: u8, b: u8| {
            let mixed = f64::from(a) + share * (f64::from(b) - f64::from(a));
            mixed.round() as u8
        };
        Colour { red: mix(self.red, other.red), green: mix(self.green, other.green), blue: mix(self.blue, other.blue) }
    }
}

impl fmt::Display for Colour {
    /// The colour in the notation of SVG and style files: `#b5361c`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Colour { red, green, blue } = self;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

/// Lengths of dashes and gaps in turn, in mm; empty for full lines.
pub type Dash = SmallVec<[f64; 4]>;

/// How a line ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "cap")]
pub enum Cap {
    /// Square at the very end: for vectors, which must not look longer than they are.
    #[default]
    Flat,
    /// Rounded beyond the end: for links, so that their corners close.
    Round,
}

/// The look of a mark. Lengths are in mm of paper.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Colour of lines and arrowheads; none for areas without outline.
    pub stroke: Option<Colour>,
    /// Width of lines.
    pub width: f64,
    /// Lengths of dashes and gaps in turn; empty for full lines.
    pub dash: Dash,
    /// Colour inside polygons and circles; none for transparent ones.
    pub fill: Option<Colour>,
    /// How lines end.
    pub cap: Cap,
    /// Colour of text.
    pub ink: Colour,
    /// Width of the line in the background's colour around the letters of a text; 0 for none.
    pub halo: f64,
}

impl Look {
    /// The look of an area without outline.
    pub(super) fn area(colour: Colour) -> Look {
        let fill = Some(colour);
        Look { stroke: None, width: 0.0, dash: Dash::new(), fill, cap: Cap::default(), ink: colour, halo: 0.0 }
    }
}
