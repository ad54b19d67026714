//! What marks are, and how they look.

use serde::{Deserialize, Serialize};
use smallvec::SmallVec;
use std::fmt;

use crate::construction::VectorPart;
use crate::sheet::Order;

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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "cap"))]
#[serde(rename_all = "lowercase")]
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

/// What a mark *is*. Colour, width, dash and fill come from the drawing's [`Style`](super::Style), so a figure is
/// restyled in one place. Style files write pens in small letters: `link_fill`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Pen {
    /// The border of a panel, axes, the bar of a scale.
    Frame,
    /// The line of the frame that a pivot or a guide stands on.
    Ground,
    /// The short strokes under a ground line.
    Hatch,
    /// A link drawn as a line, or the outline of one drawn as an area.
    Link,
    /// The tinted area of a link.
    LinkFill,
    /// A sliding block, or a pivot's foot: outlined.
    Slider,
    /// The straight guide that a block slides on.
    Guide,
    /// A revolute joint: a small circle.
    Joint,
    /// The path of a point over a cycle.
    Trace,
    /// The rest of such a path, beyond the limits of the drive.
    Beyond,
    /// A link in another position of the cycle.
    Ghost,
    /// A link, or a pin on its guide, that moves as profiles that touch do.
    Equivalent,
    /// A helping line of the scheme.
    Construction,
    /// A line of known direction in a plan.
    Ray,
    /// A vector that is neither of the kinds below.
    Vector,
    /// A velocity.
    Velocity,
    /// A total acceleration.
    Acceleration,
    /// A normal part of an acceleration, known before the plan is closed.
    Normal,
    /// A tangential part, found by closing the plan.
    Tangential,
    /// A Coriolis part.
    Coriolis,
    /// The pole of a plan.
    Pole,
    /// The outline of the image of a link in a plan.
    Image,
    /// The area of such an image.
    ImageFill,
    /// The end of a vector in a plan, the image of a point: a small dot.
    ImagePoint,
    /// A special (Assur) point and what belongs to it.
    Special,
    /// The sense of turning: curved arrows of ω and α.
    Turning,
    /// The line from a label to what it names when it had to stand apart.
    Leader,
    /// The name of a point, a link or a vector; haloed, so that it reads across lines.
    Label,
    /// What a step is about, in that step alone: a broad pale line under a length or a direction.
    Hint,
    /// Running text: scales, equations, captions.
    Caption,
    /// The heading of a panel or a sheet.
    Heading,
    /// A line at a round value of an axis.
    Grid,
    /// The line at zero.
    Zero,
    /// A quantity over the cycle, its name, and the dots at its greatest and least values.
    Curve,
    /// A dead centre of the link or slider: a small circle on the line at zero.
    Dead,
    /// Where a drive can go no further.
    Limit,
    /// Where the motion could go on in another assembly mode too.
    Change,
    /// Where the drive stands in the scene.
    Stand,
    /// A line of a student's drawing over the right one.
    Student,
    /// A point of such a drawing, a small cross, and its name.
    StudentPoint,
    /// A line or a vector of a hand's drawing that is wrong by itself.
    Wrong,
    /// Such a point, its name, and the cross by which a wrong line is struck.
    WrongPoint,
    /// A marker by which a photograph of the sheet is read, and the small code: black in every style.
    #[serde(skip_deserializing)]
    #[cfg_attr(feature = "schemas", schemars(skip))]
    Marker,
    /// The white around them, on paper of any colour.
    #[serde(skip_deserializing)]
    #[cfg_attr(feature = "schemas", schemars(skip))]
    MarkerWhite,
}

impl Pen {
    /// How many pens have looks of a style.
    pub(super) const COUNT: usize = Pen::WrongPoint as usize + 1;

    /// Its name, as in style files: `link_fill`.
    pub(crate) fn name(self) -> String {
        let name = serde_json::to_value(self).ok();
        name.and_then(|name| name.as_str().map(str::to_owned)).unwrap_or_default()
    }

    /// The pen of a plan's vectors that show this.
    pub(super) fn of_vectors(order: Order, part: VectorPart) -> Pen {
        match (part, order) {
            (VectorPart::Whole, Order::Velocity) => Pen::Velocity,
            (VectorPart::Whole, Order::Acceleration) => Pen::Acceleration,
            // The side of a link's image.
            (VectorPart::Relative, _) => Pen::Image,
            (VectorPart::Normal, _) => Pen::Normal,
            (VectorPart::Tangential, _) => Pen::Tangential,
            (VectorPart::Sliding, _) => Pen::Vector,
            (VectorPart::Coriolis, _) => Pen::Coriolis,
        }
    }

    /// The colour of areas that no style changes: programs look for them.
    pub(super) fn fixed(self) -> Option<Colour> {
        match self {
            Pen::Marker => Some(Colour::new(0)),
            Pen::MarkerWhite => Some(Colour::new(0xff_ffff)),
            _ => None,
        }
    }
}
