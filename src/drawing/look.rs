use super::sheet::Pen;

/// A colour of the screen, sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
        Self {
            red: (rgb >> 16) as u8,
            green: (rgb >> 8) as u8,
            blue: rgb as u8,
        }
    }

    /// So far (0 to 1) on the way to another colour.
    fn towards(self, other: Colour, share: f64) -> Colour {
        let mix = |a: u8, b: u8| {
            let mixed = f64::from(a) + share * (f64::from(b) - f64::from(a));
            mixed.round() as u8
        };
        Colour {
            red: mix(self.red, other.red),
            green: mix(self.green, other.green),
            blue: mix(self.blue, other.blue),
        }
    }
}

/// How a line ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cap {
    /// Square at the very end: for vectors, which must not look longer than they are.
    Flat,
    /// Rounded beyond the end: for links, so that their corners close.
    Round,
}

/// How marks of one pen look. Lengths are in mm of paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Colour of lines and arrowheads; none for areas without outline.
    pub stroke: Option<Colour>,
    /// Width of lines.
    pub width: f64,
    /// Lengths of dashes and gaps in turn; empty for full lines.
    pub dash: &'static [f64],
    /// Colour inside polygons and circles; none leaves them clear.
    pub fill: Option<Colour>,
    /// How lines end.
    pub cap: Cap,
    /// Colour of text.
    pub ink: Colour,
    /// Width of the white line around the letters of a text; 0 for none.
    pub halo: f64,
}

impl Look {
    /// The same in the accent colour, its lines somewhat bolder.
    pub(super) fn accented(self) -> Look {
        let solid = |fill: Colour| {
            if self.stroke.is_some() && fill == WHITE {
                fill
            } else {
                ACCENT
            }
        };
        Look {
            stroke: self.stroke.map(|_| ACCENT),
            width: self.width + BOLDER,
            // Areas without outline stay tints, so that letters can be read on them.
            fill: self.fill.map(|fill| match self.is_tint() {
                true => ACCENT.towards(WHITE, 0.8),
                false => solid(fill),
            }),
            ink: ACCENT,
            ..self
        }
    }

    /// The same, paler.
    pub(super) fn calmed(self) -> Look {
        let pale = |colour: Colour| colour.towards(WHITE, CALM);
        Look {
            stroke: self.stroke.map(pale),
            fill: self
                .fill
                .map(|fill| if self.is_tint() { fill } else { pale(fill) }),
            ink: self.ink.towards(WHITE, 0.5 * CALM),
            ..self
        }
    }

    /// Whether it is a pale area without outline.
    fn is_tint(&self) -> bool {
        let sum = |c: Colour| u16::from(c.red) + u16::from(c.green) + u16::from(c.blue);
        self.stroke.is_none() && self.fill.is_some_and(|fill| sum(fill) > 600)
    }
}

// Four accents of nearly the same weight. They keep apart for readers who do not tell red from
// green: blue, a green that leans to blue, an orange red, a purple; and each kind of mark differs
// by more than its colour (dash, head, place).
const INK: Colour = Colour::new(0x1a1a1a);
const GREY: Colour = Colour::new(0x767676);
const FAINT: Colour = Colour::new(0xb4b4b4);
const PALE: Colour = Colour::new(0xe2e2e2);
const BLUE: Colour = Colour::new(0x0b4f8a);
const GREEN: Colour = Colour::new(0x0f6b57);
const RED: Colour = Colour::new(0xb5361c);
const PURPLE: Colour = Colour::new(0x6d3a7c);
const OCHRE: Colour = Colour::new(0x8a6100);
const WHITE: Colour = Colour::new(0xffffff);

/// What comes with a step.
const ACCENT: Colour = Colour::new(0xc2410c);
/// By how much its lines are bolder, in mm.
const BOLDER: f64 = 0.15;
/// How far towards white the marks of earlier steps are.
const CALM: f64 = 0.45;

/// Colours of curves in one panel; then the same with dashes.
const CURVES: [Colour; 6] = [BLUE, RED, GREEN, PURPLE, OCHRE, INK];

/// How many styles of curves there are.
pub(super) const CURVE_STYLES: usize = 2 * CURVES.len();

fn curve_colour(style: u8) -> Colour {
    CURVES[usize::from(style) % CURVES.len()]
}

