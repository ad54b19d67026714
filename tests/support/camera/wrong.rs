//! Pages that are no sheets of ours.

use super::sheet::{begun, marker};
use crate::random::Random;
use std::fmt::Write;

/// What lies there instead of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// Nothing: the desk alone.
    Nothing,
    /// A page of writing.
    Text,
    /// A page with squares of another kind.
    OtherMarkers,
    Checkerboard,
    /// White paper.
    Blank,
}

/// All of them.
pub const WRONGS: [Wrong; 5] = [Wrong::Nothing, Wrong::Text, Wrong::OtherMarkers, Wrong::Checkerboard, Wrong::Blank];

impl Wrong {
    /// The page's SVG, if there is a page.
    pub fn svg(self, mm: [f64; 2], random: &mut Random) -> Option<String> {
        let mut svg = begun(mm);
        match self {
            Wrong::Nothing => return None,
            Wrong::Text => text(&mut svg, mm, random),
            Wrong::OtherMarkers => markers(&mut svg, mm, random),
            Wrong::Checkerboard => checkerboard(&mut svg, mm),
            Wrong::Blank => {}
        }
        Some(svg + "</svg>")
    }
}

/// Lines of letters, which are a few bars each.
fn text(svg: &mut String, mm: [f64; 2], random: &mut Random) {
    let mut y = 25.0;
    while y < mm[1] - 20.0 {
        let end = if random.below(6) == 0 { random.between(60.0, mm[0] - 20.0) } else { mm[0] - 20.0 };
        let mut x = 20.0;
        while x < end {
            if random.below(6) == 0 {
                x += 1.4;
                continue;
            }
            let high = if random.below(4) == 0 { 2.6 } else { 1.8 };
            let top = y - high;
            let _ = write!(svg, "<path d='M{x} {y}v-{high}");
            match random.below(4) {
                0 => _ = write!(svg, "h1.1v{high}z"),
                1 => _ = write!(svg, "M{x} {top}h1.2"),
                2 => _ = write!(svg, "h1.2M{x} {y}h1.1"),
                _ => _ = write!(svg, "l1.1 {high}"),
            }
            svg.push_str("' fill='none' stroke='black' stroke-width='0.3'/>");
            x += 1.75;
        }
        y += 5.4;
    }
}

/// Our squares' size and border with other cells inside, and some elsewhere.
fn markers(svg: &mut String, [width, height]: [f64; 2], random: &mut Random) {
    for [x, y] in [[8.0, 8.0], [width - 16.0, 8.0], [width - 16.0, height - 16.0], [8.0, height - 16.0]] {
        let code = 0xa55a ^ (random.below(16) as u16 * 0x0421);
        marker(svg, [x, y], code);
    }
    for _ in 0..6 {
        let [x, y] = [random.between(25.0, width - 40.0), random.between(25.0, height - 40.0)];
        let _ = write!(svg, "<path d='M{x} {y}h9v9h-9z' fill='none' stroke='black' stroke-width='1.4'/>");
    }
}

fn checkerboard(svg: &mut String, [width, height]: [f64; 2]) {
    for (i, j) in (0..32).flat_map(|i| (0..32).map(move |j| (i, j))) {
        let (x, y) = (14.0 + 9.0 * f64::from(i), 14.0 + 9.0 * f64::from(j));
        if (i + j) % 2 == 0 && x + 9.0 < width - 14.0 && y + 9.0 < height - 14.0 {
            let _ = write!(svg, "<path d='M{x} {y}h9v9h-9z'/>");
        }
    }
}
