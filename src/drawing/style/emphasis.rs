//! Looks of new marks, in the accent colour, and of earlier ones, paler.

use super::super::look::{Colour, Look};
use super::Style;

/// Additional width of lines in the accent colour, in mm.
const BOLDER: f64 = 0.15;
/// Share of the background's colour in the marks of earlier steps.
const CALM: f64 = 0.45;
/// Share of the background's colour in a tint of the accent colour.
const TINT: f64 = 0.8;

impl Style {
    /// The look in the accent colour, with slightly wider lines.
    pub(in crate::drawing) fn accented(&self, look: Look) -> Look {
        let (accent, background) = (self.0.accent, self.background());
        let is_tint = self.is_tint(&look);
        let solid = |fill: Colour| match look.stroke.is_some() && fill == background {
            true => fill,
            false => accent,
        };
        Look {
            stroke: look.stroke.map(|_| accent),
            width: look.width + BOLDER,
            // Areas without outline stay tints: letters on them must be legible.
            fill: look.fill.map(|fill| match is_tint {
                true => accent.towards(background, TINT),
                false => solid(fill),
            }),
            ink: accent,
            ..look
        }
    }

    /// The look in paler colours.
    pub(in crate::drawing) fn calmed(&self, look: Look) -> Look {
        let background = self.background();
        let pale = |colour: Colour| colour.towards(background, CALM);
        let is_tint = self.is_tint(&look);
        Look {
            stroke: look.stroke.map(pale),
            fill: look.fill.map(|fill| if is_tint { fill } else { pale(fill) }),
            ink: look.ink.towards(background, 0.5 * CALM),
            ..look
        }
    }

    /// Whether it is an area without outline whose colour is nearer to the background than to the ink.
    fn is_tint(&self, look: &Look) -> bool {
        let sum = |c: Colour| i32::from(c.red) + i32::from(c.green) + i32::from(c.blue);
        let from = |fill: Colour, to: Colour| (sum(fill) - sum(to)).abs();
        look.stroke.is_none() && look.fill.is_some_and(|fill| from(fill, self.background()) < from(fill, self.0.ink))
    }
}