/// Tints of the links, light enough for black labels on them.
const TINTS: [Colour; 4] = [
    Colour::new(0xe3ecf4),
    Colour::new(0xf4ead9),
    Colour::new(0xe2efe9),
    Colour::new(0xeee6f1),
];

// The four line widths of a technical drawing.
const HAIR: f64 = 0.18;
const THIN: f64 = 0.25;
const MEDIUM: f64 = 0.35;
const BOLD: f64 = 0.5;

/// Width of the white line around labels: 0.3 mm on each side of a letter.
const HALO: f64 = 0.6;

/// How marks of a pen look: the one table of the project's drawing style.
pub fn look(pen: Pen) -> Look {
    let line = |colour, width| Look {
        stroke: Some(colour),
        width,
        dash: &[],
        fill: None,
        cap: Cap::Flat,
        ink: colour,
        halo: HALO,
    };
    let area = |colour| Look {
        stroke: None,
        fill: Some(colour),
        ..line(INK, 0.0)
    };
    let writing = |colour, halo| Look {
        stroke: None,
        halo,
        ..line(colour, 0.0)
    };
    match pen {
        Pen::Frame => line(GREY, HAIR),
        Pen::Ground => Look {
            cap: Cap::Round,
            ..line(INK, MEDIUM)
        },
        Pen::Hatch => line(INK, HAIR),
        Pen::Link => Look {
            cap: Cap::Round,
            ..line(INK, BOLD)
        },
        Pen::LinkFill(tint) => area(TINTS[usize::from(tint) % TINTS.len()]),
        Pen::Slider => Look {
            fill: Some(WHITE),
            ..line(INK, MEDIUM)
        },
        Pen::Guide => line(INK, THIN),
        Pen::Joint => Look {
            fill: Some(WHITE),
            ..line(INK, MEDIUM)
        },
        Pen::Trace => line(GREY, THIN),
        Pen::Construction => Look {
            dash: &[1.8, 1.0],
            ..line(GREY, HAIR)
        },
        Pen::Ray => Look {
            dash: &[3.6, 0.9, 0.5, 0.9],
            ..line(RED, HAIR)
        },
        Pen::Vector => line(INK, MEDIUM),
        Pen::Velocity => line(BLUE, MEDIUM),
        Pen::Acceleration => line(PURPLE, MEDIUM),
        Pen::Normal => line(GREEN, MEDIUM),
        Pen::Tangential => line(OCHRE, MEDIUM),
        Pen::Coriolis => Look {
            dash: &[1.4, 0.7],
            ..line(INK, MEDIUM)
        },
        Pen::Pole => Look {
            fill: Some(INK),
            ..line(INK, HAIR)
        },
        Pen::Image => line(INK, THIN),
        Pen::ImageFill => area(Colour::new(0xeef1f4)),
        Pen::ImagePoint => Look {
            fill: Some(INK),
            ..area(INK)
        },
        Pen::Special => Look {
            fill: Some(WHITE),
            ..line(RED, MEDIUM)
        },
        Pen::Turning => line(INK, THIN),
        Pen::Leader => line(FAINT, HAIR),
        Pen::Label => writing(INK, HALO),
        Pen::Hint => Look {
            cap: Cap::Round,
            ..line(ACCENT.towards(WHITE, 0.72), 2.2)
        },
        Pen::Caption => writing(INK, 0.0),
        Pen::Heading => writing(INK, 0.0),
        Pen::Grid => line(PALE, HAIR),
        Pen::Zero => line(INK, THIN),
        Pen::Curve(style) => Look {
            dash: if (usize::from(style) / CURVES.len()).is_multiple_of(2) {
                &[]
            } else {
                &[2.4, 0.9]
            },
            fill: Some(curve_colour(style)),
            ..line(curve_colour(style), MEDIUM)
        },
        Pen::Dead(style) => Look {
            fill: Some(WHITE),
            ..line(curve_colour(style), THIN)
        },
        Pen::Limit => Look {
            dash: &[1.8, 1.0],
            ..line(INK, THIN)
        },
        Pen::Change => Look {
            dash: &[3.6, 0.9, 0.5, 0.9],
            ..line(INK, THIN)
        },
        Pen::Stand => line(GREY, HAIR),
    }
}
