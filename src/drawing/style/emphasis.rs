//! Marks that stand out, and those that step back for them.

use super::super::look::{Colour, Look};
use super::Style;

/// By how much lines in the accent colour are bolder, in mm.
const BOLDER: f64 = 0.15;
/// How far towards the background the marks of earlier steps are.
const CALM: f64 = 0.45;
/// How far towards the background a tint in the accent colour is.
const TINT: f64 = 0.8;

impl Style {
    /// The same in the accent colour, its lines somewhat bolder.
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
            // Areas without outline stay tints, so that letters can be read on them.
            fill: look.fill.map(|fill| match is_tint {
                true => accent.towards(background, TINT),
                false => solid(fill),
            }),
            ink: accent,
            ..look
        }
    }

    /// The same, paler.
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

    /// Whether it is an area without outline, nearer to the background than to the ink.
    fn is_tint(&self, look: &Look) -> bool {
        let sum = |c: Colour| i32::from(c.red) + i32::from(c.green) + i32::from(c.blue);
        let from = |fill: Colour, to: Colour| (sum(fill) - sum(to)).abs();
        look.stroke.is_none() && look.fill.is_some_and(|fill| from(fill, self.background()) < from(fill, self.0.ink))
    }
}
